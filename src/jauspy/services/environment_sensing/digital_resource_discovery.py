"""DigitalResourceDiscovery: where the component's streams are sent (AS6060)."""

from __future__ import annotations

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
from jauspy.services.environment_sensing.viewers import END_POINT_TIMEOUT, VideoStreams
from jauspy.services.service import Service

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
