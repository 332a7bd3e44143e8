"""Driving on tracks: kerbs, stairs, slopes, gaps and walls, by pose and uprightness; and where a real robot tips."""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterator

import pytest

pytest.importorskip("mujoco", reason="MuJoCo is not installed")

import mujoco
import numpy as np

from jauspy.geometry.poses import Pose
from jauspy.planning.mobility import FLIPPER_ANGLE, mobility_of
from jauspy.platform.joints import ControlMode, Target
from jauspy.robot.robot_files import load, robot_model
from jauspy_sim.assembly import build_in
from jauspy_sim.robot import SimulatedRobot

INC1 = robot_model(load("inc1"))
SPEED = INC1.description.joint("base_link_to_left_track").velocity
FLIPPERS_OUT = -0.15
"""Radians: in line with the tracks."""
RISER, TREAD, STEPS = 0.18, 0.28, 6
FOOT = 1.0
"""Where a flight of stairs begins, m."""
LANDING = 2.0
OUTER_EDGE = 0.28
"""Of the belts, from the middle, m."""
SAFE = math.radians(50.0)
"""More than any of these obstacles tilts a robot that climbs it."""


def ground() -> mujoco.MjSpec:
    spec = mujoco.MjSpec()
    spec.worldbody.add_geom(type=mujoco.mjtGeom.mjGEOM_PLANE, size=(0, 0, 0.1))
    return spec


def add_box(spec: mujoco.MjSpec, x: tuple[float, float], z: tuple[float, float], friction: float = 1.0) -> None:
    """A box across the way, from and to these x and z."""
    spec.worldbody.add_geom(
        type=mujoco.mjtGeom.mjGEOM_BOX,
        size=((x[1] - x[0]) / 2, 1.5, (z[1] - z[0]) / 2),
        pos=((x[0] + x[1]) / 2, 0.0, (z[0] + z[1]) / 2),
        friction=(friction, 0.005, 0.0001),
    )


def kerb(height: float) -> mujoco.MjSpec:
    spec = ground()
    add_box(spec, (0.8, 6.0), (0.0, height))
    return spec


def stairs() -> mujoco.MjSpec:
    """Up, a landing, and down to the ground again."""
    spec, top = ground(), FOOT + STEPS * TREAD
    for step in range(STEPS):
        add_box(
            spec, (FOOT + step * TREAD, 2 * top + LANDING - FOOT - step * TREAD), (step * RISER, (step + 1) * RISER)
        )
    return spec


def slope(up: float = 0.0, left: float = 0.0, friction: float = 1.0) -> mujoco.MjSpec:
    """An endless slope, degrees, seen by a robot that stands on it: the ground is level, and gravity pulls aside."""
    spec, up, left = mujoco.MjSpec(), math.radians(up), math.radians(left)
    spec.worldbody.add_geom(type=mujoco.mjtGeom.mjGEOM_PLANE, size=(0, 0, 0.1), friction=(friction, 0.005, 0.0001))
    spec.option.gravity = tuple(-9.81 * part for part in (math.sin(up), math.sin(left), math.cos(up) * math.cos(left)))
    return spec


def put(spec: mujoco.MjSpec, x: float = 0.0, yaw: float = 0.0) -> SimulatedRobot:
    """inc1 in that world."""
    robot = SimulatedRobot(build_in(spec, INC1), INC1)
    start = robot.model.joint("inc1/base").qposadr[0]
    robot.data.qpos[start] = x
    robot.data.qpos[start + 3 : start + 7] = (math.cos(yaw / 2.0), 0.0, 0.0, math.sin(yaw / 2.0))
    return robot


def turn_joints(robot: SimulatedRobot, group: str, *positions: float) -> None:
    robot.groups[group].command([Target(ControlMode.POSITION, position) for position in positions])


def tilt(pose: Pose) -> float:
    """Angle of the robot's z axis to the vertical."""
    return math.acos(math.cos(pose.roll) * math.cos(pose.pitch))


def driving(robot: SimulatedRobot, effort: float, seconds: float, turn: float = 0.0) -> Iterator[Pose]:
    """The pose each tenth of a second."""
    robot.drive.set_effort(effort, turn)
    for _ in range(round(10.0 * seconds)):
        robot.advance(0.1)
        yield robot.drive.pose()


def assert_climbs(robot: SimulatedRobot, effort: float, height: float) -> None:
    for pose in driving(robot, effort, 3.0 / effort):
        assert tilt(pose) < SAFE
        if pose.x > 1.4:
            assert pose.z == pytest.approx(height, abs=0.01)
            assert tilt(pose) < 0.02
            return
    pytest.fail(f"it hangs at {robot.drive.pose()}")


KERBS = [(height, effort) for height in (0.03, 0.05, 0.075) for effort in (0.2, 0.3, 0.4)]


@pytest.mark.slow
@pytest.mark.parametrize(
    ("height", "effort"),
    [pytest.param(*each, marks=[] if each == (0.075, 0.2) else pytest.mark.slow) for each in KERBS],
)
def test_climbs_kerbs_without_flippers(height: float, effort: float) -> None:
    assert_climbs(put(kerb(height)), effort, height)


@pytest.mark.slow
@pytest.mark.parametrize("effort", [pytest.param(0.3, marks=pytest.mark.slow), 0.4])
def test_climbs_20_cm_with_its_flippers(effort: float) -> None:
    robot = put(kerb(0.2), x=0.1)
    turn_joints(robot, "flippers", 0.6)
    robot.advance(2.0)
    for pose in driving(robot, effort, 4.0 / effort):
        assert tilt(pose) < SAFE
        if 0.4 < pose.x < 1.2:
            turn_joints(robot, "flippers", -0.8)
        elif pose.x > 1.2:
            turn_joints(robot, "flippers", 0.6)
        if pose.x > 1.7:
            break
    assert robot.drive.pose().z == pytest.approx(0.2, abs=0.01)
    assert tilt(robot.drive.pose()) < 0.02


def driven_slowly(robot: SimulatedRobot, wanted: float, seconds: float, gain: float) -> Pose:
    """The pose after a drive with the tracks at this speed, m/s; `gain`: effort for each m/s that is missing."""
    tracks = robot.drive
    for _ in range(round(100.0 * seconds)):
        tracks.set_effort(wanted / SPEED + gain * (wanted - sum(tracks.track_speeds()) / 2.0), 0.0)
        robot.advance(0.01)
    return tracks.pose()


@pytest.mark.slow
@pytest.mark.parametrize("yaw", [-0.02, -0.07, 0.01])
def test_a_slow_climb_does_not_end_where_the_road_wheels_begin(yaw: float) -> None:
    """They stand out by 2 mm: their corner must not hang on an edge."""
    robot = put(kerb(0.1), x=0.1, yaw=yaw)
    turn_joints(robot, "flippers", 0.15)
    robot.advance(2.0)
    pose = driven_slowly(robot, 0.25, 8.0, 0.5)
    assert pose.x > 1.2, f"it hangs at {pose}"
    assert pose.z == pytest.approx(0.1, abs=0.01)


@pytest.mark.slow
@pytest.mark.parametrize("x", [0.0, 0.13, 0.26])
def test_tracks_do_not_slip_on_the_face_of_a_step(x: float) -> None:
    robot = put(kerb(0.1), x=x)
    turn_joints(robot, "flippers", FLIPPER_ANGLE)
    robot.advance(2.0)
    pose = driven_slowly(robot, 0.1, 16.0, 3.0)
    assert pose.x > 0.9, f"it hangs at {pose}"


@pytest.mark.slow
@pytest.mark.parametrize("share", [0.65, 1.0])
def test_climbs_what_the_navigator_takes_for_climbable(share: float) -> None:
    step = share * mobility_of(INC1).flipper_step
    robot = put(kerb(step), x=0.1)
    turn_joints(robot, "flippers", FLIPPER_ANGLE)
    robot.advance(2.0)
    for pose in driving(robot, 0.25, 12.0):
        assert tilt(pose) < SAFE
        if pose.x > 1.7:
            break
    assert robot.drive.pose().z == pytest.approx(step, abs=0.01)


@pytest.mark.slow
def test_does_not_climb_20_cm_without() -> None:
    robot = put(kerb(0.2))
    assert max(pose.z for pose in driving(robot, 0.3, 4.0)) < 0.1


SEEDS = [pytest.param(seed, marks=[] if seed == 0 else pytest.mark.slow) for seed in range(20)]


@pytest.mark.slow
@pytest.mark.parametrize("seed", SEEDS)
def test_climbs_a_flight_of_stairs_and_comes_down_again(seed: int) -> None:
    random = np.random.default_rng(seed)
    robot = put(stairs(), x=0.25 + random.uniform(-0.15, 0.1), yaw=random.uniform(-0.05, 0.05) if seed else 0.0)
    turn_joints(robot, "flippers", FLIPPERS_OUT)
    robot.advance(2.0)
    top = FOOT + STEPS * TREAD
    on_stairs: list[float] = []
    robot.drive.set_effort(0.3, 0.0)
    while (pose := robot.drive.pose()).x < 2 * top + LANDING - FOOT + 0.8:
        assert tilt(pose) < SAFE
        assert robot.time < 60.0
        flat = top + 0.5 < pose.x < top + LANDING - 0.5
        assert not flat or pose.z == pytest.approx(STEPS * RISER, abs=0.05)
        heading = max(-0.1, min(0.1, -1.0 * pose.yaw - 0.3 * pose.y))  # as an operator keeps it straight
        robot.drive.set_effort(0.3, heading)
        robot.advance(0.1)
        if FOOT + TREAD < pose.x < top:
            on_stairs.append(robot.drive.twist().vx)
    assert pose.z == pytest.approx(0.0, abs=0.01)
    assert 0.2 < sum(on_stairs) / len(on_stairs) < 0.4


def test_climbs_a_ramp_of_35_degrees_and_holds_there() -> None:
    robot = put(slope(up=35.0))
    for pose in driving(robot, 0.4, 2.0):
        assert tilt(pose) < 0.02
    assert pose.x > 0.5
    robot.drive.stop()
    robot.advance(0.5)
    before = robot.drive.pose()
    robot.advance(1.0)
    assert robot.drive.pose().x == pytest.approx(before.x, abs=0.001)


def test_crosses_a_side_slope_of_25_degrees() -> None:
    for pose in driving(put(slope(left=25.0)), 0.3, 3.0):
        assert tilt(pose) < 0.02
    assert pose.x > 1.2
    assert abs(pose.y) < 0.05


def test_slides_down_a_side_slope_where_friction_ends() -> None:
    robot = put(slope(left=42.0))  # more than atan(0.8)
    before = robot.drive.pose()
    robot.advance(1.0)
    assert robot.drive.pose().y < before.y - 0.3


@pytest.mark.slow
@pytest.mark.parametrize(
    ("left", "turret", "load", "tips"),
    [
        pytest.param(30.0, -math.pi / 2.0, 10.0, True, id="30 degrees, 10 kg"),
        pytest.param(30.0, -math.pi / 2.0, 0.0, False, id="30 degrees, no load"),
        pytest.param(30.0, math.pi / 2.0, 10.0, False, id="30 degrees, 10 kg uphill"),
        pytest.param(25.0, -math.pi / 2.0, 8.0, False, id="25 degrees, 8 kg"),
    ],
)
def test_tips_sideways_with_a_load_on_its_arm(left: float, turret: float, load: float, tips: bool) -> None:
    """Where the centre of gravity of robot and load is beyond the lower belt; kg hang on the arm, 0.8 m beside it."""
    robot = put(slope(left=left))
    turn_joints(robot, "arm", turret, 0.6, -0.3, 0.0, 0.0)
    robot.advance(4.0)
    hand, base = robot.model.body("inc1/gripper_link").id, robot.model.body("inc1/base_link").id
    gravity = robot.model.opt.gravity
    centre = (robot.model.body_subtreemass[base] * robot.data.subtree_com[base] + load * robot.data.xpos[hand]) / (
        robot.model.body_subtreemass[base] + load
    )
    below = centre - gravity * centre[2] / gravity[2]  # on the ground, along gravity
    assert (below[1] < -OUTER_EDGE) == tips
    robot.data.xfrc_applied[hand][:3] = load * gravity
    tilts = [tilt(pose) for pose in driving(robot, 0.0, 3.0)]
    assert (max(tilts) > math.radians(40.0)) == tips
    assert tips or max(tilts) < math.radians(1.0)


@pytest.mark.slow
def test_crosses_a_gap_of_25_cm() -> None:
    spec = mujoco.MjSpec()
    add_box(spec, (-2.0, 0.8), (-0.5, 0.0))
    add_box(spec, (1.05, 5.0), (-0.5, 0.0))
    for pose in driving(put(spec), 0.3, 5.0):
        assert tilt(pose) < 0.05
        assert pose.z > -0.01
    assert pose.x > 1.9


@pytest.mark.slow
@pytest.mark.parametrize("friction", [0.5, pytest.param(1.0, marks=pytest.mark.slow)])
def test_a_wall_stops_it(friction: float) -> None:
    """At full effort it neither sinks into the wall nor shakes."""
    spec = ground()
    add_box(spec, (0.5, 0.7), (0.0, 1.0), friction)
    robot = put(spec)
    robot.drive.set_effort(1.0, 0.0)
    robot.advance(2.0)
    poses, depth = [], 0.0
    for _ in range(100):
        robot.advance(0.01)
        poses.append(robot.drive.pose())
        depth = max(depth, *(-contact.dist for contact in robot.data.contact))
    assert depth < 0.005
    assert max(map(tilt, poses)) < math.radians(8.0)
    assert np.ptp([pose.x for pose in poses]) < 0.01
    assert np.ptp([pose.pitch for pose in poses]) < math.radians(1.5)


GROUNDS = {"rubber mat": 1.0, "wet concrete": 0.5, "mud": 0.35, "ice": 0.1}


@pytest.mark.slow
def test_turns_on_the_spot_on_four_grounds() -> None:
    """Less friction, less resistance of the belts that slide sideways: a faster turn, around the same place."""
    rates = []
    for friction in GROUNDS.values():
        robot = put(slope(0.0, friction=friction))
        for pose in driving(robot, 0.0, 2.0, turn=0.3):
            assert math.hypot(pose.x, pose.y) < 0.15
        rates.append(robot.drive.twist().wz)
    assert all(slow < fast for slow, fast in itertools.pairwise(rates))
    ideal = 2.0 * 0.3 * SPEED / 0.46  # of wheels that do not slip
    assert 0.2 * ideal < rates[0] < 0.7 * ideal
    assert rates[-1] < ideal


def test_belts_slip_on_ice() -> None:
    robot = put(slope(0.0, friction=0.1))
    robot.drive.set_effort(1.0, 0.0)
    robot.advance(0.5)
    left, right = robot.drive.track_speeds()
    assert left == pytest.approx(right, abs=0.05)
    assert left > 1.7
    assert robot.drive.twist().vx == pytest.approx(0.1 * 9.81 * 0.5, abs=0.1), "belts of 3.6 kg start"


def test_the_motors_force_falls_with_speed() -> None:
    """Pulled by its current limit first, then by what the back-EMF leaves."""
    robot = put(slope(0.0))
    speeds = [0.0]
    robot.drive.set_effort(1.0, 0.0)
    for _ in range(10):
        robot.advance(0.05)
        speeds.append(robot.drive.twist().vx)
    gains = np.diff(speeds)
    assert gains[0] > 0.25
    assert gains[-1] < 0.05 * gains[0]
    assert 0.95 * SPEED < speeds[-1] < SPEED
    robot.drive.set_effort(0.3, 0.0)
    robot.advance(1.0)
    assert robot.drive.twist().vx == pytest.approx(0.3 * SPEED, rel=0.1)


@pytest.mark.slow
def test_falls_on_its_back_on_stairs_with_the_arm_stretched_out_behind() -> None:
    robot = put(stairs(), x=0.25)
    turn_joints(robot, "flippers", FLIPPERS_OUT)
    turn_joints(robot, "arm", 0.0, 2.4, 0.0, 0.0, 0.0)
    robot.advance(4.0)
    assert max(tilt(pose) for pose in driving(robot, 0.35, 8.0)) > math.radians(70.0)


def test_the_same_commands_climb_alike_bit_for_bit() -> None:
    ends = []
    for _ in range(2):
        robot = put(kerb(0.05), x=0.2)
        robot.drive.set_effort(0.4, 0.05)
        robot.advance(1.0)
        ends.append(robot.data.qpos.tobytes())
    assert ends[0] == ends[1]


DENSE, SPARSE = mujoco.mjtJacobian.mjJAC_DENSE, mujoco.mjtJacobian.mjJAC_SPARSE


@pytest.mark.slow
@pytest.mark.parametrize(
    ("jacobian", "condim"),
    [(SPARSE, 3), *(pytest.param(*each, marks=pytest.mark.slow) for each in ((DENSE, 4), (SPARSE, 4)))],
)
def test_climbs_with_either_form_of_the_jacobian_and_other_contacts(jacobian: mujoco.mjtJacobian, condim: int) -> None:
    spec = kerb(0.05)
    spec.option.jacobian = jacobian
    ball = spec.worldbody.add_body(pos=(3.0, 3.0, 0.2))
    ball.add_freejoint()
    ball.add_geom(type=mujoco.mjtGeom.mjGEOM_SPHERE, size=(0.1, 0.0, 0.0), condim=condim)
    robot = put(spec, x=0.25)
    assert mujoco.mj_isSparse(robot.model) == (jacobian == SPARSE)
    robot.drive.set_effort(0.4, 0.0)
    robot.advance(3.0)  # a micrometre at the start decides whether it is up after 1.2 s or 2.1 s
    assert robot.drive.pose().z == pytest.approx(0.05, abs=0.01)
