"""Grasps of things in two worlds by inc1 in MuJoCo, on virtual time, judged by where the things really are."""

from __future__ import annotations

import math
from typing import Any

import pytest

pytest.importorskip("mujoco", reason="MuJoCo is not installed")
pytest.importorskip("ompl", reason="OMPL is not installed")
pytest.importorskip("coal", reason="coal is not installed")
pytest.importorskip("ruckig", reason="ruckig is not installed")

import numpy as np
from tests.helpers.grasps import before_thing

from jauspy.planning.grasp_checks import GraspFailed, grip_problem, hold_problem
from jauspy.planning.objects import Wanted
from jauspy.testing import VirtualNetwork

THINGS = ("box", "bottle", "cup", "bar", "ball")
WEIGHTS = {"box": 0.4, "bottle": 0.53, "cup": 0.26, "bar": 0.35, "ball": 0.2}
"""Kilograms, as in the worlds."""
LIFTED = 0.04
"""Metres, at least."""


def stand(seed: int) -> tuple[float, float, float]:
    """Where the thing is, seen from the robot: metres ahead, metres to the left, and the robot's heading in radians."""
    rng = np.random.default_rng(seed)
    return float(rng.uniform(0.68, 0.78)), float(rng.uniform(-0.1, 0.1)), float(rng.uniform(-0.1, 0.1))


@pytest.mark.slow
@pytest.mark.timeout(600)
@pytest.mark.parametrize(
    ("name", "world"),
    [(name, world) for world in ("workbench", "lost_property") for name in THINGS],
)
async def test_a_thing_is_found_grasped_and_lifted(virtual_network: VirtualNetwork, name: str, world: str) -> None:
    async with before_thing(virtual_network, world, name, stand(THINGS.index(name))) as robot:
        thing = await robot.steps.look(Wanted(name))
        assert math.dist(thing.centre[:2], robot.in_base()[:2]) < 0.025
        held = await robot.steps.grasp(thing)
        gripper = robot.robot.gripper
        assert await gripper.force() == pytest.approx(0.6 * await gripper.max_force(), rel=0.1)  # 60 % is asked for
        assert robot.lifted > LIFTED
        assert held.lifted == pytest.approx(robot.lifted, abs=0.02)
        assert held.weight == pytest.approx(WEIGHTS[name], abs=0.06)


@pytest.mark.slow
@pytest.mark.timeout(600)
@pytest.mark.parametrize("name", ["box", "cup"])
async def test_a_thing_is_put_where_it_is_to_be(virtual_network: VirtualNetwork, name: str) -> None:
    async with before_thing(virtual_network, "workbench", name, (0.72, 0.0, 0.0)) as robot:
        held = await robot.steps.grasp(await robot.steps.look(Wanted(name)))
        top = held.thing.support.at(0.72, 0.2)
        await robot.steps.place(held, (0.72, 0.2, top))
        assert math.dist(robot.in_base()[:2], (0.72, 0.2)) < 0.03
        assert abs(robot.lifted) < 0.01


@pytest.mark.slow
@pytest.mark.timeout(600)
@pytest.mark.parametrize(
    ("limits", "text"),
    [((0.045, 0.05), "did not close|fingers stopped"), ((0.0, 0.02), "did not open")],
    ids=["does not close", "does not open"],
)
async def test_a_gripper_that_is_stuck_is_told(
    virtual_network: VirtualNetwork, limits: tuple[float, float], text: str
) -> None:
    def block(simulated: Any) -> None:  # something between its gears
        for side in ("left", "right"):
            number = simulated.model.joint(f"{simulated.name_prefix}gripper_link_to_{side}_finger").id
            simulated.model.jnt_range[number] = limits

    async with before_thing(virtual_network, "workbench", "box", (0.72, 0.0, 0.0), disturb=block) as robot:
        thing = await robot.steps.look(Wanted("box"))
        with pytest.raises(GraspFailed, match=text):
            await robot.steps.grasp(thing)
        assert robot.lifted < 0.01


@pytest.mark.slow
@pytest.mark.timeout(600)
async def test_a_thing_that_is_gone_is_told(virtual_network: VirtualNetwork) -> None:
    async with before_thing(virtual_network, "workbench", "cup", (0.72, 0.0, 0.0)) as robot:
        thing = await robot.steps.look(Wanted("cup"))
        data, model = robot.simulated.data, robot.simulated.model
        start = int(model.jnt_qposadr[model.body("cup").jntadr[0]])
        data.qpos[start : start + 3] = 5.0, 5.0, 0.5
        with pytest.raises(GraspFailed, match="closed on nothing"):
            await robot.steps.grasp(thing)
        with pytest.raises(GraspFailed, match=r"no cup is seen"):
            await robot.steps.look(Wanted("cup"))


@pytest.mark.parametrize(
    ("width", "seen", "opened", "text"),
    [
        (0.06, 0.06, 0.1, ""),
        (0.099, 0.06, 0.1, "did not close"),
        (0.002, 0.06, 0.1, "closed on nothing"),
        (0.02, 0.06, 0.1, "stopped 2.0 cm apart"),
        (0.08, 0.06, 0.1, "stopped 8.0 cm apart"),
    ],
)
def test_fingers_tell_what_is_between_them(width: float, seen: float, opened: float, text: str) -> None:
    found = grip_problem(width, seen, opened)
    assert text in found
    assert bool(found) == bool(text)


@pytest.mark.parametrize(
    ("widths", "weight", "text"),
    [
        ((0.06, 0.06, 0.06), 0.4, ""),
        ((0.07, 0.06, 0.06), 0.4, ""),  # turned, and felt
        ((0.07, 0.06, 0.06), None, "slipped"),
        ((0.06, 0.06, 0.001), 0.0, "slipped"),
        ((0.06, 0.06, 0.05), 0.4, "slipped"),
        ((0.06, 0.06, 0.06), 0.01, "no weight"),
    ],
)
def test_wrist_and_fingers_tell_whether_it_is_held(
    widths: tuple[float, float, float], weight: float | None, text: str
) -> None:
    found = hold_problem(*widths, weight)
    assert text in found
    assert bool(found) == bool(text)
