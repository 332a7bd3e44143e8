"""Which packets may enter a subsystem: rules by source, destination, network, message and rate."""

from __future__ import annotations

from collections import OrderedDict
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import Final

from jauspy.ids import EVERYONE, JausID
from jauspy.protocol.header import DataFlag, RawPacket
from jauspy.protocol.sources import TokenBuckets

MAX_FRAGMENT_STREAMS: Final = 1024
"""Large messages whose first fragment was allowed, and whose others are to follow."""
FRAGMENT_TIMEOUT: Final = 10.0
"""Seconds after the last fragment that passed until another needs a first one again."""


@dataclass(frozen=True, slots=True)
class GatewayRule:
    """What it says goes for packets that match all of it. Wildcards stand for any part of an id.

    `network` None stands for every network outside; `messages` None for every message, else ranges of message ids;
    `rate` is in messages per second and source, None for no limit.
    """

    allow: bool
    source: JausID = EVERYONE
    destination: JausID = EVERYONE
    network: str | None = None
    messages: tuple[range, ...] | None = None
    rate: float | None = None

    def matches(self, source: JausID, destination: JausID, code: int | None) -> bool:
        """`code` None is an acknowledgement, which belongs to any message."""
        return (
            self.source.matches(source)
            and self.destination.matches(destination)
            and (code is None or self.messages is None or any(code in codes for codes in self.messages))
        )


class GatewayRules:
    """The first rule that matches decides. What matches none is refused from outside, and allowed from inside.

    Without any rule for a network everything is allowed from there.
    """

    def __init__(self, rules: Sequence[GatewayRule], *, inside: Iterable[str] = ()) -> None:
        self._rules = tuple(rules)
        self._inside = frozenset(inside)
        self._buckets = {
            index: TokenBuckets(rule.rate, rule.rate) for index, rule in enumerate(rules) if rule.rate is not None
        }
        self._streams: OrderedDict[tuple[int, int, str], float] = OrderedDict()
        """When each was last heard; only those that may pass."""

    def refusal(self, raw: RawPacket, data: bytes, network: str, now: float) -> str | None:
        """Why this packet from `network` may not pass (a short name for counters); None when it may."""
        if not self._rules:
            return None
        flag = raw.control >> 6
        stream = (raw.source, raw.destination, network)
        if flag in (DataFlag.MIDDLE, DataFlag.LAST):
            if now - self._streams.get(stream, float("-inf")) >= FRAGMENT_TIMEOUT:
                return "rule"
            self._note(stream, now)
            return None
        why = self._judge(raw, data, network, now)
        if flag == DataFlag.FIRST:
            if why is None:
                self._note(stream, now)
            else:
                self._streams.pop(stream, None)
        return why

    def _note(self, stream: tuple[int, int, str], now: float) -> None:
        self._streams[stream] = now
        self._streams.move_to_end(stream)
        if len(self._streams) > MAX_FRAGMENT_STREAMS:
            self._streams.popitem(last=False)

    def _judge(self, raw: RawPacket, data: bytes, network: str, now: float) -> str | None:
        inside = network in self._inside
        source, destination = JausID.from_int(raw.source), JausID.from_int(raw.destination)
        code = _message_id(raw, data)
        asked = False
        for index, rule in enumerate(self._rules):
            if rule.network != network and (inside or rule.network is not None):
                continue
            asked = True
            if rule.matches(source, destination, code):
                if not rule.allow:
                    return "rule"
                within = index not in self._buckets or self._buckets[index].take(raw.source, now)
                return None if within else "rule_rate"
        return "rule" if asked and not inside else None


def _message_id(raw: RawPacket, data: bytes) -> int | None:
    """The id of the message in a packet; None when there is none, as in an acknowledgement."""
    at = raw.payload_start
    return int.from_bytes(data[at : at + 2], "little") if raw.end - 2 >= at + 2 else None
