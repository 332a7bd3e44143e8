"""The language of the page that is being built or that an event came from: `_` translates into it."""

from __future__ import annotations

from contextvars import ContextVar
from typing import Any, Final
from weakref import WeakKeyDictionary

from nicegui import Client, context, ui

from jauspy.console import languages
from jauspy.console.languages import ENGLISH, Sentence

_CHOSEN: Final[WeakKeyDictionary[Client, str]] = WeakKeyDictionary()
_REQUESTED: Final = ContextVar("language of the page that is requested", default=ENGLISH)


def set_language(client: Client, language: str) -> None:
    """Show the page that is being requested in a language."""
    _CHOSEN[client] = language
    _REQUESTED.set(language)


def page_language() -> str:
    """The code of the present page's language; English outside of pages, as in a task of the console."""
    try:
        return _CHOSEN.get(context.client, ENGLISH)
    except RuntimeError:  # no page
        return ENGLISH


def _(template: str, /, **values: object) -> str:
    """A text of the console in the present page's language: `_("limit {speed}", speed="1 m/s")`."""
    return languages.translated(Sentence(template, values), page_language())


def translated(text: str) -> str:
    """A sentence in the present page's language; any other text as it is."""
    return languages.translated(text, page_language())


class LocalizedPage(ui.page):
    """A page whose `lang` attribute and whose elements of Quasar have the language of the browser that loads it."""

    def resolve_language(self) -> Any:
        """The name of NiceGUI for the language."""
        language = _REQUESTED.get()
        return "en-US" if language == ENGLISH else language
