"""How the UR10's joints follow their setpoints, as the simulation measures it."""

from __future__ import annotations

import math

import pytest
from tests.helpers.cells import open_cell

from jauspy.platform.joints import ControlMode, Target
from jauspy_sim.cell.probe import JointFigures

GOAL = (1.5, -0.6, 0.9, -1.0, -1.0, 1.0)
LIMITS = {"shoulder_pan": 120.0, "shoulder_lift": 120.0, "elbow": 180.0}
"""Degrees per second, from the UR10's data sheet; 180 for the wrists."""


def move() -> dict[str, JointFigures]:
    cell = open_cell()
    probe = cell.probe()
    cell.groups["ur10"].command([Target(ControlMode.POSITION, goal, speed=2.0, acceleration=6.0) for goal in GOAL])
    for _ in range(750):
        cell.advance(0.002)
    return probe.joints


@pytest.mark.slow
def test_joints_without_payload_arrive_within_a_milliradian_at_published_speeds() -> None:
    joints = move()
    assert len(joints) == 6
    assert all(joint.ends > 0 and joint.end_error < 0.001 for joint in joints.values())
    assert all(joint.speed <= math.radians(LIMITS.get(name, 180.0)) for name, joint in joints.items())


@pytest.mark.slow
def test_joints_that_are_not_fed_forward_are_found(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("jauspy_sim.cell.robot.dynamics_of", lambda *_: None)
    assert max(joint.end_error for joint in move().values()) > 0.001
