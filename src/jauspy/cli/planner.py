"""`jauspy planner`: run a planner of an arm's motions beside a robot."""

from __future__ import annotations

import asyncio
from collections.abc import Sequence
from contextlib import AbstractAsyncContextManager, AsyncExitStack
from dataclasses import dataclass
from importlib.util import find_spec
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Final

import typer

from jauspy.cli import client, console
from jauspy.cli.options import Authority, Connect, OperatorKey, OwnId, Timeout
from jauspy.cli.processes import run
from jauspy.cli.scene import UnknownSpace
from jauspy.errors import ConfigError
from jauspy.ids import JausID
from jauspy.ocu import OCU
from jauspy.ocu.robot import Robot
from jauspy.printable import printable
from jauspy.robot import robot_files
from jauspy.robot.config import RobotConfig
from jauspy.robot.robot_files import robot_model

if TYPE_CHECKING:
    from jauspy.planning.execution import PlannedArm
    from jauspy.planning.robot_planner import Surroundings
    from jauspy.platform.description import RobotModel

COMPONENT: Final = 130
"""Component of the planner on the node of the arm."""

ArmArgument = Annotated[str, typer.Argument(metavar="ARM", help="The component that moves the arm, as in 101.1.104.")]
Primitives = Annotated[
    Path | None, typer.Option("--primitives", metavar="FILE", help="Boxes, spheres and cylinders, as TOML or JSON.")
]
Unknown = Annotated[UnknownSpace, typer.Option("--unknown", help="What space means that no sensor has looked into.")]
Clouds = Annotated[
    list[str] | None,
    typer.Option(
        "--cloud",
        metavar="ADDRESS",
        help="Where point clouds are published; may be repeated. Default: those of the robot's file.",
    ),
]
Sensors = Annotated[
    bool, typer.Option("--sensors/--no-sensors", help="Whether it plans around what the robot's sensors see.")
]
Description = Annotated[
    str | None,
    typer.Option(
        "--description", metavar="ROBOT", help="Name or .toml file of the robot. Default: the name that it reports."
    ),
]


@dataclass(frozen=True, slots=True)
class Choices:
    """The arm, and what the planner is to know."""

    arm: JausID
    description: str | None
    primitives: Path | None
    unknown: UnknownSpace
    clouds: Sequence[str]
    sensors: bool
    authority: int
    max_wait: float

    @property
    def is_default(self) -> bool:
        """True if nothing was chosen that a planner elsewhere may not know."""
        return self.primitives is None and self.unknown is UnknownSpace.FREE and self.sensors and not self.clouds


def planner(
    *,
    target: ArmArgument,
    component: Annotated[
        int, typer.Option("--component", min=1, max=254, help="Component number of the planner, on the arm's node.")
    ] = COMPONENT,
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
) -> None:
    """Plan motions of a robot's arm around obstacles for operators (service MotionPlanner), until Ctrl-C.

    The planner becomes a component of the robot. It sees what the robot's depth cameras and lidars see, and what
    --primitives lists. It has the arm move over JAUS, and takes control of it while it moves: an operator controls the
    planner instead of the arm. `jauspy reach` and the console use it.

    Examples:
      jauspy planner 101.1.104
      jauspy planner 101.1.104 --primitives table.toml --unknown forbidden
    """
    choices = Choices(arm_id(target), description, primitives, unknown, cloud or (), sensors, authority, timeout)
    need_packages()
    ocu = client.make_ocu(own_id, connect, timeout, operator=operator_key)
    run(_serve(ocu, choices, component, connect))


async def _serve(ocu: OCU, choices: Choices, component: int, connect: str | None) -> None:
    from jauspy.planning.component import planner_component

    id = JausID(choices.arm.subsystem, choices.arm.node, component)
    async with AsyncExitStack() as stack:
        await stack.enter_async_context(ocu)
        robot = await ocu.discover(id.subsystem, timeout=choices.max_wait)
        planned = await stack.enter_async_context(own_planner(robot, choices))
        await stack.enter_async_context(planner_component(id, planned, connect=connect))
        console.note(f"{id} plans motions of {choices.arm}; Ctrl-C ends it")
        await asyncio.Event().wait()


def own_planner(robot: Robot, choices: Choices) -> AbstractAsyncContextManager[PlannedArm]:
    """A planner in this process."""
    from jauspy.planning.robot_planner import planned_arm

    model, surroundings = surroundings_of(robot, choices)
    return planned_arm(robot, choices.arm, model, surroundings, authority=choices.authority)


def surroundings_of(robot: Robot, choices: Choices) -> tuple[RobotModel, Surroundings]:
    """The description of a robot, and the sources of what is known about its surroundings."""
    from jauspy.planning import scene
    from jauspy.planning.robot_planner import Surroundings
    from jauspy.planning.scene_files import put_primitives

    config, primitives = _configuration(robot, choices.description), choices.primitives
    surroundings = Surroundings(
        put=lambda seen: None if primitives is None else put_primitives(seen, primitives),
        unknown=scene.Unknown(choices.unknown.value),
        has_sensors=choices.sensors,
        clouds=choices.clouds or [source.address for source in config.clouds],
        movers=config.movers,
    )
    return robot_model(config), surroundings


def arm_id(text: str) -> JausID:
    """The component of an arm; `ConfigError` for wildcards."""
    id = client.destination(text)
    if id.is_wildcard:
        raise ConfigError(f"{id} has wildcards; name the component that moves the arm, as in 101.1.104")
    return id


def need_packages() -> None:
    """Raise `ConfigError` without the packages of planning."""
    if missing := [name for name in ("numpy", "ompl", "coal", "ruckig", "scipy", "pynng") if find_spec(name) is None]:
        raise ConfigError(f"planning needs {', '.join(missing)}: pip install 'jauspy[planning]'")


def _configuration(robot: Robot, name: str | None) -> RobotConfig:
    """The robot's file of that name, else of the robot's own name."""
    if name is None and robot.name not in robot_files.known():
        raise ConfigError(
            f"subsystem {robot.id} reports the name {printable(robot.name)!r}, of which jauspy has no description; "
            "give its file, as in --description my_robot.toml"
        )
    return robot_files.load(name or robot.name)
