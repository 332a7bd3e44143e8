"""The careful road: field by field over a layout, with paths and offsets, strict or tolerant."""

from __future__ import annotations

from typing import TypeVar

from jauspy.codec.base import Deviation, Message, check_code, counted
from jauspy.codec.nesting import Nesting
from jauspy.codec.streams import Reader, Writer
from jauspy.errors import DecodeError

M = TypeVar("M", bound=Message)


def decode(cls: type[M], data: bytes, nesting: Nesting | None = None) -> M:
    """Strict: raises `DecodeError` at the first deviation."""
    return _read(cls, Reader(data, strict=True, nesting=nesting))


def decode_tolerant(cls: type[M], data: bytes, nesting: Nesting | None = None) -> tuple[M, list[Deviation]]:
    """Tolerant: collects deviations; only a wrong message id raises."""
    reader = Reader(data, strict=False, nesting=nesting)
    message = _read(cls, reader)
    return message, reader.deviations()


def encode(message: Message, *, clamp: bool, strict: bool) -> bytes:
    """Raises `EncodeError` at the first value that does not fit."""
    writer = Writer(clamp=clamp, strict=strict)
    writer.message(message, "")
    return bytes(writer.out)


def _read(cls: type[M], reader: Reader) -> M:
    check_code(cls, reader.data)
    message = cls.layout().read(reader, "")
    left = len(reader.data) - reader.at
    if left and not reader.stopped:
        reader.report(f"{counted(left, 'byte')} left over after the message", "", lost=True)
    if not isinstance(message, cls):
        raise DecodeError(f"layout of {cls.NAME} makes {type(message).__name__}")
    return message
