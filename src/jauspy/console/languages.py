"""The languages of the console's pages: catalogues of gettext, and sentences that each page shows in its own language.

The sources are English. What a page shows at once is translated where it is shown (`page_language`). A text that is
made where there is no page, or for several pages, such as an alarm or a line of the log, is a `Sentence`: everywhere
an English string, which a page can still translate. Names of messages and states are those of JAUS in all languages.
"""

from __future__ import annotations

import gettext
from collections.abc import Iterable, Mapping
from functools import cache
from importlib.resources import files
from numbers import Real
from typing import Final

ENGLISH: Final = "en"
LANGUAGES: Final[Mapping[str, str]] = {ENGLISH: "English", "de": "Deutsch", "fr": "Fran\u00e7ais"}
"""The languages by their codes (ISO 639-1), each with its own name."""
COOKIE: Final = "jauspy-language"
"""Where a browser keeps the language that was chosen in it."""
CONSOLE, BROWSER = "console", "browser"
"""The catalogues: texts of Python, and texts of the page's scripts."""
MAX_HEADER: Final = 1000
"""Characters of `Accept-Language` that are read."""


class Sentence(str):
    """An English text that pages show in their languages: made of a template and of values, see `sentence`."""

    template: str
    values: Mapping[str, object]

    def __new__(cls, template: str, values: Mapping[str, object]) -> Sentence:
        """The template in English with the values put in: numbers, and all else as text."""
        kept = {name: value if isinstance(value, Real) else str(value) for name, value in values.items()}
        text = super().__new__(cls, template.format(**kept) if kept else template)
        text.template, text.values = template, kept
        return text

    def __str__(self) -> str:
        """Itself: the text of an error that was made of a sentence is a sentence, too."""
        return self


def sentence(template: str, /, **values: object) -> Sentence:
    """A text for pages of all languages: `sentence("robot {id} has gone", id=101)`; values are never templates."""
    return Sentence(template, values)


def joined(texts: Iterable[str], separator: str = "; ") -> Sentence:
    """Texts one after another, each of which pages translate."""
    values = {f"text_{number}": text for number, text in enumerate(texts)}
    return Sentence(separator.join(f"{{{name}}}" for name in values), values)


def translated(text: str, language: str) -> str:
    """A sentence in a language, with the sentences among its values; any other text as it is."""
    if not isinstance(text, Sentence) or language == ENGLISH:
        return text
    template = _catalogue(CONSOLE, language).gettext(text.template) if text.template else ""
    if not text.values:
        return template
    values = {
        name: translated(value, language) if isinstance(value, str) else value for name, value in text.values.items()
    }
    return template.format(**values)


def browser_texts(language: str) -> dict[str, str]:
    """The texts of the page's scripts in a language, by the English ones."""
    if language == ENGLISH:
        return {}
    catalogue = _catalogue(BROWSER, language)
    return {text: catalogue.gettext(text) for text in _texts_of(catalogue)}


def language_of(cookie: str | None, accepted: str | None) -> str:
    """The language of a browser: as chosen in it (`cookie`), else the best of its `Accept-Language` (RFC 9110, 12.5.4).

    Nothing that a browser sends is an error: what is not understood counts as not sent.
    """
    if cookie is not None and cookie in LANGUAGES:
        return cookie
    wishes = []
    for place, part in enumerate((accepted or "")[:MAX_HEADER].split(",")):
        tag, _, weight = part.strip().partition(";")
        code = tag.strip().lower().partition("-")[0]
        if code in LANGUAGES:
            wishes.append((-_weight(weight), place, code))
    wishes = [wish for wish in wishes if wish[0] < 0.0]
    return min(wishes)[2] if wishes else ENGLISH


def _weight(text: str) -> float:
    """The weight of a language, `q=0.7`; 1 if there is none, 0 if it is not valid."""
    if not text.strip():
        return 1.0
    name, _, number = text.partition("=")
    try:
        weight = float(number)
    except ValueError:
        return 0.0
    return weight if name.strip() == "q" and 0.0 <= weight <= 1.0 else 0.0


@cache
def _catalogue(domain: str, language: str) -> gettext.GNUTranslations:
    path = files("jauspy.console") / "locale" / language / "LC_MESSAGES" / f"{domain}.mo"
    with path.open("rb") as file:
        return gettext.GNUTranslations(file)


def _texts_of(catalogue: gettext.GNUTranslations) -> list[str]:
    """The English texts of a catalogue. The header's is empty."""
    return [text for text in catalogue._catalog if text]  # type: ignore[attr-defined]  # noqa: SLF001
