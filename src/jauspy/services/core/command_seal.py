"""CommandSeal: commands that operators have signed, and what an operator's role allows. See docs/security.md."""

from __future__ import annotations

import hashlib
from collections import Counter, OrderedDict
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from datetime import datetime
from typing import Final, NamedTuple

from jauspy.codec.message import Message
from jauspy.errors import ConfigError
from jauspy.ids import JausID, message_id
from jauspy.logs import get_logger
from jauspy.messages.core import CancelEvent, CreateCommandEvent, CreateEvent, RegisterServices, UpdateEvent
from jauspy.messages.operators import RejectCommand, ReportSealChallenge, SealedCommand
from jauspy.protocol.duplicates import ReplayWindow
from jauspy.protocol.seal import Operator
from jauspy.services.core.access_control import STOPS
from jauspy.services.core.command_events import encoded
from jauspy.services.service import Service
from jauspy.services.state_machine import TriggerOutcome

_LOG: Final = get_logger("jauspy.operators")

MAX_AGE: Final = 2.0
"""Seconds from the sealing of a command to its arrival, including the transmission of the challenge."""
MAX_AHEAD: Final = 0.5
"""Seconds by which a client's clock may run ahead of this one within the lifetime of a challenge."""
CHALLENGE_LIFETIME: Final = 600.0
"""Seconds that a client may use a challenge."""
MAX_CLIENTS: Final = 256
"""Clients whose latest counters are stored; each is dropped once all of its seals have expired."""
MAX_CLIENTS_OF_OPERATOR: Final = 32
MAX_REJECTS: Final = 10
"""Replies to refused commands in a second, so that forged source ids cannot be used to flood others."""
MIN_SECRET: Final = 16

Reason = RejectCommand.Reason

OPEN_COMMANDS: Final = frozenset(message.CODE for message in (CreateEvent, UpdateEvent, CancelEvent, RegisterServices))
"""Commands that need no seal: subscriptions to queries, and the lists of services of other components."""
_REPORT_CODES: Final = range(0x4000, 0x6000)
_REPORT_NAMES: Final = ("Report", "Confirm", "Reject")

_EXPLAINED: Final[dict[int, str]] = {
    Reason.NO_SEAL: "it has no seal, and this component takes commands of operators only (require_operator)",
    Reason.OTHER_DESTINATION: "it was sealed for another component",
    Reason.OTHER_SOURCE: "it was sealed by a component with another id",
    Reason.UNKNOWN_OPERATOR: "its key is not in the operators file",
    Reason.UNKNOWN_CHALLENGE: "its challenge is not of this component, or from before a restart",
    Reason.STALE: f"it was sealed more than {MAX_AGE:g} s ago",
    Reason.FORGED: "its signature is wrong",
    Reason.REPLAYED: "it was received before",
    Reason.TOO_MANY_CLIENTS: "too many clients of this operator are active",
    Reason.ROLE_TOO_LOW: "the role of its operator may not command",
    Reason.NOT_A_COMMAND: "what is in the seal is no message that this component takes",
}


def explained(reason: int) -> str:
    """Reason why a command was refused, as part of a sentence."""
    return _EXPLAINED.get(reason, f"reason {reason}")


@dataclass(frozen=True, slots=True)
class CommandRecord:
    """One command that was received, for an audit log."""

    time: datetime
    component: JausID
    source: JausID
    operator: Operator | None
    """None without a valid seal."""
    message: str
    payload: bytes
    """Payload as received, with the seal."""
    outcome: str
    """`taken`, `ignored` or `failed` by the state machine, or `refused: REASON`."""


class CommandSeal(Service, urn="urn:jauspy:operators:CommandSeal"):
    """Opens sealed commands before they reach the state machines; with `required`, refuses all others but stops.

    Standby and SetEmergency act without a valid seal, too, so that nobody can prevent a stop. `secret` is a random
    number of 16 bytes or more, new with each start. `audit` is called with each received command and its outcome.
    """

    def __init__(
        self,
        operators: Iterable[Operator],
        *,
        secret: bytes,
        required: bool = True,
        audit: Callable[[CommandRecord], None] | None = None,
    ) -> None:
        if len(secret) < MIN_SECRET:
            raise ConfigError(f"the secret of CommandSeal has {len(secret)} bytes; it must have {MIN_SECRET} or more")
        self.required = required
        self._operators = {operator.key.id: operator for operator in operators}
        self._secret = secret
        self._audit = audit
        self._last_challenge = 0
        self._clients: OrderedDict[tuple[int, int, int], _Client] = OrderedDict()
        self._rejects = (0, 0)
        self._refused: Counter[Reason] = Counter()
        self._pending: _Received | None = None

    def attached(self) -> None:
        """Set `admit` as the filter of received messages."""
        self.host.admission = self

    # --- challenges

    def report_seal_challenge(self, source: JausID) -> ReportSealChallenge:
        """A challenge for this client. It is not stored: its tag identifies it and the client."""
        self._last_challenge = max(self._last_challenge + 1, int(self.host.now * 1e6))
        return ReportSealChallenge(self._last_challenge, self._tag(int(source), self._last_challenge))

    def _tag(self, source: int, time: int) -> int:
        text = source.to_bytes(4, "big") + time.to_bytes(8, "big")
        return int.from_bytes(hashlib.blake2b(text, key=self._secret[:64], digest_size=8).digest(), "big")

    # --- received messages

    def admit(self, message: Message, payload: bytes, source: JausID) -> Message | None:
        """The message that the state machines are to handle: the one inside a seal; None when it is refused."""
        self._pending = None
        if not isinstance(message, SealedCommand):
            if _is_open(message) or self.host.is_query(message):
                return message
            return self._decide(_Received(message, payload, source), Reason.NO_SEAL if self.required else None)
        reason = self._check(message, payload, source)
        operator = None if reason else self._operators[message.operator_key]
        command = self.host.open(message.command, source)
        received = _Received(command or message, payload, source, operator, message.counter)
        if command is None or isinstance(command, SealedCommand):
            self._refuse(received, Reason.NOT_A_COMMAND)
            return None
        if operator is not None and not (operator.authority or _is_open(command)):
            reason = Reason.ROLE_TOO_LOW
        return self._decide(received, reason)

    def _decide(self, received: _Received, reason: Reason | None) -> Message | None:
        if reason is None:
            self.host.operator = received.operator
        elif not is_stop(received.command):
            self._refuse(received, reason)
            return None
        else:
            self.host.count("stop_without_seal", f"{received.command.NAME} of {received.source}: {explained(reason)}")
        self._pending = received
        return received.command

    def handled(self, outcome: TriggerOutcome) -> None:
        """Called with the outcome of the message that `admit` returned."""
        pending, self._pending = self._pending, None
        if pending is not None:
            self._record(pending, outcome.value)

    def _check(self, sealed: SealedCommand, payload: bytes, source: JausID) -> Reason | None:
        """The fault of a seal, if any; the signature is checked last, since that takes most time."""
        operator = self._operators.get(sealed.operator_key)
        age = self.host.now - sealed.challenge_time / 1e6
        if sealed.destination != int(self.host.id):
            return Reason.OTHER_DESTINATION
        if sealed.source != int(source):
            return Reason.OTHER_SOURCE
        if operator is None:
            return Reason.UNKNOWN_OPERATOR
        if sealed.challenge_tag != self._tag(sealed.source, sealed.challenge_time) or age > CHALLENGE_LIFETIME:
            return Reason.UNKNOWN_CHALLENGE
        if not -MAX_AHEAD <= age - sealed.elapsed / 1000 <= MAX_AGE:
            return Reason.STALE
        key = (sealed.operator_key, sealed.source, sealed.challenge_time)
        client = self._clients.get(key) or _Client()
        if not client.window.is_new(sealed.counter):
            return Reason.REPLAYED
        if not operator.key.has_signed(payload):
            return Reason.FORGED
        if client.used_at is None and not self._has_room(sealed.operator_key):
            return Reason.TOO_MANY_CLIENTS
        client.window.add(sealed.counter)
        client.used_at = self.host.now
        self._clients[key] = client
        self._clients.move_to_end(key)
        return None

    def _has_room(self, operator_key: int) -> bool:
        """True when one more client can be stored; clients whose seals have all expired are dropped."""
        while self._clients:
            key, client = next(iter(self._clients.items()))
            if client.used_at is not None and self.host.now - client.used_at <= MAX_AGE + MAX_AHEAD:
                break
            del self._clients[key]
        of_operator = sum(key[0] == operator_key for key in self._clients)
        return len(self._clients) < MAX_CLIENTS and of_operator < MAX_CLIENTS_OF_OPERATOR

    # --- refusals

    def _refuse(self, received: _Received, reason: Reason) -> None:
        """Count, log the 1st, 2nd, 4th, 8th ... time, tell the sender, and record it."""
        name, source = received.command.NAME, received.source
        self.host.count(f"refused.{reason.name.lower()}", f"{name} of {source}")
        self._refused[reason] += 1
        times = self._refused[reason]
        if times & (times - 1) == 0:
            again = f" ({times} times)" if times > 1 else ""
            _LOG.warning("%s refused %s of %s%s: %s", self.host.id, name, source, again, explained(reason))
        second, sent = self._rejects
        if int(self.host.now) != second:
            second, sent = int(self.host.now), 0
        if sent < MAX_REJECTS:
            self.host.send(source, RejectCommand(received.command.CODE, received.counter, reason))
        self._rejects = (second, sent + 1)
        self._record(received, f"refused: {reason.name}")

    def _record(self, received: _Received, outcome: str) -> None:
        if self._audit is not None:
            command, payload, source, operator, _ = received
            now = self.host.utc_now()
            self._audit(
                CommandRecord(
                    time=now,
                    component=self.host.id,
                    source=source,
                    operator=operator,
                    message=command.NAME,
                    payload=payload,
                    outcome=outcome,
                )
            )


class _Received(NamedTuple):
    """A command that was received; the one inside, with its operator, when it has a valid seal."""

    command: Message
    payload: bytes
    source: JausID
    operator: Operator | None = None
    counter: int = 0


class _Client:
    """The counters of one challenge that an operator has used."""

    __slots__ = ("used_at", "window")

    def __init__(self) -> None:
        self.window = ReplayWindow()
        self.used_at: float | None = None


def _is_open(message: Message) -> bool:
    """True for messages that any client may send: queries, reports and `OPEN_COMMANDS`."""
    if message.IS_COMMAND:
        return message.CODE in OPEN_COMMANDS
    return message.IS_QUERY or message.CODE in _REPORT_CODES or message.NAME.startswith(_REPORT_NAMES)


def is_stop(message: Message) -> bool:
    """True for a stop, and for a command event with one."""
    if isinstance(message, CreateCommandEvent):
        return message_id(encoded(message.command_message)) in STOPS
    return message.CODE in STOPS


def needs_seal(message: Message) -> bool:
    """True for a message that the program of an operator seals: commands, except of subscriptions."""
    return not _is_open(message)
