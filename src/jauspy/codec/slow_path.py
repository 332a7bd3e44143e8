"""The slow path: encodes and decodes field by field over a layout, with paths and offsets, strict or tolerant."""

from __future__ import annotations

import struct
from functools import lru_cache
from typing import Final, TypeVar

from jauspy.codec.message import MAX_NESTING, Deviation, Message, Nesting, check_code, counted
from jauspy.codec.scalars import SIZES
from jauspy.errors import DecodeError, EncodeError

MAX_DEVIATIONS: Final = 1000
"""Deviations that are listed for one message; a hostile one may have one in every byte."""


@lru_cache(maxsize=32)
def codec_of(code: str) -> struct.Struct:
    """The little-endian `Struct` of one number."""
    return struct.Struct(f"<{code}")


class MessageReader:
    """A position in the bytes of a message, and the deviations so far.

    `stopped` is set if the rest cannot be read; all later fields get defaults. `nesting` decodes nested
    messages; None stands for the registry that the class belongs to.
    """

    __slots__ = (
        "_first_omitted",
        "_lost_omitted",
        "_omitted",
        "_reported",
        "at",
        "data",
        "nesting",
        "stopped",
        "strict",
    )

    def __init__(self, data: bytes, *, strict: bool, nesting: Nesting | None = None) -> None:
        self.data = data
        self.nesting = nesting
        self.at = 2
        self.strict = strict
        self.stopped = False
        self._reported: list[Deviation] = []
        self._omitted = 0
        self._first_omitted = 0
        self._lost_omitted = False

    @property
    def left(self) -> int:
        """Bytes not read yet."""
        return len(self.data) - self.at

    def report(self, reason: str, path: str, offset: int | None = None, *, lost: bool = False) -> None:
        """Raise `DecodeError` when strict, else record a deviation."""
        where = self.at if offset is None else offset
        if self.strict:
            raise DecodeError(reason, offset=where, path=path)
        if len(self._reported) < MAX_DEVIATIONS:
            self._reported.append(Deviation(where, path, reason, lost))
            return
        self._first_omitted = self._first_omitted or where
        self._omitted += 1
        self._lost_omitted |= lost

    def deviations(self) -> list[Deviation]:
        """The deviations so far; those beyond `MAX_DEVIATIONS` are counted."""
        if not self._omitted:
            return self._reported
        reason = f"{counted(self._omitted, 'more deviation')} from here on"
        return [*self._reported, Deviation(self._first_omitted, "", reason, self._lost_omitted)]

    def stop(self, reason: str, path: str, offset: int | None = None) -> None:
        """Report a deviation and stop: the rest cannot be read."""
        self.report(reason, path, offset, lost=True)
        self.stopped = True

    def number(self, code: str, path: str) -> int | float | None:
        """The next number, or None at the end."""
        size = SIZES[code]
        if not self.has(size, path):
            return None
        (value,) = codec_of(code).unpack_from(self.data, self.at)
        self.at += size
        return value  # type: ignore[no-any-return]  # struct gives int or float for these codes

    def count(self, code: str, path: str) -> int | None:
        """The next unsigned number, or None at the end."""
        value = self.number(code, path)
        return None if value is None else int(value)

    def take(self, size: int, path: str) -> bytes | None:
        """The next `size` bytes; tolerant readers get fewer at the end, `None` once stopped."""
        if self.stopped:
            return None
        start = self.at
        if self.left < size:
            self.stop(f"needs {counted(size, 'byte')}, {self.left} left", path)
        taken = self.data[start : start + size]
        self.at = start + len(taken)
        return taken

    def has(self, size: int, path: str) -> bool:
        """True if `size` bytes are left; else reports a deviation and stops."""
        if not self.stopped and self.left < size:
            self.stop(f"needs {counted(size, 'byte')}, {self.left} left", path)
        return not self.stopped


class MessageWriter:
    """Collects the bytes of a message."""

    __slots__ = ("clamp", "depth", "out", "strict")

    def __init__(self, *, clamp: bool, strict: bool) -> None:
        self.out = bytearray()
        self.clamp = clamp
        self.strict = strict
        self.depth = 0

    def number(self, code: str, value: float) -> None:
        """Append a number that is known to fit."""
        self.out += codec_of(code).pack(value)

    def message(self, message: Message, path: str) -> None:
        """The two id bytes and the fields."""
        if self.depth > MAX_NESTING:
            raise EncodeError(f"messages are nested more than {MAX_NESTING} deep", path=path)
        self.depth += 1
        self.number("H", type(message).CODE)
        message.layout().write(self, message, path)
        self.depth -= 1


M = TypeVar("M", bound=Message)


def decode(cls: type[M], data: bytes, nesting: Nesting | None = None) -> M:
    """The message; raises `DecodeError` at the first deviation."""
    return _read(cls, MessageReader(data, strict=True, nesting=nesting))


def decode_tolerant(cls: type[M], data: bytes, nesting: Nesting | None = None) -> tuple[M, list[Deviation]]:
    """The message as far as it can be read, and all deviations; only a wrong message id raises `DecodeError`."""
    reader = MessageReader(data, strict=False, nesting=nesting)
    message = _read(cls, reader)
    return message, reader.deviations()


def encode(message: Message, *, clamp: bool, strict: bool) -> bytes:
    """The bytes of a message; raises `EncodeError` at the first value that does not fit."""
    writer = MessageWriter(clamp=clamp, strict=strict)
    writer.message(message, "")
    return bytes(writer.out)


def _read(cls: type[M], reader: MessageReader) -> M:
    check_code(cls, reader.data)
    message = cls.layout().read(reader, "")
    left = len(reader.data) - reader.at
    if left and not reader.stopped:
        reader.report(f"{counted(left, 'byte')} left over after the message", "", lost=True)
    if not isinstance(message, cls):
        raise DecodeError(f"layout of {cls.NAME} makes {type(message).__name__}")
    return message
