"""A filter in the kernel for the datagrams of a local socket: what it drops wakes no program (Linux, classic BPF)."""

from __future__ import annotations

import ctypes
import socket
import struct
from collections.abc import Collection, Sequence
from contextlib import suppress
from enum import IntEnum
from typing import Final, NamedTuple

from jauspy.protocol.header import OVERHEAD, VERSION

_SO_ATTACH_FILTER: Final = 26
_SO_DETACH_FILTER: Final = 27
"""Socket options of asm-generic/socket.h, which Python does not name."""
_INSTRUCTION: Final = struct.Struct("@HBBI")
_PROGRAM: Final = struct.Struct("@HP")
_KEEP: Final = 0xFFFFFFFF
MAX_CODES: Final = 64
"""Message ids of one filter: jumps are short."""


class _Operation(IntEnum):
    """Operations of linux/filter.h: loads of the datagram's bytes, as big endian, jumps and arithmetics."""

    LOAD_BYTE = 0x30
    LOAD_PAIR = 0x28
    LOAD_LENGTH = 0x80
    SHIFT_LEFT = 0x64
    ADD = 0x04
    OR_X = 0x4C
    TO_X = 0x07
    IF_EQUAL = 0x15
    IF_EQUAL_X = 0x1D
    IF_AT_LEAST = 0x35
    IF_ANY_BIT = 0x45
    RETURN = 0x06


class _Step(NamedTuple):
    """An instruction; a jump leaves the header's checks and keeps the datagram where its condition is not `wanted`."""

    operation: _Operation
    operand: int = 0
    wanted: bool | None = None


_IS_BROADCAST: Final = (
    _Step(_Operation.LOAD_LENGTH),
    _Step(_Operation.IF_AT_LEAST, 1 + OVERHEAD + 2, wanted=True),  # with a message id
    _Step(_Operation.LOAD_BYTE, 0),
    _Step(_Operation.IF_EQUAL, VERSION, wanted=True),
    _Step(_Operation.LOAD_BYTE, 1),
    _Step(_Operation.IF_EQUAL, 0, wanted=True),  # no header compression, no other flag
    _Step(_Operation.LOAD_BYTE, 4),
    _Step(_Operation.IF_ANY_BIT, 0xF0, wanted=False),  # no ACK, no fragment
    _Step(_Operation.IF_ANY_BIT, 0x0C, wanted=True),
    _Step(_Operation.LOAD_BYTE, 2),
    _Step(_Operation.TO_X),
    _Step(_Operation.LOAD_BYTE, 3),
    _Step(_Operation.SHIFT_LEFT, 8),
    _Step(_Operation.OR_X),
    _Step(_Operation.ADD, 1),
    _Step(_Operation.TO_X),
    _Step(_Operation.LOAD_LENGTH),
    _Step(_Operation.IF_EQUAL_X, wanted=True),  # alone and whole
    _Step(_Operation.LOAD_PAIR, 13),
)
"""True for the datagrams of which `header.broadcast_code` tells the message id."""


def set_filter(sock: socket.socket, codes: Collection[int]) -> None:
    """Have the kernel drop broadcasts with these message ids, at most `MAX_CODES`, and no others; none removes it.

    Only what is alone and whole in its datagram is dropped. Senders are told that it was sent. Does nothing on systems
    without such filters.
    """
    with suppress(OSError):
        if not codes:
            sock.setsockopt(socket.SOL_SOCKET, _SO_DETACH_FILTER, 0)
            return
        program = _program(sorted(codes))
        instructions = ctypes.create_string_buffer(b"".join(program), _INSTRUCTION.size * len(program))
        value = _PROGRAM.pack(len(program), ctypes.addressof(instructions))
        sock.setsockopt(socket.SOL_SOCKET, _SO_ATTACH_FILTER, value)


def _program(codes: Sequence[int]) -> list[bytes]:
    if len(codes) > MAX_CODES:
        raise ValueError(f"{len(codes)} message ids; a filter has up to {MAX_CODES}")
    keep = len(_IS_BROADCAST) + len(codes)
    program = []
    for index, (operation, operand, wanted) in enumerate(_IS_BROADCAST):
        away = keep - index - 1
        jumps = (0, 0) if wanted is None else (0, away) if wanted else (away, 0)
        program.append(_INSTRUCTION.pack(operation, *jumps, operand))
    for index, code in enumerate(codes):
        swapped = int.from_bytes(code.to_bytes(2, "little"), "big")
        program.append(_INSTRUCTION.pack(_Operation.IF_EQUAL, len(codes) - index, 0, swapped))
    return [*program, _INSTRUCTION.pack(_Operation.RETURN, 0, 0, _KEEP), _INSTRUCTION.pack(_Operation.RETURN, 0, 0, 0)]
