"""Header compression of AS5669A: bytes that are equal in many packets to a neighbour are sent once, as a template.

With any of the flags, two bytes follow the data size: a number and a length.

1 proposes: the packet is complete, and the `length` bytes after these two become the sender's template `number`.
2 answers, in a complete packet: the same length accepts the proposal, length 0 refuses an unknown number.
3 omits the bytes of the template; the data size is that of what is sent.

Our own templates are control, destination and source: they save 7 bytes in every packet.
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
"""The longest template that is accepted from a peer."""
MAX_TEMPLATES: Final = 1024
MAX_OFFERS: Final = 64
"""Templates proposed to one peer, numbered from 1."""
PROPOSE_INTERVAL: Final = 1.0
CONFIRM_INTERVAL: Final = 5.0
"""Seconds after which an accepted template is proposed again, because the peer may have restarted."""
ACCEPTANCE_TIMEOUT: Final = 10.0
"""Seconds after the last answer in which a template is used."""
REUSE_DELAY: Final = 30.0
"""Seconds after its last use when a number may be reused: no packet is under way for so long."""


class Templates:
    """Templates that peers have proposed; the least recently used is dropped first."""

    def __init__(self) -> None:
        self._known: OrderedDict[tuple[UdpPort, int], tuple[bytes, float]] = OrderedDict()
        """Templates, and when each was used."""

    def find(self, port: UdpPort, number: int, now: float) -> bytes | None:
        """The template that a peer has proposed under this number, or None."""
        known = self._known.get((port, number))
        if known is None:
            return None
        self._known[port, number] = known[0], now
        self._known.move_to_end((port, number))
        return known[0]

    def store(self, port: UdpPort, number: int, template: bytes, now: float) -> bool:
        """Store a template; false when its length is out of range, or the number is in use for another one."""
        if not 0 < len(template) <= MAX_TEMPLATE_LENGTH:
            return False
        known, used_at = self._known.get((port, number), (template, now))
        if known != template and now - used_at < REUSE_DELAY:
            return False
        self._known[port, number] = template, now
        self._known.move_to_end((port, number))
        if len(self._known) > MAX_TEMPLATES:
            self._known.popitem(last=False)
        return True


@dataclass(slots=True)
class Offer:
    """A template of ours, for one peer."""

    number: int
    proposed_at: float = float("-inf")
    accepted_at: float = float("-inf")
    used_at: float = 0.0

    def is_accepted(self, now: float) -> bool:
        """True when the peer has accepted it lately."""
        return now - self.accepted_at < ACCEPTANCE_TIMEOUT

    def is_due(self, now: float) -> bool:
        """True when it is to be proposed, for the first time or again."""
        return now - self.accepted_at >= CONFIRM_INTERVAL and now - self.proposed_at >= PROPOSE_INTERVAL


class OfferedTemplates:
    """Our templates for one peer."""

    def __init__(self) -> None:
        self._offers: OrderedDict[bytes, Offer] = OrderedDict()

    def offer_for(self, template: bytes, now: float) -> Offer | None:
        """The offer of this template; None while all numbers are in use for others."""
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

    def handle_answer(self, number: int, length: int, packet: bytes, now: float) -> None:
        """The peer has accepted a number or, with length 0, refused it. Answers for another template are ignored."""
        for template, offer in self._offers.items():
            if offer.number == number:
                if length == 0:
                    offer.accepted_at = offer.proposed_at = float("-inf")
                elif length == TEMPLATE_LENGTH and packet[1:TEMPLATE_LENGTH] == template[5:] + template[1:5]:
                    offer.accepted_at = now


MAX_PARTNERS: Final = 64
"""Peers that compress, and as many that are probed."""
MAX_PROBES: Final = 3
PROBE_INTERVAL: Final = 1.0

_PROPOSED, _ANSWERED, _COMPRESSED = 1, 2, 3
_START: Final = struct.Struct("<BHBB")
_BODY: Final = slice(4, None)
"""The part of a plain datagram after version, flags and data size."""
_PROBE_NUMBER: Final = 0
_ACK_MASK: Final = 3 << 4
_EMPTY: Final = TEMPLATE_LENGTH + 2
"""Bytes of a packet without a message, after number and length."""


class _FlaggedPacket(NamedTuple):
    """A packet with compression flags; `rest` is what follows number and length."""

    kind: int
    type: int
    number: int
    length: int
    rest: bytes


class Compression:
    """Accepts templates of peers, and compresses for peers that have proposed or accepted one.

    With `probes`, other peers are asked whether they compress. `send(port, datagram)` sends answers and probes.
    """

    def __init__(self, counters: Counters, send: Callable[[UdpPort, bytes], None], *, probes: bool = False) -> None:
        self.is_used = probes
        """False while `compress` changes no packet."""
        self._counters = counters
        self._send = send
        self._probes = probes
        self._templates = Templates()
        self._partners: OrderedDict[UdpPort, OfferedTemplates] = OrderedDict()
        self._probed: OrderedDict[UdpPort, tuple[int, float]] = OrderedDict()

    # --- receiving ------------------------------------------------------------------------------------------------

    def expand(self, data: bytes, port: UdpPort, now: float) -> bytes:
        """The same packets without compression; empty if they only negotiate it. Raises `ProtocolError`."""
        plain = bytearray(data[:1])
        offset = 1
        while offset < len(data):
            if data[offset] < 0x40:
                end = header.parse_header(data, offset).end
                plain += data[offset:end]
            else:
                sent, end = _parse(data, offset)
                body = self._body(sent, port, now)
                if body:
                    plain += struct.pack("<BH", sent.type, len(body) + 3) + body
            offset = end
        return bytes(plain) if len(plain) > 1 else b""

    def _body(self, sent: _FlaggedPacket, port: UdpPort, now: float) -> bytes:
        """Control, destination, source, message and sequence number; empty if the packet only negotiates."""
        body = sent.rest if sent.kind != _COMPRESSED else self._template(sent.number, port, now) + sent.rest
        if len(body) < _EMPTY:
            raise ProtocolError("size", f"{len(body)} bytes are too few for a packet")
        if sent.kind == _COMPRESSED:
            self._counters["compression.received"] += 1
            return body
        partner = self._partner(port)
        if sent.kind == _PROPOSED:
            self._handle_proposal(sent, port, now)
        else:
            partner.handle_answer(sent.number, sent.length, body, now)
        return body if len(body) > _EMPTY or body[0] & _ACK_MASK else b""

    def _template(self, number: int, port: UdpPort, now: float) -> bytes:
        template = self._templates.find(port, number, now)
        if template is None:
            self._answer(number, 0, bytes(TEMPLATE_LENGTH), port)
            self._counters["compression.refused"] += 1
            raise ProtocolError("no_template", f"template {number} was not proposed")
        return template

    def _handle_proposal(self, sent: _FlaggedPacket, port: UdpPort, now: float) -> None:
        """Accept a proposal if its template can be stored and its answer has one receiver."""
        destination, source = struct.unpack_from("<II", sent.rest, 1)
        incomplete = addressing.is_incomplete(destination) or addressing.is_incomplete(source)
        template = sent.rest[:-2][: sent.length]
        if incomplete or len(template) < sent.length or not self._templates.store(port, sent.number, template, now):
            self._counters["compression.not_accepted"] += 1
            return
        control = bytes([sent.rest[0] & ~_ACK_MASK])
        self._answer(sent.number, sent.length, control + sent.rest[5:9] + sent.rest[1:5], port)
        self._counters["compression.accepted"] += 1

    def _answer(self, number: int, length: int, head: bytes, port: UdpPort) -> None:
        self._send(port, _packed(_ANSWERED, number, length, head + bytes(2)))

    def _partner(self, port: UdpPort) -> OfferedTemplates:
        """The offers for a peer that uses compression."""
        partner = self._partners.get(port)
        if partner is None:
            partner = self._partners[port] = OfferedTemplates()
            self.is_used = True
            if len(self._partners) > MAX_PARTNERS:
                self._partners.popitem(last=False)
        self._partners.move_to_end(port)
        return partner

    def applies_to(self, port: UdpPort) -> bool:
        """True when `compress` may change packets to this peer, or probe it."""
        return self._probes or port in self._partners

    # --- sending ------------------------------------------------------------------------------------------------

    def compress(self, datagram: bytes, port: UdpPort, now: float) -> bytes:
        """The datagram to send to this peer in place of a plain packet.

        Safety-critical packets are never compressed, so that they are understood even if earlier packets were lost.
        """
        if datagram[0] != header.VERSION or datagram[1] or datagram[4] & 3 == Priority.SAFETY_CRITICAL:
            return datagram
        partner = self._partners.get(port)
        if partner is None:
            if self._probes:
                self._probe(datagram, port, now)
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

    def _probe(self, datagram: bytes, port: UdpPort, now: float) -> None:
        """Propose in an empty packet, because peers without compression would misread a message."""
        count, probed_at = self._probed.get(port, (0, now - PROBE_INTERVAL))
        if count >= MAX_PROBES or now - probed_at < PROBE_INTERVAL:
            return
        self._probed[port] = (count + 1, now)
        if len(self._probed) > MAX_PARTNERS:
            self._probed.popitem(last=False)
        control = bytes([datagram[4] & ~_ACK_MASK & 0x3F])
        self._send(port, _packed(_PROPOSED, _PROBE_NUMBER, TEMPLATE_LENGTH, control + datagram[5:13] + bytes(2)))
        self._counters["compression.asked"] += 1


def is_compressed(data: bytes) -> bool:
    """True when the first packet of a datagram has a compression flag."""
    return len(data) > 1 and data[1] > 0x3F and data[0] == header.VERSION


def _parse(data: bytes, offset: int) -> tuple[_FlaggedPacket, int]:
    """Parse the packet with flags at `offset`; returns it and where it ends."""
    left = len(data) - offset
    if left < _START.size:
        raise ProtocolError("truncated", f"{left} bytes are too few for a header")
    flags, size, number, length = _START.unpack_from(data, offset)
    if not _START.size <= size <= left:
        raise ProtocolError("truncated", f"a data size of {size} in {left} bytes")
    return _FlaggedPacket(
        flags >> 6, flags & 0x3F, number, length, data[offset + _START.size : offset + size]
    ), offset + size


def _packed(kind: int, number: int, length: int, body: bytes) -> bytes:
    return bytes([header.VERSION]) + _START.pack(kind << 6, _START.size + len(body), number, length) + body
