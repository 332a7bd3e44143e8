"""The programs in docs/conformance.md do what they say."""

from __future__ import annotations

import re
import textwrap
from datetime import UTC, datetime
from pathlib import Path

from tests.conformance.simulated import examined

from jauspy.conformance import TargetComponent, Verdict, VirtualTarget
from jauspy.ids import JausID
from jauspy.services.core import Discovery, Management
from jauspy.services.host import Host

PAGE = Path(__file__).parents[2] / "docs" / "conformance.md"


def program(beginning: str) -> str:
    blocks = map(textwrap.dedent, re.findall(r"(?:^ {4}.*\n|^\n)+", PAGE.read_text(), re.MULTILINE))
    (found,) = [each.strip() for each in blocks if each.strip().startswith(beginning)]
    return found


def my_host() -> Host:
    return Host(JausID(101, 1, 1), [Discovery(), Management()], utc_now=lambda: datetime(2026, 1, 1, tzinfo=UTC))


def test_documented_profile_runs():
    names: dict = {}
    exec(program("from jauspy.conformance import Profile"), names)
    report = examined(names["PROFILE"], VirtualTarget([TargetComponent(my_host())]), JausID(101, 1, 1))
    assert [each.verdict for each in report.results] == [Verdict.FAIL, Verdict.SILENT]
    assert report.points == (0, 5)


def test_documented_pytest_steps_run():
    names: dict = {"my_host": my_host}
    exec(program("from jauspy.conformance import TargetComponent"), names)
    (mark,) = names["test_core"].pytestmark
    steps = [each.values[0] for each in mark.args[1]]
    assert len(steps) > 50
    steps[0]()
