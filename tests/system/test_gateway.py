"""`jauspy up ROBOT --gateway FILE`: an OCU outside drives and sees what is inside.

Three hosts: the OCU's, the gateway's with one part of the robot, and one behind the gateway with another part. The
OCU's has no way to the last one but through the gateway.
"""

from __future__ import annotations

import asyncio
import contextlib
import shutil
import socket
import subprocess
import sys
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest
from tests.node.hosts.switch import Switch

from jauspy.errors import RequestError
from jauspy.ids import EVERYONE, JausID
from jauspy.messages.mobility import QueryLocalPose, ReportLocalPose, SetWrenchEffort
from jauspy.node import status
from jauspy.ocu import OCU
from jauspy.ocu.robot import Robot
from jauspy.protocol import judp, junior
from jauspy.protocol.header import Broadcast, Packet

pytestmark = pytest.mark.alone

HERE, BEHIND = "101.1.102", "101.2.102"
DISTANCE = 0.1  # metres
GATEWAY = """
address = "10.77.0.2"
[[networks]]
name = "vehicle"
address = "10.88.0.1"
multicast_group = "239.255.0.2"
[gateway]
subsystem = 101
inside = ["vehicle"]
[[gateway.rules]]
source = "42.*.*"
[[gateway.rules]]
action = "deny"
network = "vehicle"
messages = ["0x7E00"]
"""

WATCH = """
import select, sys
from jauspy.video.receiver import RtpReceiver
host, port = sys.argv[1].split(":")
pictures = []
with RtpReceiver(host, int(port)) as receiver:
    while not (idrs := [each.is_idr for each in pictures if each.whole]) or True not in idrs[:-2]:
        select.select([receiver], [], [])
        pictures += receiver.take()
print("a whole picture, then others")
"""


def within(host: str, *command: str) -> tuple[str, ...]:
    """A command on that host."""
    return (str(shutil.which("ip")), "netns", "exec", host, *command)


@pytest.fixture
def hosts(switch: Callable[[int], Switch]) -> dict[str, str]:
    """Their names."""
    made = switch(2)
    made.bridge()
    return {"ocu": made.hosts[0], "gate": made.hosts[1], "behind": made.behind(made.hosts[1])}


@pytest.fixture
def folders(root: Path, hosts: dict[str, str], start: Callable[..., object]) -> dict[str, Path]:
    """Everything runs; the local roots."""
    (root / "behind.toml").write_text("extends = 'inc1'\nnode = 2\nvideo_targets = ['10.77.0.0/24']\n")
    (root / "gateway.toml").write_text(GATEWAY)
    folders = {name: root / name for name in ("ocu", "gate", "behind")}
    simple = ("--backend", "kinematic", "--local-root")
    start("node-manager", "--local-root", str(folders["ocu"]), ready="ready", within=within(hosts["ocu"]))
    start(
        "up",
        "inc1",
        *(*simple, str(folders["gate"]), "--gateway", str(root / "gateway.toml")),
        ready="stop it",
        within=within(hosts["gate"]),
    )
    start(
        "up",
        str(root / "behind.toml"),
        *(*simple, str(folders["behind"]), "--address", "10.88.0.2", "--multicast-group", "239.255.0.2"),
        ready="stop it",
        within=within(hosts["behind"]),
    )
    return folders


async def drive(robot: Robot, which: str) -> None:
    """Control it, and see it move."""
    driver, sensor = (robot.component(which).service(name) for name in ("PrimitiveDriver", "LocalPoseSensor"))
    async with driver.control(authority=200):
        await driver.resume()
        await driver.send(SetWrenchEffort(propulsive_linear_effort_x=60.0))
        async with asyncio.timeout(20):
            while (await sensor.query(QueryLocalPose(presence_vector=1), expects=ReportLocalPose)).x < DISTANCE:
                await asyncio.sleep(0.05)


@pytest.mark.slow
async def test_an_ocu_finds_and_drives_both_parts(folders: dict[str, Path]) -> None:
    async with OCU("42.1.1", connect=f"local:{folders['ocu']}") as ocu:
        async with asyncio.timeout(30):
            while len((robot := await ocu.discover(101)).nodes) < 2:
                await asyncio.sleep(0.2)
        for which in (HERE, BEHIND):
            await drive(robot, which)
    counters = (await status.read(folders["gate"]))["counters"]
    assert counters["relayed"] > 10


@pytest.mark.slow
def test_ocu_receives_data_of_both_parts(
    folders: dict[str, Path], hosts: dict[str, str], root: Path, start: Callable[..., object]
) -> None:
    """Video is no JAUS: from behind the gateway it needs a way out by IP, which is opened here."""
    pytest.importorskip("av", reason="the extra 'video' is not installed")
    for command in (
        within(hosts["gate"], "sh", "-c", "echo 1 > /proc/sys/net/ipv4/ip_forward"),
        within(hosts["behind"], "ip", "route", "add", "default", "via", "10.88.0.1"),
    ):
        subprocess.run(command, check=True, timeout=20)
    ocu = within(hosts["ocu"])
    for number, camera in ((7, "101.1.107"), (8, "101.2.107")):
        to = f"10.77.0.1:50{number}0"
        options = [
            "--to",
            to,
            "--sdp",
            str(root / "sdp"),
            "--connect",
            f"local:{folders['ocu']}",
            "--id",
            f"42.1.{number}",
        ]
        start("video", camera, *options, "--timeout", "10", ready="sends to", within=ocu)
        seen = subprocess.run(
            [*ocu, sys.executable, "-c", WATCH, to], capture_output=True, text=True, timeout=200, check=False
        )
        assert seen.stdout == "a whole picture, then others\n", seen.stderr


@pytest.mark.slow
async def test_an_ocu_without_a_rule_finds_nothing(folders: dict[str, Path]) -> None:
    async with OCU("43.1.1", connect=f"local:{folders['ocu']}") as ocu:
        with pytest.raises(RequestError):
            await ocu.discover(101, timeout=1.0)
        for which in (HERE, BEHIND):
            with pytest.raises(RequestError):
                await ocu.query(which, QueryLocalPose(presence_vector=1), timeout=0.2, retries=1)
    counters = (await status.read(folders["gate"]))["counters"]
    assert counters["dropped.gateway.rule"] > 4


@contextlib.contextmanager
def component(folder: Path, id: JausID) -> Iterator[Callable[[Packet | None], Packet]]:
    """Sends a packet, or gives the next one that arrived."""
    with socket.socket(socket.AF_UNIX, socket.SOCK_DGRAM) as sock:
        sock.settimeout(20)
        sock.bind(str(folder / str(int(id))))
        node = str(folder / junior.SOCKET_NAME)
        sock.sendto(junior.connect(id), node)
        assert sock.recv(100) == junior.accept(id)

        def talk(packet: Packet | None) -> Packet:
            if packet is not None:
                sock.sendto(judp.pack(packet), node)
                return packet
            return judp.unpack(sock.recv(5000))[0]

        yield talk


@pytest.mark.slow
def test_broadcast_crosses_once_without_loop(folders: dict[str, Path]) -> None:
    """Both ways; heard by a component of this test's own on each side."""
    ids = JausID.parse("42.1.9"), JausID.parse("101.2.9")
    with component(folders["ocu"], ids[0]) as outside, component(folders["behind"], ids[1]) as inside:
        for speak, listen, source, destination in ((outside, inside, *ids), (inside, outside, *ids[::-1])):
            for number in range(20):
                speak(Packet(source, EVERYONE, b"\x00\x7f", number, broadcast=Broadcast.GLOBAL))
            speak(Packet(source, EVERYONE, b"\x00\x7f", 99, broadcast=Broadcast.LOCAL))
            speak(Packet(source, destination, b"\x00\x7f", 100))
            heard = []
            while not heard or heard[-1] != 100:
                packet = listen(None)
                if packet.source == source and packet.payload == b"\x00\x7f":
                    heard.append(packet.sequence)
            assert heard == [*range(20), 100]


@pytest.mark.slow
async def test_packets_refused_by_a_rule_are_counted(folders: dict[str, Path]) -> None:
    ocu, module = JausID.parse("42.1.9"), JausID.parse("101.2.9")
    with component(folders["ocu"], ocu) as outside, component(folders["behind"], module) as inside:
        outside(Packet(ocu, module, b"\x00\x7f", 1))
        while inside(None).payload != b"\x00\x7f":
            pass
        for number in range(5):
            inside(Packet(module, ocu, b"\x00\x7e", number))
        inside(Packet(module, ocu, b"\x00\x7f", 5))
        while (heard := outside(None).payload) != b"\x00\x7f":
            assert heard != b"\x00\x7e"
    counters = (await status.read(folders["gate"]))["counters"]
    assert counters["dropped.gateway.rule"] == 5
