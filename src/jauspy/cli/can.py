"""`jauspy can`: list the drives on a CAN bus, simulate drives and their faults, and home drives."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from importlib.util import find_spec
from typing import TYPE_CHECKING, Annotated, Any, Final

import typer

from jauspy.backends.can.cia402 import LIMIT_ACTIVE, error_text, register_text, state_of
from jauspy.backends.can.faults import DriveFault
from jauspy.cli import console
from jauspy.cli.options import Bus, Json, World, on_bus
from jauspy.cli.processes import stoppable
from jauspy.errors import ConfigError
from jauspy.platform.servo_drives import CanSetup
from jauspy.robot import robot_files

if TYPE_CHECKING:
    import canopen

    from jauspy.platform.description import RobotModel

Robot = Annotated[
    str, typer.Argument(metavar="ROBOT", help="The robot's name, as in inc1, or the path of its .toml file.")
]

NODE_BITS: Final = 0x7F
SERVICES: Final = frozenset({0x180, 0x280, 0x580, 0x700})
"""Identifiers without the node, of the frames by which nodes are found and read."""

SCAN_TIME: Final = 0.5
"""Seconds in which drives answer a scan."""


def _robot(name: str, bus: str | None) -> tuple[RobotModel, CanSetup]:
    """The robot and its drives; raises `ConfigError`."""
    missing = [package for package in ("can", "canopen") if find_spec(package) is None]
    if missing:
        raise ConfigError("`jauspy can` needs python-can and canopen: pip install 'jauspy[can]'")
    model = robot_files.robot_model(on_bus(robot_files.load(name), bus))
    if model.can is None:
        raise ConfigError(f"{name} has no drives on CAN: its file has no table [can] (docs/hardware.md)")
    if isinstance(model.can, str):
        raise ConfigError(model.can)
    return model, model.can


@contextmanager
def _network(setup: CanSetup) -> Iterator[canopen.Network]:
    """Open the bus of a robot from another process; raises `ConfigError` for a bus inside the robot's process."""
    import can
    import canopen

    from jauspy.backends.can import bus as buses
    from jauspy.backends.can.inbox import deviation

    if buses.split(setup.bus)[0] == buses.VIRTUAL:
        raise ConfigError(
            f"{setup.bus} is inside the robot's process; give a bus that others can use, as in "
            "--bus udp_multicast:239.0.0.1"
        )
    bus = buses.open_bus(setup.bus, setup.bit_rate)
    network = canopen.Network(bus)

    def receive(message: can.Message) -> None:
        if not deviation(message) and (message.arbitration_id & ~NODE_BITS in SERVICES):
            network.notify(message.arbitration_id, message.data, message.timestamp)

    receiver = buses.Receiver(
        bus,
        receive,
        lambda why: console.note(f"{setup.bus}: {why}"),
        errors_forgeable=buses.split(setup.bus)[0] in buses.OPEN,
    )
    try:
        yield network
    except (can.CanError, OSError) as error:
        raise ConfigError(f"{setup.bus} takes no frames: {buses.describe(error)}") from error
    finally:
        receiver.close()
        bus.shutdown()


def drives(*, robot: Robot, bus: Bus = None, as_json: Json = False) -> None:
    """List the nodes on a robot's bus: state, error, voltage, firmware.

    Drives of the robot that do not answer are listed, too. Nothing is changed.
    The exit status is 1 if a drive of the robot does not answer or is in Fault.

    Example:
      jauspy can drives inc1 --bus socketcan:can0
    """
    _, setup = _robot(robot, bus)
    with _network(setup) as network:
        rows = _scan(network, setup)
    if as_json:
        for row in rows:
            console.print_json(row)
    else:
        console.print_table(HEADER, [_cells(row) for row in rows])
    if any(row["state"] in {"no answer", "Fault"} for row in rows):
        raise typer.Exit(1)


def _scan(network: canopen.Network, setup: CanSetup) -> list[dict[str, Any]]:
    import time

    network.scanner.search()
    time.sleep(SCAN_TIME)
    names = {drive.node: name for name, drive in setup.drives.items()}
    found = sorted({*network.scanner.nodes, *names} - {setup.node})
    return [_row(network, setup, node, names.get(node, ""), node in network.scanner.nodes) for node in found]


def _row(network: canopen.Network, setup: CanSetup, node: int, name: str, answers: bool) -> dict[str, Any]:
    import canopen
    from canopen.sdo.exceptions import SdoError

    row: dict[str, Any] = {"node": node, "drive": name, "moves": setup.drives[name].moves if name else ""}
    if not answers:
        return row | {"state": "no answer"}
    from jauspy.backends.can.configuration import read_object

    sdo: Any = network.add_node(node, canopen.ObjectDictionary()).sdo

    def read(index: int, sub: int = 0) -> bytes | None:
        try:
            return read_object(sdo, index, sub)
        except SdoError:
            return None

    def number(index: int, sub: int = 0) -> int | None:
        data = read(index, sub)
        return None if data is None else int.from_bytes(data, "little")

    def text(index: int) -> str:
        return (read(index) or b"").decode("latin-1").strip("\0 ")

    status, register = number(0x6041), number(0x1001) or 0
    row["state"] = "no drive (no CiA 402)" if status is None else _state(status)
    row["error"] = error_text(number(0x603F) or 0)
    row["register"] = register_text(register)
    row["voltage"] = None if (millivolts := number(0x6079)) is None else millivolts / 1e3
    index = setup.drives[name].temperature if name else None
    row["temperature"] = None if index is None or (tenths := number(index)) is None else tenths / 10.0
    return row | {"serial": number(0x1018, 4), "device": text(0x1008), "firmware": text(0x100A)}


def _state(status: int) -> str:
    return state_of(status).value + (", limit active" if status & LIMIT_ACTIVE else "")


HEADER: Final = ("node", "drive", "state", "volt", "degC", "serial", "device", "firmware", "error")


def _cells(row: dict[str, Any]) -> list[str]:
    volt, heat = (f"{row[key]:.1f}" if row.get(key) is not None else "-" for key in ("voltage", "temperature"))
    more = (str(row.get(key) or "-") for key in ("serial", "device", "firmware", "error"))
    return [str(row["node"]), row["drive"] or "-", row["state"], volt, heat, *more]


def simulate(
    *,
    robot: Robot,
    bus: Bus = None,
    behind: Annotated[
        str,
        typer.Option("--behind", metavar="NAME", help="What the drives move: motors, or the robot of a backend: sim."),
    ] = "motors",
    world: World = None,
) -> None:
    """Simulate all drives of a robot on a CAN bus, until Ctrl-C.

    They are CANopen nodes with CiA 402.

    Example:
      jauspy can simulate inc1 --bus udp_multicast:239.0.0.1
      jauspy up inc1 --backend can --bus udp_multicast:239.0.0.1      (in another terminal)
    """
    model, setup = _robot(robot, bus)
    from jauspy.backends.can import bus as buses
    from jauspy.backends.can.simulated.fleet import MOTORS, RealTimeFleet, plant_of

    if buses.split(setup.bus)[0] == buses.VIRTUAL:
        raise ConfigError(
            f"{setup.bus} is inside the robot's process, which simulates its drives itself; give a bus that others can "
            "use, as in --bus udp_multicast:239.0.0.1"
        )
    if world is not None and behind == MOTORS:
        behind = "sim"
    plant = plant_of(behind, model, setup, world or "empty")
    opened = buses.open_bus(setup.bus, setup.bit_rate)
    fleet = RealTimeFleet(model, setup, opened, plant)
    with stoppable() as exit_status:
        try:
            console.print_lines(
                f"{len(setup.drives)} simulated drives on {setup.bus}, {behind} behind them",
                f"drive it:  jauspy up {robot} --backend can --bus {setup.bus}",
                f"see them:  jauspy can drives {robot} --bus {setup.bus}",
                f"break one: jauspy can fault {next(iter(setup.drives))} overcurrent --robot {robot} --bus {setup.bus}",
                "stop it:   Ctrl-C",
            )
            fleet.run()
        except KeyboardInterrupt:
            raise typer.Exit(exit_status()) from None
        finally:
            fleet.fleet.close()
            opened.shutdown()


def home(*, robot: Robot, bus: Bus = None) -> None:
    """Have drives search for their home positions, one after the other. Joints move.

    It moves the drives that have `homing` and lost their position; those with absolute encoders need none. A drive
    keeps its home position until it loses power. Stop the robot's program first: two masters on a bus are dangerous.
    Ctrl-C stops.

    Example:
      jauspy can home my_robot.toml --bus socketcan:can0
    """
    model, setup = _robot(robot, bus)
    if not any(drive.homing for drive in setup.drives.values()):
        console.note(f"no drive of {robot} needs homing: their encoders are absolute (can.drives.NAME.homing)")
        return
    from jauspy.backends.can import bus as buses
    from jauspy.backends.can.robot import CanRobot

    if buses.split(setup.bus)[0] == buses.VIRTUAL:
        raise ConfigError(f"{setup.bus} is inside the robot's process, and its simulated drives need no homing")
    moved: list[str] = []

    def tell(text: str) -> None:
        moved.append(text)
        console.print_lines(text)

    try:
        CanRobot(model, setup, setup.bus, "empty", lambda master: master.home(tell)).close()
    except DriveFault as error:
        raise ConfigError(f"can: {error}") from error
    except KeyboardInterrupt:
        raise typer.Exit(130) from None
    console.note(f"{len(moved)} drives have moved; all drives have their home positions")


def fault(
    *,
    drive: Annotated[str, typer.Argument(metavar="DRIVE", help="Name or node id of a simulated drive.")],
    what: Annotated[
        str,
        typer.Argument(
            metavar="FAULT",
            help="overcurrent, overvoltage, undervoltage, overtemperature, encoder or blocked; or silent, deaf (to "
            "SYNC), restart, normal.",
        ),
    ],
    robot: Annotated[
        str, typer.Option("--robot", metavar="ROBOT", help="The robot that the drive belongs to.")
    ] = "inc1",
    bus: Bus = None,
) -> None:
    """Make a simulated drive fail.

    Real drives reject this.

    Example:
      jauspy can fault arm_2 overcurrent --bus udp_multicast:239.0.0.1
    """
    _, setup = _robot(robot, bus)
    import canopen
    from canopen.sdo.exceptions import SdoAbortedError, SdoError

    from jauspy.backends.can.simulated.drive import BEHAVIOUR_OBJECT, BEHAVIOURS, FAULT_OBJECT, FAULTS

    node = int(drive) if drive.isdigit() else getattr(setup.drives.get(drive), "node", None)
    if node is None or not 1 <= node <= 126:
        raise ConfigError(f"no drive {drive!r}; {robot} has: {', '.join(setup.drives)}; or give a node id, 1..126")
    if what not in FAULTS and what not in BEHAVIOURS:
        raise ConfigError(f"no fault {what!r}; there are: {', '.join([*FAULTS, *BEHAVIOURS])}")
    with _network(setup) as network:
        sdo: Any = network.add_node(node, canopen.ObjectDictionary()).sdo
        try:
            if what in FAULTS:
                sdo.download(FAULT_OBJECT, 0, FAULTS[what][0].to_bytes(2, "little"))
            else:
                sdo.download(BEHAVIOUR_OBJECT, 0, bytes((BEHAVIOURS[what],)))
        except SdoAbortedError as error:
            raise ConfigError(f"node {node} refuses: it is not a simulated drive ({error})") from error
        except SdoError as error:
            raise ConfigError(f"node {node} does not answer on {setup.bus}") from error
    console.note(f"node {node}: {what}")
