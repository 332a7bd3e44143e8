"""Configures a drive over SDO: identity, PDOs, reaction to the loss of the robot, limits. Blocks."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import Any, Final

import can
import canopen
from canopen.sdo.exceptions import SdoAbortedError, SdoCommunicationError, SdoError

from jauspy.backends.can import pdo
from jauspy.backends.can.bus import describe
from jauspy.backends.can.cia402 import HOMING_ATTAINED, HOMING_ERROR, Controlword, Mode
from jauspy.backends.can.drive import LIMIT_MARGIN, Drive
from jauspy.backends.can.faults import DriveFault
from jauspy.geometry.urdf import JointKind
from jauspy.logs import get_logger
from jauspy.platform.joint_control import ACCELERATION_TIME
from jauspy.platform.servo_drives import CanSetup

_LOG: Final = get_logger("jauspy.can")

PROFILE: Final = 402
"""The low half of the device type (1000h) of a drive with CiA 402."""

SDO_TIMEOUT: Final = 0.3
SDO_TRIES: Final = 4

NO_ANSWER: Final = "No SDO response received"
"""The text of canopen's error."""

MAX_ANSWERS: Final = 8
"""Answers of a node that wait; canopen reads one, and drops the others."""

MAX_OBJECT: Final = 256
"""Bytes of an object that are read."""

MODE_READS: Final = 20
"""Reads of the mode until the drive shows the one that was written."""

PRODUCED: Final = 0.2
"""Time between two heartbeats of a drive, as a fraction of the time after which it counts as lost."""

CYCLIC_MODES: Final = 0b111 << 7
CYCLIC_VELOCITY: Final = 0b1 << 8
PROFILE_POSITION: Final = 0b1
"""Bits of the supported modes (6502h)."""

SIZES: Final = {
    0x1017: 2, 0x605A: 2, 0x605E: 2, 0x6007: 2, 0x6040: 2, 0x6060: 1, 0x6066: 2, 0x6072: 2, 0x6098: 1, 0x60C2: 1
}  # fmt: skip
"""Bytes of objects; others have 4."""


@dataclass(frozen=True, slots=True)
class ObjectSetting:
    """A value that an object of the drive must have."""

    index: int
    sub: int
    value: int
    why: str = ""
    """The purpose, for an object that the drive may lack; empty for a required one."""


class Configurator:
    """Configures drives, one after the other."""

    def __init__(self, network: canopen.Network, setup: CanSetup) -> None:
        self._network = network
        self._setup = setup
        self._asked: tuple[int, Any] | None = None
        """The node that is configured now, and its client."""

    def configure(self, drive: Drive) -> None:
        """Bring a drive to Pre-operational, check it, and write its settings. Raises `DriveFault`."""
        sdo = self._client(drive)
        self._asked = drive.setup.node, sdo
        try:
            self._network.send_message(0, bytes((0x80, drive.setup.node)))  # NMT: Pre-operational
            check_identity(sdo, drive)
            if _read(sdo, 0x6041, 0) & 0x04:  # enabled by whoever was here before
                _write(sdo, 0x6040, 0, Controlword.DISABLE_VOLTAGE, 2)
            for setting in self._settings(drive):
                _set(sdo, setting, drive)
            for wanted in pdo.ALL:
                _map(sdo, wanted, drive)
            drive.homed = drive.setup.homing is None or is_homed(sdo)
        except SdoCommunicationError as error:
            if str(error) != NO_ANSWER:
                raise DriveFault(
                    f"{drive.name} gives wrong answers on {self._setup.bus} ({error}): another program sends as this "
                    "node, or two drives have its node id"
                ) from error
            raise DriveFault(
                f"{drive.name} does not answer on {self._setup.bus}: check its supply, node id, bit rate "
                f"({self._setup.bit_rate}), wiring and termination"
            ) from None
        except SdoAbortedError as error:
            raise DriveFault(f"{drive.name} refuses its configuration: {error}") from error
        except (can.CanError, OSError) as error:
            raise DriveFault(f"{self._setup.bus} takes no frames: {describe(error)}") from error
        finally:
            self._asked = None

    def receive_answer(self, node: int, data: bytes) -> bool:
        """Take an answer of a node; False if it was not asked, or has answered more often than it was."""
        if self._asked is None or self._asked[0] != node:
            return False
        answers = self._asked[1].responses
        if answers.qsize() >= MAX_ANSWERS:
            return False
        answers.put(data)
        return True

    def _client(self, drive: Drive) -> Any:
        node: Any = self._network.nodes.get(drive.setup.node)
        if node is None:
            node = self._network.add_node(drive.setup.node, canopen.ObjectDictionary())
        node.sdo.RESPONSE_TIMEOUT, node.sdo.MAX_RETRIES = SDO_TIMEOUT, SDO_TRIES
        return node.sdo

    def _settings(self, drive: Drive) -> Iterator[ObjectSetting]:
        setup, units, joint = self._setup, drive.units, drive.joint
        timeout = round(1e3 * setup.heartbeat_timeout)
        yield ObjectSetting(0x1016, 1, setup.node << 16 | timeout)
        yield ObjectSetting(0x1017, 0, round(1e3 * setup.heartbeat_timeout * PRODUCED))
        yield ObjectSetting(0x6007, 0, 1, "a lost heartbeat is a fault")
        yield ObjectSetting(0x605E, 0, 2, "a fault stops by the quick stop ramp")
        yield ObjectSetting(0x605A, 0, 6)  # after a quick stop: stay in Quick Stop Active, and hold
        yield ObjectSetting(0x6085, 0, abs(units.velocity_counts(units.stop_deceleration)))
        yield ObjectSetting(0x60C2, 1, round(1e3 / setup.sync_rate), "interpolation between two SYNCs")
        if drive.setup.track is None:
            yield ObjectSetting(
                0x6065, 0, units.distance_counts(drive.setup.following_error), "its own following error"
            )
            yield ObjectSetting(0x6066, 0, round(1e3 * drive.setup.following_time), "its own following error")
            if joint.kind in {JointKind.REVOLUTE, JointKind.PRISMATIC}:
                margin = LIMIT_MARGIN * (joint.upper - joint.lower)
                ends = sorted((units.counts(joint.lower - margin), units.counts(joint.upper + margin)))
                yield ObjectSetting(0x607D, 1, ends[0], "its own position limits")
                yield ObjectSetting(0x607D, 2, ends[1], "its own position limits")
        if drive.by_profile:
            acceleration = abs(units.velocity_counts(joint.velocity / ACCELERATION_TIME))
            yield ObjectSetting(0x6081, 0, abs(units.velocity_counts(joint.velocity)))
            yield ObjectSetting(0x6083, 0, acceleration)
            yield ObjectSetting(0x6084, 0, acceleration)
        if (homing := drive.setup.homing) is not None:
            speed = abs(units.velocity_counts(homing.speed))
            yield ObjectSetting(0x6098, 0, homing.method)
            yield ObjectSetting(0x6099, 1, speed)
            yield ObjectSetting(0x6099, 2, max(1, speed // 4))
            yield ObjectSetting(0x609A, 0, abs(units.velocity_counts(joint.velocity / ACCELERATION_TIME)))
            yield ObjectSetting(0x607C, 0, 0, "an offset of the home position")
        yield ObjectSetting(0x6072, 0, abs(units.torque(joint.effort)), "its own limit of the torque")


def check_identity(sdo: Any, drive: Drive) -> None:
    """Check that a node is the drive that the robot's file describes. Raises `DriveFault`."""
    setup = drive.setup
    device = _read(sdo, 0x1000, 0)
    if device & 0xFFFF != PROFILE:
        raise DriveFault(
            f"{drive.name} is not a servo drive: its device type is {device:08X}h, and CiA 402 ends in 0192h; "
            f"check can.drives.{setup.name}.node"
        )
    modes = _read(sdo, 0x6502, 0)
    drive.by_profile = setup.track is None and modes & CYCLIC_MODES != CYCLIC_MODES
    if (drive.by_profile and not modes & PROFILE_POSITION) or (setup.track and not modes & CYCLIC_VELOCITY):
        raise DriveFault(
            f"{drive.name} has neither the cyclic synchronous modes nor profile position (6502h is {modes:08X}h): "
            "update its firmware"
            if setup.track is None
            else f"{drive.name} lacks cyclic synchronous velocity (6502h is {modes:08X}h), which a track needs: update "
            "its firmware"
        )
    for sub, what, wanted in ((1, "vendor", setup.vendor), (2, "product", setup.product)):
        if wanted is not None and (found := _read(sdo, 0x1018, sub)) != wanted:
            source = f"the EDS file {setup.eds}" if setup.eds else "the robot's file"
            raise DriveFault(
                f"{drive.name} has the {what} code {found:X}h, and {source} is for {wanted:X}h: wrong EDS file, "
                "or another drive has this node id"
            )
    if setup.serial is not None and (found := _read(sdo, 0x1018, 4)) != setup.serial:
        raise DriveFault(
            f"{drive.name} has the serial number {found}, and the robot's file says {setup.serial}: "
            "node ids are swapped, or the drive was replaced"
        )


def is_homed(sdo: Any) -> bool:
    """True if the drive has found its home position since it got power. It reports this in the homing mode only."""
    _write(sdo, 0x6060, 0, Mode.HOMING, 1)
    for _ in range(MODE_READS):
        if _read(sdo, 0x6061, 0) == Mode.HOMING:
            return _read(sdo, 0x6041, 0) & (HOMING_ATTAINED | HOMING_ERROR) == HOMING_ATTAINED
    return False


def _set(sdo: Any, setting: ObjectSetting, drive: Drive) -> None:
    """Write an object that differs."""
    size = SIZES.get(setting.index, 4)
    try:
        if _read(sdo, setting.index, setting.sub) & ((1 << 8 * size) - 1) != setting.value & ((1 << 8 * size) - 1):
            _write(sdo, setting.index, setting.sub, setting.value, size)
    except SdoAbortedError as error:
        if not setting.why:
            raise DriveFault(
                f"{drive.name} refuses {setting.index:04X}h = {setting.value}, which is needed to stop safely: {error}"
            ) from error
        _LOG.warning("%s has no %04Xh: %s; check its manual", drive.name, setting.index, setting.why)


def _map(sdo: Any, wanted: pdo.Pdo, drive: Drive) -> None:
    """Map a PDO, unless it is mapped so already; then check it."""
    node = drive.setup.node
    final = wanted.mapping(node)

    def present() -> dict[tuple[int, int], int]:
        return {(index, sub): _read(sdo, index, sub) for index, sub in final}

    if wanted.is_mapped_by(present(), node):
        return
    for index, sub, value in wanted.parameters(node):
        is_small = sub == 0 or (index, sub) == (wanted.parameter, 2)
        _write(sdo, index, sub, value, 1 if is_small else 4)
    if not wanted.is_mapped_by(present(), node):
        raise DriveFault(f"{drive.name} does not keep the mapping of PDO {wanted.parameter:04X}h: its mapping is fixed")


def read_object(sdo: Any, index: int, sub: int) -> bytes:
    """The first bytes of an object, `MAX_OBJECT` at most: an answer may go on for ever."""
    found = b""
    with sdo.open(index, sub, "rb", buffering=0) as stream:
        while len(found) < MAX_OBJECT and (data := stream.read(MAX_OBJECT)):
            found += data
    return found


def _read(sdo: Any, index: int, sub: int) -> int:
    return int.from_bytes(read_object(sdo, index, sub)[:4], "little")


def _write(sdo: Any, index: int, sub: int, value: int, size: int) -> None:
    sdo.download(index, sub, (value & ((1 << 8 * size) - 1)).to_bytes(size, "little"))


def attempt(action: Callable[[], int]) -> int | None:
    """The result of an SDO access; None if the drive does not have the object or does not answer."""
    try:
        return action()
    except SdoError:
        return None
