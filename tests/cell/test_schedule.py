"""The scheduler: what may run at once does."""

from __future__ import annotations

import asyncio

import pytest

from jauspy.cell.schedule import Schedule, TaskFailed
from jauspy.errors import ConfigError
from jauspy.testing import VirtualClock


def schedule() -> Schedule:
    return Schedule(asyncio.get_running_loop().time)


async def wait() -> None:
    await asyncio.sleep(1.0)


async def test_independent_actions_run_at_once() -> None:
    with VirtualClock():
        plan = schedule()
        plan.add("a", wait, uses=["left"])
        plan.add("b", wait, uses=["right"])
        found = await plan.run()
    assert found.total == pytest.approx(1.0, abs=1e-3)
    assert found.saved == pytest.approx(1.0, abs=1e-3)


async def test_a_resource_is_used_by_one_action_at_a_time() -> None:
    with VirtualClock():
        plan = schedule()
        plan.add("a", wait, uses=["left"])
        plan.add("both", wait, uses=["left", "right"])
        plan.add("b", wait, uses=["right"])
        found = await plan.run()
    ends = {each.action: each.end for each in found.entries}
    assert ends["a"] == pytest.approx(1.0, abs=1e-3)
    assert ends["b"] == pytest.approx(1.0, abs=1e-3)
    assert ends["both"] == pytest.approx(2.0, abs=1e-3)


async def test_actions_wait_for_those_before() -> None:
    with VirtualClock():
        plan = schedule()
        plan.add("a", wait)
        plan.add("b", wait, after=["a"])
        found = await plan.run()
    assert [each.action for each in found.entries] == ["a", "b"]
    assert found.total == pytest.approx(2.0, abs=1e-3)


async def test_a_failure_ends_what_runs() -> None:
    ended = []

    async def long() -> None:
        try:
            await asyncio.sleep(60.0)
        finally:
            ended.append("long")

    async def fail() -> None:
        await asyncio.sleep(1.0)
        raise TaskFailed("the part is lost")

    with VirtualClock() as clock:
        plan = schedule()
        plan.add("long", long)
        plan.add("fail", fail)
        plan.add("never", wait, after=["fail"])
        with pytest.raises(TaskFailed, match="lost"):
            await plan.run()
        assert clock.elapsed < 2.0
    assert ended == ["long"]
    assert [each.action for each in plan.timeline.entries] == ["fail"]


async def test_mistakes_in_a_schedule_are_named() -> None:
    plan = schedule()
    plan.add("a", wait)
    with pytest.raises(ConfigError, match="'a' already"):
        plan.add("a", wait)
    with pytest.raises(ConfigError, match="after 'z'"):
        plan.add("b", wait, after=["z"])
