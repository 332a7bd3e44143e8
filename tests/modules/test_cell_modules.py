"""The modules of a factory cell as JAUS components: they appear with their power, and obey one client."""

from __future__ import annotations

import asyncio
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager
from dataclasses import dataclass

from tests.helpers.memory_cell import MemoryBackend, MemoryCell

from jauspy import OCU
from jauspy.modules import robot_files
from jauspy.modules.robot import RobotRunner
from jauspy.virtual.environment import VirtualTime
from jauspy.virtual.network import VirtualNetwork

CONFIG = robot_files.load("cell")
IDS = {module.part or module.type: str(CONFIG.id_of(module)) for module in CONFIG.modules if module.type != "CM-MOB"}
ALWAYS = {"201.1.10", "201.1.11", "201.1.12", "201.1.13", "201.3.1"}
BASES = {IDS[name] for name in ("platform_1", "platform_2", "car")}
ALL_FIELDS = 0xFFFFFFFF


@dataclass
class World:
    """A cell that runs, and a client."""

    network: VirtualNetwork
    backend: MemoryBackend
    runner: RobotRunner
    ocu: OCU

    @property
    def robot(self) -> MemoryCell:
        assert self.backend.robot is not None
        return self.backend.robot

    @property
    def ids(self) -> set[str]:
        return {str(component.id) for component in self.runner.components}

    async def client(self, what: str):
        return await self.ocu.find(IDS.get(what, what))

    async def service(self, what: str, name: str):
        robot = await self.ocu.robot(201)
        return robot.component(IDS.get(what, what)).service(name)


@asynccontextmanager
async def world() -> AsyncIterator[World]:
    backend = MemoryBackend()
    async with VirtualNetwork() as network:
        runner = RobotRunner(CONFIG, network.transport, backend=backend, realtime=VirtualTime)
        async with runner, network.ocu() as ocu:
            yield World(network, backend, runner, ocu)


async def test_modules_appear_and_disappear_with_their_power():
    async with world() as cell:
        assert cell.ids == ALWAYS | BASES
        cell.robot.assemble("servo_1", "tube_1", "servo_2")
        await asyncio.sleep(0.2)
        assert cell.ids == ALWAYS | BASES | {IDS["servo_1"], IDS["tube_1"], IDS["servo_2"]}
        cell.robot.connectors["servo_1/output"].set(False)
        await asyncio.sleep(0.2)
        assert cell.ids == ALWAYS | BASES | {IDS["servo_1"]}
        cell.robot.power.switch("servo_1", False)
        await asyncio.sleep(0.2)
        assert cell.ids == ALWAYS | BASES
    assert cell.runner.components == ()
