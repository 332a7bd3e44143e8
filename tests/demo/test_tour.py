"""The demo on a robot in memory and on virtual time: all that needs no physics, and what goes wrong."""

from __future__ import annotations

import asyncio
from pathlib import Path

import pytest

from jauspy.demo import plan
from jauspy.demo.report import Report, View
from jauspy.demo.tour import Tour
from jauspy.errors import ControlRejected, RequestError
from jauspy.ocu import OCU
from jauspy.robot.robot_files import load
from jauspy.robot.runner import RobotRunner
from jauspy.testing import TestEnvironment

YARD = plan.PLANS["yard"]


@pytest.fixture
def tour(ocu: OCU, tmp_path: Path) -> Tour:
    return Tour(ocu, load("inc1"), View(), Report(), tmp_path, goals=YARD)


def holders(robot: RobotRunner) -> set[object]:
    return {each.host.controller for each in robot.components}


@pytest.mark.slow
async def test_tour_drives_moves_the_arm_and_releases_control(robot: RobotRunner, tour: Tour) -> None:
    await tour.run()
    assert [(each.stage, each.reached) for each in tour._report.results] == [("drive", True), ("arm", True)]
    assert robot.snapshot is not None
    where = robot.snapshot.pose
    assert (where.x, where.y, where.yaw) == pytest.approx((YARD.goal.x, YARD.goal.y, YARD.goal.heading), abs=0.15)
    assert holders(robot) == {None}


@pytest.mark.slow
async def test_drive_times_out_if_the_robot_does_not_arrive(
    robot: RobotRunner, tour: Tour, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(plan, "DRIVE_TIMEOUT", 1.0)
    with pytest.raises(RequestError, match=r"1\.\d+ m from \(2, 0\)"):
        await tour.run()
    assert holders(robot) == {None}


@pytest.mark.slow
async def test_loss_of_control_ends_the_drive(robot: RobotRunner, tour: Tour, environment: TestEnvironment) -> None:
    touring = asyncio.create_task(tour.run())
    while robot.snapshot is None or robot.snapshot.pose.x < 0.1:
        await asyncio.sleep(0.05)
    async with environment.ocu("43.1.1") as other:
        driver = (await other.discover(101)).service("LocalWaypointDriver")
        async with driver.control(authority=plan.AUTHORITY + 1):
            with pytest.raises(ControlRejected, match="was lost"):
                await touring
