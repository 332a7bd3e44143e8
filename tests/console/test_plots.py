"""Fields over time: which there are, how they are recorded, and as CSV."""

from __future__ import annotations

import asyncio
from itertools import count

import pytest

from jauspy.console.plots import MAX_SAMPLES, MAX_TRACES, Recorder
from jauspy.console.reports import MAX_FIELDS, fields_of, numbers_of, queries_of
from jauspy.errors import ConfigError
from jauspy.messages import registry
from jauspy.messages.core import QueryStatus, ReportServices, ReportStatus
from jauspy.messages.mobility import QueryLocalPose, ReportLocalPose
from jauspy.ocu import OCU
from jauspy.ocu.subsystems import ComponentInfo
from jauspy.testing import VirtualNetwork


def test_fields_have_paths_units_and_numbers() -> None:
    report = ReportLocalPose(x=1.25, yaw=0.5)
    x, yaw = (each for each in fields_of(report) if each.path in ("x", "yaw"))
    assert (x.text, x.unit) == ("1.25", "m")
    assert x.number == pytest.approx(1.25, abs=1e-4)
    assert yaw.unit == "rad"
    ready = ReportStatus(status=ReportStatus.Status.READY, reserved=0)
    assert "READY" in fields_of(ready)[0].text
    assert numbers_of(ready)["status"] == ReportStatus.Status.READY


def test_of_a_long_message_the_first_fields_are_shown() -> None:
    node = ReportServices.NodeSeq(node_rec=ReportServices.NodeRec(node_id=1), component_list=[])
    shown = fields_of(ReportServices(node_list=[node] * 250))
    assert len(shown) == MAX_FIELDS + 1
    assert "only the first" in shown[-1].text


async def component_with(ocu: OCU, service: str) -> ComponentInfo:
    robot = await ocu.discover(101)
    return next(each for each in robot.components if each.find(service))


@pytest.mark.slow
async def test_traces_of_one_report_share_a_subscription(virtual_network: VirtualNetwork) -> None:
    async with virtual_network.robot(), virtual_network.ocu() as ocu:
        component = await component_with(ocu, "LocalPoseSensor")
        query = queries_of(component, registry)["QueryLocalPose"]
        assert isinstance(query, QueryLocalPose)
        ticks = count()
        recorder = Recorder(ocu, now=lambda: float(next(ticks)))
        x = recorder.add(component, query, "x", "m", 5.0)
        yaw = recorder.add(component, query, "yaw", "rad", 5.0)
        assert recorder.add(component, query, "x", "m", 5.0) is x
        sent = ocu.stats.sent
        await asyncio.sleep(4.0)
        assert ocu.stats.sent - sent < 6, "reports come as events, not as answers"
        assert 15 <= x.total == yaw.total <= 21
        assert x.problem == ""
        head, first, *_ = recorder.csv().splitlines()
        assert head == f"time,{component.id} LocalPose.x [m],{component.id} LocalPose.yaw [rad]"
        assert first.startswith("1970-01-01T00:00:00.000+00:00,")
        recorder.remove(x.number)
        recorder.remove(yaw.number)
        total = yaw.total
        await asyncio.sleep(2.0)
        assert yaw.total == total
        recorder.close()


@pytest.mark.slow
async def test_a_component_without_events_is_queried(virtual_network: VirtualNetwork) -> None:
    async with virtual_network.robot(), virtual_network.ocu() as ocu:
        component = await component_with(ocu, "LocalPoseSensor")
        without = ComponentInfo(
            component.id, services=tuple(each for each in component.services if not each.is_called("Events"))
        )
        recorder = Recorder(ocu)
        trace = recorder.add(without, QueryStatus(), "status", "", 5.0)
        await asyncio.sleep(2.0)
        assert 8 <= trace.total <= 11
        missing = recorder.add(without, QueryStatus(), "no.such", "", 5.0)
        await asyncio.sleep(1.0)
        assert missing.problem == "the last report has no such field"
        recorder.close()


async def test_traces_and_values_are_bounded(virtual_network: VirtualNetwork) -> None:
    async with virtual_network.ocu() as ocu:
        recorder = Recorder(ocu)
        nobody = ComponentInfo(ocu.id)
        traces = [recorder.add(nobody, QueryStatus(), str(each), "", 1.0) for each in range(MAX_TRACES)]
        with pytest.raises(ConfigError, match="remove one first"):
            recorder.add(nobody, QueryStatus(), "more", "", 1.0)
        with pytest.raises(ConfigError, match=r"0\.\.50 Hz"):
            recorder.add(nobody, QueryStatus(), "0", "", 0.0)
        for each in range(MAX_SAMPLES + 10):
            traces[0].add(float(each), 0.0)
        assert (len(traces[0].samples), traces[0].total) == (MAX_SAMPLES, MAX_SAMPLES + 10)
        recorder.close()
