"""DigitalResourceDiscovery: where the component's streams are sent (AS6060)."""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum
from typing import Final

from jauspy.errors import ConfigError
from jauspy.ids import JausID
from jauspy.messages.environment_sensing.v1_0.types import JAUS_ID
from jauspy.messages.environment_sensing.v2_0.digital_resource_discovery import (
    ConfirmDigitalResourceEndpoint,
    RegisterDigitalResourceEndpoint,
    RemoveDigitalResourceEndpoint,
    ReportDigitalResourceEndpoint,
)
from jauspy.services.environment_sensing.visual_sensor import Address, Cameras, parse_rtp_url
from jauspy.services.service import Service

MAX_END_POINTS: Final = 32
"""End points of a component; they are numbered from 1, and 0 stands for none."""

END_POINT_TIMEOUT: Final = 300.0
"""Seconds that an end point lasts after its client last entered it."""


class StreamState(Enum):
    """What a stream does."""

    PLAY = 0
    PAUSE = 1
    STOP = 2


@dataclass(slots=True)
class EndPoint:
    """Where one client has one camera's stream sent."""

    client: JausID
    sensor: int
    url: str
    address: Address
    flow: StreamState = StreamState.PLAY


class VideoStreams:
    """Enters and removes end points, and has the cameras send to those that play."""

    def __init__(self, cameras: Cameras) -> None:
        self.cameras = cameras
        self.end_points: dict[int, EndPoint] = {}

    def enter(self, client: JausID, sensor: int, url: str) -> int:
        """The number of a new end point, which plays, or of the same one; `ConfigError` when it cannot be."""
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
            raise ConfigError(f"there are {MOST} end points already; one must be removed first")
        self.cameras[sensor].source.watch(address)
        self.end_points[number] = EndPoint(client, sensor, url, address)
        return number

    def remove(self, number: int) -> None:
        """Send there no longer; unknown ones are no error."""
        point = self.end_points.pop(number, None)
        if point is not None:
            self.cameras[point.sensor].source.leave(point.address)

    def control(self, client: JausID, sensor: int, flow: StreamState) -> int:
        """Play, pause or stop the client's own end points of a sensor; how many that are."""
        own = [each for each in self.end_points.values() if (each.client, each.sensor) == (client, sensor)]
        for point in own:
            source = self.cameras[sensor].source
            if flow is StreamState.STOP:
                source.leave(point.address)
            else:
                source.watch(point.address, playing=flow is StreamState.PLAY)
            point.flow = flow
        return len(own)

    def flow(self, sensor: int) -> StreamState:
        """What the stream does: it plays if it does for anybody, and pauses if it only waits to go on."""
        flows = {each.flow for each in self.end_points.values() if each.sensor == sensor}
        return next((flow for flow in StreamState if flow in flows), StreamState.STOP)

    def forget(self, client: JausID) -> None:
        """The client is gone."""
        for number in [number for number, each in self.end_points.items() if each.client == client]:
            self.remove(number)


RTP: Final = 201
"""Of the server types that are free for everybody's use: RTP over UDP, sent to the address that the URL names."""

_Record = ReportDigitalResourceEndpoint.DigitalResourceEndpointRec


class DigitalResourceDiscovery(Service, urn="urn:jaus:jss:environmentSensing:DigitalResourceDiscovery"):
    """End points `rtp://ADDRESS:PORT`, entered by clients, to which the cameras' streams are sent.

    The ResourceID is the id of the camera's sensor, 1 when left out. The stream plays at once, until the client removes
    the end point, is lost, or has not entered it again for five minutes. Whoever enters an end point of another server
    type, or one that cannot be, is told the number 0.
    """

    def __init__(self, viewers: VideoStreams) -> None:
        self._viewers = viewers
        self._entered = 0

    def send_report_digital_resource_endpoint(self) -> ReportDigitalResourceEndpoint:
        """Everything that is entered."""
        own = self.host.id
        component = JAUS_ID(own.component, own.node, own.subsystem)
        return ReportDigitalResourceEndpoint(
            [_Record(RTP, point.url, component, point.sensor) for point in self._viewers.end_points.values()]
        )

    def add_digital_resource_endpoint(self, msg: RegisterDigitalResourceEndpoint, source: JausID) -> None:
        """Enter an end point, or keep one."""
        record = msg.digital_resource_endpoint_rec
        self._entered = 0
        if record.server_type != RTP:
            self.host.count(
                "endpoint_refused", f"{source}: server type {record.server_type} is not {RTP}, RTP over UDP"
            )
            return
        try:
            self._entered = self._viewers.enter(source, record.resource_id or 1, record.server_url)
        except ConfigError as error:
            self.host.count("endpoint_refused", f"{source}: {error}")
            return
        number = self._entered
        self.host.set_timer(
            ("end point", number), self.host.now + END_POINT_TIMEOUT, lambda: self._viewers.remove(number)
        )

    def remove_digital_resource_endpoint(self, msg: RemoveDigitalResourceEndpoint, source: JausID) -> None:
        """Remove an end point of the client's own."""
        point = self._viewers.end_points.get(msg.id)
        if point is None or point.client != source:
            self._entered = 0
            self.host.count("endpoint_unknown", f"{source} has not entered number {msg.id}")
            return
        self._entered = msg.id
        self._viewers.remove(msg.id)
        self.host.cancel_timer(("end point", msg.id))

    def send_confirm_digital_resource_endpoint(
        self, msg: RegisterDigitalResourceEndpoint | RemoveDigitalResourceEndpoint
    ) -> ConfirmDigitalResourceEndpoint:
        """The number that was entered or removed; 0: nothing was."""
        head = msg.request_id_rec if isinstance(msg, RegisterDigitalResourceEndpoint) else msg
        return ConfirmDigitalResourceEndpoint(self._entered, head.request_id)
