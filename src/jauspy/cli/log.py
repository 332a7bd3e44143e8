"""`jauspy log`: show and switch the log of a robot's traffic, which the robot keeps itself."""

from __future__ import annotations

from enum import StrEnum
from typing import Annotated, Any, Final

import typer

from jauspy.cli import client, console
from jauspy.cli.options import Authority, Connect, Json, OperatorKey, OwnId, Timeout
from jauspy.cli.processes import run
from jauspy.errors import RequestError
from jauspy.messages.iop import (
    QueryLoggerConfiguration,
    QueryLoggerStatus,
    ReportLoggerConfiguration,
    ReportLoggerStatus,
    SetLoggerConfiguration,
    SetLoggerConfigurationResponse,
    SetLoggerState,
)
from jauspy.ocu import OCU
from jauspy.ocu.service import ServiceClient

SERVICE: Final = "iop:DataLogging"
ALL: Final = 0
"""The id that stands for every logger."""
STATUS: Final = QueryLoggerStatus([QueryLoggerStatus.LoggerIDRec(ALL)])
SETTINGS: Final = QueryLoggerConfiguration([QueryLoggerConfiguration.LoggerIDRec(ALL)])


class State(StrEnum):
    """States of a logger."""

    ON = "on"
    OFF = "off"
    PAUSE = "pause"


class Level(StrEnum):
    """Kinds of messages, as robots of jauspy sort them."""

    VERBOSE = "verbose"
    INFORMATION = "information"
    CRITICAL = "critical"


def log(
    *,
    robot: Annotated[int, typer.Argument(metavar="ROBOT", min=1, max=65534, help="The robot's subsystem id.")],
    state: Annotated[State | None, typer.Argument(metavar="[on|off|pause]", help="The new state.")] = None,
    level: Annotated[
        list[Level] | None,
        typer.Option("--level", help="What is recorded, may be repeated: emergencies, commands, all others."),
    ] = None,
    size: Annotated[
        int | None,
        typer.Option("--size", min=1, max=4_000_000, metavar="MB", help="Of all files; the oldest give way."),
    ] = None,
    authority: Authority = 127,
    connect: Connect = None,
    own_id: OwnId = None,
    operator_key: OperatorKey = None,
    timeout: Timeout = 5.0,
    as_json: Json = False,
) -> None:
    """Show the log of a robot's traffic, which the robot keeps itself, or switch it.

    The robot writes it to its own disk (IOP's service DataLogging; `jauspy up --record-to`), and goes on without this
    program. Without a state it is shown: state, size, times of the first and the last message, and what is recorded. To
    switch it, control of its component is taken for a moment.

    Examples:
      jauspy log 101
      jauspy log 101 on --level critical --level information --size 100
    """
    ocu = client.make_ocu(own_id, connect, timeout, operator=operator_key)
    for row in run(_switch(ocu, robot, state, level or [], size, authority=authority)) or ():
        if as_json:
            console.print_json(row)
        else:
            times = " to ".join(time for time in (row["began"], row["ended"]) if time)
            kept = "" if row["megabytes"] is None else f"{row['megabytes']} MB of {row['limit'] or 'unknown'} MB"
            levels = ", ".join(row["levels"]) or "nothing"
            console.print_lines(f"logger {row['logger']}: {row['state']}; it records {levels}")
            console.print_lines(*(f"  {text}" for text in (kept, times) if text))


async def _switch(
    ocu: OCU, number: int, state: State | None, levels: list[Level], size: int | None, *, authority: int
) -> list[dict[str, Any]]:
    async with ocu:
        service = (await ocu.robot(number)).service(SERVICE)
        if state is not None or levels or size is not None:
            async with service.control(authority=authority):
                await service.resume()
                if levels or size is not None:
                    await _configure(service, levels, size)
                if state is not None:
                    value = SetLoggerState.LoggerState[f"LOGGER_{state.name}"]
                    await service.send(SetLoggerState([SetLoggerState.LoggerStateRec(ALL, value)]), ack=True)
                return await _rows(service)
        return await _rows(service)


async def _configure(service: ServiceClient, levels: list[Level], size: int | None) -> None:
    """Change what is given, of every logger; what is not given stays."""
    found = await service.query(
        QueryLoggerConfiguration([QueryLoggerConfiguration.LoggerIDRec(ALL)]), expects=ReportLoggerConfiguration
    )
    if not found.logger_configuration_list:
        raise RequestError(f"{service.id} has no logger")
    entries = []
    for now in found.logger_configuration_list:
        record, policy = now.logger_configuration_rec, now.overflow_policy_rec
        names = {f"log_{level}": 1 for level in levels} or _bits(record.logging_level)
        entries.append(
            SetLoggerConfiguration.LoggerConfigurationSeq(
                SetLoggerConfiguration.LoggerConfigurationRec(
                    record.logger_id, SetLoggerConfiguration.LoggingLevel(**_zeros() | names)
                ),
                SetLoggerConfiguration.OverflowPolicyRec(
                    policy.overflow_removal_policy,
                    overflow_size_threshold=policy.overflow_size_threshold if size is None else size,
                ),
            )
        )
    answer = await service.query(SetLoggerConfiguration(entries), expects=SetLoggerConfigurationResponse)
    for refused in answer.logger_configuration_response_list:
        if refused.error_field != SetLoggerConfigurationResponse.ErrorField.NONE:
            why = getattr(refused.error_field, "name", str(refused.error_field)).lower().replace("_", " ")
            raise RequestError(f"{service.id} refuses these settings of logger {refused.logger_id}: {why}")


async def _rows(service: ServiceClient) -> list[dict[str, Any]]:
    status = await service.query(STATUS, expects=ReportLoggerStatus)
    settings = await service.query(
        QueryLoggerConfiguration([QueryLoggerConfiguration.LoggerIDRec(ALL)]), expects=ReportLoggerConfiguration
    )
    by_id = {entry.logger_configuration_rec.logger_id: entry for entry in settings.logger_configuration_list}
    rows = []
    for record in status.logger_status_list:
        entry = by_id.get(record.logger_id)
        levels = {} if entry is None else _bits(entry.logger_configuration_rec.logging_level)
        rows.append(
            {
                "logger": record.logger_id,
                "state": getattr(record.logger_state, "name", str(record.logger_state)).lower().removeprefix("logger_"),
                "levels": [name.removeprefix("log_") for name, bit in levels.items() if bit],
                "megabytes": record.fill_size,
                "percent": record.fill_percentage_rec,
                "limit": None if entry is None else entry.overflow_policy_rec.overflow_size_threshold,
                "began": _time(record.beginning_timestamp),
                "ended": _time(record.ending_timestamp),
            }
        )
    return rows


def _time(stamp: Any) -> str | None:
    """Day of the month and time (UTC), as far as the message tells it."""
    if stamp is None:
        return None
    return f"day {stamp.day}, {stamp.hour:02}:{stamp.minutes:02}:{stamp.seconds:02} UTC"


def _bits(levels: Any) -> dict[str, int]:
    return {name: getattr(levels, name) for name in _zeros()}


def _zeros() -> dict[str, int]:
    names = ("verbose", "unknown", "critical", "error", "warning", "information", "debug")
    return {f"log_{name}": 0 for name in names}
