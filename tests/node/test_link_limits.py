"""Limits of slow links, seen from outside: what arrives, in which order, and what the status says of the rest."""

import asyncio
import contextlib
import json
import socket
import time
from pathlib import Path

import pytest
from hypothesis import given, strategies as st
from tests.node.daemon import Daemon

from jauspy.cli import node_manager as cli
from jauspy.errors import ConfigError
from jauspy.ids import EVERYONE, JausID
from jauspy.logs import get_logger
from jauspy.messages import registry
from jauspy.messages.core import Event
from jauspy.messages.mobility import ReportLocalPose
from jauspy.node import NodeConfig, NodeManager, metrics, status
from jauspy.node.link_limits import make_link_limit, parse_rate
from jauspy.node.link_shaper import LinkShaper
from jauspy.protocol import judp, junior
from jauspy.protocol.addressing import UdpPort
from jauspy.protocol.counters import Counters
from jauspy.protocol.header import Ack, Broadcast, DataFlag, Packet, Priority
from jauspy.protocol.link_limits import (
    HEADER_BYTES,
    MAX_KINDS,
    MAX_STREAMS,
    LeftOutCounts,
    LinkLimits,
    TotalLimit,
    message_code,
)

ROBOT, OPERATOR = JausID.parse("101.1.1"), JausID.parse("42.1.1")
POSE = ReportLocalPose(x=1.0).encode()
STATUS = b"\x02\x40\x01"
FEW = "0.001/s"
"""A limit of which nothing comes back during a test: two messages pass."""


def packet(
    payload: bytes,
    sequence: int = 0,
    priority: Priority = Priority.STANDARD,
    *,
    flag: DataFlag = DataFlag.SINGLE,
    ack: Ack = Ack.NONE,
    destination: JausID = OPERATOR,
) -> bytes:
    return judp.pack(Packet(ROBOT, destination, payload, sequence, priority, ack=ack, data_flag=flag))


async def receive(sock: socket.socket, count: int = 1) -> list[bytes]:
    async with asyncio.timeout(20):
        return [await asyncio.get_running_loop().sock_recv(sock, 70000) for _ in range(count)]


class Radio:
    """A robot's node manager with limits, and the operator's, on loopback."""

    def __init__(self, root: Path, port: int, introduce, limit: dict[str, str]) -> None:
        self.folders = [root / name for name in ("robot", "operator")]
        there = {str(OPERATOR): f"127.0.0.3:{port}"}
        common = {"port": port, "multicast_group": "239.255.0.7", "max_message_age": 0}
        self.near = NodeManager(
            NodeConfig.make(address="127.0.0.1", local_root=self.folders[0], addresses=there, limit=limit, **common)
        )
        self.far = NodeManager(NodeConfig.make(address="127.0.0.3", local_root=self.folders[1], **common))
        self._introduce = introduce

    async def open(self, stack: contextlib.AsyncExitStack) -> tuple[socket.socket, socket.socket]:
        for node in (self.near, self.far):
            await stack.enter_async_context(node)
        robot, operator = self._introduce(ROBOT, self.folders[0]), self._introduce(OPERATOR, self.folders[1])
        assert await receive(robot) == [junior.accept(ROBOT)]
        assert await receive(operator) == [junior.accept(OPERATOR)]
        return robot, operator

    async def send(self, robot: socket.socket, *datagrams: bytes) -> None:
        for datagram in datagrams:
            await asyncio.get_running_loop().sock_sendto(robot, datagram, str(self.near.path))


async def test_messages_beyond_their_rate_are_left_out_counted_and_shown(
    root: Path, free_port: int, introduce, capsys: pytest.CaptureFixture[str]
) -> None:
    radio = Radio(root, free_port, introduce, {"ReportLocalPose": FEW})
    async with contextlib.AsyncExitStack() as stack:
        robot, operator = await radio.open(stack)
        poses = [packet(POSE, number) for number in range(20)]
        urgent = [packet(POSE, 100 + number, Priority.SAFETY_CRITICAL) for number in range(5)]
        last = packet(STATUS, 200)
        await radio.send(robot, *poses, *urgent, last)
        assert sorted(await receive(operator, 8)) == sorted([*poses[:2], *urgent, last])
        reported = status.with_rates(*[await status.read(radio.folders[0])] * 2)
        assert reported["left_out"] == [
            {"message": "ReportLocalPose 4403h", "link": "lan", "limit": f"ReportLocalPose {FEW}", "count": 18}
        ]
        assert reported["networks"][0]["limit"] == {"ReportLocalPose": FEW}
        assert radio.near.counters["dropped.link_limit"] == 18
        cli._show(reported)
        shown = capsys.readouterr().out
        assert (
            "left out by the limits of links:\n  ReportLocalPose 4403h  on lan  ReportLocalPose 0.001/s  18\n" in shown
        )
        names = [
            sample for family in metrics.NodeCollector(lambda: radio.near.state).collect() for sample in family.samples
        ]
        (sample,) = [sample for sample in names if sample.name == "jauspy_node_left_out_total"]
        assert (sample.labels["message"], sample.value) == ("0x4403", 18)


async def test_link_carries_no_more_than_its_rate_and_urgent_packets_do_not_wait(
    root: Path, free_port: int, introduce
) -> None:
    """What has arrived at any moment fits the rate, also on a slow machine; what was sent is accounted for."""
    rate = 250_000.0
    radio = Radio(root, free_port, introduce, {"all": "250 kbit/s"})
    async with contextlib.AsyncExitStack() as stack:
        robot, operator = await radio.open(stack)
        sent = [packet(STATUS + bytes(485), number) for number in range(200)]
        stop = packet(STATUS, 999, Priority.SAFETY_CRITICAL)
        began = time.monotonic()
        await radio.send(robot, *sent, stop)
        arrived: list[bytes] = []
        while len(arrived) + sum(radio.near._router.limits.left_out.values()) < len(sent) + 1:
            arrived += await receive(operator)
            bits = sum(8 * (len(datagram) + HEADER_BYTES) for datagram in arrived)
            spent = 0.05 * rate + (time.monotonic() - began) * rate
            assert bits <= spent + 8 * (len(sent[0]) + len(stop) + 2 * HEADER_BYTES)
        assert arrived.index(stop) < 20
        arrived.remove(stop)
        assert arrived == sorted(arrived, key=sent.index)
        assert len(arrived) < len(sent)
        (left_out,) = (await status.read(radio.folders[0]))["left_out"]
        assert left_out == {
            "message": "ReportStatus 4002h",
            "link": "lan",
            "limit": "all 250 kbit/s",
            "count": len(sent) - len(arrived),
        }


async def test_reload_changes_limits_of_all_networks(root: Path, introduce, udp) -> None:
    peer = udp()
    host, port = peer.getsockname()
    settings = {"address": "127.0.0.1", "port": 0, "local_root": root, "addresses": {str(OPERATOR): f"{host}:{port}"}}
    radio = {"name": "radio", "address": "127.0.0.9", "port": 0}
    limited = NodeConfig.make(**settings, networks=[radio], limit={"ReportLocalPose": FEW})
    async with NodeManager(limited) as node:
        robot = introduce(ROBOT)
        await receive(robot)
        for number in range(3):
            robot.sendto(packet(POSE, number), str(node.path))
        robot.sendto(packet(STATUS, 3), str(node.path))
        assert [judp.unpack(data)[0].sequence for data in await receive(peer, 3)] == [0, 1, 3]
        assert node.reload(NodeConfig.make(**settings, networks=[radio | {"limit": {"all": "1 Mbit/s"}}])) == []
        assert list(node.state.shapers) == ["radio"]
        for number in range(10, 14):
            robot.sendto(packet(POSE, number), str(node.path))
        assert [judp.unpack(data)[0].sequence for data in await receive(peer, 4)] == [10, 11, 12, 13]
        other = radio | {"limit": {"all": "1 Mbit/s"}, "multicast_ttl": 3}
        assert node.reload(NodeConfig.make(**settings, networks=[other])) == ["networks"]


def test_serial_line_has_limits_of_its_own(root: Path, free_port: int) -> None:
    """Broadcasts pass by its limit, and reach a peer by TCP on the network of the same node manager without one."""

    class Limited(Daemon):
        def start(self) -> None:
            self._config.write_text(
                self._config.read_text() + f'limit = {{ "ReportStatus" = "{FEW}", "all" = "1 Mbit/s" }}\n'
            )
            super().start()

    with contextlib.ExitStack() as stack:
        daemon = Limited(stack, root, free_port)
        robot, stream = daemon.component(str(ROBOT)), daemon.stream()
        hello = judp.pack(Packet(OPERATOR, ROBOT, STATUS, 1)).hex()
        stream.says(hello)
        robot.hears(hello)
        reports = [
            judp.pack(Packet(ROBOT, EVERYONE, STATUS, number, broadcast=Broadcast.GLOBAL)) for number in range(4)
        ]
        for report in [*reports, judp.pack(Packet(ROBOT, EVERYONE, POSE, 9, broadcast=Broadcast.GLOBAL))]:
            robot.says(report.hex())
        stream.hears_stream("02" + "".join(report[1:].hex() for report in reports))
        found = json.loads(asyncio.run(_read(daemon)))
        assert [(kind["link"][:5], kind["message"], kind["count"]) for kind in found["left_out"]] == [
            ("/dev/", "ReportStatus 4002h", 2)
        ]


async def _read(daemon: Daemon) -> str:
    async with asyncio.timeout(20):
        while not (found := await status.read(daemon.root))["left_out"]:
            await asyncio.sleep(0.01)
    return json.dumps(found)


class Limits(LinkLimits):
    """Of one link, with the time that passes."""

    def __init__(self, **limits: str) -> None:
        super().__init__({"radio": make_link_limit(limits)})

    def passes(self, *datagrams: bytes, now: float = 0.0) -> list[bool]:
        return [self.admits("radio", datagram, now) for datagram in datagrams]


def test_steady_reports_keep_their_rate() -> None:
    limits = Limits(ReportLocalPose="5/s")
    passed = [now for now in range(100) if limits.passes(packet(POSE), now=0.1 * now + 0.003 * (now % 3))[0]]
    assert len(passed) == pytest.approx(51, abs=1)
    assert limits.passes(packet(POSE, destination=EVERYONE), now=9.9) == [True], "another destination has its own rate"


def test_reports_in_events_count_as_such_and_acknowledgements_pass() -> None:
    limits = Limits(ReportLocalPose=FEW)
    event = packet(Event(1, 2, POSE).encode())
    assert limits.passes(event, packet(POSE), event, packet(POSE)) == [True, True, False, False]
    assert (
        limits.passes(packet(Event(1, 2, STATUS).encode()), packet(b"", ack=Ack.ACK), packet(b"", ack=Ack.NAK))
        == [True] * 3
    )
    assert message_code(event) == 0x4403


def test_large_messages_pass_or_are_left_out_as_a_whole() -> None:
    limits = Limits(ReportLocalPose=FEW)
    parts = [
        packet(POSE, 1, flag=DataFlag.FIRST),
        packet(b"xx", 2, flag=DataFlag.MIDDLE),
        packet(b"x", 3, flag=DataFlag.LAST),
    ]
    assert [limits.passes(*parts) for _ in range(3)] == [[True] * 3, [True] * 3, [False] * 3]
    assert list(limits.left_out.values()) == [1]
    other = [packet(STATUS, 4, flag=DataFlag.FIRST), parts[1], parts[2]]
    assert limits.passes(*other) == [True] * 3


def test_limit_in_bits_counts_what_the_link_carries() -> None:
    limits = Limits(ReportLocalPose="8 kbit/s")
    report = packet(POSE + bytes(1000 - len(packet(POSE)) - HEADER_BYTES))
    passed = sum(limits.passes(report, now=0.1 * number)[0] for number in range(100))
    assert passed == pytest.approx(10, abs=1), "1000 bytes a second"


def test_first_limit_that_matches_counts() -> None:
    limits = LinkLimits({"radio": make_link_limit({"ReportLocalPose": "1000/s", "0x4000-0x4FFF": FEW})})
    assert all(limits.admits("radio", packet(POSE), 0.0) for _ in range(2))
    assert [limits.admits("radio", packet(STATUS), 0.0) for _ in range(3)] == [True, True, False]
    assert limits.admits("lan", packet(STATUS), 0.0)


@given(st.binary(max_size=60), st.integers(0, 255))
def test_no_packet_raises(data: bytes, control: int) -> None:
    limits = Limits(**{"0x0000-0xFFFF": "5/s"})
    limits.admits("radio", data, 0.0)
    message_code(data)
    whole = bytearray(packet(data))
    whole[4] = control
    limits.admits("radio", bytes(whole), 0.0)
    message_code(bytes(whole))


def test_tables_are_bounded_whatever_ids_are_invented() -> None:
    limits = Limits(**{"0x0000-0xFFFF": FEW})
    for number in range(3 * MAX_STREAMS):
        payload = (number & 0xFFFF).to_bytes(2, "little") + b"xx"
        source = JausID.from_int(0x10101 + number)
        for _ in range(3):
            limits.admits("radio", judp.pack(Packet(source, OPERATOR, payload, data_flag=DataFlag.FIRST)), 0.0)
    assert len(limits._streams) == MAX_STREAMS
    assert len(limits.left_out) == MAX_KINDS


async def test_queue_of_a_slow_link_is_bounded_and_its_oldest_least_urgent_goes_first() -> None:
    sent: list[bytes] = []
    left_out = LeftOutCounts()
    shaper = LinkShaper(
        "radio",
        TotalLimit(8000.0, "all 8 kbit/s"),
        lambda _, datagram: sent.append(datagram),
        counters=Counters(get_logger(__name__)),
        left_out=left_out,
        max_age=10.0,
    )
    port = UdpPort("127.0.0.1", 3794, "radio")
    for number in range(1000):
        shaper.send(port, packet(STATUS + bytes(500), number))
        shaper.send(port, packet(POSE, number, Priority.HIGH))
        assert shaper.queued_bytes < 20_000
    assert sum(left_out.values()) + len(shaper) + len(sent) == 2000
    assert {kind.code for kind in left_out} == {0x4002, 0x4403}
    before = len(sent)
    shaper.send(port, packet(STATUS, 1, Priority.SAFETY_CRITICAL))
    assert len(sent) == before + 1
    shaper.close()
    assert len(shaper) == 0


@pytest.mark.parametrize(
    ("key", "text", "reported"),
    [
        ("ReportLocalPose", "5", 'write messages per second, as in "5/s", or bits per second'),
        ("ReportLocalPose", "-5/s", "write messages per second"),
        ("ReportLocalPose", "0/s", "write messages per second"),
        ("ReportLocalPose", "9" * 400 + "/s", "write messages per second"),
        ("all", "5/s", 'all traffic has a rate in bits, as in "250 kbit/s"'),
        ("ReportLocalPoes", "5/s", "no message ReportLocalPoes is known; did you mean ReportLocalPose"),
        ("video", "2 Mbit/s", "video does not pass the node manager; set `bit_rate` of the cameras"),
    ],
)
def test_mistakes_are_one_sentence(key: str, text: str, reported: str) -> None:
    with pytest.raises(ConfigError) as caught:
        NodeConfig.make(limit={key: text})
    assert str(caught.value).startswith(f"node manager setting limit.{key} = {text!r}: ")
    assert reported in str(caught.value)
    with pytest.raises(ConfigError, match=r"serial\[0\]\.limit\."):
        NodeConfig.make(serial=[{"device": "/dev/ttyUSB0", "limit": {key: text}}])


def test_rates_have_units() -> None:
    assert [parse_rate(text) for text in ("5/s", "0.5 /s", "9600 bit/s", "250kbit/s", "2 Mbit/s")] == [
        (5.0, False),
        (0.5, False),
        (9600.0, True),
        (250e3, True),
        (2e6, True),
    ]
    assert registry.by_name("ReportLocalPose").CODE == 0x4403
