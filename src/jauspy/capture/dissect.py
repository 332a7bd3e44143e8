"""Dissection of one UDP payload or message: headers, fields, and whether it encodes to the same bytes."""

from __future__ import annotations

from typing import Final, NamedTuple

from jauspy.codec.message import Message, too_short
from jauspy.codec.registry import NO_HINTS, Collision, Hints, MessageEntry, Registry
from jauspy.errors import EncodeError, ProtocolError
from jauspy.ids import message_id
from jauspy.protocol import header, judp, junior
from jauspy.protocol.header import Ack, Broadcast, DataFlag, Packet

V1_MARK: Final = b"\x01"
OPC_MARK: Final = b"JAUS01.0"  # OpenJAUS 2.75 and similar stacks wrote this before an AS5669 v1 header
# A JAUS Toolset component that sends with priority 0 sets all bits of the control byte.
PRIORITY_ZERO: Final = "control byte FF, as a faulty sender of priority 0 sets it; taken for a single packet"
STANDARD: Final = "urn:jaus:jss:"
OLD_HEADER: Final = "AS5669 v1/OPC header, not decoded"


class Content(NamedTuple):
    """The message of a packet or of bare bytes, as far as it can be decoded.

    `message` is None if there is none (an acknowledgement, a later fragment), if its code is unknown, or if its bytes
    are invalid; `problem` then says which. `others` are further meanings of the id, unless hints were given.
    `reencodes` is true if `reencoded` gives exactly the original bytes.
    """

    payload: bytes
    message: Message | None = None
    deviations: tuple[str, ...] = ()
    problem: str = ""
    broken: bool = False
    others: tuple[MessageEntry, ...] = ()
    reencodes: bool = True

    @property
    def code(self) -> int | None:
        """The message id, little endian in the first two bytes."""
        return message_id(self.payload) if len(self.payload) >= 2 else None

    def reencoded(self) -> bytes | None:
        """The encoded message; the payload itself if nothing was decoded; None if the message cannot be encoded."""
        return self.payload if self.message is None else _encoded(self.message, strict=not self.deviations)

    @property
    def exact(self) -> bool:
        """True when the bytes are exactly one known message, without deviations."""
        return self.message is not None and not self.deviations and self.reencodes


class Part(NamedTuple):
    """One packet of a datagram and its content: of the whole message, if `Dissector` put it together here."""

    packet: Packet
    content: Content


class Dissection(NamedTuple):
    """A dissected datagram; `errors` are sentences about what could not be read.

    `note` describes datagrams of another known format than AS5669A.
    """

    data: bytes
    parts: tuple[Part, ...] = ()
    errors: tuple[str, ...] = ()
    note: str = ""

    @property
    def reencodes(self) -> bool:
        """True when headers and messages encode to exactly the original bytes."""
        parts = self.parts
        if len(parts) == 1:  # nearly always
            return parts[0].content.reencodes and self.data[:1] + header.pack(parts[0].packet) == self.data
        again = b"".join([header.pack(part.packet) for part in parts])
        return bool(parts) and self.data[:1] + again == self.data and all(part.content.reencodes for part in parts)


_new: Final = tuple.__new__  # half the time of Content(...), which counts for each message


def dissect(data: bytes, registry: Registry, wanted: Hints = NO_HINTS) -> Dissection:
    """Dissect a UDP payload; `wanted` as in `read_message`. Never raises; problems are in `errors`."""
    if data[:1] != header.VERSION_BYTE and is_old_header(data):
        return Dissection(data, note=OLD_HEADER)
    packets, problems = judp.unpack_all(data)
    parts = [_new(Part, (packet, _content_of(packet, registry, wanted))) for packet in packets]
    errors = [_sentence(problem) for problem in problems]
    errors += [part.content.problem for part in parts if part.content.broken]
    return _new(Dissection, (data, tuple(parts), tuple(errors), ""))


def local_control(data: bytes) -> Dissection | None:
    """A Connect, Accept or Cancel of the Junior protocol, or None. On UDP the same bytes are a legacy packet."""
    control = junior.parse(data)
    if control is None:
        return None
    to_or_from = "to" if control.kind is junior.ControlKind.ACCEPT else "from"
    kind = control.kind.name.capitalize()
    return Dissection(data, note=f"{kind} {to_or_from} {control.id}, of the Junior local protocol")


def read_message(payload: bytes, registry: Registry, wanted: Hints = NO_HINTS) -> Content:
    """Decode a bare message (message id first).

    If an id has several meanings, that of the service, version or name in `wanted` is used, if there is one.
    """
    if len(payload) < 2:
        return Content(payload, problem=too_short(payload).reason, broken=True)
    code = payload[0] | payload[1] << 8
    hints = NO_HINTS if wanted is NO_HINTS else registry.narrowed(code, wanted)
    kind = registry.class_of(payload, hints)
    if kind is None:
        return Content(payload, problem=_undecided(code, registry.collision(code, hints)))
    message, found = registry.decode_as(kind, payload, strict=False)
    deviations = tuple(map(str, found)) if found else ()
    others = registry.others(kind) if hints is NO_HINTS or hints == NO_HINTS else ()
    reencodes = _encoded(message, strict=not found) == payload
    return _new(Content, (payload, message, deviations, "", False, others, reencodes))


def _encoded(message: Message, *, strict: bool) -> bytes | None:
    """The bytes of a message, with values outside their sets if need be; None if they cannot be encoded."""
    try:
        if strict:
            return message.encode()
    except EncodeError:
        pass
    try:
        return message.encode(strict=False)
    except EncodeError:
        return None


def _undecided(code: int, collision: Collision | None) -> str:
    if collision is None:
        return f"unknown message {code:04X}h"
    names = [f"{entry.name} of {entry.service.removeprefix(STANDARD)} {entry.version}" for entry in collision.entries]
    return f"message {code:04X}h is {' or '.join(names)}; specify the {collision.remedy}"


def is_old_header(data: bytes) -> bool:
    """True for packet formats older than AS5669A."""
    return data.startswith(OPC_MARK) or (data[:1] == V1_MARK and len(data) >= 21)


def _content_of(packet: Packet, registry: Registry, wanted: Hints) -> Content:
    payload, data_flag, ack = packet.payload, packet.data_flag, packet.ack
    if not payload:
        return Content(payload)
    if data_flag is DataFlag.SINGLE and ack is not Ack.ACK:
        return read_message(payload, registry, wanted)
    if packet.broadcast == Broadcast.RESERVED and packet.ack == Ack.ACK and packet.data_flag == DataFlag.LAST:
        content = read_message(payload, registry, wanted)
        return content._replace(deviations=(PRIORITY_ZERO, *content.deviations))
    if packet.ack == Ack.ACK:
        return Content(payload, problem="an acknowledgement with a payload, not decoded")
    return Content(payload, problem=f"{packet.data_flag.name.lower()} fragment, {len(payload)} bytes")


def _sentence(problem: ProtocolError) -> str:
    return f"packet not readable: {problem}"
