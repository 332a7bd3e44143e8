"""Queries whose answers look alike: equal ones may be outstanding at once, different ones take turns."""

from __future__ import annotations

import asyncio
from collections.abc import AsyncIterator, Hashable
from contextlib import asynccontextmanager
from dataclasses import dataclass, field


@dataclass(slots=True)
class _Turns:
    content: bytes = b""
    active: int = 0
    waiting: int = 0
    turn: asyncio.Event = field(default_factory=asyncio.Event)


class QuerySerializer:
    """By key; a lane exists only while somebody is in it."""

    def __init__(self) -> None:
        self._lanes: dict[Hashable, _Turns] = {}

    def __len__(self) -> int:
        return len(self._lanes)

    @asynccontextmanager
    async def enter(self, key: Hashable, content: bytes) -> AsyncIterator[None]:
        """Share the lane with equal content, wait until other content has left it."""
        lane = self._lanes.setdefault(key, _Turns())
        try:
            await self._wait(lane, content)
            lane.content = content
            lane.active += 1
            try:
                yield
            finally:
                lane.active -= 1
        finally:
            if not lane.active:
                lane.turn.set()
                if not lane.waiting:
                    self._lanes.pop(key, None)

    async def _wait(self, lane: _Turns, content: bytes) -> None:
        """Who comes new goes behind all who wait, or these might wait for ever."""
        has_turn = not lane.waiting
        lane.waiting += 1
        try:
            while not has_turn or (lane.active and lane.content != content):
                lane.turn.clear()
                await lane.turn.wait()
                has_turn = True
        finally:
            lane.waiting -= 1
