"""Who a component, its node and its subsystem are, as Discovery tells (AS5710)."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Final

from jauspy.errors import ConfigError

SYSTEM, SUBSYSTEM, NODE, COMPONENT = 1, 2, 3, 4
"""The levels of a query (its field QueryType)."""


@dataclass(frozen=True, slots=True)
class Identity:
    """A name (Latin-1, at most 255 bytes), and the type of AS5710: 10001 vehicle, 40001 node, 60001 component."""

    name: str
    type: int

    def __post_init__(self) -> None:
        try:
            fits = len(self.name.encode("latin-1")) <= 255
        except UnicodeEncodeError:
            fits = False
        if not fits:
            raise ConfigError(f"identity {self.name!r}: a name on the wire is Latin-1 text of up to 255 bytes")


DEFAULT_IDENTITIES: Final[Mapping[int, Identity]] = {
    SYSTEM: Identity("jauspy", 10001),
    SUBSYSTEM: Identity("jauspy vehicle", 10001),
    NODE: Identity("jauspy node", 40001),
    COMPONENT: Identity("jauspy component", 60001),
}
