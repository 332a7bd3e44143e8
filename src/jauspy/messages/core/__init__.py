"""Messages of core, newest versions; loaded on use. Generated from schemas/; do not edit."""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from jauspy.messages.core.v1_0.types import (
        AllEventsRec as AllEventsRec,
        ComponentRec as ComponentRec,
        DateStamp as DateStamp,
        ElementRec as ElementRec,
        EventTypeRec as EventTypeRec,
        QueriedComponentRec as QueriedComponentRec,
        QueriedNodeRec as QueriedNodeRec,
        ServiceRec as ServiceRec,
        SubsystemRec as SubsystemRec,
        TimeStamp as TimeStamp,
    )
    from jauspy.messages.core.v1_1.access_control import (
        ConfirmControl as ConfirmControl,
        QueryAuthority as QueryAuthority,
        QueryControl as QueryControl,
        QueryTimeout as QueryTimeout,
        RejectControl as RejectControl,
        ReleaseControl as ReleaseControl,
        ReportAuthority as ReportAuthority,
        ReportControl as ReportControl,
        ReportTimeout as ReportTimeout,
        RequestControl as RequestControl,
        SetAuthority as SetAuthority,
    )
    from jauspy.messages.core.v1_1.discovery import (
        QueryConfiguration as QueryConfiguration,
        QueryIdentification as QueryIdentification,
        QueryServiceList as QueryServiceList,
        QueryServices as QueryServices,
        QuerySubsystemList as QuerySubsystemList,
        RegisterServices as RegisterServices,
        ReportConfiguration as ReportConfiguration,
        ReportIdentification as ReportIdentification,
        ReportServiceList as ReportServiceList,
        ReportServices as ReportServices,
        ReportSubsystemList as ReportSubsystemList,
    )
    from jauspy.messages.core.v1_1.events import (
        CancelEvent as CancelEvent,
        CommandEvent as CommandEvent,
        ConfirmEventRequest as ConfirmEventRequest,
        CreateCommandEvent as CreateCommandEvent,
        CreateEvent as CreateEvent,
        Event as Event,
        QueryEventTimeout as QueryEventTimeout,
        QueryEvents as QueryEvents,
        RejectEventRequest as RejectEventRequest,
        ReportEventTimeout as ReportEventTimeout,
        ReportEvents as ReportEvents,
        UpdateEvent as UpdateEvent,
    )
    from jauspy.messages.core.v1_1.list_manager import (
        ConfirmElementRequest as ConfirmElementRequest,
        DeleteElement as DeleteElement,
        QueryElement as QueryElement,
        QueryElementCount as QueryElementCount,
        QueryElementList as QueryElementList,
        RejectElementRequest as RejectElementRequest,
        ReportElement as ReportElement,
        ReportElementCount as ReportElementCount,
        ReportElementList as ReportElementList,
        SetElement as SetElement,
    )
    from jauspy.messages.core.v1_1.liveness import (
        QueryHeartbeatPulse as QueryHeartbeatPulse,
        ReportHeartbeatPulse as ReportHeartbeatPulse,
    )
    from jauspy.messages.core.v1_1.management import (
        ClearEmergency as ClearEmergency,
        QueryStatus as QueryStatus,
        ReportStatus as ReportStatus,
        Reset as Reset,
        Resume as Resume,
        SetEmergency as SetEmergency,
        Shutdown as Shutdown,
        Standby as Standby,
    )
    from jauspy.messages.core.v1_1.time import (
        QueryTime as QueryTime,
        ReportTime as ReportTime,
        SetTime as SetTime,
    )

_MODULES = {
    "AllEventsRec": "jauspy.messages.core.v1_0.types",
    "CancelEvent": "jauspy.messages.core.v1_1.events",
    "ClearEmergency": "jauspy.messages.core.v1_1.management",
    "CommandEvent": "jauspy.messages.core.v1_1.events",
    "ComponentRec": "jauspy.messages.core.v1_0.types",
    "ConfirmControl": "jauspy.messages.core.v1_1.access_control",
    "ConfirmElementRequest": "jauspy.messages.core.v1_1.list_manager",
    "ConfirmEventRequest": "jauspy.messages.core.v1_1.events",
    "CreateCommandEvent": "jauspy.messages.core.v1_1.events",
    "CreateEvent": "jauspy.messages.core.v1_1.events",
    "DateStamp": "jauspy.messages.core.v1_0.types",
    "DeleteElement": "jauspy.messages.core.v1_1.list_manager",
    "ElementRec": "jauspy.messages.core.v1_0.types",
    "Event": "jauspy.messages.core.v1_1.events",
    "EventTypeRec": "jauspy.messages.core.v1_0.types",
    "QueriedComponentRec": "jauspy.messages.core.v1_0.types",
    "QueriedNodeRec": "jauspy.messages.core.v1_0.types",
    "QueryAuthority": "jauspy.messages.core.v1_1.access_control",
    "QueryConfiguration": "jauspy.messages.core.v1_1.discovery",
    "QueryControl": "jauspy.messages.core.v1_1.access_control",
    "QueryElement": "jauspy.messages.core.v1_1.list_manager",
    "QueryElementCount": "jauspy.messages.core.v1_1.list_manager",
    "QueryElementList": "jauspy.messages.core.v1_1.list_manager",
    "QueryEventTimeout": "jauspy.messages.core.v1_1.events",
    "QueryEvents": "jauspy.messages.core.v1_1.events",
    "QueryHeartbeatPulse": "jauspy.messages.core.v1_1.liveness",
    "QueryIdentification": "jauspy.messages.core.v1_1.discovery",
    "QueryServiceList": "jauspy.messages.core.v1_1.discovery",
    "QueryServices": "jauspy.messages.core.v1_1.discovery",
    "QueryStatus": "jauspy.messages.core.v1_1.management",
    "QuerySubsystemList": "jauspy.messages.core.v1_1.discovery",
    "QueryTime": "jauspy.messages.core.v1_1.time",
    "QueryTimeout": "jauspy.messages.core.v1_1.access_control",
    "RegisterServices": "jauspy.messages.core.v1_1.discovery",
    "RejectControl": "jauspy.messages.core.v1_1.access_control",
    "RejectElementRequest": "jauspy.messages.core.v1_1.list_manager",
    "RejectEventRequest": "jauspy.messages.core.v1_1.events",
    "ReleaseControl": "jauspy.messages.core.v1_1.access_control",
    "ReportAuthority": "jauspy.messages.core.v1_1.access_control",
    "ReportConfiguration": "jauspy.messages.core.v1_1.discovery",
    "ReportControl": "jauspy.messages.core.v1_1.access_control",
    "ReportElement": "jauspy.messages.core.v1_1.list_manager",
    "ReportElementCount": "jauspy.messages.core.v1_1.list_manager",
    "ReportElementList": "jauspy.messages.core.v1_1.list_manager",
    "ReportEventTimeout": "jauspy.messages.core.v1_1.events",
    "ReportEvents": "jauspy.messages.core.v1_1.events",
    "ReportHeartbeatPulse": "jauspy.messages.core.v1_1.liveness",
    "ReportIdentification": "jauspy.messages.core.v1_1.discovery",
    "ReportServiceList": "jauspy.messages.core.v1_1.discovery",
    "ReportServices": "jauspy.messages.core.v1_1.discovery",
    "ReportStatus": "jauspy.messages.core.v1_1.management",
    "ReportSubsystemList": "jauspy.messages.core.v1_1.discovery",
    "ReportTime": "jauspy.messages.core.v1_1.time",
    "ReportTimeout": "jauspy.messages.core.v1_1.access_control",
    "RequestControl": "jauspy.messages.core.v1_1.access_control",
    "Reset": "jauspy.messages.core.v1_1.management",
    "Resume": "jauspy.messages.core.v1_1.management",
    "ServiceRec": "jauspy.messages.core.v1_0.types",
    "SetAuthority": "jauspy.messages.core.v1_1.access_control",
    "SetElement": "jauspy.messages.core.v1_1.list_manager",
    "SetEmergency": "jauspy.messages.core.v1_1.management",
    "SetTime": "jauspy.messages.core.v1_1.time",
    "Shutdown": "jauspy.messages.core.v1_1.management",
    "Standby": "jauspy.messages.core.v1_1.management",
    "SubsystemRec": "jauspy.messages.core.v1_0.types",
    "TimeStamp": "jauspy.messages.core.v1_0.types",
    "UpdateEvent": "jauspy.messages.core.v1_1.events",
}

__all__ = ("AllEventsRec", "CancelEvent", "ClearEmergency", "CommandEvent", "ComponentRec", "ConfirmControl", "ConfirmElementRequest", "ConfirmEventRequest", "CreateCommandEvent", "CreateEvent", "DateStamp", "DeleteElement", "ElementRec", "Event", "EventTypeRec", "QueriedComponentRec", "QueriedNodeRec", "QueryAuthority", "QueryConfiguration", "QueryControl", "QueryElement", "QueryElementCount", "QueryElementList", "QueryEventTimeout", "QueryEvents", "QueryHeartbeatPulse", "QueryIdentification", "QueryServiceList", "QueryServices", "QueryStatus", "QuerySubsystemList", "QueryTime", "QueryTimeout", "RegisterServices", "RejectControl", "RejectElementRequest", "RejectEventRequest", "ReleaseControl", "ReportAuthority", "ReportConfiguration", "ReportControl", "ReportElement", "ReportElementCount", "ReportElementList", "ReportEventTimeout", "ReportEvents", "ReportHeartbeatPulse", "ReportIdentification", "ReportServiceList", "ReportServices", "ReportStatus", "ReportSubsystemList", "ReportTime", "ReportTimeout", "RequestControl", "Reset", "Resume", "ServiceRec", "SetAuthority", "SetElement", "SetEmergency", "SetTime", "Shutdown", "Standby", "SubsystemRec", "TimeStamp", "UpdateEvent")


def __getattr__(name: str) -> object:
    if name not in _MODULES:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    value: object = getattr(import_module(_MODULES[name]), name)
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    return sorted({*globals(), *_MODULES})
