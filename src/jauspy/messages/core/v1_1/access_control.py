"""urn:jaus:jss:core:AccessControl 1.1. Generated from schemas/; do not edit."""

from __future__ import annotations

from dataclasses import dataclass
from enum import IntEnum
from typing import ClassVar

from jauspy.codec import runtime as rt


@dataclass(slots=True, repr=False)
class RequestControl(rt.Message):
    """RequestControl (0x000D): Asks for exclusive control, or renews it.

    authority_code: 0..255. Authority; the higher code wins, 0 is the lowest
    """

    CODE: ClassVar[int] = 0x000D
    NAME: ClassVar[str] = "RequestControl"
    SERVICE: ClassVar[str] = "urn:jaus:jss:core:AccessControl"
    VERSION: ClassVar[str] = "1.1"
    IS_COMMAND: ClassVar[bool] = True

    authority_code: int

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(
            cls,
            (
                rt.Slot("authority_code", "AuthorityCode", rt.Number("B", rt.Values(None, ((0, 255),)))),
            ),
        )


@dataclass(slots=True, repr=False)
class ReleaseControl(rt.Message):
    """ReleaseControl (0x000E): Gives up exclusive control."""

    CODE: ClassVar[int] = 0x000E
    NAME: ClassVar[str] = "ReleaseControl"
    SERVICE: ClassVar[str] = "urn:jaus:jss:core:AccessControl"
    VERSION: ClassVar[str] = "1.1"
    IS_COMMAND: ClassVar[bool] = True

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(cls, ())


@dataclass(slots=True, repr=False)
class QueryControl(rt.Message):
    """QueryControl (0x200D): Asks who controls the component."""

    CODE: ClassVar[int] = 0x200D
    NAME: ClassVar[str] = "QueryControl"
    SERVICE: ClassVar[str] = "urn:jaus:jss:core:AccessControl"
    VERSION: ClassVar[str] = "1.1"
    IS_COMMAND: ClassVar[bool] = False

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(cls, ())


@dataclass(slots=True, repr=False)
class QueryAuthority(rt.Message):
    """QueryAuthority (0x2001): Asks for the authority of the component."""

    CODE: ClassVar[int] = 0x2001
    NAME: ClassVar[str] = "QueryAuthority"
    SERVICE: ClassVar[str] = "urn:jaus:jss:core:AccessControl"
    VERSION: ClassVar[str] = "1.1"
    IS_COMMAND: ClassVar[bool] = False

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(cls, ())


@dataclass(slots=True, repr=False)
class SetAuthority(rt.Message):
    """SetAuthority (0x0001): Sets the authority of the controlling client.

    authority_code: 0..255. Authority; the higher code wins, 0 is the lowest
    """

    CODE: ClassVar[int] = 0x0001
    NAME: ClassVar[str] = "SetAuthority"
    SERVICE: ClassVar[str] = "urn:jaus:jss:core:AccessControl"
    VERSION: ClassVar[str] = "1.1"
    IS_COMMAND: ClassVar[bool] = True

    authority_code: int

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(
            cls,
            (
                rt.Slot("authority_code", "AuthorityCode", rt.Number("B", rt.Values(None, ((0, 255),)))),
            ),
        )


@dataclass(slots=True, repr=False)
class QueryTimeout(rt.Message):
    """QueryTimeout (0x2003): Asks after how long control ends unless it is renewed."""

    CODE: ClassVar[int] = 0x2003
    NAME: ClassVar[str] = "QueryTimeout"
    SERVICE: ClassVar[str] = "urn:jaus:jss:core:AccessControl"
    VERSION: ClassVar[str] = "1.1"
    IS_COMMAND: ClassVar[bool] = False

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(cls, ())


@dataclass(slots=True, repr=False)
class ReportControl(rt.Message):
    """ReportControl (0x400D): Tells who controls the component.

    subsystem_id: Subsystem of the controlling client
    node_id: Node of the controlling client
    component_id: Component of the controlling client
    authority_code: 0..255. Authority; the higher code wins, 0 is the lowest
    """

    CODE: ClassVar[int] = 0x400D
    NAME: ClassVar[str] = "ReportControl"
    SERVICE: ClassVar[str] = "urn:jaus:jss:core:AccessControl"
    VERSION: ClassVar[str] = "1.1"
    IS_COMMAND: ClassVar[bool] = False

    subsystem_id: int
    node_id: int
    component_id: int
    authority_code: int

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(
            cls,
            (
                rt.Slot("subsystem_id", "SubsystemID", rt.Number("H")),
                rt.Slot("node_id", "NodeID", rt.Number("B")),
                rt.Slot("component_id", "ComponentID", rt.Number("B")),
                rt.Slot("authority_code", "AuthorityCode", rt.Number("B", rt.Values(None, ((0, 255),)))),
            ),
        )


@dataclass(slots=True, repr=False)
class RejectControl(rt.Message):
    """RejectControl (0x0010): Tells a client that it has lost or released control, or that releasing is not
    possible.

    response_code: ResponseCode. Whether control is released, or cannot be
    """

    CODE: ClassVar[int] = 0x0010
    NAME: ClassVar[str] = "RejectControl"
    SERVICE: ClassVar[str] = "urn:jaus:jss:core:AccessControl"
    VERSION: ClassVar[str] = "1.1"
    IS_COMMAND: ClassVar[bool] = False

    class ResponseCode(IntEnum):
        """Values of ResponseCode."""

        CONTROL_RELEASED = 0
        NOT_AVAILABLE = 1

    response_code: RejectControl.ResponseCode | int

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(
            cls,
            (
                rt.Slot("response_code", "ResponseCode", rt.Number("B", rt.Values(RejectControl.ResponseCode))),
            ),
        )


@dataclass(slots=True, repr=False)
class ConfirmControl(rt.Message):
    """ConfirmControl (0x000F): Answers a request for control.

    response_code: ResponseCode. Whether control is granted, and if not, why
    """

    CODE: ClassVar[int] = 0x000F
    NAME: ClassVar[str] = "ConfirmControl"
    SERVICE: ClassVar[str] = "urn:jaus:jss:core:AccessControl"
    VERSION: ClassVar[str] = "1.1"
    IS_COMMAND: ClassVar[bool] = False

    class ResponseCode(IntEnum):
        """Values of ResponseCode."""

        CONTROL_ACCEPTED = 0
        NOT_AVAILABLE = 1
        INSUFFICIENT_AUTHORITY = 2

    response_code: ConfirmControl.ResponseCode | int

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(
            cls,
            (
                rt.Slot("response_code", "ResponseCode", rt.Number("B", rt.Values(ConfirmControl.ResponseCode))),
            ),
        )


@dataclass(slots=True, repr=False)
class ReportAuthority(rt.Message):
    """ReportAuthority (0x4001): Tells the authority of the component.

    authority_code: 0..255. Authority; the higher code wins, 0 is the lowest
    """

    CODE: ClassVar[int] = 0x4001
    NAME: ClassVar[str] = "ReportAuthority"
    SERVICE: ClassVar[str] = "urn:jaus:jss:core:AccessControl"
    VERSION: ClassVar[str] = "1.1"
    IS_COMMAND: ClassVar[bool] = False

    authority_code: int

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(
            cls,
            (
                rt.Slot("authority_code", "AuthorityCode", rt.Number("B", rt.Values(None, ((0, 255),)))),
            ),
        )


@dataclass(slots=True, repr=False)
class ReportTimeout(rt.Message):
    """ReportTimeout (0x4003): Tells after how long control ends unless it is renewed.

    timeout: Timeout or 1..255 in second. Time after the last renewal; 0 means that there is no timeout
    """

    CODE: ClassVar[int] = 0x4003
    NAME: ClassVar[str] = "ReportTimeout"
    SERVICE: ClassVar[str] = "urn:jaus:jss:core:AccessControl"
    VERSION: ClassVar[str] = "1.1"
    IS_COMMAND: ClassVar[bool] = False

    class Timeout(IntEnum):
        """Values of Timeout."""

        TIMEOUT_FEATURE_DISABLED = 0

    timeout: ReportTimeout.Timeout | int

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(
            cls,
            (
                rt.Slot("timeout", "Timeout", rt.Number("B", rt.Values(ReportTimeout.Timeout, ((1, 255),)), "second")),
            ),
        )
