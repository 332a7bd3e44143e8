"""The base classes of messages, and the two paths through the codec.

A message class declares its fields and its layout. Its straight-line `_unpack` and `_pack` are made from the layout
when they are first called (`jauspy.codec.fast_path`). They take valid input only; all else ends in one of
`FAST_ERRORS`. Then the slow path (`jauspy.codec.slow_path`) processes the same input field by field: it finds the error
and its offset, clamps, or keeps what a tolerant decoder can keep. It costs about ten times as much and is linear in the
input, too.
"""

from __future__ import annotations

import struct
from collections.abc import Mapping
from dataclasses import dataclass, fields
from typing import TYPE_CHECKING, Any, ClassVar, Final, Literal, Protocol, Self, TypeVar, overload

from jauspy.errors import DecodeError, EncodeError

if TYPE_CHECKING:
    from jauspy.codec.items import Item


MAX_NESTING: Final = 8
"""Levels of nested messages that are decoded; deeper ones stay bytes."""


class Reject(Exception):
    """Raised by straight-line code for input that it does not handle."""


FAST_ERRORS: Final = (
    Reject,
    struct.error,
    LookupError,
    TypeError,
    ValueError,
    AttributeError,
    OverflowError,
    RecursionError,
)
"""All that straight-line code may raise on bad bytes or bad values."""


@dataclass(frozen=True, slots=True)
class Deviation:
    """An error that a tolerant decoder accepted; `offset` counts from the first byte of the message id.

    `lost` is true if bytes were skipped or missing, so that the message does not encode to the same bytes again.
    """

    offset: int
    path: str
    reason: str
    lost: bool = False

    def __str__(self) -> str:
        return f"byte {self.offset}: {self.path + ': ' if self.path else ''}{self.reason}"


_LAYOUTS: Final[dict[type[Struct], Item]] = {}


class Struct:
    """A record, sequence, bit field or variable field inside a message."""

    __slots__ = ()

    @classmethod
    def _read(cls, data: bytes, at: int, nesting: Nesting | None) -> tuple[Self, int]:
        """Decode valid bytes from `at` on; returns the object and the end. Raises one of `FAST_ERRORS` for others."""
        from jauspy.codec.fast_path import install  # noqa: PLC0415 - once for each class

        install(cls, "_read")
        return cls._read(data, at, nesting)

    def _write(self, out: bytearray) -> None:
        """Append valid values; raises one of `FAST_ERRORS` for others."""
        from jauspy.codec.fast_path import install  # noqa: PLC0415 - once for each class

        install(type(self), "_write")
        self._write(out)

    @classmethod
    def _layout(cls) -> Item:
        raise Reject

    @classmethod
    def layout(cls) -> Item:
        """The wire layout of this class: fields with types, units and ranges."""
        if cls not in _LAYOUTS:
            _LAYOUTS[cls] = cls._layout()
        return _LAYOUTS[cls]

    def to_dict(self) -> dict[str, Any]:
        """A JSON-able, lossless form: absent optionals left out, enum members by name, bytes as `{"hex": ...}`."""
        data: dict[str, Any] = self.layout().to_json(self)
        return data

    @classmethod
    def from_dict(cls, data: dict[str, Any]) -> Self:
        """The inverse of `to_dict`; enum members by name or number. Raises `EncodeError` with the field path."""
        return cls._from_json(data, "", None)

    @classmethod
    def _from_json(cls, data: object, path: str, nesting: Nesting | None) -> Self:
        value = cls.layout().from_json(data, path, nesting)
        assert isinstance(value, cls)
        return value

    def __repr__(self) -> str:
        shown = ((f.name, getattr(self, f.name)) for f in fields(self) if f.init)  # type: ignore[arg-type]  # generated classes are dataclasses
        parts = [f"{name}={value!r}" for name, value in shown if not _is_silent(name, value)]
        return f"{type(self).__qualname__}({', '.join(parts)})"


def _is_silent(name: str, value: object) -> bool:
    return value is None or (value == 0 and name in ("reserved_presence", "reserved_bits"))


class Message(Struct):
    """A JAUS message: two id bytes, then its fields. Subclasses are declared with `jauspy.codec.declare`."""

    __slots__ = ()

    CODE: ClassVar[int]
    NAME: ClassVar[str]
    SERVICE: ClassVar[str]
    VERSION: ClassVar[str]
    IS_COMMAND: ClassVar[bool]
    IS_QUERY: ClassVar[bool]
    """True for a query: by its id, or, for user-defined ids, an input that is not a command."""

    @classmethod
    def _unpack(cls, data: bytes, nesting: Nesting | None) -> Self:
        """Decode valid bytes; raises one of `FAST_ERRORS` for others.

        `nesting` decodes nested messages; None stands for the registry of the class.
        """
        from jauspy.codec.fast_path import install  # noqa: PLC0415 - once for each class

        install(cls, "_unpack")
        return cls._unpack(data, nesting)

    def _pack(self) -> bytes:
        """Encode valid values; raises one of `FAST_ERRORS` for others."""
        from jauspy.codec.fast_path import install  # noqa: PLC0415 - once for each class

        install(type(self), "_pack")
        return self._pack()

    def encode(self, *, clamp: bool = False, strict: bool = True) -> bytes:
        """The message as bytes, the two id bytes first.

        Raises `EncodeError` with field path, value and range. `clamp=True` moves numbers that are out of range to the
        nearest limit instead. `strict=False` leaves value sets and count limits unchecked, as for messages that came
        from `decode(..., strict=False)`.
        """
        if strict and not clamp:
            try:
                return self._pack()
            except FAST_ERRORS:
                pass
        from jauspy.codec.slow_path import encode  # noqa: PLC0415 - not on the fast path

        return encode(self, clamp=clamp, strict=strict)

    @overload
    @classmethod
    def decode(cls, data: bytes | bytearray | memoryview, *, strict: Literal[True] = True) -> Self: ...

    @overload
    @classmethod
    def decode(
        cls, data: bytes | bytearray | memoryview, *, strict: Literal[False]
    ) -> tuple[Self, list[Deviation]]: ...

    @classmethod
    def decode(
        cls, data: bytes | bytearray | memoryview, *, strict: bool = True
    ) -> Self | tuple[Self, list[Deviation]]:
        """Read one whole message; raises `DecodeError` with offset, field path and reason.

        With `strict=False`, read what can be read, and return it with a list of deviations; an empty one means that
        the bytes are valid. Values outside their set stay numbers, missing fields get defaults, extra bytes are
        reported. Beyond 1000 deviations the rest is counted. `DecodeError` is raised only for the id of another
        message.
        """
        if type(data) is not bytes:
            data = as_bytes(data)
        try:
            if strict:
                return cls._unpack(data, None)
            return cls._unpack(data, None), []
        except FAST_ERRORS:
            pass
        from jauspy.codec import slow_path  # noqa: PLC0415 - not on the fast path

        return slow_path.decode(cls, data) if strict else slow_path.decode_tolerant(cls, data)


R_co = TypeVar("R_co", bound=Message, covariant=True)


class Query(Protocol[R_co]):
    """A message with `REPORT`, the class of its report: type checkers infer what a query returns."""

    @property
    def REPORT(self) -> type[R_co]:  # noqa: N802 - a constant of the class
        """The class of the report."""


def as_bytes(data: object) -> bytes:
    """A copy of any bytes-like object; `DecodeError` for other types, because `bytes(5)` would be five bytes."""
    try:
        return memoryview(data).tobytes()  # type: ignore[arg-type]  # the check is what this is for
    except TypeError:
        raise DecodeError(f"a message is bytes, not {type(data).__name__}") from None


def too_short(data: bytes) -> DecodeError:
    """The error for fewer than two bytes."""
    return DecodeError(f"{counted(len(data), 'byte')}: too short for a message id")


def counted(number: int, what: str) -> str:
    """`1 byte`, `2 bytes`."""
    return f"{number} {what}" if number == 1 else f"{number} {what}s"


def check_code(cls: type[Message], data: bytes) -> None:
    """Raise `DecodeError` unless the two id bytes are those of `cls`."""
    if len(data) < 2:
        raise too_short(data)
    code = data[0] | data[1] << 8
    if code != cls.CODE:
        raise DecodeError(f"message id 0x{code:04X} is not 0x{cls.CODE:04X} ({cls.NAME})")


class NestingSource(Protocol):
    """Finds the classes of nested messages: a registry."""

    @property
    def nesting(self) -> Nesting:
        """The `Nesting` for messages that are not nested themselves."""

    def class_of(self, data: bytes) -> type[Message] | None:
        """The class for the message id of these bytes; None if it is unknown or ambiguous."""

    def message_from(self, data: Mapping[str, Any], nesting: Nesting, path: str) -> Message:
        """The inverse of `message_to_dict`; raises `EncodeError`."""


class Nesting:
    """Decodes nested messages, down to `MAX_NESTING` levels."""

    __slots__ = ("_inner", "_source")

    def __init__(self, source: NestingSource, depth: int = 0) -> None:
        self._source = source
        self._inner = Nesting(source, depth + 1) if depth < MAX_NESTING else None

    def message(self, data: bytes) -> Message | bytes:
        """The nested message if it decodes strictly and encodes to the same bytes, else the bytes."""
        if self._inner is None:
            return data
        cls = self._source.class_of(data)
        if cls is None:
            return data
        try:
            message = cls._unpack(data, self._inner)
            return message if message._pack() == data else data  # noqa: SLF001 - the fast path
        except FAST_ERRORS:
            return data

    def from_dict(self, data: Mapping[str, Any], path: str) -> Message:
        """The nested message; raises `EncodeError`, also if it is nested too deeply."""
        if self._inner is None:
            raise EncodeError(f"messages are nested more than {MAX_NESTING} deep", path=path)
        return self._source.message_from(data, self._inner, path)
