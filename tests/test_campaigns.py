"""Campaigns in processes: all parts are done, an error or a killed process ends them in one sentence."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import threading
import time
from pathlib import Path

import pytest

from jauspy.campaigns import run_parts
from jauspy.errors import ConfigError


def squared(number: int) -> int:
    return number * number


def ends(number: int) -> int:
    os.kill(os.getpid(), signal.SIGKILL)
    return number


def noted(part: tuple[int, str]) -> int:
    """Fails at the first part; notes the others."""
    number, folder = part
    if number == 0:
        raise ConfigError("the first one fails")
    (Path(folder) / str(number)).touch()
    return number


@pytest.mark.slow
@pytest.mark.parametrize("jobs", [1, 2])
def test_the_number_of_processes_does_not_change_the_results(jobs: int) -> None:
    assert sorted(run_parts(squared, range(6), jobs=jobs)) == [0, 1, 4, 9, 16, 25]


def test_one_part_or_one_job_needs_no_other_process() -> None:
    own = os.getpid()
    assert list(run_parts(lambda _: os.getpid(), [1], jobs=4)) == [own]
    assert list(run_parts(lambda _: os.getpid(), [1, 2], jobs=1)) == [own, own]
    assert list(run_parts(squared, [])) == []


@pytest.mark.slow
def test_an_error_ends_the_campaign_before_the_other_parts_are_begun(tmp_path: Path) -> None:
    with pytest.raises(ConfigError, match="the first one fails"):
        list(run_parts(noted, [(number, str(tmp_path)) for number in range(500)], jobs=2))
    assert len(list(tmp_path.iterdir())) < 499


def waits(part: tuple[int, str]) -> int:
    """Fails at the first part, once another one has been begun, which takes longer than a test; notes its process."""
    number, folder = part
    if number:
        (Path(folder) / str(os.getpid())).touch()
        threading.Event().wait(300.0)
    while not list(Path(folder).iterdir()):
        threading.Event().wait(0.01)
    raise ConfigError("the first one fails")


def has_ended(process: int) -> bool:
    """True if a process that may be a zombie does not run any more."""
    try:
        return Path(f"/proc/{process}/stat").read_text().rpartition(")")[2].split()[0] == "Z"
    except FileNotFoundError:
        return True


@pytest.mark.slow
def test_an_error_ends_the_parts_that_were_begun(tmp_path: Path) -> None:
    with pytest.raises(ConfigError, match="the first one fails"):
        list(run_parts(waits, [(number, str(tmp_path)) for number in range(2)], jobs=2))
    assert has_ended(int(next(tmp_path.iterdir()).name))


@pytest.mark.slow
def test_processes_end_with_a_parent_that_is_killed(tmp_path: Path) -> None:
    code = (
        "from tests.test_campaigns import run_parts, waits\n"
        f"if __name__ == '__main__': list(run_parts(waits, [(1, {str(tmp_path)!r}), (2, {str(tmp_path)!r})], jobs=2))"
    )
    parent = subprocess.Popen([sys.executable, "-c", code], cwd=Path(__file__).parents[1])
    end = time.monotonic() + 60.0
    while len(list(tmp_path.iterdir())) < 2 and time.monotonic() < end:
        threading.Event().wait(0.05)
    parent.kill()
    parent.wait()
    workers = [int(path.name) for path in tmp_path.iterdir()]
    assert len(workers) == 2
    while not all(has_ended(worker) for worker in workers) and time.monotonic() < end:
        threading.Event().wait(0.05)
    assert all(has_ended(worker) for worker in workers)


@pytest.mark.slow
def test_a_killed_process_is_an_error_that_says_how_to_continue() -> None:
    with pytest.raises(ConfigError, match="was killed, perhaps for want of memory; use --resume"):
        list(run_parts(ends, range(3), jobs=2))
