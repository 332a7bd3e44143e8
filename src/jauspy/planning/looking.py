"""Looking for things with the depth cameras of a robot, first of all with that which its arm carries."""

from __future__ import annotations

import asyncio
import math
from collections.abc import Callable, Sequence
from contextlib import suppress
from dataclasses import replace
from typing import Final, Protocol

import numpy as np

from jauspy.cloud.stream import Cloud, CloudSubscriber
from jauspy.geometry.vectors import Vector
from jauspy.ocu.robot import Robot
from jauspy.planning.grasp_checks import GraspFailed
from jauspy.planning.motion import NoPlan
from jauspy.planning.objects import SeenObject, Wanted, choose, find_objects
from jauspy.planning.obstacles import Obstacles
from jauspy.planning.planned_motions import PlannedMotions
from jauspy.planning.robot_planner import Sight
from jauspy.planning.scene import Scene
from jauspy.planning.views import Views
from jauspy.platform.description import RobotModel

FARTHEST: Final = 1.8
"""Metres from the base within which things are looked for."""
LOOK_AT: Final = ((0.8, 0.0), (0.7, 0.7), (0.7, -0.7))
"""Where it looks if the place is not known: metres from the arm's foot, and radians to the left."""
LOOK_HEIGHT: Final = 0.15
"""Metres above the base's origin."""
BODY_MARGIN: Final = 0.03
"""Metres around the robot's own links in which points are not used."""
REST_TIME: Final = 0.6
"""Seconds until an arm that has arrived is at rest, for clouds and for the wrist's sensor."""
CLOUD_WAIT: Final = 6.0
"""Seconds to wait for a cloud."""


class Eyes(Protocol):
    """What the depth cameras of a robot see."""

    scene: Scene
    """Obstacles that were seen."""

    async def clouds(self) -> Sequence[Cloud]:
        """A cloud of each camera, all measured from now on."""
        ...

    def obstacles(self) -> Obstacles:
        """What a motion must not touch now; `RequestError` if it is not known."""
        ...


class CloudEyes:
    """The clouds that a robot publishes."""

    def __init__(self, scene: Scene, sight: Sight, subscribers: Sequence[CloudSubscriber]) -> None:
        self.scene = scene
        self._sight, self._subscribers = sight, subscribers

    async def clouds(self) -> Sequence[Cloud]:
        """A cloud of each camera, all measured from now on."""
        found = [await asyncio.to_thread(_newest, one) for one in self._subscribers]
        return [cloud for cloud in found if cloud is not None]

    def obstacles(self) -> Obstacles:
        """What a motion must not touch now; `RequestError` if it is not known."""
        return self._sight.obstacles()


class Looking:
    """Finds things; `foot` is where the arm stands (x, y), metres, base's frame."""

    def __init__(
        self,
        robot: Robot,
        model: RobotModel,
        group: str,
        eyes: Eyes,
        motions: PlannedMotions,
        *,
        foot: tuple[float, float],
        tell: Callable[[str], None],
    ) -> None:
        """`group`: the joints of the arm; `tell` is called with what begins, in words."""
        self._robot, self._model, self._group = robot, model, group
        self._eyes, self._motions, self._foot, self._tell = eyes, motions, foot, tell
        self._views: dict[str, Views | None] = {}

    async def find(self, wanted: Wanted) -> SeenObject:
        """Find a thing, and look at it closely; `GraspFailed` if none is seen.

        As the cameras look now, then from views of the arm's camera.
        """
        self._tell(f"looking for {wanted}")
        points = [wanted.near] if wanted.near is not None else self._usual_points()
        seen = await self.see(wanted)
        found = choose(seen, wanted)
        for point in points:
            if found is not None:
                break
            if await self.turn_to(point):
                found = choose(now := await self.see(wanted), wanted)
                seen += now
        if found is None and wanted.hue:  # a part of it may have been hidden
            found = choose(seen, Wanted(colour=wanted.hue, near=wanted.near))
            if found is not None and await self.turn_to(found.centre):
                found = choose(await self.see(wanted), wanted)
            else:
                found = None
        elif found is not None and await self.turn_to(found.centre):
            near = replace(wanted, near=found.centre)
            found = choose(await self.see(wanted), near) or found
        if found is None:
            others = "; ".join(str(thing) for thing in seen[:4])
            raise GraspFailed(f"no {wanted} is seen" + (f"; seen are: {others}" if others else ""))
        self._tell(f"found: {found}")
        return found

    async def turn_to(self, point: Vector) -> bool:
        """Move the arm so that its depth camera looks at a point; False if there is no such camera, or no way."""
        present = await self._motions.present()
        for views in filter(None, self._views.values()):
            for posture in views.at(point, present):
                with suppress(NoPlan):
                    await self._motions.run(await self._motions.plan(posture), 1)
                    return True
        return False

    async def see(self, wanted: Wanted) -> list[SeenObject]:
        """The things that the cameras see now; `GraspFailed` if no cloud comes."""
        await asyncio.sleep(REST_TIME)
        clouds = await self._eyes.clouds()
        positions = (await self._robot.joints()).positions
        rows, colours = [], []
        for cloud in clouds:
            if cloud.frame not in self._model.description.links():
                continue
            self._note_camera(cloud.frame)
            frame = self._motions.tree.pose(cloud.frame, positions)
            data = np.frombuffer(cloud.points, "<f4").reshape(-1, cloud.values).astype(np.float64)
            data = data[np.isfinite(data).all(axis=1)]
            points = data[:, :3] @ np.array(frame.rotation).T + np.array(frame.position)
            near = np.hypot(points[:, 0], points[:, 1]) <= FARTHEST
            rows.append(points[near])
            colours.append(data[near, 3:6] if cloud.values >= 6 else np.zeros((int(near.sum()), 3)))
        if not rows:
            raise GraspFailed("no point cloud came: does the robot publish one? (jauspy up --cloud arm=ADDRESS)")
        points, tints = np.concatenate(rows), np.concatenate(colours)
        assert self._eyes.scene.body is not None
        own = self._eyes.scene.body.contains(points, [positions], BODY_MARGIN)
        return await self._motions.work(lambda: find_objects(points[~own], tints[~own], wanted.hue))

    def _usual_points(self) -> list[Vector]:
        x, y = self._foot
        return [(x + far * math.cos(left), y + far * math.sin(left), LOOK_HEIGHT) for far, left in LOOK_AT]

    def _note_camera(self, link: str) -> None:
        """Prepare the search for views of a camera that the arm carries."""
        if link in self._views:
            return
        setup = self._model.groups[self._group]
        chain = self._model.description.chain(self._motions.tree.root, link)
        carried = any(joint.name in setup.joints for joint in chain)
        self._views[link] = Views(self._model, self._group, link) if carried else None


def _newest(subscriber: CloudSubscriber) -> Cloud | None:
    """A cloud that is measured from now on; None if none comes."""
    while subscriber.receive(0.0) is not None:
        pass
    subscriber.receive(CLOUD_WAIT)
    return subscriber.receive(CLOUD_WAIT)
