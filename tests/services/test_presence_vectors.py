from __future__ import annotations

from copy import copy
from dataclasses import replace
from random import Random

import pytest
from hypothesis import given, strategies as st

from jauspy.codec.layout import Composite, Repeat, Slot
from jauspy.codec.message import Message
from jauspy.fuzz.messages import FuzzTarget, MessageMaker, Style, targets
from jauspy.messages import registry
from jauspy.messages.core import QueryStatus, ReportStatus
from jauspy.messages.mobility import (
    QueryVelocityState,
    QueryVelocityStateExt,
    ReportVelocityState,
    ReportVelocityStateExt,
    ReportVelocityStateExtRec,
    VelocityVehicleXYZRec,
)
from jauspy.messages.mobility.v1_1.navigation_state import QueryNavigation, ReportNavigation
from jauspy.schema import load_builtin
from jauspy.services.presence_vectors import apply_presence_vectors

FULL = ReportVelocityState(1.0, 2.0, 3.0, 4.0, 0.1, 0.2, 0.3, 0.4)
NAMES = ("velocity_x", "velocity_y", "velocity_z", "velocity_rms", "roll_rate", "pitch_rate", "yaw_rate", "rate_rms")


@pytest.mark.slow
@given(st.integers(0, 0xFFFF), st.sets(st.sampled_from(NAMES)))
def test_report_has_requested_and_available_fields(asked: int, missing: set[str]) -> None:
    report = ReportVelocityState(**{name: getattr(FULL, name) for name in NAMES if name not in missing})
    masked = apply_presence_vectors(report, QueryVelocityState(asked))
    for bit, name in enumerate(NAMES):
        wanted = asked >> bit & 1 and name not in missing
        assert getattr(masked, name) == (getattr(FULL, name) if wanted else None)
    supported = sum(1 << bit for bit, name in enumerate(NAMES) if name not in missing)
    assert int.from_bytes(masked.encode()[2:4], "little") == asked & supported


def test_original_report_is_not_modified() -> None:
    report = ReportVelocityState(1.0)
    assert apply_presence_vectors(report, QueryVelocityState(0)) == ReportVelocityState()
    assert report == ReportVelocityState(1.0)
    assert apply_presence_vectors(report, QueryVelocityState(1)) is report


def test_vectors_named_after_a_part_mask_that_part() -> None:
    report = ReportVelocityStateExt(
        VelocityVehicleXYZRec(1.0, 2.0, 3.0), ReportVelocityStateExtRec(roll_rate=0.5, yaw_rate=1.0)
    )
    masked = apply_presence_vectors(report, QueryVelocityStateExt(0b101, 0b10))
    assert masked == ReportVelocityStateExt(
        VelocityVehicleXYZRec(1.0, None, 3.0), ReportVelocityStateExtRec(roll_rate=0.5)
    )
    assert report.velocity_var.velocity_y == 2.0


def test_unrequested_part_is_empty() -> None:
    """QueryNavigation has one vector for the components of velocity and for what else there is of it."""
    report = made(TARGETS[ReportNavigation])
    nothing = apply_presence_vectors(report, QueryNavigation(0, 0, 0, 0))
    assert (
        nothing.report_velocity_state_ext_seq.velocity_var == type(report.report_velocity_state_ext_seq.velocity_var)()
    )
    something = apply_presence_vectors(report, QueryNavigation(0, 0, 1, 0))
    assert something.report_velocity_state_ext_seq.velocity_var == report.report_velocity_state_ext_seq.velocity_var


@pytest.mark.parametrize("status", list(ReportStatus.Status))
def test_report_without_presence_vector_is_complete(status) -> None:
    report = ReportStatus(status=status, reserved=0)
    assert apply_presence_vectors(report, QueryStatus()) is report


ALL, NOTHING = -1, 0
TARGETS = {each.cls: each for each in targets(registry, load_builtin())}


def vectors(query: type[Message]) -> list[str]:
    return [slot.name for slot in TARGETS[query].layout.slots if slot.name.endswith("presence_vector")]


def made(target: FuzzTarget) -> Message:
    return target.cls.decode(MessageMaker(Random(target.cls.CODE), Style.FULL).message(target))


@pytest.mark.parametrize(
    ("query", "vector"),
    [pytest.param(kind, name, id=f"{kind.NAME}-{kind.VERSION}-{name}") for kind in TARGETS for name in vectors(kind)],
)
def test_all_presence_vectors_have_an_effect(query: type[Message], vector: str) -> None:
    report, asked = made(TARGETS[query.REPORT]), made(TARGETS[query])
    for each in vectors(query):
        setattr(asked, each, ALL)
    assert apply_presence_vectors(report, asked) == report
    less = copy(asked)
    setattr(less, vector, NOTHING)
    assert apply_presence_vectors(report, less) != report
    assert len(apply_presence_vectors(report, less).encode()) < len(report.encode())


def records(kind: type[Message], field: str = "") -> list[Slot]:
    """The lists of a message whose records are about sensors, with such a field or with optional ones."""
    lists = [slot for slot in TARGETS[kind].layout.slots if isinstance(slot.item, Repeat)]
    inner = [(each, each.item.item.slots) for each in lists if isinstance(each.item.item, Composite)]
    return [each for each, slots in inner if any(field == slot.name if field else slot.optional for slot in slots)]


ABOUT_SENSORS = [
    kind for kind in TARGETS if kind.IS_QUERY and records(kind, "query_presence_vector") and records(kind.REPORT)
]


@pytest.mark.parametrize("query", ABOUT_SENSORS, ids=lambda each: f"{each.NAME}-{each.VERSION}")
def test_vector_of_a_sensor_applies_to_its_record(query: type[Message]) -> None:
    (wanted,), (reported,) = records(query, "query_presence_vector"), records(query.REPORT)
    report, asked = made(TARGETS[query.REPORT]), made(TARGETS[query])
    one, *_ = getattr(report, reported.name)
    setattr(report, reported.name, [replace(one, sensor_id=each) for each in (1, 2, 3)])

    def changed(*vectors: tuple[int, int]) -> list[int]:
        """The sensors whose records lack something, when this is asked of each; 0 is all."""
        first, *_ = getattr(asked, wanted.name)
        setattr(asked, wanted.name, [replace(first, sensor_id=i, query_presence_vector=v) for i, v in vectors])
        both = zip(
            getattr(report, reported.name), getattr(apply_presence_vectors(report, asked), reported.name), strict=True
        )
        return [before.sensor_id for before, after in both if before != after]

    assert changed((0, ALL)) == []
    assert changed((0, NOTHING)) == [1, 2, 3]
    assert changed((1, ALL), (2, NOTHING), (3, ALL), (2, ALL)) == [2]
    assert changed((2, ALL), (0, NOTHING)) == [1, 3]
