"""The datagrams of a run: time, direction and decoded content. Their number is bounded, so no verdict depends on it."""

from __future__ import annotations

from dataclasses import dataclass
from enum import StrEnum
from functools import cached_property
from typing import Final

from jauspy.codec.message import Message
from jauspy.codec.registry import Registry
from jauspy.codec.rounding import rounded
from jauspy.errors import DecodeError
from jauspy.ids import JausID, message_id
from jauspy.messages import registry as known_messages
from jauspy.protocol import judp
from jauspy.protocol.header import Packet


class Direction(StrEnum):
    """Direction as seen from the tester."""

    SENT = ">"
    RECEIVED = "<"


@dataclass(frozen=True)
class TraceEntry:
    """One datagram; `at` is in seconds since the run began."""

    at: float
    direction: Direction
    data: bytes
    registry: Registry
    other_port: bool = False
    """True if it was sent or received on the second UDP port of the tester."""

    @cached_property
    def packets(self) -> tuple[Packet, ...]:
        """The AS5669A packets that it contains."""
        return tuple(judp.unpack_all(self.data)[0])

    @cached_property
    def lines(self) -> tuple[str, ...]:
        """A line for each packet: from, to, message and fields."""
        if not self.packets:
            return (f"{len(self.data)} bytes that are no AS5669A packet",)
        return tuple(f"{packet.source} to {packet.destination}: {self._content(packet)}" for packet in self.packets)

    def __reduce__(self) -> tuple[object, ...]:
        """Pickle without the definitions, which are those of this process: what was decoded goes along."""
        return _unpickled, (self.at, str(self.direction), self.data, self.lines, self.other_port)

    def _content(self, packet: Packet) -> str:
        if not packet.payload:
            return f"{packet.ack.name}, sequence number {packet.sequence}"
        return described(packet.payload, self.registry)


def _unpickled(at: float, direction: str, data: bytes, lines: tuple[str, ...], other_port: bool) -> TraceEntry:
    entry = TraceEntry(at, Direction(direction), data, known_messages, other_port)
    entry.__dict__["lines"] = lines
    return entry


def described(payload: bytes, registry: Registry) -> str:
    """A message on one line: name, fields, and deviations from its definition."""
    if len(payload) < 2:
        return f"{payload.hex()}: too short for a message"
    code = f"{message_id(payload):04X}h"
    try:
        message, deviations = registry.decode(payload, strict=False)
    except DecodeError:
        return f"{code} {payload[2:].hex()}".strip()
    wrong = f" ({'; '.join(map(str, deviations))})" if deviations else ""
    return f"{code} {rounded(message)!r}{wrong}"


def message_name(kind: type[Message]) -> str:
    """The name and id of a message, as in `ReportStatus 4002h`."""
    return f"{kind.NAME} {kind.CODE:04X}h"


@dataclass(frozen=True, slots=True)
class ReceivedMessage:
    """One whole message that a client received; `at` is in seconds since the run began."""

    at: float
    client: JausID
    source: JausID
    payload: bytes
    broadcast: bool = False
    """True for a message to everyone, which answers nobody."""

    @property
    def code(self) -> int:
        """Message id of the datagram."""
        return message_id(self.payload)


MAX_STEP_ENTRIES: Final = 2000
"""Datagrams kept of one step; usually there are at most a few hundred."""
MAX_ENTRIES: Final = 200_000
"""Datagrams of a run after which a step keeps fewer."""
MAX_STEP_ENTRIES_WHEN_FULL: Final = 100
"""Datagrams kept of each of these later steps."""


class DatagramTrace:
    """Keeps the first datagrams of each step; the others are counted."""

    def __init__(self) -> None:
        self.entries: list[TraceEntry] = []
        self.omitted = 0
        self._first = 0
        self._omitted_before = 0

    def begin(self) -> None:
        """Start a step."""
        self._first, self._omitted_before = len(self.entries), self.omitted

    def add(self, entry: TraceEntry) -> None:
        """Keep a datagram, or count it as omitted."""
        room = MAX_STEP_ENTRIES if len(self.entries) < MAX_ENTRIES else MAX_STEP_ENTRIES_WHEN_FULL
        if len(self.entries) - self._first < room:
            self.entries.append(entry)
        else:
            self.omitted += 1

    @property
    def of_step(self) -> tuple[TraceEntry, ...]:
        """The datagrams that are kept of this step."""
        return tuple(self.entries[self._first :])

    @property
    def omitted_in_step(self) -> int:
        """Number of datagrams of this step that are not kept."""
        return self.omitted - self._omitted_before
