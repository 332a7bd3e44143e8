"""Limits of slow links: messages beyond the rate of their id are left out, before they fill a radio (sans I/O).

A link is a network, or a serial line. Safety-critical packets and acknowledgements always pass.
"""

from __future__ import annotations

from collections import OrderedDict
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Final, NamedTuple

from jauspy.ids import message_id
from jauspy.protocol import header
from jauspy.protocol.addressing import NetworkPort, SerialPort
from jauspy.protocol.header import Ack, DataFlag, Priority
from jauspy.protocol.sources import TokenBuckets

HEADER_BYTES: Final = 28
"""Bytes of IPv4 and UDP headers, which a link carries with each datagram."""
BURST: Final = 0.05
"""Seconds of its rate that a link may be sent at once: what is more waits here, where urgent packets overtake it."""
MAX_DEBT: Final = 1.0
"""Seconds after which a link has room again, however much was sent that may not wait."""
MESSAGE_BURST: Final = 2.0
"""Messages that may follow each other at once, so that reports at a steady rate are not left out for their jitter."""
MAX_STREAMS: Final = 1024
"""Large messages whose later fragments are treated as their first one, for so many seconds:"""
STREAM_TIMEOUT: Final = 10.0
MAX_KINDS: Final = 256
"""Kinds of messages that are counted as left out."""
_EVENT: Final = 0x41F1
_REPORT_IN_EVENT: Final = 8
"""Offset of the report in Event (AS5710): message id, event id, sequence number and length precede it."""
_COMPRESSED: Final = 3
"""Compression flag of a packet whose control byte and ids are those of a template."""
_COMPRESSED_PAYLOAD: Final = 6
"""Offset of its payload, after version, flags, size, and number and length of the template."""
_ADDRESSES: Final = 9
"""Bytes of control, destination and source."""
_SHORTEST: Final = 4
"""Bytes of a message id, and of the sequence number behind it."""
_LATER: Final = (DataFlag.MIDDLE, DataFlag.LAST)


@dataclass(frozen=True, slots=True)
class MessageLimit:
    """A limit of messages with these ids; `text` is the limit as people read it.

    `rate` is in messages per second from one component to one destination, or with `is_bits` in bits per second of all.
    """

    codes: range
    rate: float
    is_bits: bool
    text: str


class TotalLimit(NamedTuple):
    """A limit of all traffic in bits per second; `text` is the limit as people read it."""

    rate: float
    text: str


@dataclass(frozen=True, slots=True)
class LinkLimit:
    """The limits of a link: of all its traffic, and of messages; of these the first one that matches counts."""

    total: TotalLimit | None = None
    messages: tuple[MessageLimit, ...] = ()


class LeftOut(NamedTuple):
    """A kind of messages that a link did not carry; `code` is None where the message id is not known."""

    link: str
    limit: str
    code: int | None


class LeftOutCounts(OrderedDict[LeftOut, int]):
    """How many messages of each kind were left out; of the kinds last left out, at most `MAX_KINDS`."""

    def add(self, kind: LeftOut) -> None:
        """Count one."""
        self[kind] = self.pop(kind, 0) + 1
        if len(self) > MAX_KINDS:
            self.popitem(last=False)


class BitBudget:
    """Bits that may be sent at `rate` per second; what is sent beyond that is made up for before anything else."""

    def __init__(self, rate: float) -> None:
        self._rate = rate
        self._bits = rate * BURST
        self._at = float("-inf")

    def has_room(self, now: float) -> bool:
        """True when something may be sent now, of any size."""
        self._refill(now)
        return self._bits > 0.0

    def spend(self, size: int, now: float) -> None:
        """Note a datagram of `size` bytes that is sent."""
        self._refill(now)
        self._bits = max(self._bits - 8.0 * (size + HEADER_BYTES), -MAX_DEBT * self._rate)

    def room_at(self, now: float) -> float:
        """The time from which something may be sent."""
        return now + max(0.0, -self._bits / self._rate)

    def _refill(self, now: float) -> None:
        if now > self._at:
            self._bits = min(self._rate * BURST, self._bits + (now - self._at) * self._rate)
            self._at = now


class _Rule:
    """A limit of messages, and what remains of it."""

    def __init__(self, limit: MessageLimit) -> None:
        self.limit = limit
        self._budget = BitBudget(limit.rate) if limit.is_bits else None
        self._buckets = TokenBuckets(limit.rate, MESSAGE_BURST)

    def take(self, flow: tuple[int, int, int], size: int, now: float) -> bool:
        """False when a message of this flow (source, destination, id) exceeds the limit."""
        if self._budget is None:
            return self._buckets.take(flow, now)
        if not self._budget.has_room(now):
            return False
        self._budget.spend(size, now)
        return True

    def continue_with(self, size: int, now: float) -> None:
        """Note a later fragment of a message that was sent."""
        if self._budget is not None:
            self._budget.spend(size, now)


class LinkLimits:
    """Decides which packets a link carries, by message id; reports in events count as such.

    `limits` is by the name of a network or the device of a serial line. A large message is left out as a whole.
    """

    def __init__(self, limits: Mapping[str, LinkLimit]) -> None:
        self.left_out = LeftOutCounts()
        self.set_limits(limits)

    def set_limits(self, limits: Mapping[str, LinkLimit]) -> None:
        """Replace the limits."""
        self._rules = {link: tuple(map(_Rule, limit.messages)) for link, limit in limits.items() if limit.messages}
        self._streams: OrderedDict[tuple[str, int, int], tuple[float, _Rule, bool]] = OrderedDict()
        """Time of the last fragment, rule, and whether it is carried, of large messages that a rule applies to."""

    def apply_to(self, link: str) -> bool:
        """True when `admits` may refuse packets of this link."""
        return link in self._rules

    def admits(self, link: str, datagram: bytes, now: float) -> bool:
        """False for a packet that its link does not carry; it is counted.

        `datagram` is one that `judp.packets` returned. A packet with a header of AS5669 version 1 has no such ids.
        """
        rules = self._rules.get(link)
        raw = header.parse_alone(datagram) if rules is not None else None
        if rules is None or raw is None or raw.priority == Priority.SAFETY_CRITICAL or raw.ack & Ack.NAK:
            return True
        flag, size = raw.control >> 6, len(datagram)
        stream = (link, raw.source, raw.destination)
        if flag in _LATER:
            return self._continues(stream, size, now)
        if flag == DataFlag.FIRST:
            self._streams.pop(stream, None)
        code = message_code(datagram)
        rule = next((rule for rule in rules if code in rule.limit.codes), None)
        if rule is None or code is None:
            return True
        is_carried = rule.take((raw.source, raw.destination, code), size, now)
        if not is_carried:
            self.left_out.add(LeftOut(link, rule.limit.text, code))
        if flag == DataFlag.FIRST:
            self._note(stream, rule, now, is_carried=is_carried)
        return is_carried

    def _continues(self, stream: tuple[str, int, int], size: int, now: float) -> bool:
        at, rule, is_carried = self._streams.get(stream, (float("-inf"), None, True))
        if rule is None or now - at > STREAM_TIMEOUT:
            return True
        self._note(stream, rule, now, is_carried=is_carried)
        if is_carried:
            rule.continue_with(size, now)
        return is_carried

    def _note(self, stream: tuple[str, int, int], rule: _Rule, now: float, *, is_carried: bool) -> None:
        self._streams[stream] = now, rule, is_carried
        self._streams.move_to_end(stream)
        if len(self._streams) > MAX_STREAMS:
            self._streams.popitem(last=False)


def link_of(port: NetworkPort) -> str:
    """The link to a peer, as `LinkLimits` names it."""
    return port.host if type(port) is SerialPort else port.network


def message_code(datagram: bytes) -> int | None:
    """The id of the message in a datagram with one packet, of the report if it is an Event.

    None for an acknowledgement, for a later fragment unless it is compressed, and for other versions.
    """
    if len(datagram) < _COMPRESSED_PAYLOAD or datagram[0] != header.VERSION:
        return None
    if datagram[1] >> 6 == _COMPRESSED:
        start = _COMPRESSED_PAYLOAD
    else:
        control = header.control_offset(datagram)
        if datagram[control] >> 6 in _LATER:
            return None
        start = control + _ADDRESSES
    if len(datagram) - start < _SHORTEST:
        return None
    code = message_id(datagram, start)
    report = start + _REPORT_IN_EVENT
    return message_id(datagram, report) if code == _EVENT and len(datagram) - report >= _SHORTEST else code
