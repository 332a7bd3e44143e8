"""All that a recording or a live view has: datagrams, messages as JSON, and Foxglove's schemas."""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping, Sequence
from typing import Final

import foxglove
import orjson

from jauspy.capture import writer
from jauspy.capture.dissect import Part, read_message
from jauspy.capture.reader import Datagram
from jauspy.codec.json_schema import json_schema
from jauspy.codec.message import Message
from jauspy.codec.registry import Registry
from jauspy.codec.rounding import rounded_dict
from jauspy.messages.core.v1_0 import access_control, management
from jauspy.messages.core.v1_0.events import Event as Event1
from jauspy.messages.core.v1_1.events import Event as Event2
from jauspy.protocol.header import Packet
from jauspy.recording.described_robot import DescribedRobot
from jauspy.recording.foxglove_messages import Translator
from jauspy.recording.run_files import DATAGRAMS, ENCODING, NO_ROBOTS
from jauspy.recording.samples import ChannelForm, Sample

LARGE: Final = 16_384
"""Bytes of JSON from which on a slow client does without it."""


class Feed:
    """Makes samples of datagrams, and of what `Dissector` found in them."""

    def __init__(self, registry: Registry, robots: Mapping[int, DescribedRobot] = NO_ROBOTS) -> None:
        self._registry = registry
        self._translator = Translator(robots)
        self._forms: dict[type[Message], ChannelForm] = {}
        self._datagram_form = ChannelForm(
            ENCODING,
            foxglove.Schema(
                name="IPv4", encoding="", data=b"IPv4 packet with UDP (LINKTYPE_RAW); its payload is SAE AS5669A"
            ),
        )

    def samples(self, datagram: Datagram, parts: Sequence[Part]) -> Iterator[Sample]:
        """The samples of a datagram and the messages in it."""
        time = round(datagram.time * 1e9)
        packet = writer.ip_packet(datagram.source, datagram.destination, datagram.payload)
        yield Sample(DATAGRAMS, time, packet, self._datagram_form, is_bulk=True)
        for part in parts:
            found = part.content.message
            if found is not None:
                yield self._json(part.packet, found, time)
                yield from self._translator.translate(part.packet, self._reported(found), time)

    def _reported(self, message: Message) -> Message:
        """The report in an event, or the message itself."""
        if not isinstance(message, Event1 | Event2):
            return message
        inside = message.report_message
        if not isinstance(inside, Message):
            inside = read_message(bytes(inside), self._registry).message or message
        return inside

    def _json(self, packet: Packet, message: Message, time: int) -> Sample:
        kind = type(message)
        form = self._forms.get(kind)
        if form is None:
            schema = json_schema(kind)
            form = self._forms[kind] = ChannelForm(
                "json",
                foxglove.Schema(name=schema["title"], encoding="jsonschema", data=json.dumps(schema).encode()),
                {"service": kind.SERVICE, "version": kind.VERSION, "code": f"{kind.CODE:04X}"},
            )
        data = orjson.dumps(rounded_dict(message))
        is_state = isinstance(message, management.ReportStatus | access_control.ReportControl)
        topic, state = f"/{packet.source}/{kind.NAME}", "" if is_state else None
        return Sample(topic, time, data, form, state, is_bulk=len(data) >= LARGE)
