"""Finding a service or a message by name, URN or message id."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass
from difflib import get_close_matches

from jauspy.errors import ConfigError
from jauspy.ids import is_called
from jauspy.schema.model import Message, Schema, Service
from jauspy.schema.services import version_key
from jauspy.schema.wire import same_wire

_VERSIONED = re.compile(r"(.+)[@:](\d+(?:\.\d+)*)")
_CODE = re.compile(r"(?:0[xX])?([0-9A-Fa-f]{4})[hH]?")


@dataclass(frozen=True, slots=True)
class Match:
    """What a name stands for: a service, or a message of one; `others` have the same message."""

    service: Service
    message: Message | None = None
    others: tuple[Service, ...] = ()


def split_version(text: str) -> tuple[str, str | None]:
    """Name and version of `mobility:PrimitiveDriver@1.0`, or of `urn:jaus:jss:mobility:PrimitiveDriver:1.0`."""
    found = _VERSIONED.fullmatch(text)
    return (found[1], found[2]) if found else (text, None)


def find(schema: Schema, name: str, version: str | None = None) -> list[Match]:
    """Every service and message of this name, newest version of each service; `ConfigError` when there is none.

    Messages that are the same in several services are one match.
    """
    name, written = split_version(name)
    if written and version not in (None, written):
        raise ConfigError(f"{name} is wanted in version {written} and in {version}; say one of them")
    version = version or written
    services = [service for service in schema.services if version in (None, service.version)]
    if not services:
        known = ", ".join(sorted({service.version for service in schema.services}))
        raise ConfigError(f"nothing has the version {version}; there are {known}")
    newest: dict[str, list[Service]] = {}
    for service in sorted(services, key=lambda service: version_key(service.version), reverse=True):
        newest.setdefault(service.id, []).append(service)
    found = [Match(versions[0]) for versions in newest.values() if _names(versions[0], name)]
    found += _messages(newest, name)
    if not found:
        raise ConfigError(_unknown(services, name, version))
    return found


def _names(service: Service, name: str) -> bool:
    """True for the service's name, its URN, and the end of its URN, as in `mobility:PrimitiveDriver`."""
    return name.casefold() == service.name.casefold() or is_called(service.id, name)


def _messages(newest: dict[str, list[Service]], name: str) -> Iterator[Match]:
    code = _CODE.fullmatch(name)
    groups: list[list[tuple[Service, Message]]] = []
    for versions in newest.values():
        holder = next((each for each in versions for message in each.messages if _is(message, name, code)), None)
        for message in holder.messages if holder else ():
            if holder is not None and _is(message, name, code):
                _group(groups, holder, message)
    for (service, message), *rest in groups:
        yield Match(service, message, tuple(other for other, _ in rest))


def _is(message: Message, name: str, code: re.Match[str] | None) -> bool:
    return message.name.casefold() == name.casefold() or (code is not None and message.code == int(code[1], 16))


def _group(groups: list[list[tuple[Service, Message]]], service: Service, message: Message) -> None:
    for group in groups:
        first = group[0][1]
        if (first.name, first.code) == (message.name, message.code) and same_wire(first.body, message.body):
            if all(other is not service for other, _ in group):
                group.append((service, message))
            return
    groups.append([(service, message)])


def _unknown(services: list[Service], name: str, version: str | None) -> str:
    names = {service.name for service in services} | {m.name for service in services for m in service.messages}
    by_key = {known.casefold(): known for known in names}
    close = [by_key[key] for key in get_close_matches(name.casefold(), by_key, 3, 0.6)]
    which = f"{name!r} in version {version}" if version else f"{name!r}"
    hint = f"; did you mean {' or '.join(close)}?" if close else "; `jauspy schema ls` lists the services"
    return f"no service or message is called {which}{hint}"
