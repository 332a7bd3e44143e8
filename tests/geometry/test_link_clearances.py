"""Clearances between links of robots, by boxes around their shapes, for one posture and for many at once."""

from __future__ import annotations

import math
import random
import subprocess
import sys
from collections.abc import Callable, Mapping
from typing import TypeAlias

import pytest

from jauspy.geometry.frames import FrameTree
from jauspy.geometry.link_clearances import LinkClearances
from jauspy.geometry.link_pairs import GROUND, LinkPairs, Pair
from jauspy.geometry.urdf import RobotDescription, parse_urdf
from jauspy.robot.robot_files import load, robot_model

LINK = """<link name="{}"><collision><origin xyz="{}"/><geometry>{}</geometry></collision></link>"""
BOX = '<box size="0.2 0.2 0.2"/>'
JOINT = """<joint name="{0}" type="{1}"><parent link="{2}"/><child link="{3}"/><origin xyz="{4}"/><axis xyz="{5}"/>
<limit lower="-3" upper="3" effort="1" velocity="1"/>{6}</joint>"""
INC1 = robot_model(load("inc1"))
TRACKS = {"left_track", "right_track"}

Measure: TypeAlias = Callable[[RobotDescription, Mapping[str, float], float], dict[Pair, float]]


def robot(*parts: str) -> RobotDescription:
    return parse_urdf(f'<robot name="test">{"".join(parts)}</robot>')


def slider(child: str = BOX) -> RobotDescription:
    """A base, a link that turns, and one that slides along x on it, which is not the base's neighbour."""
    return robot(
        LINK.format("base", "0 0 0.3", BOX),
        '<link name="middle"/>',
        LINK.format("slide", "0 0 0.3", child),
        JOINT.format("turn", "revolute", "base", "middle", "0 0 0", "0 0 1", ""),
        JOINT.format("way", "prismatic", "middle", "slide", "0 0 0", "1 0 0", ""),
    )


def two_boxes_on_three_joints() -> RobotDescription:
    return robot(
        LINK.format("base", "0 0 0", '<box size="0.4 0.2 0.3"/>'),
        '<link name="a"/><link name="b"/>',
        LINK.format("end", "0 0 0", '<box size="0.1 0.5 0.2"/>'),
        JOINT.format("yaw", "revolute", "base", "a", "0.1 0.3 0.2", "0 0 1", ""),
        JOINT.format("pitch", "revolute", "a", "b", "0.1 0 0.2", "0 1 0", ""),
        JOINT.format("out", "prismatic", "b", "end", "0 0 0", "1 0 0", ""),
    )


def one_posture(description: RobotDescription, positions: Mapping[str, float], below: float) -> dict[Pair, float]:
    return LinkClearances(description, independent(description)).at(positions, below)


def many_postures(description: RobotDescription, positions: Mapping[str, float], below: float) -> dict[Pair, float]:
    """The clearances in the last of several postures; the pairs that touch in a posture far away are left out."""
    pytest.importorskip("numpy", reason="numpy is not installed")
    import numpy as np

    from jauspy.geometry.link_boxes import LinkBoxes
    from jauspy.geometry.posture_clearances import PostureClearances

    joints = independent(description)
    clearances = PostureClearances(LinkBoxes(description, joints), dict.fromkeys(joints, 3.0))
    postures = [[1.5] * len(joints), [positions.get(name, 0.0) for name in joints]]
    found: dict[Pair, float] = {}
    for number, clearance in enumerate(clearances.at(np.array(postures))[-1].tolist()):
        if clearance < below:
            pair = clearances.pair(number)
            found[pair] = min(clearance, found.get(pair, math.inf))
    return found


def independent(description: RobotDescription) -> list[str]:
    return [joint.name for joint in description.joints.values() if joint.is_independent]


@pytest.fixture(params=[one_posture, many_postures])
def measure(request: pytest.FixtureRequest) -> Measure:
    found: Measure = request.param
    return found


def test_clearance_is_the_distance_of_faces_and_negative_inside(measure: Measure) -> None:
    assert measure(slider(), {"way": 0.25}, 0.1) == {("base", "slide"): pytest.approx(0.05)}
    assert measure(slider(), {"way": 0.15}, 0.1) == {("base", "slide"): pytest.approx(-0.05)}
    assert measure(slider(), {"way": 0.35}, 0.1) == {}


def test_edges_that_cross_are_separated(measure: Measure) -> None:
    """Where no face separates two boxes, an axis across two edges does."""
    upright = robot(
        LINK.format("base", "0 0 0", '<box size="2 0.1 0.1"/>'),
        '<link name="middle"/>',
        LINK.format("bar", "0 0 0", '<box size="0.1 2 0.1"/>'),
        JOINT.format("roll", "revolute", "base", "middle", "0 0 0", "1 0 0", ""),
        JOINT.format("lift", "prismatic", "middle", "bar", "0 0 0", "0 0 1", ""),
    )
    turned = {"roll": math.pi / 4.0, "lift": 0.2}
    assert measure(upright, turned, 1.0)["base", "bar"] > 0.05


@pytest.mark.parametrize("seed", range(20))
def test_clearance_is_at_most_the_distance_of_points_of_both_boxes(seed: int, measure: Measure) -> None:
    numbers, description = random.Random(seed), two_boxes_on_three_joints()
    positions = {name: numbers.uniform(-1.0, 1.0) for name in ("yaw", "pitch", "out")}
    clearance = measure(description, positions, 9.0)["base", "end"]
    frame = FrameTree(description).poses(positions)["end"]

    def point(size: tuple[float, float, float]) -> tuple[float, float, float]:
        x, y, z = (side * numbers.choice((-0.5, 0.5, numbers.uniform(-0.5, 0.5))) for side in size)
        return x, y, z

    for _ in range(300):
        distance = math.dist(point((0.4, 0.2, 0.3)), frame.apply(point((0.1, 0.5, 0.2))))
        assert clearance <= distance + 1e-9


def test_neighbours_are_left_out(measure: Measure) -> None:
    direct = robot(
        LINK.format("base", "0 0 0", BOX),
        LINK.format("slide", "0 0 0", BOX),
        JOINT.format("way", "prismatic", "base", "slide", "0 0 0", "1 0 0", ""),
    )
    assert measure(direct, {}, 0.1) == {}


def test_links_that_keep_their_places_are_left_out() -> None:
    assert LinkClearances(slider(), ["turn"]).at({"way": 0.15}, 0.1), "turning changes the clearance"
    assert LinkClearances(slider(), []).at({"way": 0.15}, 0.1) == {}


def test_fingers_that_one_joint_moves_are_left_out(measure: Measure) -> None:
    mimic = '<mimic joint="close" multiplier="-1"/>'
    gripper = robot(
        LINK.format("palm", "0 0 0", BOX),
        LINK.format("left", "0.3 0 0", BOX),
        LINK.format("right", "0.3 0 0", BOX),
        JOINT.format("close", "prismatic", "palm", "left", "0 0 0", "0 1 0", ""),
        JOINT.format("follow", "prismatic", "palm", "right", "0 0 0", "0 1 0", mimic),
    )
    assert measure(gripper, {"close": 0.11}, 0.1) == {}
    assert not LinkPairs(gripper, ["close"]).movers("left", "right")


def test_links_of_a_telescope_that_one_joint_moves_count(measure: Measure) -> None:
    telescope = robot(
        LINK.format("base", "0 0 0", BOX),
        '<link name="middle"/>',
        LINK.format("end", "0 0 0", BOX),
        JOINT.format("out", "prismatic", "base", "middle", "0 0 0", "1 0 0", ""),
        JOINT.format("follow", "prismatic", "middle", "end", "0 0 0", "1 0 0", '<mimic joint="out"/>'),
    )
    assert measure(telescope, {"out": 0.125}, 0.1) == {("base", "end"): pytest.approx(0.05)}


def test_joints_that_mimic_move_their_links_too(measure: Measure) -> None:
    description = robot(
        LINK.format("base", "0 0 0", BOX),
        '<link name="a"/><link name="b"/>',
        LINK.format("end", "0 0 0", BOX),
        JOINT.format("lead", "prismatic", "base", "a", "0 0 0", "0 1 0", ""),
        JOINT.format("half", "prismatic", "base", "b", "0 0 0", "1 0 0", '<mimic joint="lead" multiplier="0.5"/>'),
        JOINT.format("turn", "revolute", "b", "end", "0 0 0", "0 0 1", ""),
    )
    assert measure(description, {"lead": 0.5}, 0.1) == {("base", "end"): pytest.approx(0.05)}


def test_a_robot_of_meshes_has_no_clearances(measure: Measure) -> None:
    mesh = '<mesh filename="a.stl"/>'
    description = robot(
        LINK.format("base", "0 0 0", mesh),
        LINK.format("slide", "0 0 0", mesh),
        JOINT.format("way", "prismatic", "base", "slide", "0 0 0", "1 0 0", ""),
    )
    assert measure(description, {}, 9.0) == {}
    assert LinkClearances(description, ["way"], has_ground=True).at({}, 9.0) == {}


def test_ground_is_below_what_stands_on_it() -> None:
    description = robot(
        LINK.format("base", "0 0 0.1", BOX),
        '<link name="middle"/>',
        LINK.format("arm", "0 0 0", BOX),
        LINK.format("belt", "0 0 0.1", BOX),
        JOINT.format("track", "prismatic", "base", "belt", "0 3 0", "1 0 0", ""),
        JOINT.format("turn", "revolute", "base", "middle", "2 0 0", "0 0 1", ""),
        JOINT.format("lift", "prismatic", "middle", "arm", "0 0 0", "0 0 1", ""),
    )
    clearances = LinkClearances(description, ["turn", "lift"], has_ground=True, belts=["track"])
    assert clearances.at({"lift": 0.15}, 0.1) == {("arm", GROUND): pytest.approx(0.05)}
    assert clearances.at({"lift": 0.05}, 0.1) == {("arm", GROUND): pytest.approx(-0.05)}
    assert LinkClearances(description, ["turn", "lift"]).at({"lift": 0.05}, 0.1) == {}


def test_pairs_that_touch_at_the_start_are_left_out_of_many_postures_only() -> None:
    pytest.importorskip("numpy", reason="numpy is not installed")
    from jauspy.geometry.link_boxes import LinkBoxes
    from jauspy.geometry.posture_clearances import PostureClearances

    boxes = LinkBoxes(slider(), ["turn", "way"])
    apart = PostureClearances(boxes, {"way": 0.3})
    assert [apart.pair(number) for number in range(len(apart))] == [("base", "slide")]
    assert apart.movers(0) == {"turn", "way"}
    assert len(PostureClearances(boxes, {"way": 0.1})) == 0
    assert LinkClearances(slider(), ["way"]).at({"way": 0.1}, 0.01), "a pose with contact is found"


def test_rigid_joints_make_links_one_body() -> None:
    names = [joint.name for group in INC1.groups.values() for joint in map(INC1.description.joint, group.joints)]
    assert INC1.tracks is not None
    belts = [joint.name for joint in INC1.description.joints.values() if joint.child in TRACKS]
    loose, rigid = (LinkPairs(INC1.description, names, rigid=joints) for joints in ((), belts))
    assert loose.movers("arm_link_1", "left_track") == {"base_link_to_arm_link_1"}
    assert not rigid.movers("arm_link_1", "left_track"), "a neighbour, as of base_link"
    assert rigid.movers("arm_link_2", "left_track") == {"base_link_to_arm_link_1", "arm_link_1_to_arm_link_2"}


def test_both_ways_to_measure_agree_in_random_postures_of_inc1() -> None:
    """Pairs that only one of them has are those of belts."""
    pytest.importorskip("numpy", reason="numpy is not installed")
    import numpy as np

    from jauspy.geometry.link_boxes import LinkBoxes
    from jauspy.geometry.posture_clearances import PostureClearances

    rng, limit = random.Random(3), 0.05
    joints = [INC1.description.joint(name) for group in INC1.groups.values() for name in group.joints]
    names = [joint.name for joint in joints]
    start = {
        name: value for group in INC1.groups.values() for name, value in zip(group.joints, group.start, strict=True)
    }
    rows = [[rng.uniform(max(joint.lower, -3.0), min(joint.upper, 3.0)) for joint in joints] for _ in range(200)]
    many = PostureClearances(LinkBoxes(INC1.description, names), start)
    one = LinkClearances(INC1.description, names)
    pairs = {many.pair(number) for number in range(len(many))}
    touched = 0
    for row, measured in zip(rows, many.at(np.array(rows), near=limit), strict=True):
        expected: dict[Pair, float] = {}
        for number, clearance in enumerate(measured.tolist()):
            if clearance < limit:
                expected[many.pair(number)] = min(clearance, expected.get(many.pair(number), math.inf))
        found = one.at(dict(zip(names, row, strict=True)), limit)
        assert {pair: found[pair] for pair in found.keys() & pairs} == pytest.approx(expected, abs=1e-9)
        others = {frozenset(pair) for pair in found.keys() - pairs}
        assert others <= {frozenset({f"{side}_flipper", f"{side}_track"}) for side in ("left", "right")}
        touched += any(clearance < 0.0 for clearance in expected.values())
    assert touched > 10


@pytest.mark.slow
def test_named_poses_are_checked_without_numpy() -> None:
    program = """
import sys
sys.modules["numpy"] = None
from jauspy.platform.link_clearances import clearances_of
from jauspy.robot.robot_files import load, robot_model
inc1 = robot_model(load("inc1"))
assert inc1.poses
print(len(clearances_of(inc1, inc1.groups["arm"].joints).at({"arm_link_1_to_arm_link_2": -0.4}, 0.0)))
"""
    ran = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=False)
    assert ran.returncode == 0, ran.stderr
    assert int(ran.stdout) > 0
