"""Numbers with few digits are encoded as the same bytes."""

from __future__ import annotations

import json
import math
import random
from collections.abc import Iterator
from fractions import Fraction
from typing import Any

import pytest
from hypothesis import HealthCheck, given, settings
from tests.helpers.sampling import sampled

from jauspy.codec.items import Item, Real
from jauspy.codec.layout import Composite, Repeat, Union
from jauspy.codec.message import Message
from jauspy.codec.registry import Registry
from jauspy.codec.rounding import rounded, rounded_dict, shortest
from jauspy.codec.scalars import Scaling, exact_raw
from jauspy.messages import registry
from jauspy.messages.core import CreateEvent
from jauspy.messages.mobility import ReportLocalPose

FEW = settings(max_examples=12, deadline=None, suppress_health_check=list(HealthCheck))


def scalings(item: Item) -> Iterator[Scaling]:
    if isinstance(item, Real):
        yield item.scaling
    elif isinstance(item, Composite):
        for slot in item.slots:
            yield from scalings(slot.item)
    elif isinstance(item, Repeat):
        yield from scalings(item.item)
    elif isinstance(item, Union):
        for arm in item.arms.values():
            yield from scalings(arm)


FINER_THAN_FLOATS = {(1e5, 1e10, 2**64 - 1)}
"""Frequencies of IOP's Communicator in eight bytes: no float tells two neighbouring raw values apart."""


def test_every_scaling_of_the_standards_keeps_its_raw_values() -> None:
    every = {scaling for entry in registry.entries for scaling in scalings(entry.load().layout())}
    assert len(every) > 50
    rng = random.Random(1)
    coarse = {scaling for scaling in every if scaling.top <= 2**53}
    assert {(fine.lower, fine.upper, fine.top) for fine in every - coarse} == FINER_THAN_FLOATS
    for scaling in coarse:
        raws = [0, 1, scaling.top // 2, scaling.top // 2 + 1, scaling.top - 1, scaling.top]
        for raw in raws + [rng.randint(0, scaling.top) for _ in range(20)]:
            value = scaling.real(raw)
            number = shortest(value, scaling)
            assert exact_raw(number, scaling) == raw, (scaling, raw, number)
            decimals = max(0, math.ceil(math.log10(scaling.factor)) + 1)
            is_limit = number in (scaling.lower, scaling.upper)
            assert is_limit or float(f"{number:.{decimals}f}") == number, (scaling, raw, number)


@pytest.mark.parametrize("function", ["round", "floor", "ceiling"])
def test_every_way_of_rounding_keeps_its_raw_values(function: Any) -> None:
    scaling = Scaling(-10.0, 30.0, 255, function)
    for raw in range(256):
        assert exact_raw(shortest(scaling.real(raw), scaling), scaling) == raw


def test_a_zero_between_two_steps_is_zero() -> None:
    pose = ReportLocalPose.decode(ReportLocalPose(x=0.0, yaw=0.0).encode())
    assert pose.x == 2.3283064365386963e-05
    assert rounded(pose).to_dict() == {"x": 0.0, "yaw": 0.0}
    assert rounded(pose).encode() == pose.encode()


def test_messages_in_messages_are_rounded() -> None:
    event = CreateEvent(request_id=1, event_type=1, requested_periodic_rate=0.1, query_message=ReportLocalPose(x=0.0))
    decoded = CreateEvent.decode(event.encode())
    assert '"x": 0.0' in json.dumps(rounded(decoded).to_dict())


def test_what_is_outside_of_the_range_stays() -> None:
    scaling = Scaling(0.0, 1.0, 255)
    assert shortest(1.00000000001, scaling) == 1.00000000001
    assert math.isnan(shortest(math.nan, scaling))


def test_a_float_near_the_greatest_of_32_bits_is_rounded_within_them() -> None:
    command = registry.by_name("CBRNScanWindowConfigurationCommand")
    check(command(station_number=0, set_elevation_scan_rate=3.4025001647762064e38))


def test_a_float_at_a_limit_is_not_rounded_beyond_it() -> None:
    command = registry.by_name("CBRNScanWindowConfigurationCommand")
    check(command(station_number=0, set_end_scan_window_azimuth=6.2831854820251465))


def test_reals_of_64_bits_are_read_exactly_and_keep_their_value() -> None:
    capability = registry.by_name("ReportCommunicatorCapability")
    data = bytes.fromhex("004900000100000000000000000000000000000000c600")
    message = capability.decode(data)
    assert message.frequency_band_list[0].max_frequency == float(
        100_000 + Fraction(0xC600000000000000, 2**64 - 1) * (10**10 - 100_000)
    )
    assert capability.decode(message.encode()) == message
    check(message)


def check(message: Message) -> None:
    decoded = type(message).decode(message.encode())
    short = rounded(decoded)
    assert rounded_dict(decoded) == short.to_dict()
    assert short.encode() == decoded.encode()
    assert type(message).from_dict(json.loads(json.dumps(short.to_dict()))).encode() == decoded.encode()
    assert len(json.dumps(short.to_dict())) <= len(json.dumps(decoded.to_dict()))


@pytest.mark.parametrize("entry", sampled(registry.entries, 30), ids=lambda entry: f"{entry.name}-{entry.version}")
def test_messages_keep_their_bytes(entry: Any, values_of: Any) -> None:
    @FEW
    @given(values_of(entry.load().layout()))
    def run(message: Message) -> None:
        check(message)

    run()


@pytest.mark.parametrize("name", ["Everything", "Options", "Nothing", "Shapes", "Points", "Rounded"])
def test_every_feature_keeps_its_bytes(name: str, odd: Registry, values_of: Any) -> None:
    @FEW
    @given(values_of(odd.by_name(name).layout()))
    def run(message: Message) -> None:
        check(message)

    run()
