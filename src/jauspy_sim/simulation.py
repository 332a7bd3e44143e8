"""The physics of a world with one robot or several, in whole steps."""

from __future__ import annotations

import math
from collections.abc import Sequence
from threading import RLock
from typing import Final, Protocol

import mujoco

from jauspy_sim.assembly import TIMESTEP
from jauspy_sim.physics.joints import SimulatedJoints
from jauspy_sim.physics.tracks import SimulatedTracks
from jauspy_sim.physics.wheels import SimulatedWheels

SETTLING_STEPS: Final = 250
"""Steps before time starts, in which robots settle on the ground."""

MAX_STEPS_AT_ONCE: Final = 2
"""Maximal number of physics steps in one call of MuJoCo."""

SINGLE_CONTACTS: Final = int(getattr(mujoco.mjtDisableBit, "mjDSBL_MULTICCD", 0))
"""Flag of MuJoCo, from version 4 on: one contact of each pair of rounded shapes or meshes; 0 before, when there was no
more than that."""

MAX_AHEAD: Final = 50
"""Steps, 0.1 s: how far the others may take the world beyond the time of a robot that pauses, before the rest is lost
to it. A thread that falls further behind the clock skips its steps, too."""


class Sampled(Protocol):
    """A sensor, or something else that is called on a fixed grid."""

    def step(self, now: float) -> object:
        """Measure; `now` is the time of the world in seconds."""
        ...


class RobotPhysics:
    """The parts of one robot that act in the steps of its world."""

    def __init__(
        self,
        tracks: SimulatedTracks | None,
        wheels: SimulatedWheels | None,
        groups: Sequence[SimulatedJoints],
    ) -> None:
        self.tracks, self.wheels, self.groups = tracks, wheels, groups
        self.sensors: Sequence[Sampled] = ()
        """Those that measure after the steps; none while the world settles."""
        self.ahead = 0
        """Steps that the world has made for the others, beyond the time of this robot."""


class Simulation:
    """A world that all its robots advance: the first that asks for a step makes it for all of them.

    The same commands at the same times give the same trajectory, bit for bit. Threads that use it, or a robot in it,
    hold `lock`.
    """

    def __init__(self, model: mujoco.MjModel) -> None:
        self.model, self.data = model, mujoco.MjData(model)
        self.lock = RLock()
        self._robots: list[RobotPhysics] = []
        self._tracks: list[SimulatedTracks] = []
        self._every = MAX_STEPS_AT_ONCE
        self._steps = -SETTLING_STEPS

    @property
    def time(self) -> float:
        """Seconds simulated, a whole number of steps."""
        return self._steps * TIMESTEP

    @property
    def is_shared(self) -> bool:
        """True with more than one robot."""
        return len(self._robots) > 1

    def add(self, robot: RobotPhysics) -> None:
        """Add a robot of the model, before the world settles."""
        self._robots.append(robot)
        if robot.tracks is not None:
            self._tracks.append(robot.tracks)
        self._every = math.gcd(self._every, *(group.every for group in robot.groups))

    def settle(self) -> None:
        """Let the robots settle on the ground; then time starts."""
        mujoco.mj_forward(self.model, self.data)
        self._run(SETTLING_STEPS)

    def advance(self, robot: RobotPhysics, steps: int) -> None:
        """Advance the time of a robot, and the world unless the others have done so already."""
        made = min(robot.ahead, steps)
        robot.ahead -= made
        if remaining := steps - made:
            self._run(remaining)
            for other in self._robots:
                if other is not robot:
                    other.ahead = min(other.ahead + remaining, MAX_AHEAD)

    def _run(self, steps: int) -> None:
        """Run physics steps; controllers and sensors act on a fixed grid, however `advance` divides the time."""
        model, data, tracks = self.model, self.data, self._tracks
        every, end, trusting = self._every, self._steps + steps, not SINGLE_CONTACTS
        while self._steps < end:
            phase = self._steps % every
            if not phase:
                self._control()
            count = min(every - phase, end - self._steps)
            if not tracks:
                mujoco.mj_step(model, data, count)
            else:
                for _ in range(count):
                    mujoco.mj_step1(model, data)
                    if not all(chassis.run_belts_around(trusting=trusting) for chassis in tracks):
                        self._begin_step_with_single_contacts()
                    mujoco.mj_step2(model, data)
                    for chassis in tracks:
                        chassis.take_run()
            self._steps += count
            if phase + count == every:
                self._measure(every * TIMESTEP)

    def _begin_step_with_single_contacts(self) -> None:
        """Make the first half of a step anew, with one contact of each pair of rounded shapes.

        Of the several that MuJoCo finds from version 4 on, some at edges have the normal of the face beside it.
        """
        option = self.model.opt
        option.disableflags |= SINGLE_CONTACTS
        mujoco.mj_step1(self.model, self.data)
        option.disableflags &= ~SINGLE_CONTACTS
        for chassis in self._tracks:
            chassis.run_belts_around(trusting=True)

    def _control(self) -> None:
        for robot in self._robots:
            for group in robot.groups:
                if not self._steps % group.every:
                    group.control()

    def _measure(self, dt: float) -> None:
        now = self.time
        for robot in self._robots:
            if robot.wheels is not None:
                robot.wheels.step(dt)
            for sensor in robot.sensors:
                sensor.step(now)
