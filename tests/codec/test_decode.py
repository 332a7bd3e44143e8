"""Strict decoding says where and why; tolerant decoding keeps what it can."""

from __future__ import annotations

import re
from array import array
from typing import Any

import pytest

from jauspy.codec.message import Message
from jauspy.codec.registry import Registry
from jauspy.codec.slow_path import MAX_DEVIATIONS
from jauspy.errors import DecodeError
from jauspy.messages import registry
from jauspy.messages.core import (
    ConfirmControl,
    CreateEvent,
    QueryIdentification,
    QueryTime,
    RegisterServices,
    ReportIdentification,
    SetEmergency,
    SetTime,
    TimeStamp,
)
from jauspy.messages.mobility import ReportVelocityState, SetWrenchEffort


@pytest.mark.parametrize(
    ("data", "offset", "path", "reason"),
    [
        ("", 0, "", "too short for a message id"),
        ("0f", 0, "", "too short for a message id"),
        ("0fff", 0, "", "unknown message id 0xFF0F"),
        ("0f00", 2, "response_code", "needs 1 byte, 0 left"),
        ("0f0003", 2, "response_code", "3 is none of 0 CONTROL_ACCEPTED"),
        ("0f000100", 3, "", "1 byte left over"),
        ("1100", 2, "presence_vector", "needs 1 byte"),
        ("110001e8", 3, "time_stamp", "needs 4 bytes, 1 left"),
        ("110001ffffffff", 3, "time_stamp.milliseconds", "1023 is none of 0..999"),
        ("000b02", 2, "service_list", "count 2 needs at least 6 bytes, 0 left"),
        ("000b0105414243", 3, "service_list[0].uri", "count 5 needs at least 5 bytes, 3 left"),
        ("f02107", 2, "query_events_var", "tag 7 is outside 0..3"),
        ("f001000000ffffffff", 5, "query_message", "needs"),
    ],
)
def test_invalid_bytes_raise_decode_errors(data: str, offset: int, path: str, reason: str) -> None:
    with pytest.raises(DecodeError, match=reason) as caught:
        registry.decode(bytes.fromhex(data))
    if reason != "needs":
        assert (caught.value.offset, caught.value.path) == (offset, path)


def test_wrong_id_raises_a_decode_error() -> None:
    with pytest.raises(DecodeError, match=r"0x0010 is not 0x000F \(ConfirmControl\)"):
        ConfirmControl.decode(b"\x10\x00\x00")
    with pytest.raises(DecodeError, match="0x0010"):
        ConfirmControl.decode(b"\x10\x00\x00", strict=False)


def test_tolerant_decoding_keeps_values_outside_their_set() -> None:
    message, deviations = SetEmergency.decode(b"\x06\x00\x00\x00", strict=False)
    assert message == SetEmergency(0)
    assert [str(d) for d in deviations] == ["byte 2: emergency_code: 0 is none of 1 STOP"]
    assert message.encode(strict=False) == b"\x06\x00\x00\x00"


def test_tolerant_decoding_reports_extra_bytes() -> None:
    message, (deviation,) = ConfirmControl.decode(b"\x0f\x00\x01\xaa\xbb", strict=False)
    assert message == ConfirmControl(ConfirmControl.ResponseCode.NOT_AVAILABLE)
    assert (deviation.offset, deviation.reason) == (3, "2 bytes left over after the message")


def test_tolerant_decoding_reads_truncated_messages() -> None:
    full = ReportVelocityState(1.0, 2.0, 3.0).encode()
    message, deviations = ReportVelocityState.decode(full[:-3], strict=False)
    assert message.velocity_y == pytest.approx(2.0)
    assert message.velocity_z is not None
    assert deviations[0].path == "velocity_z"
    services = RegisterServices([RegisterServices.ServiceRec("urn:a", 1, 1)] * 3).encode()
    found, _ = RegisterServices.decode(services[:-2], strict=False)
    assert [service.uri for service in found.service_list] == ["urn:a"] * 3


def test_truncated_presence_vector_is_reported() -> None:
    with pytest.raises(DecodeError, match=r"^byte 2: presence_vector: needs 2 bytes, 1 left$"):
        SetWrenchEffort.decode(b"\x05\x04\x01")


def test_deviations_above_a_thousand_are_counted(folder: Any) -> None:
    cls = registry.by_name("ReportDataDefinition")
    data = cls.CODE.to_bytes(2, "little") + b"\xff" * 3000
    message, deviations = cls.decode(data, strict=False)
    assert len(deviations) == MAX_DEVIATIONS + 1
    assert re.fullmatch(r"byte \d+: \d+ more deviations from here on", str(deviations[-1]))
    assert deviations[-2].offset <= deviations[-1].offset <= len(data)
    assert any(deviation.lost for deviation in deviations) or message.encode(strict=False) == data


def test_undefined_presence_bits_are_kept() -> None:
    data = SetWrenchEffort(40.0).encode()
    odd = data[:3] + b"\xa0" + data[4:]
    message = SetWrenchEffort.decode(odd)
    assert message.reserved_presence == 0xA000
    assert message.encode() == odd


def test_strings_keep_every_byte() -> None:
    text = bytes(range(256))[1:]
    data = b"\x00\x4b\x02\x11\x27\xff" + text
    message = ReportIdentification.decode(data)
    assert message.encode() == data
    assert ReportIdentification.from_dict(message.to_dict()) == message


def test_values_become_members_or_stay_numbers() -> None:
    known = QueryIdentification.decode(b"\x00\x2b\x02").query_type
    assert isinstance(known, QueryIdentification.QueryType)
    other = QueryIdentification.decode(b"\x00\x2b\x63").query_type
    assert other == 99
    assert not isinstance(other, QueryIdentification.QueryType)


def test_nested_messages_are_decoded() -> None:
    event = CreateEvent(1, CreateEvent.EventType(1), 0.0, QueryTime(3))
    decoded = CreateEvent.decode(event.encode())
    assert decoded.query_message == QueryTime(3)
    for inner in (b"", b"\x11", b"\xff\xff\x00", b"\x11\x20", b"\x11\x20\x03\x00"):
        event.query_message = inner
        assert CreateEvent.decode(event.encode()).query_message == inner


def test_nesting_is_bounded() -> None:
    message: Message | bytes = QueryTime(3)
    for _ in range(12):
        data = message if isinstance(message, bytes) else message.encode()
        message = CreateEvent(1, 1, 0.0, data).encode()
    outer: Message | bytes = registry.decode(message)
    depth = 0
    while isinstance(outer, CreateEvent):
        outer, depth = outer.query_message, depth + 1
    assert isinstance(outer, bytes)
    assert depth == 9


def test_input_types() -> None:
    data = SetTime(TimeStamp(1, 2, 3, 4, 5)).encode()
    assert SetTime.decode(bytearray(data)) == SetTime.decode(memoryview(data)) == registry.decode(data)


def test_counts_are_checked_before_allocation(odd: Registry) -> None:
    shapes = odd.by_name("Shapes")
    with pytest.raises(DecodeError, match=r"count 65535 is outside 0\.\.9"):
        shapes.decode(b"\x04\xf0\x02\xff\xff")
    message, deviations = shapes.decode(b"\x04\xf0\x02\xff\xff" + bytes(6), strict=False)
    assert message.to_dict() == {"shape": {"point_list": {"point_list": [{"x": 0, "y": 0.0}]}}}
    assert [d.offset for d in deviations] == [3, 11]


def test_match_statement_and_repr() -> None:
    message: Message = ReportVelocityState(velocity_x=1.5)
    match message:
        case ReportVelocityState(velocity_x=speed):
            assert speed == 1.5
        case _:
            pytest.fail("no match")
    assert repr(message) == "ReportVelocityState(velocity_x=1.5)"
    assert repr(ReportVelocityState()) == "ReportVelocityState()"


@pytest.mark.parametrize("wrong", [7, True, None, "0f00", [15, 0], 1.5])
def test_other_types_than_bytes_are_rejected(wrong: Any) -> None:
    for decode in (ConfirmControl.decode, registry.decode):
        with pytest.raises(DecodeError, match="a message is bytes, not"):
            decode(wrong)


def test_all_bytes_like_objects_are_accepted() -> None:
    data = b"\x0f\x00\x00"
    for same in (bytearray(data), memoryview(data), array("B", data), memoryview(data[::-1])[::-1]):
        assert ConfirmControl.decode(same) == registry.decode(same) == ConfirmControl(0)  # type: ignore[arg-type]
