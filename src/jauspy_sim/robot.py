"""A robot in MuJoCo's physics, advanced in whole steps."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from threading import RLock
from typing import Final

import mujoco

from jauspy.errors import ConfigError
from jauspy.platform.backend import PlacedRobot
from jauspy.platform.chassis import chassis_of
from jauspy.platform.contract import OptionalPart
from jauspy.platform.description import RobotModel
from jauspy.platform.drives import SLIP_FACTOR, FixedBase, GroundDrive
from jauspy.platform.force_torque import SampledForceTorque
from jauspy.platform.lights import Lamp, switched_lamps
from jauspy.platform.localizer import Localizer, Turning
from jauspy.platform.motors import MotorLoad
from jauspy.platform.power_supply import PowerSupply
from jauspy_sim.assembly import (
    STEP_TOLERANCE,
    TIMESTEP,
    DrawnModel,
    build,
    build_several,
    first_sides,
    prefix,
    redirect_warnings,
)
from jauspy_sim.driving.truth import DrivingTruth
from jauspy_sim.physics.contacts import SimulatedContacts
from jauspy_sim.physics.dynamics import dynamics_of
from jauspy_sim.physics.joints import SimulatedJoints
from jauspy_sim.physics.sensors import SimulatedLidar, shapes_of, simulated_force_torque
from jauspy_sim.physics.tracks import SimulatedTracks
from jauspy_sim.physics.wheels import SimulatedWheels
from jauspy_sim.rendering.cameras import SimulatedCamera, SimulatedCameras
from jauspy_sim.rendering.viewer import Viewer
from jauspy_sim.simulation import RobotPhysics, Simulation

MAX_OVERLAP: Final = 0.05
"""Metres by which the shapes of a robot may be in others where it starts among other robots."""

SKIDDING: Final = 0.04
"""Metres after one radian by which tracks shift the robot, besides what the turning point of its file explains."""


class SimulatedRobot:
    """One robot, alone in its world or with others.

    The same commands at the same times give the same trajectory, bit for bit.
    """

    def __init__(
        self,
        model: mujoco.MjModel,
        robot: RobotModel,
        drawn: DrawnModel | None = None,
        *,
        simulation: Simulation | None = None,
        first_side: int = 0,
    ) -> None:
        """Put a robot into a simulation that has not settled yet, which others share; without one it is alone."""
        self._model, self._drawn, self._robot = model, drawn, robot
        self._viewer: Viewer | None = None
        self._simulation = simulation or Simulation(model)
        self._data = data = self._simulation.data
        self.name_prefix = name_prefix = prefix(robot.description.name)
        """Of the names of its parts in the model."""
        tracks = SimulatedTracks(model, data, name_prefix, robot.tracks, first_side) if robot.tracks else None
        wheels = SimulatedWheels(model, data, name_prefix, robot.wheels) if robot.wheels else None
        self.drive: SimulatedTracks | SimulatedWheels | FixedBase = tracks or wheels or FixedBase()
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
        self._physics = RobotPhysics(tracks, wheels, tuple(self.groups.values()))
        self._simulation.add(self._physics)
        self.lamps: Sequence[Lamp] = switched_lamps(robot.lamps)
        """Lamps of the robot."""
        self._owed = self._advanced_to = 0.0
        if simulation is None:
            self._simulation.settle()
            self.equip([self])

    def equip(self, robots: Sequence[SimulatedRobot]) -> None:
        """Add the sensors, once the world has settled; `robots` are all those of the world, which lidars see."""
        model, data, name_prefix, robot = self._model, self._data, self.name_prefix, self._robot
        others = [other for other in robots if other is not self]
        seen = shapes_of(model, [other.name_prefix for other in others])
        lamps = [(other.name_prefix, lamp) for other in others for lamp in other.lamps]
        self.lidars: Mapping[str, SimulatedLidar] = {
            setup.name: SimulatedLidar(model, data, data.body(f"{name_prefix}{setup.link}"), setup, seen)
            for setup in robot.lidars
        }
        """Lidars by name."""
        self.force_torque: Mapping[str, SampledForceTorque] = {
            setup.name: simulated_force_torque(data, name_prefix, setup) for setup in robot.force_torque
        }
        """Sensors of force and torque by name."""
        tracks, wheels = self._physics.tracks, self._physics.wheels
        if tracks is not None:
            tracks.slip_width = SLIP_FACTOR * chassis_of(robot).track_separation
        if (measured := tracks or wheels) and not robot.localization.is_exact(default=False):
            turning = Turning(robot.tracks.turning_point, SKIDDING) if robot.tracks else Turning()
            self._localizer = Localizer(robot.localization, measured, turning)
        located = () if self._localizer is None else (self._localizer,)
        self._contacts = SimulatedContacts(
            model, data, name_prefix, {name: setup.joints for name, setup in robot.groups.items()}
        )
        self._supply = PowerSupply(robot, self.lamps, self._motor_loads, self._halt)
        measuring = (*self.lidars.values(), *self.force_torque.values(), *located)
        self._physics.sensors = (*measuring, self._contacts, self._supply)
        for sensor in self._physics.sensors:
            sensor.step(self.time)
        self._twist = self.drive.twist()
        self._cameras = SimulatedCameras(model, data, name_prefix, robot, self.lamps, others=lamps, drawn=self._drawn)

    @classmethod
    def open(cls, robot: RobotModel, world: str) -> SimulatedRobot:
        """Build a robot in a world, and let it settle. Raises `ConfigError` with the known worlds."""
        redirect_warnings()
        return cls(build(robot, world, drawn=False), robot, DrawnModel(robot, world))

    @property
    def world_lock(self) -> RLock:
        """The lock of the simulation, which other robots may share."""
        return self._simulation.lock

    @property
    def model(self) -> mujoco.MjModel:
        """MuJoCo's model of the robot and its world, without what is only seen of the robot."""
        return self._model

    @property
    def data(self) -> mujoco.MjData:
        """MuJoCo's state; writing to it moves the world."""
        return self._data

    def driving_truth(self, step: float) -> DrivingTruth:
        """The truth about its drives from now on; takes seconds. `step` metres is the highest that the robot climbs."""
        truth = DrivingTruth(self._model, self._data, self.name_prefix, self.drive.pose, step)
        self._physics.sensors = (*self._physics.sensors, truth.watch)
        return truth

    @property
    def cameras(self) -> Mapping[str, SimulatedCamera]:
        """Cameras by name."""
        return self._cameras.cameras

    @property
    def optional_parts(self) -> Sequence[OptionalPart]:
        """Those of the chassis, the localisation unless the pose is exact, contacts, lamps, and those of the supply."""
        located = () if self._localizer is None else (self._localizer,)
        return (*self.drive.optional_parts, *located, self._contacts, *self.lamps, *self._supply.parts)

    @property
    def time(self) -> float:
        """Seconds simulated, a whole number of steps."""
        return self._simulation.time

    def advance(self, dt: float) -> None:
        """Simulate `dt` seconds in whole steps of `TIMESTEP`; the remainder is carried over to the next call.

        Of several robots in a world, the others have perhaps simulated these seconds already.
        """
        if not 0.0 <= dt < math.inf:
            raise ValueError(f"cannot advance by {dt} s; time only goes forward")
        self._owed += dt / TIMESTEP
        steps = math.floor(self._owed + STEP_TOLERANCE)
        if not steps:
            return
        self._owed -= steps
        before = self._twist if self._simulation.is_shared else self.drive.twist()
        self._simulation.advance(self._physics, steps)
        elapsed, self._advanced_to = self.time - self._advanced_to, self.time
        if self._simulation.is_shared:  # the others may advance the world before this robot is asked again
            self._twist = self.drive.twist()
        if isinstance(self.drive, GroundDrive) and elapsed > 0.0:
            self.drive.update_acceleration(before, elapsed)
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
        with self.world_lock:
            self._halt()
            self._cameras.close()
            if self._viewer is not None:
                self._viewer.close()
                self._viewer = None

    def _halt(self) -> None:
        """Stop all motors."""
        self.drive.stop()
        for group in self.groups.values():
            group.hold()

    def _motor_loads(self) -> Iterator[MotorLoad]:
        for group in self.groups.values():
            yield from group.motor_loads()
        if (rolling := self._physics.tracks or self._physics.wheels) is not None:
            yield from rolling.motor_loads()


def open_several(robots: Sequence[PlacedRobot], world: str) -> tuple[SimulatedRobot, ...]:
    """Build several robots in one world, and let them settle.

    Raises `ConfigError` with the known worlds, and for a robot that starts inside of something.
    """
    redirect_warnings()
    simulation = Simulation(build_several(robots, world))
    opened = tuple(
        SimulatedRobot(
            simulation.model,
            placed.robot,
            DrawnModel(placed.robot, world, tuple(robots)),
            simulation=simulation,
            first_side=first_side,
        )
        for placed, first_side in zip(robots, first_sides(row.robot for row in robots), strict=True)
    )
    mujoco.mj_forward(simulation.model, simulation.data)
    if problem := _overlap(simulation, [placed.robot.description.name for placed in robots]):
        raise ConfigError(problem)
    simulation.settle()
    for robot in opened:
        robot.equip(opened)
    return opened


def _overlap(simulation: Simulation, names: Sequence[str]) -> str:
    """A text about a robot that is inside of something else; empty if none is."""
    model = simulation.model
    for contact in simulation.data.contact:
        if contact.dist > -MAX_OVERLAP:
            continue
        bodies = [str(model.body(model.geom_bodyid[geom]).name) for geom in (contact.geom1, contact.geom2)]
        owners = [next((name for name in names if body.startswith(prefix(name))), None) for body in bodies]
        if owners[0] == owners[1]:
            continue
        robot, other = (owners[0], owners[1] or bodies[1]) if owners[0] else (owners[1], bodies[0])
        thing = "the world" if other == "world" else other
        return f"the robot {robot} starts inside of {thing}: give it another place, as in inc1:102@-3,0"
    return ""
