"""Make collision shapes of detailed meshes: fewer triangles (quadric decimation), or convex pieces (decomposition).

    python tools/make_collision_shapes.py MESH... [--way decimate|decompose] [--triangles N] [--error E] [--to FOLDER]
    python tools/make_collision_shapes.py --bench

MESH is a file that trimesh reads (STL, OBJ, PLY), or the name of a look of the cell, as in `x5_elbow`. The result is an
STL for each shape; the table says what it costs in accuracy: the largest distance of the shape's surface from the
mesh's, and its volume beside that of the mesh's convex hull. `decimate` uses fast-simplification, `decompose` CoACD.

With --bench the parts of the cell fall into a bin, once for each kind of collision shape: the visual meshes as they are
(MuJoCo collides with their convex hulls), their decimation, their convex pieces, and the cell's own primitives
(`Solid`). It prints the real-time factors by CPU time, and the gain.
"""

from __future__ import annotations

import argparse
import sys
import time
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import coacd
import fast_simplification
import mujoco
import numpy as np
import trimesh
import trimesh.proximity
import trimesh.util
from numpy.typing import NDArray

MESHES = Path(__file__).parents[1] / "src" / "jauspy_sim" / "cell" / "meshes.npz"
TYPES = {
    "x5_inline": (0.064, 0.05, 0.09),
    "x8_elbow": (0.068, 0.056, 0.11),
    "tube_long": (0.05, 0.05, 0.2),
    "bracket_straight": (0.05, 0.05, 0.06),
    "wheel": (0.13, 0.13, 0.04),
    "box": (0.16, 0.12, 0.1),
}
"""Looks that fall in the benchmark, and the sizes of their primitives: metres."""
EACH = 5
"""Parts of each look."""
SETTLED, SECONDS, STEP = 1.0, 2.0, 0.002

Shape = tuple[NDArray[np.float64], NDArray[np.int64]]
"""Vertices and triangles."""


@dataclass(frozen=True, slots=True)
class Settings:
    """How shapes are made."""

    way: str = "decimate"
    triangles: int = 200
    error: float = 0.1
    """CoACD's threshold of concavity: a fraction of the size."""
    seed: int = 1


def look(name: str) -> trimesh.Trimesh:
    """All meshes of a look of the cell as one."""
    with np.load(MESHES) as found:
        names = sorted({key.partition("/")[0] for key in found.files if key.startswith(f"{name}.")})
        if not names:
            known = sorted({key.partition(".")[0] for key in found.files})
            raise SystemExit(f"no file and no look {name!r}; looks are: {', '.join(known)}")
        parts = [
            trimesh.Trimesh(found[f"{each}/vertices"].astype(np.float64), found[f"{each}/triangles"].astype(np.int64))
            for each in names
        ]
    offsets = np.cumsum([0, *(len(part.vertices) for part in parts)])
    faces = [part.faces + offset for part, offset in zip(parts, offsets, strict=False)]
    joined = trimesh.Trimesh(np.concatenate([part.vertices for part in parts]), np.concatenate(faces))
    joined.merge_vertices(merge_norm=True, merge_tex=True)
    return joined


def read(name: str) -> trimesh.Trimesh:
    """A file, or a look of the cell."""
    return trimesh.load_mesh(name) if Path(name).is_file() else look(name)


def shapes_of(mesh: trimesh.Trimesh, settings: Settings) -> list[Shape]:
    """The collision shapes of a mesh."""
    if settings.way == "decompose":
        coacd.set_log_level("error")
        found = coacd.run_coacd(
            coacd.Mesh(mesh.vertices, mesh.faces),
            threshold=settings.error,
            max_convex_hull=4,
            preprocess_resolution=30,
            resolution=500,
            mcts_iterations=20,
            mcts_nodes=10,
            decimate=True,
            max_ch_vertex=32,
            seed=settings.seed,
        )
        return [(np.asarray(vertices), np.asarray(triangles)) for vertices, triangles in found]
    # inner surfaces do not touch anything: the hull is simplified
    hull = mesh.convex_hull
    count = len(hull.faces)
    if count <= settings.triangles:
        return [(np.asarray(hull.vertices), np.asarray(hull.faces))]
    vertices, triangles = fast_simplification.simplify(
        np.asarray(hull.vertices, np.float32), np.asarray(hull.faces), target_reduction=1.0 - settings.triangles / count
    )
    return [(np.asarray(vertices, np.float64), np.asarray(triangles, np.int64))]


def distance(mesh: trimesh.Trimesh, shapes: Sequence[Shape]) -> float:
    """The largest distance of points of the mesh's hull from the nearest of the shapes' surfaces, metres."""
    points = mesh.convex_hull.sample(400, seed=1)
    surfaces = trimesh.util.concatenate([trimesh.Trimesh(*each).convex_hull for each in shapes])
    _, distances, _ = trimesh.proximity.closest_point_naive(surfaces, points)  # type: ignore[no-untyped-call]  # theirs
    return float(distances.max())


def make(names: Sequence[str], settings: Settings, folder: Path) -> None:
    """Write the shapes of meshes, and print what they cost."""
    folder.mkdir(parents=True, exist_ok=True)
    print(f"{'mesh':20}{'triangles':>10}{'shapes':>8}{'triangles':>10}{'off (mm)':>10}{'volume':>8}")
    for name in names:
        mesh = read(name)
        shapes = shapes_of(mesh, settings)
        for number, each in enumerate(shapes):
            trimesh.Trimesh(*each).export(folder / f"{Path(name).stem}_{number}.stl")
        volume = sum(trimesh.Trimesh(*each).convex_hull.volume for each in shapes) / mesh.convex_hull.volume
        triangles = sum(len(each[1]) for each in shapes)
        off = 1e3 * distance(mesh, shapes)
        print(f"{Path(name).stem:20}{len(mesh.faces):10}{len(shapes):8}{triangles:10}{off:10.2f}{volume:8.2f}")


def bin_with_parts(kind: str) -> mujoco.MjModel:
    """A bin above which the parts begin to fall."""
    spec = mujoco.MjSpec()
    spec.option.timestep, spec.option.integrator = STEP, mujoco.mjtIntegrator.mjINT_IMPLICITFAST
    world, box = spec.worldbody, mujoco.mjtGeom.mjGEOM_BOX
    world.add_geom(type=mujoco.mjtGeom.mjGEOM_PLANE, size=(2.0, 2.0, 0.1))
    for side in (-0.4, 0.4):
        world.add_geom(type=box, size=(0.01, 0.4, 0.2), pos=(side, 0.0, 0.2))
        world.add_geom(type=box, size=(0.4, 0.01, 0.2), pos=(0.0, side, 0.2))
    at = 0
    for name, size in TYPES.items():
        shapes = _shapes(name, kind)
        for number, (vertices, triangles) in enumerate(shapes):
            mesh = spec.add_mesh(name=f"{name}_{number}")
            mesh.uservert, mesh.userface = vertices.ravel().tolist(), triangles.ravel().tolist()
            mesh.inertia = mujoco.mjtMeshInertia.mjMESH_INERTIA_CONVEX
        for _ in range(EACH):
            row, column, level = at % 5, at // 5 % 3, at // 15
            body = world.add_body(pos=(0.28 - 0.14 * row, 0.24 - 0.24 * column, 0.2 + 0.25 * level))
            body.add_freejoint()
            body.explicitinertial = True
            body.mass, body.inertia = 0.4, (8e-4, 8e-4, 5e-4)
            if kind == "primitives":
                half = tuple(each / 2.0 for each in size)
                if name == "wheel":
                    body.add_geom(type=mujoco.mjtGeom.mjGEOM_CYLINDER, size=(half[0], half[2], 0.0), mass=0.0)
                else:
                    body.add_geom(type=box, size=half, mass=0.0)
            for number in range(len(shapes)):
                body.add_geom(type=mujoco.mjtGeom.mjGEOM_MESH, meshname=f"{name}_{number}", mass=0.0)
            at += 1
    return spec.compile()


def _shapes(name: str, kind: str) -> list[Shape]:
    mesh = look(name)
    if kind == "primitives":
        return []
    if kind == "visual meshes":
        return [(np.asarray(mesh.vertices), np.asarray(mesh.faces))]
    return shapes_of(mesh, Settings("decimate" if kind == "decimated" else "decompose", triangles=60))


def bench() -> None:
    """Print the real-time factor with each kind of collision shape."""
    print(f"{len(TYPES) * EACH} parts in a bin, all awake: {SECONDS:g} s after {SETTLED:g} s")
    first = None
    for kind in ("visual meshes", "convex pieces", "decimated", "primitives"):
        model = bin_with_parts(kind)
        data = mujoco.MjData(model)
        mujoco.mj_step(model, data, round(SETTLED / STEP))
        start = time.process_time()
        contacts = 0
        for _ in range(round(SECONDS / STEP)):
            mujoco.mj_step(model, data)
            contacts += data.ncon
        factor = SECONDS / (time.process_time() - start)
        first = first or factor
        mean = contacts * STEP / SECONDS
        print(f"  {kind:15} real-time factor {factor:6.2f}, {factor / first:5.2f} of the first, {mean:5.0f} contacts")
        sys.stdout.flush()


def main() -> None:
    """Make shapes, or measure."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("meshes", nargs="*", metavar="MESH")
    parser.add_argument("--way", choices=("decimate", "decompose"), default="decimate")
    parser.add_argument("--triangles", type=int, default=200)
    parser.add_argument("--error", type=float, default=0.1)
    parser.add_argument("--to", type=Path, default=Path("collision_shapes"))
    parser.add_argument("--bench", action="store_true")
    arguments = parser.parse_args()
    if arguments.bench:
        bench()
    elif arguments.meshes:
        make(arguments.meshes, Settings(arguments.way, arguments.triangles, arguments.error), arguments.to)
    else:
        parser.error("name a mesh, or give --bench")


if __name__ == "__main__":
    main()
