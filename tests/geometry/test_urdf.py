"""Reading URDF."""

import math

import pytest

from jauspy.errors import ConfigError
from jauspy.geometry.urdf import JointKind, parse_urdf

LIMIT = '<limit lower="-1" upper="2" effort="30" velocity="0.5"/>'
TWO = f"""<robot name="two">
  <link name="base"/><link name="arm"/><link name="tool"/>
  <joint name="shoulder" type="revolute">
    <parent link="base"/><child link="arm"/><origin xyz="0.1 0 0.2" rpy="0 0 1.5"/><axis xyz="0 2 0"/>{LIMIT}
    <dynamics damping="3" friction="0.5"/>
  </joint>
  <joint name="flange" type="fixed"><parent link="arm"/><child link="tool"/></joint>
  <gazebo reference="tool"><mu1>0.9</mu1></gazebo>
</robot>"""


def test_joints_with_frames_limits_and_dynamics() -> None:
    description = parse_urdf(TWO)
    shoulder = description.joint("shoulder")
    assert (description.name, description.root(), description.friction) == ("two", "base", {"tool": 0.9})
    assert (shoulder.kind, shoulder.parent, shoulder.child) == (JointKind.REVOLUTE, "base", "arm")
    assert (shoulder.origin.x, shoulder.origin.z, shoulder.origin.yaw) == (0.1, 0.2, 1.5)
    assert shoulder.axis == (0.0, 1.0, 0.0)
    assert (shoulder.lower, shoulder.upper, shoulder.effort, shoulder.velocity) == (-1.0, 2.0, 30.0, 0.5)
    assert (shoulder.damping, shoulder.friction) == (3.0, 0.5)
    assert math.isclose(description.joint("flange").origin.x, 0.0)


def test_chain_from_base_to_tip() -> None:
    description = parse_urdf(TWO)
    assert [joint.name for joint in description.chain("base", "tool")] == ["shoulder", "flange"]
    with pytest.raises(ConfigError, match="no joints lead from link 'tool' to link 'base'"):
        description.chain("tool", "base")


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        ("</robot>", "", "not XML"),
        ("robot", "model", "begins with <model>"),
        (
            'type="revolute"',
            'type="ball"',
            "'shoulder' is 'ball'; jauspy supports: revolute, continuous, prismatic, fixed",
        ),
        (LIMIT, "", "'shoulder' has no <limit>"),
        ('<child link="tool"/>', "", "'flange' has no <child"),
        ('<child link="tool"/>', '<child link="tol"/>', "names the link 'tol'"),
        ('name="flange"', 'name="shoulder"', "name twice"),
        ('<axis xyz="0 2 0"/>', '<axis xyz="0 0 0"/>', "no direction"),
        ('<axis xyz="0 2 0"/>', '<axis xyz="0 2"/>', "'0 2' is not 3 finite numbers"),
        ('lower="-1"', 'lower="nan"', "'nan' is not 1 finite number"),
        ('<link name="tool"/>', '<link name="tool"/><link name="spare"/>', "one root link; it has: base, spare"),
    ],
)
def test_errors_name_the_joint(old: str, new: str, said: str) -> None:
    with pytest.raises(ConfigError, match=said):
        parse_urdf(TWO.replace(old, new))


def test_unknown_joint_lists_those_that_move() -> None:
    with pytest.raises(ConfigError, match="two has no joint 'elbow'; those that move are: shoulder"):
        parse_urdf(TWO).joint("elbow")


CONTINUOUS = TWO.replace('type="revolute"', 'type="continuous"')


@pytest.mark.parametrize("text", [CONTINUOUS, CONTINUOUS.replace(LIMIT, "")])
def test_continuous_joints_have_no_limits(text: str) -> None:
    shoulder = parse_urdf(text).joint("shoulder")
    assert (shoulder.lower, shoulder.upper, shoulder.turns) == (-math.inf, math.inf, True)
    assert (shoulder.effort, shoulder.velocity) == ((30.0, 0.5) if "<limit" in text else (0.0, 0.0))


def mimicking(*mimics: str) -> str:
    """A base with joints `j0`, `j1` ... that have these elements."""
    joints = "".join(
        f'<link name="l{n}"/><joint name="j{n}" type="revolute"><parent link="base"/><child link="l{n}"/>{LIMIT}{each}'
        "</joint>"
        for n, each in enumerate(mimics)
    )
    return f'<robot name="many"><link name="base"/>{joints}</robot>'


def test_mimics_of_mimics_follow_the_independent_joint() -> None:
    text = mimicking(
        '<mimic joint="j1" multiplier="2" offset="0.5"/>', '<mimic joint="j2" multiplier="-3" offset="1"/>', ""
    )
    j0, j1, j2 = parse_urdf(text).joints.values()
    assert (j0.mimics, j1.mimics, j2.mimics) == ("j2", "j2", None)
    assert (j1.position({"j2": 0.1}), j0.position({"j2": 0.1})) == pytest.approx((0.7, 1.9))
    assert j2.position({}) == 0.0


@pytest.mark.parametrize(
    ("mimics", "said"),
    [
        (['<mimic joint="j7"/>'], "'j0' mimics 'j7', which is not a moving joint"),
        (["<mimic/>"], "'j0' mimics '', which is not a moving joint"),
        (['<mimic joint="j1"/>', '<mimic joint="j0"/>'], "'j0' mimics itself"),
        (['<mimic joint="j1" multiplier="x"/>', ""], "'x' is not 1 finite number"),
    ],
)
def test_mimics_of_nothing_are_named(mimics: list[str], said: str) -> None:
    with pytest.raises(ConfigError, match=said):
        parse_urdf(mimicking(*mimics))
