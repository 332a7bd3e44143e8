"""Values of wrong types: one sentence at the call, which says what is wrong with what, and nothing is sent."""

from __future__ import annotations

import pytest
from tests.ocu.test_lists import ROBOT, Driver, services

import jauspy
from jauspy.ids import JausID
from jauspy.messages.core import QueryStatus, ReportStatus, Resume
from jauspy.messages.mobility import QueryLocalPose, SetLocalWaypoint, SetWrenchEffort


@pytest.fixture
async def ocu_and_robot(virtual_network):
    async with virtual_network.component(ROBOT, services(Driver())), virtual_network.ocu() as ocu:
        yield ocu, await ocu.discover(101)


async def first(iterator):
    return await anext(aiter(iterator))


async def entered(context):
    async with context:
        pass


A_CLASS = r"{} takes a message, and {} is only its class; write {}\(\.\.\.\)$"
ASKING = {
    "text": (lambda it: it.query("QueryStatus"), r"^query\(\) takes a message, as in QueryStatus\(\), not the str 'Q"),
    "class": (lambda it: it.query(QueryStatus), A_CLASS.format(r"query\(\)", "QueryStatus", "QueryStatus")),
    "nothing": (lambda it: it.query(None), r"not None$"),
    "expects": (
        lambda it: it.query(QueryStatus(), expects=ReportStatus(ReportStatus.Status.READY, 0)),
        r"^expects takes the class .* not a message; write ReportStatus without brackets$",
    ),
    "expects text": (lambda it: it.query(QueryStatus(), expects="ReportStatus"), "not the str 'ReportStatus'"),
    "timeout": (lambda it: it.query(QueryStatus(), timeout="1"), r"^timeout is a number, not the str '1'$"),
    "retries": (lambda it: it.query(QueryStatus(), retries=1.5), r"^retries is a whole number, not the float 1.5$"),
    "send class": (
        lambda it: it.send(SetWrenchEffort),
        A_CLASS.format(r"send\(\)", "SetWrenchEffort", "SetWrenchEffort"),
    ),
    "send bytes": (lambda it: it.send(b"\x04\x00"), r"^send\(\) takes a message, as in Resume\(\), not the bytes"),
    "acknowledged": (lambda it: it.send(Resume, ack=True), "Resume is only its class"),
    "authority": (lambda it: entered(it.control("200")), r"^authority is a whole number, not the str '200'$"),
    "rate": (lambda it: first(it.subscribe(QueryLocalPose(1), rate="10")), r"^rate is a number, not the str '10'$"),
    "event": (lambda it: first(it.subscribe(QueryLocalPose)), r"^subscribe\(\) takes a message, and QueryLocalPose"),
    "silence": (lambda it: first(it.subscribe(QueryStatus(), silence="a")), r"^silence is a number"),
    "buffer": (lambda it: first(it.subscribe(QueryStatus(), buffer=2.5)), r"^buffer is a whole number"),
    "resume": (lambda it: it.resume("soon"), r"^timeout is a number, not the str 'soon'$"),
    "message": (lambda it: it.message(5), r"^a message's name is text, not the int 5$"),
    "one element": (
        lambda it: it.elements.upload(SetLocalWaypoint(x=1.0, y=1.0)),
        r"^a list is made of several elements, as in \[SetLocalWaypoint\(x=1.0, y=2.0\)\], not the SetLocalWaypoint",
    ),
    "tuples": (lambda it: it.elements.upload([(1.0, 2.0)]), r"^a list takes a message, as in Set.* not the tuple \(1"),
    "one for one": (
        lambda it: it.elements.replace(0, (1.0, 2.0)),
        r"^a list takes a message, as in SetLocalWaypoint\(x=1.0, y=2.0\), not the tuple \(1.0, 2.0\)$",
    ),
    "one for several": (lambda it: it.elements.replace(slice(0, 2), 5), r"^a list is made of several elements"),
    "element class": (lambda it: it.elements.append(SetLocalWaypoint), "SetLocalWaypoint is only its class"),
    "index": (lambda it: it.elements.delete("1"), r"^index is a whole number, not the str '1'$"),
    "speed": (lambda it: it.elements.set_speed("1"), r"^speed is a number, not the str '1'$"),
}


@pytest.mark.parametrize(("call", "words"), ASKING.values(), ids=ASKING)
async def test_invalid_service_arguments_are_rejected(virtual_network, ocu_and_robot, call, words):
    client = ocu_and_robot[1].service("LocalWaypointListDriver")
    sent = virtual_network.sent(Resume), virtual_network.sent(SetWrenchEffort)
    with pytest.raises(TypeError, match=words):
        await call(client)
    assert sent == (virtual_network.sent(Resume), virtual_network.sent(SetWrenchEffort))


FINDING = {
    "swapped": (lambda it: it.send(Resume(), "101.1.102"), r"^a JAUS id is text, as in '101.1.102', or a JausID, not"),
    "number": (lambda it: it.query(101, QueryStatus()), "not the int 101$"),
    "discover": (lambda it: it.discover("101"), r"^a subsystem is a whole number, not the str '101'$"),
    "discover id": (lambda it: it.discover(JausID(101, 1, 102)), r"^a subsystem is a whole number, not the JausID"),
    "limit": (lambda it: it.discover_all(timeout="1"), r"^timeout is a number"),
    "each": (lambda it: first(it.query_each("101.1.255", QueryStatus)), r"^query_each\(\) takes a message, and"),
    "within": (lambda it: first(it.query_each("101.1.255", QueryStatus(), within="1")), r"^within is a number"),
    "watch": (lambda it: first(it.watch(interval="1")), r"^interval is a number"),
}


@pytest.mark.parametrize(("call", "words"), FINDING.values(), ids=FINDING)
async def test_invalid_ocu_arguments_are_rejected(ocu, call, words):
    with pytest.raises(TypeError, match=words):
        await call(ocu)


@pytest.mark.parametrize(
    ("call", "words"),
    [
        (lambda: jauspy.OCU(5), r"^a JAUS id is text"),
        (lambda: jauspy.OCU(timeout="x"), r"^timeout is a number"),
        (lambda: jauspy.OCU(name=5), r"^an OCU's name is text"),
        (lambda: jauspy.OCU(registry="vendor/*.xml"), r"^registry is what `jauspy.load` returns, not the str 'vendor"),
    ],
)
def test_invalid_constructor_arguments_are_rejected(call, words):
    with pytest.raises(TypeError, match=words):
        call()


async def test_invalid_robot_arguments_are_rejected(ocu_and_robot):
    robot = ocu_and_robot[1]
    for place in (robot, robot.component(1)):
        with pytest.raises(TypeError, match=r"^a service's name is text, not the int 5$"):
            place.service(5)


WITHOUT_ASYNC = {
    "an OCU": (lambda ocu, it: with_(ocu), "use `async with` with this OCU, inside `async def`; .*jauspy.sync.OCU$"),
    "control": (lambda ocu, it: with_(it.control()), "use `async with` with this Control"),
    "an event": (lambda ocu, it: with_(it.subscribe(QueryStatus())), "use `async with` with this Subscription"),
    "a loop": (lambda ocu, it: list(it.subscribe(QueryStatus())), "use `async for` with this Subscription"),
    "item": (lambda ocu, it: it.waypoints.__setitem__(0, it), r"use `await elements.replace\(index, ...\)` with"),
    "del": (lambda ocu, it: it.waypoints.__delitem__(0), r"use `await elements.delete\(index\)` with this Elements"),
    "+=": (lambda ocu, it: it.waypoints.__iadd__([]), r"use `await elements.extend\(...\)` with this Elements"),
}


def with_(it):
    with it:
        pytest.fail("entered")


@pytest.mark.parametrize(("call", "words"), WITHOUT_ASYNC.values(), ids=WITHOUT_ASYNC)
async def test_with_instead_of_async_with_is_explained(ocu_and_robot, call, words):
    ocu, robot = ocu_and_robot
    with pytest.raises(TypeError, match=words):
        call(ocu, robot.service("LocalWaypointListDriver"))


async def test_invalid_connect_error_lists_the_forms():
    with pytest.raises(jauspy.ConfigError, match=r"connect=5 is not supported; use 'udp://HOST"):
        await jauspy.OCU(connect=5).open()
