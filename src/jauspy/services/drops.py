"""Counting what a component does not do: nothing is dropped in silence."""

from __future__ import annotations

import logging
from collections import Counter
from collections.abc import Callable
from typing import Final, TypeAlias

Count: TypeAlias = Callable[[str, str], None]
"""Counts something dropped: (reason, detail)."""

_LOG: Final = logging.getLogger("jauspy.services")


class Drops:
    """Counts by reason into `counters`; the first of each reason is logged at DEBUG, as `who` is called then."""

    def __init__(self, counters: Counter[str], who: Callable[[], object]) -> None:
        self._counters = counters
        self._who = who
        self._logged: set[str] = set()

    def count(self, reason: str, detail: str) -> None:
        """One more."""
        self._counters[reason] += 1
        if reason not in self._logged:
            self._logged.add(reason)
            _LOG.debug("%s: first %s: %s", self._who(), reason, detail)
