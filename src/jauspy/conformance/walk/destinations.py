"""Somewhere to go that nobody reaches during a step, of the kinds that a component takes."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from types import MappingProxyType
from typing import Final

from jauspy.codec.base import Message
from jauspy.conformance.walk import lists
from jauspy.conformance.walk.explorer import PILOT, Walker
from jauspy.messages.core import Standby
from jauspy.messages.mobility import (
    SetGlobalLoiter,
    SetGlobalPathSegment,
    SetGlobalWaypoint,
    SetLocalLoiter,
    SetLocalPathSegment,
    SetLocalWaypoint,
)

MOBILITY: Final = "urn:jaus:jss:mobility:"
FAR: Final = 1000.0
"""m; nobody gets there during a step."""
LATITUDE, LONGITUDE = 1.0, 2.0
"""Degrees."""


def local_loiter(x: float) -> SetLocalLoiter:
    """Stay over a place."""
    return SetLocalLoiter(SetLocalLoiter.LocalLoiterRec(x, FAR), SetLocalLoiter.HoverRec(0, 0.0, 0.0))


def global_loiter(latitude: float) -> SetGlobalLoiter:
    """Stay over a place."""
    return SetGlobalLoiter(SetGlobalLoiter.GlobalLoiterRec(latitude, LONGITUDE), SetGlobalLoiter.HoverRec(0, 0.0, 0.0))


_WAYPOINTS: Final[Mapping[str, Message]] = MappingProxyType(
    {
        "LocalWaypoint": SetLocalWaypoint(x=FAR, y=FAR),
        "GlobalWaypoint": SetGlobalWaypoint(latitude=LATITUDE, longitude=LONGITUDE),
    }
)
_SEGMENTS: Final[Mapping[str, Message]] = MappingProxyType(
    {
        "LocalPathSegment": SetLocalPathSegment(p1_x=FAR, p1_y=FAR, p2_x=2 * FAR, p2_y=FAR, weighting_factor=0.0),
        "GlobalPathSegment": SetGlobalPathSegment(
            p1_latitude=LATITUDE,
            p1_longitude=LONGITUDE,
            p2_latitude=LATITUDE,
            p2_longitude=LONGITUDE + 1.0,
            weighting_factor=0.0,
        ),
    }
)
_LOITERS: Final[Mapping[str, Message]] = MappingProxyType(
    {"LocalLoiter": local_loiter(FAR), "GlobalLoiter": global_loiter(LATITUDE)}
)
"""By how the names begin of the services that take them."""


def element(walker: Walker) -> Message:
    """What the lists of its drivers are made of."""
    return next(_taken(walker, {**_WAYPOINTS, **_SEGMENTS}), _WAYPOINTS["LocalWaypoint"])


def _taken(walker: Walker, kinds: Mapping[str, Message]) -> Iterator[Message]:
    for name, made in kinds.items():
        if any(each.startswith(f"{MOBILITY}{name}") for each in walker.services):
            yield made


def place(walker: Walker, waypoint: Message) -> None:
    """The one in control sets a waypoint, before anybody drives."""
    walker.client(PILOT).send(waypoint, to=walker.component)


def place_all(walker: Walker) -> None:
    """One of each kind that the component takes by itself, without a list."""
    for each in _taken(walker, {**_WAYPOINTS, **_LOITERS}):
        place(walker, each)


def stop(walker: Walker, role: str) -> None:  # noqa: ARG001 - a Prepare
    """Nobody drives any more."""
    walker.client(PILOT).send(Standby(), to=walker.component)
    lists.clear(walker, PILOT)
    walker.where = None
