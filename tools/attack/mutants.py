"""Defects that victims can be given, to test that the attacks notice them: `python -m tools.attack --mutant NAME`.

`observed.py` applies a mutant in the process of a victim, before the command starts. No product code knows of them.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, Final

from jauspy.protocol import sources
from jauspy.services.core import access_control


@dataclass(frozen=True, slots=True)
class Mutant:
    """A defect: `patch` makes it; `noticed_by` names the attacks that break a bound because of it."""

    patch: Callable[[], None]
    noticed_by: tuple[str, ...]


def replaced(owner: Any, name: str, value: Any) -> Callable[[], None]:
    """A patch that replaces an attribute."""

    def patch() -> None:
        if not hasattr(owner, name):
            raise AttributeError(f"{owner} has no {name}: this mutant is out of date")
        setattr(owner, name, value)

    return patch


MUTANTS: Final[dict[str, Mutant]] = {
    "anybody-controls": Mutant(
        replaced(access_control.AccessControl, "is_controlling_client", lambda *_: True), ("commands",)
    ),
    "any-source": Mutant(replaced(sources.SourceChecks, "check_address", lambda *_, **__: True), ("commands",)),
}


def apply(name: str) -> None:
    """Give this process a defect."""
    MUTANTS[name].patch()
