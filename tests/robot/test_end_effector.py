"""CM-MAN brings its tool to poses and moves it along lines, on both robots and both backends, on virtual time."""

from __future__ import annotations

import math
import random
from collections.abc import Sequence
from dataclasses import replace
from importlib.util import find_spec

import pytest
from tests.helpers.sampling import sampled
from tests.robot.workcell import BACKENDS, OTHER, Workcell, outcomes

from jauspy.codec.message import Message
from jauspy.geometry.kinematics import forward_kinematics
from jauspy.geometry.poses import Transform, rotation_vector
from jauspy.geometry.vectors import Vector, quaternion, rotation_from_quaternion
from jauspy.messages import manipulator as m
from jauspy.messages.core import (
    ConfirmElementRequest,
    CreateCommandEvent,
    ElementRec,
    RejectElementRequest,
    ReleaseControl,
    Resume,
    SetElement,
    SetEmergency,
    Standby,
)
from jauspy.services.manipulator import Arm, EndEffectorVelocityStateDriver

MILLIMETRE, HALF_A_DEGREE = 0.001, math.radians(0.5)
STARTS = {"inc1": (0.4, 1.2, -0.9, 0.3, -0.5), "inc1_pprm": (0.3, 0.2, -0.7, 0.4)}
"""Where the arms have room, as their URDFs count."""
LINES = [
    ("inc1", (-0.05, 0.05, -0.05)),
    ("inc1", (0.0, -0.06, 0.0)),
    ("inc1_pprm", (-0.02, 0.03, 0.03)),
    ("inc1_pprm", (0.0, -0.05, 0.0)),
]
"""And metres per second that lead into it."""
NOWHERE = m.SetEndEffectorPose(5.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0)


class Handler(Workcell):
    """A robot's arm, and where its tool is."""

    def __init__(self, backend: str, robot: str) -> None:
        super().__init__(backend, robot, 104)
        self.take_control()
        self.arm = Arm(self.robot.groups["arm"])

    def to(self, native: Sequence[float]) -> None:
        make, choice = m.JointPositionRec.JointPosition, m.JointPositionRec.JointPositionChoice
        rows = zip(self.arm.geometry.from_urdf(native), self.arm.geometry.links, strict=True)
        kinds = [(value, choice.RADIAN if link.is_revolute else choice.METER) for value, link in rows]
        self.tell(m.SetJointPositions([m.JointPositionRec(make(kind, value)) for value, kind in kinds]))
        self.run(5.0)

    def pose(self) -> Transform:
        return transform(self.ask(m.QueryEndEffectorPose()))

    def commanded(self) -> Transform:
        return transform(self.ask(m.QueryCommandedEndEffectorPose()))

    def pose_at(self, native: Sequence[float]) -> Transform:
        return forward_kinematics(self.arm.geometry.links, self.arm.geometry.from_urdf(native), self.arm.tool).tool

    def random_pose(self, rng: random.Random) -> Transform:
        """A pose reached without touching robot or ground: at least 0.45 m above it, in front, beside the mast."""
        while True:
            positions = [rng.uniform(0.9 * low + 0.1 * high, 0.1 * low + 0.9 * high) for low, high in self.arm.limits]
            tool = forward_kinematics(self.arm.geometry.links, positions, self.arm.tool).tool
            x, y, z = (self.arm.geometry.base @ tool).position
            if x > 0.35 and abs(y) > 0.2 and z > 0.45:
                return tool


def transform(msg) -> Transform:
    x, y, z, *parts = (getattr(msg, name) for name in msg.__dataclass_fields__)
    return Transform(rotation_from_quaternion(*parts), (x, y, z))


def command(goal: Transform) -> m.SetEndEffectorPose:
    return m.SetEndEffectorPose(*goal.position, *quaternion(goal.rotation))


def moving(*values: float) -> m.SetEndEffectorVelocityState:
    """Angular, then linear."""
    return m.SetEndEffectorVelocityState(*values)


def errors(there: Transform, goal: Transform) -> tuple[float, float]:
    return math.dist(there.position, goal.position), math.hypot(*rotation_vector(there.rotation, goal.rotation))


@pytest.fixture(params=BACKENDS)
def backend(request: pytest.FixtureRequest) -> str:
    return request.param


@pytest.fixture
def arm(backend: str) -> Handler:
    handler = Handler(backend, "inc1")
    handler.to(STARTS["inc1"])
    return handler


# --- poses


@pytest.mark.slow
@pytest.mark.parametrize("robot", sampled([*STARTS], 1))
def test_tool_reaches_commanded_poses(backend: str, robot: str) -> None:
    arm, rng = Handler(backend, robot), random.Random(7)
    ends: list[int] = []
    for number in range(3):
        goal = arm.random_pose(rng)
        assert outcomes(arm, CreateCommandEvent(1, 60, command(goal))) == []
        arm.run(9.0, lambda: ends.extend(outcomes(arm)))
        assert ends == [0] * (number + 1)
        distance, turn = errors(arm.pose(), goal)
        assert distance < MILLIMETRE
        assert turn < HALF_A_DEGREE
        assert errors(arm.commanded(), goal) == pytest.approx((0.0, 0.0), abs=1e-6)


@pytest.mark.slow
@pytest.mark.skipif(find_spec("mujoco") is None, reason="MuJoCo is not installed")
@pytest.mark.parametrize("robot", sampled([*STARTS], 1))
def test_simulated_tool_reaches_the_commanded_pose(robot: str) -> None:
    arm = Handler("sim", robot)
    goal = arm.random_pose(random.Random(11))
    arm.tell(command(goal))
    arm.run(9.0)
    data = arm.robot.data
    base, tool = data.body(f"{robot}/base_link"), data.body(f"{robot}/tool_link")
    seen = (tool.xpos - base.xpos) @ base.xmat.reshape(3, 3)
    assert math.dist(seen, (arm.arm.geometry.base @ goal).position) < 1.5 * MILLIMETRE


@pytest.mark.slow
def test_joints_respect_the_motion_profile(arm: Handler) -> None:
    record = m.SetJointMotionProfile.RevoluteJointMotionProfileRec
    arm.tell(m.SetJointMotionProfile([record(0.2, 1.0, 1.0)] * 5))
    arm.tell(command(arm.pose_at((0.0, 1.6, -1.5, 0.2, 0.0))))
    fastest = [0.0]
    arm.run(2.0, lambda: fastest.append(max(map(abs, arm.velocities()))))
    assert 0.15 < max(fastest) < 0.25


@pytest.mark.slow
def test_tool_offset_is_applied(arm: Handler) -> None:
    before = arm.pose()
    x, y, z = arm.arm.tool
    arm.tell(m.SetToolOffset(x + 0.05, y, z))
    arm.tell(command(before))
    arm.run(8.0)
    distance, _ = errors(arm.pose(), before)
    assert distance < MILLIMETRE
    assert math.dist(arm.arm.kinematic_state().tool.position, before.position) == pytest.approx(0.05, abs=0.002)


@pytest.mark.slow
def test_pose_out_of_reach_is_counted_and_the_arm_holds(arm: Handler) -> None:
    before = arm.positions()
    ends: list[int] = outcomes(arm, CreateCommandEvent(1, 60, NOWHERE))
    arm.run(2.0, lambda: ends.extend(outcomes(arm)))
    assert ends == [1]
    assert arm.host.counters["out_of_reach"] == 1
    assert arm.positions() == pytest.approx(before, abs=0.003)
    assert errors(arm.commanded(), arm.pose()) == pytest.approx((0.0, 0.0), abs=1e-3)


@pytest.mark.slow
def test_zero_quaternion_is_ignored_and_counted(arm: Handler) -> None:
    goal = arm.pose_at((0.2, 1.3, -1.0, 0.2, -0.3))
    arm.tell(command(goal))
    zero = replace(command(arm.pose()), **dict.fromkeys(list(NOWHERE.__dataclass_fields__)[3:], 0.0))
    assert outcomes(arm, CreateCommandEvent(1, 60, zero)) == [1]
    assert arm.host.counters["no_attitude"] == 1
    arm.run(8.0)
    distance, _ = errors(arm.pose(), goal)
    assert distance < MILLIMETRE, "the command before still holds"


@pytest.mark.slow
def test_unreachable_attitude_fails_but_the_point_is_reached(arm: Handler) -> None:
    goal = replace(arm.pose(), rotation=arm.pose_at((-0.4, 1.2, -0.9, 0.3, 0.9)).rotation)
    ends: list[int] = outcomes(arm, CreateCommandEvent(1, 60, command(goal)))
    arm.run(12.0, lambda: ends.extend(outcomes(arm)))
    assert ends == [1]
    distance, turn = errors(arm.pose(), goal)
    assert distance < MILLIMETRE
    assert turn > HALF_A_DEGREE


@pytest.mark.slow
def test_command_event_fails_when_the_pose_is_abandoned(arm: Handler) -> None:
    goals = [command(arm.pose_at((turn, 1.3, -1.0, 0.2, -0.3))) for turn in (-1.0, 1.0)]
    assert outcomes(arm, CreateCommandEvent(1, 60, goals[0])) == []
    arm.run(0.3)
    assert outcomes(arm, goals[1]) == [1], "another pose"
    assert outcomes(arm, CreateCommandEvent(1, 60, goals[0])) == []
    assert outcomes(arm, moving(0.0, 0.0, 0.0, 0.01, 0.0, 0.0)) == [1], "another service"
    assert outcomes(arm, CreateCommandEvent(1, 60, goals[0]), Standby()) == [1]


@pytest.mark.slow
@pytest.mark.parametrize("stop", sampled([Standby(), ReleaseControl(), SetEmergency(1)], 1))
@pytest.mark.parametrize("what", ["pose", "velocity", "search"])
def test_stops_within_200_ms(arm: Handler, stop: Message, what: str) -> None:
    far = arm.pose_at((-1.5, 1.3, -1.0, 0.2, -0.3))
    commands = {"pose": command(far), "velocity": moving(0.0, 0.0, 0.0, -0.2, 0.2, 0.0), "search": NOWHERE}
    arm.tell(commands[what])
    if what != "search":
        arm.run(0.5)
        assert max(map(abs, arm.velocities())) > 0.2
    arm.tell(stop)
    arm.run(0.2)
    assert arm.velocities() == pytest.approx([0.0] * 5, abs=0.03)
    before = arm.positions()
    arm.run(1.0)
    assert arm.positions() == pytest.approx(before, abs=0.004)
    assert arm.host.counters["out_of_reach"] == 0, "nobody goes on searching"


@pytest.mark.slow
def test_does_not_move_without_control(arm: Handler) -> None:
    before = arm.positions()
    arm.tell(command(arm.pose_at((0.0, 1.6, -1.5, 0.2, 0.0))), moving(0.0, 0.0, 0.0, -0.2, 0.0, 0.0), client=OTHER)
    arm.run(0.5)
    assert arm.positions() == pytest.approx(before, abs=0.003)


@pytest.mark.slow
def test_rapid_poses_are_followed_before_searches_end(arm: Handler) -> None:
    attitude = arm.pose_at((-0.4, 1.2, -0.9, 0.3, 0.9)).rotation  # which the arm cannot have: a long search for each
    x, y, z = arm.pose().position
    for number in range(1, 51):
        arm.tell(command(Transform(attitude, (x - 0.002 * number, y, z))))
        arm.run(0.03)
    assert arm.pose().position[0] < x - 0.05
    arm.run(6.0)
    assert arm.pose().position == pytest.approx((x - 0.1, y, z), abs=0.002)


# --- lists


def element(uid: int, following: int, pose: Message) -> ElementRec:
    return ElementRec(uid, uid - 1, following, ElementRec.ElementData(format=0, data=pose))


@pytest.mark.slow
def test_list_of_poses_is_executed(arm: Handler) -> None:
    goals = [arm.pose_at(q) for q in ((0.2, 1.3, -1.0, 0.2, -0.3), (0.3, 1.1, -0.8, 0.0, 0.0), STARTS["inc1"])]
    rows = [element(uid, (uid + 1) % 4, command(goal)) for uid, goal in enumerate(goals, 1)]
    assert arm.tell(SetElement(SetElement.RequestIDRec(7), rows)) == [ConfirmElementRequest(7)]
    assert errors(arm.commanded(), arm.pose()) == pytest.approx((0.0, 0.0), abs=1e-3)
    ends: list[int] = outcomes(arm, CreateCommandEvent(1, 100, m.ExecuteList(element_uid=1)))
    seen, heading = [], []

    def look() -> None:
        ends.extend(outcomes(arm))
        seen.append(arm.ask(m.QueryActiveElement()).element_uid)
        if seen[-1]:
            heading.append(errors(arm.commanded(), goals[seen[-1] - 1])[0])

    arm.run(20.0, look)
    assert list(dict.fromkeys(seen)) == [1, 2, 3, 0]
    assert max(heading) < 1e-6
    assert ends == [0]
    assert errors(arm.pose(), goals[-1])[0] < 3 * MILLIMETRE


@pytest.mark.slow
def test_pose_out_of_reach_ends_the_list(arm: Handler) -> None:
    rows = [element(1, 2, NOWHERE), element(2, 0, command(arm.pose_at((0.2, 1.3, -1.0, 0.2, -0.3))))]
    before = arm.positions()
    arm.tell(SetElement(SetElement.RequestIDRec(7), rows))
    ends: list[int] = outcomes(arm, CreateCommandEvent(1, 100, m.ExecuteList(element_uid=1)))
    arm.run(3.0, lambda: ends.extend(outcomes(arm)))
    assert ends == [1]
    assert arm.ask(m.QueryActiveElement()).element_uid == 0
    assert arm.positions() == pytest.approx(before, abs=0.003)
    assert arm.host.counters["out_of_reach"] == 1


@pytest.mark.slow
def test_element_with_zero_quaternion_is_rejected(arm: Handler) -> None:
    rows = [element(1, 0, m.SetEndEffectorPose(0.3, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0))]
    (answer,) = arm.tell(SetElement(SetElement.RequestIDRec(7), rows))
    assert isinstance(answer, RejectElementRequest)


# --- velocities


@pytest.mark.slow
@pytest.mark.parametrize(("robot", "way"), sampled(LINES, 2, several=True))
def test_the_tool_moves_along_a_straight_line_and_stops(backend: str, robot: str, way: Vector) -> None:
    arm = Handler(backend, robot)
    arm.to(STARTS[robot])
    start, aside = arm.pose().position, [0.0]
    speed = math.hypot(*way)

    def look() -> None:
        offset = [a - b for a, b in zip(arm.pose().position, start, strict=True)]
        along = sum(a * b for a, b in zip(offset, way, strict=True)) / speed
        aside.append(math.dist(offset, [along * part / speed for part in way]))

    arm.tell(moving(0.0, 0.0, 0.0, *way))
    arm.run(2.0, look)
    assert max(aside) < 0.003
    assert math.dist(arm.pose().position, start) == pytest.approx(2.0 * speed, rel=0.1)
    state = arm.ask(m.QueryEndEffectorVelocityState())
    seen = (state.linear_velocity_component_x, state.linear_velocity_component_y, state.linear_velocity_component_z)
    assert seen == pytest.approx(way, abs=0.01)
    arm.tell(moving(*[0.0] * 6))
    arm.run(0.5)
    assert arm.velocities() == pytest.approx([0.0] * len(STARTS[robot]), abs=0.02)
    driver = arm.host.service(EndEffectorVelocityStateDriver)
    assert driver is not None
    assert not driver.is_moving, "the joints just hold"


@pytest.mark.slow
def test_repeated_commands_respect_the_motion_profile(arm: Handler) -> None:
    record = m.SetJointMotionProfile.RevoluteJointMotionProfileRec
    arm.tell(m.SetJointMotionProfile([record(0.4, 0.2, 0.2)] * 5))
    for _ in range(50):
        for _ in range(5):
            arm.tell(moving(0.0, 0.0, 0.0, -0.3, 0.0, 0.0))
        arm.run(0.01)
    assert max(map(abs, arm.velocities())) < 0.2 * 0.5 + 0.02, "what half a second of acceleration gives"


@pytest.mark.slow
def test_velocity_is_reported_until_another_service_commands(arm: Handler) -> None:
    def commanded() -> list[float]:
        report = arm.ask(m.QueryCommandedEndEffectorVelocityState())
        return [getattr(report, name) for name in report.__dataclass_fields__]

    wanted = [0.1, 0.0, -0.2, 0.05, 0.02, 0.0]
    arm.tell(moving(*wanted))
    arm.run(0.3)
    assert commanded() == pytest.approx(wanted, abs=1e-6)
    arm.tell(command(arm.pose_at((0.2, 1.3, -1.0, 0.2, -0.3))))
    assert commanded() == pytest.approx([0.0] * 6, abs=1e-6)
    arm.run(8.0)
    assert errors(arm.pose(), arm.commanded())[0] < MILLIMETRE


@pytest.mark.slow
def test_velocities_stay_within_limits(arm: Handler) -> None:
    def look() -> None:
        rows = zip(arm.robot.groups["arm"].state().positions, arm.robot.groups["arm"].joints, strict=True)
        assert all(joint.lower - 0.02 <= position <= joint.upper + 0.02 for position, joint in rows)

    for way in ((0.0, 0.0, 1.0), (0.0, 1.0, 0.0), (-1.0, 0.0, 0.0)):
        arm.tell(moving(0.0, 0.5, 0.0, *way))
        arm.run(2.0, look)
    assert all(map(math.isfinite, arm.positions()))


@pytest.mark.slow
def test_the_same_commands_give_the_same_trajectory(backend: str) -> None:
    def trajectory() -> list[tuple[float, ...]]:
        arm, seen = Handler(backend, "inc1"), []
        for message in (command(arm.pose_at((0.2, 1.3, -1.0, 0.2, -0.3))), moving(0.1, 0.0, 0.0, -0.1, 0.1, 0.0)):
            arm.tell(message)
            arm.run(1.0, lambda: seen.append(arm.robot.groups["arm"].state().positions))
        return seen

    assert trajectory() == trajectory()


@pytest.mark.slow
def test_resume_does_not_continue_a_motion(arm: Handler) -> None:
    arm.tell(moving(0.0, 0.0, 0.0, -0.1, 0.0, 0.0))
    arm.run(0.3)
    arm.tell(Standby(), Resume())
    arm.run(0.3)
    before = arm.positions()
    arm.run(0.5)
    assert arm.positions() == pytest.approx(before, abs=0.003)
