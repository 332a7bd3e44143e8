"""Two arms on one base, each a component of its own, commanded over JAUS at the same time."""

from __future__ import annotations

import asyncio
from dataclasses import replace

import pytest

pytest.importorskip("mujoco", reason="the simulated cell needs the extra 'sim'")
pytest.importorskip("pinocchio", reason="needs the extra 'cell' and libgomp1", exc_type=ImportError)

from tests.helpers.cells import small_cell

from jauspy.cell.judge import WatchedBackend
from jauspy.geometry.poses import Pose
from jauspy.platform.modular.parts import CellSetup
from jauspy.robot import robot_files
from jauspy.robot.config import ModuleConfig, RobotConfig
from jauspy.robot.runner import RobotRunner
from jauspy.virtual.environment import VirtualTime
from jauspy.virtual.network import VirtualNetwork
from jauspy_sim.backend import MujocoBackend
from jauspy_sim.cell.robot import SimulatedCell
from jauspy_sim.cell.watch import FAR

LEFT = ("servo_1", "servo_3", "tube_2", "servo_4")
RIGHT = ("servo_5", "servo_11", "tube_4")
FIRST, SECOND = "201.3.1", "201.3.2"


def two_arms() -> RobotConfig:
    """The included cell with two arms, on a platform with two connectors."""
    config = robot_files.load("cell")
    assert config.cell is not None
    pair = tuple(
        replace(part, type="platform_pair") if part.name == "platform_1" else part for part in config.cell.parts
    )
    cell = replace(config.cell, parts=pair, second_arm="arm_2")
    module = ModuleConfig(type="CM-ARM", node=3, component=2, part="arm_2")
    return config.model_copy(update={"cell": cell, "modules": [*config.modules, module]})


def test_arms_have_names_of_their_own() -> None:
    config = two_arms()
    assert isinstance(config.cell, CellSetup)
    with pytest.raises(ValueError, match="must have another name than arm"):
        replace(config.cell, second_arm="arm")


@pytest.mark.slow
async def test_two_arms_on_one_base_move_at_the_same_time_and_keep_their_joints() -> None:
    backend, config = WatchedBackend(MujocoBackend()), two_arms()
    async with VirtualNetwork() as network:
        runner = RobotRunner(config, network.transport, backend=backend, realtime=VirtualTime)
        async with runner, network.ocu() as ocu:
            cell = backend.robot
            assert isinstance(cell, SimulatedCell)
            cell.prepare("platform_1/left", LEFT)
            cell.prepare("platform_1/right", RIGHT)
            await asyncio.sleep(0.3)
            robot = await ocu.discover(201)
            arms = [robot.component(id).modular_arm for id in (FIRST, SECOND)]
            left, right = [await arm.state() for arm in arms]
            assert left.joints == ("servo_1", "servo_3", "servo_4")
            assert right.joints == ("servo_5", "servo_11")
            async with robot.control(FIRST), robot.control(SECOND):
                begun = asyncio.get_running_loop().time()
                await asyncio.gather(arms[0].move([0.6, 0.4, -0.5], 2.0), arms[1].move([-0.5, 0.7], 2.0))
                assert asyncio.get_running_loop().time() - begun < 3.5, "one after the other would take four seconds"
            wanted = {"servo_1": 0.6, "servo_3": 0.4, "servo_4": -0.5, "servo_5": -0.5, "servo_11": 0.7}
            true = {name: cell.truth.servo(name)[0] for name in wanted}
            assert true == pytest.approx(wanted, abs=0.01)
            claimed = {name: cell.servos[name].state().claimed_by for name in wanted}
            assert set(claimed.values()) == {"arm", "arm_2"}
            assert claimed["servo_11"] == "arm_2"
            cell.connectors["platform_1/left"].set(
                False
            )  # the first arm is gone, and does not take the second's joints
            await asyncio.sleep(0.3)
            assert (await arms[0].state()).joints == (), "it does not take those of the other arm"
            assert (await arms[1].state()).joints == ("servo_5", "servo_11")
            assert cell.servos["servo_5"].state().claimed_by == "arm_2"


def test_groups_of_parts_are_measured_against_each_other() -> None:
    cell = small_cell(["box_1", "box_2", "box_3"])
    for number, along in enumerate((0.0, 0.3, 0.5)):
        cell.place(f"box_{number + 1}", Pose(x=1.0 + along, z=0.001))
    alone = cell.truth.watch(["box_1"])
    cell.advance(0.02)
    assert alone.clearance == FAR, "a watch of one group does not see other parts"
    first, second = cell.truth.watch_groups([["box_1"], ["box_2"]])
    cell.advance(0.02)
    side = cell.setup.types["box"].solids[0].size[0]
    assert first.clearance == pytest.approx(0.3 - side, abs=0.002)
    assert second.clearance == first.clearance, "box_3 is nearer, and in no group"
