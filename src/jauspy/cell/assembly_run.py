"""The assembly as a task, with what the judge measures of it."""

from __future__ import annotations

from dataclasses import asdict

from jauspy.cell.assembly import Assembler, AssemblyResult
from jauspy.cell.judge import Placement
from jauspy.cell.measured import Measured
from jauspy.cell.session import Session


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
