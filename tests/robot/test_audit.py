"""The audit log of a robot: what it has, and that nobody changes or cuts it unnoticed."""

from __future__ import annotations

import json
import logging
import os
import threading
from collections.abc import Callable
from contextlib import suppress
from dataclasses import replace
from datetime import UTC, datetime, timedelta
from hashlib import sha256
from itertools import count, islice
from pathlib import Path

import pytest
from hypothesis import given, strategies as st

from jauspy.cli import operators as cli
from jauspy.errors import ConfigError
from jauspy.ids import JausID
from jauspy.messages.core import Resume
from jauspy.messages.operators import ReportSealChallenge
from jauspy.protocol.seal import Operator, OperatorKey
from jauspy.robot.audit import MAX_PAYLOAD, MAX_UNSEALED, MAX_WAITING, AuditLog, Head, head_file, verify
from jauspy.services.core.command_seal import CommandRecord

pytest.importorskip("cryptography", reason="keys of operators need the extra 'operators'")

KEY = OperatorKey.generate()
ALICE = Operator("alice", "operator", 127, KEY.public)
ROBOT, OCU = JausID(101, 1, 102), JausID(42, 1, 1)
START = datetime(2026, 3, 14, 15, 9, 26, tzinfo=UTC)


def record(number: int, *, operator: Operator | None = ALICE, outcome: str = "taken") -> CommandRecord:
    challenge = ReportSealChallenge(1, 2)
    sealed = KEY.seal(Resume(), challenge, destination=ROBOT, source=OCU, elapsed=0.0, counter=number)
    at = START + timedelta(milliseconds=number)
    return CommandRecord(at, ROBOT, OCU, operator, "Resume", sealed.encode(), outcome)


@pytest.fixture
def path(tmp_path: Path) -> Path:
    return tmp_path / "robot.audit"


@pytest.fixture
def write(path) -> Callable[..., None]:
    """Writes a log with so many commands."""

    numbers = count(1)

    def written(commands: int = 5) -> None:
        with AuditLog(path, "inc1") as log:
            for number in islice(numbers, commands):
                log.record(record(number))

    return written


def lines(path: Path) -> list[bytes]:
    return path.read_bytes().splitlines(keepends=True)


def test_what_it_has(path, write):
    write(2)
    started, first, _, closed = map(json.loads, lines(path))
    assert (started["event"], started["robot"], closed["event"]) == ("started", "inc1", "closed")
    assert {name: first[name] for name in ("n", "time", "component", "source", "operator", "role", "message")} == {
        "n": 2,
        "time": "2026-03-14T15:09:26.001000+00:00",
        "component": "101.1.102",
        "source": "42.1.1",
        "operator": "alice",
        "role": "operator",
        "message": "Resume",
    }
    assert path.stat().st_mode & 0o777 == 0o600


def test_a_whole_log(path, write):
    write()
    write()
    report = verify(path, operators=[ALICE])
    assert (report.problem, report.head.number) == ("", 14)
    assert (dict(report.commands), report.refused, report.verified) == ({"alice": 10}, 0, 10)


@pytest.mark.parametrize("number", range(1, 8))
def test_a_line_that_was_changed_is_named(path, write, number):
    write()
    changed = lines(path)
    changed[number - 1] = changed[number - 1].replace(b'"time": "2', b'"time": "3')
    path.write_bytes(b"".join(changed))
    assert verify(path).problem.startswith(f"line {number} was changed")


@pytest.mark.parametrize(("first", "last"), [(1, 1), (1, 3), (3, 4), (6, 6)])
def test_lines_that_were_removed_are_named(path, write, first, last):
    write()
    left = lines(path)
    del left[first - 1 : last]
    path.write_bytes(b"".join(left))
    assert verify(path).problem == f"lines {first} to {last} were removed"


@pytest.mark.parametrize("left", range(7))
def test_lines_that_were_cut_off_are_named(path, write, left):
    write()
    path.write_bytes(b"".join(lines(path)[:left]))
    assert verify(path).problem == f"lines {left + 1} to 7 were cut off at the end"


def test_lines_that_were_cut_off_before_a_restart_are_named(path, write):
    write()
    path.write_bytes(b"".join(lines(path)[:3]))
    write()
    assert verify(path).problem.startswith("lines were cut off before line 4: the head was '7:")


def test_lines_that_were_added_are_named(path, write):
    write()
    copied = lines(path)
    copied.insert(3, copied[2])
    path.write_bytes(b"".join(copied))
    assert verify(path).problem == "line 4 was changed"


@pytest.mark.parametrize("restarted", [False, True])
def test_lines_that_were_appended_after_the_head_was_saved_are_named(path, write, restarted):
    write()
    report = verify(path)
    forged = {
        "n": report.head.number + 1,
        "time": "2026-11-22",
        "message": "SetEmergency",
        "previous": report.head.hash,
    }
    with path.open("a") as stream:
        stream.write(json.dumps(forged) + "\n")
    if restarted:
        with AuditLog(path, "inc1"):
            pass
    number = report.head.number
    assert f"lines {number + 1} to {number + 1} follow the line of the head file" in verify(path).problem


def test_without_its_head_a_cut_is_not_excluded(path, write):
    write()
    head_file(path).unlink()
    assert "no head file" in verify(path).problem


def rewrite(path: Path, left: int) -> None:
    """What an attacker with the whole disk can do: cut lines off, and set the head accordingly."""
    path.write_bytes(b"".join(lines(path)[:left]))
    report = verify(path)
    head_file(path).write_text(f"{report.head}\n")


def test_who_rewrites_everything_is_found_by_a_head_that_was_noted(path, write):
    write()
    noted = verify(path).head
    rewrite(path, 4)
    assert verify(path).problem == ""
    assert verify(path, [noted]).problem == "lines 5 to 7 were cut off at the end"
    write()
    assert "line 7 was changed" in verify(path, [noted]).problem


def test_who_rewrites_everything_cannot_invent_commands_of_an_operator(path):
    mallory = Operator("alice", "operator", 127, OperatorKey.generate().public)
    with AuditLog(path, "inc1") as log:
        log.record(record(1))
    assert verify(path, operators=[ALICE]).problem == ""
    assert "'alice' has not sealed" in verify(path, operators=[mallory]).problem
    with AuditLog(path, "inc1") as log:
        log.record(replace(record(2), payload=Resume().encode()))
    assert verify(path, operators=[ALICE]).problem.startswith("line 5 was not written by the robot")
    with AuditLog(path.with_name("other"), "inc1") as log:
        log.record(replace(record(2), message="Shutdown"))
    assert "'alice' has not sealed" in verify(path.with_name("other"), operators=[ALICE]).problem


def test_who_rewrites_everything_cannot_repeat_commands_of_an_operator(path):
    with AuditLog(path, "inc1") as log:
        for number in (1, 3, 2):
            log.record(record(number))
    assert verify(path, operators=[ALICE]).problem == ""
    with AuditLog(path, "inc1") as log:
        log.record(record(2))
    assert verify(path, operators=[ALICE]).problem.startswith("line 7 was not written by the robot: 'alice' has sealed")


def test_a_line_that_was_torn_by_a_power_failure(path, write):
    write()
    with path.open("ab") as stream:
        stream.write(b'{"n": 8, "ti')
    assert verify(path).problem == ""
    write(1)
    assert json.loads(lines(path)[7])["torn"] == b'{"n": 8, "ti'.hex()
    assert verify(path).problem == ""


def test_two_robots_need_two_logs(path, write):
    with AuditLog(path, "inc1"), pytest.raises(ConfigError, match="another robot"), AuditLog(path, "inc2"):
        pass
    write()


def test_a_folder_that_is_not_there(tmp_path):
    with pytest.raises(ConfigError, match="No such file"), AuditLog(tmp_path / "none" / "log", "inc1"):
        pass


def test_what_anybody_can_cause_is_bounded(path):
    with AuditLog(path, "inc1") as log:
        for number in range(1, 101):
            log.record(record(number, operator=None, outcome="refused: NO_SEAL"))
        log.record(record(101))
    report = verify(path)
    assert dict(report.commands) == {"-": MAX_UNSEALED, "alice": 1}
    assert (report.refused, report.not_recorded) == (MAX_UNSEALED, 100 - MAX_UNSEALED)


def test_of_large_messages_the_hash_is_kept(path):
    with AuditLog(path, "inc1") as log:
        log.record(replace(record(1), payload=bytes(MAX_PAYLOAD + 1)))
    entry = json.loads(lines(path)[1])
    assert (entry["sha256"], "payload" in entry) == (sha256(bytes(MAX_PAYLOAD + 1)).hexdigest(), False)
    report = verify(path, operators=[ALICE])
    assert (report.problem, report.verified, report.unverifiable) == ("", 0, 1)


def test_a_disk_that_hangs_stops_nobody(path, monkeypatch):
    free = threading.Event()
    real = os.fsync
    with AuditLog(path, "inc1") as log:
        monkeypatch.setattr(os, "fsync", lambda file: free.wait(30) and real(file))
        same = record(1)
        for _ in range(MAX_WAITING * 2 + 99):
            log.record(same)
        assert log.counters["lost"] >= 99
        free.set()
    report = verify(path)
    assert (report.problem, report.not_recorded) == ("", log.counters["lost"])
    assert report.commands["alice"] + report.not_recorded == MAX_WAITING * 2 + 99


def test_a_full_disk_is_reported_and_survived(path, monkeypatch, caplog):
    real = os.pwrite
    with AuditLog(path, "inc1") as log, caplog.at_level(logging.ERROR, "jauspy.audit"):
        monkeypatch.setattr(os, "pwrite", lambda file, data, at: real(file, data[: len(data) // 2], at))
        log.record(record(1))
        for _ in range(1000):
            if log.counters["not_written"]:
                break
            threading.Event().wait(0.01)
        monkeypatch.setattr(os, "pwrite", real)
        log.record(record(2))
    assert "No space left" in caplog.text
    report = verify(path)
    assert (report.problem, report.commands["alice"], report.not_recorded) == ("", 1, 1)


@given(st.binary(max_size=60), st.integers(0, 3000), st.booleans())
def test_any_bytes_are_verified_without_an_error(tmp_path_factory, noise, at, overwrite):
    path = LOG.setdefault("path", tmp_path_factory.mktemp("log") / "log")
    if "text" not in LOG:
        with AuditLog(path, "inc1") as log:
            for number in range(5):
                log.record(record(number + 1))
        LOG["text"] = path.read_bytes()
    text = LOG["text"]
    at = min(at, len(text))
    damaged = text[:at] + noise + text[at + len(noise) * overwrite :]
    path.write_bytes(damaged)
    problem = verify(path, operators=[ALICE]).problem
    assert problem or damaged.startswith(text)


LOG: dict[str, object] = {}


@pytest.mark.parametrize("operator", [["alice"], {"a": 1}, 7, True, "bob\x1b[2J"])
def test_lines_with_other_values(path, write, operator, capsys):
    """Those of somebody who writes the whole chain anew."""
    entry = {"n": 1, "previous": "0" * 64, "message": 7, "operator": operator, "payload": 7, "outcome": []}
    path.write_text(json.dumps(entry) + "\n")
    head_file(path).write_text(str(Head(1, sha256(path.read_bytes()[:-1]).hexdigest())))
    assert verify(path, operators=[ALICE]).problem
    with suppress(ConfigError):
        cli.audit(path=path)
    assert "\x1b" not in capsys.readouterr().out


def test_the_verb(path, write, capsys, tmp_path):
    write()
    (tmp_path / "operators.toml").write_text(f'[operators]\nalice = {{ role = "operator", key = "{KEY.public}" }}\n')
    cli.audit(path=path, operators=tmp_path / "operators.toml")
    reported = capsys.readouterr().out
    assert "7 lines; commands: 5 of alice; 0 refused" in reported
    assert "5 verified" in reported
    head = reported.rpartition("head: ")[2].strip()
    write()
    cli.audit(path=path, head=[head])
    with pytest.raises(ConfigError, match="line 7 was changed"):
        cli.audit(path=path, head=[str(Head(7, "0" * 64))])
    with pytest.raises(ConfigError, match="NUMBER:HASH"):
        cli.audit(path=path, head=["7"])
    with pytest.raises(ConfigError, match="cannot be read"):
        cli.audit(path=tmp_path / "none")
