"""Loads on the gripper: of postures, of detours that keep within its strength, and of motions that speed up slowly."""

from __future__ import annotations

import copy
import math
from dataclasses import replace
from itertools import pairwise

import coal
import numpy as np
import pinocchio as pin
import pytest
from tests.helpers.fake_cell import FakeCell

from jauspy.cell.assembly import Assembler
from jauspy.cell.frames import se3, shifted, transform, turned
from jauspy.cell.held_load import MOST, HeldLoad
from jauspy.cell.interface import GRIPPER
from jauspy.cell.motion import NoPath, Path
from jauspy.cell.scene import Layout, Piece, connector_frame
from jauspy.geometry.poses import Transform
from jauspy.geometry.vectors import GRAVITY
from jauspy.platform.modular.connector import ConnectorState
from jauspy.platform.modular.holding import GRIPPER_CUP, GRIPPER_PLATE

DOWN = turned("x", math.pi)


def ball(mass: float, below: float = 0.05) -> HeldLoad:
    return HeldLoad(pin.Inertia(mass, np.array([0.0, 0.0, below]), np.eye(3) * 1e-3), GRIPPER_CUP)


def test_what_hangs_pulls_and_what_is_held_from_the_side_slides() -> None:
    load, weight = ball(3.0), 3.0 * GRAVITY
    assert load.utilisation(DOWN) == pytest.approx(weight / GRIPPER_CUP.force)
    sideways = max(weight * 0.05 / GRIPPER_CUP.radius, weight / GRIPPER_CUP.friction) / GRIPPER_CUP.force
    assert load.utilisation(turned("y", math.pi / 2.0)) == pytest.approx(sideways)
    assert load.utilisation(pin.SE3.Identity()) == pytest.approx(0.0, abs=1e-9)  # it lies on the cup
    assert load.utilisation(DOWN, np.array([0.0, 0.0, GRAVITY])) == pytest.approx(2.0 * weight / GRIPPER_CUP.force)
    assert load.worst >= sideways


@pytest.fixture
def ur10(layout: Layout) -> Assembler:
    made = Assembler(FakeCell(layout), layout)
    for part in layout.setup.parts:
        made.scene.remove(part.name)
    return made


def level(ur10: Assembler, x: float, y: float, z: float, near: np.ndarray) -> np.ndarray:
    found = ur10.layout.kinematics.solve(shifted(x, y, z) * DOWN, near)
    return found[0].positions


@pytest.mark.slow
def test_a_heavy_load_is_carried_upright_where_a_light_one_is_turned(ur10: Assembler) -> None:
    """A column stands in the way."""
    k, scene = ur10.layout.kinematics, ur10.scene
    start = level(ur10, 0.6, -0.3, 0.7, ur10.layout.home)
    goal = level(ur10, -0.5, -0.5, 0.9, start - np.array([1.9, 0.0, 0.0, 0.0, 0.0, 0.0]))
    scene.put("column", [Piece(coal.Box(0.08, 0.08, 1.1), pin.SE3.Identity())], shifted(0.05, -0.68, 0.55))

    def tilts(path: Path) -> list[float]:
        steps = [a + (b - a) * s for a, b in pairwise(path.points) for s in np.linspace(0.0, 1.0, 60)]
        return [math.acos(min(1.0, float(-k.forward(q).rotation[2, 2]))) for q in steps]

    try:
        light = ur10.planner.to_posture(start, goal)
        ur10.planner.load = heavy = ball(6.2)
        carried = ur10.planner.to_posture(start, goal)
    finally:
        scene.remove("column")
    assert max(tilts(light)) > math.radians(20.0)
    assert max(tilts(carried)) < math.radians(16.0)
    assert max(heavy.utilisation(turned("x", math.pi + tilt)) for tilt in tilts(carried)) < MOST + 0.01


def test_a_goal_in_which_the_load_would_come_off_is_refused(ur10: Assembler) -> None:
    start = level(ur10, 0.6, -0.3, 0.7, ur10.layout.home)
    goal = start.copy()
    goal[3] += 1.2
    ur10.planner.load = ball(6.2)
    with pytest.raises(NoPath, match=r"at the end of the motion the load uses \d+% of what holds it"):
        ur10.planner.to_posture(start, goal)


async def test_a_motion_that_would_shake_it_off_speeds_up_slowly(
    ur10: Assembler, monkeypatch: pytest.MonkeyPatch
) -> None:
    start = level(ur10, 0.6, -0.3, 0.7, ur10.layout.home)
    goal = start.copy()
    goal[0] += 0.8
    gentle: list[bool] = []

    async def follow(path: Path, **options: object) -> None:
        gentle.append(bool(options["gentle"]))

    monkeypatch.setattr(ur10.cell, "follow", follow)
    for mass in (0.3, 4.0):
        ur10.planner.load = ball(mass, 0.1)
        await ur10.go(Path((start, goal)))
    assert gentle == [False, True]
    ur10.planner.load = ball(12.0)
    with pytest.raises(NoPath, match="the gripper would use"):
        await ur10.go(Path((start, goal)))


def test_what_is_attached_to_a_part_counts_and_a_latch_holds_more(ur10: Assembler) -> None:
    grasp = ur10.layout.grasp("car")
    alone = ur10.handling.load("car", grasp, latched=True)
    assert alone.strength is ur10.layout.setup.limits.latch
    assert alone.inertia.mass == pytest.approx(3.5)
    ur10.handling.members["car"] = [("servo_6", shifted(0.1, 0.1)), ("wheel_1", shifted(0.1, 0.2))]
    assert ur10.handling.load("car", grasp, latched=True).inertia.mass == pytest.approx(3.5 + 0.435 + 0.25)
    beside = ur10.handling.load("servo_1", ur10.layout.grasp("servo_1"), latched=False)
    assert beside.strength.force == pytest.approx(GRIPPER_CUP.force)


FLANGE = pin.SE3.Identity()
GRASPED = (
    ("bracket_1", None),
    ("bracket_3", None),
    ("tube_1", None),
    ("tube_1", FLANGE),
    ("box_1", None),
    ("car", None),
)
"""Parts, and the gripper in their frame where it is not the usual one."""


@pytest.mark.slow
def test_the_gripper_locks_where_the_simulation_says_so(layout: Layout) -> None:
    """On flanges, and on the faces of brackets that are made for it."""
    pytest.importorskip("mujoco")
    cells = pytest.importorskip("tests.helpers.cells")
    cell = cells.small_cell([name for name, _ in GRASPED] + ["platform_1"], car="car")
    found = {}
    with cells.weightless(cell):
        for part, grasp in GRASPED:
            at = layout.grasp(part) if grasp is None else grasp
            cells.put_on(cell, GRIPPER, part, transform(at.inverse()))
            cell.advance(0.5)
            state = cell.connectors[GRIPPER].state()
            assert state.attached_to == part
            found[part, grasp is None] = state.latched
            assert layout.locks(GRIPPER, part, se3(state.offset).inverse()) == state.latched, part
            if grasp is None:
                assert layout.locks(GRIPPER, part) == state.latched, part
            cell.connectors[GRIPPER].set(False)
            cell.advance(0.01)
            cells.put(cell, part, Transform(position=(20.0 + len(found), 0.0, 0.0)))
    assert found == {
        ("bracket_1", True): True,
        ("bracket_3", True): True,
        ("tube_1", True): False,
        ("tube_1", False): True,
        ("box_1", True): False,
        ("car", True): True,
    }


def test_a_face_between_two_flanges_is_none(layout: Layout) -> None:
    pair = replace(layout.setup.parts[0], name="pair", type="platform_pair")
    made = copy.copy(layout)
    made.setup = replace(layout.setup, parts=(*layout.setup.parts, pair))
    assert not made.locks(GRIPPER, "pair")
    left = connector_frame(made.type_of("pair"), "left") * turned("x", math.pi)
    assert made.locks(GRIPPER, "pair", left)
    assert made.locks("pair/left", "servo_1")
    assert not made.locks("pair/left", "box_1")


def test_what_the_cup_bears_need_not_lock(ur10: Assembler) -> None:
    def held(part: str) -> ConnectorState:
        offset = transform(ur10.layout.grasp(part).inverse())
        return ConnectorState(attached_to=part, offset=offset, vacuum=GRIPPER_PLATE.pressure)

    assert not ur10._needs_lock(held("bracket_1")), "light"
    assert ur10._needs_lock(held("car"))
    assert not ur10._needs_lock(replace(held("car"), latched=True))
    assert not ur10._needs_lock(held("box_1")), "it has no latch"
    ur10.handling.members["bracket_1"] = [("platform_1", shifted(z=0.1))]
    assert ur10._needs_lock(held("bracket_1"))
