"""`jauspy health`: what it prints, and its exit status."""

from __future__ import annotations

import json
from datetime import UTC, datetime

import pytest
from typer.testing import CliRunner

from jauspy.cli import health as verb
from jauspy.cli.main import app
from jauspy.ocu import BatteryReport, HealthReport

NOW = datetime(2026, 1, 1, tzinfo=UTC)
BATTERY = BatteryReport(0.5, 30.0, 2.0, None, NOW)
WELL = HealthReport(102, "urn:jaus:jss:mobility:PrimitiveDriver", "NONE", "NONE", "drives work", NOW)
HOT = HealthReport(104, "urn", "WARN", "ACTUATOR", "the motor of arm_2 has 95 degrees Celsius", None)


@pytest.fixture
def asked(monkeypatch):
    found: list[tuple[BatteryReport | None, list[HealthReport], int]] = []

    async def ask(own_id, connect, subsystem):
        return found[0]

    monkeypatch.setattr(verb, "_ask", ask)
    return found


@pytest.mark.parametrize(("entries", "status"), [([WELL], 0), ([HOT, WELL], 1), ([], 0)])
def test_the_exit_status_says_whether_somebody_must_act(asked, entries, status):
    asked.append((BATTERY, entries, 1))
    result = CliRunner().invoke(app, ["health", "101"])
    assert result.exit_code == status
    assert "battery: 50.0 %, 30.0 V, 2.0 A, 60.0 W" in result.stdout
    for entry in entries:
        assert entry.text in result.stdout
        assert f"101.1.{entry.component}  {entry.text}" in result.stdout


def test_json_lines(asked):
    asked.append((BATTERY, [HOT], 1))
    result = CliRunner().invoke(app, ["health", "101", "--json"])
    battery, entry = map(json.loads, result.stdout.splitlines())
    assert battery["battery"]["charge"] == 0.5
    assert (entry["id"], entry["severity"], entry["time"]) == ("101.1.104", "WARN", None)


def test_an_empty_battery_is_shown_as_such(asked):
    asked.append((BatteryReport(0.0, 0.0, 0.0, None, NOW), [], 0))
    assert "battery: 0.0 %, 0.0 V, 0.0 A, 0.0 W" in CliRunner().invoke(app, ["health", "101"]).stdout
