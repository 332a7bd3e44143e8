"""Assertions about asynchronous code: a condition becomes true, nothing is left behind."""

from __future__ import annotations

import asyncio
import gc
from collections.abc import AsyncIterator, Callable
from contextlib import asynccontextmanager
from typing import Any, Final

POLL_INTERVAL: Final = 0.005
"""Seconds between two checks of a condition."""


async def until(condition: Callable[[], object], within: float = 20.0) -> None:
    """Wait until the condition is true; `AssertionError` after `within` seconds of the event loop's clock."""
    clock = asyncio.get_running_loop().time
    end = clock() + within
    while not condition():
        if clock() >= end:
            raise AssertionError(f"waited {within:g} s in vain for {_named(condition)}")
        await asyncio.sleep(POLL_INTERVAL)


def _named(condition: Callable[[], object]) -> str:
    code = getattr(condition, "__code__", None)
    return f"the condition at {code.co_filename}:{code.co_firstlineno}" if code else repr(condition)


@asynccontextmanager
async def no_leftovers() -> AsyncIterator[None]:
    """Raise `AssertionError` when the body leaves a task running, or an error that only the event loop has reported."""
    loop, before = asyncio.get_running_loop(), asyncio.all_tasks()
    errors: list[dict[str, Any]] = []
    handler = loop.get_exception_handler()
    freezes = not gc.get_freeze_count()
    if freezes:
        gc.freeze()  # existing objects need not be searched for such errors, which would take long
    loop.set_exception_handler(lambda _, context: errors.append(context))
    try:
        yield
        for _ in range(3):
            await asyncio.sleep(0)
        gc.collect()  # an error of a task or future that nobody retrieved is reported when it is deleted
    finally:
        if freezes:
            gc.unfreeze()
        loop.set_exception_handler(handler)
    left = asyncio.all_tasks() - before - {asyncio.current_task()}
    if left:
        raise AssertionError(f"still running at the end of the test: {', '.join(sorted(map(str, left)))}")
    if errors:
        error = errors[0].get("exception")
        raise AssertionError(f"an unhandled error: {errors[0].get('message')}: {error!r}") from error
