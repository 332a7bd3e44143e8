"""What a query is answered by is known to its class, and to type checkers."""

from __future__ import annotations

import subprocess
import sys

from jauspy.messages import registry

TYPED = """
from typing import Any, assert_type

import jauspy
from jauspy.messages.core import ReportControl, ReportStatus, QueryStatus
from jauspy.messages.mobility import QueryLocalPose, ReportLocalPose

async def check(ocu: jauspy.OCU, plain: jauspy.sync.OCU, unknown: jauspy.Message) -> None:
    driver = (await ocu.discover(101)).service("PrimitiveDriver")
    assert_type(await driver.query(QueryLocalPose(1)), ReportLocalPose)
    assert_type(await driver.query(QueryLocalPose(1), expects=ReportControl), ReportControl)
    assert_type(await driver.query(unknown), Any)
    assert_type(await ocu.query("101.1.1", QueryStatus()), ReportStatus)
    assert_type(plain.query("101.1.1", QueryStatus()), ReportStatus)
    async with driver.subscribe(QueryLocalPose(1), rate=10.0) as poses:
        assert_type(await poses.get(), ReportLocalPose)
    await ocu.watch().aclose()
    plain.watch().close()
    jauspy.sync.OCU().query_each("101.255.255", QueryStatus()).close()
"""


def test_type_checkers_infer_the_report(tmp_path):
    file = tmp_path / "typed.py"
    file.write_text(TYPED)
    done = subprocess.run(
        [sys.executable, "-m", "mypy", "--strict", "--cache-dir", str(tmp_path), str(file)],
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stdout


def test_the_report_is_of_the_same_service_and_version():
    queries = [each for each in registry if each.IS_QUERY]
    known = [each for each in queries if hasattr(each, "REPORT")]
    assert len(known) > 0.9 * len(queries)
    for each in known:
        assert (each.REPORT.SERVICE, each.REPORT.VERSION) == (each.SERVICE, each.VERSION)
        assert each.REPORT.NAME.removeprefix("Report") == each.NAME.removeprefix("Query") or each.CODE < 0x4000
