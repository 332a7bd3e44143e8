"""The requests of clients in a recording, with the answers that they got."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Final, NamedTuple

from jauspy.capture.dissect import Part, read_message
from jauspy.capture.reader import Datagram, up_to_damage
from jauspy.codec.message import Message
from jauspy.codec.registry import Registry
from jauspy.errors import ConfigError
from jauspy.ids import ANY_SUBSYSTEM, JausID
from jauspy.inspection.traffic import seen_messages
from jauspy.messages.operators import SealedCommand
from jauspy.protocol.header import Ack, DataFlag, Packet
from jauspy.recording.mcap_capture import open_capture_file
from jauspy.replay.answers import AnswerMatcher
from jauspy.replay.events import EventKey, EventReports, event_of

MAX_REQUESTS: Final = 1_000_000
"""Requests of a recording that are replayed at once."""
MAX_CLIENTS: Final = 16
PATIENCE: Final = 3.0
"""Seconds in which an answer follows its request."""
FIRST_REPORT: Final = 0x4000
"""Message ids below are commands and queries (AS5710), unless a definition says otherwise."""


class RecordedMessage(NamedTuple):
    """A whole message; fragments are joined."""

    time: float
    packet: Packet
    message: Message | None
    """None for an unknown or invalid one."""

    @property
    def is_request(self) -> bool:
        """True for a query or command."""
        if self.message is not None:
            return self.message.IS_QUERY or self.message.IS_COMMAND
        payload = self.packet.payload
        return len(payload) >= 2 and payload[0] | payload[1] << 8 < FIRST_REPORT


@dataclass(slots=True)
class Request:
    """A command or query that a client sent, and its recorded answers by the component that sent them."""

    time: float
    """Seconds after the first request."""
    packet: Packet
    message: Message | None
    """Of a sealed command, the command inside."""
    sealed: bool = False
    """True for a command that an operator sealed."""
    answers: dict[JausID, Message] = field(default_factory=dict)


@dataclass(frozen=True, slots=True)
class Recording:
    """What is replayed."""

    requests: tuple[Request, ...]
    clients: tuple[JausID, ...]
    """The busiest first."""
    subsystem: int
    """The robot to which the requests were sent."""
    heard: frozenset[JausID]
    """Clients to which the recording has at least one answer; the others' answers were not recorded."""
    events: EventReports = field(default_factory=EventReports)
    """The reports of events that the requests created."""


def read_messages(
    path: Path, registry: Registry, on_damage: Callable[[str], None] | None = None
) -> Iterator[RecordedMessage]:
    """The messages in a pcap, pcapng or MCAP file in the order of their ends; raises `ConfigError`.

    With `on_damage`, a file that is damaged or cut off behind its first datagram ends there, and is told.
    """
    try:
        with path.open("rb") as file:
            capture: Iterable[Datagram] = open_capture_file(file, name=str(path), port=None)
            if on_damage is not None:
                capture = up_to_damage(capture, on_damage)
            for seen in seen_messages(capture, registry):
                packet, content = seen.part.packet, seen.part.content
                is_whole = packet.data_flag is DataFlag.SINGLE or len(content.payload) > len(packet.payload)
                if content.message is not None or (is_whole and packet.ack is not Ack.ACK):
                    yield RecordedMessage(seen.time, replace(packet, payload=content.payload), content.message)
    except OSError as error:
        raise ConfigError(f"{path} cannot be read: {error.strerror}") from None


def load(
    path: Path,
    registry: Registry,
    *,
    clients: Iterable[JausID] = (),
    subsystem: int | None = None,
    fits: Callable[[Part], bool] | None = None,
    on_damage: Callable[[str], None] | None = None,
) -> Recording:
    """The requests that clients sent to one subsystem, or to all.

    `clients` may be wildcard ids; by default all of other subsystems, or of the same if there are none. Without
    `subsystem` it is the one that received the most requests. `fits` says which requests are replayed.
    `on_damage` as in `read_messages`. Raises `ConfigError` if there are none.
    """
    wanted = tuple(clients)
    counts = _count(read_messages(path, registry, on_damage), wanted)
    if subsystem is None:
        subsystem = _busiest(counts)
    inside = bool(wanted) or not any(id.subsystem != subsystem for id, to in counts if to in (subsystem, ANY_SUBSYSTEM))
    clients_found: Counter[JausID] = Counter()
    for (id, to), count in counts.items():
        if to in (subsystem, ANY_SUBSYSTEM) and (inside or id.subsystem != subsystem):
            clients_found[id] += count
    found = [id for id, _ in clients_found.most_common()]
    if not found:
        raise ConfigError(f"{path} has no command or query of {_named(wanted)}{_to(subsystem)}")
    if len(found) > MAX_CLIENTS:
        raise ConfigError(f"{path} has {len(found)} clients, {MAX_CLIENTS} is the limit; choose with --from")
    again = None if on_damage is None else lambda _: None
    return _collect(
        read_messages(path, registry, again), path, registry, clients=tuple(found), subsystem=subsystem, fits=fits
    )


def _count(messages: Iterable[RecordedMessage], wanted: tuple[JausID, ...]) -> Counter[tuple[JausID, int]]:
    """How many requests each wanted client sent to which subsystem."""
    counts: Counter[tuple[JausID, int]] = Counter()
    for recorded in messages:
        source, to = recorded.packet.source, recorded.packet.destination.subsystem
        if recorded.is_request and (not wanted or any(id.matches(source) for id in wanted)):
            counts[source, to] += 1
    return counts


def _busiest(counts: Counter[tuple[JausID, int]]) -> int:
    """The subsystem that received the most requests of other subsystems, or, if there are none, of its own."""
    received: Counter[int] = Counter()
    for (source, to), count in counts.items():
        if to != ANY_SUBSYSTEM:
            received[to] += count if source.subsystem != to else 0
    if not any(received.values()):
        received.update({to: count for (_, to), count in counts.items() if to != ANY_SUBSYSTEM})
    return received.most_common(1)[0][0] if received else ANY_SUBSYSTEM


def _collect(
    messages: Iterable[RecordedMessage],
    path: Path,
    registry: Registry,
    *,
    clients: tuple[JausID, ...],
    subsystem: int,
    fits: Callable[[Part], bool] | None,
) -> Recording:
    requests: list[Request] = []
    matchers = {client: AnswerMatcher(registry, PATIENCE) for client in clients}
    heard: set[JausID] = set()
    events, confirmed = EventReports(), set[EventKey]()
    start: float | None = None
    for recorded in messages:
        packet, message = recorded.packet, recorded.message
        if packet.source in matchers and packet.destination.subsystem in (subsystem, ANY_SUBSYSTEM):
            if not recorded.is_request or (fits is not None and not fits(_part(recorded, registry))):
                continue
            if len(requests) >= MAX_REQUESTS:
                raise ConfigError(f"{path} has more than {MAX_REQUESTS} requests; choose with --filter")
            start = recorded.time if start is None else start
            sealed = isinstance(message, SealedCommand)
            if isinstance(message, SealedCommand):
                message = message.command if isinstance(message.command, Message) else None
            if message is not None:
                matchers[packet.source].sent(len(requests), packet.destination, message, recorded.time)
            requests.append(Request(recorded.time - start, packet, message, sealed))
        elif packet.source.subsystem == subsystem and packet.destination in matchers and message is not None:
            number = matchers[packet.destination].answered(packet.source, message, recorded.time)
            if number is not None:
                heard.add(packet.destination)
                requests[number].answers[packet.source] = message
                event_id = getattr(message, "event_id", None)
                if event_id is not None:
                    confirmed.add((packet.destination, packet.source, event_id))
            elif (event := event_of(message)) is not None and start is not None:
                key = packet.destination, packet.source, event[0]
                if key in confirmed:
                    events.add(key, recorded.time - start, event[1])
    if not requests:
        raise ConfigError(f"{path} has no command or query that fits the filter")
    return Recording(tuple(requests), clients, subsystem, frozenset(heard), events)


def _part(recorded: RecordedMessage, registry: Registry) -> Part:
    return Part(recorded.packet, read_message(recorded.packet.payload, registry))


def _named(wanted: tuple[JausID, ...]) -> str:
    return " or ".join(map(str, wanted)) or "any client"


def _to(subsystem: int) -> str:
    return "" if subsystem == ANY_SUBSYSTEM else f" to subsystem {subsystem}"
