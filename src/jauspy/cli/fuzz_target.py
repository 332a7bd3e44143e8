"""`jauspy fuzz target`: damaged messages to a running component or node manager."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Annotated

import typer

from jauspy.cli import console
from jauspy.cli.options import ClusterOption, Json
from jauspy.codec.message import counted
from jauspy.errors import ConfigError
from jauspy.fuzz.target.address import target_address
from jauspy.fuzz.target.campaign import TargetPlan, TargetResult, run, run_on_cluster
from jauspy.fuzz.target.findings import TargetFinding
from jauspy.fuzz.target.session import MEBIBYTE, Limits
from jauspy.ids import JausID


def target(
    *,
    address: Annotated[
        str, typer.Argument(metavar="ADDR", help="HOST:PORT of the target's UDP socket; port 0 is one that is free.")
    ],
    cases: Annotated[int, typer.Option("--cases", min=1, metavar="N", help="Number of cases.")] = 10_000,
    seed: Annotated[int, typer.Option("--seed", min=0, metavar="S", help="The same seed gives the same cases.")] = 0,
    component: Annotated[
        str | None,
        typer.Option("--component", metavar="ID", help="The component to test. Default: that with the most services."),
    ] = None,
    message: Annotated[
        list[str] | None, typer.Option("--message", metavar="NAME", help="Only this message; may be repeated.")
    ] = None,
    restart: Annotated[
        str,
        typer.Option(
            "--restart",
            metavar="COMMAND",
            help="The command that starts the target and keeps running; {host} and {port} in it are those of ADDR. "
            "It is started at the beginning, and again after a failure and to minimise one.",
        ),
    ] = "",
    pid: Annotated[
        int | None, typer.Option("--pid", min=1, metavar="PID", help="The process of a target that runs already.")
    ] = None,
    limit: Annotated[
        float, typer.Option("--limit", min=0.05, metavar="SECONDS", help="A later answer counts as hanging.")
    ] = 2.0,
    memory: Annotated[
        int, typer.Option("--memory", min=1, metavar="MIB", help="Steady growth of memory by more counts as a leak.")
    ] = 64,
    tries: Annotated[
        int, typer.Option("--tries", min=1, metavar="N", help="Starts of the target, at most, to minimise a finding.")
    ] = 200,
    cluster: ClusterOption = None,
    is_own_network: Annotated[
        bool, typer.Option("--i-own-this-network", help="Allow an address that is not a loopback address.")
    ] = False,
    output: Annotated[Path, typer.Option("-o", "--output", metavar="DIR", help="Where findings are saved.")] = Path(
        "findings"
    ),
    as_json: Json = False,
) -> None:
    """Send legal and damaged messages to a component or node manager in each of its states.

    The target is asked for its services. It is brought to each state of their merged state machine, and then gets legal
    messages, damaged ones, damaged headers and fragments that do not fit together. Queries between them show whether it
    still answers. A target that dies, hangs or leaks memory is a finding; with --restart it is minimised. It is saved
    as a pcapng file that shows the failure when it is sent again. Only Shutdown is never sent.

    ADDR must be a loopback address, or be in a network namespace without a default route, unless --i-own-this-network.
    A node manager may pass messages on to its network: run it in a namespace, or on a machine without one.

    Exit status: 0 no findings, 1 findings, 2 wrong use, or a target that does not answer at the start or could not be
    brought to any state.

    Examples:
      jauspy fuzz target 127.0.0.1:3794 --cases 100000
      jauspy fuzz target 127.0.0.1:0 --restart 'vendor-node --port {port}' --output crashes
      jauspy fuzz target 127.0.0.1:3794 --pid 4711 --memory 200 --message SetWrenchEffort
    """
    try:
        _check(cluster, restart, pid)
        plan = TargetPlan(
            target_address(address, is_own_network=is_own_network),
            cases,
            seed,
            restart=restart,
            pid=pid,
            component=JausID.parse(component) if component else None,
            only=tuple(message or ()),
            limits=Limits(limit, memory * MEBIBYTE),
            tries=tries,
        )
        with _progress(cases) as show:
            outcome = run(plan, show) if cluster is None else run_on_cluster(plan, cluster, show)
    except (ConfigError, ValueError) as error:
        console.error(str(error))
        raise typer.Exit(2) from None
    for finding in outcome.findings.values():
        path = finding.save(output)
        if as_json:
            console.print_json(finding.to_dict() | {"file": str(path)})
        else:
            _print(finding, path)
    summary = (
        f"{counted(outcome.cases, 'case')} of {counted(outcome.messages, 'message')} to {outcome.component} "
        f"in {counted(len(outcome.states), 'state')}: {counted(len(outcome.findings), 'finding')}"
    )
    (console.note if as_json else console.print_lines)(summary)
    for state in sorted(outcome.unreached):
        console.note(f"the target could not be brought to the state {state}")
    if outcome.is_stopped:
        console.note("the other cases were not sent: the target failed; with --restart the campaign goes on")
    if outcome.findings:
        raise typer.Exit(1)
    if outcome.unreached and not outcome.states:
        console.error("nothing was tested in a state of its own: reset the target, whose emergency or control is held")
        raise typer.Exit(2)


def _check(cluster: str | None, restart: str, pid: int | None) -> None:
    """Raise `ConfigError` for options that do not go together."""
    if restart and pid is not None:
        raise ConfigError("give either --pid or --restart: the process of a started target is known")
    if cluster is not None and "{port}" not in restart:
        raise ConfigError("with --cluster every worker starts a target: add --restart COMMAND with {port} in it")


def _print(finding: TargetFinding, path: Path) -> None:
    count = counted(len(finding.datagrams), "datagram")
    kind = "minimised" if finding.is_minimised else "all since its start, not minimised"
    console.print_lines(finding.cause, f"  {finding.seen}", f"  {path}: {count}, {kind}")


@contextmanager
def _progress(cases: int) -> Iterator[Callable[[TargetResult], None]]:
    """A progress bar on a terminal; nothing in a pipe."""
    from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeRemainingColumn

    if not sys.stderr.isatty():
        yield lambda _: None
        return
    columns = (BarColumn(), MofNCompleteColumn(), TextColumn("{task.description}"), TimeRemainingColumn())
    with Progress(*columns, console=console.stderr(), transient=True) as progress:
        task = progress.add_task("", total=cases)
        yield lambda outcome: progress.update(
            task, completed=outcome.cases, description=counted(len(outcome.findings), "finding")
        )
