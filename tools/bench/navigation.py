"""How well inc1 finds its way in simulated worlds: goals reached, contacts, length of the way driven.

python tools/bench/navigation.py [--world yard street house] [--goals 50] [--seed 1] [--moved] [--blind] [--json FILE]
    [--jobs N]

The table of `jauspy navigate-trials` (docs/planning.md), of which this is the short way; --json writes the drives of
which it was made. Exit status 1 if less than 95 % of the goals were reached, or something was touched.
"""

from __future__ import annotations

import argparse
import sys
from pathlib import Path

from jauspy.navigation_trials.groups import run_trials
from jauspy.navigation_trials.report import lines, reported
from jauspy.navigation_trials.results import TrialPlan, TrialResults, write_trials

NEED = 0.95
"""Part of the goals that are to be reached."""


def main() -> None:
    """Print a table of the worlds, with what failed and why."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--world", nargs="+", default=["yard", "street", "house"])
    parser.add_argument("--goals", type=int, default=50)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--moved", action="store_true")
    parser.add_argument("--blind", action="store_true")
    parser.add_argument("--json", type=Path)
    parser.add_argument("--jobs", type=int)
    options = parser.parse_args()
    plan = TrialPlan(tuple(options.world), options.goals, options.seed, moved=options.moved, blind=options.blind)
    results = TrialResults(plan, ())
    for drives in run_trials(plan, results.missing(), jobs=options.jobs):
        results = results.with_drives(drives)
        if options.json is not None:
            write_trials(options.json, results)
    report = reported(results)
    print("\n".join(lines(report)))
    sys.exit(not report.is_good(NEED))


if __name__ == "__main__":
    main()
