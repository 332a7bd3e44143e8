"""Where outside cameras are, and how they follow a robot."""

from __future__ import annotations

import itertools
import math

import pytest

from jauspy.geometry.poses import Pose, Transform
from jauspy.platform.camera import OutsideSetup, OutsideView, Viewpoint, looking


def base(x=0.0, y=0.0, yaw=0.0):
    return Transform.from_pose(Pose(x, y, 0.0, 0.0, 0.0, yaw))


def test_a_chasing_camera_comes_around_when_the_robot_turns():
    view = OutsideView(OutsideSetup(Viewpoint.CHASE, distance=2.0, height=1.0))
    position, target = view.ends(10.0, base(1.0))
    assert position == pytest.approx((-1.0, 0.0, 1.0))
    assert target == pytest.approx((1.0, 0.0, 0.35))
    soon, _ = view.ends(10.1, base(1.0, yaw=math.pi / 2))
    assert soon[0] < -0.9
    later = [view.ends(10.1 + 0.05 * step, base(1.0, yaw=math.pi / 2))[0] for step in range(200)]
    assert later[-1] == pytest.approx((1.0, -2.0, 1.0), abs=0.01)


@pytest.mark.parametrize("rate", [10.0, 50.0])
def test_a_camera_starts_and_stops_softly_and_keeps_the_robot_in_view(rate):
    """At full speed, with a stop at once: no jump of the camera, and the robot within 15 degrees of the middle."""
    speed, view = 1.9, OutsideView(OutsideSetup(Viewpoint.CHASE, distance=2.2, height=1.3, angle=math.pi / 2.0))
    xs, times = [], [number / rate for number in range(int(6.0 * rate))]
    for time in times:
        x = speed * min(time, 3.0)
        position, target = view.ends(100.0 + time, base(x))
        xs.append(position[0])
        to_robot = looking(position, target).inverse().apply((x, 0.0, 0.35))
        assert math.atan2(math.hypot(to_robot[1], to_robot[2]), to_robot[0]) < math.radians(15.0)
    speeds = [(after - before) * rate for before, after in itertools.pairwise(xs)]
    assert speeds[0] < 0.35 * speed, "it is not locked to the robot"
    half = int(3.0 * rate)
    assert speeds[half - 2] == pytest.approx(speed, rel=0.01)
    assert speeds[half] > 0.5 * speed, "nor does it stop with it"
    assert speeds[-1] == pytest.approx(0.0, abs=0.01)
    assert max(speeds) < 1.01 * speed
    assert xs[-1] == pytest.approx(speed * 3.0, abs=0.02)


def test_bumps_do_not_shake_a_chasing_camera():
    view = OutsideView(OutsideSetup(Viewpoint.CHASE))
    heights = []
    for number in range(100):
        bumped = Transform.from_pose(Pose(0.0, 0.0, 0.05 * (number % 2), 0.0, 0.0, 0.0))
        heights.append(view.ends(0.05 * number, bumped)[0][2])
    assert max(heights[50:]) - min(heights[50:]) < 0.012


def test_an_orbit_takes_its_period():
    view = OutsideView(OutsideSetup(Viewpoint.ORBIT, distance=3.0, period=8.0))
    first, _ = view.ends(5.0, base())
    quarter, _ = view.ends(7.0, base())
    whole, _ = view.ends(13.0, base())
    assert first == pytest.approx((-3.0, 0.0, 1.5))
    assert quarter == pytest.approx((0.0, -3.0, 1.5))
    assert whole == pytest.approx(first)


def test_a_fixed_camera_follows_with_its_eye_or_looks_at_a_point():
    position, target = OutsideView(OutsideSetup(Viewpoint.FIXED, (1.0, 2.0, 3.0))).ends(0.0, base(4.0))
    assert (position, target) == ((1.0, 2.0, 3.0), pytest.approx((4.0, 0.0, 0.35)))
    still = OutsideView(OutsideSetup(Viewpoint.FIXED, (1.0, 2.0, 3.0), (0.0, 0.0, 0.0)))
    assert still.ends(0.0, base(4.0))[1] == (0.0, 0.0, 0.0)


@pytest.mark.parametrize("target", [(2.0, 1.0, 0.0), (0.0, 0.0, 5.0), (-1.0, 0.0, 1.0)])
def test_the_frame_looks_at_its_target_with_z_up(target):
    frame = looking((0.0, 0.0, 1.0), target)
    x, y, z = frame.inverse().apply(target)
    assert (y, z) == pytest.approx((0.0, 0.0), abs=1e-9)
    assert x > 0.0
    assert frame.rotation[2][1] == pytest.approx(0.0)
    assert frame.rotation[2][2] >= -1e-9
