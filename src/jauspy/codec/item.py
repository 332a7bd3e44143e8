"""What every layout item can do, and the checks they share."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Mapping
from operator import index
from typing import Any, Protocol

from jauspy.codec.base import Message, Struct
from jauspy.codec.streams import Reader, Writer
from jauspy.errors import EncodeError


class Nesting(Protocol):
    """What knows the messages inside messages: a registry."""

    def nested(self, data: bytes, depth: int) -> Message | bytes:
        """The message these bytes are, or the bytes."""

    def from_dict(self, data: Mapping[str, Any]) -> Message:
        """The inverse of `message_to_dict`."""


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

    def from_json(self, data: Any, path: str) -> Any:  # noqa: ARG002 - others need the path
        """The inverse of `to_json`; numbers and strings are checked when they are encoded."""
        return data


def number_of(value: Any, path: str) -> float:
    """A finite float, or `EncodeError`."""
    if isinstance(value, (str, bytes, bytearray)):
        raise EncodeError(f"{value!r} is not a number", path=path)
    try:
        number = float(value)
    except (TypeError, ValueError, OverflowError) as error:
        raise EncodeError(f"{value!r} is not a number", path=path) from error
    return number


def integer_of(value: Any, path: str) -> int:
    """An int, or `EncodeError`."""
    try:
        return index(value)
    except TypeError as error:
        raise EncodeError(f"{value!r} is not an integer", path=path) from error


def check_class(value: Any, cls: type[Struct], path: str) -> None:
    """Raise `EncodeError` unless `value` is a `cls`."""
    if not isinstance(value, cls):
        raise EncodeError(f"{value!r} is not a {cls.__qualname__}", path=path)


def check_keys(data: Any, required: list[str], optional: list[str], path: str) -> None:
    """Raise `EncodeError` unless `data` is a dict with these keys."""
    if not isinstance(data, dict):
        raise EncodeError(f"{data!r} is not a mapping with {', '.join(required + optional)}", path=path)
    unknown = [key for key in data if key not in required and key not in optional]
    if unknown:
        known = ", ".join(required + optional) or "no fields"
        raise EncodeError(f"unknown field {unknown[0]!r}, expected {known}", path=path)
    missing = [key for key in required if key not in data]
    if missing:
        raise EncodeError("a value is required", path=join(path, missing[0]))
