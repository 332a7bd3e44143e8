"""`jauspy schema`: read, check, compare and use JSIDL definitions."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, Final

import typer
import typer.core

from jauspy.cli import console
from jauspy.cli.help import help_text
from jauspy.cli.schema import diff, generate, lint, ls, show
from jauspy.errors import JausError


class Verbs(typer.core.TyperGroup):
    """What cannot be done has exit status 2 here, for 1 is an answer: something was found, something differs."""

    def invoke(self, ctx: Any) -> Any:
        """Run the verb; with `--debug` errors keep their traceback."""
        try:
            return super().invoke(ctx)
        except JausError as error:
            if ctx.find_root().params.get("debug"):
                raise
            console.error(str(error))
            raise typer.Exit(2) from None


app = typer.Typer(
    cls=Verbs,
    name="schema",
    no_args_is_help=True,
    help="Read, check, compare and use service definitions (JSIDL): those built in, and your own.\n\n"
    "Exit status of every verb: 0 done, 1 lint found something or diff a difference, 2 wrong use, or a name or file "
    "that is not there or cannot be read.",
)

VERBS: Final[dict[str, Callable[..., None]]] = {
    "ls": ls.ls,
    "show": show.show,
    "lint": lint.lint,
    "diff": diff.diff,
    "generate": generate.generate,
}
for name, verb in VERBS.items():
    app.command(name, help=help_text(verb.__doc__ or ""))(verb)
