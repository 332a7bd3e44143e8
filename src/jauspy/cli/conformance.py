"""`jauspy conformance`: test a robot or component against a standard."""

from __future__ import annotations

import os
import sys
from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Annotated, Final

import typer
from rich.table import Table
from rich.text import Text

from jauspy.cli import console
from jauspy.cli.conformance_campaign import Campaign, Plan, run_campaign
from jauspy.cli.conformance_runs import (
    Target,
    chosen_profile,
    is_urn,
    named_offers,
    parse_targets,
    report_of,
    steps_of,
)
from jauspy.cli.definitions import SchemasOption, definitions
from jauspy.cli.options import ClusterOption, Json, Peer
from jauspy.cli.processes import stoppable
from jauspy.conformance import reports
from jauspy.conformance.profile import Step, find, known
from jauspy.conformance.reports import explanation, result_json, summary, summary_json, totals_json, transcript
from jauspy.conformance.results import Report, Result, Verdict, transitions_summary, worst
from jauspy.conformance.runner import Interrupted, OnResult, Settings
from jauspy.errors import ConfigError, JausError

ProfileName = Annotated[
    str | None,
    typer.Argument(
        metavar="PROFILE",
        help="The profile, as in igvc-2015; --list lists them. MODULE:NAME is one of your own. A URN, as in "
        "urn:acme:Winch, tests every transition of this service, which --schemas may define.",
    ),
]
Targets = Annotated[
    list[str] | None,
    typer.Option(
        "--target",
        metavar="ID[@WHERE]",
        help="What to test: 101.1.102 is a component, 101.1.255 all components of a node, 101 those of a robot. May be "
        "repeated, for one report of all; each may have its own --connect after @, as in 101@udp://192.168.1.101.",
    ),
]
Listing = Annotated[bool, typer.Option("--list", help="List the profiles, or the steps of PROFILE, without testing.")]
Where = Annotated[
    str | None,
    typer.Option(
        "--connect",
        metavar="WHERE",
        help="How to reach the target: udp://HOST:PORT, or a node manager at tcp://HOST:PORT or local:DIR. "
        "Default: multicast, even if a node manager runs on this machine.",
    ),
]
Deadline = Annotated[
    float,
    typer.Option(
        "--timeout",
        min=0.01,
        metavar="SECONDS",
        help="How long an answer may take; other waiting times are scaled with it.",
    ),
]
Motion = Annotated[bool, typer.Option("--motion/--no-motion", help="Whether the robot may drive.")]
Only = Annotated[
    list[str] | None,
    typer.Option("--only", metavar="STEP", help="Only steps whose id begins with STEP; may be repeated."),
]
Services = Annotated[
    str | None,
    typer.Option(
        "--services",
        metavar="NAMES",
        help="The services of a component without Discovery, as in Management@1.0,Liveness@1.0; those that they "
        "inherit from are included. Default: the target is asked for its services.",
    ),
]
Junit = Annotated[Path | None, typer.Option("--junit", metavar="FILE", help="Write JUnit XML.")]
Html = Annotated[Path | None, typer.Option("--html", metavar="FILE", help="Write a report as one HTML file.")]
Pcapng = Annotated[
    Path | None,
    typer.Option("--pcapng", metavar="FILE", help="Write the messages sent and received as a capture file."),
]


def conformance(
    *,
    profile: ProfileName = None,
    target: Targets = None,
    list_: Listing = False,
    connect: Where = None,
    timeout: Deadline = 1.5,
    motion: Motion = True,
    only: Only = None,
    services: Services = None,
    json: Json = False,
    junit: Junit = None,
    html: Html = None,
    pcapng: Pcapng = None,
    schemas: SchemasOption = None,
    peer: Peer = None,
    cluster: ClusterOption = None,
) -> None:
    """Test a robot or component of any vendor, step by step.

    The verdict of a step is passed, failed, silent, late, malformed, or skipped with a reason. Exit status: 0 all
    steps passed; 1 a step did not pass; 2 the test could not run; 130 Ctrl-C; 143 SIGTERM. Some profiles make the robot
    drive and shut it down at the end. In every other case the robot is left in Standby, without a controller.

    Without --connect the test uses UDP multicast itself, from port 3794 if that is free.

    Examples:
      jauspy conformance igvc-2015 --target 101.1.255 --html report.html
      jauspy conformance iop-v3 --target 101
      jauspy conformance core-1.1 --target 101.1.102@udp://10.0.0.1 --target 102.1.102@udp://10.0.0.2 --cluster local
      jauspy conformance core-1.1 --target 101.1.102 --connect udp://192.168.1.101
      jauspy conformance core-1.1 --target 126.1.11 --connect local:/tmp --services Management@1.0
      jauspy conformance urn:acme:Winch --target 101.1.120 --schemas Winch.xml
      jauspy conformance acme_steps:PROFILE --target 101.1.120 --schemas acme.xml
      jauspy conformance --list
    """
    if profile is not None and ":" in profile and not is_urn(profile):
        sys.path.append("")  # the user's profile may be in the current directory; last, so that it hides no module
    try:
        defined = definitions(schemas)
        targets = parse_targets(target or (), connect)
        offers = [named_offers(services, one.id, defined.own) for one in targets]
        if list_:
            if profile is None:
                show_list()
            else:
                first, known_offers = (targets[0], offers[0]) if targets else (None, None)
                chosen = chosen_profile(profile, defined.registry)
                show_steps(steps_of(chosen, first, timeout, known_offers, messages=defined.registry))
            return
        if profile is None or not targets:
            raise ConfigError("name a profile and a target, as in `jauspy conformance igvc-2015 --target 101.1.255`")
        files = ReportFiles(junit=junit, html=html, pcapng=pcapng)
        chosen = chosen_profile(profile, defined.registry)
        settings = Settings(timeout, motion, tuple(only or ()))
        with stoppable() as stopped:
            if len(targets) == 1 and cluster is None:
                try:
                    with progress_line() as progress:
                        watch = _print_json if json else progress
                        report = report_of(
                            chosen,
                            targets[0],
                            settings,
                            watch,
                            offers=offers[0],
                            messages=defined.registry,
                            peer=peer,
                        )
                    runs, status = [report], report.status
                except Interrupted as stop:
                    runs, status = [stop.report], stopped()
            else:
                plan = Plan(profile, settings, services, tuple(schemas or ()), peer)
                campaign = _run_all(plan, targets, cluster, json=json)
                runs, status = campaign.reports, stopped() if campaign.is_interrupted else worst(campaign.reports)
            for problem in (unwritten := files.write(runs)):
                console.error(problem)
            with _ignoring_closed_pipe():
                _show(runs, several=len(targets) > 1, json=json)
    except JausError as error:
        console.error(str(error))
        raise typer.Exit(2) from None
    raise typer.Exit(2 if unwritten else status)


def _run_all(plan: Plan, targets: Sequence[Target], cluster: str | None, *, json: bool) -> Campaign:
    """Test several targets; with `json` each step is printed with its target, and each target's summary."""
    with progress_line() as progress:

        def on_result(target: Target, result: Result) -> None:
            if json:
                with _ignoring_closed_pipe():
                    console.print_json({"target": target.id, "connect": target.where} | result_json(result))
            else:
                progress(result)

        def on_report(report: Report) -> None:
            with _ignoring_closed_pipe():
                if json:
                    console.print_json(summary_json(report))
                else:
                    console.note(f"{report.target}: {report.problem or summary(report)}")

        return run_campaign(plan, targets, cluster, on_result=on_result, on_report=on_report)


def _print_json(result: Result) -> None:
    """Print the result of a step as soon as it has ended."""
    with _ignoring_closed_pipe():
        console.print_json(result_json(result))


@contextmanager
def _ignoring_closed_pipe() -> Iterator[None]:
    """Continue the run if the output pipe is closed, to write the files and return the status."""
    try:
        yield
        sys.stdout.flush()
    except BrokenPipeError:
        console.discard_stdout()
    except OSError as error:
        console.discard_stdout()
        raise ConfigError(f"the results cannot be written: {error.strerror}") from error


def _show(runs: Sequence[Report], *, several: bool, json: bool) -> None:
    """Print the reports; with `json` the steps have been printed, and the summary follows."""
    for report in runs:
        if report.problem:
            console.error(f"{report.target}: {report.problem}" if several else report.problem)
        if not json:
            show(report)
    if json and runs:
        console.print_json(totals_json(runs) if several else summary_json(runs[0]))
    elif several:
        show_totals(runs)


@dataclass(frozen=True, slots=True)
class ReportFiles:
    """Where to write each kind of report. Raises `ConfigError` if a file cannot be written."""

    junit: Path | None = None
    html: Path | None = None
    pcapng: Path | None = None

    def __post_init__(self) -> None:
        if self.html is not None:
            reports.html_template()
        kinds: dict[Path, str] = {}
        for kind, path in (("--junit", self.junit), ("--html", self.html), ("--pcapng", self.pcapng)):
            if path is None:
                continue
            if obstacle := _obstacle(path):
                raise ConfigError(f"{path}: cannot be written: {obstacle}")
            if other := kinds.get(path.resolve()):
                raise ConfigError(f"{path} is given for {other} and for {kind}; choose different files")
            kinds[path.resolve()] = kind

    def write(self, runs: Sequence[Report]) -> list[str]:
        """Write the files; returns an error message for each that cannot be written."""
        if not runs:
            return []
        problems = (
            _write(self.junit, lambda: reports.junit(*runs)),
            _write(self.html, lambda: reports.page(*runs).encode()),
            _write(self.pcapng, lambda: reports.capture(*runs)),
        )
        return [problem for problem in problems if problem]


def _obstacle(path: Path) -> str:
    """Why a path cannot be written, as far as can be checked without writing."""
    if path.is_dir():
        return "it is a directory"
    if not path.parent.is_dir():
        return f"there is no directory {path.parent}"
    return "" if os.access(path if path.exists() else path.parent, os.W_OK) else "permission denied"


def _write(path: Path | None, content: Callable[[], bytes]) -> str:
    if path is None:
        return ""
    try:
        path.write_bytes(content())
    except OSError as error:
        return f"{path}: cannot be written: {error.strerror}"
    return ""


_STYLES: Final = {Verdict.PASS: "green", Verdict.SKIPPED: "dim"}
PIPE_WIDTH: Final = 1000
"""Columns of the table in a pipe: one line a step, so that it can be searched."""

MAX_TRAFFIC_LINES: Final = 24
"""Lines of traffic shown for a failed step; the files have all."""


def show(report: Report) -> None:
    """Print the steps as a table, the failures and the summary."""
    out = console.stdout()
    if report.results:
        console.stdout(pipe_width=PIPE_WIDTH).print(_table(report))
    for result in report.failures:
        _explain(result)
    for note in report.notes:
        console.note(note)
    if total := transitions_summary(report):
        rest = (
            "; --json and --html list the others"
            if any(not transition.step for transition in report.transitions)
            else ""
        )
        out.print(Text(f"{total}{rest}", style="dim"))
    style = "bold green" if report.status == 0 else "bold red"
    out.print(Text(f"{report.profile}, {report.target}: {summary(report)}", style=style))


def show_totals(runs: Sequence[Report]) -> None:
    """Print a line for each target."""
    table = Table("target", "seconds", "result", box=None, pad_edge=False, header_style="dim")
    for report in runs:
        style = "green" if report.status == 0 else "red"
        table.add_row(report.target, f"{report.seconds:.1f}", Text(report.problem or summary(report), style=style))
    console.stdout(pipe_width=PIPE_WIDTH).print(table)


def _table(report: Report) -> Table:

    counted = report.points[1] > 0
    table = Table(box=None, pad_edge=False, header_style="dim")
    for header in ("step", "verdict", "ms", *(["points"] if counted else []), "what"):
        table.add_column(header, overflow="fold", justify="right" if header == "ms" else "left")
    for result in report.results:
        reason = f"  {result.reason}" if result.verdict is Verdict.SKIPPED else ""
        table.add_row(
            result.id,
            Text(str(result.verdict), style=_STYLES.get(result.verdict, "red")),
            f"{result.elapsed * 1000:.0f}",
            *([f"{result.earned:g}/{result.points:g}" if result.points else ""] if counted else []),
            Text.assemble(result.title, (reason, "dim")),
        )
    return table


def _explain(result: Result) -> None:

    out = console.stdout()
    out.print(Text(f"\n{result.id} {result.title}: {result.verdict}", style="bold red"))
    out.print(Text(f"  {result.reason}"))
    for line in explanation(result):
        out.print(Text(f"  {line}", style="red" if line.startswith("failed check") else ""))
    if result.why:
        out.print(Text(f"  from: {result.why}"))
    lines = transcript(result)
    for line in lines[-MAX_TRAFFIC_LINES:]:
        out.print(Text(f"  {line}", style="dim"))
    if len(lines) > MAX_TRAFFIC_LINES:
        out.print(Text(f"  ({len(lines) - MAX_TRAFFIC_LINES} earlier lines; --html and --json have them)", style="dim"))


def show_list() -> None:
    """Print every installed profile."""
    table = Table("profile", "steps", "points", "what", box=None, pad_edge=False, header_style="dim")
    for name in known():
        try:
            profile = find(name)
        except ConfigError as error:
            table.add_row(name, "", "", str(error))
            continue
        steps = () if callable(profile.steps) else profile.steps
        points = sum(step.points for step in steps)
        table.add_row(name, str(len(steps) or "as offered"), f"{points:g}" if points else "", profile.title)
    console.stdout().print(table)


def show_steps(steps: Iterable[Step]) -> None:
    """Print the steps of a profile."""
    for step in steps:
        console.print_lines(f"{step.id}  {step.title}")


@contextmanager
def progress_line() -> Iterator[OnResult]:
    """Show the last step and its verdict on a terminal."""
    if not sys.stderr.isatty():
        yield lambda _: None
        return
    with console.stderr().status("waiting for the target ...") as status:
        yield lambda result: status.update(Text(f"{result.id} {result.title}: {result.verdict}"))
