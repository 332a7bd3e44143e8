"""The events of a component: a bounded table, each entry known to its creator alone."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Final

from jauspy.arguments import check_number
from jauspy.codec.base import Message
from jauspy.errors import ConfigError
from jauspy.ids import JausID

PERIODIC: Final = 0
EVERY_CHANGE: Final = 1
FIRST_CHANGE: Final = 2
ONE_TIME: Final = 3
KINDS: Final = frozenset({PERIODIC, EVERY_CHANGE})
EXTRA_KINDS: Final = frozenset({FIRST_CHANGE, ONE_TIME})
"""Kinds of event that AS5710 has no numbers for."""


@dataclass(slots=True, eq=False)
class ClientEvent:
    """What a client asked for; `request_id` is that of its last request about it."""

    id: int
    client: JausID
    request_id: int


@dataclass(slots=True, eq=False)
class Subscription(ClientEvent):
    """Reports of one query; keeps to `due` (time) and `period` (s). The client was told the rate `confirmed` (Hz)."""

    kind: int
    query: Message
    due: float
    period: float = 1.0
    confirmed: float = 1.0
    sequence: int = 0
    last: bytes | None = None
    asked: Message | None = None
    """Its query while the answer to that has not come yet."""


@dataclass(slots=True, eq=False)
class PendingCommand(ClientEvent):
    """A command under way, and whether it was carried out; None while that is open."""

    command: Message
    request: bytes
    """What its client sent."""
    success: bool | None = None
    known: bool = False
    """Its client has the confirmation, and so does not ask again."""


class Subscriptions:
    """By event id, 0..255, unique in the component."""

    def __init__(self, limit: int, limit_per_client: int) -> None:
        self._limit = min(limit, 256)
        self._limit_per_client = limit_per_client
        self._by_id: dict[int, ClientEvent] = {}
        self._next_id = 1

    def __len__(self) -> int:
        return len(self._by_id)

    def full_for(self, client: JausID) -> bool:
        """True when this client cannot have one more."""
        return len(self._by_id) >= self._limit or len(self.of(client)) >= self._limit_per_client

    def free_id(self) -> int:
        """An id that is not in use; ids of cancelled events come back last."""
        while self._next_id in self._by_id:
            self._next_id = self._next_id + 1 & 0xFF
        taken = self._next_id
        self._next_id = taken + 1 & 0xFF
        return taken

    def add(self, entry: ClientEvent) -> None:
        """Keep it under its id, in place of what is there."""
        self._by_id[entry.id] = entry

    def remove(self, entry: ClientEvent) -> None:
        """Forget it; fine when it is gone."""
        if self.holds(entry):
            del self._by_id[entry.id]

    def holds(self, entry: ClientEvent) -> bool:
        """True while this very entry is in the table."""
        return self._by_id.get(entry.id) is entry

    def find(self, id: int, client: JausID) -> ClientEvent | None:
        """The client's event with this id; another client's is unknown to it."""
        found = self._by_id.get(id)
        return found if found and found.client == client else None

    def same(self, client: JausID, kind: int, query: bytes) -> Subscription | None:
        """The client's event of this kind with this very query."""
        return next((each for each in self.queries(client) if each.kind == kind and each.query.encode() == query), None)

    def same_command(self, client: JausID, command: bytes) -> PendingCommand | None:
        """The client's command event for this very command."""
        watches = (each for each in self.of(client) if isinstance(each, PendingCommand))
        return next((each for each in watches if each.command.encode() == command), None)

    def all(self) -> list[ClientEvent]:
        """Everyone's events in the order of their ids."""
        return [each for _, each in sorted(self._by_id.items())]

    def of(self, client: JausID) -> list[ClientEvent]:
        """The client's events in the order of their ids."""
        return [each for each in self.all() if each.client == client]

    def queries(self, client: JausID) -> Iterator[Subscription]:
        """Those among them that report."""
        return (each for each in self.of(client) if isinstance(each, Subscription))


RATE_STEP: Final = 1092 / 65535
"""Rates travel as 16-bit numbers of 0..1092 Hz."""


@dataclass(frozen=True, slots=True)
class EventRates:
    """Limits (Hz) of periodic events, and of how often every-change events look for a change; 0 is never."""

    lowest: float
    highest: float
    change: float

    def __post_init__(self) -> None:
        for name, value in (("min_rate", self.lowest), ("max_rate", self.highest), ("max_change_rate", self.change)):
            check_number(value, f"events: {name}")
        if not 0 < self.lowest <= 1092 or not 0 <= self.highest <= 1092 or not 0 <= self.change <= 1092:
            raise ConfigError(
                f"events: min_rate {self.lowest}, max_rate {self.highest} and max_change_rate {self.change} "
                "must be 0..1092 Hz, and min_rate more than 0"
            )

    def periodic(self, asked: float) -> float:
        """The rate of a periodic event."""
        return _on_wire(max(asked, self.lowest), self.highest)

    def on_change(self, asked: float) -> float:
        """The most that an every-change event reports; 0, as asked for, leaves it open: as often as allowed."""
        return _on_wire(asked, self.change) if asked else 0.0


def _on_wire(rate: float, most: float) -> float:
    """The nearest rate that the wire can say, and not more than allowed unless that is less than one step."""
    steps = min(round(rate / RATE_STEP), int(most / RATE_STEP + 1e-6))
    return max(1, steps) * RATE_STEP
