"""inc1 with 8 kg in its gripper on a side slope and on stairs: it tips without StabilityControl, and not with it.

What happened is read from MuJoCo: attitude and heights of the base.
"""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Sequence
from datetime import UTC, datetime

import pytest

pytest.importorskip("mujoco", reason="MuJoCo is not installed")

import mujoco
import numpy as np

from jauspy.ids import JausID
from jauspy.joint_values import position_records
from jauspy.messages.core import RequestControl, Resume
from jauspy.messages.iop import SetStabilityControlStatus
from jauspy.messages.manipulator import SetJointPositions
from jauspy.messages.mobility import SetWrenchEffort
from jauspy.platform.joints import ControlMode, Target
from jauspy.platform.stability import StabilityModel, stability_of
from jauspy.robot.config import AccessControlConfig
from jauspy.robot.hosts import host_of
from jauspy.robot.kinds import Shared
from jauspy.robot.robot_files import load, robot_model
from jauspy.services.host import Host
from jauspy.services.manipulator import PrimitiveManipulator
from jauspy_sim.assembly import build_in
from jauspy_sim.robot import SimulatedRobot

CONFIG = load("inc1")
INC1 = dataclasses.replace(robot_model(CONFIG), lidars=(), cameras=())
OPERATOR = JausID.parse("42.1.1")
PAYLOAD = 8.0
SIDE_SLOPE = math.radians(32.0)
STAIRS = math.atan2(0.18, 0.28)
"""Slope of the stairs of the world `yard`."""


def put(robot: SimulatedRobot, position: Sequence[float], forward: Sequence[float], up: Sequence[float]) -> None:
    """Put the robot down, with 8 kg in its gripper."""
    rotation, quaternion = np.column_stack([forward, np.cross(up, forward), up]), np.zeros(4)
    mujoco.mju_mat2Quat(quaternion, rotation.flatten())
    place = int(robot.model.joint("inc1/base").qposadr[0])
    robot.data.qpos[place : place + 7] = (*position, *quaternion)
    robot.data.qvel[:] = 0.0
    robot.model.body_mass[robot.model.body("inc1/gripper_link").id] += PAYLOAD
    mujoco.mj_setConst(robot.model, mujoco.MjData(robot.model))
    mujoco.mj_forward(robot.model, robot.data)
    robot.advance(1.0)


def on_side_slope() -> SimulatedRobot:
    """Across a slope of concrete: the left side is down."""
    spec = mujoco.MjSpec()
    normal = np.array([math.sin(SIDE_SLOPE), 0.0, math.cos(SIDE_SLOPE)])  # it falls towards x
    quaternion = np.zeros(4)
    mujoco.mju_quatZ2Vec(quaternion, normal)
    spec.worldbody.add_geom(
        type=mujoco.mjtGeom.mjGEOM_PLANE, size=(0, 0, 0.1), quat=quaternion, friction=(1.0, 0.005, 0.0001)
    )
    robot = SimulatedRobot(build_in(spec, INC1), INC1)
    put(robot, normal * 0.01, (0.0, -1.0, 0.0), normal)
    return robot


def on_stairs() -> SimulatedRobot:
    """Nose up on the stairs of the world `yard`, on two edges."""
    robot = SimulatedRobot.open(INC1, "yard")
    forward, up = (-math.cos(STAIRS), 0.0, math.sin(STAIRS)), (math.sin(STAIRS), 0.0, math.cos(STAIRS))
    put(robot, np.array([-1.02, -3.2, 0.45]) + 0.01 * np.array(up), forward, up)
    return robot


def tilt_from(robot: SimulatedRobot, start: np.ndarray) -> float:
    """Degrees by which the z axis of the base has turned since it was `start`, in MuJoCo."""
    now = axis(robot)
    return math.degrees(math.acos(float(np.clip(np.dot(now, start), -1.0, 1.0))))


def axis(robot: SimulatedRobot) -> np.ndarray:
    return robot.data.body("inc1/base_link").xmat.reshape(3, 3)[:, 2].copy()


class Operated:
    """The modules that move the robot, and an operator in control of them."""

    def __init__(self, robot: SimulatedRobot) -> None:
        self.robot = robot
        self.shared = Shared(stability=stability_of(INC1, robot))
        self.arm, self.drive = self._host(104), self._host(102)
        self.start = axis(robot)

    def _host(self, component: int) -> Host:
        (module,) = (module for module in CONFIG.modules if module.component == component)
        module = module.model_copy(update={"access_control": AccessControlConfig(timeout=0)})
        clock = lambda: datetime.now(UTC)  # noqa: E731
        host = host_of(CONFIG, module, INC1, self.robot, {}, utc_now=clock, now=self.robot.time, shared=self.shared)
        for message in (RequestControl(200), Resume()):
            host.receive(message.encode(), OPERATOR, self.robot.time)
        return host

    def switch(self, *, pitchover: bool, rollover: bool) -> None:
        """Switch the aids by JAUS."""
        kind = SetStabilityControlStatus.StabilityControlStatus
        bits = dict.fromkeys((field.name for field in dataclasses.fields(kind)), 0)
        bits |= {"active_pitchover_control": int(pitchover), "active_rollover_control": int(rollover)}
        self.tell(self.drive, SetStabilityControlStatus(kind(**bits)))

    def tell(self, host: Host, *messages: object) -> None:
        for message in messages:
            host.receive(message.encode(), OPERATOR, self.robot.time)
        host.poll_output(self.robot.time)

    def move_arm(self, *positions: float) -> None:
        """Positions as in the URDF."""
        geometry = self.arm.service(PrimitiveManipulator).arm.geometry
        records = position_records(geometry.from_urdf(positions), geometry.links)
        self.tell(self.arm, SetJointPositions(records))

    def run(self, seconds: float) -> float:
        """Degrees by which the base has turned at most."""
        most = 0.0
        for _ in range(round(seconds / 0.02)):
            self.robot.advance(0.02)
            for host in (self.arm, self.drive):
                host.handle_timeout(self.robot.time)
                host.poll_output(self.robot.time)
            most = max(most, tilt_from(self.robot, self.start))
        return most


DOWNHILL = ((1.57, 2.0, -1.9, -0.1, 0.0), (1.57, 0.7, -0.2, 0.0, 0.0))
BACKWARD = ((2.9, 2.5, -2.3, 0.0, 0.0), (2.9, 0.8, -0.3, 0.0, 0.0))


def reach(operated: Operated, poses: Sequence[Sequence[float]]) -> float:
    """Move the arm through these poses; returns the degrees by which the base has turned at most."""
    return max(operated.run(5.0) for pose in poses if operated.move_arm(*pose) is None)


@pytest.mark.slow
def test_a_reach_downhill_tips_it_over_without_stability_control() -> None:
    operated = Operated(on_side_slope())
    operated.switch(pitchover=False, rollover=False)
    assert reach(operated, DOWNHILL) > 45.0


@pytest.mark.slow
def test_a_reach_downhill_stops_before_it_tips() -> None:
    operated = Operated(on_side_slope())
    assert reach(operated, DOWNHILL) < 2.0
    assert operated.arm.counters["stability"] >= 1
    assert operated.shared.stability.payload().mass == pytest.approx(PAYLOAD, abs=0.5)
    assert operated.shared.stability.margin().angle < math.radians(12.0), "it went as far as it may"
    assert operated.shared.stability.margin().edge == "left"
    operated.move_arm(*DOWNHILL[0])
    operated.run(6.0)
    assert operated.robot.groups["arm"].state().positions[1] == pytest.approx(2.0, abs=0.05), "back is free"


@pytest.mark.slow
def test_repeated_commands_do_not_creep_over_the_limit() -> None:
    """A joystick sends a command each 50 ms, whatever happens."""
    operated = Operated(on_side_slope())
    operated.move_arm(*DOWNHILL[0])
    most = operated.run(5.0)
    for _ in range(200):
        operated.move_arm(*DOWNHILL[1])
        most = max(most, operated.run(0.06))
    assert most < 2.0


@pytest.mark.slow
def test_only_the_aid_for_the_side_matters_on_a_side_slope() -> None:
    operated = Operated(on_side_slope())
    operated.switch(pitchover=True, rollover=False)
    assert reach(operated, DOWNHILL) > 45.0


@pytest.mark.slow
@pytest.mark.parametrize("blind", ["slope", "payload", "arm"])
def test_a_guard_that_does_not_know_all_tips_it_over(monkeypatch: pytest.MonkeyPatch, blind: str) -> None:
    """Mutants of the guard: without the attitude, without the payload, and without the pose of the arm."""
    operated = Operated(on_side_slope())
    stability = operated.shared.stability
    if blind == "slope":
        monkeypatch.setattr(stability, "_down", lambda: (0.0, 0.0, -1.0))
    elif blind == "payload":
        monkeypatch.setattr(stability, "_scale", None)
    else:
        frames = StabilityModel.frames
        monkeypatch.setattr(StabilityModel, "frames", lambda self, _: frames(self, {}))
    assert reach(operated, DOWNHILL) > 45.0


@pytest.mark.slow
def test_a_reach_backward_on_stairs_rocks_it_off_the_edge_without_stability_control() -> None:
    operated = Operated(on_stairs())
    operated.switch(pitchover=False, rollover=False)
    assert reach(operated, BACKWARD) > 12.0


@pytest.mark.slow
def test_a_reach_backward_on_stairs_stops_before_it_rocks() -> None:
    operated = Operated(on_stairs())
    assert reach(operated, BACKWARD) < 3.0
    assert operated.arm.counters["stability"] >= 1
    assert operated.robot.groups["arm"].state().positions[1] > 1.0


def before_ramp() -> SimulatedRobot:
    """On level ground before a ramp of 37 degrees, the arm folded."""
    spec = mujoco.MjSpec()
    rough = (1.0, 0.005, 0.0001)
    spec.worldbody.add_geom(type=mujoco.mjtGeom.mjGEOM_PLANE, size=(0, 0, 0.1), friction=rough)
    slope = math.radians(37.0)
    spec.worldbody.add_geom(
        type=mujoco.mjtGeom.mjGEOM_BOX,
        size=(1.5, 1.0, 0.05),
        pos=(0.75 + 1.5 * math.cos(slope), 0.0, 1.5 * math.sin(slope) - 0.05),
        quat=(math.cos(slope / 2.0), 0.0, -math.sin(slope / 2.0), 0.0),
        friction=rough,
    )
    robot = SimulatedRobot(build_in(spec, INC1), INC1)
    put(robot, (0.0, 0.0, 0.01), (1.0, 0.0, 0.0), (0.0, 0.0, 1.0))
    robot.groups["flippers"].command([Target(ControlMode.POSITION, 0.4)])
    robot.advance(2.0)
    return robot


def hold_stick(operated: Operated, effort: float, seconds: float) -> float:
    """Hold the joystick, percent forward; returns the metres that the base has gone, in MuJoCo."""
    begun = operated.robot.data.body("inc1/base_link").xpos.copy()
    for _ in range(round(seconds / 0.1)):
        operated.tell(operated.drive, SetWrenchEffort(propulsive_linear_effort_x=effort))
        operated.run(0.1)
    return float(np.linalg.norm(operated.robot.data.body("inc1/base_link").xpos - begun))


@pytest.mark.slow
def test_near_the_limit_it_climbs_slowly() -> None:
    """The arm with its load behind the robot leaves a margin of 10 degrees on the ramp."""
    went = {}
    for on in (False, True):
        operated = Operated(before_ramp())
        operated.switch(pitchover=on, rollover=on)
        reach(operated, (*BACKWARD, (2.9, 0.55, -0.05, 0.0, 0.0)))
        hold_stick(operated, 40.0, 2.5)  # onto the ramp
        margin = operated.shared.stability.margin()
        assert math.radians(6.0) < margin.angle < math.radians(12.0)
        assert margin.edge == "rear"
        went[on] = hold_stick(operated, 40.0, 2.0)
    assert 0.25 * went[False] < went[True] < 0.75 * went[False]
