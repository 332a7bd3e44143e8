"""A stranger on the network registers services with a robot's Discovery, under an id of the robot's subsystem."""

from __future__ import annotations

import shutil
import subprocess
import sys
from datetime import UTC, datetime
from pathlib import Path

import pytest

from jauspy.ids import JausID
from jauspy.messages import registry
from jauspy.messages.core import (
    ComponentRec,
    QueriedComponentRec,
    QueriedNodeRec,
    QueryServices,
    RegisterServices,
    ReportIdentification,
    ReportServices,
    ServiceRec,
)
from jauspy.ocu.subsystems import SubsystemTree
from jauspy.protocol.addressing import HERE, UNKNOWN_LOCATION, Location
from jauspy.services.core import Discovery
from jauspy.services.host import Host

ROBOT, MODULE, STRANGER, CLIENT = (JausID.parse(each) for each in ("101.1.1", "101.1.2", "101.1.222", "42.1.1"))
DRIVER = ServiceRec("urn:jaus:jss:mobility:PrimitiveDriver", 1, 0)
EVERYTHING = QueryServices([QueryServices.NodeSeq(QueriedNodeRec(255), [QueriedComponentRec(255)])])


def host(id: JausID, discovery: Discovery) -> Host:
    return Host(id, [discovery], utc_now=lambda: datetime(2026, 1, 1, tzinfo=UTC))


def listed(robot: Host) -> set[int]:
    """The components that it tells a client."""
    robot.receive(EVERYTHING.encode(), CLIENT, 0.0)
    (answer,) = (registry.decode(each.payload) for each in robot.poll_output(0.0))
    return {each.component_rec.component_id for node in answer.node_list for each in node.component_list}


@pytest.mark.parametrize("location", [Location(hosts=frozenset({"10.0.6.6"})), UNKNOWN_LOCATION])
def test_who_is_on_another_machine_is_not_listed(location: Location) -> None:
    robot = host(ROBOT, Discovery())
    robot.locate = lambda source, found: found(HERE if source == MODULE else location)
    for id in (MODULE, STRANGER):
        robot.receive(RegisterServices([DRIVER]).encode(), id, 0.0)
    assert listed(robot) == {1, 2}
    assert robot.counters["foreign_registration"] == 1


def test_a_subsystem_of_several_machines_can_allow_it() -> None:
    robot = host(ROBOT, Discovery(registrants="subsystem"))
    robot.locate = lambda _, found: found(UNKNOWN_LOCATION)
    robot.receive(RegisterServices([DRIVER]).encode(), STRANGER, 0.0)
    assert listed(robot) == {1, 222}


def test_nobody_changes_what_a_robots_own_modules_offer() -> None:
    discovery = Discovery(registrants="subsystem")
    robot = host(ROBOT, discovery)
    discovery.add_local([host(MODULE, Discovery())])
    for services in ([DRIVER], []):
        robot.receive(RegisterServices(services).encode(), MODULE, 0.0)
    robot.unreachable(MODULE, 0.0)
    assert listed(robot) == {1, 2}
    assert DRIVER.uri not in {each.uri for each in discovery.directory.all()[MODULE]}


def test_a_client_believes_a_component_about_itself() -> None:
    """Whatever another one says that it offers."""
    tree = SubsystemTree()

    def report(source: JausID, about: JausID, uri: str) -> None:
        component = ReportServices.ComponentSeq(ComponentRec(about.component, 0), [ServiceRec(uri, 1, 0)])
        node = ReportServices.NodeSeq(ReportServices.NodeRec(about.node), [component])
        tree.add(ReportServices([node]), source, 0.0)

    for level, id in ((2, ROBOT), (3, ROBOT), (4, ROBOT), (4, MODULE)):
        tree.add(ReportIdentification(level, 10001, "x"), id, 0.0)
    report(STRANGER, MODULE, DRIVER.uri)
    report(MODULE, MODULE, "urn:x:Lamp")
    report(STRANGER, MODULE, DRIVER.uri)
    (subsystem,) = tree.subsystems()
    (module,) = (each for each in subsystem.components if each.id == MODULE)
    assert [each.urn for each in module.services] == ["urn:x:Lamp"]


ATTACK = """
import asyncio, sys
from jauspy.messages.core import RegisterServices, ServiceRec
from jauspy.ocu import OCU

async def main():
    where = "udp://10.77.0.2:" + sys.argv[1]
    async with OCU("101.2.22", connect=where) as stranger:
        services = [ServiceRec("urn:jaus:jss:mobility:PrimitiveDriver", 1, 0)]
        for component in (102, 104, 106):
            await stranger.send(f"101.1.{component}", RegisterServices(services), ack=True)
        await asyncio.sleep(1.5)  # longer than Discovery needs to find out where it is
    async with OCU("42.1.1", connect=where) as ocu:
        print((await ocu.discover(101)).service("PrimitiveDriver").id)

asyncio.run(main())
"""


@pytest.mark.slow
def test_a_robot_on_another_machine_stays_unambiguous(cable: tuple[str, str], root: Path, free_port: int) -> None:
    outside, robot = ([str(shutil.which("ip")), "netns", "exec", each] for each in cable)
    up = [sys.executable, "-m", "jauspy.cli.main", "up", "inc1", "--backend", "kinematic"]
    where = ["--local-root", str(root), "--port", str(free_port)]
    with subprocess.Popen([*robot, *up, *where], stdout=subprocess.PIPE, text=True) as running:
        try:
            assert any("stop it" in line for line in running.stdout or ())
            command = [*outside, sys.executable, "-c", ATTACK, str(free_port)]
            reported = subprocess.run(command, capture_output=True, text=True, timeout=60, check=False)
        finally:
            running.terminate()
            running.communicate(timeout=20)
    assert reported.stdout == "101.1.102\n", reported.stderr
