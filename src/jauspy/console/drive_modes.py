"""How a robot is driven, as it offers: velocities, efforts (wrench), or waypoints on the map."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any, Final

from nicegui import ui

from jauspy.console.operation import EFFORT, VELOCITY_MODE, modes_of
from jauspy.console.route import LIST_DRIVER
from jauspy.ocu.robot import Robot

if TYPE_CHECKING:
    from jauspy.console.server import Console

WAYPOINTS: Final = "waypoints"
NAMES: Final = {VELOCITY_MODE: "velocity", EFFORT: "effort", WAYPOINTS: "waypoints"}
UPDATE_INTERVAL: Final = 0.5


class DriveModes:
    """The choice in the panel Drive, for one page; `open_map` shows the map. Waypoints never lock the stick.

    `show_limit` shows `limit_text` again, whose unit depends on the mode.
    """

    def __init__(
        self, console: Console, token: str, open_map: Callable[[], None], show_limit: Callable[[], None]
    ) -> None:
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
        offered = modes_of(robot) + [WAYPOINTS] * any(each.find(LIST_DRIVER) for each in robot.components)
        self._toggle.set_options({each: NAMES[each] for each in offered}, value=None)
        self._toggle.set_visibility(len(offered) > 1)
        self._update()

    def limit_text(self, limit: float) -> str:
        """What the limit of the speed means in the present mode."""
        operation = self._console.operation(self._robot.id) if self._robot is not None else None
        if operation is not None and operation.mode == EFFORT:
            return f"limit {min(1.0, limit):.0%} of the effort"
        return f"limit {limit:.1f} m/s"

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
            operation.problem = problem
            self._update()
