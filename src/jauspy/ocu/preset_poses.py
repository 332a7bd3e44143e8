"""Moves components to named poses (PresetPose, IOP v3), and tells why one did not get there."""

# ruff: noqa: ASYNC109 - a timeout ends in an error that says where the joints are

from __future__ import annotations

import asyncio
from collections.abc import Awaitable, Callable, Iterable
from typing import Final

from jauspy.arguments import check_number, check_text
from jauspy.codec.message import Message
from jauspy.errors import ConfigError, ControlRejected, EventRejected, RequestError, ResponseTimeout
from jauspy.ids import JausID
from jauspy.messages.iop import (
    QueryCurrentPose,
    QueryPresetPoseCapabilities,
    ReportCurrentPose,
    ReportPresetPoseCapabilities,
    ReportTransitionCompleted,
    SetCurrentPose,
)
from jauspy.ocu.commands import CONTROL_CHECK_INTERVAL, perform
from jauspy.ocu.connection import Connection
from jauspy.ocu.explain import check_ready
from jauspy.printable import printable

PRESET_POSE: Final = "iop:PresetPose"
UNKNOWN_POSE: Final = 255
"""The id of positions that are no named pose."""

_Status = ReportTransitionCompleted.TransitionStatus


class NoRouteError(RequestError):
    """Links would touch on the way to a pose, or in it, with the other joints where they are."""


async def pose_names(connection: Connection, id: JausID) -> dict[int, str]:
    """The names of a component's poses by their ids, as it reports them."""
    report = await connection.query(id, QueryPresetPoseCapabilities(), expects=ReportPresetPoseCapabilities)
    assert isinstance(report, ReportPresetPoseCapabilities)
    records = [sequence.preset_pose_rec for sequence in report.pose_list]
    return {record.pose_id: record.pose_name for record in records if record.pose_id != UNKNOWN_POSE}


async def held_pose(connection: Connection, id: JausID) -> str | None:
    """The name of the pose in which the joints are; None if they are in none, or on the way to one."""
    report = await connection.query(id, QueryCurrentPose(), expects=ReportCurrentPose)
    assert isinstance(report, ReportCurrentPose)
    held = report.report_current_pose_var
    if not isinstance(held, ReportCurrentPose.CurrentPoseRec):
        return None
    return (await pose_names(connection, id)).get(held.current_state_id)


async def move_to_pose(
    connection: Connection, id: JausID, name: str, timeout: float, blocked: Callable[[], Awaitable[str]]
) -> None:
    """Move the joints of a component to a pose, and wait until they are there; `blocked` tells which joint is blocked.

    Raises `ConfigError` for a pose that it does not have, and `RequestError` when it does not get there.
    """
    check_text(name, "the name of a pose")
    check_number(timeout, "timeout")
    number = _number_of(name, await pose_names(connection, id), id)
    command = SetCurrentPose(connection.next_request_id(id), number)
    await check_ready(connection, id)
    report: asyncio.Future[int] = asyncio.get_running_loop().create_future()

    def on_report(message: Message, _: JausID) -> None:
        assert isinstance(message, ReportTransitionCompleted)
        if message.request_id == command.request_id and not report.done():
            report.set_result(int(message.transition_status))

    with connection.replies.listening(id, on_report, ReportTransitionCompleted):
        try:
            await perform(connection, id, command, timeout)
        except EventRejected:  # it has no command events
            await connection.send_checked(id, command, ack=True)
            status = await _reported(connection, id, command, report, timeout)
            if status != _Status.TRANSITION_COMPLETED:
                raise await _error(id, name, status, blocked) from None
        except (ControlRejected, ResponseTimeout):
            raise
        except RequestError as error:
            await asyncio.wait({report}, timeout=connection.retry.timeout)
            if not report.done():
                raise RequestError(f"{id} is not in the pose {name!r}: {error}") from error
            raise await _error(id, name, report.result(), blocked) from error


async def _reported(
    connection: Connection, id: JausID, command: Message, report: asyncio.Future[int], timeout: float
) -> int:
    clock = asyncio.get_running_loop().time
    end = clock() + timeout
    while not report.done():
        connection.controls.check(id, command)
        if clock() >= end:
            raise ResponseTimeout(f"{id} has not reported the end of {command.NAME} within {timeout:g} s")
        await asyncio.wait({report}, timeout=min(CONTROL_CHECK_INTERVAL, end - clock()))
    return report.result()


def _number_of(name: str, names: dict[int, str], id: JausID) -> int:
    found = [number for number, known in names.items() if known == name]
    if len(found) == 1:
        return found[0]
    if found:
        raise ConfigError(f"{id} has {len(found)} poses with the name {name!r}")
    raise ConfigError(f"{id} has no pose {name!r}; it has: {listed(names.values())}")


def listed(names: Iterable[str]) -> str:
    """Names of poses in a sentence."""
    return ", ".join(map(printable, names)) or "none"


async def _error(id: JausID, name: str, status: int, blocked: Callable[[], Awaitable[str]]) -> RequestError:
    """Why a pose was not reached."""
    begin = f"{id} is not in the pose {name!r}: "
    match status:
        case _Status.INVALID_TRANSITION:
            return NoRouteError(
                begin + "links would touch on the way or in the pose, with the other joints where they are (its log "
                "names the links); move them clear first"
            )
        case _Status.UNRECOGNIZED_POSE:
            return RequestError(begin + "it does not know this pose any more")
        case _Status.TRANSITION_TIMED_OUT:
            return RequestError(begin + "it took too long, and holds where it is")
        case _Status.TRANSITION_FAILED_ORIGINAL_POSE_RESTORED:
            return RequestError(begin + "it has returned to the pose from which it came")
    reason = await blocked()
    return RequestError(begin + (reason or "another command, or a stop, ended the motion; it holds where it is"))
