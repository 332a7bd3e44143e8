"""The card Way back: the robot drives back along the path by which it came (Retrotraverse)."""

from __future__ import annotations

from typing import Final

from nicegui import ui

from jauspy.console.console import Console
from jauspy.console.conventions import Conventions
from jauspy.console.languages import sentence
from jauspy.console.markup import attributes
from jauspy.console.motion import Motion
from jauspy.console.page_language import _, translated
from jauspy.console.panels.quantity_field import QuantityField
from jauspy.ocu.comms_lost import WayBack
from jauspy.ocu.robot import Robot

SERVICE: Final = "iop:Retrotraverse"
UPDATE_INTERVAL: Final = 0.4
MAX_DISTANCE: Final = 10_000.0
"""Metres that can be entered."""


class WayBackCard:
    """Distance, speed, progress and stop, for one page; hidden for robots that keep no path."""

    def __init__(self, console: Console, token: str, conventions: Conventions) -> None:
        self._conventions = conventions
        self._motion = Motion(console, token)
        self._robot: Robot | None = None
        self._said = ""
        """What came of the last way."""
        self._share = 0.0
        with ui.element("section").classes("card") as self._card:
            attributes(self._card, aria_label=_("Way back"))
            with ui.element("div").classes("row"):
                ui.label(_("Way back")).classes("heading")
                self._state = ui.label("").classes("state grow").props('role="status"')
            ui.label(_("drives back along the path by which it came; it sees no obstacles")).classes("hint")
            with ui.element("div").classes("row start"):
                self._distance = QuantityField(
                    conventions,
                    "length",
                    lambda unit: _("distance in {unit}", unit=unit),
                    0.1,
                    MAX_DISTANCE,
                    value=5.0,
                    step=1.0,
                )
                self._speed = QuantityField(
                    conventions,
                    "length",
                    lambda unit: _("{unit}/s, 0: as it came", unit=unit),
                    0.0,
                    5.0,
                    value=0.0,
                    step=0.1,
                )
                self._speed.element.classes("wide")
            with ui.element("div").classes("row start"):
                self._go = ui.button(_("drive back"), on_click=self._begin).props("unelevated no-caps")
                stop = ui.button(_("stop"), on_click=self._motion.stop)
                self._stop = attributes(stop.props("outline no-caps color=negative"), aria_label=_("stop driving back"))
            self._bar = ui.linear_progress(0.0, show_value=False, size="8px")
            attributes(self._bar, aria_label=_("way back, driven"))
            self._problem = ui.label("").classes("problem").props('role="alert"')
        self._card.set_visibility(False)
        ui.timer(UPDATE_INTERVAL, self._update)

    def show(self, robot: Robot | None) -> None:
        """Offer it for this robot."""
        self._motion.stop()
        self._robot, self._said, self._share = robot, "", 0.0
        self._card.set_visibility(robot is not None and any(robot.info.offering(SERVICE)))

    def close(self) -> None:
        """Handle the end of the page."""
        self._motion.stop()
        self._robot = None

    def _begin(self) -> None:
        robot = self._robot
        if robot is None:
            return
        distance, speed = float(self._distance.value or 0.0), float(self._speed.value or 0.0)
        self._said, self._share = "", 0.0
        self._motion.begin(robot.id, self._drive(robot, distance, speed or None), sentence("driving back"))

    async def _drive(self, robot: Robot, distance: float, speed: float | None) -> None:
        way = await robot.retrotraverse(distance, speed=speed, progress=self._note)
        self._said = result_text(way, distance, self._conventions)

    def _note(self, share: float) -> None:
        self._share = share

    def _update(self) -> None:
        robot = self._robot
        if robot is None or not self._card.visible:
            return
        runs, refusal = self._motion.is_running, self._motion.refusal(robot.id)
        self._go.set_enabled(not runs and not refusal)
        self._stop.set_enabled(runs)
        self._bar.set_visibility(runs)
        self._bar.set_value(round(self._share, 3))
        self._state.set_text(
            _("{share:.0f} % driven", share=100.0 * self._share) if runs else translated(self._said or refusal)
        )
        self._problem.set_text(translated(self._motion.problem))


def result_text(way: WayBack, asked: float, conventions: Conventions) -> str:
    """How far the robot drove, and why it ended there if that is less than was asked for."""
    driven = conventions.distance(way.distance, 1)
    if way.ended_by != "path":
        return sentence("drove {distance} back", distance=driven)
    return sentence(
        "drove {distance} back of {asked}: its path begins here",
        distance=driven,
        asked=conventions.distance(asked, 1),
    )
