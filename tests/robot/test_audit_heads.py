"""Heads of an audit log on another machine: they are sent without delaying the robot, and found again there."""

from __future__ import annotations

import socket
from collections.abc import Iterator
from pathlib import Path
from typing import Final

import pytest

from jauspy.cli import operators as cli
from jauspy.errors import ConfigError
from jauspy.robot.audit import AuditLog, head_file, verify
from jauspy.robot.audit_heads import HeadSender, collected_heads

INTERVAL: Final = 0.001


@pytest.fixture
def udp() -> Iterator[socket.socket]:
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as receiver:
        receiver.bind(("127.0.0.1", 0))
        receiver.settimeout(10.0)
        yield receiver


@pytest.fixture
def tcp() -> Iterator[socket.socket]:
    with socket.create_server(("127.0.0.1", 0)) as server:
        server.settimeout(10.0)
        yield server


def _write(path: Path, url: str, robot: str = "inc1") -> HeadSender:
    with HeadSender(url, interval=INTERVAL) as sender, AuditLog(path, robot, heads=sender) as log:
        log.note({"event": "a login"})
    return sender


def _collected(receiver: socket.socket, path: Path) -> Path:
    """What came until the last head of the log, as the file of a syslog."""
    lines: list[bytes] = []
    while not lines or str(verify(path).head).encode() not in lines[-1]:
        lines.append(receiver.recv(65535))
    file = path.with_name("syslog")
    file.write_bytes(b"".join(b"Nov 23 23:00:00 robot " + line + b"\n" for line in lines))
    return file


def test_heads_that_were_sent_verify_a_log(tmp_path: Path, udp: socket.socket) -> None:
    path = tmp_path / "log"
    sender = _write(path, f"syslog://127.0.0.1:{udp.getsockname()[1]}")
    assert not verify(path, heads=_collected(udp, path)).problem
    assert sender.counters["heads_sent"] >= 1
    assert not sender.counters["heads_not_sent"]


def test_a_log_that_was_cut_with_its_head_is_found(tmp_path: Path, udp: socket.socket) -> None:
    path = tmp_path / "log"
    _write(path, f"syslog://127.0.0.1:{udp.getsockname()[1]}")
    file = _collected(udp, path)
    path.write_bytes(path.read_bytes().splitlines(keepends=True)[0])
    head_file(path).write_text(f"{verify(path).head}\n")
    assert not verify(path).problem
    assert verify(path, heads=file).problem == "lines 2 to 3 were cut off at the end"


def test_a_log_that_was_written_anew_is_found(tmp_path: Path, udp: socket.socket) -> None:
    path = tmp_path / "log"
    _write(path, f"syslog://127.0.0.1:{udp.getsockname()[1]}")
    file = _collected(udp, path)
    path.unlink()
    head_file(path).unlink()
    with AuditLog(path, "inc1"):
        pass
    assert not verify(path).problem
    with pytest.raises(ConfigError, match="no head of this log, and has those of 1 others"):
        cli.audit(path=path, heads=file)


def test_heads_of_other_logs_and_noise_are_passed_over(tmp_path: Path, udp: socket.socket) -> None:
    path = tmp_path / "log"
    _write(path, f"syslog://127.0.0.1:{udp.getsockname()[1]}")
    file = _collected(udp, path)
    other = b"jauspy-audit log=" + b"1" * 64 + b" head=2:" + b"2" * 64
    file.write_bytes(b"\xff\x00" * 9000 + b"\n" + other + b"\n" + file.read_bytes())
    assert not verify(path, heads=file).problem


def test_a_forged_head_is_named(tmp_path: Path, udp: socket.socket) -> None:
    path = tmp_path / "log"
    _write(path, f"syslog://127.0.0.1:{udp.getsockname()[1]}")
    file = _collected(udp, path)
    head = str(verify(path).head).encode()
    file.write_bytes(file.read_bytes() + file.read_bytes().replace(head, head[:2] + b"0" * 64))
    assert "the heads of line 3 differ" in verify(path, heads=file).problem


def test_heads_are_sent_by_tcp(tmp_path: Path, tcp: socket.socket) -> None:
    path = tmp_path / "log"
    _write(path, f"syslog+tcp://127.0.0.1:{tcp.getsockname()[1]}")
    connection, _ = tcp.accept()
    with connection, connection.makefile("rb") as stream:
        text = stream.read()
    assert text.endswith(f"head={verify(path).head}\n".encode())
    assert text.startswith(b"<110>1 20")


def test_a_machine_that_is_not_there_delays_nothing(tmp_path: Path, tcp: socket.socket) -> None:
    url = f"syslog+tcp://127.0.0.1:{tcp.getsockname()[1]}"
    tcp.close()
    sender = _write(tmp_path / "log", url)
    assert sender.counters["heads_not_sent"]
    assert verify(tmp_path / "log").head.number == 3


@pytest.mark.parametrize(
    "url", ["host:514", "http://host", "syslog://", "syslog://host:99999", "syslog://host/x", "syslog://[::1", ""]
)
def test_what_is_no_address(url: str) -> None:
    with pytest.raises(ConfigError, match="is not syslog://HOST:PORT"):
        HeadSender(url)


def test_files_without_heads(tmp_path: Path) -> None:
    with pytest.raises(ConfigError, match="cannot be read: No such file"):
        collected_heads(tmp_path / "none", "0" * 64)
    with pytest.raises(ConfigError, match="is not a regular file"):
        collected_heads(tmp_path, "0" * 64)
