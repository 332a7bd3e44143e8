"""The inputs whose content matters, and the internal events that can be brought about from outside."""

from __future__ import annotations

from typing import Final

from jauspy.codec.base import Message
from jauspy.conformance.checks import has
from jauspy.conformance.offers import ALL_SERVICES
from jauspy.conformance.walk.access import ACCESS, SILENT_CLIENT
from jauspy.conformance.walk.arms import ARMS
from jauspy.conformance.walk.driving import DRIVING
from jauspy.conformance.walk.effects import EFFECTS
from jauspy.conformance.walk.events import COMMANDS, DUE, EVENTS, EXPIRED, NOT_RENEWED
from jauspy.conformance.walk.explorer import STOP, Stimulus
from jauspy.conformance.walk.lists import LISTS
from jauspy.conformance.walk.sensors import PICTURES, SENSORS
from jauspy.conformance.walk.settings import CLOCKS, MIRRORS
from jauspy.messages.core import ClearEmergency, QueryConfiguration, QueryIdentification, SetEmergency


def _one(message: Message, variant: str = "", **fields: object) -> Stimulus:
    """A message with fields that matter; `fields` are what its report must say."""
    checks = {message.NAME.replace("Query", "Report", 1): has(**fields)} if fields else {}
    return Stimulus(message.NAME, lambda _: message, variant, checks=checks)


RECIPES: Final[tuple[Stimulus, ...]] = (
    *ACCESS,
    *EVENTS,
    *COMMANDS,
    *LISTS,
    *EFFECTS,
    *DRIVING,
    *ARMS,
    *PICTURES,
    *CLOCKS,
    *SENSORS,
    *MIRRORS,
    _one(SetEmergency(STOP)),
    _one(ClearEmergency(STOP)),
    *(_one(QueryIdentification(level), f"level {level}", query_type=level) for level in (1, 2, 3, 4)),
    *(_one(QueryConfiguration(level), f"level {level}") for level in (2, 3)),
    _one(ALL_SERVICES, "everything"),
)
"""Of all other inputs the neutral message is sent; queries with presence vectors ask for all and for none."""

SPONTANEOUS: Final[tuple[Stimulus, ...]] = (SILENT_CLIENT, NOT_RENEWED, DUE, EXPIRED)
"""Internal events that can be brought about from outside."""
