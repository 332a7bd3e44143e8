"""The card Follow: the robot follows another one along its path (LeaderFollowerDriver)."""

from __future__ import annotations

import asyncio
from typing import Final

from nicegui import ui

from jauspy.console.console import Console
from jauspy.console.conventions import Conventions
from jauspy.console.languages import sentence
from jauspy.console.markup import attributes
from jauspy.console.motion import Motion
from jauspy.console.page_language import _, translated
from jauspy.console.panels.quantity_field import QuantityField
from jauspy.errors import JausError, RequestError
from jauspy.ocu.following import Following
from jauspy.ocu.robot import Robot
from jauspy.printable import printable

SERVICE: Final = "iop:LeaderFollowerDriver"
UPDATE_INTERVAL: Final = 0.5
CHECK_PERIOD: Final = 1.0
"""Seconds between two queries whether the robot still follows."""
POSE: Final = "GlobalPoseSensor"
"""What a leader must offer."""


class FollowingCard:
    """Leader, gap, start and stop, for one page; hidden for robots that follow nobody."""

    def __init__(self, console: Console, token: str, conventions: Conventions) -> None:
        self._conventions = conventions
        self._console = console
        self._motion = Motion(console, token)
        self._robot: Robot | None = None
        self._asks = False
        with ui.element("section").classes("card") as self._card:
            attributes(self._card, aria_label=_("Follow"))
            with ui.element("div").classes("row"):
                ui.label(_("Follow")).classes("heading")
                self._state = ui.label("").classes("state grow").props('role="status"')
            self._hint = ui.label(_("follows another robot along its path")).classes("hint")
            with ui.element("div").classes("row start"):
                self._leader = ui.select({}, label=_("leader")).props("dense outlined").classes("wide")
                self._gap = QuantityField(
                    conventions, "length", lambda unit: _("gap in {unit}", unit=unit), 0.0, 100.0, value=3.0, step=0.5
                )
            with ui.element("div").classes("row start"):
                self._go = ui.button(_("follow"), on_click=self._begin).props("unelevated no-caps")
                stop = ui.button(_("stop"), on_click=self._motion.stop)
                self._stop = attributes(stop.props("outline no-caps color=negative"), aria_label=_("stop following"))
            self._problem = ui.label("").classes("problem").props('role="alert"')
        self._card.set_visibility(False)
        ui.timer(UPDATE_INTERVAL, self._update)

    def show(self, robot: Robot | None) -> None:
        """Offer it for this robot."""
        self._motion.stop()
        self._robot = robot
        self._state.set_text("")
        self._card.set_visibility(robot is not None and any(robot.info.offering(SERVICE)))

    def close(self) -> None:
        """Handle the end of the page."""
        self._motion.stop()
        self._robot = None

    def _begin(self) -> None:
        robot, leader = self._robot, self._leader.value
        if robot is None:
            return
        if leader is None:
            self._motion.problem = sentence("choose a leader first")
            return
        gap = float(self._gap.value or 0.0)
        self._motion.begin(robot.id, follow_until_stopped(robot, int(leader), gap), sentence("following"))

    async def _update(self) -> None:
        robot = self._robot
        if robot is None or not self._card.visible or self._asks:
            return
        self._show_leaders(robot)
        runs, refusal = self._motion.is_running, self._motion.refusal(robot.id)
        self._go.set_enabled(not runs and not refusal and bool(self._leader.options))
        self._stop.set_enabled(runs)
        self._problem.set_text(translated(self._motion.problem))
        self._asks = True
        try:
            text = state_text(await robot.following(), self._conventions)
        except JausError:
            text = _("the robot does not answer")
        finally:
            self._asks = False
        if self._robot is robot:
            self._state.set_text(text)

    def _show_leaders(self, robot: Robot) -> None:
        found = {
            other.id: f"{other.id} {printable(other.name)}"
            for other in self._console.fleet.robots.values()
            if other.id != robot.id and any(other.info.offering(POSE))
        }
        if found != self._leader.options:
            chosen = self._leader.value if self._leader.value in found else next(iter(found), None)
            self._leader.set_options(found, value=chosen)
        self._hint.set_text(
            _("follows another robot along its path") if found else _("no other robot here tells its pose on the globe")
        )


async def follow_until_stopped(robot: Robot, leader: int, gap: float) -> None:
    """Follow until this is cancelled, which stops the robot; raises `RequestError` when it follows no more."""
    await robot.follow(leader, gap=gap)
    try:
        state = await robot.following()
        while state.is_following:
            await asyncio.sleep(CHECK_PERIOD)
            state = await robot.following()
    finally:
        await robot.stop_following()
    raise RequestError(sentence("it follows no more: the leader is lost or too far ahead, or the robot was stopped"))


def state_text(state: Following, conventions: Conventions) -> str:
    """Whom the robot follows, at which gap."""
    if not state.is_following:
        return _("follows nobody")
    if state.gap is None:
        return _("follows {leader}", leader=state.leader)
    return _("follows {leader} at {gap}", leader=state.leader, gap=conventions.distance(state.gap, 1))
