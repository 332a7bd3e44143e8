"""One seeded run of each task on virtual time, and what was measured of it, as plain values for tables and files."""

from __future__ import annotations

import time
from collections.abc import Callable, Coroutine
from dataclasses import asdict, dataclass, field
from pathlib import Path
from typing import Any, Final, TypeAlias

from jauspy.cell.assembly import Assembler, AssemblyResult
from jauspy.cell.judge import Placement
from jauspy.cell.session import Disturbances, Session, simulated
from jauspy.errors import JausError


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


async def assemble(session: Session, seed: int) -> Measured:
    """Build the arm with five joints, and measure how the parts sit."""
    result, _ = await assembled(session, seed)
    return measured_assembly(session, seed, result)


async def assembled(session: Session, seed: int) -> tuple[AssemblyResult, Assembler]:
    """Build the arm with five joints; the assembler goes on from there."""
    assembler = Assembler(session.cell, session.layout, seed=seed)
    return await assembler.build(), assembler


def measured_assembly(session: Session, seed: int, result: AssemblyResult) -> Measured:
    """The figures of an assembly, with the placement errors by the judge when there is one."""
    found = Measured(seed, "assemble", not result.failure, result.failure, result.duration)
    placements = _placements(session)
    for row in result.parts:
        placed = placements.get(row.part)
        line = asdict(row)
        line |= {"error": placed.distance, "error_tilt": placed.tilt, "error_turn": placed.turn} if placed else {}
        found.rows.append(line)
    joined = [placements[row.part] for row in result.parts if row.part in placements]
    found.values = {
        "parts": float(len(joined)),
        "retries": float(result.retries),
        "clearance": result.clearance.distance,
        "largest_error": max((each.distance for each in joined), default=0.0),
        "largest_tilt": max((each.tilt for each in joined), default=0.0),
        "saved_by_schedule": result.timeline.saved,
    }
    if found.success and placements and len(joined) < len(result.parts):
        found.success = False
        found.failure = f"only {len(joined)} of {len(result.parts)} parts are attached in the end"
    return found


def _placements(session: Session) -> dict[str, Placement]:
    if session.judge is None:
        return {}
    judge = session.judge
    return {part: judge.placement(at, part) for at, part in judge.attached().items() if at != "gripper"}


Task: TypeAlias = Callable[[Session, int], Coroutine[Any, Any, Measured]]

TASKS: Final[dict[str, Task]] = {"assemble": assemble}
"""The tasks that can be run by name, each in a fresh cell."""


async def run_one(
    task: str, seed: int, disturbances: Disturbances | None = None, *, film: Path | None = None
) -> Measured:
    """One run. A task that raises is a failure with that reason."""
    begun = time.perf_counter()
    async with simulated(seed, disturbances, film=film) as session:
        start = session.cell.now()
        try:
            found = await TASKS[task](session, seed)
        except JausError as error:
            found = Measured(seed, task, failure=str(error), duration=session.cell.now() - start)
    found.wall = time.perf_counter() - begun
    return found
