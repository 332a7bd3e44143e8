"""`jauspy doctor`: output, JSON, exit status and wrong use; and notes of `jauspy decode` on peers."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from tests.helpers.udp_peer import GROUP, udp_peer
from typer.testing import CliRunner

from jauspy.capture import writer
from jauspy.cli.main import app


def run(*arguments: object):
    return CliRunner().invoke(app, [*map(str, arguments)])


@pytest.fixture
def here(free_port: int, root: Path) -> tuple[object, ...]:
    return "--port", free_port, "--local-root", root, "--interface", "127.0.0.1", "--multicast-group", GROUP


def test_healthy_component(here: tuple[object, ...], free_port: int) -> None:
    with udp_peer(free_port, holder=(42, 1, 7), authority=50):
        done = run("doctor", "101.1.1", *here)
    lines = done.stdout.splitlines()
    assert "ok    component 255: 101.1.1 answers what is sent to 101.1.255" in lines
    assert "warn  control: control of 101.1.1 is held by 42.1.7 with authority 50" in lines
    start = lines.index("warn  control: control of 101.1.1 is held by 42.1.7 with authority 50")
    assert lines[start + 1 : start + 3] == [
        "      seen: a client with 127 takes it over",
        "      fix:  agree with its user first",
    ]


def test_exit_status_json_and_quiet(here: tuple[object, ...], free_port: int) -> None:
    with udp_peer(free_port, ignores_wildcard=True):
        done = run("doctor", "101.1.1", "--json", *here)
    assert done.exit_code == 1
    rows = {row["check"]: row for row in map(json.loads, done.stdout.splitlines())}
    assert rows["component 255"].keys() == {"check", "severity", "what", "evidence", "fix"}
    assert rows["component 255"]["severity"] == "fail"
    quiet = run("doctor", "-q", *here)
    assert quiet.exit_code == 1  # nobody answers
    assert "\nok " not in quiet.stdout


def test_a_local_root_is_named_as_for_other_verbs(root: Path, free_port: int) -> None:
    done = run("doctor", "--connect", f"local:{root}", "--port", free_port, "--interface", "127.0.0.1")
    assert str(root) in done.stdout or "no program" in done.stdout
    assert "Invalid value" not in done.output


def test_wrong_use(here: tuple[object, ...]) -> None:
    assert "is not one component" in run("doctor", "101.1.255").output
    assert "name the component" in run("doctor", "--connect", "udp://127.0.0.1").output
    assert "is not udp://HOST" in run("doctor", "101.1.1", "--connect", "tcp://127.0.0.1", *here).output


def test_decode_notes_peers(tmp_path: Path) -> None:
    path = tmp_path / "run.pcapng"
    priority_0 = bytes.fromhex("02001200ff0101650009016400000102030100")
    blocks = [writer.preamble(), writer.packet(("10.0.0.3", 3794), ("10.0.0.2", 3794), priority_0, 100_000_000_000)]
    path.write_bytes(b"".join(blocks))
    done = run("decode", path)
    assert "10.0.0.3 looks like JAUS Toolset (Junior)" in done.stderr
    assert "Known of JTS: priority 0 is sent with a control byte of FF (J7)" in done.stderr


def test_send_obliges_the_jaus_toolset(root: Path) -> None:
    done = run("send", "101.1.1", "Resume", "--peer", "junior", "--connect", f"local:{root}")
    assert done.exit_code == 1
    assert "choose one of jts, fkie, openjaus" in done.stderr
