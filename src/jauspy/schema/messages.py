"""Messages and internal events."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import replace

from lxml.etree import _Element as Element

from jauspy.schema.composites import read_content
from jauspy.schema.document import flag, line_of, location, prose, required, text_of, wrong
from jauspy.schema.library import Scope
from jauspy.schema.model import DeclaredType, FixedField, InternalEvent, Message, Record

_CODE = re.compile(r"[0-9A-Fa-f]{4}")


def read_messages(message_set: Element, direction: str, scope: Scope) -> tuple[Message, ...]:
    """The messages of an `input_set` or `output_set`.

    Names are unique in it, and so are codes, except for those with the same content: a public definition has such.
    """
    names: dict[str, Element] = {}
    codes: dict[int, tuple[Message, Element]] = {}
    messages = []
    for element in message_set.iterfind(f"{direction}/*"):
        message = read_message(element, scope)
        first = names.setdefault(message.name, element)
        if first is not element:
            raise wrong(element, f"duplicate name '{message.name}'; the first is in line {line_of(first)}")
        other, first = codes.setdefault(message.code, (message, element))
        if first is not element and (message.body is None or message.body != other.body):
            raise wrong(element, f"duplicate message_id '{message.code:04X}'; the first is in line {line_of(first)}")
        messages.append(message)
    return tuple(messages)


def read_message(element: Element, scope: Scope) -> Message:
    """A message, written out or declared."""
    if element.tag == "message_def":
        return _message(element, scope)
    home, found = scope.find(element)
    name = required(found, "name")
    message = home.once(name, element, lambda: read_message(found, home))
    return replace(
        message,
        name=required(element, "name"),
        doc=prose(element) or message.doc,
        declared=message.declared or DeclaredType(home.set_id, home.version, name),
    )


def _message(element: Element, scope: Scope) -> Message:
    code = required(element, "message_id")
    if not _CODE.fullmatch(code):
        raise wrong(element, f"message_id: expected four hexadecimal digits, got {code!r}")
    header, body, footer = _parts(element)
    _check_header(header, scope)
    if read_content(footer, scope) is not None:
        raise wrong(footer, "a footer with content is not supported; no published message has one")
    return Message(
        name=required(element, "name"),
        code=int(code, 16),
        is_command=flag(element, "is_command"),
        body=read_content(body, scope),
        doc=text_of(element, "description"),
        where=location(element),
    )


def _parts(element: Element) -> Iterator[Element]:
    for part in ("header", "body", "footer"):
        yield from element.iterchildren(part, f"declared_{part}")


def _check_header(header: Element, scope: Scope) -> None:
    """Every message starts with its id; a header that says otherwise would not be JAUS."""
    match read_content(header, scope):
        case Record(fields=(FixedField(type="u16", scale=None),), presence=None):
            return
    raise wrong(header, "the header must be a record with the message id (unsigned short integer) alone")


def read_events(events: Element | None, scope: Scope) -> tuple[InternalEvent, ...]:
    """The internal events of a service."""
    if events is None:
        return ()
    seen: set[str] = set()
    found = []
    for element in events:
        event = read_event(element, scope)
        if event.name in seen:
            raise wrong(element, f"duplicate name '{event.name}'")
        seen.add(event.name)
        found.append(event)
    return tuple(found)


def read_event(element: Element, scope: Scope) -> InternalEvent:
    """An internal event, written out or declared."""
    if element.tag == "declared_event_def":
        home, found = scope.find(element)
        event = home.once(required(found, "name"), element, lambda: read_event(found, home))
        return replace(event, name=required(element, "name"), doc=prose(element) or event.doc)
    _, body, _ = _parts(element)
    return InternalEvent(
        name=required(element, "name"), body=read_content(body, scope), doc=text_of(element, "description")
    )
