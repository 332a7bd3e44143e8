"""The planning scene and the layout of the cell.

The scene has the arm's links, the part that it holds and what stands around it, with distances by coal. The layout is
what the robot's file describes: the parts and their types, the bases, and the arm that handles parts.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from itertools import pairwise
from typing import Any, Final, Protocol

import coal
import numpy as np
import pinocchio as pin

from jauspy.cell.frames import Array, se3, se3_of_pose, shifted, turned
from jauspy.cell.kinematics import ArmKinematics
from jauspy.errors import ConfigError
from jauspy.platform.description import GroupSetup, RobotModel
from jauspy.platform.modular.parts import CellSetup, PartKind, PartSolid, PartType, Shape

FAR: Final = 1.0
"""Metres beyond which a distance is not computed; what is farther off counts as this far."""
NEIGHBOURS: Final = 1
"""Links up to so many joints apart touch each other by design."""
HAND: Final = 3
"""The last joint before the wrist, whose short links cannot reach each other."""


@dataclass(frozen=True, slots=True)
class Clearance:
    """The smallest distance in one posture, in metres, and the two things that it is between."""

    distance: float
    between: tuple[str, str] = ("", "")


CLEAR: Final = Clearance(FAR)


@dataclass(frozen=True, slots=True)
class Piece:
    """A convex shape and its frame in that of the thing that it belongs to."""

    shape: Any
    frame: pin.SE3


@dataclass(frozen=True, slots=True)
class LinkPiece:
    """A piece of an arm, and the number of the joint that moves it; 0 is the foot."""

    name: str
    piece: Piece
    joint: int


class Kinematics(Protocol):
    """An arm of which pinocchio has a model."""

    model: Any
    data: Any
    tool: int
    """The number of the tool's frame in the model."""


def pieces_of(solids: Iterable[PartSolid], frame: pin.SE3 | None = None) -> list[Piece]:
    """The shapes of solids whose frame is `frame` in that of the thing."""
    frame = frame or pin.SE3.Identity()
    return [Piece(_shape(solid), frame * se3(solid.pose)) for solid in solids]


def pieces_of_part(type: PartType, position: float = 0.0) -> list[Piece]:
    """The shapes of a part in its own frame; `position` is that of a servo's joint, in radians."""
    found = pieces_of(type.solids)
    if type.servo is not None:
        found += pieces_of(type.servo.output, output_frame(type, position))
    return found


def output_frame(type: PartType, position: float = 0.0) -> pin.SE3:
    """The frame of a servo's output link in that of the part; the identity for other parts."""
    if type.servo is None:
        return pin.SE3.Identity()
    turn = pin.SE3(pin.exp3(np.array(type.servo.axis) * position), np.zeros(3))
    joint = se3(type.servo.joint)
    # the axis is given in the part's frame, and goes through the origin of the joint
    about = pin.SE3(np.eye(3), joint.translation)
    return about * turn * about.inverse() * joint


def connector_frame(type: PartType, connector: str, position: float = 0.0) -> pin.SE3:
    """The frame of a connector in that of the part. Raises `ConfigError` for an unknown one."""
    if connector not in type.connectors:
        known = ", ".join(type.connectors) or "none"
        raise ConfigError(f"a {type.name} has no connector {connector!r}; it has: {known}")
    return output_frame(type, position) * se3(type.connectors[connector])


def _shape(solid: PartSolid) -> Any:
    x, y, z = solid.size
    return coal.Box(x, y, z) if solid.shape is Shape.CUBOID else coal.Cylinder(x, z)


@dataclass(slots=True)
class _Object:
    """A shape with its name, as the broad phase uses it."""

    name: str
    shape: Any
    frame: pin.SE3
    """Placement in the frame of the thing, or of the arm's link."""
    joint: int = 0
    body: Any = None
    """The shape where it is, for coal."""

    def __post_init__(self) -> None:
        self.body = coal.CollisionObject(self.shape)

    def place(self, frame: pin.SE3) -> None:
        world = frame * self.frame
        self.body.setTransform(coal.Transform3s(world.rotation, world.translation))
        self.body.computeAABB()


class PlanningScene:
    """The obstacles of the arm. Things are named; each consists of convex shapes and has a pose in the world."""

    def __init__(self, kinematics: Kinematics, links: Iterable[LinkPiece], *, wrist: int | None = HAND) -> None:
        self.kinematics = kinematics
        self._links = [_Object(link.name, link.piece.shape, link.piece.frame, link.joint) for link in links]
        self._last_checked = math.inf if wrist is None else wrist
        """Number of the joint: of two links of the arm, one must be moved by it or by one before."""
        self._things: dict[str, list[_Object]] = {}
        self._poses: dict[str, pin.SE3] = {}
        self._ignored: set[str] = set()
        self._held: list[_Object] = []
        self._held_name = ""
        self._manager = coal.DynamicAABBTreeCollisionManager()
        self._pairs = self._self_pairs()
        self.checks = 0
        """Postures that were checked so far."""

    # --- what is there --------------------------------------------------------------------------------------------

    @property
    def poses(self) -> Mapping[str, pin.SE3]:
        """The poses of the things that stand around, in the world."""
        return self._poses

    def pieces(self, name: str) -> list[Piece]:
        """The shapes of a thing."""
        return [Piece(thing.shape, thing.frame) for thing in self._things[name]]

    def links_at(self, positions: Array) -> list[tuple[str, Piece, pin.SE3]]:
        """The arm's links in a posture: name, shape and the frame of the joint that moves it, in the world."""
        k = self.kinematics
        pin.forwardKinematics(k.model, k.data, positions)
        return [
            (f"{number} {link.name}", Piece(link.shape, link.frame), k.data.oMi[link.joint].copy())
            for number, link in enumerate(self._links)
        ]

    def put(self, name: str, pieces: Iterable[Piece], pose: pin.SE3) -> None:
        """Add a thing at a pose, or move it there."""
        self.remove(name)
        objects = [_Object(name, piece.shape, piece.frame) for piece in pieces]
        for piece in objects:
            piece.place(pose)
        self._things[name], self._poses[name] = objects, pose
        if name not in self._ignored:
            self._register(objects)

    def remove(self, name: str) -> None:
        """Remove a thing; without effect if there is none of that name."""
        objects = self._things.pop(name, None)
        self._poses.pop(name, None)
        if objects is not None and name not in self._ignored:
            self._unregister(objects)

    def hold(self, name: str, pieces: Iterable[Piece], frame: pin.SE3) -> None:
        """Attach a thing to the tool, with `frame` in the tool's frame; it is no longer an obstacle."""
        self.remove(name)
        self._held = [_Object(name, piece.shape, frame * piece.frame) for piece in pieces]
        self._held_name = name

    def release(self) -> None:
        """Remove the thing that the arm holds."""
        self._held, self._held_name = [], ""

    @property
    def held(self) -> tuple[str, Sequence[Any]]:
        """The load of the arm, for `restore`."""
        return self._held_name, self._held

    def restore(self, held: tuple[str, Sequence[Any]]) -> None:
        """Restore a value of `held`."""
        self._held_name, self._held = held[0], list(held[1])

    @contextmanager
    def without(self, *names: str) -> Iterator[None]:
        """Ignore things in the block: those that the arm is about to touch."""
        new = [name for name in names if name not in self._ignored]
        for name in new:
            self._unregister(self._things.get(name, []))
        self._ignored |= set(new)
        try:
            yield
        finally:
            self._ignored -= set(new)
            for name in new:
                self._register(self._things.get(name, []))

    # --- distances ------------------------------------------------------------------------------------------------

    def clearance(self, positions: Array, *, enough: float = FAR) -> Clearance:
        """The smallest distance of the arm, and of what it holds, from everything and from itself.

        Distances above `enough` are not distinguished; a negative distance is the depth of a penetration, at least 0.
        """
        self.checks += 1
        self._place(positions)
        best = Clearance(min(enough, FAR))
        for piece in (*self._held, *reversed(self._links)):
            if piece.joint == 0 and piece not in self._held:
                continue  # the foot of the arm does not move
            best = self._nearest(piece, best)
            if best.distance <= 0.0:
                return best
        for a, b in self._pairs:
            best = _pair_distance(a, b, best)
        for held in self._held:
            for link in self._links:
                if link.joint <= self._last_checked:
                    best = _pair_distance(held, link, best)
        return best

    def clearance_from(self, positions: Array, names: Iterable[str]) -> Clearance:
        """The smallest distance of the arm alone, without what it holds, from these things, up to `FAR`.

        They count also inside of `without`.
        """
        self._place(positions)
        best = Clearance(FAR)
        for link in self._links:
            for name in names if link.joint else ():
                for thing in self._things.get(name, ()):
                    best = _pair_distance(link, thing, best)
        return best

    def clearance_of(self, pieces: Iterable[Piece], pose: pin.SE3) -> Clearance:
        """The smallest distance of a free body from the things that stand around, up to `FAR`."""
        best = Clearance(FAR)
        for piece in pieces:
            body = _Object("box", piece.shape, piece.frame)
            body.place(pose)
            best = self._nearest(body, best)
        return best

    def is_free(self, positions: Array, margin: float) -> bool:
        """True if nothing is closer than `margin` metres."""
        return self.clearance(positions, enough=margin).distance >= margin

    def along(self, path: Sequence[Array], step: float, *, enough: float = FAR) -> Clearance:
        """The smallest distance along straight joint motions, checked every `step` radians."""
        best, where = Clearance(enough), None
        for a, b in pairwise(path):
            count = max(1, math.ceil(float(np.max(np.abs(b - a))) / step))
            for number in range(count + 1):
                q = a + (b - a) * (number / count)
                found = self.clearance(q, enough=best.distance)
                if found.distance < best.distance:
                    best, where = found, q
        return self.explain(where) if where is not None else best

    def explain(self, positions: Array) -> Clearance:
        """Same as `clearance`, with the names of both things, which takes longer."""
        best = self.clearance(positions)
        if best.distance >= FAR or all(best.between):
            return best
        moving = [link for link in (*self._links, *self._held) if link.name == best.between[0]]
        things = [piece for name, found in self._things.items() if name not in self._ignored for piece in found]
        nearest = Clearance(math.inf)
        for a in moving:
            for b in things:
                nearest = _pair_distance(a, b, nearest)
        return Clearance(best.distance, nearest.between)

    # --- inside ---------------------------------------------------------------------------------------------------

    def _place(self, positions: Array) -> None:
        k = self.kinematics
        pin.framesForwardKinematics(k.model, k.data, positions)
        for link in self._links:
            link.place(k.data.oMi[link.joint])
        tool = k.data.oMf[k.tool]
        for piece in self._held:
            piece.place(tool)

    def _nearest(self, moving: _Object, best: Clearance) -> Clearance:
        query = coal.DistanceCallBackDefault()
        query.data.result.min_distance = best.distance
        self._manager.distance(moving.body, query)
        found = float(query.data.result.min_distance)
        return Clearance(found, (moving.name, "")) if found < best.distance else best

    def _register(self, objects: Iterable[_Object]) -> None:
        for piece in objects:
            self._manager.registerObject(piece.body)
        self._manager.setup()

    def _unregister(self, objects: Iterable[_Object]) -> None:
        for piece in objects:
            self._manager.unregisterObject(piece.body)
        self._manager.setup()

    def _self_pairs(self) -> list[tuple[_Object, _Object]]:
        links, last = self._links, self._last_checked
        return [(a, b) for a in links for b in links if b.joint - a.joint > NEIGHBOURS and a.joint <= last]


def _pair_distance(a: _Object, b: _Object, best: Clearance) -> Clearance:
    if a.body.getAABB().distance(b.body.getAABB()) > max(best.distance, 0.0):
        return best
    result = coal.DistanceResult()
    found = coal.distance(a.body, b.body, coal.DistanceRequest(), result)
    return Clearance(float(found), (a.name, b.name)) if found < best.distance else best


def links_of_urdf(urdf: str, joints: Sequence[str]) -> list[LinkPiece]:
    """The collision shapes of a URDF's links, each with the joint that moves it."""
    model = pin.buildModelFromXML(urdf)
    shapes = pin.buildGeomFromUrdfString(model, urdf, pin.GeometryType.COLLISION)
    others = [model.getJointId(name) for name in list(model.names)[1:] if name not in joints]
    if others:
        _, shapes = pin.buildReducedModel(model, shapes, others, pin.neutral(model))
    return [
        LinkPiece(
            geometryObject.name, Piece(geometryObject.geometry, geometryObject.placement), geometryObject.parentJoint
        )
        for geometryObject in shapes.geometryObjects
    ]


FLOOR_SIZE: Final = 8.0
BELT_THICKNESS: Final = 0.1
SPEED_SHARE: Final = 0.97
ACCELERATION_TIME: Final = 0.35
"""Seconds in which a joint reaches full speed; more than the joints need, so that parts are carried without a jerk."""


def cell_of(model: RobotModel) -> CellSetup:
    """The cell around a robot. Raises `ConfigError` for a robot without one."""
    if model.cell is None:
        raise ConfigError("this robot's file has no [cell]; `jauspy cell` needs a factory cell, such as cell.toml")
    return model.cell


def arm_group(model: RobotModel) -> GroupSetup:
    """The joints of the arm with the gripper. Raises `ConfigError` if there is none."""
    cell = cell_of(model)
    for group in model.groups.values():
        if group.tip == cell.gripper:
            return group
    raise ConfigError(f"no group of joints ends at the gripper {cell.gripper!r}")


def _latched_faces(kind: PartType) -> list[pin.SE3]:
    """Faces of a part on which a latch locks, as the frames in the part of a plate that is attached there."""
    if kind.kind is PartKind.BOX:
        return []
    faces = [se3(grasp) for grasp in kind.grasps] if kind.grasp_latch else []
    if kind.latch:
        faces += [] if kind.kind is PartKind.BASE else [pin.SE3.Identity()]
        faces += [connector_frame(kind, name) * turned("x", math.pi) for name in kind.connectors]
    return faces


class Layout:
    """The cell's types of parts, its bases, and the arm that handles parts."""

    def __init__(self, model: RobotModel) -> None:
        self.setup = cell_of(model)
        self.group = arm_group(model)
        self.urdf = model.description.urdf
        self.kinematics = ArmKinematics(self.urdf, self.group.joints, self.group.tip)
        self.home: Array = np.array(self.group.start)
        self.speeds: Array = SPEED_SHARE * self.kinematics.speeds
        """rad/s of motions: the limits, less what a controller may need to catch up."""
        self.accelerations: Array = self.speeds / ACCELERATION_TIME
        """rad/s^2."""
        self._types: Mapping[str, str] = {part.name: part.type for part in self.setup.parts}

    @property
    def arms(self) -> tuple[str, ...]:
        """The names of the modular arms; the first one is commanded where none is named."""
        return tuple(name for name in (self.setup.arm, self.setup.second_arm) if name)

    def type_of(self, part: str) -> PartType:
        """The type of a part. Raises `ConfigError` for an unknown name."""
        return self.setup.type_of(part)

    def locks(self, connector: str, part: str, grasp: pin.SE3 | None = None) -> bool:
        """True if a connector, named as in `servo_1/output`, or the gripper, locks a part mechanically.

        The gripper locks on the faces that have a latch: flanges, and with `grasp_latch` those by which it holds the
        part. `grasp` is the gripper in the part's frame, by default the usual one; other connectors hold flanges.
        """
        if not part:
            return False
        kind = self.type_of(part)
        owner, _, own = connector.partition("/")
        if own:
            return kind.latch and self.type_of(owner).latch
        at = self.grasp(part) if grasp is None else grasp
        return self.setup.gripper_latch and any(self._is_at(face, at) for face in _latched_faces(kind))

    def _is_at(self, face: pin.SE3, plate: pin.SE3) -> bool:
        """True for a plate that is close enough to a face to be attached there."""
        apart, limits = face.actInv(plate), self.setup.limits
        aligned = apart.rotation[2, 2] >= math.cos(limits.max_angle)
        return bool(aligned and np.linalg.norm(apart.translation) <= limits.max_distance)

    def of_types(self, types: tuple[str, ...]) -> list[str]:
        """The names of the parts of these types: those of the first type first."""
        return [name for type in types for name, kind in self._types.items() if kind == type]

    def scene(self) -> PlanningScene:
        """A scene with all that is fixed, and the parts where the file has them."""
        scene = PlanningScene(self.kinematics, links_of_urdf(self.urdf, self.group.joints))
        scene.put("floor", [Piece(coal.Box(FLOOR_SIZE, FLOOR_SIZE, 0.1), shifted(z=-0.05))], pin.SE3.Identity())
        for bin in self.setup.bins:
            scene.put(bin.name, pieces_of(bin.solids()), se3_of_pose(bin.pose))
        for fixture in self.setup.fixtures:
            scene.put(fixture.name, pieces_of(fixture.solids), se3_of_pose(fixture.pose))
        if (belt := self.setup.conveyor) is not None:
            box = coal.Box(belt.length, belt.width, BELT_THICKNESS)
            scene.put("conveyor", [Piece(box, shifted(z=-BELT_THICKNESS / 2.0))], se3_of_pose(belt.pose))
        for part in self.setup.parts:
            scene.put(part.name, pieces_of_part(self.type_of(part.name)), se3_of_pose(part.pose))
        return scene

    def grasps(self, part: str) -> list[pin.SE3]:
        """The gripper's poses in the part's frame on all faces by which it can hold the part, the usual one first."""
        return [se3(grasp) for grasp in self.type_of(part).grasps]

    def thickness(self, part: str) -> float:
        """Height of a part that lies with its grasp upward, metres."""
        solid = self.type_of(part).solids[0]
        if solid.shape is Shape.CYLINDER:
            return solid.size[2]
        normal = np.abs(self.grasp(part).rotation[:, 2])
        return float(normal @ np.array(solid.size))

    def grasp(self, part: str) -> pin.SE3:
        """The gripper's pose in the part's frame when it holds the part."""
        return se3(self.type_of(part).grasp)
