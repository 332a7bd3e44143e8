"""Services that the modules of a robot may offer, by the names that its TOML file uses.

Those of jauspy stand in the kinds of modules. Installed packages add services in the entry-point group
`jauspy.services`: the entry's name is the service's, and its object is a `ServiceEntry`. See docs/adding-a-service.md.
"""

from __future__ import annotations

from collections.abc import Iterable
from importlib.metadata import EntryPoint, entry_points
from typing import Any, Final

from jauspy.errors import ConfigError
from jauspy.robot.kinds import KINDS, Context, ServiceEntry
from jauspy.services.service import Service

GROUP: Final = "jauspy.services"

CORE: Final = ("Discovery", "Time", "Liveness")
"""Optional core services; Transport, Events, AccessControl and Management are in every module."""


def defaults(module: str) -> tuple[str, ...]:
    """The services of a module of that type that lists none."""
    return (*CORE, *(name for name, entry in KINDS[module].services.items() if entry.by_default))


def find(module: str, name: str) -> ServiceEntry[Any]:
    """The service of that name for that type of module, beside the core services.

    Raises `ConfigError` if there is none, or if the package that provides it cannot be loaded.
    """
    if (built_in := KINDS[module].services.get(name)) is not None:
        return built_in
    found = [_load(entry) for entry in entry_points(group=GROUP, name=name)]
    for entry in found:
        if entry.context.module == module:
            return entry
    installed = sorted({entry.name for entry in entry_points(group=GROUP)})
    known = ", ".join((*CORE, *KINDS[module].services)) + (
        f"; from other packages: {', '.join(installed)}" * bool(installed)
    )
    raise ConfigError(f"a {module} has no service {name!r}; it can have: {known}")


def _load(entry: EntryPoint) -> ServiceEntry[Any]:
    try:
        found = entry.load()
    except (ImportError, AttributeError) as error:
        raise ConfigError(f"service {entry.name!r} ({entry.value}) cannot be loaded: {error}") from error
    if not isinstance(found, ServiceEntry) or getattr(found.context, "module", None) not in KINDS:
        raise ConfigError(f"service {entry.name!r} ({entry.value}) is not a ServiceEntry for a known module type")
    return found


def make(module: str, names: Iterable[str] | None, context: Context) -> list[Service]:
    """The services of a module that have these names (None: the defaults that the robot has the parts for).

    Raises `ConfigError` for a service that is named and needs what the robot lacks.
    """
    chosen = list(defaults(module) if names is None else names)
    order = list(KINDS[module].services)
    made: list[Service] = []
    for name in sorted(set(chosen) - set(CORE), key=lambda name: order.index(name) if name in order else len(order)):
        entry = find(module, name)
        service = entry.make(context)
        if service is not None:
            made.append(service)
        elif names is not None:
            raise ConfigError(f"{name} needs {entry.needs or 'a part that this robot does not have'}")
    return made
