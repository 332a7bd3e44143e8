"""Rate limits: a token bucket for each of many keys."""

from __future__ import annotations

from collections import OrderedDict
from collections.abc import Hashable
from typing import Final

MAX_TOKEN_BUCKETS: Final = 4096


class TokenBuckets:
    """`rate` per second for each key, and `burst` at once; the keys that were quiet longest are forgotten first.

    A forgotten key begins again with a full bucket, so a flood of made-up keys is not limited by this alone.
    """

    def __init__(self, rate: float, burst: float, *, limit: int = MAX_TOKEN_BUCKETS) -> None:
        self._rate = rate
        self._burst = max(burst, 1.0)
        self._limit = limit
        self._buckets: OrderedDict[Hashable, tuple[float, float]] = OrderedDict()

    def __len__(self) -> int:
        return len(self._buckets)

    def take(self, key: Hashable, now: float) -> bool:
        """True when `key` may have one more now."""
        tokens, last = self._buckets.get(key, (self._burst, now))
        tokens = min(self._burst, tokens + (now - last) * self._rate)
        granted = tokens >= 1.0
        self._buckets[key] = (tokens - granted, now)
        self._buckets.move_to_end(key)
        if len(self._buckets) > self._limit:
            self._buckets.popitem(last=False)
        return granted
