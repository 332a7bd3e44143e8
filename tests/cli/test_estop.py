"""`jauspy estop` beside a robot that another client drives."""

import json
import time

import pytest
from tests.helpers.command_line import jauspy, robot_in_thread

from jauspy import sync
from jauspy.cli import estop as verb
from jauspy.errors import TransportError
from jauspy.messages.core import QueryStatus
from jauspy.messages.mobility import QueryVelocityState, SetWrenchEffort
from jauspy.robot.robot_files import load

INC1 = load("inc1")


@pytest.fixture(scope="module")
def robot():
    with robot_in_thread() as running:
        yield running


def lines(*arguments, status=0):
    result = jauspy("estop", *arguments, "--json", status=status)
    return {each["id"]: each for each in map(json.loads, result.stdout.splitlines())}


@pytest.mark.slow
def test_all_components_stop_beside_the_client_that_drives_and_are_released(robot):
    with sync.OCU("42.1.1", robot.local) as ocu:
        driver = ocu.discover(subsystem=101).service("mobility:PrimitiveDriver")
        with driver.control(authority=255):
            driver.resume()
            driver.send(SetWrenchEffort(propulsive_linear_effort_x=50.0))
            stopped = lines("--connect", robot.udp)
            assert stopped.keys() == {str(INC1.id_of(module)) for module in INC1.modules}
            assert {(each["status"], each["obeyed"]) for each in stopped.values()} == {("EMERGENCY", True)}
            deadline = time.monotonic() + 10
            while abs(ocu.query("101.1.102", QueryVelocityState(0x1FF)).velocity_x) > 0.02:
                assert time.monotonic() < deadline
            released = lines("101", "--release", "--connect", robot.local)
            assert released.keys() == stopped.keys()
            assert all(each["obeyed"] for each in released.values())
            time.sleep(0.5)
            assert abs(ocu.query("101.1.102", QueryVelocityState(0x1FF)).velocity_x) < 0.02


@pytest.mark.slow
def test_one_component_stops_and_only_the_id_that_stopped_it_releases_it(robot):
    assert lines("101.1.104", "--connect", robot.local).keys() == {"101.1.104"}
    refused = jauspy("estop", "101.1.104", "--release", "--id", "42.1.99", "--connect", robot.local, status=1)
    assert "101.1.104  EMERGENCY  did not obey" in refused.stdout
    assert "1 of 1 did not obey: 101.1.104; another client has set an emergency" in " ".join(refused.stderr.split())
    with sync.OCU("42.1.1", robot.local) as ocu:
        assert ocu.query("101.1.102", QueryStatus()).status.name == "STANDBY"
    assert lines("101.1.104", "--release", "--connect", robot.local)["101.1.104"]["status"] == "STANDBY"


@pytest.mark.parametrize(
    ("target", "said"),
    [
        ("7", "no component answered within 0.3 s; the message was sent"),
        ("7.1.1", "7.1.1 did not answer within 0.3 s"),
        ("70000", "70000 is not the number of a subsystem; it is 1..65534"),
        ("everything", "everything"),
    ],
)
def test_a_target_that_does_not_exist(robot, target, said):
    result = jauspy("estop", target, "--timeout", "0.3", "--connect", robot.local, status=1)
    assert said in " ".join(result.stderr.split())


def test_an_id_that_another_host_uses_prevents_no_stop(monkeypatch, capsys):
    """The node manager of this machine would not accept it."""
    made = []

    class Sender:
        def __init__(self, id, connect, **_):
            made.append(id)

        async def __aenter__(self):
            raise TransportError("nothing to send to")

        async def __aexit__(self, *_):
            raise AssertionError

    monkeypatch.setattr(verb, "OCU", Sender)
    monkeypatch.setattr(verb.client, "ids_elsewhere", lambda connect: {verb.ESTOP_ID})
    monkeypatch.setattr(verb.client, "own_id", lambda given, connect: "42.1.7")
    for release in (False, True):
        with pytest.raises(TransportError):
            verb.estop(release=release)
    assert made == ["42.1.7", verb.ESTOP_ID]
    assert "stopping as 42.1.7; release with --id 42.1.7" in capsys.readouterr().err
