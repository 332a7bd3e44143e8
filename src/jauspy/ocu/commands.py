"""Commands that take time: sent, and awaited until they have been carried out (command events, AS5710 1.1).

A component has one event for equal commands of one client. The event is created for the longest time that any of those
who wait allows; the others give up by themselves.
"""

from __future__ import annotations

import asyncio
import math
from contextlib import suppress
from typing import Final

from jauspy.arguments import check_number
from jauspy.codec.message import Message
from jauspy.errors import ConfigError, JausError, RequestError, ResponseTimeout
from jauspy.ids import JausID
from jauspy.messages.core import CommandEvent, ConfirmEventRequest, CreateCommandEvent
from jauspy.ocu.connection import Connection
from jauspy.ocu.replies import ReplyWaiter, check_message
from jauspy.ocu.subscription import cancel_event, request_event

MAX_WITHIN: Final = 0xFFFF_FFFF
"""Seconds; the largest number that fits the message."""
CONTROL_CHECK_INTERVAL: Final = 0.2
"""Seconds between two checks whether control is still held."""


async def perform(connection: Connection, id: JausID, command: Message, within: float) -> None:
    """As `ServiceClient.perform`."""
    check_message(command, "perform()", "Resume()")
    check_number(within, "within")
    if not 0 <= within <= MAX_WITHIN:
        raise ConfigError(f"within {within} s is outside 0..{MAX_WITHIN}")
    if not command.IS_COMMAND:
        raise ConfigError(f"{command.NAME} is no command; `query()` asks, `send()` sends anything")
    connection.controls.check(id, command)
    begin = asyncio.get_running_loop().time()
    result = await _PendingCommand(connection, id, command, within).result()
    if result.command_result != CommandEvent.CommandResult.SUCCESSFUL:
        connection.controls.check(id, command)
        raise RequestError(
            f"{id} did not carry out {command.NAME} {_after(begin, within)}: it gave up, another command took its "
            "place, or it does not take it now (see `control()` and `status()`)"
        )


def _after(begin: float, within: float) -> str:
    elapsed = asyncio.get_running_loop().time() - begin
    return f"(it said so after {elapsed:.1f} s)" if elapsed < within else f"within {within:g} s"


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
            own = results.keys() & events
            if own and not waiter.reply.done():
                waiter.reply.set_result((results[min(own)], source))

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
            self._outlasted = self._outlasted or any(each > self.deadline for each in self._other_deadlines())
            left = self.deadline + (retry.timeout if self._outlasted else retry.total) - self._clock()
            if left <= 0:
                raise self._too_long()
            await asyncio.wait({waiter.reply}, timeout=min(CONTROL_CHECK_INTERVAL, left))
        message, _ = waiter.reply.result()
        assert isinstance(message, CommandEvent)
        return message

    def _other_deadlines(self) -> list[float]:
        users = self._connection.events.users(self._id, self._encoded) - {self}
        return [each.deadline for each in users if isinstance(each, _PendingCommand)]

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
