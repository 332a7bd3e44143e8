"""`jauspy cell trial`: one trial in the style of ARIAC 2023, from a file, and tables of many."""

from __future__ import annotations

from dataclasses import asdict
from typing import TYPE_CHECKING, Annotated

import typer

from jauspy.cli import console
from jauspy.cli.cell.options import Exact, Record, Seed, View, check_extra
from jauspy.cli.options import Json
from jauspy.cli.processes import run

if TYPE_CHECKING:
    from collections.abc import Sequence

    from rich.table import Table

    from jauspy.cell.measurements import Measured


def trial(
    file: Annotated[
        str, typer.Argument(metavar="TRIAL", help="A TOML file, or the name of a trial that comes with jauspy.")
    ] = "10_everything",
    *,
    seed: Seed = 0,
    exact: Exact = False,
    record: Record = None,
    view: View = False,
    json: Json = False,
) -> None:
    """Fill kitting orders of a trial with changes and faults, scored by the rules of ARIAC 2023.

    The file has orders, changes of orders, and challenges: parts that lie upside down, are faulty or missing, a gripper
    that loses parts, a part sensor that is blind for a while, a belt whose speed changes. Exit status 1 unless all
    points were reached, in the order of priority.

    Example:
      jauspy cell trial 10_everything --seed 7
    """
    check_extra()
    from jauspy.cell.ariac.runner import run_trial
    from jauspy.cell.ariac.trial_file import load
    from jauspy.cell.session import UNDISTURBED
    from jauspy.cli.cell.tables import values_table

    wanted = load(file)
    found = run(run_trial(wanted, seed, UNDISTURBED if exact else None, film=record, view=view))
    if found is None:
        return
    if json:
        console.print_json(asdict(found))
    else:
        console.stdout(140).print(values_table(found))
        if found.failure:
            console.error(f"{wanted.name}: {found.failure}")
        if found.film_problem:
            console.error(found.film_problem)
    if not found.success or found.film_problem:
        raise typer.Exit(1)


def summary_tables(results: Sequence[Measured]) -> list[Table]:
    """Tables of many trials: by trial, and by challenge."""
    from rich.table import Table

    from jauspy.cell.ariac.summary import by_challenge, by_trial

    trials = Table(title="by trial", title_justify="left")
    for heading in ("trial", "challenges", "succeeded", "score", "of", "time, s", "trial score"):
        trials.add_column(heading)
    for row in by_trial(results):
        figures = (f"{row.score:.2f}", f"{row.most:.0f}", f"{row.duration:.1f}", f"{row.trial_score:.2f}")
        trials.add_row(row.trial, ", ".join(row.challenges), f"{row.successes} of {row.runs}", *figures)
    challenges = Table(title="by challenge", title_justify="left")
    challenges.add_column("challenge")
    challenges.add_column("succeeded")
    for challenge, (runs, successes) in by_challenge(results).items():
        challenges.add_row(challenge, f"{successes} of {runs}")
    return [trials, challenges]
