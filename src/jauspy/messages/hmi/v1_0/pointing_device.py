"""urn:jaus:jss:HMI:PointingDevice 1.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from dataclasses import dataclass
from enum import IntEnum
from typing import ClassVar, Self

from jauspy.codec import runtime as rt


@dataclass(slots=True, repr=False)
class QueryPointingDeviceMovement(rt.Message):
    """QueryPointingDeviceMovement (0x2703): Asks for the position of the pointer."""

    CODE = 0x2703
    NAME = "QueryPointingDeviceMovement"
    SERVICE = "urn:jaus:jss:HMI:PointingDevice"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = True
    REPORT: ClassVar[type[ReportPointingDeviceMovement]]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(cls, ())

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data != b"\x03'": raise rt.Reject
        return rt.new(cls)

    def _pack(self) -> bytes:
        return _S_H.pack(0x2703)


@dataclass(slots=True, repr=False)
class QueryPointingDeviceAction(rt.Message):
    """QueryPointingDeviceAction (0x2704): Asks for the button that was used."""

    CODE = 0x2704
    NAME = "QueryPointingDeviceAction"
    SERVICE = "urn:jaus:jss:HMI:PointingDevice"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = True
    REPORT: ClassVar[type[ReportPointingDeviceAction]]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(cls, ())

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data != b"\x04'": raise rt.Reject
        return rt.new(cls)

    def _pack(self) -> bytes:
        return _S_H.pack(0x2704)


@dataclass(slots=True, repr=False)
class ReportPointingDeviceMovement(rt.Message):
    """ReportPointingDeviceMovement (0x4703): Tells the position of the pointer.

    x: Position of the pointer along X
    y: Position of the pointer along Y
    valid: Valid. Whether the position can be used
    """

    CODE = 0x4703
    NAME = "ReportPointingDeviceMovement"
    SERVICE = "urn:jaus:jss:HMI:PointingDevice"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = False

    class Valid(IntEnum):
        """Values of Valid."""

        INVALID = 0
        VALID = 1

    x: int
    y: int
    valid: ReportPointingDeviceMovement.Valid | int

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("X", rt.Number("i")),
            ("Y", rt.Number("i")),
            ("Valid", rt.Number("b", rt.Values(ReportPointingDeviceMovement.Valid))),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        self = rt.new(cls)
        code, self.x, self.y, valid_ = _S_H2ib.unpack(data)
        if code != 0x4703: raise rt.Reject
        self.valid = _E_ReportPointingDeviceMovement_Valid[valid_]
        return self

    def _pack(self) -> bytes:
        valid_ = self.valid
        if valid_ not in _E_ReportPointingDeviceMovement_Valid: raise rt.Reject
        return _S_H2ib.pack(0x4703, self.x, self.y, valid_)


@dataclass(slots=True, repr=False)
class ReportPointingDeviceAction(rt.Message):
    """ReportPointingDeviceAction (0x4704): Tells that a button was pressed or released, and where.

    button: Button. Which button was used
    state: State. Whether the button went up or down
    x: Position of the pointer along X
    y: Position of the pointer along Y
    valid: Valid. Whether the position can be used
    """

    CODE = 0x4704
    NAME = "ReportPointingDeviceAction"
    SERVICE = "urn:jaus:jss:HMI:PointingDevice"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = False

    class Button(IntEnum):
        """Values of Button."""

        LEFT = 0
        MIDDLE = 1
        RIGHT = 2

    class State(IntEnum):
        """Values of State."""

        UP = 0
        DOWN = 1

    class Valid(IntEnum):
        """Values of Valid."""

        INVALID = 0
        VALID = 1

    button: ReportPointingDeviceAction.Button | int
    state: ReportPointingDeviceAction.State | int
    x: int
    y: int
    valid: ReportPointingDeviceAction.Valid | int

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("Button", rt.Number("b", rt.Values(ReportPointingDeviceAction.Button))),
            ("State", rt.Number("b", rt.Values(ReportPointingDeviceAction.State))),
            ("X", rt.Number("i")),
            ("Y", rt.Number("i")),
            ("Valid", rt.Number("b", rt.Values(ReportPointingDeviceAction.Valid))),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        self = rt.new(cls)
        code, button_, state_, self.x, self.y, valid_ = _S_H2b2ib.unpack(data)
        if code != 0x4704: raise rt.Reject
        self.button = _E_ReportPointingDeviceAction_Button[button_]
        self.state = _E_ReportPointingDeviceAction_State[state_]
        self.valid = _E_ReportPointingDeviceAction_Valid[valid_]
        return self

    def _pack(self) -> bytes:
        button_ = self.button
        if button_ not in _E_ReportPointingDeviceAction_Button: raise rt.Reject
        state_ = self.state
        if state_ not in _E_ReportPointingDeviceAction_State: raise rt.Reject
        valid_ = self.valid
        if valid_ not in _E_ReportPointingDeviceAction_Valid: raise rt.Reject
        return _S_H2b2ib.pack(0x4704, button_, state_, self.x, self.y, valid_)


_S_H = rt.Packer("<H")
_E_ReportPointingDeviceMovement_Valid = rt.members(ReportPointingDeviceMovement.Valid)
_S_H2ib = rt.Packer("<H2ib")
_E_ReportPointingDeviceAction_Button = rt.members(ReportPointingDeviceAction.Button)
_E_ReportPointingDeviceAction_State = rt.members(ReportPointingDeviceAction.State)
_E_ReportPointingDeviceAction_Valid = rt.members(ReportPointingDeviceAction.Valid)
_S_H2b2ib = rt.Packer("<H2b2ib")
QueryPointingDeviceMovement.REPORT = ReportPointingDeviceMovement
QueryPointingDeviceAction.REPORT = ReportPointingDeviceAction
