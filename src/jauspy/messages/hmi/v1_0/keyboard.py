"""urn:jaus:jss:HMI:Keyboard 1.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from enum import IntEnum
from jauspy.codec import declare as jd

_SERVICE = jd.Service("urn:jaus:jss:HMI:Keyboard", "1.0")


@jd.message(_SERVICE, 0x4705)
class ReportKeyboardAction(jd.Message):
    """ReportKeyboardAction (0x4705): Tells that a key was pressed or released.

    key: Which key was used
    key_state: KeyState. Whether the key went up or down
    """

    class KeyState(IntEnum):
        RELEASED = 0
        PRESSED = 1

    key: int = jd.field("Key", jd.Number("h"))
    key_state: ReportKeyboardAction.KeyState | int = jd.field("KeyState", lambda: jd.Number("b", jd.Values(ReportKeyboardAction.KeyState)))


@jd.message(_SERVICE, 0x2705, query=True)
class QueryKeyboardAction(jd.Message):
    """QueryKeyboardAction (0x2705): Asks for the key that was used."""
    REPORT = ReportKeyboardAction
