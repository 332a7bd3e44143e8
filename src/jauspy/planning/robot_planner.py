"""A planner for an arm of a running robot, around what its sensors see and what was given by hand."""

from __future__ import annotations

import asyncio
from collections.abc import AsyncIterator, Callable, Mapping, Sequence
from contextlib import asynccontextmanager, suppress
from dataclasses import dataclass, field
from typing import Final

from jauspy.errors import JausError, RequestError
from jauspy.ids import JausID
from jauspy.ocu.control import DEFAULT_AUTHORITY
from jauspy.ocu.robot import Robot
from jauspy.planning.arm_planner import ArmPlanner
from jauspy.planning.execution import PlannedArm, group_of
from jauspy.planning.held_object import HELD, box_around
from jauspy.planning.obstacles import Obstacles, Primitive
from jauspy.planning.perception import Perception
from jauspy.planning.scene import Scene, SceneSetup, Unknown
from jauspy.platform.description import RobotModel

FIRST_LOOK: Final = 5.0
"""Seconds to wait until all sensors have measured."""
LOOK_INTERVAL: Final = 0.05
"""Seconds between two looks whether they have."""
STALE: Final = 3.0
"""Seconds without a measurement after which it is not known what is around the arm."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Surroundings:
    """Sources of what is known about the surroundings of an arm."""

    put: Callable[[Scene], object] = lambda _: None
    """Puts what was given by hand into the scene."""
    unknown: Unknown = Unknown.FREE
    has_sensors: bool = True
    """False: only what was given by hand is known."""
    clouds: Sequence[str] = ()
    """Addresses of point clouds, beside the lidars that the robot reports."""
    movers: Mapping[int, str] = field(default_factory=dict)
    """Joint groups of components, as for `RobotFrames`."""


class Sight:
    """What is seen, as long as the sensors measure."""

    def __init__(self, scene: Scene, perception: Perception, clouds: Sequence[str]) -> None:
        self._scene, self._perception, self._clouds = scene, perception, clouds
        self._task = asyncio.create_task(perception.run(), name="perception")

    def obstacles(self) -> Obstacles:
        """What is around the arm now; `RequestError` if a sensor measures no more."""
        if problem := self.problem():
            raise RequestError(problem)
        return self._scene.obstacles()

    def problem(self) -> str:
        """Why it is not known what is around the arm; empty if it is."""
        task = self._task
        if task.done():
            error = None if task.cancelled() else task.exception()
            return f"it is not known what is around the arm: {error or 'perception has ended'}"
        seen = self._perception.sensors
        for address in self._clouds:
            if address not in seen:
                return f"it is not known what is around the arm: no point cloud came from {address}"
        for name, sensor in seen.items():
            if sensor.age > STALE:
                return f"it is not known what is around the arm: nothing came from {name} for {sensor.age:.1f} s"
        return ""

    async def first_look(self) -> None:
        """Wait until all sensors have measured, or do not."""
        with suppress(TimeoutError):
            async with asyncio.timeout(FIRST_LOOK):
                while self.problem() and not self._task.done():  # noqa: ASYNC110 - perception has no event for it
                    await asyncio.sleep(LOOK_INTERVAL)

    async def close(self) -> None:
        """End perception."""
        self._task.cancel()
        await asyncio.wait((self._task,))


@asynccontextmanager
async def planned_arm(
    robot: Robot,
    arm: JausID,
    model: RobotModel,
    surroundings: Surroundings,
    *,
    authority: int = DEFAULT_AUTHORITY,
) -> AsyncIterator[PlannedArm]:
    """The planner of the arm that this component moves; `ConfigError` if the description has no such joints.

    Joints of other groups count as they are when the planner is made.
    """
    client = robot.manipulator(arm)
    joints = [joint.name for joint in (await client.description()).joints]
    group, _ = group_of(model, joints)
    planner = ArmPlanner(model, group, others=await _other_joints(robot, model, joints))
    scene = Scene(model.description, SceneSetup(unknown=surroundings.unknown))
    surroundings.put(scene)
    if not surroundings.has_sensors:
        yield PlannedArm(
            robot, client, model, planner, scene.obstacles, obstruction=planner.obstruction, authority=authority
        )
        return
    clouds, tip = surroundings.clouds, model.groups[group].tip

    def on_hold(held: Primitive | None) -> None:
        assert scene.body is not None
        if held is None:
            scene.body.detach(HELD)
        else:
            scene.body.attach(tip, box_around(held))

    sight = Sight(scene, Perception(robot, scene, model, clouds=clouds, movers=surroundings.movers), clouds)
    try:
        await sight.first_look()
        yield PlannedArm(
            robot,
            client,
            model,
            planner,
            sight.obstacles,
            obstruction=planner.obstruction,
            authority=authority,
            on_hold=on_hold,
        )
    finally:
        await sight.close()


async def _other_joints(robot: Robot, model: RobotModel, joints: Sequence[str]) -> dict[str, float]:
    """Positions of the joints in other groups, as far as the robot reports them."""
    known = {name for setup in model.groups.values() for name in setup.joints} - set(joints)
    try:
        positions = (await robot.joints()).positions
    except JausError:
        return {}
    return {name: value for name, value in positions.items() if name in known}
