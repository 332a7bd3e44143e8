"""The arms of a factory cell: the UR10, and the modular arm whose joints come and go."""

from __future__ import annotations

import asyncio
import math
from typing import Any

import pytest
from nicegui import Client
from nicegui.page import page
from tests.robot.test_cell_modules import world

from jauspy.console.manipulators import (
    CONNECTOR,
    JointInfo,
    ModularArm,
    StandardArm,
    joint_label,
    manipulators,
    operated,
)
from jauspy.console.panels.arm import _JointRow
from jauspy.console.panels.gripper import connector_state, switch
from jauspy.console.trajectory import Trajectory, TrajectoryRow
from jauspy.errors import ConfigError, RequestError
from jauspy.ocu.motion_limits import MotionLimits


@pytest.mark.slow
async def test_a_cell_has_two_arms_and_the_joints_of_one_come_and_go() -> None:
    async with world() as cell:
        robot = await cell.ocu.discover(201)
        arms = manipulators(robot)
        assert {id: type(arm) for id, arm in arms.items()} == {"201.1.10": StandardArm, "201.3.1": ModularArm}
        assert {"201.1.10", "201.1.11", "201.3.1"} <= set(operated(robot))
        assert not any(id.startswith("201.2.") for id in operated(robot)), "connectors of parts are not the gripper"
        arm = arms["201.3.1"]
        assert await arm.joints() == ()
        assert await arm.tool() == ""
        cell.robot.assemble("servo_1", "tube_1", "servo_2")
        await asyncio.sleep(0.2)
        joints = await arm.joints()
        assert [each.name for each in joints] == ["servo_1", "servo_2"]
        low, high = joints[0].shown_range(7.0)
        assert low < 7.0 < high
        assert high - low == pytest.approx(6.283, abs=0.001)

        async with robot.control(*operated(robot)):
            await arm.move({"servo_1": 0.5}, 0.5)
            assert (await arm.positions())["servo_1"] == pytest.approx(0.5, abs=0.01)
            begun = list[int]()
            await arm.follow([(1.0, {"servo_1": 0.2}), (0.0, {"servo_2": -0.3})], begun.append)
            assert begun == [0, 1]
            assert await arm.positions() == pytest.approx({"servo_1": 0.2, "servo_2": -0.3}, abs=0.01)
            with pytest.raises(ConfigError, match="row 1: there is no joint 'servo_9' now"):
                await arm.follow([(1.0, {"servo_9": 0.2})], begun.append)

            gripper = robot.component("201.1.11").service(CONNECTOR)
            assert await connector_state(gripper) == "off"
            await switch(gripper, on=True)
            await asyncio.sleep(0.2)
            assert (await connector_state(gripper)).startswith("on, holds nothing")
            cell.robot.attach("gripper", "box_1")
            await asyncio.sleep(0.2)
            assert await connector_state(gripper) == "holds box_1"

        cell.robot.connectors["servo_1/output"].set(False)
        await asyncio.sleep(0.2)
        assert [each.name for each in await arm.joints()] == ["servo_1"]


@pytest.mark.slow
async def test_rows_with_times_are_one_motion() -> None:
    async with world() as cell:
        robot = await cell.ocu.discover(201)
        arm = manipulators(robot)["201.3.1"]
        cell.robot.assemble("servo_1", "tube_1", "servo_2")
        await asyncio.sleep(0.2)
        async with robot.control("201.3.1"):
            begun = list[int]()
            begin, sent = cell.robot.arm.begin, []
            cell.robot.arm.begin = lambda motion: (sent.append(motion), begin(motion))[1]
            await arm.follow([(0.5, {"servo_1": 0.4}), (0.3, {"servo_1": 0.1})], begun.append)
            assert begun == [0, 1]
            assert [(point.time, point.positions) for point in sent[0].points] == [(0.5, (0.4,)), (0.8, (0.1,))]
            assert len(sent) == 1, "one motion, without a stop at the first row"
            following = asyncio.create_task(
                arm.follow([(2.0, {"servo_1": 0.4}), (3.0, {"servo_1": 0.1})], begun.append)
            )
            await asyncio.sleep(0.3)
            await robot.component("201.3.1").modular_arm.begin([0.0, 0.0], 1.0)
            with pytest.raises(RequestError, match="another motion took its place"):
                await following


@pytest.mark.slow
async def test_the_exported_program_moves_the_modular_arm() -> None:
    async with world() as cell:
        robot = await cell.ocu.discover(201)
        cell.robot.assemble("servo_1", "tube_1", "servo_2")
        await asyncio.sleep(0.2)
        for rows in ([(0.5, [0.3]), (0.4, [0.6])], [(0.0, [0.1]), (0.4, [0.6])]):
            made = Trajectory(("servo_1",), [TrajectoryRow(*row) for row in rows])
            names: dict[str, Any] = {"__name__": "exported"}
            exec(compile(made.program(201, "201.3.1", modular=True), "exported.py", "exec"), names)
            await names["play"](robot)
            assert (await manipulators(robot)["201.3.1"].positions())["servo_1"] == pytest.approx(0.6, abs=0.01)


def test_the_slider_of_a_joint_without_limits_shows_the_turn_that_the_joint_is_in() -> None:
    endless = JointInfo("base_to_servo_1", True, -math.inf, math.inf, MotionLimits(1.0))
    with Client(page("/joint")):
        row = _JointRow(endless, 0.0)
        slider = row._slider
        assert (slider.props["min"], slider.props["max"]) == pytest.approx((-math.pi, math.pi), abs=1e-3)
        row.measured(4.0)
        assert (float(slider.props["min"]), float(slider.props["max"])) == pytest.approx(
            (math.pi, 3.0 * math.pi), abs=1e-3
        )
        assert slider.value == pytest.approx(4.0, abs=1e-3)
    assert joint_label(endless.name) == "servo_1"
    assert joint_label("shoulder_pan") == "shoulder_pan"
