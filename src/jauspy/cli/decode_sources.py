"""What `jauspy decode` reads: captures, hex files, hex text, JSerial lines and standard input, as items to print."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from dataclasses import dataclass
from io import BufferedReader, BytesIO
from pathlib import Path
from typing import Final, Literal, NamedTuple, cast

from jauspy.capture.dissect import Content, Dissection, dissect, is_old_header, local_control, read_message
from jauspy.capture.dissector import Dissector
from jauspy.capture.reader import CaptureReader, Datagram, from_hex, from_lines, is_capture
from jauspy.cli import console
from jauspy.codec.registry import NO_HINTS, Hints, Registry
from jauspy.errors import ConfigError
from jauspy.messages import registry
from jauspy.protocol import judp
from jauspy.protocol.jserial import FrameDecoder
from jauspy.recording.mcap_capture import McapCapture, open_capture_file
from jauspy.recording.mcap_records import MAGIC


class Item(NamedTuple):
    """One thing to show: a datagram (captured or pasted) or a bare message. `number` is 0 when there is only one."""

    number: int
    captured: Datagram | None = None
    dissection: Dissection | None = None
    bare: Content | None = None

    @property
    def failed(self) -> bool:
        """True if something could not be decoded; unknown messages in a capture do not count."""
        if self.dissection is not None:
            return bool(self.dissection.errors)
        return self.bare is not None and (bool(self.bare.problem) or not self.bare.reencodes)


HexKindName = Literal["datagram", "message", "serial"] | None

_VERSION: Final = b"\x02"  # first byte of an AS5669A datagram
_UNCOMPRESSED: Final = b"\x00"  # its second byte
READ_SIZE: Final = 65536
"""Bytes of a JSerial line that are read at once."""
_MIN_DATAGRAM: Final = 15  # bytes of a datagram without payload


@dataclass(frozen=True, slots=True)
class DecodeOptions:
    """Definitions for decoding, the UDP port to select, and how to interpret hex text."""

    registry: Registry = registry
    wanted: Hints = NO_HINTS
    port: int | None = None
    what: HexKindName = None

    def datagram(self, data: bytes) -> Dissection:
        """Decode a UDP payload."""
        return dissect(data, self.registry, self.wanted)

    def message(self, data: bytes) -> Content:
        """Decode a message without header."""
        return read_message(data, self.registry, self.wanted)


def items(source: str, options: DecodeOptions) -> Iterator[Item]:
    """Everything in a file, in standard input (`-`) or in hex text; raises `ConfigError`."""
    if source == "-":
        yield from _from_file(cast("BufferedReader", sys.stdin.buffer), "standard input", options)
    elif _exists(Path(source)):
        with _open(Path(source)) as file:
            yield from _from_file(file, source, options)
    elif options.what == "serial":
        yield from _from_line(BytesIO(_from_text(source)), options)
    else:
        yield _from_hex(0, _from_text(source), options)


def _from_line(line: BufferedReader | BytesIO, options: DecodeOptions) -> Iterator[Item]:
    """The datagrams in bytes of a JSerial line, as they come."""
    decoder, dissector, number = FrameDecoder(), Dissector(options.registry, options.wanted), 0
    damaged = 0
    while data := line.read1(READ_SIZE):
        datagrams, errors = decoder.feed(data)
        damaged += len(errors)
        for datagram in datagrams:
            number += 1
            yield Item(number, dissection=dissector.dissect(datagram, 0.0))
    if damaged or not number:
        console.note(f"{damaged} damaged frames, {number} whole ones")


def _exists(path: Path) -> bool:
    try:
        return path.exists()
    except (OSError, ValueError):  # hex text is easily longer than a file name may be
        return False


def _open(path: Path) -> BufferedReader:
    try:
        return path.open("rb")
    except OSError as error:
        raise ConfigError(f"{path} cannot be read: {error.strerror}") from None


def _from_text(text: str) -> bytes:
    try:
        return from_hex(text)
    except ConfigError as error:
        raise ConfigError(f"there is no file {text!r}, and as hex text it is wrong: {error}") from None


def _from_file(file: BufferedReader, name: str, options: DecodeOptions) -> Iterator[Item]:
    if is_capture(file.peek(4)) or file.peek(len(MAGIC)).startswith(MAGIC):
        yield from _from_capture(open_capture_file(file, name=name, port=options.port), options)
        return
    if options.what == "serial":
        yield from _from_line(file, options)
        return
    try:
        lines = from_lines(file.read().decode("ascii"))
    except (UnicodeDecodeError, ConfigError) as error:
        reason = f": {error}" if isinstance(error, ConfigError) else ""
        raise ConfigError(f"{name} is neither a pcap, pcapng or MCAP file nor hex text{reason}") from None
    if not lines:
        raise ConfigError(f"{name} is empty")
    for number, data in lines:
        yield _from_hex(number, data, options)


def _from_capture(reader: CaptureReader | McapCapture, options: DecodeOptions) -> Iterator[Item]:
    count = 0
    dissector = Dissector(options.registry, options.wanted)
    for count, datagram in enumerate(reader, 1):  # noqa: B007 - for the note below
        number, time, source, destination, payload = datagram
        control = local_control(payload) if source == destination and _is_local(source) else None
        yield Item(number, datagram, control or dissector.dissect(payload, time))
    if not count and not reader.skipped:
        console.note("the capture has no packets")
    if reader.skipped:
        console.note("skipped: " + ", ".join(f"{count} {reason}" for reason, count in reader.skipped.items()))


def _is_local(address: tuple[str, int]) -> bool:
    """True for source and destination of the node manager's answers to components of its machine in its mirror."""
    host, port = address
    return host.startswith("127.") and port == judp.PORT


def _from_hex(number: int, data: bytes, options: DecodeOptions) -> Item:
    """A datagram if the bytes are a whole one, or long enough for one; else a message."""
    if options.what == "message":
        return Item(number, bare=options.message(data))
    control = local_control(data)
    if control is not None and options.what is None:
        return Item(number, dissection=control)
    datagram = Item(number, dissection=options.datagram(data))
    if options.what == "datagram" or (data[:1] == _VERSION and not datagram.failed):
        return datagram
    message = options.message(data)
    is_version_2 = data[:1] == _VERSION and (len(data) >= _MIN_DATAGRAM or data[1:2] == _UNCOMPRESSED)
    looks_like_datagram = is_version_2 or is_old_header(data)
    return datagram if looks_like_datagram and not message.exact else Item(number, bare=message)
