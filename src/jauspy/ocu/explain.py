"""Finds out why a component ignores commands. JAUS has no answer for that, but the component's state can be queried."""

from __future__ import annotations

import asyncio
from collections.abc import Mapping
from typing import Any, Final

from jauspy.codec.message import Message
from jauspy.errors import ConfigError, ControlRejected, RequestError, ResponseTimeout
from jauspy.ids import JausID
from jauspy.messages.cell import (
    MoveModularArm,
    QueryModularArmMotionResult,
    ReportModularArmMotionResult,
    SetModularArmTrajectory,
)
from jauspy.messages.core import (
    QueryControl,
    QueryEventTimeout,
    QueryIdentification,
    QueryStatus,
    ReportControl,
    ReportServices,
    ReportStatus,
    Reset,
    Shutdown,
)
from jauspy.messages.iop import StartRetrotraverse
from jauspy.messages.manipulator import QueryJointPositions, ReportJointPositions
from jauspy.messages.mobility import QueryVelocityCommand, ReportVelocityCommand, SetVelocityCommand
from jauspy.ocu.connection import COMMANDS_WITHOUT_CONTROL, Connection, RetryPolicy
from jauspy.ocu.control import NO_CONTROLLER, REMEDIES, STATUS_RETRY, controller, status_name
from jauspy.ocu.follow_ups import query_all_services
from jauspy.ocu.subsystems import offered_services

_UNCONTROLLED_SERVICES: Final = frozenset(
    {"Transport", "Events", "EventsClient", "AccessControl", "Discovery", "Liveness"}
)
_TAKEN_IN_STANDBY: Final = ("SetLocalWaypoint", "SetGlobalWaypoint", "SetElement", "DeleteElement")
"""Prefixes of names of commands that need control, but not the state Ready."""
TAKE_CONTROL: Final = "take control first"
NOT_CONTROLLED: Final = f"{{}} is not controlled by this program; {TAKE_CONTROL}, with `robot.control()`"
"""Advice for when another client, or none, is in control."""
_STATES: Final[dict[int, str]] = {
    ReportStatus.Status.INITIALIZE: "still starting: wait until it is in Standby, then resume it",
    ReportStatus.Status.STANDBY: "in Standby: resume first",
    ReportStatus.Status.SHUTDOWN: f"in Shutdown: {REMEDIES[ReportStatus.Status.SHUTDOWN]}",
    ReportStatus.Status.FAILURE: f"in Failure: {REMEDIES[ReportStatus.Status.FAILURE]}",
    ReportStatus.Status.EMERGENCY: f"in Emergency: {REMEDIES[ReportStatus.Status.EMERGENCY]}",
}
_UNAVAILABLE: Final = frozenset({*REMEDIES, ReportStatus.Status.INITIALIZE})
"""The states in which a component gives control to nobody (AS5710)."""
_FITTING: Final[Mapping[int, tuple[type[Message], ...]]] = {
    ReportStatus.Status.FAILURE: (Reset,),
    ReportStatus.Status.SHUTDOWN: (Shutdown,),
}
"""Commands that are taken in such a state, or lead to it."""
_JOINT_LISTS: Final = {
    "SetJointPositions": "joint_position_list",
    "SetJointVelocity": "joint_velocity_list",
    "SetJointEffort": "joint_effort_list",
    "SetActuatorForceTorques": "actuator_force_torque_list",
    "SetJointMotionProfile": "joint_motion_profile_list",
}
_PERHAPS: Final[Mapping[type[Message], str]] = {
    StartRetrotraverse: (
        "it has no path to drive back, or something has stopped it: it keeps the path that it has driven since it "
        "started, without what it has driven back, and ends when it does not get on, or is off its path"
    )
}
"""Why commands fail that a component takes, as far as their services define it."""
_LISTS_WITH_TYPES: Final = {"SetJointPositions": "joint_position"}
_FULL: Final = 0xFF
_COMPONENT_LEVEL: Final = QueryIdentification.QueryType.COMPONENT


def needs_control(command: Message) -> bool:
    """False for queries, for most messages of the core services, and for emergencies."""
    if not command.IS_COMMAND or command.CODE in COMMANDS_WITHOUT_CONTROL:
        return False
    return command.SERVICE.rpartition(":")[2] not in _UNCONTROLLED_SERVICES


async def explain(
    connection: Connection, id: JausID, command: Message | None = None, retry: RetryPolicy = STATUS_RETRY
) -> str:
    """Why `id` ignores commands, or this one, as one sentence; empty when nothing is found that prevents its effect."""
    # Every component answers QueryEventTimeout, whatever services it offers.
    # Those of some vendors answer Discovery only.
    queries = QueryControl(), QueryStatus(), QueryEventTimeout(), QueryIdentification(_COMPONENT_LEVEL)
    answers: list[Any] = await asyncio.gather(
        *(connection.query(id, query, retry=retry) for query in queries), return_exceptions=True
    )
    control, status, *_ = answers
    if all(isinstance(answer, BaseException) for answer in answers):
        return f"{id} does not answer queries and may not exist; `jauspy ls` lists the components"
    if command is not None and (problem := await _not_offered(connection, id, command, retry)):
        return problem
    if command is None or needs_control(command):
        if isinstance(status, ReportStatus) and status.status in _UNAVAILABLE:
            fits = isinstance(command, _FITTING.get(status.status, ()))
            return "" if fits else f"{id} is {_STATES[status.status]}"
        if isinstance(control, ReportControl) and (holder := controller(control)) != connection.id:
            who = "nobody" if holder == NO_CONTROLLER else f"{holder} with authority {control.authority_code}"
            return f"{id} takes commands only from the client in control, which is {who}: {TAKE_CONTROL}"
        if isinstance(status, ReportStatus) and not _is_taken(command, status):
            return f"{id} is {_STATES.get(status.status, status_name(status))}"
    if command is not None:
        return await _wrong_values(connection, id, command, retry)
    return ""


async def why_it_failed(connection: Connection, id: JausID, command: Message, *, timed_out: bool = False) -> str:
    """Why `id` reported that it has not carried out a command, as far as it can be asked; completes "...: ".

    `timed_out`: it reported so when the time for it was over.
    """
    if reason := await explain(connection, id, command):
        return reason
    try:
        if isinstance(command, MoveModularArm | SetModularArmTrajectory):
            # a motion without a number is the last one, unless another one took its place
            number = 0 if isinstance(command, MoveModularArm) else command.modular_arm_trajectory_rec.motion_number
            report = await motion_result(connection, id, number)
            if report.reason:
                return report.reason
            if report.result == report.Result.IN_PROGRESS:
                return "another motion took its place"
    except ResponseTimeout:  # a component without this query
        pass
    untold = f"{id} takes such commands now, and tells no reason: messages of JAUS have no field for one"
    perhaps = None if timed_out else _PERHAPS.get(type(command))
    return untold if perhaps is None else f"{untold}; perhaps {perhaps}"


async def motion_result(connection: Connection, id: JausID, number: int) -> ReportModularArmMotionResult:
    """How a motion of a modular arm ended, by its number; 0 is the last one."""
    query, retry = QueryModularArmMotionResult(number), STATUS_RETRY
    report = await connection.query(id, query, expects=ReportModularArmMotionResult, retry=retry)
    assert isinstance(report, ReportModularArmMotionResult)
    return report


async def check_ready(connection: Connection, id: JausID) -> None:
    """Raise `ControlRejected` or `RequestError` with the reason, unless this client controls `id` and `id` is Ready."""
    if id not in connection.controls:
        raise ControlRejected(NOT_CONTROLLED.format(id))
    status = await connection.query(id, QueryStatus(), expects=ReportStatus)
    assert isinstance(status, ReportStatus)
    if status.status != ReportStatus.Status.READY:
        how = (
            ", with `resume()` of what `robot.control()` gives" if status.status == ReportStatus.Status.STANDBY else ""
        )
        raise RequestError(f"{id} is {_STATES.get(status.status, status_name(status))}{how}")


def _is_taken(command: Message | None, status: ReportStatus) -> bool:
    if status.status == ReportStatus.Status.READY:
        return True
    return command is not None and (
        command.SERVICE.endswith(":Management") or command.NAME.startswith(_TAKEN_IN_STANDBY)
    )


async def _not_offered(connection: Connection, id: JausID, command: Message, retry: RetryPolicy) -> str:
    """Services that inherit from the message's own have it too, so only those of other sets are named."""
    if ":core:" in command.SERVICE:
        return ""
    try:
        report = await connection.query(id, query_all_services(), expects=ReportServices, retry=retry)
    except ResponseTimeout:
        return ""
    assert isinstance(report, ReportServices)
    offered = sorted(service for service in offered_services(report, id).get(id, ()))
    if not offered or any(_has(connection, service.urn, command) for service in offered):
        return ""
    names = ", ".join(str(service) for service in offered if ":core:" not in service.urn)
    return f"{id} does not offer {command.NAME} of {command.SERVICE.removeprefix('urn:jaus:jss:')}; it offers {names}"


def _has(connection: Connection, urn: str, command: Message) -> bool:
    """True when a service has the message, or may inherit it, as drivers of lists do."""
    if urn == command.SERVICE or (urn.endswith("ListDriver") and command.SERVICE.endswith("ListDriver")):
        return True
    known = connection.registry.by_code(command.CODE)
    return any(urn == kind.SERVICE for kind in known)


# --- values -----------------------------------------------------------------------------------------------------------


async def _wrong_values(connection: Connection, id: JausID, command: Message, retry: RetryPolicy) -> str:
    try:
        if command.NAME in _JOINT_LISTS:
            return await _wrong_joints(connection, id, command, retry)
        if isinstance(command, SetVelocityCommand) and not command.command_type:
            return await _too_fast(connection, id, command, retry)
    except (ResponseTimeout, ConfigError):  # it does not report its joints or limits
        return ""
    return ""


async def _wrong_joints(connection: Connection, id: JausID, command: Message, retry: RetryPolicy) -> str:
    report = await connection.query(id, QueryJointPositions(), expects=ReportJointPositions, retry=retry)
    assert isinstance(report, ReportJointPositions)
    joint_kinds = [int(position.joint_position.choice) for position in report.joint_position_list]
    given: list[Any] = getattr(command, _JOINT_LISTS[command.NAME])
    if len(given) != len(joint_kinds):
        return (
            f"{id} ignores {command.NAME}: it has {len(joint_kinds)} joint{'s' * (len(joint_kinds) != 1)}, "
            f"and the message has {len(given)}; give one value for each, base to tip"
        )
    field = _LISTS_WITH_TYPES.get(command.NAME)
    for number, (pair, kind) in enumerate(zip(given, joint_kinds, strict=True), 1):
        if field is not None and int(getattr(pair, field).choice) != kind:
            right, wrong = ("an angle", "a distance") if kind == 1 else ("a distance", "an angle")
            return f"{id} ignores {command.NAME}: joint {number} takes {right}, and the message has {wrong}"
    return ""


async def _too_fast(connection: Connection, id: JausID, command: SetVelocityCommand, retry: RetryPolicy) -> str:
    kinds = ReportVelocityCommand.CommandType
    limits: list[ReportVelocityCommand] = []
    for kind in (kinds.SET_MIN_ALLOWED, kinds.SET_MAX_ALLOWED):
        query = QueryVelocityCommand(_FULL >> 2, kind)
        report = await connection.query(id, query, expects=ReportVelocityCommand, retry=retry)
        assert isinstance(report, ReportVelocityCommand)
        limits.append(report)
    for name, unit in (("velocity_x", "m/s"), ("yaw_rate", "rad/s")):
        value, low, high = (getattr(record, name) for record in (command, *limits))
        if None not in (value, low, high) and not low - 0.01 <= value <= high + 0.01:
            return f"{id} ignores {command.NAME}: {name} {value:g} {unit} is outside {low:.4g}..{high:.4g} {unit}"
    return ""
