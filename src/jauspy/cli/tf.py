"""`jauspy tf`: the poses of a running robot's frames."""

from __future__ import annotations

from collections.abc import Callable
from typing import Annotated, Any

import typer

from jauspy.cli import client, console
from jauspy.cli.options import Connect, Json, OwnId, Timeout
from jauspy.cli.processes import run
from jauspy.errors import ConfigError
from jauspy.geometry.frames import Frames
from jauspy.geometry.poses import Transform
from jauspy.geometry.vectors import quaternion
from jauspy.ocu.frames import RobotFrames
from jauspy.robot import robot_files
from jauspy.robot.config import RobotConfig
from jauspy.robot.robot_files import robot_model


def tf(
    *,
    source: Annotated[str | None, typer.Argument(metavar="[FROM]", help="The reference frame.")] = None,
    target: Annotated[str | None, typer.Argument(metavar="[TO]", help="The frame whose pose is printed.")] = None,
    robot: Annotated[
        str,
        typer.Option("--robot", metavar="ROBOT", help="The robot's name, as in inc1, or the path of its .toml file."),
    ] = "inc1",
    connect: Connect = None,
    own_id: OwnId = None,
    timeout: Timeout = 5.0,
    as_json: Json = False,
) -> None:
    """Show the poses of a running robot's frames: each in its parent, or TO in FROM.

    Frames are the links of the robot's description, and `local`, the frame of LocalPoseSensor. Joint positions are
    queried over JAUS, so any robot works that has LocalPoseSensor and the position sensors of its arms, grippers and
    pan-tilt units. Joints that no service reports are assumed to be at their initial position; each line names those
    that it depends on. Metres and radians, x forward, y left, z up; quaternions are w, x, y, z.

    Examples:
      jauspy tf
      jauspy tf base_link tool_link
      jauspy tf --robot my_robot.toml local lidar_link --json
    """
    if (source is None) != (target is None):
        raise ConfigError(f"give two frames, FROM and TO; only {source} is given")
    config = robot_files.load(robot)
    found = run(_query_frames(own_id, connect, config, timeout))
    if found is None:
        return
    frames, assumed = found
    if not as_json:
        console.note("metres and radians; axes of REP-103: x forward, y left, z up")
    pairs = [(target, source)] if source is not None and target is not None else list(frames.parents.items())
    for name, parent in pairs:
        row = _row(name, parent, frames.pose(name, parent)) | {"assumed": assumed(name, parent)}
        if as_json:
            console.print_json(row)
        else:
            console.print_lines(_line(row))


async def _query_frames(
    own_id: str | None, connect: str | None, config: RobotConfig, max_wait: float
) -> tuple[Frames, Callable[[str, str], list[str]]]:
    """All frames, and a function that returns the assumed joints on which the pose of a frame in another depends."""
    model = robot_model(config)
    async with client.make_ocu(own_id, connect, max_wait) as ocu:
        reader = RobotFrames(await ocu.discover(config.subsystem, timeout=max_wait), model, config.movers)
        return await reader.read(), reader.assumed_between


def _row(frame: str, parent: str, pose: Transform) -> dict[str, Any]:

    angles = pose.to_pose()
    return {
        "frame": frame,
        "in": parent,
        "axes": "REP-103",
        "position": [round(value, 6) + 0.0 for value in pose.position],
        "roll_pitch_yaw": [round(value, 6) + 0.0 for value in (angles.roll, angles.pitch, angles.yaw)],
        "quaternion": [round(value, 6) + 0.0 for value in quaternion(pose.rotation)],
    }


def _line(row: dict[str, Any]) -> str:
    x, y, z = (round(value, 4) + 0.0 for value in row["position"])  # no negative zeros
    roll, pitch, yaw = (round(value, 4) + 0.0 for value in row["roll_pitch_yaw"])
    line = (
        f"{row['frame']:24} in {row['in']:24}"
        f"  x {x:8.4f}  y {y:8.4f}  z {z:8.4f} m  roll {roll:7.4f}  pitch {pitch:7.4f}  yaw {yaw:7.4f} rad"
    )
    return f"{line}  assumed: {', '.join(row['assumed'])}" if row["assumed"] else line
