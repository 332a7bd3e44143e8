"""Service definitions, and what they inherit from each other."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import replace

from lxml.etree import _Element as Element

from jauspy.schema.behavior import read_behavior
from jauspy.schema.document import child, identity, location, required, suggestion, text_of, wrong
from jauspy.schema.library import Key, Scope
from jauspy.schema.messages import read_events, read_messages
from jauspy.schema.model import Message, Reference, Service

_VERSION = re.compile(r"\d+\.\d+")


def version_key(version: str) -> tuple[int, ...]:
    """For sorting: 1.10 comes after 1.9."""
    return tuple(int(part) for part in version.split("."))


def read_service(element: Element, jsidl: str, scope: Scope) -> Service:
    """One service; its `inherits_from` is as written, see `resolve_parents`."""
    urn, version = identity(element)
    if not _VERSION.fullmatch(version):
        raise wrong(element, f"version: expected major.minor, got {version!r}")
    message_set = child(element, "message_set")
    inputs = read_messages(message_set, "input_set", scope)
    outputs = read_messages(message_set, "output_set", scope)
    _check_both_ways(element, inputs, outputs)
    return Service(
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
        behavior=read_behavior(element.find("protocol_behavior")),
        where=location(element),
    )


def _reference(element: Element) -> Reference:
    return Reference(required(element, "name"), *identity(element))


def _check_both_ways(element: Element, inputs: Sequence[Message], outputs: Sequence[Message]) -> None:
    """A message may come and go, but one code must not mean two things."""
    codes = {message.code: message for message in inputs}
    for message in outputs:
        other = codes.get(message.code)
        if other is not None and other.body != message.body:
            names = f"{other.name} and {message.name}"
            raise wrong(element, f"message_id '{message.code:04X}' means two things: {names}")


def resolve_parents(
    services: Sequence[Service], known: Sequence[Service], roots: Mapping[Key, Element]
) -> tuple[Service, ...]:
    """Check that all parents are there, and replace version patterns such as `1.*` by the newest match."""
    versions: dict[str, list[str]] = {}
    for service in (*services, *known):
        versions.setdefault(service.id, []).append(service.version)
    resolved = tuple(_resolve_parent(service, versions, roots[service.key]) for service in services)
    _refuse_cycles(resolved, known, roots)
    return resolved


def _resolve_parent(service: Service, versions: Mapping[str, list[str]], root: Element) -> Service:
    parent = service.inherits_from
    if parent is None:
        return service
    matches = [version for version in versions.get(parent.id, ()) if matches_version(version, parent.version)]
    if not matches:
        element = child(child(root, "references"), "inherits_from")
        wanted = f"{parent.id} {parent.version}"
        known = suggestion(wanted, (f"{urn} {version}" for urn, found in versions.items() for version in found))
        raise wrong(element, f"inherits_from: no service {wanted} is loaded{known}")
    return replace(service, inherits_from=replace(parent, version=max(matches, key=version_key)))


def matches_version(version: str, pattern: str) -> bool:
    """True when a version is the one wanted; the pattern `1.*` takes any 1.x."""
    return all(want in ("*", have) for have, want in zip(version.split("."), pattern.split("."), strict=False))


def _refuse_cycles(services: Sequence[Service], known: Sequence[Service], roots: Mapping[Key, Element]) -> None:
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
