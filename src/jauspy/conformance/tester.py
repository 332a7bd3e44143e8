"""The hands of a step: clients that send, and expectations about what comes back."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable, Collection, Iterable
from typing import Any, Final, TypeVar

from jauspy.codec.base import Message
from jauspy.codec.registry import Registry
from jauspy.conformance.checks import Check
from jauspy.conformance.expectation import Expectation
from jauspy.conformance.outcome import Failed, Skipped
from jauspy.conformance.results import Looked
from jauspy.conformance.trace import Direction, Entry, Heard, named
from jauspy.conformance.wire import Arrival, Wire
from jauspy.errors import ConfigError
from jauspy.ids import EVERYONE, JausID
from jauspy.messages.core import CommandEvent, Event
from jauspy.protocol import judp
from jauspy.protocol.endpoint import Endpoint
from jauspy.protocol.header import Ack

M = TypeVar("M", bound=Message)

TIMEOUT: Final = 1.5
"""Seconds that a judge of the public tests waits for an answer."""
EVENTS: Final = frozenset({Event.CODE, CommandEvent.CODE})
"""These come whenever they like."""
MAX_PENDING: Final = 1024
"""Messages of one client that nobody has looked at; the oldest go first. A target that floods is no news."""
MAX_ENTRIES: Final = 200_000
"""Datagrams of a run that are kept for the report."""


class Tester:
    """What a step works with. `target` may be a wildcard; answers of others than it are not looked at.

    `timeout`: seconds within which an answer must come; every other waiting is measured in it.
    """

    def __init__(self, wire: Wire, target: JausID, *, registry: Registry, timeout: float = TIMEOUT) -> None:
        self.wire = wire
        self.target = target
        self.registry = registry
        self.timeout = timeout
        self.memory: dict[str, Any] = {}
        """What steps leave for later ones."""
        self.entries: list[Entry] = []
        self.left_out = 0
        self.answered = False
        """True once anything came from the target."""
        self.looked: list[Looked] = []
        self.expected: list[str] = []
        self.why: list[str] = []
        self._start = wire.now()
        self._clients: dict[JausID, Client] = {}

    @property
    def now(self) -> float:
        """Seconds since the run began."""
        return self.wire.now() - self._start

    @property
    def component(self) -> JausID:
        """One component of the target, to be spoken to alone: the first that answered when the target is a wildcard."""
        if not self.target.is_wildcard:
            return self.target
        found: JausID = self.recall("component", "no component of the target has answered")
        return found

    @property
    def clients(self) -> tuple[Client, ...]:
        """Those that have had something to do."""
        return tuple(self._clients.values())

    def client(self, id: str | JausID) -> Client:
        """The client of this id; it is reachable from now on."""
        wanted = JausID.of(id)
        if wanted == self.target:
            raise ConfigError(f"{wanted} is an id that the test itself speaks as; give the target another one")
        if wanted not in self._clients:
            self.wire.join(wanted)
            self._clients[wanted] = Client(self, wanted)
        return self._clients[wanted]

    def recall(self, name: str, missing: str) -> Any:
        """What an earlier step left; else the step is skipped, with this reason."""
        if name not in self.memory:
            raise Skipped(missing)
        return self.memory[name]

    def begin(self) -> None:
        """A new step: what came before it, and has not been looked at, is not its business."""
        self.pump(self.now, lambda: False)
        self.looked, self.expected, self.why = [], [], []
        for client in self._clients.values():
            client.pending.clear()

    def look(self, name: str, problem: str = "") -> None:
        """Note that something was looked at."""
        self.looked.append(Looked(name, problem))

    def check(self, name: str, problem: str) -> None:
        """Note it, and end the step when there is a problem."""
        self.look(name, problem)
        if problem:
            raise Failed(problem)

    def wait(self, seconds: float) -> None:
        """Let time pass; what comes meanwhile is kept."""
        self.pump(self.now + seconds, lambda: False)

    def pump(self, until: float, done: Callable[[], bool]) -> bool:
        """Take what comes until `done`, or until the time is over; says whether it was done."""
        while not done():
            arrival = self.wire.receive(self._start + until)
            if arrival is None:
                return done()
            self._take(arrival)
        return True

    def transmit(self, datagram: bytes, source: JausID, *, strange_port: bool = False) -> None:
        """Send these very bytes."""
        self._record(Direction.SENT, datagram, strange_port=strange_port)
        self.wire.send(datagram, source, strange_port=strange_port)

    def _take(self, arrival: Arrival) -> None:
        datagram = arrival.data
        self._record(Direction.RECEIVED, datagram, strange_port=arrival.strange_port)
        packets, errors = judp.unpack_all(datagram)
        for client in self._clients.values():
            if errors or any(each.destination.matches(client.id) for each in packets):
                client.take(datagram)
        if any(self.target.matches(each.source) for each in packets):
            self.answered = True
            if not self.target.is_wildcard or "component" in self.memory:
                return
            self.memory["component"] = next(each.source for each in packets if self.target.matches(each.source))

    def _record(self, direction: Direction, datagram: bytes, *, strange_port: bool) -> None:
        if len(self.entries) < MAX_ENTRIES:
            self.entries.append(Entry(self.now, direction, datagram, self.registry, strange_port))
        else:
            self.left_out += 1


class Client:
    """One client of the target: a JAUS id that sends and expects."""

    def __init__(self, tester: Tester, id: JausID) -> None:
        self.tester = tester
        self.id = id
        self.pending: deque[Heard] = deque(maxlen=MAX_PENDING)
        self.strange_port = False
        """Speak from another UDP port from now on."""
        self.sent: set[int] = set()
        """The ids of all messages that it has sent."""
        self._endpoint = Endpoint(id, first_sequence=int(id) % 251)

    def send(self, message: Message | bytes, *, to: JausID | None = None, ack: Ack = Ack.NONE) -> None:
        """Send a message, to the target unless told otherwise."""
        payload = message if isinstance(message, bytes) else message.encode()
        self.sent.add(int.from_bytes(payload[:2], "little"))
        if isinstance(message, Message):
            self.tester.why.append(f"{message.SERVICE} {message.VERSION}: {named(type(message))}")
        self._endpoint.send(to or self.tester.target, payload, now=self.tester.now, ack=ack)
        self._flush()

    def broadcast(self, message: Message) -> None:
        """Send a message to all components of all subsystems."""
        self.send(message, to=EVERYONE)

    def raw(self, datagram: bytes) -> None:
        """Send a datagram as it is."""
        self.tester.transmit(datagram, self.id, strange_port=self.strange_port)

    def ask(
        self,
        message: Message | bytes,
        answer: type[M],
        *checks: Check | Iterable[Check],
        to: JausID | None = None,
        within: float = 1.0,
    ) -> M:
        """Send, and expect this answer; earlier ones of the same kind do not count."""
        self.forget(answer)
        self.send(message, to=to)
        return self.expect(answer, *checks, within=within)

    def expect(
        self,
        answer: type[M],
        *checks: Check | Iterable[Check],
        where: Callable[[M], bool] = lambda _: True,
        within: float = 1.0,
    ) -> M:
        """A message of this kind that passes all checks, within so many timeouts; ends the step if there is none.

        Messages for which `where` is false are others, and stay.
        """
        flat = [one for each in checks for one in ((each,) if isinstance(each, Check) else each)]
        return Expectation(self, answer, flat, where).wait(within * self.tester.timeout)

    def collect(
        self, kind: type[M], seconds: float, where: Callable[[M], bool] = lambda _: True
    ) -> list[tuple[float, M]]:
        """All messages of this kind within a time, with when they came."""
        self.tester.wait(seconds)
        taken = [(heard, Expectation(self, kind, [], where).readable(heard)) for heard in list(self.pending)]
        for heard, message in taken:
            if message is not None:
                self.pending.remove(heard)
        return [(heard.at, message) for heard, message in taken if message is not None]

    def silence(self, within: float = 0.1, *, besides: tuple[type[Message], ...] = ()) -> None:
        """Nothing comes to this client from the target for this part of the timeout, besides these and events."""
        allowed = {kind.CODE for kind in besides}
        end = self.tester.now + within * self.tester.timeout
        self.tester.pump(end, lambda: bool(self.unasked(allowed)))
        came = ", ".join(self.unasked(allowed))
        self.tester.expected.append("no answer")
        self.tester.check("there is no answer", f"{came} came, where nothing should" if came else "")

    def unasked(self, besides: Collection[int] = ()) -> list[str]:
        """The names of what waits to be looked at; events, queries of the target and these ids left aside."""
        waiting = [each for each in self.pending if self.tester.target.matches(each.source)]
        return [self.name_of(each) for each in waiting if is_answer(each.code) and each.code not in besides]

    def name_of(self, heard: Heard) -> str:
        """`ReportStatus 4002h`."""
        kinds = self.tester.registry.by_code(heard.code)
        return named(kinds[0]) if kinds else f"{heard.code:04X}h"

    def forget(self, kind: type[Message]) -> None:
        """Do not look at messages of this kind that have come already."""
        self.pending = deque((each for each in self.pending if each.code != kind.CODE), maxlen=MAX_PENDING)

    def take(self, datagram: bytes) -> None:
        """A datagram for this client; acknowledges what wants to be."""
        self._endpoint.receive(datagram, self.tester.now)
        while (packet := self._endpoint.next_event()) is not None:
            self.pending.append(Heard(self.tester.now, self.id, packet.source, packet.payload))
        self._flush()

    def _flush(self) -> None:
        for datagram in self._endpoint.poll_output():
            self.raw(datagram)


def is_answer(code: int) -> bool:
    """True for what comes because something was sent: no event, and no query (2000h to 3FFFh)."""
    return code not in EVENTS and not 0x2000 <= code < 0x4000
