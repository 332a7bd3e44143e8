"""The panel Fleet: robots and components with their states; of one component, on a click, its services and refusals."""

from __future__ import annotations

import re
from collections.abc import Callable
from functools import partial
from typing import Final

from nicegui import ui

from jauspy.console.console import Console
from jauspy.console.fleet import NOTHING
from jauspy.console.markup import attributes, breakable
from jauspy.console.page_language import _, translated
from jauspy.console.reports import fields_of
from jauspy.console.traffic import Line
from jauspy.ids import JausID
from jauspy.ocu.robot import Robot
from jauspy.ocu.subsystems import ComponentInfo
from jauspy.printable import printable

UPDATE_INTERVAL: Final = 0.4
"""Seconds between two updates of the panel."""
OLD: Final = 1.5
"""Seconds without an answer after which the panel shows their number."""
MAX_REFUSALS: Final = 3
COLOURS: Final = {"READY": "ready", "STANDBY": "standby", "EMERGENCY": "emergency", "FAILURE": "failure"}
"""States of console.css; each state has a sign beside its colour, too."""
SIGNS: Final = {"READY": "\u25b6", "STANDBY": "\u2016", "EMERGENCY": "\u26a0", "FAILURE": "\u2716", "silent": "?"}


class FleetPanel:
    """All robots, for one page; `choose` is called with the number of the one that is clicked."""

    def __init__(self, console: Console, choose: Callable[[int], None]) -> None:
        self._console = console
        self._choose = choose
        self._chosen: int | None = None
        self._rows: dict[JausID, _Row] = {}
        self._robots: dict[int, ui.element] = {}
        self._names: dict[int, ui.button] = {}
        self._listed: tuple[tuple[int, str, tuple[ComponentInfo, ...]], ...] = ()
        ui.label(_("Fleet")).classes("heading")
        self._empty = ui.label(_("No robot answers yet.")).classes("hint")
        self._list = ui.element("div").classes("list")
        ui.timer(UPDATE_INTERVAL, self._update)

    def show(self, robot: Robot | None) -> None:
        """Mark the robot that the other panels show."""
        self._chosen = robot.id if robot is not None else None
        for id, element in self._robots.items():
            element.classes(add="chosen" if id == self._chosen else "", remove="" if id == self._chosen else "chosen")

    def _update(self) -> None:
        robots = self._console.fleet.robots
        listed = tuple((robot.id, robot.name, robot.components) for robot in robots.values())
        if listed != self._listed:
            self._listed = listed
            self._empty.set_visibility(not robots)
            self._build()
        for row in self._rows.values():
            row.update()

    def _build(self) -> None:
        """Add, remove and replace what has changed; all else stays, so that a click on it is not lost."""
        robots = self._console.fleet.robots
        for id in self._robots.keys() - robots.keys():
            self._robots.pop(id).delete()
            del self._names[id]
        rows = {}
        for place, robot in enumerate(robots.values()):
            name = f"{robot.id}  {printable(robot.name)}"
            if robot.id not in self._robots:
                self._add(robot, name)
            self._names[robot.id].set_text(name)
            _put(self._robots[robot.id], self._list, place)
            with self._robots[robot.id] as element:
                for number, component in enumerate(robot.components):
                    row = self._rows.pop(component.id, None)
                    if row is None or row.component != component:
                        is_open = row is not None and row.is_open
                        if row is not None:
                            row.delete()
                        row = _Row(self._console, component, is_open=is_open)
                    row.put(element, 1 + 2 * number)  # after the name, two elements each
                    rows[component.id] = row
        for row in self._rows.values():
            row.delete()
        self._rows = rows

    def _add(self, robot: Robot, name: str) -> None:
        with self._list, ui.element("div").classes("robot") as element:
            button = ui.button(name, on_click=partial(self._choose, robot.id), color=None)
            button.classes("name").props("flat no-caps dense align=left")
        if robot.id == self._chosen:
            element.classes("chosen")
        self._robots[robot.id], self._names[robot.id] = element, button


def _put(element: ui.element, parent: ui.element, place: int) -> None:
    """Move an element to this place in its parent, unless it is there."""
    if parent.default_slot.children[place] is not element:
        element.move(parent, target_index=place)


class _Row:
    """One component."""

    def __init__(self, console: Console, component: ComponentInfo, *, is_open: bool) -> None:
        self._console = console
        self.component = component
        self.is_open = is_open
        id = component.id
        with ui.element("button").classes("component").props('type="button"').on("click", self._toggle) as self._button:
            attributes(self._button, aria_expanded=is_open)
            ui.label(f"{id.node}.{id.component}").classes("id")
            name = printable(component.name) or _("component")
            with ui.element("span").classes("component-name").tooltip(f"{name} {id}"):
                ui.label(name)
                self._part = ui.label("").classes("part-name")
            self._status = ui.label("").classes("chip")
            self._controller = ui.label("").classes("controller")
        self._details = ui.element("div").classes("component-details")
        self._show_details()

    def put(self, parent: ui.element, place: int) -> None:
        """Move it to this place in its parent."""
        _put(self._button, parent, place)
        _put(self._details, parent, place + 1)

    def delete(self) -> None:
        """Remove it from the page, unless its robot has gone with it."""
        for element in (self._button, self._details):
            if not element.is_deleted:
                element.delete()

    def _toggle(self) -> None:
        self.is_open = not self.is_open
        attributes(self._button, aria_expanded=self.is_open)
        self._show_details()

    def _show_details(self) -> None:
        self._details.clear()
        self._details.set_visibility(self.is_open)
        if not self.is_open:
            return
        with self._details:
            self._heard = ui.label("").classes("hint")
            for service in self.component.services:
                with ui.element("div").classes("service"):
                    breakable(_words(service.short.rpartition(":")[2])).tooltip(printable(service.short))
                    ui.label(printable(service.version)).classes("hint")
            refusals = self._refusals()
            ui.label(_("refused") if refusals else _("nothing was refused")).classes("hint")
            for text in refusals:
                ui.label(text).classes("refusal")
        self.update()

    def update(self) -> None:
        """Show the present state."""
        fleet, id = self._console.fleet, self.component.id
        self._part.set_text(translated(self._console.names.of(self.component)))
        state = fleet.states.get(id, NOTHING)
        silent, age = fleet.is_silent(id), fleet.age(id)
        status = "silent" if silent else state.status
        shown = _("silent") if silent else status.lower()
        old = f" {age:.0f} s" if OLD < age < 1e6 else ""
        self._status.set_text(f"{SIGNS.get(status, '')} {shown}{old}")
        attributes(self._status, data_state=COLOURS.get(status, "other"))
        who = "" if silent or not state.controller else _("controlled by {who}", who=self._who(state.controller))
        self._controller.set_text(who)
        self._controller.set_visibility(bool(who))
        if self.is_open:
            heard = _("it has never answered") if age > 1e6 else _("last sign of life {age:.0f} s ago", age=age)
            self._heard.set_text(
                _("{heard}, controlled with authority {authority}", heard=heard, authority=state.authority)
                if who
                else heard
            )

    def _who(self, controller: str) -> str:
        return _("this console") if controller == str(self._console.ocu.id) else controller

    def _refusals(self) -> list[str]:
        """Commands that the component refused, with reasons, the newest first."""
        id = str(self.component.id)
        lines = [line for line in self._console.traffic.lines(id, "refused") if line.source == id]
        return [self._refusal(line) for line in lines[:MAX_REFUSALS]]

    def _refusal(self, line: Line) -> str:
        decoded = self._console.traffic.decoded(line)
        if isinstance(decoded, str):
            why = decoded
        else:
            why = ", ".join(f"{field.path.replace('_', ' ')}: {field.text}" for field in fields_of(decoded))
        return printable(f"{line.time:%H:%M:%S} {line.name}: {why}")


def _words(name: str) -> list[str]:
    """The words of a name such as `GlobalPoseSensor`."""
    return re.split(r"(?<=[a-z0-9])(?=[A-Z])", name)
