"""Dictionaries and JSON: lossless there and back, and every wrong shape is an error that names the field."""

from __future__ import annotations

import json
import math
from typing import Any

import pytest
from hypothesis import HealthCheck, given, settings, strategies as st

from jauspy.codec.items import non_finite_from_json, non_finite_to_json
from jauspy.codec.registry import Registry
from jauspy.errors import CodecError, EncodeError
from jauspy.messages import registry
from jauspy.messages.core import ConfirmControl, CreateEvent, QueryTime

MANY = settings(max_examples=600, deadline=None, suppress_health_check=list(HealthCheck))
JSON = st.recursive(
    st.none() | st.booleans() | st.integers() | st.floats() | st.text(max_size=4),
    lambda inner: st.lists(inner, max_size=3) | st.dictionaries(st.text(max_size=4), inner, max_size=3),
    max_leaves=4,
)


NANS = ("7fc00000", "ffc00000", "7fc12345", "ffffffff", "7ff8000000000000", "fff8000000000000", "7ff8000000000001")


@pytest.mark.parametrize("bits", [*NANS, "7f800000", "ff800000", "fff7ffffffffffff"])
def test_non_finite_numbers_keep_their_bits(bits: str, folder: Any) -> None:
    folder.add("Lamp", type="float" if len(bits) == 8 else "long float")
    own = folder.load()
    message, _ = own.decode(b"\x01\xd0" + bytes.fromhex(bits)[::-1], strict=False)
    again = own.from_dict({"message": "SetLevel", "fields": json.loads(json.dumps(message.to_dict(), allow_nan=False))})
    assert again.encode(strict=False)[2:] == bytes.fromhex(bits)[::-1]


def test_only_non_finite_numbers_are_text() -> None:
    assert non_finite_to_json(math.nan) == "nan"
    for text in ("nan:", "nan:7ff0", "nan:3ff0000000000000", "nan:zzf8000000000001", "NaN", "1.5", ""):
        assert non_finite_from_json(text) is None


@pytest.mark.parametrize("wrong", [None, 7, "QueryTime", [], {}, {"message": 7}, {"message": ["QueryTime"]}])
def test_other_dictionaries_are_rejected(wrong: Any) -> None:
    with pytest.raises(EncodeError, match="does not name its message"):
        registry.from_dict(wrong)


@pytest.mark.parametrize(
    ("wrong", "path"),
    [
        ({"message": "QueryTime", "service": 7}, "service"),
        ({"message": "QueryTime", "version": [1]}, "version"),
        ({"message": "QueryTimes"}, "message"),
        ({"message": "QueryTime", "fields": 0}, ""),
        ({"message": "QueryTime", "fields": [["presence_vector", 1]]}, ""),
        ({"message": "QueryTime", "fields": {"presence_vector": [1]}}, "presence_vector"),
        ({"message": "QueryTime", "fields": {"presence_vector": "one"}}, "presence_vector"),
        ({"message": "QueryTime", "fields": {"presence_vector": 1.5}}, "presence_vector"),
        ({"message": "QueryTime", "fields": {7: 1}}, ""),
        (
            {"message": "ReportIdentification", "fields": {"query_type": 1, "type": 10001, "identification": 3}},
            "identification",
        ),
    ],
)
def test_wrong_types_name_the_field(wrong: Any, path: str) -> None:
    with pytest.raises(EncodeError) as caught:
        registry.from_dict(wrong)
    assert caught.value.path == path


def test_wrong_types_in_nested_messages_name_the_field() -> None:
    event = CreateEvent(1, 1, 0.0, QueryTime(3)).to_dict()
    event["query_message"]["fields"]["presence_vector"] = {}
    with pytest.raises(EncodeError, match=r"^query_message\.fields\.presence_vector: \{\} is not an integer"):
        CreateEvent.from_dict(event)


def test_long_values_are_shortened_in_errors() -> None:
    for make in (
        lambda: ConfirmControl(10**400).encode(),
        lambda: ConfirmControl(10**5000).encode(),
        lambda: ConfirmControl.from_dict({"response_code": "x" * 9999}),
        lambda: ConfirmControl.from_dict({"y" * 9999: 1}),
        lambda: QueryTime([1] * 9999).encode(),  # type: ignore[arg-type]
    ):
        with pytest.raises(EncodeError) as caught:
            make()
        assert len(str(caught.value)) < 400


@pytest.mark.slow
def test_mutated_dictionaries_raise_codec_errors_only(odd: Registry, values_of: Any) -> None:
    """A part of a good dictionary is replaced by anything."""
    entries = st.sampled_from([*registry.entries, *(entry for entry in odd.entries if "example" in entry.service)])

    @MANY
    @given(st.data())
    def run(more: st.DataObject) -> None:
        entry = more.draw(entries)
        cls = entry.load()
        data = cls.to_dict(more.draw(values_of(cls.layout())))
        wrong = replaced(data, more)
        try:
            message = cls.from_dict(wrong)
        except CodecError:
            return
        try:
            message.encode()
        except CodecError:
            return
        assert message.from_dict(message.to_dict()) == message

    run()


@pytest.mark.slow
@MANY
@given(JSON)
def test_arbitrary_values_raise_codec_errors_only(data: Any) -> None:
    for wrong in (data, {"message": "CreateEvent", "fields": data}, {"message": data}):
        try:
            registry.from_dict(wrong)
        except CodecError:
            continue


def replaced(data: Any, more: st.DataObject) -> Any:
    """The data with one part, anywhere in it, replaced."""
    if not data or not isinstance(data, (dict, list)) or more.draw(st.integers(0, 3)) == 0:
        return more.draw(JSON)
    key = more.draw(st.sampled_from(sorted(data) if isinstance(data, dict) else range(len(data))))
    again = data.copy()
    again[key] = replaced(data[key], more)
    return again
