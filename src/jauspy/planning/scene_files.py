"""Files of scenes: primitives by hand as TOML or JSON, and what a scene holds as PLY, JSON or a picture."""

from __future__ import annotations

import json
import math
import time
from collections.abc import Mapping
from importlib import import_module
from itertools import combinations, product
from pathlib import Path
from typing import Annotated, Any, Final, TypeAlias

import numpy as np
from numpy.typing import NDArray
from pydantic import BaseModel, ConfigDict, Field, ValidationError

from jauspy.cloud.stream import XYZ_RGB, Cloud, save as save_cloud
from jauspy.config_errors import explain
from jauspy.errors import ConfigError
from jauspy.geometry.poses import Pose, Transform
from jauspy.planning.obstacles import Box, Cylinder, Obstacles, Primitive, Sphere
from jauspy.planning.scene import MAX_PRIMITIVES, Frame, Scene
from jauspy.user_files import read_file, read_toml

Array: TypeAlias = NDArray[np.float64]
_Number: TypeAlias = Annotated[float, Field(ge=-1e5, le=1e5, allow_inf_nan=False)]
_Length: TypeAlias = Annotated[float, Field(gt=0.0, le=1e4, allow_inf_nan=False)]
_Name: TypeAlias = Annotated[str, Field(min_length=1, max_length=100)]

SUFFIXES: Final = (".ply", ".json", ".png")


class _Shape(BaseModel):
    model_config = ConfigDict(extra="forbid", frozen=True)

    name: _Name
    frame: Frame = Frame.LOCAL
    position: tuple[_Number, _Number, _Number]
    rotation: tuple[_Number, _Number, _Number] = (0.0, 0.0, 0.0)
    """Roll, pitch and yaw in degrees, about fixed axes."""

    @property
    def pose(self) -> Transform:
        """The pose of the middle."""
        return Transform.from_pose(Pose(*self.position, *map(math.radians, self.rotation)))


class _BoxTable(_Shape):
    size: tuple[_Length, _Length, _Length]


class _SphereTable(_Shape):
    radius: _Length


class _CylinderTable(_Shape):
    radius: _Length
    length: _Length


class _PrimitiveTables(BaseModel):
    model_config = ConfigDict(extra="forbid", frozen=True)

    boxes: tuple[_BoxTable, ...] = ()
    spheres: tuple[_SphereTable, ...] = ()
    cylinders: tuple[_CylinderTable, ...] = ()


def put_primitives(scene: Scene, path: Path) -> int:
    """Put the primitives of a file into a scene; returns their number. Raises `ConfigError`, which names the mistake.

    The poses of those with `frame = "local"` are in the robot's local frame, of those with "base" in that of its base.
    """
    primitives = _read(path)
    for frame, primitive in primitives:
        scene.put(primitive, frame, within=frame)
    return len(primitives)


def _read(path: Path) -> list[tuple[Frame, Primitive]]:
    try:
        tables = _PrimitiveTables.model_validate(_keys(path))
    except ValidationError as error:
        problems = "\n".join(f"  {explain(problem, _PrimitiveTables)}" for problem in error.errors(include_url=False))
        raise ConfigError(f"{path}: is not a file of primitives:\n{problems}") from error
    found: list[tuple[Frame, Primitive]] = [
        *((table.frame, Box(table.pose, table.size, table.name)) for table in tables.boxes),
        *((table.frame, Sphere(table.pose, table.radius, table.name)) for table in tables.spheres),
        *((table.frame, Cylinder(table.pose, table.radius, table.length, table.name)) for table in tables.cylinders),
    ]
    names = [primitive.name for _, primitive in found]
    if twice := sorted({name for name in names if names.count(name) > 1}) if len(names) <= MAX_PRIMITIVES else []:
        raise ConfigError(f"{path}: {twice[0]!r} is there twice; give each primitive its own name")
    if len(names) > MAX_PRIMITIVES:
        raise ConfigError(f"{path}: has {len(names)} primitives; a scene has {MAX_PRIMITIVES} at most")
    return found


def _keys(path: Path) -> Mapping[str, Any]:
    if path.suffix != ".json":
        return read_toml(path)
    try:
        found = json.loads(read_file(path))
    except (ValueError, RecursionError) as error:
        raise ConfigError(f"{path}: is not JSON: {str(error)[:200]}") from error
    if not isinstance(found, dict):
        raise ConfigError(f"{path}: is not a file of primitives; its keys are boxes, spheres and cylinders")
    return found


def check_suffix(path: Path) -> None:
    """Raise `ConfigError` for a file that `save_obstacles` does not write."""
    if path.suffix not in SUFFIXES:
        raise ConfigError(f"{path}: scenes are written as {', '.join(SUFFIXES[:-1])} or {SUFFIXES[-1]}")


def save_obstacles(obstacles: Obstacles, path: Path, frame: str) -> None:
    """Write obstacles by the suffix of the path; raises `ConfigError` if that is not possible.

    `.ply`: the centres of the voxels, coloured by height. `.json`: voxels and primitives. `.png`: views from above and
    from the right; needs matplotlib. `frame` is the name of the base.
    """
    check_suffix(path)
    if path.suffix == ".ply":
        points = np.concatenate((obstacles.voxels, _shades(obstacles.voxels[:, 2])), axis=1).astype("<f4")
        save_cloud(Cloud(points.tobytes(), frame, time.time(), XYZ_RGB), path)
        return
    try:
        if path.suffix == ".json":
            path.write_text(json.dumps(as_json(obstacles, frame)) + "\n", encoding="utf-8")
        else:
            _draw(obstacles, path, frame)
    except OSError as error:
        raise ConfigError(f"{path}: the scene cannot be written: {error.strerror}") from error


def as_json(obstacles: Obstacles, frame: str) -> dict[str, Any]:
    """Obstacles as a table: metres in the frame of the base; rotations are roll, pitch and yaw in degrees."""
    kinds: dict[type, str] = {Box: "boxes", Sphere: "spheres", Cylinder: "cylinders"}
    tables: dict[str, list[dict[str, Any]]] = {kind: [] for kind in kinds.values()}
    for primitive in obstacles.primitives:
        pose = primitive.pose.to_pose()
        angles = [round(math.degrees(angle), 4) for angle in (pose.roll, pose.pitch, pose.yaw)]
        place = {"position": [round(value, 4) for value in primitive.pose.position], "rotation": angles}
        size = {key: getattr(primitive, key) for key in ("size", "radius", "length") if hasattr(primitive, key)}
        tables[kinds[type(primitive)]].append({"name": primitive.name, **place, **size})
    voxels = np.round(obstacles.voxels, 4).tolist()
    return {"frame": frame, "voxel_size": obstacles.voxel_size, "voxels": voxels, **tables}


def _shades(heights: Array) -> Array:
    """Red, green and blue, 0..1, from blue for the lowest to red for the highest, shape (n, 3)."""
    low, high = float(heights.min(initial=0.0)), float(heights.max(initial=1.0))
    part = (heights - low) / max(high - low, 1e-6)
    return np.clip(np.stack((2.0 * part - 0.5, 1.0 - np.abs(2.0 * part - 1.0), 1.5 - 2.0 * part), axis=1), 0.0, 1.0)


def _draw(obstacles: Obstacles, path: Path, frame: str) -> None:
    try:
        figure_kind = import_module("matplotlib.figure").Figure
        canvas = import_module("matplotlib.backends.backend_agg").FigureCanvasAgg
    except ImportError:
        raise ConfigError("pictures of scenes need matplotlib; run: pip install 'jauspy[plot]'") from None
    figure = figure_kind(figsize=(12.0, 6.0), layout="constrained")
    canvas(figure)
    views = ((0, 1, 2, "from above", "y: left"), (0, 2, 1, "from the right", "z: up"))
    for number, (across, up, toward, title, label) in enumerate(views, 1):
        axes = figure.add_subplot(1, 2, number)
        order = np.argsort(obstacles.voxels[:, toward] * (-1.0 if toward == 1 else 1.0))
        shown = obstacles.voxels[order]
        axes.scatter(shown[:, across], shown[:, up], s=6.0, c=_shades(shown[:, 2]), marker="s", linewidths=0.0)
        for primitive in obstacles.primitives:
            for edge in _edges(primitive):
                axes.plot(edge[:, across], edge[:, up], "k-", linewidth=1.0)
        axes.plot(0.0, 0.0, "k+", markersize=12.0)
        axes.set(title=f"{title}, metres in {frame}", xlabel="x: forward", ylabel=label, aspect="equal")
        axes.grid(visible=True, alpha=0.3)
    figure.savefig(str(path), dpi=100)


def _edges(primitive: Primitive) -> list[Array]:
    """The twelve edges, each of shape (2, 3), of the box around a primitive."""
    if isinstance(primitive, Box):
        half = np.array(primitive.size) / 2.0
    elif isinstance(primitive, Sphere):
        half = np.full(3, primitive.radius)
    else:
        half = np.array((primitive.radius, primitive.radius, primitive.length / 2.0))
    rotation, position = np.array(primitive.pose.rotation), np.array(primitive.pose.position)
    corners = [np.array(signs) for signs in product((-1.0, 1.0), repeat=3)]
    pairs = [(one, other) for one, other in combinations(corners, 2) if np.abs(one - other).sum() == 2.0]
    return [position + np.stack(pair) * half @ rotation.T for pair in pairs]
