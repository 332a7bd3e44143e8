"""The package `lerobot` reads a data set; it is in an environment of its own, for it needs PyTorch."""

from __future__ import annotations

import os
import subprocess
from collections.abc import Callable
from pathlib import Path

import pytest
from typer.testing import CliRunner

from jauspy.cli.main import app

PYTHON = os.environ.get("JAUSPY_LEROBOT_PYTHON")
READ = """
import sys
from lerobot.datasets.lerobot_dataset import LeRobotDataset

data = LeRobotDataset("local/run", root=sys.argv[1], video_backend="torchcodec")
frames = [data[index] for index in range(len(data))]
grey = [round(float(frame["observation.images.10_0_0_1-5004"].mean()) * 255) for frame in frames]
print(data.num_episodes, len(data), grey[0], grey[14], grey[15], grey[29], frames[20]["task"])
"""


@pytest.mark.slow
@pytest.mark.skipif(PYTHON is None, reason="JAUSPY_LEROBOT_PYTHON names no Python with lerobot and torchcodec")
def test_the_package_reads_a_data_set(run_file: Callable[..., Path], tmp_path: Path) -> None:
    runs = [str(run_file("one")), str(run_file("two", 0.5))]
    arguments = ["export", *runs, "--lerobot", "-o", str(tmp_path / "set"), "--fps", "5", "--task", "grasp"]
    assert CliRunner().invoke(app, arguments).exit_code == 0
    found = subprocess.run(
        [str(PYTHON), "-c", READ, str(tmp_path / "set")],
        env=os.environ | {"HF_HUB_OFFLINE": "1"},
        capture_output=True,
        text=True,
        check=False,
    )
    assert found.stdout.split() == ["2", "30", "18", "187", "18", "187", "grasp"], found.stderr
