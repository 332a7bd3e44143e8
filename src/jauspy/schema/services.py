"""Readers of services, their messages and internal events; what services inherit from each other."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace

from lxml.etree import _Element as Element

from jauspy.schema.behavior import read_behavior
from jauspy.schema.document import (
    child,
    flag,
    give_its_file,
    identity,
    line_of,
    location,
    prose,
    required,
    suggestion,
    text_of,
    wrong,
)
from jauspy.schema.fields import read_content
from jauspy.schema.library import Key, NameScope
from jauspy.schema.model import (
    DeclaredType,
    FixedField,
    InternalEvent,
    MessageDefinition,
    Record,
    Reference,
    ServiceDefinition,
)

_CODE = re.compile(r"[0-9A-Fa-f]{4}")


def read_messages(message_set: Element, direction: str, scope: NameScope) -> tuple[MessageDefinition, ...]:
    """Read the messages of an `input_set` or `output_set`.

    Names are unique. Codes are, too, except for messages with the same content, which a public definition has.
    """
    names: dict[str, Element] = {}
    codes: dict[int, tuple[MessageDefinition, Element]] = {}
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


def read_message(element: Element, scope: NameScope) -> MessageDefinition:
    """Read a message, written out or declared."""
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


def _message(element: Element, scope: NameScope) -> MessageDefinition:
    code = required(element, "message_id")
    if not _CODE.fullmatch(code):
        raise wrong(element, f"message_id: expected four hexadecimal digits, got {code!r}")
    header, body, footer = _parts(element)
    _check_header(header, scope)
    if read_content(footer, scope) is not None:
        raise wrong(footer, "a footer with content is not supported; no published message has one")
    return MessageDefinition(
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


def _check_header(header: Element, scope: NameScope) -> None:
    """Check that the header contains the message id only."""
    match read_content(header, scope):
        case Record(fields=(FixedField(type="u16", scale=None),), presence=None):
            return
    raise wrong(header, "the header must be a record with the message id (unsigned short integer) alone")


def read_events(events: Element | None, scope: NameScope) -> tuple[InternalEvent, ...]:
    """Read the internal events of a service."""
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


def read_event(element: Element, scope: NameScope) -> InternalEvent:
    """Read an internal event, written out or declared."""
    if element.tag == "declared_event_def":
        home, found = scope.find(element)
        event = home.once(required(found, "name"), element, lambda: read_event(found, home))
        return replace(event, name=required(element, "name"), doc=prose(element) or event.doc)
    _, body, _ = _parts(element)
    return InternalEvent(
        name=required(element, "name"), body=read_content(body, scope), doc=text_of(element, "description")
    )


_VERSION = re.compile(r"\d+\.\d+", re.ASCII)


def version_key(version: str) -> tuple[int, ...]:
    """Key for sorting: 1.10 comes after 1.9."""
    return tuple(int(part) for part in version.split("."))


def read_service(element: Element, jsidl: str, scope: NameScope) -> ServiceDefinition:
    """Read a service; its `inherits_from` is as written, see `resolve_parents`."""
    urn, version = identity(element)
    if not _VERSION.fullmatch(version):
        raise wrong(element, f"version: expected major.minor, got {version!r}")
    message_set = child(element, "message_set")
    inputs = read_messages(message_set, "input_set", scope)
    outputs = read_messages(message_set, "output_set", scope)
    _check_both_ways(element, inputs, outputs)
    return ServiceDefinition(
        name=required(element, "name"),
        id=urn,
        version=version,
        jsidl=jsidl,
        doc=text_of(element, "description"),
        assumptions=text_of(element, "assumptions"),
        inherits_from=next((_reference(part) for part in element.iterfind("references/inherits_from")), None),
        client_of=tuple(_reference(part) for part in element.iterfind("references/client_of")),
        inputs=inputs,
        outputs=outputs,
        internal_events=read_events(element.find("internal_events_set"), scope),
        behavior=read_behavior(element.find("protocol_behavior"), {message.name for message in inputs}),
        where=location(element),
    )


def _reference(element: Element) -> Reference:
    return Reference(required(element, "name"), *identity(element))


def _check_both_ways(
    element: Element, inputs: Sequence[MessageDefinition], outputs: Sequence[MessageDefinition]
) -> None:
    """A message may be both input and output, but a code must not have two meanings."""
    codes = {message.code: message for message in inputs}
    for message in outputs:
        other = codes.get(message.code)
        if other is not None and other.body != message.body:
            names = f"{other.name} and {message.name}"
            raise wrong(element, f"message_id '{message.code:04X}' has two meanings: {names}")


def resolve_parents(
    services: Sequence[ServiceDefinition], known: Sequence[ServiceDefinition], roots: Mapping[Key, Element]
) -> tuple[ServiceDefinition, ...]:
    """Check that all parents are known, and replace version patterns such as `1.*` by the newest match."""
    versions: dict[str, list[str]] = {}
    for service in (*services, *known):
        versions.setdefault(service.id, []).append(service.version)
    resolved = tuple(_resolve_parent(service, versions, roots[service.key]) for service in services)
    _refuse_cycles(resolved, known, roots)
    return resolved


def _resolve_parent(service: ServiceDefinition, versions: Mapping[str, list[str]], root: Element) -> ServiceDefinition:
    parent = service.inherits_from
    if parent is None:
        return service
    matches = [version for version in versions.get(parent.id, ()) if matches_version(version, parent.version)]
    if not matches:
        element = child(child(root, "references"), "inherits_from")
        wanted = f"{parent.id} {parent.version}"
        known = suggestion(wanted, (f"{urn} {version}" for urn, found in versions.items() for version in found))
        raise wrong(element, f"inherits_from: no service {wanted} is loaded{known}; {give_its_file(parent.id)}")
    return replace(service, inherits_from=replace(parent, version=max(matches, key=version_key)))


def matches_version(version: str, pattern: str) -> bool:
    """True when a version is the one wanted; the pattern `1.*` takes any 1.x."""
    return all(want in ("*", have) for have, want in zip(version.split("."), pattern.split("."), strict=False))


def _refuse_cycles(
    services: Sequence[ServiceDefinition], known: Sequence[ServiceDefinition], roots: Mapping[Key, Element]
) -> None:
    parents = {
        service.key: None if service.inherits_from is None else service.inherits_from.key
        for service in (*services, *known)
    }
    for service in services:
        ancestor = parents[service.key]
        for _ in parents:
            if ancestor is None:
                break
            if ancestor == service.key:
                raise wrong(roots[service.key], f"{service.id} inherits from itself")
            ancestor = parents.get(ancestor)
