"""The definitions that a verb uses: those built in, the user's files, the preferred service and version."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from difflib import get_close_matches
from typing import Annotated

import typer

from jauspy.codec.build import load_schema
from jauspy.codec.message import Message
from jauspy.codec.registry import NO_HINTS, Hints, Registry
from jauspy.errors import ConfigError
from jauspy.messages import registry
from jauspy.schema import Schema, load_builtin, model
from jauspy.schema.loader import load_own

SchemasOption = Annotated[
    list[str] | None,
    typer.Option(
        "--schemas",
        metavar="FILE",
        help="Your own JSIDL files, folders or patterns, preferred to the built-in definitions; may be repeated.",
    ),
]
ServiceName = Annotated[
    str | None,
    typer.Option(
        "--service", metavar="NAME", help="Which service, if several have the message: a URN or the end of one."
    ),
]
ServiceVersion = Annotated[
    str | None, typer.Option("--version", metavar="V", help="The service's version. Default: the newest.")
]


@dataclass(frozen=True, slots=True)
class Definitions:
    """The messages of `registry`; `own` has the models of the user's files."""

    registry: Registry
    own: Schema | None = None

    def model_of(self, kind: type[Message]) -> model.MessageDefinition:
        """The definition of a message class."""
        key = (kind.SERVICE, kind.VERSION)
        services = self.own.services if self.own else ()
        service = next((service for service in services if service.key == key), None) or load_builtin().service(*key)
        return next(message for message in service.messages if (message.code, message.name) == (kind.CODE, kind.NAME))

    def hints(self, service: str | None = None, version: str | None = None, message: str | None = None) -> Hints:
        """The preferred definitions; raises `ConfigError`, with similar names, for an unknown name."""
        entries = self.registry.entries
        services = {entry.service for entry in entries}
        for wanted, what, known in (
            (service, "service", {*services, *(urn.rpartition(":")[2] for urn in services)}),
            (version, "version", {entry.version for entry in entries}),
            (message, "message", {entry.name for entry in entries}),
        ):
            hints = Hints(**{what: wanted})
            if not any(map(hints.fit, entries)):
                raise _unknown(what, str(wanted), known)
        found = Hints(service, version, message)
        return NO_HINTS if found == NO_HINTS else found  # which decoding asks for by identity


def definitions(sources: list[str] | None) -> Definitions:
    """The built-in definitions, with those of the files preferred to them."""
    if not sources:
        return Definitions(registry)

    user_schema = load_own(sources)
    return Definitions(load_schema(user_schema), user_schema)


def _unknown(what: str, wanted: str, known: Iterable[str]) -> Exception:

    by_key = {name.casefold(): name for name in known}
    close = [by_key[key] for key in get_close_matches(wanted.casefold(), by_key, 3, 0.6)]
    hint = f"; did you mean {' or '.join(close)}?" if close else ""
    return ConfigError(f"no {what} {wanted} is known{hint}")
