"""MCAP files are read in bounded memory, whatever they claim of themselves."""

from __future__ import annotations

import io
import random
import struct
import tracemalloc
from pathlib import Path
from typing import Any

import pytest
from typer.testing import CliRunner

from jauspy.cli.main import app
from jauspy.recording.mcap_records import MAGIC, mcap_records

mcap = pytest.importorskip("mcap.writer", reason="mcap is of the extra `recording`")
records = pytest.importorskip("mcap.records")
zstandard = pytest.importorskip("zstandard")
frame = pytest.importorskip("lz4.frame")

BOMB = 64 << 20
"""Bytes that a few hundred of compressed ones become."""
MEMORY = 8 << 20


def written(compression: Any = mcap.CompressionType.ZSTD, *, chunks: bool = True) -> bytes:
    file = io.BytesIO()
    run = mcap.Writer(file, chunk_size=1000, compression=compression, use_chunking=chunks)
    run.start("jaus", "test")
    schema = run.register_schema("Point", "jsonschema", b"{}")
    channel = run.register_channel("/a", "json", schema, {"key": "value"})
    for number in range(100):
        run.add_message(channel, number, f"{number}".encode(), number)
    run.add_attachment(1, 1, "notes", "text/plain", bytes(3 << 20))
    run.finish()
    return file.getvalue()


def read(data: bytes) -> list[Any]:
    return list(mcap_records(io.BytesIO(data)))


@pytest.mark.parametrize("compression", list(mcap.CompressionType))
def test_messages_are_those_that_the_library_reads(compression: Any) -> None:
    from mcap.reader import make_reader

    data = written(compression)
    found = read(data)
    messages = [record for record in found if isinstance(record, records.Message)]
    assert messages == [message for _, _, message in make_reader(io.BytesIO(data)).iter_messages()]
    assert next(record.topic for record in found if isinstance(record, records.Channel)) == "/a"
    assert next(record.name for record in found if isinstance(record, records.Schema)) == "Point"


def test_files_without_chunks_are_read() -> None:
    assert len([record for record in read(written(chunks=False)) if isinstance(record, records.Message)]) == 100


def chunk(data: bytes, compression: str, claimed: int) -> bytes:
    name = compression.encode()
    body = struct.pack("<QQQII", 0, 1, claimed, 0, len(name)) + name + struct.pack("<Q", len(data)) + data
    return MAGIC + struct.pack("<BQ", 6, len(body)) + body


UNSAID = zstandard.ZstdCompressor(write_content_size=False)


@pytest.mark.parametrize(
    "hostile",
    [
        chunk(zstandard.compress(bytes(BOMB)), "zstd", 1000),
        chunk(UNSAID.compress(bytes(BOMB)), "zstd", 1000),
        chunk(frame.compress(bytes(BOMB)), "lz4", 1000),
        chunk(zstandard.compress(bytes(10)), "zstd", 1 << 40),
        chunk(b"", "zstd", 10),
        chunk(b"(\xb5/\xfd\xe0" + b"\xff" * 8, "zstd", 10),
        chunk(bytes(10), "brotli", 10),
        chunk(struct.pack("<BQ", 5, 1 << 62), "", 9),
        chunk(struct.pack("<BQ", 5, 3) + bytes(3), "", 12),
        MAGIC + struct.pack("<BQ", 6, 1 << 62),
        MAGIC + struct.pack("<BQ", 9, 1 << 62),
        MAGIC + struct.pack("<BQI", 3, 6, 1 << 31) + bytes(2),
        MAGIC,
        b"\x89MCAP1\r\n",
    ],
)
def test_what_a_hostile_file_claims_takes_no_memory(hostile: bytes) -> None:
    tracemalloc.start()
    try:
        with pytest.raises(Exception) as caught:  # noqa: PT011 - that of any parser
            read(hostile)
        assert not isinstance(caught.value, MemoryError)
        assert tracemalloc.get_traced_memory()[1] < MEMORY
    finally:
        tracemalloc.stop()


@pytest.mark.slow
def test_many_messages_of_a_chunk_are_not_in_memory_at_once() -> None:
    message = struct.pack("<BQHIQQ", 5, 22, 1, 0, 0, 0)
    data = chunk(zstandard.compress(message * 100_000), "zstd", len(message) * 100_000)
    tracemalloc.start()
    try:
        with pytest.raises(ValueError, match="do not end"):
            for _ in mcap_records(io.BytesIO(data)):
                pass
        assert tracemalloc.get_traced_memory()[1] < 3 * len(message) * 100_000
    finally:
        tracemalloc.stop()


@pytest.mark.parametrize(
    "verb", [("decode",), ("export", "--mp4"), ("export", "--csv"), ("replay",), ("echo", "--capture")]
)
def test_verbs_say_that_a_hostile_file_is_damaged(verb: tuple[str, ...], tmp_path: Path) -> None:
    path = tmp_path / "run.mcap"
    path.write_bytes(chunk(zstandard.compress(bytes(BOMB)), "zstd", 1000))
    result = CliRunner().invoke(app, [*verb, str(path)])
    assert result.exit_code == 1
    assert "damaged" in result.stderr
    assert "larger than it says" in " ".join(result.stderr.split())


@pytest.mark.slow
def test_damaged_bytes_are_errors_of_a_parser() -> None:
    chance, whole, refused = random.Random(3), written(), 0
    for _ in range(150):
        damaged = bytearray(whole[: chance.randrange(len(whole))] if chance.random() < 0.3 else whole)
        for _ in range(chance.randrange(1, 6)):
            if damaged:
                damaged[chance.randrange(min(len(damaged), 5000))] = chance.randrange(256)
        try:
            read(bytes(damaged))
        except (MemoryError, RecursionError):
            raise
        except Exception:  # noqa: BLE001 - that of any parser
            refused += 1
    assert refused > 75
