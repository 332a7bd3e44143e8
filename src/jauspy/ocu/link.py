"""One client on the network: sends messages, and finds the answer to each query."""

from __future__ import annotations

import asyncio
import logging
from collections import Counter
from collections.abc import AsyncIterator, Awaitable, Callable, Iterator
from contextlib import contextmanager, suppress
from typing import Final

from jauspy.arguments import check_number
from jauspy.codec.message import Message
from jauspy.codec.registry import Registry
from jauspy.component import Shell
from jauspy.errors import ConfigError, JausError, ResponseTimeout, TransportError
from jauspy.ids import JausID
from jauspy.ocu.answers import answer_to
from jauspy.ocu.arguments import check_message
from jauspy.ocu.controls import Controls
from jauspy.ocu.lanes import Lanes
from jauspy.ocu.patience import Patience
from jauspy.ocu.replies import Arrival, Replies, Waiter
from jauspy.ocu.shared_events import SharedEvents
from jauspy.ocu.stats import Recorder
from jauspy.protocol.header import Ack, Broadcast, Packet, Priority

_LOG: Final = logging.getLogger("jauspy.ocu")

ASK_AGAIN: Final = 0.5
"""Seconds between two questions to all that a wildcard reaches."""
ENDS: Final = 128
"""Events that are ended at once: of what may be under way, the rest is for others, as for Standby."""
MAX_ANSWERS: Final = 4096
"""Different components that one question may be answered by."""


class Link:
    """What all parts of the OCU share. `registry` has the known messages."""

    def __init__(self, registry: Registry, patience: Patience) -> None:
        self.registry = registry
        self.patience = patience
        self.recorder = Recorder()
        self.replies = Replies(registry, self.malformed)
        self.requests: Counter[JausID] = Counter()
        self.controls = Controls()
        self.events = SharedEvents()
        self._component: Shell | None = None
        self._loop: asyncio.AbstractEventLoop | None = None
        self._farewells: list[Callable[[], Awaitable[object]]] = []
        self._lanes = Lanes()

    def attach(self, component: Shell) -> None:
        """Use this component for sending."""
        self._component, self._loop = component, asyncio.get_running_loop()
        self.ends = asyncio.Semaphore(ENDS)

    async def say_goodbye(self) -> None:
        """The OCU is about to be closed: whoever is to say goodbye does so, until that was heard."""
        said = await asyncio.gather(*(farewell() for farewell in self._farewells), return_exceptions=True)
        for each in said:
            if isinstance(each, BaseException):
                raise each

    def detach(self) -> None:
        """The OCU is closed: nobody waits any more."""
        self._component = None
        self.replies.fail(TransportError("the OCU was closed while this waited for an answer"))

    @contextmanager
    def before_closing(self, farewell: Callable[[], Awaitable[object]]) -> Iterator[None]:
        """Inside, `farewell` is awaited when the OCU is closed, while it can still send."""
        self._farewells.append(farewell)
        try:
            yield
        finally:
            self._farewells.remove(farewell)

    @property
    def id(self) -> JausID:
        """The client's id."""
        return self._open().id

    def receive(self, packet: Packet) -> bool:
        """Take a received packet; false for commands and queries nobody here waits for: the OCU's services answer.

        What nobody waits for, as an answer that comes too late, is counted, and told to those who wait in vain.
        """
        self.recorder.received += 1
        if len(packet.payload) < 2:
            self.malformed(f"{packet.payload.hex()!r} from {packet.source} is too short for a message")
            return True
        if self.replies.deliver(packet.payload, packet.source):
            return True
        code = int.from_bytes(packet.payload[:2], "little")
        known = self.registry.by_code(code)
        if any(each.IS_COMMAND or each.IS_QUERY for each in known):
            return False
        self.recorder.unexpected += 1
        self.replies.unexpected(known[0].NAME if known else f"{code:04X}h, which is not known here,", packet.source)
        return True

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
        self._open().send(destination, message, priority=priority, broadcast=broadcast, ack=ack)
        self._sent(destination, message)

    async def tell(self, destination: JausID, message: Message, *, ack: bool) -> None:
        """Send for a user: `ControlRejected` for a command to a component whose control is lost.

        With `ack` it is resent until acknowledged; raises `ResponseTimeout` when it is not, after all resends.
        """
        check_message(message, "send()", "Resume()")
        self.controls.check(destination, message)
        if ack:
            component = self._open()
            self._sent(destination, message)
            await component.deliver(destination, message)
        else:
            self.send(destination, message)
            await asyncio.sleep(0)  # so that a loop that only sends lets others run

    async def assure(self, destination: JausID, message: Message) -> bool:
        """Send, and wait until it was acknowledged, or given up; which of them.

        What is sent after this does not overtake it, as what is resent in the background can be.
        """
        with suppress(JausError):  # not open, too much under way, or nobody there
            component = self._open()
            self._sent(destination, message)
            await component.deliver(destination, message)
            return True
        return False

    async def query(
        self,
        destination: JausID,
        message: Message,
        *,
        patience: Patience | None = None,
        expects: type[Message] | None = None,
        accept: Callable[[Message], bool] = lambda _: True,
    ) -> Message:
        """The answer to a query; raises `ResponseTimeout` when none comes.

        Equal queries may be outstanding at once. Different ones whose reports have the same class take turns, since
        most reports do not say which query they answer; those that do are chosen by `accept`.
        """
        patience = patience or self.patience
        kind = answer_to(self.registry, message, expects)
        try:
            async with asyncio.timeout(patience.total) as deadline:
                async with self._lanes.enter((destination, kind.CODE), message.encode()):
                    deadline.reschedule(None)  # it was for the turn; what follows keeps time itself
                    return await self._exchange(destination, message, patience, (kind,), accept)
        except TimeoutError:
            if not deadline.expired():
                raise
            self.recorder.timeouts += 1
            raise ResponseTimeout(
                f"{message.NAME} was not sent to {destination}: for {patience.total:g} s another query waited for a "
                f"{kind.NAME} from there, which could not be told from this one's"
            ) from None

    async def query_each(
        self, destination: JausID, message: Message, seconds: float, expects: type[Message] | None = None
    ) -> AsyncIterator[Arrival]:
        """Every answer within `seconds`, with who gave it, as they come; one of each component."""
        check_number(seconds, "within")
        if not seconds > 0:
            raise ConfigError(f"within {seconds} s must be above 0")
        kind, myself = answer_to(self.registry, message, expects, "query_each()"), self.id
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
        while not answers.empty():  # they came in time, and whoever reads them was slow
            yield answers.get_nowait()

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
        self.controls.check(destination, message)
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
            self.recorder.timeouts += 1
            raise ResponseTimeout(_no_answer(destination, message, patience, waiter))

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
        self.controls.sent(destination, message)

    def _open(self) -> Shell:
        if self._component is None:
            raise TransportError("the OCU is not open; use it inside `async with jauspy.OCU(...) as ocu:`")
        if self._loop is not asyncio.get_running_loop():
            raise TransportError(
                "the OCU was opened in another event loop and cannot be used from here; open and use it inside one "
                "`asyncio.run`, or take jauspy.sync.OCU, which any code may call"
            )
        return self._component


def _no_answer(destination: JausID, message: Message, patience: Patience, waiter: Waiter) -> str:
    times = f"{patience.retries + 1} times" if patience.retries else "once"
    what = "no answer came"
    if waiter.problem:
        what = f"an answer came but could not be read ({waiter.problem})"
    elif waiter.instead:
        what = f"no {waiter.kinds[0].NAME} came, but {waiter.instead} did (`expects` says what to wait for)"
    return (
        f"{destination} was sent {message.NAME} {times} in {patience.total:g} s and {what}; check that the component "
        "runs and offers this, and that the node manager is reachable (`jauspy ls` shows who answers)"
    )
