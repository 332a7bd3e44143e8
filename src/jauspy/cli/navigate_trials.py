"""`jauspy navigate-trials`: many drives to goals in simulated worlds, and how many are reached without a touch."""

from __future__ import annotations

from importlib.util import find_spec
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Final

import typer

from jauspy.cli import console
from jauspy.cli.options import ClusterOption, Json
from jauspy.cli.progress import with_progress
from jauspy.errors import ConfigError

if TYPE_CHECKING:
    from jauspy.navigation_trials.results import Drive, TrialPlan, TrialResults

WORLDS: Final = ("yard", "street", "house")
OUTPUT: Final = Path("navigate_out")
RESULTS: Final = "navigate-trials.json"
PLOT: Final = "navigate-trials.svg"
EXTRAS: Final = {"planning": ("numpy", "scipy", "pydantic"), "sim": ("mujoco",)}


def navigate_trials(
    *,
    world: Annotated[
        list[str] | None,
        typer.Option(
            "--world",
            metavar="NAME|FILE",
            help="A world of the simulation; may be repeated. Default: yard, street and house.",
        ),
    ] = None,
    goals: Annotated[int, typer.Option("--goals", min=1, max=100_000, metavar="N", help="Goals in each world.")] = 50,
    seed: Annotated[
        int, typer.Option("--seed", min=0, max=1 << 53, metavar="N", help="The same seed draws the same goals.")
    ] = 1,
    group: Annotated[
        int,
        typer.Option(
            "--group",
            min=1,
            max=100_000,
            metavar="N",
            help="Goals to which a robot drives one after the other before it begins anew: the unit of work.",
        ),
    ] = 5,
    moved: Annotated[bool, typer.Option("--moved", help="Put a thing into the way of each drive.")] = False,
    again: Annotated[
        bool,
        typer.Option("--again", help="Drive to the goals of each group once more, with the map of the first drives."),
    ] = False,
    blind: Annotated[bool, typer.Option("--blind", help="Without the depth camera: the lidar alone.")] = False,
    jobs: Annotated[
        int | None,
        typer.Option("--jobs", "-j", min=1, metavar="N", help="Parallel processes. Default: one per core."),
    ] = None,
    cluster: ClusterOption = None,
    resume: Annotated[
        bool,
        typer.Option("--resume", help="Keep the results in DIR of an interrupted run, or of one with fewer goals."),
    ] = False,
    need: Annotated[
        float,
        typer.Option(
            "--need", min=0.0, max=1.0, help="Exit status 1 when the fraction of goals that are reached is below this."
        ),
    ] = 0.95,
    out: Annotated[Path, typer.Option("-o", "--output", metavar="DIR", help="Directory of results and plot.")] = OUTPUT,
    as_json: Json = False,
) -> None:
    """Drive inc1 to many goals in simulated worlds, and report how many it reaches without touching anything.

    The robot navigates as with `jauspy navigate`: over JAUS, with its lidar, a depth camera and its localisation with
    their errors, in MuJoCo on virtual time. Goals are drawn of those that a search on the true map reaches; the way
    driven is compared with the shortest one there. Groups of goals do not depend on each other: they are driven in
    parallel, results are written after each, and neither the number of processes nor --resume changes which goals are
    driven from where each group starts. With --again a robot that begins anew with the map of these drives is sent to
    the same goals; its drives are a line of their own. Writes DIR/navigate-trials.json and DIR/navigate-trials.svg, a
    plot.

    Exit status: 0 enough goals were reached and nothing was touched, 1 otherwise, 2 wrong use.

    Examples:
      jauspy navigate-trials --world yard --goals 10 --jobs 2
      jauspy navigate-trials --moved --cluster tcp://10.0.0.1:8786 --resume
    """
    try:
        _check_packages()
        from jauspy.navigation_trials.results import TrialPlan

        plan = TrialPlan(
            tuple(dict.fromkeys(world or WORLDS)), goals, seed, moved=moved, blind=blind, group=group, again=again
        )
        results = _run(plan, out, jobs=jobs, cluster=cluster, resume=resume)
    except ConfigError as error:
        console.error(str(error))
        raise typer.Exit(2) from None
    from jauspy.navigation_trials.report import lines, plot, reported
    from jauspy.navigation_trials.results import write_trials

    report = reported(results)
    write_trials(out / RESULTS, results, report.values())
    plot(results, report, out / PLOT)
    if as_json:
        console.print_json(report.values())
    else:
        console.print_lines(*lines(report))
    if not report.is_good(need):
        raise typer.Exit(1)


def _check_packages() -> None:
    """Raise `ConfigError` for what the trials and their plot need, before they begin."""
    for extra, packages in EXTRAS.items():
        if missing := [name for name in packages if find_spec(name) is None]:
            raise ConfigError(f"navigate-trials needs {' and '.join(missing)}: pip install 'jauspy[{extra}]'")
    from jauspy.plots import check_plots

    check_plots()


def _run(plan: TrialPlan, out: Path, *, jobs: int | None, cluster: str | None, resume: bool) -> TrialResults:
    """The results of all groups; they are written after each. Raises `ConfigError`."""
    from jauspy.navigation_trials.groups import run_trials
    from jauspy.navigation_trials.results import TrialResults, resumed, write_trials

    path = out / RESULTS
    results = resumed(path, plan) if resume and path.exists() else TrialResults(plan, ())
    try:
        out.mkdir(parents=True, exist_ok=True)
        write_trials(path, results)
    except OSError as error:
        raise ConfigError(f"{path}: cannot be written: {error.strerror}; give another --output") from None
    groups = results.missing()
    found = run_trials(plan, groups, jobs=jobs, cluster=cluster)
    for drives in with_progress("groups of goals", len(groups), found, _failures):
        results = results.with_drives(drives)
        write_trials(path, results)
    return results


def _failures(drives: list[Drive]) -> int:
    return sum(not drive.reached or bool(drive.contacts) for drive in drives)
