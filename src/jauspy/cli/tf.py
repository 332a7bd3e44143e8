"""`jauspy tf`: where the frames of a running robot are."""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated, Any

import typer

from jauspy.cli.options import Connect, Json, OwnId, Timeout

if TYPE_CHECKING:
    from collections.abc import Callable

    from jauspy.geometry.frames import Frames
    from jauspy.geometry.poses import Transform
    from jauspy.modules.config import RobotConfig


def tf(
    *,
    source: Annotated[str | None, typer.Argument(metavar="[FROM]", help="The frame to give poses in.")] = None,
    target: Annotated[str | None, typer.Argument(metavar="[TO]", help="The frame whose pose is wanted.")] = None,
    robot: Annotated[
        str,
        typer.Option("--robot", metavar="ROBOT", help="The robot's name, as in inc1, or the path of its .toml file."),
    ] = "inc1",
    connect: Connect = None,
    own_id: OwnId = None,
    timeout: Timeout = 5.0,
    as_json: Json = False,
) -> None:
    """Show where the frames of a running robot are: all in their parents, or TO as FROM has it.

    Frames are the links of the robot's description, and `local`, in which its pose sensor reports. What moves is asked
    for over JAUS, so it works with any robot that has the services: LocalPoseSensor, and the sensors of joint
    positions of arms, grippers and pan-tilt units. Joints that no service reports are taken to be where they start;
    each line says which of them it depends on. Metres and radians, x forward, y left, z up; quaternions are w, x, y, z.

    Examples:
      jauspy tf
      jauspy tf base_link tool_link
      jauspy tf --robot my_robot.toml local lidar_link --json
    """
    import json

    from jauspy.cli.run import run
    from jauspy.errors import ConfigError
    from jauspy.modules import robots

    if (source is None) != (target is None):
        raise ConfigError(f"{source} alone is not enough: give the frame to start from and the one that is wanted")
    config = robots.load(robot)
    found = run(_look(own_id, connect, config, timeout))
    if found is None:
        return
    frames, assumed = found
    pairs = [(target, source)] if source is not None and target is not None else list(frames.parents.items())
    for name, parent in pairs:
        row = _row(name, parent, frames.pose(name, parent)) | {"assumed": assumed(name, parent)}
        print(json.dumps(row) if as_json else _line(row))


async def _look(
    own_id: str | None, connect: str | None, config: RobotConfig, patience: float
) -> tuple[Frames, Callable[[str, str], list[str]]]:
    """All frames, and what tells on which joints that nobody reports the pose of one in another one depends."""
    from jauspy.cli import addresses
    from jauspy.modules.robots import robot_model
    from jauspy.ocu.frames import RobotFrames

    model = robot_model(config)
    async with addresses.client(own_id, connect, patience) as ocu:
        reader = RobotFrames(await ocu.discover(config.subsystem, timeout=patience), model, config.movers)
        return await reader.read(), reader.assumed_between


def _row(frame: str, parent: str, pose: Transform) -> dict[str, Any]:
    from jauspy.geometry.vectors import quaternion

    angles = pose.to_pose()
    return {
        "frame": frame,
        "in": parent,
        "position": [round(value, 6) for value in pose.position],
        "roll_pitch_yaw": [round(value, 6) for value in (angles.roll, angles.pitch, angles.yaw)],
        "quaternion": [round(value, 6) for value in quaternion(pose.rotation)],
    }


def _line(row: dict[str, Any]) -> str:
    x, y, z = row["position"]
    roll, pitch, yaw = row["roll_pitch_yaw"]
    line = (
        f"{row['frame']:24} in {row['in']:24}"
        f"  x {x:8.4f}  y {y:8.4f}  z {z:8.4f} m  roll {roll:7.4f}  pitch {pitch:7.4f}  yaw {yaw:7.4f} rad"
    )
    return f"{line}  assumed: {', '.join(row['assumed'])}" if row["assumed"] else line
