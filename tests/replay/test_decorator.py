"""`jauspy.testing.replay` in a user's project: pytest runs it in a process of its own."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

FILE = """
import jauspy.testing
import pytest_asyncio
from jauspy.messages.core import ReportStatus
from jauspy.services.core import AccessControl, Events, Liveness

@pytest_asyncio.fixture
async def target(virtual_network):
    async with virtual_network.component("101.1.1", [Events(), AccessControl(), Liveness()]) as component:
        yield component

@pytest_asyncio.fixture
async def silent_target(virtual_network, target):
    virtual_network.lose(ReportStatus, 1)

@jauspy.testing.replay("run.pcapng")
def test_field_run(target): ...

@jauspy.testing.replay("run.pcapng", speed=None)
async def test_own_assertions(target, environment):
    assert target.state.startswith("Receiving.Ready")
    assert environment.sent(ReportStatus)

@jauspy.testing.replay("run.pcapng")
def test_fault(silent_target): ...
"""


@pytest.mark.slow
def test_a_recording_is_a_test(recording: Path) -> None:
    (recording.parent / "test_run.py").write_text(FILE)
    found = subprocess.run(
        [sys.executable, "-m", "pytest", "-q", "--strict-config", "-p", "no:cacheprovider", "test_run.py"],
        cwd=recording.parent,
        capture_output=True,
        text=True,
        check=False,
    )
    assert "1 failed, 2 passed" in found.stdout, found.stdout + found.stderr
    assert "answers differ from those in run.pcapng:" in found.stdout
    assert "QueryStatus to 101.1.1: ReportStatus recorded, (no answer) now" in found.stdout
