"""The whole script: cameras and a map beside the drive; then look, reach, grasp, lift. Needs the extras of the demo."""

from __future__ import annotations

import asyncio
from contextlib import AsyncExitStack
from pathlib import Path
from typing import Final

from jauspy.cli.demo import plan
from jauspy.cli.demo.aim import look_up
from jauspy.cli.demo.chart import draw
from jauspy.cli.demo.drive import to_the_table
from jauspy.cli.demo.film import Film, filmed
from jauspy.cli.demo.grasp import CAMERA, STILL, Grasp
from jauspy.cli.demo.mapped import DriveMap
from jauspy.cli.demo.report import Report
from jauspy.cli.demo.tour import Tour
from jauspy.cli.demo.watch import Watcher
from jauspy.modules.config import RobotConfig
from jauspy.ocu import OCU, Control
from jauspy.ocu.frames import RobotFrames
from jauspy.ocu.robot import ComponentClient, Robot
from jauspy.services.environment_sensing.frame_sizes import SIZES, FrameSize

AIMED: Final = "chassis"
"""The camera that a mount turns."""


class WholeTour(Tour):
    """In a world with a table and a can."""

    def __init__(
        self, ocu: OCU, config: RobotConfig, watcher: Watcher, report: Report, folder: Path, *, size: FrameSize
    ) -> None:
        """`size` is that of the films."""
        super().__init__(ocu, config, watcher, report, folder)
        self._size = size

    async def run(self) -> None:
        """As `Tour.run`."""
        robot = await self._discover()
        async with AsyncExitStack() as stack:
            driving, arm = await self._begin(stack, robot)
            films = await self._film(stack, robot)
            await self._drive(robot, driving)
            await self._aim(stack, robot)
            frames, eye = RobotFrames(robot, self._model, self._config.movers), self._camera(robot, CAMERA)
            grasp = Grasp(arm, frames, self._model, eye, SIZES[self._size])
            self._step("look", "Look for the can with the arm's camera")
            self._found(await grasp.look(self._folder))
            self._step("reach", "Reach for the can")
            self._found(await grasp.reach())
            self._step("grasp", "Close the gripper")
            self._found(await grasp.close())
            self._step("lift", "Lift the can")
            self._found(await grasp.lift())
            self._step("", "Standby, release control")
        for film in films.values():
            self._found(film.finding())
        self._draw()

    async def _film(self, stack: AsyncExitStack, robot: Robot) -> dict[str, Film]:
        films = {}
        for module in self._config.modules:
            if module.camera is not None:
                self._watcher.step(f"Record camera {module.camera} of {self._config.id_of(module)}")
                file = self._folder / f"{module.camera}.mp4"
                film = filmed(self._ocu, robot.component(module.component), module.camera, file, self._size)
                films[module.camera] = await stack.enter_async_context(film)
                self._scene.films[module.camera] = films[module.camera]
                self._report.files.append(file.name)
        await asyncio.gather(*(film.begins() for film in films.values()))
        return films

    async def _drive(self, robot: Robot, driving: Control) -> None:
        mapping = DriveMap(robot, self._scene)
        async with mapping.made():
            self._step("drive", f"Drive {plan.STAND[0]:g} m to the table and turn to it, mapping on the way")
            self._found(await to_the_table(robot, driving, self._scene))
            found, files = await mapping.finish(self._folder)
        self._found(found)
        self._report.files += files

    async def _aim(self, stack: AsyncExitStack, robot: Robot) -> None:
        self._step("aim", "Point the camera on the chassis up")
        self._found(await look_up(stack, self._camera(robot, AIMED)))

    def _camera(self, robot: Robot, name: str) -> ComponentClient:
        return robot.component(next(each.component for each in self._config.modules if each.camera == name))

    def _draw(self) -> None:
        draw(self._scene, self._folder / "joints.png")
        self._report.files += [STILL, "joints.png"]
