"""Files of recorded traffic: pcapng, and MCAP with the messages as JSON beside the datagrams."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from types import MappingProxyType
from typing import BinaryIO, Final, Protocol, cast

from jauspy.capture import writer
from jauspy.capture.dissect import Part
from jauspy.capture.reader import Datagram
from jauspy.codec.registry import Registry
from jauspy.errors import ConfigError, SchemaError
from jauspy.recording.definitions_archive import MEDIA_TYPE, NAME, fitting_archive
from jauspy.recording.described_robot import DescribedRobot

CHUNK_SIZE: Final = 1 << 20
"""Bytes of an MCAP chunk before it is compressed; each `flush` ends one."""
DATAGRAMS: Final = "/datagrams"
"""Topic with all datagrams of an MCAP file: IPv4 packets with UDP, as in pcap's link type 101."""
ENCODING: Final = "ipv4"
NO_ROBOTS: Final[Mapping[int, DescribedRobot]] = MappingProxyType({})
SUFFIXES: Final = (".pcapng", ".mcap")


class RunFile(Protocol):
    """A file that is being written; errors of writing raise `OSError`."""

    @property
    def size(self) -> int:
        """Bytes written so far."""
        ...

    def add(self, datagram: Datagram, parts: Sequence[Part]) -> None:
        """Add a datagram with the messages that are in it."""

    def add_picture(self, camera: str, time: float, access_unit: bytes, *, is_idr: bool) -> None:
        """Add a picture of H.264 (a byte stream of annex B), if the format has room for it."""

    def flush(self) -> None:
        """Hand over all that was added to the operating system."""

    def close(self) -> None:
        """Complete the file."""


def create(
    path: Path, registry: Registry, robots: Mapping[int, DescribedRobot] = NO_ROBOTS, limit: float | None = None
) -> RunFile:
    """A new file, by its suffix; the registry has the definitions of the messages, `robots` are described ones.

    `limit` is the number of bytes at which it will be closed, None for any: small files go without definitions.

    Raises:
        ConfigError: another suffix, a file that exists, or one that cannot be written; definitions that cannot be read.
    """
    if path.suffix not in SUFFIXES:
        raise ConfigError(f"{path} has none of the suffixes {', '.join(SUFFIXES)}")
    definitions = prepared(path, registry, limit)
    try:
        file = path.open("xb", buffering=0)
    except FileExistsError:
        raise ConfigError(f"{path} exists already; recordings are not overwritten") from None
    except OSError as error:
        raise ConfigError(f"{path} cannot be written: {error.strerror}") from None
    if path.suffix == ".mcap":
        return McapFile(cast("BinaryIO", file), registry, robots, definitions)
    return PcapngFile(cast("BinaryIO", file))


def prepared(path: Path, registry: Registry, limit: float | None = None) -> bytes:
    """The definitions for a file of this name, none for pcapng. Takes up to a second when it is called first.

    Raises `ConfigError` for definitions that cannot be read.
    """
    if path.suffix != ".mcap":
        return b""
    from jauspy.recording import feed  # noqa: F401, PLC0415 - needs foxglove; what takes long is in the import

    try:
        return fitting_archive(registry, limit)
    except SchemaError as error:
        raise ConfigError(f"the definitions for {path} cannot be read: {error}") from None


class PcapngFile:
    """Datagrams as they were, with synthetic IPv4 headers, for Wireshark and `jauspy decode`."""

    def __init__(self, file: BinaryIO) -> None:
        self._file = file
        self._blocks = [writer.preamble()]
        self.size = 0

    def add(self, datagram: Datagram, parts: Sequence[Part]) -> None:  # noqa: ARG002 - of `RunFile`
        """Add a datagram."""
        time = round(datagram.time * 1e9)
        self._blocks.append(writer.packet(datagram.source, datagram.destination, datagram.payload, time))

    def add_picture(self, camera: str, time: float, access_unit: bytes, *, is_idr: bool) -> None:
        """Do nothing: pcapng has datagrams only."""

    def flush(self) -> None:
        """Write what was added."""
        data = memoryview(b"".join(self._blocks))
        self._blocks.clear()
        while data:
            written = self._file.write(data)
            self.size += written
            data = data[written:]

    def close(self) -> None:
        """Write what is left, and close the file."""
        try:
            self.flush()
        finally:
            self._file.close()


class McapFile:
    """Datagrams; each message as JSON, on a topic of its sender and name; and what Foxglove's schemas tell of them.

    `definitions` (`definitions_archive`) are attached before the first message, so that the file can be read without
    jauspy, also after the recorder was killed.
    """

    def __init__(
        self,
        file: BinaryIO,
        registry: Registry,
        robots: Mapping[int, DescribedRobot] = NO_ROBOTS,
        definitions: bytes = b"",
    ) -> None:
        import foxglove  # noqa: PLC0415 - of the extra `recording`

        from jauspy.recording.feed import Feed  # noqa: PLC0415 - needs foxglove
        from jauspy.recording.samples import Channels  # noqa: PLC0415 - needs foxglove

        self._out = _CountedFile(file)
        context = foxglove.Context()
        options = foxglove.mcap.MCAPWriteOptions(profile="jaus", chunk_size=CHUNK_SIZE, compression_threads=0)
        self._writer = foxglove.open_mcap(cast("BinaryIO", self._out), context=context, writer_options=options)
        self._feed = Feed(registry, robots)
        self._channels = Channels(context)
        self._definitions = definitions
        """What is still to be attached."""

    @property
    def size(self) -> int:
        """Bytes written so far."""
        return self._out.size

    def add(self, datagram: Datagram, parts: Sequence[Part]) -> None:
        """Add a datagram with the messages that are in it."""
        self._attach(round(datagram.time * 1e9))
        for sample in self._feed.samples(datagram, parts):
            self._channels.add(sample)
        self._out.check()

    def add_picture(self, camera: str, time: float, access_unit: bytes, *, is_idr: bool) -> None:
        """Add a picture of a camera's H.264."""
        from jauspy.recording.foxglove_messages import picture  # noqa: PLC0415 - needs foxglove

        self._attach(round(time * 1e9))
        self._channels.add(picture(camera, round(time * 1e9), access_unit, is_idr=is_idr))
        self._out.check()

    def _attach(self, time: int) -> None:
        """Attach the definitions, once, with the time of what comes first (ns)."""
        data, self._definitions = self._definitions, b""
        if data:
            self._writer.attach(log_time=time, create_time=time, name=NAME, media_type=MEDIA_TYPE, data=data)

    def flush(self) -> None:
        """End the present chunk, and write it."""
        self._writer.flush()
        self._out.check()

    def close(self) -> None:
        """Write the summary, and close the file."""
        try:
            self._writer.close()
            self._out.check()
        finally:
            self._out.close()


class _CountedFile:
    """A file whose first error is kept: the writer of MCAP only logs errors."""

    def __init__(self, file: BinaryIO) -> None:
        self._file = file
        self._error: OSError | None = None
        self.size = 0

    def write(self, data: bytes) -> int:
        """Write all of it."""
        left = memoryview(data)
        try:
            while left:
                left = left[self._file.write(left) :]
            self.size = max(self.size, self._file.tell())
        except OSError as error:
            self._error = self._error or error
        return len(data)

    def seek(self, offset: int, whence: int = 0) -> int:
        """Change the place of the next write."""
        return self._file.seek(offset, whence)

    def tell(self) -> int:
        """The place of the next write."""
        return self._file.tell()

    def flush(self) -> None:
        """Do nothing: all is written at once."""

    def check(self) -> None:
        """Raise the first error."""
        if self._error is not None:
            raise self._error

    def close(self) -> None:
        """Close the file."""
        self._file.close()
