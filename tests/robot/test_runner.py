"""A whole robot in memory: kinematic backend in real time, one component, a client that drives it."""

from __future__ import annotations

import asyncio
from collections.abc import AsyncIterator

import pytest

from jauspy.backends.kinematic import KinematicBackend
from jauspy.codec.message import Message
from jauspy.errors import ConfigError, TransportError
from jauspy.ids import JausID
from jauspy.messages import registry
from jauspy.messages.core import (
    QueriedComponentRec,
    QueriedNodeRec,
    QueryConfiguration,
    QueryIdentification,
    QueryServices,
    ReportHeartbeatPulse,
    RequestControl,
    Resume,
)
from jauspy.messages.mobility import (
    QueryLocalPose,
    QueryTravelSpeed,
    ReportLocalPose,
    ReportTravelSpeed,
    SetLocalWaypoint,
    SetTravelSpeed,
    SetWrenchEffort,
)
from jauspy.protocol.endpoint import Endpoint
from jauspy.robot.robot_files import load
from jauspy.robot.runner import RobotRunner
from jauspy.testing import until
from jauspy.transport import LoopbackHub, LoopbackTransport

ROBOT, CLIENT = JausID(101, 1, 102), JausID(42, 1, 1)
FORWARD = SetWrenchEffort(propulsive_linear_effort_x=80.0)


class Client:
    """Sends messages to the robot and waits for what comes back."""

    def __init__(self, hub: LoopbackHub) -> None:
        self.transport = LoopbackTransport(CLIENT, hub)
        self.transport.received = self._received
        self._endpoint = Endpoint(CLIENT, first_sequence=0)
        self._answers: asyncio.Queue[Message] = asyncio.Queue()

    def tell(self, *messages: Message) -> None:
        for message in messages:
            self._endpoint.send(ROBOT, message.encode(), now=0.0)
        for datagram in self._endpoint.poll_output():
            self.transport.send(datagram)

    async def answer(self) -> Message:
        async with asyncio.timeout(30.0):
            return await self._answers.get()

    async def drive_past(self, x: float) -> ReportLocalPose:
        """Ask for the pose until it is past x; not without a pause, which would leave the robot's thread no time."""
        while True:
            await asyncio.sleep(0.005)
            self.tell(QueryLocalPose(presence_vector=0xFFFF))
            report = await self.answer()
            if isinstance(report, ReportLocalPose) and report.x > x:
                return report

    def _received(self, datagram: bytes) -> None:
        self._endpoint.receive(datagram, 0.0)
        while (packet := self._endpoint.next_event()) is not None:
            message = registry.decode(packet.payload)
            if not isinstance(message, ReportHeartbeatPulse):  # they come unasked, in a slow run during a test
                self._answers.put_nowait(message)


@pytest.fixture
def hub() -> LoopbackHub:
    return LoopbackHub()


@pytest.fixture
async def client(hub) -> AsyncIterator[Client]:
    client = Client(hub)
    await client.transport.open()
    yield client
    await client.transport.close()


@pytest.fixture
def runner(hub) -> RobotRunner:
    return RobotRunner(load("inc1"), lambda me: LoopbackTransport(me, hub), backend="kinematic")


@pytest.mark.slow
async def test_robot_drives_and_reports_its_pose(runner, client):
    async with runner:
        client.tell(RequestControl(authority_code=100), Resume(), FORWARD)
        await client.drive_past(0.1)
        assert runner.snapshot.pose.x > 0.1
        assert runner.counters["101.1.102.host.received"] >= 4
        assert runner.counters["realtime.steps"] > 10


async def test_stands_still_when_closed_while_driving(runner, client):
    async with runner:
        client.tell(RequestControl(authority_code=100), Resume(), FORWARD)
        await client.drive_past(0.05)
        robot = runner._realtime._robot.inner
    assert robot.drive._efforts == (0.0, 0.0)
    assert runner.components == ()


@pytest.mark.slow
async def test_does_not_move_without_control(runner, client):
    async with runner:
        client.tell(FORWARD, Resume(), FORWARD, QueryIdentification(query_type=4))
        await client.answer()
        time = runner.snapshot.time
        while runner.snapshot.time < time + 0.1:
            await asyncio.sleep(0.01)
        assert runner.snapshot.pose.x == 0.0


@pytest.mark.slow
async def test_each_module_discovers_the_whole_robot(runner, client):
    async with runner:
        client.tell(QueryConfiguration(query_type=2))
        (node,) = (await client.answer()).node_list
        assert node.node_rec.node_id == 1
        assert [each.component_id for each in node.component_list] == [102, 103, 104, 105, 106, 107, 108, 109, 110, 113]

        gripper = QueryServices.NodeSeq(QueriedNodeRec(1), [QueriedComponentRec(105)])
        client.tell(QueryServices([gripper]))
        ((component,),) = (node.component_list for node in (await client.answer()).node_list)
        assert component.component_rec.component_id == 105
        assert "urn:jaus:jss:manipulator:PrimitiveEndEffector" in [each.uri for each in component.service_list]


async def test_close_may_be_called_twice_and_before_open(runner):
    await runner.close()
    async with runner:
        await runner.open()
    await runner.close()


@pytest.mark.slow
async def test_can_be_opened_again(runner, client):
    for _ in range(2):
        async with runner:
            client.tell(QueryIdentification(query_type=2))
            assert (await client.answer()).identification == "inc1"


@pytest.mark.slow
async def test_stops_everything_when_a_transport_cannot_be_opened(runner, hub, monkeypatch):
    taken = LoopbackTransport(ROBOT, hub)
    await taken.open()
    before = asyncio.all_tasks()
    with pytest.raises(TransportError):
        await runner.open()
    assert asyncio.all_tasks() == before
    assert runner.components == ()
    await taken.close()
    async with runner:
        assert len(runner.components) == len(runner.config.modules)


async def test_runs_until_cancelled(runner, client):
    task = asyncio.create_task(runner.run())
    await until(lambda: runner.components)
    client.tell(QueryIdentification(query_type=4))
    await client.answer()
    task.cancel()
    with pytest.raises(asyncio.CancelledError):
        await task
    assert runner.components == ()


@pytest.mark.slow
async def test_backend_object_is_accepted(hub, client):
    class Workshop(KinematicBackend):
        name = "workshop"

    runner = RobotRunner(load("inc1"), lambda me: LoopbackTransport(me, hub), backend=Workshop(), world="empty")
    assert runner.config.backend == "workshop"
    async with runner:
        client.tell(RequestControl(authority_code=100), Resume(), FORWARD)
        await client.drive_past(0.05)


@pytest.mark.parametrize(
    ("options", "said"), [({"backend": "gazebo"}, "'gazebo'.*kinematic"), ({"backend": "sim", "world": "mars"}, "mars")]
)
async def test_unknown_names_are_configuration_errors(hub, options, said):
    if options["backend"] == "sim":
        pytest.importorskip("mujoco", reason="MuJoCo is not installed")
    with pytest.raises(ConfigError, match=said):
        await RobotRunner(load("inc1"), lambda me: LoopbackTransport(me, hub), **options).open()


@pytest.mark.slow
async def test_drives_to_a_waypoint_in_real_time(runner, client):
    async with runner:
        client.tell(RequestControl(authority_code=100), Resume())
        client.tell(SetLocalWaypoint(x=0.7, y=0.0), SetTravelSpeed(speed=1.0))
        report = await client.drive_past(0.5)
        assert abs(report.y) < 0.1
        async with asyncio.timeout(30.0):
            while True:
                client.tell(QueryTravelSpeed())
                answer = await client.answer()
                if isinstance(answer, ReportTravelSpeed) and answer.speed == 0.0:
                    break
        assert runner.snapshot.pose.x == pytest.approx(0.7, abs=0.2)
