"""What `jauspy up` says once the robot is there."""

from __future__ import annotations

import asyncio
import socket
from pathlib import Path
from types import SimpleNamespace

import pytest
from typer.testing import CliRunner

from jauspy.backends.kinematic import KinematicRobot
from jauspy.cli import up
from jauspy.cli.main import app
from jauspy.cli.up import print_summary
from jauspy.ids import JausID
from jauspy.robot.config import AccessControlConfig
from jauspy.robot.robot_files import load


@pytest.mark.parametrize(("services", "drives"), [(None, True), (("Discovery", "LocalPoseSensor"), False)])
def test_drive_example_is_printed_only_for_robots_that_drive(capsys, services, drives) -> None:
    config = load("inc1")
    module = config.modules[0].model_copy(update={"services": services})
    config = config.model_copy(update={"modules": (module,)})
    component = SimpleNamespace(id=config.id_of(module))
    runner = SimpleNamespace(
        config=config, audit=None, components=[component], running=[(component, module)], faults={}
    )
    print_summary(runner, "running", Path("/tmp/elsewhere"))
    text = capsys.readouterr().out
    assert ("drive it:  jauspy send 101.1.102 SetWrenchEffort" in text) == drives
    assert "ask it:    jauspy query 101.1.102 QueryStatus --connect local:/tmp/elsewhere" in text


@pytest.mark.parametrize(
    ("robot", "timeout", "warning"),
    [
        ("inc1", None, ""),
        ("igvc", None, "warning:   105.1.1 keeps moving for 120 s after its client died: access_control.timeout = 120"),
        ("igvc", 0, "warning:   105.1.1 keeps moving without limit after its client died: access_control.timeout = 0"),
    ],
)
def test_long_control_timeout_causes_a_warning(capsys, robot, timeout, warning) -> None:
    config = load(robot)
    if timeout is not None:
        access = AccessControlConfig(timeout=timeout)
        modules = tuple(each.model_copy(update={"access_control": access}) for each in config.modules)
        config = config.model_copy(update={"modules": modules})
    components = [SimpleNamespace(id="105.1.1")] * len(config.modules)
    running = list(zip(components, config.modules, strict=True))
    runner = SimpleNamespace(config=config, audit=None, components=components, running=running, faults={})
    print_summary(runner, "", Path())
    lines = [line for line in capsys.readouterr().out.splitlines() if line.startswith("warning:")]
    assert lines[:1] == [warning] * bool(warning)


def test_the_warning_concerns_all_modules_that_move_something(capsys) -> None:
    config = load("inc1")
    access = AccessControlConfig(timeout=0)
    modules = tuple(module.model_copy(update={"access_control": access}) for module in config.modules)
    config = config.model_copy(update={"modules": modules})
    components = [SimpleNamespace(id=config.id_of(module)) for module in modules]
    running = list(zip(components, modules, strict=True))
    print_summary(
        SimpleNamespace(config=config, audit=None, components=components, running=running, faults={}), "", Path()
    )
    warned = {line.split()[1] for line in capsys.readouterr().out.splitlines() if line.startswith("warning:")}
    moving = {str(config.id_of(module)) for module in modules if module.type in {"CM-MOB", "CM-MAN", "CM-EEF"}}
    assert warned == moving | {"101.1.107"}  # the pan-tilt unit of one of three cameras


@pytest.mark.slow
async def test_modules_in_failure_are_named_with_the_reason(virtual_network, monkeypatch, capsys) -> None:
    def no_bus(self: KinematicRobot, dt: float) -> None:
        raise OSError("no such bus")

    monkeypatch.setattr(KinematicRobot, "advance", no_bus)
    async with virtual_network.robot() as runner:
        await asyncio.sleep(0.2)
        print_summary(runner, "running", Path("/tmp/elsewhere"))
    first, *lines = capsys.readouterr().out.splitlines()
    assert first.startswith("inc1 is up, but 101.1.102, 101.1.103,")
    assert "are in Failure: subsystem 101" in first
    reset = "`jauspy send 101.1.103 Reset --connect local:/tmp/elsewhere` tries again"
    assert f"failed:    101.1.103: the robot: OSError: no such bus; {reset}" in lines


def test_second_robot_of_one_kind_gets_its_own_id(monkeypatch, tmp_path) -> None:
    started = []
    monkeypatch.setattr(up, "run", lambda coroutine: (started.append(coroutine.cr_frame.f_locals), coroutine.close()))
    command = ["up", "inc1", "--backend", "kinematic", "--local-root", str(tmp_path), "--no-node-manager"]
    with socket.socket(socket.AF_UNIX, socket.SOCK_DGRAM) as first:
        first.bind(str(tmp_path / str(int(JausID(101, 1, 102)))))
        result = CliRunner().invoke(app, command)
        assert result.exit_code == 1
        assert "101.1.102 is in use in" in result.stderr
        assert "a second one needs its own: `jauspy up inc1 --id 102`" in " ".join(result.stderr.split())
        assert started == []
        assert CliRunner().invoke(app, [*command, "--id", "102"]).exit_code == 0
    (second,) = started
    config = second["runner"].config
    assert {config.id_of(module).subsystem for module in config.modules} == {102}
