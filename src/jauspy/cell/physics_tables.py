"""Tables of what the simulation measured, for the page of results: of one run, and of many seeds."""

from __future__ import annotations

import math
from collections.abc import Sequence
from statistics import median

from jauspy.cell.measurements import BATTERY_CHARGE, BATTERY_ENERGY, BATTERY_VOLTAGE, Measured, figure_text
from jauspy.cell.physics import GENTLE_FORCE, GENTLE_SPEED, Meeting, Physics
from jauspy.cell.report import Promise, Table

JOULES = 3600.0
"""Joules in a watt hour."""
MOST_ROWS = 200
"""Rows of a table; those beyond are counted in its note."""


def gentle(found: Measured) -> list[Promise]:
    """What is promised of each task's physics: soft attachments, and no contacts that no grasp explains."""
    physics = found.physics
    assert physics is not None
    figures = physics.figures()
    soft = [row for row in physics.attaches if row.speed <= GENTLE_SPEED and row.force <= GENTLE_FORCE]
    attached = f"{len(soft)} of {len(physics.attaches)}"
    if physics.attaches:
        attached += f", at most {_mm(figures['attach speed'])} mm/s and {figures['attach force']:.0f} N"
    touched = "none"
    if physics.collisions:
        worst = max(physics.collisions, key=lambda meeting: meeting.force)
        touched = f"{len(physics.collisions)}, the hardest {worst.first} on {worst.second}: {worst.force:.0f} N"
    heaviest = max(physics.loads, key=lambda load: load.utilisation, default=None)
    strong = "no connector held anything"
    if heaviest is not None:
        share = f"{100.0 * heaviest.utilisation:.0f} % of its strength"
        strong = f"{heaviest.connector} ({heaviest.kind}) with {heaviest.part}: at most {share}"
    return [
        Promise(
            f"{found.task}: loads of connectors",
            "below their strength",
            strong,
            heaviest is None or heaviest.utilisation < 1.0,
        ),
        Promise(
            f"{found.task}: attachments below {1e3 * GENTLE_SPEED:g} mm/s and {GENTLE_FORCE:g} N",
            "all",
            attached,
            len(soft) == len(physics.attaches),
        ),
        Promise(f"{found.task}: contacts of the UR10 that no grasp explains", "none", touched, not physics.collisions),
        Promise(
            f"{found.task}: motions that the UR10 ended for a contact that it did not have",
            "none",
            f"{physics.stops} ended, {len(physics.collisions)} contacts",
            physics.stops <= len(physics.collisions),
        ),
    ]


def energy_table(runs: Sequence[Measured]) -> Table | None:
    """What modules drew in each task, and from which batteries; None without a run of which that is known."""
    rows: list[Sequence[str]] = [
        ("task", "time, s", "modules, Wh", "mean, W", "battery", "from it, Wh", "left, %", "voltage, V")
    ]
    for run in runs:
        if "energy" not in run.values:
            continue
        energy = run.values["energy"]
        mean = f"{energy / run.duration:.1f}" if run.duration else "-"
        own = (run.task, f"{run.duration:.1f}", f"{energy / JOULES:.3f}", mean)
        names = [name.removeprefix(BATTERY_ENERGY) for name in run.values if name.startswith(BATTERY_ENERGY)]
        figures = [
            (
                name,
                f"{run.values[BATTERY_ENERGY + name] / JOULES:.3f}",
                f"{100.0 * run.values[BATTERY_CHARGE + name]:.1f}",
                f"{run.values[BATTERY_VOLTAGE + name]:.2f}",
            )
            for name in names
        ]
        rows += [(*own, *battery) for battery in figures or [("none", "", "", "")]]
    note = "Measured by the simulation at each step: windings, mechanical work, electronics, pumps. Without the UR10."
    return Table("Energy of the modules in each task", rows, note) if len(rows) > 1 else None


def physics_tables(physics: Physics) -> list[Table]:
    """The figures of one run: the largest ones, each meeting, and each joint."""
    largest: list[Sequence[str]] = [("figure", "value")]
    largest += [(name, figure_text(name, value)) for name, value in physics.figures().items()]
    tables = [Table("Measured by the simulation: the largest figures", largest)]
    if physics.joints:
        rows: list[Sequence[str]] = [
            (
                "joint of the UR10",
                "speed, degrees/s",
                "torque, N m",
                "error in motion, mrad",
                "error at ends, mrad",
                "ends",
            )
        ]
        rows += [
            (
                name,
                f"{math.degrees(joint.speed):.0f}",
                f"{joint.torque:.1f}",
                f"{1e3 * joint.error:.2f}",
                f"{1e3 * joint.end_error:.2f}",
                str(joint.ends),
            )
            for name, joint in physics.joints.items()
        ]
        tables.append(Table("Measured by the simulation: joints of the UR10", rows))
    if physics.loads:
        tables.append(_loads(physics))
    for name, first, meetings in (
        ("attachments", "connector", physics.attaches),
        ("contacts of what the UR10 carried", "carried", physics.landings),
        ("contacts of the UR10 that no grasp explains", "link", physics.collisions),
    ):
        if meetings:
            tables.append(_meetings(f"Measured by the simulation: {name}", first, meetings))
    return tables


def trials_tables(runs: Sequence[Measured]) -> list[Table]:
    """The figures of the simulation in many runs: their medians and largest values, and all of them by seed."""
    found = {run.seed: run.physics.figures() for run in runs if run.physics is not None}
    names = list(dict.fromkeys(name for figures in found.values() for name in figures))
    if not names:
        return []
    summary: list[Sequence[str]] = [("figure", "median", "largest", "seed of the largest")]
    for name in names:
        values = {seed: figures[name] for seed, figures in found.items() if name in figures}
        worst = max(values, key=values.__getitem__)
        middle = figure_text(name, median(values.values()))
        summary.append((name, middle, figure_text(name, values[worst]), str(worst)))
    rows: list[Sequence[str]] = [("seed", *names)]
    rows += [
        (str(seed), *(figure_text(name, figures[name]) if name in figures else "-" for name in names))
        for seed, figures in found.items()
    ]
    return [
        Table("Measured by the simulation, over all seeds", summary),
        Table("Measured by the simulation, by seed", rows[: MOST_ROWS + 1], _rest(len(rows) - 1), folded=True),
    ]


def _loads(physics: Physics) -> Table:
    """The largest load of each connector, the heaviest first."""
    rows: list[Sequence[str]] = [
        ("connector", "connection", "held", "of its strength, %", "force, N", "moment, N m", "at, s")
    ]
    heaviest = sorted(physics.loads, key=lambda load: -load.utilisation)
    rows += [
        (
            load.connector,
            load.kind,
            load.part,
            f"{100.0 * load.utilisation:.0f}",
            f"{load.force:.1f}",
            f"{load.moment:.2f}",
            f"{load.time:.1f}",
        )
        for load in heaviest[:MOST_ROWS]
    ]
    return Table("Measured by the simulation: the largest load of each connector", rows, _rest(len(heaviest)))


def _meetings(caption: str, first: str, meetings: Sequence[Meeting]) -> Table:
    rows: list[Sequence[str]] = [(first, "met", "at, s", "speed, mm/s", "force, N")]
    rows += [
        (row.first, row.second, f"{row.time:.1f}", _mm(row.speed), f"{row.force:.1f}") for row in meetings[:MOST_ROWS]
    ]
    return Table(caption, rows, _rest(len(meetings)), folded=len(meetings) > 12)


def _rest(count: int) -> str:
    return f"{count - MOST_ROWS} more are left out." if count > MOST_ROWS else ""


def _mm(metres: float) -> str:
    return f"{1e3 * metres:.1f}"
