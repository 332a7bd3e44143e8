"""No contact of the arm on its way to a pose, as the physics sees it."""

from __future__ import annotations

import itertools
import random

import pytest

pytest.importorskip("mujoco", reason="MuJoCo is not installed")

from tests.robot.workcell import Workcell

from jauspy.messages import iop, manipulator as m
from jauspy.platform.link_clearances import clearances_of
from jauspy.robot.robot_files import load, robot_model

INC1 = robot_model(load("inc1"))
ARM = INC1.groups["arm"].joints
POSES = {pose.name: pose.number for pose in INC1.poses}
FLIPPER_ANGLES = (2.2, pytest.param(0.785, marks=pytest.mark.slow), pytest.param(0.0, marks=pytest.mark.slow))
"""Radians: those of the poses."""
TOUR = (1, 2, 1, 3, 1, 4, 2, 3, 2, 4, 3, 4, 1)
"""Numbers of poses, each of which follows each other one once."""
BESIDE_A_FLIPPER = (2.381, 1.333, -2.272, 0.279, 1.237)


class WatchedArm(Workcell):
    """The arm in MuJoCo, and what it has touched: other links of the robot, and the ground."""

    def __init__(self, arm: tuple[float, ...] | None = None, flippers: float = 2.2) -> None:
        start = {"flippers": (flippers,)} | ({} if arm is None else {"arm": arm})
        super().__init__("sim", "inc1", 104, start=start)
        self.touched: set[tuple[str, ...]] = set()
        model = self.robot.model
        names = [model.body(number).name for number in range(model.nbody)]
        self._bodies = [names[body] for body in model.geom_bodyid.tolist()]
        below = {model.body("inc1/arm_link_1").id}
        for body in range(model.nbody):  # parents come first
            if model.body_parentid[body] in below:
                below.add(body)
        self._arm_bodies = {names[body] for body in below}
        self.take_control()

    def watch(self) -> None:
        contacts = self.robot.data.contact
        for (one, other), gap in zip(contacts.geom.tolist(), contacts.dist.tolist(), strict=True):
            bodies = self._bodies[one], self._bodies[other]
            if gap <= 0.0 and self._arm_bodies & set(bodies):
                self.touched.add(tuple(sorted(bodies)))

    def move_to(self, pose: int) -> int:
        """The status with which it ends."""
        kind, end = iop.ReportTransitionCompleted, self.now + 30.0
        reports = self.tell(iop.SetCurrentPose(1, pose))
        while not reports and self.now < end:
            self.run(0.02, self.watch)
            reports = [message for message in self.tell() if isinstance(message, kind)]
        (report,) = reports
        return int(report.transition_status)


@pytest.mark.slow
@pytest.mark.parametrize("flippers", FLIPPER_ANGLES)
def test_no_contact_between_any_two_poses(flippers: float) -> None:
    arm = WatchedArm(flippers=flippers)
    assert set(itertools.pairwise(TOUR)) == set(itertools.permutations(POSES.values(), 2))
    assert arm.move_to(TOUR[0]) == 0
    for start, end in itertools.pairwise(TOUR):
        assert arm.move_to(end) == 0
        assert arm.touched == set(), f"from pose {start} to {end}"


def start_positions(numbers: random.Random) -> tuple[tuple[float, ...], float]:
    """Positions of the arm, anywhere within its limits, and of the flippers, without contact."""
    clearances = clearances_of(INC1, ARM)
    joints = [INC1.description.joint(name) for name in ARM]
    while True:
        arm = tuple(numbers.uniform(joint.lower, joint.upper) for joint in joints)
        flippers = numbers.uniform(-0.1, 2.3)
        if not clearances.at({**dict(zip(ARM, arm, strict=True)), "base_link_to_flippers": flippers}, 0.02):
            return arm, flippers


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(20))
def test_no_contact_on_the_way_from_anywhere(seed: int) -> None:
    numbers = random.Random(seed)
    arm = WatchedArm(*start_positions(numbers))
    status = arm.move_to(numbers.choice(list(POSES.values())))
    assert status == 0
    assert arm.touched == set()


@pytest.mark.slow
def test_a_detour_avoids_what_the_direct_way_touches() -> None:
    """The physics agrees that the joints' own way, which JointPositionDriver takes, leads into a flipper."""
    arm = WatchedArm(BESIDE_A_FLIPPER, 1.65)
    assert arm.move_to(POSES["stow"]) == 0
    assert arm.touched == set()
    goal = arm.ask(m.QueryJointPositions()).joint_position_list
    direct = WatchedArm(BESIDE_A_FLIPPER, 1.65)
    direct.tell(m.SetJointPositions(goal))
    direct.run(6.0, direct.watch)
    assert ("inc1/left_flipper", "inc1/right_finger") in direct.touched
