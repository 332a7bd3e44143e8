"""Small readers for one XML element: attributes as Python values, and errors that say where."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from difflib import get_close_matches
from typing import TypeVar

from lxml.etree import _Element as Element

from jauspy.errors import SchemaError
from jauspy.schema.model import Location

Value = TypeVar("Value")


def file_of(element: Element) -> str:
    """The path that the document of this element was read from."""
    return element.getroottree().docinfo.URL or "<unknown>"


def line_of(element: Element) -> int:
    """The line of the start tag; 0 when libxml2 has lost it."""
    line: object = element.sourceline
    return line if isinstance(line, int) else 0


def location(element: Element) -> Location:
    """File and line of an element, for the model."""
    return Location(file_of(element), line_of(element))


def wrong(element: Element, message: str) -> SchemaError:
    """The error to raise about this element."""
    return SchemaError(message, file=file_of(element), line=line_of(element))


def suggestion(name: str, known: Iterable[str]) -> str:
    """How an error about an unknown name ends: the closest known names, or all when there are few."""
    names = sorted(set(known))
    close = get_close_matches(name, names, n=3, cutoff=0.5)
    if close:
        return f"; did you mean {' or '.join(close)}?"
    if not names:
        return "; there are none"
    return f"; known: {', '.join(names[:12])}{', ...' if len(names) > 12 else ''}"


def required(element: Element, name: str) -> str:
    """A mandatory attribute."""
    text = element.get(name)
    if text is None:
        raise wrong(element, f"<{element.tag}> needs the attribute '{name}'")
    return text


def identity(element: Element) -> tuple[str, str]:
    """Id (URN) and version; blanks around them mean nothing (xsd:anyURI), and public files have some."""
    return required(element, "id").strip(), required(element, "version").strip()


def child(element: Element, tag: str) -> Element:
    """A mandatory child."""
    found = element.find(tag)
    if found is None:
        raise wrong(element, f"<{element.tag}> needs <{tag}>")
    return found


def choice(element: Element, name: str, values: Mapping[str, Value], default: str | None = None) -> Value:
    """A mandatory attribute (unless there is a default) with a fixed vocabulary, translated."""
    text = required(element, name) if default is None else element.get(name, default)
    try:
        return values[" ".join(text.split())]
    except KeyError:
        raise wrong(element, f"{name}: expected one of {', '.join(map(repr, values))}, got {text!r}") from None


def whole_number(element: Element, name: str) -> int:
    """A mandatory decimal integer."""
    text = required(element, name)
    try:
        return int(text)
    except ValueError:
        raise wrong(element, f"{name}: expected a whole number, got {text!r}") from None


def bounded(element: Element, name: str, lower: int, upper: int) -> int:
    """A mandatory decimal integer from `lower` to `upper`."""
    number = whole_number(element, name)
    if not lower <= number <= upper:
        raise wrong(element, f"{name}: expected a whole number from {lower} to {upper}, got {number}")
    return number


_TRUTH: Mapping[str, bool] = {"true": True, "1": True, "false": False, "0": False}


def flag(element: Element, name: str) -> bool:
    """An xsd:boolean that is false when it is not there."""
    return choice(element, name, _TRUTH, default="false")


def prose(element: Element) -> str:
    """The interpretation of an element as one line."""
    return " ".join(element.get("interpretation", "").split())


def text_of(parent: Element, tag: str) -> str:
    """The text of a child element as one line; empty when there is none."""
    return " ".join((parent.findtext(tag) or "").split())
