"""The limits of links as they are written: messages by name or id, and rates with their units."""

from __future__ import annotations

import re
from collections.abc import Mapping
from typing import Final

from jauspy.errors import ConfigError
from jauspy.messages import registry
from jauspy.protocol.link_limits import LinkLimit, MessageLimit, TotalLimit

ALL: Final = "all"
"""The key for all traffic of a link."""
VIDEO: Final = "video"
_RANGE: Final = re.compile(r"(0[xX][0-9a-fA-F]{1,4})(?:-(0[xX][0-9a-fA-F]{1,4}))?")
_RATE: Final = re.compile(r"(\d{1,9}(?:\.\d{1,6})?)\s*(/|bit/|kbit/|Mbit/)s")
_UNITS: Final = {"/": 1.0, "bit/": 1.0, "kbit/": 1e3, "Mbit/": 1e6}
_FORMS: Final = 'write messages per second, as in "5/s", or bits per second, as in "250 kbit/s" or "2 Mbit/s"'


def parse_codes(text: str) -> range | None:
    """The message ids of `0x0405` or `0x2000-0x2FFF`; None for any other text, such as a name."""
    found = _RANGE.fullmatch(text)
    if found is None:
        return None
    first = int(found[1], 16)
    return range(first, int(found[2] or found[1], 16) + 1)


def parse_rate(text: str) -> tuple[float, bool]:
    """A rate, and whether it is in bits per second (else in messages per second); raises `ConfigError`."""
    found = _RATE.fullmatch(text.strip())
    rate = float(found[1]) * _UNITS[found[2]] if found is not None else 0.0
    if found is None or rate <= 0.0:
        raise ConfigError(_FORMS)
    return rate, found[2] != "/"


def make_link_limit(table: Mapping[str, str]) -> LinkLimit:
    """The limit of one link; raises `ConfigError` that names the key.

    A key is "all", or a message by its name, its id or a range of ids.
    """
    total, messages = None, []
    for key, text in table.items():
        try:
            if key == ALL:
                total = _total(text)
            else:
                messages.append(_message_limit(key, text))
        except ConfigError as error:
            raise ConfigError(f"{key} = {text!r}: {error}") from None
    return LinkLimit(total, tuple(messages))


def _total(text: str) -> TotalLimit:
    rate, is_bits = parse_rate(text)
    if not is_bits:
        raise ConfigError('all traffic has a rate in bits, as in "250 kbit/s"')
    return TotalLimit(rate, f"{ALL} {text}")


def _message_limit(key: str, text: str) -> MessageLimit:
    if key == VIDEO:
        raise ConfigError(
            "video does not pass the node manager; set `bit_rate` of the cameras in the robot's file, and leave room "
            f'for it in "{ALL}"'
        )
    rate, is_bits = parse_rate(text)
    codes = parse_codes(key) or _codes_of(key)
    return MessageLimit(codes, rate, is_bits, f"{key} {text}")


def _codes_of(name: str) -> range:
    try:
        code = registry.by_name(name).CODE
    except ConfigError as error:
        raise ConfigError(f"{error}; or write its id, as in 0x4403") from None
    return range(code, code + 1)
