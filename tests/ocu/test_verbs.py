"""What a robot does in the words of the task: drive, go to, move, grip; on virtual time, with the robot inc1."""

from __future__ import annotations

import asyncio
import math
from dataclasses import replace
from datetime import UTC, datetime, timedelta

import pytest
from tests.helpers.robot import FakeDrive
from tests.helpers.simulated import Simulation, simulated

from jauspy.backends.kinematic import KinematicDrive
from jauspy.component.component import loop_time
from jauspy.errors import ConfigError, ControlRejected, RequestError
from jauspy.geometry.poses import Pose
from jauspy.geometry.vectors import GRAVITY
from jauspy.messages.core import Standby, TimeStamp
from jauspy.messages.mobility import QueryWrenchEffort, SetWrenchEffort
from jauspy.ocu import CoursePoint, MotionLimits
from jauspy.ocu.driving import PROGRESS_INTERVAL, Driving
from jauspy.ocu.state import datetime_of
from jauspy.platform.chassis import Chassis
from jauspy.platform.joints import JointState
from jauspy.services.core import AccessControl
from jauspy.services.manipulator.end_effector import EndEffectorPoseDriver
from jauspy.services.mobility import PrimitiveDriver, Vehicle
from jauspy.services.ugv import PlatformSpecifications
from jauspy.testing import VirtualNetwork

TURN, SHOULDER, ELBOW = "base_link_to_arm_link_1", "arm_link_1_to_arm_link_2", "arm_link_2_to_arm_link_3"
FINGER = "gripper_link_to_left_finger"
PAN, TILT, PAN_TILT = "base_link_to_pan_link", "pan_link_to_tilt_link", 107


@pytest.fixture
async def inc1(robot, ocu):
    return await ocu.robot(101)


@pytest.mark.slow
async def test_drive_turns_left_for_positive_angular(inc1, robot):
    async with inc1.control("drive"):
        await inc1.drive(linear=0.4, angular=0.3, seconds=2.0)
        pose = await inc1.pose()
    assert pose.x > 0.4
    assert pose.y > 0.05
    assert 0.3 < pose.yaw < 0.75
    assert abs(robot.snapshot.pose.yaw - pose.yaw) < 0.05
    assert abs(datetime.now(UTC) - pose.time) < timedelta(days=32)


@pytest.mark.slow
async def test_drive_goes_on_until_stopped(inc1, robot):
    async with inc1.control("drive"):
        await inc1.drive(linear=0.4)
        await asyncio.sleep(5.0)
        assert robot.snapshot.twist.vx == pytest.approx(0.4, abs=0.05)
        await inc1.stop()
        await asyncio.sleep(1.0)
        assert robot.snapshot.twist.vx == pytest.approx(0.0, abs=0.01)


@pytest.mark.slow
async def test_drive_stops_at_the_end_of_the_block(inc1, robot):
    async with inc1.control("drive"):
        await inc1.drive(linear=0.4)
        await asyncio.sleep(2.0)
    await asyncio.sleep(1.0)
    assert robot.snapshot.twist.vx == pytest.approx(0.0, abs=0.01)


@pytest.mark.slow
async def test_effort_drives_until_the_next_command_or_for_a_time(inc1, robot):
    async with inc1.control("drive"):
        await inc1.drive_effort(40.0)
        await asyncio.sleep(3.0)
        assert robot.snapshot.twist.vx > 0.3
        assert abs(robot.snapshot.twist.wz) < 0.05
        await inc1.drive_effort(angular=30.0, seconds=1.0)
        assert robot.snapshot.pose.yaw > 0.1
        with pytest.raises(ConfigError, match=r"linear=140 is outside -100..100 percent"):
            await inc1.drive_effort(140.0)
        await asyncio.sleep(1.0)
        assert robot.snapshot.twist.vx == pytest.approx(0.0, abs=0.02)


async def test_drive_without_control_says_what_to_do(inc1):
    with pytest.raises(ControlRejected, match=r"take control first, with `robot.control\(\)`"):
        await inc1.drive(linear=0.4)


async def test_drive_faster_than_the_robot_can_is_an_error(inc1):
    async with inc1.control("drive"):
        with pytest.raises(ConfigError, match=r"linear=9 is more than the [\d.]+ m/s"):
            await inc1.drive(linear=9.0)


@pytest.mark.slow
async def test_drive_in_standby_says_resume_first(inc1, ocu):
    async with inc1.control("drive"):
        await inc1.service("mobility:PrimitiveDriver").send(Standby(), ack=True)
        with pytest.raises(RequestError, match="in Standby: resume first"):
            await inc1.drive(linear=0.2)
        assert "in Standby: resume first" in await ocu.explain("101.1.102", SetWrenchEffort())


@pytest.mark.slow
async def test_go_to_reports_progress_and_arrives(inc1):
    seen = []
    async with inc1.control("drive"):
        there = await inc1.go_to(x=1.5, y=0.5, progress=seen.append)
    assert math.dist((there.x, there.y), (1.5, 0.5)) <= 0.11
    assert seen[0].distance > 1.0 > seen[-1].distance
    assert seen[-1].elapsed > seen[0].elapsed


@pytest.mark.slow
async def test_go_to_in_the_frame_of_the_robot_is_relative(inc1):
    async with inc1.control("drive"):
        await inc1.go_to(x=1.0, y=0.0, yaw=math.pi / 2)
        there = await inc1.go_to(x=0.8, y=0.0, frame="robot")
    assert math.dist((there.x, there.y), (1.0, 0.8)) < 0.25


@pytest.mark.slow
async def test_link_is_measured_by_the_robot(inc1):
    await inc1.link()
    await asyncio.sleep(3.0)
    health = await inc1.link()
    assert health.is_up
    assert (health.round_trip, health.loss) == (pytest.approx(0.0, abs=0.01), 0.0)


@pytest.mark.slow
async def test_course_with_reverse_and_waits(inc1):
    headings = []
    async with inc1.control("drive"):
        there = await inc1.drive_course(
            [(1.0, 0.0), CoursePoint(1.5, 0.0, wait=2.0), CoursePoint(0.0, 0.0, reverse=True)], speed=0.8
        )
        headings.append(there.yaw)
    assert math.hypot(there.x, there.y) < 0.25
    assert abs(headings[0]) < 0.3


@pytest.mark.slow
@pytest.mark.parametrize(
    ("points", "error", "text"),
    [
        ([], ConfigError, "at least one point"),
        (7, TypeError, "a course is made of points"),
        ([(1.0, float("nan"))], ConfigError, "y=nan of a point of a course is no finite number"),
        ([(1.0, 2.0, 3.0)], TypeError, "a pair of metres or a CoursePoint"),
        (["ab"], TypeError, "a pair of metres or a CoursePoint"),
    ],
)
async def test_a_course_needs_points(inc1, points, error, text):
    with pytest.raises(error, match=text):
        await inc1.drive_course(points)


def test_waits_have_limits():
    with pytest.raises(ConfigError, match="wait=0 is outside of"):
        CoursePoint(1.0, 0.0, wait=0.0)


@pytest.mark.slow
async def test_cancelled_course_stops_the_robot(inc1, robot):
    async with inc1.control("drive"):
        with pytest.raises(TimeoutError):
            async with asyncio.timeout(3.0):
                await inc1.drive_course([(20.0, 0.0)])
        await asyncio.sleep(1.0)
        assert abs(robot.snapshot.twist.vx) < 0.01


@pytest.mark.slow
async def test_cancelled_go_to_stops_the_robot(inc1, robot):
    async with inc1.control("drive"):
        with pytest.raises(TimeoutError):
            async with asyncio.timeout(3.0):
                await inc1.go_to(x=20.0, y=0.0)
        await asyncio.sleep(1.5)
        assert robot.snapshot.twist.vx == pytest.approx(0.0, abs=0.01)


@pytest.mark.slow
@pytest.mark.parametrize("earlier", ["course", "go_to", "drive"])
async def test_the_end_of_an_earlier_motion_does_not_stop_a_later_one(inc1, robot, earlier):
    async with inc1.control("drive"):
        motion = {
            "course": lambda: inc1.drive_course([(20.0, 0.0)]),
            "go_to": lambda: inc1.go_to(x=20.0, y=0.0),
            "drive": lambda: inc1.drive(0.3, seconds=30.0),
        }[earlier]
        first = asyncio.create_task(motion())
        await asyncio.sleep(1.5)
        later = asyncio.create_task(inc1.drive_course([(20.0, 0.0)], speed=0.4))
        await asyncio.sleep(1.0)
        first.cancel()
        await asyncio.wait({first})
        await asyncio.sleep(2.0)
        assert robot.snapshot.twist.vx == pytest.approx(0.4, abs=0.05)
        later.cancel()
        await asyncio.wait({later})


@pytest.mark.slow
async def test_go_to_accepts_where_the_robot_stands(inc1, robot, monkeypatch):
    """As with a pose that drifts while the robot comes to rest."""
    pose, queries = Driving.pose, []

    async def drifted(self):
        found = await pose(self)
        queries.append(found)
        return replace(found, y=found.y + 0.12)

    monkeypatch.setattr(Driving, "pose", drifted)
    async with inc1.control("drive"):
        reached = await inc1.go_to(x=1.0, y=0.0, tolerance=0.05, accept=0.2)
        assert reached.y > 0.06
        queries.clear()
        with pytest.raises(RequestError, match=r"the robot is 0\.1\d m from \(1, 0\) after 8 s"):
            await inc1.go_to(x=1.0, y=0.0, tolerance=0.05, timeout=8.0)
    assert len(queries) <= 8.0 / PROGRESS_INTERVAL + 2, "the pose is not queried more often while the robot stands"


@pytest.mark.slow
async def test_go_to_names_the_loss_of_control(inc1, virtual_network):
    async with inc1.control("drive", authority=100):
        going = asyncio.create_task(inc1.go_to(x=5.0, y=0.0))
        await asyncio.sleep(1.0)
        async with virtual_network.ocu("42.1.9") as other, (await other.robot(101)).control("drive", authority=200):
            with pytest.raises(ControlRejected, match="was lost"):
                await going


@pytest.mark.slow
async def test_go_to_says_that_the_robot_is_tilted_when_its_guard_stops_it(inc1, robot, monkeypatch):
    level = KinematicDrive.pose

    def rearing_up(drive: KinematicDrive) -> Pose:
        pose = level(drive)
        return replace(pose, pitch=-math.radians(65.0)) if pose.x > 0.8 else pose

    monkeypatch.setattr(KinematicDrive, "pose", rearing_up)
    async with inc1.control("drive"):
        with pytest.raises(RequestError, match=r"stopped 1\.\d+ m from.*tilted: pitch -65, roll 0 degrees"):
            await inc1.go_to(x=2.0, y=0.0)
        await asyncio.sleep(1.0)
        assert robot.snapshot.twist.vx == pytest.approx(0.0, abs=0.01)


@pytest.mark.slow
async def test_go_to_unknown_frame_lists_frames(inc1):
    with pytest.raises(ConfigError, match=r"no frame 'map'; frames are local, robot"):
        await inc1.go_to(x=1.0, y=0.0, frame="map")


@pytest.mark.slow
async def test_arm_positions_are_those_of_the_description(inc1, robot):
    async with inc1.control("arm"):
        reached = await inc1.arm.move({ELBOW: -1.2})
    own = dict(zip((joint for joint in reached.positions), robot.snapshot.joints["arm"].positions, strict=True))
    assert own[ELBOW] == pytest.approx(-1.2, abs=0.02)
    assert reached[ELBOW] == pytest.approx(-1.2, abs=0.02)
    assert reached[SHOULDER] == pytest.approx(2.7, abs=0.02)


@pytest.mark.slow
async def test_begin_returns_at_once_and_reports_follow_the_motion(inc1, robot):
    async with inc1.control("arm"):
        await inc1.arm.begin({TURN: 0.6})
        assert abs(robot.snapshot.joints["arm"].positions[0]) < 0.1
        reports = inc1.arm.watch(rate=20.0)
        seen = [(await anext(reports))[TURN] for _ in range(40)]
        await reports.aclose()
    assert seen == sorted(seen)
    assert seen[-1] == pytest.approx(0.6, abs=0.01)


@pytest.mark.slow
async def test_move_with_a_tolerance_ends_at_rest_within_it(inc1, robot):
    async with inc1.control("arm"):
        reached = await inc1.arm.move({TURN: 0.5}, tolerance=0.002)
        assert reached[TURN] == pytest.approx(0.5, abs=0.002)
        assert robot.snapshot.joints["arm"].velocities[0] == pytest.approx(0.0, abs=1e-2)


@pytest.mark.slow
async def test_motion_limits_are_set_for_joints_by_name_and_stay(inc1):
    clock = asyncio.get_running_loop().time
    async with inc1.control("arm"):
        before = await inc1.arm.motion_limits()
        await inc1.arm.set_motion_limits({TURN: MotionLimits(0.1, 0.5, 0.4)})
        after = await inc1.arm.motion_limits()
        assert after[TURN] == MotionLimits(pytest.approx(0.1), pytest.approx(0.5), pytest.approx(0.4))
        assert {name: after[name] for name in after if name != TURN} == {n: before[n] for n in before if n != TURN}
        began = clock()
        await inc1.arm.move({TURN: 0.4})
        assert clock() - began > 4.0
        with pytest.raises(ConfigError, match="no joint 'knee'; there are base_link_to_arm_link_1"):
            await inc1.arm.set_motion_limits({"knee": MotionLimits(0.1)})
        with pytest.raises(ConfigError, match="acceleration 0 must be above 0"):
            await inc1.arm.set_motion_limits({TURN: MotionLimits(0.1, 0.0)})


@pytest.mark.slow
async def test_pan_tilt_unit_is_moved_by_the_names_of_its_joints(inc1, robot):
    unit = inc1.manipulator(PAN_TILT)
    async with inc1.control(PAN_TILT):
        await unit.move({PAN: 0.5, TILT: -0.2})
        reached = await unit.move({PAN: 0.3}, tolerance=0.01)
        assert (reached[PAN], reached[TILT]) == pytest.approx((0.3, -0.2), abs=0.01)
        assert robot.snapshot.joints["pan_tilt"].positions == pytest.approx((0.3, -0.2), abs=0.01)
        await unit.begin({PAN: -0.5})
        await unit.stop()
        assert (await unit.joints())[PAN] > 0.1
        with pytest.raises(ConfigError, match=r"101.1.107 cannot move its joints to positions"):
            await unit.joint_positions(**{PAN: 0.0})


@pytest.mark.slow
async def test_force_torque_sensor_measures_the_weight_downwards(inc1):
    measured = await inc1.force_torque()
    assert -measured.force[2] / GRAVITY == pytest.approx(1.5, abs=1.0)
    assert measured.force[2] < -5.0
    assert math.hypot(*measured.force[:2]) < 0.2
    with pytest.raises(RequestError, match="has no force-torque sensor 7"):
        await inc1.force_torque(7)


@pytest.mark.slow
async def test_all_joints_are_reported_as_in_the_description(inc1, robot):
    reported = await inc1.joints()
    joints = reported.positions
    assert dict(reported.items()) == dict(joints)
    assert (list(reported), len(reported)) == (list(joints), len(joints))
    for name, value in {
        TURN: 0.0,
        SHOULDER: 2.7,
        ELBOW: -2.6,
        "arm_link_3_to_arm_link_4": -0.1,
        FINGER: 0.03,
        "base_link_to_flippers": 2.2,
        "base_link_to_pan_link": 0.0,
    }.items():
        assert joints[name] == pytest.approx(value, abs=0.005)


@pytest.mark.slow
async def test_speed_limits_the_joints_for_this_move_only(inc1):
    clock = asyncio.get_running_loop().time
    async with inc1.control("arm"):
        began = clock()
        await inc1.arm.move({TURN: 0.5}, speed=0.1)
        slow = clock() - began
        await inc1.arm.move({TURN: 0.0})
        fast = clock() - began - slow
    assert slow > 4.5
    assert fast < 2.5


@pytest.mark.slow
async def test_unknown_joints_and_positions_out_of_range_are_named(inc1):
    async with inc1.control("arm"):
        with pytest.raises(ConfigError, match="no joint 'knee'; there are base_link_to_arm_link_1"):
            await inc1.arm.move({"knee": 0.3})
        with pytest.raises(ConfigError, match=r"arm_link_2_to_arm_link_3 can be -2.8..2.8 rad, and not 3"):
            await inc1.arm.move({ELBOW: 3.0})


@pytest.mark.slow
async def test_a_move_takes_its_duration_with_all_joints(inc1, robot):
    clock = asyncio.get_running_loop().time
    async with inc1.control("arm"):
        limits = await inc1.arm.motion_limits()
        begun = clock()
        await inc1.arm.move({TURN: 0.8, ELBOW: -2.4}, duration=4.0)
        assert clock() - begun == pytest.approx(4.0, abs=0.4)
        assert await inc1.arm.motion_limits() == limits, "the motion profile is as before"
        there = robot.snapshot.joints["arm"].positions
        with pytest.raises(ConfigError, match=rf"{TURN} needs at least \d.\d\d s for its way, and not 0.1 s"):
            await inc1.arm.move({TURN: -0.8}, duration=0.1)
        assert robot.snapshot.joints["arm"].positions == there
        with pytest.raises(ConfigError, match="not both"):
            await inc1.arm.move({TURN: 0.0}, duration=4.0, speed=0.1)


@pytest.mark.slow
@pytest.mark.parametrize("service", ["list", "verbs"])
async def test_an_arm_follows_rows_in_their_times(inc1, robot, monkeypatch, service):
    if service == "verbs":
        monkeypatch.setattr("jauspy.ocu.arm.LIST_DRIVER", "Nothing")
    clock, seen = asyncio.get_running_loop().time, []
    rows = [(2.0, {TURN: 0.4}), (0.0, {ELBOW: -2.3}), (3.0, {TURN: 0.0, SHOULDER: 2.4})]
    async with inc1.control("arm"):
        limits, begun = await inc1.arm.motion_limits(), clock()
        reached = await inc1.arm.follow(rows, progress=lambda number: seen.append((number, clock() - begun)))
        taken = clock() - begun
        assert await inc1.arm.motion_limits() == limits
    assert [number for number, _ in seen] == [0, 1, 2]
    assert seen[1][1] == pytest.approx(2.0, abs=0.4)
    assert taken - seen[2][1] == pytest.approx(3.0, abs=0.5)
    assert reached.positions[TURN] == pytest.approx(0.0, abs=0.02)
    assert reached.positions[ELBOW] == pytest.approx(-2.3, abs=0.02)
    assert reached.positions[SHOULDER] == pytest.approx(2.4, abs=0.02)


@pytest.mark.slow
async def test_rows_that_cannot_be_move_nothing(inc1, robot):
    async with inc1.control("arm"):
        before = robot.snapshot.joints["arm"].positions
        for rows, said in (
            ([(3.0, {TURN: 0.4}), (0.1, {TURN: -0.4})], rf"row 2: {TURN} needs at least \d.\d\d s for its way"),
            ([(3.0, {TURN: 0.4}), (3.0, {ELBOW: 3.0})], f"row 2: {ELBOW} can be"),
            ([(-1.0, {TURN: 0.4})], "row 1: its time is -1 s"),
            ([], "`rows` is empty"),
        ):
            with pytest.raises(ConfigError, match=said):
                await inc1.arm.follow(rows)
        assert robot.snapshot.joints["arm"].positions == before


@pytest.mark.slow
async def test_a_pause_takes_its_time_and_cancelling_stops(inc1, robot):
    clock = asyncio.get_running_loop().time
    async with inc1.control("arm"):
        here, begun = (await inc1.arm.joints()).positions[TURN], clock()
        await inc1.arm.follow([(1.5, {TURN: here})])
        assert clock() - begun >= 1.5
        moving = asyncio.create_task(inc1.arm.follow([(4.0, {TURN: 1.0}), (4.0, {TURN: -1.0})]))
        await asyncio.sleep(2.0)
        moving.cancel()
        await asyncio.wait([moving])
        await asyncio.sleep(0.5)
        there = robot.snapshot.joints["arm"].positions[0]
        assert 0.1 < there < 0.9
        await asyncio.sleep(2.0)
        assert robot.snapshot.joints["arm"].positions[0] == pytest.approx(there, abs=0.01)


@pytest.mark.slow
async def test_a_speed_may_be_that_of_some_joints(inc1, robot):
    clock = asyncio.get_running_loop().time
    async with inc1.control("arm"):
        begun = clock()
        await inc1.arm.move({TURN: 0.3, ELBOW: -2.4}, speed={TURN: 0.1})
        assert clock() - begun == pytest.approx(3.1, abs=0.4)


@pytest.mark.slow
@pytest.mark.parametrize("service", ["velocity", "pose"])
async def test_the_tool_moves_at_a_velocity_in_both_frames(inc1, robot, monkeypatch, service):
    if service == "pose":
        monkeypatch.setattr("jauspy.ocu.arm.VELOCITY_DRIVER", "Nothing")
    arm = inc1.arm
    async with inc1.control("arm"):
        await arm.move_tool((0.6, 0.2, 0.6))
        for frame in ("robot", "tool"):
            before = await arm.tool()
            pitch, yaw = before.pitch, before.yaw
            ahead = (
                0.1 * math.cos(yaw) * math.cos(pitch),
                0.1 * math.sin(yaw) * math.cos(pitch),
                -0.1 * math.sin(pitch),
            )
            way = (0.0, 0.0, 0.1) if frame == "robot" else ahead
            velocity = (0.0, 0.0, 0.05) if frame == "robot" else (0.05, 0.0, 0.0)
            for _ in range(20):
                await arm.move_tool_at(velocity, frame=frame)
                await asyncio.sleep(0.1)
            await arm.move_tool_at()
            await asyncio.sleep(0.5)
            after = await arm.tool()
            moved = (after.x - before.x, after.y - before.y, after.z - before.z)
            assert math.dist(moved, way) < 0.035, (frame, moved)
            await asyncio.sleep(1.0)
            still = await arm.tool()
            assert math.dist((still.x, still.y, still.z), (after.x, after.y, after.z)) < 0.002
        with pytest.raises(ConfigError, match='there are "robot" and "tool"'):
            await arm.move_tool_at((0.1, 0.0, 0.0), frame="base")


@pytest.mark.slow
async def test_the_gripper_opens_to_a_width(inc1, robot):
    async with inc1.control("gripper"):
        gripper = inc1.gripper
        assert await gripper.width_limits() == pytest.approx((0.0, 0.1))
        assert await gripper.max_force()
        for width in (0.03, 0.08, 0.05):
            reached = await gripper.open_to(width)
            assert reached == pytest.approx(width, abs=0.01)
            assert reached == pytest.approx(await gripper.width(), abs=0.002)
        with pytest.raises(ConfigError, match=r"the fingers of 101.1.105 open 0..0.1 m, not 2"):
            await gripper.open_to(2.0)


@pytest.mark.slow
async def test_a_width_is_the_distance_between_the_fingers_in_the_simulation():
    mujoco = pytest.importorskip("mujoco")
    async with VirtualNetwork() as network:
        simulation = Simulation()
        async with simulated(network, simulation), network.ocu() as ocu:
            inc1, model, data = await ocu.robot(101), simulation.robot.model, simulation.robot.data
            solids = [model.body(f"inc1/{side}_finger").geomadr[0] for side in ("left", "right")]
            async with inc1.control("gripper"):
                for width in (0.02, 0.06, 0.04):
                    await inc1.gripper.open_to(width, effort=15.0)
                    await asyncio.sleep(0.3)
                    measured = mujoco.mj_geomDistance(model, data, *solids, 1.0, None)
                    assert measured == pytest.approx(width, abs=0.008)
                    assert measured == pytest.approx(await inc1.gripper.width(), abs=0.002)
                assert await inc1.gripper.force() == pytest.approx(0.0, abs=3.0), "they hold, and press nothing"


@pytest.mark.slow
async def test_an_arm_that_presses_on_something_stops_and_says_which_joint(caplog):
    mujoco = pytest.importorskip("mujoco")
    numpy = pytest.importorskip("numpy")
    async with VirtualNetwork() as network:
        simulation = Simulation()
        async with simulated(network, simulation) as running, network.ocu() as ocu:
            inc1, model, data = await ocu.robot(101), simulation.robot.model, simulation.robot.data

            def pressed() -> float:
                """Newtons between the forearm and the camera on its mast, on which it comes to lie."""
                bodies = {model.body(f"inc1/{name}").id for name in ("tilt_link", "arm_link_2")}
                total, wrench = 0.0, numpy.zeros(6)
                for number, contact in enumerate(data.contact):
                    if {model.geom_bodyid[contact.geom1], model.geom_bodyid[contact.geom2]} == bodies:
                        mujoco.mj_contactForce(model, data, number, wrench)
                        total += wrench[0]
                return total

            async def touches() -> float:
                while not pressed():
                    await asyncio.sleep(0.05)
                return loop_time()

            async with inc1.control("arm"):
                await inc1.arm.move({SHOULDER: 1.8, ELBOW: 0.0})
                touching = asyncio.create_task(touches())
                with pytest.raises(
                    RequestError, match=rf"^Blocked: {SHOULDER}, \d+ N m, 0.08 rad short; 101.1.104 holds"
                ):
                    await inc1.arm.move({SHOULDER: 0.0})
                assert loop_time() - await touching < 1.0
                await asyncio.sleep(0.5)
                assert pressed() < 80.0, "without the stop it presses with more than 600 N"
                assert running.counters["101.1.104.host.blocked"] == 1
                assert "blocked: " + SHOULDER in caplog.text
                await inc1.arm.move({SHOULDER: 0.5})


@pytest.mark.slow
async def test_a_slow_move_is_not_taken_for_a_blocked_one():
    pytest.importorskip("mujoco")
    async with VirtualNetwork() as network:
        simulation = Simulation()
        async with simulated(network, simulation), network.ocu() as ocu:
            inc1 = await ocu.robot(101)
            async with inc1.control("arm"):
                start = (await inc1.arm.joints()).positions[TURN]
                await inc1.arm.move({TURN: start + 0.05}, speed=0.004)
                arm = simulation.robot.groups["arm"]
                assert arm.state().positions[0] == pytest.approx(start + 0.05, abs=0.01)


@pytest.mark.slow
async def test_cancelled_move_stops_the_arm(inc1, robot):
    async with inc1.control("arm"):
        with pytest.raises(TimeoutError):
            async with asyncio.timeout(1.0):
                await inc1.arm.move({TURN: 2.5})
        await asyncio.sleep(1.0)
        there = robot.snapshot.joints["arm"].positions[0]
        await asyncio.sleep(1.0)
        assert robot.snapshot.joints["arm"].positions[0] == pytest.approx(there, abs=0.01)
        assert there < 1.5


@pytest.mark.slow
async def test_tool_moves_in_the_frame_of_the_robot(inc1):
    async with inc1.control("arm"):
        tool = await inc1.arm.move_tool(position=(0.6, 0.0, 0.6), rpy=(0.0, 0.0, 0.0))
        assert (tool.x, tool.y, tool.z) == pytest.approx((0.6, 0.0, 0.6), abs=0.01)
        assert (tool.roll, tool.pitch, tool.yaw) == pytest.approx((0.0, 0.0, 0.0), abs=0.04)
        left = await inc1.arm.move_tool(position=(0.5, 0.3, 0.6))
        assert left.y == pytest.approx(0.3, abs=0.01)


@pytest.mark.slow
async def test_without_rpy_the_tool_takes_the_short_way(inc1):
    """And does not turn the arm over, through the chassis, for an attitude that is nearer by a part of a degree."""
    async with inc1.control("arm"):
        start = dict(zip((await inc1.arm.joints()).positions, (0.39, 1.6, -2.34, 0.74, 0.0), strict=True))
        await inc1.arm.move(start)  # the tool at 0.6, 0.2, 0.45
        before, begun = (await inc1.arm.joints()).positions, loop_time()
        tool = await inc1.arm.move_tool((0.70, 0.11, 0.62))
        after, seconds = (await inc1.arm.joints()).positions, loop_time() - begun
    assert (tool.x, tool.y, tool.z) == pytest.approx((0.70, 0.11, 0.62), abs=0.002)
    assert max(abs(after[name] - before[name]) for name in before) < 0.7
    assert seconds < 2.0, "the other way takes 4.6 s"


@pytest.mark.slow
async def test_an_arm_that_sags_beside_the_pose_does_not_wait_for_the_timeout(inc1, robot, monkeypatch):
    (arm,) = (each for each in robot.components if str(each.id) == "101.1.104")
    joints = arm.host.service(EndEffectorPoseDriver).arm.joints
    state = joints.state

    def sagging() -> JointState:
        there = state()
        return replace(there, positions=tuple(position - 0.004 for position in there.positions))

    monkeypatch.setattr(joints, "state", sagging)
    async with inc1.control("arm"):
        begun = loop_time()
        await inc1.arm.move_tool((0.60, 0.0, 0.60))
        assert loop_time() - begun < 10.0


@pytest.mark.slow
async def test_tool_out_of_reach_says_at_once_how_far_it_is(inc1):
    async with inc1.control("arm"):
        before, begun = (await inc1.arm.joints()).positions, loop_time()
        with pytest.raises(RequestError, match=r"out of reach: the tool gets no nearer than 3\.8\d m"):
            await inc1.arm.move_tool(position=(5.0, 0.0, 0.3))
        with pytest.raises(RequestError, match=r"only with another attitude, \d\d° from `rpy`"):
            await inc1.arm.move_tool(position=(0.5, 0.0, 0.6), rpy=(0.0, 0.0, 1.5))
        with pytest.raises(RequestError, match=rf"no nearer than 0\.\d\d m, with {SHOULDER} at its limit of -0\.5 rad"):
            await inc1.arm.move_tool(position=(0.95, 0.0, -0.6))
        assert (await inc1.arm.joints()).positions == before
        assert loop_time() - begun < 1.0
        with pytest.raises(ConfigError, match=r"in radians; `math.radians\(90\)`"):
            await inc1.arm.move_tool(position=(0.6, 0.0, 0.3), rpy=(0, 90, 0))


@pytest.mark.slow
@pytest.mark.parametrize("bad", [math.nan, math.inf])
async def test_tool_pose_that_is_no_place_is_refused_before_it_is_sent(inc1, bad):
    async with inc1.control("arm"):
        with pytest.raises(ConfigError, match=r"position is three finite numbers, as in \(0\.6, 0\.0, 0\.3\), not"):
            await inc1.arm.move_tool((bad, 0.0, 0.6))
        with pytest.raises(ConfigError, match="rpy is three finite numbers"):
            await inc1.arm.move_tool((0.6, 0.0, 0.6), rpy=(0.0, bad, 0.0))


@pytest.mark.slow
async def test_gripper_closes_with_a_force_and_opens(inc1):
    async with inc1.control("gripper"):
        closed = await inc1.gripper.close(force=20)
        opened = await inc1.gripper.open()
        assert closed[FINGER] < opened[FINGER]
        with pytest.raises(ConfigError, match=r"force 5000 is outside 0\.\.[\d.]+ N"):
            await inc1.gripper.close(force=5000)


async def test_control_takes_all_that_moves_and_releases_it(inc1, ocu, virtual_network):
    async with inc1.control() as control:
        assert [id.component for id in control.ids] == [102, 103, 104, 105]
        assert control.held
        async with virtual_network.ocu("42.1.9") as other:
            theirs = await other.robot(101)
            with pytest.raises(ControlRejected, match=r"101.1.10\d is held by 42.1.1"):
                async with theirs.control("drive", "arm", authority=1):
                    pass
    for component in (102, 103, 104, 105):
        assert "is nobody: take control first" in await ocu.explain(f"101.1.{component}")


@pytest.mark.slow
async def test_a_robot_that_went_to_standby_meanwhile_can_be_resumed(inc1, robot):
    """As after the link was lost for longer than its time-outs."""
    async with inc1.control("drive") as control:
        await inc1.service("mobility:LocalPoseSensor").standby()
        with pytest.raises(RequestError, match=r"is in Standby: resume first, with `resume\(\)` of"):
            await inc1.drive(linear=0.4)
        await control.resume()
        await inc1.drive(linear=0.4, seconds=1.0)
    assert robot.snapshot.pose.x > 0.2


async def test_unknown_part_is_named(inc1):
    with pytest.raises(ConfigError, match="no part 'legs'; parts are drive, arm, gripper"):
        inc1.control("legs")


async def test_robot_without_services_for_a_verb_says_so(ocu, virtual_network):
    async with virtual_network.component("7.1.1", []):
        bare = await ocu.robot(7)
        for verb in (bare.drive(0.1), bare.go_to(1, 1), bare.pose(), bare.joints()):
            with pytest.raises(ConfigError, match=r"does not offer|offers neither|offers no"):
                await verb
        with pytest.raises(ConfigError, match="has no arm: it does not offer"):
            _ = bare.arm
        with pytest.raises(ConfigError, match="has no gripper"):
            _ = bare.gripper
        with pytest.raises(ConfigError, match="nothing to control"):
            bare.control()


def test_time_stamp_is_of_the_closest_month():
    now = datetime(2026, 3, 1, 0, 0, 5, tzinfo=UTC)
    stamp = TimeStamp(milliseconds=500, seconds=59, minutes=59, hour=23, day=28)
    assert datetime_of(stamp, now) == datetime(2026, 2, 28, 23, 59, 59, 500_000, tzinfo=UTC)


async def test_robot_with_efforts_only_is_driven_in_metres_per_second(ocu, virtual_network):
    drive = FakeDrive(clock=loop_time)
    vehicle = Vehicle(drive, chassis=Chassis(max_speed=2.0, max_turn_rate=4.0))
    services = [AccessControl(timeout=5), PrimitiveDriver(vehicle), PlatformSpecifications(vehicle)]
    async with virtual_network.component("7.1.1", services):
        robot = await ocu.robot(7)
        async with robot.control("drive"):
            assert await robot.speed_limits() == pytest.approx((2.0, 4.0), abs=0.01)
            await robot.drive(linear=0.5, angular=1.0)
            report = await robot.service("PrimitiveDriver").query(QueryWrenchEffort())
            assert report.propulsive_linear_effort_x == pytest.approx(25.0, abs=0.2)
            assert report.propulsive_rotational_effort_z == pytest.approx(-25.0, abs=0.2)


async def test_robot_with_efforts_only_that_hides_its_speeds_says_so(ocu, virtual_network):
    vehicle = Vehicle(FakeDrive(clock=loop_time))
    async with virtual_network.component("7.1.1", [AccessControl(timeout=5), PrimitiveDriver(vehicle)]):
        robot = await ocu.robot(7)
        async with robot.control("drive"):
            with pytest.raises(ConfigError, match=r"percent.* does not report its greatest speeds"):
                await robot.drive(linear=0.5)
