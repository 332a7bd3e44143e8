"""`jauspy fuzz`: test the codec with random and damaged messages."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import asdict
from pathlib import Path
from typing import Annotated, Any, Final, Protocol

import typer
from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeRemainingColumn
from rich.text import Text

from jauspy.cli import console
from jauspy.cli.options import ClusterOption, Json
from jauspy.codec.message import counted
from jauspy.errors import ConfigError, SchemaError
from jauspy.fuzz.campaign import CHECK as IDENTITY, CampaignPlan, CampaignResult, fuzzer, run
from jauspy.fuzz.findings import FuzzFinding, load_finding
from jauspy.fuzz.mutation import file_payloads

SchemasOption = Annotated[
    list[str] | None,
    typer.Option(
        "--schemas",
        metavar="FILE",
        help="Your own JSIDL files, folders or patterns; their messages are tested instead of the built-in ones.",
    ),
]
PackageOption = Annotated[
    str | None,
    typer.Option(
        "--package",
        metavar="NAME",
        help="The package that `jauspy schema generate` has written for --schemas; its classes are tested.",
    ),
]
PROGRESS_LINES: Final = 10  # in a pipe


def codec(
    *,
    seeds: Annotated[
        list[Path] | None, typer.Argument(metavar="[SEEDS]...", help="pcap, pcapng or hex files to start from.")
    ] = None,
    cases: Annotated[int, typer.Option("--cases", min=1, metavar="N", help="Number of cases.")] = 100_000,
    seed: Annotated[int, typer.Option("--seed", min=0, metavar="S", help="The same seed gives the same cases.")] = 0,
    output: Annotated[
        Path, typer.Option("-o", "--output", "--out", metavar="DIR", help="Where findings are saved.")
    ] = Path("findings"),
    message: Annotated[
        list[str] | None, typer.Option("--message", metavar="NAME", help="Only this message; may be repeated.")
    ] = None,
    sources: SchemasOption = None,
    package: PackageOption = None,
    jobs: Annotated[int, typer.Option("--jobs", "-j", min=1, metavar="N", help="Processes to use.")] = 1,
    resume: Annotated[
        Path | None,
        typer.Option(
            "--resume", metavar="STATE", help="Note the progress in this file, and continue from what it has."
        ),
    ] = None,
    cluster: ClusterOption = None,
    as_json: Json = False,
) -> None:
    """Decode valid, random and damaged messages and check invariants.

    Every second case is a random valid message; the others are damaged messages. Each case must decode or raise
    DecodeError, encode to the same bytes again, agree with the reference codec, and use no more time and memory than
    its size allows; with the id of another message, it must not decode. With --package, the messages of a generated
    package are tested against the definitions that it was made from: all are there, none else, with the same ids,
    versions and fields. Exit status: 0 no findings, 1 findings, 2 wrong use.

    Examples:
      jauspy fuzz codec run.pcap --cases 1000000 --jobs 2
      jauspy fuzz codec --cases 10000000 --jobs 8 --resume fuzz.json
      jauspy fuzz codec --message ReportServices --seed 7
      jauspy fuzz codec --schemas vendor/ --cases 20000
      jauspy fuzz codec --schemas vendor/ --package acme_messages
    """
    with _usage_errors():
        payloads = [payload for path in seeds or [] for payload in _payloads(path)]
        plan = CampaignPlan(
            cases=cases,
            seed=seed,
            payloads=tuple(dict.fromkeys(payloads)),
            only=tuple(message or ()),
            jobs=jobs,
            own=tuple(sources or ()),
            package=package or "",
        )
        with _progress(plan) as show:
            outcome = run(plan, show, resume=resume, cluster=cluster)
    for finding in sorted(outcome.findings.values(), key=lambda finding: finding.case):
        if as_json:
            console.print_json(_object(finding) | {"file": str(finding.save(output))})
            continue
        _print(finding)
        again = [str(finding.save(output)), *(f"--schemas {source}" for source in sources or ())]
        again += [f"--package {package}"] if package else []
        console.print_lines(f"  jauspy fuzz replay {' '.join(again)}")
    found = counted(len(outcome.findings), "finding") if outcome.findings else "nothing found"
    summary = f"{outcome.cases} cases from {outcome.seeds} seeds of {outcome.messages} messages: {found}"
    (console.note if as_json else console.print_lines)(summary)
    if outcome.findings:
        raise typer.Exit(1)


def _payloads(path: Path) -> list[bytes]:

    found = file_payloads(path)
    if not found:
        console.note(f"{path} has no JAUS messages and is ignored")
    return found


def replay(
    *,
    file: Annotated[Path, typer.Argument(metavar="FILE", help="A finding that was saved.")],
    sources: SchemasOption = None,
    package: PackageOption = None,
    as_json: Json = False,
) -> None:
    """Check the bytes of a saved finding again.

    Exit status: 0 not reproduced, 1 reproduced, 2 wrong use.

    Example:
      jauspy fuzz replay findings/agreement-ReportServices-1.1-verdict.json
    """
    with _usage_errors():
        finding = load_finding(file)
        only = () if finding.check == IDENTITY else (finding.message,)
        plan = CampaignPlan(0, finding.seed, only=only, own=tuple(sources or ()), package=package or "")
        again = fuzzer(plan).replay(finding)
    if as_json:
        console.print_json(_object(again or finding) | {"reproduced": again is not None})
    elif again is None:
        console.print_lines(f"{finding.cause}: not reproduced")
    else:
        _print(again)
    if again is None:
        return
    raise typer.Exit(1)


@contextmanager
def _usage_errors() -> Iterator[None]:
    """Exit with status 2 for missing files and unknown names."""
    try:
        yield
    except (ConfigError, SchemaError) as error:
        console.error(str(error))
        raise typer.Exit(2) from None


def _object(finding: FuzzFinding) -> dict[str, Any]:
    return {"cause": finding.cause, **asdict(finding)}


def _print(finding: FuzzFinding) -> None:
    console.stdout().print(Text(finding.cause, style="bold red"))
    shown = finding.hex if len(finding.hex) <= 200 else finding.hex[:200] + "..."
    console.print_lines(f"  {finding.seen}", f"  {shown} ({len(finding.data)} bytes)")


class _ShowProgress(Protocol):
    def __call__(self, outcome: CampaignResult) -> None:
        """Show the progress."""


@contextmanager
def _progress(plan: CampaignPlan) -> Iterator[_ShowProgress]:
    """A progress bar on a terminal, some lines in a pipe; both on stderr."""
    if not sys.stderr.isatty():
        yield _ProgressLines(plan.cases)
        return

    columns = (BarColumn(), MofNCompleteColumn(), TextColumn("{task.description}"), TimeRemainingColumn())
    with Progress(*columns, console=console.stderr(), transient=True) as progress:
        task = progress.add_task("", total=plan.cases)
        yield lambda outcome: progress.update(task, completed=outcome.cases, description=_state(outcome))


class _ProgressLines:
    """Prints a line for every tenth of the cases. It contains no times, so equal campaigns print the same."""

    def __init__(self, cases: int) -> None:
        self._cases = cases
        self._shown = -1

    def __call__(self, outcome: CampaignResult) -> None:
        tenth = PROGRESS_LINES * outcome.cases // self._cases
        if tenth > self._shown:
            self._shown = tenth
            console.note(f"{outcome.cases} of {self._cases} cases, {_state(outcome)}")


def _state(outcome: CampaignResult) -> str:

    return f"{outcome.accepted} valid, {counted(len(outcome.findings), 'finding')}"
