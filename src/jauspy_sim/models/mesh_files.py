"""Reads the files of meshes that robots and worlds name: STL, OBJ, DAE (COLLADA), PLY, glTF."""

from __future__ import annotations

import logging
import warnings
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import lru_cache
from itertools import pairwise
from pathlib import Path
from typing import Any, Final
from urllib.parse import unquote

import numpy as np
from numpy.typing import NDArray

from jauspy.errors import ConfigError
from jauspy.user_files import confined, own_folder, read_file
from jauspy_sim.models.mesh_checks import check_mesh

_LOG = logging.getLogger("jauspy_sim.meshes")

KINDS: Final = ("stl", "obj", "dae", "ply", "glb", "gltf")
"""Suffixes of the mesh files that can be read."""

MAX_BYTES: Final = 256 << 20

MAX_FACES: Final = 200_000
"""Faces of one mesh, the limit of MuJoCo for STL files. Larger meshes are simplified."""

MAX_TEXTURE: Final = 1024
"""Pixels of a side; larger ones are made smaller: MuJoCo holds them uncompressed, in each camera's process."""

MAX_PIXELS: Final = 1 << 26
"""Most pixels of an image file, before it is read."""

BESIDE: Final = (".png", ".jpg", ".jpeg", ".bmp", ".tga", ".tif", ".tiff", ".gif", ".webp", ".mtl", ".bin")
"""Suffixes of files that meshes refer to and that are read."""

TEXTURE_FOLDERS: Final = (".", "../materials/textures", "../textures", "textures")
"""Folders beside a mesh that may contain its textures."""

THICKNESS: Final = 0.001
"""Metres that a flat mesh gets as a collision shape."""


@dataclass(frozen=True, slots=True, eq=False)
class Image:
    """A picture: uint8, shape (rows, columns, 3), RGB; the first row is the top."""

    pixels: NDArray[np.uint8]


@dataclass(frozen=True, slots=True, eq=False)
class MeshPart:
    """A mesh of one colour or texture."""

    name: str
    """Name of the node in the file, which SDF calls a submesh."""
    vertices: NDArray[np.float64]
    """Shape (n, 3): metres."""
    faces: NDArray[np.int32]
    """Shape (m, 3)."""
    colour: tuple[float, float, float, float] | None = None
    """Red, green, blue, alpha, 0..1; None if the file has none."""
    texcoords: NDArray[np.float64] | None = None
    """Shape (n, 2)."""
    normals: NDArray[np.float64] | None = None
    """Shape (n, 3), of unit length; None leaves them to MuJoCo."""
    texture: Image | None = None


@lru_cache(maxsize=256)
def read_mesh(path: Path) -> tuple[MeshPart, ...]:
    """The parts of a mesh, of which none is empty. Raises `ConfigError`, which names the file."""
    kind = path.suffix.lower().removeprefix(".")
    if kind not in KINDS:
        raise ConfigError(f"{path}: is not a mesh that can be read; known are: {', '.join(KINDS)}")
    data = read_file(path, MAX_BYTES)
    if not data:
        raise ConfigError(f"{path}: is empty")
    if kind == "dae" and any("<!ENTITY".encode(code) in data for code in ("utf-8", "utf-16-le", "utf-16-be")):
        raise ConfigError(f"{path}: has <!ENTITY ...>, which is not read")
    check_mesh(path, kind, data)
    if kind == "obj" and (plain := _of_plain_obj(data)) is not None:
        return (plain,)
    if kind == "stl" or (kind == "obj" and b"mtllib" not in data):
        try:
            found = [_of_stl(data) if kind == "stl" else _of_obj(data)]
        except (ValueError, IndexError) as error:
            raise ConfigError(f"{path}: is not read as a mesh: {error}") from error
    else:
        found = _of_file(path, kind)
    parts = [_checked(path, part) for part in found]
    if not any(len(part.faces) for part in parts):
        raise ConfigError(f"{path}: has no triangles")
    return tuple(part for part in parts if len(part.faces))


def _of_file(path: Path, kind: str) -> list[MeshPart]:
    """The parts of a mesh that trimesh reads."""
    scene = _scene(path, kind)
    try:
        nodes = [(str(node), *scene.graph[node]) for node in scene.graph.nodes_geometry]
        meshes = [(node, _metres(scene, frame, kind), scene.geometry[name]) for node, frame, name in nodes]
        return [_of_scene(*mesh) for mesh in meshes if hasattr(mesh[2], "faces")]  # others are lines and points
    except (ValueError, IndexError, TypeError, ArithmeticError) as error:  # what the file has is of no use
        raise ConfigError(f"{path}: is not read as a mesh: {' '.join(str(error).split())[:200]}") from error


def by_look(parts: tuple[MeshPart, ...]) -> tuple[MeshPart, ...]:
    """The parts, of which those with the same colour and texture are one."""
    groups: dict[tuple[object, ...], list[MeshPart]] = {}
    for part in parts:
        key = part.colour, id(part.texture), part.texcoords is None, part.normals is None
        groups.setdefault(key, []).append(part)
    return tuple(joined(tuple(group)) if len(group) > 1 else group[0] for group in groups.values())


def joined(parts: tuple[MeshPart, ...]) -> MeshPart:
    """One part with the triangles of all."""
    offsets = np.cumsum([0, *(len(part.vertices) for part in parts)])
    faces = np.concatenate([part.faces + offset for part, offset in zip(parts, offsets, strict=False)])
    first = parts[0]
    texcoords = [part.texcoords for part in parts if part.texcoords is not None]
    normals = [part.normals for part in parts if part.normals is not None]
    return MeshPart(
        first.name,
        np.concatenate([part.vertices for part in parts]),
        faces.astype(np.int32),
        first.colour,
        np.concatenate(texcoords) if len(texcoords) == len(parts) else None,
        normals=np.concatenate(normals) if len(normals) == len(parts) else None,
        texture=first.texture,
    )


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
    beside = _Beside(path)
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            scene = trimesh.load_scene(path, file_type=kind, process=False, resolver=beside)
    except Exception as error:  # the readers of these formats raise whatever they meet
        reason = " ".join(str(error).split())[:200] or type(error).__name__
        if isinstance(error, KeyError):
            reason = f"it lacks {reason}, or names a file that is not there, or of a kind that is not read"
        raise ConfigError(f"{path}: is not read as a mesh: {reason}") from error
    if beside.refused is not None:
        raise ConfigError(f"{path}: {beside.refused}") from beside.refused
    return scene


class _Beside(Mapping[str, bytes]):
    """The files that a mesh refers to: found by path, beside the mesh, or in the folders of Gazebo's models."""

    def __init__(self, path: Path) -> None:
        self._path = path
        self._folder = path.parent
        self.refused: ConfigError | None = None

    def get(self, name: str, default: bytes | None = None) -> bytes | None:  # type: ignore[override]  # as trimesh calls
        """The content of a texture or of a list of materials; `default` if there is none."""
        try:
            return self[name]
        except KeyError:
            return default

    def __getitem__(self, name: str) -> bytes:
        text = unquote(str(name).removeprefix("file://")).replace("\\", "/").strip()
        last = Path(text).name
        if Path(last).suffix.lower() in BESIDE:
            for path in (self._folder / text, *(self._folder / folder / last for folder in TEXTURE_FOLDERS)):
                if path.is_file():
                    try:
                        return read_file(confined(path, (own_folder(self._path),)), MAX_BYTES)
                    except ConfigError as error:
                        self.refused = error  # trimesh goes on without it
        raise KeyError(name)

    def __iter__(self) -> Iterator[str]:
        return iter(())

    def __len__(self) -> int:
        return 0

    def namespaced(self, _: str) -> _Beside:
        """Content of a file as trimesh asks for it; names have no spaces here."""
        return self


def _metres(scene: Any, frame: NDArray[np.float64], kind: str) -> NDArray[np.float64]:
    """The transform of a node; the unit of COLLADA counts, the axis that it calls up does not, as in ROS and Gazebo."""
    if kind == "dae":
        number, _, unit = str(scene.units).partition(" * ")
        return np.diag([*[float(number) if unit else 1.0] * 3, 1.0]) @ frame
    if kind in ("glb", "gltf"):  # y is up
        return np.array([[1.0, 0, 0, 0], [0, 0, -1, 0], [0, 1, 0, 0], [0, 0, 0, 1]]) @ frame
    return frame


def _of_scene(name: str, frame: NDArray[np.float64], mesh: Any) -> MeshPart:
    texcoords, texture = _texture(mesh)
    vertices = np.asarray(mesh.vertices, np.float64) @ frame[:3, :3].T + frame[:3, 3]
    faces = np.asarray(mesh.faces, np.int32)
    if np.linalg.det(frame[:3, :3]) < 0.0:
        faces = faces[:, ::-1]
    normals = None
    if "vertex_normals" in mesh._cache:  # noqa: SLF001 - else trimesh computes them
        normals = np.asarray(mesh.vertex_normals, np.float64) @ np.linalg.inv(frame[:3, :3])
    return MeshPart(name, vertices, faces, _colour(mesh), texcoords, normals=normals, texture=texture)


def _of_stl(data: bytes) -> MeshPart:
    """Without trimesh, whose import takes two seconds; `ValueError` for what is no STL."""
    count = int.from_bytes(data[80:84], "little")
    if len(data) >= 84 + 50 * count and (count or not data.startswith(b"solid")):
        records = np.frombuffer(data, np.dtype([("numbers", "<f4", 12), ("attribute", "<u2")]), count, 84)
        corners = records["numbers"][:, 3:].astype(np.float64)
    elif data.lstrip().startswith(b"solid"):
        lines = [line.split() for line in data.splitlines()]
        corners = np.array([line[1:4] for line in lines if line[:1] == [b"vertex"]], np.float64)
    else:
        raise ValueError("it is neither a binary STL file of its length nor a text")
    vertices = corners.reshape(-1, 3)
    return MeshPart("", vertices, np.arange(len(vertices), dtype=np.int32).reshape(-1, 3))


def _of_obj(data: bytes) -> MeshPart:
    """Without materials, which trimesh reads; `ValueError` or `IndexError` for what is no OBJ."""
    points: list[list[bytes]] = []
    coordinates: list[list[bytes]] = []
    directions: list[list[bytes]] = []
    corners: dict[bytes, int] = {}
    rows: list[tuple[int, int, int]] = []
    faces: list[tuple[int, int, int]] = []
    for line in data.splitlines():
        match line.split():
            case [b"v", *numbers]:
                points.append(numbers[:3])
            case [b"vt", *numbers]:
                coordinates.append(numbers[:2])
            case [b"vn", *numbers]:
                directions.append(numbers[:3])
            case [b"f", *texts]:
                polygon = []
                for text in texts:
                    if text not in corners or b"-" in text:
                        point, place, normal = [*text.split(b"/"), b"", b""][:3]
                        rows.append(
                            (
                                _index(point, len(points)),
                                _index(place, len(coordinates)) if place else -1,
                                _index(normal, len(directions)) if normal else -1,
                            )
                        )
                        corners[text] = len(rows) - 1
                    polygon.append(corners[text])
                faces += [(polygon[0], *pair) for pair in pairwise(polygon[1:])]
    if not rows:
        raise ValueError("it has no faces")
    position_at, texture_at, normal_at = np.array(rows).T
    vertices = np.array(points, np.float64)[position_at]
    if vertices.shape[1] != 3:
        raise ValueError("a vertex has not three numbers")
    texcoords = np.array(coordinates, np.float64)[texture_at] if (texture_at >= 0).all() else None
    normals = np.array(directions, np.float64)[normal_at] if (normal_at >= 0).all() else None
    return MeshPart("", vertices, np.array(faces, np.int32).reshape(-1, 3), None, texcoords, normals=normals)


def _of_plain_obj(data: bytes) -> MeshPart | None:
    """An OBJ file that has only triangles, with normals, as `tools/make_robot_meshes.py` writes it; else None.

    Reading it takes a tenth of the time.
    """
    lines: dict[bytes, list[bytes]] = {b"v": [], b"vn": [], b"f": [], b"": []}
    for line in data.split(b"\n"):
        kind, _, rest = line.partition(b" ")
        if kind not in lines:
            return None
        lines[kind].append(rest)
    try:
        vertices = np.array(b" ".join(lines[b"v"]).split(), np.float64).reshape(-1, 3)
        normals = np.array(b" ".join(lines[b"vn"]).split(), np.float64).reshape(-1, 3)
        corners = np.array(b" ".join(lines[b"f"]).replace(b"//", b" ").split(), np.int64).reshape(-1, 2) - 1
    except ValueError:
        return None
    if (3 * len(lines[b"f"]), len(lines[b"v"]), len(lines[b"vn"])) != (len(corners), len(vertices), len(normals)):
        return None
    if not len(corners) or len(corners) > 3 * MAX_FACES or (corners >= (len(vertices), len(normals))).any():
        return None
    lengths = np.linalg.norm(normals, axis=1, keepdims=True)
    if corners.min() < 0 or not np.isfinite(vertices).all() or not (lengths > 0.0).all():
        return None
    pairs, faces = np.unique(corners @ (len(normals), 1), return_inverse=True)
    point, direction = np.divmod(pairs, len(normals))
    triangles = faces.reshape(-1, 3).astype(np.int32)
    return MeshPart("", vertices[point], triangles, normals=(normals / lengths)[direction])


def _index(text: bytes, count: int) -> int:
    number = int(text)
    found = number - 1 if number > 0 else count + number
    if not 0 <= found < count:
        raise ValueError(f"a face names the element {number} of {count}")
    return found


def _checked(path: Path, part: MeshPart) -> MeshPart:
    """The part without double vertices, without triangles that have no area, and with at most `MAX_FACES`."""
    vertices, faces, texcoords, normals = part.vertices, part.faces, part.texcoords, part.normals
    if vertices.ndim != 2 or vertices.shape[1] != 3 or faces.ndim != 2 or faces.shape[1] != 3:
        raise ConfigError(f"{path}: has vertices or triangles without three numbers")
    if not np.isfinite(vertices).all():
        raise ConfigError(f"{path}: has vertices that are not finite numbers")
    if len(faces) and not 0 <= faces.min() <= faces.max() < len(vertices):
        raise ConfigError(f"{path}: has triangles of vertices that are not there")
    if normals is not None:
        lengths = np.linalg.norm(normals, axis=1, keepdims=True)
        normals = normals / lengths if np.isfinite(lengths).all() and (lengths > 0.0).all() else None
    if len(faces) > MAX_FACES:
        normals = None
    if texcoords is None and len(faces):
        rows = vertices if normals is None else np.column_stack([vertices, normals])
        rows, same = np.unique(rows, axis=0, return_inverse=True)
        vertices, normals = rows[:, :3], None if normals is None else rows[:, 3:]
        faces = same.reshape(-1)[faces].astype(np.int32)
        if len(faces) > MAX_FACES:
            _LOG.warning("%s: has %d faces; simplified to %d", path, len(faces), MAX_FACES)
            vertices, faces = _simplified(path, vertices, faces)
    elif len(faces) > MAX_FACES:
        raise ConfigError(f"{path}: has {len(faces)} faces; with texture coordinates at most {MAX_FACES}")
    a, b, c = (vertices[faces[:, corner]] for corner in range(3))
    areas = np.linalg.norm(np.cross(b - a, c - a), axis=1)
    used, inverse = np.unique(faces[areas > 1e-14], return_inverse=True)
    return MeshPart(
        part.name,
        np.ascontiguousarray(vertices[used]),
        inverse.reshape(-1, 3).astype(np.int32),
        part.colour,
        None if texcoords is None else np.ascontiguousarray(texcoords[used]),
        normals=None if normals is None else np.ascontiguousarray(normals[used]),
        texture=part.texture,
    )


def _simplified(
    path: Path, vertices: NDArray[np.float64], faces: NDArray[np.int32]
) -> tuple[NDArray[np.float64], NDArray[np.int32]]:
    try:
        import fast_simplification  # noqa: PLC0415 - for large meshes only
    except ImportError:
        raise ConfigError(
            f"{path}: has {len(faces)} faces, and at most {MAX_FACES} are read: pip install fast-simplification, or "
            "simplify the file"
        ) from None
    points, triangles = fast_simplification.simplify(
        vertices.astype(np.float32), faces, target_reduction=1.0 - MAX_FACES / len(faces)
    )
    return np.asarray(points, np.float64), np.asarray(triangles, np.int32)


def _colour(mesh: Any) -> tuple[float, float, float, float] | None:
    visual = mesh.visual
    if visual.kind == "texture":
        material = visual.material
        found = material.baseColorFactor if hasattr(material, "baseColorFactor") else material.main_color
        if found is None:
            return None
    elif visual.kind in ("face", "vertex"):
        found = visual.main_color
    else:
        return None
    red, green, blue, alpha = (float(channel) / 255.0 for channel in np.asarray(found)[:4])
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
