"""Ends a case that does not end by itself."""

from __future__ import annotations

import signal
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any, Final, NoReturn

MOST_SECONDS: Final = 20.0
"""Processor time of one case: far beyond every limit, so only for what would never end."""


class TooLong(BaseException):
    """Raised in the middle of the case, past everything that handles exceptions."""


@contextmanager
def watched() -> Iterator[None]:
    """Raise `TooLong` when the block takes too much processor time; only the main thread can be watched."""
    if threading.current_thread() is not threading.main_thread():
        yield
        return
    before = signal.signal(signal.SIGVTALRM, _stop)
    signal.setitimer(signal.ITIMER_VIRTUAL, MOST_SECONDS)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_VIRTUAL, 0)
        signal.signal(signal.SIGVTALRM, before)


def _stop(number: int, frame: Any) -> NoReturn:  # noqa: ARG001 - a signal handler gets both
    raise TooLong(f"no end after {MOST_SECONDS:g} s of processor time")
