"""Adds geometries to the bodies of a model: primitives, meshes, colours, textures."""

from __future__ import annotations

import logging
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Final

import mujoco
import numpy as np
from numpy.typing import NDArray

from jauspy.geometry.poses import Transform
from jauspy.geometry.vectors import quaternion
from jauspy_sim.models.mesh_files import Image, MeshPart, by_look, joined, read_image, read_mesh, with_volume
from jauspy_sim.models.slabs import convex_pieces

_LOG = logging.getLogger("jauspy_sim.meshes")

RGBA = tuple[float, float, float, float]

GREY: Final[RGBA] = (0.6, 0.6, 0.6, 1.0)
"""Colour of shapes and meshes without one."""

CONE_SIDES: Final = 24
"""Edges of the base of a cone, which is drawn and collides as a mesh."""

MAX_PIECES: Final = 4000
"""Convex pieces of one mesh that does not move."""

DENSITY: Final = 1000.0
"""kg/m^3, as MuJoCo's."""


@dataclass(frozen=True, slots=True)
class Look:
    """Colour and texture of a geometry. A colour of None leaves those that a mesh's file has."""

    colour: RGBA | None = None
    texture: Path | None = None
    repeat: tuple[float, float] | None = None
    """Repetitions of a texture in each metre; None stretches one over the whole surface."""
    shininess: float = 0.3
    specular: float = 0.2
    emission: float = 0.0
    yields: bool = False
    """True if colours and textures of a mesh's file take precedence, as in ROS."""


PLAIN: Final = Look()

Primitive = mujoco.mjtGeom
_FLAT: Final = (mujoco.mjtGeom.mjGEOM_PLANE, mujoco.mjtGeom.mjGEOM_HFIELD)


@dataclass(frozen=True, slots=True)
class Solid:
    """How a geometry collides, and what it weighs."""

    friction: float | None = None
    mass: float | None = None
    """Kilograms; None computes it from the density."""
    density: float = DENSITY


@dataclass(frozen=True, slots=True)
class MeshSource:
    """The mesh of a file."""

    path: Path
    scale: tuple[float, ...] = (1.0, 1.0, 1.0)
    submesh: str | None = None
    """The name of the parts that are taken; all if none has it, or without a name."""
    centred: bool = False
    """True to make the middle of these parts the origin."""

    def parts(self) -> tuple[MeshPart, ...]:
        """The parts, not scaled."""
        every, name = read_mesh(self.path), self.submesh
        return tuple(part for part in every if name in (part.name, part.name.removesuffix("-mesh"))) or every

    def centre(self, parts: Sequence[MeshPart]) -> NDArray[np.float64]:
        """The point of the parts that becomes the origin; not scaled."""
        if not self.centred:
            return np.zeros(3)
        vertices = np.concatenate([part.vertices for part in parts])
        middle: NDArray[np.float64] = (vertices.min(axis=0) + vertices.max(axis=0)) / 2.0
        return middle


class ShapeBuilder:
    """Adds geometries to the bodies of one model. Names of assets begin with `prefix`.

    Visual geometries are in group `visual` and collide with nothing; those that collide are in group `collision`.
    """

    def __init__(self, spec: mujoco.MjSpec, *, visual: int, collision: int, prefix: str = "") -> None:
        self._spec = spec
        self._visual, self._collision = visual, collision
        self._prefix = prefix
        self._materials: dict[tuple[object, ...], str] = {}
        self._textures: dict[tuple[object, ...], str] = {}
        self._meshes: dict[tuple[MeshSource, bool], list[tuple[str, MeshPart]]] = {}
        self._fields = self._count = 0

    def draw(
        self, body: mujoco.MjsBody, kind: mujoco.mjtGeom, size: Sequence[float], pose: Transform, look: Look
    ) -> mujoco.MjsGeom:
        """Add a visual primitive, which does not collide."""
        geom = self._primitive(body, kind, size, pose)
        self.paint(geom, look)
        self._only_seen(geom)
        return geom

    def collide(
        self, body: mujoco.MjsBody, kind: mujoco.mjtGeom, size: Sequence[float], pose: Transform, solid: Solid
    ) -> mujoco.MjsGeom:
        """Add a primitive that collides."""
        geom = self._primitive(body, kind, size, pose)
        self._make_solid(geom, solid)
        return geom

    def draw_cone(self, body: mujoco.MjsBody, radius: float, length: float, pose: Transform, look: Look) -> None:
        """Add a visual cone along z; its middle is at the pose."""
        geom = self._cone(body, radius, length, pose)
        self.paint(geom, look)
        self._only_seen(geom)

    def collide_cone(
        self, body: mujoco.MjsBody, radius: float, length: float, pose: Transform, solid: Solid
    ) -> mujoco.MjsGeom:
        """Add a cone along z that collides; its middle is at the pose."""
        geom = self._cone(body, radius, length, pose)
        self._make_solid(geom, solid)
        return geom

    def _cone(self, body: mujoco.MjsBody, radius: float, length: float, pose: Transform) -> mujoco.MjsGeom:
        angles = np.arange(CONE_SIDES) * 2.0 * np.pi / CONE_SIDES
        rim = np.column_stack([radius * np.cos(angles), radius * np.sin(angles), np.full(CONE_SIDES, -length / 2.0)])
        name = self._add_hull(Path("cone"), np.concatenate([rim, [[0.0, 0.0, length / 2.0]]]))
        return _add_mesh_geom(body, name, pose)

    def _add_hull(self, path: Path, corners: NDArray[np.float64]) -> str:
        """Add a mesh that is the convex hull of these corners, shape (n, 3), in metres; returns its name."""
        name = self._mesh_name(path)
        mesh = self._spec.add_mesh(name=name, inertia=mujoco.mjtMeshInertia.mjMESH_INERTIA_CONVEX)
        mesh.uservert = corners.ravel()
        return name

    def draw_mesh(self, body: mujoco.MjsBody, source: MeshSource, pose: Transform, look: Look) -> None:
        """Add a visual mesh: a geometry for each of its colours."""
        for name, part in self._mesh(source, hull=False):
            geom = _add_mesh_geom(body, name, pose)
            self._paint_part(geom, look, part)
            self._only_seen(geom)

    def collide_mesh(self, body: mujoco.MjsBody, source: MeshSource, pose: Transform, solid: Solid) -> mujoco.MjsGeom:
        """Add the convex hull of a mesh, which collides."""
        ((name, _),) = self._mesh(source, hull=True)
        geom = _add_mesh_geom(body, name, pose)
        self._make_solid(geom, solid)
        return geom

    def collide_surface(self, body: mujoco.MjsBody, source: MeshSource, pose: Transform, solid: Solid) -> None:
        """Add convex pieces with the surface of a mesh, which collide; the body must not move.

        A mesh of too many pieces collides as its convex hull, and this is logged.
        """
        parts = source.parts()
        whole = joined(parts)
        vertices = (whole.vertices - source.centre(parts)) * np.asarray(source.scale, np.float64)
        pieces = convex_pieces(vertices, whole.faces, MAX_PIECES)
        if pieces is None:
            faces = len(whole.faces)
            _LOG.warning("%s: has %d faces and is not convex; it collides as its convex hull", source.path, faces)
            self.collide_mesh(body, source, pose, solid)
            return
        for corners in pieces:
            name = self._add_hull(source.path, with_volume(corners))
            geom = _add_mesh_geom(body, name, pose)
            self._make_solid(geom, solid)

    def height_field(
        self, body: mujoco.MjsBody, heights: NDArray[np.float64], size: Sequence[float], pose: Transform, look: Look
    ) -> mujoco.MjsGeom:
        """Add a height field: `heights` 0..1, the first row at the largest y; `size` in metres along x, y, z."""
        self._fields += 1
        name = f"{self._prefix}height_map_{self._fields}"
        rows, columns = heights.shape
        x, y, z = size
        base = max(0.1, 0.05 * z)
        low, high = float(heights.min()), float(heights.max())
        spread = high - low
        flat = (heights[::-1] - low) / spread if spread else np.zeros_like(heights)
        self._spec.add_hfield(
            name=name,
            nrow=rows,
            ncol=columns,
            size=(x / 2.0, y / 2.0, max(1e-6, z * spread), base),
            userdata=flat.ravel().tolist(),
        )
        geom = body.add_geom(type=mujoco.mjtGeom.mjGEOM_HFIELD, hfieldname=name)
        _place(geom, pose @ Transform(position=(0.0, 0.0, z * low)))
        self.paint(geom, look)
        return geom

    def material(self, look: Look, image: Image | None = None, *, cube: bool = False) -> str:
        """The name of a material with this look."""
        key = (look, None if image is None else id(image), cube)
        if key in self._materials:
            return self._materials[key]
        name = self._materials[key] = f"{self._prefix}material_{len(self._materials)}"
        material = self._spec.add_material(
            name=name,
            rgba=look.colour or (1.0, 1.0, 1.0, 1.0),
            shininess=look.shininess,
            specular=look.specular,
            emission=look.emission,
        )
        if image is None and look.texture is not None:
            image = read_image(look.texture)
        if image is not None:
            textures = list(material.textures)
            textures[int(mujoco.mjtTextureRole.mjTEXROLE_RGB)] = self._texture(image, look, cube=cube)
            material.textures = textures
            if look.repeat is not None and not cube:
                material.texuniform, material.texrepeat = True, look.repeat
        return name

    def _texture(self, image: Image, look: Look, *, cube: bool) -> str:
        key = (look.texture or id(image), cube)
        if key in self._textures:
            return self._textures[key]
        name = self._textures[key] = f"{self._prefix}texture_{len(self._textures)}"
        pixels = _square(image.pixels) if cube else image.pixels
        kind = mujoco.mjtTexture.mjTEXTURE_CUBE if cube else mujoco.mjtTexture.mjTEXTURE_2D
        if cube:
            pixels = np.concatenate([pixels] * 6)
        texture = self._spec.add_texture(
            name=name, type=kind, nchannel=3, width=pixels.shape[1], height=pixels.shape[0]
        )
        texture.data = np.ascontiguousarray(pixels).tobytes()
        return name

    def _primitive(
        self, body: mujoco.MjsBody, kind: mujoco.mjtGeom, size: Sequence[float], pose: Transform
    ) -> mujoco.MjsGeom:
        geom = body.add_geom(type=kind, size=[*size, 0.0, 0.0, 0.0][:3])
        _place(geom, pose)
        return geom

    def _only_seen(self, geom: mujoco.MjsGeom) -> None:
        geom.contype = geom.conaffinity = 0
        geom.group = self._visual
        geom.mass = 0.0

    def _make_solid(self, geom: mujoco.MjsGeom, solid: Solid) -> None:
        geom.group = self._collision
        geom.density = solid.density
        if solid.mass is not None:
            geom.mass = solid.mass
        if solid.friction is not None:
            geom.friction = (solid.friction, *geom.friction[1:])

    def paint(self, geom: mujoco.MjsGeom, look: Look) -> None:
        """Give a primitive or a height field its colour or texture."""
        cube = geom.type not in _FLAT
        if look.texture is None and look.emission == 0.0:
            geom.rgba = look.colour or GREY
        else:
            geom.material = self.material(look, cube=cube)

    def _paint_part(self, geom: mujoco.MjsGeom, look: Look, part: MeshPart) -> None:
        has_own_look = part.texture is not None or part.colour is not None
        if look.yields and has_own_look:
            look = PLAIN
        if look.texture is not None and part.texcoords is not None:
            geom.material = self.material(look)
        elif look.colour is None and part.texture is not None:
            geom.material = self.material(PLAIN, part.texture)
        elif look.emission:
            geom.material = self.material(look)
        else:
            geom.rgba = look.colour or part.colour or GREY

    def _mesh(self, source: MeshSource, *, hull: bool) -> list[tuple[str, MeshPart]]:
        """Names of the meshes of a file; of its convex hull, one."""
        key = (source, hull)
        if key not in self._meshes:
            parts = source.parts()
            centre = source.centre(parts)
            parts = (joined(parts),) if hull else by_look(parts)
            self._meshes[key] = [(self._add_mesh(source, part, centre, hull=hull), part) for part in parts]
        return self._meshes[key]

    def _mesh_name(self, path: Path) -> str:
        self._count += 1
        return f"{self._prefix}{path.stem}_{self._count}"

    def _add_mesh(self, source: MeshSource, part: MeshPart, centre: NDArray[np.float64], *, hull: bool) -> str:
        name = self._mesh_name(source.path)
        factors = np.asarray(source.scale, np.float64)
        vertices = (part.vertices - centre) * factors
        faces = part.faces[:, ::-1] if np.prod(factors) < 0.0 else part.faces
        mesh = self._spec.add_mesh(name=name)
        mesh.inertia = (
            mujoco.mjtMeshInertia.mjMESH_INERTIA_CONVEX if hull else mujoco.mjtMeshInertia.mjMESH_INERTIA_SHELL
        )
        if hull:
            solid = with_volume(vertices)
            mesh.uservert = solid.ravel()
            if len(solid) == len(vertices):
                mesh.userface = faces.ravel()
            return name
        if len(vertices) < 4:  # which is the least that MuJoCo takes
            vertices = np.concatenate([vertices, vertices[:1]])
        mesh.uservert, mesh.userface = vertices.ravel(), faces.ravel()
        if part.normals is not None and len(vertices) == len(part.vertices):
            normals = part.normals / factors
            mesh.usernormal = (normals / np.linalg.norm(normals, axis=1, keepdims=True)).ravel()
            mesh.userfacenormal = faces.ravel()
        if part.texcoords is not None and len(vertices) == len(part.vertices):
            mesh.usertexcoord = np.column_stack([part.texcoords[:, 0], 1.0 - part.texcoords[:, 1]]).ravel()
            mesh.userfacetexcoord = faces.ravel()
        return name


def _square(pixels: NDArray[np.uint8]) -> NDArray[np.uint8]:
    """The picture with as many rows as columns, by repeating pixels."""
    side = max(pixels.shape[:2])
    rows, columns = (np.arange(side) * count // side for count in pixels.shape[:2])
    squared: NDArray[np.uint8] = pixels[rows][:, columns]
    return squared


def _add_mesh_geom(body: mujoco.MjsBody, name: str, pose: Transform) -> mujoco.MjsGeom:
    geom = body.add_geom(type=mujoco.mjtGeom.mjGEOM_MESH, meshname=name)
    _place(geom, pose)
    return geom


def _place(geom: mujoco.MjsGeom, pose: Transform) -> None:
    geom.pos, geom.quat = pose.position, quaternion(pose.rotation)


def same_shape(present: float | Sequence[float], value: float) -> float | tuple[float, ...]:
    """A damping or stiffness in the form of the MuJoCo version: 4 has a polynomial, 3 a number."""
    terms = np.size(present)
    return (value, *[0.0] * (terms - 1)) if terms > 1 else value
