"""`jauspy replay`: sends again what recorded clients sent, and compares the answers with the recorded ones."""

from __future__ import annotations

from dataclasses import asdict
from pathlib import Path
from typing import Annotated

import typer

from jauspy.capture.filters import Filter
from jauspy.cli import console
from jauspy.cli.client import own_id
from jauspy.cli.definitions import SchemasOption, definitions
from jauspy.cli.options import FilterOption, Json, OperatorKey
from jauspy.cli.processes import run
from jauspy.errors import ConfigError
from jauspy.ids import ANY_SUBSYSTEM, JausID, component_id
from jauspy.ocu.sealing import load_key
from jauspy.replay.comparison import Comparison
from jauspy.replay.player import Playback, Result, replay as play
from jauspy.replay.recorded import PATIENCE, Recording, load
from jauspy.transport import Transport
from jauspy.transport.connect import transport_for

MAX_SHOWN = 50


def replay(
    *,
    file: Annotated[Path, typer.Argument(metavar="FILE", help="A .pcap, .pcapng or .mcap file.")],
    to: Annotated[
        str | None,
        typer.Option(
            "--to",
            metavar="WHERE",
            help="The node manager of the robot: HOST:PORT, udp://HOST:PORT, tcp://HOST:PORT or local:DIR. "
            "Default: the one in /tmp if it runs, else multicast.",
        ),
    ] = None,
    own: Annotated[
        str | None,
        typer.Option(
            "--as",
            metavar="ID",
            help="Id of the first client; more have the next ones. Default: a free one.",
        ),
    ] = None,
    sender: Annotated[
        list[str] | None,
        typer.Option(
            "--from",
            metavar="ID",
            help="A recorded client, as 42.1.1 or 42.255.255 (wildcards); may be repeated. Default: all of other "
            "subsystems than the robot's.",
        ),
    ] = None,
    target: Annotated[
        str | None,
        typer.Option(
            "--target",
            metavar="SUBSYSTEM[=NOW]",
            help="The recorded robot, and its number now: 101, or 101=102. Default: the one that was sent the most.",
        ),
    ] = None,
    only: FilterOption = None,
    speed: Annotated[float, typer.Option("--speed", min=0.01, metavar="N", help="So many times faster.")] = 1.0,
    asap: Annotated[bool, typer.Option("--asap", help="Send as fast as answers come.")] = False,
    timeout: Annotated[
        float, typer.Option("--timeout", min=0.01, metavar="SECONDS", help="How long to wait for an answer.")
    ] = PATIENCE,
    strict: Annotated[
        bool, typer.Option("--strict", help="Compare numbers, too; sealed commands are differences.")
    ] = False,
    tolerance: Annotated[
        float, typer.Option("--tolerance", min=0.0, metavar="X", help="How much numbers may differ with --strict.")
    ] = 0.0,
    ignore: Annotated[
        list[str] | None,
        typer.Option("--ignore", metavar="FIELD", help="Do not compare this field; * is a wildcard; may be repeated."),
    ] = None,
    operator_key: OperatorKey = None,
    schemas: SchemasOption = None,
    json: Json = False,
) -> None:
    """Send again what clients sent in a recording, and compare the answers with the recorded ones.

    Commands move the robot. Ids and sequence numbers are new; control that was requested is released at the end.
    Messages, enumerations and texts are compared, numbers with --strict. Exit status 1: there are differences.

    Examples:
      jauspy replay run.pcap --to 192.0.2.7:3794
      jauspy replay run.mcap --asap --strict --ignore time_stamp
      jauspy replay run.mcap --from 42.1.1 --target 101=102 --speed 10
      jauspy replay run.mcap --operator-key alice.key
    """
    known = definitions(schemas)
    subsystem, now = _target(target)
    fits = None if only is None else Filter(only, known.registry)
    clients = [JausID.parse(text) for text in sender or ()]
    recording = load(file, known.registry, clients=clients, subsystem=subsystem, fits=fits, on_damage=console.note)
    connect = _connection(to)
    playback = Playback(
        speed=None if asap else speed,
        timeout=timeout,
        client=component_id(own_id(own, connect)),
        subsystem=now,
        comparison=Comparison(strict, tolerance, tuple(ignore or ())),
        operator=None if operator_key is None else load_key(operator_key),
    )

    async def transport(id: JausID) -> Transport:
        return await transport_for(id, connect)

    _announce(recording, playback)
    result = run(play(recording, known.registry, transport, playback))
    if result is None:  # ended by a signal
        return
    _show(result, recording, json=json)
    if result.differences:
        raise typer.Exit(1)


def _announce(recording: Recording, playback: Playback) -> None:
    seconds = recording.requests[-1].time
    how = "as fast as answers come" if playback.speed is None else f"in {seconds / playback.speed:.1f} s"
    clients = ", ".join(map(str, recording.clients))
    to = recording.subsystem if playback.subsystem is None else playback.subsystem
    console.note(f"{len(recording.requests)} messages of {clients} to subsystem {to}, {how}; Ctrl-C ends it")


def _show(result: Result, recording: Recording, *, json: bool) -> None:
    silent = [str(id) for id in recording.clients if id not in recording.heard]
    if json:
        for difference in result.differences:
            console.print_json(asdict(difference))
    else:
        console.print_lines(*(map(str, result.differences[:MAX_SHOWN]) if result.differences else ("no difference",)))
    if len(result.differences) > MAX_SHOWN and not json:
        console.note(f"{len(result.differences) + result.more - MAX_SHOWN} more; --json prints up to 10,000")
    if silent:
        console.note(f"the recording has no answers to {', '.join(silent)}: nothing to compare for these")
    if result.unsendable:
        console.note(f"{result.unsendable} messages could not be sent: too large, or too many at once")
    if result.sealed:
        console.note(
            f"{result.sealed} commands that an operator sealed were not sent: a seal is valid once. With "
            "--operator-key they are sealed anew, if the component has seals"
        )
    console.note(
        f"{result.sent} messages sent, {result.answers} answers and the reports of {result.events} events compared, "
        f"{len(result.differences) + result.more} differences"
    )


def _connection(to: str | None) -> str | None:
    """The value of `connect` for `--to`: a host and port alone are reached by UDP."""
    if to is None or "://" in to or to.startswith("local:"):
        return to
    return f"udp://{to}"


def _target(text: str | None) -> tuple[int | None, int | None]:
    """The recorded subsystem, and its number now."""
    if text is None:
        return None, None
    recorded, _, now = text.partition("=")
    numbers = [int(part) if part.isascii() and part.isdigit() else 0 for part in (recorded, now or recorded)]
    if not all(0 < number < ANY_SUBSYSTEM for number in numbers):
        raise ConfigError(f"--target {text}: write the number of a subsystem, as 101, or the one of now, too: 101=102")
    return numbers[0], numbers[1]
