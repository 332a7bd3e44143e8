"""`jauspy up`: a robot, with a node manager when none runs."""

from __future__ import annotations

from contextlib import AsyncExitStack
from enum import StrEnum
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Final

import typer

from jauspy.cli.options import DEFAULT_PORT, DEFAULT_ROOT, LocalRoot, Port, WithParent

if TYPE_CHECKING:
    from jauspy.modules.robot import RobotRunner


_DRIVE: Final = "jauspy send {} SetWrenchEffort propulsive_linear_effort_x=40 --control 200 --hold 2"


class BackendName(StrEnum):
    """What moves the robot."""

    SIM = "sim"
    KINEMATIC = "kinematic"


Backend = Annotated[
    BackendName | None,
    typer.Option(
        "--backend",
        help="sim: MuJoCo physics (extra 'sim'); kinematic: pure Python, without obstacles. Default: the robot's own.",
    ),
]


def up(
    *,
    robot: Annotated[
        str, typer.Argument(metavar="ROBOT", help="The robot's name, as in inc1, or the path of its .toml file.")
    ],
    backend: Backend = None,
    port: Port = DEFAULT_PORT,
    local_root: LocalRoot = DEFAULT_ROOT,
    world: Annotated[
        str | None, typer.Option("--world", metavar="NAME", help="The world it stands in. Default: the robot's own.")
    ] = None,
    no_node_manager: Annotated[
        bool, typer.Option("--no-node-manager", help="Start no node manager; wait for one in the local root.")
    ] = False,
    gateway: Annotated[
        Path | None,
        typer.Option(
            "--gateway", metavar="FILE", help="Put a gateway before it: a node manager with this configuration file."
        ),
    ] = None,
    with_parent: WithParent = False,
) -> None:
    """Run a robot, and a node manager when none runs in the local root.

    The robot stands in Standby until a client takes control and resumes it. Ctrl-C ends everything in order. With
    --gateway the node manager connects and filters the networks of its configuration file (see `jauspy node-manager
    --print-config`), and no other may run.

    Example:
      jauspy up inc1 --backend kinematic
    """
    from jauspy.cli.run import end_with_parent, run
    from jauspy.modules import robots
    from jauspy.modules.robot import RobotRunner
    from jauspy.transport import LocalTransport

    config = robots.load(robot)
    if gateway is not None:
        from jauspy.cli.local_node import check_gateway

        check_gateway(gateway, config.subsystem, local_root, starts=not no_node_manager)
    if with_parent:
        end_with_parent()
    runner = RobotRunner(
        config,
        lambda component: LocalTransport(component, local_root),
        backend=None if backend is None else backend.value,
        world=world,
    )
    run(_up(runner, local_root, None if no_node_manager else port, gateway))


async def _up(runner: RobotRunner, root: Path, port: int | None, gateway: Path | None) -> None:
    """Run the robot until cancelled; `port` is for the node manager, None for none."""
    from jauspy.cli.local_node import node_manager

    async with AsyncExitStack() as stack:
        where = f"none started, local sockets in {root}"
        if port is not None:
            where = await stack.enter_async_context(node_manager(root, port, gateway))
        async with runner:
            _tell(runner, where, root)
            await runner.run()


def _tell(runner: RobotRunner, where: str, root: Path) -> None:
    """What runs, and how to talk to it."""
    config = runner.config
    first = runner.components[0].id
    connect = "" if root == DEFAULT_ROOT else f" --connect local:{root}"
    lines = [
        f"{config.name} is up: subsystem {config.subsystem}, backend {config.backend}, world {config.world}",
        *(
            f"  {component.id}  {module.type}"
            for component, module in zip(runner.components, config.modules, strict=True)
        ),
        f"  node manager: {where}",
        f"see it:    jauspy ls{connect}",
        f"ask it:    jauspy query {first} QueryStatus{connect}",
        *([f"drive it:  {_DRIVE.format(first)}{connect}"] if config.modules[0].offers("PrimitiveDriver") else ()),
        "stop it:   Ctrl-C",
    ]
    print(*lines, sep="\n", flush=True)
