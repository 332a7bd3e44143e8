"""Peers cause lines of the log as fast as they can; a few of each kind are written, and what is valid arrives."""

from __future__ import annotations

import asyncio
import logging
import random
import re
import socket
from collections import Counter
from collections.abc import Callable
from pathlib import Path

import pytest
from tests.node import malformed

import jauspy
from jauspy.ids import JausID
from jauspy.logs import LINE_INTERVAL, MAX_LINES_AT_ONCE, LogRateLimit
from jauspy.messages.core import QueryHeartbeatPulse, ReportHeartbeatPulse
from jauspy.node import NodeConfig, NodeManager
from jauspy.protocol import judp, junior
from jauspy.protocol.duplicates import ECHO_WINDOW
from jauspy.protocol.endpoint import Endpoint
from jauspy.protocol.header import DataFlag, Packet
from jauspy.services.core import Liveness
from jauspy.testing import VirtualNetwork

HERE, THERE, STRANGER = (JausID.parse(text) for text in ("101.1.1", "101.1.2", "43.1.1"))
PULSE = QueryHeartbeatPulse().encode()


def lines_of_each_kind(caplog: pytest.LogCaptureFixture) -> Counter[tuple[str, int, str]]:
    """How many lines were written, by place and, for what is told once for each reason, by reason."""
    return Counter((each.pathname, each.lineno, str(getattr(each, "kind", ""))) for each in caplog.records)


@pytest.mark.parametrize("flags", [(DataFlag.MIDDLE, DataFlag.MIDDLE), (DataFlag.MIDDLE, DataFlag.LAST)])
def test_the_first_fragment_of_a_message_may_have_the_number_and_bytes_of_another_one(
    flags: tuple[DataFlag, DataFlag],
) -> None:
    endpoint = Endpoint(HERE, first_sequence=0)

    fragments = ((flags[0], 1, PULSE), (flags[1], 2, PULSE), (DataFlag.FIRST, 2, PULSE), (DataFlag.LAST, 3, b"end"))
    for step, (flag, number, payload) in enumerate(fragments):
        packet = Packet(STRANGER, HERE, payload, number, data_flag=flag)
        endpoint.receive(judp.pack(packet), 1.0 + 2 * ECHO_WINDOW * step)
    received = endpoint.next_event()
    assert received is not None
    assert received.payload == PULSE + b"end"
    assert endpoint.counters["dropped.large_message.restarted"] >= 1


class Fragile(Liveness):
    """Its answer to a query is a mistake."""

    def report_heartbeat_pulse(self) -> ReportHeartbeatPulse:
        raise LookupError("a mistake")


async def test_a_component_that_gets_nonsense(caplog: pytest.LogCaptureFixture) -> None:
    caplog.set_level(logging.DEBUG)
    async with VirtualNetwork() as network, network.component("101.1.1", [Fragile()]) as component:
        attacker = network.transport(STRANGER)
        await attacker.open()
        answers: list[bytes] = []
        attacker.received = answers.append
        chance = random.Random(1)
        for number in range(400):
            for flag, step in ((DataFlag.MIDDLE, 0), (DataFlag.MIDDLE, 1), (DataFlag.FIRST, 1), (DataFlag.SINGLE, 2)):
                packet = Packet(STRANGER, HERE, PULSE, 3 * number + step, data_flag=flag)
                attacker.send(judp.pack(packet))
            code = chance.randbytes(chance.randrange(1, 40))
            attacker.send(judp.pack(Packet(STRANGER, HERE, code, 60000 - number)))
            await asyncio.sleep(0.01)
        assert component.counters.get("component.internal_error", 0) == 0
        assert component.counters["host.action_failed"] >= 400
    assert max(lines_of_each_kind(caplog).values()) <= MAX_LINES_AT_ONCE + 1
    assert len(caplog.records) < 100


async def test_a_node_manager_in_all_kinds_of_floods(
    root: Path,
    introduce: Callable[..., socket.socket],
    udp: Callable[..., socket.socket],
    caplog: pytest.LogCaptureFixture,
) -> None:
    caplog.set_level(logging.DEBUG)
    loop = asyncio.get_running_loop()
    config = NodeConfig(address="127.0.0.1", port=0, local_root=root, tcp=True, rate_limit=1e6, rate_burst=1e6)
    async with NodeManager(config) as node:
        here, peer, other = introduce(HERE), udp(), udp("127.0.0.2")
        where, path = ("127.0.0.1", node.port), str(root / junior.SOCKET_NAME)
        for number, data in enumerate(malformed.datagrams(1, 60 * len(malformed.KINDS))):
            peer.sendto(data, where)
            id = JausID(200 + number % 300, 1, 1)
            for datagram in (
                judp.pack(Packet(HERE, THERE, PULSE, number)),  # the id of a component of this machine
                judp.pack(Packet(id, THERE, PULSE, number)),  # to nobody
                junior.connect(id),
                junior.cancel(id),
            ):
                (other if number % 2 else peer).sendto(datagram, where)
            if number % 16 == 0:
                await send(here, judp.pack(Packet(id, HERE, PULSE, number)), path)
                await send(here, data, path)
                await asyncio.sleep(0)
        for _ in range(80):
            _, writer = await asyncio.open_connection(*("127.0.0.1", node.tcp_port))
            writer.write(b"\xff" * 30)
            writer.close()
        last = judp.pack(Packet(JausID(42, 1, 1), HERE, PULSE, 9))
        peer.sendto(last, where)
        async with asyncio.timeout(20):
            while await loop.sock_recv(here, 70000) != last:
                pass
        kinds = [name for name in node.counters if name.startswith("dropped.")]
        assert len(kinds) >= 10
    assert max(lines_of_each_kind(caplog).values()) <= MAX_LINES_AT_ONCE + 1
    assert len(caplog.records) < 300


async def send(sock: socket.socket, data: bytes, path: str) -> None:
    """As soon as the node manager has room."""
    while True:
        try:
            sock.sendto(data, path)
        except BlockingIOError:
            await asyncio.sleep(0)
        else:
            return


def test_lines_left_out_are_counted_in_the_next_one() -> None:
    limit, written = LogRateLimit(), []
    for second in range(100):
        record = logging.LogRecord("jauspy.x", logging.INFO, "x.py", 1, "line %d", (second,), None)
        record.created = 1000.0 + second / 10
        if limit.filter(record):
            written.append(record.getMessage())
    record = logging.LogRecord("jauspy.x", logging.INFO, "x.py", 1, "line %d", (100,), None)
    record.created = 1000.0 + 3 * LINE_INTERVAL
    assert limit.filter(record)
    assert len(written) == MAX_LINES_AT_ONCE
    assert record.getMessage() == f"line 100 ({100 - MAX_LINES_AT_ONCE} such lines were left out)"


def test_all_loggers_are_limited() -> None:
    package = Path(jauspy.__file__).parent
    unlimited = [
        str(path.relative_to(package))
        for path in package.rglob("*.py")
        if re.search(r"logging\.(getLogger|debug|info|warning|error|exception|log)\(", path.read_text())
    ]
    # bus.py only silences python-can's own logger while a bus is opened
    assert sorted(unlimited) == ["backends/can/bus.py", "cli/console.py", "logs.py"]
