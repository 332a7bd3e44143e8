"""A robot in MuJoCo's physics, advanced in whole steps."""

from __future__ import annotations

import math
from typing import Final

import mujoco

from jauspy_sim import log
from jauspy_sim.assembly import TIMESTEP, build, prefix
from jauspy_sim.tracks import TrackedDrive

SETTLING_STEPS: Final = 250
"""Steps before time starts, in which the robot sinks into its contacts and comes to rest."""

ROUNDING: Final = 1e-9
"""Part of a step by which sums of floats may fall short of a whole one."""


class SimulatedRobot:
    """One robot and its world. The same commands at the same times give the same trajectory, bit for bit."""

    def __init__(self, model: mujoco.MjModel, name_prefix: str) -> None:
        self._model = model
        self._data = mujoco.MjData(model)
        self._drive = TrackedDrive(model, self._data, name_prefix)
        self._steps = 0
        self._owed = 0.0
        self._run(SETTLING_STEPS)

    @classmethod
    def open(cls, robot: str, world: str) -> SimulatedRobot:
        """Build and settle that robot in that world; `ConfigError` lists the names there are."""
        log.redirect()
        return cls(build(robot, world), prefix(robot))

    @property
    def drive(self) -> TrackedDrive:
        """The tracked chassis."""
        return self._drive

    @property
    def time(self) -> float:
        """Seconds simulated, a whole number of steps."""
        return self._steps * TIMESTEP

    def advance(self, dt: float) -> None:
        """Simulate `dt` seconds in whole steps of `TIMESTEP`; the rest is carried to the next call."""
        if not 0.0 <= dt < math.inf:
            raise ValueError(f"cannot advance by {dt} s; time only goes forward")
        self._owed += dt / TIMESTEP
        steps = math.floor(self._owed + ROUNDING)
        if not steps:
            return
        self._owed -= steps
        before = self._drive.twist()
        self._run(steps)
        self._steps += steps
        self._drive.moved(before, steps * TIMESTEP)

    def close(self) -> None:
        """Stop; MuJoCo's memory goes with the object."""
        self._drive.stop()

    def _run(self, steps: int) -> None:
        for _ in range(steps):
            mujoco.mj_step(self._model, self._data)
            self._drive.rewind_belts()
