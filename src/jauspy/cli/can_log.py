"""Explains logs of CAN frames (candump and other formats of python-can) for `jauspy decode`: PDOs in SI units."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from importlib.util import find_spec
from pathlib import Path
from typing import Any, Final

from jauspy.backends.can import pdo
from jauspy.backends.can.cia402 import Controlword, Mode, error_text, register_text, state_of
from jauspy.backends.can.units import DriveUnits
from jauspy.errors import ConfigError
from jauspy.geometry.urdf import JointKind
from jauspy.platform.description import RobotModel
from jauspy.platform.servo_drives import CanSetup, DriveSetup
from jauspy.printable import printable

CANDUMP: Final = re.compile(rb"\(\d+\.\d+\) +\S+ +[0-9A-Fa-f]+#")
"""The first line of a file that `candump -l` writes."""

SUFFIXES: Final = frozenset({".asc", ".blf", ".trc"})
"""Suffixes of other formats of python-can."""

NUMBER: Final = re.compile(r"-?\d+\.\d+")

NMT: Final = {1: "start", 2: "stop", 128: "enter Pre-operational", 129: "reset", 130: "reset communication"}
STATES: Final = {0: "has started", 4: "Stopped", 5: "Operational", 127: "Pre-operational"}
POSITIONS: Final = frozenset({0x6064, 0x607A})
VELOCITIES: Final = frozenset({0x606C, 0x60FF})
TORQUES: Final = frozenset({0x6071, 0x6077})


@dataclass(frozen=True, slots=True)
class CanFrame:
    """One frame. `time` is in seconds since 1970, UTC; `text` explains it."""

    time: float
    identifier: int
    data: bytes
    text: str
    channel: str = ""

    def as_json(self) -> dict[str, Any]:
        """The frame as a JSON object."""
        return {
            "time": self.time,
            "channel": self.channel or None,
            "can_id": f"{self.identifier:03X}",
            "hex": self.data.hex(),
            "text": self.text,
        }


def is_can_log(source: str) -> bool:
    """True for the path of a file with CAN frames."""
    path = Path(source)
    try:
        if not path.is_file():
            return False
        with path.open("rb") as file:
            return path.suffix.lower() in SUFFIXES or CANDUMP.match(file.read(200)) is not None
    except OSError:
        return False


def can_frames(source: str, robot: str) -> Iterator[CanFrame]:
    """The frames, named by the drives of `robot`. Raises `ConfigError`."""
    if find_spec("can") is None:
        raise ConfigError("CAN logs need python-can: pip install 'jauspy[can]'")
    import can

    from jauspy.robot import robot_files

    model = robot_files.robot_model(robot_files.load(robot))
    if model.can is None or isinstance(model.can, str):
        raise ConfigError(model.can or f"{robot} has no table [can] in its file")
    names = FrameNames(model, model.can)
    reader = can.CanutilsLogReader if Path(source).suffix.lower() not in SUFFIXES else can.LogReader
    try:
        with reader(source) as frames:
            for frame in frames:
                data = bytes(frame.data)
                what = "error frame" if frame.is_error_frame else names.explain(frame.arbitration_id, data)
                channel = "" if frame.channel is None else str(frame.channel)
                yield CanFrame(frame.timestamp, frame.arbitration_id, data, printable(what), channel)
    except (ValueError, OSError, IndexError) as error:
        raise ConfigError(f"{source}: is not a log of CAN frames: {error}") from error


def changes(frames: Iterable[CanFrame]) -> Iterator[CanFrame]:
    """The frames whose content differs from the last frame of the same identifier in more than the size of a number.

    A number that becomes zero or changes its sign is such a difference.
    """
    said: dict[int, str] = {}
    for frame in frames:
        gist = NUMBER.sub(lambda found: _sign(float(found[0])), frame.text)
        if said.get(frame.identifier) != gist:
            said[frame.identifier] = gist
            yield frame


def _sign(number: float) -> str:
    return "0" if not number else "+" if number > 0.0 else "-"


class FrameNames:
    """Explains the frames of one robot."""

    def __init__(self, model: RobotModel, setup: CanSetup) -> None:
        self._node = setup.node
        self._drives: Mapping[int, tuple[DriveSetup, DriveUnits, str]] = {
            drive.node: (drive, DriveUnits(drive, joint), "m" if joint.kind is JointKind.PRISMATIC else "rad")
            for drive in setup.drives.values()
            for joint in (model.description.joint(drive.moves),)
        }
        self._pdos = {mapping.cob_id: mapping for mapping in pdo.ALL}

    def explain(self, identifier: int, data: bytes) -> str:
        """An explanation of one frame; unknown content as bytes in hex."""
        function, node = identifier & 0x780, identifier & 0x7F
        if identifier == pdo.SYNC:
            return "SYNC"
        if identifier == 0 and len(data) >= 2:
            return f"NMT {NMT.get(data[0], data[0])}: {self._name(data[1]) if data[1] else 'all'}"
        if function == pdo.EMCY and len(data) >= 3:
            code = int.from_bytes(data[:2], "little")
            return f"{self._name(node)}: emergency: {error_text(code)}, error register: {register_text(data[2])}"
        if function == pdo.HEARTBEAT and data:
            return f"{self._name(node)}: heartbeat: {STATES.get(data[0] & 0x7F, data[0])}"
        if function in {pdo.SDO_REQUEST, 0x580} and len(data) == 8:
            what = "request" if function == pdo.SDO_REQUEST else "response"
            index = int.from_bytes(data[1:3], "little")
            return f"{self._name(node)}: SDO {what} {index:04X}h:{data[3]:02X} {data[4:].hex(' ')}"
        found = self._pdos.get(function)
        if found is not None and node in self._drives and len(data) == found.layout.size:
            way = "command" if function in {mapping.cob_id for mapping in pdo.COMMANDS.values()} else "status"
            values = ", ".join(self._values(found, node, data))
            return f"{self._name(node)}: {way}: {values}"
        return data.hex(" ")

    def _name(self, node: int) -> str:
        if node == self._node:
            return "the robot"
        found = self._drives.get(node)
        return f"{found[0].name} ({node})" if found else f"node {node}"

    def _values(self, found: pdo.Pdo, node: int, data: bytes) -> Iterator[str]:
        _, units, unit = self._drives[node]
        for (index, _bits), raw in zip(found.objects, found.layout.unpack(data), strict=True):
            name = pdo.NAMES[index]
            if index in POSITIONS:
                yield f"{name} {units.position(raw):.4f} {unit}"
            elif index in VELOCITIES:
                yield f"{name} {units.velocity(raw):.4f} {unit}/s"
            elif index in TORQUES:
                yield f"{name} {units.effort(raw):.3f} {'N' if unit == 'm' else 'N m'}"
            elif index == 0x6041:
                yield state_of(raw).value
            elif index == 0x6040:
                yield Controlword(raw).name.lower() if raw in set(Controlword) else f"controlword {raw:04X}h"
            elif index == 0x603F:
                yield error_text(raw)
            else:
                yield Mode(raw).name.lower() if raw in set(Mode) else f"mode {raw}"
