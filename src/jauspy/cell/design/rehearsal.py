"""Whether the UR10 can build a design: a quick plan of all that it would do, without a cell."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Final

from jauspy.cell.design.chains import Element
from jauspy.cell.design.search import Design, Found
from jauspy.cell.design.surroundings import LOAD
from jauspy.cell.frames import se3_of_pose
from jauspy.cell.handling import Handling
from jauspy.cell.motion import MotionPlanner, NoPath
from jauspy.cell.scene import Layout, connector_frame
from jauspy.cell.slots import QUARTERS, Slot, Tip, is_straight, slot_goals
from jauspy.platform.modular.parts import PartType

NODES: Final = 60
"""Postures of a detour: fewer than when it is built, so that what is rehearsed is easy to build."""


def slots_of(elements: Sequence[Element], types: Mapping[str, PartType], load: float) -> tuple[Slot, ...]:
    """The places of a design, base to tip, and of its load, in kilograms; none of a load of zero."""
    found, joints = [], 0
    for number, element in enumerate(elements):
        kind = types[element.type]
        joints += kind.servo is not None
        name = f"joint {joints}" if kind.servo is not None else f"part {number + 1}"
        others = QUARTERS if is_straight(kind) else QUARTERS[:1] if kind.servo is None else QUARTERS[:2]
        turns = tuple(element.turn + turn for turn in others)  # half a turn only reverses the axis of an elbow
        found.append(Slot(name, (element.type,), next(iter(kind.connectors)), turns))
    return (*found, Slot(LOAD, (LOAD,), "", QUARTERS)) if load else tuple(found)


def first_buildable(
    layout: Layout,
    found: Found,
    base: str,
    load: float,
    note: Callable[[str], None],
    *,
    before: Sequence[tuple[Design, str]] = (),
) -> Design | None:
    """The cheapest design that a search has found and that can be built; `note` is told why others cannot.

    `before` are the arms that stand there already, each with its connector, and with the same load.
    """
    for design in reversed(found.designs):
        why = why_not_buildable(layout, design, base, load, before)
        if not why:
            return design
        note(f"the design of cost {design.cost:.3f} cannot be built: {why}")
        found.reasons["the UR10 cannot build it"] += 1
    return None


def why_not_buildable(
    layout: Layout, design: Design, base: str, load: float, before: Sequence[tuple[Design, str]] = ()
) -> str:
    """Why the UR10 could not join the parts of a design where the file has them; empty if a plan was found.

    `before` are the arms that it builds first, each with its connector, and with the same load.
    """
    ur10 = Rehearsal(layout)
    for other, connector in before:
        if why := _why_not_joined(ur10, layout, other, connector, load):
            return why
    return _why_not_joined(ur10, layout, design, base, load)


def _why_not_joined(ur10: Rehearsal, layout: Layout, design: Design, base: str, load: float) -> str:
    owner, _, connector = base.partition("/")
    placed = next(part for part in layout.setup.parts if part.name == owner)
    frame = se3_of_pose(placed.pose) * connector_frame(layout.type_of(owner), connector)
    tip = Tip(base, owner, frame)
    for slot in slots_of(design.elements, layout.setup.types, load):
        reasons = []
        for part in layout.of_types(slot.types):
            if part in ur10.used:
                continue
            try:
                ur10.join(part, slot, tip)
                break
            except NoPath as error:
                reasons.append(f"{part}: {error}")
        else:
            return f"{slot.name}: {'; '.join(reasons) or 'none is left'}"
    return ""


class Rehearsal:
    """Plans of the UR10 without a cell: each part lies where the file has it, and each motion ends as planned."""

    def __init__(self, layout: Layout) -> None:
        self._layout = layout
        self._scene = layout.scene()
        self._handling = Handling(layout, self._scene, MotionPlanner(self._scene, layout.kinematics, nodes=NODES))
        self._at = layout.home
        self.used: set[str] = set()
        """Parts that are joined."""

    def join(self, part: str, slot: Slot, tip: Tip) -> None:
        """Plan to fetch a part, and to join it to the tip; raises `NoPath`, and then all is as before."""
        handling, goals = self._handling, slot_goals(self._layout, slot, tip)
        lies = self._scene.poses[part]
        picked = handling.pick(part, lies, self._at, goals)
        try:
            place = handling.place(part, picked.grasp, picked.lift.end, goals, touches=[tip.part])
        except NoPath:
            self._scene.release()
            self._scene.put(part, handling.pieces(part), lies)
            raise
        self._scene.release()
        self._scene.put(part, handling.pieces(part), place.goal)
        self.used.add(part)
        self._at = handling.retreat(place.contact.end).end
        type = self._layout.type_of(part)
        if slot.connector in type.connectors:
            tip.advance(part, slot.connector, place.goal, connector_frame(type, slot.connector), slot.turns[0])
