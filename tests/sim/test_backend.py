"""The entry point of the simulation, with and without MuJoCo."""

import pytest

from jauspy.errors import ConfigError
from jauspy.modules.robots import load, robot_model
from jauspy_sim import backend as backend_module
from jauspy_sim.backend import MujocoBackend


def test_says_what_to_install_without_mujoco(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(backend_module, "find_spec", lambda name: None)
    with pytest.raises(ConfigError, match=r"pip install 'jauspy\[sim\]'"):
        MujocoBackend().open(robot_model(load("inc1")), "demo")
