"""Hexadecimal text as people paste it."""

import pytest

from jauspy.capture.reader import from_hex, from_lines
from jauspy.errors import ConfigError


@pytest.mark.parametrize("text", ["02001f", "02 00 1F", "02:00:1f", "0x02001f", "0x02, 0x00, 0x1f", "02-00-1f\n"])
def test_all_forms_of_hex_are_parsed(text):
    assert from_hex(text) == b"\x02\x00\x1f"


def test_zero_before_x_inside_a_number_is_a_digit():
    with pytest.raises(ConfigError, match="'x'"):
        from_hex("020x1f")


@pytest.mark.parametrize(("text", "what"), [("020", "odd number"), ("0g", "'g'"), (" ", "no hexadecimal digits")])
def test_invalid_hex_raises_a_config_error(text, what):
    with pytest.raises(ConfigError, match=what):
        from_hex(text)


def test_line_numbers_are_kept():
    assert from_lines("# capture\n\n02 00\n  # x\n0003 # y\n") == [(3, b"\2\0"), (5, b"\0\3")]


def test_invalid_line_is_named():
    with pytest.raises(ConfigError, match="line 2"):
        from_lines("02\n0z\n")
