"""What a cell's physics do at each step: how gently plates meet, what they hold, how fast and exactly joints move.

For tests, reports and figures; nothing that commands the cell reads it.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Final

import mujoco
import numpy as np
from numpy.typing import NDArray

from jauspy.platform.joints import ControlMode
from jauspy_sim.cell.assembly import GRIPPER, CellModel
from jauspy_sim.cell.connectors import Attachments, Face, SimulatedConnector
from jauspy_sim.physics.joints import SimulatedJoints

Array = NDArray[np.float64]

APART: Final = 0.3
"""Seconds without contact after which two things that touch again count as meeting anew."""
SETTLING: Final = 0.1
"""Seconds after an attachment in which its force belongs to the meeting, not yet to what is done with the part."""
LEAST_FORCE: Final = 0.01
"""Newtons from which on a contact counts."""


@dataclass(slots=True)
class Meeting:
    """Two things that met: a connector and what it attached, or what the gripper holds and what it was put on."""

    time: float
    """Seconds at which it attached, or touched."""
    first: str
    """The connector, or the part that the gripper carries."""
    second: str
    speed: float
    """m/s between the plates when they attached, or at the first contact if that was faster."""
    force: float = 0.0
    """Newtons: the largest of the contact before, and of the connection until it has settled."""


@dataclass(frozen=True, slots=True)
class Peak:
    """The largest load of a connector, of all physics steps."""

    utilisation: float = 0.0
    """Fraction of the strength that there was in that step."""
    time: float = 0.0
    """Seconds."""
    part: str = ""
    """The part that it held."""
    kind: str = ""
    """Kind of the connection: `latch`, `cup`, or `gripper`."""
    force: tuple[float, float, float] = (0.0, 0.0, 0.0)
    moment: tuple[float, float, float] = (0.0, 0.0, 0.0)
    """N and N m that it exerted, in the connector's frame."""


@dataclass(slots=True)
class JointFigures:
    """The largest values of one joint of the robot."""

    speed: float = 0.0
    """rad/s."""
    torque: float = 0.0
    """N m of the motor."""
    error: float = 0.0
    """Radians from the setpoint while it moves to a position."""
    end_error: float = 0.0
    """Radians from the setpoint when that has arrived."""
    ends: int = 0
    """Number of motions that ended."""


@dataclass(slots=True)
class Contact:
    """One contact of two bodies without a break: its first speed, and the largest force."""

    last: float
    speed: float
    force: float
    landing: Meeting | None = None
    collision: Meeting | None = None


@dataclass(slots=True)
class Settling:
    """An attachment whose force is still measured."""

    meeting: Meeting
    weld: int
    until: float
    motion: Array
    """Velocities of the robot's setpoints at the attachment: motions that go elsewhere load it on purpose."""
    stopped: bool = False
    """True from when the robot stood still."""

    def goes_on(self, velocities: Array) -> bool:
        """False when another motion of the robot has begun."""
        moves = bool(velocities.any())
        self.stopped = self.stopped or not moves
        return not (self.stopped and moves) and float(velocities @ self.motion) >= 0.0


class Probe:
    """Fed after each physics step; `attaches`, `landings`, `collisions` and `joints` are what it has measured.

    MuJoCo's constraints after a step are those of the state before it, which is kept, so that speeds are those with
    which things met.
    """

    def __init__(
        self,
        cell: CellModel,
        data: mujoco.MjData,
        attachments: Attachments,
        groups: Mapping[str, SimulatedJoints],
    ) -> None:
        self.attaches: list[Meeting] = []
        self.landings: list[Meeting] = []
        """First contacts of what the gripper carried with anything that it was not joined to."""
        self.collisions: list[Meeting] = []
        """Contacts of the robot's links and gripper, except with what the gripper has just attached or released."""
        self.joints: dict[str, JointFigures] = {}
        self.peaks: dict[tuple[str, str], Peak] = {}
        """The largest loads, by connector and kind of connection."""
        self._model, self._data, self._attachments = cell.model, data, attachments
        self._groups = tuple(groups.values())
        self._stops = -self._contacts_found()
        self._before = mujoco.MjData(cell.model)
        self._things = _things(cell.model)
        self._names = _names(cell.model)
        self._contacts: dict[tuple[int, int], Contact] = {}
        self._settling: list[Settling] = []
        self._frames = {
            connector.name: np.array(connector.frame.rotation) for connector in attachments.connectors.values()
        }
        self._held = {connector.name: connector.held for connector in attachments.connectors.values()}
        self._revision = attachments.revision
        self._carried: set[int] = set()
        self._joined: set[tuple[int, int]] = set()
        self._released: dict[tuple[int, int], float] = {}
        """When pairs were joined last."""
        self._moving: dict[str, bool] = {}
        gripper = attachments.connectors.get(GRIPPER)
        self._robot = int(self._things[gripper.body]) if gripper is not None else -1
        self._find_carried(-APART)
        self._keep()

    @property
    def stops(self) -> int:
        """Motions of the robot that its own detection of contact has ended."""
        return self._stops + self._contacts_found()

    def _contacts_found(self) -> int:
        return sum(group.contact.number for group in self._groups if group.contact is not None)

    def step(self, time: float) -> None:
        """Measure the step that has just been made; `time` is that after it."""
        self._measure_contacts(time)
        if self._attachments.revision != self._revision:
            self._revision = self._attachments.revision
            self._find_attached(time)
            self._find_carried(time)
        if self._settling:
            self._measure_settling(time)
        for group in self._groups:
            self._measure_joints(group)
        self._keep()

    def measure_loads(self, time: float) -> None:
        """Measure what the connectors hold in a physics step, before any of them breaks off; `time` is that before it.

        Read from MuJoCo's constraints by their ids, not through what breaks the connectors off.
        """
        data = self._data
        ids = data.efc_id[: data.ne].tolist()
        # without an attachment it is still evacuated, and may slide
        held = [
            (connector, face)
            for connector, face in self._attachments.attached()
            if connector.attached_to and ids.count(connector.weld) == 6
        ]
        if not held:
            return
        starts = np.array([ids.index(connector.weld) for connector, _ in held])
        rows = data.efc_force[starts[:, np.newaxis] + np.arange(6)]
        rotations = data.xmat.reshape(-1, 3, 3)
        axes = rotations[[connector.body for connector, _ in held]] @ np.array(
            [self._frames[connector.name] for connector, _ in held]
        )
        forces = -np.einsum("nji,nj->ni", axes, rows[:, :3])
        # the rows of the rotation are those of half the angle, in the frame of what is held
        turned = np.einsum("nij,nj->ni", rotations[[face.body for _, face in held]], rows[:, 3:])
        moments = -0.5 * np.einsum("nji,nj->ni", axes, turned)
        for (connector, face), force, moment in zip(held, forces.tolist(), moments.tolist(), strict=True):
            strength, share = connector.strength()
            # a part of the strength is used by a load as the whole of it by that much more of the load
            more = 1.0 / max(share, 1e-9)
            used = strength.utilisation([more * part for part in force], [more * part for part in moment])
            kind = "latch" if not connector.until_locked else "cup" if connector.part else "gripper"
            last = self.peaks.get((connector.name, kind))
            if last is None or used > last.utilisation:
                (x, y, z), (a, b, c) = force, moment
                self.peaks[connector.name, kind] = Peak(used, time, face.part, kind, (x, y, z), (a, b, c))

    def largest_loads(self) -> dict[str, Peak]:
        """The largest load of each kind of connection."""
        found: dict[str, Peak] = {}
        for (_, kind), peak in self.peaks.items():
            if kind not in found or peak.utilisation > found[kind].utilisation:
                found[kind] = peak
        return found

    def _keep(self) -> None:
        self._before.qpos[:] = self._data.qpos
        self._before.qvel[:] = self._data.qvel

    # --- contacts -------------------------------------------------------------------------------------------------

    def _measure_contacts(self, time: float) -> None:
        data = self._data
        contact = data.contact
        address = np.asarray(contact.efc_address)
        pushing = address >= 0
        if not pushing.any():
            return
        things = np.sort(self._things[self._model.geom_bodyid[np.asarray(contact.geom)[pushing]]], axis=1)
        normal = data.efc_force[address[pushing]]
        forces: dict[tuple[int, int], float] = {}
        places: dict[tuple[int, int], int] = {}
        numbers = np.flatnonzero(pushing).tolist()
        for number, (a, b), force in zip(numbers, things.tolist(), normal.tolist(), strict=True):
            if force > LEAST_FORCE and a != b:
                forces[a, b] = forces.get((a, b), 0.0) + force
                places.setdefault((a, b), number)
        for pair, force in forces.items():
            found = self._contacts.get(pair)
            if found is None or time - found.last > APART:
                found = self._contacts[pair] = self._touched(pair, places[pair], time)
            found.last, found.force = time, max(found.force, force)
            if found.landing is not None and self._carries(pair):
                found.landing.force = max(found.landing.force, force)
            if found.collision is not None:
                found.collision.force = max(found.collision.force, force)

    def _carries(self, pair: tuple[int, int]) -> bool:
        return (pair[0] in self._carried) is not (pair[1] in self._carried)

    def _touched(self, pair: tuple[int, int], number: int, time: float) -> Contact:
        contact = self._data.contact[number]
        bodies = [int(body) for body in self._model.geom_bodyid[contact.geom]]
        made = Contact(time, self._speed_between(bodies[0], bodies[1], contact.pos), 0.0)
        if self._carries(pair) and pair not in self._joined:
            first, second = pair if pair[0] in self._carried else pair[::-1]
            made.landing = Meeting(time, self._names[first], self._names[second], made.speed)
            self.landings.append(made.landing)
        elif self._robot in pair and time - self._released.get(pair, -APART) > APART:
            other = pair[0] if pair[1] == self._robot else pair[1]
            link = next(body for body in bodies if self._things[body] == self._robot)
            made.collision = Meeting(time, str(self._model.body(link).name), self._names[other], made.speed)
            self.collisions.append(made.collision)
        return made

    def _speed_between(self, first: int, second: int, place: Array) -> float:
        """Relative speed of two bodies at a point, before the step."""
        model, before = self._model, self._before
        mujoco.mj_kinematics(model, before)
        mujoco.mj_comPos(model, before)
        one, other = (self._velocity_at(body, place) for body in (first, second))
        return float(np.linalg.norm(one - other))

    def _velocity_at(self, body: int, place: Array) -> Array:
        jacobian = np.zeros((3, self._model.nv))
        mujoco.mj_jac(self._model, self._before, jacobian, None, np.asarray(place), body)
        return np.asarray(jacobian @ self._before.qvel)

    # --- attachments ----------------------------------------------------------------------------------------------

    def _find_attached(self, time: float) -> None:
        for connector in self._attachments.connectors.values():
            held = connector.held
            if held is not None and held is not self._held[connector.name]:
                self._attached(connector, held, time)
            self._held[connector.name] = held

    def _attached(self, connector: SimulatedConnector, face: Face, time: float) -> None:
        model, before = self._model, self._before
        mujoco.mj_kinematics(model, before)
        rotation = before.xmat[connector.body].reshape(3, 3)
        plate = before.xpos[connector.body] + rotation @ np.array(connector.frame.position)
        speed = self._speed_between(connector.body, face.body, plate)
        pair = self._pair(connector.body, face.body)
        contact = self._contacts.get(pair)
        met = Meeting(time, connector.name, face.part, speed)
        if contact is not None and time - contact.last <= APART:
            met.speed, met.force = max(speed, contact.speed), contact.force
            if contact.landing is not None:
                self.landings.remove(contact.landing)
                contact.landing = None
            if contact.collision is not None:
                self.collisions.remove(contact.collision)
                contact.collision = None
        self.attaches.append(met)
        self._settling.append(Settling(met, connector.weld, time + SETTLING, self._velocities()))

    def _velocities(self) -> Array:
        """Velocities of the setpoints of the robot's joints."""
        return np.array([setpoint.velocity for group in self._groups for setpoint in group.setpoints()])

    def _measure_settling(self, time: float) -> None:
        velocities = self._velocities()
        self._settling = [
            settling for settling in self._settling if time < settling.until and settling.goes_on(velocities)
        ]
        data = self._data
        rows = data.ne
        equal = data.efc_type[:rows] == mujoco.mjtConstraint.mjCNSTR_EQUALITY
        for settling in self._settling:
            own = np.flatnonzero(equal & (data.efc_id[:rows] == settling.weld))[:3]
            force = float(np.linalg.norm(data.efc_force[own]))
            settling.meeting.force = max(settling.meeting.force, force)

    def _find_carried(self, time: float) -> None:
        """The things that hang on the gripper, directly or through connectors, and pairs that are joined."""
        attached = [(connector, face) for connector, face in self._attachments.attached()]
        before = self._joined
        self._joined = {self._pair(connector.body, face.body) for connector, face in attached}
        self._released |= dict.fromkeys(before - self._joined, time)
        first = [face.body for connector, face in attached if connector.name == GRIPPER]
        reached = {int(self._things[body]) for body in first}
        gripper = [int(self._things[connector.body]) for connector, _ in attached if connector.name == GRIPPER]
        waiting = list(reached)
        while waiting:
            thing = waiting.pop()
            for pair in self._joined:
                other = pair[0] if pair[1] == thing else pair[1] if pair[0] == thing else thing
                if other not in reached and other not in gripper:
                    reached.add(other)
                    waiting.append(other)
        self._carried = reached

    def _pair(self, first: int, second: int) -> tuple[int, int]:
        a, b = sorted((int(self._things[first]), int(self._things[second])))
        return a, b

    # --- joints ---------------------------------------------------------------------------------------------------

    def _measure_joints(self, group: SimulatedJoints) -> None:
        state = group.true_state()
        rows = zip(group.joints, state.positions, state.velocities, state.efforts, group.setpoints(), strict=True)
        for joint, position, velocity, effort, setpoint in rows:
            figures = self.joints.get(joint.name)
            if figures is None:
                figures = self.joints[joint.name] = JointFigures()
            figures.speed = max(figures.speed, abs(velocity))
            figures.torque = max(figures.torque, abs(effort))
            if setpoint.mode is not ControlMode.POSITION:
                continue
            error = abs(setpoint.position - position)
            if setpoint.velocity:
                figures.error = max(figures.error, error)
            elif self._moving.get(joint.name, False) and setpoint.arrived:
                figures.end_error = max(figures.end_error, error)
                figures.ends += 1
            self._moving[joint.name] = bool(setpoint.velocity)


def _things(model: mujoco.MjModel) -> NDArray[np.int64]:
    """A number for each body: bodies of one tree are one thing, and so is each fixed body."""
    trees = np.asarray(model.body_treeid)
    return np.where(trees >= 0, trees, model.ntree + np.arange(model.nbody)).astype(np.int64)


def _names(model: mujoco.MjModel) -> Mapping[int, str]:
    """What the things are called: by their part, or by their first body."""
    found: dict[int, str] = {}
    for body, thing in enumerate(_things(model).tolist()):
        found.setdefault(thing, str(model.body(body).name))
    return found
