"""urn:jaus:jss:iop:DataLogging 1.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from enum import IntEnum
from jauspy.codec import declare as jd

_SERVICE = jd.Service("urn:jaus:jss:iop:DataLogging", "1.0")


@jd.message(_SERVICE, 0x9213)
class ReportLoggerCapability(jd.Message):
    """ReportLoggerCapability (0x9213): Tells what each logger can do.

    logger_capability_list: 0..255 items. One entry a logger
    """

    @jd.bit_field("B")
    class LoggingLevel(jd.Struct):
        """Kinds of entries the logger can record.

        log_verbose: bit 0. Log verbose.
        log_unknown: bit 1. Log unknown.
        log_critical: bit 2. Log critical.
        log_error: bit 3. Log error.
        log_warning: bit 4. Log warning.
        log_information: bit 5. Log information.
        log_debug: bit 6. Log debug.
        """
        log_verbose: int = jd.bits(0, 0x1, jd.Values(None, ((0, 1),)))
        log_unknown: int = jd.bits(1, 0x1, jd.Values(None, ((0, 1),)))
        log_critical: int = jd.bits(2, 0x1, jd.Values(None, ((0, 1),)))
        log_error: int = jd.bits(3, 0x1, jd.Values(None, ((0, 1),)))
        log_warning: int = jd.bits(4, 0x1, jd.Values(None, ((0, 1),)))
        log_information: int = jd.bits(5, 0x1, jd.Values(None, ((0, 1),)))
        log_debug: int = jd.bits(6, 0x1, jd.Values(None, ((0, 1),)))
        reserved_bits: int = 0

    @jd.record("B")
    class LoggerCapabilityRec(jd.Struct):
        """logger_id: Number of the logger; 0 stands for every logger
        logger_description: up to 255 characters. Text for people that says what the logger records
        logging_level: Kinds of entries the logger can record
        overflow_size_threshold: optional. Log size at which overflow handling starts, in megabytes
        overflow_percentage_threshold: 0..100, optional. Fill level at which overflow handling starts, in percent
        """
        logger_id: int = jd.field("LoggerID", jd.Number("b"))
        logger_description: str = jd.field("LoggerDescription", jd.Text(count=jd.Count("B", 0, 255)))
        logging_level: ReportLoggerCapability.LoggingLevel = jd.field("LoggingLevel", lambda: ReportLoggerCapability.LoggingLevel.layout())
        overflow_size_threshold: int | None = jd.field("OverflowSizeThreshold", jd.Number("Q"), default=None)
        overflow_percentage_threshold: float | None = jd.field("OverflowPercentageThreshold", jd.real("B", 0.0, 100.0), default=None)
        reserved_presence: int = 0

    logger_capability_list: list[ReportLoggerCapability.LoggerCapabilityRec] = jd.field("LoggerCapabilityList", lambda: jd.Repeat(jd.Count("B", 0, 255), ReportLoggerCapability.LoggerCapabilityRec.layout()))


@jd.message(_SERVICE, 0x9113, query=True)
class QueryLoggerCapability(jd.Message):
    """QueryLoggerCapability (0x9113): Asks what the named loggers can do.

    logger_id_list: 0..255 items. Loggers the question is about
    """
    REPORT = ReportLoggerCapability

    @jd.record()
    class LoggerIDRec(jd.Struct):
        """logger_id: Number of the logger; 0 stands for every logger"""
        logger_id: int = jd.field("LoggerID", jd.Number("b"))

    logger_id_list: list[QueryLoggerCapability.LoggerIDRec] = jd.field("LoggerIDList", lambda: jd.Repeat(jd.Count("B", 0, 255), QueryLoggerCapability.LoggerIDRec.layout()))


@jd.message(_SERVICE, 0x9212)
class ReportLoggerConfiguration(jd.Message):
    """ReportLoggerConfiguration (0x9212): Tells the settings of each logger.

    logger_configuration_list: 0..255 items. One entry a logger
    """

    @jd.bit_field("B")
    class LoggingLevel(jd.Struct):
        """Kinds of entries that are recorded.

        log_verbose: bit 0. Log verbose.
        log_unknown: bit 1. Log unknown.
        log_critical: bit 2. Log critical.
        log_error: bit 3. Log error.
        log_warning: bit 4. Log warning.
        log_information: bit 5. Log information.
        log_debug: bit 6. Log debug.
        """
        log_verbose: int = jd.bits(0, 0x1, jd.Values(None, ((0, 1),)))
        log_unknown: int = jd.bits(1, 0x1, jd.Values(None, ((0, 1),)))
        log_critical: int = jd.bits(2, 0x1, jd.Values(None, ((0, 1),)))
        log_error: int = jd.bits(3, 0x1, jd.Values(None, ((0, 1),)))
        log_warning: int = jd.bits(4, 0x1, jd.Values(None, ((0, 1),)))
        log_information: int = jd.bits(5, 0x1, jd.Values(None, ((0, 1),)))
        log_debug: int = jd.bits(6, 0x1, jd.Values(None, ((0, 1),)))
        reserved_bits: int = 0

    @jd.record()
    class LoggerConfigurationRec(jd.Struct):
        """Logger configuration.

        logger_id: Number of the logger; 0 stands for every logger
        logging_level: Kinds of entries that are recorded
        """
        logger_id: int = jd.field("LoggerID", jd.Number("b"))
        logging_level: ReportLoggerConfiguration.LoggingLevel = jd.field("LoggingLevel", lambda: ReportLoggerConfiguration.LoggingLevel.layout())

    class OverflowRemovalPolicy(IntEnum):
        FIRST_IN_FIRST_OUT = 0
        LAST_IN_LAST_OUT = 1
        LEAST_RECENTLY_USED = 2
        MOST_RECENTLY_USED = 3
        LEAST_FREQUENTLY_USED = 4
        RANDOM_REPLACEMENT = 5

    @jd.bit_field("B")
    class OverflowLoggingLevel(jd.Struct):
        """Kinds of entries the overflow rule covers.

        log_verbose: bit 0. Log verbose.
        log_unknown: bit 1. Log unknown.
        log_critical: bit 2. Log critical.
        log_error: bit 3. Log error.
        log_warning: bit 4. Log warning.
        log_information: bit 5. Log information.
        log_debug: bit 6. Log debug.
        """
        log_verbose: int = jd.bits(0, 0x1, jd.Values(None, ((0, 1),)))
        log_unknown: int = jd.bits(1, 0x1, jd.Values(None, ((0, 1),)))
        log_critical: int = jd.bits(2, 0x1, jd.Values(None, ((0, 1),)))
        log_error: int = jd.bits(3, 0x1, jd.Values(None, ((0, 1),)))
        log_warning: int = jd.bits(4, 0x1, jd.Values(None, ((0, 1),)))
        log_information: int = jd.bits(5, 0x1, jd.Values(None, ((0, 1),)))
        log_debug: int = jd.bits(6, 0x1, jd.Values(None, ((0, 1),)))
        reserved_bits: int = 0

    @jd.record("B")
    class OverflowPolicyRec(jd.Struct):
        """Overflow policy.

        overflow_removal_policy: OverflowRemovalPolicy. Which entries give way once the log is full
        overflow_logging_level: optional. Kinds of entries the overflow rule covers
        overflow_size_threshold: optional. Log size at which the overflow rule starts, in megabytes
        overflow_percentage_threshold: 0..100, optional. Fill level at which the overflow rule starts, in percent
        """
        overflow_removal_policy: ReportLoggerConfiguration.OverflowRemovalPolicy | int = jd.field("OverflowRemovalPolicy", lambda: jd.Number("B", jd.Values(ReportLoggerConfiguration.OverflowRemovalPolicy)))
        overflow_logging_level: ReportLoggerConfiguration.OverflowLoggingLevel | None = jd.field("OverflowLoggingLevel", lambda: ReportLoggerConfiguration.OverflowLoggingLevel.layout(), default=None)
        overflow_size_threshold: int | None = jd.field("OverflowSizeThreshold", jd.Number("Q"), default=None)
        overflow_percentage_threshold: float | None = jd.field("OverflowPercentageThreshold", jd.real("B", 0.0, 100.0), default=None)
        reserved_presence: int = 0

    @jd.record()
    class LoggerConfigurationSeq(jd.Struct):
        """logger_configuration_rec: Logger configuration
        overflow_policy_rec: Overflow policy
        """
        logger_configuration_rec: ReportLoggerConfiguration.LoggerConfigurationRec = jd.field("LoggerConfigurationRec", lambda: ReportLoggerConfiguration.LoggerConfigurationRec.layout())
        overflow_policy_rec: ReportLoggerConfiguration.OverflowPolicyRec = jd.field("OverflowPolicyRec", lambda: ReportLoggerConfiguration.OverflowPolicyRec.layout())

    logger_configuration_list: list[ReportLoggerConfiguration.LoggerConfigurationSeq] = jd.field("LoggerConfigurationList", lambda: jd.Repeat(jd.Count("B", 0, 255), ReportLoggerConfiguration.LoggerConfigurationSeq.layout()))


@jd.message(_SERVICE, 0x9112, query=True)
class QueryLoggerConfiguration(jd.Message):
    """QueryLoggerConfiguration (0x9112): Asks for the settings of the named loggers.

    logger_id_list: 0..255 items. Loggers the question is about
    """
    REPORT = ReportLoggerConfiguration

    @jd.record()
    class LoggerIDRec(jd.Struct):
        """logger_id: Number of the logger; 0 stands for every logger"""
        logger_id: int = jd.field("LoggerID", jd.Number("b"))

    logger_id_list: list[QueryLoggerConfiguration.LoggerIDRec] = jd.field("LoggerIDList", lambda: jd.Repeat(jd.Count("B", 0, 255), QueryLoggerConfiguration.LoggerIDRec.layout()))


@jd.message(_SERVICE, 0x9211)
class ReportLoggerStatus(jd.Message):
    """ReportLoggerStatus (0x9211): Tells state and fill level of each logger.

    logger_status_list: 0..255 items. One entry a logger
    """

    class LoggerState(IntEnum):
        LOGGER_ON = 0
        LOGGER_OFF = 1
        LOGGER_PAUSE = 2

    @jd.bit_field("I")
    class BeginningTimestamp(jd.Struct):
        """Time of the log's start.

        milliseconds: bits 0..9. Milliseconds.
        seconds: bits 10..15. Seconds.
        minutes: bits 16..21. Minutes.
        hour: bits 22..26. Hour.
        day: bits 27..31. Day.
        """
        milliseconds: int = jd.bits(0, 0x3FF, jd.Values(None, ((0, 999),)))
        seconds: int = jd.bits(10, 0x3F, jd.Values(None, ((0, 59),)))
        minutes: int = jd.bits(16, 0x3F, jd.Values(None, ((0, 59),)))
        hour: int = jd.bits(22, 0x1F, jd.Values(None, ((0, 23),)))
        day: int = jd.bits(27, 0x1F, jd.Values(None, ((1, 31),)))

    @jd.bit_field("I")
    class EndingTimestamp(jd.Struct):
        """Time of the log's end.

        milliseconds: bits 0..9. Milliseconds.
        seconds: bits 10..15. Seconds.
        minutes: bits 16..21. Minutes.
        hour: bits 22..26. Hour.
        day: bits 27..31. Day.
        """
        milliseconds: int = jd.bits(0, 0x3FF, jd.Values(None, ((0, 999),)))
        seconds: int = jd.bits(10, 0x3F, jd.Values(None, ((0, 59),)))
        minutes: int = jd.bits(16, 0x3F, jd.Values(None, ((0, 59),)))
        hour: int = jd.bits(22, 0x1F, jd.Values(None, ((0, 23),)))
        day: int = jd.bits(27, 0x1F, jd.Values(None, ((1, 31),)))

    @jd.record("B")
    class LoggerStatuRec(jd.Struct):
        """logger_id: Number of the logger; 0 stands for every logger
        logger_state: LoggerState. What the logger does now
        fill_size: optional. Space used by the log, in megabytes
        fill_percentage_rec: 0..100, optional. Share of the log space in use, in percent
        beginning_timestamp: optional. Time of the log's start
        ending_timestamp: optional. Time of the log's end
        """
        logger_id: int = jd.field("LoggerID", jd.Number("b"))
        logger_state: ReportLoggerStatus.LoggerState | int = jd.field("LoggerState", lambda: jd.Number("B", jd.Values(ReportLoggerStatus.LoggerState)))
        fill_size: int | None = jd.field("FillSize", jd.Number("Q"), default=None)
        fill_percentage_rec: float | None = jd.field("FillPercentageRec", jd.real("B", 0.0, 100.0), default=None)
        beginning_timestamp: ReportLoggerStatus.BeginningTimestamp | None = jd.field("BeginningTimestamp", lambda: ReportLoggerStatus.BeginningTimestamp.layout(), default=None)
        ending_timestamp: ReportLoggerStatus.EndingTimestamp | None = jd.field("EndingTimestamp", lambda: ReportLoggerStatus.EndingTimestamp.layout(), default=None)
        reserved_presence: int = 0

    logger_status_list: list[ReportLoggerStatus.LoggerStatuRec] = jd.field("LoggerStatusList", lambda: jd.Repeat(jd.Count("B", 0, 255), ReportLoggerStatus.LoggerStatuRec.layout()))


@jd.message(_SERVICE, 0x9111, query=True)
class QueryLoggerStatus(jd.Message):
    """QueryLoggerStatus (0x9111): Asks for state and fill level of the named loggers.

    logger_id_list: 0..255 items. Loggers the question is about
    """
    REPORT = ReportLoggerStatus

    @jd.record()
    class LoggerIDRec(jd.Struct):
        """logger_id: Number of the logger; 0 stands for every logger"""
        logger_id: int = jd.field("LoggerID", jd.Number("b"))

    logger_id_list: list[QueryLoggerStatus.LoggerIDRec] = jd.field("LoggerIDList", lambda: jd.Repeat(jd.Count("B", 0, 255), QueryLoggerStatus.LoggerIDRec.layout()))


@jd.message(_SERVICE, 0x9110, command=True)
class SetLoggerConfiguration(jd.Message):
    """SetLoggerConfiguration (0x9110): Changes the settings of loggers.

    logger_configuration_list: 0..255 items. One entry a logger
    """

    @jd.bit_field("B")
    class LoggingLevel(jd.Struct):
        """Kinds of entries that are recorded.

        log_verbose: bit 0. Log verbose.
        log_unknown: bit 1. Log unknown.
        log_critical: bit 2. Log critical.
        log_error: bit 3. Log error.
        log_warning: bit 4. Log warning.
        log_information: bit 5. Log information.
        log_debug: bit 6. Log debug.
        """
        log_verbose: int = jd.bits(0, 0x1, jd.Values(None, ((0, 1),)))
        log_unknown: int = jd.bits(1, 0x1, jd.Values(None, ((0, 1),)))
        log_critical: int = jd.bits(2, 0x1, jd.Values(None, ((0, 1),)))
        log_error: int = jd.bits(3, 0x1, jd.Values(None, ((0, 1),)))
        log_warning: int = jd.bits(4, 0x1, jd.Values(None, ((0, 1),)))
        log_information: int = jd.bits(5, 0x1, jd.Values(None, ((0, 1),)))
        log_debug: int = jd.bits(6, 0x1, jd.Values(None, ((0, 1),)))
        reserved_bits: int = 0

    @jd.record()
    class LoggerConfigurationRec(jd.Struct):
        """Logger configuration.

        logger_id: Number of the logger; 0 stands for every logger
        logging_level: Kinds of entries that are recorded
        """
        logger_id: int = jd.field("LoggerID", jd.Number("b"))
        logging_level: SetLoggerConfiguration.LoggingLevel = jd.field("LoggingLevel", lambda: SetLoggerConfiguration.LoggingLevel.layout())

    class OverflowRemovalPolicy(IntEnum):
        FIRST_IN_FIRST_OUT = 0
        LAST_IN_LAST_OUT = 1
        LEAST_RECENTLY_USED = 2
        MOST_RECENTLY_USED = 3
        LEAST_FREQUENTLY_USED = 4
        RANDOM_REPLACEMENT = 5

    @jd.bit_field("B")
    class OverflowLoggingLevel(jd.Struct):
        """Kinds of entries the overflow rule covers.

        log_verbose: bit 0. Log verbose.
        log_unknown: bit 1. Log unknown.
        log_critical: bit 2. Log critical.
        log_error: bit 3. Log error.
        log_warning: bit 4. Log warning.
        log_information: bit 5. Log information.
        log_debug: bit 6. Log debug.
        """
        log_verbose: int = jd.bits(0, 0x1, jd.Values(None, ((0, 1),)))
        log_unknown: int = jd.bits(1, 0x1, jd.Values(None, ((0, 1),)))
        log_critical: int = jd.bits(2, 0x1, jd.Values(None, ((0, 1),)))
        log_error: int = jd.bits(3, 0x1, jd.Values(None, ((0, 1),)))
        log_warning: int = jd.bits(4, 0x1, jd.Values(None, ((0, 1),)))
        log_information: int = jd.bits(5, 0x1, jd.Values(None, ((0, 1),)))
        log_debug: int = jd.bits(6, 0x1, jd.Values(None, ((0, 1),)))
        reserved_bits: int = 0

    @jd.record("B")
    class OverflowPolicyRec(jd.Struct):
        """Overflow policy.

        overflow_removal_policy: OverflowRemovalPolicy. Which entries give way once the log is full
        overflow_logging_level: optional. Kinds of entries the overflow rule covers
        overflow_size_threshold: optional. Log size at which the overflow rule starts, in megabytes
        overflow_percentage_threshold: 0..100, optional. Fill level at which the overflow rule starts, in percent
        """
        overflow_removal_policy: SetLoggerConfiguration.OverflowRemovalPolicy | int = jd.field("OverflowRemovalPolicy", lambda: jd.Number("B", jd.Values(SetLoggerConfiguration.OverflowRemovalPolicy)))
        overflow_logging_level: SetLoggerConfiguration.OverflowLoggingLevel | None = jd.field("OverflowLoggingLevel", lambda: SetLoggerConfiguration.OverflowLoggingLevel.layout(), default=None)
        overflow_size_threshold: int | None = jd.field("OverflowSizeThreshold", jd.Number("Q"), default=None)
        overflow_percentage_threshold: float | None = jd.field("OverflowPercentageThreshold", jd.real("B", 0.0, 100.0), default=None)
        reserved_presence: int = 0

    @jd.record()
    class LoggerConfigurationSeq(jd.Struct):
        """logger_configuration_rec: Logger configuration
        overflow_policy_rec: Overflow policy
        """
        logger_configuration_rec: SetLoggerConfiguration.LoggerConfigurationRec = jd.field("LoggerConfigurationRec", lambda: SetLoggerConfiguration.LoggerConfigurationRec.layout())
        overflow_policy_rec: SetLoggerConfiguration.OverflowPolicyRec = jd.field("OverflowPolicyRec", lambda: SetLoggerConfiguration.OverflowPolicyRec.layout())

    logger_configuration_list: list[SetLoggerConfiguration.LoggerConfigurationSeq] = jd.field("LoggerConfigurationList", lambda: jd.Repeat(jd.Count("B", 0, 255), SetLoggerConfiguration.LoggerConfigurationSeq.layout()))


@jd.message(_SERVICE, 0x9109, command=True)
class SetLoggerState(jd.Message):
    """SetLoggerState (0x9109): Switches each named logger on, off or to pause.

    logger_state_list: 0..255 items. One entry a logger
    """

    class LoggerState(IntEnum):
        LOGGER_ON = 0
        LOGGER_OFF = 1
        LOGGER_PAUSE = 2

    @jd.record()
    class LoggerStateRec(jd.Struct):
        """logger_id: Number of the logger; 0 stands for every logger
        logger_state: LoggerState. Wanted state
        """
        logger_id: int = jd.field("LoggerID", jd.Number("b"))
        logger_state: SetLoggerState.LoggerState | int = jd.field("LoggerState", lambda: jd.Number("B", jd.Values(SetLoggerState.LoggerState)))

    logger_state_list: list[SetLoggerState.LoggerStateRec] = jd.field("LoggerStateList", lambda: jd.Repeat(jd.Count("B", 0, 255), SetLoggerState.LoggerStateRec.layout()))


@jd.message(_SERVICE, 0x9210)
class SetLoggerConfigurationResponse(jd.Message):
    """SetLoggerConfigurationResponse (0x9210): Tells for each logger whether its new settings were accepted.

    logger_configuration_response_list: 0..255 items. One entry a logger
    """

    class ErrorField(IntEnum):
        NONE = 0
        OVERFLOW_POLICY_UNSUPPORTED = 1
        LOGGING_LEVEL_UNSUPPORTED = 2

    @jd.record()
    class LoggerConfigurationResponseRec(jd.Struct):
        """logger_id: Number of the logger; 0 stands for every logger
        error_field: ErrorField. Reason why the settings were refused, if they were
        """
        logger_id: int = jd.field("LoggerID", jd.Number("b"))
        error_field: SetLoggerConfigurationResponse.ErrorField | int = jd.field("ErrorField", lambda: jd.Number("B", jd.Values(SetLoggerConfigurationResponse.ErrorField)))

    logger_configuration_response_list: list[SetLoggerConfigurationResponse.LoggerConfigurationResponseRec] = jd.field("LoggerConfigurationResponseList", lambda: jd.Repeat(jd.Count("B", 0, 255), SetLoggerConfigurationResponse.LoggerConfigurationResponseRec.layout()))
