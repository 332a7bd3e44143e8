"""A turret that turns without end, and a joint that mimics another one, on each backend."""

from __future__ import annotations

import math
from pathlib import Path

import pytest
from tests.robot.workcell import Workcell

from jauspy.errors import ConfigError
from jauspy.geometry.frames import FrameTree
from jauspy.geometry.vectors import X
from jauspy.messages import manipulator as m
from jauspy.messages.description import QueryJointDescription, ReportJointDescription
from jauspy.platform.joints import joint_positions
from jauspy.robot import robot_files
from jauspy.services.manipulator.joints import percent_records

CRANE = str(Path(__file__).parents[1] / "helpers" / "robots" / "crane.toml")
FOUR_TURNS = 8.0 * math.pi


@pytest.fixture(params=["kinematic", "sim"])
def crane(request: pytest.FixtureRequest) -> Workcell:
    if request.param == "sim":
        pytest.importorskip("mujoco", reason="MuJoCo is not installed")
    cell = Workcell(request.param, CRANE, 1)
    cell.take_control()
    return cell


def slew_and_luff(slew: float, luff: float) -> m.SetJointPositions:
    make, choice = m.JointPositionRec.JointPosition, m.JointPositionRec.JointPositionChoice
    return m.SetJointPositions([m.JointPositionRec(make(choice.RADIAN, value)) for value in (slew, luff)])


def spin(speed: float) -> m.SetJointVelocity:
    make, choice = m.JointVelocityRec.JointVelocity, m.JointVelocityRec.JointVelocityChoice
    return m.SetJointVelocity([m.JointVelocityRec(make(choice.RADIAN_PER_SECOND, value)) for value in (speed, 0.0)])


def test_a_continuous_joint_turns_more_than_once(crane: Workcell) -> None:
    zero = crane.positions()[0]
    crane.tell(slew_and_luff(zero + 9.0, crane.positions()[1]))
    crane.run(4.0)
    assert crane.positions()[0] - zero == pytest.approx(9.0, abs=0.01)


def test_beyond_four_turns_it_is_reported_within_the_field(crane: Workcell) -> None:
    crane.robot.advance(0.01)
    for _ in range(8):
        crane.tell(spin(3.0))
        crane.run(1.9)
    crane.tell(spin(0.0))
    crane.run(0.5)
    turned = crane.robot.groups["arm"].state().positions[0]
    assert turned > FOUR_TURNS + 5.0
    reported = crane.positions()[0]
    assert -FOUR_TURNS <= reported <= FOUR_TURNS
    crane.tell(slew_and_luff(reported - 0.5, crane.positions()[1]))
    crane.run(2.0)
    assert crane.robot.groups["arm"].state().positions[0] == pytest.approx(turned - 0.5, abs=0.02), "the short way"


def test_its_limits_are_left_out(crane: Workcell) -> None:
    assert crane.robot.groups["arm"].joints[0].upper == math.inf
    slew, luff = crane.ask(QueryJointDescription()).joint_list
    types = ReportJointDescription.JointType
    assert (slew.joint_type, luff.joint_type) == (types.CONTINUOUS, types.REVOLUTE)
    assert slew.upper_limit == pytest.approx(FOUR_TURNS)


def test_a_mimicking_joint_follows(crane: Workcell) -> None:
    tree = FrameTree(crane.model.description)
    crane.tell(slew_and_luff(*(p + change for p, change in zip(crane.positions(), (0.0, 0.5), strict=True))))
    crane.run(3.0)
    positions = joint_positions(crane.robot.groups.values())
    assert positions["luff"] == pytest.approx(0.9, abs=0.01)
    assert tree.pose("tray", positions).rotate(X)[2] == pytest.approx(math.sin(0.1)), "the boom's angle cancels out"
    if crane.backend == "sim":
        level = crane.robot.data.joint("crane/level").qpos[0]
        assert level == pytest.approx(-positions["luff"] + 0.1, abs=0.02)


def test_its_motor_carries_what_mimics_it(crane: Workcell) -> None:
    before = crane.positions()
    crane.run(2.0)
    assert crane.positions() == pytest.approx(before, abs=0.003)


def test_services_that_need_a_chain_of_independent_joints_are_not_there(crane: Workcell) -> None:
    offered = {service.urn.rpartition(":")[2] for service in crane.host.services}
    assert "ManipulatorJointPositionDriver" in offered
    assert not {"ManipulatorSpecificationService", "ManipulatorEndEffectorPoseDriver"} & offered


def test_efforts_have_one_value_for_each_independent_joint(crane: Workcell) -> None:
    crane.tell(m.SetJointEffort(percent_records([10.0, 0.0])))
    crane.run(1.0)
    assert crane.robot.groups["arm"].state().positions[0] > 0.05


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        ('name = "luff"', 'name = "level"', "'level' mimics 'luff', and follows it without a command"),
        ('tip = "tray"', 'tip = "turret"', "from base to turret that move are, in order: slew"),
    ],
)
def test_groups_have_independent_joints(tmp_path: Path, old: str, new: str, said: str) -> None:
    source = Path(CRANE)
    text = source.read_text().replace('"crane.urdf"', f'"{source.with_suffix(".urdf")}"')
    (tmp_path / "own.toml").write_text(text.replace(old, new))
    with pytest.raises(ConfigError, match=said):
        robot_files.robot_model(robot_files.load(tmp_path / "own.toml"))
