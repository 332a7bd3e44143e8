"""Finds backends by name: packages announce them in the entry-point group `jauspy.backends`."""

from __future__ import annotations

from importlib.metadata import EntryPoint, entry_points
from typing import Final, cast

from jauspy.errors import ConfigError
from jauspy.platform.contract import Backend

GROUP: Final = "jauspy.backends"


def names() -> list[str]:
    """The backends that are installed, sorted; one may still lack a package that it needs."""
    return sorted({entry.name for entry in entry_points(group=GROUP)})


def find(name: str) -> Backend:
    """Return the backend of that name. Raises `ConfigError` with the installed backends, or with a missing package."""
    matches = entry_points(group=GROUP, name=name)
    if not matches:
        raise ConfigError(f"no backend {name!r}; installed are: {', '.join(names()) or 'none'}")
    return _load(next(iter(matches)))


def _load(entry: EntryPoint) -> Backend:
    try:
        factory = entry.load()
    except (ImportError, AttributeError) as error:
        raise ConfigError(f"backend {entry.name!r} ({entry.value}) cannot be loaded: {error}") from error
    return cast("Backend", factory())
