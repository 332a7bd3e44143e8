"""What a step works with: clients, the wire, the time, and what has been looked at."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, Final, TypeAlias, TypeVar

from jauspy.codec.base import Message
from jauspy.codec.registry import Registry
from jauspy.conformance.client import Client
from jauspy.conformance.results import Failed, Looked, Skipped
from jauspy.conformance.trace import Direction, Entry, Record
from jauspy.conformance.wire import Arrival, Wire
from jauspy.errors import ConfigError, TransportError
from jauspy.ids import JausID
from jauspy.protocol import judp
from jauspy.protocol.header import Packet

M = TypeVar("M", bound=Message)

TIMEOUT: Final = 1.5
"""Seconds that a judge of the public tests waits for an answer."""
MAX_BEHIND: Final = 50_000
"""Datagrams that may have been waiting when a time is over; sockets hold far fewer, so more is a flood without end."""

TOO_FAST: Final = (
    "datagrams come faster than they can be read, so nothing can be judged by time; the report has the first of "
    "them: stop whoever sends them, or test from a faster machine"
)

Listener: TypeAlias = Callable[[Packet, bool], None]
"""Takes a packet, and whether it came to the strange port."""


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
        self.record = Record()
        self.listeners: list[Listener] = []
        """Hear every packet that comes in this step."""
        self.spoke = False
        """True when something was sent in this step."""
        self.heard = False
        """True when something came from the target in this step."""
        self.unread = 0
        """Messages that came, and were dropped because no step looked at them."""
        self.asked = False
        """True once anything was sent."""
        self.answered = False
        """True once anything came from the target."""
        self.lost = ""
        """The step since which the target is silent; empty while it lives."""
        self.looked: list[Looked] = []
        self.expected: list[str] = []
        self.why: list[str] = []
        self.taken: list[str] = []
        """Transitions of state machines that the target takes in this step."""
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
        self.looked, self.expected, self.why, self.taken = [], [], [], []
        self.spoke = self.heard = False
        self.listeners.clear()
        self.record.begin()
        for client in self._clients.values():
            client.begin()

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
        """Take what comes until `done`, or until the time is over; says whether it was done.

        Raises `TransportError` when so much comes that the time is never over.
        """
        behind = 0
        while not done():
            arrival = self.wire.receive(self._start + until)
            if arrival is None:
                return done()
            self._take(arrival)
            behind += self.now >= until
            if behind > MAX_BEHIND:
                raise TransportError(TOO_FAST)
        return True

    def transmit(self, datagram: bytes, source: JausID, *, strange_port: bool = False) -> None:
        """Send these very bytes."""
        self.asked = self.spoke = True
        self._record(Direction.SENT, datagram, strange_port=strange_port)
        self.wire.send(datagram, source, strange_port=strange_port)

    def _take(self, arrival: Arrival) -> None:
        datagram = arrival.data
        self._record(Direction.RECEIVED, datagram, strange_port=arrival.strange_port)
        packets, errors = judp.unpack_all(datagram)
        for client in self._clients.values():
            if errors or any(each.destination.matches(client.id) for each in packets):
                client.take(datagram)
        for packet in packets:
            for listener in self.listeners:
                listener(packet, arrival.strange_port)
        if any(self.target.matches(each.source) for each in packets):
            self.answered = self.heard = True
            if not self.target.is_wildcard or "component" in self.memory:
                return
            self.memory["component"] = next(each.source for each in packets if self.target.matches(each.source))

    def _record(self, direction: Direction, datagram: bytes, *, strange_port: bool) -> None:
        self.record.add(Entry(self.now, direction, datagram, self.registry, strange_port))
