"""`.ci/run` on planted tests: what fails is tried again; what then passes is recorded, and too much of that fails."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path

import pytest
from tools import second_try
from tools.second_try import MAX_SECOND_TRIES, Outcomes, OutcomesError, judge, report

ROOT = Path(__file__).parents[1]
MAKEFILE = """
dev check wheel-test audit:
\t@true
unit:
\t@.venv/bin/pytest -n 2 $(PYTEST_ARGS)
test-together:
\t@.venv/bin/pytest -n 2 -m 'slow and not alone' $(PYTEST_ARGS)
test-alone:
\t@.venv/bin/pytest -m 'slow and alone' $(PYTEST_ARGS)
"""
SETTINGS = """
[pytest]
testpaths = tests
addopts = -m 'not slow' -p xdist
markers =
    slow
    alone
pythonpath = .
"""
PLANTED = '''
import os
from pathlib import Path

import pytest


def first(name):
    """True at the first try; each try leaves a file."""
    path = Path(f"tried-{name}")
    tried = path.exists()
    path.touch()
    return not tried


def test_that_passes():
    pass


@pytest.mark.slow
def test_slow():
    pass


@pytest.mark.slow
@pytest.mark.alone
def test_alone():
    pass
'''
FLAKY = """
def test_flaky_{0}():
    assert not first("{0}")
"""
FAILS = """
@pytest.mark.slow
def test_that_fails():
    assert False
"""
SKIPS = """
def test_that_is_skipped_then():
    if first("skipping"):
        raise RuntimeError
    pytest.skip("no matter")
"""
TEARDOWN = """
@pytest.fixture
def broken():
    yield
    assert not first("teardown")


def test_with_a_teardown(broken):
    pass
"""
KILLED = """
def test_that_ends_the_run():
    os.kill(os.getppid(), 9)
"""


@dataclass
class Run:
    status: int
    lines: list[str]
    record: list[str]


def run(folder: Path, planted: str) -> Run:
    """Run `.ci/run` in a tree with these tests, where there are no checks to make and media cannot be removed."""
    for name in (".ci", "tools", "tests"):
        (folder / name).mkdir()
    shutil.copy(ROOT / ".ci/run", folder / ".ci/run")
    shutil.copy(ROOT / "tools/second_try.py", folder / "tools/second_try.py")
    (folder / "tools/without_media.sh").write_text("#!/bin/sh\nexit 77\n")
    (folder / "tools/without_media.sh").chmod(0o755)
    (folder / ".venv").symlink_to(Path(sys.prefix))
    (folder / "Makefile").write_text(MAKEFILE)
    (folder / "pytest.ini").write_text(SETTINGS)
    (folder / "tests/conftest.py").write_text('pytest_plugins = ("tools.second_try",)\n')
    (folder / "tests/test_planted.py").write_text(PLANTED + planted)
    names = ("MAKEFLAGS", "MAKELEVEL", "PYTEST_ARGS")
    environment = {name: value for name, value in os.environ.items() if name not in names and "PYTEST" not in name}
    environment["PYTEST_DISABLE_PLUGIN_AUTOLOAD"] = "1"  # those of other packages take seconds to load
    command = [folder / ".ci/run"]
    done = subprocess.run(command, check=False, capture_output=True, text=True, timeout=250, env=environment)
    return Run(done.returncode, done.stdout.splitlines(), (folder / ".ci/second_tries.txt").read_text().splitlines())


def flaky(count: int) -> str:
    return "".join(FLAKY.format(number) for number in range(count))


@pytest.mark.slow
def test_what_passes_at_the_second_try_is_recorded_and_printed_last(tmp_path: Path) -> None:
    ended = run(tmp_path, flaky(2) + TEARDOWN)
    expected = {f"unit: tests/test_planted.py::test_{name}" for name in ("flaky_0", "flaky_1", "with_a_teardown")}
    assert set(ended.record) == expected
    assert set(ended.lines[-3:]) == expected
    assert ended.status == 0


@pytest.mark.slow
def test_without_failures_nothing_is_recorded(tmp_path: Path) -> None:
    ended = run(tmp_path, "")
    assert ended.record == []
    assert ended.lines[-1] == "== no test passed only at the second try"
    assert ended.status == 0


@pytest.mark.slow
@pytest.mark.parametrize(
    ("planted", "recorded"),
    [
        pytest.param(flaky(MAX_SECOND_TRIES + 1), MAX_SECOND_TRIES + 1, id="too many"),
        pytest.param(FAILS + flaky(1), 1, id="fails twice"),
        pytest.param(FAILS.replace("slow", "slow\n@pytest.mark.alone", 1), 0, id="fails twice alone"),
        pytest.param(SKIPS + flaky(1), 1, id="is skipped then"),
        pytest.param(KILLED, 0, id="killed"),
        pytest.param("import nothing_of_this_name", 0, id="cannot be collected"),
    ],
)
def test_what_fails_the_run(tmp_path: Path, planted: str, recorded: int) -> None:
    ended = run(tmp_path, planted)
    assert ended.status != 0
    assert len(ended.record) == recorded
    assert ended.lines[len(ended.lines) - recorded :] == ended.record


def outcomes(*phases: tuple[str, str, str], status: int = 1) -> Outcomes:
    made = Outcomes(status)
    for name, outcome, phase in phases:
        made.add(name, outcome, phase)
    return made


def test_one_phase_that_fails_fails_a_test() -> None:
    made = outcomes(
        ("passes", "passed", "setup"),
        ("passes", "passed", "call"),
        ("passes", "passed", "teardown"),
        ("setup", "failed", "setup"),
        ("setup", "passed", "teardown"),
        ("call", "passed", "setup"),
        ("call", "failed", "call"),
        ("call", "passed", "teardown"),
        ("teardown", "passed", "call"),
        ("teardown", "failed", "teardown"),
        ("skipped", "passed", "setup"),
        ("skipped", "skipped", "call"),
        ("skipped", "passed", "teardown"),
        ("crashed", "failed", "???"),
    )
    assert made.failed == ["setup", "call", "teardown", "crashed"]
    assert made.tests["passes"] == "passed"
    assert made.tests["skipped"] == "skipped"


def test_only_what_has_passed_has_passed() -> None:
    first = outcomes(*((name, "failed", "call") for name in ("a", "b", "c", "d")), ("e", "passed", "call"))
    second = outcomes(("a", "passed", "call"), ("b", "failed", "call"), ("c", "skipped", "call"))
    assert judge(first, second) == (["a"], ["b", "c", "d"])


@pytest.mark.parametrize("status", [2, 3, 4, 5])
def test_a_run_that_did_not_end_as_planned_is_not_mended_by_the_tests_that_failed_in_it(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, status: int
) -> None:
    ran: list[list[str]] = []

    def make(command: list[str], check: bool) -> subprocess.CompletedProcess[str]:
        ran.append(command)
        path = Path(command[-1].removeprefix("PYTEST_ARGS=--outcomes ").split()[0])
        outcomes(("a", "failed", "call"), status=status).write(path)
        return subprocess.CompletedProcess(command, 2)

    monkeypatch.setattr(second_try.subprocess, "run", make)
    assert second_try.run_stage("unit", "unit", tmp_path / "record") == 1
    assert len(ran) == 1


@pytest.mark.parametrize(("count", "status"), [(0, 0), (1, 0), (MAX_SECOND_TRIES, 0), (MAX_SECOND_TRIES + 1, 1)])
def test_the_report_ends_with_the_record(count: int, status: int) -> None:
    record = [f"unit: test_{number}" for number in range(count)]
    lines, ended = report(record)
    assert ended == status
    assert lines[1:] == record
    assert str(count) in lines[0] or count == 0


@pytest.mark.parametrize("text", ["", "{", "[]", '{"status": 1}'])
def test_a_run_that_left_nothing_readable_is_no_success(tmp_path: Path, text: str) -> None:
    path = tmp_path / "outcomes.json"
    with pytest.raises(OutcomesError):
        Outcomes.read(path)
    path.write_text(text)
    with pytest.raises(OutcomesError):
        Outcomes.read(path)
