"""Motions of a point between walls in a plane: straight where that is free, around what is in the way otherwise."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise
from typing import Any

import numpy as np
import pinocchio as pin
import pytest
from hypothesis import given, strategies as st

from jauspy.cell.frames import Array, shifted
from jauspy.cell.kinematics import Posture
from jauspy.cell.motion import MAX_NODES, MotionPlanner, NoPath, Path, duration, profile
from jauspy.cell.scene import FAR, Clearance, PlanningScene

LIMITS = st.lists(st.tuples(st.floats(-3.0, 3.0), st.floats(-3.0, 3.0), st.floats(0.1, 4.0), st.floats(0.1, 9.0)))


class Point:
    """An arm of two sliding joints: its tool is at x and y."""

    lower = np.array([-2.0, -2.0])
    upper = np.array([2.0, 2.0])

    def forward(self, positions: Array) -> pin.SE3:
        return shifted(float(positions[0]), float(positions[1]))

    def solve_from(self, goal: pin.SE3, start: Array) -> Array | None:
        return np.array(goal.translation[:2]) if abs(float(goal.translation[2])) < 1e-9 else None


class Disks(PlanningScene):
    """Round obstacles of the point, by name: x, y and radius."""

    def __init__(self, **disks: tuple[float, float, float]) -> None:
        self.disks = disks
        self.checks = 0

    def clearance(self, positions: Array, *, enough: float = FAR) -> Clearance:
        self.checks += 1
        best = Clearance(min(enough, FAR))
        for name, (x, y, radius) in self.disks.items():
            far = float(np.hypot(positions[0] - x, positions[1] - y)) - radius
            if far < best.distance:
                best = Clearance(far, ("point", name))
        return best

    def explain(self, positions: Array) -> Clearance:
        return self.clearance(positions)


def planner(seed: int = 0, nodes: int = MAX_NODES, **disks: tuple[float, float, float]) -> MotionPlanner:
    return MotionPlanner(Disks(**disks), Point(), margin=0.05, seed=seed, nodes=nodes)


def at(x: float, y: float) -> Array:
    return np.array([x, y])


def postures(*points: Sequence[float]) -> list[Posture]:
    return [Posture(np.array(each), 1.0) for each in points]


class TestProfile:
    @given(LIMITS.filter(bool))
    def test_all_joints_arrive_together_within_their_limits(self, rows: list[tuple[float, ...]]) -> None:
        start, goal, speeds, accelerations = (np.array(column) for column in zip(*rows, strict=True))
        found = profile(start, goal, speeds, accelerations)
        moved = np.abs(goal - start) > 1e-9
        assert np.all(found.speeds[moved] <= np.maximum(speeds[moved], 1e-4) * (1.0 + 1e-9))
        assert np.all(found.accelerations[moved] <= np.maximum(accelerations[moved], 1e-4) * (1.0 + 1e-9))
        if not np.any(moved):
            assert found.duration == 0.0
            return
        for way, speed, change in zip(np.abs(goal - start), found.speeds, found.accelerations, strict=True):
            if way * 1e4 > 1.0 and speed > 1.1e-4 and change > 1.1e-4:
                peak = min(speed, float(np.sqrt(way * change)))
                assert found.duration == pytest.approx(way / peak + peak / change, rel=1e-6)

    @given(st.floats(0.01, 3.0), st.floats(0.1, 4.0), st.floats(0.1, 9.0), st.floats(1.0, 5.0))
    def test_a_longer_way_takes_longer(self, way: float, speed: float, change: float, factor: float) -> None:
        limits = np.array([speed]), np.array([change])
        short, long = (profile(np.zeros(1), np.array([each]), *limits).duration for each in (way, way * factor))
        assert long >= short

    def test_a_long_motion_is_a_trapezoid_and_a_short_one_a_triangle(self) -> None:
        limits = np.array([2.0]), np.array([4.0])
        assert profile(np.zeros(1), np.array([3.0]), *limits).duration == pytest.approx(3.0 / 2.0 + 2.0 / 4.0)
        assert profile(np.zeros(1), np.array([0.25]), *limits).duration == pytest.approx(2.0 * np.sqrt(0.25 / 4.0))

    def test_a_path_takes_as_long_as_its_parts(self) -> None:
        path = Path((at(0.0, 0.0), at(3.0, 0.0), at(3.0, 3.0)))
        limits = np.array([2.0, 2.0]), np.array([4.0, 4.0])
        assert duration(path, *limits) == pytest.approx(2.0 * (3.0 / 2.0 + 2.0 / 4.0))
        assert path.end is path.points[-1]


class TestToAPosture:
    def test_it_is_straight_where_that_is_free(self) -> None:
        found = planner(pole=(0.0, 1.0, 0.3)).to_posture(at(-1.0, 0.0), at(1.0, 0.0))
        assert len(found.points) == 2
        assert found.clearance.distance == pytest.approx(0.7, abs=1e-3)

    @pytest.mark.parametrize("seed", range(6))
    def test_it_goes_around_what_is_in_the_way(self, seed: int) -> None:
        made = planner(seed, pole=(0.0, 0.0, 0.4))
        found = made.to_posture(at(-1.0, 0.0), at(1.0, 0.05))
        assert np.array_equal(found.points[0], at(-1.0, 0.0))
        assert np.array_equal(found.end, at(1.0, 0.05))
        assert made.scene.along(found.points, 0.01).distance >= 0.045
        assert found.clearance.distance >= made.margin

    def test_equal_seeds_give_equal_paths(self) -> None:
        one, other = (planner(4, pole=(0.0, 0.0, 0.4)).to_posture(at(-1.0, 0.0), at(1.0, 0.0)) for _ in range(2))
        assert np.array_equal(np.array(one.points), np.array(other.points))

    def test_a_goal_in_an_obstacle_is_named(self) -> None:
        with pytest.raises(NoPath, match="not free: point would be -400 mm from pole"):
            planner(pole=(1.0, 0.0, 0.4)).to_posture(at(-1.0, 0.0), at(1.0, 0.0))

    def test_without_a_way_the_obstacles_are_named(self) -> None:
        ring = {f"post_{n}": (float(np.cos(n * 0.52)), float(np.sin(n * 0.52)), 0.25) for n in range(13)}
        with pytest.raises(NoPath, match=r"no way around point and post_\d+ was found with 60 postures, 50 mm off"):
            planner(0, nodes=60, **ring).to_posture(at(0.0, 0.0), at(1.8, 0.0))

    def test_a_motion_may_begin_closer_than_the_margin_and_not_go_closer(self) -> None:
        made = planner(wall=(0.0, -1.0, 0.98))
        found = made.to_posture(at(0.0, 0.0), at(0.0, 1.0))
        assert found.clearance.distance == pytest.approx(0.02, abs=1e-3)
        with pytest.raises(NoPath, match="not free"):
            made.to_posture(at(0.0, 0.0), at(0.0, -0.01))


class TestToAnyPosture:
    def test_the_first_that_is_straight_ahead_is_taken(self) -> None:
        made = planner(pole=(0.0, 0.0, 0.4))
        found = made.to_any(at(-1.0, 0.0), postures((1.0, 0.0), (-1.0, 1.0)))
        assert np.array_equal(found.end, at(-1.0, 1.0)), "the other one would need a detour"

    def test_without_a_straight_one_a_detour_is_taken(self) -> None:
        found = planner(pole=(0.0, 0.0, 0.4)).to_any(at(-1.0, 0.0), postures((1.0, 0.0)))
        assert len(found.points) > 2

    def test_without_a_posture_the_reason_is_named(self) -> None:
        with pytest.raises(NoPath, match="no posture is free: the pose is out of reach, or close to a singularity"):
            planner().to_any(at(0.0, 0.0), [])
        with pytest.raises(NoPath, match="no posture is free: point would be -400 mm from pole"):
            planner(pole=(1.0, 0.0, 0.4)).to_any(at(0.0, 0.0), postures((1.0, 0.0)))


class TestLine:
    def test_it_ends_where_it_is_to(self) -> None:
        found = planner().line(at(0.0, 0.0), shifted(0.5, 0.25))
        assert found.end == pytest.approx(at(0.5, 0.25))

    def test_what_is_in_the_way_is_named(self) -> None:
        with pytest.raises(NoPath, match="the straight approach is blocked: point would be -50 mm from pole"):
            planner(pole=(0.5, 0.0, 0.05)).line(at(0.0, 0.0), shifted(0.7), margin=0.01)

    def test_without_a_margin_it_only_says_how_close_it_comes(self) -> None:
        found = planner(pole=(0.5, 0.0, 0.05)).line(at(0.0, 0.0), shifted(0.7))
        assert found.clearance.distance < 0.0

    @pytest.mark.parametrize("goal", [shifted(2.5), shifted(0.1, 0.1, 0.1)])
    def test_out_of_reach(self, goal: pin.SE3) -> None:
        with pytest.raises(NoPath, match="leaves the arm's reach"):
            planner().line(at(1.9, 0.0), goal)

    def test_a_posture_that_is_far_from_the_one_before_is_a_singularity(self) -> None:
        with pytest.raises(NoPath, match="passes a singularity"):
            planner().line(at(-1.0, 0.0), shifted(1.0))

    def test_it_has_more_postures_where_joints_would_leave_it(self) -> None:
        class Bent(Point):
            def forward(self, positions: Array) -> pin.SE3:
                x, y = (float(each) for each in positions)
                return shifted(x, y + x * x)

            def solve_from(self, goal: pin.SE3, start: Array) -> Array | None:
                x, y, _ = (float(each) for each in goal.translation)
                return at(x, y - x * x)

        arm: Any = Bent()
        made = MotionPlanner(Disks(), arm, margin=0.05)
        found = made.line(at(-0.5, -0.25), shifted(0.5))
        assert len(found.points) > 4
        middles = [arm.forward((a + b) / 2.0).translation[1] for a, b in pairwise(found.points)]
        assert np.max(np.abs(middles)) < 0.0016
