"""Tests that fail are tried once more, alone; what passes only then is recorded, and too many of these fail the run.

`second_try.py stage NAME TARGET RECORD` runs `make TARGET`, and then the tests that failed in it. It succeeds if each
passes now; those that do are appended to the file RECORD. `second_try.py report RECORD` prints that file, and fails if
it has too many.

As a plugin of pytest, which tests/conftest.py loads, it writes with `--outcomes FILE` how each test ended.
"""

from __future__ import annotations

import argparse
import json
import os
import subprocess
import sys
import tempfile
from collections.abc import Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Final, TypeAlias

import pytest

MAX_SECOND_TRIES: Final = 3
"""Tests of one run that may pass only at the second try."""
TESTS_FAILED: Final = 1
"""The exit status of pytest after a whole run in which tests failed; others are of runs that did not end as planned."""
Outcome: TypeAlias = str
"""`passed`, `failed` or `skipped`."""


class OutcomesError(Exception):
    """A run of the tests of which nothing is known, such as one that was killed."""


@dataclass
class Outcomes:
    """How the tests of one run ended, by their names (node ids); and the exit status of pytest."""

    status: int = 0
    tests: dict[str, Outcome] = field(default_factory=dict)

    @property
    def failed(self) -> list[str]:
        """The tests, or files that could not be collected, that failed."""
        return [name for name, outcome in self.tests.items() if outcome == "failed"]

    def add(self, name: str, outcome: Outcome, phase: str) -> None:
        """Take the outcome of a phase (setup, call or teardown) of a test: one that failed decides, else the call."""
        before = self.tests.get(name)
        if outcome == "failed" or before is None or (before != "failed" and phase == "call"):
            self.tests[name] = outcome

    def write(self, path: Path) -> None:
        """Write to a file."""
        path.write_text(json.dumps({"status": self.status, "tests": self.tests}))

    @classmethod
    def read(cls, path: Path) -> Outcomes:
        """Read what `write` has written; raises `OutcomesError`."""
        try:
            content = json.loads(path.read_text())
            return cls(content["status"], content["tests"])
        except (OSError, ValueError, KeyError, TypeError) as error:
            raise OutcomesError("the run of the tests did not come to its end") from error


class _Recorder:
    """The plugin: collects outcomes in the process that reports them, also those of the workers of pytest-xdist."""

    def __init__(self, path: Path) -> None:
        self._path = path
        self._outcomes = Outcomes()

    def pytest_runtest_logreport(self, report: pytest.TestReport) -> None:
        self._outcomes.add(report.nodeid, report.outcome, report.when)

    def pytest_collectreport(self, report: pytest.CollectReport) -> None:
        if report.failed:
            self._outcomes.add(report.nodeid, "failed", "collect")

    def pytest_sessionfinish(self, exitstatus: int) -> None:
        self._outcomes.status = int(exitstatus)
        self._outcomes.write(self._path)


def pytest_addoption(parser: pytest.Parser) -> None:
    """Add the option."""
    parser.addoption("--outcomes", type=Path, metavar="FILE", help="write how each test ended, as JSON")


def pytest_configure(config: pytest.Config) -> None:
    """Record what this process reports; workers report to another one."""
    path: Path | None = config.getoption("--outcomes")
    if path is not None and not hasattr(config, "workerinput"):
        config.pluginmanager.register(_Recorder(path.absolute()))


# --- the run of a stage -------------------------------------------------------------------------------------------


def judge(first: Outcomes, second: Outcomes) -> tuple[list[str], list[str]]:
    """Of the tests that failed in the first run: those that passed in the second one, and those that did not.

    A test that is skipped in the second run, or is not in it, has not passed.
    """
    passed = [name for name in first.failed if second.tests.get(name) == "passed"]
    return passed, [name for name in first.failed if name not in passed]


def run_stage(stage: str, target: str, record: Path) -> int:
    """Run `make TARGET`, and the tests that failed in it once more; returns the exit status."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "first.json"
        make = ["make", target, f"PYTEST_ARGS=--outcomes {path} {os.environ.get('PYTEST_ARGS', '')}"]
        made = subprocess.run(make, check=False)
        if made.returncode == 0:
            return 0
        try:
            first = Outcomes.read(path)
        except OutcomesError as error:
            return _fail(f"{stage}: {error}")
        if first.status != TESTS_FAILED or not first.failed:
            return _fail(f"{stage}: pytest ended with {first.status}, which is not that of tests that failed")
        print("== once more, one after the other: the tests that failed", flush=True)
        again = Path(folder) / "second.json"
        command = [".venv/bin/pytest", "-n", "0", "-m", "", "--outcomes", str(again), *first.failed]
        subprocess.run(command, check=False)
        try:
            passed, failed = judge(first, Outcomes.read(again))
        except OutcomesError as error:
            return _fail(f"{stage}, second try: {error}")
    with record.open("a") as file:
        file.writelines(f"{stage}: {name}\n" for name in passed)
    return _fail(f"{stage}: failed at the second try, too:", *failed) if failed else 0


def _fail(*lines: str) -> int:
    print("\n  ".join(lines), file=sys.stderr, flush=True)
    return 1


# --- the report ---------------------------------------------------------------------------------------------------


def report(record: Sequence[str]) -> tuple[list[str], int]:
    """Lines about the tests of all stages that passed only at the second try, and the exit status."""
    if not record:
        return ["== no test passed only at the second try"], 0
    lines = [f"== passed only at the second try: {len(record)}; at most {MAX_SECOND_TRIES} may", *record]
    return lines, int(len(record) > MAX_SECOND_TRIES)


def main(arguments: Sequence[str] | None = None) -> int:
    """Run a stage, or print the report."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    verbs = parser.add_subparsers(dest="verb", required=True)
    stage = verbs.add_parser("stage", help="make TARGET, and then the tests that failed")
    stage.add_argument("name", help="of the stage, for the record")
    stage.add_argument("target")
    for verb in (stage, verbs.add_parser("report", help="print the record of all stages")):
        verb.add_argument("record", type=Path)
    options = parser.parse_args(arguments)
    if options.verb == "stage":
        return run_stage(options.name, options.target, options.record)
    lines, status = report(options.record.read_text().splitlines())
    print("\n".join(lines))
    return status


if __name__ == "__main__":
    raise SystemExit(main())
