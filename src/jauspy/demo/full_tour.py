"""The whole demo: records videos and a map during the drive, then looks, reaches, grasps, lifts. Needs extra `all`."""

from __future__ import annotations

import asyncio
import math
import time
from collections import deque
from collections.abc import AsyncIterator, Sequence
from contextlib import AsyncExitStack, aclosing, asynccontextmanager
from dataclasses import dataclass, field
from pathlib import Path
from statistics import median
from typing import Final

import numpy as np
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure

from jauspy.demo import plan
from jauspy.demo.grasp import ARM_CAMERA, STILL_FILE, Grasp, aim
from jauspy.demo.plan import Plan
from jauspy.demo.report import DemoState, Report, StageResult, View
from jauspy.demo.tour import Tour
from jauspy.errors import RequestError
from jauspy.geometry.poses import PlanarPose
from jauspy.mapping.grid import OccupancyGrid, Points, transformed
from jauspy.mapping.live import LiveMapping
from jauspy.mapping.map_files import save_map
from jauspy.mapping.mapper import MAX_RANGE, Mapper
from jauspy.ocu import OCU, Camera, Robot, RobotControl
from jauspy.ocu.frames import RobotFrames
from jauspy.robot.config import CameraTable, RobotConfig
from jauspy.video.h264_payload import Picture
from jauspy.video.recorder import Recorder

LOCALHOST: Final = "127.0.0.1"
STILL_SIZE: Final = (640, 480)
"""Width and height in pixels, whatever those of the videos: the height of the table is measured to some millimetres."""
MAX_LATENCIES: Final = 3000


@dataclass(slots=True)
class VideoRecording:
    """A camera's video: its file and the measured delays."""

    name: str
    camera: Camera
    recorder: Recorder
    wanted: int
    """Pictures per second that the camera is set to."""
    latencies: deque[float] = field(default_factory=lambda: deque(maxlen=MAX_LATENCIES))
    began: float = field(default_factory=time.monotonic)
    ended: float = 0.0
    failure: str = ""
    """Why no more pictures came."""
    note: str = ""
    """Last note of the camera about a machine that is too slow."""

    async def run(self) -> None:
        """Record until this is cancelled, or no further picture has come for `plan.CAMERA_TIMEOUT`."""
        pictures = self.camera.encoded(address=LOCALHOST, timeout=plan.LONG_CAMERA_TIMEOUT, silence=plan.CAMERA_TIMEOUT)
        try:
            async with aclosing(pictures):
                async for picture in pictures:
                    self.add(picture)
        except RequestError as error:
            self.failure = f"camera {self.name}: {error}"

    def add(self, picture: Picture) -> None:
        """Write a picture, with its delay and with what the camera says."""
        self.recorder.add(picture)
        self.note = self.camera.note or self.note
        if (taken := self.camera.taken(picture)) is not None:
            self.latencies.append(time.time() - taken.timestamp())

    async def begins(self) -> None:
        """Wait for the first picture; raises `RequestError` after `plan.CAMERA_TIMEOUT`.

        A camera that says that it is still starting has until `plan.LONG_CAMERA_TIMEOUT`.
        """
        while not self.recorder.pictures:
            limit = plan.LONG_CAMERA_TIMEOUT if (note := self.camera.note) else plan.CAMERA_TIMEOUT
            if self.failure:
                raise RequestError(self.failure)
            if time.monotonic() - self.began > limit:
                raise RequestError(
                    f"camera {self.name}: no picture in {limit:g} s" + (f"; it says: {note}" if note else "")
                )
            await asyncio.sleep(0.05)
        self.began, self.note = time.monotonic(), ""

    def result(self) -> StageResult:
        """Rate, losses and delay; no packet may be lost, and not more than half of the pictures be missing.

        A camera that says that its machine is too slow has reached less, and that is said.
        """
        pictures, counters = self.recorder.pictures, self.camera.counters
        lost, damaged = counters.get("lost", 0), counters.get("damaged", 0)
        rate = pictures / max(self.ended - self.began, 1e-3)
        late = median(self.latencies) if self.latencies else 0.0
        least = plan.MIN_REDUCED_RATE if self.note else plan.MIN_RATE * self.wanted
        is_whole = rate >= least and not lost and not damaged and not self.failure
        said = f"; it said: {self.note}" if self.note else ""
        return StageResult(
            f"{self.name} video",
            f"{pictures} pictures ({rate:.1f} of {self.wanted} Hz), {lost or 'no'} packets lost, "
            f"{damaged or 'none'} damaged; {1e3 * late:.0f} ms delay (median){said}"
            + (self.failure and f"; {self.failure}"),
            is_whole,
            {
                "pictures": pictures,
                "rate": rate,
                "wanted_rate": self.wanted,
                "packets_lost": lost,
                "damaged": damaged,
                "latency": late,
            },
            reduced=is_whole and bool(self.note),
        )


@asynccontextmanager
async def recorded(
    camera: Camera, setup: CameraTable, file: Path, size: tuple[int, int]
) -> AsyncIterator[VideoRecording]:
    """Record the camera's video in that size while this context is open."""
    await camera.set_video(size=size, rate=setup.rate, authority=plan.AUTHORITY)
    with Recorder(file) as recorder:
        recording = VideoRecording(setup.name, camera, recorder, setup.rate)
        running = asyncio.create_task(recording.run(), name=f"video of {setup.name}")
        try:
            yield recording
        finally:
            recording.ended = time.monotonic()
            running.cancel()
            await asyncio.wait({running})


MAP_SIZE: Final = 20.0
"""Side of the map, m."""
MIN_AGREEMENT: Final = 0.9
"""Minimal share of echoes that must be in occupied cells."""
MAX_HELDOUT_SCANS: Final = 500
"""Scans kept to check the map."""


class HoldoutMapper(Mapper):
    """A mapper that keeps the echoes of scans that it does not use, to check the map with them."""

    def __init__(self, grid: OccupancyGrid) -> None:
        super().__init__(grid)
        self.scans = 0
        self.others: deque[Points] = deque(maxlen=MAX_HELDOUT_SCANS)

    def add(
        self, odometry: PlanarPose, lidar: PlanarPose, angles: Sequence[float], ranges: Sequence[float]
    ) -> PlanarPose:
        """Add a scan to the map, as `Mapper.add` does."""
        used, pose = len(self.path), super().add(odometry, lidar, angles, ranges)
        self.scans += 1
        if len(self.path) == used:
            bearings, far = np.asarray(angles), np.asarray(ranges)
            echoes = (far > 0.0) & (far < MAX_RANGE)
            bearings, far = bearings[echoes], far[echoes]
            self.others.append(
                transformed(pose @ lidar, np.column_stack([far * np.cos(bearings), far * np.sin(bearings)]))
            )
        return pose

    def agreement(self) -> float:
        """Share of the unused scans' echoes that are in or beside an occupied cell."""
        if not self.others:
            return 0.0
        taken = np.pad(self.grid.occupancy() == 100, 1)
        near = np.logical_or.reduce([np.roll(taken, (dy, dx), (0, 1)) for dy in (-1, 0, 1) for dx in (-1, 0, 1)])
        columns, rows = np.rint(self.grid.cell_coordinates(np.concatenate(list(self.others)))).astype(int).T + 1
        inside = (columns > 0) & (rows > 0) & (columns <= self.grid.cells) & (rows <= self.grid.cells)
        return float(near[rows[inside], columns[inside]].mean()) if inside.any() else 0.0


class MapRecording:
    """Maps during the drive."""

    def __init__(self, robot: Robot, state: DemoState) -> None:
        self._mapper = HoldoutMapper(OccupancyGrid(MAP_SIZE))
        self._live = LiveMapping(robot, self._mapper, threaded=True)
        self._state = state
        self._task: asyncio.Task[None] | None = None

    @asynccontextmanager
    async def made(self) -> AsyncIterator[None]:
        """Add scans to the map in the block."""
        self._task = asyncio.create_task(self._live.run())
        counting = asyncio.create_task(self._count())
        try:
            yield
        finally:
            for task in (self._task, counting):
                task.cancel()
            await asyncio.gather(self._task, counting, return_exceptions=True)  # `finish` has raised what went wrong

    async def finish(self, folder: Path) -> tuple[StageResult, list[str]]:
        """Check the map with the unused scans and save it; returns the result and the names of the files."""
        if self._task is not None and self._task.done():
            self._task.result()
        agreement = self._mapper.agreement()
        files = save_map(self._mapper.grid, folder / "map")
        known = int((self._mapper.grid.occupancy() != -1).sum()) * self._mapper.grid.resolution**2
        used = len(self._mapper.path)
        result = StageResult(
            "map",
            f"{known:.0f} m² from {used} scans; of the echoes of the {len(self._mapper.others)} unused "
            f"scans, {100 * agreement:.1f} % are in occupied cells",
            agreement >= MIN_AGREEMENT,
            {"agreement": agreement, "area": known, "scans": self._mapper.scans},
        )
        return result, [file.name for file in files]

    async def _count(self) -> None:
        while True:
            self._state.scans = self._mapper.scans
            await asyncio.sleep(0.2)


JOINT_NAMES: Final = ("turn", "shoulder", "elbow", "wrist", "roll")
MIN_HALF_RANGE: Final = 2.5
"""Degrees; half of the minimal range of an axis, so that noise is not magnified."""


def plot_joints(state: DemoState, file: Path) -> None:
    """Plot joint positions and commands as PNG, in degrees."""
    times, positions = zip(*state.positions, strict=True)
    moments, commands = zip(*state.commands, strict=True)
    began, end = moments[0] - 1.0, times[-1]
    phases = [(moment, text) for moment, text in state.phases if moment >= began]
    figure = Figure(figsize=(11, 9), layout="constrained")
    axes = figure.subplots(len(JOINT_NAMES), 1, sharex=True)
    for joint, (axis, name) in enumerate(zip(axes, JOINT_NAMES, strict=True)):
        commanded = [math.degrees(command[joint]) for command in commands]
        axis.step(
            [*moments, end], [*commanded, commanded[-1]], where="post", color="0.45", linestyle="--", linewidth=1.2
        )
        axis.plot(times, [math.degrees(position[joint]) for position in positions], color="C0", linewidth=1.6)
        axis.set_ylabel(f"{name}\ndegrees")
        axis.grid(alpha=0.3)
        low, high = axis.get_ylim()
        margin = max(0.1 * (high - low), MIN_HALF_RANGE - (high - low) / 2.0)
        axis.set_ylim(low - margin, high + margin)
        for moment, _ in phases:
            axis.axvline(moment, color="C1", alpha=0.4, linewidth=0.8)
    axes[0].legend(("command", "position"), loc="upper right", ncols=2)
    for moment, text in phases:
        axes[0].annotate(text, (moment, 1.0), (2, 3), xycoords=("data", "axes fraction"), textcoords="offset points",
                         rotation=45, fontsize=8, color="0.3")  # fmt: skip
    axes[-1].set_xlabel("seconds since the demo began")
    axes[-1].set_xlim(began, end)
    figure.suptitle("inc1's arm: joint positions against commands")
    FigureCanvasAgg(figure)
    figure.savefig(file)


CHASSIS_CAMERA: Final = "chassis"
"""The camera on the pan-tilt unit."""


class FullTour(Tour):
    """The tour in a world with something to grasp."""

    def __init__(
        self,
        ocu: OCU,
        config: RobotConfig,
        view: View,
        report: Report,
        folder: Path,
        *,
        goals: Plan,
        size: tuple[int, int],
    ) -> None:
        """`size` is that of the videos: width and height in pixels."""
        super().__init__(ocu, config, view, report, folder, goals=goals)
        self._size = size

    async def run(self) -> None:
        """Run all steps; see `Tour.run`."""
        robot = await self._discover()
        async with AsyncExitStack() as stack:
            control, arm = await self._begin(stack, robot)
            recordings = await self._record(stack, robot)
            await self._drive(robot, control)
            await self._aim(stack, robot)
            frames, camera = RobotFrames(robot, self._model, self._config.movers), robot.camera(ARM_CAMERA)
            grasp = Grasp(arm, frames, self._model, camera, size=STILL_SIZE, goals=self._plan)
            thing = self._plan.thing.name
            self._step("look", f"Look for the {thing} with the arm's camera")
            self._add(await grasp.look(self._folder))
            self._step("reach", f"Reach for the {thing}")
            self._add(await grasp.reach())
            self._step("grasp", "Close the gripper")
            self._add(await grasp.close())
            self._step("lift", f"Lift the {thing}")
            self._add(await grasp.lift())
            self._step("", "Standby, release control")
        for recording in recordings.values():
            self._add(recording.result())
        self._draw()

    async def _record(self, stack: AsyncExitStack, robot: Robot) -> dict[str, VideoRecording]:
        recordings = {}
        setups = {camera.name: camera for camera in self._config.cameras}
        for module in self._config.modules:
            if module.camera is not None:
                self._view.step(f"Record camera {module.camera} of {self._config.id_of(module)}")
                file = self._folder / f"{module.camera}.mp4"
                recording = recorded(robot.camera(module.camera), setups[module.camera], file, self._size)
                recordings[module.camera] = await stack.enter_async_context(recording)
                self._state.recordings[module.camera] = recordings[module.camera]
                self._report.files.append(file.name)
        await asyncio.gather(*(recording.begins() for recording in recordings.values()))
        return recordings

    async def _drive(self, robot: Robot, control: RobotControl) -> None:
        mapping = MapRecording(robot, self._state)
        async with mapping.made():
            self._step("drive", f"Drive {self._plan.drive}, mapping on the way")
            self._add(await self._drive_there(robot, control))
            found, files = await mapping.finish(self._folder)
        self._add(found)
        self._report.files += files

    async def _aim(self, stack: AsyncExitStack, robot: Robot) -> None:
        self._step("aim", "Point the camera on the chassis to it")
        mount = next(module.component for module in self._config.modules if module.camera == CHASSIS_CAMERA)
        self._add(await aim(stack, robot, mount, self._plan.aim))

    def _draw(self) -> None:
        plot_joints(self._state, self._folder / "joints.png")
        self._report.files += [STILL_FILE, "joints.png"]
