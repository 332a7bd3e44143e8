"""The OCU without `await`, on a real node manager and from where an event loop runs already."""

from __future__ import annotations

import asyncio
import signal
import subprocess
import sys
import threading
import time
from itertools import islice

import pytest
from tests.ocu.test_lists import ROBOT, Driver, at, order, services, xs

from jauspy.errors import ControlRejected, ElementRejected, ResponseTimeout, TransportError
from jauspy.messages.core import QueryControl, QueryStatus, ReportStatus
from jauspy.messages.mobility import QueryLocalPose, SetWrenchEffort
from jauspy.ocu import Appeared, SubsystemInfo, Vanished
from jauspy.robot.robot_files import load
from jauspy.sync import OCU
from jauspy.sync.portal import Portal
from jauspy.testing import LocalNode

Status = ReportStatus.Status
INC1 = load("inc1")
MODULES = [str(INC1.id_of(module)) for module in INC1.modules]
FULL = SetWrenchEffort(propulsive_linear_effort_x=60.0)


@pytest.fixture
def ocu(node_manager: LocalNode):
    with OCU("42.1.1", node_manager.local) as opened:
        yield opened


@pytest.fixture
def listed(node_manager: LocalNode):
    """A component with a list, in a thread of its own."""
    driver = Driver()
    with Portal("component") as portal:

        async def make():
            component = node_manager.component(ROBOT, services(driver))
            await component.open()
            return component

        component = portal.run(make())
        yield component, driver, portal
        portal.run(component.close())


def test_wrong_types_cause_one_sentence(listed, ocu):
    client = ocu.discover(101).service("LocalWaypointListDriver")
    with pytest.raises(TypeError, match=r"^query\(\) takes a message, as in QueryStatus\(\), not the str 'x'$"):
        client.query("x")
    with pytest.raises(TypeError, match=r"^a JAUS id is text"):
        ocu.send(QueryStatus(), "101.1.1")
    with client.control(), pytest.raises(TypeError, match=r"^a list takes a message, as in SetLocalWaypoint"):
        client.waypoints[:] = [(1.0, 2.0)]


@pytest.mark.slow
def test_robot_is_discovered_controlled_and_driven(robot, node_manager, ocu):
    found = ocu.discover(subsystem=101)
    driver = found.service("mobility:PrimitiveDriver")
    with driver.control(authority=200) as control:
        assert control.held
        driver.resume()
        driver.send(FULL)
        for pose in found.service("LocalPoseSensor").subscribe(QueryLocalPose(0x1FF), rate=10.0):
            if pose.x >= 0.2:
                break
    mobility = robot.components[0]
    assert mobility.host.state.endswith("NotControlled.Available.Standby")
    assert driver.status() == Status.STANDBY
    assert ocu.query(driver.id, QueryStatus(), expects=ReportStatus).status == Status.STANDBY


@pytest.mark.slow
def test_query_each_and_subscriptions_iterate(robot, ocu):
    answers = ocu.query_each("101.255.255", QueryStatus(), within=20.0)
    assert {str(source) for source, _ in islice(answers, len(MODULES))} == set(MODULES)
    sensor = ocu.discover(101).service("LocalPoseSensor")
    with sensor.subscribe(QueryLocalPose(0x43), rate=20.0) as poses:
        assert poses.confirmed_rate == pytest.approx(20, abs=0.1)
        assert len(list(islice(poses, 3))) == 3
        assert poses.get().x is not None
        assert poses.lost == 0


@pytest.mark.slow
def test_errors_equal_those_of_the_asynchronous_client(robot, node_manager, ocu):
    with pytest.raises(ResponseTimeout, match=r"9\.9\.9 was sent QueryStatus once"):
        ocu.query("9.9.9", QueryStatus(), timeout=0.05, retries=0)
    mine = ocu.discover(101).service("PrimitiveDriver").control(authority=200)
    with (
        OCU("43.1.1", node_manager.local) as other,
        other.discover(101).service("PrimitiveDriver").control(authority=220),
        pytest.raises(ControlRejected, match=r"is held by 43\.1\.1 with authority 220; requested with 200"),
    ):
        mine.__enter__()


@pytest.mark.slow
def test_an_error_in_the_block_leaves_standby(robot, ocu):
    driver = ocu.discover(101).service("PrimitiveDriver")

    def drive() -> None:
        with driver.control():
            driver.resume()
            raise ValueError("a bug")

    with pytest.raises(ValueError, match="a bug"):
        drive()
    assert driver.status() == Status.STANDBY


def test_watch_iterates(node_manager, ocu):
    news = ocu.watch(interval=0.1, silence=0.5)
    with OCU("43.1.1", node_manager.local):
        first = next(news)
        assert isinstance(first, Appeared)
        assert isinstance(first.now, SubsystemInfo)
        assert first.id.subsystem == 43
    assert any(isinstance(each, Vanished) and isinstance(each.before, SubsystemInfo) for each in news)
    news.close()


def test_lists_are_mutable_sequences(ocu, listed):
    component, driver, portal = listed
    client = ocu.discover(101).service("LocalWaypointListDriver")
    with client.control():
        client.resume()
        waypoints = client.waypoints
        waypoints.upload(at(1, 2, 3, 4))
        waypoints.append(at(5)[0])
        waypoints[0] = at(9)[0]
        waypoints[1:3] = at(7)
        del waypoints[-1]
        waypoints += at(6)
        assert round(waypoints.pop().x) == 6
        waypoints.insert(0, at(8)[0])
        assert order(component) == xs(waypoints) == [8, 9, 7, 4]
        with pytest.raises(ElementRejected):
            waypoints.append(b"what is this")

        waypoints.execute(speed=1.0)

        async def arrive() -> None:
            driver.arrive(component)

        seen = []
        for index in waypoints.progress():
            seen.append(index)
            portal.run(arrive())
        assert seen == [0, 1, 2, 3]


async def test_facade_works_inside_a_running_loop(node_manager):
    assert asyncio.get_running_loop().is_running()
    with OCU("42.1.1", node_manager.local) as ocu, OCU("43.1.1", node_manager.local) as other:
        until = time.monotonic() + 20
        while not (found := ocu.discover_all(timeout=0.3)):
            assert time.monotonic() < until
        assert {each.id for each in found} == {43}
        assert other.id.subsystem == 43


async def test_async_with_is_explained():
    with pytest.raises(TypeError, match="use `with` for this OCU; `async with` is for what"):
        async with OCU():
            pytest.fail("entered")


def test_closed_ocu_is_an_error_and_can_be_reopened(node_manager):
    ocu = OCU("42.1.1", node_manager.local)
    with pytest.raises(TransportError, match="not open; use it inside `with`"):
        ocu.query("1.1.1", QueryStatus())
    for _ in range(2):
        with ocu:
            assert ocu.is_open
    ocu.close()
    threads = [each.name for each in threading.enumerate()]
    assert "jauspy" not in threads


def test_failed_open_leaves_no_thread(tmp_path):
    with pytest.raises(TransportError, match="no node manager"):
        OCU("42.1.1", f"local:{tmp_path}").open()
    assert "jauspy" not in [each.name for each in threading.enumerate()]


def test_counters_can_be_read_while_they_change(ocu):
    counters = ocu._async._component._transport.counters
    done = threading.Event()

    def count() -> None:
        while not done.is_set() and len(counters) < 20_000:
            counters[f"reason {len(counters)}"] = 1

    counting = threading.Thread(target=count)
    interval = sys.getswitchinterval()
    sys.setswitchinterval(1e-5)
    counting.start()
    try:
        while counting.is_alive():
            assert ocu.counters
    finally:
        sys.setswitchinterval(interval)
        done.set()
        counting.join(20)


@pytest.mark.slow
def test_close_inside_a_block_leaves_standby(robot, node_manager):
    with OCU("42.1.1", node_manager.local) as ocu:
        driver = ocu.discover(101).service("PrimitiveDriver")
        with driver.control() as control, driver.subscribe(QueryStatus()):
            driver.resume()
            ocu.close()
            assert control.lost == "the OCU was closed"
    with OCU("42.1.1", node_manager.local) as ocu:
        assert ocu.query(driver.id, QueryStatus()).status == Status.STANDBY


LEFT = """
import sys
import jauspy

ocu = jauspy.sync.OCU("42.1.1", sys.argv[1])
ocu.open()
driver = ocu.discover(101).service("PrimitiveDriver")
driver.control().__enter__()
driver.resume()
print(driver.status().name)
"""


@pytest.mark.slow
def test_program_end_without_close_leaves_standby(robot, node_manager, ocu):
    ocu.close()  # the program is 42.1.1
    command = [sys.executable, "-c", LEFT, node_manager.local]
    run = subprocess.run(command, capture_output=True, text=True, timeout=60, check=False)
    assert (run.stdout, run.stderr) == ("READY\n", "")
    ocu.open()
    assert ocu.query(MODULES[0], QueryStatus()).status == Status.STANDBY
    control = ocu.query(MODULES[0], QueryControl())
    assert (control.subsystem_id, control.node_id, control.component_id) == (0, 0, 0)


FORKED = """
import os, sys
import jauspy
from jauspy.messages.core import QueryStatus

ocu = jauspy.sync.OCU(connect="udp://127.0.0.1:9")
ocu.open()
child = os.fork()
if not child:
    try:
        ocu.query("1.1.1", QueryStatus())
    except jauspy.TransportError as error:
        print(error, flush=True)
    sys.exit(3)
print(os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]), ocu.is_open)
"""


@pytest.mark.slow
def test_use_in_a_forked_process_is_an_error():
    run = subprocess.run([sys.executable, "-c", FORKED], capture_output=True, text=True, timeout=30, check=False)
    assert run.stdout == "it is not open; use it inside `with`, and in the process that opened it\n3 True\n"


INTERRUPTED = """
import sys, time
from jauspy.messages.mobility import QueryLocalPose, SetWrenchEffort
from jauspy.sync import OCU

with OCU("42.1.1", sys.argv[1]) as ocu:
    robot = ocu.discover(101)
    driver = robot.service("PrimitiveDriver")
    with driver.control():
        driver.resume()
        driver.send(SetWrenchEffort(propulsive_linear_effort_x=60.0))
        print("driving", flush=True)
        WAIT
"""


@pytest.mark.slow
@pytest.mark.parametrize(
    "wait",
    [
        pytest.param("time.sleep(60)", marks=pytest.mark.slow),
        "list(robot.service('LocalPoseSensor').subscribe(QueryLocalPose(1), rate=5.0))",
    ],
)
def test_ctrl_c_leaves_the_robot_in_standby(robot, node_manager, ocu, wait):
    ocu.close()  # the program is 42.1.1
    command = [sys.executable, "-c", INTERRUPTED.replace("WAIT", wait), node_manager.local]
    process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    try:
        assert process.stdout.readline() == "driving\n"
        process.send_signal(signal.SIGINT)
        _, problems = process.communicate(timeout=30)
    finally:
        process.kill()
        process.wait()
    assert problems.endswith("KeyboardInterrupt\n")
    mobility = robot.components[0]
    assert mobility.host.state.endswith("NotControlled.Available.Standby")


@pytest.mark.slow
def test_verbs_are_the_same_without_await(node_manager, ocu, caplog):
    with Portal("robot") as portal:
        running = node_manager.robot()
        runner = portal.run(running.__aenter__())
        try:
            robot = ocu.robot(101)
            with robot.control("drive", "gripper") as control:
                assert control.held
                robot.drive(linear=0.4, seconds=0.5)
                assert robot.pose().x > 0.05
                robot.gripper.close(force=20)
                robot.drive(linear=0.3)
                time.sleep(1.8)  # the program hangs: no call for more than a second
                assert abs(runner.snapshot.twist.vx) < 0.05
        finally:
            portal.run(running.__aexit__(None, None, None))
    assert "101.1.102 was stopped: the program was blocked for 1." in caplog.text
