"""`jauspy decode`: what captured or pasted bytes say."""

from __future__ import annotations

from enum import StrEnum
from typing import Annotated

import typer

from jauspy.cli.definitions import Beside, ServiceName, ServiceVersion


class What(StrEnum):
    """What pasted bytes are."""

    DATAGRAM = "datagram"
    MESSAGE = "message"


def decode(
    *,
    source: Annotated[
        str,
        typer.Argument(
            metavar="FILE|HEX|-", help="A pcap or pcapng file, a file of hex lines, hex text, or - for standard input."
        ),
    ],
    as_json: Annotated[bool, typer.Option("--json", help="One JSON object per datagram per line.")] = False,
    explain: Annotated[bool, typer.Option("--explain", help="Show every field's offset, bytes and raw value.")] = False,
    port: Annotated[
        str, typer.Option("--port", metavar="N|any", help="Only datagrams from or to this UDP port.")
    ] = "3794",
    what: Annotated[
        What | None,
        typer.Option("--as", help="What the hex text is. Default: a datagram (01 or 02 first), else a bare message."),
    ] = None,
    sources: Beside = None,
    service: ServiceName = None,
    version: ServiceVersion = None,
    message: Annotated[
        str | None, typer.Option("--message", metavar="NAME", help="The message meant where one service has several.")
    ] = None,
) -> None:
    """Print the JAUS messages in a capture file or in hex text.

    Values are in SI units and radians. Yellow lines say how bytes deviate from the definition. The exit status is 1
    when something could not be read.

    A message id is read as in the newest version of its service; where other versions differ, it is said. --service,
    --version and --message tell what is meant; ids that they do not speak of are read as without them.

    Examples:
      jauspy decode run.pcap --json
      jauspy decode --explain 02001000010a017e0014017e0002200200
      tcpdump -w - udp | jauspy decode -
      jauspy decode arm.pcap --from vendor/ --version 1.0
    """
    from jauspy.cli.definitions import definitions
    from jauspy.cli.sources import Reading, items
    from jauspy.cli.traffic import HumanPrinter, JsonPrinter

    known = definitions(sources)
    wanted = known.hints(service, version, message)
    reading = Reading(known.registry, wanted, _port(port), None if what is None else what.value)
    printer = JsonPrinter() if as_json else HumanPrinter(known if explain else None)
    for item in items(source, reading):
        printer.show(item)
    if printer.failed:
        raise typer.Exit(1)


def _port(text: str) -> int | None:
    if text == "any":
        return None
    if text.isdigit() and 0 < int(text) < 65536:
        return int(text)
    raise typer.BadParameter(f"{text!r} is neither a UDP port (1..65535) nor 'any'", param_hint="--port")
