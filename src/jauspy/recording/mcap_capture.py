"""The datagrams in an MCAP file that jauspy recorded."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator
from io import BufferedReader
from typing import TYPE_CHECKING, Any

from jauspy.capture.ip import JAUS_PORT, DatagramAssembler
from jauspy.capture.reader import CaptureReader, Datagram
from jauspy.errors import ConfigError
from jauspy.recording.mcap_records import MAGIC, mcap_records
from jauspy.recording.run_files import DATAGRAMS, ENCODING

if TYPE_CHECKING:
    from mcap.records import Channel, Message, Schema


class McapCapture:
    """Iterates over the datagrams from or to `port` (None: any port), as `CaptureReader` does for other files.

    Raises:
        ConfigError: while iterating: no MCAP file, damaged, or cut off here, as after a crash of the recorder.
    """

    lost = 0
    """The recorder says at its end what it has lost; the file does not."""

    def __init__(self, file: BufferedReader[Any], *, name: str, port: int | None = JAUS_PORT) -> None:
        self._file, self._name, self._port = file, name, port
        self._assembler = DatagramAssembler()

    @property
    def skipped(self) -> Counter[str]:
        """Number of skipped packets, by reason."""
        return self._assembler.skipped

    def __iter__(self) -> Iterator[Datagram]:
        number = 0
        try:
            for number, (time, packet) in enumerate(self._packets(), 1):
                for udp in self._assembler.add(packet):
                    if self._port not in (None, udp.source[1], udp.destination[1]):
                        self.skipped[f"other UDP port than {self._port}"] += 1
                        continue
                    yield Datagram(number, time / 1e9, *udp)
        except _Damaged as error:
            raise ConfigError(f"{self._name} is damaged or cut off after datagram {number} ({error})") from None

    def _packets(self) -> Iterator[tuple[int, bytes]]:
        """Time (ns) and IPv4 packet of each datagram. Raises `_Damaged`."""
        from mcap.records import Channel, Message  # noqa: PLC0415 - of the extra `recording`

        topics: set[int] = set()

        def packets(records: Iterable[Schema | Channel | Message]) -> Iterator[tuple[int, bytes]]:
            for record in records:
                if isinstance(record, Channel) and (record.topic, record.message_encoding) == (DATAGRAMS, ENCODING):
                    topics.add(record.id)
                elif isinstance(record, Message) and record.channel_id in topics:
                    yield record.log_time, record.data

        found = packets(mcap_records(self._file))
        while True:
            try:
                packet = next(found, None)
            except Exception as error:  # noqa: BLE001 - what a parser of others raises for damaged files is not listed
                raise _Damaged(str(error) or type(error).__name__) from None
            if packet is None:
                return
            yield packet


class _Damaged(Exception):
    """The file cannot be read further."""


def open_capture_file(
    file: BufferedReader[Any], *, name: str, port: int | None = JAUS_PORT
) -> CaptureReader | McapCapture:
    """The capture in an open pcap, pcapng or MCAP file. Raises `ConfigError` for another file."""
    if file.peek(len(MAGIC)).startswith(MAGIC):
        return McapCapture(file, name=name, port=port)
    return CaptureReader(file, name=name, port=port)
