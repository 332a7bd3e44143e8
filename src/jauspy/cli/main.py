"""The `jauspy` command: its verbs, and what becomes of errors, Ctrl-C and closed pipes."""

from __future__ import annotations

import errno
import os
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Annotated, Any, Final

import typer
import typer.core

from jauspy import __version__
from jauspy.cli import (
    conformance,
    console,
    decode,
    demo,
    fuzz,
    ls,
    map_robot,
    new,
    node_manager,
    query,
    schema,
    send,
    still,
    tf,
    up,
    video,
)
from jauspy.cli.help import help_text
from jauspy.errors import JausError

FULL: Final = frozenset({errno.ENOSPC, errno.EDQUOT, errno.EFBIG, errno.EIO})
"""What writing results can fail with, and nobody but the user can mend."""


class Verbs(typer.core.TyperGroup):
    """Turns errors into one sentence and an exit status: 1 failed, 2 wrong use, 130 Ctrl-C."""

    def invoke(self, ctx: Any) -> Any:
        """Run the verb; with `--debug` errors keep their traceback."""
        try:
            try:
                return super().invoke(ctx)
            finally:
                sys.stdout.flush()
        except BrokenPipeError:
            # Whoever reads has had enough, as in `jauspy decode ... | head`.
            console.discard_stdout()
            raise typer.Exit(0) from None
        except JausError as error:
            if ctx.params.get("debug"):
                raise
            console.error(str(error))
            raise typer.Exit(1) from None


app = typer.Typer(
    cls=Verbs,
    name="jauspy",
    no_args_is_help=True,
    add_completion=False,
    pretty_exceptions_enable=False,
    rich_markup_mode="rich",
    context_settings={"help_option_names": ["-h", "--help"]},
)


def _version(value: bool) -> None:
    if value:
        print(f"jauspy {__version__}")
        raise typer.Exit


@app.callback()
def _options(
    debug: Annotated[
        bool, typer.Option("--debug", help="Show the traceback of an error.", envvar="JAUSPY_DEBUG")
    ] = False,
    version: Annotated[
        bool, typer.Option("--version", callback=_version, is_eager=True, help="Print the version.")
    ] = False,
) -> None:
    """JAUS for Python: talk to unmanned ground vehicles, be one, or read what others say.

    Ids are SUBSYSTEM.NODE.COMPONENT, as in 101.1.102. Values are in SI units and radians.

    Try it: [bold]jauspy demo[/], or [bold]jauspy up inc1[/] in one terminal and [bold]jauspy ls[/] in another.
    """


VERBS: Final[dict[str, Callable[..., None]]] = {
    "demo": demo.demo,
    "up": up.up,
    "node-manager": node_manager.node_manager,
    "ls": ls.ls,
    "query": query.query,
    "send": send.send,
    "tf": tf.tf,
    "map": map_robot.map_robot,
    "video": video.video,
    "still": still.still,
    "decode": decode.decode,
    "conformance": conformance.conformance,
}
for name, verb in VERBS.items():
    app.command(name, help=help_text(verb.__doc__ or ""))(verb)
app.add_typer(new.app)
app.add_typer(schema.app)
app.add_typer(fuzz.app)


def main() -> None:
    """The console script."""
    if not _open_streams():
        console.error("standard output is closed; write `>/dev/null` to do without it")
        sys.exit(1)
    try:
        app()
    except OSError as error:
        if error.errno not in FULL or "--debug" in sys.argv:
            raise
        console.discard_stdout()
        console.error(f"the results cannot be written: {error.strerror}")
        sys.exit(1)


def _open_streams() -> bool:
    """Give closed standard streams a meaning, so that no socket gets their number; false when results have no place.

    A closed standard input is an empty one, and errors go nowhere without standard error.
    """
    has_output = sys.stdout is not None
    for name, mode in (("stdin", "r"), ("stdout", "w"), ("stderr", "w")):
        if getattr(sys, name) is None:
            setattr(sys, name, Path(os.devnull).open(mode, encoding="utf-8"))  # noqa: SIM115 - until the process ends
    return has_output


if __name__ == "__main__":
    main()
