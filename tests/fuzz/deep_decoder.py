"""A decoder with a mistake behind five comparisons, which random bytes hardly ever pass all at once."""

from __future__ import annotations


def decode(data: bytes) -> int:
    """Fail for bytes 2 to 6 with these values; each comparison is a line of its own."""
    body = data[2:]
    if len(body) < 6:
        return 0
    if body[0] != 0x7F:
        return 1
    if body[1] != 0xFF:
        return 2
    if body[2] != 0x80:
        return 3
    if body[3] != 0x01:
        return 4
    if body[4] != 0x7F:
        return 5
    raise ZeroDivisionError("deep")
