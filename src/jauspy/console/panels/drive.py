"""The panel Drive: the mode (velocities, efforts or waypoints, as the robot offers), the stick, the limit, the pose."""

from __future__ import annotations

from collections.abc import Callable
from contextlib import suppress
from typing import TYPE_CHECKING, Any, Final

from nicegui import ui

from jauspy.console.console import Console
from jauspy.console.conventions import Conventions
from jauspy.console.languages import sentence
from jauspy.console.markup import attributes, plain_text
from jauspy.console.operation import EFFORT, MAX_SPEED, VELOCITY_MODE, modes_of
from jauspy.console.page_language import _, translated
from jauspy.console.route import LIST_DRIVER
from jauspy.errors import JausError
from jauspy.ocu.robot import Robot
from jauspy.ocu.state import RobotPose

if TYPE_CHECKING:
    from jauspy.console.console import Console

WAYPOINTS: Final = "waypoints"
NAMES: Final = {VELOCITY_MODE: sentence("velocity"), EFFORT: sentence("effort"), WAYPOINTS: sentence("waypoints")}
UPDATE_INTERVAL: Final = 0.5


class DriveModes:
    """The choice in the panel Drive, for one page; `open_map` shows the map. Waypoints never lock the stick.

    `show_limit` shows `limit_text` again, whose unit depends on the mode.
    """

    def __init__(
        self,
        console: Console,
        token: str,
        open_map: Callable[[], None],
        show_limit: Callable[[], None],
        conventions: Conventions,
    ) -> None:
        self._conventions = conventions
        self._console = console
        self._token = token
        self._open_map = open_map
        self._show_limit = show_limit
        self._shown = ""
        self._robot: Robot | None = None
        self._toggle = ui.toggle({}, on_change=self._choose).props("no-caps dense unelevated").classes("modes")
        ui.timer(UPDATE_INTERVAL, self._update)

    def show(self, robot: Robot | None) -> None:
        """Offer what this robot offers."""
        self._robot, self._shown = robot, ""
        if robot is None:
            return
        offered = modes_of(robot) + [WAYPOINTS] * any(component.find(LIST_DRIVER) for component in robot.components)
        self._toggle.set_options({way: translated(NAMES[way]) for way in offered}, value=None)
        self._toggle.set_visibility(len(offered) > 1)
        self._update()

    def limit_text(self, limit: float) -> str:
        """The speed limit as text, with the unit of the present mode."""
        operation = self._console.operation(self._robot.id) if self._robot is not None else None
        if operation is not None and operation.mode == EFFORT:
            return _("limit {share:.0%} of the effort", share=min(1.0, limit))
        return _("limit {speed}", speed=self._conventions.speed(limit))

    def _update(self) -> None:
        """Show the mode that the operator chose, in every browser."""
        operation = self._console.operation(self._robot.id) if self._robot is not None else None
        if operation is None:
            return
        world = self._console.worlds.get(operation.robot.id)
        drives_through_list = world is not None and world.route.active is not None
        now = WAYPOINTS if drives_through_list else operation.mode
        if self._toggle.value != now and now in self._toggle.options:
            self._toggle.set_value(now)
        if operation.mode != self._shown:
            self._shown = operation.mode
            self._show_limit()

    async def _choose(self, event: Any) -> None:
        operation = self._console.operation(self._robot.id) if self._robot is not None else None
        if operation is None or event.value in (None, operation.mode):
            return
        if event.value == WAYPOINTS:
            self._open_map()
        elif problem := operation.set_mode(self._token, event.value):
            operation.tell(self._token, problem)
            self._update()


POSE_INTERVAL: Final = 0.2
"""Seconds between two queries of the pose."""
DRIVERS: Final = ("PrimitiveDriver", "VelocityStateDriver")
"""Services with which a robot is driven manually."""


class DrivePanel:
    """Driving the chosen robot, for one page, which `token` names; the keys and the stick are in console.js.

    `open_map` shows where waypoints are set.
    """

    def __init__(self, console: Console, token: str, open_map: Callable[[], None], conventions: Conventions) -> None:
        self._conventions = conventions
        self._console = console
        self._token = token
        self._robot: Robot | None = None
        with ui.element("section").classes("panel drive") as self._panel:
            attributes(self._panel, aria_label=_("Drive"))
            with ui.element("div").classes("row"):
                ui.label(_("Drive")).classes("heading")
                keys = ui.label(_("W A S D, arrows, stick, gamepad")).classes("hint")
                attributes(keys, data_keys=True)
            self._modes = DriveModes(console, token, open_map, self._show_limit, conventions)
            with ui.element("div").classes("row"):
                with ui.element("div").props('id=stick role="img"') as stick:
                    ui.element("div").props("id=stick-knob")
                attributes(stick, data_keys=True, aria_label=_("stick; drive by the keys W A S D or the arrows"))
                with ui.element("div").classes("facts"):
                    with ui.element("div") as self._pose:
                        self._position = plain_text("", tag="b")
                        self._heading, self._attitude = ui.label(""), ui.label("")
                    self._limit = ui.slider(min=0.1, max=MAX_SPEED, step=0.1, value=0.5, on_change=self._show_limit)
                    attributes(self._limit, aria_label=_("limit of the speed in m/s"))
                    self._limit_text = ui.label("").classes("hint")
            with ui.element("details").classes("gamepads").props("hidden"):
                plain_text(_("Gamepad"), tag="summary")
                ui.html('<div id="gamepads"></div>', sanitize=False).classes("gamepad-cards")
            ui.html('<span id="drive-answer" class="problem" role="status"></span>', sanitize=False)
        conventions.on_change.append(self._show_limit)
        self.show(None)
        ui.timer(POSE_INTERVAL, self._update)

    def show(self, robot: Robot | None) -> None:
        """Drive this robot; the panel is hidden if it cannot be driven."""
        self._robot = robot
        for text in (self._position, self._heading, self._attitude):
            text.set_text("")
        drives = robot is not None and any(component.find(name) for component in robot.components for name in DRIVERS)
        self._panel.set_visibility(drives)
        self._modes.show(robot)

    def close(self) -> None:
        """Handle the end of the page."""
        self._robot = None

    def _show_limit(self) -> None:
        self._limit_text.set_text(self._modes.limit_text(self._limit.value))

    async def _update(self) -> None:
        if self._robot is None:
            return
        operation = self._console.operation(self._robot.id)
        if operation is not None:
            operation.set_limit(self._token, float(self._limit.value))
        pose: RobotPose | None = None
        with suppress(JausError):
            pose = await self._robot.pose()
        self._pose.classes(add="stale" if pose is None else "", remove="" if pose is None else "stale")
        if pose is None:
            return
        shown = self._conventions
        self._position.set_text(shown.position(pose.x, pose.y))
        self._heading.set_text(translated(shown.yaw(pose.yaw)))
        self._attitude.set_text(translated(shown.attitude(pose.pitch, pose.roll)))
