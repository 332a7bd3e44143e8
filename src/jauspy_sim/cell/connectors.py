"""Vacuum connectors: welds that hold a part in contact until they are disabled or overloaded."""

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
from jauspy.platform.modular.parts import HALF_TURN, PartKind, PartType, Shape
from jauspy_sim.cell.assembly import GRIPPER, CellModel, angle_between, carrier

Array = NDArray[np.float64]

LIP: Final = 0.001
"""Metres: the compliant lip of a plate seals a gap of this width; it counts as contact."""

DEPTH: Final = 0.004
"""Metres by which plates may be pressed into each other in contact."""

NEAR: Final = 0.03
"""Metres between the middles of plates from which on a failed attempt is reported."""

MEASURE_EVERY: Final = 2
"""Control cycles from one measurement of forces to the next: 8 ms."""

OVERLOAD_MEASUREMENTS: Final = 2
"""Measurements over which force and moment are averaged before they count as an overload: 16 ms."""

HALF_ANGLE: Final = np.array((1.0, 0.5))
"""Factors from the rows of a weld to force and moment: those of the rotation act on half the angle."""

PLATE_RADIUS: Final = 0.02
"""Metres: a plate must lie on the face of a box with this radius."""

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


class SimulatedConnector(VacuumConnector):
    """One connector; `Attachments` does its physics."""

    def __init__(self, name: str, part: str, body: int, frame: Transform, weld: int) -> None:
        self.name = name
        self.part = part
        """The part with this connector; empty for the gripper of the robot."""
        self.body = body
        self.frame = frame
        """Frame of the connector in its body."""
        self.weld = weld
        self.held: Face | None = None
        self.failing = False
        """True while a simulated failure lasts: until the connector is disabled."""
        self.load = (0.0, 0.0)
        """Newtons, newton metres."""
        self.enabled = False
        """True while its pump runs."""
        self._state = ConnectorState()

    @cached_property
    def id(self) -> PartId:
        """Kind and name."""
        return PartId(VacuumConnector, self.name)

    def state(self) -> ConnectorState:
        """The measured state."""
        state = self._state
        if self.held is None or (state.force, state.moment) == self.load:
            return state
        # written out: `replace` takes five times as long
        self._state = ConnectorState(
            powered=state.powered,
            enabled=state.enabled,
            attached_to=state.attached_to,
            offset=state.offset,
            force=self.load[0],
            moment=self.load[1],
            broken_off=state.broken_off,
            error=state.error,
            last_error=state.last_error,
        )
        return self._state

    def set(self, enabled: bool) -> None:
        """Start the pump, or vent; without effect when there is no power."""
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
        self._by_weld = {connector.weld: connector for connector in self.connectors.values()}
        self._faces = list(_faces(cell))
        self._face_bodies = np.array([face.body for face in self._faces], np.int64)
        self._face_positions = np.array([face.frame.position for face in self._faces])
        self._face_axes = np.array([[row[2] for row in face.frame.rotation] for face in self._faces])
        self._any_place = np.array([face.half_size is not None for face in self._faces])
        self._unused_exclusions = cell.model.exclude_signature[-len(self.connectors) :].copy()
        self._own_exclusions = cell.model.exclude_signature[: -len(self.connectors)].copy()
        self._cycles = 0
        self._woken: list[int] = []
        self._loads = np.zeros((cell.model.neq, 2))

    def attached(self) -> Iterable[tuple[SimulatedConnector, Face]]:
        """The connectors that hold something, with the face that each holds."""
        return ((connector, connector.held) for connector in self.connectors.values() if connector.held is not None)

    def control(self) -> None:
        """Attach parts in contact, release those of disabled connectors, and break off overloaded ones."""
        for dof in self._woken:
            self._data.qfrc_applied[dof] = 0.0
        self._woken.clear()
        seeking: list[SimulatedConnector] = []
        holding = False
        for connector in self.connectors.values():
            if connector.held is not None:
                if connector.enabled:
                    holding = True
                else:
                    self._release(connector)
            elif connector.enabled:
                seeking.append(connector)
            elif connector.failing:
                connector.failing = False
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
                if self._fails(connector, face):
                    return
                self._attach(connector, face)
                return
            if distance < best:
                best = distance
                error, reason = self._misaligned(face.part, distance, angle)
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
        within = all(abs(at) + PLATE_RADIUS <= half for at, half in zip((x, y), face.half_size, strict=True))
        return -z if within else None

    def _fails(self, connector: SimulatedConnector, face: Face) -> bool:
        """Draw at random whether an attempt of the gripper fails, once for each time it is enabled."""
        if connector.name != GRIPPER or self._setup.attach_failure <= 0.0:
            return False
        if connector.failing:
            return True
        connector.failing = bool(self._random.random() < self._setup.attach_failure)
        if connector.failing:
            leak = f"no vacuum on {face.part}: the plate leaks"
            connector.change(error=ConnectorError.FAILED, last_error=leak)
        return connector.failing

    def _attach(self, connector: SimulatedConnector, face: Face) -> None:
        connector.held = face
        self._hold(connector, face, self.relative(connector.body, face.body))
        offset = connector.frame.inverse() @ self.relative(connector.body, self._model.body(face.part).id)
        connector.change(attached_to=face.part, offset=offset, error=ConnectorError.NONE, last_error="")

    def _hold(self, connector: SimulatedConnector, face: Face, pose: Transform) -> None:
        model, weld = self._model, connector.weld
        quaternion = np.empty(4)
        mujoco.mju_mat2Quat(quaternion, np.ravel(pose.rotation))
        anchor = pose.inverse().apply(connector.frame.position)
        model.eq_obj2id[weld] = face.body
        model.eq_data[weld][:10] = [*anchor, *connector.frame.position, *quaternion]
        self._data.eq_active[weld] = 1
        self._loads[weld] = 0.0
        self.wake(face.body)
        self._changed()

    def _release(self, connector: SimulatedConnector, **fields: object) -> None:
        weld = connector.weld
        held = connector.held
        assert held is not None
        self._data.eq_active[weld] = 0
        self._model.eq_obj2id[weld] = 0
        connector.held = None
        connector.load = 0.0, 0.0
        connector.change(attached_to="", offset=IDENTITY, force=0.0, moment=0.0, **fields)
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
        """Read forces and moments of all welds from the constraints of the last step, and break off overloads."""
        data = self._data
        max_force, max_moment = self._setup.limits.max_force, self._setup.limits.max_moment
        rows = data.ne // 6
        if not rows:
            return
        welds = data.efc_id[: 6 * rows : 6]
        forces = data.efc_force[: 6 * rows].reshape(rows, 2, 3)
        loads = np.sqrt(np.einsum("nij,nij->ni", forces, forces)) * HALF_ANGLE
        mean = self._loads[welds]
        mean += (loads - mean) / OVERLOAD_MEASUREMENTS
        self._loads[welds] = mean
        for weld, (force, moment) in zip(welds.tolist(), mean.tolist(), strict=True):
            connector = self._by_weld[weld]
            if connector.held is None:
                continue
            if force > max_force or moment > max_moment:
                self._break_off(connector, force, moment)
                continue
            connector.load = force, moment

    def _break_off(self, connector: SimulatedConnector, force: float, moment: float) -> None:
        limits, state = self._setup.limits, connector.state()
        too_much = (
            f"{force:.0f} N, rated {limits.max_force:.0f} N"
            if force > limits.max_force
            else f"{moment:.1f} N m, rated {limits.max_moment:.1f} N m"
        )
        self._release(
            connector,
            enabled=False,
            broken_off=state.broken_off + 1,
            error=ConnectorError.OVERLOADED,
            last_error=f"{state.attached_to} broke off: {too_much}",
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
    return {
        name: SimulatedConnector(name, part, int(model.body(body).id), frame, int(model.equality(name).id))
        for name, (part, body, frame) in frames.items()
    }


def _faces(cell: CellModel) -> Iterable[Face]:
    for part in cell.setup.parts:
        kind = cell.setup.types[part.type]
        body = int(cell.model.body(part.name).id)
        if kind.kind is PartKind.BOX:
            yield from _box_faces(part.name, kind, body)
            continue
        if kind.kind is not PartKind.BASE:
            yield Face(part.name, body, IDENTITY)
        yield Face(part.name, body, kind.grasp)
        if kind.back is not None:
            yield Face(part.name, body, kind.back)
        carried = int(cell.model.body(carrier(part.name, kind)).id)
        for frame in kind.connectors.values():
            yield Face(part.name, carried, frame @ HALF_TURN)


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
