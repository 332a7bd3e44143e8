"""The middle of the page: views as tabs, or beside each other as arranged; sizes, places, presets, full window."""

from __future__ import annotations

import math
from collections.abc import Callable, Collection, Iterator, Sequence
from contextlib import contextmanager
from typing import Any, Final

from nicegui import ui

from jauspy.console.arrangement import PRESETS, Arrangement, arrangement_of
from jauspy.console.languages import sentence
from jauspy.console.markup import attributes, call, style_number
from jauspy.console.page_language import _, translated

EVENTS: Final = "Events"
"""The view that has no tab: in "one view" it is below others."""
VIEWS: Final = {
    "Video": sentence("Video"),
    "World": sentence("World"),
    "Trajectory": sentence("Trajectory"),
    "Tasks": sentence("Tasks"),
    "Plots": sentence("Plots"),
    "Log": sentence("Log"),
    "Recordings": sentence("Recordings"),
    EVENTS: sentence("Events"),
}
"""The views in the order of their tabs, with their titles."""
PANELS: Final = {
    "Fleet": sentence("Fleet"),
    "Link": sentence("Link"),
    "Drive": sentence("Drive"),
    "Guards": sentence("Guards"),
    "Arm": sentence("Arm"),
    "Gripper": sentence("Gripper"),
    "Conveyor": sentence("Conveyor"),
}
"""Panels that can be put away, with their titles; STOP and Control always stay."""
_PRESETS: Final = {
    "one view": sentence("one view"),
    "drive": sentence("drive"),
    "arm": sentence("arm"),
    "observe": sentence("observe"),
}
"""The names of `PRESETS`."""
SPLITS: Final = {
    "width": sentence("width of the views"),
    "left": sentence("height at the left"),
    "right": sentence("height at the right"),
}


class Desk:
    """The views of one page and their arrangement, which the browser keeps; `changed` is called when it changes.

    `main` is the element around all panels.
    """

    def __init__(self, main: ui.element, changed: Callable[[], None]) -> None:
        self.arrangement = PRESETS["one view"]
        self._main = main
        self._changed = changed
        self._panes: dict[str, ui.element] = {}
        self._boxes: dict[str, ui.checkbox] = {}
        self._active = ""
        """The view in whose place a click on a tab shows another one."""
        self._setting = False
        ui.on("desk", self._take)

    def build_menu(self, views: Sequence[str]) -> None:
        """The button "layout" with its menu: presets, views and panels."""
        button = ui.button(_("layout \u25be"), color=None).props("flat no-caps dense").classes("layout")
        with button, ui.menu().props("no-focus").classes("layout-menu") as menu:
            attributes(menu, aria_label=_("layout of the views"))
            for number, name in enumerate(PRESETS, 1):
                with ui.menu_item(on_click=lambda name=name: self.choose(name)):
                    ui.label(translated(_PRESETS[name])).classes("grow")
                    ui.label(str(number)).classes("hint")
            ui.separator()
            for name in (*views, EVENTS):
                self._boxes[name] = self._box(_("view {name}", name=VIEWS[name]), name)
            ui.separator()
            for name in PANELS:
                self._boxes[f"panel {name}"] = self._box(_("panel {name}", name=PANELS[name]), f"panel {name}")

    def _box(self, text: str, name: str) -> ui.checkbox:
        box = ui.checkbox(text, value=name.startswith("panel ")).props("dense").classes("layout-box")
        box.on_value_change(lambda event: self._toggle(name, shown=bool(event.value)))
        return box

    @contextmanager
    def frame(self) -> Iterator[ui.element]:
        """The place of the views, which are made in this block."""
        with ui.element("div").classes("desk") as self._desk:
            yield self._desk
            for name, label in SPLITS.items():
                splitter = ui.element("div").classes("splitter").props('role="separator" tabindex="0"')
                attributes(splitter, data_split=name, aria_label=translated(label))
                if name == "width":
                    splitter.props('aria-orientation="vertical"')
                else:
                    splitter.props('aria-orientation="horizontal"')

    @contextmanager
    def pane(self, name: str) -> Iterator[ui.element]:
        """The frame of one view, with its title while several are shown."""
        with ui.element("section").classes("pane") as pane:
            attributes(pane, data_view=name, aria_label=_("view {name}", name=VIEWS[name]))
            self._panes[name] = pane
            with ui.element("div").classes("pane-bar"):
                ui.label(translated(VIEWS[name])).classes("grow")
                for sign, tip, act in (
                    ("\u21c4", _("move to the next place"), lambda: self._arrange(self.arrangement.moved(name))),
                    ("\u00d7", _("close"), lambda: self._arrange(self.arrangement.without(name))),
                ):
                    button = ui.button(sign, on_click=act, color=None).props("flat dense no-caps").tooltip(tip)
                    attributes(button, aria_label=f"{translated(VIEWS[name])}: {tip}")
            yield pane

    @property
    def panes(self) -> dict[str, ui.element]:
        """The frames by the names of their views."""
        return self._panes

    @property
    def is_arranged(self) -> bool:
        """True while several views are shown at once."""
        return bool(self.arrangement.columns)

    def show(self, views: Collection[str]) -> list[str]:
        """Arrange those of these views that are in the arrangement; returns them."""
        columns = self.arrangement.offered(views)
        for name, pane in self._panes.items():
            column = next((number for number, column in enumerate(columns) if name in column), None)
            pane.set_visibility(column is not None)
            if column is not None:
                rows = columns[column]
                row = "all" if len(rows) == 1 else ("top", "bottom")[rows.index(name)]
                attributes(pane, data_column=column if len(columns) > 1 else "all", data_row=row)
        self._mark(columns)
        return [name for column in columns for name in column]

    def show_one(self, views: Collection[str]) -> None:
        """Show these views below each other, as a tab has them."""
        for name, pane in self._panes.items():
            pane.set_visibility(name in views)
        self._mark([])

    def _mark(self, columns: Sequence[Sequence[str]]) -> None:
        """What the style sheet needs to know."""
        arrangement = self.arrangement
        self._desk.classes(add="arranged" if columns else "", remove="" if columns else "arranged")
        two = [len(column) > 1 for column in columns] + [False, False]
        attributes(self._desk, data_columns=len(columns), data_left=two[0], data_right=two[1])
        style_number(self._desk, "width", arrangement.width)
        style_number(self._desk, "left", arrangement.heights[0])
        style_number(self._desk, "right", arrangement.heights[1])
        attributes(self._main, data_away=" ".join(arrangement.away))
        self._setting = True
        for name, box in self._boxes.items():
            panel = name.removeprefix("panel ")
            box.set_value(panel not in arrangement.away if panel != name else name in arrangement.views)
        self._setting = False

    # --- changes ----------------------------------------------------------------------------------------------------

    def choose(self, preset: str) -> None:
        """Arrange the views for a task."""
        self._arrange(PRESETS[preset])

    def show_view(self, name: str) -> None:
        """Show a view beside the others: in place of the one that was used last, unless it is shown."""
        views = self.arrangement.views
        if self.is_arranged and name not in views:
            self._arrange(self.arrangement.replaced(self._active if self._active in views else views[0], name))
        self._active = name

    def _arrange(self, arrangement: Arrangement) -> None:
        if arrangement != self.arrangement:
            self.arrangement = arrangement
            call("jauspy.desk.keep", arrangement.text())
            self._changed()

    def _toggle(self, name: str, *, shown: bool) -> None:
        if self._setting:
            return
        panel = name.removeprefix("panel ")
        if panel != name:
            self._arrange(self.arrangement.put_away(panel, away=not shown))
        else:
            self._arrange(self.arrangement.added(name) if shown else self.arrangement.without(name))

    def _take(self, event: Any) -> None:
        """Handle what the operator did in the browser, after checking it: a key, a splitter, a title that was moved."""
        asked = event.args
        if not isinstance(asked, dict):
            return
        views, split, share = self.arrangement.views, asked.get("split"), asked.get("share")
        if (kept := arrangement_of(asked.get("kept"), list(self._panes))) is not None:
            self._arrange(kept)
        elif isinstance(preset := asked.get("preset"), int) and 0 < preset <= len(PRESETS):
            self._arrange(list(PRESETS.values())[preset - 1])
        elif isinstance(split, str) and split in SPLITS and isinstance(share, int | float) and math.isfinite(share):
            self._arrange(self.arrangement.resized(split, float(share)))
        elif asked.get("move") in views and asked.get("to") in views:
            self._arrange(self.arrangement.swapped(str(asked["move"]), str(asked["to"])))
        elif asked.get("used") in views:
            self._active = str(asked["used"])
