"""urn:jaus:jss:iop:EnhancedAccessControl 1.1. Generated from schemas/; do not edit."""

from __future__ import annotations

from enum import IntEnum
from jauspy.codec import declare as jd
from jauspy.messages.iop.v1_0 import types as iop_v1_0_types

_SERVICE = jd.Service("urn:jaus:jss:iop:EnhancedAccessControl", "1.1")


@jd.message(_SERVICE, 0xFF31, command=True)
class RequestHandoff(jd.Message):
    """RequestHandoff (0xFF31): Asks for control to be handed over.

    authority_code: 0..255. Authority of the asking client
    explanation: up to 255 characters. Why control is wanted, for people
    """
    authority_code: int = jd.field("AuthorityCode", jd.Number("B", jd.Values(None, ((0, 255),))))
    explanation: str = jd.field("Explanation", jd.Text(count=jd.Count("B", 0, 255)))


@jd.message(_SERVICE, 0xFF36)
class ReportHandoffTimeout(jd.Message):
    """ReportHandoffTimeout (0xFF36): Tells the timeout of handoff requests.

    timeout: in second. Timeout of handoff requests, in seconds
    """
    timeout: int = jd.field("Timeout", jd.Number("B", jd.ANY, "second"))


@jd.message(_SERVICE, 0xFF32, query=True)
class QueryHandoffTimeout(jd.Message):
    """QueryHandoffTimeout (0xFF32): Asks for the timeout of handoff requests."""
    REPORT = ReportHandoffTimeout


@jd.message(_SERVICE, 0xFF37)
class ReportEnhancedTimeout(jd.Message):
    """ReportEnhancedTimeout (0xFF37): Tells the timeout of enhanced access control.

    timeout: in second. Timeout of enhanced access control, in seconds
    """
    timeout: int = jd.field("Timeout", jd.Number("B", jd.ANY, "second"))


@jd.message(_SERVICE, 0xFF33, query=True)
class QueryEnhancedTimeout(jd.Message):
    """QueryEnhancedTimeout (0xFF33): Asks for the timeout of enhanced access control."""
    REPORT = ReportEnhancedTimeout


@jd.message(_SERVICE, 0xFF34, command=True)
class RemoveHandoffRequest(jd.Message):
    """RemoveHandoffRequest (0xFF34): Takes back a request for control.

    id: 0..255. Number of the request
    """
    id: int = jd.field("ID", jd.Number("B", jd.Values(None, ((0, 255),))))


@jd.message(_SERVICE, 0xFF39)
class ConfirmReleaseControl(jd.Message):
    """ConfirmReleaseControl (0xFF39): Tells whether the controlling client hands over.

    release_control_list: 0..255 items. The requests
    """
    ReleaseControlRec = iop_v1_0_types.ReleaseControlRec
    release_control_list: list[iop_v1_0_types.ReleaseControlRec] = jd.field("ReleaseControlList", lambda: jd.Repeat(jd.Count("B", 0, 255), iop_v1_0_types.ReleaseControlRec.layout()))


@jd.message(_SERVICE, 0xFF35)
class ConfirmHandoffRequest(jd.Message):
    """ConfirmHandoffRequest (0xFF35): Tells what has become of a request for control.

    id: 0..255. Number of the request
    response_code: ResponseCode. What has become of the request
    """

    class ResponseCode(IntEnum):
        GRANTED = 0
        NOT_AVAILABLE = 1
        TIMEOUT = 2
        DENIED = 3
        QUEUED = 4
        DEFERRED = 5
        INSUFFICIENT_AUTHORITY = 6

    id: int = jd.field("ID", jd.Number("B", jd.Values(None, ((0, 255),))))
    response_code: ConfirmHandoffRequest.ResponseCode | int = jd.field("ResponseCode", lambda: jd.Number("B", jd.Values(ConfirmHandoffRequest.ResponseCode)))
