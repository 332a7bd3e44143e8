"""Packets from real networks, replayed byte for byte against the running node manager: what went in and came out."""

import asyncio
import socket
from collections.abc import AsyncIterator
from contextlib import ExitStack
from pathlib import Path

import pytest

from jauspy.node import NodeConfig, NodeManager

NEAR, FAR = "NEAR", "FAR"
"""A local component, 100.1.2 unless it says otherwise, and a peer on the network."""

Step = tuple[str, str, str, str]
"""Who sends what, and who gets what (nothing: ``)."""

CASES: dict[str, list[Step]] = {
    "address learned by an acknowledgement": [
        (FAR, "02000e003102016400010165000100", NEAR, "02000e003102016400010165000100"),
        (NEAR, "02001800010101650002016400000102030405060708090200", FAR, ""),
    ],
    "guaranteed delivery": [
        (FAR, "020010001102016400010165000a0b0100", NEAR, ""),
        (NEAR, "02001a00110101650002016400000102030405060708090a0b0100", FAR, ""),
        (FAR, "02000e003102016400010165000100", NEAR, ""),
    ],
    "pieces of a large message": [
        (FAR, "020010004102016400010165000a0b0100", NEAR, ""),
        (FAR, "020010008102016400010165000a0b0200", NEAR, ""),
        (FAR, "02001000c102016400010165000a0b0300", NEAR, ""),
        (NEAR, "02001000510101650002016400ef f0 0100", FAR, ""),
    ],
    "broadcasts": [
        (FAR, "0200180009ffffffff06016500000102030405060708090100", NEAR, ""),
        (FAR, "0200180009ffff640006016500000102030405060708090100", NEAR, ""),
    ],
    "two packets in a datagram": [
        (
            FAR,
            "02 001000 01 02016400 0101c800 0a0b 0600 001100 01 02016400 0101c800 0c0d0e 0700",
            NEAR,
            "02 001000 01 02016400 0101c800 0a0b 0600|02 001100 01 02016400 0101c800 0c0d0e 0700",
        ),
    ],
    "rubbish behind a whole packet": [
        (FAR, "02 001000 01 02016400 0101c800 0a0b 0600 ffff", NEAR, "02 001000 01 02016400 0101c800 0a0b 0600"),
    ],
    "control byte ff": [(FAR, "02001200ff02016400010165 0000010203 0100", NEAR, "")],
    "opc and its reply": [
        (
            FAR,
            "4a41555330312e30 06023412 02016400 0101c800 0200 2300 0102",
            NEAR,
            "01 0000 0012 06023412 02016400 0101c800 0200 2300 0102",
        ),
        (
            NEAR,
            "01 0000 0012 06023412 0101c800 02016400 0200 2300 0102",
            FAR,
            "4a41555330312e30 06023412 0101c800 02016400 0200 2300 0102",
        ),
    ],
    "version 1 with a command code": [
        (FAR, "01 0000 001a 06023412 02016400 01016500 0a00 0100 00010203040506070809", NEAR, ""),
        (NEAR, "01 0000 001a 06023412 01016500 02016400 0a00 0100 00010203040506070809", FAR, ""),
    ],
    "version 1 without a command code": [
        (
            FAR,
            "01 0000 0012 06020000 02016400 01016500 0200 0100 0220",
            NEAR,
            "02 001000 01 02016400 01016500 0220 0100",
        ),
    ],
    "local version 1 with a command code": [
        (NEAR, "01 0000 0012 06023412 02016400 02016400 0200 0700 aabb", NEAR, ""),
    ],
    "to itself": [(NEAR, "02001000 01 02016400 02016400 0000 0600", NEAR, "")],
}


class Ends:
    """Both ends as bytes; the local one is not connected, since the node manager answers from another socket."""

    def __init__(self, manager: NodeManager, near: socket.socket, far: socket.socket) -> None:
        self.manager = manager
        self._sockets = {NEAR: near, FAR: far}

    def send(self, who: str, data: bytes) -> None:
        if who == NEAR:
            self._sockets[NEAR].sendto(data, str(self.manager.path))
        else:
            self._sockets[FAR].send(data)

    async def receive(self, who: str) -> str:
        async with asyncio.timeout(5):
            return (await asyncio.get_running_loop().sock_recv(self._sockets[who], 70000)).hex()


@pytest.fixture
async def ends(root: Path) -> AsyncIterator[Ends]:
    async with NodeManager(NodeConfig(address="127.0.0.1", port=0, local_root=root)) as manager:
        with ExitStack() as stack:
            near = stack.enter_context(socket.socket(socket.AF_UNIX, socket.SOCK_DGRAM))
            near.bind(str(root / str(0x00640102)))
            far = stack.enter_context(socket.socket(socket.AF_INET, socket.SOCK_DGRAM))
            far.bind(("127.0.0.1", 0))
            far.connect(("127.0.0.1", manager.port))
            for sock in (near, far):
                sock.setblocking(False)
            ends = Ends(manager, near, far)
            ends.send(NEAR, bytes.fromhex("010000001006020100000000000201640000000000"))
            assert await ends.receive(NEAR) == "010000001006020200020164000000000000000000"
            yield ends


@pytest.mark.parametrize("name", CASES)
async def test_replayed(name: str, ends: Ends) -> None:
    for sender, sent, receiver, expected in CASES[name]:
        ends.send(sender, bytes.fromhex(sent))
        for each in (expected or sent).split("|"):
            assert await ends.receive(receiver) == bytes.fromhex(each).hex()


@pytest.mark.parametrize("receiver", [NEAR, FAR])
async def test_the_largest_packet(receiver: str, ends: Ends) -> None:
    ends.send(FAR, bytes.fromhex("020010000102016400010165000a0b0100"))
    await ends.receive(NEAR)
    ids = "02016400 01016500" if receiver == NEAR else "01016500 02016400"
    largest = bytes.fromhex("02 00 fd0f 01" + ids) + bytes(4079) + b"\x01\x00"
    ends.send(FAR if receiver == NEAR else NEAR, largest)
    assert await ends.receive(receiver) == largest.hex()


@pytest.mark.parametrize(
    "rubbish",
    [
        "02000d00 01 02016400 0101c800 0600",
        "02001100 01 02016400 0101c800 0a0b 0600",
        "03001000 01 02016400",
        "02",
        "00",
    ]
    + [f"02{kind:02x}1000 01 02016400 0101c800 0a0b 0600" for kind in (1, 2, 3, 32, 63)],
)
@pytest.mark.parametrize("sender", [NEAR, FAR])
async def test_rubbish_goes_nowhere(sender: str, rubbish: str, ends: Ends) -> None:
    ends.send(sender, bytes.fromhex(rubbish))
    good = "02001000 01 02016400 02016400 0000 0600"
    if sender == FAR:
        good = "02001000 01 02016400 01016500 0000 0600"
    ends.send(sender, bytes.fromhex(good))
    assert await ends.receive(NEAR) == bytes.fromhex(good).hex()
    assert sum(count for reason, count in ends.manager.counters.items() if reason.startswith("dropped.malformed")) == 1
    assert ends.manager.counters["routed.multicast"] == 0
