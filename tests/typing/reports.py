"""What a query is answered by is known to type checkers: mypy checks this file, nothing runs it."""

from __future__ import annotations

from typing import Any, assert_type

import jauspy
from jauspy.messages.core import QueryStatus, ReportControl, ReportStatus
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
