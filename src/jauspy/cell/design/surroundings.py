"""What a task has around its arms: obstacles as fixtures of the cell, and a load for each arm that lies ready."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Final

from jauspy.cell.design.chains import LOAD_SIDE, load_height
from jauspy.cell.design.tasks import DesignTask, Obstacle
from jauspy.cell.session import Session
from jauspy.errors import ConfigError
from jauspy.geometry.poses import Transform
from jauspy.platform.modular.parts import CellSetup, Fixture, PartKind, PartSolid, PartType, PlacedPart, Shape

LOAD: Final = "load"
"""The type of what an arm carries, and the name of the first part of that type."""
LOAD_ROOM: Final = 0.03
"""Metres between two loads that lie side by side."""
ASIDE: Final = 50.0
"""Metres beside the cell, where obstacles of other tasks are."""


def furnished(cell: CellSetup, tasks: Sequence[DesignTask], base: str, load: float) -> CellSetup:
    """The cell with the obstacles of all tasks, those of the first in place, and with loads on another base.

    `load` in kilograms; there is one for each arm of the tasks.
    """
    fixtures = [
        _fixture(name, box, aside=number > 0) for number, task in enumerate(tasks) for name, box in _named(number, task)
    ]
    cell = replace(cell, fixtures=(*cell.fixtures, *fixtures))
    if not load:
        return cell
    size = (LOAD_SIDE, LOAD_SIDE, load_height(load))
    middle = Transform(position=(0.0, 0.0, size[2] / 2.0))
    solid = PartSolid(Shape.CUBOID, size, load, middle)
    top = Transform(((1.0, 0.0, 0.0), (0.0, -1.0, 0.0), (0.0, 0.0, -1.0)), (0.0, 0.0, size[2]))
    type = PartType(LOAD, PartKind.BOX, (solid,), grasp=top)
    count = max(len(task.arms) for task in tasks) or 1
    shelf, pitch = _shelf(cell, base.partition("/")[0]), LOAD_SIDE + LOAD_ROOM
    loads = []
    for number in range(count):
        place = shelf @ Transform(position=(0.0, pitch * (number - (count - 1) / 2.0), 0.0))
        loads.append(PlacedPart(LOAD if number == 0 else f"{LOAD}_{number + 1}", LOAD, place.to_pose()))
    return replace(cell, types={**cell.types, LOAD: type}, parts=(*cell.parts, *loads))


def set_up(session: Session, tasks: Sequence[DesignTask], active: int) -> None:
    """Have the obstacles of one task in place, and those of the others aside, as a person would between tasks."""
    setup = session.layout.setup
    fixtures = {fixture.name: fixture for fixture in setup.fixtures}
    for number, task in enumerate(tasks):
        for name, box in _named(number, task):
            fixtures[name] = _fixture(name, box, aside=number != active)
            session.true.place(name, fixtures[name].pose)
    session.layout.setup = replace(setup, fixtures=tuple(fixtures.values()))


def _named(number: int, task: DesignTask) -> list[tuple[str, Obstacle]]:
    return [(f"task_{number + 1}_box_{index + 1}", box) for index, box in enumerate(task.obstacles)]


def _fixture(name: str, box: Obstacle, *, aside: bool) -> Fixture:
    pose = box.pose.to_pose()
    return Fixture(name, (PartSolid(Shape.CUBOID, box.size),), replace(pose, x=pose.x + ASIDE) if aside else pose)


def _shelf(cell: CellSetup, base: str) -> Transform:
    """Where the loads are at first: on the first platform that carries no arm."""
    for part in cell.parts:
        if part.fixed and part.name != base:
            kind = cell.types[part.type]
            return Transform.from_pose(part.pose) @ next(iter(kind.connectors.values()))
    raise ConfigError(f"there is no platform beside {base} on which a load could be")
