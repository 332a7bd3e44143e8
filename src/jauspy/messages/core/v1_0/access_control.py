"""urn:jaus:jss:core:AccessControl 1.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from enum import IntEnum
from jauspy.codec import declare as jd

_SERVICE = jd.Service("urn:jaus:jss:core:AccessControl", "1.0")


@jd.message(_SERVICE, 0x000D, command=True)
class RequestControl(jd.Message):
    """RequestControl (0x000D): Asks for exclusive control, or renews it.

    authority_code: 0..255. Authority; the higher code wins, 0 is the lowest
    """
    authority_code: int = jd.field("AuthorityCode", jd.Number("B", jd.Values(None, ((0, 255),))))


@jd.message(_SERVICE, 0x000E, command=True)
class ReleaseControl(jd.Message):
    """ReleaseControl (0x000E): Gives up exclusive control."""


@jd.message(_SERVICE, 0x400D)
class ReportControl(jd.Message):
    """ReportControl (0x400D): Tells who controls the component.

    subsystem_id: Subsystem of the controlling client
    node_id: Node of the controlling client
    component_id: Component of the controlling client
    authority_code: 0..255. Authority; the higher code wins, 0 is the lowest
    """
    subsystem_id: int = jd.field("SubsystemID", jd.Number("H"))
    node_id: int = jd.field("NodeID", jd.Number("B"))
    component_id: int = jd.field("ComponentID", jd.Number("B"))
    authority_code: int = jd.field("AuthorityCode", jd.Number("B", jd.Values(None, ((0, 255),))))


@jd.message(_SERVICE, 0x200D, query=True)
class QueryControl(jd.Message):
    """QueryControl (0x200D): Asks who controls the component."""
    REPORT = ReportControl


@jd.message(_SERVICE, 0x4001)
class ReportAuthority(jd.Message):
    """ReportAuthority (0x4001): Tells the authority of the component.

    authority_code: 0..255. Authority; the higher code wins, 0 is the lowest
    """
    authority_code: int = jd.field("AuthorityCode", jd.Number("B", jd.Values(None, ((0, 255),))))


@jd.message(_SERVICE, 0x2001, query=True)
class QueryAuthority(jd.Message):
    """QueryAuthority (0x2001): Asks for the authority of the component."""
    REPORT = ReportAuthority


@jd.message(_SERVICE, 0x0001, command=True)
class SetAuthority(jd.Message):
    """SetAuthority (0x0001): Sets the authority of the controlling client.

    authority_code: 0..255. Authority; the higher code wins, 0 is the lowest
    """
    authority_code: int = jd.field("AuthorityCode", jd.Number("B", jd.Values(None, ((0, 255),))))


@jd.message(_SERVICE, 0x4003)
class ReportTimeout(jd.Message):
    """ReportTimeout (0x4003): Tells after how long control ends unless it is renewed.

    timeout: Timeout or 1..255 in second. Time after the last renewal; 0 means that there is no timeout
    """

    class Timeout(IntEnum):
        TIMEOUT_FEATURE_DISABLED = 0

    timeout: ReportTimeout.Timeout | int = jd.field("Timeout", lambda: jd.Number("B", jd.Values(ReportTimeout.Timeout, ((1, 255),)), "second"))


@jd.message(_SERVICE, 0x2003, query=True)
class QueryTimeout(jd.Message):
    """QueryTimeout (0x2003): Asks after how long control ends unless it is renewed."""
    REPORT = ReportTimeout


@jd.message(_SERVICE, 0x0010)
class RejectControl(jd.Message):
    """RejectControl (0x0010): Tells a client that it has lost or released control, or that releasing is not possible.

    response_code: ResponseCode. Whether control is released, or cannot be
    """

    class ResponseCode(IntEnum):
        CONTROL_RELEASED = 0
        NOT_AVAILABLE = 1

    response_code: RejectControl.ResponseCode | int = jd.field("ResponseCode", lambda: jd.Number("B", jd.Values(RejectControl.ResponseCode)))


@jd.message(_SERVICE, 0x000F)
class ConfirmControl(jd.Message):
    """ConfirmControl (0x000F): Answers a request for control.

    response_code: ResponseCode. Whether control is granted, and if not, why
    """

    class ResponseCode(IntEnum):
        CONTROL_ACCEPTED = 0
        NOT_AVAILABLE = 1
        INSUFFICIENT_AUTHORITY = 2

    response_code: ConfirmControl.ResponseCode | int = jd.field("ResponseCode", lambda: jd.Number("B", jd.Values(ConfirmControl.ResponseCode)))
