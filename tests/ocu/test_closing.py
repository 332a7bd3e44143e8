"""An OCU that is closed while it controls, listens or waits: the robot stands, and everybody is told why."""

from __future__ import annotations

import asyncio

import pytest
from tests.ocu.test_control import FULL, Status, driver_of, until
from tests.ocu.test_subscription import POSE, drain, events_of, sensor_of

from jauspy.errors import ControlRejected, TransportError
from jauspy.messages.core import QueryStatus
from jauspy.messages.mobility import SetLocalWaypoint
from jauspy.ocu import OCU


async def test_close_leaves_controlled_components_in_standby(world):
    robot = await world.robot()
    ocu = await world.ocu()
    driver = await driver_of(ocu)
    async with driver.control() as control:
        await driver.resume()
        await driver.send(FULL)
        await until(lambda: world.drives[0].effort[0] > 0)
        await ocu.close()
        await until(lambda: robot.host.controller is None, 1)
        assert (robot.host.status, world.drives[0].effort) == (Status.STANDBY, (0.0, 0.0))
        assert control.lost == "the OCU was closed"
        with pytest.raises(ControlRejected, match=r"control of 101\.1\.1 was lost: the OCU was closed"):
            await driver.send(FULL)


async def test_close_stops_a_robot_driven_by_another_task(world):
    robot = await world.robot()

    async def drive(driver) -> None:
        async with driver.control():
            await driver.resume()
            while True:
                await driver.send(FULL)
                await asyncio.sleep(0.1)

    async with world.network.ocu() as ocu:
        task = asyncio.create_task(drive(await driver_of(ocu)))
        await until(lambda: world.drives[0].effort[0] > 0)
    await until(lambda: robot.host.controller is None, 1)
    assert world.drives[0].effort == (0.0, 0.0)
    with pytest.raises(ControlRejected, match="the OCU was closed"):
        await task


async def test_close_ends_events_and_waiting_readers(world):
    robot = await world.robot()
    ocu = await world.ocu()
    sensor = await sensor_of(ocu)
    async with sensor.subscribe(POSE, rate=50.0) as poses, sensor.subscribe(QueryStatus()) as statuses:
        await statuses.get()
        waiting = asyncio.create_task(statuses.get())
        await asyncio.sleep(0)
        await ocu.close()
        with pytest.raises(TransportError, match="the OCU was closed, and with it the event on QueryStatus"):
            await asyncio.wait_for(waiting, 0.1)
        with pytest.raises(TransportError, match="the OCU was closed"):
            await drain(poses)
        await until(lambda: len(events_of(robot).subscriptions) == 0, 1)


async def test_use_from_another_event_loop_is_an_error(tmp_path):
    ocu = OCU(connect="udp://127.0.0.1:9")
    await asyncio.to_thread(asyncio.run, ocu.open())
    with pytest.raises(TransportError, match=r"opened in another event loop .* inside one `asyncio.run`, or"):
        await ocu.query("101.1.1", QueryStatus())
    with pytest.raises(TransportError, match="opened in another event loop"):
        await ocu.send("101.1.1", SetLocalWaypoint(x=1.0, y=1.0))
    await ocu.close()
