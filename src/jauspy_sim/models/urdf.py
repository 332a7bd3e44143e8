"""The body of a robot in MuJoCo, from its URDF: links, joints, inertias, shapes, materials.

Visual shapes are drawn, collision shapes collide, of a mesh its convex hull. Links that are fixed to each other remain
separate bodies, because sensors and cameras refer to them.
"""

from __future__ import annotations

import logging
import math
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Final

import mujoco

from jauspy.errors import ConfigError
from jauspy.geometry.poses import Transform
from jauspy.geometry.urdf import Element, Joint, JointKind, RobotDescription, numbers, origin, parse_tree, place
from jauspy.geometry.vectors import quaternion
from jauspy_sim.models.groups import COLLISION, VISUAL
from jauspy_sim.models.inertias import KEYS, MIN_INERTIA, checked_inertia, set_inertia
from jauspy_sim.models.shapes import DENSITY, RGBA, Look, MeshSource, ShapeBuilder, Solid

_LOG = logging.getLogger("jauspy_sim.urdf")

MIN_MASS: Final = 1e-3
"""Kilograms of a link that a joint moves and that has no mass: neither itself, nor what is fixed to it."""

LOCKED: Final = 1e-5
"""Radians or metres that a joint may move whose limits are the same."""


def body_name(link: str) -> str:
    """The name of the body of a link; `world` is a name that MuJoCo has itself."""
    return "world_link" if link == "world" else link


def urdf_spec(description: RobotDescription) -> mujoco.MjSpec:
    """The robot, without motors and fixed to the world. Raises `ConfigError` with file and line."""
    try:
        return _Reader(description).read()
    except ConfigError as error:
        raise ConfigError(f"URDF of {description.name}: {error}") from error


def material_colour(material: Element) -> RGBA | None:
    """The colour that a `<material>` has itself, limited to 0..1; None without one. Raises `ConfigError`."""
    colour = material.find("color")
    if colour is None or not colour.get("rgba"):
        return None
    red, green, blue, alpha = (min(1.0, max(0.0, value)) for value in numbers(colour, "rgba", 4))
    return red, green, blue, alpha


@dataclass(frozen=True, slots=True)
class _Material:
    colour: RGBA | None
    texture: Path | None


class _Reader:
    def __init__(self, description: RobotDescription) -> None:
        self._description = description
        self._root = parse_tree(description.urdf)
        self._links = {str(link.get("name")): link for link in self._root.findall("link")}
        self._spec = mujoco.MjSpec()
        self._spec.modelname = description.name
        self._spec.compiler.degree = False
        self._shapes = ShapeBuilder(self._spec, visual=VISUAL, collision=COLLISION)
        self._materials = {
            str(material.get("name")): self._material_of(material)
            for material in self._root.findall("material")
            if len(material)
        }
        self._below: dict[str, list[Joint]] = {}
        for joint in description.joints.values():
            self._below.setdefault(joint.parent, []).append(joint)

    def read(self) -> mujoco.MjSpec:
        root = self._description.root()
        pending = [(root, self._spec.worldbody.add_body(name=body_name(root)))]
        while pending:
            link, body = pending.pop()
            self._add_link(link, body)
            for joint in self._below.get(link, []):
                child = body.add_body(name=body_name(joint.child))
                frame = Transform.from_pose(joint.origin)
                child.pos, child.quat = frame.position, quaternion(frame.rotation)
                self._add_joint(child, joint)
                pending.append((joint.child, child))
        self._add_mimics()
        self._give_mass()
        return self._spec

    def _add_joint(self, body: mujoco.MjsBody, joint: Joint) -> None:
        if joint.kind is JointKind.FIXED:
            return
        slides = joint.kind is JointKind.PRISMATIC
        added = body.add_joint(
            name=joint.name,
            type=mujoco.mjtJoint.mjJNT_SLIDE if slides else mujoco.mjtJoint.mjJNT_HINGE,
            axis=joint.axis,
        )
        if math.isfinite(joint.lower) and math.isfinite(joint.upper):
            added.limited = mujoco.mjtLimited.mjLIMITED_TRUE
            added.range = (joint.lower, max(joint.upper, joint.lower + LOCKED))
        if joint.effort:
            added.actfrclimited = mujoco.mjtLimited.mjLIMITED_TRUE
            added.actfrcrange = (-joint.effort, joint.effort)

    def _add_mimics(self) -> None:
        for joint in self._description.joints.values():
            if joint.mimics is not None:
                equality = self._spec.add_equality(
                    type=mujoco.mjtEq.mjEQ_JOINT,
                    name1=joint.name,
                    name2=joint.mimics,
                )
                equality.data = [joint.offset, joint.multiplier, *[0.0] * (len(equality.data) - 2)]

    def _add_link(self, name: str, body: mujoco.MjsBody) -> None:
        link = self._links[name]
        for visual in link.findall("visual"):
            look = self._look(visual)
            self._add_shape(visual, _Drawing(self._shapes, body, look))
        for collision in link.findall("collision"):
            self._add_shape(collision, _Colliding(self._shapes, body, Solid(mass=0.0)))
        self._add_inertial(link, body)

    def _add_shape(self, element: Element, target: _Drawing | _Colliding) -> None:
        geometry = element.find("geometry")
        shape = None if geometry is None else geometry.find("*")
        if shape is None:
            raise ConfigError(f"{place(element)}: <{element.tag}> has no <geometry>")
        pose = Transform.from_pose(origin(element))
        kinds = mujoco.mjtGeom
        match shape.tag:
            case "box":
                target.primitive(kinds.mjGEOM_BOX, [half / 2.0 for half in _sizes(shape, "size", 3)], pose)
            case "sphere":
                target.primitive(kinds.mjGEOM_SPHERE, _sizes(shape, "radius", 1), pose)
            case "cylinder" | "capsule":
                (radius,), (length,) = _sizes(shape, "radius", 1), _sizes(shape, "length", 1)
                kind = kinds.mjGEOM_CYLINDER if shape.tag == "cylinder" else kinds.mjGEOM_CAPSULE
                target.primitive(kind, (radius, length / 2.0), pose)
            case "mesh":
                scale = numbers(shape, "scale", 3, "1 1 1")
                if not all(scale):
                    raise ConfigError(f'{place(shape)}: <mesh scale="{shape.get("scale")}">: must not be zero')
                _located(shape, lambda: target.mesh(Path(shape.get("filename", "")), pose, scale))
            case other:
                raise ConfigError(
                    f"{place(shape)}: <{other}> is not a shape that is read; known are: box, cylinder, sphere, "
                    "capsule, mesh"
                )

    def _look(self, visual: Element) -> Look:
        element = visual.find("material")
        if element is None:
            return Look()
        named = self._materials.get(str(element.get("name")), _Material(None, None))
        own_material = self._material_of(element)
        return Look(own_material.colour or named.colour, own_material.texture or named.texture, yields=True)

    @staticmethod
    def _material_of(element: Element) -> _Material:
        texture = element.find("texture")
        file = None if texture is None else texture.get("filename")
        return _Material(material_colour(element), Path(file) if file else None)

    def _add_inertial(self, link: Element, body: mujoco.MjsBody) -> None:
        inertial = link.find("inertial")
        if inertial is None:
            return
        mass_element = inertial.find("mass")
        mass = 0.0 if mass_element is None else numbers(mass_element, "value", 1)[0]
        if mass < 0.0:
            where = place(inertial if mass_element is None else mass_element)
            raise ConfigError(f"{where}: link {link.get('name')!r}: a mass of {mass:g} kg is negative")
        if not mass:
            return
        element = inertial.find("inertia")
        place_of_it = place(inertial if element is None else element)
        moments = [0.0 if element is None else numbers(element, key, 1, "0")[0] for key in KEYS]
        tensor = checked_inertia(tuple(moments), mass, f"{place_of_it}: link {link.get('name')!r}")
        set_inertia(body, mass, Transform.from_pose(origin(inertial)), tensor)

    def _give_mass(self) -> None:
        """Give a mass to links that a joint moves, and that have none: neither they nor what is fixed to them."""
        weighed, guessed = [], []
        for joint in self._description.joints.values():
            if joint.kind is JointKind.FIXED or self._has_mass(joint.child):
                continue
            body = self._spec.body(body_name(joint.child))
            if solids := [geom for geom in body.geoms if geom.group == COLLISION]:
                for geom in solids:
                    geom.mass = math.nan  # of its density
                weighed.append(joint.child)
                continue
            body.mass, body.explicitinertial = MIN_MASS, True
            body.inertia = (MIN_INERTIA,) * 3
            guessed.append(joint.child)
        for links, mass in ((weighed, f"{DENSITY:g} kg/m^3 of their collision shapes"), (guessed, f"{MIN_MASS:g} kg")):
            if links:
                names = ", ".join(links[:8]) + ", ..." * (len(links) > 8)
                _LOG.warning(
                    "%s: joints move %d links without a mass, which get %s: %s",
                    *(self._description.name, len(links), mass, names),
                )

    def _has_mass(self, link: str) -> bool:
        fixed = [joint.child for joint in self._below.get(link, []) if joint.kind is JointKind.FIXED]
        return self._spec.body(body_name(link)).explicitinertial or any(map(self._has_mass, fixed))


@dataclass(frozen=True, slots=True)
class _Drawing:
    shapes: ShapeBuilder
    body: mujoco.MjsBody
    look: Look

    def primitive(self, kind: mujoco.mjtGeom, size: tuple[float, ...] | list[float], pose: Transform) -> None:
        self.shapes.draw(self.body, kind, size, pose, self.look)

    def mesh(self, path: Path, pose: Transform, scale: tuple[float, ...]) -> None:
        self.shapes.draw_mesh(self.body, MeshSource(path, scale), pose, self.look)


@dataclass(frozen=True, slots=True)
class _Colliding:
    shapes: ShapeBuilder
    body: mujoco.MjsBody
    solid: Solid

    def primitive(self, kind: mujoco.mjtGeom, size: tuple[float, ...] | list[float], pose: Transform) -> None:
        self.shapes.collide(self.body, kind, size, pose, self.solid)

    def mesh(self, path: Path, pose: Transform, scale: tuple[float, ...]) -> None:
        self.shapes.collide_mesh(self.body, MeshSource(path, scale), pose, self.solid)


def _located(element: Element, add: Callable[[], None]) -> None:
    """Call `add`; a `ConfigError` gets the place of the element."""
    try:
        add()
    except ConfigError as error:
        raise ConfigError(f"{place(element)}: <{element.tag}>: {error}") from error


def _sizes(shape: Element, key: str, count: int) -> tuple[float, ...]:
    """Lengths in metres; one of zero, as some tools write it for a marker, is a tenth of a millimetre."""
    found = numbers(shape, key, count, "")
    if min(found) < 0.0:
        raise ConfigError(f'{place(shape)}: <{shape.tag} {key}="{shape.get(key)}">: a size is negative')
    return tuple(max(length, 1e-4) for length in found)
