"""The colours of the console's theme can be read: contrast of WCAG 2.1, level AA."""

from __future__ import annotations

import re
from importlib.resources import files

import pytest

TEXTS = ("text", "quiet", "accent", "ready", "standby", "emergency", "failure", "other")
TEXT_CONTRAST = 4.5
"""Of text smaller than 24 px (1.4.3)."""
FIELD_CONTRAST = 3.0
"""Of what shows where a field is (1.4.11)."""


def colours(selector: str) -> dict[str, str]:
    theme = (files("jauspy.console") / "static" / "theme.css").read_text()
    block = re.search(re.escape(selector) + r" \{([^}]*)\}", theme)
    assert block is not None
    return dict(re.findall(r"--([\w-]+): (#\w{6})", block[1]))


def luminance(colour: str) -> float:
    parts = (int(colour[at : at + 2], 16) / 255.0 for at in (1, 3, 5))
    red, green, blue = (each / 12.92 if each <= 0.03928 else ((each + 0.055) / 1.055) ** 2.4 for each in parts)
    return 0.2126 * red + 0.7152 * green + 0.0722 * blue


def contrast(one: str, other: str) -> float:
    dark, light = sorted((luminance(one), luminance(other)))
    return (light + 0.05) / (dark + 0.05)


@pytest.mark.parametrize("scheme", [":root", "body.body--dark"])
def test_texts_and_fields_can_be_read(scheme: str) -> None:
    theme = colours(scheme)
    pairs = [(text, ground, TEXT_CONTRAST) for text in TEXTS for ground in ("panel", "background")]
    pairs += [("on-accent", "accent", TEXT_CONTRAST), ("on-accent", "quiet", TEXT_CONTRAST)]
    pairs += [("field", "panel", FIELD_CONTRAST)]
    found = {f"{text} on {ground}": contrast(theme[text], theme[ground]) - least for text, ground, least in pairs}
    found["white on a button"] = contrast("#ffffff", theme["primary"]) - TEXT_CONTRAST
    assert not [name for name, margin in found.items() if margin < 0.0]


def test_the_measure_is_that_of_the_standard() -> None:
    assert contrast("#000000", "#ffffff") == pytest.approx(21.0)
    assert contrast("#777777", "#ffffff") == pytest.approx(4.48, abs=0.01)
