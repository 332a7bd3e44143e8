"""RTP packets, RTCP reports (RFC 3550, RFC 4585), session descriptions, and how players receive them."""

from __future__ import annotations

import struct
from base64 import b64encode
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Final, NamedTuple

from jauspy.errors import ProtocolError

CLOCK_RATE: Final = 90_000
"""Ticks per second of video time stamps (RFC 6184, 8.1)."""

PAYLOAD_TYPE: Final = 96
"""The first dynamic payload type; the session description defines its meaning."""

PARITY_TYPE: Final = 97
"""Payload type of parity packets, which are sent to receivers that ask for them alone (`jauspy.video.parity`)."""

HEADER: Final = struct.Struct("!BBHII")

_VERSION: Final = 0x80
_MARKER: Final = 0x80


@dataclass(frozen=True, slots=True)
class RtpPacket:
    """One packet; `marker` on the last one of a picture, `timestamp` in ticks of `CLOCK_RATE`, modulo 2**32."""

    sequence: int
    timestamp: int
    ssrc: int
    payload: bytes
    marker: bool = False
    payload_type: int = PAYLOAD_TYPE

    def encode(self) -> bytes:
        """The packet as bytes."""
        second = self.payload_type | (_MARKER if self.marker else 0)
        return HEADER.pack(_VERSION, second, self.sequence, self.timestamp, self.ssrc) + self.payload

    @classmethod
    def decode(cls, data: bytes) -> RtpPacket:
        """Decode a packet, without extension and padding; raises `ProtocolError` for other data."""
        if len(data) < HEADER.size or data[0] & 0xC0 != _VERSION:
            raise ProtocolError("not_rtp")
        first, second, sequence, timestamp, ssrc = HEADER.unpack_from(data)
        begin, end = _payload(data, first)
        return cls(
            sequence=sequence,
            timestamp=timestamp,
            ssrc=ssrc,
            payload=data[begin:end],
            marker=bool(second & _MARKER),
            payload_type=second & 0x7F,
        )


def _payload(data: bytes, first: int) -> tuple[int, int]:
    begin = HEADER.size + 4 * (first & 0x0F)
    if first & 0x10:
        if len(data) < begin + 4:
            raise ProtocolError("not_rtp", "its extension is cut off")
        begin += 4 + 4 * int.from_bytes(data[begin + 2 : begin + 4], "big")
    end = len(data) - (data[-1] if first & 0x20 else 0)
    if end <= begin:
        raise ProtocolError("not_rtp", "it has no payload")
    return begin, end


REPORT_INTERVAL: Final = 1.0
"""Seconds between two sender reports to a receiver, which knows from them where to send its requests."""

_SENDER: Final = struct.Struct("!BBHIIIIII")
_NTP_EPOCH: Final = 2_208_988_800
"""Seconds from 1900, where NTP's time begins, to 1970."""

_SENDER_REPORT: Final = 200
_SOURCE_DESCRIPTION: Final = 202
_FEEDBACK: Final = 206
_PICTURE_LOSS, _FULL_INTRA = 1, 4
_RECEIVER_REPORT: Final = 201
_APPLICATION: Final = 204
_PARITY: Final = b"PRTY"
_CNAME, _NOTE = 1, 7
MAX_TEXT: Final = 255
"""Bytes of a text in a source description."""


def sender_report(
    ssrc: int, name: str, note: str = "", *, utc: float, timestamp: int, packets: int, octets: int
) -> bytes:
    """Sender report, name and note of a source; `timestamp` is the stream's clock at `utc` (seconds since 1970)."""
    seconds, fraction = divmod(utc + _NTP_EPOCH, 1.0)
    counts = (packets & 0xFFFFFFFF, octets & 0xFFFFFFFF)
    ntp = (int(seconds) & 0xFFFFFFFF, int(fraction * 2**32))
    return _SENDER.pack(0x80, _SENDER_REPORT, 6, ssrc, *ntp, timestamp & 0xFFFFFFFF, *counts) + _source_description(
        ssrc, name, note
    )


def source_note(ssrc: int, name: str, note: str) -> bytes:
    """Name and note of a source that has not sent anything yet, after an empty report as RFC 3550 (6.1) has it."""
    return struct.pack("!BBHI", 0x80, _RECEIVER_REPORT, 1, ssrc) + _source_description(ssrc, name, note)


def _source_description(ssrc: int, name: str, note: str) -> bytes:
    texts = ((_CNAME, name), (_NOTE, note)) if note else ((_CNAME, name),)
    items = b"".join(bytes([kind, len(text)]) + text for kind, text in ((k, t.encode()[:MAX_TEXT]) for k, t in texts))
    chunk = ssrc.to_bytes(4, "big") + items + bytes(4 - len(items) % 4)
    return struct.pack("!BBH", 0x81, _SOURCE_DESCRIPTION, len(chunk) // 4) + chunk


class SenderClock(NamedTuple):
    """The clock of a stream: its time stamp at `utc` (seconds since 1970)."""

    ssrc: int
    utc: float
    timestamp: int


def sender_clock(data: bytes) -> SenderClock | None:
    """The clock in a sender report; None for other data."""
    if len(data) < _SENDER.size or data[0] & 0xC0 != 0x80 or data[1] != _SENDER_REPORT:
        return None
    _, _, _, ssrc, seconds, fraction, timestamp, _, _ = _SENDER.unpack_from(data)
    return SenderClock(ssrc, seconds - _NTP_EPOCH + fraction / 2**32, timestamp)


class SourceNote(NamedTuple):
    """Note of a source about itself now (NOTE, RFC 3550 6.5.7); empty when it says nothing."""

    ssrc: int
    text: str


def noted(data: bytes) -> SourceNote | None:
    """The note in RTCP packets, of the first source that they describe; None for data without a description."""
    while len(data) >= 4 and data[0] & 0xC0 == 0x80:
        length = 4 * (1 + int.from_bytes(data[2:4], "big"))
        if data[1] == _SOURCE_DESCRIPTION and 8 <= length <= len(data):
            return SourceNote(int.from_bytes(data[4:8], "big"), _text_of(data[8:length], _NOTE))
        data = data[length:]
    return None


def _text_of(items: bytes, wanted: int) -> str:
    """The text of an item of that kind; empty without one."""
    while len(items) >= 2 and items[0]:
        kind, end = items[0], 2 + items[1]
        if kind == wanted:
            return items[2:end].decode(errors="replace")
        items = items[end:]
    return ""


def picture_loss_indication(receiver: int, source: int) -> bytes:
    """The request of a receiver for a whole picture (Picture Loss Indication, PLI)."""
    return struct.pack("!BBHII", 0x80 | _PICTURE_LOSS, _FEEDBACK, 2, receiver, source)


def requests_picture(data: bytes) -> bool:
    """True when RTCP packets of a receiver request a whole picture (PLI or FIR); false for other data."""
    while len(data) >= 4 and data[0] & 0xC0 == 0x80:
        length = 4 * (1 + int.from_bytes(data[2:4], "big"))
        if data[1] == _FEEDBACK and data[0] & 0x1F in {_PICTURE_LOSS, _FULL_INTRA} and length <= len(data):
            return True
        data = data[length:]
    return False


class ParityRequest(NamedTuple):
    """A receiver understands parity packets, and wants so many for each packet of this source."""

    source: int
    share: float


MAX_SHARE: Final = 1.0
"""Parity packets for each packet of a stream, at most."""
_REQUEST: Final = struct.Struct("!BBHI4sII")


def parity_request(receiver: int, source: int, share: float) -> bytes:
    """The request of a receiver for parity packets: an application packet (APP, RFC 3550 6.7) after an empty report.

    Senders that do not know it ignore it, and those that do send parity to nobody else.
    """
    empty = struct.pack("!BBHI", 0x80, _RECEIVER_REPORT, 1, receiver)
    percent = round(100.0 * min(MAX_SHARE, max(0.0, share)))
    return empty + _REQUEST.pack(0x80, _APPLICATION, 4, receiver, _PARITY, source, percent)


def requested_parity(data: bytes) -> ParityRequest | None:
    """The request for parity in RTCP packets of a receiver; None for other data."""
    while len(data) >= 4 and data[0] & 0xC0 == 0x80:
        length = 4 * (1 + int.from_bytes(data[2:4], "big"))
        if data[1] == _APPLICATION and _REQUEST.size <= length <= len(data):
            _, _, _, _, name, source, percent = _REQUEST.unpack_from(data)
            if name == _PARITY:
                return ParityRequest(source, min(MAX_SHARE, percent / 100.0))
        data = data[length:]
    return None


def session_description(name: str, address: str, port: int, parameter_sets: Sequence[bytes] = ()) -> str:
    """The session description (SDP, RFC 8866, RFC 6184 8.2.1) with which a player receives the stream.

    With the stream's parameter sets (SPS first, then PPS), a player that joins late has size and profile before the
    next IDR picture.
    """
    family = "IP6" if ":" in address else "IP4"
    title = " ".join(name.split()) or "-"
    lines = [
        "v=0",
        f"o=- 0 0 IN {family} {address}",
        f"s={title}",
        f"c=IN {family} {address}",
        "t=0 0",
        f"m=video {port} RTP/AVP {PAYLOAD_TYPE}",
        f"a=rtpmap:{PAYLOAD_TYPE} H264/{CLOCK_RATE}",
        f"a=fmtp:{PAYLOAD_TYPE} packetization-mode=1{_parameters(parameter_sets)}",
        "a=recvonly",
    ]
    return "".join(f"{line}\r\n" for line in lines)


def _parameters(sets: Sequence[bytes]) -> str:
    """The rest of the format parameters; the profile and level are the three bytes after the SPS's header."""
    if not sets:
        return ""
    encoded = ",".join(b64encode(parameter_set).decode() for parameter_set in sets)
    return f";profile-level-id={sets[0][1:4].hex()};sprop-parameter-sets={encoded}"


def ffmpeg_source(sdp: Path) -> list[str]:
    """Options of ffmpeg, ffplay and ffprobe, which decode a picture only when the next one begins."""
    quick = ["-fflags", "nobuffer", "-flags", "low_delay"]
    return ["-protocol_whitelist", "file,udp,rtp", *quick, "-i", str(sdp)]


def gstreamer_source(port: int) -> list[str]:
    """The start of a gst-launch-1.0 pipeline, up to decoded pictures; it waits 20 ms for late packets."""
    caps = f"application/x-rtp,media=video,clock-rate={CLOCK_RATE},encoding-name=H264,payload={PAYLOAD_TYPE}"
    stages = [["rtpjitterbuffer", "latency=20"], ["rtph264depay"], ["avdec_h264", "max-threads=1"]]
    return ["udpsrc", f"port={port}", f"caps={caps}", *(word for stage in stages for word in ("!", *stage))]
