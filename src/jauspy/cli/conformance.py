"""`jauspy conformance`: test whether a robot or component is what the standard says."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from jauspy.cli.options import Json

if TYPE_CHECKING:
    from jauspy.conformance.results import Report, Result

ProfileName = Annotated[
    str | None,
    typer.Argument(
        metavar="PROFILE", help="Which test, as in igvc-2015; --list shows them all. MODULE:NAME is one of yours."
    ),
]
Target = Annotated[
    str | None,
    typer.Option("--target", metavar="ID", help="What to test, as in 101.1.102, or 101.1.255 for its components."),
]
Listing = Annotated[bool, typer.Option("--list", help="Show the profiles, or the steps of PROFILE, and test nothing.")]
Where = Annotated[
    str | None,
    typer.Option(
        "--connect",
        metavar="WHERE",
        help="How to reach the target: udp://HOST:PORT, or by a node manager, tcp://HOST:PORT or local:DIR. "
        "Default: multicast, also when a node manager runs on this machine.",
    ),
]
Deadline = Annotated[
    float,
    typer.Option("--timeout", min=0.01, metavar="SECONDS", help="How long an answer may take; scales all waiting."),
]
Motion = Annotated[bool, typer.Option("--motion/--no-motion", help="Whether the robot may drive.")]
Only = Annotated[
    list[str] | None, typer.Option("--only", metavar="STEP", help="Only steps that begin so; may be repeated.")
]
Junit = Annotated[Path | None, typer.Option("--junit", metavar="FILE", help="Write JUnit XML.")]
Html = Annotated[Path | None, typer.Option("--html", metavar="FILE", help="Write a report to read, in one file.")]
Pcapng = Annotated[Path | None, typer.Option("--pcapng", metavar="FILE", help="Write what was sent and received.")]


def conformance(
    *,
    profile: ProfileName = None,
    target: Target = None,
    list_: Listing = False,
    connect: Where = None,
    timeout: Deadline = 1.5,
    motion: Motion = True,
    only: Only = None,
    json: Json = False,
    junit: Junit = None,
    html: Html = None,
    pcapng: Pcapng = None,
) -> None:
    """Test a robot or component of any vendor, step by step.

    Each step passes, fails, is silent, late, malformed, or skipped with a reason. Status 0: all passed; 1: some did
    not; 2: the test could not run; 130: Ctrl-C; 143: SIGTERM. Give the robot room: some profiles make it drive, and
    shut it down at the end. However it ends, the robot is left in Standby and free.

    Without --connect the test speaks UDP multicast itself, from port 3794 if it is free.

    Examples:
      jauspy conformance igvc-2015 --target 101.1.255 --html report.html
      jauspy conformance core-1.1 --target 101.1.102 --connect udp://192.168.1.101
      jauspy conformance --list
    """
    from jauspy.cli import console
    from jauspy.cli.conformance_files import Files
    from jauspy.cli.conformance_run import report_of, steps_of
    from jauspy.cli.conformance_view import show_list, show_steps, watching
    from jauspy.cli.run import stoppable
    from jauspy.conformance.profile import find
    from jauspy.conformance.runner import Interrupted, Settings
    from jauspy.errors import ConfigError, JausError

    sys.path.append("")  # profiles of one's own, in the folder where one is; last, so that they hide nothing
    try:
        if list_:
            show_steps(steps_of(find(profile), target, connect, timeout)) if profile else show_list()
            return
        if profile is None or target is None:
            raise ConfigError("say which test, and of what: `jauspy conformance igvc-2015 --target 101.1.255`")
        files = Files(junit=junit, html=html, pcapng=pcapng)
        settings = Settings(timeout, motion, tuple(only or ()))
        with stoppable() as stopped:
            try:
                with watching() as progress:
                    report = report_of(find(profile), target, connect, settings, _lines if json else progress)
                status = report.status
            except Interrupted as stop:
                report, status = stop.report, stopped()
            for each in (unwritten := files.write(report)):
                console.error(each)
            with _unread_is_fine():
                _show(report, json=json)
    except JausError as error:
        console.error(str(error))
        raise typer.Exit(2) from None
    raise typer.Exit(2 if unwritten else status)


def _lines(result: Result) -> None:
    """A step in JSON, as soon as it has ended."""
    from json import dumps

    from jauspy.conformance.reports import result_json

    with _unread_is_fine():
        print(dumps(result_json(result), ensure_ascii=False))


@contextmanager
def _unread_is_fine() -> Iterator[None]:
    """When nobody reads the output any more, the run goes on for its files and its status."""
    from jauspy.cli import console
    from jauspy.errors import ConfigError

    try:
        yield
        sys.stdout.flush()
    except BrokenPipeError:
        console.discard_stdout()
    except OSError as error:
        console.discard_stdout()
        raise ConfigError(f"the results cannot be written: {error.strerror}") from error


def _show(report: Report, *, json: bool) -> None:
    """All of it; with `json` the steps are there already, and only the sum is missing."""
    from jauspy.cli import conformance_view, console

    if report.problem:
        console.error(report.problem)
    if not json:
        conformance_view.show(report)
        return
    from json import dumps

    from jauspy.conformance.reports import summary_json

    print(dumps(summary_json(report), ensure_ascii=False))
