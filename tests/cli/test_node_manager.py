"""`jauspy node-manager` as a process."""

import os
import signal
import socket
import stat
import subprocess
import sys

import pytest

COMMAND = [sys.executable, "-m", "jauspy.cli.main", "node-manager"]


@pytest.fixture
def node_manager(free_port, local_root):
    process = subprocess.Popen(
        [*COMMAND, "--port", str(free_port), "--local-root", str(local_root)],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    )
    first = process.stdout.readline()
    assert first == f"node manager ready: UDP 0.0.0.0:{free_port}, local sockets in {local_root}\n"
    yield process
    process.kill()
    process.communicate()


@pytest.mark.parametrize(("number", "status"), [(signal.SIGTERM, 0), (signal.SIGINT, 130)])
def test_it_stops_in_order_and_prints_counters(node_manager, local_root, number, status):
    node_manager.send_signal(number)
    out, err = node_manager.communicate(timeout=20)
    assert (out, node_manager.returncode) == ("", status)
    assert err.startswith("counters:\n")
    assert "Traceback" not in err
    assert not list(local_root.iterdir())


def test_sigusr1_prints_the_counters(node_manager, free_port):
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as sender:
        sender.sendto(b"\xff" * 40, ("127.0.0.1", free_port))
    for _ in range(50):  # the datagram and the signal race; each signal prints what is known by then
        node_manager.send_signal(signal.SIGUSR1)
        assert node_manager.stderr.readline() == "counters:\n"
        if "version" in node_manager.stderr.readline():
            return
    pytest.fail("the datagram was never counted")


def test_a_taken_port_names_who_has_it_and_how_to_choose_another(node_manager, free_port, other_root):
    second = subprocess.run(
        [*COMMAND, "--port", str(free_port), "--local-root", str(other_root)],
        capture_output=True,
        text=True,
        check=False,
        timeout=30,
    )
    assert second.returncode == 1
    assert f"UDP port {free_port} is used by process {node_manager.pid}" in second.stderr
    assert "--port" in second.stderr
    assert len(second.stderr.splitlines()) == 1


def test_wrong_settings_get_a_sentence():
    done = subprocess.run(
        [*COMMAND, "--multicast-group", "10.0.0.1"], capture_output=True, text=True, check=False, timeout=30
    )
    assert done.returncode == 1
    assert "write an IPv4 multicast address" in done.stderr


def test_the_mode_of_the_socket(free_port, local_root):
    arguments = ["--port", str(free_port), "--local-root", str(local_root), "--socket-mode"]
    wide = {**os.environ, "COLUMNS": "200"}
    wrong = subprocess.run([*COMMAND, *arguments, "999"], capture_output=True, text=True, check=False, env=wide)
    assert wrong.returncode == 2
    assert "three octal digits" in wrong.stderr
    with subprocess.Popen([*COMMAND, *arguments, "600"], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL) as process:
        process.stdout.readline()
        mode = stat.S_IMODE((local_root / "JuniorRTE").stat().st_mode)
        process.terminate()
    assert mode == 0o600
