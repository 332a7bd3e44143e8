"""Two sites on a link that is cut: what is local goes on, and commands from before do not arrive afterwards."""

from __future__ import annotations

import json
import select
import shutil
import socket
import subprocess
import time
from collections.abc import Callable, Iterator
from contextlib import ExitStack
from pathlib import Path

import pytest
from tests.node.hosts.switch import Switch

from jauspy.ids import JausID
from jauspy.protocol import judp, junior
from jauspy.protocol.header import Packet
from jauspy.transport.age import MAX_AGE, MAX_UNACKNOWLEDGED
from jauspy.transport.tcp import ACK_CHECK_INTERVAL

pytestmark = [pytest.mark.alone, pytest.mark.slow]

ROBOT, LOCAL_OPERATOR, FAR_OPERATOR = (JausID.parse(text) for text in ("101.1.1", "103.1.1", "42.1.1"))
CUT = 6.0
"""Seconds."""
OLDEST = MAX_UNACKNOWLEDGED + ACK_CHECK_INTERVAL + MAX_AGE + 0.5
"""Seconds: what may have been under way, the times between two looks at it, in the queue before, and on the link."""
GATEWAY = """
name = "wan"
address = "10.77.0.{number}"
local_root = "{root}"
tcp = {tcp}
[addresses]
{peer}
[gateway]
subsystem = {subsystem}
further_subsystems = ["103"]
[[gateway.rules]]
source = "{other}.*.*"
"""


class Component:
    """Sends the time in commands, and notes what it receives."""

    def __init__(self, id: JausID, root: Path, stack: ExitStack) -> None:
        self.id = id
        self.sock = stack.enter_context(socket.socket(socket.AF_UNIX, socket.SOCK_DGRAM))
        self._node = str(root / junior.SOCKET_NAME)
        self.sock.bind(str(root / str(int(id))))
        self.sock.settimeout(20)
        self.sock.sendto(junior.connect(id), self._node)
        assert self.sock.recv(100) == junior.accept(id)
        self.received: list[tuple[int, float, float]] = []
        """Source, time of sending, and of arrival."""

    def command(self, to: JausID) -> None:
        body = b"\x05\x04" + str(time.monotonic()).encode()
        self.sock.sendto(judp.pack(Packet(self.id, to, body)), self._node)

    def receive(self, seconds: float) -> None:
        end = time.monotonic() + seconds
        while select.select([self.sock], [], [], max(0.0, end - time.monotonic()))[0]:
            packet = judp.unpack(self.sock.recv(5000))[0]
            self.received.append((int(packet.source), float(packet.payload[2:]), time.monotonic()))


@pytest.fixture
def stack() -> Iterator[ExitStack]:
    with ExitStack() as opened:
        yield opened


def word(relay: subprocess.Popen[str], text: str) -> None:
    assert relay.stdin is not None
    relay.stdin.write(f"{text}\n")
    relay.stdin.flush()


@pytest.mark.parametrize("way", ["tcp", "udp"])
def test_a_site_that_is_cut_off_works_on_and_gets_no_old_commands(
    switch: Callable[[int], Switch], root: Path, start: Callable[..., object], stack: ExitStack, way: str
) -> None:
    made = switch(2)
    relay = made.relay(wide_area=True, latency=0.05, loss=0, twice=0, delay=0)
    for number, (subsystem, other) in enumerate(((101, 42), (42, 101)), 1):
        folder = root / str(number)
        folder.mkdir()
        peer = "" if (way, number) == ("tcp", 1) else f'"{other}.255.255" = "{way}://10.77.0.{3 - number}:3794"'
        text = GATEWAY.format(
            number=number, root=folder, tcp=json.dumps(way == "tcp"), peer=peer, subsystem=subsystem, other=other
        )
        (folder / "gateway.toml").write_text(text)
        within = (str(shutil.which("ip")), "netns", "exec", made.hosts[number - 1])
        start("node-manager", "--config", str(folder / "gateway.toml"), ready="ready", within=within)
    robot, local = (Component(id, root / "1", stack) for id in (ROBOT, LOCAL_OPERATOR))
    far = Component(FAR_OPERATOR, root / "2", stack)

    def operate(seconds: float, until: Callable[[], bool] = lambda: False) -> None:
        end = time.monotonic() + seconds
        while time.monotonic() < end and not until():
            local.command(ROBOT)
            far.command(ROBOT)
            robot.receive(0.05)

    def from_afar(since: float) -> list[tuple[float, float]]:
        return [(sent, at) for id, sent, at in robot.received if id == int(FAR_OPERATOR) and at > since]

    operate(30.0, until=lambda: len(from_afar(0.0)) > 20)
    assert len(from_afar(0.0)) > 20
    word(relay, "cut")
    cut = time.monotonic()
    operate(CUT)
    assert len([sent for id, sent, _ in robot.received if id == int(LOCAL_OPERATOR) and sent > cut + 0.5]) > 10
    word(relay, "mend")
    mended = time.monotonic()
    operate(30.0, until=lambda: any(sent > mended for sent, _ in from_afar(mended)))
    operate(1.0)
    arrived = from_afar(mended)
    assert max(sent for sent, _ in arrived) > mended
    assert min(sent for sent, _ in arrived) > mended - OLDEST
