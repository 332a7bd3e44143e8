"""Vacuum connectors: what touches a plate is evacuated, held by a weld, locked, and breaks off when it is overloaded.

In contact a weld holds the part, as strongly as the vacuum that there is. The pump evacuates the cup as far as the leak
lets it, between plates that lie askew or apart. From `HOLDS` of the full vacuum on the part counts as attached, and two
flanges that have latches lock. It lasts until the connector is disabled, or one physics step overloads it.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Final

import mujoco
import numpy as np
from numpy.typing import NDArray

from jauspy.geometry.poses import IDENTITY, Transform
from jauspy.geometry.vectors import Rotation, Vector
from jauspy.platform.contract import PartId
from jauspy.platform.modular.connector import ConnectorError, ConnectorState, VacuumConnector
from jauspy.platform.modular.holding import HOLDS, Cup, Holding, Latch
from jauspy.platform.modular.parts import HALF_TURN, PartKind, PartType, Shape
from jauspy.platform.payload import NOTHING
from jauspy_sim.cell.assembly import GRIPPER, CellModel, angle_between, carrier
from jauspy_sim.cell.loads import ConnectorLoads, Load

Array = NDArray[np.float64]

LIP: Final = 0.001
"""Metres: the compliant lip of a plate seals a gap of this width; it counts as contact."""

DEPTH: Final = 0.004
"""Metres by which plates may be pressed into each other in contact."""

NEAR: Final = 0.03
"""Metres between the middles of plates from which on a failed attempt is reported."""

MEASURE_EVERY: Final = 2
"""Control cycles from one measurement of forces to the next: 8 ms."""

UTILISATION_EVERY: Final = 8
"""Control cycles from one measurement of the fractions of strengths to the next: 32 ms."""

AVERAGED: Final = 2
"""Measurements over which reported force and moment are averaged: 16 ms. Overloads are those of single steps."""

LEAST_TIME: Final = 1e-6
"""Seconds below which a time has passed, but for rounding."""

SETTLED: Final = 1e-3
"""Fraction of the full vacuum by which it may be off where it settles before it counts as constant."""

WAKING_FORCE: Final = 1e-9
"""Newtons; an applied force of any size wakes a sleeping body."""


@dataclass(frozen=True, slots=True)
class Face:
    """A face of a part where a plate can attach, as the frame of the attached plate: z into the part."""

    part: str
    body: int
    frame: Transform
    half_size: tuple[float, float] | None = None
    """Half the size along x and y of a face on which a plate may be anywhere. None: in the middle only."""
    latch: bool = False
    """True for a flange that locks with a connector that has a latch."""


class SimulatedConnector(VacuumConnector):
    """One connector; `Attachments` does its physics."""

    def __init__(
        self, name: str, part: str, body: int, frame: Transform, weld: int, *, cup: Cup, latch: Latch | None
    ) -> None:
        self.name = name
        self.part = part
        """The part with this connector; empty for the gripper of the robot."""
        self.body = body
        self.cup, self.latch = cup, latch
        self._suction = cup.holding
        self.frame = frame
        """Frame of the connector in its body."""
        self.weld = weld
        self.held: Face | None = None
        self.failing: bool | None = None
        """Whether a simulated failure lasts, drawn at the first contact after it was enabled; None before that."""
        self.load = (0.0, 0.0, 0.0)
        """Newtons, newton metres, and the fraction of its strength that is used."""
        self.leak = 0.0
        """Square metres between lip and face."""
        self.vacuum = 0.0
        """Fraction of the full vacuum."""
        self.until_locked = math.inf
        """Seconds until the latch has locked; infinite when it does not, 0 when it has."""
        self.enabled = False
        """True while its pump runs."""
        self._scheduled: tuple[bool, float] | None = None
        """The scheduled command, enabled or not, and the seconds that are left until then; None without one."""
        self.payload = NOTHING
        """All that hangs on the robot's gripper, as the robot has found it out."""
        self._state = ConnectorState()

    @cached_property
    def id(self) -> PartId:
        """Kind and name."""
        return PartId(VacuumConnector, self.name)

    @property
    def attached_to(self) -> str:
        """Name of the part that it holds; empty without one."""
        return self._state.attached_to

    def state(self) -> ConnectorState:
        """The measured state."""
        state, payload = self._state, self.payload
        force, moment, utilisation = self.load
        vacuum = self.vacuum * self.cup.pressure
        if (state.vacuum, state.force, state.utilisation) == (vacuum, force, utilisation) and (
            self.held is None or state.mass_deviation == payload.mass_deviation
        ):
            return state
        # written out: `replace` takes five times as long
        self._state = ConnectorState(
            powered=state.powered,
            enabled=state.enabled,
            attached_to=state.attached_to,
            offset=state.offset,
            force=force,
            moment=moment,
            mass=payload.mass,
            mass_deviation=payload.mass_deviation,
            utilisation=utilisation,
            vacuum=vacuum,
            latched=state.latched,
            broken_off=state.broken_off,
            error=state.error,
            last_error=state.last_error,
        )
        return self._state

    @property
    def secured(self) -> bool:
        """True when it holds something, and has locked that if both have a latch."""
        if self.held is None or not self._state.attached_to:
            return False
        return self._state.latched or self.latch is None or not self.held.latch

    def strength(self) -> tuple[Holding, float]:
        """Strength of its latch once that has locked, until then of the full vacuum with the fraction that there is."""
        if self.latch is not None and not self.until_locked:
            return self.latch, 1.0
        return self._suction, self.vacuum

    def schedule(self, enabled: bool, delay: float) -> None:
        """Call `set` after `delay` seconds, at the beginning of a control cycle."""
        self._scheduled = enabled, delay

    def cancel(self) -> None:
        """Cancel what is scheduled."""
        self._scheduled = None

    def count_down(self, dt: float) -> None:
        """Do what is scheduled for now, at the beginning of a control cycle of `dt` seconds."""
        if self._scheduled is None:
            return
        enabled, left = self._scheduled
        if left < dt / 2.0:
            self.set(enabled)
        else:
            self._scheduled = enabled, left - dt

    def set(self, enabled: bool) -> None:
        """Start the pump, or vent, and cancel what is scheduled; without effect when there is no power."""
        self._scheduled = None
        if not self._state.powered:
            self.change(error=ConnectorError.NO_POWER, last_error=f"{self.part} has no power")
            return
        if enabled is self.enabled:
            return
        if enabled:
            self.change(enabled=True, error=ConnectorError.NO_CONTACT, last_error="nothing is in contact")
        else:
            self.change(enabled=False)

    def change(self, **fields: object) -> None:
        """Change its state."""
        self._state = replace(self._state, **fields)  # type: ignore[arg-type]  # names are those of the class
        self.enabled = self._state.enabled


class Attachments:
    """All connectors of a cell, with their loads and forces.

    `control` is called once in each control cycle. `revision` counts attachments and releases.
    """

    def __init__(self, cell: CellModel, data: mujoco.MjData, random: np.random.Generator) -> None:
        self._model, self._data, self._setup = cell.model, data, cell.setup
        self._random = random
        self.revision = 0
        self.connectors = _make(cell)
        self.loads = ConnectorLoads(cell.model, data)
        self._mean = np.zeros((0, 2))
        self._used: list[float] = []
        self._faces = list(_faces(cell))
        self._face_bodies = np.array([face.body for face in self._faces], np.int64)
        self._face_positions = np.array([face.frame.position for face in self._faces])
        self._face_axes = np.array([[row[2] for row in face.frame.rotation] for face in self._faces])
        self._any_place = np.array([face.half_size is not None for face in self._faces])
        self._unused_exclusions = cell.model.exclude_signature[-len(self.connectors) :].copy()
        self._own_exclusions = cell.model.exclude_signature[: -len(self.connectors)].copy()
        self._cycles, self._dt = 0, 0.0
        self._woken: list[int] = []

    def attached(self) -> Iterable[tuple[SimulatedConnector, Face]]:
        """The connectors that hold something, with the face that each holds."""
        return ((connector, connector.held) for connector in self.connectors.values() if connector.held is not None)

    def check(self) -> None:
        """Break off what the last physics step overloaded; to be called after each."""
        for connection, load in self.loads.overloaded():
            assert isinstance(connection, SimulatedConnector)
            if connection.state().attached_to:
                self._break_off(connection, load)
            else:
                self._slip(connection)

    def control(self, dt: float) -> None:
        """Attach parts in contact, and release those of disabled connectors; `dt` seconds after the last time."""
        for dof in self._woken:
            self._data.qfrc_applied[dof] = 0.0
        self._woken.clear()
        self._dt = dt
        seeking: list[SimulatedConnector] = []
        holding = changed = False
        for connector in self.connectors.values():
            connector.count_down(dt)
            if (face := connector.held) is not None:
                if connector.enabled:
                    holding = True
                    changed |= self._tighten(connector, face)
                else:
                    self._release(connector)
            elif connector.enabled:
                seeking.append(connector)
            else:
                connector.failing, connector.vacuum = None, 0.0
        if changed:
            self.loads.weigh()
        self._cycles += 1
        if holding and not self._cycles % MEASURE_EVERY:
            self._measure()
        if seeking:
            self._seek(seeking)

    def set_powered(self, powered: Mapping[str, bool]) -> None:
        """Set the parts whose connectors have power; the gripper always has power."""
        for connector in self.connectors.values():
            now = connector.part == "" or powered.get(connector.part, False)
            if now is not connector.state().powered:
                connector.change(powered=now)

    # --- attaching ------------------------------------------------------------------------------------------------

    def _seek(self, seeking: list[SimulatedConnector]) -> None:
        data = self._data
        bodies = self._face_bodies
        rotations = data.xmat.reshape(-1, 3, 3)[bodies]
        positions = data.xpos[bodies] + np.einsum("nij,nj->ni", rotations, self._face_positions)
        axes = np.einsum("nij,nj->ni", rotations, self._face_axes)
        for connector in seeking:
            rotation = data.xmat[connector.body].reshape(3, 3)
            at = data.xpos[connector.body] + rotation @ np.array(connector.frame.position)
            normal = rotation @ np.array([row[2] for row in connector.frame.rotation])
            between = positions - at
            gaps = between @ normal
            # an attempt concerns what is near: in front of the plate, and on any place of a box beside its middle
            reach = np.where(self._any_place, 0.15, NEAR)
            near = (np.abs(gaps) <= NEAR) & (np.einsum("ni,ni->n", between, between) <= reach**2)
            self._try_near(connector, np.flatnonzero(near), between, gaps, axes @ normal)

    def _try_near(
        self, connector: SimulatedConnector, near: NDArray[np.int64], between: Array, gaps: Array, cosines: Array
    ) -> None:
        limits = self._setup.limits
        error, reason, best = ConnectorError.NO_CONTACT, "nothing is in contact", math.inf
        for number in near.tolist():
            face = self._faces[number]
            if face.part == connector.part:
                continue
            distance = float(np.linalg.norm(between[number]))
            if face.half_size is not None:
                beside = self._beside(connector, face)
                if beside is None:
                    continue
                distance = abs(beside)
                gap = beside
            else:
                gap = float(gaps[number])
            angle = angle_between(float(cosines[number]))
            if angle > math.pi / 2.0 or distance > NEAR:
                continue
            if -DEPTH <= gap <= LIP and distance <= limits.max_distance and angle <= limits.max_angle:
                leak = connector.cup.leak(gap, angle)
                if self._seals(connector, face, leak) and not self._fails(connector, face):
                    self._touch(connector, face, leak)
                return
            if distance < best:
                best = distance
                error, reason = self._misaligned(face.part, distance, angle)
        connector.vacuum = 0.0
        if not connector.failing and reason != connector.state().last_error:
            connector.change(error=error, last_error=reason)

    def _misaligned(self, part: str, distance: float, angle: float) -> tuple[ConnectorError, str]:
        """Why it does not attach; rounded, so that it does not change in every cycle."""
        limits = self._setup.limits
        if distance <= limits.max_distance and angle <= limits.max_angle:
            return ConnectorError.NO_CONTACT, f"not in contact with {part}"
        far = f"{1e3 * distance:.0f} mm" if distance > limits.max_distance else ""
        tilted = f"{math.degrees(angle):.0f} degrees" if angle > limits.max_angle else ""
        what = " and ".join(deviation for deviation in (far, tilted) if deviation)
        most = f"{1e3 * limits.max_distance:.1f} mm and {math.degrees(limits.max_angle):.1f} degrees"
        error = ConnectorError.TOO_FAR if far else ConnectorError.NOT_ALIGNED
        return error, f"not aligned with {part}: {what} off, at most {most} hold"

    def _beside(self, connector: SimulatedConnector, face: Face) -> float | None:
        """Distance from the face of a box along its normal; None if the plate is not within the face."""
        assert face.half_size is not None
        in_face = (self.frame_of(face.body) @ face.frame).inverse() @ self.frame_of(connector.body) @ connector.frame
        x, y, z = in_face.position
        within = all(abs(at) + connector.cup.radius <= half for at, half in zip((x, y), face.half_size, strict=True))
        return -z if within else None

    def _fails(self, connector: SimulatedConnector, face: Face) -> bool:
        """Draw at random whether an attempt of the gripper fails, once for each time it is enabled."""
        if connector.name != GRIPPER or self._setup.attach_failure <= 0.0:
            return False
        if connector.failing is not None:
            return connector.failing
        connector.failing = bool(self._random.random() < self._setup.attach_failure)
        if connector.failing:
            leak = f"no vacuum on {face.part}: the plate leaks"
            connector.change(error=ConnectorError.FAILED, last_error=leak)
        return connector.failing

    def _seals(self, connector: SimulatedConnector, face: Face, leak: float) -> bool:
        cup = connector.cup
        if (settled := cup.settled(leak)) >= HOLDS:
            return True
        level, least = (f"{1e-3 * fraction * cup.pressure:.0f} kPa" for fraction in (settled, HOLDS))
        reason = f"the cup leaks on {face.part}: {level} of vacuum, {least} hold"
        if reason != connector.state().last_error:
            connector.change(error=ConnectorError.FAILED, last_error=reason)
        return False

    def _touch(self, connector: SimulatedConnector, face: Face, leak: float) -> None:
        """Hold a face in contact with the vacuum there is."""
        connector.held, connector.leak = face, leak
        connector.vacuum = connector.cup.evacuated(connector.vacuum, leak, self._dt)
        self._hold(connector, face, self.relative(connector.body, face.body))
        connector.change(error=ConnectorError.NONE, last_error=f"evacuating the cup on {face.part}")

    def _attach(self, connector: SimulatedConnector, face: Face) -> None:
        """Report what is held as attached, and have the latch lock it."""
        reason = self._begin_to_lock(connector, face, self.relative(connector.body, face.body))
        offset = connector.frame.inverse() @ self.relative(connector.body, self._model.body(face.part).id)
        connector.change(attached_to=face.part, offset=offset, error=ConnectorError.NONE, last_error=reason)
        self.revision += 1

    def _tighten(self, connector: SimulatedConnector, face: Face) -> bool:
        """Go on evacuating and locking what is held; true if that changes its strength."""
        if not connector.until_locked:
            return False
        if connector.until_locked < math.inf:
            connector.until_locked -= self._dt
            if connector.until_locked < LEAST_TIME:
                connector.until_locked = 0.0
                connector.change(latched=True)
                return True
        cup, attached = connector.cup, connector.state().attached_to
        if attached and abs(cup.settled(connector.leak) - connector.vacuum) < SETTLED:
            return False
        connector.vacuum = cup.evacuated(connector.vacuum, connector.leak, self._dt)
        if connector.vacuum >= HOLDS and not attached:
            self._attach(connector, face)
        return True

    def _begin_to_lock(self, connector: SimulatedConnector, face: Face, pose: Transform) -> str:
        """Have the latch lock, if both have one; returns why it does not."""
        latch = connector.latch
        connector.until_locked = math.inf
        if latch is None or not face.latch:
            return ""
        plate = connector.frame.inverse() @ pose @ face.frame
        beside, angle = math.hypot(*plate.position[:2]), angle_between(plate.rotation[2][2])
        if beside > latch.max_distance or angle > latch.max_angle:
            off, most = (
                f"{1e3 * distance:.1f} mm and {math.degrees(turn):.1f} degrees"
                for distance, turn in ((beside, angle), (latch.max_distance, latch.max_angle))
            )
            return f"not locked on {face.part}: {off} off, at most {most} lock"
        connector.until_locked = latch.time
        return ""

    def _hold(self, connector: SimulatedConnector, face: Face, pose: Transform) -> None:
        model, weld = self._model, connector.weld
        quaternion = np.empty(4)
        mujoco.mju_mat2Quat(quaternion, np.ravel(pose.rotation))
        anchor = pose.inverse().apply(connector.frame.position)
        model.eq_obj2id[weld] = face.body
        model.eq_data[weld][:10] = [*anchor, *connector.frame.position, *quaternion]
        self._data.eq_active[weld] = 1
        self.wake(face.body)
        self._changed()

    def _release(self, connector: SimulatedConnector, **fields: object) -> None:
        weld = connector.weld
        held = connector.held
        assert held is not None
        self._data.eq_active[weld] = 0
        self._model.eq_obj2id[weld] = 0
        connector.held = None
        connector.load, connector.vacuum, connector.until_locked = (0.0, 0.0, 0.0), 0.0, math.inf
        connector.change(
            attached_to="",
            offset=IDENTITY,
            force=0.0,
            moment=0.0,
            mass=0.0,
            mass_deviation=math.inf,
            utilisation=0.0,
            vacuum=0.0,
            latched=False,
            **fields,
        )
        self.wake(connector.body)
        self.wake(held.body)
        self._changed()

    def wake(self, body: int) -> None:
        """Wake the tree of a sleeping body, so that it is simulated again."""
        tree = self._model.body_treeid[body]
        if tree >= 0 and self._data.tree_asleep[tree] >= 0:
            dof = int(self._model.tree_dofadr[tree])
            self._data.qfrc_applied[dof] = WAKING_FORCE
            self._woken.append(dof)

    def _changed(self) -> None:
        self.revision += 1
        self.loads.follow((connector, face.body) for connector, face in self.attached())
        self._mean = np.zeros((len(self.loads.connections), 2))
        self._used = [0.0] * len(self._mean)
        held = [
            (min(connector.body, face.body) << 16) + max(connector.body, face.body)
            for connector, face in self.attached()
            if connector.body != face.body
        ]
        free = self._unused_exclusions[len(held) :]
        signatures = np.concatenate([self._own_exclusions, np.array(held, np.int32), free])
        self._model.exclude_signature[:] = np.sort(signatures)

    def vent(self, connector: SimulatedConnector, reason: str) -> None:
        """Let a connector lose what it holds, as one does whose line leaks; without effect if it holds nothing."""
        if connector.held is not None:
            self._release(connector, enabled=False, error=ConnectorError.FAILED, last_error=reason)

    # --- loads ----------------------------------------------------------------------------------------------------

    def _measure(self) -> None:
        """Take the loads that connectors report from the constraints of the last step."""
        loads, mean = self.loads, self._mean
        mean += (loads.magnitudes() - mean) / AVERAGED
        if not self._cycles % UTILISATION_EVERY:
            self._used = loads.utilisations(loads.wrenches()).tolist()
        for connector, (force, moment), used in zip(loads.connections, mean.tolist(), self._used, strict=True):
            connector.load = force, moment, used  # type: ignore[attr-defined]  # those of this class

    def _slip(self, connector: SimulatedConnector) -> None:
        """Let plates slide on each other while the vacuum is low; in contact they go on being evacuated."""
        vacuum = connector.vacuum
        self._release(connector)
        connector.vacuum = vacuum

    def _break_off(self, connector: SimulatedConnector, load: Load) -> None:
        held = connector.held
        assert held is not None
        strength, share = connector.strength()
        by = "its latch" if not connector.until_locked else f"{1e-3 * share * connector.cup.pressure:.0f} kPa of vacuum"
        self._release(
            connector,
            enabled=False,
            broken_off=connector.state().broken_off + 1,
            error=ConnectorError.OVERLOADED,
            last_error=f"{held.part} broke off: {load} are {load.utilisation:.0%} of what {by} holds "
            f"({strength.force * share:.0f} N, {strength.moment * share:.1f} N m)",
        )

    # --- frames ---------------------------------------------------------------------------------------------------

    def frame_of(self, body: int) -> Transform:
        """Pose of a body in the world."""
        data = self._data
        return to_transform(data.xpos[body].tolist(), data.xmat[body].tolist())

    def relative(self, outer: int, inner: int) -> Transform:
        """Pose of one body in the frame of another."""
        return self.frame_of(outer).inverse() @ self.frame_of(inner)


def to_transform(position: list[float], matrix: list[float]) -> Transform:
    """A transform from MuJoCo's position and rotation matrix."""
    x, y, z = position
    a, b, c, d, e, f, g, h, i = matrix
    return Transform(((a, b, c), (d, e, f), (g, h, i)), (x, y, z))


def _make(cell: CellModel) -> dict[str, SimulatedConnector]:
    model, setup = cell.model, cell.setup
    frames: dict[str, tuple[str, str, Transform]] = {}
    if setup.gripper:
        frames[GRIPPER] = "", f"{cell.prefix}{setup.gripper}", IDENTITY
    for part in setup.parts:
        kind = setup.types[part.type]
        for name, frame in kind.connectors.items():
            frames[f"{part.name}/{name}"] = part.name, carrier(part.name, kind), frame
    limits = setup.limits
    found = {}
    for name, (owner, body, frame) in frames.items():
        cup = limits.cup if owner else limits.gripper
        has_latch = setup.type_of(owner).latch if owner else setup.gripper_latch
        weld = int(model.equality(name).id)
        found[name] = SimulatedConnector(
            name, owner, int(model.body(body).id), frame, weld, cup=cup, latch=limits.latch if has_latch else None
        )
    return found


def _faces(cell: CellModel) -> Iterable[Face]:
    for part in cell.setup.parts:
        kind = cell.setup.types[part.type]
        body = int(cell.model.body(part.name).id)
        if kind.kind is PartKind.BOX:
            yield from _box_faces(part.name, kind, body)
            continue
        # flanges first: where the gripper holds a base is one of them, and the first face in contact is taken
        if kind.kind is not PartKind.BASE:
            yield Face(part.name, body, IDENTITY, latch=kind.latch)
        carried = int(cell.model.body(carrier(part.name, kind)).id)
        for frame in kind.connectors.values():
            yield Face(part.name, carried, frame @ HALF_TURN, latch=kind.latch)
        for grasp in kind.grasps:
            yield Face(part.name, body, grasp, latch=kind.grasp_latch)


def _box_faces(part: str, kind: PartType, body: int) -> Iterable[Face]:
    """The six faces of each cuboid of a box."""
    for solid in kind.solids:
        if solid.shape is not Shape.CUBOID:
            continue
        for axis in range(3):
            for sign in (1.0, -1.0):
                normal = tuple(-sign if index == axis else 0.0 for index in range(3))
                position = tuple(sign * solid.size[axis] / 2.0 if index == axis else 0.0 for index in range(3))
                u, v = (axis + 1) % 3, (axis + 2) % 3
                frame = solid.pose @ Transform(_facing(normal, u), (position[0], position[1], position[2]))
                halves = (solid.size[u] / 2.0, solid.size[v] / 2.0)
                yield Face(part, body, frame, halves)


def _facing(normal: tuple[float, ...], along: int) -> Rotation:
    """The rotation whose z is `normal` and whose x is a coordinate axis."""
    z = np.array(normal)
    x = np.eye(3)[along]
    y = np.cross(z, x)
    rows: list[Vector] = [(float(x[row]), float(y[row]), float(z[row])) for row in range(3)]
    return rows[0], rows[1], rows[2]
