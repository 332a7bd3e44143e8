"""A question to the user of a page, before something is done that cannot be undone."""

from __future__ import annotations

import asyncio
from typing import Final

from nicegui import ui

from jauspy.console.markup import attributes
from jauspy.console.page_language import _

ANSWER_TIME: Final = 60.0
"""Seconds until no answer counts as no."""


async def confirmed(question: str, action: str) -> bool:
    """Ask in the page of the present event; true if the user chooses `action`."""
    with attributes(ui.dialog(), aria_label=_("question")) as dialog, ui.card():
        ui.label(question)
        with ui.element("div").classes("row"):
            ui.button(action, on_click=lambda: dialog.submit(result=True)).props("unelevated no-caps color=negative")
            ui.button(_("cancel"), on_click=lambda: dialog.submit(result=False)).props("outline no-caps")
    try:
        async with asyncio.timeout(ANSWER_TIME):
            return await dialog is True
    except TimeoutError:
        return False
    finally:
        dialog.delete()
