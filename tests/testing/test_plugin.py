"""The plugin as a user's project sees it: one run of pytest over small test files, whose results are judged here."""

from __future__ import annotations

import os
import subprocess
import sys
import xml.etree.ElementTree as ET
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

import pytest
from tests.helpers.documentation import program

PLUGIN = ("-p", "jauspy.testing.plugin")
ASYNCIO = ("-p", "pytest_asyncio.plugin", *PLUGIN)
"""Other plugins of this environment are not loaded, which would take a second."""

TALK = """
import pytest
from jauspy.messages.core import QueryHeartbeatPulse
from jauspy.services.core import Liveness

@pytest.mark.asyncio
async def test_it(PLACE, ocu):
    async with PLACE.component("101.1.1", [Liveness()]):
        report = await ocu.query("101.1.1", QueryHeartbeatPulse())
        assert report.NAME == "ReportHeartbeatPulse"
"""

FILES = {
    "virtual_network": TALK.replace("PLACE", "virtual_network"),
    "node_manager": TALK.replace("PLACE", "node_manager"),
    "virtual_hour": """
import asyncio, time

async def test_it(virtual_network):
    started = time.monotonic()
    await asyncio.sleep(3600)
    assert virtual_network.clock.elapsed >= 3600
    assert time.monotonic() - started < 60
""",
    "two_times": """
async def test_it(virtual_network, node_manager, ocu):
    pass
""",
    "leftover_task": """
import asyncio

async def test_it(virtual_network):
    virtual_network.task = asyncio.create_task(asyncio.sleep(1), name="forgotten")
""",
    "unhandled_error": """
import asyncio

async def test_it(virtual_network):
    asyncio.get_running_loop().call_soon(lambda: 1 / 0)
    await asyncio.sleep(1)
""",
    "action": """
import pytest
from jauspy.errors import ResponseTimeout
from jauspy.messages.core import QueryHeartbeatPulse
from jauspy.services.core import Liveness

class Broken(Liveness):
    def report_heartbeat_pulse(self, query):
        return self.missing_attribute

@pytest.mark.parametrize("allowed", [False, True])
async def test_it(virtual_network, ocu, allowed):
    virtual_network.allow_errors = allowed
    async with virtual_network.component("101.1.1", [Broken()]):
        with pytest.raises(ResponseTimeout):
            await ocu.query("101.1.1", QueryHeartbeatPulse())
""",
    "unawaited_task": """
import asyncio

async def fail():
    myself = asyncio.current_task()  # so that it does not go before somebody collects the garbage
    raise ValueError("unseen")

async def test_it(virtual_network):
    asyncio.create_task(fail())
    await asyncio.sleep(1)
""",
    "documented": "\n\n".join(
        (
            program("testing.md", "from jauspy.messages.core import QueryHeartbeatPulse"),
            "import jauspy",
            program("testing.md", "def test_it_is_found"),
        )
    ),
}
"""Test files of a project with pytest-asyncio, by name."""

WITHOUT_ASYNCIO = """
def test_it(node_manager):
    assert node_manager.components == ()
    assert node_manager.port > 0

def test_ocu(ocu):
    pass
"""
WITHOUT_ASYNCIO_CONFTEST = """
from jauspy.testing import plugin

async def ocu():
    yield

plugin.find_spec = lambda name: None
ocu = plugin._asynchronous(ocu)
"""


@dataclass(frozen=True)
class Outcome:
    """Of one test: whether its function passed, and the text of its error or failure."""

    passed: bool
    problem: str


def outcomes(folder: Path, *options: str) -> dict[str, Outcome]:
    """Run pytest over a folder; the outcomes by the name of file and test."""
    report = folder / "report.xml"
    command = (sys.executable, "-m", "pytest", "-q", "-p", "no:cacheprovider", f"--junit-xml={report}", *options)
    measured = {name: value for name, value in os.environ.items() if name.startswith("COVERAGE_")}
    environment = {"PYTHONPATH": ":".join(sys.path), "PATH": "/usr/bin:/bin", "PYTEST_DISABLE_PLUGIN_AUTOLOAD": "1"}
    done = subprocess.run(command, cwd=folder, env=environment | measured, capture_output=True, text=True, check=False)
    assert report.exists(), done.stdout + done.stderr
    found: dict[str, Outcome] = {}
    for case in ET.parse(report).iter("testcase"):
        name = f"{case.get('classname', '').rpartition('.')[2].removeprefix('test_')}:{case.get('name')}"
        problems = [*case.iter("failure"), *case.iter("error")]
        text = "\n".join(f"{each.get('message')}\n{each.text}" for each in problems)
        passed = not any(True for _ in case.iter("failure")) and "failed on setup" not in text
        before = found.get(name, Outcome(True, ""))  # an error of the teardown is a second entry
        found[name] = Outcome(before.passed and passed, before.problem + text)
    return found


def written(folder: Path, files: Mapping[str, str]) -> Path:
    for name, source in files.items():
        (folder / f"test_{name}.py").write_text(source)
    return folder


@pytest.fixture(scope="module")
def automatic(tmp_path_factory: pytest.TempPathFactory) -> dict[str, Outcome]:
    """A project where pytest-asyncio runs every asynchronous test."""
    return outcomes(written(tmp_path_factory.mktemp("auto"), FILES), *ASYNCIO, "-o", "asyncio_mode=auto")


@pytest.fixture(scope="module")
def strict(tmp_path_factory: pytest.TempPathFactory) -> dict[str, Outcome]:
    """A project where it runs marked ones only."""
    files = {name: FILES[name] for name in ("virtual_network", "node_manager")}
    return outcomes(written(tmp_path_factory.mktemp("strict"), files), *ASYNCIO, "-o", "asyncio_mode=strict")


@pytest.fixture(scope="module")
def without_asyncio(tmp_path_factory: pytest.TempPathFactory) -> dict[str, Outcome]:
    """A project without pytest-asyncio."""
    folder = written(tmp_path_factory.mktemp("plain"), {"plain": WITHOUT_ASYNCIO})
    (folder / "conftest.py").write_text(WITHOUT_ASYNCIO_CONFTEST)
    return outcomes(folder, *PLUGIN)


@pytest.mark.slow
@pytest.mark.parametrize("mode", ["strict", "automatic"])
@pytest.mark.parametrize("place", ["virtual_network", "node_manager"])
def test_an_ocu_reaches_a_component(request: pytest.FixtureRequest, mode: str, place: str) -> None:
    assert request.getfixturevalue(mode)[f"{place}:test_it"] == Outcome(True, "")


@pytest.mark.slow
def test_virtual_hour_takes_no_time(automatic: dict[str, Outcome]) -> None:
    assert automatic["virtual_hour:test_it"] == Outcome(True, "")


def test_documented_component_test_runs(automatic: dict[str, Outcome]) -> None:
    found = [outcome for name, outcome in automatic.items() if name.startswith("documented:")]
    assert found == [Outcome(True, "")] * 2


def test_mixing_real_and_virtual_time_is_an_error(automatic: dict[str, Outcome]) -> None:
    outcome = automatic["two_times:test_it"]
    assert not outcome.passed
    assert "either node_manager, on real time, or virtual_network" in outcome.problem


def test_leftover_task_fails_the_test(automatic: dict[str, Outcome]) -> None:
    outcome = automatic["leftover_task:test_it"]
    assert outcome.passed
    assert "still running at the end of the test: " in outcome.problem
    assert "forgotten" in outcome.problem


@pytest.mark.parametrize(("file", "error"), [("unhandled_error", "ZeroDivisionError"), ("unawaited_task", "unseen")])
def test_unhandled_error_fails_the_test(automatic: dict[str, Outcome], file: str, error: str) -> None:
    outcome = automatic[f"{file}:test_it"]
    assert outcome.passed
    assert "an unhandled error" in outcome.problem
    assert error in outcome.problem


def test_exception_in_an_action_fails_the_test_with_its_traceback(automatic: dict[str, Outcome]) -> None:
    problem = automatic["action:test_it[False]"].problem
    assert "of 101.1.1 raised AttributeError: 'Broken' object has no attribute 'missing_attribute'" in problem
    assert "return self.missing_attribute" in problem
    assert automatic["action:test_it[True]"] == Outcome(True, "")


@pytest.mark.slow
def test_the_node_manager_serves_a_test_without_asyncio(without_asyncio: dict[str, Outcome]) -> None:
    assert without_asyncio["plain:test_it"] == Outcome(True, "")


@pytest.mark.slow
def test_missing_pytest_asyncio_is_explained(without_asyncio: dict[str, Outcome]) -> None:
    outcome = without_asyncio["plain:test_ocu"]
    assert not outcome.passed
    assert "pip install pytest-asyncio" in outcome.problem


def test_plugin_imports_no_unused_modules():
    code = "import sys, jauspy.testing.plugin; print(*[name for name in sys.modules if name.startswith('jauspy')])"
    run = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert set(run.stdout.split()) == {"jauspy", "jauspy.testing", "jauspy.testing.plugin"}


@pytest.mark.slow
def test_jauspy_testing_needs_no_pytest():
    code = "import sys; from jauspy.testing import VirtualNetwork, LocalNode, until; print('pytest' in sys.modules)"
    run = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert run.stdout.strip() == "False"
