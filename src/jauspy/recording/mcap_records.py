"""The records of an MCAP file from its beginning on, in bounded memory whatever the file claims of itself.

`mcap` reads a chunk as a whole, with an object for each message, and as large as the compressed data say.
"""

from __future__ import annotations

import struct
import zlib
from collections.abc import Iterator
from io import BytesIO
from typing import IO, TYPE_CHECKING, Any, Final

if TYPE_CHECKING:
    from mcap.records import Channel, Chunk, Message, Schema

MAGIC: Final = b"\x89MCAP0\r\n"
MAX_CHUNK: Final = 256 << 20
"""Bytes of a record, also of what a chunk is decompressed to; more counts as damage."""
UNFINISHED: Final = (1 << 64) - 1
"""Length of the chunk that Foxglove's library was writing when its program was killed."""
_HEAD: Final = struct.Struct("<BQ")
"""Opcode and length of a record."""
_MESSAGE: Final = struct.Struct("<HIQQ")
"""Channel, sequence number, and times of recording and publication, before the data of a message."""
_SKIPPED_AT_ONCE: Final = 1 << 20


def mcap_records(file: IO[bytes]) -> Iterator[Schema | Channel | Message]:
    """Schemas, channels and messages, those in chunks too, up to the end of the data.

    Raises `ValueError`, `struct.error`, and what parsers of others raise, for a damaged file or one that is cut off.
    """
    from mcap.opcode import Opcode  # noqa: PLC0415 - of the extra `recording`
    from mcap.records import Chunk  # noqa: PLC0415

    if file.read(len(MAGIC)) != MAGIC:
        raise ValueError("it does not begin as an MCAP file")
    while True:
        head = file.read(_HEAD.size)
        if len(head) != _HEAD.size:
            raise ValueError("its data do not end")
        opcode, size = _HEAD.unpack(head)
        if opcode in (Opcode.DATA_END, Opcode.FOOTER):
            return
        if size == UNFINISHED:
            raise ValueError("its last chunk was not finished")
        if size > MAX_CHUNK:
            raise ValueError(f"a record of {size} bytes")
        if opcode not in (Opcode.CHUNK, Opcode.SCHEMA, Opcode.CHANNEL, Opcode.MESSAGE):
            _skip(file, size)
            continue
        data = file.read(size)
        if len(data) != size:
            raise ValueError("a record is cut off")
        if opcode == Opcode.CHUNK:
            yield from chunk_records(_parsed(Chunk, data))
        else:
            yield _record(opcode, data)


def chunk_records(chunk: Chunk) -> Iterator[Schema | Channel | Message]:
    """Those in a chunk. Raises as `mcap_records` does."""
    from mcap.opcode import Opcode  # noqa: PLC0415 - of the extra `recording`

    data = _decompressed(chunk)
    if chunk.uncompressed_crc and zlib.crc32(data) != chunk.uncompressed_crc:
        raise ValueError("the checksum of a chunk is wrong")
    place = 0
    while place < len(data):
        opcode, size = _HEAD.unpack_from(data, place)
        place += _HEAD.size
        if place + size > len(data):
            raise ValueError("a record of a chunk is cut off")
        if opcode in (Opcode.SCHEMA, Opcode.CHANNEL, Opcode.MESSAGE):
            yield _record(opcode, data[place : place + size])
        place += size


def _record(opcode: int, data: bytes) -> Schema | Channel | Message:
    from mcap.opcode import Opcode  # noqa: PLC0415 - of the extra `recording`
    from mcap.records import Channel, Message, Schema  # noqa: PLC0415

    if opcode == Opcode.MESSAGE:
        channel, sequence, log_time, publish_time = _MESSAGE.unpack_from(data)
        return Message(channel, log_time, data[_MESSAGE.size :], publish_time, sequence)
    found: Schema | Channel = _parsed(Schema if opcode == Opcode.SCHEMA else Channel, data)
    return found


def _parsed(kind: Any, data: bytes) -> Any:
    from mcap.data_stream import ReadDataStream  # noqa: PLC0415 - of the extra `recording`

    return kind.read(ReadDataStream(BytesIO(data)))


def _decompressed(chunk: Chunk) -> bytes:
    """The data of a chunk. Raises `ValueError` if they are more than it says, or than `MAX_CHUNK`."""
    claimed, data = chunk.uncompressed_size, chunk.data
    if claimed > MAX_CHUNK:
        raise ValueError(f"a chunk of {claimed} bytes")
    match chunk.compression:
        case "zstd":
            import zstandard  # noqa: PLC0415 - mcap depends on it

            # what the compressed data say is taken for the size to allocate, whatever limit is given
            if zstandard.frame_content_size(data) > claimed:
                raise ValueError("a chunk is larger than it says")
            plain = zstandard.ZstdDecompressor().decompress(data, max_output_size=claimed)
        case "lz4":
            from lz4.frame import LZ4FrameDecompressor  # noqa: PLC0415 - mcap depends on it

            plain = LZ4FrameDecompressor().decompress(data, max_length=claimed + 1)
        case "":
            plain = data
        case other:
            raise ValueError(f"chunks compressed by {other}, which is not known")
    if len(plain) != claimed:
        raise ValueError("a chunk has another size than it says")
    return plain


def _skip(file: IO[bytes], size: int) -> None:
    """Pass over bytes, also of a pipe."""
    while size:
        taken = len(file.read(min(size, _SKIPPED_AT_ONCE)))
        if not taken:
            raise ValueError("a record is cut off")
        size -= taken
