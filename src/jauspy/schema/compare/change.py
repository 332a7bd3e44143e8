"""One difference."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal


@dataclass(frozen=True, slots=True)
class Change:
    """A difference and the field path where it is; the path is empty for a whole message or machine.

    `wire`: bytes, numbers or allowed values differ. `units`: the same numbers in other units. `name`: the same bytes
    are called differently. `behavior`: what a service does differs.
    """

    kind: Literal["wire", "units", "name", "behavior"]
    path: str
    text: str

    def __str__(self) -> str:
        return f"{self.path}: {self.text}" if self.path else self.text
