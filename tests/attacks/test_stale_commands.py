"""A process stands still while an operator sends commands and goes away; what waited must not be carried out."""

from __future__ import annotations

import asyncio
import json
import signal
import socket
import subprocess
import sys
import time
from pathlib import Path

import pytest
from tests.node.daemon import DaemonProcess

from jauspy.ids import JausID
from jauspy.messages.core import Resume
from jauspy.messages.mobility import SetWrenchEffort
from jauspy.protocol import judp
from jauspy.protocol.header import Ack, Packet
from jauspy.testing import VirtualNetwork
from jauspy.transport import LocalTransport, UdpTransport
from jauspy.transport.age import MAX_AGE

OPERATOR, ROBOT = JausID.parse("42.1.1"), JausID.parse("101.1.30")
EFFORT = SetWrenchEffort(propulsive_linear_effort_x=60.0).encode()


def command(number: int, ack: Ack = Ack.NONE) -> bytes:
    return judp.pack(Packet(OPERATOR, ROBOT, EFFORT, number, ack=ack))


@pytest.mark.slow
@pytest.mark.usefixtures("kernel_stamps")
def test_a_node_manager_that_was_stopped_hands_on_only_what_is_acknowledged_or_new(
    daemon_process: DaemonProcess, root: Path
) -> None:
    robot, operator = daemon_process.component("101.1.30"), daemon_process.peer()
    operator.says(command(0).hex())
    robot.hears(command(0).hex())
    daemon_process.process.send_signal(signal.SIGSTOP)
    for number in range(1, 40):
        operator.says(command(number).hex())
    operator.says(command(40, Ack.REQUIRED).hex())
    time.sleep(MAX_AGE + 0.1)
    daemon_process.process.send_signal(signal.SIGCONT)
    operator.says(command(41).hex())
    robot.hears(command(40, Ack.REQUIRED).hex())
    robot.hears(command(41).hex())
    assert dropped_as_stale(root) == 39


def dropped_as_stale(root: Path) -> int:
    command = (sys.executable, "-m", "jauspy.cli.main", "node-manager", "--status", "--json", "--local-root", str(root))
    found = json.loads(subprocess.run(command, capture_output=True, check=True, timeout=60).stdout)
    return int(found["counters"]["dropped.stale"])


@pytest.mark.slow
async def test_a_robot_that_was_stopped_does_not_drive_off_afterwards() -> None:
    async with VirtualNetwork() as network, network.robot() as robot, network.ocu() as ocu:
        driver = (await ocu.discover(101)).service("PrimitiveDriver")
        async with driver.control():
            network.stall(driver.id, 2.0)
            for _ in range(20):
                await ocu.send(driver.id, Resume())
                await ocu.send(driver.id, SetWrenchEffort(propulsive_linear_effort_x=60.0))
                await asyncio.sleep(0.01)
            network.disconnect(ocu.id)
            await asyncio.sleep(10.0)
            assert robot.snapshot is not None
            assert abs(robot.snapshot.pose.x) < 0.01
            assert robot.counters[f"{driver.id}.transport.dropped.stale"] >= 40
            network.reconnect(ocu.id)


@pytest.mark.usefixtures("kernel_stamps")
@pytest.mark.parametrize("kind", ["local", "udp"])
async def test_a_component_whose_event_loop_hung_drops_what_waited(kind: str, root: Path, free_port: int) -> None:
    """While it handles its first command, others arrive; the last one is new."""
    arrived: list[int] = []
    peer = socket.socket(socket.AF_UNIX if kind == "local" else socket.AF_INET, socket.SOCK_DGRAM)
    with peer:
        transport: LocalTransport | UdpTransport
        if kind == "local":
            transport = LocalTransport(ROBOT, root, timeout=None)
            address: str | tuple[str, int] = str(transport.path)
        else:
            address = own = ("127.0.0.1", free_port)
            transport = UdpTransport(ROBOT, peer=("127.0.0.1", 9), bind=own)
        transport.max_age = 0.1

        def handle(datagram: bytes) -> None:
            number = judp.unpack(datagram)[0].sequence
            arrived.append(number)
            if number == 0:
                for later in (1, 2, 3):
                    peer.sendto(command(later), address)
                peer.sendto(command(4, Ack.REQUIRED), address)
                time.sleep(0.15)
                peer.sendto(command(5), address)

        transport.received = handle
        await transport.open()
        peer.sendto(command(0), address)
        async with asyncio.timeout(20):
            while 5 not in arrived:
                await asyncio.sleep(0.01)
        await transport.close()
    assert arrived == [0, 4, 5]
    assert transport.counters["dropped.stale"] == 3
