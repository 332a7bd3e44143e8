"""EnhancedAccessControl and HandoffController: a client asks the one in control to hand over (IOP v3).

The component queues requests and shows them to the client in control, which grants, refuses or puts off each of them.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass, replace
from typing import Final

from jauspy.arguments import check_number
from jauspy.codec.message import Message
from jauspy.errors import ConfigError
from jauspy.ids import JausID
from jauspy.messages.iop import (
    ConfirmHandoffRequest,
    ConfirmReleaseControl,
    ReleaseControlRec,
    RemoveHandoffRequest,
    ReportEnhancedTimeout,
    ReportHandoffTimeout,
    RequestHandoff,
    RequestReleaseControl,
)
from jauspy.protocol.seal import Operator
from jauspy.services.core import AccessControl
from jauspy.services.service import Service, ServiceHost

MAX_REQUESTS: Final = 16
"""Clients that may wait for control of one component."""
Code = ConfirmHandoffRequest.ResponseCode
Decision = ReleaseControlRec.ResponseCode
"""What the client in control decides: GRANTED, DENIED or WAIT."""


@dataclass(frozen=True, slots=True)
class HandoffRequest:
    """A request for control that waits: its number at the component, and who asks why."""

    id: int
    client: JausID
    authority: int
    explanation: str
    """Text of the asking client, for people."""
    operator: Operator | None = None
    """The operator who sealed the request."""


class EnhancedAccessControl(Service, urn="urn:jaus:jss:iop:EnhancedAccessControl"):
    """Queues requests for control and hands it over once the client in control has granted one.

    `handoff_timeout`: whole seconds, 1..255, after which a request that nobody has answered ends. `enhanced_timeout`:
    seconds for which one that was put off goes on waiting. Handing over stops all motion, like any loss of control.
    Lists of requests and decisions are resent until they are acknowledged.
    """

    def __init__(self, *, handoff_timeout: int = 15, enhanced_timeout: int = 60) -> None:
        for name, value in (("handoff_timeout", handoff_timeout), ("enhanced_timeout", enhanced_timeout)):
            check_number(value, f"enhanced access control: {name}", whole=True)
            if not 1 <= value <= 255:
                raise ConfigError(f"enhanced access control: {name} is {value}; it must be 1..255")
        self.handoff_timeout = handoff_timeout
        self.enhanced_timeout = enhanced_timeout
        self._requests: dict[JausID, HandoffRequest] = {}
        self._removed = 0
        """Number of the request that was removed last, for its confirmation."""
        self._next = 0

    @property
    def requests(self) -> tuple[HandoffRequest, ...]:
        """The requests that wait, oldest first."""
        return tuple(self._requests.values())

    # --- predicates

    def is_queued(self, source: JausID) -> bool:
        """The sender waits for control."""
        return source in self._requests

    # --- actions

    def queue_handoff_request(self, msg: RequestHandoff, source: JausID) -> ConfirmHandoffRequest:
        """Queue a request, unless too many wait."""
        if len(self._requests) >= MAX_REQUESTS:
            self.host.count("handoff_not_queued", f"that of {source}")
            return ConfirmHandoffRequest(id=0, response_code=Code.NOT_AVAILABLE)
        return self._keep(HandoffRequest(self._free_id(), source, 0, ""), msg)

    def update_handoff_request(self, msg: RequestHandoff, source: JausID) -> ConfirmHandoffRequest:
        """Replace the request of a client that waits."""
        return self._keep(self._requests[source], msg)

    def remove_handoff_request(self, source: JausID) -> None:
        """Remove the request of a client."""
        self._removed = self._remove(source)

    def send_confirm_handoff_request(
        self, code: str, msg: RequestHandoff | RemoveHandoffRequest
    ) -> ConfirmHandoffRequest:
        """The answer to a request that is not queued, or is no longer."""
        id, self._removed = self._removed, 0
        return ConfirmHandoffRequest(
            id=msg.id if isinstance(msg, RemoveHandoffRequest) else id,
            response_code=ConfirmHandoffRequest.ResponseCode[code],
        )

    def send_request_release_control(self) -> None:
        """Show all requests to the client in control."""
        controller = self.host.controller
        if controller is None:
            return
        listed = [
            RequestReleaseControl.RequestReleaseControlRec(
                id=request.id,
                src_subsystem_id=request.client.subsystem,
                src_node_id=request.client.node,
                src_component_id=request.client.component,
                authority_code=request.authority,
                explanation=request.explanation,
            )
            for request in self._requests.values()
        ]
        deliver(self.host, controller, RequestReleaseControl(listed))

    def process_handoff_response(self, msg: ConfirmReleaseControl) -> None:
        """Carry out the decisions of the client in control; of several grants the first counts."""
        by_id = {request.id: request for request in self._requests.values()}
        granted = None
        for decision in msg.release_control_list:
            request = by_id.pop(decision.id, None)
            if request is None:
                self.host.count("handoff_unknown", f"request {decision.id}")
            elif decision.response_code == Decision.WAIT:
                self._wait(request, self.enhanced_timeout)
                self._tell(request, Code.DEFERRED)
            elif decision.response_code == Decision.GRANTED and granted is None:
                granted = request
            else:
                self._end(request, Code.DENIED)
        if granted is not None:
            self._hand_over(granted)

    def control_lost(self) -> None:
        """Show the requests to the next client in control; without one they end: control can be requested."""
        if self.host.controller is None:
            for request in self.requests:
                self._end(request, Code.DENIED)
        elif self._requests:
            self._remove(self.host.controller)
            self.send_request_release_control()

    def client_lost(self, client: JausID) -> None:
        """Remove the request of a client that is lost."""
        self._remove(client)

    # --- reports

    def send_report_handoff_timeout(self) -> ReportHandoffTimeout:
        """Seconds until a request ends that nobody answers."""
        return ReportHandoffTimeout(timeout=self.handoff_timeout)

    def send_report_enhanced_timeout(self) -> ReportEnhancedTimeout:
        """Seconds until a request ends that was put off."""
        return ReportEnhancedTimeout(timeout=self.enhanced_timeout)

    # --- inside

    def _keep(self, request: HandoffRequest, msg: RequestHandoff) -> ConfirmHandoffRequest:
        operator = self.host.operator
        authority = msg.authority_code if operator is None else min(msg.authority_code, operator.authority)
        kept = replace(request, authority=authority, explanation=msg.explanation, operator=operator)
        self._requests[request.client] = kept
        self._wait(kept, self.handoff_timeout)
        return ConfirmHandoffRequest(id=kept.id, response_code=Code.QUEUED)

    def _free_id(self) -> int:
        taken = {request.id for request in self._requests.values()}
        self._next = next(id for id in ((self._next + step) % 255 + 1 for step in range(255)) if id not in taken)
        return self._next

    def _wait(self, request: HandoffRequest, seconds: float) -> None:
        due = self.host.now + seconds
        self.host.set_timer(self._timer(request), due, lambda: self._end(request, Code.TIMEOUT))

    def _timer(self, request: HandoffRequest) -> tuple[str, int]:
        return ("handoff request", request.id)

    def _hand_over(self, request: HandoffRequest) -> None:
        access = self.host.service(AccessControl)
        assert access is not None  # this service inherits from it
        self._end(request, Code.GRANTED)
        access.hand_over(request.client, request.authority, request.operator)

    def _end(self, request: HandoffRequest, code: ConfirmHandoffRequest.ResponseCode) -> None:
        self._remove(request.client)
        self._tell(request, code)

    def _tell(self, request: HandoffRequest, code: ConfirmHandoffRequest.ResponseCode) -> None:
        deliver(self.host, request.client, ConfirmHandoffRequest(id=request.id, response_code=code))

    def _remove(self, client: JausID) -> int:
        """Remove a request; its number, or 0."""
        request = self._requests.pop(client, None)
        if request is None:
            return 0
        self.host.cancel_timer(self._timer(request))
        return request.id


DecideHandoff = Callable[[JausID, HandoffRequest], "Decision | None"]
"""Decides on a request of the component with this id; None leaves it until `HandoffController.answer`."""


def leave_open(component: JausID, request: HandoffRequest) -> Decision | None:  # noqa: ARG001 - the same for all
    """Decide nothing: the request times out at the component."""
    return None


class HandoffController(Service, urn="urn:jaus:jss:iop:HandoffController"):
    """The client's side: shows requests for control to `decide`, and sends what it decides.

    Without `decide` requests are left alone until they time out at the component. It needs a service beside it that
    inherits from Events, such as Liveness: its definition has transitions only for states inside `Receiving`.
    """

    def __init__(self, decide: DecideHandoff = leave_open) -> None:
        self.decide = decide

    def process_handoff_requests(self, msg: RequestReleaseControl, source: JausID) -> None:
        """Decide on each request that the component shows."""
        decided = [
            (request.id, decision)
            for request in map(_request, msg.request_release_control_list[:MAX_REQUESTS])
            if (decision := self.decide(source, request)) is not None
        ]
        if decided:
            self._send(source, decided)

    def process_confirm_handoff_request(self, msg: ConfirmHandoffRequest, source: JausID) -> None:
        """Count an answer that came when nobody waited for it."""
        self.host.count("handoff_unawaited", f"{msg.response_code} of {source}")

    def process_report_handoff_timeout(self, source: JausID) -> None:
        """Count a report that nobody waited for."""
        self.host.count("handoff_unawaited", f"a time-out of {source}")

    def process_report_enhanced_timeout(self, source: JausID) -> None:
        """Count a report that nobody waited for."""
        self.host.count("handoff_unawaited", f"a time-out of {source}")

    def answer(self, component: JausID, id: int, decision: Decision) -> None:
        """Decide on a request that `decide` has left."""
        self._send(component, [(id, decision)])

    def _send(self, component: JausID, decisions: Iterable[tuple[int, Decision]]) -> None:
        listed = [ReleaseControlRec(id=id, response_code=code) for id, code in decisions]
        deliver(self.host, component, ConfirmReleaseControl(listed))


def deliver(host: ServiceHost, destination: JausID, message: Message) -> None:
    """Send a message, resent until it is acknowledged; what is not is counted."""

    def ended(delivered: bool) -> None:
        if not delivered:
            host.count("handoff_not_delivered", f"{message.NAME} to {destination}")

    host.send(destination, message, on_acknowledged=ended)


def _request(record: RequestReleaseControl.RequestReleaseControlRec) -> HandoffRequest:
    client = JausID(record.src_subsystem_id, record.src_node_id, record.src_component_id)
    return HandoffRequest(record.id, client, record.authority_code, record.explanation)
