"""The checksum of JSerial: CRC-16 with the reflected polynomial 8408h, start FFFFh, nothing at the end ("MCRF4XX").

The standard library has the same polynomial in the other bit order, so bits are mirrored on the way in and out.
"""

from __future__ import annotations

import binascii
from typing import Final

CRC_START: Final = 0xFFFF
_MIRRORED: Final = bytes(int(f"{byte:08b}"[::-1], 2) for byte in range(256))


def crc16(data: bytes | bytearray, start: int = CRC_START) -> int:
    """The checksum of `data`, continued from `start`."""
    return _mirror(binascii.crc_hqx(data.translate(_MIRRORED), _mirror(start)))


def _mirror(value: int) -> int:
    return _MIRRORED[value & 0xFF] << 8 | _MIRRORED[value >> 8]
