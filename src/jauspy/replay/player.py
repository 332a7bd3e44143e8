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
from jauspy.errors import ConfigError, ProtocolError
from jauspy.ids import JausID
from jauspy.messages.core import ReleaseControl, RequestControl
from jauspy.protocol.header import Ack, Packet
from jauspy.replay.answers import AnswerMatcher
from jauspy.replay.comparison import Comparison
from jauspy.replay.recorded import PATIENCE, Recording, Request
from jauspy.services.core import with_core_services
from jauspy.services.host import Host
from jauspy.transport import Transport

MAX_DIFFERENCES: Final = 10_000
"""Differences that are listed; more are only counted."""
MIN_INTERVAL: Final = 0.002
"""Seconds between requests without an answer, when they are sent as fast as answers come."""
ID_FIELDS: Final = ("subsystem_id", "node_id", "component_id")
"""Names of the parts of an id in messages of AS5710."""
NO_ANSWER: Final = "(no answer)"
_LAST_COMPONENT: Final = 254

DEFAULT_CLIENT: Final = JausID(42, 1, 2)

MakeTransport: TypeAlias = Callable[[JausID], Awaitable[Transport]]
OnAnswer: TypeAlias = Callable[[int, JausID, Message], None]
"""Called with the number of a request, the component that answers, and its answer."""


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
    answers: int = 0
    """Recorded answers that were compared."""
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


class _Client:
    """One recorded client, by its id of now."""

    def __init__(self, id: JausID, registry: Registry, timeout: float, on_answer: OnAnswer) -> None:
        self.id = id
        self.matcher = AnswerMatcher(registry, timeout)
        self.event_ids: dict[tuple[JausID, int], int] = {}
        """Event ids of now, by component of now and recorded event id."""
        self.controlled: set[JausID] = set()
        self._registry, self._on_answer = registry, on_answer
        self.component: Component | None = None

    def intercept(self, packet: Packet) -> bool:
        """Take an answer; queries of others are left to the services."""
        content = read_message(packet.payload, self._registry)
        message = content.message
        if message is None:
            return True
        if message.IS_QUERY or message.IS_COMMAND:
            return False
        number = self.matcher.answered(packet.source, message, loop_time())
        if number is not None:
            self._on_answer(number, packet.source, message)
        return True


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
        self._arrived = asyncio.Event()
        self._recorded_ids: dict[tuple[int, int, int], JausID] = {}
        """Recorded ids of the clients, by the parts of their ids of now."""
        self._result = Result()
        self._clients: dict[JausID, _Client] = {}
        """The clients by their recorded ids."""
        for recorded, id in zip(recording.clients, _ids_for(recording.clients, playback.client), strict=True):
            self._clients[recorded] = _Client(id, registry, playback.timeout, self._on_answer)
            self._recorded_ids[id.subsystem, id.node, id.component] = recorded

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
                stack.callback(self._release, client)
            yield

    def _release(self, client: _Client) -> None:
        assert client.component is not None
        for id in client.controlled:
            client.component.send(id, ReleaseControl())

    async def send_all(self) -> None:
        """Send each request at its time, or when the one before was answered."""
        start, speed = loop_time(), self._playback.speed
        for number, request in enumerate(self._recording.requests):
            if speed is not None:
                await asyncio.sleep(max(0.0, start + request.time / speed - loop_time()))
            self._send(number, request)
            if speed is None:
                await (self._wait_for(number) if request.answers else asyncio.sleep(MIN_INTERVAL))

    async def wait_for_rest(self) -> None:
        """Wait for answers that are missing, no longer than the time limit."""
        end = loop_time() + self._playback.timeout
        while self._missing and (left := end - loop_time()) > 0.0:
            await self._next_arrival(left)

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
        event_id = getattr(message, "event_id", None)
        if message is not None and event_id is not None:
            known: Any = client.event_ids.get((destination, event_id), event_id)
            if known != event_id:
                message = replace(message, event_id=known)  # type: ignore[type-var]  # messages are dataclasses
                payload = message.encode(strict=False)
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
        now = self._playback.subsystem
        if now is None or id.subsystem != self._recording.subsystem:
            return id
        return replace(id, subsystem=now)

    def _with_recorded_id(self, message: Message) -> Message:
        """A message with a client's recorded id where it has the one of now, such as who is in control."""
        parts: Any = tuple(getattr(message, name, None) for name in ID_FIELDS)
        recorded = self._recorded_ids.get(parts)
        if recorded is None:
            return message
        values = (recorded.subsystem, recorded.node, recorded.component)
        changed: Message = replace(message, **dict(zip(ID_FIELDS, values, strict=True)))  # type: ignore[type-var]
        return changed

    def result(self) -> Result:
        """The differences, in the order of the requests."""
        result = self._result
        for number, request in enumerate(self._recording.requests):
            live = self._live.get(number, {})
            if request.packet.source not in self._recording.heard:
                result.not_recorded += len(live)
                continue
            name = request.message.NAME if request.message is not None else f"message {number}"
            recorded = {self._live_id(id): (id, answer) for id, answer in request.answers.items()}
            for id_now, (id, answer) in recorded.items():
                result.answers += 1
                if id_now not in live:
                    result.add(Difference(request.time, name, str(id), "", answer.NAME, NO_ANSWER))
                    continue
                for path, old, new in self._playback.comparison.differences(
                    answer, self._with_recorded_id(live[id_now])
                ):
                    result.add(Difference(request.time, name, str(id), path, old, new))
            for id_now in live.keys() - recorded.keys():
                answer = live[id_now]
                result.add(Difference(request.time, name, str(id_now), "", NO_ANSWER, answer.NAME))
        return result


def _ids_for(recorded: tuple[JausID, ...], first: JausID) -> list[JausID]:
    """An id of now for each client: consecutive components."""
    last = first.component + len(recorded) - 1
    if last > _LAST_COMPONENT:
        raise ConfigError(f"{len(recorded)} clients from {first} on need components up to {last}; 254 is the last one")
    return [replace(first, component=first.component + number) for number in range(len(recorded))]
