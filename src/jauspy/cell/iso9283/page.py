"""The report by ISO 9283: the standard's tables on a page, with plots of attained poses, of paths, and of the drift."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import Final

import numpy as np

from jauspy.cell.frames import Array
from jauspy.cell.iso9283.bench import (
    ARM_CUBE,
    ARM_TOOL_SPEED,
    REST,
    UR10_CUBE,
    UR10_TOOL_SPEED,
    Plan,
)
from jauspy.cell.iso9283.characteristics import EDGE, PLANES, Accuracy, Drift, LaserTracker, PathAccuracy
from jauspy.cell.iso9283.loads import ARM_RATED, GRIPPER_MASS, UR10_RATED
from jauspy.cell.iso9283.measurement import CALIBRATED
from jauspy.cell.iso9283.results import NEGLIGIBLE, WANTED, Report, Run
from jauspy.cell.report import Plot, Promise, Section, Table, page as whole_page
from jauspy.plots import figure

COLOURS: Final = ("#3b6ea5", "#b3423a", "#2f7d4f", "#8a5aa8", "#c58a1c", "#5f6b76", "#1d8a99")
"""Colours of poses, and of runs, in plots."""
PLACES, PATHS, DRIFT = "iso9283.svg", "iso9283_paths.svg", "iso9283_drift.svg"
"""Files of the plots."""
THERMAL: Final = (
    "There is no thermal model of the arms: motors of modules warm up, but nothing expands. What drifts here is "
    "the measurement and the control."
)


def write_report(report: Report, plan: Plan, seed: int, directory: Path, page: Path | None = None) -> Path:
    """Write the plots into a directory and the page to `page`, by default `iso9283.html` there; returns that path."""
    directory.mkdir(parents=True, exist_ok=True)
    plot_accuracy(report, directory / PLACES)
    plot_paths(report, directory / PATHS)
    if report.drifts:
        plot_drift(report.drifts, directory / DRIFT)
    path = page or directory / "iso9283.html"
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(html(report, plan, seed, directory), encoding="utf-8")
    return path


def html(report: Report, plan: Plan, seed: int, directory: Path) -> str:
    """The page; its plots are in `directory`."""
    modular = (report.assembled, report.reported, *report.calibrated)
    plots = [
        Plot(directory / PLACES, "Attained places less the commanded ones, without a load; crosses are means."),
        Plot(directory / PATHS, "Distance of the mean path from the commanded line, along the line, for each run."),
        Plot(directory / DRIFT, "AP and RP of P1 over the time of the runs."),
    ]
    sections = [
        _conditions(plan),
        Section("Plots", plots=plots if report.drifts else plots[:2]),
        _arm_section("UR10", report.ur10, report.drifts),
        _arm_section("Modular arm", modular, report.drifts),
    ]
    promise = Promise(
        "Calibration of the misassembled arm",
        f"AP at least {WANTED:g} times better",
        f"{report.improvement:.0f} times better than by the library of parts, "
        f"{report.improvement_on_reports:.1f} times better than by the connectors' reports",
        report.improvement >= WANTED,
    )
    lead = f"Industrial robots: performance criteria and test methods. Measured in the simulated cell with seed {seed}."
    return whole_page("Performance by ISO 9283", lead, [promise], sections)


def _conditions(plan: Plan) -> Section:
    tracker = LaserTracker(np.random.default_rng(0))
    instrument = (
        f"laser tracker with a six-axis probe; standard deviations: {1e6 * tracker.position:.0f} micrometres and "
        f"{math.degrees(tracker.angle):.4f} degrees"
    )
    rows = [
        ("condition", "UR10", "modular arm"),
        ("test cube", f"side {UR10_CUBE:g} m about its start", f"side {ARM_CUBE:g} m in front of its platform"),
        ("poses", "P1 to P5 in an inclined plane of the cube", "the same"),
        ("path", "a line from P2 to P4, on a diagonal of the plane", "the same"),
        (
            "path by",
            "a velocity of the tool (end effector velocity driver)",
            "a spline through postures on the line",
        ),
        (
            "whole speed",
            f"joints at their limits; on the path {UR10_TOOL_SPEED:g} m/s",
            f"as fast as the limits of the modules allow; on the path {ARM_TOOL_SPEED:g} m/s (assumption)",
        ),
        ("rated load", f"{UR10_RATED:g} kg, with the gripper of {GRIPPER_MASS:g} kg", f"{ARM_RATED:g} kg (assumption)"),
        ("cycles", f"{plan.cycles} at poses, {plan.path_cycles} on the path", "the same"),
        ("rest before a measurement", f"{REST:g} s", "the same"),
        ("instrument", instrument, "the same"),
        ("environment", "simulation, 20 degrees Celsius throughout", "the same"),
    ]
    note = (
        f"A path counts at {PLANES} planes across it, without {EDGE:.0%} of its length at each end. Commanded poses of "
        f"the modular arm have the attitude closest to the goal's that five joints reach. {THERMAL}"
    )
    return Section("Conditions of the test", tables=[Table("Conditions", rows, note)])


def _arm_section(title: str, runs: Sequence[Run], drifts: Iterable[tuple[str, Drift]]) -> Section:
    section = Section(title)
    section.tables.append(
        Table(
            f"{title}: pose accuracy and repeatability, the largest of five poses",
            [_heading("run", "AP", "RP"), *((run.label, *_cells(run.worst)) for run in runs)],
        )
    )
    paths = [(run, run.path) for run in runs if run.path is not None]
    if paths:
        section.tables.append(
            Table(
                f"{title}: path accuracy and repeatability of the line from P2 to P4",
                [
                    (*_heading("run", "AT", "RT"), "speed, m/s"),
                    *((run.label, *_cells(path.worst), f"{path.speed:.3f}") for run, path in paths),
                ],
                "The speed is the mean between the first and the last plane.",
            )
        )
    section.tables.append(
        Table(
            f"{title}: stabilisation and overshoot, the largest of all approaches",
            [
                ("run", "stabilisation time, s", "overshoot, mm", "attitude out of reach, degrees"),
                *(
                    (
                        run.label,
                        f"{run.stabilisation:.2f}",
                        f"{1e3 * run.overshoot:.2f}",
                        f"{math.degrees(run.out_of_reach):.1f}" if run.out_of_reach > NEGLIGIBLE else "0",
                    )
                    for run in runs
                ),
            ],
        )
    )
    names = {run.name for run in runs}
    section.tables += [_drift_table(name, drift) for name, drift in drifts if name in names]
    section.tables += [
        Table(
            f"Each pose: {run.label}",
            [
                _heading("pose", "AP", "RP"),
                *((f"P{number}", *_cells(pose)) for number, pose in enumerate(run.poses, 1)),
            ],
            folded=True,
        )
        for run in runs
    ]
    return section


def _drift_table(name: str, drift: Drift) -> Table:
    rows = [("time, minutes", "AP, mm", "RP, mm")]
    for point in drift.points:
        found = point.accuracy
        rows.append((f"{point.time / 60.0:.1f}", f"{1e3 * found.accuracy:.3f}", f"{1e3 * found.repeatability:.3f}"))
    note = f"dAP {1e3 * drift.accuracy:.3f} mm, dRP {1e3 * drift.repeatability:.3f} mm. {THERMAL}"
    return Table(f"{name}: drift of P1 in {drift.duration / 60.0:.0f} minutes of motion, without a load", rows, note)


def _heading(first: str, accuracy: str, repeatability: str) -> tuple[str, ...]:
    return (
        first,
        f"{accuracy}, mm",
        *(f"{accuracy} {axis}, deg" for axis in "abc"),
        f"{repeatability}, mm",
        *(f"{repeatability} {axis}, deg" for axis in "abc"),
    )


def _cells(found: Accuracy) -> tuple[str, ...]:
    return (
        f"{1e3 * found.accuracy:.3f}",
        *(f"{math.degrees(angle):.3f}" for angle in found.angles),
        f"{1e3 * found.repeatability:.3f}",
        *(f"{math.degrees(angle):.3f}" for angle in found.angle_spreads),
    )


def plot_accuracy(report: Report, path: Path) -> None:
    """Plot the attained places of the UR10 and of the calibrated arm, less the commanded ones, from above and aside."""
    views = ((0, 1, "x, mm", "y, mm"), (0, 2, "x, mm", "z, mm"))
    runs = (report.ur10[0], report.calibrated[0])
    with figure(path, columns=4, size=(14.0, 3.9)) as axes:
        for column, axis in enumerate(axes):
            run, (across, up, x_name, y_name) = runs[column // 2], views[column % 2]
            most = 1.2e3 * max(float(np.max(np.abs(rows))) for rows in run.deviations)
            for number, (rows, colour) in enumerate(zip(run.deviations, COLOURS, strict=False), 1):
                places = 1e3 * rows
                axis.scatter(places[:, across], places[:, up], s=10.0, color=colour, alpha=0.6, label=f"P{number}")
                mean = places.mean(axis=0)
                axis.plot(mean[across], mean[up], "+", color=colour, ms=11.0, mew=1.8)
            axis.axhline(0.0, color="0.75", lw=0.8, zorder=0)
            axis.axvline(0.0, color="0.75", lw=0.8, zorder=0)
            axis.set(xlim=(-most, most), ylim=(-most, most), xlabel=x_name, ylabel=y_name, aspect="equal")
            axis.set_title(run.name, fontsize=10)
        axes[0].legend(loc="best", fontsize=8)


def plot_paths(report: Report, path: Path) -> None:
    """Plot the distance of each mean path from the line, along the line: the UR10 left, the modular arm right."""
    with figure(path, columns=2, size=(13.0, 4.4)) as axes:
        for axis, title, runs in zip(axes, ("UR10", CALIBRATED), (report.ur10, report.calibrated), strict=True):
            found = [(run, run.path) for run in runs if run.path is not None]
            for number, (run, line) in enumerate(found):
                along, off = _along(line)
                label = f"{run.load:g} kg, {run.speed:.0%}"
                axis.plot(along, 1e3 * off, color=COLOURS[number % len(COLOURS)], lw=1.6, label=label)
            axis.set(xlabel="part of the line, %", ylabel="mm off the line", title=title)
            axis.set_ylim(0.0, None)
            if found:
                axis.legend(loc="best", fontsize=8, title="load, speed")


def _along(line: PathAccuracy) -> tuple[Array, Array]:
    places = 100.0 * np.linspace(EDGE, 1.0 - EDGE, len(line.deviations))
    return places, np.linalg.norm(line.deviations, axis=1)


def plot_drift(drifts: Sequence[tuple[str, Drift]], path: Path) -> None:
    """Plot AP and RP of P1 over time, an axis for each arm."""
    with figure(path, columns=len(drifts), size=(13.0, 3.6)) as axes:
        for axis, (name, drift) in zip(axes, drifts, strict=True):
            minutes = [point.time / 60.0 for point in drift.points]
            accuracies = [1e3 * point.accuracy.accuracy for point in drift.points]
            repeatabilities = [1e3 * point.accuracy.repeatability for point in drift.points]
            axis.plot(minutes, accuracies, "o-", color=COLOURS[0], label="AP")
            axis.plot(minutes, repeatabilities, "s--", color=COLOURS[1], label="RP")
            axis.set(xlabel="minutes", ylabel="mm", title=name)
            axis.set_ylim(0.0, None)
            axis.legend(loc="best", fontsize=8)
