"""The command that ends a stream: efforts and velocities of zero, vectors without speed."""

from __future__ import annotations

import pytest

from jauspy.messages import registry
from jauspy.messages.mobility import SetLocalVector, SetLocalVectorExt, SetTravelSpeed
from jauspy.messages.ugv import SetSkidSteerEffort
from jauspy.ocu.commands import neutral
from jauspy.services.command_timeout import CONTINUOUS_COMMANDS, Zero

Speed = SetLocalVectorExt.Speed


@pytest.mark.parametrize(
    ("command", "stop"),
    [
        (SetSkidSteerEffort(40.0, -40.0), SetSkidSteerEffort(0.0, 0.0)),
        (SetLocalVector(speed=0.5, heading=1.0), SetLocalVector(speed=0.0, heading=1.0)),
        (
            SetLocalVectorExt(speed=Speed(Speed.Choice.SPEED_OVER_GROUND, 0.5), heading=1.0),
            SetLocalVectorExt(speed=Speed(Speed.Choice.SPEED_OVER_GROUND, 0.0), heading=1.0),
        ),
        (SetTravelSpeed(0.5), SetTravelSpeed(0.0)),
        (registry.by_name("SetActuatorForceTorques")([]), None),
        (registry.by_name("SetLocalPose")(x=1.0), None),
    ],
)
def test_the_stop_of_a_command(command, stop):
    assert neutral(command) == stop


def test_every_continuous_command_is_a_message():
    for name, zero in CONTINUOUS_COMMANDS.items():
        fields = [slot.name for slot in registry.by_name(name).layout().slots]
        assert zero is not Zero.SPEED or "speed" in fields
