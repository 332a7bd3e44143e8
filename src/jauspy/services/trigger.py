"""What a state machine reacts to, and what an action may answer."""

from __future__ import annotations

from enum import Enum
from typing import Any, Final, NamedTuple, TypeAlias

from jauspy.ids import JausID

TriggerKey: TypeAlias = int | str
"""What a transition waits for: the code of a received message, or the name of an internal event."""

ANY_MESSAGE: Final = "Receive"
"""The key of transitions that take every received message (JSIDL: `Receive` without parameters)."""

ANY_TRIGGER: Final = ""
"""The key of transitions that take whatever no other transition of their state takes (JSIDL: `default_transition`)."""


class Trigger(NamedTuple):
    """One input of the state machine: a message from `source`, or an internal event."""

    key: TriggerKey
    msg: Any = None
    """The received message; for an internal event whatever the service that fired it passed on."""
    source: JausID | None = None
    """Who sent the message; for an internal event whom it is about, None for nobody."""

    @property
    def is_message(self) -> bool:
        """True for a received message."""
        return isinstance(self.key, int)


class ActionResult(Enum):
    """What an action may return to steer the transition it belongs to."""

    STAY = "stay"


STAY: Final = ActionResult.STAY
"""Returned by an action: the remaining actions run, but the state does not change."""
