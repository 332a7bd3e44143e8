"""Attack: `python -m tools.attack [--seconds 600] [--seed 1] [--only NAME ...] [--write docs/security.md]`.

With `--mutant NAME` the victims have this defect, and the exit status is 0 when the attacks notice it.

Each attack has an equal share of the time, and for a given seed always the same bytes. The exit status is 1 when a
victim did not keep a bound; each is reported in one sentence.
"""

from __future__ import annotations

import argparse
import contextlib
import os
import shutil
import sys
import tempfile
import time
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Final

import jauspy

from . import hosts, table
from .arena import Arena
from .attack import Attack, BoundBroken, Layout, NotPossible, NotStarted, Result
from .attacks import ALL
from .hosts import Lan
from .mutants import MUTANTS
from .stage import Stage

MIN_SECONDS: Final = 1.0
"""Seconds of each attack at least."""
SETTLE_SECONDS: Final = 2.0
"""Seconds for one attack in which victims start, and are measured."""


def main() -> int:
    """Run the attacks; 0 if all bounds were kept."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--seconds", type=float, default=600.0, help="for all attacks together")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--only", nargs="*", choices=[each.name for each in ALL], metavar="NAME", help="these attacks")
    parser.add_argument("--list", action="store_true", help="print the names of all attacks")
    parser.add_argument("--write", type=Path, metavar="FILE", help="write the table between the markers of this file")
    parser.add_argument("--mutant", choices=sorted(MUTANTS), metavar="NAME", help="a defect that the victims have")
    parser.add_argument("--mutants", action="store_true", help="print the names of all mutants, and who notices them")
    parser.add_argument("--keep", action="store_true", help="keep the folders with the logs of the victims")
    options = parser.parse_args()
    if options.list:
        print(*(f"{each.name:24} {each.attacker.value}" for each in ALL), sep="\n")
        return 0
    if options.mutants:
        print(*(f"{name:24} {', '.join(each.noticed_by)}" for name, each in MUTANTS.items()), sep="\n")
        return 0
    only = options.only or (MUTANTS[options.mutant].noticed_by if options.mutant else ())
    chosen = [each for each in ALL if not only or each.name in only]
    load = os.getloadavg()[1]
    with hosts.lan() as lan:
        if lan.why_loopback:
            print(f"on the loopback interface, because {lan.why_loopback}")
        share = max(MIN_SECONDS, options.seconds / len(chosen) - SETTLE_SECONDS)
        results = run(chosen, lan, share, options.seed, keep=options.keep, mutant=options.mutant or "")
        network = "on the loopback interface" if lan.why_loopback else "in network namespaces"
    if options.write is not None:
        machine = f"{os.cpu_count()} processors with a load of {load:.1f} by others"
        circumstances = table.Run(options.seconds, options.seed, network, jauspy.__version__, machine)
        table.write(options.write, table.as_markdown(results, circumstances))
    print(table.as_text(results))
    broken = [sentence for result in results for sentence in result.broken]
    if options.mutant:
        noticed = "; ".join(broken) or "nothing was noticed"
        print(f"mutant {options.mutant}: {noticed}")
        return 0 if broken else 1
    print(*broken, sep="\n", file=sys.stderr)
    return 1 if broken else 0


def run(
    attacks: Sequence[Attack], lan: Lan, seconds: float, seed: int, *, keep: bool, mutant: str = ""
) -> list[Result]:
    """Run one attack after the other, each for so many seconds."""
    results: list[Result] = []
    with contextlib.ExitStack() as stack:
        stage: Stage | None = None
        for attack in attacks:
            begin, result = time.monotonic(), Result(attack)
            try:
                if stage is None or stage.layout != attack.layout:
                    stack.close()
                    stage = stack.enter_context(new_stage(attack.layout, lan, keep=keep, mutant=mutant))
                run_one(result, stage, seconds, seed)
            except BoundBroken as error:
                if mutant and isinstance(error, NotStarted):
                    sys.exit(f"mutant {mutant}: {error}")  # which no attack has noticed
                result.broken.append(str(error))
            except NotPossible as error:
                result.skipped = str(error)
            if result.broken or attack.restarts:
                stage = None
            results.append(result)
            how = result.skipped or "; ".join(result.broken) or "bounds kept"
            print(f"{attack.name:24} {time.monotonic() - begin:5.1f} s  {how}", flush=True)
    return results


@contextlib.contextmanager
def new_stage(layout: Layout, lan: Lan, *, keep: bool, mutant: str = "") -> Iterator[Stage]:
    """Fresh victims, with a folder of their own."""
    folder = Path(tempfile.mkdtemp(prefix="ja"))
    try:
        with Stage(layout, lan, folder, mutant) as stage:
            yield stage
    finally:
        if keep:
            print(f"logs in {folder}")
        else:
            shutil.rmtree(folder, ignore_errors=True)


def run_one(result: Result, stage: Stage, seconds: float, seed: int) -> None:
    """Run one attack, and fill in the result."""
    arena = Arena(result.attack, stage, seconds, seed)
    try:
        result.attack.run(arena)
        result.asked, result.lost, result.silence, growth = arena.measure()
        result.motion = arena.motion
    finally:
        result.sent = arena.sent
        arena.close()
    result.memory = max([arena.memory, *(each.memory for each in growth)])
    result.descriptors = sum(max(0, each.descriptors) for each in growth)
    result.tasks = sum(max(0, each.tasks) for each in growth)
    result.lines = sum(each.lines for each in growth)
    result.compare()
    if result.broken and (drops := arena.drops()):
        result.broken.append(f"{result.attack.name}: the node manager has dropped meanwhile: {drops}")


if __name__ == "__main__":
    sys.exit(main())
