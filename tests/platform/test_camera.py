"""Where outside cameras are, and how they follow a robot."""

from __future__ import annotations

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
