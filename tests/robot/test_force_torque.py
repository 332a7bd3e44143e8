"""ForceTorqueSensor of a CM-SEN, as a client sees it."""

from __future__ import annotations

from dataclasses import replace
from datetime import UTC, datetime
from typing import Any

import pytest
from tests.helpers.robot import described

from jauspy.backends import find
from jauspy.ids import JausID
from jauspy.messages.environment_sensing.v2_0 import force_torque_sensor as m
from jauspy.platform.joints import ControlMode, Target
from jauspy.robot.hosts import host_of

CLIENT = JausID(42, 1, 1)
NATIVE, VEHICLE = m.QueryForceTorque.CoordinateSystem
ALL = 0b111111
ASK = m.QueryForceTorque.QueryForceTorqueRec
ASK_LIMITS = m.QueryForceTorqueCapabilities.QueryForceTorqueCapabilitiesRec
STEP = 10000.0 / 65535.0
"""Of a value on the wire, N or N m."""

HAND = (0.45 + 2 * 0.12 + 0.02) * 9.81
"""What the gripper of inc1 weighs, N."""


class Wrist:
    """A kinematic inc1, whose sensor is exact, and its sensor module."""

    def __init__(self, sensors: int = 1) -> None:
        config, model = described("inc1")
        (wrist,) = model.force_torque
        model = replace(model, force_torque=tuple(replace(wrist, name=f"wrist{n}") for n in range(1, sensors + 1)))
        self.robot = find("kinematic").open(model, "empty")
        (module,) = (each for each in config.modules if each.type == "CM-SEN")
        self.host = host_of(
            config, module, model, self.robot, {}, utc_now=lambda: datetime(2026, 1, 1, tzinfo=UTC), now=0.0
        )

    def point(self, *positions: float) -> None:
        self.robot.groups["arm"].command([Target(ControlMode.POSITION, value) for value in positions])
        self.robot.advance(10.0)

    def _tell(self, query: Any, answer: Any) -> Any:
        self.host.receive(query.encode(), CLIENT, 0.0)
        (payload,) = (each.payload for each in self.host.poll_output(0.0))
        return answer.decode(payload)

    def ask(self, *records: Any) -> list[Any]:
        found = self._tell(m.QueryForceTorque(list(records)), m.ReportForceTorque)
        return list(found.report_force_torque_list)

    def limits(self, *records: Any) -> list[Any]:
        found = self._tell(m.QueryForceTorqueCapabilities(list(records)), m.ReportForceTorqueCapabilities)
        return list(found.report_force_torque_capabilities_list)


def force(found: Any) -> tuple[float, float, float]:
    return found.force_x, found.force_y, found.force_z


def torque(found: Any) -> tuple[float, float, float]:
    return found.torque_x, found.torque_y, found.torque_z


def test_level_gripper_gives_weight_down_and_pitch_torque() -> None:
    wrist = Wrist()
    wrist.point(0.0, 0.0, 0.0, 0.0, 0.0)
    (found,) = wrist.ask(ASK(1, NATIVE, ALL))
    assert found.coordinate_system == NATIVE
    assert force(found) == pytest.approx((0.0, 0.0, HAND), abs=STEP), "JAUS's z is down"
    middle = (0.45 * 0.03 + 0.24 * 0.1 + 0.02 * 0.12) * 9.81
    assert torque(found) == pytest.approx((0.0, -middle, 0.0), abs=STEP), "about y, which is right"


def test_vehicle_axes_do_not_rotate_with_the_gripper() -> None:
    wrist = Wrist()
    wrist.point(0.3, 1.2, -0.5, 0.4, 1.0)
    (native,) = wrist.ask(ASK(1, NATIVE, ALL))
    (vehicle,) = wrist.ask(ASK(1, VEHICLE, ALL))
    assert vehicle.coordinate_system == VEHICLE
    assert force(vehicle) == pytest.approx((0.0, 0.0, HAND), abs=STEP)
    assert force(native) != pytest.approx(force(vehicle), abs=1.0)
    assert sum(value**2 for value in force(native)) ** 0.5 == pytest.approx(HAND, abs=2 * STEP)


def test_rolled_gripper_gives_lateral_force() -> None:
    wrist = Wrist()
    wrist.point(0.0, 0.0, 0.0, 0.0, 1.0)  # about x forward: clockwise as the robot sees it
    (found,) = wrist.ask(ASK(1, NATIVE, ALL))
    assert found.force_y > 1.0, "JAUS's y is right, where the lower side is"


def test_only_requested_fields_are_reported() -> None:
    (found,) = Wrist().ask(ASK(1, NATIVE, 0b000100))
    assert (found.force_x, found.force_y, found.torque_x, found.torque_z) == (None, None, None, None)
    assert found.force_z is not None


def test_each_sensor_is_reported_once_and_unknown_ones_are_omitted() -> None:
    wrist = Wrist(sensors=2)
    assert [each.sensor_id for each in wrist.ask(ASK(0, NATIVE, ALL))] == [1, 2]
    assert [each.sensor_id for each in wrist.ask(ASK(2, NATIVE, ALL), *[ASK(9, NATIVE, ALL)] * 500)] == [2]
    assert wrist.ask(ASK(7, NATIVE, ALL)) == []


def test_limits_are_those_of_the_description() -> None:
    wrist = Wrist(sensors=2)
    first, second = wrist.limits(ASK_LIMITS(0, 0x1FFF))
    assert (first.sensor_name, second.sensor_name) == ("wrist1", "wrist2")
    assert first.coordinate_transform_supported == 1
    for axis in "xyz":
        found = (getattr(first, f"{bound}_{what}_{axis}") for what in ("force", "torque") for bound in ("min", "max"))
        assert list(found) == pytest.approx([-300.0, 300.0, -30.0, 30.0], abs=STEP)
    (bare,) = wrist.limits(ASK_LIMITS(2, 0))
    assert (bare.sensor_id, bare.max_force_x, bare.coordinate_transform_supported) == (2, None, None)
