"""Nothing of 64 kB costs more than 100 times a normal message of that size: counted in calls and bytes, not in time."""

from __future__ import annotations

import random
import sys
import tracemalloc
from collections.abc import Callable, Iterator
from typing import Any

import pytest

from jauspy.codec import slow_path
from jauspy.codec.message import Message
from jauspy.errors import DecodeError
from jauspy.fuzz.campaign import CampaignPlan, fuzzer
from jauspy.messages import registry
from jauspy.messages.core import ReportServices

SIZE = 65536
FILLS = (b"\0", b"\xff", b"\1", b"\2\0")


def normal() -> bytes:
    """A full ReportServices: 32 components with 255 services each."""
    component = b"\1\1\xff" + b"\4urn:\1\1" * 255
    return b"\3\x4b\1\1\x24" + component * 36


def work(call: Callable[[], object]) -> int:
    """Calls of Python and C functions, and returns from them, until it is done or rejected."""
    events = 0

    def count(*_: Any) -> None:
        nonlocal events
        events += 1

    sys.setprofile(count)
    try:
        call()
    except DecodeError:
        pass
    finally:
        sys.setprofile(None)
    return events


def memory(call: Callable[[], object]) -> int:
    """Bytes allocated at the peak."""
    tracemalloc.start()
    try:
        call()
    except DecodeError:
        pass
    finally:
        _, peak = tracemalloc.get_traced_memory()
        tracemalloc.stop()
    return peak


def pathological() -> Iterator[tuple[type[Message], bytes]]:
    """Every list, variant, string and nested message, with the highest count, and 64 kB of next to nothing."""
    made = fuzzer(CampaignPlan(0))
    seen = set()
    for seed in made.seeds:
        cls = made.targets[seed.target].cls
        for offset in seed.offsets:
            key = id(offset.item) if offset.item else (cls, offset.at)
            if offset.kind not in ("count", "tag") or key in seen:
                continue
            seen.add(key)
            number = b"\xff" * offset.size if offset.kind == "count" else seed.data[offset.at : offset.at + offset.size]
            for fill in FILLS:
                yield cls, (seed.data[: offset.at] + number + fill * SIZE)[:SIZE]


@pytest.fixture(scope="module")
def inputs() -> list[tuple[type[Message], bytes]]:
    """Some of them, always the same ones, and those of the message with the deepest lists."""
    found = list(pathological())
    deepest = [one for one in found if one[0] is ReportServices]
    return [*deepest, *random.Random(1).sample(found, 150)]


def test_reference_message_takes_normal_time() -> None:
    assert len(normal()) == pytest.approx(SIZE, rel=0.03)
    assert len(ReportServices.decode(normal()).node_list[0].component_list) == 36


@pytest.mark.slow
def test_cost_inputs_cover_all_kinds(inputs: Any) -> None:
    assert {len(data) for _, data in inputs} == {SIZE}
    assert len({cls for cls, _ in inputs}) > 10


@pytest.mark.slow
@pytest.mark.parametrize(
    "number", [pytest.param(number, marks=pytest.mark.long if number else []) for number in range(4)]
)
def test_decoding_64_kb_is_bounded_in_time(number: int, inputs: Any) -> None:
    most = 100 * work(lambda: ReportServices.decode(normal()))
    for cls, data in inputs[number::4]:
        assert work(lambda cls=cls, data=data: cls.decode(data)) <= most, cls
        assert work(lambda cls=cls, data=data: slow_path.decode_tolerant(cls, data)) <= most, cls


@pytest.mark.slow
def test_decoding_64_kb_is_bounded_in_memory(inputs: Any) -> None:
    most = 100 * memory(lambda: ReportServices.decode(normal()))
    assert most < 2**30  # a normal message takes less than 160 bytes for each of its own
    for cls, data in inputs[::3]:
        assert memory(lambda cls=cls, data=data: cls.decode(data)) <= most, cls
        assert memory(lambda cls=cls, data=data: slow_path.decode_tolerant(cls, data)) <= most, cls


def test_time_is_linear_in_the_size() -> None:
    """Twice the size is about twice the work."""
    services = registry.by_name("RegisterServices")
    for cls, fill in ((services, b"\0"), (ReportServices, b"\1\0")):
        works = []
        for size in (8192, 16384, 32768):
            data = (cls.CODE.to_bytes(2, "little") + fill * size)[:size]
            works.append(work(lambda cls=cls, data=data: slow_path.decode_tolerant(cls, data)))
        assert works[2] <= 2.5 * works[1] <= 6 * works[0]
