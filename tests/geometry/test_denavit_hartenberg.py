"""Geometry in the standard's terms against the chain of joints that it was made from."""

import random

import pytest

from jauspy.geometry.denavit_hartenberg import manipulator_geometry
from jauspy.geometry.poses import Pose, Transform
from jauspy.geometry.urdf import Joint, JointKind
from jauspy.geometry.vectors import Vector, rotation_about, scaled
from jauspy.robot.robot_files import load, robot_model


def tool_point(chain: tuple[Joint, ...], positions: list[float]) -> Vector:
    """Forward kinematics as URDF defines it."""
    values = iter(positions)
    frame = Transform()
    for joint in chain:
        frame = frame @ Transform.from_pose(joint.origin)
        if joint.kind is JointKind.REVOLUTE:
            frame = frame @ Transform(rotation_about(joint.axis, next(values)))
        elif joint.kind is JointKind.PRISMATIC:
            frame = frame @ Transform(position=scaled(joint.axis, next(values)))
    return frame.position


def random_chain(rng: random.Random) -> tuple[Joint, ...]:
    def joint(number: int) -> Joint:
        kind = rng.choice((JointKind.REVOLUTE, JointKind.PRISMATIC, JointKind.FIXED))
        right = [0.0, 1.5707963267948966, -1.5707963267948966]
        turn = [rng.choice((rng.uniform(-3.0, 3.0), *right)) for _ in range(3)]
        origin = Pose(*(rng.choice((0.0, rng.uniform(-1.0, 1.0))) for _ in range(3)), *turn)
        axis = rng.choice(((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0), (0.0, -1.0, 0.0), (0.6, 0.0, 0.8)))
        return Joint(f"j{number}", kind, f"l{number}", f"l{number + 1}", origin, axis)

    first = Joint("first", JointKind.REVOLUTE, "base", "l0", axis=(0.0, 0.0, 1.0))
    return (first, *(joint(number) for number in range(rng.randint(0, 7))))


@pytest.mark.parametrize("seed", range(200))
def test_reaches_the_same_points_as_the_chain(seed: int) -> None:
    rng = random.Random(seed)
    chain = random_chain(rng)
    found = manipulator_geometry(chain)
    for _ in range(5):
        positions = [rng.uniform(-3.0, 3.0) for _ in found.links]
        there = found.forward(found.from_urdf(positions)).apply(found.tool)
        assert there == pytest.approx(tool_point(chain, positions), abs=1e-7)
        assert found.to_urdf(found.from_urdf(positions)) == pytest.approx(positions)


@pytest.mark.parametrize("robot", ["inc1", "inc1_pprm"])
def test_the_first_link_is_the_base(robot: str) -> None:
    model = robot_model(load(robot))
    setup = model.groups["arm"]
    found = manipulator_geometry(model.description.chain(setup.base, setup.tip))
    assert (found.links[0].length, found.links[0].twist) == (0.0, 0.0)
    assert [link.joint.name for link in found.links] == list(setup.joints)
