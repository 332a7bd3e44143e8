"""Messages of core, newest versions; loaded on use. Generated from schemas/; do not edit."""

from __future__ import annotations

from typing import TYPE_CHECKING

from jauspy.codec.registry import lazy

if TYPE_CHECKING:
    from jauspy.messages.core.v1_0.types import (
        AllEventsRec as AllEventsRec, ComponentRec as ComponentRec, DateStamp as DateStamp,
        DestinationID as DestinationID, ElementRec as ElementRec, EventTypeRec as EventTypeRec,
        QueriedComponentRec as QueriedComponentRec, QueriedNodeRec as QueriedNodeRec,
        ReportEventRec as ReportEventRec, ServiceRec as ServiceRec, SourceID as SourceID,
        SubsystemRec as SubsystemRec, TimeStamp as TimeStamp,
    )
    from jauspy.messages.core.v1_1.access_control import (
        ConfirmControl as ConfirmControl, QueryAuthority as QueryAuthority, QueryControl as QueryControl,
        QueryTimeout as QueryTimeout, RejectControl as RejectControl, ReleaseControl as ReleaseControl,
        ReportAuthority as ReportAuthority, ReportControl as ReportControl, ReportTimeout as ReportTimeout,
        RequestControl as RequestControl, SetAuthority as SetAuthority,
    )
    from jauspy.messages.core.v1_1.discovery import (
        QueryConfiguration as QueryConfiguration, QueryIdentification as QueryIdentification,
        QueryServiceList as QueryServiceList, QueryServices as QueryServices,
        QuerySubsystemList as QuerySubsystemList, RegisterServices as RegisterServices,
        ReportConfiguration as ReportConfiguration, ReportIdentification as ReportIdentification,
        ReportServiceList as ReportServiceList, ReportServices as ReportServices,
        ReportSubsystemList as ReportSubsystemList,
    )
    from jauspy.messages.core.v1_1.events import (
        CancelEvent as CancelEvent, CommandEvent as CommandEvent, ConfirmEventRequest as ConfirmEventRequest,
        CreateCommandEvent as CreateCommandEvent, CreateEvent as CreateEvent, Event as Event,
        QueryEventTimeout as QueryEventTimeout, QueryEvents as QueryEvents,
        RejectEventRequest as RejectEventRequest, ReportEventTimeout as ReportEventTimeout,
        ReportEvents as ReportEvents, UpdateEvent as UpdateEvent,
    )
    from jauspy.messages.core.v1_1.list_manager import (
        ConfirmElementRequest as ConfirmElementRequest, DeleteElement as DeleteElement,
        QueryElement as QueryElement, QueryElementCount as QueryElementCount, QueryElementList as QueryElementList,
        RejectElementRequest as RejectElementRequest, ReportElement as ReportElement,
        ReportElementCount as ReportElementCount, ReportElementList as ReportElementList, SetElement as SetElement,
    )
    from jauspy.messages.core.v1_1.liveness import (
        QueryHeartbeatPulse as QueryHeartbeatPulse, ReportHeartbeatPulse as ReportHeartbeatPulse,
    )
    from jauspy.messages.core.v1_1.management import (
        ClearEmergency as ClearEmergency, QueryStatus as QueryStatus, ReportStatus as ReportStatus, Reset as Reset,
        Resume as Resume, SetEmergency as SetEmergency, Shutdown as Shutdown, Standby as Standby,
    )
    from jauspy.messages.core.v1_1.time import (
        QueryTime as QueryTime, ReportTime as ReportTime, SetTime as SetTime,
    )

__all__, __getattr__, __dir__ = lazy(__name__, {
    "jauspy.messages.core.v1_0.types": "AllEventsRec ComponentRec DateStamp DestinationID ElementRec EventTypeRec QueriedComponentRec QueriedNodeRec ReportEventRec ServiceRec SourceID SubsystemRec TimeStamp",
    "jauspy.messages.core.v1_1.access_control": "ConfirmControl QueryAuthority QueryControl QueryTimeout RejectControl ReleaseControl ReportAuthority ReportControl ReportTimeout RequestControl SetAuthority",
    "jauspy.messages.core.v1_1.discovery": "QueryConfiguration QueryIdentification QueryServiceList QueryServices QuerySubsystemList RegisterServices ReportConfiguration ReportIdentification ReportServiceList ReportServices ReportSubsystemList",
    "jauspy.messages.core.v1_1.events": "CancelEvent CommandEvent ConfirmEventRequest CreateCommandEvent CreateEvent Event QueryEventTimeout QueryEvents RejectEventRequest ReportEventTimeout ReportEvents UpdateEvent",
    "jauspy.messages.core.v1_1.list_manager": "ConfirmElementRequest DeleteElement QueryElement QueryElementCount QueryElementList RejectElementRequest ReportElement ReportElementCount ReportElementList SetElement",
    "jauspy.messages.core.v1_1.liveness": "QueryHeartbeatPulse ReportHeartbeatPulse",
    "jauspy.messages.core.v1_1.management": "ClearEmergency QueryStatus ReportStatus Reset Resume SetEmergency Shutdown Standby",
    "jauspy.messages.core.v1_1.time": "QueryTime ReportTime SetTime",
})
