"""What a test must not leave behind: tasks that still run, and errors that nobody saw."""

from __future__ import annotations

import asyncio
import gc
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager
from typing import Any


@asynccontextmanager
async def no_leftovers() -> AsyncIterator[None]:
    """`AssertionError` when the body leaves a task running, or an error reached only the event loop."""
    loop, before = asyncio.get_running_loop(), asyncio.all_tasks()
    complaints: list[dict[str, Any]] = []
    handler = loop.get_exception_handler()
    gc.freeze()  # what there is already need not be searched for such errors, and that is much
    loop.set_exception_handler(lambda _, context: complaints.append(context))
    try:
        yield
        for _ in range(3):
            await asyncio.sleep(0)
        gc.collect()  # a task's or future's error that nobody took is told when it goes
    finally:
        gc.unfreeze()
        loop.set_exception_handler(handler)
    left = asyncio.all_tasks() - before - {asyncio.current_task()}
    if left:
        raise AssertionError(f"still running at the end of the test: {', '.join(sorted(map(str, left)))}")
    if complaints:
        error = complaints[0].get("exception")
        raise AssertionError(f"an error that nobody saw: {complaints[0].get('message')}: {error!r}") from error
