"""Shares of two arms: the estimate is what a schedule does, and the second arm is used only where that saves time."""

from __future__ import annotations

import asyncio
from collections.abc import Sequence

import pytest
from hypothesis import given, settings, strategies as st

from jauspy.cell.schedule import Entry, Schedule, Timeline
from jauspy.cell.shares import MARGIN, Planned, StepTimes, best_share, estimated
from jauspy.testing import VirtualClock

RESOURCES = ("ur10", "arm", "tray")


@st.composite
def schedules(draw: st.DrawFn) -> list[Planned]:
    found: list[Planned] = []
    for number in range(draw(st.integers(1, 7))):
        after = draw(st.sets(st.sampled_from([action.name for action in found]), max_size=2)) if found else set()
        uses = draw(st.sets(st.sampled_from(RESOURCES), max_size=2))
        duration = draw(st.integers(1, 40)) / 8.0 + number / 1024.0  # no two actions end at the same time
        found.append(Planned(f"{number}", duration, tuple(sorted(after)), frozenset(uses)))
    return found


async def carried_out(actions: Sequence[Planned]) -> float:
    schedule = Schedule(asyncio.get_running_loop().time)
    for action in actions:

        async def wait(seconds: float = action.duration) -> None:
            await asyncio.sleep(seconds)

        schedule.add(action.name, wait, after=action.after, uses=action.uses)
    return (await schedule.run()).total


@settings(max_examples=40, deadline=None)
@given(schedules())
def test_an_estimate_is_what_the_schedule_takes(actions: list[Planned]) -> None:
    async def run() -> float:
        with VirtualClock():
            return await carried_out(actions)

    assert estimated(actions) == pytest.approx(asyncio.run(run()), abs=1e-6)


@pytest.mark.slow
@given(schedules())
def test_an_estimate_is_between_the_longest_chain_and_all_in_a_row(actions: list[Planned]) -> None:
    total = estimated(actions)
    assert max(action.duration for action in actions) <= total + 1e-9
    assert total <= sum(action.duration for action in actions) + 1e-9


def plan(seconds: float) -> object:
    """Two products of 10 s; the second one may be done by the arm, which takes so many seconds."""

    def make(by_arm: frozenset[int]) -> list[Planned]:
        own = [Planned(f"own {n}", 10.0, uses=frozenset({"ur10"})) for n in range(2) if n not in by_arm]
        return own + [Planned(f"arm {n}", seconds, uses=frozenset({"arm"})) for n in by_arm]

    return make


@pytest.mark.parametrize(("seconds", "used"), [(5.0, True), (18.0, True), (20.0 - MARGIN / 2.0, False), (25.0, False)])
def test_the_second_arm_is_used_only_where_it_saves_time(seconds: float, used: bool) -> None:
    share = best_share([1], plan(seconds))  # type: ignore[arg-type]
    assert share.alone == 20.0
    assert share.by_arm == (frozenset({1}) if used else frozenset())
    assert share.expected == (max(10.0, seconds) if used else 20.0)


def test_without_a_product_for_it_the_second_arm_does_nothing() -> None:
    share = best_share([], plan(1.0))  # type: ignore[arg-type]
    assert (share.by_arm, share.expected) == (frozenset(), 20.0)


def test_expected_times_are_the_means_of_what_was_measured() -> None:
    times = StepTimes({"fetch": 4.0, "place": 5.0})
    entries = [Entry("fetch 0", 0.0, 3.0), Entry("fetch 1", 3.0, 8.0)]
    times.learn(Timeline(entries), {"fetch 0": "fetch", "fetch 1": "fetch"})
    assert times["fetch"] == 4.0
    times.learn(Timeline([Entry("fetch 0", 0.0, 1.0)]), {"fetch 0": "fetch"})
    assert times["fetch"] == 3.0
    assert times["place"] == 5.0, "not measured yet"
