"""DigitalResourceDiscovery: the end points to which a component's streams are sent (AS6060)."""

from __future__ import annotations

import ipaddress
from collections.abc import Callable, Collection, Iterable, Mapping
from dataclasses import dataclass
from enum import Enum
from functools import partial
from typing import Final, Protocol, TypeAlias
from urllib.parse import urlsplit

from jauspy.errors import ConfigError
from jauspy.ids import JausID
from jauspy.messages.environment_sensing.v1_0.types import JAUS_ID
from jauspy.messages.environment_sensing.v2_0.digital_resource_discovery import (
    ConfirmDigitalResourceEndpoint,
    RegisterDigitalResourceEndpoint,
    RemoveDigitalResourceEndpoint,
    ReportDigitalResourceEndpoint,
)
from jauspy.platform.video_settings import RTP_SERVER_TYPE
from jauspy.protocol import judp
from jauspy.protocol.addressing import Location
from jauspy.services.deferred import Deferred
from jauspy.services.environment_sensing.visual_sensor import Address, Cameras
from jauspy.services.service import Service

Network: TypeAlias = ipaddress.IPv4Network | ipaddress.IPv6Network

_Record = ReportDigitalResourceEndpoint.DigitalResourceEndpointRec

MAX_END_POINTS: Final = 32
"""End points of a component; they are numbered from 1, and 0 stands for none."""

MAX_END_POINTS_PER_CLIENT: Final = 4
"""End points of one client, and of all clients of one other machine; one more replaces the oldest of them."""

FIRST_PORT: Final = 1024
"""Lower ports are those of system services."""

END_POINT_TIMEOUT: Final = 300.0
"""Seconds that an end point lasts after its client last registered it."""


class StreamState(Enum):
    """State of a stream, as `StreamState` of ControlDigitalVideoSensorStream."""

    PLAY = 0
    PAUSE = 1
    STOP = 2


@dataclass(slots=True)
class EndPoint:
    """The address to which one sensor's stream is sent for one client, which is at `location`."""

    client: JausID
    sensor: int
    url: str
    address: Address
    location: Location
    state: StreamState = StreamState.PLAY


class StreamSource(Protocol):
    """Sends what it senses to all watching addresses. No method blocks."""

    def watch(self, address: Address, *, playing: bool = True) -> None:
        """Send to an address, or pause it; raises `ConfigError` if there are too many."""
        ...

    def leave(self, address: Address) -> None:
        """Stop sending to an address."""
        ...


class MediaStreams:
    """The end points of a component's sensors, by sensor id; these send to the end points in state PLAY.

    Clients have streams sent to their own machine only, or into the networks `targets`.
    """

    def __init__(self, sources: Mapping[int, StreamSource], targets: Iterable[Network] = ()) -> None:
        self._sources = sources
        self.end_points: dict[int, EndPoint] = {}
        """End points by number, in the order in which they were registered."""
        self._targets = tuple(targets)
        self._number = 0

    def register(
        self, client: JausID, sensor: int, url: str, location: Location, operators: Collection[JausID] = ()
    ) -> int:
        """Add an end point in state PLAY and return its number, or that of the existing one.

        When there is no room, an operator's replaces one of a client that is none, and one of an operator's subsystem
        replaces one of another subsystem. Raises `ConfigError` for an address that is not the client's, an unknown
        sensor, another client's end point, or too many end points.
        """
        address = parse_rtp_url(url)
        check_target(address, location, client, self._targets)
        if sensor not in self._sources:
            raise ConfigError(f"there is no sensor {sensor}; there are: {', '.join(map(str, self._sources))}")
        for number, known in self.end_points.items():
            if known.sensor == sensor and known.address == address:
                if known.client != client:
                    raise ConfigError(f"{url} was entered by {known.client}")
                return number
        self._keep_to_share(client, location)
        self._watch(sensor, address, replaceable=self._ranking_below(client, operators))
        number = self._number = self._free_number()
        self.end_points[number] = EndPoint(client, sensor, url, address, location)
        return number

    def _keep_to_share(self, client: JausID, location: Location) -> None:
        """Remove the client's oldest end point if it has its share, or its machine has."""
        is_shared = not location.is_here and bool(location.hosts)
        of_client = [number for number, item in self.end_points.items() if item.client == client]
        same = [n for n, item in self.end_points.items() if is_shared and item.location == location]
        for numbers in (of_client, same):
            if len(numbers) >= MAX_END_POINTS_PER_CLIENT and numbers[0] in self.end_points:
                self.remove(numbers[0])

    def _watch(self, sensor: int, address: Address, replaceable: list[int]) -> None:
        """Make the sensor send there, if necessary in place of another end point."""
        source = self._sources[sensor]
        try:
            self._check_room()
            source.watch(address)
        except ConfigError:
            replaced = next((key for key in replaceable if self.end_points[key].sensor == sensor), None)
            if replaced is None:
                raise
            self.remove(replaced)
            source.watch(address)

    def _free_number(self) -> int:
        """The number that was free for the longest time: clients may still use that of one that was replaced."""
        following = (1 + (self._number + index) % MAX_END_POINTS for index in range(MAX_END_POINTS))
        return next(number for number in following if number not in self.end_points)

    def _check_room(self) -> None:
        if len(self.end_points) >= MAX_END_POINTS:
            raise ConfigError(f"there are {MAX_END_POINTS} end points already; one must be removed first")

    def _ranking_below(self, client: JausID, operators: Collection[JausID]) -> list[int]:
        """End points of clients that rank below this one, the least and newest first."""
        subsystems = {operator.subsystem for operator in operators}

        def rank(each: JausID) -> int:
            return 2 if each in operators else int(each.subsystem in subsystems)

        newest_first = [(rank(item.client), number) for number, item in reversed(self.end_points.items())]
        return [
            number
            for rank_of_owner, number in sorted(newest_first, key=lambda ranked: ranked[0])
            if rank_of_owner < rank(client)
        ]

    def remove(self, number: int) -> None:
        """Stop sending to an end point; unknown numbers are ignored."""
        point = self.end_points.pop(number, None)
        if point is not None:
            self._sources[point.sensor].leave(point.address)

    def control(self, client: JausID, sensor: int, state: StreamState) -> int:
        """Play, pause or stop the client's end points of a sensor; returns their number."""
        of_sensor = [point for point in self.end_points.values() if (point.client, point.sensor) == (client, sensor)]
        for point in of_sensor:
            source = self._sources[sensor]
            if state is StreamState.STOP:
                source.leave(point.address)
            else:
                source.watch(point.address, playing=state is StreamState.PLAY)
            point.state = state
        return len(of_sensor)

    def state(self, sensor: int) -> StreamState:
        """Return PLAY if any end point of the sensor plays, else PAUSE if any is paused, else STOP."""
        states = {point.state for point in self.end_points.values() if point.sensor == sensor}
        return next((state for state in StreamState if state in states), StreamState.STOP)

    def remove_client(self, client: JausID) -> None:
        """Remove all end points of a client."""
        for number in [number for number, item in self.end_points.items() if item.client == client]:
            self.remove(number)


class VideoStreams(MediaStreams):
    """The end points of a component's cameras."""

    def __init__(self, cameras: Cameras, targets: Iterable[Network] = ()) -> None:
        super().__init__({sensor: camera.source for sensor, camera in cameras.items()}, targets)
        self.cameras = cameras


def check_target(target: Address, location: Location, client: JausID, networks: Iterable[Network]) -> None:
    """Raise `ConfigError` unless a client at `location` may have a stream sent there, or played from there."""
    host, port = target
    if location.ports & {port, port + 1}:  # control packets (RTCP) are sent to the next one
        ports = ", ".join(map(str, sorted(location.ports)))
        raise ConfigError(f"{host}:{port}: streams are not sent to a port of JAUS: {ports}")
    address = ipaddress.ip_address(host)
    if location.has(host) or any(address in network and address != network.broadcast_address for network in networks):
        return
    known = f"which is at {', '.join(sorted(location.hosts))}" if location.hosts else "whose machine is not known"
    raise ConfigError(f"{host} is not an address of {client}, {known}; video_targets may allow networks")


def parse_rtp_url(url: str) -> Address:
    """Return the numeric address and port of `rtp://ADDRESS:PORT`; raises `ConfigError` for anything else."""
    try:
        parts = urlsplit(url)
        host, port = parts.hostname or "", parts.port or 0
        address = ipaddress.ip_address(host)
    except ValueError as error:
        raise ConfigError(f"{url!r} is not rtp://ADDRESS:PORT with an address in numbers: {error}") from error
    if parts.scheme != "rtp" or not 1 <= port <= 65534:
        raise ConfigError(f"{url!r} is not rtp://ADDRESS:PORT with a port of 1..65534")
    if port < FIRST_PORT or judp.PORT in (port, port + 1):
        raise ConfigError(f"{url!r}: streams are sent to ports from {FIRST_PORT}, and not to that of JAUS, {judp.PORT}")
    if isinstance(address, ipaddress.IPv6Address) and address.ipv4_mapped:
        address = address.ipv4_mapped
    if address.is_multicast or address.is_unspecified or str(address) == "255.255.255.255":
        raise ConfigError(
            f"{url!r}: streams are sent to one machine, so its address must not be a group, broadcast or 0"
        )
    return str(address), port


class DigitalResourceDiscovery(Service, urn="urn:jaus:jss:environmentSensing:DigitalResourceDiscovery"):
    """End points `rtp://ADDRESS:PORT`, registered by clients, to which the streams of cameras or microphones are sent.

    ResourceID is the sensor's id, 1 by default. The stream starts immediately and ends when the client removes
    the end point, is lost, or has not registered it again for five minutes. A request with another server type or a bad
    URL is confirmed with the number 0.
    """

    def __init__(self, streams: MediaStreams) -> None:
        self._streams = streams
        self._confirmed_number = 0
        self._reply: Deferred | None = None
        self.operators: Callable[[], Iterable[JausID | None]] = lambda: (self.host.controller,)
        """Returns the clients that come first when there is no room: those in control."""

    def send_report_digital_resource_endpoint(self, source: JausID) -> ReportDigitalResourceEndpoint:
        """Return the client's own end points only; the addresses of others are private."""
        this_component = self.host.id
        component = JAUS_ID(this_component.component, this_component.node, this_component.subsystem)
        points = [point for point in self._streams.end_points.values() if point.client == source]
        return ReportDigitalResourceEndpoint(
            [_Record(RTP_SERVER_TYPE, point.url, component, point.sensor) for point in points]
        )

    def add_digital_resource_endpoint(self, msg: RegisterDigitalResourceEndpoint, source: JausID) -> None:
        """Add an end point, or restart the timeout of an existing one, when the client's machine is known."""
        self._confirmed_number, self._reply = 0, None
        server = msg.digital_resource_endpoint_rec.server_type
        if server != RTP_SERVER_TYPE:
            self.host.count(
                "endpoint_refused", f"{source}: server type {server} is not {RTP_SERVER_TYPE}, RTP over UDP"
            )
            return
        self._reply = reply = self.host.defer(partial(_confirmation, msg, 0))
        if reply.report is None:
            self.host.locate(source, partial(self._register, msg, source, reply))

    def _register(
        self, msg: RegisterDigitalResourceEndpoint, source: JausID, reply: Deferred, location: Location
    ) -> None:
        if reply.report is not None:  # too late: 0 was confirmed
            return
        record, number = msg.digital_resource_endpoint_rec, 0
        operators = {operator for operator in self.operators() if operator is not None}
        try:
            number = self._streams.register(source, record.resource_id or 1, record.server_url, location, operators)
        except ConfigError as error:
            self.host.count("endpoint_refused", f"{source}: {error}")
        else:
            until = self.host.now + END_POINT_TIMEOUT
            self.host.set_timer(("end point", number), until, partial(self._streams.remove, number))
        reply.set_result(_confirmation(msg, number))

    def remove_digital_resource_endpoint(self, msg: RemoveDigitalResourceEndpoint, source: JausID) -> None:
        """Remove an end point that the same client registered."""
        point = self._streams.end_points.get(msg.id)
        if point is None or point.client != source:
            self._confirmed_number = 0
            self.host.count("endpoint_unknown", f"{source} has not entered number {msg.id}")
            return
        self._confirmed_number = msg.id
        self._streams.remove(msg.id)
        self.host.cancel_timer(("end point", msg.id))

    def send_confirm_digital_resource_endpoint(
        self, msg: RegisterDigitalResourceEndpoint | RemoveDigitalResourceEndpoint
    ) -> ConfirmDigitalResourceEndpoint | Deferred:
        """Return the number of the end point that was registered or removed; 0 if the request failed."""
        reply, self._reply = self._reply, None
        return reply or _confirmation(msg, self._confirmed_number)


def _confirmation(
    msg: RegisterDigitalResourceEndpoint | RemoveDigitalResourceEndpoint, number: int
) -> ConfirmDigitalResourceEndpoint:
    head = msg.request_id_rec if isinstance(msg, RegisterDigitalResourceEndpoint) else msg
    return ConfirmDigitalResourceEndpoint(number, head.request_id)
