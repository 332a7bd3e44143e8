"""`jauspy schema ls`: list service definitions; and how the other verbs find services by name."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from difflib import get_close_matches
from typing import Annotated, Any

import typer

from jauspy.cli import console
from jauspy.cli.console import print_table
from jauspy.cli.options import Json
from jauspy.codec.names import set_package
from jauspy.errors import ConfigError
from jauspy.ids import is_called, service_set
from jauspy.schema import load_builtin
from jauspy.schema.digest import same_wire
from jauspy.schema.loader import load_own
from jauspy.schema.model import MessageDefinition, Schema, ServiceDefinition
from jauspy.schema.services import version_key

SchemasOption = Annotated[
    list[str] | None,
    typer.Option(
        "--schemas", metavar="FILE", help="Your own files, folders or patterns, instead of the built-in definitions."
    ),
]


def definitions(sources: list[str] | None) -> Schema:
    """The services of these files, or the built-in ones."""
    return load_own(sources) if sources else load_builtin()


def set_of(service: ServiceDefinition) -> str:
    """The set of a service: `core` of `urn:jaus:jss:core:Time`."""
    return service_set(service.id)


def is_set(service: ServiceDefinition, name: str) -> bool:
    """True for the set's name, its Python package, and the part of the URN before the service's name."""
    parts = service.id.split(":")
    return name.casefold() in {word.casefold() for word in (set_of(service), set_package(service.id), *parts[-2:-1])}


def ls(
    *,
    set_name: Annotated[
        str | None,
        typer.Option(
            "--set",
            metavar="SET",
            help="Only this service set, such as core, environment_sensing or aeodrs.",
        ),
    ] = None,
    sources: SchemasOption = None,
    as_json: Json = False,
) -> None:
    """List service definitions: set, name, version, parent service, number of messages.

    Examples:
      jauspy schema ls --set mobility
      jauspy schema ls --json | jq -r .urn
      jauspy schema ls --schemas vendor/
    """
    services = _of_set(definitions(sources).services, set_name)
    if as_json:
        for service in services:
            console.print_json(as_object(service))
        return
    rows = [_row(service) for service in sorted(services, key=lambda service: (set_of(service), service.name))]
    print_table(("set", "service", "version", "inherits from", "messages"), rows)


def _of_set(services: Sequence[ServiceDefinition], set_name: str | None) -> list[ServiceDefinition]:

    found = [service for service in services if set_name is None or is_set(service, set_name)]
    if not found:
        known = ", ".join(sorted({set_of(service) for service in services}))
        raise ConfigError(f"there is no service set '{set_name}'; the sets are {known or 'none'}")
    return found


def _row(service: ServiceDefinition) -> tuple[str, ...]:
    parent = service.inherits_from
    inherited = f"{parent.id.rpartition(':')[2]} {parent.version}" if parent else ""
    if parent and service_set(parent.id) != set_of(service):
        inherited = f"{service_set(parent.id)} {inherited}"
    counts = f"{len(service.inputs)} in, {len(service.outputs)} out"
    return set_of(service), service.name, service.version, inherited, counts


def as_object(service: ServiceDefinition) -> dict[str, Any]:
    """A service as a JSON object."""
    parent = service.inherits_from
    return {
        "urn": service.id,
        "name": service.name,
        "version": service.version,
        "set": set_of(service),
        "package": set_package(service.id),
        "jsidl": service.jsidl,
        "inherits_from": {"urn": parent.id, "version": parent.version} if parent else None,
        "inputs": [_message(message) for message in service.inputs],
        "outputs": [_message(message) for message in service.outputs],
        "file": service.where.file if service.where else None,
    }


def _message(message: MessageDefinition) -> dict[str, str]:
    return {"code": f"{message.code:04X}", "name": message.name}


_VERSIONED = re.compile(r"(.+)[@:](\d+(?:\.\d+)*)")
_CODE = re.compile(r"(?:0[xX])?([0-9A-Fa-f]{4})[hH]?")


@dataclass(frozen=True, slots=True)
class Match:
    """A service, or a message of one; the services in `others` define the same message."""

    service: ServiceDefinition
    message: MessageDefinition | None = None
    others: tuple[ServiceDefinition, ...] = ()


def split_version(text: str) -> tuple[str, str | None]:
    """Name and version of `mobility:PrimitiveDriver@1.0`, or of `urn:jaus:jss:mobility:PrimitiveDriver:1.0`."""
    found = _VERSIONED.fullmatch(text)
    return (found[1], found[2]) if found else (text, None)


def find(schema: Schema, name: str, version: str | None = None) -> list[Match]:
    """Every service and message of this name, in the newest version of each service; `ConfigError` if there is none.

    A message that several services define identically is one match.
    """
    name, written = split_version(name)
    if written and version not in (None, written):
        raise ConfigError(f"{name} is given with version {written} and with {version}; give one version")
    version = version or written
    services = [service for service in schema.services if version in (None, service.version)]
    if not services:
        known = ", ".join(sorted({service.version for service in schema.services}))
        raise ConfigError(f"no service has version {version}; the versions are {known}")
    newest: dict[str, list[ServiceDefinition]] = {}
    for service in sorted(services, key=lambda service: version_key(service.version), reverse=True):
        newest.setdefault(service.id, []).append(service)
    found = [Match(versions[0]) for versions in newest.values() if _names(versions[0], name)]
    found += _messages(newest, name)
    if not found:
        raise ConfigError(_unknown(services, name, version))
    return found


def _names(service: ServiceDefinition, name: str) -> bool:
    """True for the service's name, its URN, and the end of its URN, as in `mobility:PrimitiveDriver`."""
    return name.casefold() == service.name.casefold() or is_called(service.id, name)


def _messages(newest: dict[str, list[ServiceDefinition]], name: str) -> Iterator[Match]:
    code = _CODE.fullmatch(name)
    groups: list[list[tuple[ServiceDefinition, MessageDefinition]]] = []
    for versions in newest.values():
        holder = next(
            (version for version in versions for message in version.messages if _is(message, name, code)), None
        )
        for message in holder.messages if holder else ():
            if holder is not None and _is(message, name, code):
                _group(groups, holder, message)
    for (service, message), *rest in groups:
        yield Match(service, message, tuple(other for other, _ in rest))


def _is(message: MessageDefinition, name: str, code: re.Match[str] | None) -> bool:
    return message.name.casefold() == name.casefold() or (code is not None and message.code == int(code[1], 16))


def _group(
    groups: list[list[tuple[ServiceDefinition, MessageDefinition]]],
    service: ServiceDefinition,
    message: MessageDefinition,
) -> None:
    for group in groups:
        first = group[0][1]
        if (first.name, first.code) == (message.name, message.code) and same_wire(first.body, message.body):
            if all(other is not service for other, _ in group):
                group.append((service, message))
            return
    groups.append([(service, message)])


def _unknown(services: list[ServiceDefinition], name: str, version: str | None) -> str:
    names = {service.name for service in services} | {m.name for service in services for m in service.messages}
    by_key = {known.casefold(): known for known in names}
    close = [by_key[key] for key in get_close_matches(name.casefold(), by_key, 3, 0.6)]
    which = f"{name!r} in version {version}" if version else f"{name!r}"
    hint = f"; did you mean {' or '.join(close)}?" if close else "; `jauspy schema ls` lists the services"
    return f"no service or message is called {which}{hint}"
