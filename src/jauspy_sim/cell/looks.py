"""Visual meshes and materials of a cell. Nothing here collides or has mass."""

from __future__ import annotations

import math
from collections.abc import Mapping
from functools import cache
from importlib.resources import as_file, files
from typing import Final, TypeAlias

import mujoco
import numpy as np
from numpy.typing import NDArray

from jauspy.geometry.poses import Pose, Transform
from jauspy.geometry.vectors import X, quaternion, rotation_about
from jauspy.platform.modular.parts import BinSetup, CellSetup, ConveyorSetup, PartSolid, PartType, Shape, TargetArea
from jauspy_sim.models.groups import VISUAL

Colour: TypeAlias = tuple[float, float, float, float]

MATERIALS: Final[Mapping[str, tuple[Colour, float, float]]] = {
    "housing": ((0.13, 0.14, 0.16, 1.0), 0.35, 0.35),
    "metal": ((0.68, 0.70, 0.73, 1.0), 0.75, 0.55),
    "silver": ((0.66, 0.68, 0.70, 1.0), 0.55, 0.45),
    "blue": ((0.33, 0.56, 0.78, 1.0), 0.5, 0.5),
    "dark": ((0.07, 0.07, 0.08, 1.0), 0.4, 0.4),
    "rubber": ((0.05, 0.05, 0.055, 1.0), 0.1, 0.1),
    "carbon": ((0.10, 0.11, 0.12, 1.0), 0.7, 0.7),
    "accent": ((0.95, 0.46, 0.06, 1.0), 0.4, 0.4),
    "red": ((0.78, 0.12, 0.10, 1.0), 0.4, 0.4),
    "white": ((0.88, 0.89, 0.90, 1.0), 0.4, 0.4),
    "frame": ((0.20, 0.25, 0.31, 1.0), 0.3, 0.3),
    "warning": ((0.96, 0.76, 0.05, 1.0), 0.3, 0.3),
    "lamp": ((0.75, 0.95, 1.0, 1.0), 0.9, 0.9),
    "cardboard": ((0.74, 0.57, 0.37, 1.0), 0.05, 0.05),
    "tape": ((0.86, 0.76, 0.55, 1.0), 0.6, 0.6),
    "bin": ((0.16, 0.36, 0.62, 1.0), 0.35, 0.3),
    "belt": ((0.09, 0.16, 0.14, 1.0), 0.15, 0.15),
    "line": ((0.93, 0.72, 0.06, 1.0), 0.05, 0.05),
    "target": ((0.12, 0.52, 0.30, 1.0), 0.05, 0.05),
    "paint": ((0.93, 0.94, 0.94, 1.0), 0.05, 0.05),
}
"""Colour (red, green, blue, alpha), specular and shininess."""

SHADING: Final = frozenset({"housing", "silver", "white", "carbon", "frame", "cardboard", "bin", "belt"})
"""Materials that cast shadows: those of what is large. Bolts and lips would double the time of a picture."""

LOOKS: Final[Mapping[str, tuple[str, str]]] = {
    "x5_1_inline": ("x5_inline", "inline_output"),
    "x5_4_inline": ("x5_inline", "inline_output"),
    "x5_9_inline": ("x5_inline", "inline_output"),
    "x5_4_elbow": ("x5_elbow", "x5_elbow_output"),
    "x5_9_elbow": ("x5_elbow", "x5_elbow_output"),
    "x8_9_elbow": ("x8_elbow", "x8_elbow_output"),
    "x8_16_elbow": ("x8_elbow", "x8_elbow_output"),
    **{name: (name, "") for name in ("tube_short", "tube_long", "bracket_straight", "bracket_angled")},
    **{name: (name, "") for name in ("wheel", "chassis", "platform", "box")},
}
"""Meshes of the included types of parts, and of the output links of servo modules. Others look like their solids."""

ROBOT: Final = (
    "base_link",
    "shoulder_link",
    "upper_arm_link",
    "forearm_link",
    "wrist_1_link",
    "wrist_2_link",
    "wrist_3_link",
    "gripper",
)
"""Links of the UR10 that have meshes."""

LEG: Final = 0.02
"""Metres: half the width of the legs of bins and of the conveyor."""
PAINT: Final = 0.0008
"""Metres: thickness of the marks on the floor."""
ROLLER_PITCH: Final = 0.12


@cache
def _meshes() -> dict[str, tuple[NDArray[np.float64], NDArray[np.float64], NDArray[np.int64]]]:
    """Vertices, normals and triangles of all meshes, by name; made by tools/make_cell_meshes.py."""
    with as_file(files("jauspy_sim.cell") / "meshes.npz") as path, np.load(path) as found:
        names = sorted({key.partition("/")[0] for key in found.files})
        return {
            name: (
                found[f"{name}/vertices"].astype(np.float64),
                found[f"{name}/normals"].astype(np.float64),
                found[f"{name}/triangles"].astype(np.int64),
            )
            for name in names
        }


class Dresser:
    """Adds visual shapes to the bodies of a cell's model."""

    def __init__(self, spec: mujoco.MjSpec, setup: CellSetup, prefix: str) -> None:
        self._spec, self._setup, self._prefix = spec, setup, prefix
        for name, (colour, specular, shininess) in MATERIALS.items():
            material = spec.add_material(name=name, rgba=colour)
            material.specular, material.shininess = specular, shininess
        self._added: set[str] = set()

    def dress(self) -> None:
        """Add the visual shapes of the whole cell."""
        self._dress_robot()
        for part in self._setup.parts:
            self._dress_part(part.name, self._setup.types[part.type])
        for bin_setup in self._setup.bins:
            self._dress_bin(bin_setup)
        for fixture in self._setup.fixtures:
            body = self._spec.body(fixture.name)
            for solid in fixture.solids:
                self._solid(body, solid, "frame")
        if self._setup.conveyor is not None:
            self._dress_conveyor(self._setup.conveyor)
        if self._setup.target is not None:
            self._paint_target(self._setup.target)
        self._paint_floor()

    # --- what it consists of --------------------------------------------------------------------------------------

    def _look(self, body: mujoco.MjsBody, look: str) -> None:
        for name in _meshes():
            own, _, material = name.partition(".")
            if own == look:
                self._load(name)
                geom = body.add_geom(type=mujoco.mjtGeom.mjGEOM_MESH, meshname=name, material=material)
                self._only_seen(geom)

    def _load(self, name: str) -> None:
        if name in self._added:
            return
        self._added.add(name)
        vertices, normals, triangles = _meshes()[name]
        mesh = self._spec.add_mesh(name=name)
        mesh.uservert, mesh.usernormal = vertices.ravel().tolist(), normals.ravel().tolist()
        mesh.userface = mesh.userfacenormal = triangles.ravel().tolist()
        mesh.inertia = mujoco.mjtMeshInertia.mjMESH_INERTIA_SHELL

    def _solid(self, body: mujoco.MjsBody, solid: PartSolid, material: str) -> None:
        x, y, z = solid.size
        size = (x, y, z) if solid.shape is Shape.CUBOID else (2.0 * x, 2.0 * x, z)
        self._shape(body, solid.shape, size, solid.pose, material)

    def _box(
        self, body: mujoco.MjsBody, size: tuple[float, float, float], at: tuple[float, float, float], material: str
    ) -> None:
        self._shape(body, Shape.CUBOID, size, Transform(position=at), material)

    def _shape(
        self,
        body: mujoco.MjsBody,
        shape: Shape,
        size: tuple[float, float, float],
        pose: Transform,
        material: str,
    ) -> None:
        cuboid = shape is Shape.CUBOID
        x, y, z = size
        geom = body.add_geom(
            type=mujoco.mjtGeom.mjGEOM_BOX if cuboid else mujoco.mjtGeom.mjGEOM_CYLINDER,
            size=(x / 2.0, y / 2.0, z / 2.0) if cuboid else (x / 2.0, z / 2.0, 0.0),
            material=material,
            pos=pose.position,
            quat=quaternion(pose.rotation),
        )
        self._only_seen(geom)

    @staticmethod
    def _only_seen(geom: mujoco.MjsGeom) -> None:
        geom.castshadow = geom.material in SHADING
        geom.contype = geom.conaffinity = 0
        geom.mass = 0.0
        geom.group = VISUAL

    # --- what there is --------------------------------------------------------------------------------------------

    def _dress_robot(self) -> None:
        links = {body.name: body for body in self._spec.bodies}
        names = [f"{self._prefix}{link}" for link in ROBOT]
        if not all(name in links for name in names):
            return
        for link, name in zip(ROBOT, names, strict=True):
            for geom in links[name].geoms:
                if geom.group == VISUAL:
                    self._spec.delete(geom)
            self._look(links[name], link)

    def _dress_part(self, name: str, kind: PartType) -> None:
        body = self._spec.body(name)
        output = self._spec.body(f"{name}.output") if kind.servo is not None else None
        look, output_look = LOOKS.get(kind.name, ("", ""))
        if look:
            self._look(body, look)
        else:
            for solid in kind.solids:
                self._solid(body, solid, "metal")
        if output is None or kind.servo is None:
            return
        if output_look:
            self._look(output, output_look)
        else:
            for solid in kind.servo.output:
                self._solid(output, solid, "housing")

    def _dress_bin(self, setup: BinSetup) -> None:
        body = self._spec.body(setup.name)
        for solid in setup.solids():
            self._solid(body, solid, "bin")
        x, y, t = setup.length / 2.0, setup.width / 2.0, setup.thickness
        rim = 0.012
        for side in (-1.0, 1.0):
            self._box(body, (2.0 * x + 2.0 * t + rim, rim + t, 0.007), (0.0, side * (y + t / 2.0), setup.wall), "bin")
            self._box(body, (rim + t, 2.0 * y - rim, 0.006), (side * (x + t / 2.0), 0.0, setup.wall), "bin")
        self._box(body, (0.12, 0.002, 0.03), (0.0, -y - t - 0.001, setup.wall / 2.0 - 0.004), "paint")
        self._stand(setup)

    def _stand(self, setup: BinSetup) -> None:
        """Four legs under a bin, and a frame between them."""
        pose = Transform.from_pose(setup.pose)
        x, y = setup.length / 2.0 - 0.04, setup.width / 2.0 - 0.04
        feet = [pose.apply((sx * x, sy * y, -setup.thickness)) for sx, sy in ((1, 1), (-1, 1), (-1, -1), (1, -1))]
        world = self._spec.worldbody
        turn = Transform.from_pose(Pose(yaw=setup.pose.yaw)).rotation
        for px, py, pz in feet:
            self._shape(world, Shape.CUBOID, (2.0 * LEG, 2.0 * LEG, pz), Transform(turn, (px, py, pz / 2.0)), "frame")
            self._shape(world, Shape.CYLINDER, (0.06, 0.06, 0.008), Transform(turn, (px, py, 0.004)), "dark")
        for (ax, ay, _), (bx, by, _) in zip(feet, feet[1:] + feet[:1], strict=True):
            yaw = math.atan2(by - ay, bx - ax)
            bar = Transform.from_pose(Pose((ax + bx) / 2.0, (ay + by) / 2.0, 0.10, yaw=yaw))
            self._shape(world, Shape.CUBOID, (math.hypot(bx - ax, by - ay), 0.024, 0.024), bar, "frame")

    def _dress_conveyor(self, setup: ConveyorSetup) -> None:
        spec = self._spec
        belt, body = spec.body("belt"), spec.body("conveyor")
        length, width, height = setup.length, setup.width, setup.pose.z
        self._box(belt, (length - 0.04, width - 0.03, 0.006), (0.0, 0.0, -0.003), "belt")
        across = rotation_about(X, math.pi / 2.0)
        for number in range(round((length - 0.1) / ROLLER_PITCH) + 1):
            at = -length / 2.0 + 0.05 + number * ROLLER_PITCH
            roller = Transform(across, (at, 0.0, -0.032))
            self._shape(body, Shape.CYLINDER, (0.05, 0.05, width - 0.02), roller, "metal")
        for side in (-1.0, 1.0):
            y = side * (width / 2.0 + 0.008)
            self._box(body, (length, 0.03, 0.09), (0.0, y, -0.047), "silver")
            self._box(body, (length, 0.006, 0.012), (0.0, y + side * 0.017, -0.03), "accent")
            for end in (-1.0, 0.0, 1.0):
                x = end * (length / 2.0 - 0.12)
                leg = height - 0.09
                self._box(body, (0.05, 0.04, leg), (x, y, -0.09 - leg / 2.0), "frame")
                self._box(body, (0.10, 0.08, 0.008), (x, y, 0.004 - height), "dark")
        for end in (-1.0, 1.0):
            roller = Transform(across, (end * (length / 2.0 - 0.022), 0.0, -0.026))
            self._shape(body, Shape.CYLINDER, (0.048, 0.048, width - 0.03), roller, "belt")
        motor = Transform(across, (length / 2.0 - 0.16, -width / 2.0 - 0.09, -0.09))
        self._shape(body, Shape.CYLINDER, (0.09, 0.09, 0.14), motor, "accent")
        self._box(body, (0.07, 0.05, 0.06), (length / 2.0 - 0.16, -width / 2.0 - 0.045, -0.09), "housing")

    def _paint_target(self, area: TargetArea) -> None:
        body = self._spec.worldbody.add_body(name="target")
        pose = Transform.from_pose(area.pose)
        body.pos, body.quat = pose.position, quaternion(pose.rotation)
        x, y, width = area.length, area.width, 0.04
        self._box(body, (x, y, PAINT), (0.0, 0.0, PAINT / 2.0), "target")
        for side in (-1.0, 1.0):
            self._box(body, (x, width, PAINT), (0.0, side * (y - width) / 2.0, 1.5 * PAINT), "paint")
            self._box(body, (width, y, PAINT), (side * (x - width) / 2.0, 0.0, 1.5 * PAINT), "paint")
        for level, (radius, material) in enumerate(
            ((0.28, "paint"), (0.23, "target"), (0.12, "paint"), (0.07, "accent"))
        ):
            height = (2.0 + 0.5 * level) * PAINT
            self._shape(
                body, Shape.CYLINDER, (2 * radius, 2 * radius, PAINT), Transform(position=(0.0, 0.0, height)), material
            )

    def _paint_floor(self) -> None:
        """A yellow line around the cell, and black stripes on it."""
        world = self._spec.worldbody
        low, high, width = (-1.45, -1.55), (1.62, 1.25), 0.06
        x, y = (low[0] + high[0]) / 2.0, (low[1] + high[1]) / 2.0
        length, depth = high[0] - low[0], high[1] - low[1]
        for edge in (low[1], high[1]):
            self._box(world, (length + width, width, PAINT), (x, edge, PAINT / 2.0), "line")
        for edge in (low[0], high[0]):
            self._box(world, (width, depth, PAINT), (edge, y, PAINT / 2.0), "line")
