"""Messages of exp, v1_4; loaded on use. Generated from schemas/; do not edit."""

from __future__ import annotations

from typing import TYPE_CHECKING

from jauspy.codec.registry import lazy

if TYPE_CHECKING:
    from jauspy.messages.exp.v1_4.aeodrs_digital_video import (
        QueryAimpointParameters as QueryAimpointParameters, QueryDigitalVideoEndpoint as QueryDigitalVideoEndpoint,
        ReportAimpointParameters as ReportAimpointParameters,
        ReportDigitalVideoEndpoint as ReportDigitalVideoEndpoint,
        SetDigitalVideoEndpoint as SetDigitalVideoEndpoint,
    )
    from jauspy.messages.exp.v1_4.aeodrs_video_illuminator import (
        QueryDigitalVideoIlluminator as QueryDigitalVideoIlluminator,
        QueryDigitalVideoIlluminatorCapabilities as QueryDigitalVideoIlluminatorCapabilities,
        QueryDigitalVideoIlluminatorConfiguration as QueryDigitalVideoIlluminatorConfiguration,
        ReportDigitalVideoIlluminator as ReportDigitalVideoIlluminator,
        ReportDigitalVideoIlluminatorCapabilities as ReportDigitalVideoIlluminatorCapabilities,
        ReportDigitalVideoIlluminatorConfiguration as ReportDigitalVideoIlluminatorConfiguration,
        SetDigitalVideoIlluminator as SetDigitalVideoIlluminator,
        SetDigitalVideoIlluminatorConfiguration as SetDigitalVideoIlluminatorConfiguration,
    )
    from jauspy.messages.exp.v1_4.digital_audio_annuciator import (
        ConfirmAnnunciatorStream as ConfirmAnnunciatorStream, ControlAnnunciatorStream as ControlAnnunciatorStream,
        QueryAnnunciatorCapabilities as QueryAnnunciatorCapabilities,
        QueryAnnunciatorConfiguration as QueryAnnunciatorConfiguration,
        QueryAnnunciatorEndpoint as QueryAnnunciatorEndpoint,
        ReportAnnunciatorCapabilities as ReportAnnunciatorCapabilities,
        ReportAnnunciatorConfiguration as ReportAnnunciatorConfiguration,
        ReportAnnunciatorEndpoint as ReportAnnunciatorEndpoint,
        SetAnnunciatorConfiguration as SetAnnunciatorConfiguration,
    )
    from jauspy.messages.exp.v1_4.digital_audio_sensor import (
        ControlDigitalAudioSensorStream as ControlDigitalAudioSensorStream,
        QueryDigitalAudioSensorCapabilities as QueryDigitalAudioSensorCapabilities,
        QueryDigitalAudioSensorConfiguration as QueryDigitalAudioSensorConfiguration,
        QueryDigitalAudioSensorStreamEndpoint as QueryDigitalAudioSensorStreamEndpoint,
        ReportDigitalAudioSensorCapabilities as ReportDigitalAudioSensorCapabilities,
        ReportDigitalAudioSensorConfiguration as ReportDigitalAudioSensorConfiguration,
        ReportDigitalAudioSensorStreamEndpoint as ReportDigitalAudioSensorStreamEndpoint,
        SetDigitalAudioSensorConfiguration as SetDigitalAudioSensorConfiguration,
        SetDigitalAudioSensorStreamEndpoint as SetDigitalAudioSensorStreamEndpoint,
    )
    from jauspy.messages.exp.v1_4.health_monitor import (
        QueryUGVSummary as QueryUGVSummary, ReportUGVSummary as ReportUGVSummary,
        UpdateUGVSummary as UpdateUGVSummary,
    )
    from jauspy.messages.exp.v1_4.health_reporter import (
        QueryHealthDetails as QueryHealthDetails, QueryHealthSummary as QueryHealthSummary,
        QueryHourMeter as QueryHourMeter, QueryReminder as QueryReminder,
        QueryReminderSummary as QueryReminderSummary, ReportHealthDetails as ReportHealthDetails,
        ReportHealthSummary as ReportHealthSummary, ReportHourMeter as ReportHourMeter,
        ReportReminder as ReportReminder, ReportReminderSummary as ReportReminderSummary,
        ResetReminder as ResetReminder, UpdateHealthReporter as UpdateHealthReporter,
    )
    from jauspy.messages.exp.v1_4.subsystem_id_allocator import (
        GrantSubsystemID as GrantSubsystemID, QuerySubsystemIDs as QuerySubsystemIDs,
        ReportSubsystemIDs as ReportSubsystemIDs, RequestSubsystemID as RequestSubsystemID,
    )

__all__, __getattr__, __dir__ = lazy(__name__, {
    "jauspy.messages.exp.v1_4.aeodrs_digital_video": "QueryAimpointParameters QueryDigitalVideoEndpoint ReportAimpointParameters ReportDigitalVideoEndpoint SetDigitalVideoEndpoint",
    "jauspy.messages.exp.v1_4.aeodrs_video_illuminator": "QueryDigitalVideoIlluminator QueryDigitalVideoIlluminatorCapabilities QueryDigitalVideoIlluminatorConfiguration ReportDigitalVideoIlluminator ReportDigitalVideoIlluminatorCapabilities ReportDigitalVideoIlluminatorConfiguration SetDigitalVideoIlluminator SetDigitalVideoIlluminatorConfiguration",
    "jauspy.messages.exp.v1_4.digital_audio_annuciator": "ConfirmAnnunciatorStream ControlAnnunciatorStream QueryAnnunciatorCapabilities QueryAnnunciatorConfiguration QueryAnnunciatorEndpoint ReportAnnunciatorCapabilities ReportAnnunciatorConfiguration ReportAnnunciatorEndpoint SetAnnunciatorConfiguration",
    "jauspy.messages.exp.v1_4.digital_audio_sensor": "ControlDigitalAudioSensorStream QueryDigitalAudioSensorCapabilities QueryDigitalAudioSensorConfiguration QueryDigitalAudioSensorStreamEndpoint ReportDigitalAudioSensorCapabilities ReportDigitalAudioSensorConfiguration ReportDigitalAudioSensorStreamEndpoint SetDigitalAudioSensorConfiguration SetDigitalAudioSensorStreamEndpoint",
    "jauspy.messages.exp.v1_4.health_monitor": "QueryUGVSummary ReportUGVSummary UpdateUGVSummary",
    "jauspy.messages.exp.v1_4.health_reporter": "QueryHealthDetails QueryHealthSummary QueryHourMeter QueryReminder QueryReminderSummary ReportHealthDetails ReportHealthSummary ReportHourMeter ReportReminder ReportReminderSummary ResetReminder UpdateHealthReporter",
    "jauspy.messages.exp.v1_4.subsystem_id_allocator": "GrantSubsystemID QuerySubsystemIDs ReportSubsystemIDs RequestSubsystemID",
})
