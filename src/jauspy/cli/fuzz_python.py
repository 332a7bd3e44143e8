"""`jauspy fuzz python`: coverage-guided fuzzing of a Python function that takes messages."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Annotated

import typer

from jauspy.cli import console
from jauspy.cli.options import Json
from jauspy.codec.message import counted
from jauspy.errors import ConfigError
from jauspy.fuzz.coverage import PythonFinding, PythonPlan, run
from jauspy.fuzz.mutation import file_payloads


def python(
    *,
    function: Annotated[
        str, typer.Argument(metavar="MODULE:FUNCTION", help="A function that takes the bytes of one message.")
    ],
    seeds: Annotated[
        list[Path] | None, typer.Argument(metavar="[SEEDS]...", help="pcap, pcapng or hex files, which are run first.")
    ] = None,
    cases: Annotated[int, typer.Option("--cases", min=0, metavar="N", help="Number of cases.")] = 100_000,
    seed: Annotated[int, typer.Option("--seed", min=0, metavar="S", help="The same seed gives the same cases.")] = 0,
    message: Annotated[
        list[str] | None, typer.Option("--message", metavar="NAME", help="Only this message; may be repeated.")
    ] = None,
    include: Annotated[
        list[str] | None,
        typer.Option("--include", metavar="PATH", help="A folder or file whose lines count, too; may be repeated."),
    ] = None,
    blind: Annotated[bool, typer.Option("--blind", help="Do not use the lines that were reached.")] = False,
    output: Annotated[Path, typer.Option("-o", "--output", metavar="DIR", help="Where findings are saved.")] = Path(
        "findings"
    ),
    as_json: Json = False,
) -> None:
    """Run a Python function with damaged messages, guided by the lines that they reach.

    The function gets the bytes of one message, with its id, as a payload of AS5669A is. An input that reaches a new
    line of its package becomes a seed of further inputs. A finding is an exception other than jauspy's own
    (JausError); it is minimised and saved as a hex file, which can be given as SEEDS. Lines are measured by
    sys.monitoring, and before Python 3.12 by sys.settrace, which is slower.

    Exit status: 0 no findings, 1 findings, 2 wrong use.

    Examples:
      jauspy fuzz python my_robot.driver:handle_message --message SetWrenchEffort
      jauspy fuzz python my_robot.driver:handle_message findings/KeyError-driver.py-41.hex --cases 0
    """
    try:
        payloads = tuple(dict.fromkeys(payload for path in seeds or () for payload in file_payloads(path)))
        plan = PythonPlan(function, cases, seed, payloads, tuple(message or ()), tuple(include or ()), guided=not blind)
        outcome = run(plan)
    except ConfigError as error:
        console.error(str(error))
        raise typer.Exit(2) from None
    for finding in outcome.findings.values():
        path = _save(finding, output)
        if as_json:
            shown = {"cause": finding.cause, "seen": finding.seen, "hex": finding.data.hex(), "case": finding.case}
            console.print_json(shown | {"file": str(path)})
        else:
            console.print_lines(finding.cause, f"  {finding.seen}", f"  {finding.data.hex()}", f"  {path}")
    summary = (
        f"{counted(outcome.cases, 'case')}, {counted(outcome.lines, 'line')} reached, "
        f"{counted(len(outcome.findings), 'finding')}"
    )
    (console.note if as_json else console.print_lines)(summary)
    if outcome.findings:
        raise typer.Exit(1)


def _save(finding: PythonFinding, folder: Path) -> Path:
    """Write the bytes as a line of hex text, which `jauspy decode` and this verb read."""
    folder.mkdir(parents=True, exist_ok=True)
    path = folder / (re.sub(r"[^\w.]+", "-", finding.cause).strip("-.") + ".hex")
    path.write_text(finding.data.hex() + "\n", encoding="ascii")
    return path
