"""The entry point of the simulation, with and without MuJoCo."""

import os
import subprocess
import sys

import pytest

from jauspy.errors import ConfigError
from jauspy.robot.robot_files import load, robot_model
from jauspy_sim import backend, gl_libraries

MODEL = robot_model(load("inc1"))


def test_missing_mujoco_error_names_the_extra(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(backend, "find_spec", lambda name: None)
    with pytest.raises(ConfigError, match=r"pip install 'jauspy\[sim\]'"):
        backend.MujocoBackend().open(MODEL, "yard")


@pytest.mark.parametrize(
    ("way", "package"), [("egl", "libegl1 and libopengl0"), ("osmesa", "libosmesa6"), ("OSMesa", "libosmesa6")]
)
def test_missing_gl_library_is_one_sentence(monkeypatch, way: str, package: str) -> None:
    monkeypatch.setenv("MUJOCO_GL", way)
    monkeypatch.setattr(gl_libraries, "_loads", lambda library: False)
    with pytest.raises(
        ConfigError, match=rf"MUJOCO_GL={way.lower()} needs lib.*: install {package}, or unset MUJOCO_GL"
    ):
        backend.MujocoBackend().open(MODEL, "empty")


def test_egl_needs_opengl_too(monkeypatch) -> None:
    """As on a Debian with libegl1 alone."""
    monkeypatch.setenv("MUJOCO_GL", "egl")
    monkeypatch.setattr(gl_libraries, "_loads", lambda library: library == "libEGL.so.1")
    assert gl_libraries.missing_gl("egl")
    with pytest.raises(ConfigError, match=r"MUJOCO_GL=egl needs libOpenGL.so.0, .*: install libegl1 and libopengl0"):
        backend.MujocoBackend().open(MODEL, "empty")


@pytest.mark.slow
def test_invalid_mujoco_gl_is_one_sentence() -> None:
    """In a process of its own: MuJoCo reads it once, when it is imported."""
    code = (
        "from jauspy.robot.robot_files import load, robot_model; from jauspy_sim.backend import MujocoBackend;"
        "MujocoBackend().open(robot_model(load('inc1')), 'empty')"
    )
    environment = {**os.environ, "MUJOCO_GL": "bogus"}
    run = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=False, env=environment)
    assert "ConfigError: the backend 'sim' cannot import MuJoCo with MUJOCO_GL=bogus: invalid value" in run.stderr
