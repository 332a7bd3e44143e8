"""Two robots of one kind in one world on virtual time, the second of which follows the first."""

from __future__ import annotations

import asyncio
import math
from collections.abc import AsyncIterator, Callable
from contextlib import asynccontextmanager
from dataclasses import dataclass, replace

from jauspy import OCU
from jauspy.codec.message import Message
from jauspy.geometry.poses import Pose
from jauspy.messages.iop import (
    QueryFollowerConfiguration,
    ReportFollowerConfiguration,
    SetFollowerConfiguration,
    SetFollowerState,
)
from jauspy.ocu import Robot as OcuRobot, RobotControl
from jauspy.platform.backend import Backend
from jauspy.platform.contract import Robot
from jauspy.platform.description import RobotModel
from jauspy.platform.localization import RTK, GnssSetup
from jauspy.robot import robot_files
from jauspy.robot.runner import RobotRunner
from jauspy.robot.several import FurtherRobot, further_robots, shared_backends
from jauspy.services.iop import LeaderFollowerDriver, LeaderManagement
from jauspy.testing import VirtualNetwork
from jauspy.virtual.environment import VirtualTime

LEADER, FOLLOWER = "101.1.102", "102.1.102"
LEADER_ID = SetFollowerConfiguration.Leader_ID(component_id=102, node_id=1, subsystem_id=101)


class Kept:
    """A backend that keeps the robot that it opened."""

    def __init__(self, backend: Backend) -> None:
        self._backend, self.name = backend, backend.name
        self._robot: Robot | None = None

    @property
    def robot(self) -> Robot:
        assert self._robot is not None, "the robot is not open"
        return self._robot

    def open(self, robot: RobotModel, world: str) -> Robot:
        self._robot = self._backend.open(robot, world)
        return self._robot


@dataclass
class TwoRobots:
    """Both robots, and the OCUs that control their chassis."""

    network: VirtualNetwork
    backends: tuple[Kept, Kept]
    runners: tuple[RobotRunner, RobotRunner]
    ocus: tuple[OCU, OCU]
    robots: tuple[OcuRobot, OcuRobot]
    controls: tuple[RobotControl, RobotControl]

    @property
    def poses(self) -> tuple[Pose, Pose]:
        """The true ones, of leader and follower."""
        leader, follower = (runner.snapshot for runner in self.runners)
        assert leader is not None
        assert follower is not None
        return leader.pose, follower.pose

    @property
    def distance(self) -> float:
        """True distance of both bases."""
        leader, follower = self.poses
        return math.hypot(leader.x - follower.x, leader.y - follower.y)

    @property
    def speeds(self) -> tuple[float, float]:
        leader, follower = (runner.snapshot for runner in self.runners)
        assert leader is not None
        assert follower is not None
        return leader.twist.vx, follower.twist.vx

    def service(self, kind: type, robot: int):
        (found,) = (each for c in self.runners[robot].components if (each := c.host.service(kind)) is not None)
        return found

    @property
    def driver(self) -> LeaderFollowerDriver:
        return self.service(LeaderFollowerDriver, 1)

    @property
    def management(self) -> LeaderManagement:
        return self.service(LeaderManagement, 0)

    def host(self, robot: int):
        return self.service(LeaderFollowerDriver, robot).host

    async def tell_leader(self, message: Message) -> None:
        await self.ocus[0].send(LEADER, message, ack=True)

    async def tell_follower(self, message: Message) -> None:
        await self.ocus[1].send(FOLLOWER, message, ack=True)

    async def follow(self, *, gap: float | None = 2.0, **settings: object) -> None:
        """Configure and start."""
        settings = {"leader_id": LEADER_ID, "minimum_follow_distance": gap, **settings}
        await self.tell_follower(SetFollowerConfiguration(**settings))
        await self.tell_follower(SetFollowerState(SetFollowerState.State.START))

    async def reported(self) -> ReportFollowerConfiguration:
        report = await self.ocus[1].query(FOLLOWER, QueryFollowerConfiguration())
        assert isinstance(report, ReportFollowerConfiguration)
        return report

    async def until(self, condition: Callable[[], bool], seconds: float) -> None:
        clock = asyncio.get_running_loop().time
        end = clock() + seconds
        while not condition():
            assert clock() < end, f"not within {seconds} s: {self.poses}, {self.driver.ended_by or 'following'}"
            await asyncio.sleep(0.02)


@asynccontextmanager
async def two_robots(
    network: VirtualNetwork,
    backend: str = "kinematic",
    world: str = "street",
    *,
    start: Pose | None = None,
    gnss: GnssSetup = RTK,
) -> AsyncIterator[TwoRobots]:
    """Leader and follower without cameras, each in control of an OCU of its own, in Ready."""
    first = robot_files.load("inc1")
    modules = tuple(each for each in first.modules if each.type == "CM-MOB")
    localization = replace(first.localization, gnss=gnss)
    changes = {"modules": modules, "localization": localization, "cameras": (), "lights": ()}
    first = first.model_copy(update=changes)
    (second,) = further_robots(first, ["inc1"])
    seeded = replace(localization, seed=second.config.localization.seed)
    second = FurtherRobot(second.config.model_copy(update=changes | {"localization": seeded}), start)
    one, other = map(Kept, shared_backends(first, [second], backend))
    runners = tuple(
        RobotRunner(config, network.transport, backend=each, world=world, realtime=VirtualTime)
        for config, each in ((first, one), (second.config, other))
    )
    async with runners[0], runners[1], network.ocu("42.1.1") as ocu, network.ocu("42.2.1") as own_ocu:
        leader, follower = await ocu.discover(101), await own_ocu.discover(102)
        async with leader.control("drive") as first_control, follower.control("drive") as second_control:
            yield TwoRobots(
                network, (one, other), runners, (ocu, own_ocu), (leader, follower), (first_control, second_control)
            )
