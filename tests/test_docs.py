"""The programs in docs/ocu.md and docs/testing.md do what they say."""

from __future__ import annotations

import re
import textwrap
from pathlib import Path

import pytest

from jauspy.testing import LocalNode

DOCS = Path(__file__).parents[1] / "docs"


def program(name: str, beginning: str) -> str:
    """The indented block of a page that begins so."""
    blocks = (
        textwrap.dedent(each) for each in re.findall(r"(?:^ {4}.*\n|^\n)+", (DOCS / name).read_text(), re.MULTILINE)
    )
    (found,) = [each.strip() for each in blocks if each.strip().startswith(beginning)]
    return found


def test_the_synchronous_ocu(node_manager: LocalNode, robot) -> None:
    source = program("ocu.md", "from jauspy.sync import OCU")
    start = "from jauspy.messages.mobility import QueryLocalPose, SetWrenchEffort\n"
    exec(start + source.replace('OCU("42.1.1")', f'OCU("42.1.1", "{node_manager.local}")'), {})
    assert robot.snapshot.pose.x > 1.99
    assert robot.components[0].host.state.endswith("NotControlled.Available.Standby")


def test_the_first_tests_of_a_component(pytester: pytest.Pytester) -> None:
    first = program("testing.md", "from jauspy.messages.core import QueryHeartbeatPulse")
    without_asyncio = program("testing.md", "def test_it_is_found")
    pytester.makepyfile("\n\n".join([first, "import jauspy", without_asyncio]))
    result = pytester.runpytest_subprocess("-p", "jauspy.testing.plugin", "-o", "asyncio_mode=auto")
    result.assert_outcomes(passed=2)
