"""The plugin as a user's project sees it."""

from __future__ import annotations

import subprocess
import sys

import pytest

STRICT = ("-p", "jauspy.testing.plugin", "-o", "asyncio_mode=strict")
AUTO = ("-p", "jauspy.testing.plugin", "-o", "asyncio_mode=auto")

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


@pytest.fixture
def run(pytester, monkeypatch):
    """Runs a test file in a process of its own."""
    monkeypatch.setenv("PYTHONPATH", ":".join(sys.path))

    def go(source: str, *options: str) -> pytest.RunResult:
        pytester.makepyfile(source)
        return pytester.runpytest_subprocess("-p", "no:cacheprovider", *options)

    return go


@pytest.mark.parametrize("mode", [STRICT, pytest.param(AUTO, marks=pytest.mark.slow)])
@pytest.mark.parametrize("place", ["virtual_network", "node_manager"])
def test_an_ocu_reaches_a_component(run, mode, place):
    run(TALK.replace("PLACE", place), *mode).assert_outcomes(passed=1)


def test_virtual_hour_takes_no_time(run):
    source = """
import asyncio, time

async def test_it(virtual_network):
    started = time.monotonic()
    await asyncio.sleep(3600)
    assert virtual_network.clock.elapsed >= 3600
    assert time.monotonic() - started < 60
"""
    run(source, *AUTO).assert_outcomes(passed=1)


def test_mixing_real_and_virtual_time_is_an_error(run):
    source = """
async def test_it(virtual_network, node_manager, ocu):
    pass
"""
    result = run(source, *AUTO)
    result.assert_outcomes(errors=1)
    result.stdout.fnmatch_lines(["*either node_manager, on real time, or virtual_network*"])


def test_leftover_task_fails_the_test(run):
    source = """
import asyncio

async def test_it(virtual_network):
    virtual_network.task = asyncio.create_task(asyncio.sleep(1), name="forgotten")
"""
    result = run(source, *AUTO)
    result.assert_outcomes(passed=1, errors=1)
    result.stdout.fnmatch_lines(["*still running at the end of the test: *forgotten*"])


def test_unhandled_error_fails_the_test(run):
    source = """
import asyncio

async def test_it(virtual_network):
    asyncio.get_running_loop().call_soon(lambda: 1 / 0)
    await asyncio.sleep(1)
"""
    result = run(source, *AUTO)
    result.assert_outcomes(passed=1, errors=1)
    result.stdout.fnmatch_lines(["*an unhandled error*ZeroDivisionError*"])


def test_error_of_an_unawaited_task_fails_the_test(run):
    source = """
import asyncio

async def fail():
    myself = asyncio.current_task()  # so that it does not go before somebody collects the garbage
    raise ValueError("unseen")

async def test_it(virtual_network):
    asyncio.create_task(fail())
    await asyncio.sleep(1)
"""
    result = run(source, *AUTO)
    result.assert_outcomes(passed=1, errors=1)
    result.stdout.fnmatch_lines(["*an unhandled error*ValueError*unseen*"])


def test_the_node_manager_serves_a_test_without_asyncio(run):
    source = """
def test_it(node_manager):
    assert node_manager.components == ()
    assert node_manager.port > 0
"""
    run(source, *STRICT, "-p", "no:asyncio").assert_outcomes(passed=1)


def test_missing_pytest_asyncio_is_explained(run, pytester):
    pytester.makeconftest("""
from jauspy.testing import plugin

async def ocu():
    yield

plugin.find_spec = lambda name: None
ocu = plugin._asynchronous(ocu)
""")
    result = run("def test_it(ocu): pass", *STRICT)
    result.assert_outcomes(errors=1)
    result.stdout.fnmatch_lines(["*pip install pytest-asyncio*"])


def test_plugin_imports_no_unused_modules():
    code = "import sys, jauspy.testing.plugin; print(*[name for name in sys.modules if name.startswith('jauspy')])"
    run = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert set(run.stdout.split()) == {"jauspy", "jauspy.testing", "jauspy.testing.plugin"}


def test_jauspy_testing_needs_no_pytest():
    code = "import sys; from jauspy.testing import VirtualNetwork, LocalNode, until; print('pytest' in sys.modules)"
    run = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert run.stdout.strip() == "False"
