"""The row of the tab World about planned motions of the arm: a click on a thing, a ghost of the way, and the motion."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from nicegui import ui

from jauspy.console.languages import sentence
from jauspy.console.markup import attributes, call
from jauspy.console.motion import Motion
from jauspy.console.page_language import _, translated
from jauspy.console.reaching import Reaching, pointed_at
from jauspy.ocu.planner import PLANNER
from jauspy.ocu.robot import Robot
from jauspy.printable import printable

if TYPE_CHECKING:
    from jauspy.console.console import Console

UPDATE_INTERVAL: Final = 0.4
"""Seconds between two looks at what the planner does."""


class PlannedMotionRow:
    """The row, for one page, which `token` names; hidden for a robot without a planner."""

    def __init__(self, console: Console, token: str) -> None:
        self._console, self._token = console, token
        self._motion = Motion(console, token)
        self._robot: Robot | None = None
        self._reaching = Reaching()
        self._picks = False
        """True while a click in the view points at a thing to reach for."""
        with ui.element("div").classes("row tight") as self._row:
            attributes(self._row, aria_label=_("Planned motion"))
            ui.label(_("Planned motion")).classes("heading")
            self._text = ui.label("").classes("hint grow").props('role="status"')
            play = ui.checkbox(_("play"), value=True).props("dense")
            play.on_value_change(lambda event: call("jauspy.world.set", "play", bool(event.value)))
            self._reach = ui.button(_("reach \u2026"), on_click=self._on_reach).props("outline no-caps")
            self._reach.tooltip(_("then click a thing in the 3-D view; a ghost shows the way before anything moves"))
            self._execute = ui.button(_("execute"), on_click=self._reaching.agree).props("unelevated no-caps")
            self._cancel = ui.button(_("cancel motion"), on_click=self._on_cancel).props("outline no-caps")
            self._problem = ui.label("").classes("problem").props('role="alert"')
        self._row.set_visibility(False)
        ui.on("reach_pointed", lambda event: self._pointed(event.args))
        ui.timer(UPDATE_INTERVAL, self._update)

    def show(self, robot: Robot | None) -> None:
        """Show the planned motion of this robot."""
        if robot is None or self._robot is None or robot.id != self._robot.id:
            self._motion.stop()
            self._pick(on=False)
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
        self._row.set_visibility(any(robot.info.offering(PLANNER)))
        text = _("click a thing in the 3-D view") if self._picks else world.planned.text
        self._text.set_text(printable(translated(text)))
        state = world.planned.state
        is_active = state is not None and state.phase in ("planning", "planned", "executing")
        runs, may = self._motion.is_running, not self._motion.refusal(robot.id)
        self._reach.set_enabled(may and not runs)
        self._execute.set_visibility(self._reaching.asks)
        self._cancel.set_enabled(self._picks or runs or (is_active and may))
        self._problem.set_text(printable(translated(self._motion.problem)))

    def _on_reach(self) -> None:
        self._motion.problem = ""
        self._pick(on=not self._picks)

    def _pick(self, *, on: bool) -> None:
        if on != self._picks:
            self._picks = on
            call("jauspy.view.pick", on)

    def _pointed(self, asked: object) -> None:
        """Handle a click on a thing, after checking its values."""
        robot, thing = self._robot, pointed_at(asked)
        operation = None if robot is None else self._console.operation(robot.id)
        if robot is None or operation is None or thing is None or not self._picks:
            return
        self._pick(on=False)
        self._motion.begin(robot.id, self._reaching.reach(robot, operation, thing), sentence("reaching"))

    def _on_cancel(self) -> None:
        robot = self._robot
        if self._picks or self._motion.is_running:
            self._pick(on=False)
            self._motion.stop()
        elif robot is not None:
            self._motion.begin(robot.id, self._take_over(robot), sentence("cancelling the planned motion"))

    async def _take_over(self, robot: Robot) -> None:
        """Take control of the planners for a moment: whoever loses it loses plan and motion, too."""
        operation = self._console.operation(robot.id)
        authority = 0 if operation is None else operation.authority
        for info in robot.info.offering(PLANNER):
            async with robot.component(info.id).service(PLANNER).control(authority=authority):
                pass
