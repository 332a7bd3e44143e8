"""`up` and the demo as processes, of which none stays behind, and client verbs beside a robot."""

import json
import os
import signal
import subprocess
import sys
import time
from itertools import takewhile
from pathlib import Path

import psutil
import pytest
from tests.helpers.command_line import RunningRobot, assert_gone, jauspy, robot_in_thread, shared_robot, start, wait_for

from jauspy.protocol.junior import SOCKET_NAME
from jauspy.robot.robot_files import load
from jauspy.transport.local import is_alive

INC1 = load("inc1")
MODULES = [str(INC1.id_of(module)) for module in INC1.modules]


@pytest.fixture(scope="module")
def beside():
    """A robot that the verbs of several tests share."""
    with robot_in_thread() as robot:
        yield robot


@pytest.fixture
def robot(free_port, local_root):
    """A robot of the test's own, to end it in one way or the other."""
    running = RunningRobot(free_port, local_root)
    yield running
    running.close()


@pytest.mark.slow
def test_ls_query_and_send_work(beside):
    local, udp = beside.local, beside.udp
    [found] = [json.loads(line) for line in jauspy("ls", "--json", "--connect", udp).stdout.splitlines()]
    assert found["subsystem"] == 101
    components = found["nodes"][0]["components"]
    assert [each["id"] for each in components] == sorted(MODULES)
    component = components[0]
    assert {"urn": "urn:jaus:jss:mobility:PrimitiveDriver", "version": "1.1"} in component["services"]
    to = component["id"]

    tree = jauspy("ls", "--connect", local).stdout
    assert "mobility:PrimitiveDriver  1.1" in tree
    assert "core:" not in tree
    assert "core:Transport  1.1" in jauspy("ls", "-v", "--connect", local).stdout

    status = json.loads(jauspy("query", to, "QueryStatus", "--connect", udp).stdout)
    assert (status["message"], status["source"], status["fields"]["status"]) == ("ReportStatus", to, "STANDBY")

    effort = "propulsive_linear_effort_x=60"
    jauspy("send", to, "SetWrenchEffort", effort, "--control", "200", "--hold", "0.5", "--connect", local)
    pose = json.loads(jauspy("query", to, "querylocalpose", "presence_vector=1", "--connect", local).stdout)
    assert list(pose["fields"]) == ["x"]
    assert pose["fields"]["x"] > 0.05

    nobody = jauspy("query", "101.1.99", "QueryStatus", "--timeout", "0.3", "--connect", udp, status=1)
    assert "101.1.99 was sent QueryStatus" in nobody.stderr


@pytest.mark.slow
def test_frames_of_a_running_robot(beside):
    local = beside.local
    asked = jauspy("tf", "base_link", "lidar_link", "--json", "--connect", local)
    (lidar,) = [json.loads(line) for line in asked.stdout.splitlines()]
    assert (lidar["frame"], lidar["in"], lidar["position"]) == ("lidar_link", "base_link", [-0.33, 0.0, 0.44])
    assert lidar["quaternion"] == [1.0, 0.0, 0.0, 0.0]
    assert lidar["assumed"] == []

    tree = jauspy("tf", "--connect", local).stdout.splitlines()
    assert tree[0].split()[:3] == ["base_link", "in", "local"]
    assert any(line.startswith("tool_link ") for line in tree)
    assert not any("assumed" in line for line in tree), "its components tell where all joints are"

    alone = jauspy("tf", "base_link", "--connect", local, status=1)
    assert "give two frames, FROM and TO" in alone.stderr
    wrong = jauspy("tf", "base_link", "nose", "--connect", local, status=1)
    assert "no frame 'nose'; there are: arm_camera_link" in wrong.stderr


@pytest.mark.slow
def test_clouds_of_a_running_robot_are_saved(free_port, local_root, tmp_path):
    pytest.importorskip("pynng", reason="pynng is not installed")
    address, depth = f"ipc://{tmp_path}/cloud", f"ipc://{tmp_path}/depth"
    clouds = ["--cloud", address, "--cloud", f"chassis={depth}"]
    options = ["--port", str(free_port), "--local-root", str(local_root), *clouds]
    process = start("up", "inc1", "--backend", "kinematic", *options)
    try:
        family = wait_for(process, "stop it")
        tool = Path(__file__).parents[2] / "examples" / "save_cloud.py"
        for place, frame in ((address, b"lidar_link"), (depth, b"chassis_camera_link")):
            folder = tmp_path / frame.decode()
            command = [sys.executable, tool, place, folder, "3"]
            done = subprocess.run(command, capture_output=True, text=True, timeout=60, check=False)
            assert done.returncode == 0, done.stderr
            assert "3 received" in done.stdout
            saved = sorted(folder.iterdir())
            assert len(saved) == 3
            assert all(b"comment frame " + frame in each.read_bytes() for each in saved)
        process.send_signal(signal.SIGINT)
        assert process.wait(20) == 130
        assert_gone(family)
    finally:
        process.kill()
        process.communicate()


@pytest.mark.slow
def test_verbs_run_side_by_side_and_a_wildcard_names_who_answered(beside):
    for where in (beside.local, beside.udp):
        asked = [start("query", "101.255.255", "QueryStatus", "--timeout", "2", "--connect", where) for _ in range(2)]
        for each in asked:
            out, err = each.communicate(timeout=60)
            assert err == ""
            sources = {json.loads(line)["source"] for line in out.splitlines()}
            assert sources == set(MODULES)


@pytest.mark.slow
def test_send_tells_what_prevents_an_effect(beside):
    where = ("--connect", beside.local)
    effort = ("SetWrenchEffort", "propulsive_linear_effort_x=40")
    assert "which is nobody: use --control AUTHORITY" in jauspy("send", "101.1.102", *effort, *where, status=1).stderr
    assert "101.1.103 does not offer SetWrenchEffort" in jauspy("send", "101.1.103", *effort, *where, status=1).stderr
    assert "does not answer" in jauspy("send", "101.1.99", "Resume", "--timeout", "0.3", *where, status=1).stderr
    emergency = ("Emergency", "emergency_code=STOP")
    assert jauspy("send", "101.1.102", f"Set{emergency[0]}", emergency[1], *where).stderr == ""
    clear = ("send", "101.1.102", f"Clear{emergency[0]}", emergency[1])
    other = jauspy(*clear, "--id", "42.1.77", *where, status=1).stderr
    assert "still in EMERGENCY; only the id that set it can clear it; this is 42.1.77" in other
    assert jauspy("send", "101.1.102", f"Clear{emergency[0]}", emergency[1], *where).stderr == ""


def test_send_in_control_tells_that_a_command_is_ignored(beside):
    one = "joint_effort_list=[{joint_effort: 10}]"
    to = ("--control", "200", "--connect", beside.local)
    joints = jauspy("send", "101.1.104", "SetJointEffort", one, *to, status=1)
    assert "it has 5 joints, and the message has 1; give one value for each" in joints.stderr
    fast = jauspy("send", "101.1.102", "SetVelocityCommand", "command_type=0", "velocity_x=9", *to, status=1)
    assert "velocity_x 9 m/s is outside" in fast.stderr
    missing = jauspy("send", "101.1.104", "SetWrenchEffort", *to, status=1)
    assert "does not offer SetWrenchEffort" in missing.stderr


@pytest.mark.slow
def test_send_tells_that_the_robot_was_ended_meanwhile():
    with shared_robot() as robot:
        process = start(
            *("send", "101.1.102", "SetWrenchEffort", "propulsive_linear_effort_x=10", "--control", "200"),
            *("--hold", "3", "--connect", robot.local),
        )
        while "READY" not in jauspy("query", "101.1.102", "QueryStatus", "--connect", robot.local).stdout:
            assert process.poll() is None
        robot.process.kill()
        _, error = process.communicate(timeout=20)
    assert process.returncode == 1
    assert "did not acknowledge Standby and ReleaseControl" in " ".join(error.split())


@pytest.mark.slow
def test_send_waits_for_the_completion_of_a_command(beside):
    pan = ("send", "101.1.107", "SetPanTiltJointPositions", "joint1_position=0.3", "joint2_position=0.1")
    where = ("--control", "200", "--connect", beside.local)
    jauspy(*pan, "--within", "15", *where)
    query = ("query", "101.1.107", "QueryPanTiltJointPositions", "--connect", where[-1])
    assert json.loads(jauspy(*query).stdout)["fields"]["joint1_position"] == pytest.approx(0.3, abs=0.05)
    far = ("send", "101.1.107", "SetPanTiltJointPositions", "joint1_position=-0.9", "joint2_position=0.1")
    assert (
        "did not carry out SetPanTiltJointPositions within 0 s"
        in jauspy(*far, "--within", "0", *where, status=1).stderr
    )


@pytest.mark.slow
def test_loss_of_control_during_hold_is_a_failure(beside):
    where = ("--connect", beside.local)
    effort = ("SetWrenchEffort", "propulsive_linear_effort_x=10")
    weak = start("send", "101.1.102", *effort, "--control", "100", "--hold", "30", *where)
    deadline = time.monotonic() + 30
    while json.loads(jauspy("query", "101.1.102", "QueryControl", *where).stdout)["fields"]["authority_code"] != 100:
        assert time.monotonic() < deadline
    jauspy("send", "101.1.102", "Resume", "--control", "200", *where)
    _, err = weak.communicate(timeout=60)
    assert weak.returncode == 1
    assert err.startswith("Error: control of 101.1.102 was lost: 101.1.102 took it back")


@pytest.mark.slow
@pytest.mark.parametrize(
    ("number", "status"), [(signal.SIGINT, 130), pytest.param(signal.SIGTERM, 0, marks=pytest.mark.slow)]
)
def test_up_stops_in_order_and_leaves_no_process(robot, local_root, number, status):
    assert len(robot.family) == 1
    robot.process.send_signal(number)
    _, err = robot.process.communicate(timeout=20)
    said = [line for line in err.splitlines() if "a step of the robot took" not in line]  # on a machine that is busy
    assert (robot.process.returncode, said) == (status, [])
    assert_gone(robot.family)
    assert not list(local_root.iterdir())


@pytest.mark.slow
def test_killed_up_leaves_no_process(robot):
    robot.process.kill()
    robot.process.wait()
    assert_gone(robot.family)


@pytest.mark.slow
def test_up_passes_node_manager_options_and_prints_all_counters(free_port, local_root):
    process = start(
        *("up", "inc1", "--backend", "kinematic", "--port", str(free_port), "--local-root", str(local_root)),
        *("--address", "127.0.0.1", "--interface", "127.0.0.1", "--multicast-group", "239.255.0.77"),
        *("--socket-mode", "600", "--verbose"),
    )
    try:
        [child] = wait_for(process, "stop it")
        assert child.cmdline()[-1] == "--with-parent"
        assert {"127.0.0.1", "239.255.0.77", "600", "--verbose"} <= set(child.cmdline())
        jauspy("query", "101.1.102", "QueryStatus", "--connect", f"udp://127.0.0.1:{free_port}")
        process.send_signal(signal.SIGUSR1)
        said = list(takewhile(lambda line: line != "node manager: counters:\n", process.stderr))
        assert "counters of inc1:\n" in said
        assert process.stderr.readline().startswith("node manager:   ")
    finally:
        process.terminate()
        process.communicate()


def test_up_rejects_an_unknown_world(local_root):
    arguments = ("up", "inc1", "--backend", "kinematic", "--world", "moon", "--local-root", str(local_root))
    assert "has no worlds" in jauspy(*arguments, status=1).stderr


@pytest.mark.slow
def test_up_suggests_only_possible_commands(beside, tmp_path):
    copy = tmp_path / "other.toml"
    module = "[[modules]]\ntype = 'CM-MOB'\ncomponent = 102\nservices = []\n"
    copy.write_text(f"extends = 'inc1'\nsubsystem = 102\n{module}")
    process = start("up", str(copy), "--backend", "kinematic", "--local-root", str(beside.root))
    lines = []
    for line in process.stdout:
        lines.append(line)
        if "stop it" in line:
            break
    process.terminate()
    process.communicate(timeout=20)
    assert not [line for line in lines if "drive it" in line or "see it" in line]


@pytest.mark.slow
def test_up_uses_a_running_node_manager(beside, tmp_path):
    copy = tmp_path / "other.toml"
    copy.write_text("extends = 'inc1'\nsubsystem = 102\n")
    second = start("up", str(copy), "--backend", "kinematic", "--local-root", str(beside.root))
    assert wait_for(second, "node manager: was running") == []
    second.terminate()
    second.communicate(timeout=20)


@pytest.mark.slow
def test_dead_node_manager_is_restarted(robot, local_root):
    robot.family[0].kill()
    assert robot.process.stderr.readline() == "node manager: ended by signal 9; starting it again\n"
    until = time.monotonic() + 60
    while not is_alive(local_root / SOCKET_NAME):
        assert time.monotonic() < until
        time.sleep(0.05)
    found = jauspy("ls", "--connect", f"local:{local_root}", "--timeout", "4", "--json").stdout
    assert json.loads(found)["subsystem"] == 101
    robot.family += psutil.Process(robot.process.pid).children()


@pytest.mark.slow
def test_up_without_a_node_manager_says_what_to_do(local_root):
    done = jauspy(
        "up", "inc1", "--backend", "kinematic", "--no-node-manager", "--local-root", str(local_root), status=1
    )
    assert "jauspy node-manager" in done.stderr


def test_unknown_robot_error_lists_the_known_ones(local_root):
    assert (
        "the robots are: cell, igvc, inc1" in jauspy("up", "nobody", "--local-root", str(local_root), status=1).stderr
    )


@pytest.mark.slow
def test_the_demo(free_port):
    text = jauspy("demo", "--backend", "kinematic", "--port", str(free_port)).stdout
    for step in (
        "Discover subsystem 101",
        "Take control",
        "Resume",
        "✓ drive",
        "✓ arm",
        "Standby, release",
        "all goals were reached",
    ):
        assert step in text
    assert "real time" in text
    assert "timeouts" in text
    assert "\x1b" not in text


@pytest.mark.slow
@pytest.mark.parametrize(
    ("number", "status"),
    [
        (signal.SIGINT, 130),
        pytest.param(signal.SIGTERM, 1, marks=pytest.mark.long),
        pytest.param(signal.SIGHUP, 1, marks=pytest.mark.long),
        pytest.param(signal.SIGKILL, -9, marks=pytest.mark.slow),
    ],
)
def test_interrupted_demo_says_so_and_leaves_no_process(free_port, local_root, monkeypatch, number, status):
    monkeypatch.setenv("TMPDIR", str(local_root))
    demo = start("demo", "--backend", "kinematic", "--port", str(free_port))
    family = wait_for(demo, "Drive 2 m")
    assert len(family) == 2
    demo.send_signal(number)
    _, err = demo.communicate(timeout=20)
    said = "" if number == signal.SIGKILL else "stopped; control was released\n"
    assert (demo.returncode, err) == (status, said)
    assert_gone(family)
    assert not list(local_root.iterdir())


def test_the_demo_has_one_default_backend():
    text = jauspy("demo", "--help").stdout
    assert "[default: sim]" in text
    assert "the robot's own" not in text


@pytest.mark.slow
def test_port_in_use_error_names_the_process(beside):
    err = jauspy("demo", "--backend", "kinematic", "--port", str(beside.port), status=1).stderr
    assert f"UDP port {beside.port} is used by process {os.getpid()}" in err
    assert f"make demo PORT={beside.port + 1}" in err
    assert len(err.splitlines()) == 1
