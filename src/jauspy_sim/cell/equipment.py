"""Conveyor and part sensor, in MuJoCo."""

from __future__ import annotations

import math
from collections.abc import Iterable
from typing import Final

import mujoco
import numpy as np

from jauspy.geometry.poses import Transform
from jauspy.geometry.vectors import Rotation, add, product, rotation_about, scaled
from jauspy.platform.modular.cell import (
    Conveyor,
    ConveyorState,
    Observation,
    ObservedPart,
    PartSensor,
)
from jauspy.platform.modular.parts import CellSetup, ConveyorSetup, PartSensorSetup
from jauspy_sim.assembly import TIMESTEP, view
from jauspy_sim.cell.connectors import to_transform
from jauspy_sim.cell.part_cameras import PartCameras

BELT_ACCELERATION: Final = 1.0
"""m/s^2 of the conveyor's drive."""

BELT_BRAKING: Final = 3.0
"""m/s^2 of the conveyor when it is stopped: from its largest speed it stands within 0.2 s."""


class SimulatedConveyor(Conveyor):
    """A belt that is moved by its speed only: its position is set back to zero after each step."""

    def __init__(self, model: mujoco.MjModel, data: mujoco.MjData, setup: ConveyorSetup) -> None:
        self._qpos, self._qvel, self._ctrl = map(view, (data.qpos, data.qvel, data.ctrl))
        self._max_speed = setup.max_speed
        joint = model.joint("belt")
        self._position, self._dof = int(joint.qposadr[0]), int(joint.dofadr[0])
        self._drive = int(model.actuator("belt").id)
        self._travel = 0.0
        self._wanted = 0.0
        self._speed = 0.0
        self._braking = False

    def state(self) -> ConveyorState:
        """Speed and travel."""
        return ConveyorState(self._qvel[self._dof], self._travel)

    def set_speed(self, speed: float) -> None:
        """Run at this speed, within its limit; NaN and infinite speeds have no effect."""
        if math.isfinite(speed):
            self._wanted = min(self._max_speed, max(-self._max_speed, speed))
            self._braking = False

    def stop(self) -> None:
        """Brake as hard as it can."""
        self._wanted, self._braking = 0.0, True

    def control(self) -> None:
        """Approach the speed, and set the belt back."""
        if self._speed != self._wanted:
            change = (BELT_BRAKING if self._braking else BELT_ACCELERATION) * TIMESTEP
            self._speed += min(change, max(-change, self._wanted - self._speed))
            self._ctrl[self._drive] = self._speed
        self._travel += self._qpos[self._position]
        self._qpos[self._position] = 0.0


class SimulatedPartSensor(PartSensor):
    """Measures the poses of the parts that are not fixed and that it sees, with normally distributed errors."""

    def __init__(self, model: mujoco.MjModel, data: mujoco.MjData, cell: CellSetup, setup: PartSensorSetup) -> None:
        self._data = data
        self._setup = setup
        self._parts = [(part.name, part.type, int(model.body(part.name).id)) for part in cell.parts if not part.fixed]
        self._cameras: PartCameras | None = None
        if setup.cameras and self._parts:
            sought = [(name, cell.types[kind]) for name, kind, _ in self._parts]
            self._cameras = PartCameras(model, data, setup.cameras, sought)
        self._random = np.random.default_rng((setup.seed, cell.seed))
        self._state = Observation()
        self._due = 0.0
        self._blind_until = 0.0

    def blind(self, until: float) -> None:
        """Observe nothing until a time of the robot's clock, in seconds; the last observation stays with its time."""
        self._blind_until = max(self._blind_until, until)

    def state(self) -> Observation:
        """The last observation."""
        return self._state

    def step(self, now: float) -> None:
        """Measure when the next measurement is due."""
        if now < self._due - TIMESTEP / 2.0:
            return
        self._due = max(self._due, now) + 1.0 / self._setup.rate
        if now < self._blind_until:
            return
        data, setup = self._data, self._setup
        noise = self._random.standard_normal((len(self._parts), 9)).tolist()
        parts = []
        sights = [None] * len(self._parts) if self._cameras is None else self._cameras.sights()
        for (name, kind, body), sight, row in zip(self._parts, sights, noise, strict=True):
            if sight is None and self._cameras is not None:
                continue
            true = to_transform(data.xpos[body].tolist(), data.xmat[body].tolist())
            position = add(true.position, scaled((row[0], row[1], row[2]), setup.position_noise))
            turn = setup.angle_noise
            if sight is not None:
                along, across, angle = sight.camera.errors(sight.distance)
                position = add(position, sight.frame.rotate((along * row[6], across * row[7], across * row[8])))
                turn = math.hypot(turn, angle)
            rotation = product(true.rotation, small_turn((turn * row[3], turn * row[4], turn * row[5])))
            parts.append(ObservedPart(name, kind, Transform(rotation, position).to_pose()))
        self._state = Observation(now, tuple(parts))


def small_turn(vector: Iterable[float]) -> Rotation:
    """The rotation about a vector by its length, radians."""
    x, y, z = vector
    angle = math.hypot(x, y, z)
    return rotation_about(scaled((x, y, z), 1.0 / angle) if angle else (0.0, 0.0, 1.0), angle)
