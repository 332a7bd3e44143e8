"""The tab Recordings: the list of the console's folder, and the player; static/recordings.js fills both."""

from __future__ import annotations

from typing import Final

from nicegui import ui

_LIST: Final = '<div class="recorded" role="region" aria-label="recordings" tabindex="-1"></div>'
_PLAYER: Final = '<div class="player" role="region" aria-label="player"></div>'


class RecordingsPanel:
    """The place of list and player on one page; the browser asks for the data by itself, see `recordings`."""

    def __init__(self) -> None:
        with ui.element("div").props("id=recordings").classes("recordings"):
            ui.html(_LIST, sanitize=False).classes("recorded-frame")
            ui.html(_PLAYER, sanitize=False).classes("player-frame")
