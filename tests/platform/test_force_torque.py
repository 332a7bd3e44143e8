"""Sensors of force and torque: when they measure, what they can measure, and what hangs on them."""

from __future__ import annotations

import math
from dataclasses import replace

import pytest

from jauspy.backends import find
from jauspy.geometry.frames import gravity_wrench
from jauspy.geometry.urdf import parse_urdf
from jauspy.geometry.vectors import Vector
from jauspy.platform.force_torque import ForceTorqueSetup, SampledForceTorque
from jauspy.platform.joints import ControlMode, Target
from jauspy.robot.robot_files import load, robot_model

SETUP = ForceTorqueSetup("wrist", "hand", rate=10.0, force=50.0, torque=5.0)

CRANE = parse_urdf(
    """<robot name="crane">
  <link name="base"><inertial><mass value="9"/></inertial></link>
  <link name="arm"><inertial><origin xyz="0.2 0 0"/><mass value="2"/></inertial></link>
  <link name="hook"><inertial><mass value="1"/></inertial></link>
  <joint name="lift" type="revolute">
    <parent link="base"/><child link="arm"/><axis xyz="0 -1 0"/><limit lower="-2" upper="2" effort="1" velocity="1"/>
  </joint>
  <joint name="end" type="fixed"><parent link="arm"/><child link="hook"/><origin xyz="0.5 0 0"/></joint>
</robot>"""
)


def test_measures_at_its_rate_and_keeps_the_measurement_between() -> None:
    readings = iter(range(100))
    sensor = SampledForceTorque(SETUP, lambda: ((float(next(readings)), 0.0, 0.0), (0.0, 0.0, 0.0)))
    seen = []
    for step in range(100):
        sensor.step(step * 0.01)
        seen.append((sensor.wrench.time, sensor.wrench.force[0]))
    assert sorted(set(seen)) == [(pytest.approx(n / 10), float(n)) for n in range(10)]


def test_measurements_are_clipped_to_the_limits() -> None:
    sensor = SampledForceTorque(SETUP, lambda: ((-900.0, 1.0, 51.0), (0.0, -6.0, 4.0)))
    sensor.step(0.0)
    assert sensor.wrench.force == (-50.0, 1.0, 50.0)
    assert sensor.wrench.torque == (0.0, -5.0, 4.0)


@pytest.mark.parametrize(
    ("angle", "force", "torque"),
    [
        (0.0, (0.0, 0.0, -3 * 9.81), (0.0, 0.9 * 9.81, 0.0)),
        (math.pi / 2, (-3 * 9.81, 0.0, 0.0), (0.0, 0.0, 0.0)),
        (
            math.pi / 6,
            (-1.5 * 9.81, 0.0, -3 * 9.81 * math.cos(math.pi / 6)),
            (0.0, 0.9 * 9.81 * math.cos(math.pi / 6), 0.0),
        ),
    ],
)
def test_computed_weight_matches_a_manual_calculation(angle: float, force: Vector, torque: Vector) -> None:
    found = gravity_wrench(CRANE, "arm", lambda: {"lift": angle})()
    assert found == (pytest.approx(force, abs=1e-9), pytest.approx(torque, abs=1e-9))


def test_weight_is_computed_only_when_joints_have_moved() -> None:
    positions = {"lift": 0.0}
    weigh = gravity_wrench(CRANE, "arm", lambda: positions)
    level = weigh()
    assert weigh() is level
    positions["lift"] = math.pi / 2
    assert weigh()[0] == pytest.approx((-3 * 9.81, 0.0, 0.0), abs=1e-9)
    positions["lift"] = 0.0
    assert weigh() == level


def test_simulated_and_computed_weight_agree() -> None:
    """Also with the wrist bent and rolled: the frames, signs and points of reference agree."""
    pytest.importorskip("mujoco", reason="MuJoCo is not installed")
    model = robot_model(load("inc1"))
    (wrist,) = model.force_torque
    model = replace(model, force_torque=(replace(wrist, noise=(0.0, 0.0)),))
    readings = []
    for backend in ("kinematic", "sim"):
        robot = find(backend).open(model, "empty")
        robot.groups["arm"].command([Target(ControlMode.POSITION, at) for at in (0.4, 1.2, -0.8, 0.5, 0.7)])
        robot.advance(5.0)
        readings.append(robot.force_torque["wrist"].wrench)
        robot.close()
    computed, simulated = readings
    assert min(abs(value) for value in computed.force) > 0.5, "every axis has a share"
    assert simulated.force == pytest.approx(computed.force, abs=0.05)
    assert simulated.torque == pytest.approx(computed.torque, abs=0.005)
