"""Options that several verbs share."""

from __future__ import annotations

import math
import re
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from jauspy.errors import ConfigError

if TYPE_CHECKING:
    from jauspy.robot.config import RobotConfig

DEFAULT_PORT = 3794
DEFAULT_ROOT = Path("/tmp")  # noqa: S108 # nosec B108 # where JuniorRTE of the JAUS Toolset has its sockets

Port = Annotated[int, typer.Option("--port", min=1, max=65535, help="UDP port; 3794 is registered for JAUS.")]
LocalRoot = Annotated[
    Path, typer.Option("--local-root", metavar="DIR", help="Directory of the local sockets (JuniorRTE).")
]
Address = Annotated[
    str, typer.Option("--address", metavar="IP", help="Local address to receive UDP on; 0.0.0.0 is all.")
]
DEFAULT_ADDRESS = "0.0.0.0"  # noqa: S104 # nosec B104 # a node manager receives from other machines; --address restricts it
MulticastGroup = Annotated[
    str, typer.Option("--multicast-group", metavar="IP", help="Group that broadcasts are sent to.")
]
DEFAULT_GROUP = "239.255.0.1"
Interface = Annotated[
    list[str] | None,
    typer.Option("--interface", metavar="IP", help="Address of an interface to join the group on; may be repeated."),
]
SocketMode = Annotated[
    str,
    typer.Option(
        "--socket-mode",
        metavar="OCTAL",
        help="Permissions of the local socket, which decide who may attach a component. 660: user and group.",
    ),
]
DEFAULT_MODE = "660"
Verbose = Annotated[bool, typer.Option("--verbose", "-v", help="Log what is dropped and why.")]
OwnRoot = Annotated[
    bool, typer.Option("--own-root", hidden=True, help="Remove the local root at the end if it is empty.")
]
Connect = Annotated[
    str | None,
    typer.Option(
        "--connect",
        metavar="WHERE",
        help="How to reach the node manager: udp://HOST:PORT, tcp://HOST:PORT or local:DIR. "
        "Default: the one in /tmp if it runs, else multicast.",
    ),
]
OwnId = Annotated[
    str | None,
    typer.Option(
        "--id", metavar="ID", help="This client's JAUS id. Default: 42.1.2, or the next one that is not in use."
    ),
]
OperatorKey = Annotated[
    Path | None,
    typer.Option(
        "--operator-key",
        metavar="FILE",
        envvar="JAUSPY_OPERATOR_KEY",
        help="The key of an operator (`jauspy keys new`), which seals what is commanded.",
    ),
]
Peer = Annotated[
    str | None,
    typer.Option(
        "--peer",
        metavar="jts|fkie|openjaus",
        help="The other side is this implementation: oblige it, or mark what is known of it (docs/doctor.md).",
    ),
]
Timeout = Annotated[float, typer.Option("--timeout", min=0.01, metavar="SECONDS", help="How long to wait for answers.")]
Json = Annotated[bool, typer.Option("--json", help="One JSON object per line.")]
FilterOption = Annotated[
    str | None,
    typer.Option(
        "--filter",
        metavar="EXPRESSION",
        help="Only messages that fit, as in 'src == 42.* and msg == Report* and x > 5' (docs/filters.md).",
    ),
]
Bus = Annotated[
    str | None,
    typer.Option(
        "--bus",
        metavar="INTERFACE:CHANNEL",
        help="The CAN bus, as python-can names it: socketcan:can0, slcan:/dev/ttyACM0, udp_multicast:239.0.0.1 "
        "(without authentication: each machine that receives it can move the drives); "
        "virtual:motors, virtual:kinematic or virtual:sim are simulated drives in the robot's process, and what they "
        "move. Default: that of the robot's file.",
    ),
]
WithParent = Annotated[
    bool,
    typer.Option("--with-parent", hidden=True, help="End when standard input closes, as it does when the parent dies."),
]


def file_mode(text: str) -> int:
    """`0o660` for `660`; raises `typer.BadParameter`."""
    if re.fullmatch("0?[0-7]{3}", text):
        return int(text, 8)
    raise typer.BadParameter(
        f"{text!r} is not a file mode; write three octal digits, as in 660", param_hint="--socket-mode"
    )


ClusterOption = Annotated[
    str | None,
    typer.Option(
        "--cluster",
        metavar="ADDRESS",
        help="Spread the work over the Dask cluster of this scheduler, tcp://HOST:PORT; `local` starts workers here. "
        "What a lost worker did is done again by another one.",
    ),
]
Authority = Annotated[int, typer.Option("--authority", min=0, max=255, help="Authority with which control is taken.")]
World = Annotated[
    str | None,
    typer.Option(
        "--world",
        metavar="NAME|FILE",
        help="The world of the simulation: a name, or the path of a file with MJCF (.xml), SDF (.sdf, .world) or a "
        "list of objects (.toml). Default: the robot's own.",
    ),
]
ModelPath = Annotated[
    list[Path] | None,
    typer.Option(
        "--model-path",
        metavar="DIRECTORY",
        help="Where models of an SDF world are searched first; may be repeated.",
    ),
]


def on_bus(config: RobotConfig, bus: str | None) -> RobotConfig:
    """The robot with its drives on this bus; that of its file if None. Raises `ConfigError` if it has no drives."""
    if bus is None:
        return config
    if config.can is None:
        raise ConfigError(f"--bus: {config.name} has no table [can] in its file, and so no drives (docs/hardware.md)")
    return config.model_copy(update={"can": replace(config.can, bus=bus)})


def numbers_of(text: str, option: str, wanted: str, example: str) -> tuple[float, ...]:
    """The finite numbers of an option, as many as in its example.

    Raises `BadParameter`, which says what is `wanted`, as in "x,y in metres", and shows the example.
    """
    try:
        numbers = tuple(map(float, text.split(",")))
    except ValueError:
        numbers = ()
    if len(numbers) != len(example.split(",")) or not all(map(math.isfinite, numbers)):
        raise typer.BadParameter(f"{text!r}: write {wanted}, as in {example}", param_hint=option)
    return numbers
