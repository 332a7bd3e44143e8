"""`jauspy conformance`: test a robot or component against a standard."""

from __future__ import annotations

import asyncio
import os
import sys
import time
from collections.abc import Callable, Iterable, Iterator
from contextlib import closing, contextmanager
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Annotated, Final

import typer
from rich.table import Table
from rich.text import Text

from jauspy.cli import console
from jauspy.cli.definitions import SchemasOption, definitions
from jauspy.cli.options import Json, Peer
from jauspy.cli.processes import stoppable
from jauspy.cli.schema.ls import find as find_definitions
from jauspy.codec.registry import Registry
from jauspy.conformance import reports
from jauspy.conformance.known_deviations import marked, with_known_deviations
from jauspy.conformance.link import TesterLink, open_link
from jauspy.conformance.profile import Offers, Profile, Step, find, known
from jauspy.conformance.reports import explanation, result_json, summary, summary_json, transcript
from jauspy.conformance.results import Report, Result, Verdict, transitions_summary
from jauspy.conformance.runner import Interrupted, OnResult, Settings, planned_steps, run
from jauspy.errors import ConfigError, JausError
from jauspy.ids import JausID
from jauspy.inspection.peers import find_kind
from jauspy.messages import registry
from jauspy.schema import Schema, load_builtin
from jauspy.schema.inheritance import lineage, parents_among
from jauspy.schema.model import ServiceDefinition

ProfileName = Annotated[
    str | None,
    typer.Argument(
        metavar="PROFILE",
        help="The profile, as in igvc-2015; --list lists them. MODULE:NAME is one of your own. A URN, as in "
        "urn:acme:Winch, tests every transition of this service, which --schemas may define.",
    ),
]
Target = Annotated[
    str | None,
    typer.Option(
        "--target",
        metavar="ID",
        help="What to test: 101.1.102 is a component, 101.1.255 all components of a node, 101 those of a robot.",
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
    target: Target = None,
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
) -> None:
    """Test a robot or component of any vendor, step by step.

    The verdict of a step is passed, failed, silent, late, malformed, or skipped with a reason. Exit status: 0 all
    steps passed; 1 a step did not pass; 2 the test could not run; 130 Ctrl-C; 143 SIGTERM. Some profiles make the robot
    drive and shut it down at the end. In every other case the robot is left in Standby, without a controller.

    Without --connect the test uses UDP multicast itself, from port 3794 if that is free.

    Examples:
      jauspy conformance igvc-2015 --target 101.1.255 --html report.html
      jauspy conformance iop-v3 --target 101
      jauspy conformance core-1.1 --target 101.1.102 --connect udp://192.168.1.101
      jauspy conformance core-1.1 --target 126.1.11 --connect local:/tmp --services Management@1.0
      jauspy conformance urn:acme:Winch --target 101.1.120 --schemas Winch.xml
      jauspy conformance acme_steps:PROFILE --target 101.1.120 --schemas acme.xml
      jauspy conformance --list
    """
    if profile is not None and ":" in profile and not _is_urn(profile):
        sys.path.append("")  # the user's profile may be in the current directory; last, so that it hides no module
    try:
        defined = definitions(schemas)
        offers = named_offers(services, target, defined.own)
        if list_:
            if profile is None:
                show_list()
            else:
                chosen = chosen_profile(profile, defined.registry)
                show_steps(steps_of(chosen, target, connect, timeout, offers, messages=defined.registry))
            return
        if profile is None or target is None:
            raise ConfigError("name a profile and a target, as in `jauspy conformance igvc-2015 --target 101.1.255`")
        files = ReportFiles(junit=junit, html=html, pcapng=pcapng)
        settings = Settings(timeout, motion, tuple(only or ()))
        with stoppable() as stopped:
            try:
                with progress_line() as progress:
                    watch = _print_json if json else progress
                    chosen = chosen_profile(profile, defined.registry)
                    report = report_of(
                        chosen, target, connect, settings, watch, offers=offers, messages=defined.registry, peer=peer
                    )
                status = report.status
            except Interrupted as stop:
                report, status = stop.report, stopped()
            for problem in (unwritten := files.write(report)):
                console.error(problem)
            with _ignoring_closed_pipe():
                _show(report, json=json)
    except JausError as error:
        console.error(str(error))
        raise typer.Exit(2) from None
    raise typer.Exit(2 if unwritten else status)


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


def _show(report: Report, *, json: bool) -> None:
    """Print the report; with `json` the steps have been printed, and the summary follows."""
    if report.problem:
        console.error(report.problem)
    if not json:
        show(report)
        return

    console.print_json(summary_json(report))


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

    def write(self, report: Report) -> list[str]:
        """Write the files; returns an error message for each that cannot be written."""
        problems = (
            _write(self.junit, lambda: reports.junit(report)),
            _write(self.html, lambda: reports.page(report).encode()),
            _write(self.pcapng, lambda: reports.capture(report)),
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


def _is_urn(profile: str) -> bool:
    return profile.startswith("urn:")


def chosen_profile(name: str, messages: Registry) -> Profile:
    """The profile of this name, or that of the service with this URN. Raises `ConfigError` for an unknown one."""
    if not _is_urn(name):
        return find(name)
    from jauspy.conformance.state_tests.plan import service_profile

    return service_profile(name, messages)


def named_offers(names: str | None, target: str | None, own: Schema | None = None) -> Offers | None:
    """The services that the user names, and their ancestors, as offers of the target; None without names.

    `own` has the user's definitions.
    """
    if names is None or target is None:
        return None
    if (id := _id(target)).is_wildcard:
        raise ConfigError(f"--services names the services of one component, and {id} has wildcards")
    schema = Schema(services=(*(own.services if own else ()), *load_builtin().services))
    parent_of = parents_among(schema.services)
    found: dict[str, ServiceDefinition] = {}
    for name in filter(None, (name.strip() for name in names.split(","))):
        services = [match.service for match in find_definitions(schema, name) if match.message is None]
        if len(services) != 1:
            several = ", ".join(service.id for service in services)
            raise ConfigError(f"--services {name}: {'name one of ' + several if several else 'this is a message'}")
        for service in lineage(services[0], parent_of):
            if (other := found.setdefault(service.id, service)).version != service.version:
                raise ConfigError(
                    f"--services {name}: it needs {service.name} {service.version}, and the services before it need "
                    f"{service.name} {other.version}; give a version to each, as in {services[0].name}@{other.version}"
                )
    return Offers({id: frozenset(service.key for service in found.values())})


def steps_of(
    profile: Profile,
    target: str | None,
    connect: str | None,
    timeout: float,
    offers: Offers | None,
    *,
    messages: Registry,
) -> tuple[Step, ...]:
    """The steps of a profile; the target is queried only if they depend on its services, and these are not named."""
    if not profile.asks_for_services:
        return profile.plan(Offers({}))
    if target is None:
        raise ConfigError(
            f"the steps of {profile.name} depend on the target's services; add --target, as in --target 101.1.102"
        )
    with closing(asyncio.run(open_link(connect))) as link:
        return planned_steps(profile, link, _id(target), offers=offers, timeout=timeout, registry=messages)


def report_of(
    profile: Profile,
    target: str,
    connect: str | None,
    settings: Settings,
    watch: OnResult,
    *,
    offers: Offers | None = None,
    messages: Registry = registry,
    peer: str | None = None,
) -> Report:
    """Run a profile; raises `Interrupted`, which has the report so far."""
    id = _id(target)
    kind = None if peer is None else find_kind(peer)

    def watch_marked(result: Result) -> None:
        watch(result if kind is None else marked(result, profile.name, kind))

    with closing(asyncio.run(open_link(connect))) as link:
        try:
            report = run(
                profile,
                link,
                id,
                began=time.time(),
                offers=offers,
                settings=settings,
                registry=messages,
                watch=watch_marked,
            )
        except Interrupted as stop:
            stop.report = with_known_deviations(_with_notes(stop.report, link), kind)
            raise
        return with_known_deviations(_with_notes(report, link), kind)


def _id(target: str) -> JausID:
    id = JausID.parse(f"{target}.255.255" if target.isascii() and target.isdigit() else target)
    if 0 in (id.subsystem, id.node, id.component):
        raise ConfigError(
            f"{id} is not the id of a component: no part may be 0; 255 is the wildcard of node and component"
        )
    return id


def _with_notes(report: Report, link: TesterLink) -> Report:
    """The report with the notes of the wire."""
    return replace(report, notes=(*getattr(link, "notes", ()), *report.notes))


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
