"""Dissection of datagrams one after the other, with large messages put together."""

from __future__ import annotations

from typing import Final

from jauspy.capture.dissect import Dissection, Part, dissect, read_message
from jauspy.codec.registry import NO_HINTS, Hints, Registry
from jauspy.logs import get_logger
from jauspy.protocol.counters import Counters
from jauspy.protocol.delivery import Delivery
from jauspy.protocol.header import Ack, DataFlag
from jauspy.protocol.reassembly import Reassembly

MAX_MESSAGE: Final = 16 << 20
"""Bytes of a large message."""
FRAGMENT_TIMEOUT: Final = 10.0
"""Seconds that an incomplete message waits for its next fragment; senders repeat one for less."""

_LOG: Final = get_logger(__name__)


class Dissector:
    """Dissects datagrams; the last fragment of a large message that arrives has the content of the message.

    Fragments are put together as a receiver does, in any order and within bounds of memory and time.
    """

    def __init__(self, registry: Registry, wanted: Hints = NO_HINTS) -> None:
        self._registry = registry
        self._wanted = wanted
        settings = Delivery(max_message=MAX_MESSAGE, fragment_timeout=FRAGMENT_TIMEOUT)
        self._reassembly = Reassembly(settings, Counters(_LOG))

    def dissect(self, data: bytes, now: float) -> Dissection:
        """Dissect a UDP payload that was captured at `now` (s). Never raises; problems are in `errors`."""
        found = dissect(data, self._registry, self._wanted)
        single = DataFlag.SINGLE
        for packet, _ in found.parts:
            if packet.data_flag is not single:
                return found._replace(parts=tuple(self._completed(part, now) for part in found.parts))
        return found

    def _completed(self, part: Part, now: float) -> Part:
        """The part with the whole message as its content, if it completes one."""
        packet = part.packet
        if packet.data_flag is DataFlag.SINGLE or packet.ack is Ack.ACK or part.content.message is not None:
            return part
        self._reassembly.handle_timeout(now)
        _, whole = self._reassembly.add(packet, hash(packet.payload), now)
        if whole is None:
            return part
        return Part(packet, read_message(bytes(whole.payload), self._registry, self._wanted))
