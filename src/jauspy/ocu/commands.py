"""Commands that are awaited until they have been carried out, and commands that are repeated.

The former use command events (AS5710 1.1). The latter stop a robot when the program stops sending them (dead-man's
switch).

A component has one event for equal commands of one client. The event is created for the longest time that any of those
who wait allows; the others time out earlier.
"""

from __future__ import annotations

import asyncio
import math
from collections.abc import Mapping
from contextlib import suppress
from types import TracebackType
from typing import TYPE_CHECKING, Any, Final, Self

from jauspy.arguments import async_only, check_number
from jauspy.codec.message import Message
from jauspy.errors import (
    ConfigError,
    ControlRejected,
    JausError,
    ProtocolError,
    RequestError,
    ResponseTimeout,
    TransportError,
)
from jauspy.ids import JausID
from jauspy.logs import get_logger
from jauspy.messages.core import CommandEvent, ConfirmEventRequest, CreateCommandEvent
from jauspy.ocu.connection import Connection
from jauspy.ocu.explain import why_it_failed
from jauspy.ocu.replies import ReplyWaiter, check_message
from jauspy.ocu.subscription import cancel_event, request_event
from jauspy.protocol.header import Ack
from jauspy.services.command_timeout import CONTINUOUS_COMMANDS, Zero

MAX_WITHIN: Final = 0xFFFF_FFFF
"""Seconds; the largest number that fits the message."""
CONTROL_CHECK_INTERVAL: Final = 0.2
"""Seconds between two checks whether control is still held."""


async def perform(connection: Connection, id: JausID, command: Message, within: float) -> None:
    """See `ServiceClient.perform`."""
    check_message(command, "perform()", "Resume()")
    check_number(within, "within")
    if not 0 <= within <= MAX_WITHIN:
        raise ConfigError(f"within {within} s is outside 0..{MAX_WITHIN}")
    if not command.IS_COMMAND:
        raise ConfigError(f"{command.NAME} is not a command; use `query()` for queries and `send()` for other messages")
    connection.controls.check(id, command)
    begin = asyncio.get_running_loop().time()
    result = await _PendingCommand(connection, id, command, within).result()
    if result.command_result != CommandEvent.CommandResult.SUCCESSFUL:
        connection.controls.check(id, command)
        elapsed = asyncio.get_running_loop().time() - begin
        timed_out = elapsed >= within
        when = f"within {within:g} s" if timed_out else f"(it said so after {elapsed:.1f} s)"
        why = await why_it_failed(connection, id, command, timed_out=timed_out)
        raise RequestError(f"{id} did not carry out {command.NAME} {when}: {why}")


class _PendingCommand:
    """One awaited command; `deadline` is when the component should have reported its result."""

    def __init__(self, connection: Connection, id: JausID, command: Message, within: float) -> None:
        self._connection, self._id, self._command, self._within = connection, id, command, within
        self._encoded = command.encode()
        self._clock = asyncio.get_running_loop().time
        self._outlasted = False
        """The event lasts longer than this command's deadline, for another one."""
        self.deadline = self._clock() + math.ceil(within)

    async def result(self) -> CommandEvent:
        """The result of the command. When this is cancelled, and nobody else waits, the event is cancelled."""
        connection, id = self._connection, self._id
        request, events, results = self._request(), set[int](), dict[int, Message]()

        def on_message(message: Message, source: JausID) -> None:
            """The result may arrive with the confirmation, or before it; equal commands share one event."""
            if isinstance(message, ConfirmEventRequest) and message.request_id == request.request_id:
                events.add(message.event_id)
            elif isinstance(message, CommandEvent):
                results[message.event_id] = message
            own_events = results.keys() & events
            if own_events and not waiter.reply.done():
                waiter.reply.set_result((results[min(own_events)], source))

        waiting = connection.replies.waiting(id)  # takes no message by itself; ends when the OCU is closed
        listening = connection.replies.listening(id, on_message, ConfirmEventRequest, CommandEvent)
        with waiting as waiter, listening:
            connection.events.add(id, self._encoded, self)
            connection.controls.on_sent(id, self._command)
            try:
                await request_event(connection, id, request, self._command, connection.retry)
                self.deadline = self._clock() + math.ceil(self._within)
                return await self._wait(waiter)
            except BaseException:
                if connection.events.users(id, self._encoded) == {self}:
                    with suppress(JausError):  # the OCU may be closed
                        for event in events:
                            cancel_event(connection, id, event)
                raise
            finally:
                connection.events.remove(id, self._encoded, self)

    def _request(self) -> CreateCommandEvent:
        """The request for an event that lasts for as long as any of those who wait for an equal command allows."""
        others = self._other_deadlines()
        seconds = math.ceil(max(self.deadline, *others) - self._clock()) if others else math.ceil(self._within)
        return CreateCommandEvent(self._connection.next_request_id(self._id), min(seconds, MAX_WITHIN), self._command)

    async def _wait(self, waiter: ReplyWaiter) -> CommandEvent:
        retry = self._connection.retry
        while not waiter.reply.done():
            self._connection.controls.check(self._id, self._command)
            self._outlasted = self._outlasted or any(
                other_deadline > self.deadline for other_deadline in self._other_deadlines()
            )
            left = self.deadline + (retry.timeout if self._outlasted else retry.total) - self._clock()
            if left <= 0:
                raise self._too_long()
            await asyncio.wait({waiter.reply}, timeout=min(CONTROL_CHECK_INTERVAL, left))
        message, _ = waiter.reply.result()
        assert isinstance(message, CommandEvent)
        return message

    def _other_deadlines(self) -> list[float]:
        users = self._connection.events.users(self._id, self._encoded) - {self}
        return [pending.deadline for pending in users if isinstance(pending, _PendingCommand)]

    def _too_long(self) -> RequestError:
        name, within = self._command.NAME, f"{self._within:g} s"
        if self._outlasted:
            return RequestError(
                f"{self._id} did not carry out {name} within {within}; it goes on, for another `perform()` of the same "
                "command allows more"
            )
        return ResponseTimeout(
            f"{self._id} accepted {name} and did not report its result within {within}; it may have been carried out, "
            "since not all components repeat the report; check that this one still runs"
        )


_LOG: Final = get_logger("jauspy.ocu")

MAX_RATE: Final = 1000.0
"""Hz."""
MAX_PROGRAM_SILENCE: Final = 1.0
"""Seconds for which the program may be blocked before its command is dropped and the robot is stopped."""

_ZEROS: Final[Mapping[str, Zero]] = {**CONTINUOUS_COMMANDS, "SetTravelSpeed": Zero.ALL}
"""Fields that are set to zero to stop the motion of a command."""
_CURRENT: Final = (0, "SET_CURRENT_COMMAND", "SET_COMMAND_SOG")
"""The type of a velocity command that is not a limit."""


class CommandStream:
    """Sends the last command again at `rate` Hz while the event loop of the program runs.

    When the loop was blocked for a second, the command is dropped and the robot is stopped; the next `send` starts
    again. On leaving the block, the robot is stopped: efforts and velocities of the last command become zero, and the
    speed of a vector, whose heading stays. A command of positions is not repeated any more.
    """

    def __init__(self, connection: Connection, id: JausID, rate: float) -> None:
        check_number(rate, "rate")
        if not 0 < rate <= MAX_RATE:
            raise ConfigError(f"rate {rate} is outside 0..{MAX_RATE:g} Hz")
        self.rate: float = rate
        """Hz."""
        self.dropped = 0
        """How often the command was dropped because the program was blocked."""
        self._connection = connection
        self._id = id
        self._command: Message | None = None
        self._stops = 0
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
        self._command, self._stops = command, self._connection.controls.stops(self._id)

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
        if self._connection.controls.stops(self._id) != self._stops:
            self._command = None  # this OCU has stopped it, as by SetEmergency: it must not go on when that ends
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
            "%s was stopped: the program was blocked for %.1f s, so %s was not repeated",
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
        return {name: _zeroed(entry) for name, entry in value.items()}
    if isinstance(value, list):
        return [_zeroed(entry) for entry in value]
    return 0.0 if isinstance(value, float) else value
