"""What a gateway decides: which packets cross from one network to another.

A gateway stands between the networks inside a subsystem (its capability modules) and those outside (operator control
units, other robots). Only what concerns ids of its subsystem crosses, and nothing goes back to where it came from.
The components of its own machine count as inside.
"""

from __future__ import annotations

from collections.abc import Iterable

from jauspy.protocol.header import Broadcast, RawPacket
from jauspy.protocol.rules import GatewayRules

ANY_SUBSYSTEM = 0xFFFF


class Gateway:
    """`networks` are all names, `inside` those of the subsystem itself."""

    def __init__(self, subsystem: int, networks: Iterable[str], inside: Iterable[str], rules: GatewayRules) -> None:
        self._subsystem = subsystem
        self._inside = tuple(inside)
        self._outside = tuple(name for name in networks if name not in self._inside)
        self._rules = rules

    def refusal(self, raw: RawPacket, data: bytes, network: str, now: float) -> str | None:
        """Why a packet from `network` is not taken at all (a short name for counters); None when it is."""
        if network in self._outside:
            if raw.source >> 16 == self._subsystem:
                return "own_id_outside"
            if raw.destination >> 16 not in (self._subsystem, ANY_SUBSYSTEM):
                return "not_addressed_here"
        return self._rules.refusal(raw, data, network, now)

    def onward(self, raw: RawPacket, network: str) -> tuple[str, ...]:
        """The networks that a packet which was taken from `network` may be sent to."""
        if raw.broadcast == Broadcast.LOCAL:
            return ()
        if network in self._outside:
            return self._inside
        return tuple(name for name in self.reach(raw.source, raw.destination) if name != network)

    def reach(self, source: int, destination: int) -> tuple[str, ...]:
        """Where a packet from inside belongs: ids of the subsystem are inside, all others outside, wildcards both."""
        to = destination >> 16
        inside = self._inside if to in (self._subsystem, ANY_SUBSYSTEM) else ()
        leaves = to != self._subsystem and source >> 16 == self._subsystem
        return inside + (self._outside if leaves else ())
