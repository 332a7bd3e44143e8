"""inc1 never touches itself, however it is teleoperated, while the guard against self collision is on; by MuJoCo."""

from __future__ import annotations

import dataclasses
import re
from collections.abc import Iterator
from typing import Final

import pytest

pytest.importorskip("mujoco", reason="MuJoCo is not installed")

import numpy as np
from tests.helpers.self_contacts import ContactJudge

from jauspy.platform.description import SelfCollisionSetup
from jauspy.platform.guarded_robot import GuardedRobot
from jauspy.platform.guards import GuardState, SelfCollisionGuard
from jauspy.platform.joints import ControlMode, JointGroup, Target
from jauspy.robot.robot_files import load, robot_model
from jauspy.services.manipulator.arm import Arm
from jauspy.services.manipulator.tool_motion import ToolMotion
from jauspy_sim.robot import SimulatedRobot

INC1 = dataclasses.replace(robot_model(load("inc1")), cameras=(), lidars=(), force_torque=())
STEP, TOOL_PERIOD = 0.002, 0.02
GROUPS = ("arm", "flippers", "gripper", "pan_tilt")
RUN = 6.0
"""Seconds of one run."""
SEEDS = (1, 2, 3)
"""Runs of which at least two touch the robot without the guard."""


class Teleoperation:
    """One robot, operated in a random mode for a random time, then in another one, for each group of its joints."""

    def __init__(self, seed: int, *, enabled: bool) -> None:
        model = dataclasses.replace(INC1, self_collision=SelfCollisionSetup(enabled=enabled))
        self.sim = SimulatedRobot.open(model, "empty")
        self.robot = GuardedRobot(self.sim, model)
        self.judge = ContactJudge(self.sim, INC1.description.name)
        self._rng = np.random.default_rng(seed)
        self._due = dict.fromkeys(GROUPS, 0.0)
        self._arm = Arm(self.robot.groups["arm"])
        self._tool: ToolMotion | None = None
        self._twist = (0.0, 0.0, 0.0), (0.0, 0.0, 0.0)

    @property
    def guard(self) -> GuardState:
        guard = SelfCollisionGuard.of(self.robot)
        assert guard is not None
        return guard.state()

    def run(self, seconds: float) -> set[frozenset[str]]:
        """The pairs of links that touched each other."""
        found: set[frozenset[str]] = set()
        for number in range(round(seconds / STEP)):
            for name in GROUPS:
                if self.sim.time >= self._due[name]:
                    self._due[name] = self.sim.time + self._rng.uniform(0.3, 2.0)
                    self._command(name, self.robot.groups[name])
            if self._tool is not None and number % round(TOOL_PERIOD / STEP) == 0:
                self._tool.follow(*self._twist)
                rates = self._tool.rates(TOOL_PERIOD)
                self.robot.groups["arm"].command([Target(ControlMode.VELOCITY, rate) for rate in rates])
            self.robot.advance(STEP)
            found |= self.judge.within()
        self.sim.close()
        return found

    def _command(self, name: str, group: JointGroup) -> None:
        rng, joints = self._rng, group.joints
        modes = ["position", "velocity", "effort", "hold"] + ["tool", "raw effort"] * (name == "arm")
        mode = rng.choice(modes)
        if name == "arm":
            self._tool = None
        if mode == "position":
            speed = rng.uniform(0.2, 1.0)
            group.command(
                [
                    Target(ControlMode.POSITION, rng.uniform(joint.lower, joint.upper), speed=speed * joint.velocity)
                    for joint in joints
                ]
            )
        elif mode == "velocity":
            group.command([Target(ControlMode.VELOCITY, joint.velocity * rng.uniform(-1.0, 1.0)) for joint in joints])
        elif mode == "hold":
            group.hold()
        elif mode == "tool":
            self._tool = ToolMotion(self._arm)
            angular, linear = rng.uniform(-0.5, 0.5, 3).tolist(), rng.uniform(-0.4, 0.4, 3).tolist()
            self._twist = (angular[0], angular[1], angular[2]), (linear[0], linear[1], linear[2])
        else:
            share = rng.uniform(-1.0, 1.0, len(joints)).tolist()
            is_raw = mode == "raw effort"
            rows = zip(joints, share, strict=True)
            group.command([Target(ControlMode.EFFORT, s * joint.effort, compensated=not is_raw) for joint, s in rows])


@pytest.mark.slow
def test_random_teleoperations_end_without_a_self_contact() -> None:
    touched = {seed: Teleoperation(seed, enabled=True).run(RUN) for seed in SEEDS}
    assert not any(touched.values()), {seed: pairs for seed, pairs in touched.items() if pairs}


@pytest.mark.slow
@pytest.mark.long
@pytest.mark.parametrize("first", range(0, 500, 25))
def test_many_random_teleoperations_end_without_a_self_contact(first: int) -> None:
    touched = {seed: Teleoperation(seed, enabled=True).run(RUN) for seed in range(first, first + 25)}
    assert not any(touched.values()), {seed: pairs for seed, pairs in touched.items() if pairs}


@pytest.mark.slow
def test_the_same_teleoperations_touch_without_the_guard() -> None:
    touched = [Teleoperation(seed, enabled=False).run(RUN) for seed in SEEDS]
    assert sum(bool(pairs) for pairs in touched) >= 2


def moved(seconds: float, target: Target, *, name: str = "arm", joint: int = 1, enabled: bool = True) -> Teleoperation:
    """The robot after a command to one joint; the others hold."""
    run = Teleoperation(0, enabled=enabled)
    group = run.robot.groups[name]
    for _ in range(round(seconds / STEP)):
        if run.sim.time < STEP:
            group.command([target if number == joint else None for number in range(len(group.joints))])
        run.robot.advance(STEP)
        assert not run.judge.within() or not enabled
    return run


WRIST: Final = 3
BENT = (
    pytest.param(Target(ControlMode.POSITION, -2.1), id="position"),
    pytest.param(Target(ControlMode.VELOCITY, -1.0), id="velocity"),
    pytest.param(Target(ControlMode.EFFORT, -15.0, compensated=True), id="effort"),
    pytest.param(Target(ControlMode.EFFORT, -20.0), id="force of the actuator"),
)
"""The wrist of the folded arm bends until the gripper meets the turret."""


@pytest.fixture
def closed() -> Iterator[list[SimulatedRobot]]:
    robots: list[SimulatedRobot] = []
    yield robots
    for robot in robots:
        robot.close()


@pytest.mark.slow
@pytest.mark.parametrize("target", BENT)
def test_a_joint_stops_before_the_contact_and_tells_the_distance(target: Target, closed: list[SimulatedRobot]) -> None:
    free = moved(4.0, target, joint=WRIST, enabled=False)
    closed.append(free.sim)
    assert free.judge.within(), "without the guard it touches"
    run = moved(4.0, target, joint=WRIST)
    closed.append(run.sim)
    state = run.guard
    assert state.active
    found = re.search(r"^arm: (\w+) is (\d+) mm from (\w+): it stops before they touch", state.problem)
    assert found is not None, state
    stated, measured = int(found[2]) / 1000.0, run.judge.distance(found[1], found[3])
    assert 0.004 <= stated <= (0.06 if target.mode is ControlMode.EFFORT else 0.015)
    assert stated - 0.001 <= measured <= stated + 0.03, (
        "never nearer than stated; boxes are larger than what is in them"
    )
    assert abs(run.robot.groups["arm"].state().velocities[WRIST]) < 0.01


@pytest.mark.slow
def test_it_may_move_away_after_a_stop(closed: list[SimulatedRobot]) -> None:
    run = moved(4.0, Target(ControlMode.VELOCITY, -1.0), joint=WRIST)
    closed.append(run.sim)
    before = run.robot.groups["arm"].state().positions[WRIST]
    run.robot.groups["arm"].command([None, None, None, Target(ControlMode.VELOCITY, 0.5), None])
    for _ in range(500):
        run.robot.advance(STEP)
    assert run.robot.groups["arm"].state().positions[WRIST] > before + 0.3
    assert not run.guard.problem
    assert not run.guard.active


@pytest.mark.slow
def test_a_motion_that_comes_near_nothing_is_the_same_with_and_without_the_guard(
    closed: list[SimulatedRobot],
) -> None:
    ends = []
    for enabled in (False, True):
        run = moved(2.0, Target(ControlMode.POSITION, 2.4), joint=1, enabled=enabled)
        closed.append(run.sim)
        ends.append(run.robot.groups["arm"].state().positions)
    assert ends[0] == pytest.approx(ends[1], abs=1e-6)


@pytest.mark.slow
def test_switching_it_off_lets_the_command_go_on(closed: list[SimulatedRobot]) -> None:
    run = moved(4.0, Target(ControlMode.VELOCITY, -1.0), joint=WRIST)
    closed.append(run.sim)
    guard = SelfCollisionGuard.of(run.robot)
    assert guard is not None
    guard.enable(False)
    for _ in range(1000):
        run.robot.advance(STEP)
    assert run.judge.within()
    assert guard.state() == GuardState(enabled=False)


def test_a_hold_passes_at_once(closed: list[SimulatedRobot]) -> None:
    run = moved(0.5, Target(ControlMode.VELOCITY, 0.8), joint=1)
    closed.append(run.sim)
    run.robot.groups["arm"].hold()
    run.robot.advance(0.2)
    assert max(map(abs, run.robot.groups["arm"].state().velocities)) < 0.02
    assert run.guard == GuardState(enabled=True, distance=run.guard.distance)
