"""What every layout item can do, and the checks they share."""

from __future__ import annotations

from abc import ABC, abstractmethod
from operator import index
from typing import Any, Final

from jauspy.codec.base import Struct
from jauspy.codec.nesting import Nesting
from jauspy.codec.streams import Reader, Writer
from jauspy.errors import EncodeError

MOST_SHOWN: Final = 100
"""Characters of a wrong value that a message shows."""


def join(path: str, name: str) -> str:
    """The path of a field inside another."""
    return f"{path}.{name}" if path else name


class Item(ABC):
    """How one value lies on the wire; every method takes the field path for its errors."""

    __slots__ = ()

    @property
    @abstractmethod
    def minimum(self) -> int:
        """The fewest bytes it can take."""

    @abstractmethod
    def read(self, reader: Reader, path: str) -> Any:
        """The next value; a default when the reader has stopped."""

    @abstractmethod
    def write(self, writer: Writer, value: Any, path: str) -> None:
        """Append the value; raises `EncodeError`."""

    def to_json(self, value: Any) -> Any:
        """The value as JSON carries it."""
        return value

    @abstractmethod
    def from_json(self, data: Any, path: str, nesting: Nesting | None) -> Any:
        """The inverse of `to_json`; raises `EncodeError` for another type. Limits are checked when it is encoded."""


def shown(value: object) -> str:
    """A value for a message, cut where it gets long."""
    try:
        text = repr(value)
    except (ValueError, RecursionError):  # an integer of more digits than Python prints; lists in lists without end
        text = f"this {type(value).__name__}"
    return cut(text)


def cut(text: str) -> str:
    """The beginning and the end of a long text."""
    return text if len(text) <= MOST_SHOWN else f"{text[: MOST_SHOWN - 13]}...{text[-10:]}"


def number_of(value: Any, path: str) -> float:
    """A finite float, or `EncodeError`."""
    if isinstance(value, (str, bytes, bytearray)):
        raise EncodeError(f"{shown(value)} is not a number", path=path)
    try:
        number = float(value)
    except OverflowError as error:
        raise EncodeError(f"{shown(value)} is too large", path=path) from error
    except (TypeError, ValueError) as error:
        raise EncodeError(f"{shown(value)} is not a number", path=path) from error
    return number


def integer_of(value: Any, path: str) -> int:
    """An int, or `EncodeError`."""
    try:
        return index(value)
    except TypeError as error:
        raise EncodeError(f"{shown(value)} is not an integer", path=path) from error


def check_class(value: Any, cls: type[Struct], path: str) -> None:
    """Raise `EncodeError` unless `value` is a `cls`."""
    if not isinstance(value, cls):
        raise EncodeError(f"{shown(value)} is not a {cls.__qualname__}", path=path)


def check_keys(data: Any, required: list[str], optional: list[str], path: str) -> None:
    """Raise `EncodeError` unless `data` is a dict with these keys."""
    if not isinstance(data, dict):
        raise EncodeError(f"{shown(data)} is not a mapping with {', '.join(required + optional)}", path=path)
    unknown = [key for key in data if key not in required and key not in optional]
    if unknown:
        known = ", ".join(required + optional) or "no fields"
        raise EncodeError(f"unknown field {shown(unknown[0])}, expected {known}", path=path)
    missing = [key for key in required if key not in data]
    if missing:
        raise EncodeError("a value is required", path=join(path, missing[0]))
