"""Helpers of straight-line code: packers by presence mask, and bytes out of values."""

from __future__ import annotations

from enum import IntEnum
from struct import Struct
from typing import TypeVar

from jauspy.codec.base import Message, Reject
from jauspy.codec.wire import compact

E = TypeVar("E", bound=IntEnum)

MOST_MASKS = 1024
"""Masks whose packers are kept; a peer that sends all of 2**15 masks must not fill the memory."""


class Masks(dict[int, Struct]):
    """The packers of a run of fields behind a presence vector, made when a mask first occurs.

    Each code comes with its presence bit, 0 for fields that are always there; `head` are codes before the run.
    """

    def __init__(self, head: str, codes: tuple[tuple[int, str], ...]) -> None:
        super().__init__()
        self._head = head
        self._codes = codes

    def __missing__(self, mask: int) -> Struct:
        if len(self) >= MOST_MASKS:
            self.clear()
        present = "".join(code for bit, code in self._codes if not bit or mask & bit)
        packer = Struct(f"<{self._head}{compact(present)}")
        self[mask] = packer
        return packer


def members(enum: type[E]) -> dict[int, E]:
    """The members of an enumeration by value; looking them up costs less than a call of the class."""
    return {member.value: member for member in enum}


def plain_bytes(value: object) -> bytes:
    """The bytes of a field that takes nothing else."""
    if isinstance(value, (bytes, bytearray, memoryview)):
        return bytes(value)
    raise Reject


def message_bytes(value: object) -> bytes:
    """The bytes of a message, or bytes as they are."""
    return value._pack() if isinstance(value, Message) else plain_bytes(value)  # noqa: SLF001 - the fast road
