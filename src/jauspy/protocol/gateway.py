"""Gateway: which packets cross from one network to another, and the rules that filter them.

A gateway stands between the networks inside a subsystem (its capability modules) and those outside (operator control
units, other robots), or between the network of a site with several subsystems and a link to other sites. Only packets
from or to ids of its subsystems cross, and none is sent back to its own network. The components of its own machine
count as inside.
"""

from __future__ import annotations

from collections import OrderedDict
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import Final, NamedTuple

from jauspy.ids import EVERYONE, JausID, message_id
from jauspy.protocol.header import Ack, Broadcast, DataFlag, RawPacket
from jauspy.protocol.sources import TokenBuckets

MAX_FRAGMENT_STREAMS: Final = 1024
"""Large messages whose first fragment was allowed."""
_ACKNOWLEDGEMENTS: Final = frozenset({Ack.ACK, Ack.NAK})
FRAGMENT_TIMEOUT: Final = 10.0
"""Seconds after an allowed fragment in which the next one is allowed without a first one."""


MAX_REFUSED: Final = 64
"""Kinds of refused packets that are counted."""


class Refused(NamedTuple):
    """A kind of refused packets. `why` is a counter's name, `code` the message id: None in ACKs and later fragments."""

    why: str
    network: str
    code: int | None


@dataclass(frozen=True, slots=True)
class GatewayRule:
    """Allows or denies the packets that match all of its conditions. Ids may have wildcards.

    `network` None is every network outside; `messages` None is every message, else ranges of message ids; `rate` is in
    messages per second and source, None for no limit.
    """

    allow: bool
    source: JausID = EVERYONE
    destination: JausID = EVERYONE
    network: str | None = None
    messages: tuple[range, ...] | None = None
    rate: float | None = None

    def matches(self, source: JausID, destination: JausID, code: int | None) -> bool:
        """True when the ids and the message id match; `code` None is an acknowledgement, which matches any message."""
        return (
            self.source.matches(source)
            and self.destination.matches(destination)
            and (code is None or self.messages is None or any(code in codes for codes in self.messages))
        )


class GatewayRules:
    """The first matching rule decides. A packet that matches none is refused from outside, and allowed from inside.

    Everything is allowed from a network that no rule applies to.
    """

    def __init__(self, rules: Sequence[GatewayRule], *, inside: Iterable[str] = ()) -> None:
        self._rules = tuple(rules)
        self._inside = frozenset(inside)
        self._buckets = {
            index: TokenBuckets(rule.rate, rule.rate) for index, rule in enumerate(rules) if rule.rate is not None
        }
        self._streams: OrderedDict[tuple[int, int, str], float] = OrderedDict()
        """Time of the last fragment of each allowed large message."""

    def refusal(self, raw: RawPacket, data: bytes, network: str, now: float) -> str | None:
        """Reason to refuse a packet from `network`, as a counter's name; None when it is allowed."""
        if not self._rules:
            return None
        flag = raw.control >> 6
        stream = (raw.source, raw.destination, network)
        if flag in (DataFlag.MIDDLE, DataFlag.LAST):
            if now - self._streams.get(stream, float("-inf")) >= FRAGMENT_TIMEOUT:
                return "rule"
            self._note(stream, now)
            return None
        if flag == DataFlag.FIRST and raw.ack not in _ACKNOWLEDGEMENTS and _message_id(raw, data) is None:
            why: str | None = "rule"  # the message id is in the next fragment, where no rule would see it
        else:
            why = self._apply(raw, data, network, now)
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

    def _apply(self, raw: RawPacket, data: bytes, network: str, now: float) -> str | None:
        inside = network in self._inside
        source, destination = JausID.from_int(raw.source), JausID.from_int(raw.destination)
        code = _message_id(raw, data)
        applied = False
        for index, rule in enumerate(self._rules):
            if rule.network != network and (inside or rule.network is not None):
                continue
            applied = True
            if rule.matches(source, destination, code):
                if not rule.allow:
                    return "rule"
                within = index not in self._buckets or self._buckets[index].take(raw.source, now)
                return None if within else "rule_rate"
        return "rule" if applied and not inside else None


def _message_id(raw: RawPacket, data: bytes) -> int | None:
    """The id of the message in a packet; None for an acknowledgement."""
    offset = raw.payload_start
    return message_id(data, offset) if raw.end - 2 >= offset + 2 else None


ANY_SUBSYSTEM = 0xFFFF


class Gateway:
    """`subsystems` are what is inside, as ranges; `networks` the names of all networks, `inside` theirs."""

    def __init__(
        self, subsystems: Sequence[range], networks: Iterable[str], inside: Iterable[str], rules: GatewayRules
    ) -> None:
        self._subsystems = tuple(subsystems)
        self._inside = tuple(inside)
        self._outside = tuple(name for name in networks if name not in self._inside)
        self._rules = rules
        self.refused: OrderedDict[Refused, int] = OrderedDict()
        """Numbers of refused packets of each kind; of the kinds refused last, at most `MAX_REFUSED`."""

    def refusal(self, raw: RawPacket, data: bytes, network: str, now: float) -> str | None:
        """Reason to refuse a packet from `network`, as a counter's name; None when it is accepted."""
        why = self._refusal(raw, data, network, now)
        if why is not None:
            continues = raw.control >> 6 in (DataFlag.MIDDLE, DataFlag.LAST)
            kind = Refused(why, network, None if continues else _message_id(raw, data))
            self.refused[kind] = self.refused.pop(kind, 0) + 1
            if len(self.refused) > MAX_REFUSED:
                self.refused.popitem(last=False)
        return why

    def _refusal(self, raw: RawPacket, data: bytes, network: str, now: float) -> str | None:
        if network in self._outside:
            if self._is_inside(raw.source >> 16):
                return "own_id_outside"
            if raw.destination >> 16 != ANY_SUBSYSTEM and not self._is_inside(raw.destination >> 16):
                return "not_addressed_here"
        return self._rules.refusal(raw, data, network, now)

    def onward(self, raw: RawPacket, network: str) -> tuple[str, ...]:
        """The networks that an accepted packet from `network` may be sent to."""
        if raw.broadcast == Broadcast.LOCAL:
            return ()
        if network in self._outside:
            return self._inside
        return tuple(name for name in self.reach(raw.source, raw.destination) if name != network)

    def reach(self, source: int, destination: int) -> tuple[str, ...]:
        """The networks for a packet from inside: own ids are inside, all others outside, wildcards both."""
        subsystem = destination >> 16
        stays = self._is_inside(subsystem)
        inside = self._inside if stays or subsystem == ANY_SUBSYSTEM else ()
        leaves = not stays and self._is_inside(source >> 16)
        return inside + (self._outside if leaves else ())

    def _is_inside(self, subsystem: int) -> bool:
        return any(subsystem in subsystems for subsystems in self._subsystems)
