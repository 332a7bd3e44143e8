"""`jauspy new robot`: a first TOML file for somebody's URDF."""

from __future__ import annotations

from collections import Counter
from pathlib import Path
from typing import Annotated

import typer

from jauspy.cli import console
from jauspy.cli.new import write_new
from jauspy.errors import ConfigError
from jauspy.geometry.urdf import UNGUIDED, parse_tree
from jauspy.modules import robot_files
from jauspy.modules.first_file import first_file, relative
from jauspy.modules.package_paths import PackagePaths


def robot(
    *,
    urdf: Annotated[Path, typer.Argument(metavar="URDF", help="The URDF or xacro file.")],
    output: Annotated[
        Path | None,
        typer.Option("-o", "--output", metavar="FILE", help="Default: NAME.toml here, with the name of the URDF file."),
    ] = None,
    package_path: Annotated[
        list[Path] | None,
        typer.Option(
            "--package-path",
            metavar="DIRECTORY",
            help="Where the packages of package:// and $(find ...) are searched first; may be repeated.",
        ),
    ] = None,
    argument: Annotated[
        list[str] | None,
        typer.Option("--arg", metavar="NAME:=VALUE", help="An argument of the xacro file; may be repeated."),
    ] = None,
    subsystem: Annotated[int, typer.Option("--subsystem", min=1, max=65534, help="Its JAUS id.")] = 101,
) -> None:
    """Write a first TOML file for a robot of which there is a URDF only, so that it moves in the simulation.

    Groups are made of the chains of joints; wheels, gains, missing limits, lidars and cameras are guessed, and marked.

    Example:
      jauspy new robot husky.urdf.xacro --arg laser_enabled:=true
    """
    arguments = dict(_argument(each) for each in argument or ())
    path = output or Path(f"{urdf.name.split('.')[0]}.toml")
    given = tuple(package_path or ())
    description = robot_files.read_urdf(str(urdf), PackagePaths(given), arguments)
    extra: dict[str, object] = {}
    if given:
        extra["package_path"] = [relative(each, path.parent) for each in given]
    if arguments:
        extra["xacro_arguments"] = arguments
    write_new({path: first_file(description, relative(urdf, path.parent), subsystem, extra)})
    if passed_over := _passed_over(description.urdf):
        console.print_lines(f"passed over in the URDF: {passed_over}")
    try:
        robot_files.robot_model(robot_files.load(path.absolute()))
    except ConfigError as error:
        console.error(f"{path} needs a correction: {error}")
        raise typer.Exit(1) from None
    console.print_lines(f"run it:  jauspy up {path}", f"in another world:  jauspy up {path} --world yard")


def _passed_over(urdf: str) -> str:
    """The elements of other programs, and joints that are taken as fixed."""
    root = parse_tree(urdf)
    tags = Counter(str(each.tag) for each in root.iterchildren("gazebo", "transmission", "ros2_control"))
    parts = [f"{count} <{tag}>" for tag, count in tags.items()]
    unguided = [str(each.get("name")) for each in root.iterchildren("joint") if each.get("type") in UNGUIDED]
    return ", ".join(parts + [f"joint {name} moves freely in the URDF, and is fixed here" for name in unguided])


def _argument(text: str) -> tuple[str, str]:
    name, found, value = text.partition(":=")
    if not found or not name:
        raise typer.BadParameter(f"{text!r} is not NAME:=VALUE", param_hint="--arg")
    return name, value
