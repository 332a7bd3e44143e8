"""What the linter finds, and what a rule is."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import Literal, TypeAlias

from jauspy.schema.lint.context import LintContext
from jauspy.schema.model import Location

Severity: TypeAlias = Literal["error", "warning", "hint"]
"""An error stops a tool or is sent wrongly, a warning may, a hint makes the definition harder to use."""

Problem: TypeAlias = tuple[Location, str]
"""Where, and a sentence with what to do."""


@dataclass(frozen=True, slots=True, order=True)
class LintFinding:
    """One finding; sorts by place."""

    file: str
    line: int
    code: str
    severity: Severity
    message: str

    def __str__(self) -> str:
        return f"{self.file}:{self.line}: {self.severity}: {self.code}: {self.message}"


@dataclass(frozen=True, slots=True)
class LintRule:
    """A code, what it stands for, and the function that looks for it in all files."""

    code: str
    severity: Severity
    summary: str
    check: Callable[[LintContext], Iterator[Problem]]
