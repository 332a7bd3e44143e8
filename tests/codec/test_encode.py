"""What does not fit is an `EncodeError` that names field, value and range; clamping and `strict=False` are explicit."""

from __future__ import annotations

import math
from typing import Any

import pytest

from jauspy.codec.registry import Registry
from jauspy.errors import EncodeError
from jauspy.messages.core import (
    ConfirmControl,
    CreateEvent,
    QueryTime,
    RegisterServices,
    ReportServices,
    SetEmergency,
    SetTime,
    TimeStamp,
)
from jauspy.messages.mobility import ReportVelocityState, SetWrenchEffort


def service(uri: Any = "urn", major: Any = 1) -> RegisterServices.ServiceRec:
    return RegisterServices.ServiceRec(uri, major, 0)


@pytest.mark.parametrize(
    ("message", "path", "reason"),
    [
        (SetWrenchEffort(100.5), "propulsive_linear_effort_x", "100.5 is outside -100.0..100.0 percent"),
        (SetWrenchEffort(math.nextafter(100.0, 200.0)), "propulsive_linear_effort_x", "is outside -100.0..100.0"),
        (SetWrenchEffort(math.nan), "propulsive_linear_effort_x", "nan is outside"),
        (SetWrenchEffort(math.inf), "propulsive_linear_effort_x", "inf is outside"),
        (SetWrenchEffort("40"), "propulsive_linear_effort_x", "'40' is not a number"),
        (SetWrenchEffort(10**400), "propulsive_linear_effort_x", "is too large"),
        (SetWrenchEffort([1.0]), "propulsive_linear_effort_x", r"\[1.0\] is not a number"),
        (SetWrenchEffort(reserved_presence=1), "reserved_presence", "0x1 has bits outside 0xF000"),
        (SetWrenchEffort(reserved_presence=None), "reserved_presence", "None is not an integer"),
        (ConfirmControl(3), "response_code", "3 is none of 0 CONTROL_ACCEPTED, 1 NOT_AVAILABLE"),
        (ConfirmControl(1.0), "response_code", "1.0 is not an integer"),
        (ConfirmControl(None), "response_code", "a value is required"),
        (QueryTime(256), "presence_vector", "256 is outside 0..255"),
        (QueryTime(-1), "presence_vector", "-1 is outside 0..255"),
        (SetTime(TimeStamp(1000, 0, 0, 0, 1)), "time_stamp.milliseconds", "1000 is none of 0..999"),
        (SetTime(TimeStamp(0, 0, 0, 0, "1")), "time_stamp.day", "'1' is not an integer"),
        (SetTime(ConfirmControl(1)), "time_stamp", "is not a TimeStamp"),
        (RegisterServices([service("x" * 256)]), "service_list[0].uri", "count 256 is outside 0..255"),
        (RegisterServices([service("\u20ac")]), "service_list[0].uri", "'\u20ac' is not a Latin-1 character"),
        (RegisterServices([service(b"urn")]), "service_list[0].uri", "is not a string"),
        (RegisterServices([service(), service(major=300)]), "service_list[1].major_version_number", "300 is outside"),
        (RegisterServices([ConfirmControl(1)]), "service_list[0]", "is not a ServiceRec"),
        (RegisterServices([service()] * 256), "service_list", "count 256 is outside 0..255"),
        (RegisterServices(7), "service_list", "7 is not a list"),
        (CreateEvent(1, 0, 10.0, "query"), "query_message", "'query' is not a message or bytes"),
        (CreateEvent(1, 0, 10.0, ConfirmControl(9)), "query_message.response_code", "9 is none of"),
        (ReportServices([ReportServices.NodeSeq(ReportServices.NodeRec(1), None)]), "component_list", "required"),
    ],
    ids=str,
)
def test_errors_name_field_and_value(message: Any, path: str, reason: str) -> None:
    with pytest.raises(EncodeError, match=reason) as caught:
        message.encode()
    assert caught.value.path.endswith(path)


def test_clamp_limits_numbers() -> None:
    message = SetWrenchEffort(1e9, -1e9, propulsive_rotational_effort_z=math.inf)
    clamped = SetWrenchEffort.decode(message.encode(clamp=True))
    assert clamped == SetWrenchEffort(100.0, -100.0, propulsive_rotational_effort_z=100.0)
    assert QueryTime(-5).encode(clamp=True) == QueryTime(0).encode()
    assert SetTime(TimeStamp(5000, 99, 0, 0, 0)).encode(clamp=True) == SetTime(TimeStamp(999, 59, 0, 0, 1)).encode()
    with pytest.raises(EncodeError, match="nan"):
        SetWrenchEffort(math.nan).encode(clamp=True)


def test_strict_false_skips_value_sets() -> None:
    with pytest.raises(EncodeError):
        SetEmergency(0).encode()
    assert SetEmergency(0).encode(strict=False) == b"\x06\x00\x00\x00"


def test_message_that_contains_itself_is_an_error() -> None:
    event = CreateEvent(1, 0, 10.0, b"")
    event.query_message = event
    with pytest.raises(EncodeError, match="nested more than 8 deep"):
        event.encode()


def test_numbers_of_other_types() -> None:
    assert SetWrenchEffort(True).encode() == SetWrenchEffort(1.0).encode()
    assert ReportVelocityState(3).encode() == ReportVelocityState(3.0).encode()


@pytest.mark.parametrize("field", ["small", "ratio"])
@pytest.mark.parametrize("value", [math.nan, math.inf, "1", None, 10**400])
def test_non_finite_floats_are_rejected(odd: Registry, field: str, value: Any) -> None:
    everything = odd.by_name("Everything")
    data = bytes.fromhex("01f00000000000000000" + "00" * 12 + "010000" + "00" * 6 + "01" + "0000" + "00000000" + "00")
    message: Any = everything.decode(data[:-5] + b"\x00\x00\x00\x00\x00")
    setattr(message.values_rec, field, value)
    with pytest.raises(EncodeError) as caught:
        message.encode()
    assert caught.value.path == f"values_rec.{field}"
