"""A motion is stopped when the browser is silent, and not because the console itself did not run."""

from __future__ import annotations

import asyncio
import time

import pytest

from jauspy.console.dead_man import DEAD_MAN_TIME, GRACE, LATE, MAX_GRACES, DeadMan

BLOCKED = DEAD_MAN_TIME + LATE + 0.05


@pytest.fixture
def stops() -> list[float]:
    """Times of stops, by the clock of the event loop."""
    return []


def dead_man(stops: list[float]) -> DeadMan:
    return DeadMan(lambda: stops.append(asyncio.get_running_loop().time()))


async def test_a_silent_browser_is_stopped(stops: list[float]) -> None:
    began = asyncio.get_running_loop().time()
    dead_man(stops).repeat()
    async with asyncio.timeout(5):
        while not stops:
            await asyncio.sleep(0.01)
    assert stops[0] - began >= DEAD_MAN_TIME


async def test_an_ended_motion_is_not_stopped(stops: list[float]) -> None:
    switch = dead_man(stops)
    switch.repeat()
    switch.end()
    await asyncio.sleep(2 * DEAD_MAN_TIME)
    assert stops == []


async def test_what_waits_in_the_socket_of_a_blocked_console_counts(stops: list[float]) -> None:
    switch = dead_man(stops)
    switch.repeat()
    time.sleep(BLOCKED)  # noqa: ASYNC251 - this blocks the event loop
    await asyncio.sleep(0)  # the timer is due
    switch.repeat()  # the message that waited
    await asyncio.sleep(0)
    assert stops == []
    switch.end()


async def test_a_browser_that_is_silent_beside_a_blocked_console_is_stopped(stops: list[float]) -> None:
    dead_man(stops).repeat()
    time.sleep(BLOCKED)  # noqa: ASYNC251 - this blocks the event loop
    awake = asyncio.get_running_loop().time()
    async with asyncio.timeout(5):
        while not stops:
            await asyncio.sleep(0.01)
    assert stops[0] - awake >= GRACE - 0.01


async def turn() -> None:
    """Let the event loop call the timers that are due."""
    for _ in range(3):
        await asyncio.sleep(0)


async def block_again(times: int) -> None:
    """Block the event loop beyond the dead-man's time, and again whenever it has begun to read."""
    time.sleep(BLOCKED)  # noqa: ASYNC251 - this blocks the event loop
    for _ in range(times):
        await turn()
        time.sleep(GRACE + LATE + 0.05)  # noqa: ASYNC251 - this blocks the event loop
    await turn()


async def test_a_console_that_is_blocked_again_while_it_reads_stops_nobody(stops: list[float]) -> None:
    switch = dead_man(stops)
    switch.repeat()
    await block_again(1)
    assert stops == []
    switch.repeat()  # the message that waited
    await turn()
    assert stops == []
    switch.end()


async def test_a_silent_browser_is_stopped_by_a_console_that_is_always_late(stops: list[float]) -> None:
    dead_man(stops).repeat()
    await block_again(MAX_GRACES)
    assert len(stops) == 1
