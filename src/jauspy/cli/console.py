"""Where the verbs write: results to stdout, everything else to stderr; colours on terminals only."""

from __future__ import annotations

import os
import sys
from functools import cache
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from rich.console import Console


@cache
def _console(*, stderr: bool, width: int | None = None) -> Console:
    from rich.console import Console

    class Piped(Console):
        """Leaves a closed pipe to `main`; rich itself would end with status 1."""

        def on_broken_pipe(self) -> None:
            raise  # noqa: PLE0704 - rich calls this while it handles the error

    return Piped(stderr=stderr, highlight=False, emoji=False, soft_wrap=True, width=width)


def stdout(pipe_width: int | None = None) -> Console:
    """The console for results. Lines are never wrapped or cut, so that they can be searched and piped.

    Tables are as wide as the terminal; `pipe_width`: columns of tables that go elsewhere.
    """
    return _console(stderr=False, width=None if is_terminal() else pipe_width)


def stderr() -> Console:
    """The console for what accompanies the results."""
    return _console(stderr=True)


def error(message: str) -> None:
    """One red sentence on stderr; lines after the first explain it and stay plain."""
    from rich.text import Text

    sentence, newline, rest = message.partition("\n")
    stderr().print(Text.assemble(("Error: ", "bold red"), (sentence, "red"), newline, rest))


def note(message: str) -> None:
    """One dim line on stderr."""
    from rich.text import Text

    stderr().print(Text(message, style="dim"))


def discard_stdout() -> None:
    """What could not be written must not be tried again, with a complaint, when the interpreter ends."""
    os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())


def is_terminal() -> bool:
    """True when results go to a person's terminal and not into a pipe or file."""
    return sys.stdout.isatty()


def is_interactive() -> bool:
    """True when a person sees results and notes on one terminal, so that there may be something live."""
    return sys.stdout.isatty() and sys.stderr.isatty()
