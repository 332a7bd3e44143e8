"""Lists with a value for each joint, as the messages carry them: radians or metres, newton metres or newtons."""

from __future__ import annotations

from collections.abc import Sequence

from jauspy.geometry.denavit_hartenberg import DHLink
from jauspy.messages.manipulator import (
    ActuatorForceTorqueRec,
    JointEffortRec,
    JointPositionRec,
    JointVelocityRec,
)

REVOLUTE, PRISMATIC = 1, 2
"""Which of the two kinds of value a field holds."""

Choices = Sequence[tuple[int, float]]


def values(choices: Choices, links: Sequence[DHLink]) -> list[float] | None:
    """The values, base to tip; None unless there is one of the right kind for each joint."""
    kinds = [REVOLUTE if link.is_revolute else PRISMATIC for link in links]
    return [value for _, value in choices] if [kind for kind, _ in choices] == kinds else None


def read_positions(records: Sequence[JointPositionRec]) -> Choices:
    """What SetJointPositions holds."""
    return [(record.joint_position.choice, record.joint_position.value) for record in records]


def read_velocities(records: Sequence[JointVelocityRec]) -> Choices:
    """What SetJointVelocity holds."""
    return [(record.joint_velocity.choice, record.joint_velocity.value) for record in records]


def read_efforts(records: Sequence[ActuatorForceTorqueRec]) -> Choices:
    """What SetActuatorForceTorques holds."""
    return [(record.joint_force_torque.choice, record.joint_force_torque.value) for record in records]


def positions(found: Sequence[float], links: Sequence[DHLink]) -> list[JointPositionRec]:
    """Radians or metres for each joint."""
    make, choice = JointPositionRec.JointPosition, JointPositionRec.JointPositionChoice
    return [
        JointPositionRec(joint_position=make(choice(REVOLUTE if link.is_revolute else PRISMATIC), value))
        for value, link in zip(found, links, strict=True)
    ]


def velocities(found: Sequence[float], links: Sequence[DHLink]) -> list[JointVelocityRec]:
    """rad/s or m/s for each joint."""
    make, choice = JointVelocityRec.JointVelocity, JointVelocityRec.JointVelocityChoice
    return [
        JointVelocityRec(joint_velocity=make(choice(REVOLUTE if link.is_revolute else PRISMATIC), value))
        for value, link in zip(found, links, strict=True)
    ]


def efforts(found: Sequence[float], links: Sequence[DHLink]) -> list[ActuatorForceTorqueRec]:
    """Newton metres or newtons for each joint."""
    make, choice = ActuatorForceTorqueRec.JointForceTorque, ActuatorForceTorqueRec.JointForceTorqueChoice
    return [
        ActuatorForceTorqueRec(joint_force_torque=make(choice(REVOLUTE if link.is_revolute else PRISMATIC), value))
        for value, link in zip(found, links, strict=True)
    ]


def percents(found: Sequence[float]) -> list[JointEffortRec]:
    """Percent of each joint's greatest effort."""
    return [JointEffortRec(joint_effort=value) for value in found]
