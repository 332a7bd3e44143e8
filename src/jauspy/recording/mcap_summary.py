"""The summary at the end of an MCAP file, as far as it tells what was recorded: channels and numbers of messages.

The index of chunks, which has a record for each megabyte of the file, is not read, nor are schemas.
"""

from __future__ import annotations

import os
import struct
from collections import Counter
from collections.abc import Iterator, Mapping
from io import BytesIO
from typing import IO, TYPE_CHECKING, Any, Final, NamedTuple

from jauspy.errors import ConfigError
from jauspy.recording.mcap_records import mcap_records

if TYPE_CHECKING:
    from mcap.records import Channel, Statistics

MAX_PART: Final = 64 << 20
"""Bytes of a part of the summary, above which the file counts as damaged; a channel takes about 100."""
_HEAD: Final = struct.Struct("<BQ")
"""Opcode and length of a record."""
_END: Final = 1 + 8 + 20 + 8
"""Bytes of the footer with its head, and of the magic bytes that follow."""
_MAGIC_SIZE: Final = 8


class McapSummary(NamedTuple):
    """What the file tells of itself."""

    channels: dict[int, Channel]
    statistics: Statistics


def read_summary(file: IO[bytes], name: str) -> McapSummary:
    """The summary of an open MCAP file; raises `ConfigError` if there is none, or if the file is damaged."""
    try:
        found = _read(file)
    except OSError as error:
        raise ConfigError(f"{name} cannot be read: {error.strerror}") from None
    except Exception as error:  # noqa: BLE001 - what a parser of others raises for damaged files is not listed
        reason = str(error) or type(error).__name__
        raise ConfigError(f"{name} is no complete MCAP file ({reason}); `mcap recover` completes one") from None
    if found is None:
        raise ConfigError(f"{name} has no summary, as after a crash; `mcap recover` makes one")
    return found


def counted_summary(file: IO[bytes]) -> tuple[McapSummary, str]:
    """The same of a file without one, as after a crash, by reading all of it; and why it ends early."""
    from mcap.records import Channel, Message, Statistics  # noqa: PLC0415 - of the extra `recording`

    channels: dict[int, Channel] = {}
    counts: Counter[int] = Counter()
    start, end, problem = 0, 0, ""
    try:
        for record in mcap_records(file):
            if isinstance(record, Channel):
                channels[record.id] = record
            elif isinstance(record, Message):
                start = min(start, record.log_time) if counts else record.log_time
                end = max(end, record.log_time)
                counts[record.channel_id] += 1
    except Exception as error:  # noqa: BLE001 - what a parser of others raises for damaged files is not listed
        problem = str(error) or type(error).__name__
    known = {"attachment_count": 0, "chunk_count": 0, "metadata_count": 0, "schema_count": 0}
    statistics = Statistics(
        channel_count=len(channels),
        channel_message_counts=dict(counts),
        message_count=counts.total(),
        message_end_time=end,
        message_start_time=start,
        **known,
    )
    return McapSummary(channels, statistics), problem


def _read(file: IO[bytes]) -> McapSummary | None:
    from mcap.opcode import Opcode  # noqa: PLC0415 - of the extra `recording`
    from mcap.records import Channel, Footer, Statistics, SummaryOffset  # noqa: PLC0415

    end = file.seek(0, os.SEEK_END) - _END
    footer = next(_records(file, end, _END - _MAGIC_SIZE, {Opcode.FOOTER: Footer}), None)
    if footer is None:
        raise ValueError("it does not end with a footer")
    if not footer.summary_start:
        return None
    parts = [(footer.summary_start, (footer.summary_offset_start or end) - footer.summary_start)]
    if footer.summary_offset_start:
        length = end - footer.summary_offset_start
        groups = list(_records(file, footer.summary_offset_start, length, {Opcode.SUMMARY_OFFSET: SummaryOffset}))
        wanted = [group for group in groups if group.group_opcode in (Opcode.CHANNEL, Opcode.STATISTICS)]
        parts = [(group.group_start, group.group_length) for group in wanted]
    channels: dict[int, Channel] = {}
    statistics: Statistics | None = None
    for start, length in parts:
        for record in _records(file, start, length, {Opcode.CHANNEL: Channel, Opcode.STATISTICS: Statistics}):
            if isinstance(record, Channel):
                channels[record.id] = record
            else:
                statistics = record
    return None if statistics is None else McapSummary(channels, statistics)


def _records(file: IO[bytes], start: int, length: int, kinds: Mapping[int, Any]) -> Iterator[Any]:
    """The records of these kinds, by opcode, in a part of the file; raises `ValueError`, and what the parser raises."""
    from mcap.data_stream import ReadDataStream  # noqa: PLC0415 - of the extra `recording`

    if start < 0 or not 0 <= length <= MAX_PART:
        raise ValueError(f"a summary of {length} bytes at {start}")
    file.seek(start)
    data = file.read(length)
    place = 0
    while place < length:
        opcode, size = _HEAD.unpack_from(data, place)
        place += _HEAD.size
        if place + size > len(data):
            raise ValueError("a record of the summary is cut off")
        if opcode in kinds:
            yield kinds[opcode].read(ReadDataStream(BytesIO(data[place : place + size])))
        place += size
