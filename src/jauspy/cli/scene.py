"""`jauspy scene`: what a robot sees around it, as a planner of motions gets it."""

from __future__ import annotations

import asyncio
from contextlib import suppress
from enum import StrEnum
from importlib.util import find_spec
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, Final

import typer

from jauspy.cli import client, console
from jauspy.cli.options import Connect, Json, OwnId, Timeout
from jauspy.cli.processes import run
from jauspy.errors import ConfigError
from jauspy.ocu import OCU
from jauspy.printable import printable

if TYPE_CHECKING:
    from jauspy.planning.perception import Perception
    from jauspy.planning.scene import Scene, SceneSetup
    from jauspy.robot.config import RobotConfig

PACKAGES: Final = ("numpy", "pydantic", "pynng")


class UnknownSpace(StrEnum):
    """What space means that no sensor has looked into."""

    FREE = "free"
    FORBIDDEN = "forbidden"


def scene(
    *,
    robot: Annotated[int, typer.Argument(metavar="ROBOT", min=1, max=65534, help="The robot's subsystem id.")],
    cloud: Annotated[
        list[str] | None,
        typer.Option(
            "--cloud",
            metavar="ADDRESS",
            help="Where point clouds are published, as in tcp://127.0.0.1:5566; may be repeated. Default: those of the "
            "robot's file.",
        ),
    ] = None,
    description: Annotated[
        str | None,
        typer.Option(
            "--description", metavar="ROBOT", help="Name or .toml file of the robot. Default: the name that it reports."
        ),
    ] = None,
    primitives: Annotated[
        Path | None,
        typer.Option("--primitives", metavar="FILE", help="Boxes, spheres and cylinders, as TOML or JSON."),
    ] = None,
    seconds: Annotated[float, typer.Option("--seconds", min=0.1, max=86400.0, help="How long to look.")] = 3.0,
    voxel: Annotated[
        float, typer.Option("--voxel", min=0.005, max=1.0, metavar="METRES", help="Edge of a voxel.")
    ] = 0.04,
    unknown: Annotated[
        UnknownSpace, typer.Option("--unknown", help="What space means that no sensor has looked into.")
    ] = UnknownSpace.FREE,
    output: Annotated[
        Path | None,
        typer.Option("-o", "--output", metavar="FILE", help="Write the scene as .ply, .json, or a picture as .png."),
    ] = None,
    connect: Connect = None,
    own_id: OwnId = None,
    timeout: Timeout = 5.0,
    as_json: Json = False,
) -> None:
    """Show what a robot sees around it: voxels of its lidars and depth cameras, in the frame of its base.

    Lidars, joints and the pose are read over JAUS, point clouds of depth cameras over nanomsg. The robot's own body is
    filtered out by its description. The verb takes no control. It prints how many voxels there are, where, and how old.

    Examples:
      jauspy scene 101 --cloud tcp://127.0.0.1:5566
      jauspy scene 101 --cloud tcp://127.0.0.1:5566 -o scene.png
      jauspy scene 101 --primitives table.toml --unknown forbidden -o scene.json
    """
    if missing := [package for package in PACKAGES if find_spec(package) is None]:
        raise ConfigError(f"scenes need {', '.join(missing)}: pip install 'jauspy[planning]'")
    from jauspy.planning.scene import Scene, SceneSetup, Unknown
    from jauspy.planning.scene_files import check_suffix, put_primitives, save_obstacles

    if output is not None:
        check_suffix(output)
    setup = SceneSetup(voxel_size=voxel, unknown=Unknown(unknown.value))
    trial = Scene(None, setup)  # mistakes are told before the robot is looked for
    if primitives is not None:
        put_primitives(trial, primitives)
    ocu = client.make_ocu(own_id, connect, timeout)
    found = run(
        _look(
            ocu,
            (robot, timeout),
            description=description,
            setup=setup,
            primitives=primitives,
            cloud=cloud,
            seconds=seconds,
        )
    )
    if found is None:
        return
    seen, perception, config, base = found
    report = _report(seen, perception, config, base)
    if as_json:
        console.print_json(report)
    else:
        console.print_lines(*_lines(report))
    if output is not None:
        save_obstacles(seen.obstacles(), output, base)
        console.note(f"{output}: written")


async def _look(
    ocu: OCU,
    which: tuple[int, float],
    *,
    description: str | None,
    setup: SceneSetup,
    primitives: Path | None,
    cloud: list[str] | None,
    seconds: float,
) -> tuple[Scene, Perception, RobotConfig, str]:
    """Look for that many seconds, or until cancelled."""
    from jauspy.planning.perception import Perception
    from jauspy.planning.scene import Scene
    from jauspy.planning.scene_files import put_primitives
    from jauspy.robot import robot_files
    from jauspy.robot.robot_files import robot_model

    async with ocu:
        robot = await ocu.discover(which[0], timeout=which[1])
        if description is None and robot.name not in robot_files.known():
            raise ConfigError(
                f"subsystem {robot.id} reports the name {printable(robot.name)!r}, of which jauspy has no description; "
                "give its file, as in --description my_robot.toml"
            )
        config = robot_files.load(description or robot.name)
        model = robot_model(config)
        seen = Scene(model.description, setup)
        if primitives is not None:
            put_primitives(seen, primitives)
        clouds = cloud or [source.address for source in config.clouds]
        perception = Perception(robot, seen, model, clouds=clouds, movers=config.movers)
        with suppress(TimeoutError):
            async with asyncio.timeout(seconds):
                await perception.run()
        return seen, perception, config, model.description.root()


def _report(seen: Scene, perception: Perception, config: RobotConfig, base: str) -> dict[str, Any]:
    from jauspy.planning.scene import Unknown

    summary = seen.summary()
    sensors = [
        {"sensor": name, "frame": state.frame, "used": state.used, "latency": round(state.latency, 4)}
        for name, state in perception.sensors.items()
    ]
    return {
        "robot": config.name,
        "frame": base,
        "voxel_size": seen.setup.voxel_size,
        "voxels": summary.voxels,
        "extent": None if summary.low is None else {"low": summary.low, "high": summary.high},
        "ages": summary.ages,
        "unknown": summary.unknown if seen.setup.unknown is Unknown.FORBIDDEN else None,
        "primitives": summary.primitives,
        "sensors": sensors,
        "unread_meshes": [] if seen.body is None else seen.body.unread,
        "not_used": {**perception.counters, **summary.dropped},
    }


def _lines(report: dict[str, Any]) -> list[str]:
    lines = [f"{report['robot']}: {report['voxels']} voxels of {report['voxel_size']:g} m"]
    if report["extent"] is not None:
        pairs = zip("xyz", report["extent"]["low"], report["extent"]["high"], strict=True)
        extent = "  ".join(f"{axis} {low:.2f}..{high:.2f}" for axis, low, high in pairs)
        least, median, greatest = report["ages"]
        lines[0] += f" in {report['frame']}: {extent} m"
        lines.append(f"last seen {least:.1f} to {greatest:.1f} s ago, half of them at most {median:.1f} s")
    if report["unknown"] is not None:
        lines.append(f"unknown space is forbidden: {report['unknown']} voxels at its surface")
    if report["primitives"]:
        lines.append(f"primitives: {report['primitives']}")
    for sensor in report["sensors"]:
        latency = 1000.0 * sensor["latency"]
        lines.append(
            f"{sensor['sensor']:24} in {sensor['frame']:20} {sensor['used']:5} used, seen {latency:.0f} ms later"
        )
    if not report["sensors"]:
        lines.append("no sensor measured anything: does the robot publish clouds (--cloud), or have a lidar?")
    if report["unread_meshes"]:
        lines.append(f"not filtered out, as their meshes cannot be read: {', '.join(report['unread_meshes'])}")
    lines += [f"not used: {count} {reason}" for reason, count in report["not_used"].items() if count]
    return lines
