"""Bytes written as hexadecimal text, the way people paste them."""

from __future__ import annotations

import re

from jauspy.errors import ConfigError

_SEPARATORS = re.compile(r"[\s:,_-]+|\b0[xX]")


def from_hex(text: str) -> bytes:
    """The bytes of `"02 00:11"`, `"0x02, 0x00"` or `"020011"`; `ConfigError` says what is wrong."""
    digits = _SEPARATORS.sub("", text)
    wrong = re.search(r"[^0-9a-fA-F]", digits)
    if wrong:
        raise ConfigError(f"{wrong.group()!r} in {_short(text)!r} is not a hexadecimal digit")
    if not digits:
        raise ConfigError("there are no hexadecimal digits")
    if len(digits) % 2:
        raise ConfigError(f"{_short(text)!r} has an odd number of hexadecimal digits ({len(digits)}); a byte has two")
    return bytes.fromhex(digits)


def from_lines(text: str) -> list[tuple[int, bytes]]:
    """Each line's number and bytes; empty lines and what follows a `#` are left out."""
    found = []
    for number, line in enumerate(text.splitlines(), 1):
        content = line.partition("#")[0].strip()
        if not content:
            continue
        try:
            found.append((number, from_hex(content)))
        except ConfigError as error:
            raise ConfigError(f"line {number}: {error}") from None
    return found


def _short(text: str) -> str:
    return text if len(text) <= 40 else text[:37] + "..."
