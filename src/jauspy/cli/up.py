"""`jauspy up`: run a robot, and a node manager if none runs."""

from __future__ import annotations

import asyncio
import json
import math
import signal
import sys
from collections.abc import AsyncIterator, Collection, Mapping, Sequence
from contextlib import AbstractAsyncContextManager, AsyncExitStack, asynccontextmanager
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import Annotated, Any, Final

import typer

from jauspy import backends
from jauspy.cli import console
from jauspy.cli.beside import (
    CONSOLE_PORT,
    MAX_AFTER,
    MAX_BEFORE,
    RECORDINGS,
    chosen_options,
    console_beside,
    flight_recorder_beside,
)
from jauspy.cli.options import (
    DEFAULT_ADDRESS,
    DEFAULT_GROUP,
    DEFAULT_MODE,
    DEFAULT_PORT,
    DEFAULT_ROOT,
    Address,
    Bus,
    Interface,
    LocalRoot,
    ModelPath,
    MulticastGroup,
    OwnRoot,
    Port,
    SocketMode,
    Verbose,
    WithParent,
    World,
    file_mode,
    on_bus,
)
from jauspy.cli.processes import ChildFailed, ChildProcess, end_with_parent, remove_if_empty, run
from jauspy.errors import ConfigError
from jauspy.ids import JausID
from jauspy.node.config import load_config
from jauspy.platform import backend as platform_backend
from jauspy.platform.camera import Quality
from jauspy.platform.contacts import Contacts
from jauspy.platform.contract import PartId, Snapshot
from jauspy.platform.lights import TimeOfDay
from jauspy.platform.localization import Localization
from jauspy.platform.sound import LoudspeakerSetup
from jauspy.printable import printable
from jauspy.protocol import junior
from jauspy.robot import robot_files
from jauspy.robot.cloud import Clouds
from jauspy.robot.config import RobotConfig
from jauspy.robot.realtime import MAX_STEP, STEP
from jauspy.robot.runner import RobotRunner, in_real_time
from jauspy.robot.several import FurtherRobot, further_robots, shared_backends
from jauspy.robot.traffic_log import LogPlace, TrafficLog
from jauspy.transport import LocalTransport, local as local_socket

Backend = Annotated[
    str | None,
    typer.Option(
        "--backend",
        metavar="NAME",
        help=f"What moves the robot; installed: {', '.join(backends.names())}. sim is MuJoCo physics (extra 'sim'), "
        "kinematic is pure Python without obstacles, can is servo drives on a CAN bus (extra 'can'). "
        "Default: the robot's own.",
    ),
]


LAST_SUBSYSTEM: Final = 65534
CONNECT_TIMEOUT: Final = 15.0
"""Seconds in which the node manager must have accepted a component: many robots may be starting on this machine."""


def up(
    *,
    robot: Annotated[
        str, typer.Argument(metavar="ROBOT", help="The robot's name, as in inc1, or the path of its .toml file.")
    ],
    subsystem: Annotated[
        int | None,
        typer.Option(
            "--id",
            min=1,
            max=LAST_SUBSYSTEM,
            metavar="SUBSYSTEM",
            help="The robot's subsystem id, as for a second robot of one kind. Default: the robot's own.",
        ),
    ] = None,
    also: Annotated[
        list[str] | None,
        typer.Option(
            "--also",
            metavar="ROBOT[:SUBSYSTEM][@X,Y[,DEGREES]]",
            help="Another robot in the same world, as in inc1:102 or inc1:102@-3,0; may be repeated. Default: the next "
            "free subsystem, behind the robot before it.",
        ),
    ] = None,
    backend: Backend = None,
    bus: Bus = None,
    port: Port = DEFAULT_PORT,
    address: Address = DEFAULT_ADDRESS,
    local_root: LocalRoot = DEFAULT_ROOT,
    socket_mode: SocketMode = DEFAULT_MODE,
    multicast_group: MulticastGroup = DEFAULT_GROUP,
    interface: Interface = None,
    world: World = None,
    model_path: ModelPath = None,
    time_of_day: Annotated[
        TimeOfDay | None,
        typer.Option("--time-of-day", help="The light in the simulation. Default: the robot's own."),
    ] = None,
    quality: Annotated[
        Quality | None,
        typer.Option(
            "--quality",
            help="Simulated camera pictures: low has no shadows, high also smooth edges. Default: the robot's own.",
        ),
    ] = None,
    view: Annotated[
        bool, typer.Option("--view", help="Open MuJoCo's window on the simulation; needs a display.")
    ] = False,
    step: Annotated[
        float,
        typer.Option(
            "--step",
            min=STEP,
            max=MAX_STEP,
            metavar="SECONDS",
            help="Time between two steps of the robot, in which it takes commands and measures; longer ones cost less, "
            "as for many robots on one machine.",
        ),
    ] = STEP,
    no_node_manager: Annotated[
        bool, typer.Option("--no-node-manager", help="Do not start a node manager; wait for one in the local root.")
    ] = False,
    gateway: Annotated[
        Path | None,
        typer.Option(
            "--gateway",
            metavar="FILE",
            help="Run a gateway in front of the robot: a node manager with this configuration file.",
        ),
    ] = None,
    cloud: Annotated[
        list[str] | None,
        typer.Option(
            "--cloud",
            metavar="[SOURCE=]ADDRESS",
            help="Publish the point clouds of all lidars, or of one lidar or depth camera, at an address such as "
            "tcp://127.0.0.1:5565; "
            "may be repeated.",
        ),
    ] = None,
    with_console: Annotated[
        bool, typer.Option("--console", help="Also run the operator's console in the browser (extra 'console').")
    ] = False,
    console_port: Annotated[
        int, typer.Option("--console-port", min=0, max=65535, help="The port of its page; 0 is any free one.")
    ] = CONSOLE_PORT,
    audit_log: Annotated[
        Path | None,
        typer.Option(
            "--audit-log",
            metavar="FILE",
            help="Record commands in this file, which may be anywhere. Default: the robot's own, below its folder.",
        ),
    ] = None,
    announcements: Annotated[
        Path | None,
        typer.Option(
            "--announcements",
            metavar="FOLDER",
            help="Keep what its loudspeakers play as WAV files in this folder. Default: that of its file.",
        ),
    ] = None,
    audit_heads_to: Annotated[
        str | None,
        typer.Option(
            "--audit-heads-to",
            metavar="URL",
            help="Send the heads of the audit log to another machine, so that changes of all lines are noticed: "
            "syslog://HOST:PORT (UDP) or syslog+tcp://HOST:PORT.",
        ),
    ] = None,
    record_on: Annotated[
        str | None,
        typer.Option(
            "--record-on",
            metavar="KINDS",
            help="Run a flight recorder, which writes a file on emergency, control-lost or failure; several are "
            "separated by commas.",
        ),
    ] = None,
    before: Annotated[
        float | None,
        typer.Option(
            "--before", min=0.0, max=MAX_BEFORE, metavar="SECONDS", help="What it records before. Default: 30."
        ),
    ] = None,
    after: Annotated[
        float | None,
        typer.Option("--after", min=0.0, max=MAX_AFTER, metavar="SECONDS", help="What it records after. Default: 10."),
    ] = None,
    record_to: Annotated[
        Path | None,
        typer.Option(
            "--record-to",
            metavar="DIR",
            help="Folder of its files, and of the logs that a client in control switches on by DataLogging. Default: "
            "the robot's own, else recordings.",
        ),
    ] = None,
    plain: Annotated[
        bool, typer.Option("--plain", help="Print lines of text and no live table, as in a pipe and with --verbose.")
    ] = False,
    verbose: Verbose = False,
    with_parent: WithParent = False,
    own_root: OwnRoot = False,
) -> None:
    """Run a robot, and a node manager if none runs in the local root.

    The robot is in Standby until a client takes control and resumes it. The options for addresses and sockets are those
    of the node manager that is started. With --gateway they are in its configuration file, no other node manager may
    run, and it routes and filters between its networks (see `jauspy node-manager --print-config`). On a terminal a live
    table shows modules, cameras and the node manager. SIGUSR1 prints all counters,
    and the true pose of a simulated robot; Ctrl-C stops all processes in order. Robots of --also are in the same world,
    where they see and touch each other (backend sim); --console, --cloud and --record-on are for the first one.

    Examples:
      jauspy up inc1 --backend kinematic
      jauspy up inc1 --id 102
      jauspy up inc1 --also inc1 --world street
      jauspy up inc1 --record-on emergency,control-lost,failure --before 30 --after 10
    """
    file_mode(socket_mode)
    if verbose:
        console.log_to_stderr("DEBUG")
    if with_parent:
        end_with_parent()
    config = on_bus(robot_files.load(robot), bus)
    changes: dict[str, object] = {"subsystem": subsystem, "time_of_day": time_of_day, "quality": quality}
    if model_path:
        changes["model_path"] = (*map(str, model_path), *config.model_path)
    if announcements is not None:
        changes["loudspeakers"] = with_folder(config.loudspeakers, announcements)
    config = config.model_copy(update={key: value for key, value in changes.items() if value is not None})
    folder = record_to or (Path(config.record_to) if config.record_to is not None else RECORDINGS)
    flight = chosen_options(record_on, before, after, folder)
    check_ids_are_free(config, robot, local_root)
    if also and gateway is not None:
        raise ConfigError("--gateway is for one robot; leave out --also, or start a gateway of its own")
    others = _further(config, also or (), changes, local_root)
    clouds = Clouds(config, cloud or ())
    backends_of_all = shared_backends(config, others, backend) if others else (backend,)

    def runner_of(config: RobotConfig, backend: platform_backend.Backend | str | None, **options: Any) -> RobotRunner:
        return RobotRunner(
            config,
            lambda component: LocalTransport(component, local_root, timeout=CONNECT_TIMEOUT),
            backend=backend,
            world=world or first_world,
            traffic_log=TrafficLog(LogPlace(config.subsystem, local_root, folder)),
            realtime=partial(in_real_time, step=step),
            **options,
        )

    first_world = config.world if others else None
    runner = runner_of(config, backends_of_all[0], view=view, audit_log=audit_log, audit_heads_to=audit_heads_to)
    further = [runner_of(other.config, own) for other, own in zip(others, backends_of_all[1:], strict=True)]
    if bus is not None and runner.config.backend != CAN:
        raise ConfigError(f"--bus is for the backend can; this one is {runner.config.backend}")
    if world is not None and runner.config.backend == KINEMATIC:
        raise ConfigError("the backend kinematic has no worlds; leave out --world, or use another backend")
    if gateway is not None:
        configured = gateway_port(gateway, config.subsystem, local_root, starts=not no_node_manager)
        port = configured if port == DEFAULT_PORT else port
        options = ["--config", str(gateway)]
    else:
        options = ["--address", address, "--multicast-group", multicast_group, "--socket-mode", socket_mode]
        for placed in (config, *(other.config for other in others)):
            for node_id in placed.nodes:
                options += ["--own-ids", f"{placed.subsystem}.{node_id}.*"]
        for name in interface or ():
            options += ["--interface", name]
    options += ["--verbose"] * verbose
    node = None if no_node_manager else node_manager(local_root, port, options)
    live = not (plain or verbose or others) and console.is_interactive()
    page = console_beside(local_root, console_port, config.subsystem) if with_console else None
    recorder = flight_recorder_beside(flight, config.subsystem, local_root) if flight else None
    run(run_robot(runner, node, local_root, clouds, further=further, live=live, page=page, recorder=recorder))
    if own_root:
        remove_if_empty(local_root)


def _further(
    first: RobotConfig, also: Sequence[str], changes: Mapping[str, object], root: Path
) -> tuple[FurtherRobot, ...]:
    """The robots of `--also`, in the light and quality of the first one."""
    shared = {key: value for key, value in changes.items() if value is not None and key != "subsystem"}
    found = [replace(other, config=other.config.model_copy(update=shared)) for other in further_robots(first, also)]
    for other in found:
        if taken := _taken(other.config, other.config.subsystem, root):
            raise ConfigError(f"--also: {', '.join(map(str, taken))} of {other.config.name} are in use in {root}")
    return tuple(found)


def check_ids_are_free(config: RobotConfig, robot: str, root: Path) -> None:
    """Raise `ConfigError` if a component of this machine has the id of one of the robot's modules."""
    taken = _taken(config, config.subsystem, root)
    if taken:
        free = (number for number in range(config.subsystem + 1, LAST_SUBSYSTEM) if not _taken(config, number, root))
        raise ConfigError(
            f"{', '.join(map(str, taken))} {'are' if len(taken) > 1 else 'is'} in use in {root}: {config.name} is up, "
            f"or another robot with its id; a second one needs its own: `jauspy up {robot} --id {next(free, 1)}`"
        )


def _taken(config: RobotConfig, subsystem: int, root: Path) -> list[JausID]:
    """The ids of the robot's modules in this subsystem that components of this machine have."""
    ids = [replace(config.id_of(module), subsystem=subsystem) for module in config.modules]
    return [id for id in ids if local_socket.is_alive(root / str(int(id)))]


KINEMATIC: Final = "kinematic"
CAN: Final = "can"
_DRIVE: Final = "jauspy send {} SetWrenchEffort propulsive_linear_effort_x=40 --control 200 --hold 2"

LONG_CONTROL_TIMEOUT: Final = 30
"""Seconds; a module with a longer access control timeout, in which it keeps obeying a client that has died, causes a
warning."""


def print_summary(runner: RobotRunner, where: str, root: Path, page: str = "", records: str = "") -> None:
    """Print what runs, and commands to try."""
    config = runner.config
    first = runner.components[0].id
    pairs = runner.running
    discoverable = any(module.offers("Discovery") for module in config.modules)
    driven = [pair.id for pair, module in pairs if module.offers("Discovery") and module.offers("PrimitiveDriver")]
    connect = "" if root == DEFAULT_ROOT else f" --connect local:{root}"
    sealed = " --operator-key NAME.key" if config.operators and config.require_operator else ""
    world = "" if config.backend == KINEMATIC else f", world {config.world}"
    faults = runner.faults.items()
    lines = [
        f"{config.name} {_is_up(runner.faults)}: subsystem {config.subsystem}, backend {config.backend}{world}",
        *(f"  {pair.id}  {module.type}{f' {module.part}' if module.part else ''}" for pair, module in pairs),
        *(f"failed:    {id}: {printable(why)}; `jauspy send {id} Reset{connect}` tries again" for id, why in faults),
        f"  node manager: {where}",
        *([f"  audit log: {runner.audit.path}, head {runner.audit.head}"] if runner.audit else []),
        *[f"records:   {printable(records)}"] * bool(records),
        *[f"console:   {page}"] * bool(page),
        *[f"see it:    jauspy ls{connect}"] * discoverable,
        f"ask it:    jauspy query {first} QueryStatus{connect}",
        *(f"drive it:  {_DRIVE.format(id)}{connect}{sealed}" for id in driven),
        *_warnings(config),
        "stop it:   Ctrl-C",
    ]
    console.print_lines(*lines)


def print_further(runner: RobotRunner) -> None:
    """Print what runs of a robot beside the first one."""
    config = runner.config
    console.print_lines(
        f"{config.name} {_is_up(runner.faults)}: subsystem {config.subsystem}, in the same world",
        *(f"  {pair.id}  {module.type}{f' {module.part}' if module.part else ''}" for pair, module in runner.running),
        *_warnings(config),
    )


def _is_up(faults: Collection[str]) -> str:
    """States that the robot runs, and which of its modules are in Failure."""
    if not faults:
        return "is up"
    return f"is up, but {', '.join(faults)} {'are' if len(faults) > 1 else 'is'} in Failure"


def with_folder(loudspeakers: Sequence[LoudspeakerSetup], folder: Path) -> tuple[LoudspeakerSetup, ...]:
    """Loudspeakers that keep what they play in a folder; raises `ConfigError` for one that cannot be used."""
    if not loudspeakers:
        raise ConfigError("--announcements: the robot has no loudspeakers")
    if not (folder if folder.exists() else folder.absolute().parent).is_dir():
        raise ConfigError(f"--announcements {folder}: is no folder, and none can be made there")
    return tuple(replace(loudspeaker, folder=str(folder.resolve())) for loudspeaker in loudspeakers)


def note_audit_log(runner: RobotRunner) -> None:
    """Print the head of the audit log, with which later truncation can be detected."""
    if runner.audit is not None:
        console.note(f"audit log {runner.audit.path}: head {runner.audit.head}")


def _warnings(config: RobotConfig) -> list[str]:
    """Warnings of modules whose access control timeout is long or off, and of operators who are not required."""
    found = []
    if config.operators is not None and not config.require_operator:
        found.append("warning:   commands without the seal of an operator are taken: require_operator = false")
    for module in config.modules:
        timeout = module.access_control.timeout
        if module.kind.moved(module) is not None and not 0 < timeout <= LONG_CONTROL_TIMEOUT:
            how_long = f"for {timeout} s" if timeout else "without limit"
            found.append(
                f"warning:   {config.id_of(module)} keeps moving {how_long} after its client died: "
                f"access_control.timeout = {timeout}"
            )
    return found


RESTART_DELAY: Final = 1.0
"""Seconds from the end of a node manager to its restart, and between two checks whether one runs."""


@asynccontextmanager
async def node_manager(root: Path, port: int, options: Sequence[str] = ()) -> AsyncIterator[NodeSupervisor]:
    """Start a node manager if none runs in this local root, and restart it when it ends, whoever started it.

    `options` are further options of `jauspy node-manager`.
    """
    supervisor = NodeSupervisor(root, port, options)
    if not supervisor.is_running():
        await supervisor.start()
    watching = asyncio.create_task(supervisor.run())
    try:
        yield supervisor
    finally:
        watching.cancel()
        await asyncio.gather(watching, return_exceptions=True)
        await supervisor.stop()


class NodeSupervisor:
    """Starts a node manager whenever none runs in a local root."""

    def __init__(self, root: Path, port: int, options: Sequence[str] = ()) -> None:
        self.where = f"was running, local sockets in {root}"
        """Addresses, to be printed."""
        self._root = root
        self._port = port
        self._options = tuple(options)
        self._socket = root / junior.SOCKET_NAME
        self._child: ChildProcess | None = None

    @property
    def is_own(self) -> bool:
        """True if the node manager that runs was started here."""
        return self._child is not None

    def print_counters(self) -> None:
        """Let the node manager print its counters, if it was started here."""
        if self._child is not None:
            self._child.signal(signal.SIGUSR1)

    def is_running(self) -> bool:
        """True if a node manager runs, whoever started it."""
        return local_socket.is_alive(self._socket)

    async def start(self) -> None:
        """Start a node manager; raises `ChildFailed`."""
        arguments = ["node-manager", "--port", str(self._port), "--local-root", str(self._root), *self._options]
        child = ChildProcess("node manager", arguments, on_error_line=_forward)
        await child.__aenter__()
        self._child = child
        self.where = f"UDP port {self._port}, local sockets in {self._root}"

    async def stop(self) -> None:
        """End the node manager if it was started here."""
        if self._child is not None:
            await self._child.stop()

    async def run(self) -> None:
        """Restart the node manager whenever it ends, until cancelled."""
        if self._child is None:
            await self._wait_until_none_runs()
            console.note("the node manager that was running has ended; starting one")
        last_error = ""
        while True:
            if self._child is not None:
                console.note(f"{await self._child.ended()}; starting it again")
                self._child = None
                await asyncio.sleep(RESTART_DELAY)
            await self._wait_until_none_runs()
            try:
                await self.start()
            except ChildFailed as error:
                if str(error) != last_error and not self.is_running():  # else another process started one first
                    console.error(last_error := str(error))
                await asyncio.sleep(RESTART_DELAY)

    async def _wait_until_none_runs(self) -> None:
        """Wait for the end of a node manager that another process started; no event reports it."""
        while self.is_running():  # noqa: ASYNC110
            await asyncio.sleep(RESTART_DELAY)


def gateway_port(path: Path, subsystem: int, root: Path, *, starts: bool) -> int:
    """The port in a gateway's configuration file; raises `ConfigError` unless it fits this robot."""
    config = load_config(path)
    if config.gateway is None:
        raise ConfigError(f"{path}: has no [gateway]; `jauspy node-manager --print-config` prints an example")
    if config.gateway.subsystem != subsystem:
        raise ConfigError(f"{path}: gateway.subsystem = {config.gateway.subsystem}: the robot is subsystem {subsystem}")
    if not starts:
        raise ConfigError("--gateway starts a node manager; leave out --no-node-manager")
    if local_socket.is_alive(root / junior.SOCKET_NAME):
        raise ConfigError(f"--gateway: a node manager runs in {root} already; stop it, or choose another --local-root")
    return config.port


def _forward(line: str) -> None:
    console.print_lines(f"node manager: {line}", file=sys.stderr)


def print_truth(name: str, snapshot: Snapshot | None) -> None:
    """Print what a simulation knows: the true pose unless the robot's own is exact, and what its joints touched."""
    if snapshot is None:
        return
    if PartId(Localization) in snapshot.parts:
        pose = snapshot.pose
        where = f"x {pose.x:+.3f} m  y {pose.y:+.3f} m  z {pose.z:+.3f} m  yaw {math.degrees(pose.yaw):+.2f}°"
        tilt = f"pitch {math.degrees(pose.pitch):+.2f}°  roll {math.degrees(pose.roll):+.2f}°"
        console.print_if_read(f"true pose of {name}: {where}  {tilt}", file=sys.stderr)
    if isinstance(counts := snapshot.parts.get(PartId(Contacts)), Mapping):
        touched = json.dumps({group: dict(bodies) for group, bodies in counts.items()})
        console.print_if_read(f"contacts of {name}: {touched}", file=sys.stderr)


async def run_robot(
    runner: RobotRunner,
    node: AbstractAsyncContextManager[NodeSupervisor] | None,
    root: Path,
    clouds: Clouds,
    *,
    further: Sequence[RobotRunner] = (),
    live: bool,
    page: AbstractAsyncContextManager[str] | None = None,
    recorder: AbstractAsyncContextManager[str] | None = None,
) -> None:
    """Run the robot until cancelled.

    `node` starts and stops the node manager, `page` the console, `recorder` the flight recorder; `live` shows a table
    on the terminal. `further` are other robots in the same world, which end with the first one, and it with them.
    """
    if live:  # before the motors are enabled, which the import would hold up
        from jauspy.cli.up_table import live_table
    async with AsyncExitStack() as stack:

        def note_at_end(text: str) -> None:
            if live:
                stack.callback(console.note, text)

        note_at_end("everything has stopped")
        supervisor = await stack.enter_async_context(node) if node else None
        if supervisor is not None and supervisor.is_own:
            note_at_end("stopping the node manager")

        def print_all_counters() -> None:
            for number, one in enumerate(runners):
                name = one.config.name if not further else f"{one.config.name} {one.config.subsystem}"
                print_truth(name, one.snapshot)
                counters = one.counters if number else {**one.counters, **clouds.counters}
                console.print_counters(counters, f"counters of {name}:")
            if supervisor is not None:
                supervisor.print_counters()

        runners = (runner, *further)
        for one in runners:
            stack.callback(note_audit_log, one)
            await stack.enter_async_context(one)
        note_at_end("stopping the modules, the cameras and the robot")
        asyncio.get_running_loop().add_signal_handler(signal.SIGUSR1, print_all_counters)
        url = await stack.enter_async_context(page) if page else ""
        records = await stack.enter_async_context(recorder) if recorder else ""
        where = supervisor.where if supervisor else f"none started, local sockets in {root}"
        for one in further:
            print_further(one)
        print_summary(runner, where, root, url, records)
        await stack.enter_async_context(clouds.published(runner))
        if live:
            await stack.enter_async_context(live_table(runner, root))
        await _wait_for_any(runners)


async def _wait_for_any(runners: Sequence[RobotRunner]) -> None:
    """Wait until cancelled, or until one of the robots has ended, whose exception is raised."""
    tasks = [asyncio.ensure_future(runner.wait()) for runner in runners]
    try:
        done, _ = await asyncio.wait(tasks, return_when=asyncio.FIRST_COMPLETED)
        for task in done:
            task.result()
    finally:
        for task in tasks:
            task.cancel()
        await asyncio.gather(*tasks, return_exceptions=True)
