"""What the pointer does in the large picture: turns the camera, and measures how far away something is."""

from __future__ import annotations

import asyncio
from collections.abc import Callable, Coroutine
from typing import Any, Final

from nicegui import ui

from jauspy.console.console import Console
from jauspy.console.conventions import Conventions
from jauspy.console.languages import sentence
from jauspy.console.markup import attributes, call
from jauspy.console.page_language import _, translated
from jauspy.console.sighting import (
    DIRECTION_NAMES,
    DIRECTIONS,
    CameraHead,
    gripper_width,
    lens_of,
    pans_and_tilts,
    shown,
    sight,
)
from jauspy.console.world import World
from jauspy.errors import ConfigError, JausError, RequestError
from jauspy.ocu.robot import Robot
from jauspy.ocu.subsystems import ComponentInfo
from jauspy.printable import printable

MAX_ASPECT: Final = 10.0
TURN_STEP: Final = 0.1
"""Radians of one turn by a gamepad, which sends five a second."""
JOINTS_TIME: Final = 0.6
"""Seconds after which the joints of a robot that was not watched are known."""


class Pointing:
    """The pointer in the pictures of one page, which `token` names; `chosen` returns the large camera's component.

    `say` shows a text; if its second argument is one, only in place of that.
    """

    def __init__(
        self,
        console: Console,
        token: str,
        chosen: Callable[[], ComponentInfo | None],
        say: Callable[[str, str | None], object],
        conventions: Conventions,
    ) -> None:
        self._conventions = conventions
        self._console = console
        self._token = token
        self._chosen = chosen
        self._say = say
        self._problem = ""
        """Why the last act failed; empty after one that did not."""
        self._robot: Robot | None = None
        self._world: World | None = None
        """Followed since something was measured."""
        self._heads: dict[str, CameraHead] = {}
        self._from: tuple[float, float] | None = None
        """Where the camera looked when the drag began."""
        self._task: asyncio.Task[None] | None = None
        self._button = ui.button(_("look \u25be"), color=None).props("outline no-caps dense")
        with self._button, attributes(ui.menu(), aria_label=_("directions of the camera")):
            for name in DIRECTIONS:
                ui.menu_item(
                    translated(DIRECTION_NAMES[name]),
                    on_click=lambda name=name: self._begin(self._look(*DIRECTIONS[name])),
                )
        self._button.tooltip(_("turn this camera; also: drag the picture, or click what to look at"))
        self._button.set_visibility(False)
        ui.on("camera_pointed", self._take)

    def show(self, robot: Robot | None) -> None:
        """Point with the cameras of this robot."""
        if robot is None or self._robot is None or robot.id != self._robot.id:
            self.close()
        self._robot, self._heads = robot, {}

    def chose(self) -> None:
        """Follow the choice of another large picture."""
        component = self._chosen()
        turns = component is not None and pans_and_tilts(component)
        self._button.set_visibility(turns)
        call("jauspy.sight.choose", turns)

    def close(self) -> None:
        """Follow nothing any more."""
        if self._world is not None:
            self._world.unwatched_by(self)
        if self._task is not None:
            self._task.cancel()
        self._world = self._task = None

    # --- what the pointer did ---------------------------------------------------------------------------------------

    def _take(self, event: Any) -> None:
        """Handle a click or a drag: after checking its values."""
        asked = event.args
        if not isinstance(asked, dict) or (component := self._chosen()) is None:
            return
        try:
            x, y, aspect = (float(asked[key]) for key in ("x", "y", "aspect"))
        except (KeyError, TypeError, ValueError):
            return
        if not (-1.0 <= x <= 2.0 and -1.0 <= y <= 2.0 and 1.0 / MAX_ASPECT <= aspect <= MAX_ASPECT):
            return
        turns = pans_and_tilts(component)
        if asked.get("what") == "turn":
            if turns:
                self._begin(self._turn(component, x, y))
        elif asked.get("what") == "measure" or not turns:
            self._begin(self._measure(component, x, y, aspect))
        elif asked.get("what") == "look":
            self._begin(self._look_at(component, x, y, aspect))
        elif asked.get("what") == "drag":
            self._begin(self._drag(component, x, y, aspect, is_first=asked.get("first") is True))

    def _begin(self, act: Coroutine[Any, Any, None]) -> None:
        """Do one thing after another; what comes while one is under way is left out, since a newer one follows."""
        if self._robot is None or (self._task is not None and not self._task.done()):
            act.close()
            return
        self._task = asyncio.create_task(self._try(act), name="console: pointing of a camera")

    async def _try(self, act: Coroutine[Any, Any, None]) -> None:
        try:
            await act
        except JausError as error:
            with self._button:  # of this page
                self._problem = printable(translated(str(error)))
                self._say(self._problem, None)
        else:
            self._say("", self._problem)
            self._problem = ""

    def _head(self, component: ComponentInfo) -> CameraHead:
        robot = self._robot
        operation = None if robot is None else self._console.operation(robot.id)
        if robot is None or operation is None:
            raise ConfigError(sentence("the robot has gone"))
        if why := operation.refusal(self._token):
            raise RequestError(sentence("the camera is not turned: {why}", why=why))
        return self._heads.setdefault(str(component.id), CameraHead(robot, component))

    async def _look(self, right: float, up: float) -> None:
        component = self._chosen()
        if component is not None:
            await self._head(component).look(right, up)

    async def _look_at(self, component: ComponentInfo, x: float, y: float, aspect: float) -> None:
        """Turn the camera so that what was clicked comes to the middle."""
        head = self._head(component)
        assert self._robot is not None
        lens = await lens_of(self._robot, component, aspect)
        now, off = await head.direction(), lens.angles(x, y)
        await head.look(now[0] + off[0], now[1] + off[1])

    async def _turn(self, component: ComponentInfo, right: float, up: float) -> None:
        """Turn the camera a little, by shares of `TURN_STEP`."""
        head = self._head(component)
        now = await head.direction()
        await head.look(now[0] + TURN_STEP * right, now[1] + TURN_STEP * up)

    async def _drag(self, component: ComponentInfo, x: float, y: float, aspect: float, *, is_first: bool) -> None:
        """Turn the camera against the way of the pointer, as if it held the picture; x and y are that way."""
        head = self._head(component)
        assert self._robot is not None
        if is_first or self._from is None:
            self._from = await head.direction()
        lens = await lens_of(self._robot, component, aspect)
        await head.look(self._from[0] - x * lens.horizontal, self._from[1] + y * lens.vertical)

    async def _measure(self, component: ComponentInfo, x: float, y: float, aspect: float) -> None:
        """Say how far away is what was clicked, and draw the gripper's width there."""
        robot = self._robot
        world = None if robot is None else self._console.worlds.opened(robot.id, self._token)
        if robot is None or world is None:
            return
        if self._world is not world:
            await world.watched_by(self)
            self._world = world
            await asyncio.sleep(JOINTS_TIME)
        lens = await lens_of(robot, component, aspect)
        found = await sight(world, robot, component, lens.ray(x, y))
        width = await gripper_width(robot)
        share = 0.0 if width is None else lens.width_share(width, found.distance)
        mark = {"component": str(component.id), "x": x, "y": y, "width": share}
        with self._button:  # of this page
            call("jauspy.sight.show", {**mark, "text": translated(shown(found, width, self._conventions))})
