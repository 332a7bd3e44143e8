"""The way of a plan: legs for a list of positions, and where an arm is on it."""

from __future__ import annotations

import asyncio
import itertools
import math
from threading import Event

import pytest

pytest.importorskip("numpy", reason="numpy is not installed")

import numpy as np

from jauspy.ocu.motion_limits import MotionLimits, straight_duration, straight_limits
from jauspy.planning.execution import DEVIATION, LEAST_LEG, LEG_TOLERANCE, Path, in_thread, legs_of
from jauspy.planning.obstacles import Array

BENT = np.array([(0.0, 0.0), (1.0, 0.0), (1.0, 1.0)])


def dense(points: Array, count: int = 50) -> Array:
    """The same way with many points."""
    marks = np.linspace(0.0, len(points) - 1.0, count * (len(points) - 1) + 1)
    return np.stack([np.interp(marks, range(len(points)), column) for column in points.T], axis=1)


def test_only_bends_are_sent() -> None:
    assert legs_of(dense(BENT)) == [0, 50, 100]
    assert legs_of(BENT[:2]) == [0, 1]
    assert legs_of(BENT[:1]) == [0]


def test_curves_are_followed_within_the_tolerance() -> None:
    angles = np.linspace(0.0, math.pi / 2.0, 400)
    curve = np.stack((np.sin(angles), 1.0 - np.cos(angles)), axis=1)
    legs = curve[legs_of(curve)]
    assert 5 < len(legs) < 40
    assert max(Path(legs).follow(point) for point in curve) <= LEG_TOLERANCE + 1e-9
    assert all(np.abs(b - a).max() >= LEAST_LEG for a, b in itertools.pairwise(legs))


def test_progress_never_goes_back_and_deviation_is_that_of_the_worst_joint() -> None:
    path = Path(BENT)
    assert path.follow((0.5, 0.02)) == pytest.approx(0.02)
    assert path.part == pytest.approx(0.25)
    assert path.follow((0.45, 0.0)) == pytest.approx(0.0)
    assert path.part == pytest.approx(0.25)
    assert path.rest().tolist() == [[0.5, 0.0], [1.0, 0.0], [1.0, 1.0]]
    assert path.follow((0.5, 0.5)) > DEVIATION
    path.follow((1.0, 1.0))
    assert path.left == pytest.approx(0.0)
    assert path.follow((0.2, 0.0)) > DEVIATION  # on the way, but on a part of it that is done


def test_all_joints_have_the_same_part_of_a_straight_way_behind_them() -> None:
    limits = {"a": MotionLimits(1.0, 2.0, 2.0), "b": MotionLimits(0.5, 0.5, 1.0)}
    start, end = (0.0, 0.0), (1.0, -0.5)
    least = straight_duration(limits, start, end)
    assert least == pytest.approx(1.75)
    for duration in (0.0, 1.1 * least, 4.0 * least):
        found = straight_limits(limits, start, end, duration)
        a, b = found["a"], found["b"]
        for one, other in ((a.speed, b.speed), (a.acceleration, b.acceleration), (a.deceleration, b.deceleration)):
            assert other == pytest.approx(0.5 * one)
        assert a.speed <= 1.0 + 1e-9
        assert b.acceleration <= 0.5 + 1e-9
        if duration:
            assert a.least_duration(1.0) == pytest.approx(duration)
            assert b.least_duration(0.5) == pytest.approx(duration)


async def test_a_thread_is_told_that_nobody_waits_for_it() -> None:
    begun, told = Event(), Event()

    def call() -> bool:
        begun.set()
        return told.wait(10.0)

    waiting = asyncio.create_task(in_thread(call, told))
    await asyncio.to_thread(begun.wait, 10.0)
    waiting.cancel()
    with pytest.raises(asyncio.CancelledError):
        await waiting
    assert told.is_set()
