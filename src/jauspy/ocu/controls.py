"""Which components an OCU controls, so that whatever is sent to them is known there."""

from __future__ import annotations

from typing import Final, Protocol

from jauspy.codec.message import Message
from jauspy.errors import ControlRejected
from jauspy.ids import JausID
from jauspy.messages.core import (
    CancelEvent,
    ClearEmergency,
    CreateEvent,
    ReleaseControl,
    RequestControl,
    SetEmergency,
    UpdateEvent,
)

FREE_FOR_ALL: Final = frozenset(
    each.CODE
    for each in (RequestControl, ReleaseControl, SetEmergency, ClearEmergency, CreateEvent, UpdateEvent, CancelEvent)
)
"""Commands that need no control."""


class Held(Protocol):
    """Control of a component, as others see it."""

    def check(self) -> None:
        """Raise `ControlRejected` when it was lost."""

    def sent(self, message: Message) -> None:
        """Hear of a message that was sent to the component."""


class Controls:
    """One for each component, from when it is asked for until it is given back."""

    def __init__(self) -> None:
        self._held: dict[JausID, Held] = {}

    def __contains__(self, id: JausID) -> bool:
        return id in self._held

    def take(self, id: JausID, control: Held) -> None:
        """Remember who controls a component; `ControlRejected` when something else here does."""
        if id in self._held:
            raise ControlRejected(f"this OCU already controls {id}; one `async with` block serves all of its services")
        self._held[id] = control

    def drop(self, id: JausID, control: Held) -> None:
        """Forget it; fine when another one is there."""
        if self._held.get(id) is control:
            del self._held[id]

    def check(self, id: JausID, message: Message) -> None:
        """Raise `ControlRejected` for a command to a component whose control was taken and is lost."""
        if id in self._held and message.IS_COMMAND and message.CODE not in FREE_FOR_ALL:
            self._held[id].check()

    def sent(self, destination: JausID, message: Message) -> None:
        """Tell of a message to all whose components it reaches."""
        for id, control in self._held.items():
            if destination.matches(id):
                control.sent(message)
