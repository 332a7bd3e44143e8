"""One client on the network: sends messages, and finds the answer to each query."""

from __future__ import annotations

import asyncio
import logging
from collections import Counter
from collections.abc import AsyncIterator, Callable
from dataclasses import dataclass
from typing import Final, Protocol

from jauspy.arguments import check_number
from jauspy.codec.base import Message
from jauspy.codec.registry import Registry
from jauspy.component import Shell
from jauspy.errors import ConfigError, ControlRejected, ResponseTimeout, TransportError
from jauspy.ids import JausID
from jauspy.ocu.arguments import check_class, check_message
from jauspy.ocu.lanes import Lanes
from jauspy.ocu.replies import Arrival, Replies
from jauspy.ocu.stats import Recorder
from jauspy.protocol.header import Ack, Broadcast, Packet, Priority

_LOG: Final = logging.getLogger("jauspy.ocu")

ASK_AGAIN: Final = 0.5
"""Seconds between two questions to all that a wildcard reaches."""
MAX_ANSWERS: Final = 4096
"""Different components that one question may be answered by."""
REPORT_OFFSET: Final = 0x2000
"""From the code of a query (2000h to 3FFFh) to that of its report (AS5710)."""
REPORTS: Final = range(0x4000, 0x6000)


@dataclass(frozen=True, slots=True)
class Patience:
    """How long to wait for one answer (seconds), and how often to ask again."""

    timeout: float = 1.0
    retries: int = 2

    def __post_init__(self) -> None:
        check_number(self.timeout, "timeout")
        check_number(self.retries, "retries", whole=True)
        if not self.timeout > 0 or self.retries < 0:
            raise ConfigError(f"timeout {self.timeout} s must be above 0, retries {self.retries} must be 0 or more")

    @property
    def total(self) -> float:
        """Seconds until it is given up."""
        return self.timeout * (self.retries + 1)

    def changed(self, timeout: float | None, retries: int | None) -> Patience:
        """With what is given."""
        return Patience(self.timeout if timeout is None else timeout, self.retries if retries is None else retries)


class Held(Protocol):
    """Control of a component, as others see it."""

    def check(self) -> None:
        """Raise `ControlRejected` when it was lost."""

    def sent(self, message: Message) -> None:
        """Hear of a message that was sent to the component."""


class Link:
    """What all parts of the OCU share. `registry` has the known messages."""

    def __init__(self, registry: Registry, patience: Patience) -> None:
        self.registry = registry
        self.patience = patience
        self.recorder = Recorder()
        self.replies = Replies(registry, self.malformed)
        self.requests: Counter[JausID] = Counter()
        self._component: Shell | None = None
        self._lanes = Lanes()
        self._controls: dict[JausID, Held] = {}
        self._events: dict[tuple[JausID, int], set[object]] = {}

    def attach(self, component: Shell | None) -> None:
        """Use this component for sending; None when the OCU is closed."""
        self._component = component
        if component is None:
            self.replies.fail(TransportError("the OCU was closed while this waited for an answer"))

    @property
    def id(self) -> JausID:
        """The client's id."""
        return self._open().id

    def receive(self, packet: Packet) -> bool:
        """Take a received packet; false for commands and queries nobody here waits for: the OCU's services answer."""
        self.recorder.received += 1
        if len(packet.payload) < 2:
            self.malformed(f"{packet.payload.hex()!r} from {packet.source} is too short for a message")
            return True
        if self.replies.deliver(packet.payload, packet.source):
            return True
        known = self.registry.by_code(int.from_bytes(packet.payload[:2], "little"))
        return not any(each.IS_COMMAND or each.IS_QUERY for each in known)

    def send(
        self,
        destination: JausID,
        message: Message,
        *,
        priority: Priority = Priority.STANDARD,
        broadcast: Broadcast = Broadcast.NONE,
        ack: Ack = Ack.NONE,
    ) -> None:
        """Send a message; raises `EncodeError` when a value does not fit."""
        check_message(message, "send()", "Resume()")
        self._open().send(destination, message, priority=priority, broadcast=broadcast, ack=ack)
        self._sent(destination, message)

    async def deliver(self, destination: JausID, message: Message) -> None:
        """Send a message and wait for its ACK; raises `ResponseTimeout` when none comes after all resends."""
        component = self._open()
        check_message(message, "send()", "Resume()")
        self._sent(destination, message)
        await component.deliver(destination, message)

    async def query(
        self,
        destination: JausID,
        message: Message,
        *,
        patience: Patience | None = None,
        expects: type[Message] | None = None,
    ) -> Message:
        """The answer to a query; raises `ResponseTimeout` when none comes.

        Equal queries may be outstanding at once. Different ones whose reports have the same class take turns, since a
        report does not say which query it answers.
        """
        patience = patience or self.patience
        kind = self.answer_to(message, expects)
        try:
            async with asyncio.timeout(patience.total) as deadline:
                async with self._lanes.enter((destination, kind.CODE), message.encode()):
                    deadline.reschedule(None)  # it was for the turn; what follows keeps time itself
                    return await self._exchange(destination, message, patience, (kind,))
        except TimeoutError:
            if not deadline.expired():
                raise
            raise self._silence(destination, message, patience) from None

    async def query_each(
        self, destination: JausID, message: Message, seconds: float, expects: type[Message] | None = None
    ) -> AsyncIterator[Arrival]:
        """Every answer within `seconds`, with who gave it, as they come; one of each component."""
        check_number(seconds, "within")
        kind, myself = self.answer_to(message, expects, "query_each()"), self.id
        answers: asyncio.Queue[Arrival] = asyncio.Queue()
        seen: set[JausID] = set()

        def heard(answer: Message, source: JausID) -> None:
            if source not in seen and source != myself and len(seen) < MAX_ANSWERS:
                seen.add(source)
                answers.put_nowait((answer, source))

        clock = asyncio.get_running_loop().time
        now = clock()
        end, ask_at = now + seconds, now
        broadcast = Broadcast.GLOBAL if destination.is_wildcard else Broadcast.NONE
        with self.replies.tapped(destination, heard, kind):
            while (now := clock()) < end:
                if now >= ask_at:
                    self.send(destination, message, broadcast=broadcast)
                    ask_at = now + ASK_AGAIN
                try:
                    yield await asyncio.wait_for(answers.get(), min(ask_at, end) - now)
                except TimeoutError:
                    continue

    async def request(
        self,
        destination: JausID,
        message: Message,
        *answers: type[Message],
        accept: Callable[[Message], bool] = lambda _: True,
        patience: Patience | None = None,
    ) -> Message:
        """Send a command that is answered by one of `answers`, again and again until it is."""
        return await self._exchange(destination, message, patience or self.patience, answers, accept)

    async def _exchange(
        self,
        destination: JausID,
        message: Message,
        patience: Patience,
        answers: tuple[type[Message], ...],
        accept: Callable[[Message], bool] = lambda _: True,
    ) -> Message:
        clock = asyncio.get_running_loop().time
        with self.replies.waiting(destination, *answers, accept=accept) as waiter:
            for attempt in range(patience.retries + 1):
                sent_at = clock()
                self.send(destination, message)
                await asyncio.wait({waiter.arrival}, timeout=patience.timeout)
                if waiter.arrival.done():
                    answer, _ = waiter.arrival.result()
                    # After a repetition nobody knows which one was answered, so it says nothing about time.
                    self.recorder.answered(clock() - sent_at if attempt == 0 else None)
                    return answer
            raise self._silence(destination, message, patience, waiter.problem)

    def _silence(self, destination: JausID, message: Message, patience: Patience, problem: str = "") -> ResponseTimeout:
        self.recorder.timeouts += 1
        return ResponseTimeout(_no_answer(destination, message, patience, problem))

    def answer_to(self, message: Message, expects: type[Message] | None, use: str = "query()") -> type[Message]:
        """What answers this message: `expects`, else the report of the query that it is."""
        check_message(message, use)
        check_class(expects, "expects")
        return expects or self.report_of(message)

    def report_of(self, query: Message) -> type[Message]:
        """The class of the report that answers a query, of the same service and version."""
        if not query.IS_QUERY:
            raise ConfigError(f"{query.NAME} is no query; say with `expects` which message answers it, or send it")
        if (report := getattr(query, "REPORT", None)) is not None:
            return report  # type: ignore[no-any-return]  # queries whose report is of the same service have it
        code = query.CODE + REPORT_OFFSET
        found = self.registry.by_code(code) if code in REPORTS else self._named_report(query)
        for each in found:
            if (each.SERVICE, each.VERSION) == (query.SERVICE, query.VERSION):
                return each
        if not found:
            what = f"with id {code:04X}" if code in REPORTS else f"called {report_name(query)} of {query.SERVICE}"
            raise ConfigError(f"no message {what} is known to answer {query.NAME}; say with `expects` which one does")
        return found[0]

    def _named_report(self, query: Message) -> tuple[type[Message], ...]:
        """What answers a query whose id says nothing, as those of users do."""
        try:
            return (self.registry.by_name(report_name(query), service=query.SERVICE, version=query.VERSION),)
        except ConfigError:
            return ()

    def take_control(self, id: JausID, control: Held) -> None:
        """Remember who controls a component; `ControlRejected` when something else here does."""
        if id in self._controls:
            raise ControlRejected(f"this OCU already controls {id}; one `async with` block serves all of its services")
        self._controls[id] = control

    def has_control(self, id: JausID) -> bool:
        """True when something here controls the component."""
        return id in self._controls

    def drop_control(self, id: JausID, control: Held) -> None:
        """Forget it; fine when another one is there."""
        if self._controls.get(id) is control:
            del self._controls[id]

    def check_control(self, id: JausID) -> None:
        """Raise `ControlRejected` when control of the component was taken and is lost."""
        if id in self._controls:
            self._controls[id].check()

    def join_event(self, id: JausID, event: int, user: object) -> None:
        """`user` listens to this event; a component has one event for equal subscriptions of one client."""
        self._events.setdefault((id, event), set()).add(user)

    def leave_event(self, id: JausID, event: int | None, user: object) -> bool:
        """`user` does not any more; true when it was the last, so that the event can be cancelled."""
        users = self._events.get((id, event)) if event is not None else None
        if event is None or users is None:
            return False
        users.discard(user)
        if not users:
            del self._events[id, event]
        return not users

    def next_request_id(self, destination: JausID) -> int:
        """A number for the next event request, 0..255 and round again."""
        self.requests[destination] += 1
        return self.requests[destination] & 0xFF

    def malformed(self, problem: str) -> None:
        """Count a message that could not be read."""
        self.recorder.malformed += 1
        _LOG.debug("malformed: %s", problem)

    def _sent(self, destination: JausID, message: Message) -> None:
        self.recorder.sent += 1
        for id, control in self._controls.items():
            if destination.matches(id):
                control.sent(message)

    def _open(self) -> Shell:
        if self._component is None:
            raise TransportError("the OCU is not open; use it inside `async with jauspy.OCU(...) as ocu:`")
        return self._component


def report_name(query: Message) -> str:
    """`ReportLamp` of `QueryLamp`."""
    return f"Report{query.NAME.removeprefix('Query')}"


def _no_answer(destination: JausID, message: Message, patience: Patience, problem: str) -> str:
    times = f"{patience.retries + 1} times" if patience.retries else "once"
    what = f"an answer came but could not be read ({problem})" if problem else "no answer came"
    return (
        f"{destination} was sent {message.NAME} {times} in {patience.total:g} s and {what}; check that the component "
        "runs and offers this, and that the node manager is reachable (`jauspy ls` shows who answers)"
    )
