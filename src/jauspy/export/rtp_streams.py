"""Pictures of H.264 in the RTP packets of a network, by stream; JAUS messages beside them tell whose stream it is."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import Any, Final, NamedTuple
from urllib.parse import urlsplit

from jauspy.capture.dissect import dissect
from jauspy.capture.reader import Datagram
from jauspy.codec.message import Struct
from jauspy.codec.registry import Registry
from jauspy.errors import ProtocolError
from jauspy.ids import JausID
from jauspy.video.h264_payload import SPS, Depacketiser, Picture, nal_type
from jauspy.video.rtp import RtpPacket

MAX_STREAMS: Final = 64
"""Streams of a network; packets of further ones are left out."""
MAX_ENDPOINTS: Final = 256
"""Endpoints that messages have named; further ones are left out."""
DYNAMIC_TYPES: Final = range(96, 128)
"""Payload types of RTP that a session defines, as that of H.264."""
UNSAFE: Final = re.compile(r"[^A-Za-z0-9.]+")
"""What a name in a path has no characters of."""
_RTP_VERSION: Final = 0x80
_URL: Final = b"rtp://"
_RECORDS: Final = ("digital_resource_endpoint_rec", "digital_resource_endpoint_list")


class RecordedPicture(NamedTuple):
    """A picture of a camera."""

    camera: str
    """The id of its component, as 101.1.106 or 101.1.106/2 of its second sensor; else a name that is safe in a path:
    from the address of its packets, or from the topic of its channel."""
    time: float
    """When it was received, in seconds since 1970."""
    picture: Picture


class _Stream:
    """One stream; it begins with the first picture that can be decoded alone."""

    def __init__(self) -> None:
        self._depacketiser = Depacketiser()
        self._begun = False

    def pictures(self, packet: RtpPacket) -> Iterator[Picture]:
        """The pictures that a packet completes."""
        for picture in self._depacketiser.feed(packet):
            self._begun = self._begun or (picture.is_idr and any(nal_type(unit) == SPS for unit in picture.nals))
            if self._begun:
                yield picture


class RtpStreams:
    """Finds the streams of a network.

    With a registry, they have the ids of cameras from the message on that names an endpoint.
    """

    def __init__(self, registry: Registry | None = None) -> None:
        self._registry = registry
        self._streams: dict[tuple[str, int], _Stream] = {}
        self._endpoints: dict[tuple[str, int], str] = {}
        """Names of cameras, by the address that their packets are sent to."""

    def feed(self, datagram: Datagram) -> Iterator[RecordedPicture]:
        """The pictures that end with a datagram."""
        data = datagram.payload
        if len(data) < 13 or data[0] & 0xC0 != _RTP_VERSION or data[1] & 0x7F not in DYNAMIC_TYPES:
            if self._registry is not None and _URL in data:
                self._learn(data, self._registry)
            return
        key = datagram.source[0], datagram.destination[1]
        stream = self._streams.get(key)
        if stream is None and len(self._streams) >= MAX_STREAMS:
            return
        try:
            packet = RtpPacket.decode(data)
        except ProtocolError:
            return
        if stream is None:
            stream = self._streams[key] = _Stream()
        name = self._endpoints.get(datagram.destination) or UNSAFE.sub("-", f"{key[0]}-{key[1]}")
        for picture in stream.pictures(packet):
            yield RecordedPicture(name, datagram.time, picture)

    def _learn(self, data: bytes, registry: Registry) -> None:
        """Note which camera sends to the endpoints that a message registers, or reports."""
        for part in dissect(data, registry).parts:
            message: Any = part.content.message
            if message is None:
                continue
            camera = part.packet.destination if message.IS_COMMAND else part.packet.source
            for name in _RECORDS:
                found = getattr(message, name, ())
                for record in [found] if isinstance(found, Struct) else found:
                    self._note(record, camera)

    def _note(self, record: Any, camera: JausID) -> None:
        url, sensor = str(record.server_url), record.resource_id
        try:
            parts = urlsplit(url)
            host, port = parts.hostname, parts.port
        except ValueError:
            return
        if parts.scheme == "rtp" and host and port and len(self._endpoints) < MAX_ENDPOINTS:
            self._endpoints[host, port] = str(camera) if sensor in (None, 0, 1) else f"{camera}/{sensor}"
