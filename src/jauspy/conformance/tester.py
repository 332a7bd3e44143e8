"""The tester that runs steps, its clients, and the messages that they expect."""

from __future__ import annotations

import math
from collections import deque
from collections.abc import Callable, Collection, Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from typing import Any, Final, Generic, NamedTuple, TypeAlias, TypeVar

from jauspy.codec.message import Message
from jauspy.codec.registry import Registry
from jauspy.conformance.checks import Check
from jauspy.conformance.link import Arrival, TesterLink
from jauspy.conformance.results import CheckResult, Failed, Late, Malformed, Silent, Skipped, StepOutcome
from jauspy.conformance.trace import DatagramTrace, Direction, ReceivedMessage, TraceEntry, message_name
from jauspy.errors import ConfigError, DecodeError, TransportError
from jauspy.ids import EVERYONE, JausID, message_id
from jauspy.messages.core import (
    AllEventsRec,
    CommandEvent,
    ConfirmControl,
    ConfirmEventRequest,
    Event,
    QueryControl,
    QueryEvents,
    QueryHeartbeatPulse,
    QueryIdentification,
    QueryStatus,
    RejectControl,
)
from jauspy.messages.environment_sensing.v2_0.range_sensor import ConfirmSensorConfiguration
from jauspy.protocol import judp
from jauspy.protocol.endpoint import Endpoint
from jauspy.protocol.header import Ack, Broadcast, Packet

M = TypeVar("M", bound=Message)

CONTROLLER, OTHER_CLIENT = "controller", "other client"
EMERGENCY_CLIENT, OBSERVER = "emergency client", "observer"
CLIENTS: Final[Mapping[str, str]] = {
    CONTROLLER: "42.2.1",
    OTHER_CLIENT: "42.2.2",
    EMERGENCY_CLIENT: "42.2.4",
    OBSERVER: "42.2.9",
}
"""Ids of clients by role: in control, not in control, sets emergencies, sends only queries."""

HARMLESS_QUERIES: Final[tuple[Message, ...]] = (
    QueryEvents(AllEventsRec(0)),
    QueryHeartbeatPulse(),
    QueryStatus(),
    QueryControl(),
    QueryIdentification(4),
)
"""Queries that change nothing, to test whether a target answers. Nearly every component has Events."""


class Expectation(Generic[M]):
    """One message of a kind that passes all checks.

    With a wildcard as source one right answer is enough; else the first answer decides. `source` is
    the target, or the component that was queried.
    """

    def __init__(
        self,
        client: Client,
        kind: type[M],
        checks: Sequence[Check],
        where: Callable[[M], bool],
        source: JausID | None = None,
        *,
        broadcast: bool = True,
    ) -> None:
        self._client = client
        self._takes_broadcast = broadcast
        self._tester = client.tester
        self._kind = kind
        self._checks = checks
        self._where = where
        self._source = source or client.tester.target
        self._seconds = 0.0
        self._outcome: StepOutcome | None = None
        self._results: list[CheckResult] = []
        self._found: tuple[ReceivedMessage, M] | None = None

    def wait(self, seconds: float) -> M:
        """Return the message. Raises `StepOutcome` if none fits; one that comes within twice the time is late."""
        self._seconds = seconds
        tester, deadline = self._tester, self._tester.now + seconds
        tester.expected.append(" and ".join((message_name(self._kind), *(check.name for check in self._checks))))
        tester.pump(deadline, self._process_pending)
        if self._found is None and (self._outcome is None or self._source.is_wildcard):
            tester.pump(deadline + seconds, self._process_pending)
        comes = f"{message_name(self._kind)} comes"
        if self._found is None and self._outcome is None:
            self._outcome = self._missing_outcome()
            tester.record_check(comes, str(self._outcome))
            raise self._outcome
        tester.record_check(comes)
        tester.checks += self._results
        if self._found is None:
            assert self._outcome is not None
            raise self._outcome
        received, message = self._found
        late = received.at - deadline
        tester.record_check(f"{comes} in time", f"{late:.2f} s late" if late > 0 else "")
        if late > 0:
            raise Late(f"{message_name(self._kind)} came {late:.2f} s after the deadline of {seconds:g} s")
        return message

    def readable(self, received: ReceivedMessage) -> M | None:
        """The decoded message if it is of this kind, from the target and valid; else `None`."""
        if received.code != self._kind.CODE or not self._source.matches(received.source):
            return None
        try:
            message = self._tester.registry.decode_as(self._kind, received.payload)
        except DecodeError:
            return None
        return message if self._where(message) else None

    def _process_pending(self) -> bool:
        """Judge the pending messages of this kind; true once the result is known."""
        for received in list(self._client.pending):
            if (
                received.code == self._kind.CODE
                and self._source.matches(received.source)
                and (self._takes_broadcast or not received.broadcast)
            ):
                self._judge(received)
                if self._found is not None:
                    return True
        return self._outcome is not None and not self._source.is_wildcard

    def _judge(self, received: ReceivedMessage) -> None:
        reads = f"{message_name(self._kind)} is as its definition says"
        try:
            message = self._tester.registry.decode_as(self._kind, received.payload)
        except DecodeError as error:
            self._client.pending.remove(received)
            problem = f"{message_name(self._kind)} from {received.source} is malformed: {error}"
            self._settle(Malformed(problem), [CheckResult(reads, problem)])
            return
        if not self._where(message):
            return
        self._client.pending.remove(received)
        results = [
            CheckResult(f"{message_name(self._kind)} {check.name}", check.problem(message)) for check in self._checks
        ]
        problems = [result.problem for result in results if result.problem]
        outcome = (
            Failed(f"{message_name(self._kind)} from {received.source}: {'; '.join(problems)}") if problems else None
        )
        self._settle(outcome, [CheckResult(reads), *results])
        if outcome is None:
            self._found = received, message

    def _settle(self, outcome: StepOutcome | None, results: list[CheckResult]) -> None:
        """Keep the first wrong answer, until a right one replaces it."""
        if outcome is None or self._outcome is None:
            self._outcome, self._results = outcome, results

    def _missing_outcome(self) -> StepOutcome:
        wanted = message_name(self._kind)
        if misdirected := self._misdirected():
            return Silent(f"no {wanted} came from {self._source} to {self._client.id}, but {misdirected}")
        # The client is notified at any time of control that ends by itself.
        others = self._client.unasked(() if self._kind is ConfirmControl else (RejectControl.CODE,))
        if others:
            return Failed(f"no {wanted} came, but {', '.join(others[:4])}")
        return Silent(f"no {wanted} came in {2 * self._seconds:g} s")

    def _misdirected(self) -> str:
        """A message of this kind from another source or to another client; empty if there is none."""
        for client in self._tester.clients:
            for received in client.pending:
                from_source = self._source.matches(received.source)
                if received.code == self._kind.CODE and (not from_source or client is not self._client):
                    return f"one from {received.source} to {client.id}"
        return ""


EVENTS: Final = frozenset({Event.CODE, CommandEvent.CODE})
"""Messages that are not answers to a query."""
MAX_PENDING: Final = 1024
"""Pending messages of one client; the oldest are dropped first."""
CONFIRMATIONS: Final = frozenset({ConfirmEventRequest.CODE, ConfirmSensorConfiguration.CODE})
MAX_CONFIRMED: Final = 64
"""Confirmations of one client in one step."""


class Client:
    """One client of the target: a JAUS id that sends and expects."""

    def __init__(self, tester: Tester, id: JausID) -> None:
        self.tester = tester
        self.id = id
        self.pending: deque[ReceivedMessage] = deque(maxlen=MAX_PENDING)
        self.confirmed: deque[ReceivedMessage] = deque(maxlen=MAX_CONFIRMED)
        """Every confirmation in this step, including those that were expected."""
        self.other_port = False
        """Send from the second UDP port while this is true."""
        self.sent: set[int] = set()
        """The ids of all messages that it has sent."""
        self._endpoint = Endpoint(id, first_sequence=tester.link.first_sequence + int(id) % 251)

    def begin(self) -> None:
        """Start a step: discard pending messages."""
        self.pending.clear()
        self.confirmed.clear()

    def send(self, message: Message | bytes, *, to: JausID | None = None, ack: Ack = Ack.NONE) -> None:
        """Send a message to the target, or to `to`."""
        payload = message if isinstance(message, bytes) else message.encode()
        code = message_id(payload)
        self.tester.keep_pace()
        self.sent.add(code)
        if isinstance(message, Message):
            self.tester.why.append(f"{message.SERVICE} {message.VERSION}: {message_name(type(message))}")
        self._endpoint.send(to or self.tester.target, payload, now=self.tester.now, ack=ack)
        self._flush()
        self.tester.on_sent(code)

    def broadcast(self, message: Message) -> None:
        """Send a message to all components of all subsystems."""
        self.send(message, to=EVERYONE)

    def raw(self, datagram: bytes) -> None:
        """Send a datagram as it is."""
        self.tester.transmit(datagram, self.id, other_port=self.other_port)

    def ask(
        self,
        message: Message | bytes,
        answer: type[M],
        *checks: Check | Iterable[Check],
        to: JausID | None = None,
        within: float = 1.0,
    ) -> M:
        """Send a message and expect this answer; earlier answers of the same kind are discarded."""
        self.tester.keep_pace()
        self.forget(answer)
        self.send(message, to=to)
        asked = None if to is None or to.is_wildcard else to
        return self.expect(answer, *checks, within=within, source=asked, broadcast=False)

    def ask_until_right(
        self, message: Message, answer: type[M], *checks: Check | Iterable[Check], to: JausID | None = None
    ) -> M:
        """Same as `ask`, but the query is repeated after a wrong answer, until the timeout.

        The services of a component may notify each other asynchronously, so that what they report is right a little
        later.
        """
        tester, notes = self.tester, self.tester.notes_of_step()
        for pause in pauses(tester.timeout):
            try:
                return self.ask(message, answer, *checks, to=to)
            except Failed:
                tester.wait(pause)
                tester.restore_notes(notes)
        return self.ask(message, answer, *checks, to=to)

    def expect(
        self,
        answer: type[M],
        *checks: Check | Iterable[Check],
        where: Callable[[M], bool] = lambda _: True,
        within: float = 1.0,
        source: JausID | None = None,
        broadcast: bool = True,
    ) -> M:
        """Expect a message of this kind that passes all checks within this many timeouts; else raises `StepOutcome`.

        Messages for which `where` is false stay pending. `source` is the target, or one component of it. Messages to
        everyone count unless `broadcast` is false: they answer nothing.
        """
        flat = [one for check in checks for one in ((check,) if isinstance(check, Check) else check)]
        return Expectation(self, answer, flat, where, source, broadcast=broadcast).wait(within * self.tester.timeout)

    def collect(
        self, kind: type[M], seconds: float, where: Callable[[M], bool] = lambda _: True
    ) -> list[tuple[float, M]]:
        """All messages of this kind within a time in seconds, each with its arrival time."""
        expectation = Expectation(self, kind, [], where)
        return [(received.at, message) for received, message in self._collected(expectation, seconds)]

    def answers(
        self, message: Message, answer: type[M], seconds: float, *, of: JausID | None = None
    ) -> list[tuple[JausID, M]]:
        """Send, and return all answers within a time in seconds, with sources. `of`: the destination."""
        self.forget(answer)
        self.send(message, to=of)
        expectation = Expectation(self, answer, [], lambda _: True, of)
        return [(received.source, found) for received, found in self._collected(expectation, seconds)]

    def _collected(self, expectation: Expectation[M], seconds: float) -> list[tuple[ReceivedMessage, M]]:
        self.tester.wait(seconds)
        read = [(received, expectation.readable(received)) for received in list(self.pending)]
        taken = [(received, message) for received, message in read if message is not None]
        for received, _ in taken:
            self.pending.remove(received)
        return taken

    def silence(self, within: float = 0.1, *, besides: tuple[type[Message], ...] = ()) -> None:
        """Check that the target sends nothing but `besides` and events to this client for this part of the timeout."""
        allowed = {kind.CODE for kind in besides}
        end = self.tester.now + within * self.tester.timeout
        self.tester.pump(end, lambda: bool(self.unasked(allowed)))
        came = ", ".join(self.unasked(allowed))
        self.tester.expected.append("no answer")
        self.tester.check("there is no answer", f"{came} came, where nothing should" if came else "")

    def unasked(self, besides: Collection[int] = ()) -> list[str]:
        """The names of pending messages, except broadcasts, events, queries of the target and these ids."""
        waiting = [
            packet for packet in self.pending if self.tester.target.matches(packet.source) and not packet.broadcast
        ]
        return [self.name_of(packet) for packet in waiting if is_answer(packet.code) and packet.code not in besides]

    def name_of(self, received: ReceivedMessage) -> str:
        """The name and id of a message, as in `ReportStatus 4002h`."""
        kinds = self.tester.registry.by_code(received.code)
        return message_name(kinds[0]) if kinds else f"{received.code:04X}h"

    def forget(self, kind: type[Message]) -> None:
        """Discard pending messages of this kind."""
        self.pending = deque((packet for packet in self.pending if packet.code != kind.CODE), maxlen=MAX_PENDING)

    def take(self, datagram: bytes) -> None:
        """Handle a datagram for this client, and acknowledge packets that require it."""
        self._endpoint.receive(datagram, self.tester.now)
        while (packet := self._endpoint.next_event()) is not None:
            self._keep(_received(self, packet))
        self._flush()

    def _keep(self, received: ReceivedMessage) -> None:
        self.tester.dropped += len(self.pending) == MAX_PENDING
        self.pending.append(received)
        if received.code in CONFIRMATIONS:
            self.confirmed.append(received)

    def _flush(self) -> None:
        for datagram in self._endpoint.poll_output():
            self.raw(datagram)


def _received(client: Client, packet: Packet) -> ReceivedMessage:
    is_broadcast = packet.broadcast != Broadcast.NONE
    return ReceivedMessage(client.tester.now, client.id, packet.source, packet.payload, is_broadcast)


def is_answer(code: int) -> bool:
    """True unless the message is an event or a query (2000h to 3FFFh)."""
    return code not in EVENTS and not is_query(code)


def is_query(code: int) -> bool:
    """True for the ids of queries (2000h to 3FFFh)."""
    return 0x2000 <= code < 0x4000


TIMEOUT: Final = 1.5
"""Seconds that the judge of the public tests waits for an answer."""
PAUSES: Final = 1 / 32, 1 / 16, 1 / 8, 1 / 4, 1 / 2
"""Timeouts between two queries while an answer is not right yet."""


def pauses(timeout: float) -> Iterator[float]:
    """The seconds to wait between queries for something that may take up to a timeout."""
    return (part * timeout for part in PAUSES)


MAX_BEHIND: Final = 50_000
"""Datagrams that may be waiting at a deadline. Sockets hold far fewer, so more mean an endless flood."""

TOO_FAST: Final = (
    "datagrams come faster than they can be read, so nothing can be judged by time; the report has the first of "
    "them: stop whoever sends them, or test from a faster machine"
)

Listener: TypeAlias = Callable[[Packet, bool], None]
"""Called with a packet and whether it arrived on the second UDP port."""


class StepNotes(NamedTuple):
    """Record of a step for the report: its source, expectations and checks."""

    why: tuple[str, ...]
    expected: tuple[str, ...]
    checks: tuple[CheckResult, ...]


class Tester:
    """Sends and receives for the steps. `target` may be a wildcard; answers of others are ignored.

    `timeout`: seconds within which an answer must arrive; the unit of all other waiting times.
    """

    def __init__(self, link: TesterLink, target: JausID, *, registry: Registry, timeout: float = TIMEOUT) -> None:
        self.link = link
        self.target = target
        self.registry = registry
        self.timeout = timeout
        self.memory: dict[str, Any] = {}
        """Values that steps keep for later steps."""
        self.record = DatagramTrace()
        self.listeners: list[Listener] = []
        """Called with every packet that arrives in this step."""
        self.sent_in_step = False
        """True if something was sent in this step."""
        self.received_in_step = False
        """True if something was received from the target in this step."""
        self.notes: list[str] = []
        """Notes for the report on the run."""
        self.dropped = 0
        """Messages that were dropped because a client holds no more than `MAX_PENDING`."""
        self.has_sent = False
        """True once anything was sent."""
        self.has_received = False
        """True once anything was received from the target."""
        self.silent_since = ""
        """The id of the step since which the target does not answer; empty while it does."""
        self.checks: list[CheckResult] = []
        self.expected: list[str] = []
        self.why: list[str] = []
        self.taken: list[str] = []
        """Transitions of state machines that the target takes in this step."""
        self.pace = 0.0
        """Seconds that pass after a command, at least, before anything else is sent."""
        self._commanded_at = -math.inf
        self._start = link.now()
        self._clients: dict[JausID, Client] = {}

    @property
    def now(self) -> float:
        """Seconds since the run began."""
        return self.link.now() - self._start

    @property
    def component(self) -> JausID:
        """One component of the target: the first that answered if the target is a wildcard."""
        if not self.target.is_wildcard:
            return self.target
        found: JausID = self.recall("component", "no component of the target has answered")
        return found

    @property
    def clients(self) -> tuple[Client, ...]:
        """The clients that have been used."""
        return tuple(self._clients.values())

    def client(self, id: str | JausID) -> Client:
        """The client with this id, which is reachable from then on."""
        wanted = JausID.of(id)
        if wanted == self.target:
            raise ConfigError(f"{wanted} is an id that the test itself uses; give the target another one")
        if wanted not in self._clients:
            self.link.join(wanted)
            self._clients[wanted] = Client(self, wanted)
        return self._clients[wanted]

    def recall(self, name: str, missing: str) -> Any:
        """The value that an earlier step kept in `memory`. Raises `Skipped` with the reason `missing` without one."""
        if name not in self.memory:
            raise Skipped(missing)
        return self.memory[name]

    def begin(self) -> None:
        """Start a step: discard messages received before it."""
        self.pump(self.now, lambda: False)
        self.checks, self.expected, self.why, self.taken = [], [], [], []
        self.sent_in_step = self.received_in_step = False
        self.listeners.clear()
        self.record.begin()
        for client in self._clients.values():
            client.begin()

    @contextmanager
    def unreported(self) -> Iterator[None]:
        """Leave the checks and expectations of the block out of the report."""
        notes = self.notes_of_step()
        yield
        self.restore_notes(notes)

    def notes_of_step(self) -> StepNotes:
        """The notes of this step so far."""
        return StepNotes(tuple(self.why), tuple(self.expected), tuple(self.checks))

    def restore_notes(self, notes: StepNotes) -> None:
        """Restore earlier notes of this step; later ones are left out of the report."""
        self.why, self.expected, self.checks = list(notes.why), list(notes.expected), list(notes.checks)

    def record_check(self, name: str, problem: str = "") -> None:
        """Add a check and its problem, if any, to the report."""
        self.checks.append(CheckResult(name, problem))

    def check(self, name: str, problem: str) -> None:
        """Add a check to the report. Raises `Failed` if there is a problem."""
        self.record_check(name, problem)
        if problem:
            raise Failed(problem)

    def wait(self, seconds: float) -> None:
        """Wait this many seconds; messages that arrive stay pending."""
        self.pump(self.now + seconds, lambda: False)

    def keep_pace(self) -> None:
        """Wait until the pace allows to send."""
        self.wait(max(0.0, self._commanded_at + self.pace - self.now))

    def on_sent(self, code: int) -> None:
        """Called for each message that a client sends; the pace counts from commands, not from queries."""
        if not is_query(code):
            self._commanded_at = self.now

    @contextmanager
    def at_pace(self, pace: float) -> Iterator[None]:
        """Take a pace, in seconds, in the block."""
        before, self.pace = self.pace, pace
        try:
            yield
        finally:
            self.pace = before

    def pump(self, until: float, done: Callable[[], bool]) -> bool:
        """Receive until `done` is true or the time is over; returns whether it was done.

        Raises `TransportError` when datagrams arrive faster than they can be read.
        """
        behind = 0
        while not done():
            arrival = self.link.receive(self._start + until)
            if arrival is None:
                return done()
            self._take(arrival)
            behind += self.now >= until
            if behind > MAX_BEHIND:
                raise TransportError(TOO_FAST)
        return True

    def transmit(self, datagram: bytes, source: JausID, *, other_port: bool = False) -> None:
        """Send these bytes as they are."""
        self.has_sent = self.sent_in_step = True
        self._record(Direction.SENT, datagram, other_port=other_port)
        self.link.send(datagram, source, other_port=other_port)

    def _take(self, arrival: Arrival) -> None:
        datagram = arrival.data
        self._record(Direction.RECEIVED, datagram, other_port=arrival.other_port)
        packets, errors = judp.unpack_all(datagram)
        for client in self._clients.values():
            if errors or any(packet.destination.matches(client.id) for packet in packets):
                client.take(datagram)
        for packet in packets:
            for listener in self.listeners:
                listener(packet, arrival.other_port)
        if any(self.target.matches(packet.source) for packet in packets):
            self.has_received = self.received_in_step = True
            if not self.target.is_wildcard or "component" in self.memory:
                return
            self.memory["component"] = next(packet.source for packet in packets if self.target.matches(packet.source))

    def _record(self, direction: Direction, datagram: bytes, *, other_port: bool) -> None:
        self.record.add(TraceEntry(self.now, direction, datagram, self.registry, other_port))
