"""Checks of sources: an id must keep its address, and may be limited in its rate."""

from __future__ import annotations

from collections import OrderedDict
from collections.abc import Collection, Hashable
from dataclasses import dataclass
from typing import Final, NamedTuple, TypeVar

from jauspy.protocol.address_book import MAX_IDS, IdBounds, LearnedAddresses
from jauspy.protocol.addressing import NetworkPort
from jauspy.protocol.header import Priority

MAX_TOKEN_BUCKETS: Final = 4096

_V = TypeVar("_V")


class TokenBuckets:
    """Allows `rate` events per second for each key, and `burst` at once; the least recently used keys are forgotten.

    A forgotten key starts with a full bucket, so this alone does not limit a flood of made-up keys.
    """

    def __init__(self, rate: float, burst: float, *, limit: int = MAX_TOKEN_BUCKETS) -> None:
        self._rate = rate
        self._burst = max(burst, 1.0)
        self._limit = limit
        self._buckets: OrderedDict[Hashable, tuple[float, float]] = OrderedDict()

    def __len__(self) -> int:
        return len(self._buckets)

    def take(self, key: Hashable, now: float) -> bool:
        """Take one token of `key`; false when there is none."""
        tokens, last = self._buckets.get(key, (self._burst, now))
        tokens = min(self._burst, tokens + (now - last) * self._rate)
        granted = tokens >= 1.0
        self._buckets[key] = (tokens - granted, now)
        self._buckets.move_to_end(key)
        if len(self._buckets) > self._limit:
            self._buckets.popitem(last=False)
        return granted

    def is_empty(self, key: Hashable, now: float) -> bool:
        """True when `take` would be refused."""
        tokens, last = self._buckets.get(key, (self._burst, now))
        return tokens + (now - last) * self._rate < 1.0


MOVE_TIMEOUT: Final = 30.0
"""Seconds without a packet after which an id may have any host. For as long, a wrong claim prevents others."""
VERIFIED_INTERVAL: Final = 0.25
"""Seconds for which a checked address needs no further check."""
FOLLOW_SILENCE: Final = 0.25
"""Seconds of silence of the old way after a claim; a reliable message is resent for longer."""
NEXT_CLAIM: Final = 0.5
"""Seconds without a claim after the old way was heard: meanwhile its packets need no check."""
CLAIM_LIFETIME: Final = 2.0
"""Seconds between two packets of a claim."""
MAX_CLAIMS: Final = 1024
MIN_SEQUENCE_WINDOW: Final = 64
"""Sequence numbers by which the new way may be ahead of the last known one, and twice what the id sends meanwhile."""
MAX_SEQUENCE_WINDOW: Final = 4096
UNKNOWN_RATE: Final = 100.0
"""Messages per second that an id is assumed to send until two of its numbers are known."""
_HALF: Final = 1 << 15
_FULL: Final = 1 << 16
_URGENT: Final = 1 << 32


class _Sequence(NamedTuple):
    number: int
    at: float
    rate: float
    """Numbers per second."""


@dataclass(slots=True)
class _Claim:
    port: NetworkPort
    since: float
    last: float


class AddressChanges:
    """Lets an id that was heard lately have another host, as when a gateway fails and another one takes over (ADR 85).

    The first packet by a new way is a claim. It is accepted when the old way has been silent from then on, and the new
    way either is authenticated or goes on with the sequence numbers of the id. Ids are 32-bit numbers, and the
    numbers of `max_ids` are remembered.
    """

    def __init__(self, max_ids: int = MAX_IDS) -> None:
        self._max_ids = max_ids
        self._sequences: OrderedDict[int, _Sequence] = OrderedDict()
        self._claims: OrderedDict[int, _Claim] = OrderedDict()
        self._barred: OrderedDict[int, float] = OrderedDict()
        self._former: OrderedDict[int, tuple[NetworkPort, float]] = OrderedDict()

    def is_claimed(self, id: int) -> bool:
        """True while a new way of this id is watched, so that each packet of the old one counts."""
        return id in self._claims

    def has_new_claim(self, id: int, now: float) -> bool:
        """True for a claim of this moment."""
        claim = self._claims.get(id)
        return claim is not None and claim.since == now

    def heard(self, id: int, port: NetworkPort, sequence: int | None, now: float) -> None:
        """Note a packet that was accepted; one of the old way ends a claim."""
        claim = self._claims.get(id)
        if claim is not None and not is_same_host(claim.port, port):
            del self._claims[id]
            _put(self._barred, id, now + NEXT_CLAIM, MAX_CLAIMS)
        if sequence is None:
            return
        known = self._sequences.get(id)
        rate = UNKNOWN_RATE
        if known is not None:
            steps, seconds = (sequence - known.number) % _FULL, now - known.at
            rate = steps / seconds if steps < _HALF and seconds >= VERIFIED_INTERVAL else known.rate
        _put(self._sequences, id, _Sequence(sequence, now, rate), self._max_ids)

    def allows(
        self, id: int, port: NetworkPort, holder: NetworkPort, sequence: int | None, now: float, *, authenticated: bool
    ) -> bool:
        """True when the id may have `port` from now on, although it was heard from `holder` lately."""
        former, until = self._former.get(id, (None, 0.0))
        if former is not None and now < until and is_same_host(former, port):
            del self._former[id]
            _put(self._barred, id, now + MOVE_TIMEOUT, MAX_CLAIMS)
            self._claims.pop(id, None)
            return True
        if now < self._barred.get(id, now) or not (authenticated or self._continues(id, sequence, now)):
            return False
        claim = self._claims.get(id)
        if claim is None or not is_same_host(claim.port, port) or now - claim.last > CLAIM_LIFETIME:
            _put(self._claims, id, _Claim(port, now, now), MAX_CLAIMS)
            return False
        claim.last = now
        if now - claim.since < FOLLOW_SILENCE:
            return False
        del self._claims[id]
        if not authenticated:
            _put(self._former, id, (holder, now + MOVE_TIMEOUT), MAX_CLAIMS)
        return True

    def _continues(self, id: int, sequence: int | None, now: float) -> bool:
        """True when a number follows the known ones. A wrong one bars the id, so that nobody can try many."""
        known = self._sequences.get(id)
        if sequence is None or known is None:
            return False
        window = min(MIN_SEQUENCE_WINDOW + 2 * known.rate * (now - known.at), MAX_SEQUENCE_WINDOW)
        ahead = (sequence - known.number + _HALF) % _FULL - _HALF
        if 0 < ahead <= window:
            return True
        if -window <= ahead <= 0:
            return False  # a copy of what was received by the old way
        _put(self._barred, id, now + MOVE_TIMEOUT, MAX_CLAIMS)
        self._claims.pop(id, None)
        return False


def is_same_host(one: NetworkPort, other: NetworkPort) -> bool:
    """True for two ports of one host on one network."""
    return one.host == other.host and one.network == other.network


def _put(table: OrderedDict[int, _V], id: int, value: _V, limit: int) -> None:
    table[id] = value
    table.move_to_end(id)
    if len(table) > limit:
        table.popitem(last=False)


@dataclass(frozen=True, slots=True)
class SourceLimits:
    """Limits of sources. `rate` is in messages per second and source, 0 for no limit; `burst` in messages."""

    check_address: bool = True
    rate: float = 0.0
    burst: float = 1000.0


class SourceChecks:
    """Checks packets by their source id, a 32-bit number; those of `authenticated` networks have a signature.

    `bounds` limits the ids whose addresses, numbers and rates are remembered.
    """

    def __init__(
        self,
        limits: SourceLimits | None = None,
        *,
        authenticated: Collection[str] = (),
        bounds: IdBounds = IdBounds(),  # noqa: B008 - immutable
    ) -> None:
        self._addresses = LearnedAddresses(bounds)
        self._changes = AddressChanges(bounds.total)
        self._max_ids = bounds.total
        self._authenticated = frozenset(authenticated)
        self.set_limits(limits or SourceLimits())

    def set_limits(self, limits: SourceLimits) -> None:
        """Replace the limits; known addresses are kept."""
        self._limits = limits
        self._buckets = TokenBuckets(limits.rate, limits.burst, limit=self._max_ids)
        self.are_limited = limits.rate > 0

    def within_rate(self, id: int, priority: int, now: float) -> bool:
        """False when this source exceeds its rate; call only when `are_limited`.

        Safety-critical messages have a separate budget.
        """
        return self._buckets.take(id | _URGENT if priority == Priority.SAFETY_CRITICAL else id, now)

    def is_over_rate(self, id: int, priority: int, now: float) -> bool:
        """True when `within_rate` would be false; nothing is counted. Call only when `are_limited`."""
        return self._buckets.is_empty(id | _URGENT if priority == Priority.SAFETY_CRITICAL else id, now)

    def is_verified(self, id: int, port: NetworkPort, now: float) -> bool:
        """True when this id had exactly this address a moment ago, so that there is nothing to check or learn."""
        known = self._addresses.get(id)
        if known is None or known[0] != port or now - known[1] >= VERIFIED_INTERVAL:
            return False
        return not self._changes.is_claimed(id)

    def forget(self, port: NetworkPort) -> None:
        """Remove the ids of an address, as when a connection was closed; they may then get another one."""
        self._addresses.remove_port(port)

    def holder(self, id: int, now: float) -> NetworkPort | None:
        """The address that this id has until it is silent for `MOVE_TIMEOUT` seconds; None without address checks."""
        known = self._addresses.get(id) if self._limits.check_address else None
        return known[0] if known is not None and now - known[1] < MOVE_TIMEOUT else None

    def check_address(self, id: int, port: NetworkPort, now: float, sequence: int | None = None) -> bool:
        """False when this id was lately heard from another host or network, and may not change; another port may.

        `sequence` is the number of the packet, if it has one.
        """
        holder = self.holder(id, now)
        if holder is None or is_same_host(holder, port):
            return True
        authenticated = port.network in self._authenticated
        return self._changes.allows(id, port, holder, sequence, now, authenticated=authenticated)

    def has_new_claim(self, id: int, now: float) -> bool:
        """True when another host has claimed this id at this moment: each packet is to be checked for a while."""
        return self._changes.has_new_claim(id, now)

    def heard(self, id: int, port: NetworkPort, now: float, sequence: int | None = None) -> None:
        """Note a packet that was accepted."""
        self._changes.heard(id, port, sequence, now)
        self._addresses.set(id, port, now)
