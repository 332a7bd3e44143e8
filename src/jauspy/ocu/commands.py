"""Commands that take time: sent, and waited for until they have been carried out (command events of AS5710 1.1).

A component has one event for equal commands of one client. It is asked for the longest time that any of those who wait
allows; who allows less gives up by itself.
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
from jauspy.ocu.arguments import check_message
from jauspy.ocu.event_requests import ask, cancel
from jauspy.ocu.link import Link
from jauspy.ocu.replies import Waiter

LONGEST: Final = 0xFFFF_FFFF
"""Seconds; what fits the message."""
LOOK: Final = 0.2
"""Seconds between two looks at whether control is still held."""


async def perform(link: Link, id: JausID, command: Message, within: float) -> None:
    """As `ServiceClient.perform`."""
    check_message(command, "perform()", "Resume()")
    check_number(within, "within")
    if not 0 <= within <= LONGEST:
        raise ConfigError(f"within {within} s is outside 0..{LONGEST}")
    if not command.IS_COMMAND:
        raise ConfigError(f"{command.NAME} is no command; `query()` asks, `send()` sends anything")
    link.controls.check(id, command)
    result = await _Performance(link, id, command, within).result()
    if result.command_result != CommandEvent.CommandResult.SUCCESSFUL:
        link.controls.check(id, command)
        raise RequestError(
            f"{id} did not carry out {command.NAME} within {within:g} s: it gave up, another command took its place, "
            "or it does not take it now (see `control()` and `status()`)"
        )


class _Performance:
    """One command that somebody waits for; `ends` is when the component should have said how it ended."""

    def __init__(self, link: Link, id: JausID, command: Message, within: float) -> None:
        self._link, self._id, self._command, self._within = link, id, command, within
        self._encoded = command.encode()
        self._clock = asyncio.get_running_loop().time
        self._shared = False
        self.ends = self._clock() + math.ceil(within)

    async def result(self) -> CommandEvent:
        """How the command ended; who stops waiting, and is the last one, ends the event."""
        link, id = self._link, self._id
        request, events, ends = self._request(), set[int](), dict[int, Message]()

        def heard(message: Message, source: JausID) -> None:
            """The event may come with its confirmation, or before it; a tap, for equal commands share one event."""
            if isinstance(message, ConfirmEventRequest) and message.request_id == request.request_id:
                events.add(message.event_id)
            elif isinstance(message, CommandEvent):
                ends[message.event_id] = message
            mine = ends.keys() & events
            if mine and not waiter.arrival.done():
                waiter.arrival.set_result((ends[min(mine)], source))

        ended = link.replies.waiting(id)  # takes no message by itself, and ends when the OCU is closed
        with ended as waiter, link.replies.tapped(id, heard, ConfirmEventRequest, CommandEvent):
            link.events.join(id, self._encoded, self)
            link.controls.sent(id, self._command)
            try:
                await ask(link, id, request, self._command, link.patience)
                self.ends = self._clock() + math.ceil(self._within)
                return await self._wait(waiter)
            except BaseException:
                if link.events.users(id, self._encoded) == {self}:
                    _forget(link, id, events)
                raise
            finally:
                link.events.leave(id, self._encoded, self)

    def _request(self) -> CreateCommandEvent:
        """For as long as any of those who wait for an equal command allows."""
        others = [each.ends for each in self._others() if isinstance(each, _Performance)]
        seconds = math.ceil(max(self.ends, *others) - self._clock()) if others else math.ceil(self._within)
        return CreateCommandEvent(self._link.next_request_id(self._id), min(seconds, LONGEST), self._command)

    async def _wait(self, waiter: Waiter) -> CommandEvent:
        patience = self._link.patience
        while not waiter.arrival.done():
            self._link.controls.check(self._id, self._command)
            self._shared = self._shared or any(
                each.ends > self.ends for each in self._others() if isinstance(each, _Performance)
            )
            left = self.ends + (patience.timeout if self._shared else patience.total) - self._clock()
            if left <= 0:
                raise self._too_long()
            await asyncio.wait({waiter.arrival}, timeout=min(LOOK, left))
        message, _ = waiter.arrival.result()
        assert isinstance(message, CommandEvent)
        return message

    def _others(self) -> frozenset[object]:
        return self._link.events.users(self._id, self._encoded) - {self}

    def _too_long(self) -> RequestError:
        name, within = self._command.NAME, f"{self._within:g} s"
        if self._shared:
            return RequestError(
                f"{self._id} did not carry out {name} within {within}; it goes on, for another `perform()` of the same "
                "command allows more"
            )
        return ResponseTimeout(
            f"{self._id} took {name} and did not say within {within} how it ended; it may have been carried out, for "
            "not all components say that more than once; check that this one still runs"
        )


def _forget(link: Link, id: JausID, events: set[int]) -> None:
    """Nobody waits any more; that the OCU may be closed is said already."""
    with suppress(JausError):
        for event in events:
            cancel(link, id, event)
