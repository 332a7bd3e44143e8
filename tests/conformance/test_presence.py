"""Presence vectors of components: each is judged by the part of the report that it is about."""

from __future__ import annotations

import pytest
from tests.conformance.judging import failed, judged

from jauspy import Service
from jauspy.messages.mobility import (
    ReportAccelerationStateExtRec,
    ReportGlobalPoseExtRec,
    ReportLocalPoseExtRec,
    ReportVelocityState,
    ReportVelocityStateExt,
    ReportVelocityStateExtRec,
    VelocityVehicleXYZRec,
)
from jauspy.messages.mobility.v1_1.navigation_state import ReportNavigation
from jauspy.services import presence_vectors

EXTENDED = "Ready/QueryVelocityStateExt/other-client"
NAVIGATION = "Ready/QueryNavigation/other-client"


class Turning(Service, urn="urn:jaus:jss:mobility:VelocityStateSensor"):
    """Knows fields of one part of its report only."""

    def report_velocity_state(self):
        return ReportVelocityState(velocity_x=1.0)

    def report_velocity_state_ext(self):
        return ReportVelocityStateExt(VelocityVehicleXYZRec(), ReportVelocityStateExtRec(roll_rate=1.0))


class Navigator(Service, urn="urn:jaus:jss:mobility:NavigationState"):
    """Knows fields of the part it is made for only."""

    def __init__(self, part="", **fields):
        self.fields = {part: fields}

    def report_navigation(self):
        def of(part):
            return self.fields.get(part, {})

        velocity = ReportNavigation.ReportVelocityStateExtSeq(
            VelocityVehicleXYZRec(**of("components")), ReportVelocityStateExtRec(**of("velocity"))
        )
        return ReportNavigation(
            ReportNavigation.SyncTimeRec(1, 1),
            ReportGlobalPoseExtRec(**of("global")),
            ReportLocalPoseExtRec(**of("local")),
            velocity,
            ReportAccelerationStateExtRec(**of("acceleration")),
        )


PARTS = {
    "global": {"latitude": 1.0},
    "local": {"x": 1.0},
    "velocity": {"roll_rate": 1.0},
    "acceleration": {"acceleration_x": 1.0},
}


def test_parts_of_a_report_are_distinguished():
    report = judged(Turning())
    assert f"{EXTENDED}/some-fields" in {each.id for each in report.results}
    assert failed(report) == set()


@pytest.mark.parametrize("part", PARTS)
def test_fields_of_every_part_are_compared(part, monkeypatch):
    service = Navigator(part, **PARTS[part])
    assert failed(judged(service)) == set()
    monkeypatch.setattr(presence_vectors, "apply_presence_vectors", lambda report, query: report)
    assert failed(judged(service)) == {f"{NAVIGATION}/{some}-fields" for some in ("no", "some")}


def test_unrequested_velocity_components_fail(monkeypatch):
    """No bit is theirs alone, so which of them come for which bit is not judged."""
    service = Navigator("components", velocity_x=1.0)
    assert failed(judged(service)) == set()
    monkeypatch.setattr(presence_vectors, "apply_presence_vectors", lambda report, query: report)
    assert failed(judged(service)) == {f"{NAVIGATION}/no-fields"}
