"""Kinematic model of an arm for planners: frames of many postures at once, and its collision shapes for pinocchio.

The frame of all poses is the root link's of the robot. Joints that are not the arm's stay where the model was made.
Shapes are those of the URDF's collisions; of meshes, their convex hulls.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from itertools import combinations, product
from typing import Any, Final

import coal
import numpy as np
import pinocchio as pin

from jauspy.errors import ConfigError
from jauspy.geometry.link_pairs import LinkPairs, mover
from jauspy.geometry.urdf import Joint, JointKind, RobotDescription
from jauspy.planning.obstacles import Array, Box, Cylinder, Primitive
from jauspy.platform.description import RobotModel
from jauspy.platform.joint_control import ACCELERATION_TIME

JERK_TIME: Final = 0.1
"""Seconds in which a joint's acceleration rises to its limit."""
SAMPLES: Final = 200
"""Postures by which it is measured how far joints move points of the arm."""
WITHOUT_LIMITS: Final = math.tau
"""Radians to both sides of zero that joints without limits are moved by planners."""
METRES_TO_RADIANS: Final = 3.0
"""Radians that a metre of a prismatic joint counts as in lengths of paths."""


class ArmModel:
    """The arm that is a group of a robot's joints."""

    def __init__(self, model: RobotModel, group: str, others: Mapping[str, float] | None = None) -> None:
        """Make the model of a group of joints; `others` has positions (rad, m) of joints that are not in the group.

        Raises `ConfigError` for an unknown group. Joints that are not named stay where the robot starts.
        """
        if group not in model.groups:
            known = ", ".join(model.groups) or "none"
            raise ConfigError(f"the robot has no group {group!r} of joints; its groups are: {known}")
        setup, description = model.groups[group], model.description
        self.joints = setup.joints
        """Names of the joints, base to tip: the columns of postures."""
        at = {name: value for one in model.groups.values() for name, value in zip(one.joints, one.start, strict=True)}
        at |= others or {}
        self.positions: Mapping[str, float] = {name: at[name] for name in at if name not in self.joints}
        """Positions of the joints of other groups."""
        joints = [description.joint(name) for name in self.joints]
        endless = [joint.kind is JointKind.CONTINUOUS for joint in joints]
        self.lower = np.where(endless, -WITHOUT_LIMITS, [joint.lower for joint in joints])
        self.upper = np.where(endless, WITHOUT_LIMITS, [joint.upper for joint in joints])
        self.speeds: Array = np.array([joint.velocity or 1.0 for joint in joints])
        """Limits in rad/s or m/s; those of acceleration and jerk follow from them."""
        self.accelerations = self.speeds / ACCELERATION_TIME
        self.jerks = self.accelerations / JERK_TIME
        self.scales: Array = np.array([1.0 if joint.turns else METRES_TO_RADIANS for joint in joints])
        """Radians that a unit of each joint counts as in lengths of paths."""
        whole = pin.buildModelFromXML(description.urdf)
        moving = [description.joints[name] for name in list(whole.names)[1:]]
        kept = [joint for joint in moving if mover(joint) in self.joints]
        locked = [number for number, joint in enumerate(moving, 1) if joint not in kept]
        posture = pin.integrate(whole, pin.neutral(whole), np.array([joint.position(at) for joint in moving]))
        shapes = pin.buildGeomFromUrdfString(whole, description.urdf, pin.GeometryType.COLLISION)
        if locked:
            whole, (shapes,) = pin.buildReducedModel(whole, [shapes], locked, posture)
        self.kinematics, self.geometry = whole, shapes
        """The arm for pinocchio, and its collision shapes without pairs."""
        self._neutral = pin.neutral(whole)
        self._is_plain = whole.nq == len(self.joints)
        self._set_chain(kept)
        self._set_shapes(setup.tip, description, np.array(setup.start))

    def _set_chain(self, kept: Sequence[Joint]) -> None:
        """What `frames` needs of the joints that move, mimicking ones included."""
        whole = self.kinematics
        columns = {name: column for column, name in enumerate(self.joints)}
        self._columns = [columns[mover(joint)] for joint in kept]
        self._multipliers: Array = np.array([joint.multiplier if joint.mimics else 1.0 for joint in kept])
        self._offsets: Array = np.array([joint.offset if joint.mimics else 0.0 for joint in kept])
        self._turns: Array = np.array([joint.turns for joint in kept])
        self._parents = [whole.parents[number] for number in range(1, whole.njoints)]
        self._steps = [_step(whole.jointPlacements[n], joint) for n, joint in enumerate(kept, 1)]
        self._constant, self._sine, self._cosine = (np.array(rows) for rows in zip(*self._steps, strict=True))
        self._axes: Array = np.array([joint.axis for joint in kept])

    def _set_shapes(self, tip_link: str, description: RobotDescription, start: Array) -> None:
        """The tool, and the shapes with their pairs; `start`: the posture where the robot starts."""
        whole = self.kinematics
        tip = whole.frames[whole.getFrameId(tip_link)]
        self.tool_body, self.tool_frame = int(tip.parentJoint), tip.placement
        """The body that the tool's link belongs to, and the link's frame in it."""
        self._tool = np.array(tip.placement.homogeneous)
        objects = list(self.geometry.geometryObjects)
        for item in objects:
            _make_convex(item)
        self.links = [_link_of(item, whole) for item in objects]
        """The link of each collision shape."""
        bodies = [int(item.parentJoint) for item in objects]
        self.moving = [number for number, body in enumerate(bodies) if body]
        """Numbers of the shapes that the arm moves."""
        self.pairs = self._touching_pairs(description, start)
        """Numbers of shapes that must not touch each other."""
        holding = {number for number, body in enumerate(bodies) if body == self.tool_body}
        self.apart_from_tool = sorted({n for pair in self.pairs if holding & set(pair) for n in pair} - holding)
        """Numbers of shapes that what the tool holds must not touch."""
        rng = np.random.default_rng(0)
        self._sampled = self.frames(rng.uniform(self.lower, self.upper, (SAMPLES, len(self.joints))))
        self.levers: Array = np.array([self.levers_of(item) for item in objects]).reshape(-1, whole.njoints - 1)
        """Metres that points of each shape move at most for a unit of each pinocchio joint."""

    @property
    def bodies(self) -> int:
        """The number of bodies, with that which does not move."""
        return len(self._parents) + 1

    def configuration(self, posture: Array) -> Array:
        """A posture as pinocchio counts it."""
        if self._is_plain:
            return posture
        values = posture[self._columns] * self._multipliers + self._offsets
        found: Array = pin.integrate(self.kinematics, self._neutral, values)
        return found

    def frames(self, postures: Array) -> Array:
        """Frames of the bodies, shape (n, bodies, 4, 4), for postures of shape (n, joints)."""
        values = postures[:, self._columns] * self._multipliers + self._offsets
        sines = np.where(self._turns, np.sin(values), values)[..., None, None]
        cosines = np.where(self._turns, 1.0 - np.cos(values), 0.0)[..., None, None]
        steps = self._constant + sines * self._sine + cosines * self._cosine
        found = np.empty((len(postures), self.bodies, 4, 4))
        found[:, 0] = np.eye(4)
        for number, parent in enumerate(self._parents):
            np.matmul(found[:, parent], steps[:, number], out=found[:, number + 1])
        return found

    def tool(self, frames: Array) -> Array:
        """Frames of the tool, shape (n, 4, 4), by those of the bodies."""
        found: Array = frames[:, self.tool_body] @ self._tool
        return found

    def jacobian(self, frames: Array, points: Array) -> Array:
        """Velocities of points (n, 3) of the tool, then angular ones, for those of the joints: (n, 6, joints)."""
        frames = frames[:, 1:]
        axes = (frames[..., :3, :3] @ self._axes[..., None])[..., 0]
        ways = points[:, None] - frames[..., :3, 3]
        linear = np.where(self._turns[:, None], np.cross(axes, ways), axes)
        angular = np.where(self._turns[:, None], axes, 0.0)
        carries = self._carries()
        every = np.concatenate([linear, angular], axis=-1) * (self._multipliers * carries)[:, None]
        found = np.zeros((len(frames), 6, len(self.joints)))
        for number, column in enumerate(self._columns):
            found[..., column] += every[:, number]
        return found

    def _path(self, body: int) -> set[int]:
        """The bodies from one to that which does not move."""
        found = set()
        while body:
            found.add(body)
            body = self._parents[body - 1]
        return found

    def _carries(self) -> Array:
        """For the joints: 1 if they move the tool, else 0."""
        path = self._path(self.tool_body)
        return np.array([float(number in path) for number in range(1, self.bodies)])

    def _touching_pairs(self, description: RobotDescription, start: Array) -> list[tuple[int, int]]:
        """Pairs of shapes whose distance the arm changes, without those of links that touch where the robot starts."""
        rigid = [joint.name for joint in description.joints.values() if mover(joint) not in self.joints]
        rule, links = LinkPairs(description, self.joints, rigid=rigid), self.links
        pairs = [
            (one, other) for one, other in combinations(range(len(links)), 2) if rule.movers(links[one], links[other])
        ]
        shapes = self.geometry.copy()
        for one, other in pairs:
            shapes.addCollisionPair(pin.CollisionPair(one, other))
        data = shapes.createData()
        q = self.configuration(start)
        pin.computeCollisions(self.kinematics, self.kinematics.createData(), shapes, data, q, False)
        touching = set()
        for pair, result in zip(shapes.collisionPairs, data.collisionResults, strict=True):
            if result.isCollision():
                touching.add((links[pair.first], links[pair.second]))
        return [(one, other) for one, other in pairs if (links[one], links[other]) not in touching]

    def levers_of(self, item: Any) -> Array:
        """Metres that points of a shape move at most for a unit of each pinocchio joint.

        By the corners of the box around it, in many postures.
        """
        item.geometry.computeLocalAABB()
        box = item.geometry.aabb_local
        corners = np.array(list(product(*zip(box.min_, box.max_, strict=True))))
        corners = corners @ np.array(item.placement.rotation).T + np.array(item.placement.translation)
        frames = self._sampled[:, item.parentJoint]
        points = corners @ frames[:, :3, :3].transpose(0, 2, 1) + frames[:, None, :3, 3]
        found = np.zeros(self.bodies - 1)
        for number in self._path(int(item.parentJoint)):
            joint, axis = self._sampled[:, number], self._axes[number - 1]
            ways = np.cross((joint[:, :3, :3] @ axis)[:, None], points - joint[:, None, :3, 3])
            found[number - 1] = np.linalg.norm(ways, axis=-1).max() if self._turns[number - 1] else 1.0
        return found

    def relative_levers(self, items: Sequence[Any], levers: Array, pairs: Array) -> Array:
        """Metres by which shapes of pairs come nearer at most for a unit of each joint, shape (pairs, joints).

        `items` are the shapes that pairs, shape (n, 2), have the numbers of; `levers` as by `levers_of`, one row each.
        """
        moves = np.zeros(levers.shape, bool)
        for number, item in enumerate(items):
            moves[number, [joint - 1 for joint in self._path(int(item.parentJoint))]] = True
        one, other = pairs.T
        apart = np.where(moves[one] & moves[other], 0.0, levers[one] + levers[other])
        columns = np.zeros((self.bodies - 1, len(self.joints)))
        columns[np.arange(self.bodies - 1), self._columns] = np.abs(self._multipliers)
        found: Array = apart @ columns
        return found


def geometry_of(primitive: Primitive) -> Any:
    """The shape of a primitive for coal."""
    if isinstance(primitive, Box):
        return coal.Box(*primitive.size)
    if isinstance(primitive, Cylinder):
        return coal.Cylinder(primitive.radius, primitive.length)
    return coal.Sphere(primitive.radius)


def _step(at: Any, joint: Joint) -> tuple[Array, Array, Array]:
    """The matrices whose sum, two of them times sine and 1 less the cosine, is a joint's frame in its parent's."""
    constant = np.array(at.homogeneous)
    sine, cosine = np.zeros((4, 4)), np.zeros((4, 4))
    axis = np.array(joint.axis)
    if joint.turns:
        cross = pin.skew(axis)
        sine[:3, :3], cosine[:3, :3] = constant[:3, :3] @ cross, constant[:3, :3] @ cross @ cross
    else:
        sine[:3, 3] = constant[:3, :3] @ axis
    return constant, sine, cosine


def _make_convex(item: Any) -> None:
    """Replace a mesh by its convex hull."""
    if isinstance(item.geometry, coal.BVHModelBase):
        item.geometry.buildConvexHull(True, "Qt")
        item.geometry = item.geometry.convex


def _link_of(item: Any, model: Any) -> str:
    """The link of a geometry: pinocchio names it by link and number."""
    name, _, _ = item.name.rpartition("_")
    return str(name) if model.existBodyName(name) else str(model.frames[item.parentFrame].name)
