"""`jauspy info` reads little of an MCAP file, however large it is, and none of what a hostile one claims."""

from __future__ import annotations

import io
import random
import struct
from pathlib import Path
from typing import Any

import pytest

from jauspy.errors import ConfigError
from jauspy.recording.mcap_summary import MAX_PART, read_summary

mcap = pytest.importorskip("mcap.writer", reason="mcap is of the extra `recording`")

CHUNKS, CHANNELS = 2500, 30
CHUNK = 1 << 20
FOOTER = 37
"""Bytes of the footer and the magic bytes behind it."""


class SparseFile:
    """A file in which data that is mostly zeros takes no room."""

    def __init__(self, file: io.BufferedWriter) -> None:
        self._file = file

    def write(self, data: Any) -> int:
        """Skip zeros at the end of large data."""
        kept = bytes(data).rstrip(b"\0") if len(data) >= CHUNK else data
        self._file.write(kept)
        self._file.seek(len(data) - len(kept), io.SEEK_CUR)
        return len(data)

    def tell(self) -> int:
        """The place of the next write."""
        return self._file.tell()


class CountedFile(io.FileIO):
    """A file that counts what is read of it."""

    count = 0

    def readinto(self, buffer: Any) -> int:
        """Read and count."""
        found = super().readinto(buffer) or 0
        self.count += found
        return found

    def read(self, size: int | None = -1) -> bytes:
        """Read and count."""
        found = super().read(-1 if size is None else size) or b""
        self.count += len(found)
        return found


def write(file: Any, chunks: int, size: int, **options: Any) -> None:
    run = mcap.Writer(file, chunk_size=size // 2, compression=mcap.CompressionType.NONE, enable_crcs=False, **options)
    run.start("jaus", "test")
    numbers = [run.register_channel(f"/101.1.{number}/ReportStatus", "json", 0) for number in range(CHANNELS)]
    for chunk in range(chunks):
        for number in numbers[1:]:
            run.add_message(number, chunk, b"{}", chunk)
        run.add_message(numbers[0], chunk, bytes(size), chunk)
    run.finish()


@pytest.fixture
def small() -> bytes:
    file = io.BytesIO()
    write(file, 3, 4000)
    return file.getvalue()


@pytest.mark.slow
def test_of_gigabytes_only_channels_and_statistics_are_read(tmp_path: Path) -> None:
    path = tmp_path / "run.mcap"
    with path.open("wb") as sparse:
        write(SparseFile(sparse), CHUNKS, CHUNK)
    assert path.stat().st_size > 2_500_000_000
    with CountedFile(str(path)) as raw, io.BufferedReader(raw) as file:
        found = read_summary(file, "run.mcap")
        assert raw.count < 100_000
    assert found.statistics.message_count == CHUNKS * CHANNELS
    assert found.statistics.chunk_count >= CHUNKS
    assert len(found.channels) == CHANNELS


@pytest.mark.parametrize("options", [{}, {"use_summary_offsets": False}])
def test_a_summary_is_read_with_and_without_the_index_of_its_parts(options: dict[str, bool]) -> None:
    file = io.BytesIO()
    write(file, 3, 4000, **options)
    found = read_summary(file, "run.mcap")
    assert {channel.topic for channel in found.channels.values()} >= {"/101.1.0/ReportStatus", "/101.1.29/ReportStatus"}
    assert sum(found.statistics.channel_message_counts.values()) == 3 * CHANNELS


def test_a_file_without_summary_says_so() -> None:
    file = io.BytesIO()
    write(file, 1, 4000, use_statistics=False)
    with pytest.raises(ConfigError, match="has no summary"):
        read_summary(file, "run.mcap")


@pytest.mark.parametrize(("summary", "offsets"), [(1, 0), (2**63, 0), (2**64 - 1, 2**64 - 1), (8, 2**40), (9, 10)])
def test_places_that_a_footer_claims_are_checked(small: bytes, summary: int, offsets: int) -> None:
    footer = struct.pack("<BQQQI", 2, 20, summary, offsets, 0) + small[-8:]
    assert len(footer) == FOOTER
    with pytest.raises(ConfigError, match=r"is no complete MCAP file|has no summary"):
        read_summary(io.BytesIO(small[:-FOOTER] + footer), "run.mcap")


def test_a_summary_that_would_not_fit_memory_is_refused(tmp_path: Path, small: bytes) -> None:
    path = tmp_path / "run.mcap"
    with path.open("wb") as file:
        file.truncate(MAX_PART * 40)
        file.seek(0, io.SEEK_END)
        file.write(struct.pack("<BQQQI", 2, 20, 8, 0, 0) + small[-8:])
    with CountedFile(str(path)) as raw, io.BufferedReader(raw) as file:
        with pytest.raises(ConfigError, match="a summary of"):
            read_summary(file, "run.mcap")
        assert raw.count < 100_000


def test_damaged_files_are_one_error(small: bytes) -> None:
    chance = random.Random(1)
    refused = 0
    for _ in range(400):
        damaged = bytearray(small[: chance.randrange(len(small) + 1)] if chance.random() < 0.3 else small)
        for _ in range(chance.randrange(1, 6)):
            if damaged:
                damaged[chance.randrange(max(0, len(damaged) - 2000), len(damaged))] = chance.randrange(256)
        try:
            read_summary(io.BytesIO(bytes(damaged)), "run.mcap")
        except ConfigError:
            refused += 1
    assert refused > 100
