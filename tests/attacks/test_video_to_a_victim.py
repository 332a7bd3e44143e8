"""Whoever reaches a camera's component asks for video to others, takes all places, and asks who else watches."""

from __future__ import annotations

import shutil
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest
from tests.robot.cameras import FakeVideo, Module

from jauspy.errors import ConfigError
from jauspy.ids import JausID
from jauspy.messages import environment_sensing as m
from jauspy.messages.core import RequestControl
from jauspy.messages.environment_sensing import ConfirmDigitalResourceEndpoint as Confirm
from jauspy.ocu import OCU
from jauspy.platform.video_settings import RTP_SERVER_TYPE
from jauspy.protocol.addressing import UNKNOWN_LOCATION, Location
from jauspy.services.environment_sensing.digital_resource_discovery import parse_rtp_url
from jauspy.testing.node import LocalNode

OPERATOR, CONSOLE = JausID(42, 1, 1), JausID(42, 1, 2)
ATTACKERS = [JausID(66, 1, each) for each in range(1, 20)]
PLACES = 8
"""Receivers of a camera."""


class SmallCamera(FakeVideo):
    """Has no more places than a real one."""

    def watch(self, address, *, playing=True):
        if address not in self.receivers and len(self.receivers) >= PLACES:
            raise ConfigError("too many")
        super().watch(address, playing=playing)


@pytest.fixture
def module() -> Iterator[Module]:
    made = Module()
    made.video.__class__ = SmallCamera
    made.where = {OPERATOR: Location(hosts=frozenset({"10.0.0.1"})), CONSOLE: Location(hosts=frozenset({"10.0.0.2"}))}
    made.where |= {each: Location(hosts=frozenset({f"10.0.6.{each.component}"})) for each in ATTACKERS}
    yield made
    made.robot.close()


@pytest.mark.parametrize(
    "host",
    [
        "10.0.0.1",
        "10.0.0.255",
        "239.255.0.1",
        "255.255.255.255",
        "0.0.0.0",
        "127.0.0.1",
        "[::1]",
        "[ff02::1]",
        "[::ffff:239.1.2.3]",
        "[::ffff:10.0.0.1]",
    ],
)
def test_video_goes_only_to_the_machine_that_asks(module: Module, host: str) -> None:
    assert module.enter(f"rtp://{host}:5004", ATTACKERS[0]) == 0
    module.where[ATTACKERS[1]] = UNKNOWN_LOCATION
    assert module.enter(f"rtp://{host}:5004", ATTACKERS[1]) == 0
    assert module.video.receivers == {}
    assert module.enter("rtp://10.0.6.1:5004", ATTACKERS[0]) != 0


@pytest.mark.parametrize("port", [22, 1023, 3793, 3794])
def test_video_goes_to_no_port_of_the_system_or_of_jaus(module: Module, port: int) -> None:
    with pytest.raises(ConfigError, match="streams are sent to ports from 1024, and not to that of JAUS"):
        parse_rtp_url(f"rtp://10.0.6.1:{port}")
    assert module.enter(f"rtp://10.0.6.1:{port}", ATTACKERS[0]) == 0


@pytest.mark.parametrize("port", [4793, 4794])
def test_video_goes_to_no_port_of_a_node_manager_with_another_one(module: Module, port: int) -> None:
    module.where[ATTACKERS[0]] = Location(hosts=frozenset({"10.0.6.1"}), ports=frozenset({4794}))
    assert module.enter(f"rtp://10.0.6.1:{port}", ATTACKERS[0]) == 0
    assert module.enter("rtp://10.0.6.1:4795", ATTACKERS[0]) != 0


def test_who_takes_all_places_does_not_lock_the_operator_out(module: Module) -> None:
    for number, each in enumerate(ATTACKERS):
        assert bool(module.enter(f"rtp://10.0.6.{each.component}:5004", each)) == (number < PLACES)
    module.tell(RequestControl(200), client=OPERATOR)
    assert module.enter("rtp://10.0.0.1:5004", OPERATOR)
    assert module.enter("rtp://10.0.0.2:5004", CONSOLE), "the operator's subsystem comes next"
    assert module.enter("rtp://10.0.6.19:5004", ATTACKERS[-1]) == 0
    assert {("10.0.0.1", 5004), ("10.0.0.2", 5004)} < set(module.video.receivers)
    assert len(module.video.receivers) == PLACES


def test_many_ids_of_one_machine_have_one_share(module: Module) -> None:
    for each in ATTACKERS:
        module.where[each] = module.where[ATTACKERS[0]]
        assert module.enter(f"rtp://10.0.6.1:{5000 + 2 * each.component}", each)
    assert len(module.video.receivers) == PLACES // 2
    assert module.enter("rtp://10.0.0.1:5004", OPERATOR)


@pytest.mark.slow
def test_nobody_learns_where_others_watch(module: Module) -> None:
    module.enter("rtp://10.0.0.1:5004", OPERATOR)
    for client, count in ((ATTACKERS[0], 0), (OPERATOR, 1)):
        answer = module.ask(m.QueryDigitalResourceEndpoint(), client)
        assert len(answer.digital_resource_endpoint_list) == count


@pytest.mark.slow
async def test_a_real_robot_refuses_what_is_not_the_clients() -> None:
    """Over UDP to a node manager, which says where clients are."""
    with LocalNode() as node:
        async with node.robot(), OCU("66.1.1", connect=node.udp) as attacker:
            for url in ("rtp://10.1.2.3:5004", "rtp://239.255.0.1:5004", "rtp://127.0.0.1:3794"):
                record = m.RegisterDigitalResourceEndpoint.DigitalResourceEndpointRec(RTP_SERVER_TYPE, url, None, 1)
                request = m.RegisterDigitalResourceEndpoint(m.RegisterDigitalResourceEndpoint.RequestIDRec(1), record)
                assert (await attacker.query("101.1.107", request, expects=Confirm)).id == 0


ASK = """
import asyncio, sys
from jauspy.cli.video import register
from jauspy.errors import RequestError
from jauspy.ids import JausID
from jauspy.ocu import OCU

async def main():
    async with OCU("66.1.1", connect="udp://10.77.0.2:" + sys.argv[1], timeout=8.0) as ocu:
        for host in sys.argv[2:]:
            try:
                await register(ocu, JausID(101, 1, 107), 1, f"rtp://{host}:5004")
            except RequestError as error:
                print(host, "refused" if "does not send" in str(error) else "?")
            else:
                print(host, "sent")

asyncio.run(main())
"""


@pytest.mark.slow
def test_two_machines(cable: tuple[str, str], root: Path, free_port: int) -> None:
    """A client on another machine gets video there, and has none sent to the robot or a third machine."""
    pytest.importorskip("av", reason="the extra 'video' is not installed")
    client, robot = ([str(shutil.which("ip")), "netns", "exec", each] for each in cable)
    up = [sys.executable, "-m", "jauspy.cli.main", "up", "inc1", "--backend", "kinematic"]
    where = ["--local-root", str(root), "--port", str(free_port)]
    with subprocess.Popen([*robot, *up, *where], stdout=subprocess.PIPE, text=True) as running:
        try:
            assert any("stop it" in line for line in running.stdout or ())
            hosts = {"10.77.0.3": "refused", "10.77.0.2": "refused", "127.0.0.1": "refused", "10.77.0.255": "refused"}
            hosts |= {"10.77.0.1": "sent"}
            command = [*client, sys.executable, "-c", ASK, str(free_port), *hosts]
            reported = subprocess.run(command, capture_output=True, text=True, timeout=60, check=False)
        finally:
            running.terminate()
            running.communicate(timeout=20)
    assert dict(line.split() for line in reported.stdout.splitlines()) == hosts, reported.stderr
