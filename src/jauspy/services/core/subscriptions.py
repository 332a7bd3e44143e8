"""The events of a component in a bounded table. Each event is known to its client only."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Final

from jauspy.codec.message import Message
from jauspy.ids import JausID

PERIODIC: Final = 0
EVERY_CHANGE: Final = 1
FIRST_CHANGE: Final = 2
ONE_TIME: Final = 3
KINDS: Final = frozenset({PERIODIC, EVERY_CHANGE})
EXTRA_KINDS: Final = frozenset({FIRST_CHANGE, ONE_TIME})
"""Kinds of event that AS5710 does not number."""


@dataclass(slots=True, eq=False)
class ClientEvent:
    """An event of one client; `request_id` is that of its last request about it."""

    id: int
    client: JausID
    request_id: int


@dataclass(slots=True, eq=False)
class EventSubscription(ClientEvent):
    """Reports of one query, next at `due` (s), every `period` (s). `confirmed` is the rate that was confirmed (Hz)."""

    kind: int
    query: Message
    content: bytes
    """The query as it was requested."""
    due: float
    period: float = 1.0
    confirmed: float = 1.0
    sequence: int = 0
    last: bytes | None = None
    pending_query: Message | None = None
    """The query while its reply is deferred."""


@dataclass(slots=True, eq=False)
class PendingCommand(ClientEvent):
    """A command event: `success` says whether the command was carried out, None while it is pending."""

    command: Message
    request: bytes
    """The encoded CreateCommandEvent."""
    success: bool | None = None
    confirmation_acknowledged: bool = False
    """The client has the confirmation, and so does not repeat its request."""


class Subscriptions:
    """Events by their ids, 0..255, which are unique in the component."""

    def __init__(self, limit: int, limit_per_client: int) -> None:
        self._limit = min(limit, 256)
        self._limit_per_client = limit_per_client
        self._by_id: dict[int, ClientEvent] = {}
        self._by_client: dict[JausID, dict[int, ClientEvent]] = {}
        self._next_id = 1

    def __len__(self) -> int:
        return len(self._by_id)

    def full_for(self, client: JausID, *, in_control: bool) -> bool:
        """True when this client cannot have another event; a quarter is kept for a client in control."""
        limit = self._limit if in_control else self._limit - self._limit // 4
        return len(self._by_id) >= limit or len(self._by_client.get(client, ())) >= self._limit_per_client

    def free_id(self) -> int:
        """Return an id that is not in use; ids of cancelled events are reused last."""
        while self._next_id in self._by_id:
            self._next_id = self._next_id + 1 & 0xFF
        taken = self._next_id
        self._next_id = taken + 1 & 0xFF
        return taken

    def add(self, entry: ClientEvent) -> None:
        """Add it under its id, replacing the event with this id."""
        replaced = self._by_id.get(entry.id)
        if replaced is not None:
            self.remove(replaced)
        self._by_id[entry.id] = self._by_client.setdefault(entry.client, {})[entry.id] = entry

    def remove(self, entry: ClientEvent) -> None:
        """Remove the event, if it is in the table."""
        if self.holds(entry):
            del self._by_id[entry.id]
            of_client = self._by_client[entry.client]
            del of_client[entry.id]
            if not of_client:
                del self._by_client[entry.client]

    def holds(self, entry: ClientEvent) -> bool:
        """True while this very entry is in the table."""
        return self._by_id.get(entry.id) is entry

    def find(self, id: int, client: JausID) -> ClientEvent | None:
        """The client's event with this id; None for an event of another client."""
        found = self._by_id.get(id)
        return found if found and found.client == client else None

    def same(self, client: JausID, kind: int, query: bytes) -> EventSubscription | None:
        """The client's event of this kind with this very query."""
        return next(
            (
                subscription
                for subscription in self.queries(client)
                if subscription.kind == kind and subscription.content == query
            ),
            None,
        )

    def same_command(self, client: JausID, command: bytes) -> PendingCommand | None:
        """The client's command event for this very command."""
        watches = (event for event in self.of(client) if isinstance(event, PendingCommand))
        return next((watch for watch in watches if watch.command.encode() == command), None)

    def all(self) -> list[ClientEvent]:
        """Everyone's events in the order of their ids."""
        return [item for _, item in sorted(self._by_id.items())]

    def of(self, client: JausID) -> list[ClientEvent]:
        """The client's events in the order of their ids."""
        return [item for _, item in sorted(self._by_client.get(client, {}).items())]

    def has(self, client: JausID) -> bool:
        """True when the client has an event."""
        return client in self._by_client

    def queries(self, client: JausID) -> Iterator[EventSubscription]:
        """The subscriptions of the client."""
        return (event for event in self.of(client) if isinstance(event, EventSubscription))
