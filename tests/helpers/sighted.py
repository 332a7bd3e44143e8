"""A robot in MuJoCo with ray sensors at its links, and the true distances to the shapes of its world."""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import mujoco
import numpy as np
from tests.helpers.robot import described

from jauspy.geometry.frames import FrameTree
from jauspy.geometry.poses import Transform
from jauspy.geometry.urdf import JointKind
from jauspy.planning.scene import Sweep
from jauspy_sim.robot import SimulatedRobot

CAMERA, LIDAR = "chassis_camera_link", "lidar_link"
FLOOR = '<geom name="floor" type="plane" size="0 0 1"/>'
OBSTACLES = f"""
  {FLOOR}
  <geom name="wall" type="box" pos="3.0 0.0 0.5" size="0.1 1.5 0.5"/>
  <geom name="crate" type="box" pos="1.6 0.5 0.2" size="0.2 0.15 0.2" euler="0 0 25"/>
  <geom name="table" type="box" pos="1.9 -0.6 0.4" size="0.3 0.4 0.02"/>
  <geom name="post" type="cylinder" pos="1.4 -0.1 0.3" size="0.05 0.3"/>
  <geom name="ball" type="sphere" pos="2.2 0.1 0.15" size="0.15"/>
"""


def write_world(folder: Path, shapes: str) -> str:
    """A world with these shapes; returns its path."""
    path = folder / "world.xml"
    path.write_text(f"<mujoco><worldbody><light pos='0 0 5'/>{shapes}</worldbody></mujoco>")
    return str(path)


def camera_rays(columns: int, rows: int, fov: float = math.radians(80.0)) -> Any:
    """Unit vectors of a camera's pixels, x forward, shape (n, 3)."""
    wide = math.tan(fov / 2.0)
    pixel = 2.0 * wide / columns
    y = wide - (np.arange(columns) + 0.5) * pixel
    z = (rows / 2.0 - np.arange(rows) - 0.5) * pixel
    grid = np.stack(np.meshgrid([1.0], y, z, indexing="ij"), axis=-1).reshape(-1, 3)
    return grid / np.linalg.norm(grid, axis=1, keepdims=True)


def lidar_rays(count: int = 360) -> Any:
    """Unit vectors of a lidar of one layer."""
    angles = np.arange(count) * math.tau / count
    return np.stack((np.cos(angles), np.sin(angles), np.zeros(count)), axis=1)


class Sighted:
    """inc1 in a world; poses and joints are set, not simulated."""

    def __init__(self, world: str) -> None:
        self.model = dataclasses.replace(described("inc1")[1], cameras=(), lidars=())
        self.description = self.model.description
        self._robot = SimulatedRobot.open(self.model, world)
        self._mj, self.data = self._robot.model, self._robot.data
        self._tree = FrameTree(self.description)
        groups = self.model.groups.values()
        self.positions = {name: at for group in groups for name, at in zip(group.joints, group.start, strict=True)}
        self._prefix = self._robot.name_prefix
        self._free = next(n for n in range(self._mj.njnt) if self._mj.jnt_type[n] == mujoco.mjtJoint.mjJNT_FREE)
        self.base = Transform.from_pose(self._robot.drive.pose())
        self._height = float(self.data.qpos[self._mj.jnt_qposadr[self._free] + 2])
        world_bodies = [n for n in range(self._mj.nbody) if not self._mj.body(n).name.startswith(self._prefix)]
        self._shapes = [n for n in range(self._mj.ngeom) if self._mj.geom_bodyid[n] in world_bodies]

    def close(self) -> None:
        self._robot.close()

    def place(self, x: float, y: float, yaw: float) -> None:
        """Put the robot on the floor."""
        start = int(self._mj.jnt_qposadr[self._free])
        self.data.qpos[start : start + 7] = x, y, self._height, math.cos(yaw / 2.0), 0.0, 0.0, math.sin(yaw / 2.0)
        mujoco.mj_kinematics(self._mj, self.data)
        self.base = Transform.from_pose(self._robot.drive.pose())

    def move(self, positions: Mapping[str, float]) -> None:
        """Set joints, and those that follow them."""
        self.positions = {**self.positions, **positions}
        for joint in self.description.joints.values():
            if joint.kind is not JointKind.FIXED and f"{self._prefix}{joint.name}" in self._joint_names():
                self.data.joint(f"{self._prefix}{joint.name}").qpos = joint.position(self.positions)
        mujoco.mj_kinematics(self._mj, self.data)

    def sweep(
        self,
        link: str,
        time: float,
        rays: Any,
        *,
        postures: Sequence[Mapping[str, float]] | None = None,
        base: Transform | None = None,
        far: float = 10.0,
    ) -> Sweep:
        """A measurement from a link. `base` and `postures` are what the robot believes; by default the truth."""
        points, none = self.look(link, rays, far)
        mount = self._tree.pose(link, self.positions)
        known = [self.positions] if postures is None else postures
        return Sweep(link, points, mount, base or self.base, time, known, empty=none)

    def look(self, link: str, rays: Any, far: float = 10.0) -> tuple[Any, Any]:
        """Where rays in the link's frame end, and the ends of those that meet nothing, in that frame."""
        frame = self.base @ self._tree.pose(link, self.positions)
        directions = np.ascontiguousarray(rays @ np.array(frame.rotation).T)
        distances = self._cast(np.array(frame.position), directions)
        met = distances <= far
        return rays[met] * distances[met, None], rays[~met] * far

    def in_world(self, link: str, points: Any) -> Any:
        """Points of a link's frame in the world."""
        frame = self.base @ self._tree.pose(link, self.positions)
        return points @ np.array(frame.rotation).T + np.array(frame.position)

    def distances(self, points: Any) -> Any:
        """The true distances from points in the world to the surface of its nearest shape, metres."""
        found = np.full(len(points), np.inf)
        for number in self._shapes:
            turn = self.data.geom_xmat[number].reshape(3, 3)
            inner = (points - self.data.geom_xpos[number]) @ turn
            found = np.minimum(
                found, np.abs(_signed(int(self._mj.geom_type[number]), self._mj.geom_size[number], inner))
            )
        return found

    def hide(self, name: str) -> None:
        """Take a shape of the world away."""
        number = int(self._mj.geom(name).id)
        self._mj.geom_pos[number] = self.data.geom_xpos[number] = 0.0, 0.0, -50.0
        mujoco.mj_kinematics(self._mj, self.data)

    def _cast(self, start: Any, directions: Any) -> Any:
        """Distances along unit vectors, also to the robot itself, which the simulated lidar does not see."""
        count = len(directions)
        found, distances = np.empty(count, np.int32), np.empty(count)
        normals = {"normal": None} if "normal" in (mujoco.mj_multiRay.__doc__ or "") else {}
        mujoco.mj_multiRay(
            m=self._mj,
            d=self.data,
            pnt=start,
            vec=directions.ravel(),
            geomgroup=np.ones(mujoco.mjNGROUP, np.uint8),
            flg_static=True,
            bodyexclude=-1,
            geomid=found,
            dist=distances,
            nray=count,
            cutoff=mujoco.mjMAXVAL,
            **normals,
        )
        return np.where(distances < 0.0, math.inf, distances)

    def _joint_names(self) -> set[str]:
        return {self._mj.joint(n).name for n in range(self._mj.njnt)}


def _signed(kind: int, size: Any, points: Any) -> Any:
    """Signed distances of points, in its frame, to a shape of MuJoCo."""
    if kind == mujoco.mjtGeom.mjGEOM_PLANE:
        return points[:, 2]
    if kind == mujoco.mjtGeom.mjGEOM_SPHERE:
        return np.linalg.norm(points, axis=1) - size[0]
    if kind == mujoco.mjtGeom.mjGEOM_CYLINDER:
        beyond = np.stack((np.hypot(points[:, 0], points[:, 1]) - size[0], np.abs(points[:, 2]) - size[1]), axis=1)
    else:
        assert kind == mujoco.mjtGeom.mjGEOM_BOX
        beyond = np.abs(points) - size
    return np.linalg.norm(np.maximum(beyond, 0.0), axis=1) + np.minimum(beyond.max(axis=1), 0.0)
