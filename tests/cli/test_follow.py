"""`jauspy up --also` and `jauspy follow`: what starts, and what is refused."""

from __future__ import annotations

import pytest
from typer.testing import CliRunner

from jauspy.cli import up
from jauspy.cli.main import app


@pytest.mark.parametrize(
    ("options", "message"),
    [
        (["--also", "inc1:101"], "subsystem 101 is that of another robot"),
        (["--also", "inc1", "--gateway", "gateway.toml"], "--gateway is for one robot"),
        (["--also", "inc1", "--backend", "can"], "has one robot in a world"),
        (["--also", "inc1@a"], "is no place"),
    ],
)
def test_wrong_uses_of_also_are_refused(options: list[str], message: str, tmp_path, monkeypatch) -> None:
    monkeypatch.setattr(up, "run", lambda coroutine: coroutine.close())
    command = ["up", "inc1", "--local-root", str(tmp_path), "--no-node-manager", *options]
    result = CliRunner().invoke(app, command)
    assert result.exit_code == 1
    assert message in " ".join(result.stderr.split())


def test_also_starts_one_runner_for_each_robot_in_one_world(tmp_path, monkeypatch) -> None:
    started = []
    monkeypatch.setattr(up, "run", lambda coroutine: (started.append(coroutine.cr_frame.f_locals), coroutine.close()))
    command = ["up", "inc1", "--also", "inc1", "--also", "inc1:110", "--backend", "kinematic", "--world", "street"]
    result = CliRunner().invoke(app, [*command, "--local-root", str(tmp_path), "--no-node-manager"])
    assert result.exit_code == 1, "kinematic has no worlds"
    command = ["up", "inc1", "--also", "inc1", "--also", "inc1:110", "--backend", "kinematic"]
    result = CliRunner().invoke(app, [*command, "--local-root", str(tmp_path), "--no-node-manager"])
    assert result.exit_code == 0, result.output
    (given,) = started
    runners = [given["runner"], *given["further"]]
    assert [runner.config.subsystem for runner in runners] == [101, 102, 110]
    assert {runner.config.backend for runner in runners} == {"kinematic"}
    assert len({runner.config.world for runner in runners}) == 1


@pytest.mark.parametrize(
    ("arguments", "message"),
    [(["102", "0.1.102"], "is not the id of a component"), (["102", "x"], "x")],
)
def test_wrong_leaders_are_refused(arguments: list[str], message: str) -> None:
    result = CliRunner().invoke(app, ["follow", *arguments])
    assert result.exit_code != 0
    assert message in result.stderr
