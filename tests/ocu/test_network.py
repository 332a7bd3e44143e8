"""Over real sockets: a node manager, a component on its local socket, and OCUs that come in by UDP."""

from __future__ import annotations

import asyncio
import sys
import time
from datetime import UTC, datetime
from pathlib import Path

import pytest

from jauspy.component import Component
from jauspy.errors import TransportError
from jauspy.geometry.poses import Pose, Twist
from jauspy.ids import JausID
from jauspy.messages.core import QueryHeartbeatPulse, QueryStatus, ReportStatus, Standby
from jauspy.node import NodeManager
from jauspy.node.config import NodeConfig
from jauspy.ocu import OCU
from jauspy.services.core import AccessControl, Discovery, Liveness
from jauspy.services.host import Host
from jauspy.services.mobility import PrimitiveDriver, Vehicle
from jauspy.testing import until
from jauspy.transport import LocalTransport

ROBOT = JausID(101, 1, 102)
Status = ReportStatus.Status


class Drive:
    effort = 0.0

    def set_effort(self, linear_x: float, rotational_z: float, linear_y: float = 0.0) -> None:
        self.effort = linear_x

    def stop(self) -> None:
        self.effort = 0.0

    def pose(self) -> Pose:
        return Pose()

    def twist(self) -> Twist:
        return Twist()


class Site:
    """A node manager's configuration, and a robot that is attached to it."""

    def __init__(self, root: Path, port: int) -> None:
        self.root, self.port = root, port
        self.drive = Drive()
        services = [Discovery(), Liveness(), AccessControl(timeout=2), PrimitiveDriver(Vehicle(self.drive))]
        host = Host(ROBOT, services, utc_now=lambda: datetime.now(UTC), now=time.monotonic())
        self.robot = Component.of_host(host, LocalTransport(ROBOT, root))

    def manager(self) -> NodeManager:
        return NodeManager(NodeConfig(address="127.0.0.1", port=self.port, local_root=self.root, tcp=True))


@pytest.fixture
async def site(root: Path, free_port: int) -> Site:
    return Site(root, free_port)


@pytest.mark.parametrize("form", ["udp://127.0.0.1:{port}", "tcp://127.0.0.1:{port}", "local:{root}"])
async def test_an_ocu_finds_and_controls_a_robot(site, form):
    async with site.manager(), site.robot, OCU(connect=form.format(port=site.port, root=site.root)) as ocu:
        driver = (await ocu.discover(101)).service("mobility:PrimitiveDriver")
        async with driver.control():
            await driver.resume()
            assert site.robot.host.controller == ocu.id
            await driver.send(Standby(), ack=True)
            assert await driver.status() == Status.STANDBY
        assert site.robot.host.controller is None
        assert await driver.status() == Status.STANDBY


async def test_restart_of_the_node_manager_is_survived(site):
    async with site.manager() as manager, site.robot, OCU(connect=f"udp://127.0.0.1:{site.port}") as ocu:
        await ocu.query(ROBOT, QueryHeartbeatPulse())
        await manager.close()
        async with site.manager():
            await ocu.query(ROBOT, QueryStatus(), timeout=0.25, retries=20)


async def test_missing_node_manager_error_says_what_to_do(site):
    with pytest.raises(TransportError, match="no node manager"):
        await OCU(connect=f"local:{site.root}").open()


KILLED = """
import asyncio, sys, jauspy
from jauspy.messages.mobility import SetWrenchEffort

async def main():
    async with jauspy.OCU("42.1.1", sys.argv[1]) as ocu:
        driver = (await ocu.discover(subsystem=101)).service("mobility:PrimitiveDriver")
        async with driver.control(authority=200):
            await driver.resume()
            await driver.send(SetWrenchEffort(propulsive_linear_effort_x=40.0))
            await asyncio.sleep(60)

asyncio.run(main())
"""


@pytest.mark.slow
async def test_robot_stops_when_the_ocu_process_is_killed(site):
    async with site.manager(), site.robot:
        process = await asyncio.create_subprocess_exec(sys.executable, "-c", KILLED, f"udp://127.0.0.1:{site.port}")
        await until(lambda: site.drive.effort > 0.3, 20)

        process.kill()
        await process.wait()
        await until(lambda: site.drive.effort == 0.0, 20)

        assert (site.robot.host.controller, site.robot.host.status) == (None, Status.STANDBY)
