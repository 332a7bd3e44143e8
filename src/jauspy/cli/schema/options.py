"""Options and lookups that several verbs of `jauspy schema` share."""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated

import typer

if TYPE_CHECKING:
    from jauspy.schema.model import Schema, Service

From = Annotated[
    list[str] | None,
    typer.Option("--from", metavar="FILE", help="Your own files, folders or patterns instead of what is built in."),
]


def definitions(sources: list[str] | None) -> Schema:
    """The services of these sources, or those built in."""
    from jauspy.schema import load_builtin
    from jauspy.schema.own import load_own

    return load_own(sources) if sources else load_builtin()


def set_of(service: Service) -> str:
    """The set of a service: `core` of `urn:jaus:jss:core:Time`."""
    return set_of_urn(service.id)


def set_of_urn(urn: str) -> str:
    """The last part of a URN but one."""
    return urn.rpartition(":")[0].rpartition(":")[2]
