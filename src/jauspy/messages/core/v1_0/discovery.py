"""urn:jaus:jss:core:Discovery 1.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from dataclasses import dataclass
from enum import IntEnum
from typing import ClassVar, Self

from jauspy.codec import runtime as rt
from jauspy.messages.core.v1_0 import types as core_v1_0_types


@dataclass(slots=True, repr=False)
class QueryIdentification(rt.Message):
    """QueryIdentification (0x2B00): Asks for the name of a system, subsystem, node or component.

    query_type: QueryType or 5..255. Whose identification is meant
    """

    CODE = 0x2B00
    NAME = "QueryIdentification"
    SERVICE = "urn:jaus:jss:core:Discovery"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = True
    REPORT: ClassVar[type[ReportIdentification]]

    class QueryType(IntEnum):
        """Values of QueryType."""

        RESERVED = 0
        SYSTEM = 1
        SUBSYSTEM = 2
        NODE = 3
        COMPONENT = 4

    query_type: QueryIdentification.QueryType | int

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("QueryType", rt.Number("B", rt.Values(QueryIdentification.QueryType, ((5, 255),)))),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        self = rt.new(cls)
        code, query_type_ = _S_HB.unpack(data)
        if code != 0x2B00: raise rt.Reject
        self.query_type = _E_QueryIdentification_QueryType.get(query_type_, query_type_)
        return self

    def _pack(self) -> bytes:
        return _S_HB.pack(0x2B00, self.query_type)


@dataclass(slots=True, repr=False)
class QueryConfiguration(rt.Message):
    """QueryConfiguration (0x2B01): Asks for the components of a subsystem or node.

    query_type: QueryType or 4..255. Whose components are wanted
    """

    CODE = 0x2B01
    NAME = "QueryConfiguration"
    SERVICE = "urn:jaus:jss:core:Discovery"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = True
    REPORT: ClassVar[type[ReportConfiguration]]

    class QueryType(IntEnum):
        """Values of QueryType."""

        RESERVED_0 = 0
        RESERVED_1 = 1
        SUBSYSTEM = 2
        NODE = 3

    query_type: QueryConfiguration.QueryType | int

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("QueryType", rt.Number("B", rt.Values(QueryConfiguration.QueryType, ((4, 255),)))),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        self = rt.new(cls)
        code, query_type_ = _S_HB.unpack(data)
        if code != 0x2B01: raise rt.Reject
        self.query_type = _E_QueryConfiguration_QueryType.get(query_type_, query_type_)
        return self

    def _pack(self) -> bytes:
        return _S_HB.pack(0x2B01, self.query_type)


@dataclass(slots=True, repr=False)
class QuerySubsystemList(rt.Message):
    """QuerySubsystemList (0x2B02): Asks for the known subsystems."""

    CODE = 0x2B02
    NAME = "QuerySubsystemList"
    SERVICE = "urn:jaus:jss:core:Discovery"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = True
    REPORT: ClassVar[type[ReportSubsystemList]]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(cls, ())

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data != b'\x02+': raise rt.Reject
        return rt.new(cls)

    def _pack(self) -> bytes:
        return _S_H.pack(0x2B02)


@dataclass(slots=True, repr=False)
class QueryServices(rt.Message):
    """QueryServices (0x2B03): Asks for the services of selected components of the subsystem.

    node_list: 1..255 items. The nodes
    """

    CODE = 0x2B03
    NAME = "QueryServices"
    SERVICE = "urn:jaus:jss:core:Discovery"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = True
    REPORT: ClassVar[type[ReportServices]]

    QueriedNodeRec = core_v1_0_types.QueriedNodeRec
    QueriedComponentRec = core_v1_0_types.QueriedComponentRec

    @dataclass(slots=True, repr=False)
    class NodeSeq(rt.Struct):
        """NodeSeq.

        node_rec: One node, or all
        component_list: 1..255 items. The components
        """

        node_rec: core_v1_0_types.QueriedNodeRec
        component_list: list[core_v1_0_types.QueriedComponentRec]

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("NodeRec", core_v1_0_types.QueriedNodeRec.layout()),
                ("ComponentList", rt.Repeat(rt.Count("B", 1, 255), core_v1_0_types.QueriedComponentRec.layout())),
            )

    node_list: list[QueryServices.NodeSeq]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("NodeList", rt.Repeat(rt.Count("B", 1, 255), QueryServices.NodeSeq.layout())),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0x03 or data[1] != 0x2B: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        node_list_count_ = data[2]
        if node_list_count_ < 1: raise rt.Reject
        if node_list_count_ * 2 > size - 3: raise rt.Reject
        at = 3
        node_list_ = []
        for _ in range(node_list_count_):
            item_ = rt.new(QueryServices.NodeSeq)
            node_id_ = data[at]
            item_.node_rec = core_v1_0_types.QueriedNodeRec(_E_QueriedNodeRec_NodeID.get(node_id_, node_id_))
            component_list_count_ = data[at + 1]
            if component_list_count_ < 1: raise rt.Reject
            component_list_end_ = at + 2 + component_list_count_ * 1
            item_.component_list = [core_v1_0_types.QueriedComponentRec(_E_QueriedComponentRec_ComponentID.get(component_id_, component_id_)) for component_id_ in _L_B[component_list_count_].unpack_from(data, at + 2)]
            at = component_list_end_
            node_list_.append(item_)
        self.node_list = node_list_
        if at != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\x03\x2b")
        node_list_ = self.node_list
        if type(node_list_) is not list: raise rt.Reject
        if len(node_list_) < 1: raise rt.Reject
        out.append(len(node_list_))
        for item_ in node_list_:
            if type(item_) is not QueryServices.NodeSeq: raise rt.Reject
            node_rec_ = item_.node_rec
            if type(node_rec_) is not core_v1_0_types.QueriedNodeRec: raise rt.Reject
            out.append(node_rec_.node_id)
            component_list_ = item_.component_list
            if type(component_list_) is not list: raise rt.Reject
            if len(component_list_) < 1: raise rt.Reject
            out.append(len(component_list_))
            raw_: list[int | float] = []
            for item_2_ in component_list_:
                if type(item_2_) is not core_v1_0_types.QueriedComponentRec: raise rt.Reject
                raw_.append(item_2_.component_id)
            out += _L_B[len(raw_)].pack(*raw_)
        return bytes(out)


@dataclass(slots=True, repr=False)
class RegisterServices(rt.Message):
    """RegisterServices (0x0B00): Tells the Discovery service of the node which services a component offers.

    service_list: 0..255 items. The services
    """

    CODE = 0x0B00
    NAME = "RegisterServices"
    SERVICE = "urn:jaus:jss:core:Discovery"
    VERSION = "1.0"
    IS_COMMAND = True
    IS_QUERY = False

    ServiceRec = core_v1_0_types.ServiceRec

    service_list: list[core_v1_0_types.ServiceRec]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("ServiceList", rt.Repeat(rt.Count("B", 0, 255), core_v1_0_types.ServiceRec.layout())),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0x00 or data[1] != 0x0B: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        service_list_count_ = data[2]
        if service_list_count_ * 3 > size - 3: raise rt.Reject
        at = 3
        service_list_ = []
        for _ in range(service_list_count_):
            item_ = rt.new(core_v1_0_types.ServiceRec)
            uri_end_ = at + 1 + data[at]
            item_.uri = data[at + 1:uri_end_].decode("latin-1")
            item_.major_version_number = data[uri_end_]
            item_.minor_version_number = data[uri_end_ + 1]
            at = uri_end_ + 2
            service_list_.append(item_)
        self.service_list = service_list_
        if at != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\x00\x0b")
        service_list_ = self.service_list
        if type(service_list_) is not list: raise rt.Reject
        out.append(len(service_list_))
        for item_ in service_list_:
            if type(item_) is not core_v1_0_types.ServiceRec: raise rt.Reject
            uri_raw_ = item_.uri.encode("latin-1")
            out.append(len(uri_raw_))
            out += uri_raw_
            out.append(item_.major_version_number)
            out.append(item_.minor_version_number)
        return bytes(out)


@dataclass(slots=True, repr=False)
class ReportIdentification(rt.Message):
    """ReportIdentification (0x4B00): Tells the name and kind of a system, subsystem, node or component.

    query_type: QueryType or 5..255. Whose identification is meant
    type: Type or 10002..20000 or 20002..30000 or 30002..40000 or 40002..50000 or 50002..60000 or 60002..65535. The kind of subsystem, node or component; ranges are left for subdivisions
    identification: up to 255 characters. The name, for people
    """

    CODE = 0x4B00
    NAME = "ReportIdentification"
    SERVICE = "urn:jaus:jss:core:Discovery"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = False

    class QueryType(IntEnum):
        """Values of QueryType."""

        RESERVED = 0
        SYSTEM = 1
        SUBSYSTEM = 2
        NODE = 3
        COMPONENT = 4

    class Type(IntEnum):
        """Values of Type."""

        RESERVED = 0
        VEHICLE = 10001
        OCU = 20001
        OTHER_SUBSYSTEM = 30001
        NODE = 40001
        PAYLOAD = 50001
        COMPONENT = 60001

    query_type: ReportIdentification.QueryType | int
    type: ReportIdentification.Type | int
    identification: str

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("QueryType", rt.Number("B", rt.Values(ReportIdentification.QueryType, ((5, 255),)))),
            ("Type", rt.Number("H", rt.Values(ReportIdentification.Type, ((10002, 20000), (20002, 30000), (30002, 40000), (40002, 50000), (50002, 60000), (60002, 65535))))),
            ("Identification", rt.Text(count=rt.Count("B", 0, 255))),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0x00 or data[1] != 0x4B: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        query_type_, type_ = _S_BH.unpack_from(data, 2)
        self.query_type = _E_ReportIdentification_QueryType.get(query_type_, query_type_)
        if type_ not in _E_ReportIdentification_Type and not 10002 <= type_ <= 20000 and not 20002 <= type_ <= 30000 and not 30002 <= type_ <= 40000 and not 40002 <= type_ <= 50000 and not 50002 <= type_ <= 60000 and type_ < 60002: raise rt.Reject
        self.type = _E_ReportIdentification_Type.get(type_, type_)
        identification_end_ = 6 + data[5]
        self.identification = data[6:identification_end_].decode("latin-1")
        if identification_end_ != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\x00\x4b")
        type_ = self.type
        if type_ not in _E_ReportIdentification_Type and not 10002 <= type_ <= 20000 and not 20002 <= type_ <= 30000 and not 30002 <= type_ <= 40000 and not 40002 <= type_ <= 50000 and not 50002 <= type_ <= 60000 and not 60002 <= type_ <= 65535: raise rt.Reject
        out += _S_BH.pack(self.query_type, type_)
        identification_raw_ = self.identification.encode("latin-1")
        out.append(len(identification_raw_))
        out += identification_raw_
        return bytes(out)


@dataclass(slots=True, repr=False)
class ReportConfiguration(rt.Message):
    """ReportConfiguration (0x4B01): Lists nodes and their components.

    node_list: 0..255 items. The nodes
    """

    CODE = 0x4B01
    NAME = "ReportConfiguration"
    SERVICE = "urn:jaus:jss:core:Discovery"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = False

    ComponentRec = core_v1_0_types.ComponentRec

    @dataclass(slots=True, repr=False)
    class NodeRec(rt.Struct):
        """One node.

        node_id: Node number
        """

        node_id: int

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("NodeID", rt.Number("B")),
            )

    @dataclass(slots=True, repr=False)
    class NodeSeq(rt.Struct):
        """NodeSeq.

        node_rec: One node
        component_list: 0..255 items. The components
        """

        node_rec: ReportConfiguration.NodeRec
        component_list: list[core_v1_0_types.ComponentRec]

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("NodeRec", ReportConfiguration.NodeRec.layout()),
                ("ComponentList", rt.Repeat(rt.Count("B", 0, 255), core_v1_0_types.ComponentRec.layout())),
            )

    node_list: list[ReportConfiguration.NodeSeq]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("NodeList", rt.Repeat(rt.Count("B", 0, 255), ReportConfiguration.NodeSeq.layout())),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0x01 or data[1] != 0x4B: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        node_list_count_ = data[2]
        if node_list_count_ * 2 > size - 3: raise rt.Reject
        at = 3
        node_list_ = []
        for _ in range(node_list_count_):
            item_ = rt.new(ReportConfiguration.NodeSeq)
            node_id_ = data[at]
            item_.node_rec = ReportConfiguration.NodeRec(node_id_)
            component_list_count_ = data[at + 1]
            component_list_end_ = at + 2 + component_list_count_ * 2
            item_.component_list = [core_v1_0_types.ComponentRec(component_id_, instance_id_) for component_id_, instance_id_ in _S_2B.iter_unpack(data[at + 2:component_list_end_])]
            at = component_list_end_
            node_list_.append(item_)
        self.node_list = node_list_
        if at != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\x01\x4b")
        node_list_ = self.node_list
        if type(node_list_) is not list: raise rt.Reject
        out.append(len(node_list_))
        for item_ in node_list_:
            if type(item_) is not ReportConfiguration.NodeSeq: raise rt.Reject
            node_rec_ = item_.node_rec
            if type(node_rec_) is not ReportConfiguration.NodeRec: raise rt.Reject
            out.append(node_rec_.node_id)
            component_list_ = item_.component_list
            if type(component_list_) is not list: raise rt.Reject
            out.append(len(component_list_))
            raw_: list[int | float] = []
            for item_2_ in component_list_:
                if type(item_2_) is not core_v1_0_types.ComponentRec: raise rt.Reject
                raw_ += (item_2_.component_id, item_2_.instance_id)
            out += _L_B[len(raw_)].pack(*raw_)
        return bytes(out)


@dataclass(slots=True, repr=False)
class ReportSubsystemList(rt.Message):
    """ReportSubsystemList (0x4B02): Lists subsystems, each with the component that answers for it.

    subsystem_list: 0..255 items. The subsystems
    """

    CODE = 0x4B02
    NAME = "ReportSubsystemList"
    SERVICE = "urn:jaus:jss:core:Discovery"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = False

    SubsystemRec = core_v1_0_types.SubsystemRec

    subsystem_list: list[core_v1_0_types.SubsystemRec]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("SubsystemList", rt.Repeat(rt.Count("B", 0, 255), core_v1_0_types.SubsystemRec.layout())),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0x02 or data[1] != 0x4B: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        subsystem_list_count_ = data[2]
        subsystem_list_end_ = 3 + subsystem_list_count_ * 4
        self.subsystem_list = [core_v1_0_types.SubsystemRec(subsystem_id_, node_id_, component_id_) for subsystem_id_, node_id_, component_id_ in _S_H2B.iter_unpack(data[3:subsystem_list_end_])]
        if subsystem_list_end_ != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\x02\x4b")
        subsystem_list_ = self.subsystem_list
        if type(subsystem_list_) is not list: raise rt.Reject
        out.append(len(subsystem_list_))
        for item_ in subsystem_list_:
            if type(item_) is not core_v1_0_types.SubsystemRec: raise rt.Reject
            out += _S_H2B.pack(item_.subsystem_id, item_.node_id, item_.component_id)
        return bytes(out)


@dataclass(slots=True, repr=False)
class ReportServices(rt.Message):
    """ReportServices (0x4B03): Lists services by node and component.

    node_list: 0..255 items. The nodes
    """

    CODE = 0x4B03
    NAME = "ReportServices"
    SERVICE = "urn:jaus:jss:core:Discovery"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = False

    ComponentRec = core_v1_0_types.ComponentRec
    ServiceRec = core_v1_0_types.ServiceRec

    @dataclass(slots=True, repr=False)
    class NodeRec(rt.Struct):
        """One node.

        node_id: Node number
        """

        node_id: int

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("NodeID", rt.Number("B")),
            )

    @dataclass(slots=True, repr=False)
    class ComponentSeq(rt.Struct):
        """ComponentSeq.

        component_rec: One component
        service_list: 0..255 items. The services
        """

        component_rec: core_v1_0_types.ComponentRec
        service_list: list[core_v1_0_types.ServiceRec]

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("ComponentRec", core_v1_0_types.ComponentRec.layout()),
                ("ServiceList", rt.Repeat(rt.Count("B", 0, 255), core_v1_0_types.ServiceRec.layout())),
            )

    @dataclass(slots=True, repr=False)
    class NodeSeq(rt.Struct):
        """NodeSeq.

        node_rec: One node
        component_list: 0..255 items. The components
        """

        node_rec: ReportServices.NodeRec
        component_list: list[ReportServices.ComponentSeq]

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("NodeRec", ReportServices.NodeRec.layout()),
                ("ComponentList", rt.Repeat(rt.Count("B", 0, 255), ReportServices.ComponentSeq.layout())),
            )

    node_list: list[ReportServices.NodeSeq]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("NodeList", rt.Repeat(rt.Count("B", 0, 255), ReportServices.NodeSeq.layout())),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0x03 or data[1] != 0x4B: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        node_list_count_ = data[2]
        if node_list_count_ * 2 > size - 3: raise rt.Reject
        at = 3
        node_list_ = []
        for _ in range(node_list_count_):
            item_ = rt.new(ReportServices.NodeSeq)
            node_id_ = data[at]
            item_.node_rec = ReportServices.NodeRec(node_id_)
            component_list_count_ = data[at + 1]
            if component_list_count_ * 3 > size - (at + 2): raise rt.Reject
            at += 2
            component_list_ = []
            for _ in range(component_list_count_):
                item_2_ = rt.new(ReportServices.ComponentSeq)
                component_id_ = data[at]
                instance_id_ = data[at + 1]
                item_2_.component_rec = core_v1_0_types.ComponentRec(component_id_, instance_id_)
                service_list_count_ = data[at + 2]
                if service_list_count_ * 3 > size - (at + 3): raise rt.Reject
                at += 3
                service_list_ = []
                for _ in range(service_list_count_):
                    item_3_ = rt.new(core_v1_0_types.ServiceRec)
                    uri_end_ = at + 1 + data[at]
                    item_3_.uri = data[at + 1:uri_end_].decode("latin-1")
                    item_3_.major_version_number = data[uri_end_]
                    item_3_.minor_version_number = data[uri_end_ + 1]
                    at = uri_end_ + 2
                    service_list_.append(item_3_)
                item_2_.service_list = service_list_
                component_list_.append(item_2_)
            item_.component_list = component_list_
            node_list_.append(item_)
        self.node_list = node_list_
        if at != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\x03\x4b")
        node_list_ = self.node_list
        if type(node_list_) is not list: raise rt.Reject
        out.append(len(node_list_))
        for item_ in node_list_:
            if type(item_) is not ReportServices.NodeSeq: raise rt.Reject
            node_rec_ = item_.node_rec
            if type(node_rec_) is not ReportServices.NodeRec: raise rt.Reject
            out.append(node_rec_.node_id)
            component_list_ = item_.component_list
            if type(component_list_) is not list: raise rt.Reject
            out.append(len(component_list_))
            for item_2_ in component_list_:
                if type(item_2_) is not ReportServices.ComponentSeq: raise rt.Reject
                component_rec_ = item_2_.component_rec
                if type(component_rec_) is not core_v1_0_types.ComponentRec: raise rt.Reject
                out.append(component_rec_.component_id)
                out.append(component_rec_.instance_id)
                service_list_ = item_2_.service_list
                if type(service_list_) is not list: raise rt.Reject
                out.append(len(service_list_))
                for item_3_ in service_list_:
                    if type(item_3_) is not core_v1_0_types.ServiceRec: raise rt.Reject
                    uri_raw_ = item_3_.uri.encode("latin-1")
                    out.append(len(uri_raw_))
                    out += uri_raw_
                    out.append(item_3_.major_version_number)
                    out.append(item_3_.minor_version_number)
        return bytes(out)


_E_QueryIdentification_QueryType = rt.members(QueryIdentification.QueryType)
_S_HB = rt.Packer("<HB")
_E_QueryConfiguration_QueryType = rt.members(QueryConfiguration.QueryType)
_S_H = rt.Packer("<H")
_E_QueriedNodeRec_NodeID = rt.members(core_v1_0_types.QueriedNodeRec.NodeID)
_E_QueriedComponentRec_ComponentID = rt.members(core_v1_0_types.QueriedComponentRec.ComponentID)
_L_B = rt.Rows("B")
_E_ReportIdentification_QueryType = rt.members(ReportIdentification.QueryType)
_E_ReportIdentification_Type = rt.members(ReportIdentification.Type)
_S_BH = rt.Packer("<BH")
_S_2B = rt.Packer("<2B")
_S_H2B = rt.Packer("<H2B")
QueryIdentification.REPORT = ReportIdentification
QueryConfiguration.REPORT = ReportConfiguration
QuerySubsystemList.REPORT = ReportSubsystemList
QueryServices.REPORT = ReportServices
