"""Plans of picking a part and of joining it to a connector."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from typing import Final, TypeVar

import pinocchio as pin

from jauspy.cell.frames import Array, shifted, turned
from jauspy.cell.held_load import HeldLoad, inertia_of
from jauspy.cell.motion import MotionPlanner, NoPath, Path
from jauspy.cell.scene import Layout, Piece, PlanningScene, pieces_of_part

Option = TypeVar("Option")
Plan = TypeVar("Plan")

TURNS: Final = 12
"""Angles of the gripper about its axis that are tried; the suction plate is round."""
DOWNWARD: Final = 0.5
"""Least cosine of the angle from straight down at which the gripper reaches for a part."""
APPROACH: Final = 0.07
"""Metres from the part at which the straight approach begins."""
LIFT: Final = 0.10
"""Metres by which a part is lifted out of its bin."""
SLOW: Final = 0.003
"""Metres before contact from which on the arm moves slowly."""
PRESS: Final = 0.0002
"""Metres that the arm is sent beyond contact at first; the lip of a plate seals a gap of 1 mm."""
PRESS_MORE: Final = 0.0006
"""Metres by which it is pressed on each time that nothing attaches."""
INSERT: Final = 0.06
"""Metres above a connector at which a part is lowered in a straight line."""
LINE_MARGIN: Final = 0.003
"""Metres to keep from everything but what is touched, on straight lines."""
BIN_MARGIN: Final = 0.0015
"""The same where a part is grasped: one that lies at a bin's wall is not much higher than that."""
TOUCHED_MARGIN: Final = 0.001
"""The same from what the held part touches: parts are short, and the gripper comes close to what they join."""
MAX_PLANS: Final = 8
"""Postures for which a whole plan is tried."""
CONDITION: Final = 0.03


@dataclass(frozen=True, slots=True)
class PickPlan:
    """Four motions: to a point before the part, close to it, slowly to contact, and up."""

    part: str
    grasp: pin.SE3
    """The gripper in the frame of the part."""
    approach: Path
    near: Path
    contact: Path
    lift: Path


@dataclass(frozen=True, slots=True)
class PlacePlan:
    """Three motions: to a point before the connector, close to it, slowly to contact; and where the part is then."""

    transfer: Path
    insert: Path
    contact: Path
    goal: pin.SE3
    """The frame of the part, without the press."""


class Handling:
    """Plans with the scene's present state. All plans raise `NoPath` with the reason of the most promising attempt."""

    def __init__(self, layout: Layout, scene: PlanningScene, planner: MotionPlanner) -> None:
        self.layout = layout
        self.scene = scene
        self.planner = planner
        self.composites: dict[str, list[Piece]] = {}
        """Shapes of parts to which others are attached, with those of the others, in the frame of the part."""
        self.members: dict[str, list[tuple[str, pin.SE3]]] = {}
        """Names of what is attached to such a part, and the frames in its own."""

    def pieces(self, part: str) -> list[Piece]:
        """The shapes of a part, and of what is attached to it."""
        return self.composites.get(part) or pieces_of_part(self.layout.type_of(part))

    def load(self, part: str, grasp: pin.SE3, *, latched: bool) -> HeldLoad:
        """A part in the gripper, with what is attached to it; `grasp` is the gripper in the part's frame.

        `latched`: the gripper's latch has locked; otherwise its cup holds the part.
        """
        parts = [(part, pin.SE3.Identity()), *self.members.get(part, ())]
        frames = [(self.layout.type_of(name), grasp.actInv(frame)) for name, frame in parts]
        limits = self.layout.setup.limits
        return HeldLoad(inertia_of(frames), limits.latch if latched else limits.gripper.holding)

    def grasps(self, part: str, face: pin.SE3 | None = None) -> list[pin.SE3]:
        """The poses of the gripper in the frame of a part, for all angles about its axis.

        `face` is one of `Layout.grasps`, by default the usual one.
        """
        return _turned(face or self.layout.grasp(part))

    def upper_grasps(self, part: str, pose: pin.SE3) -> list[pin.SE3]:
        """The same on all faces that are up while the part is at `pose`: from beside and below, bins are in the way."""
        up = [grasp for grasp in self.layout.grasps(part) if (pose.rotation @ grasp.rotation)[2, 2] < -DOWNWARD]
        return [found for grasp in up for found in _turned(grasp)]

    def pick(
        self,
        part: str,
        pose: pin.SE3,
        start: Array,
        goals: Sequence[pin.SE3] = (),
        *,
        lift: float = LIFT,
        supports: Iterable[str] = (),
        skip: int = 0,
        face: pin.SE3 | None = None,
    ) -> PickPlan:
        """A way to grasp a part that is at `pose`, such that it can be put to one of `goals` afterwards.

        `supports`: what it lies on or in. `face`: where it is grasped, if not on a face that is up. `skip` leaves out
        that many of the solutions.
        """
        k = self.layout.kinematics
        options: list[tuple[float, pin.SE3, Array]] = []
        grasps = self.upper_grasps(part, pose) if face is None else self.grasps(part, face=face)
        for grasp in grasps:
            over = pose * grasp * shifted(z=-APPROACH)
            options += [
                (k.distance(posture.positions, start), grasp, posture.positions)
                for posture in k.solve(over, start, condition=CONDITION)
                if self.scene.is_free(posture.positions, self.planner.margin)
            ]
        if not grasps:
            raise NoPath(f"{part} lies turned over: no face by which the gripper can hold it is up")
        options.sort(key=lambda option: option[0])
        options = [option for option in options if not goals or self._reaches(option[1], option[2], goals)]
        if not options:
            raise NoPath(f"{part} cannot be grasped where it is, or not so that it could be put where it belongs")
        pieces = self.pieces(part)

        def plan(option: tuple[float, pin.SE3, Array]) -> PickPlan:
            _, grasp, posture = option
            approach = self.planner.to_posture(start, posture)
            with self.scene.without(part):
                near = self.planner.line(posture, pose * grasp * shifted(z=-SLOW), margin=BIN_MARGIN)
                contact = self.planner.line(near.end, pose * grasp * shifted(z=PRESS), margin=BIN_MARGIN)
            try:
                self.scene.hold(part, pieces, grasp.inverse())
                with self.scene.without(*supports):
                    raised = self.planner.line(contact.end, shifted(z=lift) * pose * grasp, margin=-1.0)
            finally:
                self.scene.release()
                self.scene.put(part, pieces, pose)
            return PickPlan(part=part, grasp=grasp, approach=approach, near=near, contact=contact, lift=raised)

        return _first(options[skip:] or options, plan)

    def place(
        self,
        part: str,
        grasp: pin.SE3,
        start: Array,
        goals: Sequence[pin.SE3],
        *,
        along: pin.SE3 | None = None,
        touches: Sequence[str] = (),
        distance: float = INSERT,
        press: float = PRESS,
    ) -> PlacePlan:
        """A way to bring the held part to one of `goals` (its frame in the world), along its own z at the end.

        `grasp`: the gripper in the part's frame, as measured. `along`: the motion in the world from which the last
        `distance` metres come, when not along the part's z. `touches`: what the part may come close to at the end.
        """
        k = self.layout.kinematics
        self.scene.hold(part, self.pieces(part), grasp.inverse())
        options: list[tuple[float, pin.SE3, Array, pin.SE3]] = []
        for goal in goals:
            before = along * goal if along is not None else goal * shifted(z=distance)
            options += [
                (k.distance(posture.positions, start), goal, posture.positions, before)
                for posture in k.solve(before * grasp, start, condition=CONDITION)
                if self.scene.is_free(posture.positions, self.planner.margin)
            ]
        options.sort(key=lambda option: option[0])
        if not options:
            raise NoPath(f"{part} cannot be brought to where it belongs: no posture of the arm is free there")

        def plan(option: tuple[float, pin.SE3, Array, pin.SE3]) -> PlacePlan:
            _, goal, posture, before = option
            transfer = self.planner.to_posture(start, posture)
            up = before.translation - goal.translation
            up = up / max(float((up @ up) ** 0.5), 1e-9)
            near, deeper = (pin.SE3(goal.rotation, goal.translation + up * far) for far in (SLOW, -press))
            with self.scene.without(*touches):
                insert = self.planner.line(posture, near * grasp, margin=LINE_MARGIN)
                contact = self.planner.line(insert.end, deeper * grasp, margin=LINE_MARGIN)
                self._check_arm(contact.end, touches)
                self._check_retreat(contact.end, part)
            return PlacePlan(transfer, insert, contact, goal)

        return _first(options, plan)

    def pressed(self, start: Array, direction: pin.SE3) -> Path:
        """A little further along the negative z of a frame in the world, to bring plates into contact."""
        tool = self.layout.kinematics.forward(start)
        deeper = pin.SE3(tool.rotation, tool.translation - PRESS_MORE * direction.rotation[:, 2])
        return self.planner.line(start, deeper)

    def retreat(self, start: Array, distance: float = APPROACH) -> Path:
        """Away from what was released, backward."""
        back = self.layout.kinematics.forward(start) * shifted(z=-distance)
        return self.planner.line(start, back)

    def _check_arm(self, posture: Array, touched: Iterable[str]) -> None:
        """Only what the arm holds may touch something: its links stay off that, too."""
        found = self.scene.clearance_from(posture, touched)
        if found.distance < TOUCHED_MARGIN:
            raise NoPath(f"{' and '.join(found.between)} would touch")

    def _check_retreat(self, posture: Array, part: str) -> None:
        """The gripper must get away from the part that it has put down."""
        held = self.scene.held
        self.scene.release()
        try:
            found = self.retreat(posture)
        finally:
            self.scene.restore(held)
        if found.clearance.distance < LINE_MARGIN:
            near = " and ".join(found.clearance.between)
            raise NoPath(f"the gripper could not get away from {part}: {near} are too close")

    def _reaches(self, grasp: pin.SE3, near: Array, goals: Sequence[pin.SE3]) -> bool:
        k = self.layout.kinematics
        return any(k.solve(goal * shifted(z=INSERT) * grasp, near, condition=CONDITION) for goal in goals)


def _turned(grasp: pin.SE3) -> list[pin.SE3]:
    return [grasp * turned("z", math.tau * number / TURNS) for number in range(TURNS)]


def _first(options: Sequence[Option], plan: Callable[[Option], Plan]) -> Plan:
    """The plan of the first option that has one."""
    reasons = []
    for option in options[:MAX_PLANS]:
        try:
            return plan(option)
        except NoPath as error:
            reasons.append(error)
    raise reasons[0]
