"""What is missing, late or double by the sequence numbers of an event."""

from __future__ import annotations

import asyncio

import pytest
from tests.ocu.conftest import hold_back

from jauspy.errors import ConfigError, EventRejected, ResponseTimeout
from jauspy.ids import JausID
from jauspy.messages.core import (
    CancelEvent,
    ConfirmEventRequest,
    CreateEvent,
    Event,
    QueryHeartbeatPulse,
    QueryStatus,
    QueryTime,
    RejectEventRequest,
    ReportHeartbeatPulse,
    ReportStatus,
    UpdateEvent,
)
from jauspy.messages.mobility import QueryLocalPose, QueryVelocityState, ReportLocalPose, ReportVelocityState
from jauspy.ocu import subscription as module
from jauspy.ocu.subscription import MAX_DELAY, EventClient, SequenceTracker
from jauspy.protocol.header import Packet
from jauspy.protocol.judp import pack
from jauspy.services.core import Discovery, Events, Liveness
from jauspy.testing import until

POSE = QueryLocalPose(presence_vector=0x43)
Status = ReportStatus.Status


async def drain(subscription) -> None:
    while True:
        await subscription.get()


async def sensor_of(ocu):
    return (await ocu.discover(subsystem=101)).service("mobility:LocalPoseSensor")


def events_of(component) -> Events:
    return component.host.service(Events)


async def test_typed_reports_at_the_confirmed_rate(world):
    robot = await world.robot()
    sensor = await sensor_of(await world.ocu())

    async with sensor.subscribe(POSE, rate=50.0) as poses:
        assert poses.confirmed_rate == pytest.approx(50, abs=0.02)
        reports = [await poses.get() for _ in range(5)]

    assert all(isinstance(report, ReportLocalPose) and report.z is None for report in reports)
    assert (poses.received >= 5, poses.lost, poses.dropped) == (True, 0, 0)
    assert len(world.network.sent(CancelEvent)) == 1
    await until(lambda: len(events_of(robot).subscriptions) == 0)


async def test_rate_above_the_limit_is_confirmed_lower(world):
    await world.robot()
    sensor = await sensor_of(await world.ocu())
    async with sensor.subscribe(POSE, rate=1000.0) as poses:
        assert poses.confirmed_rate == pytest.approx(100, abs=0.02)


async def test_leaving_the_loop_cancels_the_event(world):
    robot = await world.robot()
    sensor = await sensor_of(await world.ocu())

    async for _ in sensor.subscribe(POSE, rate=50.0):
        assert len(events_of(robot).subscriptions) == 1
        break

    await until(lambda: len(events_of(robot).subscriptions) == 0)


async def test_a_cancelled_loop_cancels_the_event(world):
    robot = await world.robot()
    sensor = await sensor_of(await world.ocu())

    async def listen() -> None:
        async for _ in sensor.subscribe(POSE, rate=50.0):
            pass

    task = asyncio.create_task(listen())
    await until(lambda: len(world.network.sent(Event)) > 2)
    task.cancel()
    with pytest.raises(asyncio.CancelledError):
        await task
    await until(lambda: len(events_of(robot).subscriptions) == 0)


async def test_every_change_event_reports_at_once_and_then_changes_only(world):
    await world.robot()
    ocu = await world.ocu()
    driver = (await ocu.discover(subsystem=101)).service("mobility:PrimitiveDriver")

    async with driver.subscribe(QueryStatus()) as statuses:
        assert statuses.confirmed_rate == 0
        seen = [(await statuses.get()).status]
        async with driver.control():
            await driver.resume()
            seen.append((await statuses.get()).status)
        seen.append((await statuses.get()).status)

    assert seen == [Status.STANDBY, Status.READY, Status.STANDBY]
    assert statuses.received == 3


@pytest.mark.parametrize("rate", [None, 10.0])
async def test_event_ended_by_the_component_raises_event_rejected(world, rate):
    class Broken(Liveness):
        works = True

        def report_heartbeat_pulse(self):
            if not self.works:
                raise RuntimeError("stopped")
            return ReportHeartbeatPulse()

    broken = Broken()
    world.network.allow_errors = True
    await world.component(JausID(101, 1, 7), [broken, Events(), Discovery()])
    liveness = (await (await world.ocu()).discover(subsystem=101)).service("Liveness")
    async with liveness.subscribe(QueryHeartbeatPulse(), rate=rate) as pulses:
        await pulses.get()
        broken.works = False
        with pytest.raises(
            EventRejected, match=r"101\.1\.7 ended the event for QueryHeartbeatPulse: it does not answer"
        ):
            async with asyncio.timeout(10):
                await drain(pulses)
    with pytest.raises(EventRejected, match="ended the event"):
        async with liveness.subscribe(QueryHeartbeatPulse(), rate=rate) as pulses:
            await asyncio.wait_for(pulses.get(), 10)


async def test_two_streams_are_distinguished(world):
    await world.robot()
    ocu = await world.ocu()
    robot = await ocu.discover(subsystem=101)
    sensor = robot.service("VelocityStateSensor")
    async with (
        sensor.subscribe(POSE, rate=50.0) as poses,
        sensor.subscribe(QueryVelocityState(presence_vector=0x41), rate=50.0) as speeds,
    ):
        for _ in range(3):
            assert isinstance(await poses.get(), ReportLocalPose)
            assert isinstance(await speeds.get(), ReportVelocityState)


async def test_shared_event_ends_with_its_last_subscription(world):
    robot = await world.robot()
    sensor = await sensor_of(await world.ocu())
    async with sensor.subscribe(POSE, rate=50.0) as first:
        async with sensor.subscribe(POSE, rate=50.0) as second:
            assert first.event_id == second.event_id
            await second.get()
        received = first.received
        await until(lambda: first.received > received + 2)
        assert len(events_of(robot).subscriptions) == 1
    assert len(world.network.sent(CancelEvent)) == 1


async def test_lost_reports_are_counted(world):
    await world.robot()
    sensor = await sensor_of(await world.ocu())
    world.network.lose(Event, times=3, after=2)
    async with sensor.subscribe(POSE, rate=50.0) as poses:
        for _ in range(5):
            await poses.get()
        assert poses.lost == 3


@pytest.mark.parametrize("outage", [100, 127, 128, 150, 200, 250])
async def test_reports_lost_in_a_long_outage_are_counted(world, outage):
    await world.robot()
    sensor = await sensor_of(await world.ocu())
    async with sensor.subscribe(POSE, rate=100.0, silence=20.0) as poses:
        await until(lambda: poses.received == 10)
        sent = len(world.network.sent(Event))
        world.network.lose(Event, times=outage)
        await until(lambda: len(world.network.sent(Event)) >= sent + outage + 20, 10.0)
        assert poses.lost == outage
        await until(lambda: poses.received + poses.lost == len(world.network.sent(Event)))


@pytest.mark.slow
async def test_late_and_duplicate_reports_are_ignored(world):
    await world.robot()
    sensor = await sensor_of(await world.ocu())
    world.network.reordering = world.network.duplication = 0.3
    async with sensor.subscribe(POSE, rate=100.0) as poses:
        await asyncio.sleep(20)
        assert poses.received + poses.lost == pytest.approx(2000, abs=5)


async def test_unread_reports_are_dropped_oldest_first(world):
    await world.robot()
    sensor = await sensor_of(await world.ocu())
    async with sensor.subscribe(POSE, rate=100.0, buffer=2) as poses:
        await until(lambda: poses.received >= 6)
        assert poses.dropped == poses.received - 2
        last = [await poses.get(), await poses.get()][-1]
        assert poses.latest is last


async def test_lost_confirmation_is_requested_again(world):
    await world.robot()
    sensor = await sensor_of(await world.ocu(timeout=0.05))
    world.network.lose(ConfirmEventRequest, times=2)
    async with sensor.subscribe(POSE, rate=50.0) as poses:
        await poses.get()


async def test_rejection_explains_the_code(world):
    await world.robot()
    ocu = await world.ocu()
    sensor = await sensor_of(ocu)
    with pytest.raises(
        EventRejected, match=r"101\.1\.1 rejected the event for QueryTime: it does not answer this query"
    ):
        async with sensor.subscribe(QueryTime(presence_vector=1), rate=1.0):
            pytest.fail("subscribed to what is not there")
    assert not world.network.sent(CancelEvent)


async def test_unanswered_subscription_raises_response_timeout(world):
    await world.robot()
    sensor = await sensor_of(await world.ocu(timeout=0.02, retries=1))
    world.network.lose(CreateEvent)
    with pytest.raises(ResponseTimeout, match="CreateEvent 2 times"):
        async with sensor.subscribe(POSE, rate=10.0):
            pytest.fail("subscribed to silence")


async def test_missing_reports_raise_response_timeout(world):
    robot = await world.robot()
    sensor = await sensor_of(await world.ocu())
    async with sensor.subscribe(POSE, rate=50.0, silence=0.2) as poses:
        await poses.get()
        await robot.close()
        dried_up = r"no event with a report on QueryLocalPose came from 101\.1\.1 for 0\.2 s"
        with pytest.raises(ResponseTimeout, match=dried_up):
            await drain(poses)


async def test_vanished_component_ends_an_every_change_subscription(world, monkeypatch):
    monkeypatch.setattr(module, "RENEWAL_INTERVAL", 0.05)
    robot = await world.robot()
    sensor = await sensor_of(await world.ocu(timeout=0.03, retries=1))
    async with sensor.subscribe(QueryStatus()) as statuses:
        await statuses.get()
        await asyncio.sleep(0.2)
        await robot.close()
        with pytest.raises(ResponseTimeout, match="UpdateEvent"):
            await statuses.get()


async def test_events_are_renewed_and_recreated_after_a_restart(world, monkeypatch):
    monkeypatch.setattr(EventClient, "lifetime", lambda _: asyncio.sleep(0, 0.3))
    robot = await world.robot()
    sensor = await sensor_of(await world.ocu())
    async with sensor.subscribe(POSE, rate=20.0, silence=5.0) as poses:
        await until(lambda: len(world.network.sent(UpdateEvent)) >= 2)
        assert len(world.network.sent(CreateEvent)) == 1
        await robot.close()
        again = await world.robot()
        await until(lambda: len(events_of(again).subscriptions) == 1)
        received = poses.received
        await until(lambda: poses.received > received + 2)
    assert world.network.sent(RejectEventRequest)


async def test_event_is_recreated_after_a_restart_before_the_timeout(world):
    robot = await world.robot()
    sensor = await sensor_of(await world.ocu())
    async with sensor.subscribe(POSE, rate=50.0, silence=2.0) as poses:
        await poses.get()
        await robot.close()
        again = await world.robot()
        received = poses.received
        await until(lambda: poses.received > received + 2, 2.0)
        assert len(events_of(again).subscriptions) == 1
        await poses.get()


async def test_component_that_returns_late_is_received_again(world):
    robot = await world.robot()
    sensor = await sensor_of(await world.ocu(timeout=0.05, retries=1))
    async with sensor.subscribe(POSE, rate=50.0, silence=0.2) as poses:
        await robot.close()
        with pytest.raises(ResponseTimeout):
            await drain(poses)
        await asyncio.sleep(0.3)
        await world.robot()
        received = poses.received
        await until(lambda: poses.received > received + 2)


async def test_every_change_event_is_recreated_after_a_restart(world, monkeypatch):
    monkeypatch.setattr(module, "RENEWAL_INTERVAL", 0.1)
    robot = await world.robot()
    sensor = await sensor_of(await world.ocu())
    async with sensor.subscribe(QueryStatus()) as statuses:
        await statuses.get()
        await asyncio.sleep(0.25)
        assert statuses.received == 1  # to be renewed makes the component report without a change
        await robot.close()
        await world.robot()
        assert (await asyncio.wait_for(statuses.get(), 2.0)).status == Status.STANDBY


async def test_report_before_its_confirmation_is_accepted(world):
    await world.robot()
    sensor = await sensor_of(await world.ocu())
    hold_back(world.network, ConfirmEventRequest, 0.05)
    async with sensor.subscribe(QueryStatus()) as statuses:
        assert (await asyncio.wait_for(statuses.get(), 0.1)).status == Status.STANDBY


@pytest.mark.parametrize("after", [0, 1])
async def test_lost_report_of_a_change_is_repeated_by_renewal(world, after):
    await world.robot()
    ocu = await world.ocu()
    driver = (await ocu.discover(subsystem=101)).service("mobility:PrimitiveDriver")
    world.network.lose(Event, times=1, after=after)
    async with driver.subscribe(QueryStatus()) as statuses, driver.control():
        for _ in range(after):
            await statuses.get()
            await driver.resume()
        wanted = Status.READY if after else Status.STANDBY
        assert (await asyncio.wait_for(statuses.get(), 6)).status == wanted
        assert statuses.lost == after
        await asyncio.sleep(60)
        assert statuses.received == 1 + after


async def test_lost_cancellation_does_not_end_the_next_event(world):
    await world.robot()
    sensor = await sensor_of(await world.ocu())
    world.network.lose(CancelEvent, times=1)
    for _ in range(2):
        async with sensor.subscribe(POSE, rate=50.0) as poses:
            await asyncio.sleep(1)
            assert poses.received == pytest.approx(50, abs=5)


async def test_cancelled_event_is_not_recreated(world):
    robot = await world.robot()
    sensor = await sensor_of(await world.ocu())
    world.network.delay = 0.02
    async with sensor.subscribe(QueryStatus()):
        await asyncio.sleep(module.RENEWAL_INTERVAL - 0.02)
    await asyncio.sleep(1)
    assert not events_of(robot).subscriptions.all()
    assert len(world.network.sent(CreateEvent)) == 1


async def test_events_with_new_numbers_after_a_restart_are_distinguished(world):
    robot = await world.robot()
    sensor = await sensor_of(await world.ocu())
    async with sensor.subscribe(POSE, rate=50.0, silence=30.0) as poses, sensor.subscribe(QueryStatus()) as statuses:
        await asyncio.sleep(1)
        await robot.close()
        again = await world.robot()
        await asyncio.sleep(12)
        received = poses.received
        await until(lambda: poses.received > received + 2)
        events = {each.query.NAME: each.id for each in events_of(again).subscriptions.all()}
        assert events == {"QueryLocalPose": poses.event_id, "QueryStatus": statuses.event_id}


async def test_every_change_timeout_is_raised_and_may_end(world, monkeypatch):
    monkeypatch.setattr(module, "RENEWAL_INTERVAL", 0.05)
    robot = await world.robot()
    sensor = await sensor_of(await world.ocu(timeout=0.03, retries=1))
    async with sensor.subscribe(QueryStatus()) as statuses:
        await statuses.get()
        world.network.disconnect(robot.id)
        with pytest.raises(ResponseTimeout, match="UpdateEvent"):
            await statuses.get()
        world.network.reconnect(robot.id)
        driver = await sensor_of(await world.ocu("43.1.1"))
        async with driver.control():
            await driver.resume()
            await until(lambda: statuses.latest.status == Status.READY)


async def test_reports_go_on_when_a_renewal_is_not_answered(world, monkeypatch):
    monkeypatch.setattr(EventClient, "lifetime", lambda _: asyncio.sleep(0, 0.3))
    await world.robot()
    sensor = await sensor_of(await world.ocu(timeout=0.03, retries=1))
    async with sensor.subscribe(POSE, rate=50.0) as poses:
        world.network.lose(UpdateEvent)
        await until(lambda: len(world.network.sent(UpdateEvent)) >= 5)
        received = poses.received
        await until(lambda: poses.received > received + 2)
        await poses.get()


async def test_garbage_in_an_event_is_counted_and_skipped(world):
    robot = await world.robot()
    ocu = await world.ocu()
    sensor = await sensor_of(ocu)
    async with sensor.subscribe(POSE, rate=20.0) as poses:
        await poses.get()
        for content in (b"\x03\x44", b"\x02\x40\x01\0\0\0\0", b"\xff\xff"):
            event = Event(event_id=poses.event_id, sequence_number=9, report_message=content)
            robot.send(ocu.id, event)
        malformed = ocu.stats.malformed
        await poses.get()
        await until(lambda: ocu.stats.malformed >= malformed + 3)
        assert isinstance(await poses.get(), ReportLocalPose)


async def test_events_of_other_clients_are_ignored(world):
    await world.robot()
    ocu = await world.ocu()
    stranger = world.transport(JausID(9, 1, 1))
    await stranger.open()
    sensor = await sensor_of(ocu)
    async with sensor.subscribe(QueryStatus()) as statuses:
        await statuses.get()
        event = Event(statuses.event_id, 1, ReportStatus(status=5, reserved=0))
        stranger.send(pack(Packet(stranger.id, ocu.id, event.encode())))
        await asyncio.sleep(0.05)
        assert statuses.received == 1
    await stranger.close()


async def test_subscription_can_be_entered_again(world):
    robot = await world.robot()
    sensor = await sensor_of(await world.ocu())
    poses = sensor.subscribe(POSE, rate=50.0, silence=0.3)
    async with poses:
        await robot.close()
        with pytest.raises(ResponseTimeout):
            await drain(poses)
    await world.robot()
    await asyncio.sleep(1)
    async with poses:
        await poses.get()
        assert poses.lost == 0


async def test_subscription_can_be_entered_again_after_a_shared_use(world):
    robot = await world.robot()
    sensor = await sensor_of(await world.ocu())
    first, second = (sensor.subscribe(POSE, rate=50.0) for _ in range(2))
    async with first:
        async with second:
            pass
        async with second:
            await first.__aexit__(None, None, None)
            assert len(events_of(robot).subscriptions) == 1
            received = second.received
            await until(lambda: second.received > received + 2)


async def test_get_outside_of_the_block_is_an_error(world):
    await world.robot()
    statuses = (await sensor_of(await world.ocu())).subscribe(QueryStatus())
    with pytest.raises(ConfigError, match="this subscription is not open; use `async with` or `async for`"):
        await statuses.get()
    async with statuses:
        await statuses.get()
        waiting = asyncio.create_task(statuses.get())
        await asyncio.sleep(0)
    with pytest.raises(ConfigError, match="is not open"):
        await asyncio.wait_for(waiting, 1)


async def test_cancelled_creation_leaves_no_event(world):
    robot = await world.robot()
    sensor = await sensor_of(await world.ocu())
    world.network.delay = 0.01
    task = asyncio.create_task(sensor.subscribe(QueryStatus()).__aenter__())
    await until(lambda: world.network.sent(CreateEvent))
    task.cancel()
    with pytest.raises(asyncio.CancelledError):
        await task
    await until(lambda: len(events_of(robot).subscriptions) == 1)
    await until(lambda: len(events_of(robot).subscriptions) == 0, 5)


async def test_lost_cancellation_is_resent(world):
    robot = await world.robot()
    sensor = await sensor_of(await world.ocu())
    async with sensor.subscribe(POSE, rate=50.0) as poses:
        await poses.get()
        world.network.lose(CancelEvent, times=2)
    await until(lambda: len(events_of(robot).subscriptions) == 0)


async def test_invalid_arguments_are_rejected(world):
    await world.robot()
    sensor = await sensor_of(await world.ocu())
    with pytest.raises(ConfigError, match="rate -1"):
        sensor.subscribe(POSE, rate=-1)
    with pytest.raises(ConfigError, match="buffer of 0"):
        sensor.subscribe(POSE, rate=1, buffer=0)
    async with sensor.subscribe(POSE, rate=1) as poses:
        with pytest.raises(ConfigError, match="already open"):
            await poses.__aenter__()


def reported(*numbers: int, rate: float = 10.0) -> list[int | None]:
    """What each of these numbers, one period apart, says of those before."""
    sequence, period = SequenceTracker(), 1.0 / rate
    return [sequence.missing(number & 0xFF, rate, index * period) for index, number in enumerate(numbers)]


@pytest.mark.parametrize(
    ("numbers", "missing"),
    [
        ((7, 8, 9), [0, 0, 0]),
        ((254, 255, 256, 257), [0, 0, 0, 0]),
        ((1, 2, 5, 6), [0, 0, 2, 0]),
        ((1, 3, 2, 4), [0, 1, None, 0]),
        ((1, 1, 2), [0, None, 0]),
        ((255, 256, 255, 257), [0, 0, None, 0]),
    ],
)
def test_gaps_are_counted_by_sequence_numbers(numbers, missing):
    assert reported(*numbers) == missing


@pytest.mark.parametrize("rate", [0.0, 0.1, 10.0, 100.0])
def test_no_report_counts_as_late_after_a_long_silence(rate):
    sequence = SequenceTracker()
    assert sequence.missing(0, rate, 0.0) == 0
    assert sequence.missing(201, rate, MAX_DELAY) == 200
    assert sequence.missing(202, rate, MAX_DELAY) == 0


def test_silence_limit_depends_on_the_rate():
    sequence = SequenceTracker()
    assert sequence.missing(0, 500.0, 0.0) == 0
    assert sequence.missing(151, 500.0, 0.25) is None
    assert sequence.missing(151, 500.0, 0.3) == 150
