"""Results of the measurement: runs of an arm at a speed and with a load, and the figures of all of them."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Final

from jauspy.cell.calibration import Parameters
from jauspy.cell.frames import Array
from jauspy.cell.iso9283.characteristics import Accuracy, Arrival, Drift, PathAccuracy, largest
from jauspy.cell.measurements import Measured

NEGLIGIBLE: Final = 1e-4
"""Radians by which an attitude may be out of reach without a word."""
WANTED: Final = 5.0
"""Factor by which a calibration is to improve the accuracy."""


@dataclass(frozen=True, slots=True)
class Run:
    """One arm that was measured at one speed: its five poses, and its path."""

    name: str
    poses: tuple[Accuracy, ...]
    speed: float = 1.0
    """Fraction of the rated speed."""
    arrivals: tuple[Arrival, ...] = ()
    """All approaches of all poses."""
    deviations: tuple[Array, ...] = ()
    """For each pose, shape (cycles, 3): attained places less the commanded one, in the world, metres."""
    out_of_reach: float = 0.0
    """Largest angle between the attitudes of a goal and of the commanded pose, radians: five joints leave some over."""
    load: float = 0.0
    """Kilograms."""
    path: PathAccuracy | None = None
    """None if the path was not measured."""

    @property
    def worst(self) -> Accuracy:
        """The largest figures of all poses."""
        return largest(self.poses)

    @property
    def stabilisation(self) -> float:
        """Seconds: the longest of all approaches."""
        return max((rest.stabilisation for rest in self.arrivals), default=0.0)

    @property
    def overshoot(self) -> float:
        """Metres: the largest of all approaches."""
        return max((rest.overshoot for rest in self.arrivals), default=0.0)

    @property
    def label(self) -> str:
        """The arm, its load, and its speed if that is not the whole."""
        load = f" with {self.load:g} kg" if self.load else ""
        return f"{self.name}{load}" + (f", at {self.speed:.0%} of its speed" if self.speed < 1.0 else "")


@dataclass(frozen=True, slots=True)
class Report:
    """All that was measured."""

    ur10: tuple[Run, ...]
    """The UR10: without a load, the fastest first; then with loads."""
    assembled: Run
    """The modular arm with modules that sit badly, by the library of parts."""
    reported: Run
    """The same arm, with the offsets that its connectors report."""
    calibrated: tuple[Run, ...]
    """The same arm after calibration: without a load, the fastest first; then with loads."""
    parameters: Parameters
    drifts: tuple[tuple[str, Drift], ...] = ()
    """Drift of P1, by the arm."""

    def __iter__(self) -> Iterator[Run]:
        yield from (*self.ur10, self.assembled, self.reported, *self.calibrated)

    @property
    def improvement(self) -> float:
        """The factor by which calibration improves the accuracy of the position."""
        return self.assembled.worst.accuracy / self.calibrated[0].worst.accuracy

    @property
    def improvement_on_reports(self) -> float:
        """The same factor, against positions that are computed with the offsets that connectors report."""
        return self.reported.worst.accuracy / self.calibrated[0].worst.accuracy

    def measured(self, seed: int) -> Measured:
        """The figures, for tables and files."""
        found = Measured(seed, "iso9283", success=self.improvement >= WANTED)
        for run in self:
            found.values |= _values(run)
            found.rows += [
                {"arm": run.name, "load": run.load, "speed": run.speed, "pose": f"P{number}"} | _row("ap", "rp", pose)
                for number, pose in enumerate(run.poses, 1)
            ]
            if (path := run.path) is not None:
                line = {"arm": run.name, "load": run.load, "speed": run.speed, "path": "P2 to P4"}
                found.rows.append(line | _row("at", "rt", path.worst) | {"path speed": path.speed})
        for name, drift in self.drifts:
            found.values |= {f"dap {name}": drift.accuracy, f"drp {name}": drift.repeatability}
            found.values[f"drift time {name}"] = drift.duration
            found.rows += [
                {"arm": name, "drift": "P1", "time": point.time} | _row("ap", "rp", point.accuracy)
                for point in drift.points
            ]
        found.values["improvement"] = self.improvement
        found.values["improvement on reports"] = self.improvement_on_reports
        if not found.success:
            found.failure = (
                f"calibration improves accuracy {self.improvement:.1f} times; at least {WANTED:g} are wanted"
            )
        return found


def _row(accuracy: str, repeatability: str, found: Accuracy) -> dict[str, float]:
    angles = zip("abc", found.angles, found.angle_spreads, strict=True)
    row = {accuracy: found.accuracy, repeatability: found.repeatability}
    for axis, angle, spread in angles:
        row |= {f"{accuracy} {axis}": angle, f"{repeatability} {axis}": spread}
    return row


def _values(run: Run) -> dict[str, float]:
    arm, worst = run.label, run.worst
    found = {
        f"ap {arm}": worst.accuracy,
        f"rp {arm}": worst.repeatability,
        f"ap angle {arm}": worst.angle_accuracy,
        f"rp angle {arm}": worst.angle_repeatability,
        f"stabilisation {arm}": run.stabilisation,
        f"overshoot of {arm}": run.overshoot,
    }
    if run.out_of_reach > NEGLIGIBLE:
        found[f"attitude out of reach {arm}"] = run.out_of_reach
    if (path := run.path) is not None:
        found |= {
            f"at {arm}": path.worst.accuracy,
            f"rt {arm}": path.worst.repeatability,
            f"at angle {arm}": path.worst.angle_accuracy,
            f"rt angle {arm}": path.worst.angle_repeatability,
            f"path speed {arm}": path.speed,
        }
    return found
