"""Incidents of a robot, as they show in its traffic: an emergency, control that is lost, a failure."""

from __future__ import annotations

from collections import OrderedDict
from collections.abc import Collection, Iterable, Iterator
from enum import StrEnum
from typing import Final, NamedTuple

from jauspy.capture.dissect import Part
from jauspy.codec.message import Message
from jauspy.ids import JausID, message_id
from jauspy.messages.core import (
    ClearEmergency,
    ConfirmControl,
    Event,
    RejectControl,
    ReleaseControl,
    ReportControl,
    ReportStatus,
    SetEmergency,
)
from jauspy.messages.iop.v1_1.platform_state import ReportPlatformState

MAX_REMEMBERED: Final = 1024
"""Components, or pairs of a client and a component, whose last state is remembered; the oldest is forgotten first."""
_CODES: Final = frozenset(
    kind.CODE
    for kind in (
        ReportStatus,
        ReportPlatformState,
        SetEmergency,
        ClearEmergency,
        ConfirmControl,
        ReleaseControl,
        RejectControl,
        ReportControl,
    )
)
"""Ids of the messages that show incidents, or what an incident is compared with."""
_REPORT_IN_EVENT: Final = 8
"""Offset of the report in the bytes of an Event: behind its id, event id, sequence number and count."""


def may_show_incident(payload: bytes) -> bool:
    """A look at the id of a message, also of a report in an event, which costs a fraction of decoding it."""
    if len(payload) < 2:
        return False
    if message_id(payload) == Event.CODE:
        payload = payload[_REPORT_IN_EVENT:]
    return len(payload) >= 2 and message_id(payload) in _CODES


class Kind(StrEnum):
    """What can happen."""

    EMERGENCY = "emergency"
    """A component reports Emergency, or a client sets it."""
    CONTROL_LOST = "control-lost"
    """A client has lost control without releasing it, as when its messages stop coming."""
    FAILURE = "failure"
    """A component reports Failure."""


class Incident(NamedTuple):
    """What happened, and to which component."""

    kind: Kind
    component: JausID


class _Memory(OrderedDict[object, object]):
    """The last states, bounded."""

    def change(self, key: object, value: object) -> bool:
        """Remember a state; true if it is another than the last."""
        changed = self.get(key) != value
        self[key] = value
        self.move_to_end(key)
        if len(self) > MAX_REMEMBERED:
            self.popitem(last=False)
        return changed


class IncidentDetector:
    """Finds incidents of the components of a subsystem. A state that is reported again and again is one incident."""

    def __init__(self, subsystem: int | None, kinds: Collection[Kind] = tuple(Kind)) -> None:
        """`subsystem` None is any."""
        self._subsystem, self._kinds = subsystem, frozenset(kinds)
        self._states, self._emergencies = _Memory(), _Memory()
        self._controllers, self._ended = _Memory(), _Memory()

    def incidents(self, parts: Iterable[Part]) -> Iterator[Incident]:
        """What the messages of a datagram show."""
        for part in parts:
            for incident in self._of(part):
                if incident.kind in self._kinds and self._subsystem in (None, incident.component.subsystem):
                    yield incident

    def _of(self, part: Part) -> Iterator[Incident]:
        message = part.content.message
        if message is not None and message.CODE == Event.CODE:
            message = getattr(message, "report_message", None)
        if not isinstance(message, Message):
            return
        source, destination = part.packet.source, part.packet.destination
        match message.CODE:
            case ReportStatus.CODE | ReportPlatformState.CODE:
                field = "status" if message.CODE == ReportStatus.CODE else "platform_state"
                state = getattr(getattr(message, field, None), "name", "")
                if self._states.change((source, message.CODE), state) and state in _INCIDENT_OF:
                    yield Incident(_INCIDENT_OF[state], source)
            case SetEmergency.CODE if self._emergencies.change((source, destination), True):
                yield Incident(Kind.EMERGENCY, destination)
            case ClearEmergency.CODE:
                self._emergencies.change((source, destination), False)
            case ConfirmControl.CODE if _code(message) == ConfirmControl.ResponseCode.CONTROL_ACCEPTED:
                self._controllers.change(source, destination)
                self._ended.change((destination, source), False)
            case ReleaseControl.CODE:
                self._control_ends(source, destination)
            case RejectControl.CODE if _code(message) == RejectControl.ResponseCode.CONTROL_RELEASED:
                if self._control_ends(destination, source):
                    yield Incident(Kind.CONTROL_LOST, source)
            case ReportControl.CODE:
                yield from self._reported(source, message)

    def _control_ends(self, client: JausID, component: JausID) -> bool:
        """False if it has ended before, as if it was released; true also if its beginning was not seen."""
        if self._controllers.get(component) == client:
            self._controllers.change(component, None)
        return self._ended.change((client, component), True)

    def _reported(self, component: JausID, message: object) -> Iterator[Incident]:
        """A component tells who controls it; that another client has taken over is told to the loser."""
        ids = [getattr(message, name) for name in ("subsystem_id", "node_id", "component_id")]
        client = JausID(*ids) if all(ids) else None
        if self._controllers.change(component, client) and client is None:
            yield Incident(Kind.CONTROL_LOST, component)


_INCIDENT_OF: Final = {"EMERGENCY": Kind.EMERGENCY, "FAILURE": Kind.FAILURE}


def _code(message: object) -> object:
    return getattr(message, "response_code", None)
