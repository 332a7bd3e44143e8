"""The panel Guards: switches of the guards against self collision and obstacles, and why the robot stopped."""

from __future__ import annotations

import math
from collections.abc import Iterable
from typing import Any, Final

from nicegui import ui

from jauspy.console.console import Console
from jauspy.console.conventions import Conventions
from jauspy.console.languages import sentence
from jauspy.console.markup import attributes
from jauspy.console.motion import Motion
from jauspy.console.page_language import _, translated
from jauspy.errors import JausError
from jauspy.ocu.guards import REPORT, Guard
from jauspy.ocu.robot import Robot
from jauspy.printable import printable

UPDATE_INTERVAL: Final = 0.4
"""Seconds between two queries of the guards."""
LABELS: Final = {"self_collision": sentence("self collision"), "obstacle": sentence("obstacles")}


class GuardsPanel:
    """The guards of the chosen robot, for one page, which `token` names; hidden if it reports none."""

    def __init__(self, console: Console, token: str, conventions: Conventions) -> None:
        self._conventions = conventions
        self._console = console
        self._motion = Motion(console, token)
        self._robot: Robot | None = None
        self._shown: dict[str, bool] = {}
        """The positions of the switches, as the robot reported them last."""
        with ui.element("section").classes("panel guards") as self._panel:
            attributes(self._panel, aria_label=_("Guards"))
            with ui.element("div").classes("row"):
                ui.label(_("Guards")).classes("heading")
                self._state = ui.label("").classes("hint grow").props('role="status"')
            with ui.element("div").classes("row switches"):
                self._switches = {name: self._switch(name, label) for name, label in LABELS.items()}
            self._problem = ui.label("").classes("problem").props('role="alert"')
        self._panel.set_visibility(False)
        ui.timer(UPDATE_INTERVAL, self._update)

    def show(self, robot: Robot | None) -> None:
        """Show the guards of this robot."""
        self._motion.stop()
        self._robot, self._shown = robot, {}
        has_guards = robot is not None and any(component.find(REPORT) for component in robot.components)
        self._panel.set_visibility(has_guards)
        self._state.set_text("")
        self._problem.set_text("")
        for switch in self._switches.values():
            switch.set_visibility(False)

    def close(self) -> None:
        """Handle the end of the page."""
        self._motion.stop()
        self._robot = None

    def _switch(self, name: str, label: str) -> ui.switch:
        async def choose(event: Any) -> None:
            self._choose(name, enabled=bool(event.value))

        return ui.switch(translated(label), on_change=choose).props("dense")

    def _choose(self, name: str, *, enabled: bool) -> None:
        robot = self._robot
        if robot is None or self._shown.get(name, enabled) == enabled:
            return
        operation = self._console.operation(robot.id)
        authority = 0 if operation is None else operation.authority
        switching = robot.guards.switch(**{name: enabled}, authority=authority)
        self._motion.begin(robot.id, switching, sentence("switching the guard against {what}", what=LABELS[name]))
        self._shown.pop(name)
        for switch in self._switches.values():
            switch.set_enabled(False)  # until the robot reports the guards again

    async def _update(self) -> None:
        robot = self._robot
        if robot is None or not self._panel.visible or self._motion.is_running:
            return
        try:
            found = await robot.guards.observe()
        except JausError:
            if self._robot is robot:
                self._state.set_text("")
                self._problem.set_text(_("the robot does not answer"))
            return
        if self._robot is not robot or self._motion.is_running:
            return  # another one was chosen meanwhile
        refusal = self._motion.refusal(robot.id)
        for guard in found:
            if (switch := self._switches.get(guard.name)) is not None:
                self._shown[guard.name] = guard.enabled
                switch.set_visibility(True)
                switch.set_value(guard.enabled)
                switch.set_enabled(not refusal)
        self._state.set_text(distances_text(found, self._conventions))
        self._problem.set_text(problems_text(found) or printable(translated(self._motion.problem)))


def distances_text(found: Iterable[Guard], conventions: Conventions) -> str:
    """A text with the distances that the guards report, and whether they act."""
    parts = []
    for guard in found:
        if guard.enabled and math.isfinite(guard.distance):
            what = translated(LABELS.get(guard.name, sentence("unknown")))
            text = f"{what} {conventions.distance(guard.distance)}"
            parts.append(_("{guard}, slows down", guard=text) if guard.active else text)
    return "; ".join(parts)


def problems_text(found: Iterable[Guard]) -> str:
    """Why the guards stopped the robot; empty if they have not."""
    return "; ".join(printable(guard.problem) for guard in found if guard.problem)
