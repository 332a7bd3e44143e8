"""MuJoCo's own window, which shows a simulation while it is advanced."""

from __future__ import annotations

import os
import threading
import time
from collections.abc import Callable
from importlib import import_module
from typing import Any, Final

import mujoco

from jauspy.errors import ConfigError
from jauspy_sim.models.track_visuals import Treads
from jauspy_sim.models.whips import Whips

DISPLAYS: Final = ("DISPLAY", "WAYLAND_DISPLAY")
"""Variables of the environment, one of which names a display."""

CLOSING_TIME: Final = 5.0
"""Seconds that the window has to close."""

FRAME_RATE: Final = 30.0
"""Hz at which the window gets the newest state."""


class Viewer:
    """A window on a simulation. Belongs to the thread that advances it; the mouse moves the view, not the world.

    It shows a separate model, so that physics needs no visual shapes and never waits for drawing.
    """

    def __init__(self, model: mujoco.MjModel, data: mujoco.MjData, clock: Callable[[], float] = time.monotonic) -> None:
        """`model` is the model to show, `data` the state of a model with the same joints.

        Raises `ConfigError` without a display.
        """
        if not any(os.environ.get(name) for name in DISPLAYS):
            raise ConfigError("there is no display for a window: DISPLAY is not set; watch a camera instead")
        self._model, self._source, self._clock = model, data, clock
        self._data, self._treads, self._whips = mujoco.MjData(model), Treads(model), Whips(model)
        self._due = clock()
        self._copy()
        others = set(threading.enumerate())
        try:
            self._window: Any = import_module("mujoco.viewer").launch_passive(
                model, self._data, show_left_ui=False, show_right_ui=False
            )
        except Exception as error:  # whatever GLFW and the display raise
            raise ConfigError(f"MuJoCo cannot open a window here: {error}; watch a camera instead") from error
        self._drawing = set(threading.enumerate()) - others

    @property
    def is_open(self) -> bool:
        """False once the user has closed the window."""
        return bool(self._window.is_running())

    def show(self) -> None:
        """Show the present state, at most `FRAME_RATE` times a second."""
        now = self._clock()
        if now < self._due or not self.is_open:
            return
        self._due = now + 1.0 / FRAME_RATE
        with self._window.lock():
            self._copy()
        self._window.sync()

    def close(self) -> None:
        """Close the window, and wait for its thread, amid which Python must not end. May be called twice."""
        self._window.close()
        for drawn in self._drawing:
            drawn.join(CLOSING_TIME)

    def _copy(self) -> None:
        model, data, source = self._model, self._data, self._source
        data.time = source.time
        data.qpos[:], data.mocap_pos[:], data.mocap_quat[:] = source.qpos, source.mocap_pos, source.mocap_quat
        data.userdata[:] = source.userdata
        mujoco.mj_kinematics(model, data)
        self._treads.place(data)
        self._whips.place(data, source.time)
        mujoco.mj_comPos(model, data)
        mujoco.mj_camlight(model, data)
        mujoco.mj_tendon(model, data)
