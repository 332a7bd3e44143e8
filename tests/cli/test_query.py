"""`jauspy query` of a component that does not offer what it is asked for."""

from __future__ import annotations

import asyncio

import pytest
from typer.testing import CliRunner

from jauspy.cli.main import app
from jauspy.cli.query import _ask, _show_json, _show_yaml, repeated
from jauspy.errors import ResponseTimeout
from jauspy.ids import JausID
from jauspy.messages.core import QueryHeartbeatPulse
from jauspy.messages.manipulator import QueryJointPositions
from jauspy.messages.mobility import ReportLocalPose
from jauspy.services.core import Liveness


async def asked(network, id, message):
    ocu = network.ocu()
    async with ocu:
        await _ask(ocu, id, message, _show_json, first=True)


async def test_a_query_that_is_not_offered_says_so(virtual_network):
    async with virtual_network.component("7.1.1", [Liveness()]):
        with pytest.raises(ResponseTimeout, match=r"7\.1\.1 does not offer QueryJointPositions of manipulator:"):
            await asked(virtual_network, JausID(7, 1, 1), QueryJointPositions())
    with pytest.raises(ResponseTimeout, match=r"QueryHeartbeatPulse .* times in .* and no answer came"):
        await asked(virtual_network, JausID(7, 1, 1), QueryHeartbeatPulse())


async def test_a_query_is_repeated_and_goes_on_after_a_missing_answer(virtual_network, capsys):
    ocu = virtual_network.ocu()
    clock, times = asyncio.get_running_loop().time, []

    async def ask(first):
        times.append(clock())
        if len(times) == 2:
            raise ResponseTimeout("7.1.1 did not answer")
        await _ask(ocu, JausID(7, 1, 1), QueryHeartbeatPulse(), _show_json, first=first)

    async with virtual_network.component("7.1.1", [Liveness()]):
        await repeated(ocu, ask, 0.5, 3)
    assert [round(time - times[0], 6) for time in times] == [0.0, 0.5, 1.0]
    printed = capsys.readouterr()
    assert printed.out.count("ReportHeartbeatPulse") == 2
    assert "7.1.1 did not answer" in printed.err


async def test_repeated_queries_without_any_answer_fail(virtual_network, capsys):
    async def ask(first):
        raise ResponseTimeout("7.1.1 did not answer")

    with pytest.raises(ResponseTimeout, match="none of 2 queries was answered"):
        await repeated(virtual_network.ocu(), ask, 0.5, 2)
    assert capsys.readouterr().err.count("7.1.1 did not answer") == 2


@pytest.mark.parametrize("show", [_show_json, _show_yaml])
def test_a_zero_is_printed_as_zero(show, capsys):
    pose = ReportLocalPose.decode(ReportLocalPose(x=0.0, yaw=0.5).encode())
    assert pose.x == 2.3283064365386963e-05
    show(pose, JausID(7, 1, 1), first=True)
    printed = capsys.readouterr().out
    assert ('"x":0.0,"yaw":0.5' if show is _show_json else "x: 0  # m\n") in printed
    assert "e-05" not in printed


@pytest.mark.parametrize("fields", [[], ["status=1", "reserved=0"]])
def test_a_report_is_no_query(fields):
    result = CliRunner().invoke(app, ["query", "7.1.1", "ReportStatus", *fields])
    assert result.exit_code == 1
    sentence = "ReportStatus is not a query but the answer to one; `jauspy query ID QueryStatus` asks for it"
    assert sentence in " ".join(result.stderr.split())
