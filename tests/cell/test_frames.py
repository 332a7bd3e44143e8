"""Frames: what is converted comes back, distances and means are those of geometry."""

from __future__ import annotations

import math

import numpy as np
import pinocchio as pin
import pytest
from hypothesis import given, strategies as st

from jauspy.cell.frames import averaged, offset_between, se3, se3_of_pose, shifted, tilt_between, transform, turned
from jauspy.geometry.poses import Pose

LENGTHS = st.floats(-5.0, 5.0)
ANGLES = st.floats(-3.0, 3.0)
VECTORS = st.tuples(LENGTHS, LENGTHS, LENGTHS)
SMALL = st.tuples(*[st.floats(-0.05, 0.05)] * 3)
FRAMES = st.builds(
    lambda place, turn: pin.SE3(pin.exp3(np.array(turn)), np.array(place)), VECTORS, st.tuples(ANGLES, ANGLES, ANGLES)
)


def same(a: pin.SE3, b: pin.SE3, tolerance: float = 1e-9) -> bool:
    return bool(np.max(np.abs(a.homogeneous - b.homogeneous)) < tolerance)


@given(FRAMES)
def test_a_frame_that_is_converted_comes_back(frame: pin.SE3) -> None:
    assert same(se3(transform(frame)), frame)


@given(VECTORS, st.floats(-3.0, 3.0))
def test_a_pose_that_only_turns_about_z_is_a_shift_and_a_turn(place: tuple[float, float, float], yaw: float) -> None:
    pose = Pose(*place, 0.0, 0.0, yaw)
    assert same(se3_of_pose(pose), shifted(*place) * turned("z", yaw))


@given(FRAMES, FRAMES)
def test_the_offset_of_two_frames_has_no_direction(a: pin.SE3, b: pin.SE3) -> None:
    there, back = offset_between(a, b), offset_between(b, a)
    assert there[0] == pytest.approx(back[0], abs=1e-9)
    assert there[1] == pytest.approx(back[1], abs=1e-6)
    assert 0.0 <= there[1] <= math.pi + 1e-9


@given(FRAMES, FRAMES, FRAMES)
def test_offset_and_tilt_are_the_same_from_wherever_one_looks(a: pin.SE3, b: pin.SE3, seen_from: pin.SE3) -> None:
    before, after = offset_between(a, b), offset_between(seen_from * a, seen_from * b)
    assert after[0] == pytest.approx(before[0], abs=1e-8)
    assert after[1] == pytest.approx(before[1], abs=1e-5)
    assert tilt_between(seen_from * a, seen_from * b) == pytest.approx(tilt_between(a, b), abs=1e-6)


@given(FRAMES, st.floats(-3.0, 3.0), st.floats(0.0, 3.0))
def test_a_turn_about_z_is_no_tilt_and_one_about_x_is_all_tilt(frame: pin.SE3, yaw: float, lean: float) -> None:
    assert tilt_between(frame, frame * turned("z", yaw)) == pytest.approx(0.0, abs=1e-6)
    assert tilt_between(frame, frame * turned("x", lean)) == pytest.approx(lean, abs=1e-6)


@given(FRAMES, st.lists(SMALL, min_size=1, max_size=6))
def test_the_mean_of_shifts_is_the_shift_by_the_mean(frame: pin.SE3, shifts: list[tuple[float, float, float]]) -> None:
    mean = averaged([frame * shifted(*each) for each in shifts])
    expected = frame * shifted(*np.mean(shifts, axis=0).tolist())
    assert same(mean, expected, 1e-8)


@given(FRAMES, st.lists(st.floats(-0.2, 0.2), min_size=1, max_size=6))
def test_the_mean_of_turns_about_one_axis_is_the_turn_by_the_mean(frame: pin.SE3, angles: list[float]) -> None:
    mean = averaged([frame * turned("y", angle) for angle in angles])
    assert same(mean, frame * turned("y", float(np.mean(angles))), 1e-8)


def test_the_mean_does_not_depend_on_which_frame_comes_first() -> None:
    frames = [turned("z", 0.03), turned("x", 0.02) * shifted(0.01), turned("y", -0.01)]
    assert max(offset_between(averaged(frames), averaged(frames[::-1]))) < 1e-5
