"""The tab Recordings: the list of the console's folder, and the player; static/recordings.js fills both."""

from __future__ import annotations

from nicegui import ui

from jauspy.console.markup import attributes
from jauspy.console.page_language import _


class RecordingsPanel:
    """The place of list and player on one page; the browser asks for the data by itself, see `recordings`."""

    def __init__(self) -> None:
        with ui.element("div").props("id=recordings").classes("recordings"):
            with ui.element("div").classes("recorded-frame"):
                files = ui.element("div").classes("recorded").props('role="region" tabindex="-1"')
                attributes(files, aria_label=_("recordings"))
            with ui.element("div").classes("player-frame"):
                attributes(ui.element("div").classes("player").props('role="region"'), aria_label=_("player"))
