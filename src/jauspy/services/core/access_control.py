"""AccessControl: at most one client is in control, by authority, as long as it repeats its request (AS5710)."""

from __future__ import annotations

from typing import Final

from jauspy.arguments import check_number
from jauspy.codec.message import Message
from jauspy.errors import ConfigError
from jauspy.ids import JausID
from jauspy.messages.core import (
    ConfirmControl,
    RejectControl,
    ReportAuthority,
    ReportControl,
    ReportTimeout,
    RequestControl,
    SetAuthority,
    SetEmergency,
    Standby,
)
from jauspy.protocol.seal import Operator
from jauspy.services.service import Service, ServiceHost

_TIMER: Final = "access control"
_NO_CLIENT: Final = JausID(0, 0, 0)
_STATES_WITHOUT_CONTROL: Final = frozenset({"Init", "Failure", "Shutdown", "Emergency"})
"""States in which nobody can take control."""
HIGHEST_AUTHORITY: Final = 255
STOPS: Final = frozenset({Standby.CODE, SetEmergency.CODE})
"""Commands that stop a robot and move nothing; they need no seal of an operator."""


MAY_MOVE: Final = ("Controlled", "Available", "Ready")
"""The nested states in which a client in control may cause motion."""
WAITS: Final = ("NotControlled", "Available")
"""The nested states of a component that works and that nobody controls."""


def may_move(host: ServiceHost) -> bool:
    """True while a client is in control and has resumed the component."""
    return _is_in(host, MAY_MOVE)


def waits_for_control(host: ServiceHost) -> bool:
    """True while nobody controls the component, and anybody could: it is in no emergency, and has not failed."""
    return _is_in(host, WAITS)


def _is_in(host: ServiceHost, states: tuple[str, ...]) -> bool:
    path = host.path
    return any(path[start : start + len(states)] == states for start in range(len(path)))


def present_authority(host: ServiceHost) -> int:
    """The authority of the client in control; the highest one in a component without access control."""
    access = host.service(AccessControl)
    return HIGHEST_AUTHORITY if access is None else access.authority


class AccessControl(Service, urn="urn:jaus:jss:core:AccessControl"):
    """Exclusive control over all services of the component.

    A client that seals its commands (`CommandSeal`) has control for its operator, and at most the authority of that
    operator's role.

    `default_authority`: 0..255, the minimum that a client needs. `timeout`: whole seconds, 1..255, within which the
    client must request control again; 0 never times out.
    """

    def __init__(self, *, default_authority: int = 1, timeout: int = 5) -> None:
        for name, value in (("default_authority", default_authority), ("timeout", timeout)):
            check_number(value, f"access control: {name}", whole=True)
            if not 0 <= value <= 255:
                raise ConfigError(f"access control: {name} is {value}; it must be 0..255")
        self.default_authority = default_authority
        self.timeout = timeout
        self.authority = default_authority
        self._operator: Operator | None = None
        self._timeout_event = "Timedout"

    @property
    def controller(self) -> JausID | None:
        """The client in control."""
        return self.host.controller

    def attached(self) -> None:
        """Select the name of the time-out event: `Timedout`, in 1.0 `Timeout`, which in 1.1 ends a subscription."""
        if self.host.definitions[self.urn].version == "1.0":
            self._timeout_event = "Timeout"

    # --- actions

    def init(self) -> None:
        """Clear the controller."""
        self.authority = self.default_authority
        self.host.cancel_timer(_TIMER)
        self._set_controller(None)

    def store_address(self, source: JausID) -> None:
        """Give control to `source`."""
        self._set_controller(source, self.host.operator)

    def set_authority(self, msg: RequestControl | SetAuthority) -> None:
        """Set the authority of the controlling client."""
        self.authority = self._asked(msg)

    def reset_timer(self) -> None:
        """Restart the time-out of the controlling client."""
        if self.timeout:
            self.host.set_timer(_TIMER, self.host.now + self.timeout, self._time_out)

    def leaving(self) -> None:
        """Time out control, which notifies the client; in an emergency it stays in control until its time-out."""
        self.host.fire(self._timeout_event)

    def _time_out(self) -> None:
        # In Emergency the event Timedout is ignored, so the timer is restarted; a dead client is dropped afterwards.
        self.reset_timer()
        self.host.fire(self._timeout_event)

    def client_lost(self, client: JausID) -> None:
        """Time out control when the controlling client is lost."""
        if client == self.controller:
            self.host.fire(self._timeout_event)

    def hand_over(self, client: JausID, authority: int, operator: Operator | None) -> None:
        """Give control to a client to which the one in control has granted it; `operator` sealed its request."""
        loser, self.authority = self.controller, authority
        self._set_controller(client, operator)
        self.reset_timer()
        if loser is not None:
            self.host.send(loser, RejectControl(response_code=RejectControl.ResponseCode.CONTROL_RELEASED))

    def _set_controller(self, client: JausID | None, operator: Operator | None = None) -> None:
        before, self.host.controller = self.host.controller, client
        of_before, self._operator = self._operator, operator
        if before is not None and (before != client or of_before is not self._operator):
            self.host.control_lost()
        elif before is None and client is not None:
            self.host.control_taken()

    def _asked(self, msg: RequestControl | SetAuthority) -> int:
        """The requested authority, limited to that of the operator's role."""
        operator = self.host.operator
        return msg.authority_code if operator is None else min(msg.authority_code, operator.authority)

    # --- predicates

    def is_control_available(self) -> bool:
        """The state allows control (a predicate of 1.0; 1.1 has states for it)."""
        return not _STATES_WITHOUT_CONTROL.intersection(self.host.path)

    def is_controlling_client(self, msg: object, source: JausID) -> bool:
        """The sender is in control, for the operator who sealed this; for a stop the id suffices."""
        if self.controller != source:
            return False
        return self._operator is self.host.operator or getattr(msg, "CODE", None) in STOPS

    def is_default_authority_greater(self, msg: RequestControl) -> bool:
        """The request has less than the default authority."""
        return self.default_authority > self._asked(msg)

    def is_current_authority_less(self, msg: RequestControl) -> bool:
        """The request has a higher authority than the controlling client."""
        return self.authority < self._asked(msg)

    def is_authority_valid(self, msg: SetAuthority) -> bool:
        """A client may lower its authority, down to the default one."""
        return self.default_authority <= self._asked(msg) <= self.authority

    # --- reports

    def confirm_control(self, code: str) -> ConfirmControl:
        """The answer to a request."""
        return ConfirmControl(response_code=ConfirmControl.ResponseCode[code])

    def reject_control(self, msg: object, source: JausID | None, code: str) -> RejectControl | None:
        """Control was released or lost. A client that loses it to another one is notified (1.0: the other)."""
        answer = RejectControl(response_code=RejectControl.ResponseCode[code])
        loser = self.controller
        if isinstance(msg, Message) and msg.CODE == RequestControl.CODE and loser not in (None, source):
            assert loser is not None
            self.host.send(loser, answer)
            return None
        return answer

    def report_control(self) -> ReportControl:
        """The client in control; all zero for none."""
        client = self.controller
        return ReportControl(
            subsystem_id=(client or _NO_CLIENT).subsystem,
            node_id=(client or _NO_CLIENT).node,
            component_id=(client or _NO_CLIENT).component,
            authority_code=self.authority if client else 0,
        )

    def report_authority(self) -> ReportAuthority:
        """The authority needed to take control: of the client in control, else the default."""
        return ReportAuthority(authority_code=self.authority)

    def report_timeout(self) -> ReportTimeout:
        """The time-out in seconds; 0 when control never times out."""
        return ReportTimeout(timeout=self.timeout)
