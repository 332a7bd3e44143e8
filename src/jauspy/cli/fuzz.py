"""`jauspy fuzz`: bytes that nobody would send on purpose, against the codec."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Final, Protocol

import typer

from jauspy.cli import console
from jauspy.cli.help import help_text
from jauspy.errors import ConfigError, SchemaError

if TYPE_CHECKING:
    from jauspy.fuzz.campaign import CampaignPlan, CampaignResult
    from jauspy.fuzz.findings import FuzzFinding

Own = Annotated[
    list[str] | None,
    typer.Option(
        "--from",
        metavar="FILE",
        help="Your own JSIDL files, folders or patterns; their messages are tested, not those built in.",
    ),
]
_LINES: Final = 10  # of progress in a pipe


def codec(
    *,
    seeds: Annotated[
        list[Path] | None, typer.Argument(metavar="[SEEDS]...", help="pcap, pcapng or hex files to start from.")
    ] = None,
    cases: Annotated[int, typer.Option("--cases", min=1, metavar="N", help="How many cases.")] = 100_000,
    seed: Annotated[int, typer.Option("--seed", min=0, metavar="S", help="The same seed gives the same cases.")] = 0,
    out: Annotated[Path, typer.Option("--out", metavar="DIR", help="Where findings are saved.")] = Path("findings"),
    message: Annotated[
        list[str] | None, typer.Option("--message", metavar="NAME", help="Only this message; may be repeated.")
    ] = None,
    sources: Own = None,
    jobs: Annotated[int, typer.Option("--jobs", "-j", min=1, metavar="N", help="Processes to use.")] = 1,
) -> None:
    """Decode valid, random and damaged messages, and check what must hold for any bytes.

    Every second case is a random valid message, the others are damaged ones. Each must decode or raise DecodeError,
    give the same bytes again, mean the same to the reference codec, and cost no more than its size allows. Exit status:
    0 nothing was found, 1 something was, 2 wrong use.

    Examples:
      jauspy fuzz codec run.pcap --cases 1000000 --jobs 2
      jauspy fuzz codec --message ReportServices --seed 7
      jauspy fuzz codec --from vendor/ --cases 20000
    """
    from jauspy.codec.message import counted
    from jauspy.fuzz.campaign import CampaignPlan, run

    with _wrong_use():
        payloads = [payload for path in seeds or [] for payload in _payloads(path)]
        plan = CampaignPlan(
            cases, seed, tuple(dict.fromkeys(payloads)), tuple(message or ()), jobs, tuple(sources or ())
        )
        with _progress(plan) as show:
            outcome = run(plan, show)
    for finding in sorted(outcome.findings.values(), key=lambda finding: finding.case):
        _print(finding)
        again = [str(finding.save(out)), *(f"--from {source}" for source in sources or ())]
        print(f"  jauspy fuzz replay {' '.join(again)}")
    found = counted(len(outcome.findings), "finding") if outcome.findings else "nothing found"
    print(f"{outcome.cases} cases from {outcome.seeds} seeds of {outcome.messages} messages: {found}")
    if outcome.findings:
        raise typer.Exit(1)


def _payloads(path: Path) -> list[bytes]:
    from jauspy.fuzz.mutation import file_payloads

    found = file_payloads(path)
    if not found:
        console.note(f"there is no JAUS message in {path}; the campaign goes on without it")
    return found


def replay(
    *,
    file: Annotated[Path, typer.Argument(metavar="FILE", help="A finding that was saved.")],
    sources: Own = None,
) -> None:
    """Check the bytes of a finding again.

    Exit status: 0 nothing is wrong with them any more, 1 they still show a problem, 2 wrong use.

    Example:
      jauspy fuzz replay findings/agreement-ReportServices-1.1-verdict.json
    """
    from jauspy.fuzz.campaign import CampaignPlan, fuzzer
    from jauspy.fuzz.findings import load_finding

    with _wrong_use():
        finding = load_finding(file)
        again = fuzzer(CampaignPlan(0, finding.seed, only=(finding.message,), own=tuple(sources or ()))).replay(finding)
    if again is None:
        print(f"{finding.cause}: not reproduced")
        return
    _print(again)
    raise typer.Exit(1)


@contextmanager
def _wrong_use() -> Iterator[None]:
    """Files and names that are not there are wrong use."""
    try:
        yield
    except (ConfigError, SchemaError) as error:
        console.error(str(error))
        raise typer.Exit(2) from None


def _print(finding: FuzzFinding) -> None:
    console.stdout().print(f"[bold red]{finding.cause}[/]", highlight=False)
    print(f"  {finding.seen}")
    print(f"  {finding.hex if len(finding.hex) <= 200 else finding.hex[:200] + '...'} ({len(finding.data)} bytes)")


class _Show(Protocol):
    def __call__(self, outcome: CampaignResult) -> None:
        """Show how far it is."""


@contextmanager
def _progress(plan: CampaignPlan) -> Iterator[_Show]:
    """A bar on a terminal, a line now and then in a pipe; both on stderr."""
    if not sys.stderr.isatty():
        yield _Lines(plan.cases)
        return
    from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeRemainingColumn

    columns = (BarColumn(), MofNCompleteColumn(), TextColumn("{task.description}"), TimeRemainingColumn())
    with Progress(*columns, console=console.stderr(), transient=True) as progress:
        task = progress.add_task("", total=plan.cases)
        yield lambda outcome: progress.update(task, completed=outcome.cases, description=_state(outcome))


class _Lines:
    """A line whenever another tenth is done: it says nothing of time, so equal campaigns say the same."""

    def __init__(self, cases: int) -> None:
        self._cases = cases
        self._shown = -1

    def __call__(self, outcome: CampaignResult) -> None:
        tenth = _LINES * outcome.cases // self._cases
        if tenth > self._shown:
            self._shown = tenth
            console.note(f"{outcome.cases} of {self._cases} cases, {_state(outcome)}")


def _state(outcome: CampaignResult) -> str:
    from jauspy.codec.message import counted

    return f"{outcome.accepted} valid, {counted(len(outcome.findings), 'finding')}"


app = typer.Typer(
    name="fuzz", no_args_is_help=True, help="Try bytes that nobody would send on purpose, and check what must hold."
)
for verb in (codec, replay):
    app.command(verb.__name__, help=help_text(verb.__doc__ or ""))(verb)
