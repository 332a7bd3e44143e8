"""`jauspy up`: a robot, with a node manager when none runs."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from jauspy.cli.options import (
    DEFAULT_ADDRESS,
    DEFAULT_GROUP,
    DEFAULT_MODE,
    DEFAULT_PORT,
    DEFAULT_ROOT,
    Address,
    Interface,
    LocalRoot,
    MulticastGroup,
    OwnRoot,
    Port,
    SocketMode,
    Verbose,
    WithParent,
)

Backend = Annotated[
    str | None,
    typer.Option(
        "--backend",
        metavar="NAME",
        help="sim: MuJoCo physics (extra 'sim'); kinematic: pure Python, without obstacles; or that of an installed "
        "package. Default: the robot's own.",
    ),
]


def up(
    *,
    robot: Annotated[
        str, typer.Argument(metavar="ROBOT", help="The robot's name, as in inc1, or the path of its .toml file.")
    ],
    backend: Backend = None,
    port: Port = DEFAULT_PORT,
    address: Address = DEFAULT_ADDRESS,
    local_root: LocalRoot = DEFAULT_ROOT,
    socket_mode: SocketMode = DEFAULT_MODE,
    multicast_group: MulticastGroup = DEFAULT_GROUP,
    interface: Interface = None,
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
    cloud: Annotated[
        list[str] | None,
        typer.Option(
            "--cloud",
            metavar="[CAMERA=]ADDRESS",
            help="Publish the lidars' point clouds there, as in tcp://127.0.0.1:5565, or those of a depth camera; "
            "may be repeated.",
        ),
    ] = None,
    plain: Annotated[
        bool, typer.Option("--plain", help="Only lines of text, no live table, as in a pipe and with --verbose.")
    ] = False,
    verbose: Verbose = False,
    with_parent: WithParent = False,
    own_root: OwnRoot = False,
) -> None:
    """Run a robot, and a node manager when none runs in the local root.

    The robot stands in Standby until a client takes control and resumes it. The options on addresses and sockets are
    those of the node manager that is started; with --gateway its configuration file has them, no other node manager
    may run, and it connects and filters its networks (see `jauspy node-manager --print-config`). On a terminal a live
    table shows modules, cameras and node manager. SIGUSR1 prints all counters, Ctrl-C ends everything in order.

    Example:
      jauspy up inc1 --backend kinematic
    """
    from jauspy.cli import console
    from jauspy.cli.local_node import gateway_port, node_manager
    from jauspy.cli.node_manager import mode_of
    from jauspy.cli.node_serve import log_everything
    from jauspy.cli.run import end_with_parent, remove_if_empty, run
    from jauspy.cli.up_run import run_robot
    from jauspy.cli.up_tell import KINEMATIC
    from jauspy.errors import ConfigError
    from jauspy.modules import robots
    from jauspy.modules.cloud import Clouds
    from jauspy.modules.robot import RobotRunner
    from jauspy.transport import LocalTransport

    mode_of(socket_mode)
    if verbose:
        log_everything()
    if with_parent:
        end_with_parent()
    config = robots.load(robot)
    clouds = Clouds(config, cloud or ())
    runner = RobotRunner(
        config,
        lambda component: LocalTransport(component, local_root),
        backend=backend,
        world=world,
    )
    if world is not None and runner.config.backend == KINEMATIC:
        raise ConfigError("the backend kinematic is an empty plane and has no worlds; leave out --world, or use sim")
    if gateway is not None:
        in_file = gateway_port(gateway, config.subsystem, local_root, starts=not no_node_manager)
        port = in_file if port == DEFAULT_PORT else port
        options = ["--config", str(gateway)]
    else:
        options = ["--address", address, "--multicast-group", multicast_group, "--socket-mode", socket_mode]
        for each in interface or ():
            options += ["--interface", each]
    options += ["--verbose"] * verbose
    node = None if no_node_manager else node_manager(local_root, port, options)
    live = not (plain or verbose) and console.is_interactive()
    run(run_robot(runner, node, local_root, clouds, live=live))
    if own_root:
        remove_if_empty(local_root)
