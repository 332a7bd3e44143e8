"""Components that loiter: right ones pass, and of wrong ones the steps fail that are about it."""

from __future__ import annotations

import pytest
from tests.conformance.judging import failed, judged
from tests.helpers.sampling import sampled

from jauspy import Service
from jauspy.messages.mobility import (
    ReportGlobalLoiter,
    ReportLocalLoiter,
    ReportTravelSpeedExt,
    SetTravelSpeedExt,
    ZPosition,
)
from jauspy.services import presence_vectors

READY = "Controlled.Available.Ready"
STILL = SetTravelSpeedExt.Speed(SetTravelSpeedExt.Speed.Choice.SPEED_OVER_GROUND, 0.0)


class Loiterer(Service):
    """Keeps what it is told; nobody moves."""

    def __init__(self):
        self.loiter = self.empty
        self.speed = STILL

    def loiter_exists(self):
        return self.loiter is not self.empty

    def set_travel_speed_ext(self, msg):
        self.speed = msg.speed

    def reset_travel_speed(self):
        self.speed = STILL

    def send_report_travel_speed_ext(self):
        return ReportTravelSpeedExt(self.speed)


class LocalLoiterer(Loiterer, urn="urn:jaus:jss:mobility:LocalLoiterDriver"):
    empty = ReportLocalLoiter.LocalLoiterRec(0.0, 0.0)

    def set_local_loiter(self, msg):
        self.loiter = msg.local_loiter_rec

    def send_report_local_loiter(self):
        place = ReportLocalLoiter.LocalLoiterRec(self.loiter.x, self.loiter.y, ZPosition(0, 5.0))
        return ReportLocalLoiter(place, ReportLocalLoiter.HoverRec(0, 0.0, 0.0))


class GlobalLoiterer(Loiterer, urn="urn:jaus:jss:mobility:GlobalLoiterDriver"):
    empty = ReportGlobalLoiter.GlobalLoiterRec(0.0, 0.0)

    def set_global_loiter(self, msg):
        self.loiter = msg.global_loiter_rec

    def send_report_global_loiter(self):
        place = ReportGlobalLoiter.GlobalLoiterRec(self.loiter.latitude, self.loiter.longitude)
        return ReportGlobalLoiter(place, ReportGlobalLoiter.HoverRec(0, 0.0, 0.0))


def nothing(self, msg):
    pass


@pytest.mark.parametrize("kind", sampled([LocalLoiterer, GlobalLoiterer], 1))
def test_correct_loiter_driver_passes(kind):
    report = judged(kind())
    assert failed(report) == set()
    taken = {name for result in report.results for name in result.taken}
    assert any(name.endswith("[isControllingClient(transportData) && loiterExists()]") for name in taken)


@pytest.mark.parametrize(
    ("kind", "action", "step"),
    [
        (LocalLoiterer, "set_local_loiter", "SetLocalLoiter/controller"),
        pytest.param(GlobalLoiterer, "set_global_loiter", "SetGlobalLoiter/controller", marks=pytest.mark.slow),
        (LocalLoiterer, "set_travel_speed_ext", "SetTravelSpeedExt/controller"),
    ],
)
def test_ignored_loiter_fails(kind, action, step, monkeypatch):
    monkeypatch.setattr(kind, action, nothing)
    assert f"{READY}/{step}" in failed(judged(kind()))


def test_unrequested_altitude_fails(monkeypatch):
    monkeypatch.setattr(presence_vectors, "apply_presence_vectors", lambda report, query: report)
    assert f"{READY}/QueryLocalLoiter/other-client/no-fields" in failed(judged(LocalLoiterer()))
