"""Sends recorded requests with new ids and sequence numbers, and compares the answers."""

from __future__ import annotations

import asyncio
from collections.abc import AsyncIterator, Awaitable, Callable
from contextlib import AsyncExitStack, asynccontextmanager
from dataclasses import dataclass, field, replace
from datetime import UTC, datetime
from typing import Any, Final, TypeAlias

from jauspy.capture.dissect import read_message
from jauspy.codec.message import Message
from jauspy.codec.registry import Registry
from jauspy.component import Component, ComponentOptions
from jauspy.component.component import loop_time
from jauspy.errors import ConfigError, ProtocolError, ResponseTimeout
from jauspy.ids import JausID
from jauspy.messages.core import ReleaseControl, RequestControl
from jauspy.messages.operators import QuerySealChallenge, RejectCommand, ReportSealChallenge
from jauspy.ocu.sealing import CommandSealer
from jauspy.protocol.header import Ack, Packet
from jauspy.protocol.seal import OperatorKey
from jauspy.replay.answers import AnswerMatcher
from jauspy.replay.comparison import Comparison
from jauspy.replay.events import EventReports, event_differences, event_of
from jauspy.replay.ids import with_other_ids
from jauspy.replay.recorded import PATIENCE, Recording, Request
from jauspy.services.core import with_core_services
from jauspy.services.host import Host
from jauspy.transport import Transport

MAX_DIFFERENCES: Final = 10_000
"""Differences that are listed; more are only counted."""
MIN_INTERVAL: Final = 0.002
"""Seconds between requests without an answer, when they are sent as fast as answers come."""
NO_ANSWER: Final = "(no answer)"
NOT_SENT: Final = "(not sent)"
_LAST_COMPONENT: Final = 254

DEFAULT_CLIENT: Final = JausID(42, 1, 2)

MakeTransport: TypeAlias = Callable[[JausID], Awaitable[Transport]]
OnAnswer: TypeAlias = Callable[[int, JausID, Message], None]
"""Called with the number of a request, the component that answers, and its answer."""
OnEvent: TypeAlias = Callable[["_Client", JausID, int, Message], None]
"""Called with a client, the component that reports, the number of the event, and the report."""


@dataclass(frozen=True, slots=True)
class Difference:
    """One field, or a whole answer, that is not as recorded."""

    time: float
    """Seconds after the first request, in the recording."""
    request: str
    source: str
    """The component that answers, by its recorded id."""
    field: str
    """Path of the field; empty if another message came, or none."""
    recorded: str
    live: str

    def __str__(self) -> str:
        what = f"{self.field}: " if self.field else ""
        return f"{self.time:.3f} s, {self.request} to {self.source}: {what}{self.recorded} recorded, {self.live} now"


@dataclass(slots=True)
class Result:
    """What came of a replay."""

    sent: int = 0
    unsendable: int = 0
    """Requests that are too large, or to many at once."""
    sealed: int = 0
    """Commands that operators sealed and that are not sent: without a key, or because the robot gave no challenge.
    `Comparison.strict` makes each a difference."""
    answers: int = 0
    """Recorded answers that were compared."""
    events: int = 0
    """Events whose reports were compared."""
    not_recorded: int = 0
    """Answers of now to clients whose answers the recording does not have; they were not compared."""
    differences: list[Difference] = field(default_factory=list)
    more: int = 0
    """Differences beyond `MAX_DIFFERENCES`."""

    def add(self, difference: Difference) -> None:
        """Add a difference."""
        if len(self.differences) < MAX_DIFFERENCES:
            self.differences.append(difference)
        else:
            self.more += 1


@dataclass(frozen=True, slots=True)
class Playback:
    """How a recording is replayed."""

    speed: float | None = 1.0
    """Times the recorded speed; None: as fast as answers come."""
    timeout: float = PATIENCE
    """Seconds to wait for an answer."""
    client: JausID = DEFAULT_CLIENT
    """The id of the first client; further ones have the next numbers."""
    subsystem: int | None = None
    """The robot's subsystem now; None: as recorded."""
    comparison: Comparison = field(default_factory=Comparison)
    operator: OperatorKey | None = None
    """Seals anew what operators had sealed; without it sealed commands are not sent, because a seal is valid once."""


class _Client:
    """One recorded client, by its id of now."""

    def __init__(
        self, id: JausID, registry: Registry, playback: Playback, on_answer: OnAnswer, on_event: OnEvent
    ) -> None:
        self.id = id
        self.matcher = AnswerMatcher(registry, playback.timeout)
        operator = playback.operator
        self._sealer = None if operator is None else CommandSealer(operator, id, self._ask_for_challenge)
        self._timeout = playback.timeout
        self._challenges: dict[JausID, asyncio.Future[ReportSealChallenge]] = {}
        """Challenges that components were asked for."""
        self.event_ids: dict[tuple[JausID, int], int] = {}
        """Event ids of now, by component of now and recorded event id."""
        self.controlled: set[JausID] = set()
        self._registry, self._on_answer, self._on_event = registry, on_answer, on_event
        self.component: Component | None = None

    async def prepare_seal(self, destination: JausID, command: Message) -> None:
        """Ask for the challenge to which the seal of this command refers."""
        if self._sealer is not None:
            await self._sealer.prepare(destination, command)

    def seal(self, destination: JausID, command: Message) -> Message | None:
        """The sealed command; None without a key or a challenge."""
        if self._sealer is None:
            return None
        sealed = self._sealer.seal(destination, command)
        return None if sealed is command else sealed

    async def _ask_for_challenge(self, destination: JausID) -> ReportSealChallenge:
        assert self.component is not None
        answer: asyncio.Future[ReportSealChallenge] = asyncio.get_running_loop().create_future()
        self._challenges[destination] = answer
        self.component.send(destination, QuerySealChallenge())
        try:
            async with asyncio.timeout(self._timeout):
                return await answer
        except TimeoutError:
            raise ResponseTimeout(f"{destination} gave no challenge for a seal") from None
        finally:
            del self._challenges[destination]

    def close(self) -> None:
        """Release control, and end the queries for challenges."""
        assert self.component is not None
        for id in self.controlled:
            self.component.send(id, self.seal(id, ReleaseControl()) or ReleaseControl())
        if self._sealer is not None:
            self._sealer.close()

    def intercept(self, packet: Packet) -> bool:
        """Take an answer; queries of others are left to the services."""
        content = read_message(packet.payload, self._registry)
        message = content.message
        if message is None:
            return True
        if message.IS_QUERY or message.IS_COMMAND:
            return False
        asked = self._challenges.get(packet.source)
        if isinstance(message, ReportSealChallenge) and asked is not None and not asked.done():
            asked.set_result(message)
            return True
        if isinstance(message, RejectCommand) and self._sealer is not None:
            self._sealer.on_reject(message, packet.source)
        number = self.matcher.answered(packet.source, message, loop_time())
        if number is not None:
            self._on_answer(number, packet.source, message)
        elif (event := event_of(message)) is not None:
            self._on_event(self, packet.source, *event)
        return True

    def recorded_event(self, source: JausID, now: int) -> int | None:
        """The recorded id of an event."""
        return next((old for (id, old), new in self.event_ids.items() if (id, new) == (source, now)), None)


async def replay(
    recording: Recording,
    registry: Registry,
    transport: MakeTransport,
    playback: Playback = Playback(),
    *,
    utc_now: Callable[[], datetime] = lambda: datetime.now(UTC),
) -> Result:
    """Send the requests, wait for their answers, and compare them; control that was requested is released at the end.

    Raises `TransportError` if a client cannot connect, and `ConfigError` if there are no ids for all clients.
    """
    player = _Player(recording, registry, playback)
    async with player.opened(transport, utc_now):
        await player.send_all()
        await player.wait_for_rest()
    return player.result()


class _Player:
    def __init__(self, recording: Recording, registry: Registry, playback: Playback) -> None:
        self._recording, self._playback = recording, playback
        self._live: dict[int, dict[JausID, Message]] = {}
        self._missing: dict[int, int] = {}
        """How many recorded answers of a request that was sent have not come."""
        self._unsealed: set[int] = set()
        """Requests that were not sent, because they were sealed and could not be sealed anew."""
        self._arrived = asyncio.Event()
        self._recorded_ids: dict[JausID, JausID] = {}
        """Recorded ids of the clients, by their ids of now."""
        self._events = EventReports()
        self._ended = False
        self._result = Result()
        self._clients: dict[JausID, _Client] = {}
        """The clients by their recorded ids."""
        for recorded, id in zip(recording.clients, _ids_for(recording.clients, playback.client), strict=True):
            self._clients[recorded] = _Client(id, registry, playback, self._on_answer, self._on_event)
            self._recorded_ids[id] = recorded

    @asynccontextmanager
    async def opened(self, transport: MakeTransport, utc_now: Callable[[], datetime]) -> AsyncIterator[None]:
        """The clients are connected; at the end they release control."""
        async with AsyncExitStack() as stack:
            for client in self._clients.values():
                services = with_core_services([], "jauspy replay")
                host = Host(client.id, services, utc_now=utc_now, now=loop_time())
                options = ComponentOptions(clock=loop_time, utc_now=utc_now)
                client.component = Component.of_host(
                    host, await transport(client.id), intercept=client.intercept, options=options
                )
                await stack.enter_async_context(client.component)
                stack.callback(client.close)
            yield

    async def send_all(self) -> None:
        """Send each request at its time, or when the one before was answered."""
        start, speed = loop_time(), self._playback.speed
        for number, request in enumerate(self._recording.requests):
            if speed is not None:
                await asyncio.sleep(max(0.0, start + request.time / speed - loop_time()))
            if request.sealed and request.message is not None:
                client = self._clients[request.packet.source]
                await client.prepare_seal(self._live_id(request.packet.destination), request.message)
            self._send(number, request)
            if speed is None:
                await (self._wait_for(number) if request.answers else asyncio.sleep(MIN_INTERVAL))

    async def wait_for_rest(self) -> None:
        """Wait for answers that are missing, no longer than the time limit."""
        end = loop_time() + self._playback.timeout
        while self._missing and (left := end - loop_time()) > 0.0:
            await self._next_arrival(left)
        self._ended = True

    async def _wait_for(self, number: int) -> None:
        end = loop_time() + self._playback.timeout
        while number in self._missing and (left := end - loop_time()) > 0.0:
            await self._next_arrival(left)
        self._missing.pop(number, None)

    async def _next_arrival(self, seconds: float) -> None:
        self._arrived.clear()
        try:
            async with asyncio.timeout(seconds):
                await self._arrived.wait()
        except TimeoutError:
            return

    def _send(self, number: int, request: Request) -> None:
        client = self._clients[request.packet.source]
        destination = self._live_id(request.packet.destination)
        message, payload = request.message, request.packet.payload
        if message is not None:
            changed = self._with_event_of_now(with_other_ids(message, self._live_id), client, destination)
            if changed is not message:
                message, payload = changed, changed.encode(strict=False)
        if request.sealed:
            sealed = None if message is None else client.seal(destination, message)
            if sealed is None:
                self._result.sealed += 1
                self._unsealed.add(number)
                return
            payload = sealed.encode(strict=False)
        if message is not None:
            client.matcher.sent(number, destination, message, loop_time())
            if message.CODE == RequestControl.CODE and not destination.is_wildcard:
                client.controlled.add(destination)
        packet = request.packet
        ack = Ack.REQUIRED if packet.ack is Ack.REQUIRED else Ack.NONE
        assert client.component is not None
        if request.answers:
            self._missing[number] = len(request.answers)
        try:
            client.component.send_encoded(
                destination, payload, priority=packet.priority, broadcast=packet.broadcast, ack=ack
            )
        except ProtocolError:
            self._result.unsendable += 1
            self._missing.pop(number, None)
            return
        self._result.sent += 1

    @staticmethod
    def _with_event_of_now(message: Message, client: _Client, destination: JausID) -> Message:
        event_id = getattr(message, "event_id", None)
        known: Any = event_id if event_id is None else client.event_ids.get((destination, event_id), event_id)
        if known == event_id:
            return message
        changed: Message = replace(message, event_id=known)  # type: ignore[type-var]  # messages are dataclasses
        return changed

    def _on_event(self, client: _Client, source: JausID, number: int, report: Message) -> None:
        recorded = client.recorded_event(source, number)
        if recorded is not None and not self._ended:  # control that is released afterwards has reports, too
            key = self._recorded_id(client.id), self._recorded_id(source), recorded
            self._events.add(key, loop_time(), with_other_ids(report, self._recorded_id))

    def _on_answer(self, number: int, source: JausID, message: Message) -> None:
        self._live.setdefault(number, {})[source] = message
        request = self._recording.requests[number]
        recorded = {self._live_id(id): answer for id, answer in request.answers.items()}.get(source)
        before, now = getattr(recorded, "event_id", None), getattr(message, "event_id", None)
        if before is not None and now is not None:
            self._clients[request.packet.source].event_ids[source, before] = now
        if recorded is not None and number in self._missing:
            self._missing[number] -= 1
            if not self._missing[number]:
                del self._missing[number]
        self._arrived.set()

    def _live_id(self, id: JausID) -> JausID:
        """The id of now of a client, or of a component of the robot; others are the same."""
        now = self._playback.subsystem
        if id in self._clients:
            return self._clients[id].id
        if now is None or id.subsystem != self._recording.subsystem:
            return id
        return replace(id, subsystem=now)

    def _recorded_id(self, id: JausID) -> JausID:
        """The inverse of `_live_id`."""
        if id in self._recorded_ids:
            return self._recorded_ids[id]
        if self._playback.subsystem is None or id.subsystem != self._playback.subsystem:
            return id
        return replace(id, subsystem=self._recording.subsystem)

    def result(self) -> Result:
        """The differences, in the order of the requests."""
        result = self._result
        for number, request in enumerate(self._recording.requests):
            name = request.message.NAME if request.message is not None else f"message {number}"
            if number in self._unsealed:
                if self._playback.comparison.strict:
                    to = str(request.packet.destination)
                    result.add(Difference(request.time, name, to, "", "sealed by an operator", NOT_SENT))
                continue
            live = self._live.get(number, {})
            if request.packet.source not in self._recording.heard:
                result.not_recorded += len(live)
                continue
            recorded = {self._live_id(id): (id, answer) for id, answer in request.answers.items()}
            for id_now, (id, answer) in recorded.items():
                result.answers += 1
                if id_now not in live:
                    result.add(Difference(request.time, name, str(id), "", answer.NAME, NO_ANSWER))
                    continue
                answer_now = with_other_ids(live[id_now], self._recorded_id)
                for path, old, new in self._playback.comparison.differences(answer, answer_now):
                    result.add(Difference(request.time, name, str(id), path, old, new))
            for id_now in live.keys() - recorded.keys():
                answer = live[id_now]
                result.add(Difference(request.time, name, str(id_now), "", NO_ANSWER, answer.NAME))
        self._compare_events(result)
        return result

    def _compare_events(self, result: Result) -> None:
        """Add the differences of reports of events; only in the recorded time their number is compared, too."""
        whole = self._playback.speed == 1.0
        for key, recorded in self._recording.events.by_event.items():
            result.events += 1
            live = self._events.by_event.get(key, [])
            name = f"Event {key[2]}"
            for found in event_differences(recorded, live, self._playback.comparison, whole=whole):
                time, path, old, new = found
                result.add(Difference(time, name, str(key[1]), path, old, new))


def _ids_for(recorded: tuple[JausID, ...], first: JausID) -> list[JausID]:
    """An id of now for each client: consecutive components."""
    last = first.component + len(recorded) - 1
    if last > _LAST_COMPONENT:
        raise ConfigError(f"{len(recorded)} clients from {first} on need components up to {last}; 254 is the last one")
    return [replace(first, component=first.component + number) for number in range(len(recorded))]
