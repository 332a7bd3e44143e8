"""All simulated drives of a robot on one bus: on the robot's own time in its process, or in real time in another."""

from __future__ import annotations

import threading
import time
from collections.abc import Callable
from functools import cache
from importlib.resources import as_file, files
from typing import Any, Final

import can
from canopen.objectdictionary import import_od

from jauspy import backends
from jauspy.backends.can import pdo
from jauspy.backends.can.bus import Port
from jauspy.backends.can.inbox import deviation
from jauspy.backends.can.simulated.axes import MotorPlant, Plant, RobotPlant
from jauspy.backends.can.simulated.drive import SimulatedDrive
from jauspy.backends.can.units import DriveUnits
from jauspy.backends.kinematic import WORLDS
from jauspy.errors import ConfigError
from jauspy.logs import get_logger
from jauspy.platform.description import RobotModel
from jauspy.platform.servo_drives import CanSetup

_LOG: Final = get_logger("jauspy.can")

MOTORS: Final = "motors"
"""The plant that is not another backend."""

REAL_STEP: Final = 0.005
"""Seconds that simulated drives in real time wait for a frame, at most."""

UNREADABLE_PAUSE: Final = 0.0005
"""Seconds from an error in reading to the next try."""

MAX_STEP: Final = 0.02
"""Seconds that the plant advances at once; what is more is skipped."""


@cache
def dictionary() -> Any:
    """The object dictionary of a simulated drive, from its EDS file."""
    with as_file(files("jauspy.backends.can") / "simulated" / "drive.eds") as path:
        return import_od(str(path))


def plant_of(name: str, model: RobotModel, setup: CanSetup, world: str) -> Plant:
    """`motors`, or the robot of an installed backend; raises `ConfigError`."""
    if name == MOTORS:
        if world not in WORLDS:
            raise ConfigError(f"motors have no world {world!r}; the worlds are: {', '.join(WORLDS)}")
        return MotorPlant(model, setup.drives)
    if name == "can":
        raise ConfigError("simulated drives cannot move the robot of the backend can; choose motors, kinematic or sim")
    return RobotPlant(backends.find(name).open(model, world), model, setup)


class DriveFleet:
    """The drives, their plant, and their end of the bus."""

    def __init__(
        self, model: RobotModel, setup: CanSetup, plant: Plant, port: Port, *, keeps_home: bool = False
    ) -> None:
        """`keeps_home`: restarted drives know their home positions, because nothing could have them search."""
        self.plant = plant
        self.network = port.network()
        self._port = port
        self._now = 0.0
        self.ignored = 0
        """Frames that no drive could take."""
        self.drives: dict[str, SimulatedDrive] = {}
        for name, item in setup.drives.items():
            units = DriveUnits(item, model.description.joint(item.moves))
            drive = SimulatedDrive(item, units, plant.axes[name], dictionary(), self.network)
            drive.keeps_home = keeps_home
            self.drives[name] = drive
        self.network.subscribe(pdo.SYNC, self._on_sync)
        self.network.subscribe(pdo.HEARTBEAT + setup.node, lambda *_: None)
        self.step(0.0)
        for drive in self.drives.values():
            drive.boot()

    def receive(self, message: can.Message) -> None:
        """Take a frame; one that no drive can take is counted, and ignored."""
        if deviation(message):
            self.ignored += 1
            return
        try:
            self.network.notify(message.arbitration_id, message.data, message.timestamp)
        except Exception as error:  # noqa: BLE001 - canopen unpacks frames of any length, and raises what it likes
            self.ignored += 1
            _LOG.debug("a frame was ignored: %s", error)

    def _on_sync(self, *_: Any) -> None:
        for drive in self.drives.values():
            drive.on_sync()

    def step(self, dt: float) -> None:
        """Let `dt` seconds pass."""
        if dt:
            self.plant.advance(dt)
        self._now += dt
        for drive in self.drives.values():
            drive.step(self._now)
        self._port.step(self._now)

    def close(self) -> None:
        """Release the plant."""
        self._port.shutdown()
        self.plant.close()


class RealTimeFleet:
    """A fleet on a bus of python-can, in a thread, between `open` and `close`."""

    def __init__(self, model: RobotModel, setup: CanSetup, bus: can.BusABC, plant: Plant) -> None:
        self._bus = bus
        self.fleet = DriveFleet(model, setup, plant, Port(self._send))
        self._closing = threading.Event()
        self._thread = threading.Thread(target=self.run, name="simulated drives", daemon=True)

    def open(self) -> None:
        """Start the thread."""
        self._thread.start()

    def close(self) -> None:
        """End the thread."""
        self._closing.set()
        if self._thread.is_alive():
            self._thread.join()

    def _send(self, message: can.Message) -> None:
        try:
            self._bus.send(message)
        except (can.CanError, OSError) as error:
            _LOG.debug("a frame of a simulated drive was lost: %s", error)

    def _receive(self) -> can.Message | None:
        try:
            return self._bus.recv(REAL_STEP)
        except Exception as error:  # noqa: BLE001 - drivers raise what they like: foreign datagrams, no adapter
            _LOG.warning("a frame of the CAN bus cannot be read: %s", error)
            time.sleep(UNREADABLE_PAUSE)
            return None

    def run(self, until: Callable[[], bool] = lambda: False) -> None:
        """Receive frames, and let the plant follow the clock, until closed."""
        clock = time.monotonic
        last = clock()
        while not self._closing.is_set() and not until():
            message = self._receive()
            if message is not None:
                self.fleet.receive(message)
            now = clock()
            is_sync = message is not None and message.arbitration_id == pdo.SYNC
            if is_sync or now - last >= REAL_STEP:
                self.fleet.step(min(now - last, MAX_STEP))
                last = now
