"""`jauspy new`: starts for what a user writes: a service definition, a component."""

from __future__ import annotations

from collections.abc import Callable
from typing import Final

import typer

from jauspy.cli.help import help_text
from jauspy.cli.new import component, definition

app = typer.Typer(
    name="new",
    no_args_is_help=True,
    help="Write a start: of a service definition (JSIDL), or of a component with tests.",
)

VERBS: Final[dict[str, Callable[..., None]]] = {
    "component": component.component,
    "definition": definition.definition,
}
for name, verb in VERBS.items():
    app.command(name, help=help_text(verb.__doc__ or ""))(verb)
