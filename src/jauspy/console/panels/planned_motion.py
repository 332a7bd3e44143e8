"""The row of the tab World about the planned motion of the arm: shown as a ghost, paused, cancelled."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from nicegui import ui

from jauspy.console.languages import sentence
from jauspy.console.markup import attributes, call
from jauspy.console.motion import Motion
from jauspy.console.page_language import _, translated
from jauspy.ocu.planner import PLANNER
from jauspy.ocu.robot import Robot
from jauspy.printable import printable

if TYPE_CHECKING:
    from jauspy.console.console import Console

UPDATE_INTERVAL: Final = 0.4
"""Seconds between two looks at what the planner does."""


class PlannedMotionRow:
    """The row, for one page, which `token` names; hidden while the robot's planner has nothing to tell."""

    def __init__(self, console: Console, token: str) -> None:
        self._console, self._token = console, token
        self._motion = Motion(console, token)
        self._robot: Robot | None = None
        with ui.element("div").classes("row tight") as self._row:
            attributes(self._row, aria_label=_("Planned motion"))
            ui.label(_("Planned motion")).classes("heading")
            self._text = ui.label("").classes("hint grow").props('role="status"')
            play = ui.checkbox(_("play"), value=True).props("dense")
            play.on_value_change(lambda event: call("jauspy.world.set", "play", bool(event.value)))
            self._cancel = ui.button(_("cancel motion"), on_click=self._on_cancel).props("outline no-caps")
            self._problem = ui.label("").classes("problem").props('role="alert"')
        self._row.set_visibility(False)
        ui.timer(UPDATE_INTERVAL, self._update)

    def show(self, robot: Robot | None) -> None:
        """Show the planned motion of this robot."""
        if robot is None or self._robot is None or robot.id != self._robot.id:
            self._motion.stop()
            self._row.set_visibility(False)
        self._robot = robot

    def close(self) -> None:
        """Handle the end of the page."""
        self._motion.stop()
        self._robot = None

    def _update(self) -> None:
        robot = self._robot
        world = None if robot is None else self._console.worlds.get(robot.id)
        if robot is None or world is None:
            return
        text = world.planned.text
        self._row.set_visibility(bool(text))
        self._text.set_text(printable(translated(text)))
        state = world.planned.state
        is_active = state is not None and state.phase in ("planning", "planned", "executing")
        self._cancel.set_enabled(is_active and not self._motion.is_running and not self._motion.refusal(robot.id))
        self._problem.set_text(printable(translated(self._motion.problem)))

    def _on_cancel(self) -> None:
        robot = self._robot
        if robot is not None:
            self._motion.begin(robot.id, self._take_over(robot), sentence("cancelling the planned motion"))

    async def _take_over(self, robot: Robot) -> None:
        """Take control of the planners for a moment: whoever loses it loses plan and motion, too."""
        operation = self._console.operation(robot.id)
        authority = 0 if operation is None else operation.authority
        for info in robot.info.offering(PLANNER):
            async with robot.component(info.id).service(PLANNER).control(authority=authority):
                pass
