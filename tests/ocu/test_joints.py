"""Names, order and limits of joints, and how long their motions take."""

from __future__ import annotations

import math

import pytest

from jauspy.messages.manipulator import SetJointPositions
from jauspy.ocu import joint_efforts, joint_positions, joint_velocities, metres
from jauspy.ocu.motion_limits import MotionLimits


def test_numbers_become_records():
    message = joint_positions(0.5, -0.2, metres(0.03))
    values = [
        (int(each.joint_position.choice), round(each.joint_position.value, 6)) for each in message.joint_position_list
    ]
    assert values == [(1, 0.5), (1, -0.2), (2, 0.03)]
    assert SetJointPositions.decode(message.encode()).encode() == message.encode()
    assert [each.joint_effort for each in joint_efforts(10, -20).joint_effort_list] == [10.0, -20.0]
    assert [each.joint_velocity.value for each in joint_velocities(0.1).joint_velocity_list] == [0.1]


def test_what_is_no_number_is_named():
    with pytest.raises(TypeError, match="joint 2 is a number, not the str 'up'"):
        joint_positions(0.0, "up")


async def test_arm_makes_the_message_from_names(robot, ocu):
    arm = (await ocu.robot(101)).arm
    message = await arm.joint_positions(arm_link_2_to_arm_link_3=-1.2)
    assert isinstance(message, SetJointPositions)
    assert len(message.joint_position_list) == 5
    assert message.joint_position_list[2].joint_position.value == pytest.approx(-1.2, abs=1e-5)


LIMITS = MotionLimits(1.0, 2.0, 4.0)


def test_a_long_way_is_at_full_speed_between_the_ramps() -> None:
    assert LIMITS.least_duration(-3.0) == pytest.approx(3.0 + 0.25 + 0.125)


def test_a_short_way_has_ramps_only() -> None:
    way = 0.1
    top = math.sqrt(way / 0.375)
    assert LIMITS.least_duration(way) == pytest.approx(top / 2.0 + top / 4.0)
    assert LIMITS.least_duration(0.0) == 0.0


@pytest.mark.parametrize("duration", [3.375, 4.0, 30.0])
def test_the_speed_for_a_duration_takes_it(duration: float) -> None:
    speed = LIMITS.speed_for(3.0, duration)
    assert speed is not None
    assert MotionLimits(speed, 2.0, 4.0).least_duration(3.0) == pytest.approx(duration)


def test_no_speed_is_fast_enough() -> None:
    assert LIMITS.speed_for(3.0, 3.3) is None
    assert LIMITS.speed_for(3.0, 0.0) is None


def test_without_limits_any_way_takes_any_time() -> None:
    assert MotionLimits().least_duration(5.0) == 0.0
    assert MotionLimits().speed_for(5.0, 2.0) == 2.5
