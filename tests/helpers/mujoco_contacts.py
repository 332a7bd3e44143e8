"""Contacts of an arm with boxes and with the robot itself, by MuJoCo: a second opinion on plans."""

from __future__ import annotations

from collections.abc import Sequence

import mujoco
import numpy as np
from lxml import etree
from numpy.typing import NDArray

from jauspy.planning.obstacles import Box, Cylinder, Obstacles, Primitive
from jauspy.platform.description import RobotModel

Array = NDArray[np.float64]


class MujocoContacts:
    """A robot with a fixed base among obstacles."""

    def __init__(self, model: RobotModel, group: str, obstacles: Obstacles, held: Primitive | None = None) -> None:
        spec = mujoco.MjSpec.from_string(_plain(model.description.urdf))
        for number, thing in enumerate(obstacles.primitives):
            _add(spec.worldbody, f"obstacle {number}", thing)
        for number, voxel in enumerate(obstacles.voxels):
            half = [obstacles.voxel_size / 2.0] * 3
            spec.worldbody.add_geom(name=f"obstacle v{number}", type=mujoco.mjtGeom.mjGEOM_BOX, size=half, pos=voxel)
        if held is not None:
            _add(next(body for body in spec.bodies if body.name == model.groups[group].tip), "held", held)
        self._model = spec.compile()
        self._model.geom_margin[:] = 0.0
        self._data = mujoco.MjData(self._model)
        self._group = model.groups[group].joints
        positions = {
            name: value for one in model.groups.values() for name, value in zip(one.joints, one.start, strict=True)
        }
        self._others = {
            joint.name: joint.position(positions)
            for joint in model.description.joints.values()
            if joint.is_independent or joint.mimics
        }
        self._address = {
            self._model.joint(number).name: int(self._model.jnt_qposadr[number]) for number in range(self._model.njnt)
        }
        carried = {number for number in range(self._model.nbody) if self._is_carried(number)}
        self._moves = [int(body) in carried for body in self._model.geom_bodyid]
        self._ignored: set[frozenset[str]] = set()
        self._connected = {frozenset((joint.parent, joint.child)) for joint in model.description.joints.values()}
        start = self._pairs(model.groups[group].start)
        self._ignored = {pair for pair in start if not any(name.startswith("obstacle") for name in pair)}
        self._connected |= self._ignored

    def at(self, posture: Sequence[float] | Array) -> set[frozenset[str]]:
        """The pairs of things that are in contact, without links that touch where the robot starts."""
        return self._pairs(posture) - self._ignored

    def clearance(self, posture: Sequence[float] | Array, most: float) -> float:
        """The smallest distance between things but those that a joint connects, in metres; `most` if it is larger."""
        self._model.geom_margin[:] = most
        found = self._distances(posture)
        self._model.geom_margin[:] = 0.0
        return min([most, *(metres for pair, metres in found.items() if pair not in self._connected)])

    def _pairs(self, posture: Sequence[float] | Array) -> set[frozenset[str]]:
        return {pair for pair, metres in self._distances(posture).items() if metres < 0.0}

    def _distances(self, posture: Sequence[float] | Array) -> dict[frozenset[str], float]:
        """Distances of the pairs that MuJoCo reports, the smallest of each."""
        data, model = self._data, self._model
        for name, value in {**self._others, **dict(zip(self._group, posture, strict=True))}.items():
            if name in self._address:
                data.qpos[self._address[name]] = value
        mujoco.mj_kinematics(model, data)
        mujoco.mj_comPos(model, data)
        mujoco.mj_collision(model, data)
        found: dict[frozenset[str], float] = {}
        for contact in data.contact[: data.ncon]:
            if any(self._moves[geom] for geom in contact.geom):
                pair = frozenset(self._name(int(geom)) for geom in contact.geom)
                found[pair] = min(found.get(pair, float(contact.dist)), float(contact.dist))
        return found

    def _is_carried(self, body: int) -> bool:
        while body:
            first = int(self._model.body_jntadr[body])
            if first >= 0 and self._model.joint(first).name in self._group:
                return True
            body = int(self._model.body_parentid[body])
        return False

    def _name(self, geom: int) -> str:
        own = self._model.geom(geom).name
        return own if own.startswith(("obstacle", "held")) else self._model.body(self._model.geom_bodyid[geom]).name


def _plain(urdf: str) -> str:
    """The URDF without what is only seen, as MuJoCo is to read it: all links, with their collisions."""
    root = etree.fromstring(urdf.encode())
    for visual in list(root.iter("visual")):
        visual.getparent().remove(visual)
    extension = etree.SubElement(root, "mujoco")
    etree.SubElement(extension, "compiler", fusestatic="false", discardvisual="true", balanceinertia="true")
    return etree.tostring(root).decode()


def _add(body: object, name: str, thing: Primitive) -> None:
    rotation = np.array(thing.pose.rotation)
    quaternion = np.zeros(4)
    mujoco.mju_mat2Quat(quaternion, rotation.ravel())
    if isinstance(thing, Box):
        kind, size = mujoco.mjtGeom.mjGEOM_BOX, [side / 2.0 for side in thing.size]
    elif isinstance(thing, Cylinder):
        kind, size = mujoco.mjtGeom.mjGEOM_CYLINDER, [thing.radius, thing.length / 2.0, 0.0]
    else:
        kind, size = mujoco.mjtGeom.mjGEOM_SPHERE, [thing.radius, 0.0, 0.0]
    body.add_geom(name=name, type=kind, size=size, pos=thing.pose.position, quat=quaternion, mass=0.001)
