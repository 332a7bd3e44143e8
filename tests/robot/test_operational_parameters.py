"""ExtendedPrimitiveManipulator and ExtendedPrimitivePanTilt: motors' data of joints, for each presence vector."""

from __future__ import annotations

import math

import pytest
from tests.robot.workcell import BACKENDS, Workcell

from jauspy.ids import JausID
from jauspy.messages.iop import (
    QueryHostManipulator,
    QueryJointOperationalParameters,
    QueryPanTiltHostManipulator,
    QueryPanTiltOperationalParameters,
)
from jauspy.platform.joints import ControlMode, Target
from jauspy.platform.motors import MotorReading
from jauspy.services.iop import ExtendedPrimitiveManipulator, ExtendedPrimitivePanTilt

NAMES = ("joint_temperature", "bus_voltage", "bus_current", "phase_current")
PAN_TILT = tuple(f"joint{joint}_{name}" for joint in (1, 2) for name in ("temperature", *NAMES[1:]))
FULL = MotorReading(40.0, 30.0, 2.0, 5.0)


@pytest.fixture(params=BACKENDS)
def arm(request):
    made = Workcell(request.param, "inc1", 104)
    yield made
    made.robot.close()


@pytest.fixture
def camera():
    made = Workcell("kinematic", "inc1", 107)
    yield made
    made.robot.close()


@pytest.mark.slow
def test_a_stretched_arm_takes_current(arm):
    arm.take_control()
    arm.robot.groups["arm"].command([Target(ControlMode.POSITION, value) for value in (0.0, 0.5, -0.4, 0.0, 0.0)])
    arm.run(9.0)
    joints = arm.ask(QueryJointOperationalParameters(0xFF)).joint_operational_parameters_list
    assert [joint.joint_number for joint in joints] == [1, 2, 3, 4, 5]
    shoulder = joints[1]
    assert shoulder.phase_current > 0.3 > joints[0].phase_current
    if arm.backend == "can":
        assert {round(joint.joint_temperature, 1) for joint in joints} == {35.3}, "as the drives report it"
        assert shoulder.bus_voltage == pytest.approx(48.0, abs=0.01)
        assert shoulder.bus_current is None, "drives do not tell it"
    else:
        assert {joint.joint_temperature for joint in joints} == {None}, "nothing measures it in a simulation"
        assert shoulder.bus_voltage == pytest.approx(33.5, abs=0.3)
        assert 0.0 < shoulder.bus_current < shoulder.phase_current


def test_every_presence_vector_gets_what_it_asks_for(arm):
    service = arm.host.service(ExtendedPrimitiveManipulator)
    service._readings = lambda: dict.fromkeys(service._joints, FULL)
    for wanted in range(256):
        for joint in arm.ask(QueryJointOperationalParameters(wanted)).joint_operational_parameters_list:
            present = [getattr(joint, name) is not None for name in NAMES]
            assert present == [bool(wanted >> bit & 1) for bit in range(4)]


def test_every_presence_vector_of_a_pan_tilt_unit(camera):
    service = camera.host.service(ExtendedPrimitivePanTilt)
    for readings, has in (({}, 0), ({"base_link_to_pan_link": FULL}, 0x0F), ({"pan_link_to_tilt_link": FULL}, 0xF0)):
        service._readings = lambda readings=readings: readings
        for wanted in range(256):
            report = camera.ask(QueryPanTiltOperationalParameters(wanted))
            present = [getattr(report, name) is not None for name in PAN_TILT]
            assert present == [bool((wanted & has) >> bit & 1) for bit in range(8)]


def test_values_beyond_the_fields_are_their_limits_and_nan_is_absent(camera):
    service = camera.host.service(ExtendedPrimitivePanTilt)
    wild = {
        "base_link_to_pan_link": MotorReading(1e9, math.inf, 1e308, math.nan),
        "pan_link_to_tilt_link": MotorReading(-1e9, -5.0, -math.inf, 3.0),
    }
    service._readings = lambda: wild
    report = camera.ask(QueryPanTiltOperationalParameters(0xFF))
    values = [getattr(report, name) for name in PAN_TILT]
    assert values[:3] == pytest.approx([150.0, 150.0, 200.0], abs=0.01)
    assert values[3] is None
    assert values[4:7] == pytest.approx([-50.0, 0.0, 0.0], abs=0.01)


def test_an_arm_on_the_chassis_has_no_host_and_one_on_another_has(arm, camera):
    report = arm.ask(QueryHostManipulator())
    assert (report.parent_id.subsystem_id, report.parent_joint) == (0, 0)
    assert camera.ask(QueryPanTiltHostManipulator()).parent_joint == 0
    service = arm.host.service(ExtendedPrimitiveManipulator)
    service._mount = JausID(101, 1, 103), 2
    report = arm.ask(QueryHostManipulator())
    assert (report.parent_id.subsystem_id, report.parent_id.node_id, report.parent_id.component_id) == (101, 1, 103)
    assert report.parent_joint == 2
