"""urn:jaus:jss:core:Discovery 1.1. Generated from schemas/; do not edit."""

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

    CODE: ClassVar[int] = 0x2B00
    NAME: ClassVar[str] = "QueryIdentification"
    SERVICE: ClassVar[str] = "urn:jaus:jss:core:Discovery"
    VERSION: ClassVar[str] = "1.1"
    IS_COMMAND: ClassVar[bool] = False

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
        return rt.Composite(
            cls,
            (
                rt.Slot("query_type", "QueryType", rt.Number("B", rt.Values(QueryIdentification.QueryType, ((5, 255),)))),
            ),
        )

    @classmethod
    def _unpack(cls, data: bytes, depth: int) -> Self:
        code, query_type_ = _S_HB.unpack(data)
        if code != 0x2B00:
            raise rt.Reject
        return cls(_E_QueryIdentification_QueryType.get(query_type_, query_type_))

    def _pack(self) -> bytes:
        query_type_ = self.query_type
        return _S_HB.pack(0x2B00, query_type_)


@dataclass(slots=True, repr=False)
class QueryConfiguration(rt.Message):
    """QueryConfiguration (0x2B01): Asks for the components of a subsystem or node.

    query_type: QueryType or 4..255. Whose components are wanted
    """

    CODE: ClassVar[int] = 0x2B01
    NAME: ClassVar[str] = "QueryConfiguration"
    SERVICE: ClassVar[str] = "urn:jaus:jss:core:Discovery"
    VERSION: ClassVar[str] = "1.1"
    IS_COMMAND: ClassVar[bool] = False

    class QueryType(IntEnum):
        """Values of QueryType."""

        RESERVED_0 = 0
        RESERVED_1 = 1
        SUBSYSTEM = 2
        NODE = 3

    query_type: QueryConfiguration.QueryType | int

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(
            cls,
            (
                rt.Slot("query_type", "QueryType", rt.Number("B", rt.Values(QueryConfiguration.QueryType, ((4, 255),)))),
            ),
        )

    @classmethod
    def _unpack(cls, data: bytes, depth: int) -> Self:
        code, query_type_ = _S_HB.unpack(data)
        if code != 0x2B01:
            raise rt.Reject
        return cls(_E_QueryConfiguration_QueryType.get(query_type_, query_type_))

    def _pack(self) -> bytes:
        query_type_ = self.query_type
        return _S_HB.pack(0x2B01, query_type_)


@dataclass(slots=True, repr=False)
class QuerySubsystemList(rt.Message):
    """QuerySubsystemList (0x2B02): Asks for the known subsystems."""

    CODE: ClassVar[int] = 0x2B02
    NAME: ClassVar[str] = "QuerySubsystemList"
    SERVICE: ClassVar[str] = "urn:jaus:jss:core:Discovery"
    VERSION: ClassVar[str] = "1.1"
    IS_COMMAND: ClassVar[bool] = False

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(cls, ())

    @classmethod
    def _unpack(cls, data: bytes, depth: int) -> Self:
        code, = _S_H.unpack(data)
        if code != 0x2B02:
            raise rt.Reject
        return cls()

    def _pack(self) -> bytes:
        return _S_H.pack(0x2B02)


@dataclass(slots=True, repr=False)
class QueryServices(rt.Message):
    """QueryServices (0x2B03): Asks for the services of selected components of the subsystem.

    node_list: 1..255 items. The nodes
    """

    CODE: ClassVar[int] = 0x2B03
    NAME: ClassVar[str] = "QueryServices"
    SERVICE: ClassVar[str] = "urn:jaus:jss:core:Discovery"
    VERSION: ClassVar[str] = "1.1"
    IS_COMMAND: ClassVar[bool] = False

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
            return rt.Composite(
                cls,
                (
                    rt.Slot("node_rec", "NodeRec", core_v1_0_types.QueriedNodeRec.layout()),
                    rt.Slot("component_list", "ComponentList", rt.Repeat(rt.Count("B", 1, 255), core_v1_0_types.QueriedComponentRec.layout())),
                ),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, depth: int) -> tuple[Self, int]:
            size = len(data)
            node_rec_node_id_ = data[at]
            at += 1
            node_rec_ = core_v1_0_types.QueriedNodeRec(_E_QueriedNodeRec_NodeID.get(node_rec_node_id_, node_rec_node_id_))
            component_list_count = data[at]
            at += 1
            if component_list_count < 1:
                raise rt.Reject
            component_list_end = at + component_list_count * 1
            if component_list_end > size:
                raise rt.Reject
            component_list_ = [core_v1_0_types.QueriedComponentRec(_E_QueriedComponentRec_ComponentID.get(component_list_item_component_id_, component_list_item_component_id_)) for (component_list_item_component_id_,) in _S_B.iter_unpack(data[at:component_list_end])]
            at = component_list_end
            return cls(node_rec_, component_list_), at

        def _write(self, out: bytearray) -> None:
            node_rec_ = self.node_rec
            if type(node_rec_) is not core_v1_0_types.QueriedNodeRec:
                raise rt.Reject
            node_rec_node_id_ = node_rec_.node_id
            out += _S_B.pack(node_rec_node_id_)
            component_list_ = self.component_list
            if type(component_list_) is not list:
                raise rt.Reject
            if len(component_list_) < 1:
                raise rt.Reject
            out.append(len(component_list_))
            for component_list_item_ in component_list_:
                if type(component_list_item_) is not core_v1_0_types.QueriedComponentRec:
                    raise rt.Reject
                component_list_item_component_id_ = component_list_item_.component_id
                out += _S_B.pack(component_list_item_component_id_)

    node_list: list[QueryServices.NodeSeq]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(
            cls,
            (
                rt.Slot("node_list", "NodeList", rt.Repeat(rt.Count("B", 1, 255), QueryServices.NodeSeq.layout())),
            ),
        )

    @classmethod
    def _unpack(cls, data: bytes, depth: int) -> Self:
        if data[0] != 0x03 or data[1] != 0x2B:
            raise rt.Reject
        at = 2
        size = len(data)
        node_list_count = data[at]
        at += 1
        if node_list_count < 1:
            raise rt.Reject
        if node_list_count * 2 > size - at:
            raise rt.Reject
        node_list_ = []
        for _ in range(node_list_count):
            node_list_item_node_rec_node_id_ = data[at]
            at += 1
            node_list_item_component_list_count = data[at]
            at += 1
            if node_list_item_component_list_count < 1:
                raise rt.Reject
            node_list_item_component_list_end = at + node_list_item_component_list_count * 1
            if node_list_item_component_list_end > size:
                raise rt.Reject
            node_list_item_component_list_ = [core_v1_0_types.QueriedComponentRec(_E_QueriedComponentRec_ComponentID.get(node_list_item_component_list_item_component_id_, node_list_item_component_list_item_component_id_)) for (node_list_item_component_list_item_component_id_,) in _S_B.iter_unpack(data[at:node_list_item_component_list_end])]
            at = node_list_item_component_list_end
            node_list_item_ = QueryServices.NodeSeq(core_v1_0_types.QueriedNodeRec(_E_QueriedNodeRec_NodeID.get(node_list_item_node_rec_node_id_, node_list_item_node_rec_node_id_)), node_list_item_component_list_)
            node_list_.append(node_list_item_)
        if at != len(data):
            raise rt.Reject
        return cls(node_list_)

    def _pack(self) -> bytes:
        out = bytearray(b"\x03\x2b")
        node_list_ = self.node_list
        if type(node_list_) is not list:
            raise rt.Reject
        if len(node_list_) < 1:
            raise rt.Reject
        out.append(len(node_list_))
        for node_list_item_ in node_list_:
            if type(node_list_item_) is not QueryServices.NodeSeq:
                raise rt.Reject
            node_list_item_node_rec_ = node_list_item_.node_rec
            if type(node_list_item_node_rec_) is not core_v1_0_types.QueriedNodeRec:
                raise rt.Reject
            node_list_item_node_rec_node_id_ = node_list_item_node_rec_.node_id
            out += _S_B.pack(node_list_item_node_rec_node_id_)
            node_list_item_component_list_ = node_list_item_.component_list
            if type(node_list_item_component_list_) is not list:
                raise rt.Reject
            if len(node_list_item_component_list_) < 1:
                raise rt.Reject
            out.append(len(node_list_item_component_list_))
            for node_list_item_component_list_item_ in node_list_item_component_list_:
                if type(node_list_item_component_list_item_) is not core_v1_0_types.QueriedComponentRec:
                    raise rt.Reject
                node_list_item_component_list_item_component_id_ = node_list_item_component_list_item_.component_id
                out += _S_B.pack(node_list_item_component_list_item_component_id_)
        return bytes(out)


@dataclass(slots=True, repr=False)
class QueryServiceList(rt.Message):
    """QueryServiceList (0x2B04): Asks for the services of selected components of several subsystems, filtered by
    name.

    subsystem_list: 1..65535 items. The subsystems
    """

    CODE: ClassVar[int] = 0x2B04
    NAME: ClassVar[str] = "QueryServiceList"
    SERVICE: ClassVar[str] = "urn:jaus:jss:core:Discovery"
    VERSION: ClassVar[str] = "1.1"
    IS_COMMAND: ClassVar[bool] = False

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
            return rt.Composite(
                cls,
                (
                    rt.Slot("subsystem_id", "SubsystemID", rt.Number("H", rt.Values(QueryServiceList.SubsystemID, ((1, 65534),)))),
                ),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, depth: int) -> tuple[Self, int]:
            (subsystem_id_,) = _S_H.unpack_from(data, at)
            at += 2
            subsystem_id_ = _E_QueryServiceList_SubsystemID.get(subsystem_id_, subsystem_id_)
            return cls(subsystem_id_), at

        def _write(self, out: bytearray) -> None:
            subsystem_id_ = self.subsystem_id
            out += _S_H.pack(subsystem_id_)

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
            return rt.Composite(
                cls,
                (
                    rt.Slot("component_id", "ComponentID", rt.Number("B", rt.Values(QueryServiceList.ComponentID, ((1, 254),)))),
                    rt.Slot("search_filter", "SearchFilter", rt.Text(count=rt.Count("B", 0, 255)), optional=True),
                ),
                "B",
            )

        @classmethod
        def _read(cls, data: bytes, at: int, depth: int) -> tuple[Self, int]:
            size = len(data)
            mask = data[at]
            at += 1
            component_id_ = data[at]
            at += 1
            component_id_ = _E_QueryServiceList_ComponentID.get(component_id_, component_id_)
            search_filter_: str | None = None
            if mask & 1:
                search_filter_end = data[at]
                at += 1
                search_filter_end += at
                if search_filter_end > size:
                    raise rt.Reject
                search_filter_ = data[at:search_filter_end].decode("latin-1")
                at = search_filter_end
            return cls(component_id_, search_filter_, mask & 0xFE), at

        def _write(self, out: bytearray) -> None:
            start = len(out)
            out += b"\0"
            mask = self.reserved_presence
            if mask & 0x1:
                raise rt.Reject
            component_id_ = self.component_id
            out += _S_B.pack(component_id_)
            search_filter_ = self.search_filter
            if search_filter_ is not None:
                mask |= 1
                search_filter_raw = search_filter_.encode("latin-1")
                out.append(len(search_filter_raw))
                out += search_filter_raw
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
            return rt.Composite(
                cls,
                (
                    rt.Slot("node_rec", "NodeRec", core_v1_0_types.QueriedNodeRec.layout()),
                    rt.Slot("component_list", "ComponentList", rt.Repeat(rt.Count("B", 1, 255), QueryServiceList.ComponentRec.layout())),
                ),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, depth: int) -> tuple[Self, int]:
            size = len(data)
            node_rec_node_id_ = data[at]
            at += 1
            node_rec_ = core_v1_0_types.QueriedNodeRec(_E_QueriedNodeRec_NodeID.get(node_rec_node_id_, node_rec_node_id_))
            component_list_count = data[at]
            at += 1
            if component_list_count < 1:
                raise rt.Reject
            if component_list_count * 2 > size - at:
                raise rt.Reject
            component_list_ = []
            for _ in range(component_list_count):
                component_list_item_, at = QueryServiceList.ComponentRec._read(data, at, depth)
                component_list_.append(component_list_item_)
            return cls(node_rec_, component_list_), at

        def _write(self, out: bytearray) -> None:
            node_rec_ = self.node_rec
            if type(node_rec_) is not core_v1_0_types.QueriedNodeRec:
                raise rt.Reject
            node_rec_node_id_ = node_rec_.node_id
            out += _S_B.pack(node_rec_node_id_)
            component_list_ = self.component_list
            if type(component_list_) is not list:
                raise rt.Reject
            if len(component_list_) < 1:
                raise rt.Reject
            out.append(len(component_list_))
            for component_list_item_ in component_list_:
                if type(component_list_item_) is not QueryServiceList.ComponentRec:
                    raise rt.Reject
                component_list_item_._write(out)

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
            return rt.Composite(
                cls,
                (
                    rt.Slot("subsystem_rec", "SubsystemRec", QueryServiceList.SubsystemRec.layout()),
                    rt.Slot("node_list", "NodeList", rt.Repeat(rt.Count("B", 1, 255), QueryServiceList.NodeSeq.layout())),
                ),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, depth: int) -> tuple[Self, int]:
            size = len(data)
            (subsystem_rec_subsystem_id_,) = _S_H.unpack_from(data, at)
            at += 2
            subsystem_rec_ = QueryServiceList.SubsystemRec(_E_QueryServiceList_SubsystemID.get(subsystem_rec_subsystem_id_, subsystem_rec_subsystem_id_))
            node_list_count = data[at]
            at += 1
            if node_list_count < 1:
                raise rt.Reject
            if node_list_count * 2 > size - at:
                raise rt.Reject
            node_list_ = []
            for _ in range(node_list_count):
                node_list_item_node_rec_node_id_ = data[at]
                at += 1
                node_list_item_component_list_count = data[at]
                at += 1
                if node_list_item_component_list_count < 1:
                    raise rt.Reject
                if node_list_item_component_list_count * 2 > size - at:
                    raise rt.Reject
                node_list_item_component_list_ = []
                for _ in range(node_list_item_component_list_count):
                    node_list_item_component_list_item_, at = QueryServiceList.ComponentRec._read(data, at, depth)
                    node_list_item_component_list_.append(node_list_item_component_list_item_)
                node_list_item_ = QueryServiceList.NodeSeq(core_v1_0_types.QueriedNodeRec(_E_QueriedNodeRec_NodeID.get(node_list_item_node_rec_node_id_, node_list_item_node_rec_node_id_)), node_list_item_component_list_)
                node_list_.append(node_list_item_)
            return cls(subsystem_rec_, node_list_), at

        def _write(self, out: bytearray) -> None:
            subsystem_rec_ = self.subsystem_rec
            if type(subsystem_rec_) is not QueryServiceList.SubsystemRec:
                raise rt.Reject
            subsystem_rec_subsystem_id_ = subsystem_rec_.subsystem_id
            out += _S_H.pack(subsystem_rec_subsystem_id_)
            node_list_ = self.node_list
            if type(node_list_) is not list:
                raise rt.Reject
            if len(node_list_) < 1:
                raise rt.Reject
            out.append(len(node_list_))
            for node_list_item_ in node_list_:
                if type(node_list_item_) is not QueryServiceList.NodeSeq:
                    raise rt.Reject
                node_list_item_node_rec_ = node_list_item_.node_rec
                if type(node_list_item_node_rec_) is not core_v1_0_types.QueriedNodeRec:
                    raise rt.Reject
                node_list_item_node_rec_node_id_ = node_list_item_node_rec_.node_id
                out += _S_B.pack(node_list_item_node_rec_node_id_)
                node_list_item_component_list_ = node_list_item_.component_list
                if type(node_list_item_component_list_) is not list:
                    raise rt.Reject
                if len(node_list_item_component_list_) < 1:
                    raise rt.Reject
                out.append(len(node_list_item_component_list_))
                for node_list_item_component_list_item_ in node_list_item_component_list_:
                    if type(node_list_item_component_list_item_) is not QueryServiceList.ComponentRec:
                        raise rt.Reject
                    node_list_item_component_list_item_._write(out)

    subsystem_list: list[QueryServiceList.SubsystemSeq]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(
            cls,
            (
                rt.Slot("subsystem_list", "SubsystemList", rt.Repeat(rt.Count("H", 1, 65535), QueryServiceList.SubsystemSeq.layout())),
            ),
        )

    @classmethod
    def _unpack(cls, data: bytes, depth: int) -> Self:
        if data[0] != 0x04 or data[1] != 0x2B:
            raise rt.Reject
        at = 2
        size = len(data)
        (subsystem_list_count,) = _S_H.unpack_from(data, at)
        at += 2
        if subsystem_list_count < 1:
            raise rt.Reject
        if subsystem_list_count * 3 > size - at:
            raise rt.Reject
        subsystem_list_ = []
        for _ in range(subsystem_list_count):
            (subsystem_list_item_subsystem_rec_subsystem_id_,) = _S_H.unpack_from(data, at)
            at += 2
            subsystem_list_item_node_list_count = data[at]
            at += 1
            if subsystem_list_item_node_list_count < 1:
                raise rt.Reject
            if subsystem_list_item_node_list_count * 2 > size - at:
                raise rt.Reject
            subsystem_list_item_node_list_ = []
            for _ in range(subsystem_list_item_node_list_count):
                subsystem_list_item_node_list_item_node_rec_node_id_ = data[at]
                at += 1
                subsystem_list_item_node_list_item_component_list_count = data[at]
                at += 1
                if subsystem_list_item_node_list_item_component_list_count < 1:
                    raise rt.Reject
                if subsystem_list_item_node_list_item_component_list_count * 2 > size - at:
                    raise rt.Reject
                subsystem_list_item_node_list_item_component_list_ = []
                for _ in range(subsystem_list_item_node_list_item_component_list_count):
                    subsystem_list_item_node_list_item_component_list_item_, at = QueryServiceList.ComponentRec._read(data, at, depth)
                    subsystem_list_item_node_list_item_component_list_.append(subsystem_list_item_node_list_item_component_list_item_)
                subsystem_list_item_node_list_item_ = QueryServiceList.NodeSeq(core_v1_0_types.QueriedNodeRec(_E_QueriedNodeRec_NodeID.get(subsystem_list_item_node_list_item_node_rec_node_id_, subsystem_list_item_node_list_item_node_rec_node_id_)), subsystem_list_item_node_list_item_component_list_)
                subsystem_list_item_node_list_.append(subsystem_list_item_node_list_item_)
            subsystem_list_item_ = QueryServiceList.SubsystemSeq(QueryServiceList.SubsystemRec(_E_QueryServiceList_SubsystemID.get(subsystem_list_item_subsystem_rec_subsystem_id_, subsystem_list_item_subsystem_rec_subsystem_id_)), subsystem_list_item_node_list_)
            subsystem_list_.append(subsystem_list_item_)
        if at != len(data):
            raise rt.Reject
        return cls(subsystem_list_)

    def _pack(self) -> bytes:
        out = bytearray(b"\x04\x2b")
        subsystem_list_ = self.subsystem_list
        if type(subsystem_list_) is not list:
            raise rt.Reject
        if len(subsystem_list_) < 1:
            raise rt.Reject
        out += _S_H.pack(len(subsystem_list_))
        for subsystem_list_item_ in subsystem_list_:
            if type(subsystem_list_item_) is not QueryServiceList.SubsystemSeq:
                raise rt.Reject
            subsystem_list_item_subsystem_rec_ = subsystem_list_item_.subsystem_rec
            if type(subsystem_list_item_subsystem_rec_) is not QueryServiceList.SubsystemRec:
                raise rt.Reject
            subsystem_list_item_subsystem_rec_subsystem_id_ = subsystem_list_item_subsystem_rec_.subsystem_id
            out += _S_H.pack(subsystem_list_item_subsystem_rec_subsystem_id_)
            subsystem_list_item_node_list_ = subsystem_list_item_.node_list
            if type(subsystem_list_item_node_list_) is not list:
                raise rt.Reject
            if len(subsystem_list_item_node_list_) < 1:
                raise rt.Reject
            out.append(len(subsystem_list_item_node_list_))
            for subsystem_list_item_node_list_item_ in subsystem_list_item_node_list_:
                if type(subsystem_list_item_node_list_item_) is not QueryServiceList.NodeSeq:
                    raise rt.Reject
                subsystem_list_item_node_list_item_node_rec_ = subsystem_list_item_node_list_item_.node_rec
                if type(subsystem_list_item_node_list_item_node_rec_) is not core_v1_0_types.QueriedNodeRec:
                    raise rt.Reject
                subsystem_list_item_node_list_item_node_rec_node_id_ = subsystem_list_item_node_list_item_node_rec_.node_id
                out += _S_B.pack(subsystem_list_item_node_list_item_node_rec_node_id_)
                subsystem_list_item_node_list_item_component_list_ = subsystem_list_item_node_list_item_.component_list
                if type(subsystem_list_item_node_list_item_component_list_) is not list:
                    raise rt.Reject
                if len(subsystem_list_item_node_list_item_component_list_) < 1:
                    raise rt.Reject
                out.append(len(subsystem_list_item_node_list_item_component_list_))
                for subsystem_list_item_node_list_item_component_list_item_ in subsystem_list_item_node_list_item_component_list_:
                    if type(subsystem_list_item_node_list_item_component_list_item_) is not QueryServiceList.ComponentRec:
                        raise rt.Reject
                    subsystem_list_item_node_list_item_component_list_item_._write(out)
        return bytes(out)


@dataclass(slots=True, repr=False)
class RegisterServices(rt.Message):
    """RegisterServices (0x0B00): Tells the Discovery service of the node which services a component offers.

    service_list: 0..255 items. The services
    """

    CODE: ClassVar[int] = 0x0B00
    NAME: ClassVar[str] = "RegisterServices"
    SERVICE: ClassVar[str] = "urn:jaus:jss:core:Discovery"
    VERSION: ClassVar[str] = "1.1"
    IS_COMMAND: ClassVar[bool] = True

    ServiceRec = core_v1_0_types.ServiceRec

    service_list: list[core_v1_0_types.ServiceRec]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(
            cls,
            (
                rt.Slot("service_list", "ServiceList", rt.Repeat(rt.Count("B", 0, 255), core_v1_0_types.ServiceRec.layout())),
            ),
        )

    @classmethod
    def _unpack(cls, data: bytes, depth: int) -> Self:
        if data[0] != 0x00 or data[1] != 0x0B:
            raise rt.Reject
        at = 2
        size = len(data)
        service_list_count = data[at]
        at += 1
        if service_list_count * 3 > size - at:
            raise rt.Reject
        service_list_ = []
        for _ in range(service_list_count):
            service_list_item_uri_end = data[at]
            at += 1
            service_list_item_uri_end += at
            if service_list_item_uri_end > size:
                raise rt.Reject
            service_list_item_uri_ = data[at:service_list_item_uri_end].decode("latin-1")
            at = service_list_item_uri_end
            service_list_item_major_version_number_, service_list_item_minor_version_number_ = _S_2B.unpack_from(data, at)
            at += 2
            service_list_item_ = core_v1_0_types.ServiceRec(service_list_item_uri_, service_list_item_major_version_number_, service_list_item_minor_version_number_)
            service_list_.append(service_list_item_)
        if at != len(data):
            raise rt.Reject
        return cls(service_list_)

    def _pack(self) -> bytes:
        out = bytearray(b"\x00\x0b")
        service_list_ = self.service_list
        if type(service_list_) is not list:
            raise rt.Reject
        out.append(len(service_list_))
        for service_list_item_ in service_list_:
            if type(service_list_item_) is not core_v1_0_types.ServiceRec:
                raise rt.Reject
            service_list_item_uri_ = service_list_item_.uri
            service_list_item_uri_raw = service_list_item_uri_.encode("latin-1")
            out.append(len(service_list_item_uri_raw))
            out += service_list_item_uri_raw
            service_list_item_major_version_number_ = service_list_item_.major_version_number
            service_list_item_minor_version_number_ = service_list_item_.minor_version_number
            out += _S_2B.pack(service_list_item_major_version_number_, service_list_item_minor_version_number_)
        return bytes(out)


@dataclass(slots=True, repr=False)
class ReportIdentification(rt.Message):
    """ReportIdentification (0x4B00): Tells the name and kind of a system, subsystem, node or component.

    query_type: QueryType or 5..255. Whose identification is meant
    type: Type or 10002..20000 or 20002..30000 or 30002..40000 or 40002..50000 or 50002..60000 or 60002..65535. The kind of subsystem, node or component; ranges are left for subdivisions
    identification: up to 255 characters. The name, for people
    """

    CODE: ClassVar[int] = 0x4B00
    NAME: ClassVar[str] = "ReportIdentification"
    SERVICE: ClassVar[str] = "urn:jaus:jss:core:Discovery"
    VERSION: ClassVar[str] = "1.1"
    IS_COMMAND: ClassVar[bool] = False

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
        return rt.Composite(
            cls,
            (
                rt.Slot("query_type", "QueryType", rt.Number("B", rt.Values(ReportIdentification.QueryType, ((5, 255),)))),
                rt.Slot("type", "Type", rt.Number("H", rt.Values(ReportIdentification.Type, ((10002, 20000), (20002, 30000), (30002, 40000), (40002, 50000), (50002, 60000), (60002, 65535))))),
                rt.Slot("identification", "Identification", rt.Text(count=rt.Count("B", 0, 255))),
            ),
        )

    @classmethod
    def _unpack(cls, data: bytes, depth: int) -> Self:
        if data[0] != 0x00 or data[1] != 0x4B:
            raise rt.Reject
        at = 2
        size = len(data)
        query_type_, type_ = _S_BH.unpack_from(data, at)
        at += 3
        if type_ not in _E_ReportIdentification_Type and not 10002 <= type_ <= 20000 and not 20002 <= type_ <= 30000 and not 30002 <= type_ <= 40000 and not 40002 <= type_ <= 50000 and not 50002 <= type_ <= 60000 and type_ < 60002:
            raise rt.Reject
        query_type_ = _E_ReportIdentification_QueryType.get(query_type_, query_type_)
        type_ = _E_ReportIdentification_Type.get(type_, type_)
        identification_end = data[at]
        at += 1
        identification_end += at
        if identification_end > size:
            raise rt.Reject
        identification_ = data[at:identification_end].decode("latin-1")
        at = identification_end
        if at != len(data):
            raise rt.Reject
        return cls(query_type_, type_, identification_)

    def _pack(self) -> bytes:
        out = bytearray(b"\x00\x4b")
        query_type_ = self.query_type
        type_ = self.type
        if type_ not in _E_ReportIdentification_Type and not 10002 <= type_ <= 20000 and not 20002 <= type_ <= 30000 and not 30002 <= type_ <= 40000 and not 40002 <= type_ <= 50000 and not 50002 <= type_ <= 60000 and not 60002 <= type_ <= 65535:
            raise rt.Reject
        out += _S_BH.pack(query_type_, type_)
        identification_ = self.identification
        identification_raw = identification_.encode("latin-1")
        out.append(len(identification_raw))
        out += identification_raw
        return bytes(out)


@dataclass(slots=True, repr=False)
class ReportConfiguration(rt.Message):
    """ReportConfiguration (0x4B01): Lists nodes and their components.

    node_list: 0..255 items. The nodes
    """

    CODE: ClassVar[int] = 0x4B01
    NAME: ClassVar[str] = "ReportConfiguration"
    SERVICE: ClassVar[str] = "urn:jaus:jss:core:Discovery"
    VERSION: ClassVar[str] = "1.1"
    IS_COMMAND: ClassVar[bool] = False

    ComponentRec = core_v1_0_types.ComponentRec

    @dataclass(slots=True, repr=False)
    class NodeRec(rt.Struct):
        """One node.

        node_id: Node number
        """

        node_id: int

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(
                cls,
                (
                    rt.Slot("node_id", "NodeID", rt.Number("B")),
                ),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, depth: int) -> tuple[Self, int]:
            node_id_ = data[at]
            at += 1
            return cls(node_id_), at

        def _write(self, out: bytearray) -> None:
            node_id_ = self.node_id
            out += _S_B.pack(node_id_)

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
            return rt.Composite(
                cls,
                (
                    rt.Slot("node_rec", "NodeRec", ReportConfiguration.NodeRec.layout()),
                    rt.Slot("component_list", "ComponentList", rt.Repeat(rt.Count("B", 0, 255), core_v1_0_types.ComponentRec.layout())),
                ),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, depth: int) -> tuple[Self, int]:
            size = len(data)
            node_rec_node_id_ = data[at]
            at += 1
            node_rec_ = ReportConfiguration.NodeRec(node_rec_node_id_)
            component_list_count = data[at]
            at += 1
            component_list_end = at + component_list_count * 2
            if component_list_end > size:
                raise rt.Reject
            component_list_ = [core_v1_0_types.ComponentRec(component_list_item_component_id_, component_list_item_instance_id_) for component_list_item_component_id_, component_list_item_instance_id_ in _S_2B.iter_unpack(data[at:component_list_end])]
            at = component_list_end
            return cls(node_rec_, component_list_), at

        def _write(self, out: bytearray) -> None:
            node_rec_ = self.node_rec
            if type(node_rec_) is not ReportConfiguration.NodeRec:
                raise rt.Reject
            node_rec_node_id_ = node_rec_.node_id
            out += _S_B.pack(node_rec_node_id_)
            component_list_ = self.component_list
            if type(component_list_) is not list:
                raise rt.Reject
            out.append(len(component_list_))
            for component_list_item_ in component_list_:
                if type(component_list_item_) is not core_v1_0_types.ComponentRec:
                    raise rt.Reject
                component_list_item_component_id_ = component_list_item_.component_id
                component_list_item_instance_id_ = component_list_item_.instance_id
                out += _S_2B.pack(component_list_item_component_id_, component_list_item_instance_id_)

    node_list: list[ReportConfiguration.NodeSeq]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(
            cls,
            (
                rt.Slot("node_list", "NodeList", rt.Repeat(rt.Count("B", 0, 255), ReportConfiguration.NodeSeq.layout())),
            ),
        )

    @classmethod
    def _unpack(cls, data: bytes, depth: int) -> Self:
        if data[0] != 0x01 or data[1] != 0x4B:
            raise rt.Reject
        at = 2
        size = len(data)
        node_list_count = data[at]
        at += 1
        if node_list_count * 2 > size - at:
            raise rt.Reject
        node_list_ = []
        for _ in range(node_list_count):
            node_list_item_node_rec_node_id_ = data[at]
            at += 1
            node_list_item_component_list_count = data[at]
            at += 1
            node_list_item_component_list_end = at + node_list_item_component_list_count * 2
            if node_list_item_component_list_end > size:
                raise rt.Reject
            node_list_item_component_list_ = [core_v1_0_types.ComponentRec(node_list_item_component_list_item_component_id_, node_list_item_component_list_item_instance_id_) for node_list_item_component_list_item_component_id_, node_list_item_component_list_item_instance_id_ in _S_2B.iter_unpack(data[at:node_list_item_component_list_end])]
            at = node_list_item_component_list_end
            node_list_item_ = ReportConfiguration.NodeSeq(ReportConfiguration.NodeRec(node_list_item_node_rec_node_id_), node_list_item_component_list_)
            node_list_.append(node_list_item_)
        if at != len(data):
            raise rt.Reject
        return cls(node_list_)

    def _pack(self) -> bytes:
        out = bytearray(b"\x01\x4b")
        node_list_ = self.node_list
        if type(node_list_) is not list:
            raise rt.Reject
        out.append(len(node_list_))
        for node_list_item_ in node_list_:
            if type(node_list_item_) is not ReportConfiguration.NodeSeq:
                raise rt.Reject
            node_list_item_node_rec_ = node_list_item_.node_rec
            if type(node_list_item_node_rec_) is not ReportConfiguration.NodeRec:
                raise rt.Reject
            node_list_item_node_rec_node_id_ = node_list_item_node_rec_.node_id
            out += _S_B.pack(node_list_item_node_rec_node_id_)
            node_list_item_component_list_ = node_list_item_.component_list
            if type(node_list_item_component_list_) is not list:
                raise rt.Reject
            out.append(len(node_list_item_component_list_))
            for node_list_item_component_list_item_ in node_list_item_component_list_:
                if type(node_list_item_component_list_item_) is not core_v1_0_types.ComponentRec:
                    raise rt.Reject
                node_list_item_component_list_item_component_id_ = node_list_item_component_list_item_.component_id
                node_list_item_component_list_item_instance_id_ = node_list_item_component_list_item_.instance_id
                out += _S_2B.pack(node_list_item_component_list_item_component_id_, node_list_item_component_list_item_instance_id_)
        return bytes(out)


@dataclass(slots=True, repr=False)
class ReportSubsystemList(rt.Message):
    """ReportSubsystemList (0x4B02): Lists subsystems, each with the component that answers for it.

    subsystem_list: 0..255 items. The subsystems
    """

    CODE: ClassVar[int] = 0x4B02
    NAME: ClassVar[str] = "ReportSubsystemList"
    SERVICE: ClassVar[str] = "urn:jaus:jss:core:Discovery"
    VERSION: ClassVar[str] = "1.1"
    IS_COMMAND: ClassVar[bool] = False

    SubsystemRec = core_v1_0_types.SubsystemRec

    subsystem_list: list[core_v1_0_types.SubsystemRec]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(
            cls,
            (
                rt.Slot("subsystem_list", "SubsystemList", rt.Repeat(rt.Count("B", 0, 255), core_v1_0_types.SubsystemRec.layout())),
            ),
        )

    @classmethod
    def _unpack(cls, data: bytes, depth: int) -> Self:
        if data[0] != 0x02 or data[1] != 0x4B:
            raise rt.Reject
        at = 2
        size = len(data)
        subsystem_list_count = data[at]
        at += 1
        subsystem_list_end = at + subsystem_list_count * 4
        if subsystem_list_end > size:
            raise rt.Reject
        subsystem_list_ = [core_v1_0_types.SubsystemRec(subsystem_list_item_subsystem_id_, subsystem_list_item_node_id_, subsystem_list_item_component_id_) for subsystem_list_item_subsystem_id_, subsystem_list_item_node_id_, subsystem_list_item_component_id_ in _S_H2B.iter_unpack(data[at:subsystem_list_end])]
        at = subsystem_list_end
        if at != len(data):
            raise rt.Reject
        return cls(subsystem_list_)

    def _pack(self) -> bytes:
        out = bytearray(b"\x02\x4b")
        subsystem_list_ = self.subsystem_list
        if type(subsystem_list_) is not list:
            raise rt.Reject
        out.append(len(subsystem_list_))
        for subsystem_list_item_ in subsystem_list_:
            if type(subsystem_list_item_) is not core_v1_0_types.SubsystemRec:
                raise rt.Reject
            subsystem_list_item_subsystem_id_ = subsystem_list_item_.subsystem_id
            subsystem_list_item_node_id_ = subsystem_list_item_.node_id
            subsystem_list_item_component_id_ = subsystem_list_item_.component_id
            out += _S_H2B.pack(subsystem_list_item_subsystem_id_, subsystem_list_item_node_id_, subsystem_list_item_component_id_)
        return bytes(out)


@dataclass(slots=True, repr=False)
class ReportServices(rt.Message):
    """ReportServices (0x4B03): Lists services by node and component.

    node_list: 0..255 items. The nodes
    """

    CODE: ClassVar[int] = 0x4B03
    NAME: ClassVar[str] = "ReportServices"
    SERVICE: ClassVar[str] = "urn:jaus:jss:core:Discovery"
    VERSION: ClassVar[str] = "1.1"
    IS_COMMAND: ClassVar[bool] = False

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
            return rt.Composite(
                cls,
                (
                    rt.Slot("node_id", "NodeID", rt.Number("B")),
                ),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, depth: int) -> tuple[Self, int]:
            node_id_ = data[at]
            at += 1
            return cls(node_id_), at

        def _write(self, out: bytearray) -> None:
            node_id_ = self.node_id
            out += _S_B.pack(node_id_)

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
            return rt.Composite(
                cls,
                (
                    rt.Slot("component_rec", "ComponentRec", core_v1_0_types.ComponentRec.layout()),
                    rt.Slot("service_list", "ServiceList", rt.Repeat(rt.Count("B", 0, 255), core_v1_0_types.ServiceRec.layout())),
                ),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, depth: int) -> tuple[Self, int]:
            size = len(data)
            component_rec_component_id_, component_rec_instance_id_ = _S_2B.unpack_from(data, at)
            at += 2
            component_rec_ = core_v1_0_types.ComponentRec(component_rec_component_id_, component_rec_instance_id_)
            service_list_count = data[at]
            at += 1
            if service_list_count * 3 > size - at:
                raise rt.Reject
            service_list_ = []
            for _ in range(service_list_count):
                service_list_item_uri_end = data[at]
                at += 1
                service_list_item_uri_end += at
                if service_list_item_uri_end > size:
                    raise rt.Reject
                service_list_item_uri_ = data[at:service_list_item_uri_end].decode("latin-1")
                at = service_list_item_uri_end
                service_list_item_major_version_number_, service_list_item_minor_version_number_ = _S_2B.unpack_from(data, at)
                at += 2
                service_list_item_ = core_v1_0_types.ServiceRec(service_list_item_uri_, service_list_item_major_version_number_, service_list_item_minor_version_number_)
                service_list_.append(service_list_item_)
            return cls(component_rec_, service_list_), at

        def _write(self, out: bytearray) -> None:
            component_rec_ = self.component_rec
            if type(component_rec_) is not core_v1_0_types.ComponentRec:
                raise rt.Reject
            component_rec_component_id_ = component_rec_.component_id
            component_rec_instance_id_ = component_rec_.instance_id
            out += _S_2B.pack(component_rec_component_id_, component_rec_instance_id_)
            service_list_ = self.service_list
            if type(service_list_) is not list:
                raise rt.Reject
            out.append(len(service_list_))
            for service_list_item_ in service_list_:
                if type(service_list_item_) is not core_v1_0_types.ServiceRec:
                    raise rt.Reject
                service_list_item_uri_ = service_list_item_.uri
                service_list_item_uri_raw = service_list_item_uri_.encode("latin-1")
                out.append(len(service_list_item_uri_raw))
                out += service_list_item_uri_raw
                service_list_item_major_version_number_ = service_list_item_.major_version_number
                service_list_item_minor_version_number_ = service_list_item_.minor_version_number
                out += _S_2B.pack(service_list_item_major_version_number_, service_list_item_minor_version_number_)

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
            return rt.Composite(
                cls,
                (
                    rt.Slot("node_rec", "NodeRec", ReportServices.NodeRec.layout()),
                    rt.Slot("component_list", "ComponentList", rt.Repeat(rt.Count("B", 0, 255), ReportServices.ComponentSeq.layout())),
                ),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, depth: int) -> tuple[Self, int]:
            size = len(data)
            node_rec_node_id_ = data[at]
            at += 1
            node_rec_ = ReportServices.NodeRec(node_rec_node_id_)
            component_list_count = data[at]
            at += 1
            if component_list_count * 3 > size - at:
                raise rt.Reject
            component_list_ = []
            for _ in range(component_list_count):
                component_list_item_component_rec_component_id_, component_list_item_component_rec_instance_id_ = _S_2B.unpack_from(data, at)
                at += 2
                component_list_item_service_list_count = data[at]
                at += 1
                if component_list_item_service_list_count * 3 > size - at:
                    raise rt.Reject
                component_list_item_service_list_ = []
                for _ in range(component_list_item_service_list_count):
                    component_list_item_service_list_item_uri_end = data[at]
                    at += 1
                    component_list_item_service_list_item_uri_end += at
                    if component_list_item_service_list_item_uri_end > size:
                        raise rt.Reject
                    component_list_item_service_list_item_uri_ = data[at:component_list_item_service_list_item_uri_end].decode("latin-1")
                    at = component_list_item_service_list_item_uri_end
                    component_list_item_service_list_item_major_version_number_, component_list_item_service_list_item_minor_version_number_ = _S_2B.unpack_from(data, at)
                    at += 2
                    component_list_item_service_list_item_ = core_v1_0_types.ServiceRec(component_list_item_service_list_item_uri_, component_list_item_service_list_item_major_version_number_, component_list_item_service_list_item_minor_version_number_)
                    component_list_item_service_list_.append(component_list_item_service_list_item_)
                component_list_item_ = ReportServices.ComponentSeq(core_v1_0_types.ComponentRec(component_list_item_component_rec_component_id_, component_list_item_component_rec_instance_id_), component_list_item_service_list_)
                component_list_.append(component_list_item_)
            return cls(node_rec_, component_list_), at

        def _write(self, out: bytearray) -> None:
            node_rec_ = self.node_rec
            if type(node_rec_) is not ReportServices.NodeRec:
                raise rt.Reject
            node_rec_node_id_ = node_rec_.node_id
            out += _S_B.pack(node_rec_node_id_)
            component_list_ = self.component_list
            if type(component_list_) is not list:
                raise rt.Reject
            out.append(len(component_list_))
            for component_list_item_ in component_list_:
                if type(component_list_item_) is not ReportServices.ComponentSeq:
                    raise rt.Reject
                component_list_item_component_rec_ = component_list_item_.component_rec
                if type(component_list_item_component_rec_) is not core_v1_0_types.ComponentRec:
                    raise rt.Reject
                component_list_item_component_rec_component_id_ = component_list_item_component_rec_.component_id
                component_list_item_component_rec_instance_id_ = component_list_item_component_rec_.instance_id
                out += _S_2B.pack(component_list_item_component_rec_component_id_, component_list_item_component_rec_instance_id_)
                component_list_item_service_list_ = component_list_item_.service_list
                if type(component_list_item_service_list_) is not list:
                    raise rt.Reject
                out.append(len(component_list_item_service_list_))
                for component_list_item_service_list_item_ in component_list_item_service_list_:
                    if type(component_list_item_service_list_item_) is not core_v1_0_types.ServiceRec:
                        raise rt.Reject
                    component_list_item_service_list_item_uri_ = component_list_item_service_list_item_.uri
                    component_list_item_service_list_item_uri_raw = component_list_item_service_list_item_uri_.encode("latin-1")
                    out.append(len(component_list_item_service_list_item_uri_raw))
                    out += component_list_item_service_list_item_uri_raw
                    component_list_item_service_list_item_major_version_number_ = component_list_item_service_list_item_.major_version_number
                    component_list_item_service_list_item_minor_version_number_ = component_list_item_service_list_item_.minor_version_number
                    out += _S_2B.pack(component_list_item_service_list_item_major_version_number_, component_list_item_service_list_item_minor_version_number_)

    node_list: list[ReportServices.NodeSeq]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(
            cls,
            (
                rt.Slot("node_list", "NodeList", rt.Repeat(rt.Count("B", 0, 255), ReportServices.NodeSeq.layout())),
            ),
        )

    @classmethod
    def _unpack(cls, data: bytes, depth: int) -> Self:
        if data[0] != 0x03 or data[1] != 0x4B:
            raise rt.Reject
        at = 2
        size = len(data)
        node_list_count = data[at]
        at += 1
        if node_list_count * 2 > size - at:
            raise rt.Reject
        node_list_ = []
        for _ in range(node_list_count):
            node_list_item_node_rec_node_id_ = data[at]
            at += 1
            node_list_item_component_list_count = data[at]
            at += 1
            if node_list_item_component_list_count * 3 > size - at:
                raise rt.Reject
            node_list_item_component_list_ = []
            for _ in range(node_list_item_component_list_count):
                node_list_item_component_list_item_component_rec_component_id_, node_list_item_component_list_item_component_rec_instance_id_ = _S_2B.unpack_from(data, at)
                at += 2
                node_list_item_component_list_item_service_list_count = data[at]
                at += 1
                if node_list_item_component_list_item_service_list_count * 3 > size - at:
                    raise rt.Reject
                node_list_item_component_list_item_service_list_ = []
                for _ in range(node_list_item_component_list_item_service_list_count):
                    node_list_item_component_list_item_service_list_item_uri_end = data[at]
                    at += 1
                    node_list_item_component_list_item_service_list_item_uri_end += at
                    if node_list_item_component_list_item_service_list_item_uri_end > size:
                        raise rt.Reject
                    node_list_item_component_list_item_service_list_item_uri_ = data[at:node_list_item_component_list_item_service_list_item_uri_end].decode("latin-1")
                    at = node_list_item_component_list_item_service_list_item_uri_end
                    node_list_item_component_list_item_service_list_item_major_version_number_, node_list_item_component_list_item_service_list_item_minor_version_number_ = _S_2B.unpack_from(data, at)
                    at += 2
                    node_list_item_component_list_item_service_list_item_ = core_v1_0_types.ServiceRec(node_list_item_component_list_item_service_list_item_uri_, node_list_item_component_list_item_service_list_item_major_version_number_, node_list_item_component_list_item_service_list_item_minor_version_number_)
                    node_list_item_component_list_item_service_list_.append(node_list_item_component_list_item_service_list_item_)
                node_list_item_component_list_item_ = ReportServices.ComponentSeq(core_v1_0_types.ComponentRec(node_list_item_component_list_item_component_rec_component_id_, node_list_item_component_list_item_component_rec_instance_id_), node_list_item_component_list_item_service_list_)
                node_list_item_component_list_.append(node_list_item_component_list_item_)
            node_list_item_ = ReportServices.NodeSeq(ReportServices.NodeRec(node_list_item_node_rec_node_id_), node_list_item_component_list_)
            node_list_.append(node_list_item_)
        if at != len(data):
            raise rt.Reject
        return cls(node_list_)

    def _pack(self) -> bytes:
        out = bytearray(b"\x03\x4b")
        node_list_ = self.node_list
        if type(node_list_) is not list:
            raise rt.Reject
        out.append(len(node_list_))
        for node_list_item_ in node_list_:
            if type(node_list_item_) is not ReportServices.NodeSeq:
                raise rt.Reject
            node_list_item_node_rec_ = node_list_item_.node_rec
            if type(node_list_item_node_rec_) is not ReportServices.NodeRec:
                raise rt.Reject
            node_list_item_node_rec_node_id_ = node_list_item_node_rec_.node_id
            out += _S_B.pack(node_list_item_node_rec_node_id_)
            node_list_item_component_list_ = node_list_item_.component_list
            if type(node_list_item_component_list_) is not list:
                raise rt.Reject
            out.append(len(node_list_item_component_list_))
            for node_list_item_component_list_item_ in node_list_item_component_list_:
                if type(node_list_item_component_list_item_) is not ReportServices.ComponentSeq:
                    raise rt.Reject
                node_list_item_component_list_item_component_rec_ = node_list_item_component_list_item_.component_rec
                if type(node_list_item_component_list_item_component_rec_) is not core_v1_0_types.ComponentRec:
                    raise rt.Reject
                node_list_item_component_list_item_component_rec_component_id_ = node_list_item_component_list_item_component_rec_.component_id
                node_list_item_component_list_item_component_rec_instance_id_ = node_list_item_component_list_item_component_rec_.instance_id
                out += _S_2B.pack(node_list_item_component_list_item_component_rec_component_id_, node_list_item_component_list_item_component_rec_instance_id_)
                node_list_item_component_list_item_service_list_ = node_list_item_component_list_item_.service_list
                if type(node_list_item_component_list_item_service_list_) is not list:
                    raise rt.Reject
                out.append(len(node_list_item_component_list_item_service_list_))
                for node_list_item_component_list_item_service_list_item_ in node_list_item_component_list_item_service_list_:
                    if type(node_list_item_component_list_item_service_list_item_) is not core_v1_0_types.ServiceRec:
                        raise rt.Reject
                    node_list_item_component_list_item_service_list_item_uri_ = node_list_item_component_list_item_service_list_item_.uri
                    node_list_item_component_list_item_service_list_item_uri_raw = node_list_item_component_list_item_service_list_item_uri_.encode("latin-1")
                    out.append(len(node_list_item_component_list_item_service_list_item_uri_raw))
                    out += node_list_item_component_list_item_service_list_item_uri_raw
                    node_list_item_component_list_item_service_list_item_major_version_number_ = node_list_item_component_list_item_service_list_item_.major_version_number
                    node_list_item_component_list_item_service_list_item_minor_version_number_ = node_list_item_component_list_item_service_list_item_.minor_version_number
                    out += _S_2B.pack(node_list_item_component_list_item_service_list_item_major_version_number_, node_list_item_component_list_item_service_list_item_minor_version_number_)
        return bytes(out)


@dataclass(slots=True, repr=False)
class ReportServiceList(rt.Message):
    """ReportServiceList (0x4B04): Lists services by subsystem, node and component.

    subsystem_list: 0..65535 items. The subsystems
    """

    CODE: ClassVar[int] = 0x4B04
    NAME: ClassVar[str] = "ReportServiceList"
    SERVICE: ClassVar[str] = "urn:jaus:jss:core:Discovery"
    VERSION: ClassVar[str] = "1.1"
    IS_COMMAND: ClassVar[bool] = False

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
            return rt.Composite(
                cls,
                (
                    rt.Slot("subsystem_id", "SubsystemID", rt.Number("H")),
                ),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, depth: int) -> tuple[Self, int]:
            (subsystem_id_,) = _S_H.unpack_from(data, at)
            at += 2
            return cls(subsystem_id_), at

        def _write(self, out: bytearray) -> None:
            subsystem_id_ = self.subsystem_id
            out += _S_H.pack(subsystem_id_)

    @dataclass(slots=True, repr=False)
    class NodeRec(rt.Struct):
        """One node.

        node_id: Node number
        """

        node_id: int

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(
                cls,
                (
                    rt.Slot("node_id", "NodeID", rt.Number("B")),
                ),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, depth: int) -> tuple[Self, int]:
            node_id_ = data[at]
            at += 1
            return cls(node_id_), at

        def _write(self, out: bytearray) -> None:
            node_id_ = self.node_id
            out += _S_B.pack(node_id_)

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
            return rt.Composite(
                cls,
                (
                    rt.Slot("component_rec", "ComponentRec", core_v1_0_types.ComponentRec.layout()),
                    rt.Slot("service_list", "ServiceList", rt.Repeat(rt.Count("B", 0, 255), core_v1_0_types.ServiceRec.layout())),
                ),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, depth: int) -> tuple[Self, int]:
            size = len(data)
            component_rec_component_id_, component_rec_instance_id_ = _S_2B.unpack_from(data, at)
            at += 2
            component_rec_ = core_v1_0_types.ComponentRec(component_rec_component_id_, component_rec_instance_id_)
            service_list_count = data[at]
            at += 1
            if service_list_count * 3 > size - at:
                raise rt.Reject
            service_list_ = []
            for _ in range(service_list_count):
                service_list_item_uri_end = data[at]
                at += 1
                service_list_item_uri_end += at
                if service_list_item_uri_end > size:
                    raise rt.Reject
                service_list_item_uri_ = data[at:service_list_item_uri_end].decode("latin-1")
                at = service_list_item_uri_end
                service_list_item_major_version_number_, service_list_item_minor_version_number_ = _S_2B.unpack_from(data, at)
                at += 2
                service_list_item_ = core_v1_0_types.ServiceRec(service_list_item_uri_, service_list_item_major_version_number_, service_list_item_minor_version_number_)
                service_list_.append(service_list_item_)
            return cls(component_rec_, service_list_), at

        def _write(self, out: bytearray) -> None:
            component_rec_ = self.component_rec
            if type(component_rec_) is not core_v1_0_types.ComponentRec:
                raise rt.Reject
            component_rec_component_id_ = component_rec_.component_id
            component_rec_instance_id_ = component_rec_.instance_id
            out += _S_2B.pack(component_rec_component_id_, component_rec_instance_id_)
            service_list_ = self.service_list
            if type(service_list_) is not list:
                raise rt.Reject
            out.append(len(service_list_))
            for service_list_item_ in service_list_:
                if type(service_list_item_) is not core_v1_0_types.ServiceRec:
                    raise rt.Reject
                service_list_item_uri_ = service_list_item_.uri
                service_list_item_uri_raw = service_list_item_uri_.encode("latin-1")
                out.append(len(service_list_item_uri_raw))
                out += service_list_item_uri_raw
                service_list_item_major_version_number_ = service_list_item_.major_version_number
                service_list_item_minor_version_number_ = service_list_item_.minor_version_number
                out += _S_2B.pack(service_list_item_major_version_number_, service_list_item_minor_version_number_)

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
            return rt.Composite(
                cls,
                (
                    rt.Slot("node_rec", "NodeRec", ReportServiceList.NodeRec.layout()),
                    rt.Slot("component_list", "ComponentList", rt.Repeat(rt.Count("B", 0, 255), ReportServiceList.ComponentSeq.layout())),
                ),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, depth: int) -> tuple[Self, int]:
            size = len(data)
            node_rec_node_id_ = data[at]
            at += 1
            node_rec_ = ReportServiceList.NodeRec(node_rec_node_id_)
            component_list_count = data[at]
            at += 1
            if component_list_count * 3 > size - at:
                raise rt.Reject
            component_list_ = []
            for _ in range(component_list_count):
                component_list_item_component_rec_component_id_, component_list_item_component_rec_instance_id_ = _S_2B.unpack_from(data, at)
                at += 2
                component_list_item_service_list_count = data[at]
                at += 1
                if component_list_item_service_list_count * 3 > size - at:
                    raise rt.Reject
                component_list_item_service_list_ = []
                for _ in range(component_list_item_service_list_count):
                    component_list_item_service_list_item_uri_end = data[at]
                    at += 1
                    component_list_item_service_list_item_uri_end += at
                    if component_list_item_service_list_item_uri_end > size:
                        raise rt.Reject
                    component_list_item_service_list_item_uri_ = data[at:component_list_item_service_list_item_uri_end].decode("latin-1")
                    at = component_list_item_service_list_item_uri_end
                    component_list_item_service_list_item_major_version_number_, component_list_item_service_list_item_minor_version_number_ = _S_2B.unpack_from(data, at)
                    at += 2
                    component_list_item_service_list_item_ = core_v1_0_types.ServiceRec(component_list_item_service_list_item_uri_, component_list_item_service_list_item_major_version_number_, component_list_item_service_list_item_minor_version_number_)
                    component_list_item_service_list_.append(component_list_item_service_list_item_)
                component_list_item_ = ReportServiceList.ComponentSeq(core_v1_0_types.ComponentRec(component_list_item_component_rec_component_id_, component_list_item_component_rec_instance_id_), component_list_item_service_list_)
                component_list_.append(component_list_item_)
            return cls(node_rec_, component_list_), at

        def _write(self, out: bytearray) -> None:
            node_rec_ = self.node_rec
            if type(node_rec_) is not ReportServiceList.NodeRec:
                raise rt.Reject
            node_rec_node_id_ = node_rec_.node_id
            out += _S_B.pack(node_rec_node_id_)
            component_list_ = self.component_list
            if type(component_list_) is not list:
                raise rt.Reject
            out.append(len(component_list_))
            for component_list_item_ in component_list_:
                if type(component_list_item_) is not ReportServiceList.ComponentSeq:
                    raise rt.Reject
                component_list_item_component_rec_ = component_list_item_.component_rec
                if type(component_list_item_component_rec_) is not core_v1_0_types.ComponentRec:
                    raise rt.Reject
                component_list_item_component_rec_component_id_ = component_list_item_component_rec_.component_id
                component_list_item_component_rec_instance_id_ = component_list_item_component_rec_.instance_id
                out += _S_2B.pack(component_list_item_component_rec_component_id_, component_list_item_component_rec_instance_id_)
                component_list_item_service_list_ = component_list_item_.service_list
                if type(component_list_item_service_list_) is not list:
                    raise rt.Reject
                out.append(len(component_list_item_service_list_))
                for component_list_item_service_list_item_ in component_list_item_service_list_:
                    if type(component_list_item_service_list_item_) is not core_v1_0_types.ServiceRec:
                        raise rt.Reject
                    component_list_item_service_list_item_uri_ = component_list_item_service_list_item_.uri
                    component_list_item_service_list_item_uri_raw = component_list_item_service_list_item_uri_.encode("latin-1")
                    out.append(len(component_list_item_service_list_item_uri_raw))
                    out += component_list_item_service_list_item_uri_raw
                    component_list_item_service_list_item_major_version_number_ = component_list_item_service_list_item_.major_version_number
                    component_list_item_service_list_item_minor_version_number_ = component_list_item_service_list_item_.minor_version_number
                    out += _S_2B.pack(component_list_item_service_list_item_major_version_number_, component_list_item_service_list_item_minor_version_number_)

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
            return rt.Composite(
                cls,
                (
                    rt.Slot("subsystem_rec", "SubsystemRec", ReportServiceList.SubsystemRec.layout()),
                    rt.Slot("node_list", "NodeList", rt.Repeat(rt.Count("B", 0, 255), ReportServiceList.NodeSeq.layout())),
                ),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, depth: int) -> tuple[Self, int]:
            size = len(data)
            (subsystem_rec_subsystem_id_,) = _S_H.unpack_from(data, at)
            at += 2
            subsystem_rec_ = ReportServiceList.SubsystemRec(subsystem_rec_subsystem_id_)
            node_list_count = data[at]
            at += 1
            if node_list_count * 2 > size - at:
                raise rt.Reject
            node_list_ = []
            for _ in range(node_list_count):
                node_list_item_node_rec_node_id_ = data[at]
                at += 1
                node_list_item_component_list_count = data[at]
                at += 1
                if node_list_item_component_list_count * 3 > size - at:
                    raise rt.Reject
                node_list_item_component_list_ = []
                for _ in range(node_list_item_component_list_count):
                    node_list_item_component_list_item_component_rec_component_id_, node_list_item_component_list_item_component_rec_instance_id_ = _S_2B.unpack_from(data, at)
                    at += 2
                    node_list_item_component_list_item_service_list_count = data[at]
                    at += 1
                    if node_list_item_component_list_item_service_list_count * 3 > size - at:
                        raise rt.Reject
                    node_list_item_component_list_item_service_list_ = []
                    for _ in range(node_list_item_component_list_item_service_list_count):
                        node_list_item_component_list_item_service_list_item_uri_end = data[at]
                        at += 1
                        node_list_item_component_list_item_service_list_item_uri_end += at
                        if node_list_item_component_list_item_service_list_item_uri_end > size:
                            raise rt.Reject
                        node_list_item_component_list_item_service_list_item_uri_ = data[at:node_list_item_component_list_item_service_list_item_uri_end].decode("latin-1")
                        at = node_list_item_component_list_item_service_list_item_uri_end
                        node_list_item_component_list_item_service_list_item_major_version_number_, node_list_item_component_list_item_service_list_item_minor_version_number_ = _S_2B.unpack_from(data, at)
                        at += 2
                        node_list_item_component_list_item_service_list_item_ = core_v1_0_types.ServiceRec(node_list_item_component_list_item_service_list_item_uri_, node_list_item_component_list_item_service_list_item_major_version_number_, node_list_item_component_list_item_service_list_item_minor_version_number_)
                        node_list_item_component_list_item_service_list_.append(node_list_item_component_list_item_service_list_item_)
                    node_list_item_component_list_item_ = ReportServiceList.ComponentSeq(core_v1_0_types.ComponentRec(node_list_item_component_list_item_component_rec_component_id_, node_list_item_component_list_item_component_rec_instance_id_), node_list_item_component_list_item_service_list_)
                    node_list_item_component_list_.append(node_list_item_component_list_item_)
                node_list_item_ = ReportServiceList.NodeSeq(ReportServiceList.NodeRec(node_list_item_node_rec_node_id_), node_list_item_component_list_)
                node_list_.append(node_list_item_)
            return cls(subsystem_rec_, node_list_), at

        def _write(self, out: bytearray) -> None:
            subsystem_rec_ = self.subsystem_rec
            if type(subsystem_rec_) is not ReportServiceList.SubsystemRec:
                raise rt.Reject
            subsystem_rec_subsystem_id_ = subsystem_rec_.subsystem_id
            out += _S_H.pack(subsystem_rec_subsystem_id_)
            node_list_ = self.node_list
            if type(node_list_) is not list:
                raise rt.Reject
            out.append(len(node_list_))
            for node_list_item_ in node_list_:
                if type(node_list_item_) is not ReportServiceList.NodeSeq:
                    raise rt.Reject
                node_list_item_node_rec_ = node_list_item_.node_rec
                if type(node_list_item_node_rec_) is not ReportServiceList.NodeRec:
                    raise rt.Reject
                node_list_item_node_rec_node_id_ = node_list_item_node_rec_.node_id
                out += _S_B.pack(node_list_item_node_rec_node_id_)
                node_list_item_component_list_ = node_list_item_.component_list
                if type(node_list_item_component_list_) is not list:
                    raise rt.Reject
                out.append(len(node_list_item_component_list_))
                for node_list_item_component_list_item_ in node_list_item_component_list_:
                    if type(node_list_item_component_list_item_) is not ReportServiceList.ComponentSeq:
                        raise rt.Reject
                    node_list_item_component_list_item_component_rec_ = node_list_item_component_list_item_.component_rec
                    if type(node_list_item_component_list_item_component_rec_) is not core_v1_0_types.ComponentRec:
                        raise rt.Reject
                    node_list_item_component_list_item_component_rec_component_id_ = node_list_item_component_list_item_component_rec_.component_id
                    node_list_item_component_list_item_component_rec_instance_id_ = node_list_item_component_list_item_component_rec_.instance_id
                    out += _S_2B.pack(node_list_item_component_list_item_component_rec_component_id_, node_list_item_component_list_item_component_rec_instance_id_)
                    node_list_item_component_list_item_service_list_ = node_list_item_component_list_item_.service_list
                    if type(node_list_item_component_list_item_service_list_) is not list:
                        raise rt.Reject
                    out.append(len(node_list_item_component_list_item_service_list_))
                    for node_list_item_component_list_item_service_list_item_ in node_list_item_component_list_item_service_list_:
                        if type(node_list_item_component_list_item_service_list_item_) is not core_v1_0_types.ServiceRec:
                            raise rt.Reject
                        node_list_item_component_list_item_service_list_item_uri_ = node_list_item_component_list_item_service_list_item_.uri
                        node_list_item_component_list_item_service_list_item_uri_raw = node_list_item_component_list_item_service_list_item_uri_.encode("latin-1")
                        out.append(len(node_list_item_component_list_item_service_list_item_uri_raw))
                        out += node_list_item_component_list_item_service_list_item_uri_raw
                        node_list_item_component_list_item_service_list_item_major_version_number_ = node_list_item_component_list_item_service_list_item_.major_version_number
                        node_list_item_component_list_item_service_list_item_minor_version_number_ = node_list_item_component_list_item_service_list_item_.minor_version_number
                        out += _S_2B.pack(node_list_item_component_list_item_service_list_item_major_version_number_, node_list_item_component_list_item_service_list_item_minor_version_number_)

    subsystem_list: list[ReportServiceList.SubsystemSeq]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(
            cls,
            (
                rt.Slot("subsystem_list", "SubsystemList", rt.Repeat(rt.Count("H", 0, 65535), ReportServiceList.SubsystemSeq.layout())),
            ),
        )

    @classmethod
    def _unpack(cls, data: bytes, depth: int) -> Self:
        if data[0] != 0x04 or data[1] != 0x4B:
            raise rt.Reject
        at = 2
        size = len(data)
        (subsystem_list_count,) = _S_H.unpack_from(data, at)
        at += 2
        if subsystem_list_count * 3 > size - at:
            raise rt.Reject
        subsystem_list_ = []
        for _ in range(subsystem_list_count):
            (subsystem_list_item_subsystem_rec_subsystem_id_,) = _S_H.unpack_from(data, at)
            at += 2
            subsystem_list_item_node_list_count = data[at]
            at += 1
            if subsystem_list_item_node_list_count * 2 > size - at:
                raise rt.Reject
            subsystem_list_item_node_list_ = []
            for _ in range(subsystem_list_item_node_list_count):
                subsystem_list_item_node_list_item_node_rec_node_id_ = data[at]
                at += 1
                subsystem_list_item_node_list_item_component_list_count = data[at]
                at += 1
                if subsystem_list_item_node_list_item_component_list_count * 3 > size - at:
                    raise rt.Reject
                subsystem_list_item_node_list_item_component_list_ = []
                for _ in range(subsystem_list_item_node_list_item_component_list_count):
                    subsystem_list_item_node_list_item_component_list_item_component_rec_component_id_, subsystem_list_item_node_list_item_component_list_item_component_rec_instance_id_ = _S_2B.unpack_from(data, at)
                    at += 2
                    subsystem_list_item_node_list_item_component_list_item_service_list_count = data[at]
                    at += 1
                    if subsystem_list_item_node_list_item_component_list_item_service_list_count * 3 > size - at:
                        raise rt.Reject
                    subsystem_list_item_node_list_item_component_list_item_service_list_ = []
                    for _ in range(subsystem_list_item_node_list_item_component_list_item_service_list_count):
                        subsystem_list_item_node_list_item_component_list_item_service_list_item_uri_end = data[at]
                        at += 1
                        subsystem_list_item_node_list_item_component_list_item_service_list_item_uri_end += at
                        if subsystem_list_item_node_list_item_component_list_item_service_list_item_uri_end > size:
                            raise rt.Reject
                        subsystem_list_item_node_list_item_component_list_item_service_list_item_uri_ = data[at:subsystem_list_item_node_list_item_component_list_item_service_list_item_uri_end].decode("latin-1")
                        at = subsystem_list_item_node_list_item_component_list_item_service_list_item_uri_end
                        subsystem_list_item_node_list_item_component_list_item_service_list_item_major_version_number_, subsystem_list_item_node_list_item_component_list_item_service_list_item_minor_version_number_ = _S_2B.unpack_from(data, at)
                        at += 2
                        subsystem_list_item_node_list_item_component_list_item_service_list_item_ = core_v1_0_types.ServiceRec(subsystem_list_item_node_list_item_component_list_item_service_list_item_uri_, subsystem_list_item_node_list_item_component_list_item_service_list_item_major_version_number_, subsystem_list_item_node_list_item_component_list_item_service_list_item_minor_version_number_)
                        subsystem_list_item_node_list_item_component_list_item_service_list_.append(subsystem_list_item_node_list_item_component_list_item_service_list_item_)
                    subsystem_list_item_node_list_item_component_list_item_ = ReportServiceList.ComponentSeq(core_v1_0_types.ComponentRec(subsystem_list_item_node_list_item_component_list_item_component_rec_component_id_, subsystem_list_item_node_list_item_component_list_item_component_rec_instance_id_), subsystem_list_item_node_list_item_component_list_item_service_list_)
                    subsystem_list_item_node_list_item_component_list_.append(subsystem_list_item_node_list_item_component_list_item_)
                subsystem_list_item_node_list_item_ = ReportServiceList.NodeSeq(ReportServiceList.NodeRec(subsystem_list_item_node_list_item_node_rec_node_id_), subsystem_list_item_node_list_item_component_list_)
                subsystem_list_item_node_list_.append(subsystem_list_item_node_list_item_)
            subsystem_list_item_ = ReportServiceList.SubsystemSeq(ReportServiceList.SubsystemRec(subsystem_list_item_subsystem_rec_subsystem_id_), subsystem_list_item_node_list_)
            subsystem_list_.append(subsystem_list_item_)
        if at != len(data):
            raise rt.Reject
        return cls(subsystem_list_)

    def _pack(self) -> bytes:
        out = bytearray(b"\x04\x4b")
        subsystem_list_ = self.subsystem_list
        if type(subsystem_list_) is not list:
            raise rt.Reject
        out += _S_H.pack(len(subsystem_list_))
        for subsystem_list_item_ in subsystem_list_:
            if type(subsystem_list_item_) is not ReportServiceList.SubsystemSeq:
                raise rt.Reject
            subsystem_list_item_subsystem_rec_ = subsystem_list_item_.subsystem_rec
            if type(subsystem_list_item_subsystem_rec_) is not ReportServiceList.SubsystemRec:
                raise rt.Reject
            subsystem_list_item_subsystem_rec_subsystem_id_ = subsystem_list_item_subsystem_rec_.subsystem_id
            out += _S_H.pack(subsystem_list_item_subsystem_rec_subsystem_id_)
            subsystem_list_item_node_list_ = subsystem_list_item_.node_list
            if type(subsystem_list_item_node_list_) is not list:
                raise rt.Reject
            out.append(len(subsystem_list_item_node_list_))
            for subsystem_list_item_node_list_item_ in subsystem_list_item_node_list_:
                if type(subsystem_list_item_node_list_item_) is not ReportServiceList.NodeSeq:
                    raise rt.Reject
                subsystem_list_item_node_list_item_node_rec_ = subsystem_list_item_node_list_item_.node_rec
                if type(subsystem_list_item_node_list_item_node_rec_) is not ReportServiceList.NodeRec:
                    raise rt.Reject
                subsystem_list_item_node_list_item_node_rec_node_id_ = subsystem_list_item_node_list_item_node_rec_.node_id
                out += _S_B.pack(subsystem_list_item_node_list_item_node_rec_node_id_)
                subsystem_list_item_node_list_item_component_list_ = subsystem_list_item_node_list_item_.component_list
                if type(subsystem_list_item_node_list_item_component_list_) is not list:
                    raise rt.Reject
                out.append(len(subsystem_list_item_node_list_item_component_list_))
                for subsystem_list_item_node_list_item_component_list_item_ in subsystem_list_item_node_list_item_component_list_:
                    if type(subsystem_list_item_node_list_item_component_list_item_) is not ReportServiceList.ComponentSeq:
                        raise rt.Reject
                    subsystem_list_item_node_list_item_component_list_item_component_rec_ = subsystem_list_item_node_list_item_component_list_item_.component_rec
                    if type(subsystem_list_item_node_list_item_component_list_item_component_rec_) is not core_v1_0_types.ComponentRec:
                        raise rt.Reject
                    subsystem_list_item_node_list_item_component_list_item_component_rec_component_id_ = subsystem_list_item_node_list_item_component_list_item_component_rec_.component_id
                    subsystem_list_item_node_list_item_component_list_item_component_rec_instance_id_ = subsystem_list_item_node_list_item_component_list_item_component_rec_.instance_id
                    out += _S_2B.pack(subsystem_list_item_node_list_item_component_list_item_component_rec_component_id_, subsystem_list_item_node_list_item_component_list_item_component_rec_instance_id_)
                    subsystem_list_item_node_list_item_component_list_item_service_list_ = subsystem_list_item_node_list_item_component_list_item_.service_list
                    if type(subsystem_list_item_node_list_item_component_list_item_service_list_) is not list:
                        raise rt.Reject
                    out.append(len(subsystem_list_item_node_list_item_component_list_item_service_list_))
                    for subsystem_list_item_node_list_item_component_list_item_service_list_item_ in subsystem_list_item_node_list_item_component_list_item_service_list_:
                        if type(subsystem_list_item_node_list_item_component_list_item_service_list_item_) is not core_v1_0_types.ServiceRec:
                            raise rt.Reject
                        subsystem_list_item_node_list_item_component_list_item_service_list_item_uri_ = subsystem_list_item_node_list_item_component_list_item_service_list_item_.uri
                        subsystem_list_item_node_list_item_component_list_item_service_list_item_uri_raw = subsystem_list_item_node_list_item_component_list_item_service_list_item_uri_.encode("latin-1")
                        out.append(len(subsystem_list_item_node_list_item_component_list_item_service_list_item_uri_raw))
                        out += subsystem_list_item_node_list_item_component_list_item_service_list_item_uri_raw
                        subsystem_list_item_node_list_item_component_list_item_service_list_item_major_version_number_ = subsystem_list_item_node_list_item_component_list_item_service_list_item_.major_version_number
                        subsystem_list_item_node_list_item_component_list_item_service_list_item_minor_version_number_ = subsystem_list_item_node_list_item_component_list_item_service_list_item_.minor_version_number
                        out += _S_2B.pack(subsystem_list_item_node_list_item_component_list_item_service_list_item_major_version_number_, subsystem_list_item_node_list_item_component_list_item_service_list_item_minor_version_number_)
        return bytes(out)


_E_QueryIdentification_QueryType = {member.value: member for member in QueryIdentification.QueryType}
_S_HB = rt.Packer("<HB")
_E_QueryConfiguration_QueryType = {member.value: member for member in QueryConfiguration.QueryType}
_S_H = rt.Packer("<H")
_E_QueriedNodeRec_NodeID = {member.value: member for member in core_v1_0_types.QueriedNodeRec.NodeID}
_E_QueriedComponentRec_ComponentID = {member.value: member for member in core_v1_0_types.QueriedComponentRec.ComponentID}
_S_B = rt.Packer("<B")
_E_QueryServiceList_SubsystemID = {member.value: member for member in QueryServiceList.SubsystemID}
_E_QueryServiceList_ComponentID = {member.value: member for member in QueryServiceList.ComponentID}
_S_2B = rt.Packer("<2B")
_E_ReportIdentification_QueryType = {member.value: member for member in ReportIdentification.QueryType}
_E_ReportIdentification_Type = {member.value: member for member in ReportIdentification.Type}
_S_BH = rt.Packer("<BH")
_S_H2B = rt.Packer("<H2B")
