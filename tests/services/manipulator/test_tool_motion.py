"""The tool on its line, with joints that do what they are told: how far off, how fast, and what happens at the ends."""

import math
from collections.abc import Callable
from dataclasses import dataclass, field

import pytest
from tests.helpers.sampling import sampled
from tests.services.manipulator.arms import arm_of

from jauspy.geometry.poses import rotation_vector
from jauspy.geometry.vectors import Vector, difference, dot, scaled
from jauspy.platform.joints import ControlMode, Target
from jauspy.services.manipulator.arm import Arm, MotionProfile
from jauspy.services.manipulator.tool_motion import ZERO, ToolMotion

PERIOD = 0.02
OUT_THERE = (0.4, 1.2, -0.9, 0.3, -0.5)
LIFTED = (0.3, 0.2, -0.7, 0.4)


@dataclass
class Run:
    """What was seen of a motion."""

    arm: Arm
    motion: ToolMotion = field(init=False)
    along: float = 0.0
    aside: float = 0.0
    speeds: list[float] = field(default_factory=list)
    rates: list[list[float]] = field(default_factory=list)

    def __post_init__(self) -> None:
        self.motion = ToolMotion(self.arm)

    def go(self, turning: Vector, moving: Vector, seconds: float, each: Callable[[], None] = lambda: None) -> None:
        start, length = self.arm.kinematic_state().tool.position, math.hypot(*moving) or 1.0
        for _ in range(round(seconds / PERIOD)):
            self.motion.follow(turning, moving)
            self.rates.append(list(self.motion.rates(PERIOD)))
            rows = zip(self.rates[-1], self.arm.profiles, strict=True)
            self.arm.joints.command(
                [Target(ControlMode.VELOCITY, rate, p.speed, p.acceleration, p.deceleration) for rate, p in rows]
            )
            for _ in range(5):
                self.arm.joints.step(PERIOD / 5)
            now = self.arm.kinematic_state()
            way = difference(now.tool.position, start)
            self.along = dot(way, moving) / length
            self.aside = max(self.aside, math.dist(way, scaled(moving, self.along / length)))
            self.speeds.append(dot(now.velocity(self.arm.state().velocities)[1], moving) / length)
            each()


LINES = [
    ("inc1", OUT_THERE, (-0.1, 0.0, 0.0)),
    ("inc1", OUT_THERE, (0.0, -0.08, 0.0)),
    ("inc1", OUT_THERE, (0.0, 0.0, -0.1)),
    ("inc1", OUT_THERE, (-0.05, 0.05, -0.05)),
    ("inc1_pprm", LIFTED, (0.0, -0.05, 0.0)),
    ("inc1_pprm", LIFTED, (0.0, 0.0, 0.06)),
    ("inc1_pprm", LIFTED, (-0.02, 0.03, 0.03)),
]


@pytest.mark.slow
@pytest.mark.parametrize(("robot", "start", "moving"), LINES)
def test_the_tool_moves_on_a_straight_line_at_the_commanded_velocity(robot: str, start, moving: Vector) -> None:
    run = Run(arm_of(robot, start))
    run.go(ZERO, moving, 2.0)
    speed = math.hypot(*moving)
    assert run.aside < 0.001
    assert 0.9 * 1.8 * speed < run.along < 2.0 * speed
    assert max(run.speeds) < 1.05 * speed
    assert run.speeds[-1] > 0.9 * speed


def test_reachable_attitude_is_kept() -> None:
    arm = arm_of("inc1", (0.0, 1.6, -1.8, 0.2, 0.0))  # it moves in its own plane
    before = arm.kinematic_state().tool.rotation
    Run(arm).go(ZERO, scaled(arm.kinematic_state().linear_jacobian[1], 0.1), 2.0)
    assert math.hypot(*rotation_vector(before, arm.kinematic_state().tool.rotation)) < 0.02


@pytest.mark.parametrize(("robot", "start", "joint"), [("inc1", OUT_THERE, 4), ("inc1_pprm", LIFTED, 3)])
def test_the_tool_turns_about_its_point(robot: str, start, joint: int) -> None:
    arm = arm_of(robot, start)
    before = arm.kinematic_state()
    turning = scaled(before.angular_jacobian[joint], 0.4)  # the last joint's axis leads through the tool point
    run = Run(arm)
    run.go(turning, ZERO, 2.0)
    turned = rotation_vector(before.tool.rotation, arm.kinematic_state().tool.rotation)
    assert turned == pytest.approx(scaled(turning, 2.0), abs=0.08)
    assert run.aside < 0.001


def test_velocity_above_joint_limits_is_scaled_on_the_same_line() -> None:
    run = Run(arm_of("inc1", OUT_THERE))
    run.go(ZERO, (-2.0, 0.0, -2.0), 0.6)
    assert run.aside < 0.004
    assert run.along > 0.1
    assert run.speeds[-1] < 1.0


def test_motion_profile_is_respected() -> None:
    arm = arm_of("inc1", OUT_THERE)
    arm.profiles = (MotionProfile(0.1, 0.3, 0.4),) * 5
    run = Run(arm)
    run.go(ZERO, (-0.3, 0.1, 0.0), 1.5)
    run.go(ZERO, ZERO, 1.0)
    assert max(abs(rate) for rates in run.rates for rate in rates) <= 0.1 + 1e-9
    changes = [abs(b - a) for x, y in zip(run.rates, run.rates[1:], strict=False) for a, b in zip(x, y, strict=True)]
    assert max(changes) <= 0.4 * PERIOD + 1e-9
    assert run.motion.is_finished


@pytest.mark.slow
@pytest.mark.parametrize(
    "moving", sampled([(0.1, 0.0, 0.0), (0.3, 0.2, 0.1), (0.0, 0.0, 0.1), (1.0, 0.0, 0.0)], fast=1)
)
def test_at_the_end_of_its_reach_the_tool_stops_on_its_line(moving: Vector) -> None:
    run = Run(arm_of("inc1", OUT_THERE))
    run.go(ZERO, moving, 8.0)
    assert run.aside < 0.005
    assert max(map(abs, run.speeds[-50:])) < 0.005
    assert max(abs(rate) for rates in run.rates[-50:] for rate in rates) < 0.05


@pytest.mark.parametrize("elbow", [0.0, 0.001, 0.01, 0.05, 0.1, -0.05])
def test_stretched_arm_can_be_retracted(elbow: float) -> None:
    run = Run(arm_of("inc1", (0.0, elbow / 2.0, -elbow, elbow / 2.0, 0.0)))
    run.go(ZERO, (-0.1, 0.0, 0.0), 2.0)
    assert run.along > 0.12
    assert run.aside < 0.004


def test_joint_at_its_limit_stops_the_tool_and_permits_the_way_back() -> None:
    arm = arm_of("inc1_pprm", LIFTED)
    run = Run(arm)
    run.go(ZERO, (0.0, 0.0, 0.1), 6.0)
    high = arm.joints.joints[0].upper
    assert arm.joints.state().positions[0] == pytest.approx(high, abs=0.002)
    assert run.speeds[-1] == pytest.approx(0.0, abs=0.001)
    run.go(ZERO, (0.0, 0.0, -0.1), 1.0)
    assert arm.joints.state().positions[0] < high - 0.08


@pytest.mark.slow
def test_limits_are_respected() -> None:
    arm = arm_of("inc1", OUT_THERE)

    def look() -> None:
        for position, (low, high) in zip(arm.state().positions, arm.limits, strict=True):
            assert low - 1e-9 <= position <= high + 1e-9

    run = Run(arm)
    for moving in ((0.0, 0.0, -0.5), (0.0, 0.6, 0.0), (-0.6, 0.0, 0.3), (0.0, -0.7, -0.2)):
        run.go(ZERO, moving, 2.0, look)
    run.go((0.8, -0.5, 0.9), (0.1, 0.0, 0.0), 3.0, look)
    assert all(map(math.isfinite, arm.state().positions))


def test_repeated_command_keeps_the_line() -> None:
    once, often = Run(arm_of("inc1", OUT_THERE)), Run(arm_of("inc1", OUT_THERE))
    once.go(ZERO, (-0.1, 0.05, 0.0), 1.0)
    for _ in range(10):
        often.go(ZERO, (-0.1, 0.05, 0.0), 0.1)
    assert often.arm.state() == once.arm.state()


ELBOW_UP = (0.0, -1.9, 2.1, -1.77, -math.pi / 2.0, 0.0)


def test_a_fast_tool_of_six_joints_keeps_its_line_and_its_attitude() -> None:
    arm = arm_of("cell", ELBOW_UP, "ur10")
    before = arm.kinematic_state().tool.rotation
    run = Run(arm)
    run.go(ZERO, (0.5, 0.5, -0.5), 0.4)
    assert max(run.speeds) > 0.8
    assert run.aside < 0.003
    assert math.hypot(*rotation_vector(before, arm.kinematic_state().tool.rotation)) < math.radians(0.5)
