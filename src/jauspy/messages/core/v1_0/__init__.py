"""Messages of core, v1_0; loaded on use. Generated from schemas/; do not edit."""

from __future__ import annotations

from typing import TYPE_CHECKING

from jauspy.codec.registry import lazy

if TYPE_CHECKING:
    from jauspy.messages.core.v1_0.access_control import (
        ConfirmControl as ConfirmControl, QueryAuthority as QueryAuthority, QueryControl as QueryControl,
        QueryTimeout as QueryTimeout, RejectControl as RejectControl, ReleaseControl as ReleaseControl,
        ReportAuthority as ReportAuthority, ReportControl as ReportControl, ReportTimeout as ReportTimeout,
        RequestControl as RequestControl, SetAuthority as SetAuthority,
    )
    from jauspy.messages.core.v1_0.discovery import (
        QueryConfiguration as QueryConfiguration, QueryIdentification as QueryIdentification,
        QueryServices as QueryServices, QuerySubsystemList as QuerySubsystemList,
        RegisterServices as RegisterServices, ReportConfiguration as ReportConfiguration,
        ReportIdentification as ReportIdentification, ReportServices as ReportServices,
        ReportSubsystemList as ReportSubsystemList,
    )
    from jauspy.messages.core.v1_0.events import (
        CancelEvent as CancelEvent, ConfirmEventRequest as ConfirmEventRequest, CreateEvent as CreateEvent,
        Event as Event, QueryEvents as QueryEvents, RejectEventRequest as RejectEventRequest,
        ReportEvents as ReportEvents, UpdateEvent as UpdateEvent,
    )
    from jauspy.messages.core.v1_0.liveliness import (
        QueryHeartbeatPulse as QueryHeartbeatPulse, ReportHeartbeatPulse as ReportHeartbeatPulse,
    )
    from jauspy.messages.core.v1_0.management import (
        ClearEmergency as ClearEmergency, QueryStatus as QueryStatus, ReportStatus as ReportStatus, Reset as Reset,
        Resume as Resume, SetEmergency as SetEmergency, Shutdown as Shutdown, Standby as Standby,
    )
    from jauspy.messages.core.v1_0.time import (
        QueryTime as QueryTime, ReportTime as ReportTime, SetTime as SetTime,
    )
    from jauspy.messages.core.v1_0.types import (
        AllEventsRec as AllEventsRec, ComponentRec as ComponentRec, DateStamp as DateStamp,
        DestinationID as DestinationID, ElementRec as ElementRec, EventTypeRec as EventTypeRec,
        QueriedComponentRec as QueriedComponentRec, QueriedNodeRec as QueriedNodeRec,
        ReportEventRec as ReportEventRec, ServiceRec as ServiceRec, SourceID as SourceID,
        SubsystemRec as SubsystemRec, TimeStamp as TimeStamp,
    )

__all__, __getattr__, __dir__ = lazy(__name__, {
    "jauspy.messages.core.v1_0.access_control": "ConfirmControl QueryAuthority QueryControl QueryTimeout RejectControl ReleaseControl ReportAuthority ReportControl ReportTimeout RequestControl SetAuthority",
    "jauspy.messages.core.v1_0.discovery": "QueryConfiguration QueryIdentification QueryServices QuerySubsystemList RegisterServices ReportConfiguration ReportIdentification ReportServices ReportSubsystemList",
    "jauspy.messages.core.v1_0.events": "CancelEvent ConfirmEventRequest CreateEvent Event QueryEvents RejectEventRequest ReportEvents UpdateEvent",
    "jauspy.messages.core.v1_0.liveliness": "QueryHeartbeatPulse ReportHeartbeatPulse",
    "jauspy.messages.core.v1_0.management": "ClearEmergency QueryStatus ReportStatus Reset Resume SetEmergency Shutdown Standby",
    "jauspy.messages.core.v1_0.time": "QueryTime ReportTime SetTime",
    "jauspy.messages.core.v1_0.types": "AllEventsRec ComponentRec DateStamp DestinationID ElementRec EventTypeRec QueriedComponentRec QueriedNodeRec ReportEventRec ServiceRec SourceID SubsystemRec TimeStamp",
})
