from __future__ import annotations

import pytest
from hypothesis import given, strategies as st

from jauspy.messages.core import QueryStatus, ReportStatus
from jauspy.messages.mobility import (
    QueryVelocityState,
    QueryVelocityStateExt,
    ReportVelocityState,
    ReportVelocityStateExt,
    ReportVelocityStateExtRec,
    VelocityVehicleXYZRec,
)
from jauspy.services.presence import mask

FULL = ReportVelocityState(1.0, 2.0, 3.0, 4.0, 0.1, 0.2, 0.3, 0.4)
NAMES = ("velocity_x", "velocity_y", "velocity_z", "velocity_rms", "roll_rate", "pitch_rate", "yaw_rate", "rate_rms")


@given(st.integers(0, 0xFFFF), st.sets(st.sampled_from(NAMES)))
def test_a_report_has_what_is_asked_for_and_there(asked: int, missing: set[str]) -> None:
    report = ReportVelocityState(**{name: getattr(FULL, name) for name in NAMES if name not in missing})
    masked = mask(report, QueryVelocityState(asked))
    for bit, name in enumerate(NAMES):
        wanted = asked >> bit & 1 and name not in missing
        assert getattr(masked, name) == (getattr(FULL, name) if wanted else None)
    supported = sum(1 << bit for bit, name in enumerate(NAMES) if name not in missing)
    assert int.from_bytes(masked.encode()[2:4], "little") == asked & supported


def test_the_report_of_the_service_itself_is_left_alone() -> None:
    report = ReportVelocityState(1.0)
    assert mask(report, QueryVelocityState(0)) == ReportVelocityState()
    assert report == ReportVelocityState(1.0)
    assert mask(report, QueryVelocityState(1)) is report


def test_vectors_named_after_a_part_mask_that_part() -> None:
    report = ReportVelocityStateExt(
        VelocityVehicleXYZRec(1.0, 2.0, 3.0), ReportVelocityStateExtRec(roll_rate=0.5, yaw_rate=1.0)
    )
    masked = mask(report, QueryVelocityStateExt(0b101, 0b10))
    assert masked == ReportVelocityStateExt(
        VelocityVehicleXYZRec(1.0, None, 3.0), ReportVelocityStateExtRec(roll_rate=0.5)
    )
    assert report.velocity_var.velocity_y == 2.0


@pytest.mark.parametrize("status", list(ReportStatus.Status))
def test_without_a_vector_nothing_is_masked(status) -> None:
    report = ReportStatus(status=status, reserved=0)
    assert mask(report, QueryStatus()) is report
