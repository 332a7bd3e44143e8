"""How a program with an OCU ends: SIGTERM and SIGHUP leave its blocks in order, so that its robots stop."""

from __future__ import annotations

import signal
import sys
import threading
from collections import Counter
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Final

SIGNALS: Final = ("SIGTERM", "SIGHUP")
"""Signals that would end the process at once."""


_users: Final[Counter[int]] = Counter()
"""How many open OCUs have a handler for each signal."""
_left: Final[set[int]] = set()
"""Signals that have begun to end the program; more of them must not interrupt its orderly end."""


def leave(number: int, frame: object = None) -> None:  # noqa: ARG001 - a signal handler
    """End the program as `sys.exit` does, with the exit status that a shell gives for this signal.

    In an event loop that `asyncio.run` runs, all tasks are cancelled and waited for.
    """
    if not _left:
        _left.add(number)
        sys.exit(128 + number)


@contextmanager
def orderly(install: Callable[[int], object], remove: Callable[[int], object]) -> Iterator[None]:
    """Inside, signals that would kill the process are handled by what `install` installs for each, in the main thread.

    Without effect for signals that the program handles or ignores itself.
    """
    is_main = threading.current_thread() is threading.main_thread()
    numbers = [getattr(signal, name) for name in SIGNALS if is_main and hasattr(signal, name)]
    handled = [number for number in numbers if _users[number] or signal.getsignal(number) is signal.SIG_DFL]
    for number in handled:
        if not _users[number]:
            install(number)
        _users[number] += 1
    try:
        yield
    finally:
        for number in handled:
            _users[number] -= 1
            if not _users[number]:
                remove(number)
