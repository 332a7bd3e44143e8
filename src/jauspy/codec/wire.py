"""Number types on the wire: `struct` codes, sizes and limits. Everything in JAUS is little-endian."""

from __future__ import annotations

import re
import struct
from itertools import groupby
from typing import TYPE_CHECKING, Final

if TYPE_CHECKING:  # the loader behind `jauspy.schema` is heavy, and messages do not need it
    from jauspy.schema.model import Scalar

CODES: Final[dict[Scalar, str]] = {
    "u8": "B",
    "u16": "H",
    "u32": "I",
    "u64": "Q",
    "i8": "b",
    "i16": "h",
    "i32": "i",
    "i64": "q",
    "f32": "f",
    "f64": "d",
}
SIZES: Final[dict[str, int]] = {"B": 1, "H": 2, "I": 4, "Q": 8, "b": 1, "h": 2, "i": 4, "q": 8, "f": 4, "d": 8}
FLOATS: Final = frozenset("fd")


def limits(code: str) -> tuple[int, int]:
    """The smallest and largest value of an integer code."""
    bits = 8 * SIZES[code]
    return (0, 2**bits - 1) if code.isupper() else (-(2 ** (bits - 1)), 2 ** (bits - 1) - 1)


def as_sent(number: float, code: str) -> float:
    """The number as it is after a journey in this type: a limit written in decimals is meant for what can be sent."""
    rounded: float = struct.unpack(f"<{code}", struct.pack(f"<{code}", number))[0]
    return rounded


def compact(codes: str) -> str:
    """`BBBH` to `3BH`; counted codes such as `80s` stay."""
    parts = re.findall(r"\d+[sx]|[a-zA-Z]", codes)
    grouped = [(part, len(list(same))) for part, same in groupby(parts)]
    return "".join(part * n if part[0].isdigit() else f"{n}{part}" if n > 1 else part for part, n in grouped)
