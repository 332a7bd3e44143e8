"""What can be known of components from their messages alone: names, services, states, control, rates and losses.

Nothing is asked. What no message has told yet is None, and shown as unknown.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Iterator
from dataclasses import dataclass, field, replace
from enum import IntEnum
from typing import Any, Final, NamedTuple

from jauspy.ids import JausID
from jauspy.inspection.rates import BEYOND, Route
from jauspy.inspection.traffic import SeenMessage
from jauspy.messages.core.v1_0 import access_control as control, discovery, management
from jauspy.messages.core.v1_1.discovery import ReportServiceList
from jauspy.protocol.header import Ack, Packet

MAX_COMPONENTS: Final = 1000
MAX_STREAMS: Final = 10_000
"""Different senders, receivers and names; what is beyond is counted together."""
MAX_SERVICES: Final = 100
"""Services of one component."""
MAX_GROUPS: Final = 1000
"""Names of subsystems and of nodes."""
MAX_REQUESTS: Final = 16
"""Clients whose requests for control of one component are remembered until they are answered."""
MAX_TEXT: Final = 80
"""Characters of a name or URN."""
MAX_GAP: Final = 1000
"""Numbers that may be missing in a row; a wider gap is a restart of the sender."""
RECENT_NUMBERS: Final = 64
RATE_SECONDS: Final = 5
"""Whole seconds over which a rate is counted."""
HISTORY_SECONDS: Final = 60


def within(id: str, scope: str) -> bool:
    """True if an id is that of a component, node or subsystem, or in it."""
    return id == scope or id.startswith(scope + ".")


class State(NamedTuple):
    """The state of a component."""

    name: str
    """As in `ReportStatus.Status`: READY, STANDBY, ..."""
    time: float
    reported: bool
    """False if it is only what a command that was seen should have led to."""


class Control(NamedTuple):
    """Who controls a component."""

    controller: JausID | None
    """None: nobody."""
    authority: int | None
    time: float


class History:
    """Numbers of messages in each of the last `HISTORY_SECONDS` seconds."""

    __slots__ = ("_counts", "_first", "_newest")

    def __init__(self) -> None:
        self._counts: deque[int] = deque([0] * HISTORY_SECONDS, HISTORY_SECONDS)
        self._first: int | None = None
        self._newest = 0

    def add(self, time: float) -> None:
        """Count a message."""
        second = int(time)
        if self._first is None:
            self._first = self._newest = second
        self._advance(second)
        age = self._newest - second
        if age < HISTORY_SECONDS:
            self._counts[-1 - age] += 1

    def rate(self, now: float) -> float:
        """Messages a second over the last whole seconds; over what there is if that is less."""
        if self._first is None:
            return 0.0
        counts = self.counts(now)
        seconds = min(RATE_SECONDS, int(now) - self._first)
        return sum(counts[-1 - seconds : -1]) / seconds if seconds > 0 else float(counts[-1])

    def counts(self, now: float) -> list[int]:
        """The counts of seconds up to that of `now`, the oldest first."""
        missing = max(0, min(HISTORY_SECONDS, int(now) - self._newest))
        return [*self._counts, *[0] * missing][-HISTORY_SECONDS:]

    def copy(self) -> History:
        """The same in a further object."""
        new = History()
        new._counts, new._first, new._newest = self._counts.copy(), self._first, self._newest
        return new

    def _advance(self, second: int) -> None:
        ahead = second - self._newest
        if ahead > 0:
            self._counts.extend([0] * min(ahead, HISTORY_SECONDS))
            self._newest = second


@dataclass(slots=True)
class Sequence:
    """The sequence numbers of one sender, which counts the messages to all receivers together."""

    missing: int = 0
    """Numbers that were not seen: lost, or sent where nobody listens."""
    resent: int = 0
    """Messages that were seen before."""
    restarts: int = 0
    last: int | None = None
    recent: deque[int] = field(default_factory=lambda: deque(maxlen=RECENT_NUMBERS))

    def add(self, number: int) -> None:
        """Count the number of a message that is no acknowledgement."""
        if self.last is None:
            self.last = number
        ahead = (number - self.last) & 0xFFFF
        if number in self.recent:
            self.resent += 1
            return
        if 0xFFFF - ahead < RECENT_NUMBERS:  # late
            self.missing = max(0, self.missing - 1)
        else:
            if ahead > MAX_GAP:
                self.restarts += 1
                self.recent.clear()
            else:
                self.missing += max(0, ahead - 1)
            self.last = number
        self.recent.append(number)


@dataclass(slots=True)
class Stream:
    """The messages of one name from one component to another."""

    latest: SeenMessage
    count: int = 0
    bytes: int = 0
    history: History = field(default_factory=History)


@dataclass(slots=True)
class ObservedComponent:
    """A component that has sent or received messages, or that another one has reported."""

    id: JausID
    name: str | None = None
    type: str | None = None
    services: tuple[str, ...] | None = None
    """Names with versions, sorted."""
    state: State | None = None
    before_emergency: str | None = None
    control: Control | None = None
    authority: int | None = None
    """Its own, as a client."""
    requests: dict[JausID, int] = field(default_factory=dict)
    """Authorities of requests for control that are not answered yet."""
    host: str = ""
    """Address from which its last message came; that of the node manager for components of its machine."""
    heard: float | None = None
    """Time of the last message that it sent."""
    sent: int = 0
    sequence: Sequence = field(default_factory=Sequence)
    history: History = field(default_factory=History)


class Observed:
    """Components and their messages, as far as the messages added so far tell; all tables are bounded."""

    def __init__(self) -> None:
        self.components: dict[JausID, ObservedComponent] = {}
        self.names: dict[tuple[int, int | None], str] = {}
        """Names of subsystems and of nodes, by their numbers; no node for a subsystem."""
        self.streams: dict[Route, Stream] = {}
        self.history = History()
        self.count = 0
        self.bytes = 0
        self.undecodable = 0
        self.beyond = 0
        """Messages from or to components that no longer fit into the table."""
        self.start: float | None = None
        self.end: float | None = None

    def add(self, seen: SeenMessage, *, listed: bool = True) -> None:
        """Learn from a message. One that is not `listed` is not in `streams`, as when a filter leaves it out."""
        packet = seen.part.packet
        self.start = seen.time if self.start is None else self.start
        self.end = seen.time
        self.count += 1
        self.bytes += seen.size
        self.history.add(seen.time)
        self.undecodable += seen.part.content.broken or bool(seen.part.content.deviations)
        sender = self._component(packet.source)
        if sender is None:
            self.beyond += 1
        else:
            sender.host, sender.heard = seen.host, seen.time
            sender.sent += 1
            sender.history.add(seen.time)
            if packet.ack not in (Ack.ACK, Ack.NAK):
                sender.sequence.add(packet.sequence)
        if not packet.destination.is_wildcard:
            self._component(packet.destination)
        if listed:
            self._add_to_stream(seen, packet)
        if sender is not None and seen.part.content.message is not None:
            self._infer(sender, packet.destination, seen.part.content.message, seen.time)

    def clear_streams(self) -> None:
        """Forget the messages, as for another filter; what is known of components stays."""
        self.streams.clear()

    def streams_of(self, scope: str) -> list[tuple[Route, Stream]]:
        """The messages from and to a component, node or subsystem (`101.1.102`, `101.1`, `101`), by name."""
        found = [
            item for item in self.streams.items() if within(item[0].source, scope) or within(item[0].destination, scope)
        ]
        return sorted(found, key=lambda item: (item[0].message, item[0]))

    def controlled_by(self, id: JausID) -> list[JausID]:
        """The components that a client controls."""
        found = self.components.values()
        return sorted(each.id for each in found if each.control is not None and each.control.controller == id)

    def copy(self) -> Observed:
        """A copy that does not change when messages are added to this one."""
        new = Observed()
        new.__dict__.update(self.__dict__)
        new.names = dict(self.names)
        new.history = self.history.copy()
        new.components = {
            id: replace(
                each,
                requests=dict(each.requests),
                sequence=replace(each.sequence, recent=each.sequence.recent.copy()),
                history=each.history.copy(),
            )
            for id, each in self.components.items()
        }
        new.streams = {route: replace(each, history=each.history.copy()) for route, each in self.streams.items()}
        return new

    def _component(self, id: JausID) -> ObservedComponent | None:
        """The entry of a component, a new one while there is room."""
        found = self.components.get(id)
        if found is None and len(self.components) < MAX_COMPONENTS:
            found = self.components[id] = ObservedComponent(id)
        return found

    def _add_to_stream(self, seen: SeenMessage, packet: Packet) -> None:
        route = Route(str(packet.source), str(packet.destination), seen.name)
        if route not in self.streams and len(self.streams) >= MAX_STREAMS:
            route = Route(BEYOND, BEYOND, BEYOND)
        stream = self.streams.get(route)
        if stream is None:
            stream = self.streams[route] = Stream(seen)
        stream.latest = seen
        stream.count += 1
        stream.bytes += seen.size
        stream.history.add(seen.time)

    # --- what messages tell -------------------------------------------------------------------------------------------

    def _infer(self, sender: ObservedComponent, to: JausID, message: Any, now: float) -> None:
        match message:
            case management.ReportStatus():
                sender.state = State(_named(message.status), now, reported=True)
            case control.ReportControl():
                client = JausID(message.subsystem_id, message.node_id, message.component_id)
                nobody = not int(client)
                sender.control = Control(None if nobody else client, None if nobody else message.authority_code, now)
            case control.ReportAuthority():
                sender.authority = message.authority_code
            case control.ConfirmControl():
                self._confirm(sender, to, accepted=message.response_code == 0, now=now)
            case control.RejectControl():
                known = sender.control
                if message.response_code == 0 and (known is None or known.controller in (None, to)):
                    sender.control = Control(None, None, now)
            case discovery.ReportIdentification():
                self._name(sender, message)
            case discovery.RegisterServices():
                sender.services = _services(message.service_list)
            case discovery.ReportConfiguration():
                for node in message.node_list:
                    for each in node.component_list:
                        self._component(JausID(sender.id.subsystem, node.node_rec.node_id, each.component_id))
            case discovery.ReportServices():
                self._list(sender.id.subsystem, message.node_list)
            case ReportServiceList():
                for subsystem in message.subsystem_list:
                    self._list(subsystem.subsystem_rec.subsystem_id, subsystem.node_list)
            case _ if message.IS_COMMAND:
                for component in self._matching(to):
                    _command(component, sender.id, message, now)
            case _:
                pass

    def _matching(self, to: JausID) -> Iterator[ObservedComponent]:
        if not to.is_wildcard:
            found = self.components.get(to)
            return iter(() if found is None else (found,))
        return (component for id, component in self.components.items() if to.matches(id))

    def _confirm(self, sender: ObservedComponent, client: JausID, *, accepted: bool, now: float) -> None:
        authority = sender.requests.pop(client, None)
        if accepted:
            known = sender.control
            if authority is None and known is not None and known.controller == client:
                authority = known.authority
            sender.control = Control(client, authority, now)

    def _name(self, sender: ObservedComponent, message: discovery.ReportIdentification) -> None:
        name = message.identification.partition("\0")[0][:MAX_TEXT]  # some send the rest of a buffer, too
        kinds = discovery.ReportIdentification.QueryType
        if message.query_type == kinds.COMPONENT:
            sender.name, sender.type = name, _named(message.type)
            return
        key = sender.id.subsystem, sender.id.node if message.query_type == kinds.NODE else None
        if message.query_type in (kinds.SUBSYSTEM, kinds.NODE) and (key in self.names or len(self.names) < MAX_GROUPS):
            self.names[key] = name

    def _list(self, subsystem: int, nodes: list[Any]) -> None:
        """Learn services from a list of nodes, their components and services."""
        for node in nodes:
            for each in node.component_list:
                record = each.component_rec
                component = self._component(JausID(subsystem, node.node_rec.node_id, record.component_id))
                if component is not None:
                    component.services = _services(each.service_list)


def _command(component: ObservedComponent, client: JausID, message: Any, now: float) -> None:
    """Learn from a command to a component; whether the component obeys is not known until it reports."""
    known = component.control
    controls = known is not None and known.controller == client
    expected: str | None = None
    match message:
        case control.RequestControl():
            if client in component.requests or len(component.requests) < MAX_REQUESTS:
                component.requests[client] = message.authority_code
        case control.SetAuthority() if known is not None and controls:
            component.control = known._replace(authority=message.authority_code)
        case management.SetEmergency():
            if component.state is not None and component.state.name != "EMERGENCY":
                component.before_emergency = component.state.name
            expected = "EMERGENCY"
        case management.ClearEmergency() if component.state is not None and component.state.name == "EMERGENCY":
            if component.before_emergency is None:
                component.state = None
            expected = component.before_emergency
        case management.Standby() if controls:
            expected = "STANDBY"
        case management.Resume() if controls:
            expected = "READY"
        case management.Reset() if controls:
            expected = "INITIALIZE"
        case management.Shutdown() if controls:
            expected = "SHUTDOWN"
        case _:
            pass
    if expected is not None and (component.state is None or component.state.name != expected):
        component.state = State(expected, now, reported=False)


def _services(records: list[Any]) -> tuple[str, ...]:
    """Names with versions of the first records of a list; standard ones without `urn:jaus:jss:`."""
    found = {
        f"{each.uri.removeprefix('urn:jaus:jss:')[:MAX_TEXT]} {each.major_version_number}.{each.minor_version_number}"
        for each in records[:MAX_SERVICES]
    }
    return tuple(sorted(found))


def _named(value: int) -> str:
    return value.name if isinstance(value, IntEnum) else str(value)
