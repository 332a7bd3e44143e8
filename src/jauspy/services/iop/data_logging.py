"""DataLogging: switches a logger of the robot's traffic on, off and to pause, and says what it records (IOP v3)."""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass
from datetime import UTC, datetime
from enum import Enum, Flag
from typing import Final, Protocol

from jauspy.messages.iop import (
    QueryLoggerCapability,
    QueryLoggerConfiguration,
    QueryLoggerStatus,
    ReportLoggerCapability,
    ReportLoggerConfiguration,
    ReportLoggerStatus,
    SetLoggerConfiguration,
    SetLoggerConfigurationResponse,
    SetLoggerState,
)
from jauspy.services.service import Service

MEGABYTE: Final = 1_000_000
ALL_LOGGERS: Final = 0
"""The id that stands for every logger."""
LOGGER: Final = 1
"""The id of the logger of traffic."""


class LogState(Enum):
    """State of a logger; the values are those of the messages."""

    ON = 0
    OFF = 1
    PAUSE = 2


class LogLevel(Flag):
    """Kinds of messages that a logger of traffic records; the values are the bits of `LoggingLevel`."""

    VERBOSE = 1 << 0
    """All messages that no other level has: queries, reports, events."""
    CRITICAL = 1 << 2
    """Emergencies, Reset and Shutdown."""
    INFORMATION = 1 << 5
    """Commands, and requests for control with their answers."""


ALL_LEVELS: Final = LogLevel.VERBOSE | LogLevel.CRITICAL | LogLevel.INFORMATION


@dataclass(frozen=True, slots=True)
class LogSettings:
    """Settings of a log: the kinds of messages recorded, and how much is kept. The oldest files give way."""

    levels: LogLevel = ALL_LEVELS
    size: int = MEGABYTE * 1000
    """Bytes of all files."""


@dataclass(frozen=True, slots=True)
class LogStatus:
    """A logger's state and its files."""

    state: LogState
    size: int = 0
    """Bytes of all files."""
    began: datetime | None = None
    ended: datetime | None = None
    """Times (UTC) of the first and the last message of the newest log; None before there is one."""


class TrafficLogger(Protocol):
    """A logger of traffic, which writes files elsewhere: no client chooses their names or their folder."""

    @property
    def max_size(self) -> int:
        """The most bytes that all files may have."""
        ...

    @property
    def settings(self) -> LogSettings:
        """The present settings."""
        ...

    @property
    def status(self) -> LogStatus:
        """The present status."""
        ...

    def configure(self, settings: LogSettings) -> None:
        """Change the settings; the next log has them if one is being written."""
        ...

    def switch(self, state: LogState) -> None:
        """Change the state. On begins a log or continues a paused one; off completes it."""
        ...


_Error = SetLoggerConfigurationResponse.ErrorField
_Response = SetLoggerConfigurationResponse.LoggerConfigurationResponseRec
_FIFO: Final = SetLoggerConfiguration.OverflowRemovalPolicy.FIRST_IN_FIRST_OUT


class DataLogging(Service, urn="urn:jaus:jss:iop:DataLogging"):
    """One logger, number 1. Only the client in control changes it, and its log continues when that client is lost."""

    def __init__(self, logger: TrafficLogger) -> None:
        self._logger = logger

    def send_report_logger_capability(self, query: QueryLoggerCapability) -> ReportLoggerCapability:
        """Capabilities of the logger; nothing about loggers that there are not."""
        return ReportLoggerCapability(
            [
                ReportLoggerCapability.LoggerCapabilityRec(
                    logger_id=LOGGER,
                    logger_description="messages of this robot",
                    logging_level=ReportLoggerCapability.LoggingLevel(**_bits(ALL_LEVELS)),
                    overflow_size_threshold=self._logger.max_size // MEGABYTE,
                )
            ]
            * _names_it(entry.logger_id for entry in query.logger_id_list)
        )

    def send_report_logger_configuration(self, query: QueryLoggerConfiguration) -> ReportLoggerConfiguration:
        """The settings."""
        settings = self._logger.settings
        return ReportLoggerConfiguration(
            [
                ReportLoggerConfiguration.LoggerConfigurationSeq(
                    ReportLoggerConfiguration.LoggerConfigurationRec(
                        LOGGER, ReportLoggerConfiguration.LoggingLevel(**_bits(settings.levels))
                    ),
                    ReportLoggerConfiguration.OverflowPolicyRec(
                        ReportLoggerConfiguration.OverflowRemovalPolicy.FIRST_IN_FIRST_OUT,
                        overflow_size_threshold=settings.size // MEGABYTE,
                    ),
                )
            ]
            * _names_it(entry.logger_id for entry in query.logger_id_list)
        )

    def send_report_logger_status(self, query: QueryLoggerStatus) -> ReportLoggerStatus:
        """State and size: megabytes are rounded up, percent are of the bytes at which the oldest files give way."""
        status = self._logger.status
        record = ReportLoggerStatus.LoggerStatuRec(
            logger_id=LOGGER,
            logger_state=ReportLoggerStatus.LoggerState(status.state.value),
            fill_size=math.ceil(status.size / MEGABYTE),
            fill_percentage_rec=min(100.0, 100.0 * status.size / self._logger.settings.size),
        )
        if status.began is not None:
            record.beginning_timestamp = ReportLoggerStatus.BeginningTimestamp(**_time(status.began))
        if status.ended is not None:
            record.ending_timestamp = ReportLoggerStatus.EndingTimestamp(**_time(status.ended))
        return ReportLoggerStatus([record] * _names_it(entry.logger_id for entry in query.logger_id_list))

    def set_logger_state(self, msg: SetLoggerState) -> None:
        """Switch the logger; the last of several states counts."""
        for entry in reversed(msg.logger_state_list):
            if entry.logger_id in (ALL_LOGGERS, LOGGER):
                try:
                    state = LogState(entry.logger_state)
                except ValueError:
                    self.host.count("undefined_value", f"logger state {entry.logger_state}")
                    return
                if state is not self._logger.status.state:
                    self._logger.switch(state)
                return

    def set_logger_configuration(self, msg: SetLoggerConfiguration) -> None:
        """Take over settings that can be; the response tells those that cannot."""
        for entry in msg.logger_configuration_list:
            known = entry.logger_configuration_rec.logger_id in (ALL_LOGGERS, LOGGER)
            if known and isinstance(settings := self._settings(entry), LogSettings):
                self._logger.configure(settings)

    def send_set_logger_configuration_response(self, msg: SetLoggerConfiguration) -> SetLoggerConfigurationResponse:
        """For each entry about the logger, why it was refused."""
        found = []
        for entry in msg.logger_configuration_list:
            if (number := entry.logger_configuration_rec.logger_id) in (ALL_LOGGERS, LOGGER):
                settings = self._settings(entry)
                found.append(_Response(number, _Error.NONE if isinstance(settings, LogSettings) else settings))
        return SetLoggerConfigurationResponse(found)

    def _settings(self, entry: SetLoggerConfiguration.LoggerConfigurationSeq) -> LogSettings | _Error:
        """The settings that an entry asks for, or why they are not possible."""
        wanted = entry.logger_configuration_rec.logging_level
        if any(getattr(wanted, name) for name in _LEVELS if name not in _SUPPORTED):
            return _Error.LOGGING_LEVEL_UNSUPPORTED
        policy = entry.overflow_policy_rec
        covers_all = policy.overflow_logging_level is None or _levels(policy.overflow_logging_level) & ALL_LEVELS
        size = self._logger.max_size
        if policy.overflow_size_threshold is not None:
            size = policy.overflow_size_threshold * MEGABYTE
        if policy.overflow_percentage_threshold is not None:
            size = int(size * policy.overflow_percentage_threshold / 100.0)
        if policy.overflow_removal_policy != _FIFO or not covers_all or not MEGABYTE <= size <= self._logger.max_size:
            return _Error.OVERFLOW_POLICY_UNSUPPORTED
        return LogSettings(_levels(wanted), size)


_SUPPORTED: Final = {
    "log_verbose": LogLevel.VERBOSE,
    "log_critical": LogLevel.CRITICAL,
    "log_information": LogLevel.INFORMATION,
}
_LEVELS: Final = (*_SUPPORTED, "log_unknown", "log_error", "log_warning", "log_debug")


def _levels(bits: SetLoggerConfiguration.LoggingLevel | SetLoggerConfiguration.OverflowLoggingLevel) -> LogLevel:
    found = LogLevel(0)
    for name, level in _SUPPORTED.items():
        if getattr(bits, name):
            found |= level
    return found


def _bits(levels: LogLevel) -> dict[str, int]:
    return {name: int(bool(_SUPPORTED.get(name, LogLevel(0)) & levels)) for name in _LEVELS}


def _names_it(numbers: Iterable[int]) -> int:
    """1 if the logger is among them, else 0: however often it is named, there is one entry."""
    return int(any(number in (ALL_LOGGERS, LOGGER) for number in numbers))


def _time(time: datetime) -> dict[str, int]:
    time = time.astimezone(UTC)
    return {
        "milliseconds": time.microsecond // 1000,
        "seconds": time.second,
        "minutes": time.minute,
        "hour": time.hour,
        "day": time.day,
    }
