"""Header compression of AS5669A: what two neighbours would say in every packet is said once, as a template.

With the flags, two bytes come behind the data size: a number and a length.

1 proposes: nothing is left out, and the `length` bytes behind these two become the sender's template `number`.
2 answers in a whole packet: with the same length it accepts, with length 0 it refuses what it does not know.
3 leaves those bytes out; the data size is that of what is sent.

Our own templates are control, destination and source: 7 bytes less in every packet.
"""

from __future__ import annotations

import struct
from collections import OrderedDict
from collections.abc import Callable
from dataclasses import dataclass
from typing import Final, NamedTuple

from jauspy.errors import ProtocolError
from jauspy.protocol import addressing, header
from jauspy.protocol.addressing import UdpPort
from jauspy.protocol.counters import Counters
from jauspy.protocol.header import Priority

TEMPLATE_LENGTH: Final = 9
"""Bytes of our own templates: control, destination and source."""
MAX_TEMPLATE_LENGTH: Final = 32
"""The longest template that is kept for a peer; a longer one is not accepted."""
MAX_TEMPLATES: Final = 1024
MAX_OFFERS: Final = 64
"""Templates told to one peer; they have the numbers from 1 on."""
PROPOSE_INTERVAL: Final = 1.0
CONFIRM_INTERVAL: Final = 5.0
"""Seconds after which an accepted template is proposed again: the peer may have restarted."""
ACCEPTANCE_TIMEOUT: Final = 10.0
"""Seconds without an answer after which nothing is compressed any more."""
REUSE_DELAY: Final = 30.0
"""Seconds that a number was not used before it may mean something else: no packet is on its way for so long."""


class Templates:
    """What peers have proposed; the least recently used is forgotten first."""

    def __init__(self) -> None:
        self._known: OrderedDict[tuple[UdpPort, int], bytes] = OrderedDict()

    def find(self, port: UdpPort, number: int) -> bytes | None:
        """The bytes that this number stands for, from there."""
        template = self._known.get((port, number))
        if template is not None:
            self._known.move_to_end((port, number))
        return template

    def keep(self, port: UdpPort, number: int, packet: bytes, length: int) -> bool:
        """Remember the first `length` bytes; false when that cannot be."""
        if not 0 < length <= min(MAX_TEMPLATE_LENGTH, len(packet)):
            return False
        self._known[port, number] = packet[:length]
        self._known.move_to_end((port, number))
        if len(self._known) > MAX_TEMPLATES:
            self._known.popitem(last=False)
        return True


@dataclass(slots=True)
class Offer:
    """A template that we have proposed, or are about to."""

    number: int
    proposed_at: float = float("-inf")
    accepted_at: float = float("-inf")
    used_at: float = 0.0

    def is_accepted(self, now: float) -> bool:
        """True when the peer can be expected to know it."""
        return now - self.accepted_at < ACCEPTANCE_TIMEOUT

    def is_due(self, now: float) -> bool:
        """True when it should be proposed, for the first time or again."""
        return now - self.accepted_at >= CONFIRM_INTERVAL and now - self.proposed_at >= PROPOSE_INTERVAL


class Offers:
    """The templates that one peer was told, or is to be told."""

    def __init__(self) -> None:
        self._offers: OrderedDict[bytes, Offer] = OrderedDict()

    def offer_for(self, template: bytes, now: float) -> Offer | None:
        """The offer of these bytes; None while all numbers are in use for others."""
        offer = self._offers.get(template)
        if offer is None:
            if len(self._offers) < MAX_OFFERS:
                number = len(self._offers) + 1
            else:
                oldest, idle = next(iter(self._offers.items()))
                if now - idle.used_at < REUSE_DELAY:
                    return None
                del self._offers[oldest]
                number = idle.number
            offer = self._offers[template] = Offer(number)
        offer.used_at = now
        self._offers.move_to_end(template)
        return offer

    def answered(self, number: int, length: int, packet: bytes, now: float) -> None:
        """The peer has accepted or, with length 0, refused a number. An answer that is for another template is old."""
        for template, offer in self._offers.items():
            if offer.number == number:
                if length == 0:
                    offer.accepted_at = offer.proposed_at = float("-inf")
                elif length == TEMPLATE_LENGTH and packet[1:TEMPLATE_LENGTH] == template[5:] + template[1:5]:
                    offer.accepted_at = now


MAX_PARTNERS: Final = 64
"""Peers that compress, and as many that are asked whether they do."""
MAX_PROBES: Final = 3
PROBE_INTERVAL: Final = 1.0

_PROPOSED, _ANSWERED, _COMPRESSED = 1, 2, 3
_START: Final = struct.Struct("<BHBB")
_BODY: Final = slice(4, None)
"""Of a plain datagram: all but version, flags and data size."""
_PROBE_NUMBER: Final = 0
_ACK_MASK: Final = 3 << 4
_EMPTY: Final = TEMPLATE_LENGTH + 2
"""Bytes of a packet without a message, behind number and length."""


class _Sent(NamedTuple):
    """A packet with flags; `rest` is what follows number and length."""

    kind: int
    type: int
    number: int
    length: int
    rest: bytes


class Compression:
    """Accepts what peers propose. Compresses for a peer that has proposed or accepted; `probes` asks the others, too.

    `send(port, datagram)` takes the answers and questions.
    """

    def __init__(self, counters: Counters, send: Callable[[UdpPort, bytes], None], *, probes: bool = False) -> None:
        self.is_used = probes
        """False while no packet would be changed by `shrink`."""
        self._counters = counters
        self._send = send
        self._probes = probes
        self._templates = Templates()
        self._partners: OrderedDict[UdpPort, Offers] = OrderedDict()
        self._asked: OrderedDict[UdpPort, tuple[int, float]] = OrderedDict()

    # --- in ------------------------------------------------------------------------------------------------------

    def expand(self, data: bytes, port: UdpPort, now: float) -> bytes:
        """The same packets without compression; empty when they were only about it. Raises `ProtocolError`."""
        plain = bytearray(data[:1])
        at = 1
        while at < len(data):
            if data[at] < 0x40:
                end = header.parse_header(data, at).end
                plain += data[at:end]
            else:
                sent, end = _parse(data, at)
                body = self._body(sent, port, now)
                if body:
                    plain += struct.pack("<BH", sent.type, len(body) + 3) + body
            at = end
        return bytes(plain) if len(plain) > 1 else b""

    def _body(self, sent: _Sent, port: UdpPort, now: float) -> bytes:
        """Control, destination, source, message and sequence number; empty when the packet was only about templates."""
        body = sent.rest if sent.kind != _COMPRESSED else self._template(sent.number, port) + sent.rest
        if len(body) < _EMPTY:
            raise ProtocolError("size", f"{len(body)} bytes are too few for a packet")
        if sent.kind == _COMPRESSED:
            self._counters["compression.received"] += 1
            return body
        partner = self._partner(port)
        if sent.kind == _PROPOSED:
            self._consider(sent, port)
        else:
            partner.answered(sent.number, sent.length, body, now)
        return body if len(body) > _EMPTY or body[0] & _ACK_MASK else b""

    def _template(self, number: int, port: UdpPort) -> bytes:
        template = self._templates.find(port, number)
        if template is None:
            self._answer(number, 0, bytes(TEMPLATE_LENGTH), port)
            self._counters["compression.refused"] += 1
            raise ProtocolError("no_template", f"nobody has proposed number {number} here")
        return template

    def _consider(self, sent: _Sent, port: UdpPort) -> None:
        """Accept a proposal, if it can be kept and its answer has one receiver."""
        destination, source = struct.unpack_from("<II", sent.rest, 1)
        vague = addressing.is_vague(destination) or addressing.is_vague(source)
        if vague or not self._templates.keep(port, sent.number, sent.rest[:-2], sent.length):
            self._counters["compression.not_accepted"] += 1
            return
        control = bytes([sent.rest[0] & ~_ACK_MASK])
        self._answer(sent.number, sent.length, control + sent.rest[5:9] + sent.rest[1:5], port)
        self._counters["compression.accepted"] += 1

    def _answer(self, number: int, length: int, head: bytes, port: UdpPort) -> None:
        self._send(port, _packed(_ANSWERED, number, length, head + bytes(2)))

    def _partner(self, port: UdpPort) -> Offers:
        """Whoever sends such flags can compress."""
        partner = self._partners.get(port)
        if partner is None:
            partner = self._partners[port] = Offers()
            self.is_used = True
            if len(self._partners) > MAX_PARTNERS:
                self._partners.popitem(last=False)
        self._partners.move_to_end(port)
        return partner

    def knows(self, port: UdpPort) -> bool:
        """True when `shrink` may change or do something for this peer."""
        return self._probes or port in self._partners

    # --- out -----------------------------------------------------------------------------------------------------

    def shrink(self, datagram: bytes, port: UdpPort, now: float) -> bytes:
        """A plain packet as it is to be sent there.

        Safety-critical ones always go whole, so that nothing earlier must have arrived for them to be understood.
        """
        if datagram[0] != header.VERSION or datagram[1] or datagram[4] & 3 == Priority.SAFETY_CRITICAL:
            return datagram
        partner = self._partners.get(port)
        if partner is None:
            if self._probes:
                self._ask(datagram, port, now)
            return datagram
        body = datagram[_BODY]
        offer = partner.offer_for(body[:TEMPLATE_LENGTH], now)
        if offer is None:
            return datagram
        if offer.is_due(now) and len(body) <= header.MAX_PAYLOAD + _EMPTY:
            offer.proposed_at = now
            self._counters["compression.proposed"] += 1
            return _packed(_PROPOSED, offer.number, TEMPLATE_LENGTH, body)
        if offer.is_accepted(now):
            self._counters["compression.sent"] += 1
            return _packed(_COMPRESSED, offer.number, TEMPLATE_LENGTH, body[TEMPLATE_LENGTH:])
        return datagram

    def _ask(self, datagram: bytes, port: UdpPort, now: float) -> None:
        """Propose in an empty packet: those that do not know compression would misread a message that has it."""
        count, at = self._asked.get(port, (0, now - PROBE_INTERVAL))
        if count >= MAX_PROBES or now - at < PROBE_INTERVAL:
            return
        self._asked[port] = (count + 1, now)
        if len(self._asked) > MAX_PARTNERS:
            self._asked.popitem(last=False)
        control = bytes([datagram[4] & ~_ACK_MASK & 0x3F])
        self._send(port, _packed(_PROPOSED, _PROBE_NUMBER, TEMPLATE_LENGTH, control + datagram[5:13] + bytes(2)))
        self._counters["compression.asked"] += 1


def applies_to(data: bytes) -> bool:
    """True when the first packet of a datagram has any of the flags."""
    return len(data) > 1 and data[1] > 0x3F and data[0] == header.VERSION


def _parse(data: bytes, at: int) -> tuple[_Sent, int]:
    """The packet with flags at `at`, and where it ends."""
    left = len(data) - at
    if left < _START.size:
        raise ProtocolError("truncated", f"{left} bytes are too few for a header")
    flags, size, number, length = _START.unpack_from(data, at)
    if not _START.size <= size <= left:
        raise ProtocolError("truncated", f"a data size of {size} in {left} bytes")
    return _Sent(flags >> 6, flags & 0x3F, number, length, data[at + _START.size : at + size]), at + size


def _packed(kind: int, number: int, length: int, body: bytes) -> bytes:
    return bytes([header.VERSION]) + _START.pack(kind << 6, _START.size + len(body), number, length) + body
