"""inc1 in MuJoCo on virtual time, with the rays of its arm's camera as point cloud, before a thing to grasp."""

from __future__ import annotations

import math
from collections.abc import AsyncIterator, Callable, Sequence
from contextlib import asynccontextmanager
from typing import Any

import mujoco
import numpy as np
from tests.helpers.sighted import camera_rays

from jauspy.cloud.stream import XYZ_RGB, Cloud
from jauspy.geometry.frames import FrameTree
from jauspy.ids import JausID
from jauspy.planning.grasping import Grasping
from jauspy.planning.obstacles import Obstacles
from jauspy.planning.scene import Scene, SceneSetup, Sweep
from jauspy.platform.localization import LocalizationSetup
from jauspy.robot import robot_files
from jauspy.robot.runner import RobotRunner
from jauspy.testing import VirtualNetwork
from jauspy.virtual.environment import VirtualTime

CAMERA = "arm_camera_link"
ARM, GRIPPER = "101.1.104", "101.1.105"
NOISE = 0.0015
"""Metres, standard deviation of a distance."""
FAR = 4.0


class RayEyes:
    """The arm's depth camera by rays, which need no GL; noise by a seed. It believes the reported joints."""

    def __init__(self, simulated: Any, robot: Any, model: Any, seed: int) -> None:
        self.scene = Scene(model.description, SceneSetup(voxel_size=0.03))
        self._mj, self.data = simulated.model, simulated.data
        self._robot, self._tree = robot, FrameTree(model.description)
        self._prefix = simulated.name_prefix
        self._rays = camera_rays(256, 192)
        self._rng = np.random.default_rng(seed)
        self._time = 0.0

    async def clouds(self) -> Sequence[Cloud]:
        positions = (await self._robot.joints()).positions
        root = self.data.body(f"{self._prefix}{self._tree.root}")
        base_turn, base_place = root.xmat.reshape(3, 3), root.xpos
        frame = self._tree.pose(CAMERA, positions)
        turn = base_turn @ np.array(frame.rotation)
        directions = np.ascontiguousarray(self._rays @ turn.T)
        distances, shapes = np.empty(len(directions)), np.empty(len(directions), np.int32)
        start = base_place + base_turn @ np.array(frame.position)
        mujoco.mj_multiRay(
            self._mj,
            self.data,
            start,
            directions.ravel(),
            None,
            True,
            -1,
            shapes,
            distances,
            None,
            len(directions),
            FAR,
        )
        met = (distances >= 0.1) & (shapes >= 0)
        far = distances[met] + self._rng.normal(0.0, NOISE, int(met.sum()))
        points = self._rays[met] * far[:, None]
        self._time += 1.0
        self.scene.add(Sweep("arm", points, frame, _still(), self._time, [positions]))
        coloured = np.concatenate((points, self._mj.geom_rgba[shapes[met], :3]), axis=1).astype("<f4")
        return [Cloud(coloured.tobytes(), CAMERA, self._time, XYZ_RGB)]

    def obstacles(self) -> Obstacles:
        return self.scene.obstacles()


def _still() -> Any:
    from jauspy.geometry.poses import Transform

    return Transform()


class Before:
    """A robot before a thing."""

    def __init__(self, steps: Grasping, simulated: Any, body: str, robot: Any, said: list[str]) -> None:
        self.steps, self.simulated, self.robot, self.said = steps, simulated, robot, said
        self._body = simulated.data.body(body)
        self._root = simulated.data.body(f"{simulated.name_prefix}base_link")
        self.start = self._body.xpos.copy()

    @property
    def lifted(self) -> float:
        """Metres that the thing is higher than at the start, in truth."""
        return float(self._body.xpos[2] - self.start[2])

    def in_base(self) -> Any:
        """Where the origin of the thing is, in the frame of the robot's base, in truth."""
        return self._root.xmat.reshape(3, 3).T @ (self._body.xpos - self._root.xpos)


@asynccontextmanager
async def before_thing(
    network: VirtualNetwork,
    world: str,
    body: str,
    offset: tuple[float, float, float],
    *,
    seed: int = 0,
    disturb: Callable[[Any], None] = lambda _: None,
) -> AsyncIterator[Before]:
    """The robot stands so that the thing is `offset` (metres, metres, radians of heading) from its base."""
    config = robot_files.load("inc1").model_copy(
        update={"localization": LocalizationSetup(source="exact"), "world": world, "cameras": [], "lidars": []}
    )
    config = config.model_copy(update={"modules": [one for one in config.modules if one.type != "CM-VIS"]})
    model = robot_files.robot_model(config)
    runner = RobotRunner(config, network.transport, backend="sim", realtime=VirtualTime)
    async with runner, network.ocu() as ocu:
        simulated = runner._realtime._robot.inner
        ahead, left, heading = offset
        x, y, _ = simulated.data.body(body).xpos
        c, s = math.cos(heading), math.sin(heading)
        start = simulated.model.joint(f"{simulated.name_prefix}base").qposadr[0]
        place = x - c * ahead + s * left, y - s * ahead - c * left, 0.0
        simulated.data.qpos[start : start + 7] = *place, math.cos(heading / 2.0), 0.0, 0.0, math.sin(heading / 2.0)
        disturb(simulated)
        robot = await ocu.robot(101)
        said: list[str] = []
        async with robot.control(ARM, GRIPPER):
            eyes = RayEyes(simulated, robot, model, seed)
            steps = await Grasping.of(robot, JausID.parse(ARM), model, eyes, tell=said.append, in_thread=False)
            yield Before(steps, simulated, body, robot, said)
