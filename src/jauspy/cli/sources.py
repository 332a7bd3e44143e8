"""What `jauspy decode` is given: capture files, hex files, hex text and standard input."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from dataclasses import dataclass
from io import BufferedReader
from pathlib import Path
from typing import Final, Literal, cast

from jauspy.capture.dissect import Content, Dissection, dissect, is_old_header, local_control, read_message
from jauspy.capture.reader import CaptureReader, from_hex, from_lines, is_capture
from jauspy.cli import console
from jauspy.cli.traffic import Item
from jauspy.codec.registry import NO_HINTS, Hints, Registry
from jauspy.errors import ConfigError
from jauspy.messages import registry

What = Literal["datagram", "message"] | None

_VERSION: Final = b"\x02"  # first byte of an AS5669A datagram
_UNCOMPRESSED: Final = b"\x00"  # its second byte
_SMALLEST: Final = 15  # bytes of a datagram without payload


@dataclass(frozen=True, slots=True)
class Reading:
    """How to read: by which messages, only which UDP port, and what hex text is."""

    registry: Registry = registry
    wanted: Hints = NO_HINTS
    port: int | None = None
    what: What = None

    def datagram(self, data: bytes) -> Dissection:
        """Read a UDP payload."""
        return dissect(data, self.registry, self.wanted)

    def message(self, data: bytes) -> Content:
        """Read a bare message."""
        return read_message(data, self.registry, self.wanted)


def items(source: str, reading: Reading) -> Iterator[Item]:
    """Everything in a file, in standard input (`-`) or in hex text; raises `ConfigError`."""
    if source == "-":
        yield from _from_file(cast("BufferedReader", sys.stdin.buffer), "standard input", reading)
    elif _is_there(Path(source)):
        with _opened(Path(source)) as file:
            yield from _from_file(file, source, reading)
    else:
        yield _from_hex(0, _pasted(source), reading)


def _is_there(path: Path) -> bool:
    try:
        return path.exists()
    except (OSError, ValueError):  # hex text is easily longer than a file name may be
        return False


def _opened(path: Path) -> BufferedReader:
    try:
        return path.open("rb")
    except OSError as error:
        raise ConfigError(f"{path} cannot be read: {error.strerror}") from None


def _pasted(text: str) -> bytes:
    try:
        return from_hex(text)
    except ConfigError as error:
        raise ConfigError(f"there is no file {text!r}, and as hex text it is wrong: {error}") from None


def _from_file(file: BufferedReader, name: str, reading: Reading) -> Iterator[Item]:
    if is_capture(file.peek(4)):
        yield from _from_capture(CaptureReader(file, name=name, port=reading.port), reading)
        return
    try:
        lines = from_lines(file.read().decode("ascii"))
    except (UnicodeDecodeError, ConfigError) as error:
        reason = f": {error}" if isinstance(error, ConfigError) else ""
        raise ConfigError(f"{name} is neither a pcap or pcapng file nor hex text{reason}") from None
    if not lines:
        raise ConfigError(f"{name} is empty")
    for number, data in lines:
        yield _from_hex(number, data, reading)


def _from_capture(reader: CaptureReader, reading: Reading) -> Iterator[Item]:
    count = 0
    for count, datagram in enumerate(reader, 1):  # noqa: B007 - for the note below
        yield Item(datagram.number, captured=datagram, dissection=reading.datagram(datagram.payload))
    if not count and not reader.skipped:
        console.note("there are no packets in it")
    if reader.skipped:
        console.note("left out: " + ", ".join(f"{count} {reason}" for reason, count in reader.skipped.items()))


def _from_hex(number: int, data: bytes, reading: Reading) -> Item:
    """A datagram where it is a whole one or long enough for one, else a message; a damaged datagram is no message."""
    if reading.what == "message":
        return Item(number, bare=reading.message(data))
    control = local_control(data)
    if control is not None and reading.what is None:
        return Item(number, dissection=control)
    datagram = Item(number, dissection=reading.datagram(data))
    if reading.what == "datagram" or (data[:1] == _VERSION and not datagram.failed):
        return datagram
    message = reading.message(data)
    is_version_2 = data[:1] == _VERSION and (len(data) >= _SMALLEST or data[1:2] == _UNCOMPRESSED)
    looks_like_datagram = is_version_2 or is_old_header(data)
    return datagram if looks_like_datagram and not message.exact else Item(number, bare=message)
