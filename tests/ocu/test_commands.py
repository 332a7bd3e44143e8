"""Commands that take time, waited for until they have been carried out."""

from __future__ import annotations

import asyncio

import pytest

from jauspy.errors import ConfigError, ControlRejected, EventRejected, RequestError, ResponseTimeout, TransportError
from jauspy.ids import JausID
from jauspy.messages import registry
from jauspy.messages.core import (
    CancelEvent,
    CommandEvent,
    ConfirmEventRequest,
    CreateCommandEvent,
    QueryStatus,
    Resume,
    SetTime,
    Standby,
    TimeStamp,
)
from jauspy.messages.mobility import (
    SetLocalVector,
    SetLocalVectorExt,
    SetLocalWaypoint,
    SetTravelSpeed,
    SetWrenchEffort,
)
from jauspy.messages.ugv import SetSkidSteerEffort
from jauspy.ocu.commands import neutral
from jauspy.protocol.header import Ack
from jauspy.services.command_timeout import CONTINUOUS_COMMANDS, Zero
from jauspy.services.core import AccessControl, Discovery, Events, Liveness, Management, Time
from jauspy.services.state_machine import CommandCompletion

SET_TIME = SetTime(time_stamp=TimeStamp(milliseconds=0, seconds=1, minutes=2, hour=3, day=4))


class SlowClock(Time):
    """Takes its time to be set, until a test says that it is."""

    begun = 0
    ended = CommandCompletion()

    def set_time(self, msg) -> None:
        self.ended(False)
        self.begun += 1
        self.ended = self.host.begin_command()


def services(*, limit: int = 128):
    return [SlowClock(), AccessControl(timeout=5), Management(), Events(limit=limit), Discovery(), Liveness()]


@pytest.fixture
async def robot(virtual_network):
    async with virtual_network.component("101.1.1", services()) as component:
        yield component


@pytest.fixture
async def client(robot, ocu):
    found = (await ocu.discover(101)).service("Time")
    async with found.control():
        await found.resume()
        yield found


@pytest.fixture
async def robot_inc1(virtual_network):
    async with virtual_network.robot() as running:
        yield running


def clock_of(component) -> SlowClock:
    return component.host.service(SlowClock)


def reported(component, *, success: bool) -> None:
    clock_of(component).ended(success)
    component.wake()


async def begun(client, component, within: float = 30.0) -> asyncio.Task[None]:
    """A command under way."""
    before = clock_of(component).begun
    task = asyncio.create_task(client.perform(SET_TIME, within=within))
    async with asyncio.timeout(5):
        while clock_of(component).begun == before:
            await asyncio.sleep(0.01)
    return task


async def test_perform_returns_when_the_command_is_complete(robot, client):
    task = await begun(client, robot)
    await asyncio.sleep(20)
    assert not task.done()
    reported(robot, success=True)
    await asyncio.wait_for(task, 0.1)


async def test_immediate_command_returns_at_once(client):
    await asyncio.wait_for(client.perform(Standby(), within=0), 0.1)


async def test_performed_standby_is_no_loss_of_control(client):
    await asyncio.sleep(3)
    await client.perform(Standby(), within=1)
    await asyncio.sleep(3)
    await client.perform(Resume(), within=1)


async def test_abandoned_command_raises_request_error(robot, client):
    task = await begun(client, robot)
    reported(robot, success=False)
    with pytest.raises(
        RequestError,
        match=r"101\.1\.1 did not carry out SetTime \(it said so after 0\.\d s\): .* takes such commands now, and",
    ):
        await task


async def test_command_above_the_time_limit_raises_request_error(virtual_network, robot, client):
    task = await begun(client, robot, within=2.5)
    with pytest.raises(RequestError, match=r"did not carry out SetTime within 2\.5 s"):
        await asyncio.wait_for(task, 3.2)


async def test_concurrent_commands_are_distinguished(robot, client):
    first = await begun(client, robot)
    second = asyncio.create_task(client.perform(Standby(), within=1))
    await second
    assert not first.done()
    reported(robot, success=True)
    await first


@pytest.mark.parametrize("success", [True, False])
async def test_equal_concurrent_commands_share_the_result(virtual_network, robot, client, success):
    tasks = [await begun(client, robot), await begun(client, robot)]
    reported(robot, success=success)
    results = await asyncio.wait_for(asyncio.gather(*tasks, return_exceptions=True), 1)
    assert [type(each) for each in results] == [type(None) if success else RequestError] * 2
    assert len(virtual_network.sent(CommandEvent)) == 1


async def test_longest_of_equal_commands_keeps_the_event(virtual_network, client):
    virtual_network.lose(CommandEvent)
    waits = [client.perform(SET_TIME, within=each) for each in (1.0, 6.0)]
    impatient, patient = await asyncio.gather(*waits, return_exceptions=True)
    assert "another `perform()` of the same command allows more" in str(impatient)
    assert isinstance(patient, ResponseTimeout)


async def test_cancelled_wait_keeps_the_event_for_an_equal_command(virtual_network, robot, client):
    first, second = await begun(client, robot), await begun(client, robot)
    third = asyncio.create_task(client.perform(SET_TIME, within=30.0))
    await asyncio.sleep(0)  # it is sent, and not confirmed yet
    for task in (first, second):
        task.cancel()
        with pytest.raises(asyncio.CancelledError):
            await task
    await client.status()
    assert not virtual_network.sent(CancelEvent)
    reported(robot, success=True)
    await asyncio.wait_for(third, 1)


async def test_last_of_equal_commands_cancels_the_event(virtual_network, robot, client):
    for task in [await begun(client, robot), await begun(client, robot)]:
        assert not virtual_network.sent(CancelEvent)
        task.cancel()
        with pytest.raises(asyncio.CancelledError):
            await task
    await client.status()
    assert len(virtual_network.sent(CancelEvent)) == 1


async def test_lost_confirmation_is_requested_again(virtual_network, robot, client):
    virtual_network.lose(ConfirmEventRequest, times=1)
    task = await begun(client, robot)
    await asyncio.sleep(3)
    reported(robot, success=True)
    await task


async def test_lost_result_is_resent(virtual_network, robot, client):
    virtual_network.lose(CommandEvent, times=2)
    task = await begun(client, robot)
    reported(robot, success=True)
    await asyncio.wait_for(task, 1)
    assert len(virtual_network.sent(CommandEvent)) == 3


async def test_result_before_the_confirmation_is_accepted(virtual_network, client):
    virtual_network.lose(ConfirmEventRequest, times=2)
    await asyncio.wait_for(client.perform(Standby(), within=0), 1)
    assert len(virtual_network.sent(CommandEvent)) == 1


@pytest.mark.parametrize("takes_time", [True, False])
async def test_late_or_lost_confirmations_do_not_repeat_the_command(virtual_network, robot, client, takes_time):
    clock = clock_of(robot)
    virtual_network.delay = 0.4
    virtual_network.lose(ConfirmEventRequest, times=5)
    task = await begun(client, robot)
    if takes_time:
        await asyncio.sleep(3)
    reported(robot, success=True)
    await asyncio.wait_for(task, 5)
    assert len(virtual_network.sent(CreateCommandEvent)) > 1
    assert clock.begun == 1


async def test_a_client_that_does_not_acknowledge_keeps_control(virtual_network, robot, client):
    def keeps(packet) -> bool:
        return packet.ack is not Ack.ACK

    virtual_network.keeps = keeps
    await client.perform(Standby(), within=1)
    await asyncio.sleep(3)
    assert robot.controller == JausID(42, 1, 1)


@pytest.mark.parametrize("limits", [(3.0, 30.0), (30.0, 3.0)])
async def test_equal_concurrent_commands_have_separate_limits(robot, client, limits):
    first = await begun(client, robot, within=limits[0])
    second = await begun(client, robot, within=limits[1])
    short, long = (first, second) if limits[0] < limits[1] else (second, first)
    with pytest.raises(RequestError, match=r"did not carry out SetTime within 3 s; it goes on, for another"):
        await asyncio.wait_for(short, 4)
    await asyncio.sleep(20)
    assert not long.done()
    reported(robot, success=True)
    await asyncio.wait_for(long, 1)


async def test_vanished_robot_raises_response_timeout(virtual_network, robot, ocu):
    client = (await ocu.discover(101)).service("Time")
    async with client.control():
        task = await begun(client, robot)
        virtual_network.disconnect("101.1.1")
        with pytest.raises(ControlRejected, match=r"control of 101\.1\.1 was lost: 101\.1\.1 has not answered for"):
            await asyncio.wait_for(task, 8)
    virtual_network.reconnect("101.1.1")


async def test_missing_result_raises_response_timeout(virtual_network, robot, client):
    virtual_network.lose(CommandEvent)
    with pytest.raises(
        ResponseTimeout, match=r"101\.1\.1 accepted Standby and did not report its result within 5 s; it may have been"
    ):
        await client.perform(Standby(), within=5)


async def test_close_ends_a_pending_command(virtual_network, robot):
    async with virtual_network.ocu("43.1.1") as ocu:
        found = (await ocu.discover(101)).service("Time")
        async with found.control():
            await found.resume()
            task = await begun(found, robot)
            await ocu.close()
    with pytest.raises(TransportError, match="the OCU was closed"):
        await asyncio.wait_for(task, 1)


async def test_cancelled_wait_ends_the_event_but_not_the_command(virtual_network, robot, client):
    task = await begun(client, robot)
    task.cancel()
    with pytest.raises(asyncio.CancelledError):
        await task
    await client.status()
    assert len(virtual_network.sent(CancelEvent)) == 1
    assert clock_of(robot).begun == 1
    reported(robot, success=True)
    assert not virtual_network.sent(CommandEvent)


async def test_loss_of_control_raises_control_rejected(virtual_network, robot, client):
    task = await begun(client, robot)
    async with virtual_network.ocu("43.1.1") as other:
        strong = (await other.discover(101)).service("Time")
        async with strong.control(authority=200):
            with pytest.raises(ControlRejected, match="took it back"):
                await asyncio.wait_for(task, 3)
            with pytest.raises(ControlRejected):
                await client.perform(SET_TIME, within=1)


async def test_rejected_command_raises_event_rejected(virtual_network, robot, client):
    with pytest.raises(EventRejected, match=r"101\.1\.1 rejected the event for SetWrenchEffort: .*take this command"):
        await client.perform(SetWrenchEffort(propulsive_linear_effort_x=1.0), within=1)
    async with virtual_network.component("102.1.1", services(limit=0)), virtual_network.ocu("43.1.1") as ocu:
        full = (await ocu.discover(102)).service("Time")
        with pytest.raises(EventRejected, match="as many events as it can hold"):
            await full.perform(SET_TIME, within=1)


async def test_component_without_command_events_raises_event_rejected(virtual_network, client):
    virtual_network.lose(CreateCommandEvent)
    with pytest.raises(ResponseTimeout, match="CreateCommandEvent 6 times"):
        await client.perform(SET_TIME, within=1)


@pytest.mark.slow
async def test_perform_waits_for_a_waypoint(virtual_network, robot_inc1, ocu):
    driver = (await ocu.discover(101)).service("mobility:LocalWaypointDriver")
    async with driver.control():
        await driver.resume()
        await driver.send(SetLocalWaypoint(x=2.0, y=0.5))
        await driver.perform(SetTravelSpeed(speed=1.0), within=60.0)
        pose = robot_inc1.snapshot.pose
        assert (pose.x, pose.y) == (pytest.approx(2.0, abs=0.5), pytest.approx(-0.5, abs=0.5))
        task = asyncio.create_task(driver.perform(SetTravelSpeed(speed=1.0), within=60.0))
        await driver.send(SetLocalWaypoint(x=9.0, y=0.5))
        await asyncio.sleep(1)
        await driver.standby()
        with pytest.raises(RequestError, match="did not carry out SetTravelSpeed"):
            await asyncio.wait_for(task, 5)


@pytest.mark.parametrize(
    ("call", "error", "words"),
    [
        (lambda it: it.perform(QueryStatus(), within=1), ConfigError, r"QueryStatus is not a command; use `query\(\)`"),
        (lambda it: it.perform(SetTime, within=1), TypeError, r"^perform\(\) takes a message, and SetTime is only"),
        (lambda it: it.perform(SET_TIME, within="1"), TypeError, r"^within is a number, not the str '1'$"),
        (lambda it: it.perform(SET_TIME, within=-1), ConfigError, r"within -1 s is outside 0\.\."),
        (lambda it: it.perform(SET_TIME, within=float("nan")), ConfigError, r"within nan s is outside 0\.\."),
    ],
)
async def test_invalid_arguments_are_rejected(virtual_network, client, call, error, words):
    with pytest.raises(error, match=words):
        await call(client)
    assert not virtual_network.sent(CreateCommandEvent)


Speed = SetLocalVectorExt.Speed


@pytest.mark.parametrize(
    ("command", "stop"),
    [
        (SetSkidSteerEffort(40.0, -40.0), SetSkidSteerEffort(0.0, 0.0)),
        (SetLocalVector(speed=0.5, heading=1.0), SetLocalVector(speed=0.0, heading=1.0)),
        (
            SetLocalVectorExt(speed=Speed(Speed.Choice.SPEED_OVER_GROUND, 0.5), heading=1.0),
            SetLocalVectorExt(speed=Speed(Speed.Choice.SPEED_OVER_GROUND, 0.0), heading=1.0),
        ),
        (SetTravelSpeed(0.5), SetTravelSpeed(0.0)),
        (registry.by_name("SetActuatorForceTorques")([]), None),
        (registry.by_name("SetLocalPose")(x=1.0), None),
    ],
)
def test_the_stop_of_a_command(command, stop):
    assert neutral(command) == stop


def test_every_continuous_command_is_a_message():
    for name, zero in CONTINUOUS_COMMANDS.items():
        fields = [slot.name for slot in registry.by_name(name).layout().slots]
        assert zero is not Zero.SPEED or "speed" in fields
