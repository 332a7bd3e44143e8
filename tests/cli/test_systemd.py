"""The unit for systemd, and what the node manager tells systemd while it runs."""

import contextlib
import os
import re
import shutil
import signal
import socket
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest

UNIT = Path(__file__).resolve().parents[2] / "examples/jauspy-node-manager.service"
VERIFY = ["systemd-analyze", "verify"]
COMMAND = [sys.executable, "-m", "jauspy.cli.main", "node-manager"]
WATCHDOG = 0.2


def test_unit_passes_systemd_analyze(tmp_path: Path) -> None:
    """With the program at a place where it is."""
    if shutil.which("systemd-analyze") is None:
        pytest.skip("needs systemd-analyze")
    unit = tmp_path / UNIT.name
    unit.write_text(re.sub(r"^ExecStart=\S+", f"ExecStart={sys.executable}", UNIT.read_text(), flags=re.M))
    done = subprocess.run([*VERIFY, str(unit)], capture_output=True, text=True, check=False, timeout=60)
    reported = [line for line in (done.stdout + done.stderr).splitlines() if UNIT.name in line]
    assert (done.returncode, reported) == (0, [])
    unit.write_text(unit.read_text().replace("WatchdogSec=10", "WatchdogSecs=ten"))
    wrong = subprocess.run([*VERIFY, str(unit)], capture_output=True, text=True, check=False, timeout=60)
    assert "WatchdogSecs" in wrong.stderr


def test_unit_permits_writing_to_configured_paths() -> None:
    """ProtectSystem=strict makes all else read-only, /tmp with the local sockets included."""
    settings = dict(line.split("=", 1) for line in UNIT.read_text().splitlines() if "=" in line and line[0] != "#")
    assert settings["ProtectSystem"] == "strict"
    assert settings["ReadWritePaths"] == "/tmp"
    assert settings["Type"] == "notify"
    assert int(settings["WatchdogSec"]) > 2


class Service:
    """A node manager, and the socket where systemd would listen."""

    def __init__(self, process: subprocess.Popen[str], sock: socket.socket) -> None:
        self.process = process
        self._socket = sock

    def reported(self) -> str:
        return self._socket.recv(1000).decode()

    def told_beside_the_watchdog(self) -> str:
        while (text := self.reported()) == "WATCHDOG=1":
            continue
        return text

    def is_silent(self, seconds: float) -> bool:
        self._socket.settimeout(seconds)
        try:
            self._socket.recv(1000)
        except (TimeoutError, BlockingIOError):
            return True
        finally:
            self._socket.settimeout(60)
        return False


@pytest.fixture(params=["path", "abstract"])
def service(request: pytest.FixtureRequest, free_port: int, local_root: Path, tmp_path: Path) -> Iterator[Service]:
    file = tmp_path / "nm.toml"
    file.write_text(f'address = "127.0.0.1"\nport = {free_port}\nlocal_root = "{local_root}"\n')
    name = str(local_root / "notify") if request.param == "path" else f"@jauspy-test-{os.getpid()}"
    with socket.socket(socket.AF_UNIX, socket.SOCK_DGRAM) as sock:
        sock.bind(name.replace("@", "\0"))
        sock.settimeout(60)
        environment = os.environ | {"NOTIFY_SOCKET": name, "WATCHDOG_USEC": str(int(WATCHDOG * 1e6))}
        with subprocess.Popen(
            [*COMMAND, "--config", str(file)],
            env=environment,
            stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL,
            text=True,
        ) as process:
            yield Service(process, sock)
            with contextlib.suppress(ProcessLookupError):
                process.kill()


@pytest.mark.slow
def test_readiness_and_stop_are_notified(service: Service) -> None:
    assert service.reported() == "READY=1"
    assert [service.reported() for _ in range(3)] == 3 * ["WATCHDOG=1"]
    service.process.send_signal(signal.SIGHUP)
    assert re.fullmatch(r"RELOADING=1\nMONOTONIC_USEC=\d+", service.told_beside_the_watchdog())
    assert service.told_beside_the_watchdog() == "READY=1\nSTATUS=running"
    service.process.send_signal(signal.SIGTERM)
    assert service.told_beside_the_watchdog() == "STOPPING=1"
    assert service.process.wait(20) == 0


@pytest.mark.slow
def test_hanging_event_loop_does_not_feed_the_watchdog(service: Service) -> None:
    """Stopped as by a debugger: systemd would restart it after WatchdogSec."""
    assert service.reported() == "READY=1"
    service.process.send_signal(signal.SIGSTOP)
    os.waitid(os.P_PID, service.process.pid, os.WSTOPPED)
    while not service.is_silent(0):  # what it had sent before
        continue
    assert service.is_silent(5 * WATCHDOG)
    service.process.send_signal(signal.SIGCONT)
    assert service.reported() == "WATCHDOG=1"


@pytest.mark.slow
def test_failed_start_never_notifies_readiness(service: Service, free_port: int, other_root: Path) -> None:
    assert service.reported() == "READY=1"
    name = str(other_root / "notify")
    with socket.socket(socket.AF_UNIX, socket.SOCK_DGRAM) as sock:
        sock.bind(name)
        sock.setblocking(False)
        command = [*COMMAND, "--address", "127.0.0.1", "--port", str(free_port), "--local-root", str(other_root)]
        environment = os.environ | {"NOTIFY_SOCKET": name}
        done = subprocess.run(command, env=environment, capture_output=True, text=True, check=False, timeout=60)
        assert done.returncode == 1
        with pytest.raises(BlockingIOError):
            sock.recv(100)
