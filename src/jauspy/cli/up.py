"""`jauspy up`: a robot, with a node manager when none runs."""

from __future__ import annotations

from enum import StrEnum
from typing import Annotated

import typer

from jauspy.cli.options import DEFAULT_PORT, DEFAULT_ROOT, LocalRoot, Port, WithParent


class BackendName(StrEnum):
    """What moves the robot."""

    SIM = "sim"
    KINEMATIC = "kinematic"


Backend = Annotated[
    BackendName,
    typer.Option("--backend", help="sim: MuJoCo physics (extra 'sim'); kinematic: pure Python, without obstacles."),
]


def up(
    *,
    robot: Annotated[str, typer.Argument(metavar="ROBOT", help="The robot's name, as in inc1.")],
    backend: Backend = BackendName.SIM,
    port: Port = DEFAULT_PORT,
    local_root: LocalRoot = DEFAULT_ROOT,
    world: Annotated[str, typer.Option("--world", metavar="NAME", help="The world the robot stands in.")] = "demo",
    no_node_manager: Annotated[
        bool, typer.Option("--no-node-manager", help="Never start a node manager; wait for the one in the local root.")
    ] = False,
    with_parent: WithParent = False,
) -> None:
    """Run a robot, and a node manager when none runs in the local root.

    The robot stands in Standby until a client takes control and resumes it. Ctrl-C ends everything in order.

    Example:
      jauspy up inc1 --backend kinematic
    """
