"""`jauspy doctor`: find why two parties do not talk."""

from __future__ import annotations

import textwrap
from typing import Annotated, Final

import typer
from rich.text import Text

from jauspy.cli import client, console
from jauspy.cli.options import (
    DEFAULT_GROUP,
    DEFAULT_PORT,
    DEFAULT_ROOT,
    Interface,
    Json,
    LocalRoot,
    MulticastGroup,
    OperatorKey,
    Port,
)
from jauspy.cli.processes import run
from jauspy.errors import ConfigError
from jauspy.ids import JausID
from jauspy.inspection.doctor.examination import Examination, usable_interfaces
from jauspy.inspection.doctor.findings import Finding, Severity, has_failed
from jauspy.ocu.control import DEFAULT_AUTHORITY
from jauspy.ocu.sealing import load_key
from jauspy.printable import printable
from jauspy.transport.connect import udp_address

_STYLES: Final = {Severity.OK: "green", Severity.WARN: "yellow", Severity.FAIL: "bold red"}
_INDENT: Final = " " * 6


def doctor(
    peer: Annotated[
        str | None, typer.Argument(metavar="ID", help="The component that does not talk, as in 101.1.1.")
    ] = None,
    *,
    connect: Annotated[
        str | None,
        typer.Option(
            "--connect",
            metavar="WHERE",
            help="Where ID is, if discovery does not find it: udp://HOST[:PORT]; local:DIR is --local-root.",
        ),
    ] = None,
    port: Port = DEFAULT_PORT,
    group: MulticastGroup = DEFAULT_GROUP,
    interface: Interface = None,
    root: LocalRoot = DEFAULT_ROOT,
    authority: Annotated[
        int,
        typer.Option(
            "--authority", min=0, max=255, help="Authority that your client has; compared with what ID needs."
        ),
    ] = DEFAULT_AUTHORITY,
    operator: OperatorKey = None,
    quiet: Annotated[bool, typer.Option("--quiet", "-q", help="Print only what is not well.")] = False,
    as_json: Json = False,
) -> None:
    """Find why two parties do not talk, and how to mend it.

    It looks at this machine and its node manager, asks everybody on the network, and, with ID, one component in
    detail. It only asks: it takes no control and changes nothing. The exit status is 1 if something fails.

    Examples:
      jauspy doctor
      jauspy doctor 101.1.102
      jauspy doctor 101.1.102 --connect udp://192.168.1.20 --authority 200
    """
    if connect is not None and (named := client.local_root(connect)) is not None:
        root, connect = named, None
    id = None if peer is None else client.destination(peer)
    if id is not None and id.is_wildcard:
        raise ConfigError(f"{id} is not one component; `jauspy doctor` without an id examines the network")
    if connect is not None and id is None:
        raise typer.BadParameter(
            "name the component to ask there, as in `jauspy doctor 101.1.1`", param_hint="--connect"
        )
    chosen = tuple(interface or ())
    used = usable_interfaces(chosen)
    examination = Examination(
        ids=tuple(JausID.parse(client.own_id(None, f"local:{root}")) for _ in used),
        used_interfaces=used,
        root=root,
        chosen=chosen,
        port=port,
        group=group,
        peer=id,
        address=None if connect is None else _address(connect),
        authority=authority,
        key=None if operator is None else load_key(operator),
    )
    found = []
    for finding in examination.findings():
        found.append(finding)
        if as_json:
            console.print_json(finding.as_json())
        elif not quiet or finding.severity is not Severity.OK:
            _show(finding)
    if not as_json:
        counts = {severity: sum(finding.severity is severity for finding in found) for severity in Severity}
        console.print_lines("", ", ".join(f"{count} {severity}" for severity, count in counts.items()))
    if has_failed(found):
        raise typer.Exit(1)


def _address(connect: str) -> tuple[str, int]:
    if not connect.startswith("udp://"):
        raise typer.BadParameter(f"{connect!r} is not udp://HOST[:PORT] or local:DIR", param_hint="--connect")
    found = run(udp_address(connect))
    if found is None:
        raise typer.Exit(130)
    return found


def _show(finding: Finding) -> None:
    """A line with the finding, and below it the evidence and the fix of what is not well."""
    rows = [("", f"{finding.check}: {finding.what}", "")]
    if finding.severity is not Severity.OK:
        rows += [("seen: ", finding.evidence, "dim")] if finding.evidence else []
        rows += [("fix:  ", finding.fix, "")]
    first = Text(f"{finding.severity:<6}", _STYLES[finding.severity])
    for label, text, style in rows:
        for line in _wrapped(label, printable(text)):
            console.stdout().print(Text.assemble(first, (line, style)))
            first = Text(_INDENT)


def _wrapped(label: str, text: str) -> list[str]:
    """The text behind its label: wrapped on terminals, one line in pipes."""
    if not console.is_terminal():
        return [label + text]
    width = max(40, console.stdout().width - len(_INDENT))
    return textwrap.wrap(text, width, initial_indent=label, subsequent_indent=" " * len(label), break_long_words=False)
