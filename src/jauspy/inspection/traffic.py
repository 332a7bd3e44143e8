"""The messages in datagrams, each once, however many receivers its copies went to."""

from __future__ import annotations

from collections import OrderedDict
from collections.abc import Iterable, Iterator
from typing import Final, NamedTuple

from jauspy.capture.dissect import Part, local_control
from jauspy.capture.dissector import Dissector
from jauspy.capture.reader import Datagram
from jauspy.codec.registry import NO_HINTS, Hints, Registry
from jauspy.inspection.peers import PeerRecogniser
from jauspy.protocol.header import OVERHEAD, Ack, DataFlag

COPY_TIME: Final = 0.1
"""Seconds in which a datagram with the same header and bytes is a copy: for another receiver, or sent again."""
MAX_REMEMBERED: Final = 1024


class SeenMessage(NamedTuple):
    """A message as it was seen."""

    time: float
    """Seconds since 1970, UTC."""
    part: Part
    host: str = ""
    """Address from which it came; that of the node manager for components of its machine."""

    @property
    def name(self) -> str:
        """The message's name, or what is known of it."""
        content = self.part.content
        if content.message is not None:
            return content.message.NAME
        if self.part.packet.ack is Ack.ACK:
            return "(acknowledgement)"
        if self.part.packet.data_flag is not DataFlag.SINGLE:
            return "(fragment)"
        return "(empty)" if content.code is None else f"({content.code:04X}h)"

    @property
    def size(self) -> int:
        """Bytes of the packet, header included."""
        return OVERHEAD + len(self.part.packet.payload)


def seen_messages(
    datagrams: Iterable[Datagram],
    registry: Registry,
    wanted: Hints = NO_HINTS,
    *,
    copies: bool = False,
    peers: PeerRecogniser | None = None,
) -> Iterator[SeenMessage]:
    """The messages in datagrams; copies of one are left out unless `copies`. Datagrams are shown to `peers`, too."""
    recent: OrderedDict[tuple[int, int, int, bytes], float] = OrderedDict()
    dissector = Dissector(registry, wanted)
    for datagram in datagrams:
        if datagram.source == datagram.destination and local_control(datagram.payload) is not None:
            continue
        parts = dissector.dissect(datagram.payload, datagram.time).parts
        if peers is not None:
            peers.see(datagram.payload, datagram.source, datagram.destination, [part.packet for part in parts])
        for part in parts:
            packet = part.packet
            key = int(packet.source), int(packet.destination), packet.sequence, bytes(packet.payload)
            before = recent.get(key)
            if not copies and before is not None and datagram.time - before < COPY_TIME:
                continue
            recent[key] = datagram.time
            if len(recent) > MAX_REMEMBERED:
                recent.popitem(last=False)
            yield SeenMessage(datagram.time, part, datagram.source[0])
