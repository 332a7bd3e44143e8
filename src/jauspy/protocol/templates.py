"""Templates of header compression: those that peers told us, and those that we have told a peer."""

from __future__ import annotations

from collections import OrderedDict
from dataclasses import dataclass
from typing import Final

from jauspy.protocol.addressing import UdpPort

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
