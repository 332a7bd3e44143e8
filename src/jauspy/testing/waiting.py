"""Waiting for a condition, where a sleep would be a guess."""

from __future__ import annotations

import asyncio
from collections.abc import Callable
from typing import Final

POLL_INTERVAL: Final = 0.005
"""Seconds between two looks."""


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
