"""The clearances between links of a robot that joints of it move, and from its ground."""

from __future__ import annotations

from collections.abc import Iterable

from jauspy.geometry.link_clearances import LinkClearances
from jauspy.platform.description import RobotModel


def clearances_of(model: RobotModel, joints: Iterable[str]) -> LinkClearances:
    """The clearances that change when these joints move; those from the ground, too, of a robot that drives on it.

    Flippers, whose belts run with the tracks, may press on the ground.
    """
    tracks = model.tracks
    belts = () if tracks is None else (*tracks.left, *tracks.right)
    return LinkClearances(model.description, joints, has_ground=bool(belts) or model.wheels is not None, belts=belts)
