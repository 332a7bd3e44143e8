"""What a query is answered by is known to its class; tests/typing/ has what type checkers know."""

from __future__ import annotations

from jauspy.messages import registry


def test_the_report_is_of_the_same_service_and_version():
    queries = [each for each in registry if each.IS_QUERY]
    known = [each for each in queries if hasattr(each, "REPORT")]
    assert len(known) > 0.9 * len(queries)
    for each in known:
        assert (each.REPORT.SERVICE, each.REPORT.VERSION) == (each.SERVICE, each.VERSION)
        assert each.REPORT.NAME.removeprefix("Report") == each.NAME.removeprefix("Query") or each.CODE < 0x4000
