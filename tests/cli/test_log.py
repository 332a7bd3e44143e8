"""`jauspy log`: shows and switches the log that a robot keeps."""

from __future__ import annotations

import json

import pytest
from tests.helpers.command_line import jauspy, shared_robot


@pytest.mark.slow
def test_log_is_switched_and_shown():
    with shared_robot() as robot:
        where = ("--connect", robot.local, "--json")
        before = json.loads(jauspy("log", "101", *where).stdout)
        assert (before["logger"], before["state"]) == (1, "off")
        on = json.loads(jauspy("log", "101", "on", "--level", "critical", "--size", "10", *where).stdout)
        assert (on["state"], on["levels"], on["limit"]) == ("on", ["critical"], 10)
        text = jauspy("log", "101", "off", "--connect", robot.local).stdout
        assert text.startswith("logger 1: off; it records critical\n")
        assert "of 10 MB" in text
        refused = jauspy("log", "101", "--size", "2000", "--connect", robot.local, status=1).stderr
        assert "refuses these settings of logger 1: overflow policy unsupported" in refused
