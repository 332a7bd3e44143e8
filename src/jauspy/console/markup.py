"""Puts text of robots, files and users into the page: the only place of the console that builds markup or scripts.

NiceGUI reads `.props("…")` as a list of keys and values, and the browser evaluates the value of a key that begins with
a colon. A text inside such a string, or inside HTML or JavaScript, may therefore become a program. Elsewhere in the
console these calls have literals only, which tests/console/test_markup_rule.py checks; what varies goes through the
functions below.
"""

from __future__ import annotations

import json
import math
from collections.abc import Iterable, Mapping
from html import escape
from typing import Any, Final, Literal, TypeVar

from nicegui import ui
from nicegui.elements.mixins.text_element import TextElement

from jauspy.printable import printable

E = TypeVar("E", bound=ui.element)

_PREFIXES: Final = ("aria-", "data-")
_NUMBERS: Final = ("min", "max")
"""Attributes of a slider that change."""


def attributes(element: E, **values: str | float | bool) -> E:
    """Set attributes of an element: `aria_label` is `aria-label`. The values are never parsed as anything.

    Only attributes that a browser does not follow, run or load can be set: those for assistive technology, those for
    the page's own scripts, and the ends of a slider.
    """
    for key, value in values.items():
        name = key.replace("_", "-")
        if not name.startswith(_PREFIXES) and (name not in _NUMBERS or isinstance(value, str)):
            raise ValueError(f"{name} is not an attribute that may vary")
        shown = str(value).lower() if isinstance(value, bool) else printable(value) if isinstance(value, str) else value
        if element.props.get(name) != shown:
            element.props[name] = shown
    return element


def style_number(element: E, name: str, value: float) -> E:
    """Set a CSS variable to a number: `style_number(element, "joints", 6)` sets `--joints`."""
    if not name.isidentifier():
        raise ValueError(f"{name} is not the name of a CSS variable")
    return element.style(f"--{name}: {float(value):.6g}")


class _Text(TextElement):
    """An element with a text."""


def plain_text(text: str, tag: Literal["b", "button", "h2", "kbd", "p", "span", "summary"] = "span") -> TextElement:
    """An element with this text."""
    return _Text(tag=tag, text=text)


def breakable(parts: Iterable[str]) -> ui.html:
    """An element with a text in which a line may end between these parts only."""
    return ui.html("<wbr>".join(escape(printable(part)) for part in parts), sanitize=False)


def with_code(text: str) -> ui.html:
    """An element with a text; what is between backquotes is shown as code."""
    parts = [escape(printable(part)) for part in text.split("`")]
    parts[1::2] = [f"<code>{part}</code>" for part in parts[1::2]]
    return ui.html("".join(parts), sanitize=False, tag="span")


def call(function: str, *arguments: object) -> None:
    """Call a function of the page's own scripts, as `jauspy.plot`; the arguments arrive as data."""
    if not all(part.isidentifier() for part in function.split(".")):
        raise ValueError(f"{function} is not the name of a function")
    ui.run_javascript(f"{function}({', '.join(json.dumps(_finite(argument)) for argument in arguments)})")


def page_files(styles: Iterable[str], scripts: Iterable[str], token: str, texts: Mapping[str, str]) -> None:
    """Load the page's own style sheets and scripts, which find the page's token as an attribute of their elements.

    `texts` are translations of the scripts' texts, which are in an element of the page.
    """
    links = "".join(f'<link rel="stylesheet" href="/static/{escape(name)}.css">' for name in styles)
    ui.add_head_html(f'<script src="/static/trusted.js"></script>{links}')
    data = f'data-token="{escape(token)}"'
    ui.add_body_html(f'<div id="texts" hidden data-texts="{escape(json.dumps(texts))}"></div>')
    ui.add_body_html("".join(f'<script src="/static/{escape(name)}.js" {data}></script>' for name in scripts))


def _finite(value: Any) -> Any:
    """The value with None for numbers that JSON does not have: infinite ones and NaN."""
    if isinstance(value, float):
        return value if math.isfinite(value) else None
    if isinstance(value, dict):
        return {str(key): _finite(entry) for key, entry in value.items()}
    if isinstance(value, (list, tuple)):
        return [_finite(entry) for entry in value]
    return value
