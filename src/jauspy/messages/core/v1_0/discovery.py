"""urn:jaus:jss:core:Discovery 1.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from enum import IntEnum
from jauspy.codec import declare as jd
from jauspy.messages.core.v1_0 import types as core_v1_0_types

_SERVICE = jd.Service("urn:jaus:jss:core:Discovery", "1.0")


@jd.message(_SERVICE, 0x4B00)
class ReportIdentification(jd.Message):
    """ReportIdentification (0x4B00): Tells the name and kind of a system, subsystem, node or component.

    query_type: QueryType or 5..255. Whose identification is meant
    type: Type or 10002..20000 or 20002..30000 or 30002..40000 or 40002..50000 or 50002..60000 or 60002..65535. The kind of subsystem, node or component; ranges are left for subdivisions
    identification: up to 255 characters. The name, for people
    """

    class QueryType(IntEnum):
        RESERVED = 0
        SYSTEM = 1
        SUBSYSTEM = 2
        NODE = 3
        COMPONENT = 4

    class Type(IntEnum):
        RESERVED = 0
        VEHICLE = 10001
        OCU = 20001
        OTHER_SUBSYSTEM = 30001
        NODE = 40001
        PAYLOAD = 50001
        COMPONENT = 60001

    query_type: ReportIdentification.QueryType | int = jd.field("QueryType", lambda: jd.Number("B", jd.Values(ReportIdentification.QueryType, ((5, 255),))))
    type: ReportIdentification.Type | int = jd.field("Type", lambda: jd.Number("H", jd.Values(ReportIdentification.Type, ((10002, 20000), (20002, 30000), (30002, 40000), (40002, 50000), (50002, 60000), (60002, 65535)))))
    identification: str = jd.field("Identification", jd.Text(count=jd.Count("B", 0, 255)))


@jd.message(_SERVICE, 0x2B00, query=True)
class QueryIdentification(jd.Message):
    """QueryIdentification (0x2B00): Asks for the name of a system, subsystem, node or component.

    query_type: QueryType or 5..255. Whose identification is meant
    """
    REPORT = ReportIdentification

    class QueryType(IntEnum):
        RESERVED = 0
        SYSTEM = 1
        SUBSYSTEM = 2
        NODE = 3
        COMPONENT = 4

    query_type: QueryIdentification.QueryType | int = jd.field("QueryType", lambda: jd.Number("B", jd.Values(QueryIdentification.QueryType, ((5, 255),))))


@jd.message(_SERVICE, 0x4B01)
class ReportConfiguration(jd.Message):
    """ReportConfiguration (0x4B01): Lists nodes and their components.

    node_list: 0..255 items. The nodes
    """
    ComponentRec = core_v1_0_types.ComponentRec

    @jd.record()
    class NodeRec(jd.Struct):
        """One node.

        node_id: Node number
        """
        node_id: int = jd.field("NodeID", jd.Number("B"))

    @jd.record()
    class NodeSeq(jd.Struct):
        """node_rec: One node
        component_list: 0..255 items. The components
        """
        node_rec: ReportConfiguration.NodeRec = jd.field("NodeRec", lambda: ReportConfiguration.NodeRec.layout())
        component_list: list[core_v1_0_types.ComponentRec] = jd.field("ComponentList", lambda: jd.Repeat(jd.Count("B", 0, 255), core_v1_0_types.ComponentRec.layout()))

    node_list: list[ReportConfiguration.NodeSeq] = jd.field("NodeList", lambda: jd.Repeat(jd.Count("B", 0, 255), ReportConfiguration.NodeSeq.layout()))


@jd.message(_SERVICE, 0x2B01, query=True)
class QueryConfiguration(jd.Message):
    """QueryConfiguration (0x2B01): Asks for the components of a subsystem or node.

    query_type: QueryType or 4..255. Whose components are wanted
    """
    REPORT = ReportConfiguration

    class QueryType(IntEnum):
        RESERVED_0 = 0
        RESERVED_1 = 1
        SUBSYSTEM = 2
        NODE = 3

    query_type: QueryConfiguration.QueryType | int = jd.field("QueryType", lambda: jd.Number("B", jd.Values(QueryConfiguration.QueryType, ((4, 255),))))


@jd.message(_SERVICE, 0x4B02)
class ReportSubsystemList(jd.Message):
    """ReportSubsystemList (0x4B02): Lists subsystems, each with the component that answers for it.

    subsystem_list: 0..255 items. The subsystems
    """
    SubsystemRec = core_v1_0_types.SubsystemRec
    subsystem_list: list[core_v1_0_types.SubsystemRec] = jd.field("SubsystemList", lambda: jd.Repeat(jd.Count("B", 0, 255), core_v1_0_types.SubsystemRec.layout()))


@jd.message(_SERVICE, 0x2B02, query=True)
class QuerySubsystemList(jd.Message):
    """QuerySubsystemList (0x2B02): Asks for the known subsystems."""
    REPORT = ReportSubsystemList


@jd.message(_SERVICE, 0x4B03)
class ReportServices(jd.Message):
    """ReportServices (0x4B03): Lists services by node and component.

    node_list: 0..255 items. The nodes
    """
    ComponentRec = core_v1_0_types.ComponentRec
    ServiceRec = core_v1_0_types.ServiceRec

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
        node_rec: ReportServices.NodeRec = jd.field("NodeRec", lambda: ReportServices.NodeRec.layout())
        component_list: list[ReportServices.ComponentSeq] = jd.field("ComponentList", lambda: jd.Repeat(jd.Count("B", 0, 255), ReportServices.ComponentSeq.layout()))

    node_list: list[ReportServices.NodeSeq] = jd.field("NodeList", lambda: jd.Repeat(jd.Count("B", 0, 255), ReportServices.NodeSeq.layout()))


@jd.message(_SERVICE, 0x2B03, query=True)
class QueryServices(jd.Message):
    """QueryServices (0x2B03): Asks for the services of selected components of the subsystem.

    node_list: 1..255 items. The nodes
    """
    REPORT = ReportServices
    QueriedNodeRec = core_v1_0_types.QueriedNodeRec
    QueriedComponentRec = core_v1_0_types.QueriedComponentRec

    @jd.record()
    class NodeSeq(jd.Struct):
        """node_rec: One node, or all
        component_list: 1..255 items. The components
        """
        node_rec: core_v1_0_types.QueriedNodeRec = jd.field("NodeRec", lambda: core_v1_0_types.QueriedNodeRec.layout())
        component_list: list[core_v1_0_types.QueriedComponentRec] = jd.field("ComponentList", lambda: jd.Repeat(jd.Count("B", 1, 255), core_v1_0_types.QueriedComponentRec.layout()))

    node_list: list[QueryServices.NodeSeq] = jd.field("NodeList", lambda: jd.Repeat(jd.Count("B", 1, 255), QueryServices.NodeSeq.layout()))


@jd.message(_SERVICE, 0x0B00, command=True)
class RegisterServices(jd.Message):
    """RegisterServices (0x0B00): Tells the Discovery service of the node which services a component offers.

    service_list: 0..255 items. The services
    """
    ServiceRec = core_v1_0_types.ServiceRec
    service_list: list[core_v1_0_types.ServiceRec] = jd.field("ServiceList", lambda: jd.Repeat(jd.Count("B", 0, 255), core_v1_0_types.ServiceRec.layout()))
