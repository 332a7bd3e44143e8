"""Options and lookups that several verbs of `jauspy schema` share."""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated

import typer

from jauspy.codec.names import set_package
from jauspy.ids import service_set

if TYPE_CHECKING:
    from jauspy.schema.model import Schema, Service

From = Annotated[
    list[str] | None,
    typer.Option("--from", metavar="FILE", help="Your own files, folders or patterns instead of what is built in."),
]


def definitions(sources: list[str] | None) -> Schema:
    """The services of these sources, or those built in."""
    from jauspy.schema import load_builtin
    from jauspy.schema.loader import load_own

    return load_own(sources) if sources else load_builtin()


def set_of(service: Service) -> str:
    """The set of a service: `core` of `urn:jaus:jss:core:Time`."""
    return service_set(service.id)


def is_set(service: Service, name: str) -> bool:
    """True for the set's name, that of its Python package, and the part of the URN before the service's name."""
    parts = service.id.split(":")
    return name.casefold() in {each.casefold() for each in (set_of(service), set_package(service.id), *parts[-2:-1])}
