"""Every transition of ListManager, and what its drivers see of it."""

from __future__ import annotations

import pytest

from jauspy.messages.core import (
    CommandEvent,
    ConfirmElementRequest,
    CreateCommandEvent,
    DeleteElement,
    ElementRec,
    QueryElement,
    QueryElementCount,
    QueryElementList,
    RejectElementRequest,
    ReleaseControl,
    ReportElement,
    ReportElementCount,
    ReportElementList,
    RequestControl,
    Resume,
    SetElement,
    SetEmergency,
    Standby,
)
from jauspy.messages.mobility import (
    ExecuteList,
    QueryActiveElement,
    ReportActiveElement,
    SetGlobalWaypoint,
    SetLocalWaypoint,
)
from jauspy.services.core import AccessControl, ListDriver, ListManager, Management
from jauspy.services.core.list_manager import LAP_PAUSE

A, B = "42.1.1", "42.2.1"
Code = RejectElementRequest.ResponseCode
JAUS_MESSAGE, USER_DEFINED = 0, 1


class _Driver(ListDriver):
    def __init__(self) -> None:
        self.begun: list[int] = []
        self.messages: list = []
        self.ended = 0

    def begin_element(self, uid, message) -> None:
        self.begun.append(uid)
        self.messages.append(message)

    def end_elements(self) -> None:
        self.ended += 1

    def report_active_element(self) -> ReportActiveElement:
        return ReportActiveElement(element_uid=self.elements.active)

    def execute_waypoint_list(self, msg) -> None:
        self.elements.execute(msg.element_uid)

    def modify_travel_speed(self) -> None:
        self.messages.append("speed")

    def reset_travel_speed(self) -> None:
        self.elements.stop()

    def __getattr__(self, name: str):
        if name.startswith(("report_", "waypoint_exists")):
            return lambda: None
        raise AttributeError(name)


class Local(_Driver, urn="urn:jaus:jss:mobility:LocalWaypointListDriver"):
    element_types = (SetLocalWaypoint,)


class Global(_Driver, urn="urn:jaus:jss:mobility:GlobalWaypointListDriver"):
    element_types = (SetGlobalWaypoint,)


def local(x: float) -> ElementRec.ElementData:
    return ElementRec.ElementData(JAUS_MESSAGE, SetLocalWaypoint(x=x, y=0.0))


def put(*elements, request: int = 7) -> SetElement:
    """Each (uid, previous, next) or (uid, previous, next, data)."""
    return SetElement(
        SetElement.RequestIDRec(request), [ElementRec(*each[:3], (*each, local(each[0]))[3]) for each in elements]
    )


def delete(*uids: int, request: int = 8) -> DeleteElement:
    return DeleteElement(DeleteElement.RequestIDRec(request), [DeleteElement.DeleteElementRec(uid) for uid in uids])


def execute(uid: int | None) -> ExecuteList:
    return ExecuteList(speed=1.0, element_uid=uid)


THREE = put((1, 0, 2), (2, 1, 3), (3, 2, 0))
DONE = ConfirmElementRequest(7)


@pytest.fixture
def driver() -> Local:
    return Local()


@pytest.fixture
def rig(make, driver):
    rig = make(driver, Global(), AccessControl(timeout=0))
    rig.tell(A, RequestControl(100))
    rig.tell(A, Resume())
    return rig


def order(rig) -> list[int]:
    return [each.element_uid for each in rig.ask(B, QueryElementList()).element_list]


def active(rig) -> int:
    return rig.ask(B, QueryActiveElement()).element_uid


def test_set_query_delete(rig) -> None:
    assert rig.ask(A, THREE) == DONE
    assert order(rig) == [1, 2, 3]
    assert rig.ask(B, QueryElementCount()) == ReportElementCount(3)
    answer = rig.ask(B, QueryElement(2))
    assert isinstance(answer, ReportElement)
    assert (answer.element_uid, answer.previous_uid, answer.next_uid) == (2, 1, 3)
    assert answer.element_data.data.encode() == local(2).data.encode()
    assert rig.ask(A, delete(2)) == ConfirmElementRequest(8)
    assert rig.ask(B, QueryElement(1)).next_uid == 3
    assert rig.tell(B, QueryElement(2)) == []
    assert rig.tell(B, QueryElement(0)) == []
    assert rig.ask(A, delete(65535)) == ConfirmElementRequest(8)
    assert rig.ask(B, QueryElementList()) == ReportElementList([])


@pytest.mark.parametrize(
    ("message", "code"),
    [
        (put((0, 3, 0)), Code.INVALID_ELEMENT_ID),
        (put((4, 9, 0)), Code.INVALID_PREVIOUS_ELEMENT),
        (put((4, 3, 9)), Code.INVALID_NEXT_ELEMENT),
        (put((4, 3, 0, ElementRec.ElementData(0, Resume()))), Code.UNSUPPORTED_ELEMENT_TYPE),
        (put((4, 3, 0, ElementRec.ElementData(USER_DEFINED, b"\x0d\x04\x00"))), Code.UNSUPPORTED_ELEMENT_TYPE),
        (put((4, 3, 0, ElementRec.ElementData(0, b"\x0d\x04\xff"))), Code.UNSUPPORTED_ELEMENT_TYPE),
        (put((4, 3, 0, ElementRec.ElementData(0, b""))), Code.UNSUPPORTED_ELEMENT_TYPE),
        (put((4, 3, 5), (5, 4, 0, ElementRec.ElementData(0, Resume()))), Code.UNSUPPORTED_ELEMENT_TYPE),
        (delete(9), Code.ELEMENT_NOT_FOUND),
        (delete(1, 9), Code.ELEMENT_NOT_FOUND),
        (put(), Code.UNSPECIFIED_ERROR),
    ],
)
def test_invalid_request_is_rejected_and_changes_nothing(rig, message, code) -> None:
    rig.tell(A, THREE)
    assert rig.ask(A, message) == RejectElementRequest(message.request_id_rec.request_id, code)
    assert order(rig) == [1, 2, 3]


def test_the_list_is_bounded_in_elements_and_bytes(make) -> None:
    for limits in ({"max_elements": 2}, {"max_bytes": 30}):
        rig = make(Local(), ListManager(**limits))
        rig.tell(A, RequestControl(100))
        assert rig.ask(A, THREE) == RejectElementRequest(7, Code.OUT_OF_MEMORY)
        assert rig.ask(A, put((1, 0, 2), (2, 1, 0))) == DONE
        assert rig.ask(A, put((3, 2, 0))) == RejectElementRequest(7, Code.OUT_OF_MEMORY)
        assert rig.ask(A, put((2, 1, 0))) == DONE, "a replacement takes no room"


@pytest.mark.parametrize("message", [THREE, put((0, 0, 0)), delete(1), delete(9), execute(1), execute(None)])
def test_only_the_controlling_client_changes_the_list(rig, driver, message) -> None:
    rig.tell(A, put((1, 0, 0)))
    assert rig.tell(B, message) == []
    rig.tell(A, ReleaseControl())
    assert rig.tell(A, message) == []
    assert order(rig) == [1]
    assert driver.begun == []


def test_changes_are_accepted_in_every_controlled_state(rig, driver) -> None:
    rig.tell(A, Standby())
    assert rig.ask(A, put((1, 0, 0))) == DONE
    rig.tell(B, SetEmergency(1))
    assert rig.ask(A, put((2, 1, 0))) == DONE
    assert rig.ask(A, delete(1)) == ConfirmElementRequest(8)
    rig.tell(A, execute(2))
    assert driver.begun == [], "nothing is carried out in Emergency"


def test_elements_are_executed_in_order(rig, driver) -> None:
    rig.tell(A, THREE)
    assert active(rig) == 0
    rig.tell(A, execute(2))
    assert (active(rig), driver.begun) == (2, [2])
    driver.elements.done()
    rig.run(0.0)
    assert (active(rig), driver.begun) == (3, [2, 3])
    assert driver.messages[-1].encode() == local(3).data.encode()
    assert driver.ended == 0
    driver.elements.done()
    rig.run(1.0)
    assert (active(rig), driver.begun, driver.ended) == (0, [2, 3], 1)
    driver.elements.done()
    assert driver.ended == 1


def test_command_event_reports_the_end_of_the_list(rig, driver) -> None:
    rig.tell(A, put((1, 0, 2), (2, 1, 0)))
    assert len(rig.tell(A, CreateCommandEvent(5, 600, execute(1)))) == 1
    driver.elements.done()
    assert rig.run(1.0) == []
    driver.elements.done()
    assert [message for *_, message in rig.run(1.0)] == [CommandEvent(1, 0)]
    rig.tell(A, CreateCommandEvent(6, 600, execute(1)))
    assert CommandEvent(2, 1) in [message for _, message in rig.tell(A, Standby())]


def test_zero_executes_from_the_first_and_no_element_changes_the_speed(rig, driver) -> None:
    rig.tell(A, execute(0))
    assert driver.begun == [], "an empty list"
    rig.tell(A, THREE)
    rig.tell(A, execute(9))
    assert driver.begun == []
    rig.tell(A, execute(0))
    rig.tell(A, execute(None))
    assert driver.begun == [1]
    assert driver.messages[-1] == "speed"


def test_a_loop_starts_over_after_a_pause(rig, driver) -> None:
    rig.tell(A, put((1, 0, 2), (2, 1, 1)))
    rig.tell(A, execute(2))
    driver.elements.done()
    rig.run(LAP_PAUSE / 2)
    assert driver.begun == [2]
    rig.run(LAP_PAUSE)
    assert driver.begun == [2, 1]


def test_each_element_is_executed_by_a_matching_driver(rig, driver) -> None:
    other = rig.host.service(Global)
    there = ElementRec.ElementData(0, SetGlobalWaypoint(latitude=40.0, longitude=-75.0))
    assert rig.ask(A, put((1, 0, 2), (2, 1, 3, there), (3, 2, 0))) == DONE
    rig.tell(A, execute(1))
    driver.elements.done()
    rig.run(0.0)
    assert (driver.begun, driver.ended, other.begun, other.ended) == ([1], 1, [2], 0)
    driver.elements.done()
    rig.run(0.0)
    assert (driver.begun, driver.ended, other.begun, other.ended) == ([1, 3], 1, [2], 1)


def test_replacing_the_active_element_restarts_it_and_deleting_it_ends_execution(rig, driver) -> None:
    rig.tell(A, THREE)
    rig.tell(A, execute(2))
    rig.tell(A, put((2, 1, 3, local(20.0))))
    assert driver.begun == [2, 2]
    assert driver.messages[-1].encode() == local(20.0).data.encode()
    rig.tell(A, put((3, 2, 0)))
    rig.tell(A, delete(1))
    assert (driver.begun, driver.ended, active(rig)) == ([2, 2], 0, 2)
    rig.tell(A, delete(2))
    assert (driver.ended, active(rig), order(rig)) == (1, 0, [3])


def test_change_between_elements_does_not_start_a_deleted_one(rig, driver) -> None:
    rig.tell(A, THREE)
    rig.tell(A, execute(1))
    driver.elements.done()
    rig.tell(A, delete(2))
    rig.run(1.0)
    assert driver.begun == [1, 3]


@pytest.mark.parametrize("end", [Standby(), ReleaseControl(), SetEmergency(1)])
def test_leaving_ready_ends_the_execution_and_keeps_the_list(rig, driver, end) -> None:
    rig.tell(A, THREE)
    rig.tell(A, execute(1))
    rig.tell(A, end)
    assert (driver.ended >= 1, active(rig), order(rig)) == (True, 0, [1, 2, 3])
    driver.elements.done()
    rig.run(10.0)
    assert driver.begun == [1]


def test_preemption_ends_the_execution(rig, driver) -> None:
    rig.tell(A, THREE)
    rig.tell(A, execute(1))
    rig.tell(B, RequestControl(200))
    assert (driver.ended, active(rig)) == (1, 0)


def test_list_without_drivers_accepts_messages_of_the_component(make) -> None:
    rig = make(ListManager(), Management())
    rig.tell(A, RequestControl(100))
    assert rig.ask(A, put((1, 0, 0, ElementRec.ElementData(0, Resume())))) == DONE
    assert rig.ask(A, put((2, 1, 0))).response_code == Code.UNSUPPORTED_ELEMENT_TYPE


def test_exchange_of_the_2015_interface_test_is_answered(rig) -> None:
    """Steps 54 to 61: one element with a waypoint, request 2Ch."""
    message = bytes.fromhex("1a04 2c 01 0100 0000 0000 00 0b00 0d04 00 ffffff0f ffffff0f")
    assert rig.ask(A, message).encode() == bytes.fromhex("1c042c")
    assert rig.ask(A, bytes.fromhex("1c24")).encode() == bytes.fromhex("1c440100")
    assert rig.ask(A, bytes.fromhex("1b24")).encode() == bytes.fromhex("1b4401000100")
    assert rig.ask(A, bytes.fromhex("1e24")).encode()[:2] == bytes.fromhex("1e44")


def test_list_of_the_2013_judge_is_rejected_with_the_right_code(rig) -> None:
    """Its last element names a next one that is not there; uninitialised bytes stand for its message ids."""
    first, second, third, fourth = (
        bytes.fromhex("000003f9f20280ffffff7f0900"),
        bytes.fromhex("17ff03f9f20280be9a03800000"),
        bytes.fromhex("002903ffffff7fbe9a03800000"),
        bytes.fromhex("001003ffffff7fffffff7fbb17"),
    )
    body = bytes.fromhex("1a040104")
    for uid, data, kind in ((1, first, 0), (2, second, 176), (3, third, 0), (4, fourth, 0)):
        body += b"".join(n.to_bytes(2, "little") for n in (uid, uid - 1, uid + 1))
        body += bytes([kind]) + len(data).to_bytes(2, "little") + data
    assert rig.ask(A, body) == RejectElementRequest(1, Code.INVALID_NEXT_ELEMENT)
    assert rig.host.counters["list_request_rejected"] == 1
