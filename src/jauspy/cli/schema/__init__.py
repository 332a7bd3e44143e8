"""`jauspy schema`: read, check, compare and use JSIDL definitions."""

from __future__ import annotations

from collections.abc import Callable
from typing import Final

import typer

from jauspy.cli.help import help_text
from jauspy.cli.schema import diff, generate, lint, ls, show

app = typer.Typer(
    name="schema",
    no_args_is_help=True,
    help="Read, check, compare and use service definitions (JSIDL): those built in, and your own.",
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
