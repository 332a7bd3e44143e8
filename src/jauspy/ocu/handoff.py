"""Handoff of control between clients (EnhancedAccessControl and HandoffController of IOP v3)."""

from __future__ import annotations

import asyncio
from collections.abc import Mapping
from typing import Final

from jauspy.arguments import check_number, check_text
from jauspy.codec.message import Message
from jauspy.errors import ConfigError, ControlRejected, ResponseTimeout
from jauspy.ids import JausID
from jauspy.messages.iop import ConfirmHandoffRequest, RequestHandoff
from jauspy.ocu.connection import Connection
from jauspy.services.units import sent_text

Code = ConfirmHandoffRequest.ResponseCode
PENDING: Final = (Code.QUEUED, Code.DEFERRED)
"""Answers after which another one follows."""
REASONS: Final[Mapping[int, str]] = {
    Code.NOT_AVAILABLE: "it is not available for control now, or too many clients wait",
    Code.TIMEOUT: "the client in control did not answer in time",
    Code.DENIED: "the client in control refused, or nobody is in control: then request control itself",
    Code.INSUFFICIENT_AUTHORITY: "its default authority is higher than the one of the request",
}


async def request_handoff(
    connection: Connection, component: JausID, explanation: str, *, authority: int, within: float
) -> None:
    """Ask the client in control of a component to hand over, and wait for its decision.

    Afterwards this client has control until the component's time-out; take it by `control` with the same authority.
    Characters of the explanation that JAUS cannot send (not Latin-1) become question marks. Raises `ControlRejected`
    with the reason, and `ResponseTimeout` when the component does not answer, or nothing is decided `within` these
    seconds.
    """
    check_text(explanation, "the explanation of a handoff")
    check_number(authority, "authority", whole=True)
    if not 0 <= authority <= 255 or len(explanation) > 255:
        limits = "a handoff needs an authority of 0..255 and an explanation of up to 255 characters"
        raise ConfigError(f"{limits}, not {authority} and {len(explanation)} characters")
    decision: asyncio.Future[int] = asyncio.get_running_loop().create_future()

    def answered(message: Message, _: JausID) -> None:
        assert isinstance(message, ConfirmHandoffRequest)
        if message.response_code not in PENDING and not decision.done():
            decision.set_result(int(message.response_code))

    is_waiting = False
    with connection.replies.listening(component, answered, ConfirmHandoffRequest):
        try:
            async with asyncio.timeout(within):
                # resent until it is answered; a further request of a client that waits replaces the first one
                await connection.request(
                    component, RequestHandoff(authority, sent_text(explanation)), ConfirmHandoffRequest
                )
                is_waiting = True
                code = await decision
        except (TimeoutError, ResponseTimeout):
            if is_waiting:
                raise ResponseTimeout(f"nothing is decided on the handoff of {component} within {within:g} s") from None
            raise ResponseTimeout(
                f"{component} does not answer a request for handoff; check that it offers EnhancedAccessControl"
            ) from None
    if code != Code.GRANTED:
        raise ControlRejected(f"{component} did not hand control over: {REASONS.get(code, f'code {code}')}")
