"""What waits too long is dropped: in queues, in stamped sockets, and in streams after a stall."""

import asyncio
import logging
import socket
import time

import pytest

from jauspy.ids import JausID
from jauspy.protocol import judp, junior
from jauspy.protocol.counters import Counters
from jauspy.protocol.header import Ack, DataFlag, Packet, Priority
from jauspy.protocol.pending import PROBE_INTERVAL, PendingDestinations
from jauspy.transport.age import DatagramReader
from jauspy.transport.send_queue import SendQueue
from jauspy.transport.tcp import Dialer

HERE, FAR = JausID.parse("101.1.30"), JausID.parse("42.1.1")


COMMAND, QUERY, REPORT, OWN = (code.to_bytes(2, "little") for code in (0x0405, 0x2002, 0x4002, 0xD001))


def packet(
    number: int,
    ack: Ack = Ack.NONE,
    priority: Priority = Priority.STANDARD,
    *,
    payload: bytes = COMMAND,
    data_flag: DataFlag = DataFlag.SINGLE,
) -> bytes:
    return judp.pack(Packet(FAR, HERE, payload, number, priority, ack=ack, data_flag=data_flag))


@pytest.fixture
def counters() -> Counters:
    return Counters(logging.getLogger("jauspy.test"))


@pytest.mark.parametrize(
    ("datagram", "may_be_late"),
    [
        (packet(1), False),
        (packet(1, Ack.REQUIRED), True),
        (packet(1, Ack.ACK), True),
        (packet(1, Ack.REQUIRED) + packet(2)[1:], False),
        (packet(1, payload=QUERY), True),
        (packet(1, payload=REPORT), True),
        (packet(1, payload=OWN), False),
        (packet(1, payload=REPORT, data_flag=DataFlag.FIRST), True),
        (packet(1, data_flag=DataFlag.FIRST), False),
        (packet(1, data_flag=DataFlag.MIDDLE), True),
        (packet(1, data_flag=DataFlag.LAST), True),
        (junior.connect(HERE), True),
        (b"", False),
        (b"\xff" * 40, False),
    ],
)
def test_only_commands_without_ack_may_not_be_late(datagram: bytes, may_be_late: bool) -> None:
    assert judp.may_be_late(datagram) is may_be_late
    assert judp.may_be_late(b"key" + datagram, 3) is may_be_late


def test_a_queue_keeps_what_is_new_or_may_be_late(monkeypatch: pytest.MonkeyPatch) -> None:
    now = 100.0
    monkeypatch.setattr(time, "monotonic", lambda: now)
    queue = SendQueue(max_age=0.5)
    for number, priority in enumerate(Priority):
        queue.push(packet(number, priority=priority))
    queue.push(packet(7, Ack.REQUIRED))
    now += 0.4
    queue.push(packet(8))
    assert queue.drop_stale() == 0
    now += 0.2
    assert queue.drop_stale() == 4
    sent: list[bytes] = []
    queue.drain(sent.append, 10)
    assert sent == [packet(7, Ack.REQUIRED), packet(8)]
    assert not len(queue)


def test_what_waits_for_an_unknown_destination_is_not_delivered_late(counters: Counters) -> None:
    pending = PendingDestinations(counters, max_age=0.5)
    assert pending.add(1, packet(0), 0.0) == packet(0)
    pending.add(1, packet(1), 0.0)
    pending.add(1, packet(2, Ack.REQUIRED), 0.0)
    pending.add(1, packet(3), 0.4)
    assert pending.pop(1, 0.6) == [packet(2, Ack.REQUIRED), packet(3)]
    assert counters["dropped.stale"] == 1
    pending.add(1, packet(4), 1.0)
    pending.add(1, packet(5), 1.0)
    assert pending.handle_timeout(1.0 + PROBE_INTERVAL) == []
    assert counters["dropped.stale"] == 2


@pytest.mark.usefixtures("kernel_stamps")
def test_a_socket_that_was_empty_a_moment_ago_is_read_without_stamps(udp_pair, counters: Counters) -> None:
    receiver, sender = udp_pair
    reader = DatagramReader(receiver, counters, 0.05)
    for _ in range(3):
        sender.sendto(packet(1), receiver.getsockname())
    reader.was_empty(100.0)
    assert reader.receiver(100.01) == receiver.recvfrom
    time.sleep(0.06)
    receive = reader.receiver(101.0)
    assert receive != receiver.recvfrom
    sender.sendto(packet(2), receiver.getsockname())
    assert receive(100)[0] == packet(2)
    assert counters["dropped.stale"] == 3
    with pytest.raises(BlockingIOError):
        reader.receiver(102.0)


@pytest.fixture
def udp_pair():
    with (
        socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as receiver,
        socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as sender,
    ):
        receiver.bind(("127.0.0.1", 0))
        receiver.setblocking(False)
        yield receiver, sender


async def test_a_connection_is_made_again_after_a_stall(counters: Counters) -> None:
    arrived: list[bytes] = []
    writers: list[asyncio.StreamWriter] = []

    async def serve(reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
        writers.append(writer)
        writer.write(packet(len(writers)))
        while await reader.read(100):
            pass
        writer.close()

    server = await asyncio.start_server(serve, "127.0.0.1", 0)
    dialer = Dialer(
        server.sockets[0].getsockname(), counters, lambda _, datagram: arrived.append(datagram), max_age=0.1
    )
    async with asyncio.timeout(20):
        while arrived != [packet(1)]:
            await asyncio.sleep(0.001)
        writers[0].write(packet(9)[1:])
        await writers[0].drain()
        time.sleep(0.2)  # noqa: ASYNC251 - this is the stall
        while arrived[-1] != packet(2):
            await asyncio.sleep(0.001)
    assert arrived == [packet(1), packet(2)]
    assert counters["dropped.stale"] == 1
    await dialer.close()
    server.close()
    await server.wait_closed()
