"""Grasps a thing that is seen, and puts it down: look, plan, approach, close, feel, lift, place.

All motions go over JAUS. The steps raise `GraspFailed` with one sentence; the gripper is open and empty, or closed.
"""

from __future__ import annotations

import asyncio
import math
from collections.abc import AsyncIterator, Callable, Sequence
from contextlib import AsyncExitStack, asynccontextmanager, suppress
from dataclasses import dataclass, replace
from functools import partial
from statistics import fmean
from typing import Final, TypeAlias

from jauspy.cloud.stream import CloudSubscriber
from jauspy.errors import ConfigError, JausError, RequestError
from jauspy.geometry.poses import Pose, Transform
from jauspy.geometry.vectors import GRAVITY, Vector
from jauspy.ids import JausID
from jauspy.ocu.arm import Arm
from jauspy.ocu.control import DEFAULT_AUTHORITY
from jauspy.ocu.robot import Robot
from jauspy.planning.arm_planner import ArmPlanner
from jauspy.planning.execution import MotionFailed, group_of
from jauspy.planning.grasp_candidates import Candidate, Gripper, candidates, gripper_of
from jauspy.planning.grasp_checks import GraspFailed, grip_problem, hold_problem
from jauspy.planning.grasp_ways import Ways, find_lowerings, find_ways
from jauspy.planning.looking import REST_TIME, CloudEyes, Eyes, Looking
from jauspy.planning.motion import NoPlan, Plan
from jauspy.planning.objects import SeenObject, Wanted, choose
from jauspy.planning.obstacles import Array
from jauspy.planning.perception import Perception
from jauspy.planning.planned_motions import PlannedMotions
from jauspy.planning.robot_planner import Sight, Surroundings
from jauspy.planning.scene import Scene, SceneSetup
from jauspy.planning.thing_around import VOXEL, AroundThing, moved_thing, payload
from jauspy.platform.description import RobotModel

MOST_CANDIDATES: Final = 60
"""Grasps that are tried by inverse kinematics."""
MOST_PLANS: Final = 12
"""Grasps to which a way is searched."""
TRIES: Final = 2
"""Grasps of a thing, until it is given up."""
SAME, ALIKE = 0.02, 0.2
"""Metres and radians up to which two grasps count as one."""
GRIP_TIMEOUT: Final = 15.0
"""Seconds."""
OPEN_TOLERANCE: Final = 0.005
"""Metres that an open gripper may be narrower than it can be."""
WEIGHT_SAMPLES: Final = 20
SAMPLE_INTERVAL: Final = 0.05
"""Seconds."""
HOLD_TIME: Final = 1.0
"""Seconds for which it is checked that it holds."""
PUT_DOWN: Final = 0.006
"""Metres above the surface at which the thing is let go."""
PLACE_TURNS: Final = (0.0, 0.35, -0.35, 0.8, -0.8, 1.6, -1.6, 3.1)
"""Radians about the vertical by which a thing may be turned where it is placed."""


@dataclass(frozen=True, slots=True)
class Grasped:
    """A thing in the gripper, and what shows that it is."""

    thing: SeenObject
    candidate: Candidate
    width: float
    """Metres between the fingers."""
    weight: float | None
    """Kilograms that the wrist feels; None without such a sensor."""
    lifted: float
    """Metres, by the arm's joints."""


Tell: TypeAlias = Callable[[str], None]


@asynccontextmanager
async def grasping(
    robot: Robot,
    arm: JausID,
    model: RobotModel,
    surroundings: Surroundings,
    *,
    authority: int = DEFAULT_AUTHORITY,
    tell: Tell = lambda _: None,
) -> AsyncIterator[Grasping]:
    """An arm that grasps, with control of it and of its gripper; `ConfigError` for a robot that cannot.

    `tell` is called with what begins, in words.
    """
    clouds = surroundings.clouds
    if not clouds:
        raise ConfigError("a grasp needs the point cloud of a depth camera; give its address, as in --cloud ADDRESS")
    scene = Scene(model.description, SceneSetup(voxel_size=VOXEL, unknown=surroundings.unknown))
    surroundings.put(scene)
    async with AsyncExitStack() as stack:
        sight = Sight(scene, Perception(robot, scene, model, clouds=clouds, movers=surroundings.movers), clouds)
        stack.push_async_callback(sight.close)
        await sight.first_look()
        eyes = CloudEyes(scene, sight, [stack.enter_context(CloudSubscriber(address)) for address in clouds])
        steps = await Grasping.of(robot, arm, model, eyes, authority=authority, tell=tell)
        await stack.enter_async_context(robot.control(str(arm), str(robot.gripper.info.id), authority=authority))
        yield steps


class Grasping:
    """The steps of a grasp, made by `grasping` or `of`; the caller has control of arm and gripper."""

    def __init__(
        self,
        robot: Robot,
        arm: Arm,
        model: RobotModel,
        planner: ArmPlanner,
        *,
        group: str,
        shape: Gripper,
        eyes: Eyes,
        authority: int,
        tell: Tell,
        in_thread: bool,
    ) -> None:
        self._robot, self._arm, self._gripper = robot, arm, robot.gripper
        self._planner, self._shape, self._tell = planner, shape, tell
        setup = model.groups[group]
        self._around = AroundThing(eyes, setup.tip)
        self._motions = PlannedMotions(
            robot, arm, model, planner, self._around.obstacles, authority=authority, in_thread=in_thread
        )
        self._failed: list[Transform] = []
        """Poses of the tool in grasps that failed."""
        moved = next(joint for joint in model.description.chain(setup.base, setup.tip) if joint.name in setup.joints)
        x, y, _ = self._motions.tree.pose(moved.child).position
        self._foot = x, y
        self._looking = Looking(robot, model, group, eyes, self._motions, foot=self._foot, tell=tell)

    @classmethod
    async def of(
        cls,
        robot: Robot,
        arm: JausID,
        model: RobotModel,
        eyes: Eyes,
        *,
        authority: int = DEFAULT_AUTHORITY,
        tell: Tell = lambda _: None,
        in_thread: bool = True,
    ) -> Grasping:
        """The steps for an arm and its gripper, by what the robot reports; `ConfigError` for one that cannot.

        `in_thread`: planning does not block the event loop.
        """
        client, gripper = robot.manipulator(arm), robot.gripper
        joints = [joint.name for joint in (await client.description()).joints]
        group, setup = group_of(model, joints)
        fingers = _finger_group(model, list(await gripper.limits()))
        shape = gripper_of(model, model.groups[fingers], setup.tip, (await gripper.width_limits())[1])
        known = {name for one in model.groups.values() for name in one.joints} - set(joints)
        opened = {name: model.description.joint(name).upper for name in model.groups[fingers].joints}
        positions = (await robot.joints()).positions
        others = {name: value for name, value in positions.items() if name in known} | opened
        planner = ArmPlanner(model, group, others=others)
        return cls(
            robot,
            client,
            model,
            planner,
            group=group,
            shape=shape,
            eyes=eyes,
            authority=authority,
            tell=tell,
            in_thread=in_thread,
        )

    # --- steps ----------------------------------------------------------------------------------------------------

    async def look(self, wanted: Wanted) -> SeenObject:
        """Find a thing: as the cameras look now, then from views of the arm's camera; then look at it closely."""
        return await self._looking.find(wanted)

    async def grasp(self, thing: SeenObject) -> Grasped:
        """Grasp and lift a thing, and check that it is held; another grasp is tried if the first one fails."""
        opened = await self._open()
        if opened < self._shape.opening - OPEN_TOLERANCE:
            raise GraspFailed(
                f"the gripper did not open: its fingers are {100.0 * opened:.1f} cm apart, not "
                f"{100.0 * self._shape.opening:.1f}"
            )
        self._failed.clear()
        while True:
            try:
                return await self._try(thing, opened)
            except (GraspFailed, MotionFailed) as error:
                again = await self._again(thing) if 0 < len(self._failed) < TRIES else None
                if again is None:
                    raise
                self._tell(f"trying another grasp: {error}")
                thing = again

    async def _again(self, thing: SeenObject) -> SeenObject | None:
        """The thing after a grasp that failed; None if it is not there any more."""
        wanted = Wanted(colour=thing.colour, near=thing.centre)
        self._around.set(None)
        with suppress(JausError):
            await self._looking.turn_to(thing.centre)
            return choose(await self._looking.see(wanted), wanted)
        return None

    async def _try(self, thing: SeenObject, opened: float) -> Grasped:
        self._around.set(thing, is_solid=True)
        ways, plan = await self._choose(thing)
        self._tell(f"approaching it, {math.degrees(ways.candidate.pitch):.0f} degrees downward")
        await self._motions.run(plan, 3)
        self._failed.append(ways.candidate.pose)
        empty = await self._weight()
        self._around.set(thing)
        try:
            await self._motions.straight(ways.approach, "on the straight way to it")
        except MotionFailed:
            await self._let_go(ways.approach)
            raise
        self._tell("closing the gripper")
        await self._gripper.close(effort=60.0, timeout=GRIP_TIMEOUT)
        width = await self._gripper.width()
        problem = grip_problem(width, ways.candidate.width, opened)
        if problem:
            await self._let_go(ways.approach)
            raise GraspFailed(problem)
        self._around.hold(thing, ways.candidate)
        self._tell(f"lifting it; the fingers are {100.0 * width:.1f} cm apart")
        lifted = await self._lift(ways.lift)
        weight, held = await self._felt(empty), await self._gripper.width()
        await asyncio.sleep(HOLD_TIME)
        kept = await self._gripper.width()
        problem = hold_problem(width, held, kept, weight)
        if problem:
            self._around.let_go()
            with suppress(JausError):
                await self._open()
            raise GraspFailed(problem)
        return Grasped(thing, ways.candidate, kept, weight, lifted)

    async def place(self, grasped: Grasped, point: Vector) -> None:
        """Put what is held on a surface, with its lowest point at `point` (base's frame, metres), and withdraw."""
        self._tell(f"placing it at {', '.join(f'{value:.2f}' for value in point)}")
        # where it was, it is no obstacle any more, although nobody has looked there since
        self._around.set(grasped.thing)
        ways, plan = await self._choose_place(grasped, point)
        await self._motions.run(plan, 1)
        await self._motions.straight(ways.approach, "on the way down", watched=False)
        if await self._open() < self._shape.opening - OPEN_TOLERANCE:
            raise GraspFailed("the gripper did not open at the place: it may still hold the thing")
        self._around.let_go()
        self._around.set(moved_thing(grasped.thing, point))
        await asyncio.sleep(REST_TIME)
        await self._motions.straight(ways.lift, "on the way back from it", watched=False)
        self._around.set(None)

    # --- choosing -------------------------------------------------------------------------------------------------

    async def _choose(self, thing: SeenObject) -> tuple[Ways, Plan]:
        """The best grasp that the arm can make, and the plan to its begin."""
        ranked = await self._motions.work(lambda: candidates(thing, self._shape, self._foot))
        if not ranked:
            raise GraspFailed(
                f"no grasp fits the {thing}: the gripper opens {100.0 * self._shape.opening:.0f} cm, and needs room "
                "beside the thing and above its surface"
            )
        present = await self._motions.present()
        tried, cause = 0, ""
        for candidate in ranked[:MOST_CANDIDATES]:
            if any(_is_like(one, candidate.pose) for one in self._failed):
                continue
            ways = await self._motions.work(partial(find_ways, self._planner.arm, candidate, present))
            if ways is None:
                continue
            tried += 1
            free = self._planner.obstruction(ways.approach, self._around.without(thing))
            if free:
                cause = free
                continue
            try:
                return ways, await self._motions.plan(ways.approach[0])
            except NoPlan as error:
                cause = str(error)
            if tried >= MOST_PLANS:
                break
        if not tried:
            raise GraspFailed(f"the arm reaches the {thing} with none of {len(ranked)} grasps; move the robot nearer")
        raise GraspFailed(f"none of {tried} grasps of the {thing} is free: {cause}")

    async def _choose_place(self, grasped: Grasped, point: Vector) -> tuple[Ways, Plan]:
        """Postures that put the thing down, and the plan to their begin."""
        x, y, _ = grasped.thing.centre
        below = x, y, grasped.thing.support.at(x, y)
        bearings = [math.atan2(b - self._foot[1], a - self._foot[0]) for a, b in ((x, y), point[:2])]
        present = await self._motions.present()
        held, cause = payload(grasped.thing, grasped.candidate), ""
        for turn in PLACE_TURNS:
            there = Transform.from_pose(Pose(*point, yaw=bearings[1] - bearings[0] + turn))
            down = Transform(position=(0.0, 0.0, PUT_DOWN))
            tool = down @ there @ Transform(position=below).inverse() @ grasped.candidate.pose
            for ways in find_lowerings(self._planner.arm, replace(grasped.candidate, pose=tool), present):
                try:
                    plan = await self._motions.plan(ways.approach[0], held)
                except NoPlan as error:
                    cause = str(error)
                else:
                    return ways, plan
        why = cause or "the arm does not reach it with this grasp"
        raise GraspFailed(f"the thing cannot be put at {', '.join(f'{value:.2f}' for value in point)}: {why}")

    # --- arm and gripper ------------------------------------------------------------------------------------------

    async def _lift(self, rows: Array) -> float:
        """Lift by a straight motion; returns the height that the arm's joints report, metres."""
        before = (await self._arm.tool()).z
        await self._motions.straight(rows, "while it is lifted", watched=False)
        return (await self._arm.tool()).z - before

    async def _open(self) -> float:
        await self._gripper.open(effort=60.0, timeout=GRIP_TIMEOUT)
        return await self._gripper.width()

    async def _let_go(self, approach: Array) -> None:
        """Open, and withdraw."""
        with suppress(RequestError):
            await self._open()
            await self._motions.straight(approach[::-1], "on the way back", watched=False)

    # --- what is felt ---------------------------------------------------------------------------------------------

    async def _weight(self) -> float | None:
        """Mean weight at the wrist in kilograms, with the gripper; None without a sensor."""
        await asyncio.sleep(REST_TIME)
        found = []
        for _ in range(WEIGHT_SAMPLES):
            try:
                found.append(-(await self._robot.force_torque()).force[2] / GRAVITY)
            except JausError:
                return None
            await asyncio.sleep(SAMPLE_INTERVAL)
        return fmean(found)

    async def _felt(self, empty: float | None) -> float | None:
        """Weight of what is held."""
        weight = None if empty is None else await self._weight()
        return None if weight is None or empty is None else weight - empty


def _is_like(one: Transform, other: Transform) -> bool:
    """True if two poses of the tool are the same grasp."""
    aims = (one.rotate((1.0, 0.0, 0.0)), other.rotate((1.0, 0.0, 0.0)))
    return math.dist(one.position, other.position) < SAME and math.dist(*aims) < ALIKE


def _finger_group(model: RobotModel, joints: Sequence[str]) -> str:
    """The group of the description that has one of these joints."""
    for name, group in model.groups.items():
        if set(group.joints) & set(joints):
            return name
    raise ConfigError(f"the description has no group with the fingers {', '.join(joints)}")
