"""`jauspy conformance` as a process against `jauspy up igvc`, and what it says when it cannot."""

from __future__ import annotations

import json
import signal
import subprocess
import sys
from pathlib import Path
from xml.etree import ElementTree as ET

import pytest
from tests.helpers.command_line import JAUSPY, robot_in_thread
from typer.testing import CliRunner

from jauspy.capture.reader import is_capture
from jauspy.cli import processes
from jauspy.cli.main import app
from jauspy.cli.processes import stoppable

SOME = ("--only", "01", "--only", "02", "--only", "2", "--only", "31")
"""Steps of igvc-2015 that take no time: discovery and access control."""


@pytest.fixture(scope="module")
def robot():
    """Local root and port of a robot."""
    with robot_in_thread("igvc") as running:
        yield running.root, running.port


def invoke(*arguments):
    return CliRunner().invoke(app, ["conformance", *map(str, arguments)])


@pytest.mark.slow
def test_steps_run_by_udp_and_through_a_node_manager(robot, tmp_path):
    root, port = robot
    files = {kind: tmp_path / f"run.{kind}" for kind in ("junit", "html", "pcapng")}
    options = [word for kind, path in files.items() for word in (f"--{kind}", path)]
    ways = (f"udp://127.0.0.1:{port}", options), (f"local:{root}", ())
    for where, more in ways:
        # generous, for a machine that is busy with other things
        result = invoke(
            "igvc-2015", "--target", "105.1.255", "--connect", where, "--timeout", 5, "--json", *SOME, *more
        )
        lines = [json.loads(line) for line in result.stdout.splitlines()]
        assert [each for each in lines[:-1] if each["verdict"] != "pass"] == []
        assert result.exit_code == 0
        assert lines[-1]["points"] == lines[-1]["of"] == 13
    assert len(ET.fromstring(files["junit"].read_bytes())[0]) == 13
    assert "13 pass" in files["html"].read_text()
    assert is_capture(files["pcapng"].read_bytes()[:4])


@pytest.mark.slow
def test_a_robot_is_named_by_its_number(robot):
    root, _ = robot
    command = (
        "iop-v3",
        "--target",
        "105",
        "--connect",
        f"local:{root}",
        "--timeout",
        5,
        "--only",
        "platform",
        "--json",
    )
    result = invoke(*command)
    verdicts = {line["step"]: line["verdict"] for line in map(json.loads, result.stdout.splitlines()) if "step" in line}
    assert verdicts["platform/Discovery"] == "pass"
    assert verdicts["platform/PlatformState"] == "fail"  # it is a robot for another test
    assert result.exit_code == 1


@pytest.mark.slow
def test_failures_are_explained(robot):
    _, port = robot
    listed = invoke("ugv-1.0", "--list", "--target", "105.1.1", "--connect", f"udp://127.0.0.1:{port}", "--timeout", 5)
    assert listed.exit_code == 0
    assert (
        "Controlled.Available.Ready/SetSkidSteerEffort/controller  SetSkidSteerEffort from the controller"
        in listed.stdout
    )
    result = invoke("igvc-2015", "--target", "105.1.1", "--connect", f"udp://127.0.0.1:{port}", "--only", "24")
    assert result.exit_code == 1
    assert "24 the client is in control: fail" in result.stdout
    assert "subsystem_id is 0, not 42" in result.stdout
    assert "from: urn:jaus:jss:core:AccessControl 1.1: QueryControl 200Dh" in result.stdout
    assert "0 of 1 points" in result.stdout


def test_missing_target_ends_with_status_2(free_port):
    result = invoke("igvc-2015", "--target", "7.1.255", "--connect", f"udp://127.0.0.1:{free_port}", "--timeout", 0.1)
    assert result.exit_code == 2
    assert "7.1.255 answers nothing" in result.stderr


@pytest.mark.slow
def test_closed_output_pipe_keeps_the_exit_status(free_port):
    where = ("--target", "7.1.255", "--connect", f"udp://127.0.0.1:{free_port}", "--timeout", "0.1")
    command = [*JAUSPY, "conformance", "igvc-2015", *where, "--json"]
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as process:
        process.stdout.close()
        errors = process.stderr.read()
        process.wait(timeout=20)
    assert process.returncode == 2
    *notes, error = errors.splitlines()
    assert error.startswith("Error: 7.1.255 answers nothing")
    assert all(each.startswith("no multicasts on interface") for each in notes)  # where there is no network


def test_sigterm_ends_a_run_like_ctrl_c():
    before = signal.getsignal(signal.SIGTERM)
    with stoppable() as status:
        with pytest.raises(KeyboardInterrupt):
            signal.raise_signal(signal.SIGTERM)
        assert status() == 143
    assert signal.getsignal(signal.SIGTERM) is before


def test_second_ctrl_c_still_writes_the_report(monkeypatch):
    with stoppable() as status:
        with pytest.raises(KeyboardInterrupt):
            signal.raise_signal(signal.SIGINT)
        signal.raise_signal(signal.SIGINT)  # the robot is being left in order
        signal.raise_signal(signal.SIGTERM)
        assert status() == 130
        monkeypatch.setattr(processes, "REPEATED_SIGNAL_TIME", 0.0)
        with pytest.raises(KeyboardInterrupt):
            signal.raise_signal(signal.SIGINT)


def test_wrong_usage_ends_with_status_2():
    assert "there are: " in invoke("igvc-1815", "--target", "1.1.1").stderr
    nothing = invoke("igvc-2015")
    assert nothing.exit_code == 2
    assert "name a profile and a target" in nothing.stderr
    assert invoke("igvc-2015", "--target", "1.1").exit_code == 2
    assert invoke("igvc-1815", "--list").exit_code == 2
    assert "0.0.0 is not the id of a component" in invoke("igvc-2015", "--target", "0.0.0").stderr
    assert "42.1.1 is an id that the test itself uses" in invoke("igvc-2015", "--target", "42.1.1").stderr


@pytest.mark.parametrize("kind", ["junit", "html", "pcapng"])
def test_unwritable_report_is_an_error_before_the_run(kind, tmp_path, free_port):
    where = ("igvc-2015", "--target", "1.1.1", "--connect", f"udp://127.0.0.1:{free_port}")
    missing = invoke(*where, f"--{kind}", tmp_path / "none" / "x")
    assert missing.exit_code == 2
    assert f"there is no directory {tmp_path / 'none'}" in missing.stderr
    assert missing.stdout == ""
    assert "it is a directory" in invoke(*where, f"--{kind}", tmp_path).stderr


def test_two_reports_in_one_file_are_rejected(tmp_path):
    both = tmp_path / "report"
    result = invoke("igvc-2015", "--target", "1.1.1", "--html", both, "--junit", tmp_path / "." / "report")
    assert result.exit_code == 2
    assert "is given for --junit and for --html" in result.stderr
    assert not both.exists()


@pytest.mark.slow
def test_failed_report_does_not_prevent_the_others(tmp_path, free_port):
    where = ("--target", "7.1.1", "--connect", f"udp://127.0.0.1:{free_port}", "--timeout", "0.1")
    files = ("--html", "/dev/full", "--pcapng", str(tmp_path / "run.pcapng"))
    command = [*JAUSPY, "conformance", "igvc-2015", *where, *files, "--json"]
    with Path("/dev/full").open("w") as full:
        done = subprocess.run(command, check=False, stdout=full, stderr=subprocess.PIPE, text=True, timeout=60)
    assert done.returncode == 2
    assert "/dev/full: cannot be written: No space left on device" in done.stderr
    assert "the results cannot be written: No space left on device" in done.stderr
    assert "Traceback" not in done.stderr
    assert is_capture((tmp_path / "run.pcapng").read_bytes()[:4])


@pytest.mark.slow
def test_ctrl_c_writes_the_report_and_releases_the_robot(robot, tmp_path):
    _, port = robot
    where = ("--target", "105.1.1", "--connect", f"udp://127.0.0.1:{port}")
    steps = ("--only", "23", "--only", "32", "--only", "33", "--only", "75")
    page = tmp_path / "run.html"
    command = [*JAUSPY, "conformance", "igvc-2015", *where, *steps, "--json", "--html", str(page)]
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as process:
        for line in process.stdout:
            if json.loads(line)["step"] == "33":
                break
        process.send_signal(signal.SIGINT)  # the heartbeat of step 75 is watched for four seconds
        process.communicate(timeout=20)
    assert process.returncode == 130
    assert "interrupted after 3 steps" in page.read_text()
    free = invoke("igvc-2015", *where, "--only", "21", "--only", "37", "--timeout", 5)
    assert free.exit_code == 0, free.stdout


def test_listing_generated_steps_requires_a_target(free_port):
    assert "add --target, as in --target 101.1.102" in invoke("core-1.1", "--list").stderr
    nobody = invoke(
        "core-1.1", "--list", "--target", "7.1.1", "--connect", f"udp://127.0.0.1:{free_port}", "--timeout", 0.1
    )
    assert nobody.exit_code == 2
    assert "7.1.1 answers nothing" in nobody.stderr


def test_list():
    assert "igvc-2015" in invoke("--list").stdout
    assert "29  a client with more authority takes over" in invoke("igvc-2015", "--list").stdout


OWN = """
from jauspy.conformance import Profile, Step, ask
from jauspy.messages.core import QueryStatus, ReportStatus

PROFILE = Profile("mine", "My test", (Step("1", "says how it is", ask("42.1.1", QueryStatus(), ReportStatus)),))
NONE = 5
"""


def test_current_directory_is_searched_for_profiles_of_ones_own_only(monkeypatch):
    for profile, searched in (("igvc-2015", False), ("acme.brakes:PROFILE", True)):
        monkeypatch.setattr(sys, "path", [each for each in sys.path if each])
        invoke("--list", profile)
        assert ("" in sys.path) == searched


@pytest.mark.slow
def test_user_defined_profile_runs(tmp_path, monkeypatch):
    (tmp_path / "my_test.py").write_text(OWN)
    command = [Path(sys.executable).with_name("jauspy"), "conformance", "my_test:PROFILE", "--list"]
    listed = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, timeout=60, check=False)
    assert (listed.returncode, "says how it is" in listed.stdout) == (0, True)
    monkeypatch.syspath_prepend(tmp_path)
    for name, problem in (("my_test:NONE", "is not a Profile"), ("my_tset:PROFILE", "No module named 'my_tset'")):
        result = invoke(name, "--list")
        assert (result.exit_code, problem in " ".join(result.output.split())) == (2, True)


def test_named_services_include_those_that_they_inherit_from():
    result = invoke("core-1.1", "--target", "126.1.11", "--services", "Liveness@1.0", "--list")
    assert result.exit_code == 0
    assert "QueryHeartbeatPulse from the other client" in result.stdout
    assert "CreateEvent" in result.stdout
    assert "Resume" not in result.stdout


@pytest.mark.parametrize(
    ("target", "services", "problem"),
    [
        ("126.1.11", "Managment", "did you mean Management"),
        ("126.1.11", "Management@1.0,Liveness@1.1", "give a version to each, as in Liveness@1.0"),
        ("126.1.11", "QueryStatus", "--services QueryStatus: this is a message"),
        ("126.1.255", "Management", "126.1.255 has wildcards"),
    ],
)
def test_named_services_are_checked(target, services, problem):
    result = invoke("core-1.1", "--target", target, "--services", services, "--list")
    assert result.exit_code == 2
    assert problem in " ".join(result.stderr.split())
