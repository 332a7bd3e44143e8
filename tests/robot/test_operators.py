"""A whole robot that requires operators: lists in fragments, arms and stops, as an operator's program commands them."""

from __future__ import annotations

import asyncio
from pathlib import Path

import pytest

from jauspy.cli.estop import _stop as stop_or_release, destination
from jauspy.errors import ControlRejected
from jauspy.messages.core import ReportStatus, SetEmergency
from jauspy.messages.mobility import SetLocalWaypoint, SetWrenchEffort
from jauspy.messages.operators import SealedCommand
from jauspy.protocol.seal import OperatorKey
from jauspy.robot.audit import verify
from jauspy.robot.operators import load
from jauspy.testing import VirtualNetwork

pytest.importorskip("cryptography", reason="keys of operators need the extra 'operators'")

MANY = 300
"""Waypoints that do not fit one packet."""


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """A robot's TOML file, the operators file that it names, and the key of the one who is in it."""
    key = OperatorKey.generate()
    (tmp_path / "alice.key").write_bytes(key.pem())
    (tmp_path / "alice.key").chmod(0o600)
    (tmp_path / "operators.toml").write_text(f'operators.alice = {{ role = "operator", key = "{key.public}" }}\n')
    keys = ['extends = "inc1"', 'operators = "operators.toml"', 'audit_log = "log"']
    (tmp_path / "robot.toml").write_text("\n".join(keys))
    return tmp_path


@pytest.mark.slow
async def test_a_robot_that_requires_operators(virtual_network: VirtualNetwork, folder: Path) -> None:
    async with (
        virtual_network.robot(str(folder / "robot.toml")) as robot,
        virtual_network.ocu("42.1.1", operator=folder / "alice.key") as ocu,
        virtual_network.ocu("43.1.1") as stranger,
    ):
        found = await ocu.discover(101)
        driver, arm = found.service("LocalWaypointListDriver"), found.component(103).service("AccessControl")
        async with driver.control(), arm.control():
            await driver.resume()
            await driver.waypoints.upload(SetLocalWaypoint(x=2.0 + n / 10, y=0.0) for n in range(MANY))
            assert any(len(each.payload) > 1000 for each in virtual_network.sent(SealedCommand))
            await driver.waypoints.execute(speed=1.0)
            await asyncio.sleep(2.0)
            assert robot.snapshot is not None
            assert robot.snapshot.pose.x > 0.5
            there = (await stranger.discover(101)).component(driver.id).service("PrimitiveDriver")
            with pytest.raises(ControlRejected, match="no seal"):
                async with there.control(255):
                    pass
            await there.send(SetWrenchEffort(propulsive_linear_effort_x=-100.0))
            await stranger.send(driver.id, SetEmergency(1), ack=True)
            await asyncio.sleep(1.0)
            assert abs(robot.snapshot.twist.vx) < 0.01
        counters = robot.counters
    refused = {name for name in counters if ".refused." in name}
    assert refused == {f"{driver.id}.host.refused.no_seal"}
    report = verify(folder / "log", operators=load(folder / "operators.toml"))
    assert (report.problem, report.not_recorded) == ("", 0)
    assert report.verified == report.commands["alice"] > 5
    assert (report.commands["-"], report.refused) == (3, 2)


@pytest.mark.slow
async def test_an_emergency_of_anybody_is_released_with_a_key(virtual_network: VirtualNetwork, folder: Path) -> None:
    everything = destination("101")
    async with virtual_network.robot(str(folder / "robot.toml")):
        stopped = await stop_or_release(virtual_network.ocu("43.1.1"), everything, release=False, max_wait=2.0)
        assert {each.status for each in stopped.values()} == {ReportStatus.Status.EMERGENCY}
        without = await stop_or_release(virtual_network.ocu("43.1.2"), everything, release=True, max_wait=2.0)
        assert {each.status for each in without.values()} == {ReportStatus.Status.EMERGENCY}
        with_key = virtual_network.ocu("42.1.1", operator=folder / "alice.key")
        released = await stop_or_release(with_key, everything, release=True, max_wait=4.0)
        assert {each.status for each in released.values()} == {ReportStatus.Status.STANDBY}
