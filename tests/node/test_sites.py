"""Two sites in one process: each has a gateway, and these are joined by JTCP or JUDP, as docs/sites.md says."""

from __future__ import annotations

import asyncio
import socket
from collections.abc import AsyncIterator, Callable
from contextlib import AsyncExitStack
from pathlib import Path
from typing import NamedTuple

import pytest
from tests.helpers.robot import FakeDrive

from jauspy.component import Component
from jauspy.component.component import loop_time
from jauspy.errors import ConfigError, JausError
from jauspy.ids import JausID
from jauspy.messages.mobility import QueryWrenchEffort, SetWrenchEffort
from jauspy.node import NodeConfig, NodeManager
from jauspy.ocu import OCU
from jauspy.protocol import judp
from jauspy.protocol.header import Packet, Priority
from jauspy.protocol.seal import Operator, OperatorKey
from jauspy.services.core import AccessControl, CommandSeal, Discovery, Events, Liveness
from jauspy.services.mobility import PrimitiveDriver, Vehicle
from jauspy.testing import until
from jauspy.transport import LocalTransport, age

ROBOT, OPERATOR = JausID.parse("101.1.1"), JausID.parse("42.1.1")
SEALED_ONLY = [
    {
        "source": "42.*.*",
        "messages": ["SealedCommand", "QuerySealChallenge", "0x2000-0x5FFF", "Standby", "SetEmergency", "CreateEvent"],
    },
]
WAYS = pytest.mark.parametrize("way", ["tcp", "udp"])


class Sites(NamedTuple):
    """The gateways of robots and operators."""

    robots: NodeManager
    operators: NodeManager


async def join(
    root: Path, port: int, stack: AsyncExitStack, way: str, *rules: dict[str, object], **settings: object
) -> Sites:
    """Sites that are joined; `settings` are of the robots' gateway."""
    made = []
    for number, (subsystem, peer) in enumerate(((101, 42), (42, 101))):
        outside, inside, there = (f"127.0.0.{octet}" for octet in (2 * number + 11, 2 * number + 12, 13 - 2 * number))
        addresses = {} if (way, number) == ("tcp", 0) else {f"{peer}.255.255": f"{way}://{there}:{port}"}
        network = {"name": "site", "address": inside, "port": port, "multicast_group": f"239.255.0.{number + 2}"}
        config = NodeConfig.make(
            name="wan",
            address=outside,
            port=port,
            local_root=root / str(number),
            tcp=way == "tcp",
            addresses=addresses,
            networks=[network],
            gateway={"subsystem": subsystem, "inside": ["site"], "rules": rules if number == 0 else ()},
            **(settings if number == 0 else {}),
        )
        made.append(await stack.enter_async_context(NodeManager(config)))
    return Sites(*made)


@pytest.fixture
async def resources() -> AsyncIterator[AsyncExitStack]:
    async with AsyncExitStack() as opened:
        yield opened


@WAYS
async def test_only_sealed_commands_cross_where_the_rules_say_so(
    root: Path, free_port: int, resources: AsyncExitStack, way: str
) -> None:
    """The gateway refuses commands without a seal, the robot those whose seal is not of its operators."""
    pytest.importorskip("cryptography", reason="keys of operators need the extra 'operators'")
    keys = {name: root / f"{name}.key" for name in ("alice", "mallory")}
    for path in keys.values():
        path.write_bytes(OperatorKey.generate().pem())
        path.chmod(0o600)
    public = OperatorKey.from_pem(keys["alice"].read_bytes()).public
    sites = await join(root, free_port, resources, way, *SEALED_ONLY)
    seal = CommandSeal([Operator("alice", "operator", 127, public)], secret=bytes(32))
    driver = PrimitiveDriver(Vehicle(FakeDrive(clock=loop_time)))
    services = [AccessControl(), Events(), Discovery(), Liveness(), driver, seal]
    transport = LocalTransport(ROBOT, sites.robots.config.local_root)
    robot = await resources.enter_async_context(Component(ROBOT, services, transport=transport, core=False))

    async def operator(number: int, key: Path | None) -> OCU:
        id = JausID(42, 1, number)
        transport = LocalTransport(id, sites.operators.config.local_root)
        return await resources.enter_async_context(OCU(id, transport=transport, operator=key))

    alice, mallory, nobody = (
        await operator(1, keys["alice"]),
        await operator(2, keys["mallory"]),
        await operator(3, None),
    )
    service = (await alice.discover(101)).component(ROBOT).service("PrimitiveDriver")
    async with service.control(127):
        await service.resume()
        await service.send(SetWrenchEffort(propulsive_linear_effort_x=40.0), ack=True)
        found = await service.query(QueryWrenchEffort(0xFFFF))
        assert found.propulsive_linear_effort_x == pytest.approx(40.0, abs=0.1)
        for other in (mallory, nobody):
            stranger = (await other.discover(101)).component(ROBOT).service("PrimitiveDriver")
            with pytest.raises(JausError):
                async with stranger.control(255):
                    pytest.fail("a stranger has control")
        assert robot.controller == alice.id
    assert sites.robots.counters["dropped.gateway.rule"] > 0
    assert any("unknown_operator" in name for name in robot.counters)
    assert not any("no_seal" in name for name in robot.counters)


@WAYS
async def test_rates_hold_between_sites(
    root: Path, free_port: int, resources: AsyncExitStack, introduce: Callable[..., socket.socket], way: str
) -> None:
    sites = await join(root, free_port, resources, way, {"source": "42.*.*", "rate": 5})
    robot, operator = (
        introduce(ROBOT, sites.robots.config.local_root),
        introduce(OPERATOR, sites.operators.config.local_root),
    )
    if way == "tcp":
        await until(lambda: sites.operators.counters["tcp.connected"] > 0)
    for number in range(50):
        packet = Packet(OPERATOR, ROBOT, b"\x05\x04", number)
        await asyncio.get_running_loop().sock_sendto(operator, judp.pack(packet), str(sites.operators.path))
    await until(lambda: sites.robots.counters["dropped.gateway.rule_rate"] >= 40)
    assert len(await asyncio.get_running_loop().sock_recv(robot, 100)) > 0


async def test_a_stop_does_not_wait_behind_what_a_slow_connection_has(
    root: Path, free_port: int, resources: AsyncExitStack, introduce: Callable[..., socket.socket]
) -> None:
    """The peer reads nothing while reports are sent, then all: the urgent packet is before most of them."""
    sites = await join(root, free_port, resources, "tcp")
    root = sites.robots.config.local_root
    robot, loop = introduce(ROBOT, root), asyncio.get_running_loop()
    peer = resources.enter_context(socket.socket())
    peer.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 4096)
    peer.setblocking(False)
    await loop.sock_connect(peer, ("127.0.0.11", sites.robots.tcp_port))
    await loop.sock_sendall(peer, judp.pack(Packet(OPERATOR, ROBOT, b"\x02\x20", 0)))
    while len(await loop.sock_recv(robot, 100)) < 15 or sites.robots.counters["received.tcp"] < 1:
        pass
    reports = 400
    for number in range(reports):
        packet = Packet(ROBOT, OPERATOR, b"\x02\x44".ljust(1000, b"\0"), number, priority=Priority.LOW)
        await loop.sock_sendto(robot, judp.pack(packet), str(sites.robots.path))
    urgent = judp.pack(Packet(ROBOT, OPERATOR, b"\x06\x00", 9999, priority=Priority.SAFETY_CRITICAL))
    await loop.sock_sendto(robot, urgent, str(sites.robots.path))
    await until(lambda: sites.robots.counters["routed.tcp"] >= reports + 1)
    arrived = bytearray()
    while len(arrived) < reports * 1000:
        async with asyncio.timeout(20):
            arrived += await loop.sock_recv(peer, 65536)
    assert 0 < arrived.find(urgent[1:]) < 60_000


class Connection:
    """Stands for a TCP socket: packets that are not acknowledged, and the time since the last acknowledgement, s."""

    def __init__(self) -> None:
        self.packets, self.silent = 0, 0.0

    def getsockopt(self, *_: int) -> bytes:
        return age._TCP_INFO.pack(self.packets, round(1000 * self.silent))


def test_old_data_is_noticed_only_while_nothing_is_acknowledged() -> None:
    connection = Connection()
    watch = age.AckWatch(connection, 0.0)  # type: ignore[arg-type]
    connection.silent = 100.0  # idle for long, and now something is sent
    assert not watch.is_overdue(100.0)
    connection.packets = 1
    assert not watch.is_overdue(100.5)
    connection.packets, connection.silent = 7, 0.3  # a busy link with losses
    assert not any(watch.is_overdue(101.0 + number) for number in range(10))
    connection.silent = 2.1
    assert watch.is_overdue(112.0)
    connection.packets = 0
    assert not watch.is_overdue(113.0)


@pytest.mark.parametrize(
    ("wrong", "reason"),
    [
        (["120-102"], "write a subsystem or a range"),
        (["0"], "write a subsystem or a range"),
        (["1-65535"], "write a subsystem or a range"),
        (["42.1.1"], "write a subsystem or a range"),
        (["\u0661"], "write a subsystem or a range"),
        ([True], "further_subsystems"),
        (["1"] * 65, "further_subsystems"),
    ],
)
def test_wrong_subsystems_of_a_site_are_explained(wrong: list[object], reason: str) -> None:
    with pytest.raises(ConfigError, match=reason):
        NodeConfig.make(gateway={"subsystem": 1, "further_subsystems": wrong})


def test_subsystems_are_numbers_or_ranges() -> None:
    config = NodeConfig.make(gateway={"subsystem": 101, "further_subsystems": [42, "102-104"]})
    assert config.gateway is not None
    assert config.gateway.further_subsystems == ("42", "102-104")
