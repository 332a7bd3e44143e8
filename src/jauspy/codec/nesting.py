"""Messages inside messages: who knows them, and how deep they are."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, Protocol

from jauspy.codec.base import FAST_ERRORS, MAX_NESTING, Message
from jauspy.errors import EncodeError


class Source(Protocol):
    """What knows the messages: a registry."""

    @property
    def nesting(self) -> Nesting:
        """Its own, for messages that are in no other one."""

    def class_of(self, data: bytes) -> type[Message] | None:
        """The class these bytes begin like; None when it is unknown, or when there are several."""

    def message_from(self, data: Mapping[str, Any], nesting: Nesting, path: str) -> Message:
        """The inverse of `message_to_dict`; raises `EncodeError`."""


class Nesting:
    """What a message that is read knows about those inside it."""

    __slots__ = ("_inner", "_source")

    def __init__(self, source: Source, depth: int = 0) -> None:
        self._source = source
        self._inner = Nesting(source, depth + 1) if depth < MAX_NESTING else None

    def message(self, data: bytes) -> Message | bytes:
        """The message inside when it decodes strictly and encodes to the same bytes, else the bytes."""
        if self._inner is None:
            return data
        cls = self._source.class_of(data)
        if cls is None:
            return data
        try:
            message = cls._unpack(data, self._inner)
            return message if message._pack() == data else data  # noqa: SLF001 - the fast road
        except FAST_ERRORS:
            return data

    def from_dict(self, data: Mapping[str, Any], path: str) -> Message:
        """The message inside; raises `EncodeError`, also for what is too deep to be encoded."""
        if self._inner is None:
            raise EncodeError(f"messages are nested more than {MAX_NESTING} deep", path=path)
        return self._source.message_from(data, self._inner, path)
