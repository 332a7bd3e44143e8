"""urn:jaus:jss:core:Discovery 1.1. Generated from schemas/; do not edit."""

from __future__ import annotations

from dataclasses import dataclass
from enum import IntEnum
from typing import ClassVar

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

    node_list: list[QueryServices.NodeSeq]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(
            cls,
            (
                rt.Slot("node_list", "NodeList", rt.Repeat(rt.Count("B", 1, 255), QueryServices.NodeSeq.layout())),
            ),
        )


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

    subsystem_list: list[QueryServiceList.SubsystemSeq]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(
            cls,
            (
                rt.Slot("subsystem_list", "SubsystemList", rt.Repeat(rt.Count("H", 1, 65535), QueryServiceList.SubsystemSeq.layout())),
            ),
        )


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

    service_list: list[core_v1_0_types.ServiceRec]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(
            cls,
            (
                rt.Slot("service_list", "ServiceList", rt.Repeat(rt.Count("B", 0, 255), core_v1_0_types.ServiceRec.layout())),
            ),
        )


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

    node_list: list[ReportConfiguration.NodeSeq]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(
            cls,
            (
                rt.Slot("node_list", "NodeList", rt.Repeat(rt.Count("B", 0, 255), ReportConfiguration.NodeSeq.layout())),
            ),
        )


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

    subsystem_list: list[core_v1_0_types.SubsystemRec]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(
            cls,
            (
                rt.Slot("subsystem_list", "SubsystemList", rt.Repeat(rt.Count("B", 0, 255), core_v1_0_types.SubsystemRec.layout())),
            ),
        )


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

    node_list: list[ReportServices.NodeSeq]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(
            cls,
            (
                rt.Slot("node_list", "NodeList", rt.Repeat(rt.Count("B", 0, 255), ReportServices.NodeSeq.layout())),
            ),
        )


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

    subsystem_list: list[ReportServiceList.SubsystemSeq]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(
            cls,
            (
                rt.Slot("subsystem_list", "SubsystemList", rt.Repeat(rt.Count("H", 0, 65535), ReportServiceList.SubsystemSeq.layout())),
            ),
        )
