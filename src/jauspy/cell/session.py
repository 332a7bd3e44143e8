"""A cell for one task: simulated on virtual time as fast as the machine can, or a running one elsewhere."""

from __future__ import annotations

import math
import time
from collections.abc import AsyncIterator
from contextlib import AsyncExitStack, asynccontextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Final

from jauspy.cell.client import CellClient
from jauspy.cell.film import Film
from jauspy.cell.judge import Judge, WatchedBackend
from jauspy.cell.layout import Layout
from jauspy.errors import ConfigError
from jauspy.modules import robot_files
from jauspy.modules.config import RobotConfig
from jauspy.modules.robot import RobotRunner
from jauspy.ocu import OCU
from jauspy.platform import backends
from jauspy.platform.contract import Robot
from jauspy.virtual.environment import VirtualTime
from jauspy.virtual.network import VirtualNetwork

ROBOT: Final = "cell"
OCU_ID: Final = "42.1.1"


@dataclass(frozen=True, slots=True)
class Disturbances:
    """What differs from the file: largest errors of the parts' poses (m, rad), and the fraction of grasps that fail."""

    position: float = 0.010
    angle: float = math.radians(5.0)
    attach_failure: float = 0.02


NONE: Final = Disturbances(0.0, 0.0, 0.0)


class WatchedTime(VirtualTime):
    """Virtual time that is never faster than the clock, so that one can watch."""

    def __init__(self, robot: Robot) -> None:
        super().__init__(robot)
        self._due = time.monotonic()

    def _advance(self) -> None:
        super()._advance()
        now = time.monotonic()
        time.sleep(max(0.0, self._due - now))
        self._due = max(self._due, now) + self._step


@dataclass(frozen=True, slots=True)
class Session:
    """A cell under control; `judge` is None for a running cell elsewhere."""

    cell: CellClient
    layout: Layout
    judge: Judge | None = None
    film: Film | None = None

    @property
    def true(self) -> Judge:
        """The judge. Raises `ConfigError` without one."""
        if self.judge is None:
            raise ConfigError("true poses are known in a simulation of this process only; leave out --connect")
        return self.judge


def configured(seed: int, disturbances: Disturbances, robot: str = ROBOT) -> RobotConfig:
    """The cell's file with a seed and disturbances."""
    config = robot_files.load(robot)
    if config.cell is None:
        raise ConfigError(f"the robot {robot!r} has no [cell]")
    sensor = config.cell.sensor.model_copy(update={"seed": seed})
    cell = config.cell.model_copy(
        update={
            "seed": seed,
            "sensor": sensor,
            "pose_error": (disturbances.position, disturbances.angle),
            "attach_failure": disturbances.attach_failure,
        }
    )
    return config.model_copy(update={"cell": cell})


@asynccontextmanager
async def simulated(
    seed: int,
    disturbances: Disturbances | None = None,
    *,
    film: Path | None = None,
    camera: str = "overview",
    view: bool = False,
) -> AsyncIterator[Session]:
    """A simulated cell on virtual time, with a client that controls it; the same seed gives the same run.

    `camera` is the name of the one that films; `view` opens a window, and the cell is then no faster than the clock.
    """
    config = configured(seed, disturbances or Disturbances())
    model = robot_files.robot_model(config)
    layout = Layout(model)
    backend = WatchedBackend(backends.find(config.backend))
    async with AsyncExitStack() as stack:
        network = await stack.enter_async_context(VirtualNetwork(seed=seed))
        realtime = WatchedTime if view else VirtualTime
        runner = RobotRunner(config, network.transport, backend=backend, realtime=realtime, view=view)
        await stack.enter_async_context(runner)
        assert backend.robot is not None
        judge = Judge(backend.robot)
        recording = None
        if film is not None:
            recording = Film(film, judge.camera(camera))
            await stack.enter_async_context(recording)
        ocu = await stack.enter_async_context(network.ocu(OCU_ID))
        cell = await stack.enter_async_context(CellClient(ocu, config, model, layout))
        yield Session(cell, layout, judge, recording)


@asynccontextmanager
async def connected(ocu: OCU, robot: str = ROBOT) -> AsyncIterator[Session]:
    """A running cell (`jauspy up cell`) that `ocu` reaches."""
    config = robot_files.load(robot)
    model = robot_files.robot_model(config)
    layout = Layout(model)
    async with ocu, CellClient(ocu, config, model, layout, threads=True) as cell:
        yield Session(cell, layout)
