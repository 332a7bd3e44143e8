"""`jauspy node-manager` as a process."""

import json
import os
import resource
import signal
import socket
import stat
import subprocess
import sys

import pytest

from jauspy.node.manager import MAX_OPEN_FILES

COMMAND = [sys.executable, "-m", "jauspy.cli.main", "node-manager"]


@pytest.fixture
def node_manager(free_port, local_root):
    process = subprocess.Popen(
        [*COMMAND, "--port", str(free_port), "--local-root", str(local_root), "--interface", "127.0.0.1"],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    )
    first = process.stdout.readline()
    assert first == f"node manager ready: UDP 0.0.0.0:{free_port}, local sockets in {local_root}\n"
    yield process
    process.kill()
    process.communicate()


@pytest.mark.slow
@pytest.mark.parametrize(("number", "status"), [(signal.SIGTERM, 0), (signal.SIGINT, 130)])
def test_stop_is_orderly_and_prints_counters(node_manager, local_root, number, status):
    node_manager.send_signal(number)
    out, err = node_manager.communicate(timeout=20)
    assert (out, node_manager.returncode) == ("", status)
    assert err.startswith("counters:\n")
    assert "Traceback" not in err
    assert not list(local_root.iterdir())


@pytest.mark.slow
def test_sigint_stops_what_a_script_started_in_the_background(free_port, local_root):
    """A shell without job control starts it with SIGINT ignored, which it would inherit."""
    options = f"--port {free_port} --local-root {local_root} --interface 127.0.0.1"
    script = f"{' '.join(COMMAND)} {options} & read stop; kill -INT $!; wait $!; echo status $?"
    pipes = {"stdin": subprocess.PIPE, "stdout": subprocess.PIPE, "text": True}
    with subprocess.Popen(["sh", "-c", script], start_new_session=True, **pipes) as shell:
        assert "ready" in shell.stdout.readline()
        try:
            out, _ = shell.communicate("stop\n", timeout=20)
        finally:
            if shell.returncode is None:
                os.killpg(shell.pid, signal.SIGKILL)
    assert out == "status 130\n"


@pytest.mark.slow
def test_sigusr1_prints_the_counters(node_manager, free_port):
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as sender:
        sender.sendto(b"\xff" * 40, ("127.0.0.1", free_port))
    for _ in range(50):  # the datagram and the signal race; each signal prints what is known by then
        node_manager.send_signal(signal.SIGUSR1)
        assert node_manager.stderr.readline() == "counters:\n"
        if "version" in node_manager.stderr.readline():
            return
    pytest.fail("the datagram was never counted")


@pytest.mark.slow
def test_port_in_use_error_names_the_process_and_the_option(node_manager, free_port, other_root):
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


@pytest.mark.slow
def test_invalid_settings_cause_one_sentence():
    done = subprocess.run(
        [*COMMAND, "--multicast-group", "10.0.0.1"], capture_output=True, text=True, check=False, timeout=30
    )
    assert done.returncode == 1
    assert "write an IPv4 multicast address" in done.stderr


@pytest.mark.slow
def test_status_has_a_json_form():
    ended = subprocess.run([*COMMAND, "--json"], check=False, capture_output=True, text=True, timeout=20)
    assert ended.returncode == 2
    assert "it requires --status" in ended.stderr


@pytest.mark.slow
def test_file_limit_is_raised_for_all_components(free_port, local_root):
    limited = ["bash", "-c", 'ulimit -S -n 100; exec "$@"', "--", *COMMAND]
    where = ["--port", str(free_port), "--local-root", str(local_root)]
    process = subprocess.Popen([*limited, *where], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
    try:
        assert process.stdout.readline().startswith("node manager ready")
        _, hard = resource.getrlimit(resource.RLIMIT_NOFILE)
        assert resource.prlimit(process.pid, resource.RLIMIT_NOFILE)[0] == min(MAX_OPEN_FILES, hard)
    finally:
        process.kill()
        process.communicate()


@pytest.mark.slow
def test_socket_mode_is_applied(free_port, local_root):
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


def run(*arguments):
    return subprocess.run([*COMMAND, *arguments], capture_output=True, text=True, check=False, timeout=30)


@pytest.mark.slow
def test_the_printed_configuration_is_valid(tmp_path):
    first = run("--print-config", "--port", "4000", "--metrics", "127.0.0.1:9794")
    file = tmp_path / "nm.toml"
    file.write_text(first.stdout)
    again = run("--config", str(file), "--print-config")
    assert (first.returncode, again.returncode) == (0, 0)
    assert again.stdout == first.stdout
    assert "\nport = 4000\n" in first.stdout


@pytest.mark.slow
def test_peer_sets_its_multicast_group():
    assert '\nmulticast_group = "224.1.0.1"\n' in run("--print-config", "--peer", "openjaus").stdout
    assert '\nmulticast_group = "239.255.0.1"\n' in run("--print-config", "--peer", "jts").stdout
    chosen = run("--print-config", "--peer", "openjaus", "--multicast-group", "239.1.2.3").stdout
    assert '\nmulticast_group = "239.1.2.3"\n' in chosen
    assert "choose one of jts, fkie, openjaus" in run("--print-config", "--peer", "none").stderr


@pytest.mark.slow
def test_invalid_file_error_names_file_key_and_fix(tmp_path):
    file = tmp_path / "nm.toml"
    file.write_text("prot = 3795\n")
    done = run("--config", str(file))
    assert done.returncode == 1
    assert f"{file}: is not a configuration of a node manager" in done.stderr
    assert "line 1: prot = 3795: there is no such key; known here are: address," in done.stderr


@pytest.mark.slow
def test_status_of_a_running_node_manager_is_printed(node_manager, free_port, local_root):
    reported = run("--status", "--local-root", str(local_root))
    assert reported.stdout.startswith(f"node manager, process {node_manager.pid}, up ")
    assert f"0.0.0.0:{free_port}" in reported.stdout
    assert json.loads(run("--status", "--json", "--local-root", str(local_root)).stdout)["pid"] == node_manager.pid


@pytest.mark.slow
def test_status_without_a_node_manager_is_an_error(local_root):
    done = run("--status", "--local-root", str(local_root))
    assert done.returncode == 1
    assert f"no node manager serves its status at {local_root}" in done.stderr


@pytest.mark.slow
def test_sighup_reloads_the_file_and_rejects_an_invalid_one(free_port, local_root, tmp_path):
    file = tmp_path / "nm.toml"
    interfaces = 'multicast_interfaces = ["127.0.0.1"]'  # others may not be there, which is said
    file.write_text(f'port = {free_port}\nlocal_root = "{local_root}"\n{interfaces}\n')
    with subprocess.Popen(
        [*COMMAND, "--config", str(file)], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True
    ) as process:
        assert "ready" in process.stdout.readline()
        file.write_text(file.read_text() + "rate_limit = -1\n")
        process.send_signal(signal.SIGHUP)
        assert "the configuration was not changed" in process.stderr.readline()
        assert "rate_limit = -1" in process.stderr.readline()
        file.write_text(file.read_text().replace("-1", "5") + "multicast_ttl = 2\n")
        process.send_signal(signal.SIGHUP)
        assert "the configuration was reloaded; after a restart: multicast_ttl" in process.stderr.readline()
        process.send_signal(signal.SIGTERM)
        assert process.wait(20) == 0


@pytest.mark.slow
@pytest.mark.parametrize(
    ("text", "reported"),
    [
        ("", "has no [gateway]"),
        ("[gateway]\nsubsystem = 102", "gateway.subsystem = 102: the robot is subsystem 101"),
    ],
)
def test_robot_rejects_the_gateway_of_another_subsystem(tmp_path, local_root, text, reported):
    file = tmp_path / "gateway.toml"
    file.write_text(text)
    command = [*COMMAND[:-1], "up", "inc1", "--gateway", str(file), "--local-root", str(local_root)]
    done = subprocess.run(command, capture_output=True, text=True, check=False, timeout=30)
    assert done.returncode == 1
    assert reported in done.stderr


@pytest.mark.slow
def test_robot_runs_behind_a_gateway(tmp_path, local_root, free_port):
    file = tmp_path / "gateway.toml"
    file.write_text(f'port = {free_port}\n[gateway]\nsubsystem = 101\n[[gateway.rules]]\nsource = "42.*.*"\n')
    command = [*COMMAND[:-1], "up", "inc1", "--backend", "kinematic", "--gateway", str(file)]
    with subprocess.Popen(
        [*command, "--local-root", str(local_root)], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True
    ) as process:
        said = iter(process.stdout.readline, "")
        assert any(f"UDP port {free_port}" in line for line in said)
        process.send_signal(signal.SIGTERM)
        assert process.wait(20) == 0
