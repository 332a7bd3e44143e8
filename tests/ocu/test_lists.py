"""Lists as Python sequences, against the real ListManager and a driver that is told when it arrives."""

from __future__ import annotations

import asyncio

import numpy as np
import pytest

from jauspy.errors import ConfigError, ControlRejected, ElementRejected, EncodeError, RequestError, ResponseTimeout
from jauspy.ids import JausID
from jauspy.messages.core import (
    ConfirmElementRequest,
    CreateEvent,
    DeleteElement,
    ElementRec,
    Event,
    ReportElementList,
    SetElement,
)
from jauspy.messages.mobility import ExecuteList, ReportActiveElement, SetGlobalWaypoint, SetLocalWaypoint
from jauspy.ocu.lists import ACTIVE_ELEMENT_INTERVAL
from jauspy.services.core import AccessControl, Discovery, Events, ListDriver, ListManager, Liveness, Management
from jauspy.services.core.list_manager import ElementList
from jauspy.testing import LocalNode, until

ROBOT = JausID(101, 1, 1)


class Driver(ListDriver, urn="urn:jaus:jss:mobility:LocalWaypointListDriver"):
    """Knows what it was told to go for; a test says when it has arrived."""

    element_types = (SetLocalWaypoint,)

    def __init__(self) -> None:
        self.began: list[float] = []
        self.speeds: list[float] = []

    def begin_element(self, uid, message) -> None:
        self.began.append(message.x)

    def end_elements(self) -> None:
        pass

    def execute_waypoint_list(self, msg) -> None:
        self.speeds.append(msg.speed)
        self.elements.execute(msg.element_uid)

    def modify_travel_speed(self, msg) -> None:
        self.speeds.append(msg.speed)

    def reset_travel_speed(self) -> None:
        self.elements.stop()

    def report_active_element(self) -> ReportActiveElement:
        return ReportActiveElement(self.elements.active)

    def report_travel_speed(self):
        raise NotImplementedError

    report_travel_speed_ext = report_local_waypoint = report_local_waypoint_ext = waypoint_exists = report_travel_speed

    def arrive(self, component) -> None:
        self.elements.done()
        component.wake()


def at(*xs: float) -> list[SetLocalWaypoint]:
    return [SetLocalWaypoint(x=float(x), y=0.0) for x in xs]


def xs(elements) -> list[int]:
    return [round(each.x) for each in elements]


def services(driver: Driver, **options):
    return [AccessControl(timeout=0), Events(), Management(), Discovery(), Liveness(), ListManager(**options), driver]


@pytest.fixture
def driver() -> Driver:
    return Driver()


@pytest.fixture
async def robot(virtual_network, driver):
    async with virtual_network.component(ROBOT, services(driver)) as component:
        yield component


@pytest.fixture
async def client(robot, ocu):
    """The list driver of a robot that this OCU controls and that is Ready."""
    found = (await ocu.discover(101)).service("LocalWaypointListDriver")
    async with found.control():
        await found.resume()
        yield found


def order(component) -> list[int]:
    """What the component really has."""
    manager = component.host.service(ListManager)
    return [round(manager.message(uid).x) for uid in manager.list.order]


async def test_uploaded_and_read_back(robot, client):
    waypoints = client.waypoints
    with pytest.raises(ConfigError, match=r"was not read yet; call `read\(\)`"):
        len(waypoints)
    assert "? elements of" in repr(waypoints)
    await waypoints.upload(at(1, 2, 3, 4))
    assert order(robot) == xs(waypoints) == [1, 2, 3, 4]
    await waypoints.upload(at(7, 8))
    assert order(robot) == xs(waypoints) == [7, 8]
    assert xs(await waypoints.read()) == [7, 8]
    assert isinstance(waypoints[0], SetLocalWaypoint)


async def test_elements_behave_as_a_sequence(client):
    waypoints = client.waypoints
    await waypoints.upload(at(1, 2, 3, 4))
    assert xs(waypoints[1:3]) == [2, 3]
    assert waypoints[-1].x == pytest.approx(4, abs=1e-4)
    assert waypoints[0] in waypoints
    assert [round(each.x) for each in reversed(waypoints)] == [4, 3, 2, 1]


CHANGES = [
    (lambda it: it.append(at(9)[0]), lambda it: it.append(9)),
    (lambda it: it.extend(at(8, 9)), lambda it: it.extend([8, 9])),
    (lambda it: it.insert(0, at(9)[0]), lambda it: it.insert(0, 9)),
    (lambda it: it.insert(2, at(9)[0]), lambda it: it.insert(2, 9)),
    (lambda it: it.insert(-1, at(9)[0]), lambda it: it.insert(-1, 9)),
    (lambda it: it.insert(99, at(9)[0]), lambda it: it.insert(99, 9)),
    (lambda it: it.replace(1, at(9)[0]), lambda it: it.__setitem__(1, 9)),
    (lambda it: it.replace(-1, at(9)[0]), lambda it: it.__setitem__(-1, 9)),
    (lambda it: it.replace(slice(1, 3), at(9, 8)), lambda it: it.__setitem__(slice(1, 3), [9, 8])),
    (lambda it: it.replace(slice(0, 4, 2), at(9, 8)), lambda it: it.__setitem__(slice(0, 4, 2), [9, 8])),
    (lambda it: it.replace(slice(1, 3), at(9)), lambda it: it.__setitem__(slice(1, 3), [9])),
    (lambda it: it.replace(slice(1, 1), at(9, 8)), lambda it: it.__setitem__(slice(1, 1), [9, 8])),
    (lambda it: it.delete(0), lambda it: it.__delitem__(0)),
    (lambda it: it.delete(-1), lambda it: it.__delitem__(-1)),
    (lambda it: it.delete(slice(1, 3)), lambda it: it.__delitem__(slice(1, 3))),
    (lambda it: it.delete(slice(None, None, 2)), lambda it: it.__delitem__(slice(None, None, 2))),
    (lambda it: it.clear(), lambda it: it.clear()),
]


@pytest.mark.slow
@pytest.mark.parametrize(("change", "same"), CHANGES)
@pytest.mark.parametrize("bad", [False, True])
async def test_changes_match_those_of_a_python_list(virtual_network, robot, client, *, change, same, bad):
    wanted = [1, 2, 3, 4]
    await client.waypoints.upload(at(*wanted))
    if bad:  # each confirmation is lost once, so each request is sent twice
        virtual_network.lose(ConfirmElementRequest, times=1)
    same(wanted)
    await change(client.waypoints)
    assert order(robot) == xs(client.waypoints) == wanted


async def test_existing_list_is_read_before_a_change(client, ocu):
    await client.waypoints.upload(at(1, 2))
    again = (await ocu.discover(101)).service("LocalWaypointListDriver").waypoints
    await again.append(at(3)[0])
    assert xs(again) == [1, 2, 3]


async def test_long_lists_use_several_requests(virtual_network, robot, client):
    await client.waypoints.upload(at(*range(600)))
    assert order(robot) == list(range(600))
    assert len(virtual_network.sent(SetElement)) == 3
    await client.waypoints.clear()
    assert order(robot) == []
    assert len(virtual_network.sent(DeleteElement)) == 3


async def test_new_list_is_complete_before_the_old_one_is_deleted(virtual_network, robot, driver, client):
    await client.waypoints.upload(at(1, 2))
    await client.waypoints.execute(speed=1.0)
    before = len(virtual_network.sent(SetElement))
    await client.waypoints.upload(at(*range(10, 310)))
    assert order(robot) == xs(client.waypoints) == list(range(10, 310))
    assert len(virtual_network.sent(SetElement)) == before + 2
    assert driver.began == [pytest.approx(1.0, abs=1e-3)], "the robot goes on with the old list, and with no other"
    assert await client.waypoints.active() is None


REFUSED = {
    "an element that no driver carries out": [*at(*range(300)), SetGlobalWaypoint(latitude=1.0, longitude=2.0)],
    "a value that does not fit": [*at(*range(300)), *at(1e9)],
    "more than there is room for": at(*range(1023)),
}


@pytest.mark.parametrize("new", REFUSED.values(), ids=REFUSED)
async def test_rejected_upload_keeps_the_old_list(robot, client, new):
    await client.waypoints.upload(at(1, 2))
    with pytest.raises((ElementRejected, EncodeError)):
        await client.waypoints.upload(new)
    assert order(robot) == xs(await client.waypoints.read()) == [1, 2]


async def test_cancelled_upload_keeps_the_old_list(virtual_network, robot, client):
    await client.waypoints.upload(at(1, 2))
    before = len(virtual_network.sent(SetElement))
    virtual_network.delay = 0.01
    task = asyncio.create_task(client.waypoints.upload(at(*range(600))))
    await until(lambda: len(virtual_network.sent(SetElement)) == before + 2)
    task.cancel()
    with pytest.raises(asyncio.CancelledError):
        await task
    assert order(robot) == xs(await client.waypoints.read()) == [1, 2]


async def test_network_failure_keeps_the_old_list_after_new_elements(virtual_network, robot, client):
    await client.waypoints.upload(at(1, 2))
    lost = [each.CODE.to_bytes(2, "little") for each in (ConfirmElementRequest, DeleteElement)]
    virtual_network.keeps = lambda packet: packet.payload[:2] not in lost
    with pytest.raises(ResponseTimeout) as caught:
        await client.waypoints.upload(at(7, 8))
    assert "still in front of the old one" in caught.value.__notes__[0]
    assert order(robot)[-2:] == [1, 2]
    with pytest.raises(ConfigError, match="was not read yet"):
        len(client.waypoints)


async def test_undeletable_old_list_follows_the_new_one(virtual_network, robot, client):
    await client.waypoints.upload(at(1, 2))
    virtual_network.lose(DeleteElement)
    with pytest.raises(ResponseTimeout) as caught:
        await client.waypoints.upload(at(7, 8))
    assert "behind it what is left of the old one" in caught.value.__notes__[0]
    assert order(robot) == [7, 8, 1, 2]
    with pytest.raises(ConfigError, match="was not read yet"):
        client.waypoints[-1]


@pytest.mark.parametrize("count", [1, 3])
async def test_loop_is_replaced_by_a_linear_list(robot, client, count):
    uids = [*range(1, count + 1)]
    ring = zip(uids, uids[-1:] + uids[:-1], uids[1:] + uids[:1], at(*uids), strict=True)
    await client.query(
        SetElement(
            SetElement.RequestIDRec(9), [ElementRec(*links, ElementRec.ElementData(0, it)) for *links, it in ring]
        ),
        expects=ConfirmElementRequest,
    )
    assert robot.host.service(ListManager).list.loop
    await client.waypoints.upload(at(7, 8))
    assert order(robot) == [7, 8]
    assert not robot.host.service(ListManager).list.loop


async def test_inconsistent_links_keep_the_old_list(virtual_network, ocu, driver):
    class Careless(ListManager):
        """Confirms, and puts everything at the end."""

        def set_element(self, msg) -> None:
            super().set_element(msg)
            self.list = ElementList(tuple(sorted(self.list.order)))

    careless = [AccessControl(timeout=0), Events(), Management(), Discovery(), Careless(), driver]
    async with virtual_network.component(ROBOT, careless) as component:
        found = (await ocu.discover(101)).service("LocalWaypointListDriver")
        async with found.control():
            await found.waypoints.upload(at(1, 2))
            with pytest.raises(ElementRejected, match=r"101\.1\.1 confirmed a new list in front of its old one"):
                await found.waypoints.upload(at(7, 8))
        assert order(component) == [1, 2]


async def test_rejections_have_a_reason_and_change_nothing(robot, client):
    await client.waypoints.upload(at(1, 2))
    with pytest.raises(ElementRejected, match=r"101\.1\.1 .*UNSUPPORTED_ELEMENT_TYPE.*none of its drivers"):
        await client.waypoints.append(SetGlobalWaypoint(latitude=1.0, longitude=2.0))
    with pytest.raises(ElementRejected, match="UNSUPPORTED_ELEMENT_TYPE"):
        await client.waypoints.append(b"something else")
    assert order(robot) == xs(client.waypoints) == [1, 2]


async def test_foreign_change_of_the_list_is_an_error(robot, client, ocu):
    await client.waypoints.upload(at(1, 2, 3))
    await (await ocu.discover(101)).service("LocalWaypointListDriver").waypoints.delete(2)
    with pytest.raises(ElementRejected, match=r"the list has changed meanwhile; call `read\(\)`"):
        await client.waypoints.append(at(4)[0])
    await client.waypoints.read()
    await client.waypoints.append(at(4)[0])
    assert order(robot) == [1, 2, 4]


async def test_change_without_control_is_an_error(robot, ocu):
    waypoints = (await ocu.discover(101)).service("LocalWaypointListDriver").waypoints
    with pytest.raises(ResponseTimeout, match="only from the client in control"):
        await waypoints.append(at(1)[0])


async def test_change_after_loss_of_control_is_an_error(virtual_network, robot, client):
    await client.waypoints.upload(at(1, 2))
    async with virtual_network.ocu("43.1.1") as other:
        strong = (await other.discover(101)).service("LocalWaypointListDriver")
        async with strong.control(authority=200):
            await asyncio.sleep(1)
            with pytest.raises(ControlRejected, match=r"control of 101\.1\.1 was lost"):
                await client.waypoints.append(at(3)[0])
    assert order(robot) == [1, 2]


@pytest.mark.parametrize(
    ("change", "error"),
    [
        (lambda it: it.delete(4), IndexError),
        (lambda it: it.replace(-5, at(1)[0]), IndexError),
        (lambda it: it.replace(0, at(1, 2)), TypeError),
        (lambda it: it.replace(np.int64(0), at(1, 2)), TypeError),
        (lambda it: it.replace(0, 5), TypeError),
        (lambda it: it.replace(slice(0, 2), at(1)[0]), TypeError),
        (lambda it: it.replace(slice(0, 4, 2), at(1)), ConfigError),
        (lambda it: it.execute(), ConfigError),
        (lambda it: it.execute(1.0, start=9), IndexError),
    ],
)
async def test_invalid_arguments_are_rejected_before_sending(virtual_network, robot, client, change, error):
    await client.waypoints.upload(at(1, 2, 3, 4))
    sent = len(virtual_network.sent(SetElement)) + len(virtual_network.sent(DeleteElement))
    with pytest.raises(error):
        await change(client.waypoints)
    assert len(virtual_network.sent(SetElement)) + len(virtual_network.sent(DeleteElement)) == sent
    assert order(robot) == [1, 2, 3, 4]


async def test_list_is_executed_and_progress_reported(robot, driver, client):
    waypoints = client.waypoints
    await waypoints.upload(at(1, 2, 3))
    await waypoints.execute(speed=1.5)
    assert await waypoints.active() == 0
    seen = []
    async for index in waypoints.progress():
        seen.append(index)
        driver.arrive(robot)
    assert seen == [0, 1, 2]
    assert [round(x) for x in driver.began] == [1, 2, 3]
    assert driver.speeds == [pytest.approx(1.5, abs=0.01)]
    assert await waypoints.active() is None


async def test_lost_execute_is_resent_and_lost_end_detected(virtual_network, robot, driver, client):
    await client.waypoints.upload(at(1, 2))
    virtual_network.lose(ExecuteList, times=1)
    await client.waypoints.execute(speed=1.0)
    assert len(virtual_network.sent(ExecuteList)) == 2

    virtual_network.lose(Event)
    seen = []
    async for index in client.waypoints.progress():
        seen.append(index)
        driver.arrive(robot)
    assert seen == [0, 1]


async def test_late_answers_about_other_elements_are_ignored(virtual_network, robot, client):
    await client.waypoints.upload(at(1, 2, 3))
    virtual_network.delay = 0.3  # so that each question is sent twice
    assert xs(await client.waypoints.read()) == [1, 2, 3]


async def test_late_answer_about_an_earlier_list_is_ignored(virtual_network, robot, client):
    virtual_network.delay = 0.02
    upload = asyncio.create_task(client.waypoints.upload(at(1, 2, 3)))
    await until(lambda: virtual_network.sent(ConfirmElementRequest))
    robot.send("42.1.1", ReportElementList([]))
    await upload
    assert order(robot) == xs(client.waypoints) == [1, 2, 3]


async def test_an_element_that_does_not_end_is_an_error(robot, driver, client):
    waypoints = client.waypoints
    await waypoints.upload([SetLocalWaypoint(x=50.0, y=0.0)])
    await waypoints.execute(speed=0.5)
    progress = waypoints.progress(timeout=5.0)
    assert await anext(progress) == 0
    with pytest.raises(RequestError, match="is still at element 0 after 5 s"):
        await anext(progress)


async def test_missing_reports_do_not_end_progress(virtual_network, robot, driver, client):
    await client.waypoints.upload(at(1, 2))
    await client.waypoints.execute(speed=1.0)
    virtual_network.lose(CreateEvent, times=2)
    seen = []
    async for index in client.waypoints.progress(grace=0.5):
        seen.append(index)
        driver.arrive(robot)
    assert seen == [0, 1]


async def test_execution_starts_anywhere_at_another_speed(virtual_network, robot, driver, client):
    await client.waypoints.upload(at(1, 2, 3))
    await client.waypoints.execute(speed=1.0, start=-1)
    assert await client.waypoints.active() == 2
    virtual_network.lose(ExecuteList, times=2)
    await client.waypoints.set_speed(0.5)
    assert driver.speeds == [pytest.approx(1.0, abs=0.01), pytest.approx(0.5, abs=0.01)]


async def test_execute_in_standby_is_an_error(client):
    await client.waypoints.upload(at(1))
    await client.standby()
    with pytest.raises(RequestError, match=r"101\.1\.1 ignores ExecuteList while it is STANDBY; call `resume\(\)`"):
        await client.waypoints.execute(speed=1.0)
    assert [each async for each in client.waypoints.progress()] == []


async def test_progress_polls_if_events_are_rejected(virtual_network, ocu, driver):
    refusing = [AccessControl(timeout=0), Events(limit=0), Management(), Discovery(), ListManager(), driver]
    async with virtual_network.component(ROBOT, refusing) as component:
        found = (await ocu.discover(101)).service("LocalWaypointListDriver")
        async with found.control():
            await found.resume()
            await found.waypoints.upload(at(1, 2))
            await found.waypoints.execute(speed=1.0)
            seen = []
            async for index in found.waypoints.progress():
                seen.append(index)
                asyncio.get_running_loop().call_later(3 * ACTIVE_ELEMENT_INTERVAL, driver.arrive, component)
        assert seen == [0, 1]


async def test_elements_work_over_a_node_manager(driver):
    with LocalNode() as node:
        async with node.component(ROBOT, services(driver)) as component, node.ocu() as ocu:
            found = (await ocu.discover(101)).service("LocalWaypointListDriver")
            async with found.control():
                await found.resume()
                await found.waypoints.upload(at(*range(300)))
                await found.waypoints.delete(slice(4, None))
                await found.waypoints.execute(speed=1.0)
                async with asyncio.timeout(20):
                    async for _ in found.waypoints.progress():
                        driver.arrive(component)
            assert [round(x) for x in driver.began] == [0, 1, 2, 3]
