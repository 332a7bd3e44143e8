"""The button View in the bar: language, axes and units of this browser, and the help about keys."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final

from nicegui import ui

from jauspy.console.conventions import DEGREES, FEET, JAUS, METRES, RADIANS, REP_103, Conventions
from jauspy.console.languages import LANGUAGES, sentence
from jauspy.console.markup import attributes, call, plain_text
from jauspy.console.page_language import _, page_language, translated

_LABELS: Final[Mapping[str, tuple[str, Mapping[str, str]]]] = {
    "axes": (sentence("Axes"), {REP_103: "REP-103", JAUS: "JAUS"}),
    "length": (sentence("Lengths"), {METRES: sentence("metres"), FEET: sentence("feet")}),
    "angle": (sentence("Angles"), {DEGREES: sentence("degrees"), RADIANS: sentence("radians")}),
}


class SettingsButton:
    """The button and its dialogue; the browser keeps the choice (static/settings.js)."""

    def __init__(self, conventions: Conventions) -> None:
        self._conventions = conventions
        with attributes(ui.dialog(), aria_label=_("axes and units")) as dialog, ui.card().classes("mission"):
            ui.label(_("View")).classes("heading")
            with ui.element("div").classes("row"):
                ui.label(_("Language"))
                language = ui.toggle(dict(LANGUAGES), value=page_language()).props("no-caps dense unelevated")
            attributes(language, aria_label=_("Language"))
            language.on_value_change(lambda event: call("jauspy.settings.speak", event.value))
            ui.label(_("another language loads the page again, and releases the robot")).classes("hint")
            self._toggles = {name: self._toggle(name) for name in _LABELS}
            self._axes = ui.label(translated(conventions.axes_text)).classes("hint")
            ui.label(
                _("arms, grippers and belts stay in radians and metres, events, files and the log as they are")
            ).classes("hint")
            ui.button(_("close"), on_click=dialog.close).props("outline no-caps")
        button = ui.button(_("view"), on_click=dialog.open, color=None).props("flat no-caps dense")
        attributes(button, aria_label=_("axes and units"))
        help = plain_text("?", tag="button").classes("quiet")
        attributes(help, data_do="help", aria_label=_("keyboard help"))
        ui.on("view", lambda event: self._remembered(event.args))
        conventions.on_change.append(self._show)

    def _toggle(self, name: str) -> ui.toggle:
        label, options = _LABELS[name]
        with ui.element("div").classes("row"):
            ui.label(translated(label))
            texts = {value: translated(text) for value, text in options.items()}
            toggle = ui.toggle(texts, value=self._conventions.chosen[name]).props("no-caps dense unelevated")
        attributes(toggle, aria_label=translated(label))
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
        self._axes.set_text(translated(self._conventions.axes_text))
        call("jauspy.settings.keep", self._conventions.chosen)
