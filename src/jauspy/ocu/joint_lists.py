"""Commands with a list of joints, from plain numbers: `joint_positions(0.0, 0.6, metres(0.03))`.

Positions are as the component counts them (AS6057); `Robot.arm.joint_positions(elbow=0.6)` takes names and positions of
the robot's description.
"""

from __future__ import annotations

from jauspy.arguments import check_number
from jauspy.messages.manipulator import (
    JointEffortRec,
    JointPositionRec,
    JointVelocityRec,
    SetJointEffort,
    SetJointPositions,
    SetJointVelocity,
)


class metres(float):  # noqa: N801 - it is used as a function
    """A number of metres, or m/s, for a joint that slides; plain numbers are radians, or rad/s."""

    __slots__ = ()


def joint_positions(*positions: float) -> SetJointPositions:
    """One position for each joint, base to tip: radians, or `metres(...)`."""
    make, kinds = JointPositionRec.JointPosition, JointPositionRec.JointPositionChoice
    return SetJointPositions([JointPositionRec(make(kinds(_kind(each)), float(each))) for each in _checked(positions)])


def joint_velocities(*velocities: float) -> SetJointVelocity:
    """One velocity for each joint, base to tip: rad/s, or `metres(...)` per second."""
    make, kinds = JointVelocityRec.JointVelocity, JointVelocityRec.JointVelocityChoice
    return SetJointVelocity([JointVelocityRec(make(kinds(_kind(each)), float(each))) for each in _checked(velocities)])


def joint_efforts(*percent: float) -> SetJointEffort:
    """One effort for each joint, base to tip, in percent."""
    return SetJointEffort([JointEffortRec(float(each)) for each in _checked(percent)])


def _checked(values: tuple[float, ...]) -> tuple[float, ...]:
    for number, each in enumerate(values, 1):
        check_number(each, f"joint {number}")
    return values


def _kind(value: float) -> int:
    return 2 if isinstance(value, metres) else 1
