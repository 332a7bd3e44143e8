"""The PDOs between robot and drives: what each maps, and the objects that say so (CiA 301)."""

from __future__ import annotations

import struct
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Final

from jauspy.backends.can.cia402 import Mode

NMT: Final = 0
SYNC: Final = 0x80
EMCY: Final = 0x80
SDO_ANSWER: Final = 0x580
HEARTBEAT: Final = 0x700
SDO_REQUEST: Final = 0x600
"""COB-IDs; all but those of NMT and SYNC are added to a node id."""

SDO_SIZE: Final = 8
EMCY_SIZE: Final = 8
"""Bytes of these frames."""

FORMATS: Final = {(8, False): "B", (8, True): "b", (16, False): "H", (16, True): "h", (32, False): "I", (32, True): "i"}
SIGNED: Final = frozenset({0x6060, 0x6061, 0x6064, 0x606C, 0x6071, 0x6077, 0x607A, 0x60FF})
"""Objects that are signed numbers."""

NAMES: Final = {
    0x603F: "error_code",
    0x6040: "controlword",
    0x6041: "statusword",
    0x6060: "mode",
    0x6061: "mode_display",
    0x6064: "position",
    0x606C: "velocity",
    0x6071: "target_torque",
    0x6077: "torque",
    0x607A: "target_position",
    0x60FF: "target_velocity",
}


@dataclass(frozen=True, slots=True)
class Pdo:
    """One PDO of each drive."""

    cob_id: int
    """Added to the drive's node id."""
    parameter: int
    """Index of its communication parameter; that of its mapping is 200h higher."""
    every: int
    """Transmission type: it belongs to each SYNC, or to each second one."""
    objects: tuple[tuple[int, int], ...]
    """Index and bits of each object, in order."""

    @property
    def layout(self) -> struct.Struct:
        """The layout of its bytes."""
        return struct.Struct("<" + "".join(FORMATS[bits, index in SIGNED] for index, bits in self.objects))

    def parameters(self, node: int) -> Iterator[tuple[int, int, int]]:
        """Index, subindex and value of each object that maps the PDO; it is off while they are written."""
        mapping = self.parameter + 0x200
        yield self.parameter, 1, 0x80000000 | self.cob_id + node
        yield self.parameter, 2, self.every
        yield mapping, 0, 0
        for number, (index, bits) in enumerate(self.objects, 1):
            yield mapping, number, index << 16 | bits
        yield mapping, 0, len(self.objects)
        yield self.parameter, 1, self.cob_id + node

    def is_mapped_by(self, present: dict[tuple[int, int], int], node: int) -> bool:
        """True if these objects, by index and subindex, map the PDO already."""
        return all(present.get((index, sub)) == value for (index, sub), value in self.mapping(node).items())

    def mapping(self, node: int) -> dict[tuple[int, int], int]:
        """The objects as they are in the end, by index and subindex."""
        return {(index, sub): value for index, sub, value in self.parameters(node)}


_CONTROL: Final = ((0x6040, 16), (0x6060, 8))

COMMANDS: Final = {
    Mode.CYCLIC_POSITION: Pdo(0x200, 0x1400, 1, (*_CONTROL, (0x607A, 32))),
    Mode.CYCLIC_VELOCITY: Pdo(0x300, 0x1401, 1, (*_CONTROL, (0x60FF, 32))),
    Mode.CYCLIC_TORQUE: Pdo(0x400, 0x1402, 1, (*_CONTROL, (0x6071, 16))),
}
"""RPDOs. A drive gets one of them before each SYNC, by the mode: all three would fill the bus."""

STATUS: Final = Pdo(0x180, 0x1800, 1, ((0x6041, 16), (0x6064, 32), (0x6077, 16)))
SPEED: Final = Pdo(0x280, 0x1801, 2, ((0x606C, 32), (0x6061, 8), (0x603F, 16)))
"""TPDOs, after each SYNC and after each second one."""

ALL: Final = (*COMMANDS.values(), STATUS, SPEED)

STATUS_LAYOUT: Final = STATUS.layout
SPEED_LAYOUT: Final = SPEED.layout
COMMAND_LAYOUTS: Final = {mode: pdo.layout for mode, pdo in COMMANDS.items()}


def frame_bits(size: int) -> int:
    """Bits of a CAN frame with `size` bytes and an 11-bit identifier, with the most stuff bits, and a gap."""
    return 47 + 8 * size + (34 + 8 * size - 1) // 4


def bus_load(drives: int, sync_rate: float, bit_rate: int) -> float:
    """The fraction of the bus that cyclic traffic of so many drives takes, at most."""
    per_drive = frame_bits(7) + frame_bits(STATUS_LAYOUT.size) + frame_bits(SPEED_LAYOUT.size) / SPEED.every
    return (drives * per_drive + frame_bits(0)) * sync_rate / bit_rate
