"""What decoding costs, held against what a normal message of that size costs."""

from __future__ import annotations

import math
import statistics
import sys
import time
import tracemalloc
from collections.abc import Callable, Iterable

from jauspy.errors import DecodeError
from jauspy.fuzz.seeds import Seed
from jauspy.fuzz.targets import Target

TIMES = 100
"""How much more than a normal message of its size an input may cost."""

SMALLEST = 512
"""Inputs below this many bytes are measured as if they had so many."""

BLOCKS_PER_BYTE = 100
PEAK_PER_BYTE = 5000
"""Normal are about 2 blocks and 100 bytes of memory for every byte of a list of small records."""


class Effort:
    """Measures with the processor time of this thread, which others on the machine do not change."""

    def __init__(self, normal: Iterable[tuple[Target, Seed]]) -> None:
        self._rate = statistics.median(_time_per_byte(target, seed.data) for target, seed in normal)
        self._rate = max(self._rate, 1.0)

    def limit(self, size: int) -> float:
        """The nanoseconds that an input of this size may take."""
        return TIMES * self._rate * max(size, SMALLEST)

    def complaint(self, size: int, spent: float, again: Callable[[], object]) -> str | None:
        """What is wrong with the time of a case. What looks slow is measured three times more; the best counts."""
        limit = self.limit(size)
        if spent <= limit:
            return None
        best = spent
        for _ in range(3):
            best = min(best, spent_on(again))
            if best <= limit:
                return None
        return f"{size} bytes took {best / 1e6:.0f} ms, {best / limit * TIMES:.0f} times as long as normal ones"


def spent_on(call: Callable[[], object]) -> float:
    """Nanoseconds of processor time."""
    start = time.thread_time_ns()
    call()
    return time.thread_time_ns() - start


def memory_complaint(size: int, call: Callable[[], object]) -> str | None:
    """What is wrong with the memory that a call takes at its peak, and with what its result keeps."""
    before = sys.getallocatedblocks()
    kept = call()
    blocks = sys.getallocatedblocks() - before
    del kept
    if blocks > 2000 + BLOCKS_PER_BYTE * size:
        return f"the message made of {size} bytes keeps {blocks} blocks of memory"
    tracemalloc.start()
    try:
        call()
        _, peak = tracemalloc.get_traced_memory()
    finally:
        tracemalloc.stop()
    if peak > 1_000_000 + PEAK_PER_BYTE * size:
        return f"decoding {size} bytes takes {peak} bytes of memory"
    return None


def _time_per_byte(target: Target, data: bytes) -> float:
    try:
        target.cls.decode(data)
    except DecodeError:
        return math.inf
    return min(spent_on(lambda: target.cls.decode(data)) for _ in range(5)) / len(data)
