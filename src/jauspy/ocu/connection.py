"""The connection of one OCU, which all its clients share: sending, queries, statistics, held controls and events."""

from __future__ import annotations

import asyncio
from collections import Counter, defaultdict, deque
from collections.abc import AsyncIterator, Awaitable, Callable, Iterator
from contextlib import contextmanager, suppress
from dataclasses import dataclass
from statistics import median
from typing import Any, Final, Protocol

from jauspy.arguments import check_number, check_text
from jauspy.codec.message import Message
from jauspy.codec.registry import Registry
from jauspy.component import Component
from jauspy.errors import (
    ConfigError,
    ControlRejected,
    DecodeError,
    JausError,
    RequestError,
    ResponseTimeout,
    TransportError,
)
from jauspy.ids import JausID, is_called, message_id
from jauspy.logs import get_logger
from jauspy.messages.core import (
    CancelEvent,
    ClearEmergency,
    CreateEvent,
    ReleaseControl,
    RequestControl,
    Reset,
    SetEmergency,
    Shutdown,
    Standby,
    UpdateEvent,
)
from jauspy.messages.iop import RemoveHandoffRequest, RequestHandoff
from jauspy.messages.operators import QuerySealChallenge, RejectCommand, ReportSealChallenge
from jauspy.ocu.replies import QuerySerializer, Reply, ReplyDispatcher, ReplyWaiter, check_message, reply_class
from jauspy.ocu.sealing import CommandSealer, Refusals
from jauspy.ocu.subsystems import ServiceInfo
from jauspy.protocol.addressing import Location
from jauspy.protocol.header import Ack, Broadcast, Packet, Priority
from jauspy.protocol.seal import OperatorKey
from jauspy.services.core.command_seal import explained
from jauspy.transport.multicast import address_towards

_LOG: Final = get_logger("jauspy.ocu")

LOOPBACK: Final = "127.0.0.1"
"""Addresses of this machine."""
QUERY_EACH_INTERVAL: Final = 0.5
"""Seconds after which `query_each` sends its query again."""
MAX_ANSWERS: Final = 4096
"""Components whose answers `query_each` yields."""
MAX_PENDING_CANCELS: Final = 128
"""Events that are cancelled at the same time, so that the limit of messages under way leaves room for others."""
MAX_ROUND_TRIPS: Final = 10_000
"""Latest round trips that statistics are computed from."""

_LIST_DRIVER: Final = "urn:jaus:jss:manipulator:ManipulatorListDriver"
"""Since manipulator 2.0 this service has the messages that execute a list; drivers of elements inherit them."""
COMMANDS_WITHOUT_CONTROL: Final = frozenset(
    message.CODE
    for message in (
        RequestControl,
        ReleaseControl,
        SetEmergency,
        ClearEmergency,
        CreateEvent,
        UpdateEvent,
        CancelEvent,
        RequestHandoff,
        RemoveHandoffRequest,
    )
)
"""Message ids of commands that need no control."""


@dataclass(frozen=True, slots=True)
class RetryPolicy:
    """How long to wait for one answer (seconds), and how often to send the query again; any answer counts.

    With 10 % packet loss, query and answer fail once in 5 times, three attempts in a row once in 150, six attempts
    once in 20,000.
    """

    timeout: float = 0.5
    retries: int = 5

    def __post_init__(self) -> None:
        check_number(self.timeout, "timeout")
        check_number(self.retries, "retries", whole=True)
        if not self.timeout > 0 or self.retries < 0:
            raise ConfigError(f"timeout {self.timeout} s must be above 0, retries {self.retries} must be 0 or more")

    @property
    def total(self) -> float:
        """Seconds for all attempts."""
        return self.timeout * (self.retries + 1)

    def replaced(self, timeout: float | None, retries: int | None) -> RetryPolicy:
        """A copy with the arguments that are not None."""
        return RetryPolicy(self.timeout if timeout is None else timeout, self.retries if retries is None else retries)


CHALLENGE_RETRY: Final = RetryPolicy(timeout=0.25, retries=3)
"""Retries of the challenge before the first command; components without CommandSeal do not answer."""


@dataclass(frozen=True, slots=True)
class Stats:
    """A snapshot of counters. Round-trip times are in seconds, of the latest 10,000 queries; 0 without queries."""

    sent: int = 0
    received: int = 0
    answers: int = 0
    timeouts: int = 0
    malformed: int = 0
    unexpected: int = 0
    """Messages that no call waited for, such as late answers."""
    refused: int = 0
    """Commands that a component refused because the seal of an operator was missing or wrong."""
    rtt_min: float = 0.0
    rtt_median: float = 0.0
    rtt_max: float = 0.0


class StatsRecorder:
    """Counters of a connection; `snapshot` returns them as `Stats`."""

    def __init__(self) -> None:
        self.sent = 0
        self.received = 0
        self.answers = 0
        self.timeouts = 0
        self.malformed = 0
        self.unexpected = 0
        self.refused = 0
        self._round_trips: deque[float] = deque(maxlen=MAX_ROUND_TRIPS)

    def answered(self, seconds: float | None) -> None:
        """Count an answer after `seconds`; None when the round-trip time is not known."""
        self.answers += 1
        if seconds is not None:
            self._round_trips.append(seconds)

    def snapshot(self) -> Stats:
        """The counters so far."""
        times = self._round_trips or (0.0,)
        return Stats(
            sent=self.sent,
            received=self.received,
            answers=self.answers,
            timeouts=self.timeouts,
            malformed=self.malformed,
            unexpected=self.unexpected,
            refused=self.refused,
            rtt_min=min(times),
            rtt_median=median(times),
            rtt_max=max(times),
        )


class Trace(Protocol):
    """Callback of `OCU.trace` for each message; `payload` is the message with its id, encoded."""

    def __call__(self, source: JausID, destination: JausID, payload: bytes, *, sent: bool) -> None:
        """Take one message."""


LEAVES_READY: Final = tuple(command.CODE for command in (Standby, SetEmergency, Reset, Shutdown))
"""After one of these from this OCU the component is expected to leave Ready."""


class ControlHandle(Protocol):
    """Control of one component, as the connection uses it."""

    def check(self) -> None:
        """Raise `ControlRejected` when control was lost."""

    def on_sent(self, message: Message) -> None:
        """Called for each message that is sent to the component."""

    def on_ready(self) -> None:
        """Called when the component has entered Ready by a Resume of this OCU."""


class ActiveControls:
    """The components that the OCU controls, each from the request for control until it is released."""

    def __init__(self) -> None:
        self._controls: dict[JausID, ControlHandle] = {}
        self._stops: dict[JausID, int] = {}

    def __contains__(self, id: JausID) -> bool:
        return id in self._controls

    def add(self, id: JausID, control: ControlHandle) -> None:
        """Register control of a component; raises `ControlRejected` when this OCU already controls it."""
        if id in self._controls:
            raise ControlRejected(f"this OCU already controls {id}; one `async with` block serves all of its services")
        self._controls[id] = control

    def remove(self, id: JausID, control: ControlHandle) -> None:
        """Remove it; without effect when another control of the component is registered."""
        if self._controls.get(id) is control:
            del self._controls[id]
            self._stops.pop(id, None)

    def stops(self, id: JausID) -> int:
        """How often this OCU has stopped a component that it controls, by `LEAVES_READY`."""
        return self._stops.get(id, 0)

    def check(self, id: JausID, message: Message) -> None:
        """Raise `ControlRejected` for a command to a component whose control was taken and is lost."""
        if id in self._controls and message.IS_COMMAND and message.CODE not in COMMANDS_WITHOUT_CONTROL:
            self._controls[id].check()

    def on_sent(self, destination: JausID, message: Message) -> None:
        """Notify the controls of all components that a sent message reaches."""
        for id, control in self._controls.items():
            if destination.matches(id):
                control.on_sent(message)
                if message.CODE in LEAVES_READY:
                    self._stops[id] = self.stops(id) + 1

    def on_ready(self, id: JausID) -> None:
        """Notify the control of a component, if there is one, that it has entered Ready by a Resume of this OCU."""
        if id in self._controls:
            self._controls[id].on_ready()


class EventUsers:
    """Who uses which event: a component has one event for equal subscriptions, or equal commands, of one client.

    Events have a number; command events are known by the bytes of the command, before they have a number.
    """

    def __init__(self) -> None:
        self._users: dict[tuple[JausID, int | bytes], set[object]] = {}

    def add(self, id: JausID, event: int | bytes, user: object) -> set[object]:
        """Add a user of this event; returns the others."""
        users = self._users.setdefault((id, event), set())
        users.add(user)
        return users - {user}

    def is_used(self, id: JausID, event: int) -> bool:
        """True if this event has users."""
        return (id, event) in self._users

    def users(self, id: JausID, event: int | bytes) -> frozenset[object]:
        """The users of this event."""
        return frozenset(self._users.get((id, event), ()))

    def remove(self, id: JausID, event: int | bytes | None, user: object) -> bool:
        """Remove a user; true when it was the last one, so that the event can be cancelled."""
        users = self._users.get((id, event)) if event is not None else None
        if event is None or users is None:
            return False
        users.discard(user)
        if not users:
            del self._users[id, event]
        return not users


class Connection:
    """Sends messages and finds the answer to each query; `id` is the client's, `registry` holds the known messages.

    Discovery remembers up to `max_components`.
    """

    def __init__(
        self,
        id: JausID,
        registry: Registry,
        retry: RetryPolicy,
        operator: OperatorKey | None = None,
        *,
        max_components: int,
    ) -> None:
        self.id = id
        self.max_components = max_components
        self.registry = registry
        self.retry = retry
        self.stats = StatsRecorder()
        self.replies = ReplyDispatcher(registry, self.on_malformed)
        self.request_counts: Counter[JausID] = Counter()
        self._motions: Counter[JausID] = Counter()
        self.list_changes: defaultdict[JausID, asyncio.Lock] = defaultdict(asyncio.Lock)
        """Held while the list of a component is replaced: a replacement that is cancelled cleans up before the next."""
        self.controls = ActiveControls()
        self.events = EventUsers()
        self.program_silence: Callable[[], float] = lambda: 0.0
        """Seconds for which the program was blocked, if it runs in another thread than the event loop."""
        self.trace: Trace | None = None
        self._component: Component | None = None
        self._loop: asyncio.AbstractEventLoop | None = None
        self._on_close: list[Callable[[], Awaitable[object]]] = []
        self._serializer = QuerySerializer()
        self._sealer = CommandSealer(operator, id, self._ask_for_challenge) if operator is not None else None
        self._refusals = Refusals()

    # --- opening and closing --------------------------------------------------------------------------------------

    def attach(self, component: Component) -> None:
        """Send with this component."""
        self._component, self._loop = component, asyncio.get_running_loop()
        self.pending_cancels = asyncio.Semaphore(MAX_PENDING_CANCELS)

    def begin_motion(self, id: JausID) -> Callable[[], bool]:
        """Count a motion of a component; the result says whether its end may stop the component.

        It may while this OCU controls the component and has begun no later motion of it.
        """
        self._motions[id] += 1
        number = self._motions[id]
        return lambda: id in self.controls and number == self._motions[id]

    @contextmanager
    def on_close(self, callback: Callable[[], Awaitable[object]]) -> Iterator[None]:
        """Inside, `callback` is awaited when the OCU is closed, while it can still send."""
        self._on_close.append(callback)
        try:
            yield
        finally:
            self._on_close.remove(callback)

    async def run_on_close(self) -> None:
        """Await all `on_close` callbacks; raises the first of their errors."""
        results = await asyncio.gather(*(callback() for callback in self._on_close), return_exceptions=True)
        for result in results:
            if isinstance(result, BaseException):
                raise result

    def detach(self) -> None:
        """End every wait with `TransportError`: the OCU is closed."""
        self._component = None
        if self._sealer is not None:
            self._sealer.close()
        self.replies.fail(TransportError("the OCU was closed while this waited for an answer"))

    def service_info(self, name: str) -> ServiceInfo:
        """The newest known definition of a service, by its URN or the end of it; `ConfigError` unless there is one."""
        check_text(name, "a service's name")
        versions = {entry.service: entry.version for entry in self.registry.entries if is_called(entry.service, name)}
        if len(versions) == 1:
            return ServiceInfo(*versions.popitem())
        if versions:
            raise ConfigError(f"several services are called {name}; name one of {', '.join(sorted(versions))}")
        raise ConfigError(f"no service {name} is known; pass its definition: OCU(registry=jauspy.load(FILE))")

    def message_class(self, urn: str, version: str | None, name: str) -> type[Any]:
        """The message class of this JAUS name in a service, in this version of it when that is known.

        Raises `ConfigError` when the service, or the message in it, is not known.
        """
        check_text(name, "a message's name")
        for service, known_version in ((urn, version), *_list_driver(urn, version), (urn, None)):
            with suppress(ConfigError):
                return self.registry.by_name(name, service=service, version=known_version)
        if any(entry.service == urn for entry in self.registry.entries):
            raise ConfigError(f"{urn.removeprefix('urn:jaus:jss:')} has no message {name}")
        raise ConfigError(f"no definition of {urn} is known; pass it: OCU(registry=jauspy.load(FILE))")

    # --- receiving ------------------------------------------------------------------------------------------------

    def on_packet(self, packet: Packet) -> bool:
        """Take a received packet; false for commands and queries that nobody waits for: the OCU's services answer.

        Other messages that nobody waits for, such as late answers, are counted and named in the errors of timeouts.
        """
        self.stats.received += 1
        if self.trace is not None:
            self.trace(packet.source, self.id, packet.payload, sent=False)
        if len(packet.payload) < 2:
            self.on_malformed(f"{packet.payload.hex()!r} from {packet.source} is too short for a message")
            return True
        if self.replies.dispatch(packet.payload, packet.source):
            return True
        code = message_id(packet.payload)
        if code == RejectCommand.CODE:
            self._on_reject(packet.payload, packet.source)
            return True
        known = self.registry.by_code(code)
        inputs = self._component.host.inputs if self._component is not None else ()
        if code in inputs or any(kind.IS_COMMAND or kind.IS_QUERY for kind in known):
            return False
        self.stats.unexpected += 1
        name = known[0].NAME if known else f"{code:04X}h, which is not known here,"
        self.replies.note_unexpected(name, packet.source)
        return True

    def on_malformed(self, problem: str) -> None:
        """Count a message that could not be decoded."""
        self.stats.malformed += 1
        _LOG.debug("malformed: %s", problem)

    # --- sending --------------------------------------------------------------------------------------------------

    def send(
        self,
        destination: JausID,
        message: Message,
        *,
        priority: Priority = Priority.STANDARD,
        broadcast: Broadcast = Broadcast.NONE,
        ack: Ack = Ack.NONE,
    ) -> None:
        """Send a message; raises `EncodeError` when a value is out of range."""
        sealed = self._sealed(destination, message)
        self._opened().send(destination, sealed, priority=priority, broadcast=broadcast, ack=ack)
        self._on_sent(destination, message)

    async def send_checked(self, destination: JausID, message: Message, *, ack: bool) -> None:
        """Send for a user: `ControlRejected` is raised for a command to a component whose control is lost.

        With `ack` it is resent until acknowledged; `ResponseTimeout` is raised when no resend is.
        """
        check_message(message, "send()", "Resume()")
        self.controls.check(destination, message)
        await self._prepare(destination, message)
        if ack:
            await self._deliver(destination, message)
        else:
            self.send(destination, message)
            await asyncio.sleep(0)  # so that a loop that only sends lets other tasks run

    async def deliver(self, destination: JausID, message: Message) -> bool:
        """Send and wait; true when the message was acknowledged, false when it could not be delivered.

        What is sent after this cannot overtake it, as it could overtake a message that is resent in the background.
        """
        with suppress(JausError):  # not open, too many messages under way, or no such component
            await self._prepare(destination, message)
            await self._deliver(destination, message)
            return True
        return False

    async def _deliver(self, destination: JausID, message: Message) -> None:
        component, sealed = self._opened(), self._sealed(destination, message)
        self._on_sent(destination, message)
        try:
            await component.deliver(destination, sealed)
        except ResponseTimeout as error:
            raise ResponseTimeout(str(error).replace(sealed.NAME, message.NAME)) from None

    def next_request_id(self, destination: JausID) -> int:
        """The id of the next event or list request to this component; wraps after 255."""
        self.request_counts[destination] += 1
        return self.request_counts[destination] & 0xFF

    async def id_clash(self) -> str:
        """A sentence if another machine uses the id of this OCU; else empty."""
        other = await self._component.id_clash() if self._component is not None else None
        if other is None:
            return ""
        return (
            f"the id {self.id} is in use twice, by this program and at {other}, so answers may go to the other one; "
            "give one of them another id, as in OCU('42.1.7') or --id 42.1.7"
        )

    async def address_towards(self, id: JausID) -> str | None:
        """The IP address of this machine that routes to a component; None if it is not known."""
        location = await self.locate(id)
        if location.is_here:
            return LOOPBACK
        hosts = (*sorted(location.hosts), self._opened().host_towards(id))
        return next(filter(None, (address_towards(host) for host in hosts if host)), None)

    async def locate(self, id: JausID) -> Location:
        """The machine of a component, as far as it is known."""
        found: asyncio.Future[Location] = asyncio.get_running_loop().create_future()

        def on_found(location: Location) -> None:
            if not found.done():
                found.set_result(location)

        self._opened().host.locate(id, on_found)
        return await found

    # --- queries --------------------------------------------------------------------------------------------------

    async def query(
        self,
        destination: JausID,
        message: Message,
        *,
        retry: RetryPolicy | None = None,
        expects: type[Message] | None = None,
        accept: Callable[[Message], bool] = lambda _: True,
    ) -> Message:
        """The answer to a query. If no answer arrives, `ResponseTimeout` is raised.

        Equal queries may be outstanding at the same time. Different queries whose reports have the same class are
        sent one after the other, since most reports do not say which query they answer; where they do, `accept`
        chooses the report.
        """
        retry = retry or self.retry
        kind = reply_class(self.registry, message, expects)
        try:
            async with asyncio.timeout(retry.total) as deadline:
                async with self._serializer.enter((destination, kind.CODE), message.encode()):
                    deadline.reschedule(None)  # the deadline was for waiting; the exchange has its own timeouts
                    return await self._exchange(destination, message, retry, (kind,), accept)
        except TimeoutError:
            if not deadline.expired():
                raise
            self.stats.timeouts += 1
            raise ResponseTimeout(
                f"{message.NAME} was not sent to {destination}: for {retry.total:g} s another query waited for a "
                f"{kind.NAME} from there, which could not be distinguished from the answer to this query"
            ) from None

    async def query_each(
        self, destination: JausID, message: Message, seconds: float, expects: type[Message] | None = None
    ) -> AsyncIterator[Reply]:
        """Yield each answer and its sender as it arrives within `seconds`, one of each component."""
        check_number(seconds, "within")
        if not seconds > 0:
            raise ConfigError(f"within {seconds} s must be above 0")
        kind, own_id = reply_class(self.registry, message, expects, "query_each()"), self.id
        answers: asyncio.Queue[Reply] = asyncio.Queue()
        answered: set[JausID] = set()

        def on_answer(answer: Message, source: JausID) -> None:
            if source not in answered and source != own_id and len(answered) < MAX_ANSWERS:
                answered.add(source)
                answers.put_nowait((answer, source))

        clock = asyncio.get_running_loop().time
        now = clock()
        end, send_at = now + seconds, now
        broadcast = Broadcast.GLOBAL if destination.is_wildcard else Broadcast.NONE
        with self.replies.listening(destination, on_answer, kind):
            while (now := clock()) < end:
                if now >= send_at:
                    self.send(destination, message, broadcast=broadcast)
                    send_at = now + QUERY_EACH_INTERVAL
                try:
                    async with asyncio.timeout(min(send_at, end) - now):
                        answer = await answers.get()
                except TimeoutError:
                    continue
                yield answer
        while not answers.empty():  # these arrived in time, but the reader was slow
            yield answers.get_nowait()

    async def request(
        self,
        destination: JausID,
        message: Message,
        *answers: type[Message],
        accept: Callable[[Message], bool] = lambda _: True,
        retry: RetryPolicy | None = None,
    ) -> Message:
        """Send a command that is answered by one of `answers`, and return the answer."""
        return await self._exchange(destination, message, retry or self.retry, answers, accept)

    async def _exchange(
        self,
        destination: JausID,
        message: Message,
        retry: RetryPolicy,
        answers: tuple[type[Message], ...],
        accept: Callable[[Message], bool],
    ) -> Message:
        self.controls.check(destination, message)
        await self._prepare(destination, message)
        clock = asyncio.get_running_loop().time

        def is_answer(answer: Message) -> bool:
            return self._is_final(answer, message) if isinstance(answer, RejectCommand) else accept(answer)

        with self.replies.waiting(destination, *answers, RejectCommand, accept=is_answer) as waiter:
            for attempt in range(retry.retries + 1):
                sent_at = clock()
                self.send(destination, message)
                await asyncio.wait({waiter.reply}, timeout=retry.timeout)
                if waiter.reply.done():
                    answer, _ = waiter.reply.result()
                    if isinstance(answer, RejectCommand):
                        self.stats.refused += 1
                        raise _refused(destination, message, answer)
                    # After a retry it is not known which attempt was answered, hence no round-trip time.
                    self.stats.answered(clock() - sent_at if attempt == 0 else None)
                    return answer
            self.stats.timeouts += 1
            clash = await self.id_clash()
            why = f"{destination} did not answer {message.NAME}: {clash}" if clash else ""
            raise ResponseTimeout(why or _no_answer(destination, message, retry, waiter))

    # --- seals of an operator -------------------------------------------------------------------------------------

    async def _prepare(self, destination: JausID, message: Message) -> None:
        if self._sealer is not None:
            await self._sealer.prepare(destination, message)

    def _sealed(self, destination: JausID, message: Message) -> Message:
        return message if self._sealer is None else self._sealer.seal(destination, message)

    async def _ask_for_challenge(self, id: JausID) -> ReportSealChallenge:
        answer = await self.query(id, QuerySealChallenge(), retry=CHALLENGE_RETRY)
        assert isinstance(answer, ReportSealChallenge)
        return answer

    def _on_reject(self, payload: bytes, source: JausID) -> None:
        try:
            reject = self.registry.decode_as(RejectCommand, payload)
        except DecodeError as error:
            self.on_malformed(f"RejectCommand from {source}: {error}")
            return
        self.stats.refused += 1
        if self._sealer is None or not self._sealer.on_reject(reject, source):
            self._refusals.log(reject, source, self.registry)

    def _is_final(self, reject: RejectCommand, message: Message) -> bool:
        """True for the refusal of this message, unless it will be sealed anew."""
        can_help = self._sealer is not None and self._sealer.can_help(reject)
        return reject.message_code == message.CODE and not can_help

    def _on_sent(self, destination: JausID, message: Message) -> None:
        self.stats.sent += 1
        if self.trace is not None:
            self.trace(self.id, destination, message.encode(), sent=True)
        self.controls.on_sent(destination, message)

    def _opened(self) -> Component:
        if self._component is None:
            raise TransportError("the OCU is not open; use it inside `async with jauspy.OCU(...) as ocu:`")
        if self._loop is not asyncio.get_running_loop():
            raise TransportError(
                "the OCU was opened in another event loop and cannot be used from here; open and use it inside one "
                "`asyncio.run`, or use jauspy.sync.OCU, which any thread may call"
            )
        return self._component


def _refused(destination: JausID, message: Message, reject: RejectCommand) -> RequestError:
    kind = ControlRejected if message.CODE == RequestControl.CODE else RequestError
    hint = (
        "; give an operator's key (`OCU(operator=)`, `--operator-key`)"
        if reject.reason == RejectCommand.Reason.NO_SEAL
        else ""
    )
    return kind(f"{destination} refused {message.NAME}: {explained(reject.reason)}{hint}")


def _list_driver(urn: str, version: str | None) -> tuple[tuple[str, str | None], ...]:
    """The service that defines the messages for executing lists, for list drivers, which inherit from it."""
    inherits = urn.startswith(_LIST_DRIVER.removesuffix("ListDriver")) and urn.endswith("ListDriver")
    return ((_LIST_DRIVER, version),) if inherits else ()


def _no_answer(destination: JausID, message: Message, retry: RetryPolicy, waiter: ReplyWaiter) -> str:
    times = f"{retry.retries + 1} times" if retry.retries else "once"
    what = "no answer came"
    if waiter.problem:
        what = f"an answer came but could not be read ({waiter.problem})"
    elif waiter.other:
        what = f"no {waiter.kinds[0].NAME} came, but {waiter.other} did (`expects` says what to wait for)"
    return (
        f"{destination} was sent {message.NAME} {times} in {retry.total:g} s and {what}; check that the component "
        "runs and offers this, and that the node manager is reachable (`jauspy ls` shows who answers)"
    )
