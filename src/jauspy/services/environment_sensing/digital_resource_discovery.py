"""DigitalResourceDiscovery: the end points to which a component's video streams are sent (AS6060)."""

from __future__ import annotations

import ipaddress
from dataclasses import dataclass
from enum import Enum
from typing import Final
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
from jauspy.services.environment_sensing.visual_sensor import Address, Cameras
from jauspy.services.service import Service

_Record = ReportDigitalResourceEndpoint.DigitalResourceEndpointRec

RTP: Final = 201
"""Server type, from the range for private use: RTP over UDP, sent to the address of the URL."""

MAX_END_POINTS: Final = 32
"""End points of a component; they are numbered from 1, and 0 stands for none."""

END_POINT_TIMEOUT: Final = 300.0
"""Seconds that an end point lasts after its client last registered it."""


class StreamState(Enum):
    """State of a stream, as `StreamState` of ControlDigitalVideoSensorStream."""

    PLAY = 0
    PAUSE = 1
    STOP = 2


@dataclass(slots=True)
class EndPoint:
    """The address to which one camera's stream is sent for one client."""

    client: JausID
    sensor: int
    url: str
    address: Address
    state: StreamState = StreamState.PLAY


class VideoStreams:
    """The end points of a component's cameras; the cameras send to those in state PLAY."""

    def __init__(self, cameras: Cameras) -> None:
        self.cameras = cameras
        self.end_points: dict[int, EndPoint] = {}

    def register(self, client: JausID, sensor: int, url: str) -> int:
        """Add an end point in state PLAY and return its number, or that of the existing one.

        Raises `ConfigError` for a bad URL, an unknown sensor, another client's end point, or too many end points.
        """
        address = parse_rtp_url(url)
        if sensor not in self.cameras:
            raise ConfigError(f"there is no sensor {sensor}; there are: {', '.join(map(str, self.cameras))}")
        for number, known in self.end_points.items():
            if known.sensor == sensor and known.address == address:
                if known.client != client:
                    raise ConfigError(f"{url} was entered by {known.client}")
                return number
        number = next((each for each in range(1, MAX_END_POINTS + 1) if each not in self.end_points), 0)
        if not number:
            raise ConfigError(f"there are {MAX_END_POINTS} end points already; one must be removed first")
        self.cameras[sensor].source.watch(address)
        self.end_points[number] = EndPoint(client, sensor, url, address)
        return number

    def remove(self, number: int) -> None:
        """Stop sending to an end point; unknown numbers are ignored."""
        point = self.end_points.pop(number, None)
        if point is not None:
            self.cameras[point.sensor].source.leave(point.address)

    def control(self, client: JausID, sensor: int, state: StreamState) -> int:
        """Play, pause or stop the client's end points of a sensor; returns their number."""
        own = [each for each in self.end_points.values() if (each.client, each.sensor) == (client, sensor)]
        for point in own:
            source = self.cameras[sensor].source
            if state is StreamState.STOP:
                source.leave(point.address)
            else:
                source.watch(point.address, playing=state is StreamState.PLAY)
            point.state = state
        return len(own)

    def state(self, sensor: int) -> StreamState:
        """Return PLAY if any end point of the sensor plays, else PAUSE if any is paused, else STOP."""
        states = {each.state for each in self.end_points.values() if each.sensor == sensor}
        return next((state for state in StreamState if state in states), StreamState.STOP)

    def remove_client(self, client: JausID) -> None:
        """Remove all end points of a client."""
        for number in [number for number, each in self.end_points.items() if each.client == client]:
            self.remove(number)


def parse_rtp_url(url: str) -> Address:
    """Return the numeric address and port of `rtp://ADDRESS:PORT`; raises `ConfigError` for anything else."""
    try:
        parts = urlsplit(url)
        host, port = parts.hostname or "", parts.port or 0
        ipaddress.ip_address(host)
    except ValueError as error:
        raise ConfigError(f"{url!r} is not rtp://ADDRESS:PORT with an address in numbers: {error}") from error
    if parts.scheme != "rtp" or not 1 <= port <= 65534:
        raise ConfigError(f"{url!r} is not rtp://ADDRESS:PORT with a port of 1..65534")
    return host, port


class DigitalResourceDiscovery(Service, urn="urn:jaus:jss:environmentSensing:DigitalResourceDiscovery"):
    """End points `rtp://ADDRESS:PORT`, registered by clients, to which the cameras' streams are sent.

    ResourceID is the camera's sensor id, 1 by default. The stream starts at once and ends when the client removes the
    end point, is lost, or has not registered it again for five minutes. A request with another server type or a bad URL
    is confirmed with the number 0.
    """

    def __init__(self, streams: VideoStreams) -> None:
        self._streams = streams
        self._confirmed_number = 0

    def send_report_digital_resource_endpoint(self) -> ReportDigitalResourceEndpoint:
        """Return all end points."""
        own = self.host.id
        component = JAUS_ID(own.component, own.node, own.subsystem)
        return ReportDigitalResourceEndpoint(
            [_Record(RTP, point.url, component, point.sensor) for point in self._streams.end_points.values()]
        )

    def add_digital_resource_endpoint(self, msg: RegisterDigitalResourceEndpoint, source: JausID) -> None:
        """Add an end point, or restart the timeout of an existing one."""
        record = msg.digital_resource_endpoint_rec
        self._confirmed_number = 0
        if record.server_type != RTP:
            self.host.count(
                "endpoint_refused", f"{source}: server type {record.server_type} is not {RTP}, RTP over UDP"
            )
            return
        try:
            self._confirmed_number = self._streams.register(source, record.resource_id or 1, record.server_url)
        except ConfigError as error:
            self.host.count("endpoint_refused", f"{source}: {error}")
            return
        number = self._confirmed_number
        self.host.set_timer(
            ("end point", number), self.host.now + END_POINT_TIMEOUT, lambda: self._streams.remove(number)
        )

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
    ) -> ConfirmDigitalResourceEndpoint:
        """Return the number of the end point that was registered or removed; 0 if the request failed."""
        head = msg.request_id_rec if isinstance(msg, RegisterDigitalResourceEndpoint) else msg
        return ConfirmDigitalResourceEndpoint(self._confirmed_number, head.request_id)
