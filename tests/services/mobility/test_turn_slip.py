"""A robot with one track on an edge, which does not turn: no track is to stand still while the other one spins."""

from __future__ import annotations

from dataclasses import replace

import pytest

from jauspy.geometry.poses import Twist
from jauspy.messages.core import RequestControl, Resume
from jauspy.messages.mobility import SetVelocityCommand
from jauspy.platform.localization import UNMOVED, Localization, LocalizationState
from jauspy.services.core import AccessControl, Events, Management
from jauspy.services.mobility import LocalPoseSensor, Vehicle, VelocityStateDriver

A = "42.1.1"


class Slipping(Localization):
    """Tracks that turn to the left faster than the robot by `slip` rad/s."""

    def __init__(self, slip: float) -> None:
        self.found = replace(UNMOVED, twist=Twist(vx=0.3), turn_slip=slip)

    def state(self) -> LocalizationState:
        return self.found

    def declare(self, position_rms: float | None, heading_rms: float | None) -> None:
        """No test declares a pose."""


def turn_effort(make, drive, slip: float, *, speed: float = 0.3) -> float:
    """Effort to the left after 2 s in which the robot is to drive straight on, and does, by its speed and turn rate."""
    vehicle = Vehicle(drive, localization=Slipping(slip))
    rig = make(
        *(kind(vehicle) for kind in (LocalPoseSensor, VelocityStateDriver)),
        AccessControl(default_authority=1, timeout=5),
        Management(),
        Events(),
    )
    for message in (RequestControl(100), Resume()):
        rig.tell(A, message)
    drive.present_twist = Twist(vx=speed)
    for _ in range(20):
        rig.tell(A, SetVelocityCommand(0, velocity_x=speed, yaw_rate=0.0 if speed else 0.5))
        rig.run(0.1)
    return drive.effort[1]


def test_the_track_that_spins_gets_less_effort(make, drive):
    assert turn_effort(make, drive, 0.0) == pytest.approx(0.0, abs=0.01)
    assert turn_effort(make, drive, 0.8) < -0.1, "to the right: the right track spins"


def test_the_usual_slip_of_a_curve_changes_nothing(make, drive):
    assert turn_effort(make, drive, 0.15) == pytest.approx(0.0, abs=0.01)


def test_a_turn_on_the_spot_needs_slip(make, drive):
    slipping = turn_effort(make, drive, 0.8, speed=0.0)
    assert slipping == pytest.approx(turn_effort(make, drive, 0.0, speed=0.0), abs=0.02)
