"""`jauspy decode` of what candump wrote: PDOs by the drives of the robot's file, in SI units."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from typer.testing import CliRunner

pytest.importorskip("can", reason="python-can is not installed")

from jauspy.capture.writer import packet, preamble
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
    lines = [line.split("  ")[-1] for line in result.output.splitlines()]
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


DATAGRAM = bytes.fromhex("02001000010a017e0014017e0002200200")


def listing(tmp_path: Path, *options: str) -> list[str]:
    log, capture = tmp_path / "bus.log", tmp_path / "run.pcapng"
    log.write_text(LOG)
    times = (1_700_000_000_000_050_000, 1_700_000_000_000_250_000)
    blocks = [packet(("10.0.0.1", 3794), ("10.0.0.2", 3794), DATAGRAM, time) for time in times]
    capture.write_bytes(preamble() + b"".join(blocks))
    result = CliRunner().invoke(app, ["decode", str(capture), str(log), *options])
    assert result.exit_code == 0, result.output
    return result.output.splitlines()


def test_datagrams_and_frames_are_one_listing_by_time(tmp_path: Path) -> None:
    rows = [json.loads(line) for line in listing(tmp_path, "--json")]
    kinds = ["JAUS" if "messages" in row else row["can_id"] for row in rows]
    assert kinds == ["080", "JAUS", "204", "204", "JAUS", "184", "085", "000", "77F", "7FF"]
    assert rows[3]["text"].startswith("arm_1 (4): command: enable_operation")
    lines = [line for line in listing(tmp_path) if " s  " in line]
    assert "0.000050 s  10.0.0.1 → 10.0.0.2" in lines[1]
    assert "0.000200 s  can0 204  arm_1 (4): command: enable_operation" in lines[3]


def test_hex_text_has_no_times(tmp_path: Path) -> None:
    (tmp_path / "bus.log").write_text(LOG)
    result = CliRunner().invoke(app, ["decode", str(tmp_path / "bus.log"), DATAGRAM.hex()])
    assert result.exit_code == 1
    assert "hex text has no times; list only captures" in result.output


def test_changes_leave_out_what_only_moves_on(tmp_path: Path) -> None:
    file = tmp_path / "run.log"
    commands = [f"0F0008{counts:08X}" for counts in (0, 0x10000000, 0x20000000)] + ["02000820000000"]
    file.write_text("".join(f"(17{number}.0) can0 204#{data}\n" for number, data in enumerate(commands)))
    result = CliRunner().invoke(app, ["decode", str(file), "--changes"])
    said = [line.split("  ")[-1] for line in result.output.splitlines()]
    assert [each.split(",")[0] for each in said] == [
        "arm_1 (4): command: enable_operation",
        "arm_1 (4): command: enable_operation",
        "arm_1 (4): command: quick_stop",
    ]
