"""Lines of keys in TOML files."""

from __future__ import annotations

import pytest

from jauspy.config_errors import line_of

TEXT = """\
name = "crane"

[can]
bit_rate = 5   # line 4
[can.drives]
boom = { node = 1, joint = "boom" }
[can.drives."left.track"]
node = 2
[[cameras]]
name = "arm"
[[cameras]]
name = "mast"
[cameras.lens]
fov = 9
"""


@pytest.mark.parametrize(
    ("keys", "line"),
    [
        (("name",), 1),
        (("can", "bit_rate"), 4),
        (("can", "drives", "boom", "node"), 6),
        (("can", "drives", "left.track", "node"), 8),
        (("can", "drives", "left.track", "encoder_counts"), 7),
        (("cameras", 0, "name"), 10),
        (("cameras", 1, "lens", "fov"), 14),
        (("can", "drives", "hook"), 5),
        (("modules", 3), None),
    ],
)
def test_line_of_a_key(keys: tuple[str | int, ...], line: int | None) -> None:
    assert line_of(TEXT, keys) == line
