"""`jauspy keys` makes the keys of operators; `jauspy audit` verifies an audit log."""

from __future__ import annotations

import os
import re
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, Final

import typer

from jauspy.cli import console
from jauspy.cli.options import Json
from jauspy.errors import ConfigError
from jauspy.ocu.sealing import load_key
from jauspy.printable import printable
from jauspy.protocol.seal import OperatorKey

if TYPE_CHECKING:
    from jauspy.robot.audit import AuditReport

_NAME: Final = re.compile(r"[A-Za-z0-9_-]{1,64}")
Role = Annotated[
    str, typer.Option("--role", metavar="ROLE", help="The role that is printed: observer, operator or supervisor.")
]


def new(
    *,
    name: Annotated[str, typer.Argument(metavar="NAME", help="The operator's name, as in alice.")],
    output: Annotated[
        Path | None, typer.Option("--output", "-o", metavar="FILE", help="The file to write.  [default: NAME.key]")
    ] = None,
    role: Role = "operator",
) -> None:
    """Write a new key, and print what to add to the robots' operators file.

    The key file is readable by its owner only, and stays with the operator. Robots need the printed lines only, which
    are not secret.

    Example:
      jauspy keys new alice >> operators.toml
    """
    _check_word(name, "NAME")
    key = OperatorKey.generate()
    lines = _lines(name, role, key)
    file = output or Path(f"{name}.key")
    try:
        descriptor = os.open(file, os.O_WRONLY | os.O_CREAT | os.O_EXCL, 0o600)
        with os.fdopen(descriptor, "wb") as stream:
            stream.write(key.pem())
    except FileExistsError as error:
        raise ConfigError(f"{file} exists; a new key would replace it, so remove it or choose --output") from error
    except OSError as error:
        raise ConfigError(f"cannot write {file}: {error.strerror}") from error
    console.note(f"{file} is written; keep it secret. Add these lines to the end of the robots' operators file")
    console.print_lines(*lines)


def show(
    *,
    file: Annotated[Path, typer.Argument(metavar="FILE", help="The file of a key, as in alice.key.")],
    name: Annotated[
        str | None,
        typer.Option("--name", metavar="NAME", help="The printed name.  [default: that of the file]"),
    ] = None,
    role: Role = "operator",
) -> None:
    """Print the lines for the robots' operators file again.

    Example:
      jauspy keys show alice.key
    """
    console.print_lines(*_lines(name or file.stem, role, load_key(file)))


def audit(
    *,
    path: Annotated[Path, typer.Argument(metavar="PATH", help="The audit log, as `audit_log` of a robot names it.")],
    head: Annotated[
        list[str] | None,
        typer.Option("--head", metavar="NUMBER:HASH", help="A head that was noted earlier; may be repeated."),
    ] = None,
    heads: Annotated[
        Path | None,
        typer.Option(
            "--heads",
            metavar="FILE",
            help="What another machine has collected from `jauspy up --audit-heads-to`, as its syslog's file.",
        ),
    ] = None,
    operators: Annotated[
        Path | None,
        typer.Option("--operators", metavar="FILE", help="The operators file, to verify the signatures of commands."),
    ] = None,
    as_json: Json = False,
) -> None:
    """Verify an audit log: name the first line that was changed or removed, or cut off at the end.

    Keep the printed head elsewhere, or have heads sent: with --head or --heads, changes to any line up to them are
    detected, also those by somebody who can write to the robot's disk. The exit status is 1 if the log was changed.

    Example:
      jauspy audit robot.audit --operators operators.toml
    """
    from jauspy.robot import audit as log, operators as file

    anchors = [log.Head.parse(text) for text in head or ()]
    report = log.verify(path, anchors, file.load(operators) if operators is not None else (), heads)
    if as_json:
        console.print_json(_object(path, report))
    else:
        _print(path, report, signed=operators is not None)
    if report.problem:
        raise ConfigError(f"{path}: {report.problem}")


def _object(path: Path, report: AuditReport) -> dict[str, Any]:
    return {
        "file": str(path),
        "lines": report.head.number,
        "commands": dict(report.commands.most_common()),
        "refused": report.refused,
        "verified": report.verified,
        "unverifiable": report.unverifiable,
        "not_recorded": report.not_recorded,
        "head": str(report.head),
        "problem": report.problem or None,
    }


def _print(path: Path, report: AuditReport, *, signed: bool) -> None:
    commands = ", ".join(f"{number} of {printable(name)}" for name, number in report.commands.most_common())
    console.print_lines(f"{path}: {report.head.number} lines; commands: {commands or 'none'}; {report.refused} refused")
    if signed:
        too_long = f"; {report.unverifiable} are not known, of long commands" if report.unverifiable else ""
        console.print_lines(f"signatures: {report.verified} verified{too_long}")
    if report.not_recorded:
        console.print_lines(f"not recorded: {report.not_recorded}, since they were too many or the disk too slow")
    console.print_lines(f"head: {report.head}")


def _lines(name: str, role: str, key: OperatorKey) -> tuple[str, ...]:
    """The lines of a TOML table; they may follow any other content of the file."""
    return (
        f"[operators.{_check_word(name, 'NAME')}]",
        f'role = "{_check_word(role, "--role")}"',
        f'key = "{key.public}"',
    )


def _check_word(text: str, what: str) -> str:
    if not _NAME.fullmatch(text):
        raise ConfigError(f"{what}: {text!r} has other characters than letters, digits, _ and -")
    return text
