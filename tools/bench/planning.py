"""Plans of arms among boxes: solved share, time, path length beside a long search, contacts and clearance by MuJoCo.

python tools/bench/planning.py [--scenes 20] [--first 0] [--arm inc1] [--limit 1] [--long-search 5] [--compared 5]
                               [--jobs 1] [--rows FILE] [--json]

Scenes are seeded: 5 to 30 boxes around inc1's arm, the UR10 of the cell and an arm of seven joints; goals are
postures and poses of the tool in turn. Times are of one core's processor time. What is not solved within `--limit` is
searched for `--long-search` seconds, until a way is found; `--compared` scenes of each arm are searched that long for
the shortest way, and by OMPL as it is by default. With `--rows` each result is added to a file as a line of JSON, and
a run that was interrupted goes on where it ended. 1,000 scenes:

python tools/bench/planning.py --scenes 334 --long-search 60 --compared 20 --jobs 2 --rows planning.jsonl
"""

from __future__ import annotations

import argparse
import json
import math
import multiprocessing
import os
import sys
from collections import Counter
from collections.abc import Iterator
from concurrent.futures import ProcessPoolExecutor, as_completed
from pathlib import Path
from typing import Any

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
sys.path[:0] = [str(Path(__file__).parents[2]), str(Path(__file__).parent)]

import numpy as np  # noqa: E402 - after the number of threads and the path
from _planning_scenes import ARMS, Work, run  # noqa: E402

Row = dict[str, Any]


def main() -> None:
    """Plan, and print one paragraph for each arm."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--scenes", type=int, default=20, help="scenes of each arm")
    parser.add_argument("--first", type=int, default=0, help="seed of the first")
    parser.add_argument("--arm", choices=list(ARMS), action="append", help="arms, default all")
    parser.add_argument("--limit", type=float, default=1.0, help="seconds of a plan on the wall clock")
    parser.add_argument("--long-search", type=float, default=5.0, help="seconds of the long search")
    parser.add_argument("--compared", type=int, default=5, help="scenes of each arm that are searched long in any case")
    parser.add_argument("--jobs", type=int, default=1, help="processes")
    parser.add_argument("--rows", type=Path, help="file for one line of JSON for each scene; is continued")
    parser.add_argument("--json", action="store_true", help="print the results as JSON")
    options = parser.parse_args()
    step = max(1, options.scenes // max(1, options.compared))
    work = [
        Work(
            arm,
            options.first + number,
            options.limit,
            options.long_search,
            number % step == 0 and bool(options.compared),
        )
        for arm in options.arm or ARMS
        for number in range(options.scenes)
    ]
    rows = _known(options.rows, work) if options.rows else []
    done = {(row["arm"], row["seed"]) for row in rows}
    for row in _results([one for one in work if (one.arm, one.seed) not in done], options.jobs):
        rows.append(row)
        if options.rows:
            with options.rows.open("a") as file:
                file.write(json.dumps(row) + "\n")
        if sys.stderr.isatty():
            print(f"\r{len(rows)} of {len(work)} scenes", end="", file=sys.stderr, flush=True)
    found = [_summary(name, [row for row in rows if row["arm"] == name]) for name in options.arm or ARMS]
    print(json.dumps(found, indent=2) if options.json else "\n".join(map(_in_words, found)))


def _known(file: Path, work: list[Work]) -> list[Row]:
    """The rows of an earlier run with the same settings; a line that was cut off is removed."""
    settings = {"limit": work[0].limit, "long_search": work[0].long_search}
    lines = file.read_text().splitlines() if file.exists() else []
    rows = []
    for number, line in enumerate(lines):
        try:
            rows.append(json.loads(line))
        except ValueError:
            if number + 1 < len(lines):
                sys.exit(f"{file}, line {number + 1} is no JSON; give another file with --rows")
    if rows and rows[0] != settings:
        sys.exit(f"{file} was made with {rows[0]}, not {settings}; give another file with --rows, or the same settings")
    file.write_text("".join(json.dumps(row) + "\n" for row in rows or [settings]))
    wanted = {(one.arm, one.seed): one.is_compared for one in work}
    return [
        row
        for row in rows[1:]
        if (key := (row["arm"], row["seed"])) in wanted and ("default" in row or not wanted[key])
    ]


def _results(work: list[Work], jobs: int) -> Iterator[Row]:
    if jobs <= 1:
        yield from map(run, work)
        return
    with ProcessPoolExecutor(jobs, mp_context=multiprocessing.get_context("spawn")) as pool:
        for future in as_completed([pool.submit(run, one) for one in work]):
            yield future.result()


def _summary(name: str, rows: list[Row]) -> dict[str, Any]:
    """The figures of an arm: times in milliseconds, distances in millimetres."""
    solved = [row for row in rows if row["reason"] is None]
    lost = [row for row in rows if row["reason"] is not None]
    possible = [row for row in lost if row["best"] is not None]
    times = 1000.0 * np.array([row["seconds"] for row in solved])
    ratios = [row["length"] / row["best"] for row in solved if row.get("best")]
    defaults = [row["default"] for row in rows if "default" in row]
    by_default = [one for one in defaults if one]
    least = [
        1000.0 * min(row[key] for row in solved) if solved else math.nan for key in ("clearance", "clearance_by_mujoco")
    ]
    return {
        "arm": name,
        "scenes": len(rows),
        "solved": len(solved),
        "by_long_search": len(possible),
        "share": len(solved) / max(1, len(solved) + len(possible)),
        "p50": _percentile(times, 50),
        "p95": _percentile(times, 95),
        "longest": _percentile(times, 100),
        "postures_in_contact": sum(row["contacts"] for row in solved),
        "least_clearance": least[0],
        "least_clearance_by_mujoco": least[1],
        "compared": len(ratios),
        "ratio_p50": _percentile(ratios, 50),
        "ratio_p95": _percentile(ratios, 95),
        "ratio_within": float(np.mean(np.array(ratios) <= 1.3)) if ratios else math.nan,
        "straight_touches": sum(row["straight_touches"] for row in rows),
        "defaults": len(defaults),
        "defaults_solved": len(by_default),
        "defaults_p50": _percentile([1000.0 * one["seconds"] for one in by_default], 50),
        "reasons": dict(Counter(row["reason"] for row in lost)),
        "slowest_refusal": _percentile([1000.0 * row["wall"] for row in lost], 100),
    }


def _percentile(values: Any, share: float) -> float:
    return float(np.percentile(values, share)) if len(values) else math.nan


def _in_words(found: dict[str, Any]) -> str:
    lines = [
        "{arm}: {scenes} scenes, {solved} solved, {by_long_search} more by the long search: {share:.1%}",
        "  time p50 {p50:.0f} ms, p95 {p95:.0f} ms, longest {longest:.0f} ms",
        "  by MuJoCo: {postures_in_contact} postures in contact, least clearance {least_clearance_by_mujoco:.1f} mm",
        "  least clearance by the planner's own check: {least_clearance:.1f} mm",
        "  length beside the long search's best, {compared} scenes: median {ratio_p50:.2f}, p95 {ratio_p95:.2f}",
        "  length at most 1.3 times the best: {ratio_within:.0%}; straight motions touch in {straight_touches} scenes",
        "  OMPL by default, {defaults} scenes: {defaults_solved} solved, median {defaults_p50:.0f} ms",
    ]
    if found["reasons"]:
        reasons = ", ".join(f"{count} {name}" for name, count in found["reasons"].items())
        lines.append(f"  not solved: {reasons}; said after at most {{slowest_refusal:.0f}} ms on the wall clock")
    return "\n".join(lines).format(**found)


if __name__ == "__main__":
    main()
