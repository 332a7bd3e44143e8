"""The pictures of docs/console.md, which tools/console_screenshots.py makes."""

from __future__ import annotations

import re
from itertools import product

from tests.helpers.documentation import DOCS

PICTURES = {
    f"console_{panel}_{scheme}_{size}.jpg"
    for panel, scheme, size in product(
        ("video", "world", "trajectory", "plots", "log", "cell"), ("light", "dark"), ("1440x900", "1024x768")
    )
} | {
    f"console_{preset}_{scheme}_1440x900.jpg"
    for preset, scheme in product(("drive", "arm", "observe"), ("light", "dark"))
}


def test_the_guide_shows_every_picture_and_each_is_small() -> None:
    shown = set(re.findall(r"assets/(console_\w+\.jpg)", (DOCS / "console.md").read_text()))
    assert shown == PICTURES
    for name in PICTURES:
        assert (DOCS / "assets" / name).stat().st_size < 250_000
