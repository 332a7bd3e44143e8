"""How verbs run until they are done or told to stop."""

from __future__ import annotations

import asyncio
import os
import signal
import sys
import threading
import time
from collections.abc import Callable, Coroutine, Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import Any, Final, TypeVar

T = TypeVar("T")

GRACE: Final = 4.0  # seconds to stop in order after the parent is gone
PARTING: Final = 5.0  # seconds in which a second Ctrl-C does not cut an orderly end short


def run(main: Coroutine[Any, Any, T]) -> T | None:
    """Run `main`; Ctrl-C, SIGTERM and a closed terminal cancel it, so that its `async with` blocks end in order.

    Returns None after SIGTERM: being told to stop is not a failure. Ctrl-C raises `KeyboardInterrupt`.
    """
    terminated = False

    async def guarded() -> T:
        nonlocal terminated
        task = asyncio.ensure_future(main)

        def terminate() -> None:
            nonlocal terminated
            terminated = True
            task.cancel()

        for number in (signal.SIGTERM, signal.SIGHUP):
            asyncio.get_running_loop().add_signal_handler(number, terminate)
        return await task

    try:
        return asyncio.run(guarded())
    except asyncio.CancelledError:
        if terminated:
            return None
        raise


@contextmanager
def stoppable() -> Iterator[Callable[[], int]]:
    """Ctrl-C, SIGTERM and a closed terminal raise `KeyboardInterrupt`; yields what tells the exit status then.

    What follows at once is ignored, so that who is impatient does not prevent an orderly end.
    """
    came: list[tuple[float, int]] = []

    def stop(number: int, frame: object) -> None:  # noqa: ARG001 - a signal handler
        now = time.monotonic()
        if not came or now - came[-1][0] > PARTING:
            came.append((now, number))
            raise KeyboardInterrupt

    before = {each: signal.signal(each, stop) for each in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP)}
    try:
        yield lambda: 128 + (came[-1][1] if came else signal.SIGINT)
    finally:
        for each, handler in before.items():
            signal.signal(each, handler)


def end_with_parent() -> None:
    """Stop this process when its standard input closes.

    The parent holds the other end, and however the parent dies,
    the kernel closes it.
    """
    threading.Thread(target=_wait_for_parent, name="parent-watch", daemon=True).start()


def _wait_for_parent() -> None:
    while os.read(sys.stdin.fileno(), 4096):
        pass
    os.kill(os.getpid(), signal.SIGTERM)
    threading.Event().wait(GRACE)
    os._exit(1)


def remove_if_empty(root: Path) -> None:
    """Remove a folder of sockets after the last of its users; the others find it in use and leave it."""
    with suppress(OSError):
        root.rmdir()
