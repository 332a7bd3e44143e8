"""`jauspy schema ls`: which services are defined."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Annotated, Any

import typer

from jauspy.cli.options import Json
from jauspy.cli.schema.options import From, definitions, is_set, set_of
from jauspy.codec.names import set_package
from jauspy.ids import service_set

if TYPE_CHECKING:
    from jauspy.schema.model import Message, Service


def ls(
    *,
    set_name: Annotated[
        str | None,
        typer.Option(
            "--set",
            metavar="SET",
            help="Only this service set, such as core; also environment_sensing, aeodrs.",
        ),
    ] = None,
    sources: From = None,
    as_json: Json = False,
) -> None:
    """List service definitions: set, name, version, what they inherit from, how many messages.

    Examples:
      jauspy schema ls --set mobility
      jauspy schema ls --json | jq -r .urn
      jauspy schema ls --from vendor/
    """
    import json

    from jauspy.cli.schema.tables import print_table

    services = _of_set(definitions(sources).services, set_name)
    if as_json:
        for service in services:
            print(json.dumps(as_object(service), ensure_ascii=False))
        return
    rows = [_row(service) for service in sorted(services, key=lambda service: (set_of(service), service.name))]
    print_table(("set", "service", "version", "inherits from", "messages"), rows)


def _of_set(services: Sequence[Service], set_name: str | None) -> list[Service]:
    from jauspy.errors import ConfigError

    found = [service for service in services if set_name is None or is_set(service, set_name)]
    if not found:
        known = ", ".join(sorted({set_of(service) for service in services}))
        raise ConfigError(f"there is no service set '{set_name}'; there is {known or 'none'}")
    return found


def _row(service: Service) -> tuple[str, ...]:
    parent = service.inherits_from
    inherited = f"{parent.id.rpartition(':')[2]} {parent.version}" if parent else ""
    if parent and service_set(parent.id) != set_of(service):
        inherited = f"{service_set(parent.id)} {inherited}"
    counts = f"{len(service.inputs)} in, {len(service.outputs)} out"
    return set_of(service), service.name, service.version, inherited, counts


def as_object(service: Service) -> dict[str, Any]:
    """A service as JSON carries it."""
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


def _message(message: Message) -> dict[str, str]:
    return {"code": f"{message.code:04X}", "name": message.name}
