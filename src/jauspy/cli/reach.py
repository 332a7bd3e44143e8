"""`jauspy reach`: move an arm to a pose, around what the robot sees."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Annotated, Any

import typer

from jauspy.cli import client, console
from jauspy.cli.options import Authority, Connect, Json, OperatorKey, OwnId, Timeout
from jauspy.cli.planner import (
    ArmArgument,
    Choices,
    Clouds,
    Description,
    Primitives,
    Sensors,
    Unknown,
    arm_id,
    need_packages,
    own_planner,
)
from jauspy.cli.processes import run
from jauspy.cli.scene import UnknownSpace
from jauspy.errors import ConfigError
from jauspy.geometry.poses import Pose, Transform
from jauspy.ids import JausID
from jauspy.ocu import OCU, Planner, Robot
from jauspy.ocu.planner import PLANNER


@dataclass(frozen=True, slots=True)
class Target:
    """What is to be reached: joints, or a pose in metres and radians in a frame; without `rpy` its point."""

    joints: dict[str, float]
    position: tuple[float, float, float]
    rpy: tuple[float, float, float] | None
    frame: str


def reach(
    *,
    target: ArmArgument,
    pose: Annotated[
        str | None,
        typer.Option(
            "--pose",
            metavar="X,Y,Z[,ROLL,PITCH,YAW]",
            help="Pose of the tool in metres and degrees; without angles any attitude will do.",
            show_default=False,
        ),
    ] = None,
    joints: Annotated[
        str | None,
        typer.Option(
            "--joints",
            metavar="NAME=VALUE,...",
            help="Positions of joints in radians or metres; the others stay.",
            show_default=False,
        ),
    ] = None,
    frame: Annotated[
        str, typer.Option("--frame", metavar="LINK", help="The link of the description in whose frame the pose is.")
    ] = "base_link",
    dry_run: Annotated[bool, typer.Option("--dry-run", help="Plan and show the plan, and move nothing.")] = False,
    replans: Annotated[
        int,
        typer.Option("--replans", min=0, max=255, help="How often it may stop and plan again on the way."),
    ] = 3,
    description: Description = None,
    primitives: Primitives = None,
    unknown: Unknown = UnknownSpace.FREE,
    cloud: Clouds = None,
    sensors: Sensors = True,
    authority: Authority = 127,
    connect: Connect = None,
    own_id: OwnId = None,
    operator_key: OperatorKey = None,
    timeout: Timeout = 5.0,
    as_json: Json = False,
) -> None:
    """Move the tool of an arm to a pose, or its joints to positions, around what the robot's sensors see.

    Uses the planner of the robot (service MotionPlanner, as of `jauspy planner`). If the robot has none for this arm,
    or if what it is to know is chosen by options, it plans in its own process. The arm is watched on its way: when it
    leaves it, or when something comes near, it stops and plans again. Ctrl-C stops it.

    Examples:
      jauspy reach 101.1.104 --pose 0.7,0,0.4,0,90,0 --frame base_link
      jauspy reach 101.1.104 --joints arm_elbow_joint=0.9 --dry-run
    """
    arm = arm_id(target)
    wanted = read_target(pose, joints, frame)
    choices = Choices(arm, description, primitives, unknown, cloud or (), sensors, authority, timeout)
    ocu = client.make_ocu(own_id, connect, timeout, operator=operator_key)
    row = run(_reach(ocu, wanted, choices, None if dry_run else replans))
    if row is not None:
        if as_json:
            console.print_json(row)
        else:
            console.print_lines("nothing was moved" if dry_run else f"{arm} is there")


def read_target(pose: str | None, joints: str | None, frame: str) -> Target:
    """The target of the options; `ConfigError` says what is wrong with them."""
    if (pose is None) == (joints is None):
        raise ConfigError("give --pose, as in --pose 0.7,0,0.4,0,90,0, or --joints, as in --joints arm_elbow_joint=0.9")
    if joints is not None:
        found: dict[str, float] = {}
        for item in joints.split(","):
            name, _, value = item.partition("=")
            if not name.strip() or name.strip() in found:
                raise ConfigError(f"--joints {joints}: write each joint once, as in arm_elbow_joint=0.9")
            found[name.strip()] = _number(value, f"--joints: {name.strip()}")
        return Target(found, (0.0, 0.0, 0.0), None, frame)
    assert pose is not None
    values = [_number(item, f"--pose {pose}") for item in pose.split(",")]
    if len(values) not in (3, 6):
        raise ConfigError(
            f"--pose {pose}: has {len(values)} numbers; write x,y,z in metres, or also roll,pitch,yaw in °"
        )
    x, y, z, *angles = values
    rpy = None
    if angles:
        roll, pitch, yaw = map(math.radians, angles)
        rpy = roll, pitch, yaw
    return Target({}, (x, y, z), rpy, frame)


def _number(text: str, what: str) -> float:
    try:
        value = float(text)
    except ValueError:
        raise ConfigError(f"{what}: {text.strip()!r} is not a number") from None
    if not math.isfinite(value):
        raise ConfigError(f"{what}: {text.strip()} is not finite")
    return value


async def _reach(ocu: OCU, target: Target, choices: Choices, replans: int | None) -> dict[str, Any]:
    """Plan, and move if `replans` is a number."""
    arm = choices.arm
    async with ocu:
        robot = await ocu.discover(arm.subsystem, timeout=choices.max_wait)
        robot.component(arm)
        if choices.is_default:
            if (planner := await _planner_of(robot, arm)) is not None:
                async with robot.control(str(planner.info.id), authority=choices.authority):
                    return await _with_component(planner, target, replans)
            console.note(f"subsystem {robot.id} has no planner for {arm}; this process plans")
        need_packages()
        return await _here(robot, target, choices, replans)


async def _planner_of(robot: Robot, arm: JausID) -> Planner | None:
    for info in robot.info.offering(PLANNER):
        planner = robot.planner_of(info.id)
        if await planner.arm() == arm:
            return planner
    return None


async def _with_component(planner: Planner, target: Target, replans: int | None) -> dict[str, Any]:
    if target.joints:
        plan = await planner.plan_joints(target.joints)
    else:
        plan = await planner.plan_pose(target.position, target.rpy, frame=target.frame)
    row = _row(str(planner.info.id), plan.duration, plan.clearance, plan.planning_time)
    if replans is None:
        await planner.cancel()
        return row
    end = await planner.execute(plan, max_replans=replans, progress=lambda state: _tell_replan(state.phase, state.text))
    return row | {"moved": True, "replans": end.replans}


async def _here(robot: Robot, target: Target, choices: Choices, replans: int | None) -> dict[str, Any]:
    from jauspy.planning.execution import Aim, MotionState
    from jauspy.planning.motion import PoseGoal

    aim = Aim(joints=target.joints)
    if not target.joints:
        pose = Transform.from_pose(Pose(*target.position, *(target.rpy or (0.0, 0.0, 0.0))))
        aim = Aim(goal=PoseGoal(pose, attitude=target.rpy is not None), frame=target.frame)
    done = 0

    def tell(state: MotionState) -> None:
        nonlocal done
        done = state.replans
        _tell_replan(state.phase.name.lower(), state.text)

    async with own_planner(robot, choices) as planned:
        plan = await planned.plan(aim)
        row = _row("this process", plan.duration, plan.clearance, plan.planning_time)
        if replans is None:
            return row
        await planned.execute(plan, aim, max_replans=replans, tell=tell)
        return row | {"moved": True, "replans": done}


def _row(planner: str, duration: float, clearance: float, planning_time: float) -> dict[str, Any]:
    near = "clearance is not known" if math.isnan(clearance) else f"clearance {100.0 * clearance:.1f} cm"
    console.note(f"plan: {duration:.1f} s, {near}; planned in {1000.0 * planning_time:.0f} ms by {planner}")
    return {
        "planner": planner,
        "duration": round(duration, 3),
        "clearance": None if math.isnan(clearance) else round(clearance, 4),
        "planning_time": round(planning_time, 4),
        "moved": False,
        "replans": 0,
    }


def _tell_replan(phase: str, text: str) -> None:
    if phase == "planning" and text:
        console.note(f"stopped, and plans again: {text}")
