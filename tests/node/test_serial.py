"""JSerial of the running node manager, on a pseudo terminal whose other end the test holds."""

import asyncio
import builtins
import os
import pty
import tty
from collections.abc import AsyncIterator, Iterator
from pathlib import Path
from typing import Any

import pytest

from jauspy.errors import ConfigError, TransportError
from jauspy.ids import EVERYONE, JausID
from jauspy.node import NodeConfig, NodeManager
from jauspy.node.config import SerialConfig
from jauspy.protocol import jserial, judp
from jauspy.protocol.header import Broadcast, Packet
from jauspy.transport import LocalTransport, SerialLine, serial as serial_link

HERE, FAR = JausID.parse("100.1.2"), JausID.parse("200.1.1")


class Terminal:
    """The far end of a serial line."""

    def __init__(self) -> None:
        self.end, device = pty.openpty()
        tty.setraw(device)
        self.device = os.ttyname(device)
        self._device = device
        os.set_blocking(self.end, False)

    def send(self, text: str) -> None:
        os.write(self.end, bytes.fromhex(text))

    async def receive(self, count: int) -> str:
        data = b""
        async with asyncio.timeout(20):
            while len(data) < count:
                try:
                    data += os.read(self.end, count - len(data))
                except BlockingIOError:
                    await asyncio.sleep(0.002)
        return data.hex()

    def hang_up(self) -> None:
        os.close(self.end)
        os.close(self._device)


@pytest.fixture
def terminal() -> Iterator[Terminal]:
    made = Terminal()
    yield made
    made.hang_up()


@pytest.fixture
async def node(root: Path, terminal: Terminal) -> AsyncIterator[NodeManager]:
    line = SerialConfig(device=terminal.device)
    async with NodeManager(NodeConfig(address="127.0.0.1", port=0, local_root=root, serial=(line,))) as manager:
        yield manager


@pytest.fixture
async def here(node: NodeManager, root: Path) -> AsyncIterator[tuple[LocalTransport, "asyncio.Queue[bytes]"]]:
    queue: asyncio.Queue[bytes] = asyncio.Queue()
    transport = LocalTransport(HERE, root)
    transport.received = queue.put_nowait
    await transport.open()
    yield transport, queue
    await transport.close()


async def test_frames_of_another_implementation_both_ways(node: NodeManager, here: Any, terminal: Terminal) -> None:
    transport, arrived = here
    terminal.send("10010211001002c20000110001020164000101c8000a10100b09001003a58c")
    async with asyncio.timeout(20):
        assert (await arrived.get()).hex() == "0200110001020164000101c8000a100b0900"
    transport.send(bytes.fromhex("02 001000 01 0101c800 02016400 3132 0600"))
    assert (
        await terminal.receive(31)
        == "1001021010001002" + "1a19" + "0010100001" + "0101c80002016400" + "31320600" + "100301d9"
    )
    transport.send(bytes.fromhex("02 001200 09 ffffffff 02016400 01021003 0500"))
    assert await terminal.receive(32) == "10010212001002aa2a00120009ffffffff02016400010210100305001003a168"


async def test_version_1_passes_both_ways(node: NodeManager, here: Any, terminal: Terminal) -> None:
    transport, arrived = here
    old = "01 0000 0012 06023412 0101c800 02016400 0200 0700 aabb"
    back = "01 0000 0012 06023412 02016400 0101c800 0200 0700 aabb"
    os.write(terminal.end, jserial.frame(bytes.fromhex(back)))
    async with asyncio.timeout(20):
        assert await arrived.get() == bytes.fromhex(back)
    transport.send(bytes.fromhex(old))
    assert await terminal.receive(35) == "10010116001002aea200001200060234120101c800020164000200" + "0700aabb1003f2a7"


async def test_several_packets_in_one_frame(node: NodeManager, here: Any, terminal: Terminal) -> None:
    _, arrived = here
    first, second = (judp.pack(Packet(FAR, HERE, b"\x02\x20", number)) for number in range(2))
    os.write(terminal.end, jserial.frame(first + second[1:]))
    async with asyncio.timeout(20):
        assert [await arrived.get(), await arrived.get()] == [first, second]


async def test_several_lines(root: Path, terminal: Terminal) -> None:
    """What is heard on one is answered there, broadcasts go out on both, and nothing crosses from one to the other."""
    second = Terminal()
    lines = tuple(SerialConfig(device=each.device) for each in (terminal, second))
    async with NodeManager(NodeConfig(address="127.0.0.1", port=0, local_root=root, serial=lines)):
        transport, arrived = LocalTransport(HERE, root), asyncio.Queue[bytes]()
        transport.received = arrived.put_nowait
        await transport.open()
        for number, (line, id) in enumerate(((terminal, FAR), (second, JausID(201, 1, 1)))):
            query = judp.pack(Packet(id, HERE, b"\x02\x20", number))
            os.write(line.end, jserial.frame(query))
            async with asyncio.timeout(20):
                assert await arrived.get() == query
            answer = jserial.frame(judp.pack(Packet(HERE, id, b"\x02\x40", number)))
            transport.send(judp.pack(Packet(HERE, id, b"\x02\x40", number)))
            assert await line.receive(len(answer)) == answer.hex()
        everybody = Packet(HERE, EVERYONE, b"\x00\x2b", 9, broadcast=Broadcast.GLOBAL)
        transport.send(judp.pack(everybody))
        frame = jserial.frame(judp.pack(everybody))
        os.write(terminal.end, jserial.frame(judp.pack(Packet(FAR, EVERYONE, b"\x00\x2b", 1))))
        transport.send(judp.pack(everybody))
        for line in (terminal, second):
            assert await line.receive(2 * len(frame)) == 2 * frame.hex()
        await transport.close()
    second.hang_up()


async def test_noise_and_bad_checksums_are_dropped(node: NodeManager, here: Any, terminal: Terminal) -> None:
    _, arrived = here
    good = judp.pack(Packet(FAR, HERE, b"\x02\x20", 1))
    frame = jserial.frame(good)
    os.write(terminal.end, b"\xff\x10\x03noise" + frame[:-1] + b"\0" + frame[:9] + frame)
    async with asyncio.timeout(20):
        assert await arrived.get() == good
    assert node.counters["dropped.malformed.serial_checksum"] == 1


async def test_returning_device_is_reopened(root: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(serial_link, "REOPEN_INTERVAL", 0.02)
    first, second = Terminal(), Terminal()
    name = tmp_path / "line"
    name.symlink_to(first.device)
    config = NodeConfig(address="127.0.0.1", port=0, local_root=root, serial=(SerialConfig(device=str(name)),))
    async with NodeManager(config) as node:
        first.hang_up()
        async with asyncio.timeout(20):
            while not node.counters["serial.lost"]:
                await asyncio.sleep(0.005)
        name.unlink()
        name.symlink_to(second.device)
        async with asyncio.timeout(20):
            while not node.counters["serial.reopened"]:
                await asyncio.sleep(0.005)
        second.send("10010211001002c20000110001020164000101c8000a10100b09001003a58c")
        async with asyncio.timeout(20):
            while not node.counters["received.serial"]:
                await asyncio.sleep(0.005)
    second.hang_up()


async def test_queue_of_a_blocked_line_is_bounded(node: NodeManager, here: Any, terminal: Terminal) -> None:
    transport, arrived = here
    terminal.send("10010211001002c20000110001020164000101c8000a10100b09001003a58c")
    async with asyncio.timeout(20):
        await arrived.get()
        while not node.counters["dropped.queue_full"]:
            for _ in range(50):
                transport.send(judp.pack(Packet(HERE, FAR, bytes(4000))))
            await asyncio.sleep(0)
    own = judp.pack(Packet(HERE, HERE, b"\0\0"))
    transport.send(own)
    async with asyncio.timeout(20):
        assert await arrived.get() == own


async def test_missing_device_is_an_error(root: Path) -> None:
    line = SerialConfig(device="/dev/does-not-exist")
    with pytest.raises(TransportError, match="cannot open the serial port /dev/does-not-exist"):
        await NodeManager(NodeConfig(address="127.0.0.1", port=0, local_root=root, serial=(line,))).open()
    assert list(root.iterdir()) == []


async def test_missing_pyserial_error_names_the_extra(monkeypatch: pytest.MonkeyPatch) -> None:
    real = builtins.__import__

    def without(name: str, *rest: Any) -> Any:
        if name == "serial":
            raise ImportError
        return real(name, *rest)

    monkeypatch.setattr(builtins, "__import__", without)
    from jauspy.protocol.counters import Counters
    from jauspy.transport.serial import SerialLink

    with pytest.raises(TransportError, match=r"jauspy\[serial\]"):
        SerialLink(SerialLine("/dev/x"), Counters(serial_link._LOG), print).open()


async def test_key_with_serial_lines_or_tcp_is_an_error(root: Path, tmp_path: Path) -> None:
    key = tmp_path / "key"
    key.write_bytes(bytes(range(32)))
    key.chmod(0o600)
    with pytest.raises(ConfigError, match="cannot be authenticated"):
        await NodeManager(NodeConfig(address="127.0.0.1", port=0, local_root=root, tcp=True, key_file=key)).open()
    assert list(root.iterdir()) == []
