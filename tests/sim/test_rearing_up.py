"""inc1 at a wall: whether it climbs it, by statics and in the simulation, and that the tilt guard stops it."""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Iterator
from datetime import UTC, datetime

import pytest

pytest.importorskip("mujoco", reason="MuJoCo is not installed")

import mujoco
import numpy as np

from jauspy.geometry.poses import Pose
from jauspy.ids import JausID
from jauspy.messages.core import RequestControl, Resume
from jauspy.messages.mobility import SetWrenchEffort
from jauspy.platform.joints import ControlMode, Target
from jauspy.robot.kinds.mobility import vehicle_of
from jauspy.robot.robot_files import load, robot_model
from jauspy.services.core import AccessControl, Events, Management
from jauspy.services.host import Host
from jauspy.services.mobility import LocalPoseSensor, PrimitiveDriver
from jauspy_sim.assembly import build_in
from jauspy_sim.robot import SimulatedRobot

INC1 = dataclasses.replace(robot_model(load("inc1")), lidars=(), cameras=())
FLIPPERS_AHEAD, FLIPPERS_UP = -0.15, 2.2
WALL = 0.62
"""Metres from the base, just before the flippers."""
OPERATOR = JausID.parse("42.1.1")
HELD = 0.3
"""The effort."""


def at_wall(flippers: float, friction: float = 1.0) -> SimulatedRobot:
    """inc1 on level ground before a wall of 1.5 m, both with this friction or that of the belts, if it is less."""
    spec = mujoco.MjSpec()
    rough = (friction, 0.005, 0.0001)
    spec.worldbody.add_geom(type=mujoco.mjtGeom.mjGEOM_PLANE, size=(0, 0, 0.1), friction=rough)
    spec.worldbody.add_geom(
        type=mujoco.mjtGeom.mjGEOM_BOX, size=(0.1, 1.5, 0.75), pos=(WALL + 0.1, 0.0, 0.75), friction=rough, name="wall"
    )
    robot = SimulatedRobot(build_in(spec, INC1), INC1)
    robot.groups["flippers"].command([Target(ControlMode.POSITION, flippers)])
    robot.advance(2.0)
    return robot


def rises(robot: SimulatedRobot, effort: float, seconds: float = 6.0) -> float:
    """The greatest pitch, radians nose up, when it is driven gently against the wall, then with this effort."""
    robot.drive.set_effort(0.04, 0.0)
    robot.advance(3.0)
    highest = 0.0
    robot.drive.set_effort(effort, 0.0)
    for _ in range(round(seconds / 0.1)):
        robot.advance(0.1)
        highest = max(highest, -robot.drive.pose().pitch)
    return highest


def critical_friction(robot: SimulatedRobot, front: tuple[float, float]) -> float:
    """The coefficient from which on driven belts lift the robot, by statics.

    Ground and wall both slip: with the weight W, the load N of the rear, the push P on the wall and a friction mu,
    P = mu N and N + mu P = W, so P = W mu/(1 + mu^2). About the rear end of the tracks the front is lifted when
    P (h + mu l) > W c. `front`: l and h, of the point that touches the wall, from there.
    """
    base = robot.model.body("inc1/base_link").id
    length, height = front
    centre = float(robot.data.subtree_com[base][0] - robot.data.xpos[base][0]) + 0.35
    low, high = 0.3, 1.5
    for _ in range(40):
        mu = (low + high) / 2.0
        lifted = mu / (1.0 + mu**2) * (height + mu * length) > centre
        low, high = (low, mu) if lifted else (mu, high)
    return low


def flippers_ahead() -> tuple[float, float]:
    """From the rear end of the tracks: the foremost point of the flippers."""
    return 0.35 + 0.25 + 0.26 * math.cos(FLIPPERS_AHEAD) + 0.045, 0.102 + 0.26 * math.sin(FLIPPERS_AHEAD)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("above", "lifted"), [pytest.param(0.06, True, id="above"), pytest.param(-0.06, False, id="below")]
)
def test_rears_up_at_a_wall_from_the_friction_that_statics_gives(above: float, lifted: bool) -> None:
    robot = at_wall(FLIPPERS_AHEAD)
    critical = critical_friction(robot, flippers_ahead())
    assert 0.70 < critical < 0.76
    robot.close()
    robot = at_wall(FLIPPERS_AHEAD, critical + above)
    assert (rises(robot, HELD) > math.radians(30.0)) == lifted
    robot.close()


@pytest.mark.slow
def test_the_forces_at_the_wall_are_those_of_motors_and_friction() -> None:
    """While it rises: friction within its cone, belts within the motors' force, and the weight is carried."""
    robot = at_wall(FLIPPERS_AHEAD)
    model, data = robot.model, robot.data
    base = model.body("inc1/base_link").id
    robot.drive.set_effort(0.04, 0.0)
    robot.advance(3.0)
    robot.drive.set_effort(HELD, 0.0)
    motors = [model.actuator(f"inc1/base_link_to_{side}_track").id for side in ("left", "right")]
    wrench, lifts, heights = np.zeros(6), [], []
    while (pitch := -robot.drive.pose().pitch) < math.radians(40.0):
        robot.advance(0.002)
        assert robot.time < 20.0
        assert np.abs(data.actuator_force[motors]).max() <= 300.0
        total = np.zeros(3)
        for number, contact in enumerate(data.contact):
            roots = model.body_rootid[model.geom_bodyid[contact.geom]]
            if roots[0] == roots[1]:
                continue
            mujoco.mj_contactForce(model, data, number, wrench)
            assert np.hypot(*wrench[1:3]) <= contact.friction[0] * wrench[0] * 1.001 + 0.1
            assert contact.friction[0] <= 0.8
            total += contact.frame.reshape(3, 3).T @ wrench[:3] * (1.0 if roots[1] == base else -1.0)
        if pitch > math.radians(5.0):
            lifts.append(total)
            heights.append(float(data.subtree_com[base][2]))
    mean = np.mean(lifts, axis=0)
    weight = 9.81 * float(model.body_subtreemass[base])
    assert mean[2] == pytest.approx(weight, rel=0.05)
    assert abs(mean[0]) < 0.05 * weight
    assert heights[-1] > heights[0] + 0.08


@pytest.mark.slow
@pytest.mark.parametrize(
    ("effort", "flippers"),
    [pytest.param(0.11, FLIPPERS_AHEAD, id="motors too weak"), pytest.param(HELD, FLIPPERS_UP, id="flippers up")],
)
def test_does_not_rear_up_without_force_or_flippers(effort: float, flippers: float) -> None:
    """Statics: 236 N a belt are needed with flippers ahead, and a friction of 0.87 without them."""
    robot = at_wall(flippers)
    assert rises(robot, effort) < math.radians(5.0)
    robot.close()


class Operated:
    """The robot with its driver service, and an operator who is in control."""

    def __init__(self, robot: SimulatedRobot, *, guarded: bool) -> None:
        model = INC1 if guarded else dataclasses.replace(INC1, tilt_guard=None)
        vehicle = vehicle_of("inc1", None, model, robot)
        assert vehicle.drive is not robot.drive, "the attitude is what its sensors estimate"
        services = (PrimitiveDriver(vehicle), LocalPoseSensor(vehicle), AccessControl(), Management(), Events())
        self.robot = robot
        self.host = Host(JausID(101, 1, 102), services, utc_now=lambda: datetime.now(UTC), now=robot.time)
        for message in (RequestControl(200), Resume()):
            self.host.receive(message.encode(), OPERATOR, robot.time)

    def hold(self, effort: float, seconds: float) -> Iterator[Pose]:
        """Hold a joystick: the poses, ten times a second."""
        for _ in range(round(seconds / 0.1)):
            for message in (RequestControl(200), SetWrenchEffort(propulsive_linear_effort_x=100.0 * effort)):
                self.host.receive(message.encode(), OPERATOR, self.robot.time)
            for _ in range(10):
                self.robot.advance(0.01)
                self.host.handle_timeout(self.robot.time)
            self.host.poll_output(self.robot.time)
            yield self.robot.drive.pose()


def tilt(pose: Pose) -> float:
    """Angle of the robot's z axis to the vertical, degrees."""
    return math.degrees(math.acos(math.cos(pose.roll) * math.cos(pose.pitch)))


@pytest.mark.slow
def test_falls_over_without_the_tilt_guard() -> None:
    operated = Operated(at_wall(FLIPPERS_AHEAD), guarded=False)
    assert max(map(tilt, operated.hold(HELD, 8.0))) > 80.0


@pytest.mark.slow
@pytest.mark.parametrize("effort", [HELD, pytest.param(1.0, marks=pytest.mark.slow)])
def test_the_tilt_guard_stops_it_and_it_drives_back(effort: float) -> None:
    operated = Operated(at_wall(FLIPPERS_AHEAD), guarded=True)
    tilts = list(map(tilt, operated.hold(effort, 8.0)))
    assert 60.0 < max(tilts) < 72.0
    assert tilts[-1] == pytest.approx(tilts[-10], abs=0.5), "it stands, though the stick is held"
    assert operated.host.counters["tilt"] == 1
    list(operated.hold(0.0, 0.2))
    back = list(map(tilt, operated.hold(-0.2, 8.0)))
    assert max(back) < max(tilts) + 1.0
    assert back[-1] < 2.0
    assert operated.host.counters["tilt"] == 1
