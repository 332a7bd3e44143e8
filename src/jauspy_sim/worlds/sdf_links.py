"""Adds the content of SDF links: visual and collision shapes, lights, inertia."""

from __future__ import annotations

import logging
import math
from collections.abc import Sequence
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import Final

import mujoco

from jauspy.errors import ConfigError
from jauspy.geometry.poses import Pose, Transform
from jauspy.geometry.urdf import Element
from jauspy.geometry.vectors import Vector
from jauspy_sim.models.inertias import KEYS, checked_inertia, set_inertia
from jauspy_sim.models.mesh_files import read_heights
from jauspy_sim.models.shapes import Look, MeshSource, ShapeBuilder, Solid
from jauspy_sim.worlds.model_paths import ModelPaths
from jauspy_sim.worlds.sdf_materials import look_of
from jauspy_sim.worlds.sdf_poses import floats, is_true, line_of, located, raw_pose, words

_LOG = logging.getLogger("jauspy_sim.sdf")

QUIET: Final = frozenset(
    [
        "atmosphere",
        "audio",
        "gravity",
        "gui",
        "magnetic_field",
        "meta",
        "physics",
        "scene",
        "spherical_coordinates",
        "state",
        "wind",
        "allow_auto_disable",
        "enable_wind",
        "kinematic",
        "must_be_base_link",
        "self_collide",
        "velocity_decay",
        "cast_shadows",
        "laser_retro",
        "layer",
        "max_contacts",
        "visibility_flags",
        "name",
        "pose",
        "static",
        "uri",
    ]
)
"""Elements that are skipped without a log line: they do not affect the world, or are read elsewhere."""

MAX_HEIGHTS: Final = 257
"""Rows and columns of a height map; larger ones are made smaller."""

MAX_FRICTION: Final = 5.0

DEFAULT_MASS: Final = 1.0
"""Kilograms of a link without `<inertial>`, as SDFormat has it."""

MAX_PLACES: Final = 4
"""Lines of the file that are listed for each kind of skipped element."""


@dataclass(slots=True)
class SdfLink:
    """A link, and the file that it is in."""

    name: str
    element: Element
    pose: Transform
    """Pose in the frame of the outermost model."""
    near: Path


class Names:
    """Makes names of bodies, joints and lights unique."""

    def __init__(self) -> None:
        self._given: dict[str, int] = {}

    def unique(self, name: str) -> str:
        """The name, with a number if it is in use already."""
        count = self._given[name] = self._given.get(name, 0) + 1
        return name if count == 1 else self.unique(f"{name}_{count}")


class SkippedElements:
    """The elements of a world that are not understood."""

    def __init__(self, path: Path) -> None:
        self._path = path
        self._found: dict[str, list[str]] = {}

    def add(self, element: Element, near: Path, what: str = "") -> None:
        """Note an element of the file `near`."""
        if element.tag in QUIET and not what:
            return
        line = f"line {line_of(element)}" if near == self._path else f"{near.name}:{line_of(element)}"
        self._found.setdefault(what or f"<{element.tag}>", []).append(line)

    def tell(self) -> None:
        """Log what was skipped, in one line."""
        parts = []
        for what, lines in self._found.items():
            more = f" and {len(lines) - MAX_PLACES} more" if len(lines) > MAX_PLACES else ""
            parts.append(f"{what} ({', '.join(lines[:MAX_PLACES])}{more})")
        if parts:
            _LOG.warning("%s: not understood and skipped: %s", self._path, "; ".join(parts))


class LinkBuilder:
    """Adds what links have to the bodies of a model."""

    def __init__(self, shapes: ShapeBuilder, paths: ModelPaths, skipped: SkippedElements, names: Names) -> None:
        self._shapes, self._paths, self._skipped, self._names = shapes, paths, skipped, names
        self.lights = 0

    def add(self, link: SdfLink, body: mujoco.MjsBody, frame: Transform, *, moves: bool) -> None:
        """Add the shapes and the inertia of a link, whose pose in the body is `frame`."""
        solids: list[mujoco.MjsGeom] = []
        for element in link.element.iterchildren("*"):
            match element.tag:
                case "visual":
                    pose = frame @ raw_pose(element)[0]
                    located(link.near, partial(self._draw, element, body, pose, link.near))
                case "collision":
                    pose = frame @ raw_pose(element)[0]
                    solids += located(link.near, partial(self._collide, element, body, pose, link.near, moves=moves))
                case "light":
                    self.add_light(element, body, frame @ raw_pose(element)[0])
                case "inertial":
                    pass
                case _:
                    self._skipped.add(element, link.near)
        if moves:
            located(link.near, lambda: self._weigh(link, body, solids))

    def _weigh(self, link: SdfLink, body: mujoco.MjsBody, solids: Sequence[mujoco.MjsGeom]) -> None:
        inertial = link.element.find("inertial")
        mass = DEFAULT_MASS
        if inertial is not None and inertial.get("auto") in ("1", "true") and solids:
            density = inertial.find("density")
            for geom in solids:
                geom.mass, geom.density = math.nan, 1000.0 if density is None else floats(density, 1)[0]
            return
        if inertial is not None and (given := inertial.find("mass")) is not None:
            mass = floats(given, 1)[0]
            if mass <= 0.0:
                raise ConfigError(f"line {line_of(given)}: link {link.name!r}: a mass of {mass:g} kg is not above zero")
        tensor = None if inertial is None else inertial.find("inertia")
        if tensor is None and solids:
            for geom in solids:
                geom.mass = mass / len(solids)
            return
        moments = []
        for key in KEYS:
            element = None if tensor is None else tensor.find(key)
            moments.append(0.0 if element is None else floats(element, 1)[0])
        line = line_of(link.element) if tensor is None else line_of(tensor)
        checked = checked_inertia(tuple(moments), mass, f"{link.near}:{line}: link {link.name!r}")
        set_inertia(body, mass, Transform() if inertial is None else raw_pose(inertial)[0], checked)

    def _draw(self, visual: Element, body: mujoco.MjsBody, pose: Transform, near: Path) -> None:
        shape = _shape_of(visual)
        if shape is None:
            return
        look = look_of(visual, self._paths, near)
        if shape.tag == "mesh":
            self._shapes.draw_mesh(body, self._mesh(shape, near), pose, look)
        elif shape.tag == "heightmap":
            pass  # drawn by the collision
        elif shape.tag == "cone":
            self._shapes.draw_cone(body, *_cone(shape), pose, look)
        elif (primitive := _primitive(shape)) is not None:
            kind, size, turn = primitive
            if kind == mujoco.mjtGeom.mjGEOM_PLANE:
                size = [*size[:2], 0.1]
            self._shapes.draw(body, kind, size, pose @ turn, look)
        else:
            self._skipped.add(shape, near, f"<geometry> of {shape.tag}")

    def _collide(
        self, collision: Element, body: mujoco.MjsBody, pose: Transform, near: Path, *, moves: bool
    ) -> list[mujoco.MjsGeom]:
        shape = _shape_of(collision)
        if shape is None or is_true(collision.find("surface/contact/collide_without_contact")):
            return []
        solid = Solid(_friction(collision), mass=0.0)
        if shape.tag == "mesh":
            source = self._mesh(shape, near)
            if moves:
                return [self._shapes.collide_mesh(body, source, pose, solid)]
            self._shapes.collide_surface(body, source, pose, solid)
            return []
        if shape.tag == "heightmap" and not moves:
            self._add_heights(shape, body, pose, near)
            return []
        if shape.tag == "cone":
            return [self._shapes.collide_cone(body, *_cone(shape), pose, solid)]
        primitive = _primitive(shape)
        if primitive is None or (primitive[0] == mujoco.mjtGeom.mjGEOM_PLANE and moves):
            self._skipped.add(shape, near, f"<geometry> of {shape.tag}")
            return []
        kind, size, turn = primitive
        if kind == mujoco.mjtGeom.mjGEOM_PLANE:
            size = [0.0, 0.0, 0.1]
        return [self._shapes.collide(body, kind, size, pose @ turn, solid)]

    def _add_heights(self, heightmap: Element, body: mujoco.MjsBody, pose: Transform, near: Path) -> None:
        path = self._paths.file(" ".join(words(heightmap.find("uri"))), near)
        size_element, pos = heightmap.find("size"), heightmap.find("pos")
        size = (1.0, 1.0, 1.0) if size_element is None else floats(size_element, 3)
        offset = (0.0, 0.0, 0.0) if pos is None else floats(pos, 3)
        texture = words(heightmap.find("texture/diffuse"))
        repeat = words(heightmap.find("texture/size"))
        look = Look(
            None if texture else (0.45, 0.42, 0.36, 1.0),
            self._paths.file(" ".join(texture), near) if texture else None,
            (1.0 / float(repeat[0]),) * 2 if repeat else None,
        )
        frame = pose @ Transform(position=(offset[0], offset[1], offset[2]))
        geom = self._shapes.height_field(body, read_heights(path, MAX_HEIGHTS), size, frame, look)
        geom.group = 0

    def _mesh(self, mesh: Element, near: Path) -> MeshSource:
        scale = mesh.find("scale")
        try:
            path = self._paths.file(" ".join(words(mesh.find("uri"))), near)
        except ConfigError as error:
            raise ConfigError(f"line {line_of(mesh)}: <mesh>: {error}") from error
        submesh = " ".join(words(mesh.find("submesh/name"))) or None
        factors = (1.0, 1.0, 1.0) if scale is None else floats(scale, 3)
        if not all(factors):
            raise ConfigError(f"line {line_of(mesh)}: <scale>: must not be zero")
        return MeshSource(path, factors, submesh, is_true(mesh.find("submesh/center")) is True)

    def add_light(self, light: Element, body: mujoco.MjsBody, frame: Transform) -> None:
        """Add a lamp or the sun to a body."""
        self.lights += 1
        kind = light.get("type", "point")
        direction = light.find("direction")
        towards = (0.0, 0.0, -1.0) if direction is None else floats(direction, 3)
        added = body.add_light(name=self._names.unique(f"light/{light.get('name')}"), pos=frame.position)
        added.dir = frame.rotate((towards[0], towards[1], towards[2]))
        types = mujoco.mjtLightType
        added.type = {"directional": types.mjLIGHT_DIRECTIONAL, "spot": types.mjLIGHT_SPOT}.get(
            kind, types.mjLIGHT_POINT
        )
        added.castshadow = is_true(light.find("cast_shadows")) is True
        diffuse = [float(word) for word in words(light.find("diffuse"))[:3]] or [1.0, 1.0, 1.0]
        added.diffuse = [min(1.0, 0.7 * channel) for channel in diffuse]
        added.ambient, added.specular = (0.0,) * 3, (0.2,) * 3
        if kind != "directional":
            terms = [words(light.find(f"attenuation/{term}")) for term in ("constant", "linear", "quadratic")]
            given = [float(term[0]) if term else default for term, default in zip(terms, (1.0, 0.0, 0.0), strict=True)]
            added.attenuation = given if any(given) else (1.0, 0.0, 0.0)
        if kind == "spot" and (angle := words(light.find("spot/outer_angle"))):
            added.cutoff = min(90.0, math.degrees(float(angle[0])))


def _shape_of(owner: Element) -> Element | None:
    geometry = owner.find("geometry")
    return (
        None
        if geometry is None
        else next((child for child in geometry.iterchildren("*") if child.tag != "empty"), None)
    )


def _primitive(shape: Element) -> tuple[mujoco.mjtGeom, list[float], Transform] | None:
    """MuJoCo's kind and size of a shape, and how it is turned."""

    def lengths(tag: str, count: int, default: tuple[float, ...]) -> tuple[float, ...]:
        element = shape.find(tag)
        found = default if element is None else floats(element, count)
        if min(found) <= 0.0:
            raise ConfigError(f"line {line_of(shape)}: <{tag}>: a size must be above zero")
        return found

    kinds = mujoco.mjtGeom
    match shape.tag:
        case "box":
            return kinds.mjGEOM_BOX, [length / 2.0 for length in lengths("size", 3, (1.0, 1.0, 1.0))], Transform()
        case "sphere":
            return kinds.mjGEOM_SPHERE, [*lengths("radius", 1, (1.0,))], Transform()
        case "cylinder" | "capsule":
            (radius,), (length,) = lengths("radius", 1, (0.5,)), lengths("length", 1, (1.0,))
            kind = kinds.mjGEOM_CYLINDER if shape.tag == "cylinder" else kinds.mjGEOM_CAPSULE
            return kind, [radius, length / 2.0], Transform()
        case "ellipsoid":
            return kinds.mjGEOM_ELLIPSOID, [*lengths("radii", 3, (1.0, 1.0, 1.0))], Transform()
        case "plane":
            width, depth = lengths("size", 2, (1.0, 1.0))
            normal = shape.find("normal")
            x, y, z = (0.0, 0.0, 1.0) if normal is None else floats(normal, 3)
            return kinds.mjGEOM_PLANE, [width / 2.0, depth / 2.0], _turn_to((x, y, z))
    return None


def _cone(shape: Element) -> tuple[float, float]:
    """Radius and length of a cone."""
    radius, length = shape.find("radius"), shape.find("length")
    return 0.5 if radius is None else floats(radius, 1)[0], 1.0 if length is None else floats(length, 1)[0]


def _turn_to(normal: Vector) -> Transform:
    """The frame whose z axis is along a normal."""
    length = math.hypot(*normal)
    if not length:
        return Transform()
    x, y, z = (coordinate / length for coordinate in normal)
    pitch, yaw = math.acos(max(-1.0, min(1.0, z))), math.atan2(y, x)
    return Transform.from_pose(Pose(pitch=pitch)) if not yaw else Transform.from_pose(Pose(pitch=pitch, yaw=yaw))


def _friction(collision: Element) -> float | None:
    for path in ("surface/friction/ode/mu", "surface/friction/bullet/friction"):
        element = collision.find(path)
        if element is not None:
            return min(MAX_FRICTION, max(0.0, floats(element, 1)[0]))
    return None
