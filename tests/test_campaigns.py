"""Campaigns in processes: all parts are done, an error or a killed process ends them in one sentence."""

from __future__ import annotations

import os
import signal
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


@pytest.mark.slow
def test_a_killed_process_is_an_error_that_says_how_to_continue() -> None:
    with pytest.raises(ConfigError, match="was killed, perhaps for want of memory; use --resume"):
        list(run_parts(ends, range(3), jobs=2))
