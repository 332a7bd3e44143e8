"""Commands that take time: sent, and waited for until they have been carried out (command events of AS5710 1.1)."""

from __future__ import annotations

import asyncio
import math
from contextlib import suppress
from typing import Final

from jauspy.arguments import check_number
from jauspy.codec.base import Message
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
    request = CreateCommandEvent(link.next_request_id(id), math.ceil(within), command)
    encoded, events = command.encode(), set[int]()

    def heard(message: Message, source: JausID) -> None:
        """At once, for the event may come with its confirmation; a tap, for equal commands share one event."""
        if isinstance(message, ConfirmEventRequest) and message.request_id == request.request_id:
            events.add(message.event_id)
        elif isinstance(message, CommandEvent) and message.event_id in events and not waiter.arrival.done():
            waiter.arrival.set_result((message, source))

    ended = link.replies.waiting(id)  # takes no message by itself, and ends when the OCU is closed
    with ended as waiter, link.replies.tapped(id, heard, ConfirmEventRequest, CommandEvent):
        link.events.join(id, encoded, waiter)
        try:
            await ask(link, id, request, command, link.patience)
            result = await _result(link, id, command, waiter, within + link.patience.total)
        except BaseException:
            if link.events.leave(id, encoded, waiter):
                _forget(link, id, events)
            raise
        link.events.leave(id, encoded, waiter)
    if result.command_result != CommandEvent.CommandResult.SUCCESSFUL:
        link.controls.check(id, command)
        raise RequestError(
            f"{id} did not carry out {command.NAME} within {within:g} s: it gave up, another command took its place, "
            "or it does not obey you now (see `control()` and `status()`)"
        )


async def _result(link: Link, id: JausID, command: Message, waiter: Waiter, seconds: float) -> CommandEvent:
    clock = asyncio.get_running_loop().time
    end = clock() + seconds
    while not waiter.arrival.done():
        link.controls.check(id, command)
        if clock() >= end:
            raise ResponseTimeout(
                f"{id} took {command.NAME} and did not say in {seconds:g} s how it ended; it may have been carried "
                "out, for this is said only once and can be lost; check that the component still runs"
            )
        await asyncio.wait({waiter.arrival}, timeout=min(LOOK, end - clock()))
    message, _ = waiter.arrival.result()
    assert isinstance(message, CommandEvent)
    return message


def _forget(link: Link, id: JausID, events: set[int]) -> None:
    """Nobody waits any more; that the OCU may be closed is said already."""
    with suppress(JausError):
        for event in events:
            cancel(link, id, event)
