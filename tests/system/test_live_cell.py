"""Tasks on a running cell, one after the other, as a user carries them out: cell and client are processes."""

from __future__ import annotations

import pytest
from tests.helpers.command_line import RunningRobot, shared_robot, start

pytest.importorskip("mujoco", reason="MuJoCo is not installed")
pytest.importorskip("coal", reason="needs the extra 'cell'")

pytestmark = [pytest.mark.slow, pytest.mark.long, pytest.mark.alone, pytest.mark.timeout(1200)]


def carry_out(task: str, cell: RunningRobot) -> tuple[int, str, str]:
    """Exit status, output and errors of a task."""
    with start("cell", task, "--connect", cell.local) as process:
        output, errors = process.communicate(timeout=400)
    return process.returncode, output, errors


def test_an_arm_is_built_throws_steps_and_is_taken_apart() -> None:
    with shared_robot("cell", backend="sim") as cell:
        for task in ("assemble", "lift", "step", "take-apart"):
            status, output, errors = carry_out(task, cell)
            assert status == 0, f"{task}: {output}\n{errors}"
        status, _, errors = carry_out("lift", cell)
        assert status == 1, "there is no arm any more"
        assert "Traceback" not in errors
