"""The progress of a campaign of many runs, on standard error."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from typing import TypeVar

from jauspy.cli import console

_Result = TypeVar("_Result")


def with_progress(
    what: str, total: int, results: Iterable[_Result], failures: Callable[[_Result], int]
) -> Iterator[_Result]:
    """Pass results on, and show a progress bar with the number of failures, of which a result may have several."""
    from rich.progress import Progress

    failed = 0
    with Progress(console=console.stderr()) as progress:
        bar = progress.add_task(what, total=total)
        for result in results:
            failed += failures(result)
            progress.update(bar, advance=1, description=f"{what}, {failed} failed" if failed else what)
            yield result
