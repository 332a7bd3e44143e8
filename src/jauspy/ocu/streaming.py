"""A command that is repeated while the program runs, so that a robot stops when the program does (dead-man)."""

from __future__ import annotations

import asyncio
from collections.abc import Mapping
from types import TracebackType
from typing import TYPE_CHECKING, Any, Final, Self

from jauspy.arguments import async_only, check_number
from jauspy.codec.message import Message
from jauspy.errors import ConfigError, ControlRejected, JausError, ProtocolError, TransportError
from jauspy.ids import JausID
from jauspy.logs import get_logger
from jauspy.ocu.connection import Connection
from jauspy.ocu.replies import check_message
from jauspy.protocol.header import Ack
from jauspy.services.command_timeout import CONTINUOUS_COMMANDS, Zero

_LOG: Final = get_logger("jauspy.ocu")

MAX_RATE: Final = 1000.0
"""Hz."""
MAX_PROGRAM_SILENCE: Final = 1.0
"""Seconds that the program may stand still before its command is dropped and the robot is stopped."""

_ZEROS: Final[Mapping[str, Zero]] = {**CONTINUOUS_COMMANDS, "SetTravelSpeed": Zero.ALL}
"""How the motion of a command is stopped: the speed of travel, which is not repeated otherwise, as the others."""
_CURRENT: Final = (0, "SET_CURRENT_COMMAND", "SET_COMMAND_SOG")
"""The type of a velocity command that is not a limit."""


class CommandStream:
    """Sends the last command again at `rate` Hz, only while the event loop of the program turns.

    When the loop stood still for a second, the command is dropped and the robot is stopped; the next `send`
    starts again. On leaving the block, the robot is stopped: efforts and velocities of the last command become zero,
    and the speed of a vector, whose heading stays. A command of positions is not repeated any more.
    """

    def __init__(self, connection: Connection, id: JausID, rate: float) -> None:
        check_number(rate, "rate")
        if not 0 < rate <= MAX_RATE:
            raise ConfigError(f"rate {rate} is outside 0..{MAX_RATE:g} Hz")
        self.rate: float = rate
        """Hz."""
        self.dropped = 0
        """How often the command was dropped because the program had stood still."""
        self._connection = connection
        self._id = id
        self._command: Message | None = None
        self._task: asyncio.Task[None] | None = None

    def __repr__(self) -> str:
        what = self._command.NAME if self._command is not None else "nothing"
        return f"<stream of {what} to {self._id} at {self.rate:g} Hz>"

    @property
    def active(self) -> bool:
        """True while a command is repeated."""
        return self._command is not None

    async def send(self, command: Message) -> None:
        """Send this command now, and repeat it from now on; raises `ControlRejected` when control was lost."""
        check_message(command, "send()", "SetWrenchEffort(propulsive_linear_effort_x=40.0)")
        if self._task is None:
            raise ConfigError("this stream is not open; use `async with driver.streaming(...) as stream` first")
        self._command = None
        await self._connection.send_checked(self._id, command, ack=False)
        self._command = command

    async def stop(self) -> None:
        """Stop: the last command with efforts and velocities of zero, resent until acknowledged; then send nothing."""
        command, self._command = self._command, None
        stopped = None if command is None else neutral(command)
        if stopped is not None and self._id in self._connection.controls:
            await self._connection.deliver(self._id, stopped)

    async def __aenter__(self) -> Self:
        if self._task is not None:
            raise ConfigError("this stream is already open")
        self._task = asyncio.create_task(self._repeat(), name=f"stream to {self._id}")
        return self

    async def __aexit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        task, self._task = self._task, None
        try:
            await self.stop()
        finally:
            if task is not None:
                task.cancel()
                await asyncio.wait({task})

    if not TYPE_CHECKING:
        __enter__ = __exit__ = async_only("`async with`")

    async def _repeat(self) -> None:
        clock, interval = asyncio.get_running_loop().time, 1.0 / self.rate
        due = clock() + interval
        while True:
            await asyncio.sleep(max(0.0, due - clock()))
            stood = max(clock() - due, self._connection.program_silence())
            if stood > MAX_PROGRAM_SILENCE:
                self._drop(stood)
            self._send_again()
            due = max(due + interval, clock())

    def _send_again(self) -> None:
        if self._command is None:
            return
        if self._id not in self._connection.controls:
            self._command = None  # control was released: it has been sent Standby
            return
        try:
            self._connection.controls.check(self._id, self._command)
            self._connection.send(self._id, self._command)
        except (ControlRejected, TransportError):
            self._command = None  # the next `send` raises it
        except ProtocolError:
            return  # too many messages are under way; the next repetition may get through

    def _drop(self, seconds: float) -> None:
        command, self._command = self._command, None
        if command is None:
            return
        self.dropped += 1
        _LOG.warning(
            "%s was stopped: the program stood still for %.1f s, so %s was not repeated",
            self._id,
            seconds,
            command.NAME,
        )
        stopped = neutral(command)
        try:
            if stopped is not None:
                self._connection.send(self._id, stopped, ack=Ack.REQUIRED)
        except JausError as error:
            _LOG.warning("%s could not be sent a stop: %s", self._id, error)


def neutral(command: Message) -> Message | None:
    """The same command with efforts and velocities of zero; None for a command that has no such form."""
    zero = _ZEROS.get(command.NAME, Zero.NONE)
    if zero is Zero.NONE or getattr(command, "command_type", 0) not in _CURRENT:
        return None
    fields = command.to_dict()
    changed = fields if zero is Zero.ALL else {zero.value: fields.get(zero.value)}
    return type(command).from_dict(fields | _zeroed(changed))


def _zeroed(value: Any) -> Any:
    if isinstance(value, dict):
        return {name: _zeroed(each) for name, each in value.items()}
    if isinstance(value, list):
        return [_zeroed(each) for each in value]
    return 0.0 if isinstance(value, float) else value
