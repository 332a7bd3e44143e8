"""`jauspy echo --subscribe`: an event is created, its reports are printed, and it is cancelled."""

import json

import pytest

from jauspy.cli.definitions import definitions
from jauspy.cli.echo import _print_reports, _Printer
from jauspy.cli.event_reports import event_query, event_reports
from jauspy.errors import ConfigError, ResponseTimeout
from jauspy.ids import JausID
from jauspy.messages.core import QueryStatus
from jauspy.services.core import Events, Management


@pytest.mark.parametrize(
    ("source", "message", "said"),
    [
        (None, "ReportStatus", "needs a component and a message"),
        ("7.1.1", None, "needs a component and a message"),
        ("7.1.255", "ReportStatus", "has wildcards"),
        ("7.1.1", "Resume", "no query and no report"),
        ("7.1.1", "ReportNothing", "QueryNothing"),
    ],
)
def test_what_has_no_event_is_said(source, message, said):
    with pytest.raises(ConfigError, match=said):
        event_query(source, message, definitions(None))


@pytest.mark.parametrize("name", ["ReportStatus", "QueryStatus"])
def test_report_and_query_name_the_same_event(name):
    component, query = event_query("7.1.1", name, definitions(None))
    assert component == JausID(7, 1, 1)
    assert query == QueryStatus()


async def test_reports_are_printed_and_the_event_is_cancelled(virtual_network, capsys):
    async with virtual_network.component("7.1.1", [Management()]) as component:
        ocu = virtual_network.ocu()
        reports = event_reports(ocu, JausID(7, 1, 1), QueryStatus(), 5.0)
        await _print_reports(reports, _Printer((), True), None, 3)
        shown = [json.loads(line) for line in capsys.readouterr().out.splitlines()]
        assert [each["message"] for each in shown] == ["ReportStatus"] * 3
        assert {each["source"] for each in shown} == {"7.1.1"}
        assert shown[0]["fields"]["status"] == "STANDBY"
        assert not component.host.service(Events).subscriptions.all()


async def test_an_event_that_is_not_answered_is_an_error(virtual_network):
    reports = event_reports(virtual_network.ocu(), JausID(7, 1, 1), QueryStatus(), None)
    with pytest.raises(ResponseTimeout):
        await anext(reports)
