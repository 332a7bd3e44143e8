"""MuJoCo's window on a simulation; with a display, which Xvfb can be."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys

import pytest

pytest.importorskip("mujoco", reason="MuJoCo is not installed")

from jauspy.errors import ConfigError
from jauspy.robot.robot_files import load, robot_model
from jauspy.robot.runner import RobotRunner
from jauspy.transport import LoopbackHub, LoopbackTransport
from jauspy_sim.robot import SimulatedRobot

SHOWN = """
import sys, time
from jauspy.robot.robot_files import load, robot_model
from jauspy_sim.robot import SimulatedRobot
robot = SimulatedRobot.open(robot_model(load("inc1")), "empty")
robot.view()
robot.drive.set_effort(0.5, 0.0)
end = time.monotonic() + 10.0
while robot._viewer._data.qpos[0] < 0.05 and time.monotonic() < end:
    robot.advance(0.01)
print("shown at", robot._viewer._data.qpos[0], robot._viewer.is_open)
robot.close()
"""


def test_without_a_display_the_error_says_what_to_do(monkeypatch):
    for name in ("DISPLAY", "WAYLAND_DISPLAY"):
        monkeypatch.delenv(name, raising=False)
    robot = SimulatedRobot.open(robot_model(load("inc1")), "empty")
    with pytest.raises(ConfigError, match="no display for a window: DISPLAY is not set; watch a camera instead"):
        robot.view()
    robot.close()


async def test_a_backend_without_a_window_says_so():
    hub = LoopbackHub()
    runner = RobotRunner(
        load("inc1"), lambda component: LoopbackTransport(component, hub), backend="kinematic", view=True
    )
    with pytest.raises(ConfigError, match="'kinematic' has no window to view"):
        await runner.open()


@pytest.mark.slow
def test_the_window_follows_the_robot(tmp_path):
    if shutil.which("Xvfb") is None:
        pytest.skip("Xvfb is not installed")
    read, write = os.pipe()
    with subprocess.Popen(
        ["Xvfb", "-displayfd", str(write), "-screen", "0", "640x480x24", "-nolisten", "tcp"],
        pass_fds=(write,),
        stderr=subprocess.DEVNULL,
    ) as display:
        os.close(write)
        with os.fdopen(read) as told:
            number = (
                told.readline().strip()
            )  # to the end of the line, which Xvfb writes separately: it ends if it cannot
        try:
            run = subprocess.run(
                [sys.executable, "-c", SHOWN],
                env={**os.environ, "DISPLAY": f":{number}"},
                capture_output=True,
                text=True,
                timeout=100,
                check=False,
                cwd=tmp_path,
            )
        finally:
            display.terminate()
    if "GLX" in run.stderr or "OpenGL" in run.stderr:
        pytest.skip(f"the display has no OpenGL: {run.stderr.splitlines()[-1]}")
    found = re.search(r"shown at ([\d.]+) True", run.stdout)
    assert found, run.stderr
    assert float(found[1]) >= 0.05
    assert run.returncode == 0
