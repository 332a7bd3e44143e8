"""urn:jaus:jss:HMI:Keyboard 1.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from dataclasses import dataclass
from enum import IntEnum
from typing import ClassVar, Self

from jauspy.codec import runtime as rt


@dataclass(slots=True, repr=False)
class QueryKeyboardAction(rt.Message):
    """QueryKeyboardAction (0x2705): Asks for the key that was used."""

    CODE = 0x2705
    NAME = "QueryKeyboardAction"
    SERVICE = "urn:jaus:jss:HMI:Keyboard"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = True
    REPORT: ClassVar[type[ReportKeyboardAction]]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(cls, ())

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data != b"\x05'": raise rt.Reject
        return rt.new(cls)

    def _pack(self) -> bytes:
        return _S_H.pack(0x2705)


@dataclass(slots=True, repr=False)
class ReportKeyboardAction(rt.Message):
    """ReportKeyboardAction (0x4705): Tells that a key was pressed or released.

    key: Which key was used
    key_state: KeyState. Whether the key went up or down
    """

    CODE = 0x4705
    NAME = "ReportKeyboardAction"
    SERVICE = "urn:jaus:jss:HMI:Keyboard"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = False

    class KeyState(IntEnum):
        """Values of KeyState."""

        RELEASED = 0
        PRESSED = 1

    key: int
    key_state: ReportKeyboardAction.KeyState | int

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("Key", rt.Number("h")),
            ("KeyState", rt.Number("b", rt.Values(ReportKeyboardAction.KeyState))),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        self = rt.new(cls)
        code, self.key, key_state_ = _S_Hhb.unpack(data)
        if code != 0x4705: raise rt.Reject
        self.key_state = _E_ReportKeyboardAction_KeyState[key_state_]
        return self

    def _pack(self) -> bytes:
        key_state_ = self.key_state
        if key_state_ not in _E_ReportKeyboardAction_KeyState: raise rt.Reject
        return _S_Hhb.pack(0x4705, self.key, key_state_)


_S_H = rt.Packer("<H")
_E_ReportKeyboardAction_KeyState = rt.members(ReportKeyboardAction.KeyState)
_S_Hhb = rt.Packer("<Hhb")
QueryKeyboardAction.REPORT = ReportKeyboardAction
