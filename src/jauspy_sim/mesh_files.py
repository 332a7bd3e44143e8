"""Reads the files of meshes that robots and worlds name: STL, OBJ, DAE (COLLADA), PLY, glTF."""

from __future__ import annotations

import logging
import warnings
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from jauspy.errors import ConfigError
from jauspy.user_files import read_file

logger = logging.getLogger("jauspy_sim.meshes")

KINDS: Final = ("stl", "obj", "dae", "ply", "glb", "gltf")
"""Ends of the names of the files that are read."""

MAX_BYTES: Final = 256 << 20

MAX_FACES: Final = 200_000
"""Of one mesh; MuJoCo takes no larger STL files, and pictures would take long. Meshes with more are simplified."""

MAX_TEXTURE: Final = 1024
"""Pixels of a side; larger ones are made smaller: MuJoCo holds them uncompressed, in each camera's process."""

MAX_PIXELS: Final = 1 << 26
"""Of an image file, before it is read."""

THICKNESS: Final = 0.001
"""Metres that a flat mesh gets as a collision shape."""


@dataclass(frozen=True, slots=True, eq=False)
class Image:
    """A picture: shape (rows, columns, 3), red, green, blue; the first row is the uppermost."""

    pixels: NDArray[np.uint8]


@dataclass(frozen=True, slots=True, eq=False)
class MeshPart:
    """A mesh of one colour or texture."""

    name: str
    """Of the node in the file, which SDF calls a submesh."""
    vertices: NDArray[np.float64]
    """Shape (n, 3): metres."""
    faces: NDArray[np.int32]
    """Shape (m, 3)."""
    colour: tuple[float, float, float, float] | None = None
    """Red, green, blue, alpha, 0..1; None if the file has none."""
    texcoords: NDArray[np.float64] | None = None
    """Shape (n, 2)."""
    texture: Image | None = None


@lru_cache(maxsize=64)
def read_mesh(path: Path) -> tuple[MeshPart, ...]:
    """The parts of a mesh, of which none is empty. Raises `ConfigError`, which names the file."""
    kind = path.suffix.lower().removeprefix(".")
    if kind not in KINDS:
        raise ConfigError(f"{path}: is not a mesh that can be read; known are: {', '.join(KINDS)}")
    data = read_file(path, MAX_BYTES)
    if not data:
        raise ConfigError(f"{path}: is empty")
    if kind == "dae" and b"<!ENTITY" in data:
        raise ConfigError(f"{path}: has <!ENTITY ...>, which is not read")
    scene = _scene(path, kind)
    parts = []
    for node in scene.graph.nodes_geometry:
        frame, name = scene.graph[node]
        if hasattr(mesh := scene.geometry[name], "faces"):  # others are lines and points
            parts += [part] if (part := _part(path, str(node), mesh, _metres(scene, frame, kind))) else []
    if not parts:
        raise ConfigError(f"{path}: has no triangles")
    return tuple(parts)


def joined(parts: tuple[MeshPart, ...]) -> MeshPart:
    """One part with the triangles of all."""
    offsets = np.cumsum([0, *(len(part.vertices) for part in parts)])
    faces = np.concatenate([part.faces + offset for part, offset in zip(parts, offsets, strict=False)])
    return MeshPart(parts[0].name, np.concatenate([part.vertices for part in parts]), faces.astype(np.int32))


def with_volume(vertices: NDArray[np.float64]) -> NDArray[np.float64]:
    """The vertices; for a flat mesh, two layers of them, so that their convex hull has a volume."""
    centred = vertices - vertices.mean(axis=0)
    _, extents, axes = np.linalg.svd(centred, full_matrices=False)
    found = vertices
    for extent, axis in zip(extents, axes, strict=True):
        if extent < THICKNESS * 0.01 * max(1.0, float(extents[0])) or extent < 1e-5:
            found = np.concatenate([found - axis * THICKNESS / 2.0, found + axis * THICKNESS / 2.0])
    return found


def _scene(path: Path, kind: str) -> Any:
    try:
        import trimesh  # noqa: PLC0415 - it takes 0.3 s, and most robots need none
    except ImportError:
        raise ConfigError(f"{path}: reading meshes needs trimesh: pip install 'jauspy[sim]'") from None
    logging.getLogger("trimesh").setLevel(logging.CRITICAL)
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            return trimesh.load_scene(path, file_type=kind, process=False)
    except Exception as error:  # the readers of these formats raise whatever they meet
        reason = " ".join(str(error).split())[:200] or type(error).__name__
        raise ConfigError(f"{path}: is not read as a mesh: {reason}") from error


def _metres(scene: Any, frame: NDArray[np.float64], kind: str) -> NDArray[np.float64]:
    """The transform of a node; the unit of COLLADA counts, the axis that it calls up does not, as in ROS and Gazebo."""
    if kind == "dae":
        number, _, unit = str(scene.units).partition(" * ")
        return np.diag([*[float(number) if unit else 1.0] * 3, 1.0]) @ frame
    if kind in ("glb", "gltf"):  # y is up
        return np.array([[1.0, 0, 0, 0], [0, 0, -1, 0], [0, 1, 0, 0], [0, 0, 0, 1]]) @ frame
    return frame


def _part(path: Path, name: str, mesh: Any, frame: NDArray[np.float64]) -> MeshPart | None:
    texcoords, texture = _texture(mesh)
    if texture is None:
        mesh = mesh.copy()
        mesh.merge_vertices(merge_tex=True, merge_norm=True)
    if len(mesh.faces) > MAX_FACES:
        logger.warning("%s: has %d faces; simplified to %d", path, len(mesh.faces), MAX_FACES)
        mesh, texcoords, texture = _simplified(path, mesh), None, None
    vertices = np.asarray(mesh.vertices, np.float64) @ frame[:3, :3].T + frame[:3, 3]
    faces = np.asarray(mesh.faces, np.int64)
    if not np.isfinite(vertices).all():
        raise ConfigError(f"{path}: has vertices that are not finite numbers")
    if np.linalg.det(frame[:3, :3]) < 0.0:
        faces = faces[:, ::-1]
    a, b, c = (vertices[faces[:, corner]] for corner in range(3))
    areas = np.linalg.norm(np.cross(b - a, c - a), axis=1)
    faces = faces[areas > 1e-14]
    if not len(faces):
        return None
    used, inverse = np.unique(faces, return_inverse=True)
    return MeshPart(
        name,
        np.ascontiguousarray(vertices[used]),
        inverse.reshape(-1, 3).astype(np.int32),
        _colour(mesh),
        None if texcoords is None else np.ascontiguousarray(texcoords[used]),
        texture,
    )


def _simplified(path: Path, mesh: Any) -> Any:
    try:
        return mesh.simplify_quadric_decimation(face_count=MAX_FACES)
    except ImportError:
        raise ConfigError(
            f"{path}: has {len(mesh.faces)} faces, and at most {MAX_FACES} are drawn: install fast-simplification, "
            "or simplify the file"
        ) from None


def _colour(mesh: Any) -> tuple[float, float, float, float] | None:
    visual = mesh.visual
    if visual.kind == "texture":
        material = visual.material
        found = getattr(material, "main_color", None)
        if found is None or not getattr(material, "name", "x"):
            return None
    elif visual.kind in ("face", "vertex"):
        found = visual.main_color
    else:
        return None
    red, green, blue, alpha = (float(each) / 255.0 for each in np.asarray(found)[:4])
    return red, green, blue, alpha if alpha > 0.0 else 1.0


def _texture(mesh: Any) -> tuple[NDArray[np.float64] | None, Image | None]:
    visual = mesh.visual
    if visual.kind != "texture" or visual.uv is None or len(visual.uv) != len(mesh.vertices):
        return None, None
    material = visual.material
    image = getattr(material, "baseColorTexture", None) or getattr(material, "image", None)
    if image is None:
        return None, None
    try:
        return np.asarray(visual.uv, np.float64), _shrunk(image)
    except (OSError, ValueError):
        return None, None


def read_image(path: Path) -> Image:
    """A texture. Raises `ConfigError`, which names the file."""
    from PIL import Image as Pillow, UnidentifiedImageError  # noqa: PLC0415 - only where there are textures

    _check_regular(path)
    try:
        with Pillow.open(path) as image:
            if image.width * image.height > MAX_PIXELS:
                raise ConfigError(f"{path}: has more than {MAX_PIXELS >> 20} million pixels")
            return _shrunk(image)
    except (OSError, ValueError, SyntaxError, UnidentifiedImageError, Pillow.DecompressionBombError) as error:
        raise ConfigError(f"{path}: is not an image that can be read: {error}") from error


def read_heights(path: Path, most: int) -> NDArray[np.float64]:
    """The grey values of an image, 0..1, with at most so many rows and columns; the first row is the uppermost."""
    from PIL import Image as Pillow, UnidentifiedImageError  # noqa: PLC0415 - only where there are height maps

    _check_regular(path)
    try:
        with Pillow.open(path) as image:
            if image.width * image.height > MAX_PIXELS:
                raise ConfigError(f"{path}: has more than {MAX_PIXELS >> 20} million pixels")
            deep = image.mode in ("I", "I;16", "I;16B", "F")
            grey = image.convert("F") if deep else image.convert("L").convert("F")
            shape = min(grey.width, most), min(grey.height, most)
            values = np.asarray(grey.resize(shape, Pillow.Resampling.BILINEAR), np.float64)
    except (OSError, ValueError, SyntaxError, UnidentifiedImageError, Pillow.DecompressionBombError) as error:
        raise ConfigError(f"{path}: is not an image that can be read: {error}") from error
    if min(values.shape) < 2 or not np.isfinite(values).all():
        raise ConfigError(f"{path}: a height map needs two rows and columns or more")
    full = max(65535.0 if deep else 255.0, float(values.max()))
    heights: NDArray[np.float64] = values / full
    return heights


def _check_regular(path: Path) -> None:
    if not path.is_file():
        raise ConfigError(f"{path}: " + ("is not a regular file" if path.exists() else "there is no such file"))


def _shrunk(image: Any) -> Image:
    small = image.convert("RGB")
    small.thumbnail((MAX_TEXTURE, MAX_TEXTURE))
    return Image(np.asarray(small, np.uint8))
