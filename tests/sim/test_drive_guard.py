"""inc1 between walls: guarded teleoperation stops it before it touches them, by MuJoCo's contacts."""

from __future__ import annotations

import dataclasses
import math

import pytest

pytest.importorskip("mujoco", reason="MuJoCo is not installed")

import mujoco
import numpy as np
from tests.helpers.self_contacts import ContactJudge

from jauspy.geometry.link_boxes import LinkBoxes
from jauspy.platform.description import GuardedTeleopSetup
from jauspy.platform.guarded_robot import GuardedRobot
from jauspy.platform.guards import GuardState, ObstacleGuard
from jauspy.platform.joints import ControlMode, Target
from jauspy.platform.ranging import ScanSettings
from jauspy.robot.robot_files import load, robot_model
from jauspy_sim.assembly import build_in
from jauspy_sim.robot import SimulatedRobot

INC1 = dataclasses.replace(robot_model(load("inc1")), cameras=(), force_torque=())
STEP = 0.002
DISTANCE = 0.15
WALLS = ("front", "back", "left", "right")
OUTLINE = ("base_link", "left_track", "right_track", "left_flipper", "right_flipper")
"""The links whose rectangle the guard keeps clear."""
ROOM = 3.0
"""Metres from the middle of the room to its walls."""


class Drive:
    """inc1 in the middle of a room, heading in a direction; the box is too low for the lidar."""

    def __init__(self, yaw: float = 0.0, *, enabled: bool = True, box: bool = False) -> None:
        spec = mujoco.MjSpec()
        spec.worldbody.add_geom(type=mujoco.mjtGeom.mjGEOM_PLANE, size=(0, 0, 0.1))
        for name, x, y in (("front", 1, 0), ("back", -1, 0), ("left", 0, 1), ("right", 0, -1)):
            wall = spec.worldbody.add_body(name=name, pos=(x * (ROOM + 0.1), y * (ROOM + 0.1), 0.6))
            size = (0.1, 4.0, 0.6) if x else (4.0, 0.1, 0.6)
            wall.add_geom(type=mujoco.mjtGeom.mjGEOM_BOX, size=size)
        if box:
            low = spec.worldbody.add_body(name="box", pos=(1.8, 0.0, 0.1))
            low.add_geom(type=mujoco.mjtGeom.mjGEOM_BOX, size=(0.1, 0.4, 0.1))
        setup = GuardedTeleopSetup(enabled=enabled, distance=DISTANCE)
        model = dataclasses.replace(INC1, guarded_teleop=setup)
        self.sim = SimulatedRobot(build_in(spec, model), model)
        base = int(self.sim.model.joint("inc1/base").qposadr[0])
        self.sim.data.qpos[base + 3 : base + 7] = (math.cos(yaw / 2.0), 0.0, 0.0, math.sin(yaw / 2.0))
        self.robot = GuardedRobot(self.sim, model)
        self.judge = ContactJudge(self.sim, "inc1")
        self.touched: set[str] = set()
        self.advance(0.2)  # until the first scan

    @property
    def guard(self) -> ObstacleGuard:
        guard = ObstacleGuard.of(self.robot)
        assert guard is not None
        return guard

    @property
    def state(self) -> GuardState:
        return self.guard.state()

    def advance(self, seconds: float) -> None:
        for _ in range(round(seconds / STEP)):
            self.robot.advance(STEP)
            self.touched |= self.judge.outside()

    @property
    def outline_distance(self) -> float:
        """Metres between the walls and the rectangle around chassis and flippers, by MuJoCo's poses.

        At the rectangle's corners, where flippers that are raised leave it empty, the robot itself is some centimetres
        farther from a wall.
        """
        model, data = self.sim.model, self.sim.data
        base = data.body("inc1/base_link")
        geoms = self.judge.solids(OUTLINE)
        turns = base.xmat.reshape(3, 3).T @ data.geom_xmat[geoms].reshape(-1, 3, 3)
        middles = (data.geom_xpos[geoms] - base.xpos) @ base.xmat.reshape(3, 3)
        reach = np.einsum("gij,gj->gi", np.abs(turns), model.geom_aabb[geoms, 3:])
        low, high = (middles - reach).min(axis=0), (middles + reach).max(axis=0)
        corners = np.array([(x, y, 0.0) for x in (low[0], high[0]) for y in (low[1], high[1])])
        return ROOM - float(np.abs(corners @ base.xmat.reshape(3, 3).T + base.xpos)[:, :2].max())

    @property
    def place(self) -> tuple[float, float]:
        pose = self.robot.drive.pose()
        return pose.x, pose.y


@pytest.mark.slow
@pytest.mark.parametrize("effort", [1.0, 0.5, 0.2, -1.0])
@pytest.mark.parametrize("degrees", [0.0, 25.0, 50.0])
def test_it_stops_before_a_wall_and_drives_back(effort: float, degrees: float) -> None:
    drive = Drive(math.radians(degrees))
    drive.robot.drive.set_effort(effort, 0.0)
    drive.advance(3.0 / abs(effort) + 1.0 if abs(effort) > 0.3 else 12.0)
    state = drive.state
    assert not drive.touched
    assert state.active
    assert 0.5 * DISTANCE < state.distance < 2.0 * DISTANCE
    assert f"obstacle {state.distance:.2f} m " in state.problem
    assert state.distance == pytest.approx(drive.outline_distance, abs=0.04), "noise of the lidar, and 1 cm of belts"
    assert state.distance < min(drive.judge.clearance(wall, OUTLINE) for wall in WALLS) + 0.01
    assert math.hypot(drive.robot.drive.twist().vx, drive.robot.drive.twist().vy) < 0.01
    before = drive.place
    drive.robot.drive.set_effort(-effort, 0.0)
    drive.advance(1.5)
    assert math.dist(before, drive.place) > 0.15
    assert not drive.state.problem
    drive.sim.close()


@pytest.mark.slow
def test_without_the_guard_it_touches_the_wall() -> None:
    drive = Drive(enabled=False)
    drive.robot.drive.set_effort(0.5, 0.0)
    drive.advance(5.0)
    assert "front" in drive.touched
    drive.sim.close()


@pytest.mark.slow
@pytest.mark.parametrize(("effort", "turn"), [(0.8, 0.3), (0.5, -0.2), (-0.6, 0.4), (0.3, 0.1)])
def test_curves_end_before_walls(effort: float, turn: float) -> None:
    drive = Drive()
    drive.robot.drive.set_effort(effort, turn)
    drive.advance(8.0)
    assert not drive.touched
    drive.sim.close()


@pytest.mark.slow
def test_random_driving_touches_no_wall() -> None:
    for seed in range(10):
        rng = np.random.default_rng(seed)
        drive = Drive(rng.uniform(-math.pi, math.pi))
        for _ in range(12):
            drive.robot.drive.set_effort(rng.uniform(-1.0, 1.0), rng.uniform(-1.0, 1.0))
            drive.advance(rng.uniform(0.3, 2.0))
        assert not drive.touched, seed
        drive.sim.close()


@pytest.mark.slow
def test_flippers_that_are_ahead_count_as_the_chassis() -> None:
    ends = []
    for flippers in (2.2, 0.0):
        drive = Drive()
        drive.robot.groups["flippers"].command([Target(ControlMode.POSITION, flippers)])
        drive.advance(2.5)
        drive.robot.drive.set_effort(0.5, 0.0)
        drive.advance(5.0)
        assert not drive.touched
        ends.append(drive.place[0])
        drive.sim.close()
    assert ends[0] - ends[1] > 0.15


@pytest.mark.slow
def test_the_arm_ahead_is_no_obstacle() -> None:
    """Stretched out in the plane of the lidar, it is seen; the robot drives on all the same."""
    drive = Drive()
    drive.robot.groups["arm"].command([Target(ControlMode.POSITION, value) for value in (0.0, 0.5, -0.4, 0.0, 0.0)])
    drive.advance(5.0)
    before = drive.place
    drive.robot.drive.set_effort(0.5, 0.0)
    drive.advance(1.0)
    assert drive.place[0] - before[0] > 0.4
    assert not drive.state.problem
    drive.sim.close()


@pytest.mark.slow
def test_a_silent_lidar_stops_it() -> None:
    drive = Drive()
    drive.sim.lidars["lidar"].configure(ScanSettings(active=False))
    drive.robot.drive.set_effort(0.5, 0.0)
    drive.advance(1.0)
    before = drive.place
    drive.advance(1.0)
    assert math.dist(before, drive.place) < 0.01
    assert "lidar has measured nothing for" in drive.state.problem
    drive.guard.enable(False)
    drive.advance(1.0)
    assert math.dist(before, drive.place) > 0.2, "off, it drives on"
    drive.sim.close()


def seen_box(drive: Drive) -> bytes:
    """The near side of the box as a depth camera at the chassis sees it, from the robot's true pose."""
    x, y = drive.place
    turn, place = LinkBoxes(INC1.description, ()).frame("chassis_camera_link", ())
    rows = [(1.7 - x, side - y, height) for side in np.arange(-0.4, 0.41, 0.05) for height in (0.12, 0.16, 0.2)]
    return ((np.array(rows) - place) @ turn).astype("<f4").tobytes()


@pytest.mark.slow
def test_what_only_the_depth_camera_sees_stops_it() -> None:
    """The box lies below the lidar's plane. Near it, the camera is over it and sees nothing: it is remembered."""
    free = Drive(box=True)
    free.robot.drive.set_effort(0.5, 0.0)
    free.advance(4.0)
    assert "box" in free.touched
    free.sim.close()
    drive = Drive(box=True)
    drive.robot.drive.set_effort(0.5, 0.0)
    for _ in range(40):
        if drive.place[0] < 1.0:
            drive.guard.see("chassis", "chassis_camera_link", seen_box(drive), 0.0)
        drive.advance(0.1)
    assert not drive.touched
    assert "ahead" in drive.state.problem
    drive.sim.close()


@pytest.mark.slow
def test_what_a_camera_sees_through_is_forgotten() -> None:
    drive = Drive()
    drive.robot.drive.set_effort(0.4, 0.0)
    drive.guard.see("chassis", "chassis_camera_link", seen_box(drive), 0.0)
    drive.advance(3.0)
    assert "ahead" in drive.state.problem
    beyond = np.frombuffer(seen_box(drive), "<f4").reshape(-1, 3)
    far = (beyond * (9.0 / beyond[:, :1])).astype("<f4").tobytes()
    drive.guard.see("chassis", "chassis_camera_link", far, 0.0)
    before = drive.place
    drive.advance(1.0)
    assert drive.place[0] - before[0] > 0.1
    drive.sim.close()


def test_points_that_are_no_numbers_are_left_out() -> None:
    drive = Drive()
    bad = np.array([[math.nan, 0.0, 0.0], [math.inf, 1.0, 0.0], [1e30, -1e30, 1e30]], "<f4").tobytes()
    drive.guard.see("chassis", "chassis_camera_link", bad, 0.0)
    drive.robot.drive.set_effort(0.5, 0.0)
    drive.advance(0.5)
    assert drive.place[0] > 0.1
    drive.sim.close()
