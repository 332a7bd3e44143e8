"""`jauspy decode` of what candump wrote: PDOs by the drives of the robot's file, in SI units."""

from __future__ import annotations

from pathlib import Path

import pytest
from typer.testing import CliRunner

pytest.importorskip("can", reason="python-can is not installed")

from jauspy.cli.main import app

LOG = """\
(1700000000.000000) can0 080#
(1700000000.000100) can0 204#0F000800
(1700000000.000200) can0 204#0F000800800200
(1700000000.000300) can0 184#3702000000006400
(1700000000.000400) can0 085#10230300000000
(1700000000.000500) can0 000#0104
(1700000000.000600) can0 77F#05
(1700000000.000700) can0 7FF#DEADBEEF
"""


def test_frames_are_named_by_the_robot(tmp_path: Path) -> None:
    file = tmp_path / "run.log"
    file.write_text(LOG)
    result = CliRunner().invoke(app, ["decode", str(file), "--robot", "inc1"])
    assert result.exit_code == 0, result.output
    lines = [line.split("  ", 2)[2] for line in result.output.splitlines()]
    assert lines == [
        "SYNC",
        "0f 00 08 00",
        "arm_1 (4): command: enable_operation, cyclic_position, target_position 1.5708 rad",
        "arm_1 (4): status: Operation Enabled, position 0.0000 rad, torque 6.000 N m",
        "arm_2 (5): emergency: overcurrent at the output (2310h), error register: generic, current",
        "NMT start: arm_1 (4)",
        "the robot: heartbeat: Operational",
        "de ad be ef",
    ]


def test_a_damaged_line_is_named(tmp_path: Path) -> None:
    file = tmp_path / "run.log"
    file.write_text("(1700000000.0) can0 080#\n(17) can0 nonsense\n")
    result = CliRunner().invoke(app, ["decode", str(file)])
    assert result.exit_code == 1
    assert "run.log: is not a log of CAN frames" in result.output
