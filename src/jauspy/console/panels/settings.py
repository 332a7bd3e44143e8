"""The button View in the bar: axes and units of this browser, and the help about keys."""

from __future__ import annotations

from typing import Final

from nicegui import ui

from jauspy.console.conventions import DEGREES, FEET, JAUS, METRES, RADIANS, REP_103, Conventions
from jauspy.console.markup import attributes, call

_LABELS: Final = {
    "axes": ("Axes", {REP_103: "REP-103", JAUS: "JAUS"}),
    "length": ("Lengths", {METRES: "metres", FEET: "feet"}),
    "angle": ("Angles", {DEGREES: "degrees", RADIANS: "radians"}),
}


class SettingsButton:
    """The button and its dialogue; the browser keeps the choice (static/settings.js)."""

    def __init__(self, conventions: Conventions) -> None:
        self._conventions = conventions
        with ui.dialog().props('aria-label="axes and units"') as dialog, ui.card().classes("mission"):
            ui.label("View").classes("heading")
            self._toggles = {name: self._toggle(name) for name in _LABELS}
            self._axes = ui.label(conventions.axes_text).classes("hint")
            ui.label("joints of arms stay in radians and metres, the log in the values of the messages").classes("hint")
            ui.button("close", on_click=dialog.close).props("outline no-caps")
        ui.button("view", on_click=dialog.open, color=None).props('flat no-caps dense aria-label="axes and units"')
        ui.html('<button class="quiet" data-do="help" aria-label="keyboard help">?</button>', sanitize=False)
        ui.on("view", lambda event: self._remembered(event.args))
        conventions.on_change.append(self._show)

    def _toggle(self, name: str) -> ui.toggle:
        label, options = _LABELS[name]
        with ui.element("div").classes("row"):
            ui.label(label)
            toggle = ui.toggle(options, value=self._conventions.chosen[name]).props("no-caps dense unelevated")
        attributes(toggle, aria_label=label)
        toggle.on_value_change(lambda event: self._choose(name, event.value))
        return toggle

    def _choose(self, name: str, value: object) -> None:
        self._conventions.set({name: value})

    def _remembered(self, asked: object) -> None:
        """Take what this browser has kept."""
        self._conventions.set(asked)

    def _show(self) -> None:
        for name, value in self._conventions.chosen.items():
            self._toggles[name].set_value(value)
        self._axes.set_text(self._conventions.axes_text)
        call("jauspy.settings.keep", self._conventions.chosen)
