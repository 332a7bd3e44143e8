"""urn:jaus:jss:exp:aeodrs:HealthReporter 1.4. Generated from schemas/; do not edit."""

from __future__ import annotations

from enum import IntEnum
from jauspy.codec import declare as jd

_SERVICE = jd.Service("urn:jaus:jss:exp:aeodrs:HealthReporter", "1.4")


@jd.message(_SERVICE, 0xFD01)
class ReportHealthDetails(jd.Message):
    """ReportHealthDetails (0xFD01): Health entries by component and service; faults that belong to no single service stand under the reporter's own component.

    detailed_status_list: 0..255 items. One element per supervised component
    """

    @jd.record()
    class ComponentRec(jd.Struct):
        """component_id: Component number within the node"""
        component_id: int = jd.field("ComponentID", jd.Number("B"))

    class Severity(IntEnum):
        NONE = 0
        INFO = 1
        WARN = 2
        ERR = 3
        FAIL = 4

    class Code(IntEnum):
        NONE = 0
        PROCESSOR = 1
        RAM = 2
        ROM = 3
        FILESYS = 4
        POWER = 5
        SENSOR = 6
        ACTUATOR = 7
        SOFTWARE = 8

    @jd.bit_field("I")
    class Logtime(jd.Struct):
        """When the entry was logged (time within the month).

        milliseconds: bits 0..9. Milliseconds.
        seconds: bits 10..15. Seconds.
        minute: bits 16..21. Minute.
        hour: bits 22..26. Hour.
        day: bits 27..31. Day of the month.
        """
        milliseconds: int = jd.bits(0, 0x3FF, jd.Values(None, ((0, 999),)))
        seconds: int = jd.bits(10, 0x3F, jd.Values(None, ((0, 59),)))
        minute: int = jd.bits(16, 0x3F, jd.Values(None, ((0, 59),)))
        hour: int = jd.bits(22, 0x1F, jd.Values(None, ((0, 23),)))
        day: int = jd.bits(27, 0x1F, jd.Values(None, ((1, 31),)))

    @jd.record()
    class ComponentStatuRec(jd.Struct):
        """service_urn: up to 255 characters. URI of the service
        severity: Severity. How bad the state is
        code: Code. Part at fault
        logtime: When the entry was logged (time within the month)
        descriptor: up to 255 characters. Text that explains the entry
        """
        service_urn: str = jd.field("Service_urn", jd.Text(count=jd.Count("B", 0, 255)))
        severity: ReportHealthDetails.Severity | int = jd.field("Severity", lambda: jd.Number("B", jd.Values(ReportHealthDetails.Severity)))
        code: ReportHealthDetails.Code | int = jd.field("Code", lambda: jd.Number("B", jd.Values(ReportHealthDetails.Code)))
        logtime: ReportHealthDetails.Logtime = jd.field("Logtime", lambda: ReportHealthDetails.Logtime.layout())
        descriptor: str = jd.field("Descriptor", jd.Text(count=jd.Count("B", 0, 255)))

    @jd.record()
    class DetailedStatuSeq(jd.Struct):
        """component_status_list: 0..255 items. One element per service of that component"""
        component_rec: ReportHealthDetails.ComponentRec = jd.field("ComponentRec", lambda: ReportHealthDetails.ComponentRec.layout())
        component_status_list: list[ReportHealthDetails.ComponentStatuRec] = jd.field("ComponentStatusList", lambda: jd.Repeat(jd.Count("B", 0, 255), ReportHealthDetails.ComponentStatuRec.layout()))

    detailed_status_list: list[ReportHealthDetails.DetailedStatuSeq] = jd.field("DetailedStatusList", lambda: jd.Repeat(jd.Count("B", 0, 255), ReportHealthDetails.DetailedStatuSeq.layout()))


@jd.message(_SERVICE, 0xED01, query=True)
class QueryHealthDetails(jd.Message):
    """QueryHealthDetails (0xED01): Asks for the latest health state of every service of every supervised component."""
    REPORT = ReportHealthDetails


@jd.message(_SERVICE, 0xFD02)
class ReportHealthSummary(jd.Message):
    """ReportHealthSummary (0xFD02): Worst severity of each supervised component; zero means no fault.

    summary_status_list: 0..255 items. One element per supervised component
    """

    @jd.record()
    class ComponentRec(jd.Struct):
        """component_id: Component number within the node"""
        component_id: int = jd.field("ComponentID", jd.Number("B"))

    class Severity(IntEnum):
        NONE = 0
        INFO = 1
        WARN = 2
        ERR = 3
        FAIL = 4

    @jd.record()
    class SeverityRec(jd.Struct):
        """severity: Severity. Worst severity among the component's services"""
        severity: ReportHealthSummary.Severity | int = jd.field("Severity", lambda: jd.Number("B", jd.Values(ReportHealthSummary.Severity)))

    @jd.record()
    class SummaryStatuSeq(jd.Struct):
        """SummaryStatuSeq."""
        component_rec: ReportHealthSummary.ComponentRec = jd.field("ComponentRec", lambda: ReportHealthSummary.ComponentRec.layout())
        severity_rec: ReportHealthSummary.SeverityRec = jd.field("SeverityRec", lambda: ReportHealthSummary.SeverityRec.layout())

    summary_status_list: list[ReportHealthSummary.SummaryStatuSeq] = jd.field("SummaryStatusList", lambda: jd.Repeat(jd.Count("B", 0, 255), ReportHealthSummary.SummaryStatuSeq.layout()))


@jd.message(_SERVICE, 0xED02, query=True)
class QueryHealthSummary(jd.Message):
    """QueryHealthSummary (0xED02): Asks for one severity per supervised component."""
    REPORT = ReportHealthSummary


@jd.message(_SERVICE, 0xFD03)
class ReportHourMeter(jd.Message):
    """ReportHourMeter (0xFD03): Total time the node or component of the reporter has been powered.

    elapsed_minutes: in minute. Total powered time, in minutes
    """
    elapsed_minutes: int = jd.field("ElapsedMinutes", jd.Number("I", jd.ANY, "minute"))


@jd.message(_SERVICE, 0xED03, query=True)
class QueryHourMeter(jd.Message):
    """QueryHourMeter (0xED03): Asks for the total running time."""
    REPORT = ReportHourMeter


@jd.message(_SERVICE, 0xFD05)
class ReportReminder(jd.Message):
    """ReportReminder (0xFD05): Settings and state of one maintenance reminder.

    reminder_id: Number of the reminder
    reminder_status: ReminderStatus. Whether the interval has run out
    descriptor: up to 255 characters. Text that tells people what the reminder is for
    service_interval: in minute. Powered time after which service is due, in minutes
    elapsed_time: in minute. Powered time since the reminder was last reset, in minutes
    """

    class ReminderStatus(IntEnum):
        NOT_EXPIRED = 0
        EXPIRED = 1

    reminder_id: int = jd.field("ReminderID", jd.Number("B"))
    reminder_status: ReportReminder.ReminderStatus | int = jd.field("ReminderStatus", lambda: jd.Number("B", jd.Values(ReportReminder.ReminderStatus)))
    descriptor: str = jd.field("Descriptor", jd.Text(count=jd.Count("B", 0, 255)))
    service_interval: int = jd.field("ServiceInterval", jd.Number("I", jd.ANY, "minute"))
    elapsed_time: int = jd.field("ElapsedTime", jd.Number("I", jd.ANY, "minute"))


@jd.message(_SERVICE, 0xED05, query=True)
class QueryReminder(jd.Message):
    """QueryReminder (0xED05): Asks for all data of one maintenance reminder.

    reminder_id: Number of the reminder asked about
    """
    REPORT = ReportReminder
    reminder_id: int = jd.field("ReminderID", jd.Number("B"))


@jd.message(_SERVICE, 0xFD04)
class ReportReminderSummary(jd.Message):
    """ReportReminderSummary (0xFD04): State of each configured maintenance reminder.

    reminder_summary_list: 0..255 items. One element per configured reminder
    """

    class ReminderStatus(IntEnum):
        NOT_EXPIRED = 0
        EXPIRED = 1

    @jd.record()
    class ReminderSummaryRec(jd.Struct):
        """reminder_id: Number of the reminder
        reminder_status: ReminderStatus. Whether the interval has run out
        """
        reminder_id: int = jd.field("ReminderID", jd.Number("B"))
        reminder_status: ReportReminderSummary.ReminderStatus | int = jd.field("ReminderStatus", lambda: jd.Number("B", jd.Values(ReportReminderSummary.ReminderStatus)))

    reminder_summary_list: list[ReportReminderSummary.ReminderSummaryRec] = jd.field("ReminderSummaryList", lambda: jd.Repeat(jd.Count("B", 0, 255), ReportReminderSummary.ReminderSummaryRec.layout()))


@jd.message(_SERVICE, 0xED04, query=True)
class QueryReminderSummary(jd.Message):
    """QueryReminderSummary (0xED04): Asks whether each maintenance reminder is due."""
    REPORT = ReportReminderSummary


@jd.message(_SERVICE, 0xDD05, command=True)
class ResetReminder(jd.Message):
    """ResetReminder (0xDD05): Sets the elapsed time of one maintenance reminder back to zero.

    reminder_id: Number of the reminder to reset
    """
    reminder_id: int = jd.field("ReminderID", jd.Number("B"))


@jd.message(_SERVICE, 0xDD01, command=True)
class UpdateHealthReporter(jd.Message):
    """UpdateHealthReporter (0xDD01): Starts a commanded self test of all supervised components; while one is pending, more requests are neither queued nor do they break it off."""
