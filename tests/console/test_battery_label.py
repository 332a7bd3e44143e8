"""The battery in the console's bar: what it says for each report."""

from __future__ import annotations

from datetime import UTC, datetime

import pytest

pytest.importorskip("nicegui", reason="needs the extra 'console'")

from jauspy.console.panels.battery import battery_text
from jauspy.ocu.state import BatteryReport

NOW = datetime(2026, 1, 1, tzinfo=UTC)


@pytest.mark.parametrize(
    ("report", "text", "level"),
    [
        (BatteryReport(0.874, 33.14, 4.0, None, NOW), "battery  87 %  33.1 V  133 W", "good"),
        (BatteryReport(0.15, 26.0, 2.0, 40.0, NOW), "\u26a0 battery  15 %  26.0 V  52 W", "low"),
        (BatteryReport(0.0, 0.0, 0.0, None, NOW), "\u2716 battery  0 %  0.0 V  0 W", "empty"),
        (BatteryReport(None, None, None, None, NOW), "battery", "unknown"),
        (BatteryReport(None, 24.0, None, None, NOW), "battery  24.0 V", "unknown"),
    ],
)
def test_text_and_level(report: BatteryReport, text: str, level: str) -> None:
    assert battery_text(report) == (text, level)
