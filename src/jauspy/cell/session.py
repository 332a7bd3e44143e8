"""A cell for one task: simulated on virtual time as fast as the machine can, and filmed, or a running one elsewhere."""

from __future__ import annotations

import asyncio
import math
import time
from collections.abc import AsyncIterator, Callable
from contextlib import AsyncExitStack, asynccontextmanager
from dataclasses import dataclass, replace
from fractions import Fraction
from importlib import import_module
from pathlib import Path
from typing import Any, Final, Self

from jauspy import backends
from jauspy.cell.client import CellClient
from jauspy.cell.judge import Judge, WatchedBackend
from jauspy.cell.scene import Layout
from jauspy.errors import ConfigError
from jauspy.logs import get_logger
from jauspy.ocu import OCU
from jauspy.platform.camera import CameraSession, CameraSource
from jauspy.platform.contract import Robot
from jauspy.platform.description import RobotModel
from jauspy.robot import robot_files
from jauspy.robot.config import RobotConfig
from jauspy.robot.runner import RobotRunner
from jauspy.virtual.environment import VirtualTime
from jauspy.virtual.network import VirtualNetwork

_LOG: Final = get_logger(__name__)

ROBOT: Final = "cell"
OCU_ID: Final = "42.1.1"
TURNED_OVER: Final = 0.25
"""Fraction of scattered parts that lie on another side."""


@dataclass(frozen=True, slots=True)
class Disturbances:
    """Differences from the file: largest errors of the parts' poses (m, rad), and the fraction of grasps that fail."""

    position: float = 0.010
    angle: float = math.radians(5.0)
    attach_failure: float = 0.02
    scatter: bool = False
    """True for parts anywhere in their bins, turned at will."""


UNDISTURBED: Final = Disturbances(0.0, 0.0, 0.0)


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
    network: VirtualNetwork | None = None
    """The network of a cell that is simulated here, for further clients."""

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
    cell = replace(
        config.cell,
        seed=seed,
        sensor=replace(config.cell.sensor, seed=seed),
        pose_error=(disturbances.position, disturbances.angle),
        attach_failure=disturbances.attach_failure,
        scatter=disturbances.scatter,
        turned_over=TURNED_OVER,
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
    robot: str = ROBOT,
    change: Callable[[RobotModel], RobotModel] = lambda model: model,
    configure: Callable[[RobotConfig], RobotConfig] = lambda config: config,
) -> AsyncIterator[Session]:
    """A simulated cell on virtual time, with a client that controls it; the same seed gives the same run.

    `camera` is the name of the one that films; `view` opens a window, and the cell is then no faster than the clock.
    `change` makes the cell another one, as with a load that is bolted to it; `configure` changes its configuration.
    """
    config = configure(configured(seed, disturbances or Disturbances(), robot))
    layout = Layout(change(robot_files.robot_model(config)))
    backend = WatchedBackend(backends.find(config.backend), change)
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
        cell = await stack.enter_async_context(CellClient(ocu, config, layout))
        yield Session(cell, layout, judge, recording, network)


@asynccontextmanager
async def connected(ocu: OCU, robot: str = ROBOT) -> AsyncIterator[Session]:
    """A running cell (`jauspy up cell`) that `ocu` reaches."""
    config = robot_files.load(robot)
    model = robot_files.robot_model(config)
    layout = Layout(model)
    async with ocu, CellClient(ocu, config, layout, threads=True) as cell:
        yield Session(cell, layout)


FILM_RATE: Final = 25
FILM_SIZE: Final = (1280, 720)
"""Width and height, pixels."""
FILM_CODEC: Final = "libx264"


class Film:
    """`async with Film(path, camera)`: films 25 pictures for each second of the event loop's time.

    An error while filming ends the film only; `problem` names it after the block.
    """

    def __init__(self, path: Path, camera: CameraSource | None, *, size: tuple[int, int] = FILM_SIZE) -> None:
        if camera is None:
            raise ConfigError("the cell has no camera to film with")
        self.path = path
        self.pictures = 0
        self.problem = ""
        """Why the film is incomplete, as a sentence; empty if it is not."""
        self._camera = camera
        self._size = size
        self._session: CameraSession | None = None
        self._task: asyncio.Task[None] | None = None
        self._container: Any = None
        self._stream: Any = None
        self._av: Any = None

    async def __aenter__(self) -> Self:
        try:
            self._av = import_module("av")
        except ImportError:
            raise ConfigError("films need PyAV; install the extra 'video'") from None
        try:
            self.path.parent.mkdir(parents=True, exist_ok=True)
            self._container = self._av.open(str(self.path), "w")
            self._stream = self._container.add_stream(FILM_CODEC, rate=FILM_RATE)
            self._stream.width, self._stream.height = self._size
            self._stream.pix_fmt = "yuv420p"
            self._stream.options = {"crf": "22", "preset": "veryfast"}
            self._container.start_encoding()  # opens the file, which the first picture would do otherwise
        except OSError as error:
            raise ConfigError(f"{self.path} cannot be written: {error}") from error
        self._session = self._camera.open()
        self._task = asyncio.create_task(self._record(), name="film")
        return self

    async def __aexit__(self, _type: object, raised: BaseException | None, _traceback: object) -> None:
        assert self._task is not None
        assert self._session is not None
        self._task.cancel()
        await asyncio.wait({self._task})
        if not self._task.cancelled():
            self._note(self._task.exception())
        try:
            for packet in self._stream.encode():
                self._container.mux(packet)
        except self._av.FFmpegError as error:
            self._note(error)
        try:
            self._container.close()
        except self._av.FFmpegError as error:
            self._note(error)
        self._session.close()
        if raised is not None and self.problem:
            raised.add_note(self.problem)

    def _note(self, error: BaseException | None) -> None:
        """Keep the first error: those after it are its consequences."""
        if not self.problem:
            _LOG.debug("filming has failed", exc_info=error)
            seconds = self.pictures / FILM_RATE
            why = str(error) or repr(error)
            self.problem = f"the film {self.path} is incomplete: it ends after {seconds:.1f} s: {why}"

    async def _record(self) -> None:
        loop = asyncio.get_running_loop()
        due = loop.time()
        assert self._session is not None
        while True:
            picture = self._session.look(*self._size, thoroughly=True)
            frame = self._av.VideoFrame.from_ndarray(picture.image, format="rgb24")
            frame.pts, frame.time_base = self.pictures, Fraction(1, FILM_RATE)
            for packet in self._stream.encode(frame):
                self._container.mux(packet)
            self.pictures += 1
            due += 1.0 / FILM_RATE
            await asyncio.sleep(due - loop.time())
