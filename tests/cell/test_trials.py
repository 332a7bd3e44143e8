"""Many runs of a task: their order, their summary, and a cluster that does not answer."""

from __future__ import annotations

import math
from pathlib import Path

import pytest
from hypothesis import given, strategies as st

from jauspy.campaigns import wilson
from jauspy.cell import trials
from jauspy.cell.measurements import Measured, figure_text
from jauspy.cell.session import Disturbances
from jauspy.cell.trials import mean_of, read_results, run_trials, summarised, write_results

COUNTS = st.integers(1, 400).flatmap(lambda runs: st.tuples(st.integers(0, runs), st.just(runs)))


@given(COUNTS)
def test_the_interval_contains_the_rate_and_lies_between_none_and_all(counts: tuple[int, int]) -> None:
    successes, runs = counts
    low, high = wilson(successes, runs)
    assert 0.0 <= low <= successes / runs + 1e-12
    assert successes / runs - 1e-12 <= high <= 1.0
    assert low < high


@given(COUNTS)
def test_the_interval_of_failures_mirrors_that_of_successes(counts: tuple[int, int]) -> None:
    successes, runs = counts
    low, high = wilson(successes, runs)
    assert wilson(runs - successes, runs) == pytest.approx((1.0 - high, 1.0 - low), abs=1e-9)


@given(COUNTS)
def test_more_runs_with_the_same_rate_say_more(counts: tuple[int, int]) -> None:
    successes, runs = counts
    low, high = wilson(successes, runs)
    closer = wilson(4 * successes, 4 * runs)
    assert closer[1] - closer[0] < high - low


def run(seed: int, *, success: bool = True, duration: float = 10.0, cpu: float = 2.0, **values: float) -> Measured:
    reason = "" if success else f"no box {seed}"
    return Measured(seed, "lift", success=success, failure=reason, duration=duration, cpu=cpu, values=values)


def test_the_summary_does_not_depend_on_the_order_in_which_results_come() -> None:
    results = [run(3, duration=8.0), run(1, success=False, duration=30.0), run(2, duration=12.0), run(0, duration=9.0)]
    found = summarised(results)
    assert found == summarised(results[::-1])
    assert (found.task, found.runs, found.successes, found.rate) == ("lift", 4, 3, 0.75)
    assert (found.duration, found.longest) == (9.0, 12.0), "of the successful ones"
    assert found.speed == pytest.approx((8.0 + 30.0 + 12.0 + 9.0) / 8.0)
    assert found.cpu == 2.0
    assert found.failures == ((1, "no box 1"),)


def test_without_a_success_there_is_no_duration() -> None:
    found = summarised([run(1, success=False)])
    assert math.isnan(found.duration)
    assert math.isnan(found.longest)
    assert found.rate == 0.0


def test_without_runs_nothing_is_claimed() -> None:
    found = summarised([])
    assert (found.runs, found.rate, found.low, found.high) == (0, 0.0, 0.0, 1.0)
    assert math.isnan(found.speed)


def test_the_mean_is_that_of_the_runs_that_have_the_figure() -> None:
    assert mean_of([run(1, lift_time=2.0), run(2, lift_time=4.0), run(3)], "lift_time") == 3.0
    assert math.isnan(mean_of([run(1)], "lift_time"))


def test_one_process_runs_the_seeds_in_order(monkeypatch: pytest.MonkeyPatch) -> None:
    asked: list[tuple[str, int, Disturbances | None]] = []

    def run_seed(task: str, disturbances: Disturbances | None, seed: int) -> Measured:
        asked.append((task, seed, disturbances))
        return run(seed)

    monkeypatch.setattr(trials, "run_seed", run_seed)
    mild = Disturbances(0.001, 0.0, 0.0)
    assert [each.seed for each in run_trials("lift", range(3), mild, jobs=1)] == [0, 1, 2]
    assert asked == [("lift", 0, mild), ("lift", 1, mild), ("lift", 2, mild)]
    assert [each.seed for each in run_trials("lift", [7])] == [7], "one run needs no other process"


def test_an_interrupted_write_leaves_the_results(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    path = tmp_path / "trials-lift.json"
    write_results(path, [run(2), run(1)])
    assert [row.seed for row in read_results(path)] == [1, 2]

    def full(path: Path, text: str) -> None:
        path.write_bytes(text[:20].encode())
        raise OSError("no space left")

    monkeypatch.setattr(Path, "write_text", full)
    with pytest.raises(OSError, match="no space"):
        write_results(path, [run(3)])
    assert [row.seed for row in read_results(path)] == [1, 2]


@pytest.mark.parametrize(
    ("name", "value", "text"),
    [
        ("ap UR10", 0.2, "0.2 m"),
        ("rp angle UR10", math.radians(2.0), "2 degrees"),
        ("clearance", -0.002, "-2 mm"),
        ("off_x", 0.0, "0 mm"),
        ("release_speed", 3.14159, "3.14 m/s"),
        ("car_force", 21.0, "21 N"),
        ("arm_moment", 1.5, "1.5 N m"),
        ("arm_error", 0.0, "0 degrees"),
        ("arm_motions", 4.0, "4"),
        ("payload", 0.3, "0.3 kg"),
        ("improvement", 12.34, "12.3"),
    ],
)
def test_figures_for_people(name: str, value: float, text: str) -> None:
    assert figure_text(name, value) == text
