"""The true state of a simulated cell, for tests and measurements; no task uses it."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import NamedTuple

import mujoco
import numpy as np

from jauspy.geometry.poses import Pose, Transform
from jauspy.geometry.vectors import Vector
from jauspy_sim.cell.assembly import CellModel, carrier
from jauspy_sim.cell.connectors import to_transform
from jauspy_sim.cell.servos import SimulatedServo
from jauspy_sim.cell.watch import Watch, Watched
from jauspy_sim.cell.writes import Writes


class TrueContact(NamedTuple):
    """Two bodies that touch."""

    first: str
    second: str
    """Names: of parts, bins and fixtures; links of the robot with its prefix, as in `cell/gripper`; floor: `world`."""
    depth: float
    """Metres by which their collision shapes overlap."""
    force: float
    """Newtons along the normal."""


class Truth:
    """True poses, velocities, contacts and loads, after the last step."""

    def __init__(self, cell: CellModel, data: mujoco.MjData, servos: Mapping[str, SimulatedServo]) -> None:
        self._cell, self._model, self._data, self._servos = cell, cell.model, data, servos
        self.watching: list[Watch] = []
        """What is measured at each step; None measures nothing."""
        self.writes: Writes | None = None
        """Positions that were written since the cell settled; None before."""
        self._types = {part.name: cell.setup.types[part.type] for part in cell.setup.parts}

    def frame(self, body: str) -> Transform:
        """Pose of a part or of another body (`cell/gripper`, `servo_1.output`) in the world."""
        self._refresh()
        found = self._data.body(body)
        return to_transform(found.xpos.tolist(), found.xmat.tolist())

    def pose(self, part: str) -> Pose:
        """Pose of a part in the world."""
        return self.frame(part).to_pose()

    def poses(self) -> dict[str, Pose]:
        """Poses of all parts."""
        return {name: self.pose(name) for name in self._types}

    def connector(self, name: str) -> Transform:
        """Pose of a connector, as in `servo_5/output` or `gripper`, in the world."""
        part, _, own = name.partition("/")
        if not own:
            return self.frame(f"{self._cell.prefix}{self._cell.setup.gripper}")
        kind = self._types[part]
        return self.frame(carrier(part, kind)) @ kind.connectors[own]

    def velocity(self, body: str) -> tuple[Vector, Vector]:
        """Linear (of its frame) and angular velocity of a body, in its own frame: m/s and rad/s."""
        self._refresh()
        found = np.empty(6)
        number = self._model.body(body).id
        mujoco.mj_objectVelocity(self._model, self._data, mujoco.mjtObj.mjOBJ_XBODY, number, found, 1)
        wx, wy, wz, vx, vy, vz = found.tolist()
        return (vx, vy, vz), (wx, wy, wz)

    def servo(self, name: str) -> tuple[float, float, float]:
        """True position (rad), velocity (rad/s) and torque of the spring (N m) of a module, powered or not."""
        servo = self._servos[name]
        return servo.true_position, servo.true_velocity, servo.true_torque

    def contacts(self, bodies: Iterable[str] = ()) -> list[TrueContact]:
        """Contacts of the last step, deepest first; of these parts or bodies only, if any are named."""
        model, data = self._model, self._data
        named = set(bodies)
        found: list[TrueContact] = []
        force = np.empty(6)
        for number, contact in enumerate(data.contact[: data.ncon]):
            first, second = (self._name(int(geom)) for geom in contact.geom)
            if named and not named.intersection((first, second)):
                continue
            mujoco.mj_contactForce(model, data, number, force)
            found.append(TrueContact(first, second, max(0.0, -float(contact.dist)), float(force[0])))
        return sorted(found, key=lambda contact: -contact.depth)

    def penetration(self) -> float:
        """Metres of the deepest overlap of shapes in the last step."""
        return max((contact.depth for contact in self.contacts()), default=0.0)

    @property
    def written(self) -> tuple[str, ...]:
        """Parts and links that were put in place by writing positions since the cell settled, in order."""
        if self.writes is None:
            return ()
        self.writes.check()
        return tuple(self.writes.names)

    def watch(self, parts: Iterable[str]) -> Watched:
        """Measure these parts against the robot's links, the bins and fixtures at each step from now on."""
        return self.watch_groups([tuple(parts)])[0]

    def watch_groups(self, groups: Sequence[Sequence[str]]) -> list[Watched]:
        """Same as `watch`, for several groups of parts, each also against the others. Earlier watches end."""
        model = self._model
        names = [str(mujoco.mj_id2name(model, mujoco.mjtObj.mjOBJ_BODY, number)) for number in range(model.nbody)]
        setup = self._cell.setup
        fixed = {"conveyor", "belt", *(bin.name for bin in setup.bins), *(fixture.name for fixture in setup.fixtures)}
        obstacles = [name for name in names if name.startswith(self._cell.prefix) or name in fixed]
        bodies = [[name for name in names if name.partition(".")[0] in group] for group in groups]
        self.watching = []
        for number, group in enumerate(groups):
            others = [name for other, found in enumerate(bodies) if other != number for name in found]
            servos = {name: servo for name, servo in self._servos.items() if name in group}
            self.watching.append(Watch(model, self._data, bodies[number], obstacles + others, servos))
        return [watch.found for watch in self.watching]

    def _name(self, geom: int) -> str:
        body = self._model.body(self._model.geom_bodyid[geom]).name
        return body.partition(".")[0] if body.partition(".")[0] in self._types else str(body)

    def _refresh(self) -> None:
        """After a step, MuJoCo's frames are those of its start."""
        mujoco.mj_kinematics(self._model, self._data)
        mujoco.mj_comPos(self._model, self._data)
