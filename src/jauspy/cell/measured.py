"""What was measured of one run, as plain values for tables and files."""

from __future__ import annotations

from dataclasses import asdict, dataclass, field
from typing import Any


@dataclass(slots=True)
class Measured:
    """What was measured of one run."""

    seed: int
    task: str
    success: bool = False
    failure: str = ""
    """Why it did not succeed, in words."""
    duration: float = 0.0
    """Seconds of the cell's time."""
    wall: float = 0.0
    """Seconds of this machine's time; differs from run to run."""
    values: dict[str, float] = field(default_factory=dict)
    """Figures by name, SI units."""
    rows: list[dict[str, Any]] = field(default_factory=list)
    """Lines of a table."""

    def comparable(self) -> dict[str, Any]:
        """All that is the same in each run with this seed."""
        found = asdict(self)
        del found["wall"]
        return found
