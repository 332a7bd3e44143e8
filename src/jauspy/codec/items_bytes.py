"""Layouts of strings, bytes, and messages inside messages."""

# ruff: noqa: D102 - what the methods do is written once, at `Item`

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from jauspy.codec.base import Message, Struct, counted
from jauspy.codec.item import Item, check_class, check_keys, integer_of, join, shown
from jauspy.codec.items_numbers import Values
from jauspy.codec.nesting import Nesting, Source
from jauspy.codec.streams import Reader, Writer
from jauspy.codec.wire import SIZES, limits
from jauspy.errors import EncodeError


@dataclass(frozen=True, slots=True)
class Count:
    """A count on the wire: its `struct` code and its limits."""

    code: str
    minimum: int
    maximum: int

    def read(self, reader: Reader, path: str, each: int = 1) -> int:
        """The count, checked against its limits and the bytes left; 0 once stopped."""
        offset = reader.at
        count = reader.count(self.code, path)
        if count is None:
            return 0
        if not self.minimum <= count <= self.maximum:
            reader.report(f"count {count} is outside {self.minimum}..{self.maximum}", path, offset)
        if count * each > reader.left and reader.strict:
            reader.report(
                f"count {count} needs at least {counted(count * each, 'byte')}, {reader.left} left", path, offset
            )
        return count

    def write(self, writer: Writer, count: int, path: str) -> None:
        """Raises `EncodeError` for a count beyond the limits."""
        _, highest = limits(self.code)
        low, high = (self.minimum, min(self.maximum, highest)) if writer.strict else (0, highest)
        if not low <= count <= high:
            raise EncodeError(f"count {count} is outside {low}..{high}", path=path)
        writer.number(self.code, count)


@dataclass(frozen=True, slots=True)
class Text(Item):
    """A string, one byte per character (Latin-1): of `length` bytes, NUL padded, or counted."""

    length: int = 0
    count: Count | None = None

    @property
    def minimum(self) -> int:
        return SIZES[self.count.code] if self.count else self.length

    def read(self, reader: Reader, path: str) -> str:
        size = self.count.read(reader, path) if self.count else self.length
        data = reader.take(size, path) or b""
        return (data if self.count else data.rstrip(b"\0")).decode("latin-1")

    def write(self, writer: Writer, value: Any, path: str) -> None:
        if not isinstance(value, str):
            raise EncodeError(f"{shown(value)} is not a string", path=path)
        try:
            data = value.encode("latin-1")
        except UnicodeEncodeError as error:
            raise EncodeError(f"{value[error.start]!r} is not a Latin-1 character", path=path) from error
        if self.count:
            self.count.write(writer, len(data), path)
        elif len(data) > self.length:
            raise EncodeError(f"{len(data)} characters are more than {self.length}", path=path)
        writer.out += data.ljust(self.length, b"\0")

    def from_json(self, data: Any, path: str, nesting: Nesting | None) -> str:  # noqa: ARG002 - others need it
        if not isinstance(data, str):
            raise EncodeError(f"{shown(data)} is not a string", path=path)
        return data


@dataclass(frozen=True, slots=True)
class Blob(Item):
    """Counted bytes; with `nested`, a message where the bytes are one."""

    count: Count
    nested: Source | None = None

    @property
    def minimum(self) -> int:
        return SIZES[self.count.code]

    def read(self, reader: Reader, path: str) -> Message | bytes:
        data = reader.take(self.count.read(reader, path), path) or b""
        return (reader.nesting or self.nested.nesting).message(data) if self.nested and not reader.stopped else data

    def write(self, writer: Writer, value: Any, path: str) -> None:
        data = blob_bytes(writer, value, path, nested=self.nested is not None)
        self.count.write(writer, len(data), path)
        writer.out += data

    def to_json(self, value: Any) -> Any:
        return blob_to_json(value)

    def from_json(self, data: Any, path: str, nesting: Nesting | None) -> Any:
        return blob_from_json(data, path, inside(self.nested, nesting))


@dataclass(frozen=True, slots=True)
class Formatted(Item):
    """A format index, a count, then bytes; `cls` has `format` and `data`."""

    cls: type[Struct]
    formats: Values
    count: Count
    nested: Source | None = None
    nested_formats: frozenset[int] = frozenset()

    @property
    def minimum(self) -> int:
        return 1 + SIZES[self.count.code]

    def read(self, reader: Reader, path: str) -> Struct:
        offset = reader.at
        chosen = reader.count("B", path)
        if chosen is not None and not self.formats.allows(chosen):
            reader.report(f"format {chosen} is none of {self.formats}", join(path, "format"), offset)
        where = join(path, "data")
        data: Message | bytes = reader.take(self.count.read(reader, where), where) or b""
        if self.nested and chosen in self.nested_formats and isinstance(data, bytes):
            data = (reader.nesting or self.nested.nesting).message(data)
        return self.cls(format=self.formats.named(chosen or 0), data=data)  # type: ignore[call-arg]  # generated fields

    def write(self, writer: Writer, value: Any, path: str) -> None:
        check_class(value, self.cls, path)
        chosen = integer_of(value.format, join(path, "format"))
        if not 0 <= chosen <= 255 or (writer.strict and not self.formats.allows(chosen)):
            raise EncodeError(f"{shown(chosen)} is none of {self.formats}", path=join(path, "format"))
        data = blob_bytes(writer, value.data, join(path, "data"), nested=chosen in self.nested_formats)
        writer.number("B", chosen)
        self.count.write(writer, len(data), join(path, "data"))
        writer.out += data

    def to_json(self, value: Any) -> Any:
        return {"format": self.formats.to_json(value.format), "data": blob_to_json(value.data)}

    def from_json(self, data: Any, path: str, nesting: Nesting | None) -> Struct:
        check_keys(data, ["format", "data"], [], path)
        chosen = self.formats.from_json(data["format"], join(path, "format"))
        content = blob_from_json(data["data"], join(path, "data"), inside(self.nested, nesting))
        return self.cls(format=chosen, data=content)  # type: ignore[call-arg]  # generated fields


def inside(known: Source | None, nesting: Nesting | None) -> Nesting | None:
    """What knows the messages inside a field: whoever reads it, else the registry its class is of."""
    return (nesting or known.nesting) if known else None


def blob_bytes(writer: Writer, value: Any, path: str, *, nested: bool) -> bytes:
    """The bytes of a field that takes bytes, or a message when `nested`."""
    if nested and isinstance(value, Message):
        inner = Writer(clamp=writer.clamp, strict=writer.strict)
        inner.depth = writer.depth
        inner.message(value, path)
        return bytes(inner.out)
    if not isinstance(value, (bytes, bytearray, memoryview)):
        raise EncodeError(f"{shown(value)} is not {'a message or ' if nested else ''}bytes", path=path)
    return bytes(value)


def message_to_dict(message: Message) -> dict[str, Any]:
    """A message in JSON with what tells which message it is: its name, service and version, and its `fields`."""
    head = {"message": message.NAME, "service": message.SERVICE, "version": message.VERSION}
    return {**head, "fields": message.to_dict()}


def blob_to_json(value: Any) -> Any:
    """`{"hex": ...}`, or `message_to_dict`."""
    return message_to_dict(value) if isinstance(value, Message) else {"hex": bytes(value).hex()}


def blob_from_json(data: Any, path: str, nesting: Nesting | None) -> Any:
    """The inverse of `blob_to_json`; also takes bytes and messages as they are."""
    if isinstance(data, (bytes, Message)):
        return data
    if isinstance(data, dict) and isinstance(data.get("hex"), str) and len(data) == 1:
        try:
            return bytes.fromhex(data["hex"])
        except ValueError as error:
            raise EncodeError(f"{shown(data['hex'])} is not hexadecimal", path=path) from error
    if nesting and isinstance(data, dict) and isinstance(data.get("message"), str):
        return nesting.from_dict(data, path)
    raise EncodeError(f'{shown(data)} is neither {{"hex": ...}} nor {{"message": ..., "fields": ...}}', path=path)
