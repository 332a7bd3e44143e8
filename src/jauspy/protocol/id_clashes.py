"""Ids that two machines use: who else has the id of a component of this machine, and who is told."""

from __future__ import annotations

from collections import OrderedDict
from collections.abc import Iterator
from typing import Final, NamedTuple

from jauspy.ids import JausID
from jauspy.protocol import judp
from jauspy.protocol.addressing import NetworkPort
from jauspy.protocol.header import Ack, Packet
from jauspy.protocol.sources import TokenBuckets

MAX_CLASHES: Final = 64
"""Ids that are remembered; the oldest is forgotten."""
CLASH_LIFETIME: Final = 30.0
"""Seconds after its last packet for which the other machine is remembered."""
NOTICE_INTERVAL: Final = 2.0
"""Seconds between two notices about one id."""
NOTICES_PER_SECOND: Final = 10.0
"""Notices about all ids together, so that forged packets cause few."""


class _Clash(NamedTuple):
    port: NetworkPort
    last: float
    notified: float


class IdClashes:
    """Sans-I/O; ids are 32-bit numbers. Both machines note a clash as soon as one hears the other."""

    def __init__(self) -> None:
        self._clashes: OrderedDict[int, _Clash] = OrderedDict()
        self._notices = TokenBuckets(NOTICES_PER_SECOND, NOTICES_PER_SECOND)

    def note(self, id: int, port: NetworkPort, now: float, *, is_notice: bool = False) -> bytes | None:
        """Note a packet from `port` with the id of a component of this machine; returns a notice for that machine.

        The notice is an ACK of the id to itself, which has no effect but that the other machine notes the clash, too.
        With `is_notice` the packet is one, and is not answered.
        """
        known = self._clashes.pop(id, None)
        is_due = known is None or now - known.notified >= NOTICE_INTERVAL
        is_sent = is_due and not is_notice and self._notices.take(None, now)
        self._clashes[id] = _Clash(port, now, now if is_sent or known is None else known.notified)
        if len(self._clashes) > MAX_CLASHES:
            self._clashes.popitem(last=False)
        own = JausID.from_int(id)
        return judp.pack(Packet(own, own, b"", 0, ack=Ack.ACK)) if is_sent else None

    def recent(self, now: float) -> Iterator[tuple[int, NetworkPort, float]]:
        """Each id in use elsewhere, where, and the seconds since its last packet from there."""
        for id, clash in list(self._clashes.items()):
            if now - clash.last <= CLASH_LIFETIME:
                yield id, clash.port, now - clash.last
            else:
                del self._clashes[id]
