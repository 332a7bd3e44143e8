"""Queries and requests for events that wait, so that commands are handled before them."""

from __future__ import annotations

from collections import OrderedDict, deque
from typing import Final, TypeAlias

from jauspy.ids import message_id
from jauspy.messages.core import CancelEvent, CreateCommandEvent, CreateEvent, UpdateEvent
from jauspy.protocol.counters import Counters
from jauspy.protocol.header import Packet

MAX_WAITING: Final = 1024
"""Packets; one more replaces the oldest one of the client that has most of them."""

_EVENT_REQUESTS: Final = frozenset(kind.CODE for kind in (CreateEvent, UpdateEvent, CancelEvent, CreateCommandEvent))
_FIRST_QUERY, _LAST_QUERY = 0x2000, 0x3FFF
"""Codes of queries (AS5710)."""

_QueueKey: TypeAlias = tuple[int, bool]


class ClientInbox:
    """One packet of each client in turn, those of one client in their order.

    A client's requests for events and its queries are two clients here: the first take longer.
    """

    def __init__(self, counters: Counters) -> None:
        self._counters = counters
        self._queues: OrderedDict[_QueueKey, deque[Packet]] = OrderedDict()
        self._size = 0

    def __len__(self) -> int:
        return self._size

    def put(self, packet: Packet) -> None:
        """Add a packet; when there are too many, one is dropped and counted."""
        key = (int(packet.source), _code(packet) in _EVENT_REQUESTS)
        self._queues.setdefault(key, deque()).append(packet)
        self._size += 1
        if self._size > MAX_WAITING:
            self._drop(max(self._queues, key=lambda client: len(self._queues[client])))

    def take(self) -> Packet | None:
        """Remove and return the packet whose turn it is."""
        if not self._size:
            return None
        key, queue = self._queues.popitem(last=False)
        packet = queue.popleft()
        self._size -= 1
        if queue:
            self._queues[key] = queue
        return packet

    def _drop(self, key: _QueueKey) -> None:
        dropped = self._queues[key].popleft()
        self._size -= 1
        if not self._queues[key]:
            del self._queues[key]
        self._counters.drop("inbox_full", dropped.source)


def may_wait(packet: Packet) -> bool:
    """True for queries and requests for events."""
    code = _code(packet)
    return _FIRST_QUERY <= code <= _LAST_QUERY or code in _EVENT_REQUESTS


def _code(packet: Packet) -> int:
    return message_id(packet.payload)
