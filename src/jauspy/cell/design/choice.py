"""The choice of designs for a task: of one arm, or of two on one base, the second beside the first."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from functools import partial

from jauspy.cell.design.rehearsal import first_buildable
from jauspy.cell.design.search import ALONE, Design, Found, Neighbour, Search, check
from jauspy.cell.design.surroundings import furnished
from jauspy.cell.design.tasks import DesignTask
from jauspy.cell.scene import Layout, cell_of
from jauspy.platform.description import RobotModel


@dataclass(frozen=True, slots=True)
class Choice:
    """What was found for one arm."""

    task: DesignTask
    """Its part of the task."""
    base: str
    """The connector that carries it, as in `platform_1/left`."""
    found: Found
    design: Design | None
    wrong: tuple[str, ...] = ()
    """What the checker found wrong with the design."""

    @property
    def is_valid(self) -> bool:
        """True if there is a design that does the task."""
        return self.design is not None and not self.wrong


@dataclass(frozen=True, slots=True)
class Chooser:
    """Searches designs for the tasks of a cell."""

    model: RobotModel
    weights: Mapping[str, float]
    seed: int
    load: float
    """Kilograms at the tip of each arm."""
    candidates: int
    """Chains that are tried for each arm."""
    seconds: float
    """CPU time of each search at most."""
    buildable: bool
    """Only designs of which a plan shows how the UR10 builds them."""
    note: Callable[[str], None]
    """Told of improvements, and of designs that cannot be built; of two arms with the name of the arm."""

    def choose(self, task: DesignTask, base: str) -> list[Choice]:
        """A choice for each arm of the task, up to the first that has no valid design. Raises `ConfigError`.

        `base` is the connector that carries the arm, as in `platform_1/top`, or the base of two arms.
        """
        cell, beside = cell_of(self.model), ALONE
        chosen: list[Choice] = []
        for arm in task.arms or ("",):
            part, connector = (task.of(arm), f"{base}/{arm}") if arm else (task, base)
            search = Search(cell, part, connector, load=self.load, weights=self.weights, seed=self.seed, beside=beside)
            note = partial(self._note, arm)
            found = search.run(self.candidates, self.seconds, note)
            design = self._buildable(found, task, connector, chosen, note) if self.buildable else found.best
            wrong = check(cell, part, connector, design, load=self.load, beside=beside) if design is not None else []
            chosen.append(Choice(part, connector, found, design, tuple(wrong)))
            if design is None or wrong:
                break
            beside = Neighbour.of(cell, connector, design, self.load)
        return chosen

    def _note(self, arm: str, text: str) -> None:
        self.note(f"{arm}: {text}" if arm else text)

    def _buildable(
        self, found: Found, task: DesignTask, connector: str, before: list[Choice], note: Callable[[str], None]
    ) -> Design | None:
        furniture = furnished(cell_of(self.model), [task], connector, self.load)
        standing = [(choice.design, choice.base) for choice in before if choice.design is not None]
        layout = Layout(replace(self.model, cell=furniture))
        return first_buildable(layout, found, connector, self.load, note, before=standing)
