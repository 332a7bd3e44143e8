"""`jauspy map`: wrong uses, and a map from a running robot."""

import subprocess

import pytest
import yaml
from tests.helpers.command_line import JAUSPY

from jauspy.cli import map as map_robot
from jauspy.cli.main import app
from jauspy.testing import LocalNode


@pytest.mark.slow
def test_map_of_the_surroundings_is_written(robot, node_manager: LocalNode, tmp_path):
    command = [*JAUSPY, "map", "yard", "--seconds", "2", "--connect", node_manager.local, "--id", "42.7.1"]
    done = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, check=False, timeout=60)
    assert done.returncode == 0, done.stderr
    assert "yard.pgm and yard.yaml" in done.stdout
    notes = yaml.safe_load((tmp_path / "yard.yaml").read_text())
    assert (tmp_path / notes["image"]).read_bytes().startswith(b"P5\n")


@pytest.mark.parametrize(
    ("options", "said"),
    [
        (["nowhere/yard"], "does not exist"),
        (["yard", "--size", "1000", "--resolution", "0.01"], "cells along a side; a map has 2..4000"),
        (["yard", "--elevation"], "--elevation and --cloud ADDRESS belong together"),
        (["yard", "--cloud", "ipc:///none"], "--elevation and --cloud ADDRESS belong together"),
        (["yard", "--elevation", "--cloud", "ipc:///none", "--size", "100"], "an elevation grid has 4..400"),
    ],
)
def test_invalid_options_are_rejected_before_mapping(options, said, tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    from typer.testing import CliRunner

    result = CliRunner().invoke(app, ["map", *options])
    assert result.exit_code == 1
    assert said in result.output + result.stderr


def test_missing_numpy_error_names_the_extra(monkeypatch):
    from typer.testing import CliRunner

    monkeypatch.setattr(map_robot, "find_spec", lambda name: None)
    result = CliRunner().invoke(app, ["map", "yard"])
    assert result.exit_code == 1
    assert "pip install 'jauspy[map]'" in result.output + result.stderr
