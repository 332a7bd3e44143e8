"""What the event loop calls must not raise into it: a bug is logged and counted, and the component goes on."""

from __future__ import annotations

import logging
from collections import Counter
from types import TracebackType
from typing import Final

_LOG: Final = logging.getLogger("jauspy.component")


class ErrorGuard:
    """A `with` block around everything one wake-up does; reusable, not to be nested."""

    __slots__ = ("_counters", "_name")

    def __init__(self, name: str, counters: Counter[str]) -> None:
        self._name = name
        self._counters = counters

    def __enter__(self) -> None:
        return None

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> bool:
        if not isinstance(error, Exception):
            return False
        self._counters["internal_error"] += 1
        _LOG.error("%s: %s", self._name, error, exc_info=error)
        return True
