"""`jauspy console`: the operator's console in the browser."""

from __future__ import annotations

import asyncio
import re
import stat
import sys
import webbrowser
from collections.abc import Iterator
from contextlib import AbstractContextManager, contextmanager, nullcontext
from html import escape
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import TYPE_CHECKING, Annotated, Final

import typer

from jauspy.cli import client, console
from jauspy.cli.beside import CONSOLE_PORT, CONSOLE_READY, NEEDS_CONSOLE
from jauspy.cli.options import Connect, Json, OperatorKey, OwnId, WithParent
from jauspy.cli.processes import end_with_parent, run
from jauspy.errors import ConfigError
from jauspy.ocu import OCU
from jauspy.user_files import read_file

if TYPE_CHECKING:
    from jauspy.robot.audit import AuditLog

USERS_FILE: Final = Path("console-users.toml")
CERTIFICATE_FILE: Final = Path("console-certificate.pem")
KEY_FILE: Final = Path("console-key.pem")
MIN_TOKEN: Final = 16
MAX_TOKEN: Final = 256
TOKEN: Final = re.compile(rf"[A-Za-z0-9_-]{{{MIN_TOKEN},{MAX_TOKEN}}}")
UsersFile = Annotated[Path, typer.Option("--users", metavar="FILE", help="The file of users.")]

app = typer.Typer(name="console", add_completion=False, pretty_exceptions_enable=False, rich_markup_mode="rich")
user_app = typer.Typer(name="user", no_args_is_help=True, help="Edit the file of users who may log in to the console.")
app.add_typer(user_app)


@app.callback(invoke_without_command=True)
def console_page(
    context: typer.Context,
    *,
    port: Annotated[
        int, typer.Option("--port", min=0, max=65535, help="The port of the page; 0 is any free one.")
    ] = CONSOLE_PORT,
    host: Annotated[
        str,
        typer.Option(
            "--host",
            metavar="ADDRESS",
            help="Address to listen at; other than loopback only with --users, --certificate and --key.",
        ),
    ] = "127.0.0.1",
    users: Annotated[Path | None, typer.Option("--users", metavar="FILE", help="Who may log in.")] = None,
    certificate: Annotated[
        Path | None, typer.Option("--certificate", metavar="FILE", help="The certificate for TLS (PEM).")
    ] = None,
    key: Annotated[Path | None, typer.Option("--key", metavar="FILE", help="The key of the certificate (PEM).")] = None,
    token_file: Annotated[
        Path | None,
        typer.Option(
            "--token-file",
            metavar="FILE",
            help="A token for bookmarks, in a file that only you may read; by default a new one for each start.",
        ),
    ] = None,
    audit: Annotated[
        Path | None,
        typer.Option(
            "--audit",
            metavar="FILE",
            help="Audit log: each command with its user.  [default: with --users FILE: FILE.audit]",
        ),
    ] = None,
    recordings: Annotated[
        Path | None,
        typer.Option("--recordings", metavar="DIR", help="Where video is recorded; ~/jauspy-recordings by default."),
    ] = None,
    poses: Annotated[
        Path | None,
        typer.Option("--poses", metavar="FILE", help="Named poses of arms: TOML with a table [ROBOT.POSE] for each."),
    ] = None,
    map: Annotated[
        Path | None,
        typer.Option("--map", metavar="FILE", help="Offline map: .mbtiles, or GeoTIFF (extra geo)."),
    ] = None,
    robot: Annotated[
        int | None,
        typer.Option("--robot", metavar="NUMBER", min=1, max=65534, help="The robot that the page shows first."),
    ] = None,
    no_browser: Annotated[bool, typer.Option("--no-browser", help="Do not open a browser.")] = False,
    connect: Connect = None,
    own_id: OwnId = None,
    operator_key: OperatorKey = None,
    with_parent: WithParent = False,
) -> None:
    """Operate robots in the browser: cameras, driving, arm, emergency stop.

    The console finds every robot that the node manager of this machine reaches. It shows the cameras of the one that
    you choose, drives it by keys, stick or gamepad, and moves its arm. A robot stops when the key is released or the
    page is closed. Escape stops all robots.

    The address that it prints contains a token, without which other users of this machine cannot open it.

    Examples:
      jauspy console
      jauspy console --host 0.0.0.0 --users users.toml --certificate certificate.pem --key key.pem
    """
    if context.invoked_subcommand is not None:
        return
    try:
        from jauspy.console.console import RECORDINGS
        from jauspy.console.killed_console import Watchdog
        from jauspy.console.map_tiles import open_map
        from jauspy.console.saved_files import read_poses
        from jauspy.console.server import Access, serving
    except ImportError as error:
        raise ConfigError(f"{NEEDS_CONSOLE} ({error})") from error
    if with_parent:
        end_with_parent()
    console.log_to_stderr("WARNING")

    if token_file is not None and users is not None:
        raise ConfigError(
            "--token-file is for a console without --users, whose users log in with passwords; leave out one"
        )
    if audit is None and users is not None:
        audit = users.with_name(f"{users.name}.audit")
    named_poses = None if poses is None else read_poses(poses)
    tiles = None if map is None else open_map(map)
    access = Access(users, certificate, key, "" if token_file is None else _read_token(token_file))

    async def serve() -> None:
        with _audit_log(audit) as log:
            await serve_with(log)

    async def serve_with(log: AuditLog | None) -> None:
        ocu = client.make_ocu(own_id, connect, 0.5, operator=operator_key)
        async with ocu:
            stopper = OCU(client.own_id(None, connect), connect, operator=operator_key, name="jauspy console (stop)")
            watchdog = Watchdog(ocu.id, connect, operator_key)
            page = serving(
                ocu,
                stopper,
                host,
                port,
                access=access,
                audit=log,
                recordings=recordings or RECORDINGS,
                watchdog=watchdog,
                poses=named_poses,
                robot=robot,
                map=tiles,
            )
            async with stopper, watchdog, page as url:
                shown = url if token_file is None else url.partition("?")[0]
                console.print_lines(f"{CONSOLE_READY} {shown}", *_hints(users, token_file), "stop it: Ctrl-C")
                with nullcontext() if no_browser else _browser_at(url):
                    await asyncio.Event().wait()

    run(serve())


def _read_token(path: Path) -> str:
    """The token in a file; raises `ConfigError`."""
    token = read_file(path).decode("utf-8", "replace").strip()
    if path.stat().st_mode & (stat.S_IRWXG | stat.S_IRWXO):
        raise ConfigError(f"{path}: other users may read or change this token; do: chmod 600 {path}")
    if not TOKEN.fullmatch(token):
        raise ConfigError(
            f"{path}: a token has {MIN_TOKEN} to {MAX_TOKEN} letters, digits, - and _; make one: "
            f"openssl rand -hex 32 > {path}"
        )
    return token


def _hints(users: Path | None, token_file: Path | None) -> list[str]:
    """Lines for the operator about the token, at a console without users."""
    return [] if users is not None or token_file is None else [f"open it with /?token= and the token in {token_file}"]


@contextmanager
def _browser_at(url: str) -> Iterator[None]:
    """Open the browser; its arguments, which all users of this machine can read, do not contain the token."""
    if "?" not in url:
        webbrowser.open(url)
        yield
        return
    with TemporaryDirectory(prefix="jauspy-console-") as folder:  # for this user only
        page = Path(folder) / "console.html"
        page.write_text(
            f'<!doctype html><meta http-equiv="refresh" content="0; url={escape(url)}">\n', encoding="utf-8"
        )
        webbrowser.open(page.as_uri())
        yield


def _audit_log(path: Path | None) -> AbstractContextManager[AuditLog | None]:
    if path is None:
        return nullcontext()
    from jauspy.robot.audit import AuditLog

    return AuditLog(path, "console", follow_links=True)


@user_app.command("add")
def add(
    name: Annotated[str, typer.Argument(metavar="NAME", help="Letters, digits, _ and -.")],
    *,
    role: Annotated[str, typer.Option("--role", metavar="ROLE", help="observer, operator or supervisor.")] = "operator",
    users: UsersFile = USERS_FILE,
) -> None:
    """Add a user, or give a user another password and role. The password is asked for, or read from a pipe.

    Example:
      jauspy console user add anna --users users.toml
    """
    from jauspy.console.users import add_user

    if sys.stdin.isatty():
        password = typer.prompt(f"password of {name}", hide_input=True, confirmation_prompt=True, err=True)
    else:
        password = sys.stdin.readline().rstrip("\n")
    replaced = add_user(users, name, role, password)
    console.note(
        f"{users}: {name} is {'changed' if replaced else 'added'}, {role}; it takes effect when the console starts"
    )


@user_app.command("remove")
def remove(
    name: Annotated[str, typer.Argument(metavar="NAME", help="As `jauspy console user ls` lists it.")],
    *,
    users: UsersFile = USERS_FILE,
) -> None:
    """Remove a user.

    Example:
      jauspy console user remove anna --users users.toml
    """
    from jauspy.console.users import remove_user

    remove_user(users, name)
    console.note(f"{users}: {name} is removed; it takes effect when the console starts")


@user_app.command("ls")
def ls(*, users: UsersFile = USERS_FILE, as_json: Json = False) -> None:
    """List the users with their roles and authorities.

    Example:
      jauspy console user ls --users users.toml
    """
    from jauspy.console.users import Users

    if as_json:
        for user in Users(users):
            console.print_json({"name": user.name, "role": user.role, "authority": user.authority})
        return
    console.print_table(
        ("NAME", "ROLE", "AUTHORITY"), [(User.name, User.role, str(User.authority)) for User in Users(users)]
    )


@app.command("certificate")
def make_certificate(
    names: Annotated[list[str], typer.Argument(metavar="HOST...", help="Names and addresses of this machine.")],
    *,
    output: Annotated[Path, typer.Option("-o", "--output", metavar="FILE", help="The certificate.")] = CERTIFICATE_FILE,
    key: Annotated[Path, typer.Option("--key", metavar="FILE", help="The private key of the certificate.")] = KEY_FILE,
) -> None:
    """Make a self-signed certificate that is valid for a year. Browsers warn about it once; compare the fingerprint.

    Example:
      jauspy console certificate ground-station.local 192.168.1.20
    """
    from jauspy.console.certificates import make_certificate as make

    fingerprint = make(names, output, key)
    console.print_lines(f"{output} and {key} are written", f"SHA-256 fingerprint: {fingerprint}")
