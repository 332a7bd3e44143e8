"""urn:jaus:jss:core:Discovery 1.1. Generated from schemas/; do not edit."""

from __future__ import annotations

from enum import IntEnum
from jauspy.codec import declare as jd
from jauspy.messages.core.v1_0 import discovery as core_v1_0_discovery
from jauspy.messages.core.v1_0 import types as core_v1_0_types

_SERVICE = jd.Service("urn:jaus:jss:core:Discovery", "1.1")

@jd.derived(_SERVICE)
class ReportIdentification(core_v1_0_discovery.ReportIdentification): ...

@jd.derived(_SERVICE)
class QueryIdentification(core_v1_0_discovery.QueryIdentification):
    REPORT = ReportIdentification

@jd.derived(_SERVICE)
class ReportConfiguration(core_v1_0_discovery.ReportConfiguration): ...

@jd.derived(_SERVICE)
class QueryConfiguration(core_v1_0_discovery.QueryConfiguration):
    REPORT = ReportConfiguration

@jd.derived(_SERVICE)
class ReportSubsystemList(core_v1_0_discovery.ReportSubsystemList): ...

@jd.derived(_SERVICE)
class QuerySubsystemList(core_v1_0_discovery.QuerySubsystemList):
    REPORT = ReportSubsystemList

@jd.derived(_SERVICE)
class ReportServices(core_v1_0_discovery.ReportServices): ...

@jd.derived(_SERVICE)
class QueryServices(core_v1_0_discovery.QueryServices):
    REPORT = ReportServices


@jd.message(_SERVICE, 0x4B04)
class ReportServiceList(jd.Message):
    """ReportServiceList (0x4B04): Lists services by subsystem, node and component.

    subsystem_list: 0..65535 items. The subsystems
    """
    ComponentRec = core_v1_0_types.ComponentRec
    ServiceRec = core_v1_0_types.ServiceRec

    @jd.record()
    class SubsystemRec(jd.Struct):
        """One subsystem.

        subsystem_id: Subsystem number
        """
        subsystem_id: int = jd.field("SubsystemID", jd.Number("H"))

    @jd.record()
    class NodeRec(jd.Struct):
        """One node.

        node_id: Node number
        """
        node_id: int = jd.field("NodeID", jd.Number("B"))

    @jd.record()
    class ComponentSeq(jd.Struct):
        """component_rec: One component
        service_list: 0..255 items. The services
        """
        component_rec: core_v1_0_types.ComponentRec = jd.field("ComponentRec", lambda: core_v1_0_types.ComponentRec.layout())
        service_list: list[core_v1_0_types.ServiceRec] = jd.field("ServiceList", lambda: jd.Repeat(jd.Count("B", 0, 255), core_v1_0_types.ServiceRec.layout()))

    @jd.record()
    class NodeSeq(jd.Struct):
        """node_rec: One node
        component_list: 0..255 items. The components
        """
        node_rec: ReportServiceList.NodeRec = jd.field("NodeRec", lambda: ReportServiceList.NodeRec.layout())
        component_list: list[ReportServiceList.ComponentSeq] = jd.field("ComponentList", lambda: jd.Repeat(jd.Count("B", 0, 255), ReportServiceList.ComponentSeq.layout()))

    @jd.record()
    class SubsystemSeq(jd.Struct):
        """subsystem_rec: One subsystem
        node_list: 0..255 items. The nodes
        """
        subsystem_rec: ReportServiceList.SubsystemRec = jd.field("SubsystemRec", lambda: ReportServiceList.SubsystemRec.layout())
        node_list: list[ReportServiceList.NodeSeq] = jd.field("NodeList", lambda: jd.Repeat(jd.Count("B", 0, 255), ReportServiceList.NodeSeq.layout()))

    subsystem_list: list[ReportServiceList.SubsystemSeq] = jd.field("SubsystemList", lambda: jd.Repeat(jd.Count("H", 0, 65535), ReportServiceList.SubsystemSeq.layout()))


@jd.message(_SERVICE, 0x2B04, query=True)
class QueryServiceList(jd.Message):
    """QueryServiceList (0x2B04): Asks for the services of selected components of several subsystems, filtered by name.

    subsystem_list: 1..65535 items. The subsystems
    """
    REPORT = ReportServiceList
    QueriedNodeRec = core_v1_0_types.QueriedNodeRec

    class SubsystemID(IntEnum):
        RESERVED = 0
        ALL_SUBSYSTEMS = 65535

    @jd.record()
    class SubsystemRec(jd.Struct):
        """One subsystem.

        subsystem_id: SubsystemID or 1..65534. Subsystem number
        """
        subsystem_id: QueryServiceList.SubsystemID | int = jd.field("SubsystemID", lambda: jd.Number("H", jd.Values(QueryServiceList.SubsystemID, ((1, 65534),))))

    class ComponentID(IntEnum):
        RESERVED = 0
        ALL_COMPONENTS = 255

    @jd.record("B")
    class ComponentRec(jd.Struct):
        """One component.

        component_id: ComponentID or 1..254. Component number
        search_filter: up to 255 characters, optional. Part of the names of the wanted services; all when absent
        """
        component_id: QueryServiceList.ComponentID | int = jd.field("ComponentID", lambda: jd.Number("B", jd.Values(QueryServiceList.ComponentID, ((1, 254),))))
        search_filter: str | None = jd.field("SearchFilter", jd.Text(count=jd.Count("B", 0, 255)), default=None)
        reserved_presence: int = 0

    @jd.record()
    class NodeSeq(jd.Struct):
        """node_rec: One node, or all
        component_list: 1..255 items. The components
        """
        node_rec: core_v1_0_types.QueriedNodeRec = jd.field("NodeRec", lambda: core_v1_0_types.QueriedNodeRec.layout())
        component_list: list[QueryServiceList.ComponentRec] = jd.field("ComponentList", lambda: jd.Repeat(jd.Count("B", 1, 255), QueryServiceList.ComponentRec.layout()))

    @jd.record()
    class SubsystemSeq(jd.Struct):
        """subsystem_rec: One subsystem
        node_list: 1..255 items. The nodes
        """
        subsystem_rec: QueryServiceList.SubsystemRec = jd.field("SubsystemRec", lambda: QueryServiceList.SubsystemRec.layout())
        node_list: list[QueryServiceList.NodeSeq] = jd.field("NodeList", lambda: jd.Repeat(jd.Count("B", 1, 255), QueryServiceList.NodeSeq.layout()))

    subsystem_list: list[QueryServiceList.SubsystemSeq] = jd.field("SubsystemList", lambda: jd.Repeat(jd.Count("H", 1, 65535), QueryServiceList.SubsystemSeq.layout()))

@jd.derived(_SERVICE)
class RegisterServices(core_v1_0_discovery.RegisterServices): ...
