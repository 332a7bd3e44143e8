"""Where the joints of an arm like inc1's must be for its hand to be somewhere: one turn and three hinges."""

from __future__ import annotations

import math
from collections.abc import Sequence

from jauspy.errors import RequestError
from jauspy.geometry.denavit_hartenberg import manipulator_geometry
from jauspy.geometry.urdf import JointKind
from jauspy.geometry.vectors import Vector
from jauspy.platform.description import RobotModel


class Hand:
    """The arm of the description, group `arm`: turn, shoulder, elbow, wrist, roll. Metres and radians."""

    def __init__(self, model: RobotModel) -> None:
        group = model.groups["arm"]
        chain = model.description.chain(group.base, group.tip)
        self.geometry = manipulator_geometry(chain)
        moving = [number for number, joint in enumerate(chain) if joint.kind is not JointKind.FIXED]
        turn, shoulder, elbow, wrist, _ = moving
        self.axis = chain[turn].origin.x
        """Of the turn, ahead of the base link's origin."""
        self._height = chain[turn].origin.z + chain[shoulder].origin.z
        self._upper, self._fore = chain[elbow].origin.x, chain[wrist].origin.x
        self._hand = sum(joint.origin.x for joint in chain[wrist + 1 :])

    def around(self, target: Vector) -> tuple[float, float, float]:
        """A point of the base link's frame as turn, distance from the axis of the turn, and height."""
        x, y, z = target
        return math.atan2(y, x - self.axis), math.hypot(x - self.axis, y), z

    def joints(self, turn: float, distance: float, height: float, pitch: float = 0.0) -> Sequence[float]:
        """The joints' positions, as the specification counts them, with the hand pointing up by `pitch`.

        Raises `RequestError` when the arm is too short.
        """
        x = distance - self._hand * math.cos(pitch)
        z = height - self._height - self._hand * math.sin(pitch)
        upper, fore = self._upper, self._fore
        bend = (x * x + z * z - upper**2 - fore**2) / (2.0 * upper * fore)
        if abs(bend) > 1.0:
            raise RequestError(f"the arm cannot reach {distance:.2f} m from its axis at a height of {height:.2f} m")
        elbow = -math.acos(bend)
        shoulder = math.atan2(z, x) + math.atan2(fore * math.sin(-elbow), upper + fore * math.cos(elbow))
        return self.geometry.from_urdf((turn, shoulder, elbow, pitch - shoulder - elbow, 0.0))
