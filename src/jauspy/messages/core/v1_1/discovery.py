"""urn:jaus:jss:core:Discovery 1.1. Generated from schemas/; do not edit."""

from __future__ import annotations

from dataclasses import dataclass
from enum import IntEnum
from typing import ClassVar, Self

from jauspy.codec import runtime as rt
from jauspy.messages.core.v1_0 import discovery as core_v1_0_discovery
from jauspy.messages.core.v1_0 import types as core_v1_0_types


class QueryIdentification(core_v1_0_discovery.QueryIdentification):
    """QueryIdentification (0x2B00): Asks for the name of a system, subsystem, node or component."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:core:Discovery"
    VERSION = "1.1"
    REPORT: ClassVar[type[ReportIdentification]]


class QueryConfiguration(core_v1_0_discovery.QueryConfiguration):
    """QueryConfiguration (0x2B01): Asks for the components of a subsystem or node."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:core:Discovery"
    VERSION = "1.1"
    REPORT: ClassVar[type[ReportConfiguration]]


class QuerySubsystemList(core_v1_0_discovery.QuerySubsystemList):
    """QuerySubsystemList (0x2B02): Asks for the known subsystems."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:core:Discovery"
    VERSION = "1.1"
    REPORT: ClassVar[type[ReportSubsystemList]]


class QueryServices(core_v1_0_discovery.QueryServices):
    """QueryServices (0x2B03): Asks for the services of selected components of the subsystem."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:core:Discovery"
    VERSION = "1.1"
    REPORT: ClassVar[type[ReportServices]]


@dataclass(slots=True, repr=False)
class QueryServiceList(rt.Message):
    """QueryServiceList (0x2B04): Asks for the services of selected components of several subsystems, filtered by
    name.

    subsystem_list: 1..65535 items. The subsystems
    """

    CODE = 0x2B04
    NAME = "QueryServiceList"
    SERVICE = "urn:jaus:jss:core:Discovery"
    VERSION = "1.1"
    IS_COMMAND = False
    IS_QUERY = True
    REPORT: ClassVar[type[ReportServiceList]]

    QueriedNodeRec = core_v1_0_types.QueriedNodeRec

    class SubsystemID(IntEnum):
        """Values of SubsystemID."""

        RESERVED = 0
        ALL_SUBSYSTEMS = 65535

    @dataclass(slots=True, repr=False)
    class SubsystemRec(rt.Struct):
        """One subsystem.

        subsystem_id: SubsystemID or 1..65534. Subsystem number
        """

        subsystem_id: QueryServiceList.SubsystemID | int

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("SubsystemID", rt.Number("H", rt.Values(QueryServiceList.SubsystemID, ((1, 65534),)))),
            )

    class ComponentID(IntEnum):
        """Values of ComponentID."""

        RESERVED = 0
        ALL_COMPONENTS = 255

    @dataclass(slots=True, repr=False)
    class ComponentRec(rt.Struct):
        """One component.

        component_id: ComponentID or 1..254. Component number
        search_filter: up to 255 characters, optional. Part of the names of the wanted services; all when absent
        """

        component_id: QueryServiceList.ComponentID | int
        search_filter: str | None = None
        reserved_presence: int = 0

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, "B",
                ("ComponentID", rt.Number("B", rt.Values(QueryServiceList.ComponentID, ((1, 254),)))),
                ("SearchFilter", rt.Text(count=rt.Count("B", 0, 255)), True),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            mask = data[at]
            component_id_ = data[at + 1]
            self.component_id = _E_QueryServiceList_ComponentID.get(component_id_, component_id_)
            at += 2
            if mask & 1:
                search_filter_end_ = at + 1 + data[at]
                self.search_filter = data[at + 1:search_filter_end_].decode("latin-1")
                at = search_filter_end_
            else: self.search_filter = None
            self.reserved_presence = mask & 0xFE
            return self, at

        def _write(self, out: bytearray) -> None:
            start = len(out)
            out += b"\0"
            mask = self.reserved_presence
            if mask & 0x1: raise rt.Reject
            out.append(self.component_id)
            search_filter_ = self.search_filter
            if search_filter_ is not None:
                mask |= 1
                search_filter_raw_ = search_filter_.encode("latin-1")
                out.append(len(search_filter_raw_))
                out += search_filter_raw_
            _S_B.pack_into(out, start, mask)

    @dataclass(slots=True, repr=False)
    class NodeSeq(rt.Struct):
        """NodeSeq.

        node_rec: One node, or all
        component_list: 1..255 items. The components
        """

        node_rec: core_v1_0_types.QueriedNodeRec
        component_list: list[QueryServiceList.ComponentRec]

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("NodeRec", core_v1_0_types.QueriedNodeRec.layout()),
                ("ComponentList", rt.Repeat(rt.Count("B", 1, 255), QueryServiceList.ComponentRec.layout())),
            )

    @dataclass(slots=True, repr=False)
    class SubsystemSeq(rt.Struct):
        """SubsystemSeq.

        subsystem_rec: One subsystem
        node_list: 1..255 items. The nodes
        """

        subsystem_rec: QueryServiceList.SubsystemRec
        node_list: list[QueryServiceList.NodeSeq]

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("SubsystemRec", QueryServiceList.SubsystemRec.layout()),
                ("NodeList", rt.Repeat(rt.Count("B", 1, 255), QueryServiceList.NodeSeq.layout())),
            )

    subsystem_list: list[QueryServiceList.SubsystemSeq]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("SubsystemList", rt.Repeat(rt.Count("H", 1, 65535), QueryServiceList.SubsystemSeq.layout())),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0x04 or data[1] != 0x2B: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        (subsystem_list_count_,) = _S_H.unpack_from(data, 2)
        if subsystem_list_count_ < 1: raise rt.Reject
        if subsystem_list_count_ * 3 > size - 4: raise rt.Reject
        at = 4
        subsystem_list_ = []
        for _ in range(subsystem_list_count_):
            item_ = rt.new(QueryServiceList.SubsystemSeq)
            (subsystem_id_,) = _S_H.unpack_from(data, at)
            item_.subsystem_rec = QueryServiceList.SubsystemRec(_E_QueryServiceList_SubsystemID.get(subsystem_id_, subsystem_id_))
            node_list_count_ = data[at + 2]
            if node_list_count_ < 1: raise rt.Reject
            if node_list_count_ * 2 > size - (at + 3): raise rt.Reject
            at += 3
            node_list_ = []
            for _ in range(node_list_count_):
                item_2_ = rt.new(QueryServiceList.NodeSeq)
                node_id_ = data[at]
                item_2_.node_rec = core_v1_0_types.QueriedNodeRec(_E_QueriedNodeRec_NodeID.get(node_id_, node_id_))
                component_list_count_ = data[at + 1]
                if component_list_count_ < 1: raise rt.Reject
                if component_list_count_ * 2 > size - (at + 2): raise rt.Reject
                at += 2
                component_list_ = []
                for _ in range(component_list_count_):
                    item_3_, at = QueryServiceList.ComponentRec._read(data, at, nesting)
                    component_list_.append(item_3_)
                item_2_.component_list = component_list_
                node_list_.append(item_2_)
            item_.node_list = node_list_
            subsystem_list_.append(item_)
        self.subsystem_list = subsystem_list_
        if at != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\x04\x2b")
        subsystem_list_ = self.subsystem_list
        if type(subsystem_list_) is not list: raise rt.Reject
        if len(subsystem_list_) < 1: raise rt.Reject
        out += _S_H.pack(len(subsystem_list_))
        for item_ in subsystem_list_:
            if type(item_) is not QueryServiceList.SubsystemSeq: raise rt.Reject
            subsystem_rec_ = item_.subsystem_rec
            if type(subsystem_rec_) is not QueryServiceList.SubsystemRec: raise rt.Reject
            out += _S_H.pack(subsystem_rec_.subsystem_id)
            node_list_ = item_.node_list
            if type(node_list_) is not list: raise rt.Reject
            if len(node_list_) < 1: raise rt.Reject
            out.append(len(node_list_))
            for item_2_ in node_list_:
                if type(item_2_) is not QueryServiceList.NodeSeq: raise rt.Reject
                node_rec_ = item_2_.node_rec
                if type(node_rec_) is not core_v1_0_types.QueriedNodeRec: raise rt.Reject
                out.append(node_rec_.node_id)
                component_list_ = item_2_.component_list
                if type(component_list_) is not list: raise rt.Reject
                if len(component_list_) < 1: raise rt.Reject
                out.append(len(component_list_))
                for item_3_ in component_list_:
                    if type(item_3_) is not QueryServiceList.ComponentRec: raise rt.Reject
                    item_3_._write(out)
        return bytes(out)


class RegisterServices(core_v1_0_discovery.RegisterServices):
    """RegisterServices (0x0B00): Tells the Discovery service of the node which services a component offers."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:core:Discovery"
    VERSION = "1.1"


class ReportIdentification(core_v1_0_discovery.ReportIdentification):
    """ReportIdentification (0x4B00): Tells the name and kind of a system, subsystem, node or component."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:core:Discovery"
    VERSION = "1.1"


class ReportConfiguration(core_v1_0_discovery.ReportConfiguration):
    """ReportConfiguration (0x4B01): Lists nodes and their components."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:core:Discovery"
    VERSION = "1.1"


class ReportSubsystemList(core_v1_0_discovery.ReportSubsystemList):
    """ReportSubsystemList (0x4B02): Lists subsystems, each with the component that answers for it."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:core:Discovery"
    VERSION = "1.1"


class ReportServices(core_v1_0_discovery.ReportServices):
    """ReportServices (0x4B03): Lists services by node and component."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:core:Discovery"
    VERSION = "1.1"


@dataclass(slots=True, repr=False)
class ReportServiceList(rt.Message):
    """ReportServiceList (0x4B04): Lists services by subsystem, node and component.

    subsystem_list: 0..65535 items. The subsystems
    """

    CODE = 0x4B04
    NAME = "ReportServiceList"
    SERVICE = "urn:jaus:jss:core:Discovery"
    VERSION = "1.1"
    IS_COMMAND = False
    IS_QUERY = False

    ComponentRec = core_v1_0_types.ComponentRec
    ServiceRec = core_v1_0_types.ServiceRec

    @dataclass(slots=True, repr=False)
    class SubsystemRec(rt.Struct):
        """One subsystem.

        subsystem_id: Subsystem number
        """

        subsystem_id: int

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("SubsystemID", rt.Number("H")),
            )

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

        node_rec: ReportServiceList.NodeRec
        component_list: list[ReportServiceList.ComponentSeq]

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("NodeRec", ReportServiceList.NodeRec.layout()),
                ("ComponentList", rt.Repeat(rt.Count("B", 0, 255), ReportServiceList.ComponentSeq.layout())),
            )

    @dataclass(slots=True, repr=False)
    class SubsystemSeq(rt.Struct):
        """SubsystemSeq.

        subsystem_rec: One subsystem
        node_list: 0..255 items. The nodes
        """

        subsystem_rec: ReportServiceList.SubsystemRec
        node_list: list[ReportServiceList.NodeSeq]

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("SubsystemRec", ReportServiceList.SubsystemRec.layout()),
                ("NodeList", rt.Repeat(rt.Count("B", 0, 255), ReportServiceList.NodeSeq.layout())),
            )

    subsystem_list: list[ReportServiceList.SubsystemSeq]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("SubsystemList", rt.Repeat(rt.Count("H", 0, 65535), ReportServiceList.SubsystemSeq.layout())),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0x04 or data[1] != 0x4B: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        (subsystem_list_count_,) = _S_H.unpack_from(data, 2)
        if subsystem_list_count_ * 3 > size - 4: raise rt.Reject
        at = 4
        subsystem_list_ = []
        for _ in range(subsystem_list_count_):
            item_ = rt.new(ReportServiceList.SubsystemSeq)
            (subsystem_id_,) = _S_H.unpack_from(data, at)
            item_.subsystem_rec = ReportServiceList.SubsystemRec(subsystem_id_)
            node_list_count_ = data[at + 2]
            if node_list_count_ * 2 > size - (at + 3): raise rt.Reject
            at += 3
            node_list_ = []
            for _ in range(node_list_count_):
                item_2_ = rt.new(ReportServiceList.NodeSeq)
                node_id_ = data[at]
                item_2_.node_rec = ReportServiceList.NodeRec(node_id_)
                component_list_count_ = data[at + 1]
                if component_list_count_ * 3 > size - (at + 2): raise rt.Reject
                at += 2
                component_list_ = []
                for _ in range(component_list_count_):
                    item_3_ = rt.new(ReportServiceList.ComponentSeq)
                    component_id_ = data[at]
                    instance_id_ = data[at + 1]
                    item_3_.component_rec = core_v1_0_types.ComponentRec(component_id_, instance_id_)
                    service_list_count_ = data[at + 2]
                    if service_list_count_ * 3 > size - (at + 3): raise rt.Reject
                    at += 3
                    service_list_ = []
                    for _ in range(service_list_count_):
                        item_4_ = rt.new(core_v1_0_types.ServiceRec)
                        uri_end_ = at + 1 + data[at]
                        item_4_.uri = data[at + 1:uri_end_].decode("latin-1")
                        item_4_.major_version_number = data[uri_end_]
                        item_4_.minor_version_number = data[uri_end_ + 1]
                        at = uri_end_ + 2
                        service_list_.append(item_4_)
                    item_3_.service_list = service_list_
                    component_list_.append(item_3_)
                item_2_.component_list = component_list_
                node_list_.append(item_2_)
            item_.node_list = node_list_
            subsystem_list_.append(item_)
        self.subsystem_list = subsystem_list_
        if at != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\x04\x4b")
        subsystem_list_ = self.subsystem_list
        if type(subsystem_list_) is not list: raise rt.Reject
        out += _S_H.pack(len(subsystem_list_))
        for item_ in subsystem_list_:
            if type(item_) is not ReportServiceList.SubsystemSeq: raise rt.Reject
            subsystem_rec_ = item_.subsystem_rec
            if type(subsystem_rec_) is not ReportServiceList.SubsystemRec: raise rt.Reject
            out += _S_H.pack(subsystem_rec_.subsystem_id)
            node_list_ = item_.node_list
            if type(node_list_) is not list: raise rt.Reject
            out.append(len(node_list_))
            for item_2_ in node_list_:
                if type(item_2_) is not ReportServiceList.NodeSeq: raise rt.Reject
                node_rec_ = item_2_.node_rec
                if type(node_rec_) is not ReportServiceList.NodeRec: raise rt.Reject
                out.append(node_rec_.node_id)
                component_list_ = item_2_.component_list
                if type(component_list_) is not list: raise rt.Reject
                out.append(len(component_list_))
                for item_3_ in component_list_:
                    if type(item_3_) is not ReportServiceList.ComponentSeq: raise rt.Reject
                    component_rec_ = item_3_.component_rec
                    if type(component_rec_) is not core_v1_0_types.ComponentRec: raise rt.Reject
                    out.append(component_rec_.component_id)
                    out.append(component_rec_.instance_id)
                    service_list_ = item_3_.service_list
                    if type(service_list_) is not list: raise rt.Reject
                    out.append(len(service_list_))
                    for item_4_ in service_list_:
                        if type(item_4_) is not core_v1_0_types.ServiceRec: raise rt.Reject
                        uri_raw_ = item_4_.uri.encode("latin-1")
                        out.append(len(uri_raw_))
                        out += uri_raw_
                        out.append(item_4_.major_version_number)
                        out.append(item_4_.minor_version_number)
        return bytes(out)


_E_QueryServiceList_ComponentID = rt.members(QueryServiceList.ComponentID)
_S_B = rt.Packer("<B")
_S_H = rt.Packer("<H")
_E_QueryServiceList_SubsystemID = rt.members(QueryServiceList.SubsystemID)
_E_QueriedNodeRec_NodeID = rt.members(core_v1_0_types.QueriedNodeRec.NodeID)
QueryIdentification.REPORT = ReportIdentification
QueryConfiguration.REPORT = ReportConfiguration
QuerySubsystemList.REPORT = ReportSubsystemList
QueryServices.REPORT = ReportServices
QueryServiceList.REPORT = ReportServiceList
