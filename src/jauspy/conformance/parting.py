"""Leaves the target as a good guest does, however the run has ended: no emergency, in Standby, in nobody's control."""

from __future__ import annotations

from contextlib import suppress
from typing import Final

from jauspy.codec.base import Message
from jauspy.conformance.tester import Tester
from jauspy.errors import TransportError
from jauspy.messages.core import ClearEmergency, ReleaseControl, RequestControl, SetEmergency, Standby

STOP: Final = SetEmergency.EmergencyCode.STOP
UNDOING: Final[tuple[tuple[type[Message], tuple[Message, ...]], ...]] = (
    (SetEmergency, (ClearEmergency(STOP),)),
    (RequestControl, (Standby(), ReleaseControl())),
)
"""What a client has sent, and what takes it back; control cannot be released during an emergency."""
SETTLE: Final = 0.1
"""Timeouts that the target has to hear of it."""


def part(tester: Tester) -> str:
    """Take back what the clients have asked for; says what prevented it, if anything did."""
    undone = [
        (client, message)
        for kind, undoing in UNDOING
        for client in tester.clients
        if kind.CODE in client.sent
        for message in undoing
    ]
    try:
        for client, message in undone:
            client.send(message)
    except TransportError as error:
        return f"the target could not be left in order: {error}"
    with suppress(TransportError):  # what comes now is not looked at
        tester.wait(SETTLE * tester.timeout if undone else 0.0)
    return ""
