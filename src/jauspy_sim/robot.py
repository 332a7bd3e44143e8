"""A robot in MuJoCo's physics, advanced in whole steps."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import Final

import mujoco

from jauspy.platform.chassis import chassis_of
from jauspy.platform.contract import OptionalPart
from jauspy.platform.description import RobotModel
from jauspy.platform.drives import SLIP_FACTOR, FixedBase, GroundDrive
from jauspy.platform.force_torque import SampledForceTorque
from jauspy.platform.lights import switched_lamps
from jauspy.platform.localizer import Localizer, Turning
from jauspy.platform.ranging import Scanner
from jauspy_sim.assembly import STEP_TOLERANCE, TIMESTEP, DrawnModel, build, prefix, redirect_warnings
from jauspy_sim.physics.contacts import SimulatedContacts
from jauspy_sim.physics.dynamics import dynamics_of
from jauspy_sim.physics.joints import SimulatedJoints
from jauspy_sim.physics.sensors import SimulatedLidar, simulated_force_torque
from jauspy_sim.physics.tracks import SimulatedTracks
from jauspy_sim.physics.wheels import SimulatedWheels
from jauspy_sim.rendering.cameras import SimulatedCamera, SimulatedCameras
from jauspy_sim.rendering.viewer import Viewer

SETTLING_STEPS: Final = 250
"""Steps before time starts, in which the robot settles on the ground."""

MAX_STEPS_AT_ONCE: Final = 2
"""Maximal number of physics steps in one call of MuJoCo."""

SKIDDING: Final = 0.04
"""Metres after one radian by which tracks shift the robot, besides what the turning point of its file explains."""


class SimulatedRobot:
    """One robot and its world. The same commands at the same times give the same trajectory, bit for bit."""

    def __init__(self, model: mujoco.MjModel, robot: RobotModel, drawn: DrawnModel | None = None) -> None:
        self._model, self._drawn = model, drawn
        self._viewer: Viewer | None = None
        self._data = data = mujoco.MjData(model)
        name_prefix = prefix(robot.description.name)
        self._tracked = SimulatedTracks(model, data, name_prefix, robot.tracks) if robot.tracks else None
        self._wheels = SimulatedWheels(model, data, name_prefix, robot.wheels) if robot.wheels else None
        self.drive: SimulatedTracks | SimulatedWheels | FixedBase = self._tracked or self._wheels or FixedBase()
        """The chassis on tracks or wheels, or a base that does not move."""
        self._localizer: Localizer | None = None
        self.groups: Mapping[str, SimulatedJoints] = {
            name: SimulatedJoints(
                model,
                data,
                name_prefix,
                robot.description,
                setup,
                dynamics=dynamics_of(model, data, name_prefix, robot, setup),
            )
            for name, setup in robot.groups.items()
        }
        """Joints other than the tracks', by the names that the robot's description gives them."""
        self._every = math.gcd(MAX_STEPS_AT_ONCE, *(group.every for group in self.groups.values()))
        self._sensors: tuple[Scanner | SampledForceTorque | Localizer | SimulatedContacts, ...] = ()
        mujoco.mj_forward(model, data)
        self._owed = 0.0
        self._steps = -SETTLING_STEPS
        self._run(SETTLING_STEPS)
        self.lidars: Mapping[str, SimulatedLidar] = {
            setup.name: SimulatedLidar(model, data, data.body(f"{name_prefix}{setup.link}"), setup)
            for setup in robot.lidars
        }
        """Lidars by name."""
        self.force_torque: Mapping[str, SampledForceTorque] = {
            setup.name: simulated_force_torque(data, name_prefix, setup) for setup in robot.force_torque
        }
        """Sensors of force and torque by name."""
        if self._tracked is not None:
            self._tracked.slip_width = SLIP_FACTOR * chassis_of(robot).track_separation
        if (measured := self._tracked or self._wheels) and not robot.localization.is_exact(default=False):
            turning = Turning(robot.tracks.turning_point, SKIDDING) if robot.tracks else Turning()
            self._localizer = Localizer(robot.localization, measured, turning)
        located = () if self._localizer is None else (self._localizer,)
        self._contacts = SimulatedContacts(
            model, data, name_prefix, {name: setup.joints for name, setup in robot.groups.items()}
        )
        self._sensors = (*self.lidars.values(), *self.force_torque.values(), *located, self._contacts)
        self._update_sensors()
        self._lamps = switched_lamps(robot.lamps)
        self._cameras = SimulatedCameras(model, data, name_prefix, robot, self._lamps, drawn=drawn)

    @classmethod
    def open(cls, robot: RobotModel, world: str) -> SimulatedRobot:
        """Build a robot in a world, and let it settle. Raises `ConfigError` with the known worlds."""
        redirect_warnings()
        return cls(build(robot, world, drawn=False), robot, DrawnModel(robot, world))

    @property
    def model(self) -> mujoco.MjModel:
        """MuJoCo's model of the robot and its world, without what is only seen of the robot."""
        return self._model

    @property
    def data(self) -> mujoco.MjData:
        """MuJoCo's state; writing to it moves the world."""
        return self._data

    @property
    def cameras(self) -> Mapping[str, SimulatedCamera]:
        """Cameras by name."""
        return self._cameras.cameras

    @property
    def optional_parts(self) -> Sequence[OptionalPart]:
        """The optional parts of the chassis, the localisation unless the pose is exact, its contacts, and the lamps."""
        located = () if self._localizer is None else (self._localizer,)
        return (*self.drive.optional_parts, *located, self._contacts, *self._lamps)

    @property
    def time(self) -> float:
        """Seconds simulated, a whole number of steps."""
        return self._steps * TIMESTEP

    def advance(self, dt: float) -> None:
        """Simulate `dt` seconds in whole steps of `TIMESTEP`; the remainder is carried over to the next call."""
        if not 0.0 <= dt < math.inf:
            raise ValueError(f"cannot advance by {dt} s; time only goes forward")
        self._owed += dt / TIMESTEP
        steps = math.floor(self._owed + STEP_TOLERANCE)
        if not steps:
            return
        self._owed -= steps
        before = self.drive.twist()
        self._run(steps)
        if isinstance(self.drive, GroundDrive):
            self.drive.update_acceleration(before, steps * TIMESTEP)
        for lidar in self.lidars.values():
            lidar.wait(self.time)
        self._cameras.show()
        if self._viewer is not None:
            self._viewer.show()

    def view(self) -> None:
        """Open a window that shows the robot and its world. Raises `ConfigError` without a display."""
        if self._viewer is None:
            self._viewer = Viewer(self._model if self._drawn is None else self._drawn.build(), self._data)

    def close(self) -> None:
        """Stop, and release the shared memory of the cameras; MuJoCo's memory is released with the object."""
        self.drive.stop()
        for group in self.groups.values():
            group.hold()
        self._cameras.close()
        if self._viewer is not None:
            self._viewer.close()
            self._viewer = None

    def _run(self, steps: int) -> None:
        """Run physics steps; controllers and sensors act on a fixed grid, however `advance` divides the time."""
        every, end = self._every, self._steps + steps
        while self._steps < end:
            phase = self._steps % every
            if not phase:
                self._control()
            count = min(every - phase, end - self._steps)
            if self._tracked is None:
                mujoco.mj_step(self._model, self._data, count)
            else:
                for _ in range(count):
                    self._tracked.step()
            self._steps += count
            if phase + count == every:
                if self._wheels is not None:
                    self._wheels.step(every * TIMESTEP)
                self._update_sensors()

    def _control(self) -> None:
        for group in self.groups.values():
            if not self._steps % group.every:
                group.control()

    def _update_sensors(self) -> None:
        now = self.time
        for sensor in self._sensors:
            sensor.step(now)
