"""Two machines with programs of the same id: both are told so."""

from __future__ import annotations

import asyncio
import socket
from pathlib import Path

import pytest

from jauspy.errors import ResponseTimeout
from jauspy.ids import JausID
from jauspy.node import NodeConfig, NodeManager
from jauspy.ocu import OCU, client
from jauspy.protocol import judp
from jauspy.protocol.addressing import LocalPort, UdpPort
from jauspy.protocol.header import Packet
from jauspy.protocol.registrar import CLASH_LIFETIME, MAX_CLASHES, NOTICES_PER_SECOND, IdClashes
from jauspy.protocol.routing import Router
from jauspy.transport.udp import UdpTransport

ID, ROBOT = JausID(42, 1, 1), JausID(101, 1, 1)
ELSEWHERE = UdpPort("10.0.0.2", 3794)
HELLO = judp.pack(Packet(ID, ROBOT, b"\x02\x2b", 7))


@pytest.fixture
def port(free_port: int) -> int:
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as probe:
        try:
            probe.bind(("127.0.0.2", free_port))
        except OSError:
            pytest.skip("this system has no 127.0.0.2")
    return free_port


async def test_both_programs_report_it(tmp_path: Path, port: int, monkeypatch, caplog):
    """Not to start the robot."""
    monkeypatch.setattr(client, "CLASH_INTERVAL", 0.05)
    hosts = ("127.0.0.1", "127.0.0.2")
    for number in (0, 1):
        (tmp_path / str(number)).mkdir()
    here, there = (
        NodeManager(
            NodeConfig(
                address=hosts[number],
                port=port,
                multicast_interfaces=["127.0.0.1"],
                multicast_group="239.255.0.8",
                local_root=tmp_path / str(number),
                addresses={"101.1.1": f"{hosts[1 - number]}:{port}"},
            )
        )
        for number in (0, 1)
    )
    early, late = (OCU("42.1.1", f"local:{tmp_path / str(number)}") for number in (0, 1))
    async with here, there, early, late:
        with pytest.raises(ResponseTimeout, match=r"the id 42\.1\.1 is in use twice") as reported:
            await late.discover(101, timeout=0.5)
        with pytest.raises(ResponseTimeout, match="in use twice"):
            await late.query("101.1.1", late.service("101.1.1", "Management").message("QueryStatus")(), timeout=0.1)
        async with asyncio.timeout(20):
            while len([each for each in caplog.records if "in use twice" in each.getMessage()]) < 2:
                await asyncio.sleep(0.01)
    assert "start the robot" not in str(reported.value)
    assert "127.0.0.1" in str(reported.value)


async def test_programs_without_a_node_manager_are_reported():
    transports = [UdpTransport(ID, peer=("127.0.0.1", 9)) for _ in range(2)]
    for each in transports:
        await each.open()
    first, second = transports
    first.send(judp.pack(Packet(ID, ROBOT, b"\x02\x2b", 7)))
    assert await first.id_clash() is None
    address = second._socket.getsockname()
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as other:
        other.bind(("127.0.0.1", 0))
        other.settimeout(20)
        other.sendto(HELLO, ("127.0.0.1", address[1]))
        async with asyncio.timeout(20):
            while await second.id_clash() is None:
                await asyncio.sleep(0.01)
        assert await second.id_clash() == f"127.0.0.1:{other.getsockname()[1]}"
        (notice,) = judp.unpack(other.recv(100))
        assert (notice.source, notice.destination) == (ID, ID)
    for each in transports:
        await each.close()


def test_a_node_manager_notes_the_clash_and_tells_the_other():
    router = Router("/here")
    router.components.register(int(ID), LocalPort(f"/here/{int(ID)}"))
    router.receive(HELLO, ELSEWHERE, 0.0)
    ((to, notice),) = router.poll_output()
    assert to == ELSEWHERE
    other = Router("/there")
    other.components.register(int(ID), LocalPort(f"/there/{int(ID)}"))
    other.receive(notice, UdpPort("10.0.0.1", 3794), 0.0)
    assert [port.host for _, port, _ in other.clashes.recent(0.0)] == ["10.0.0.1"]
    assert [(id, port) for id, port, _ in router.clashes.recent(CLASH_LIFETIME)] == [(int(ID), ELSEWHERE)]
    assert list(router.clashes.recent(CLASH_LIFETIME + 1)) == []


def test_forged_packets_cause_few_notices_and_little_memory():
    clashes = IdClashes()
    assert clashes.note(int(ID), ELSEWHERE, 0.0)
    assert not clashes.note(int(ID), ELSEWHERE, 1.0)
    sent = [clashes.note(number, ELSEWHERE, 1.0) for number in range(1, 1000)]
    assert len(list(filter(None, sent))) <= NOTICES_PER_SECOND
    assert len(list(clashes.recent(1.0))) == MAX_CLASHES
