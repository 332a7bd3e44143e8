"""The posture that the sliders of the panel Arm ask for: a ghost in the view World, and what it would touch."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Final

from nicegui import ui

from jauspy.console.manipulators import joint_label
from jauspy.console.markup import attributes, call
from jauspy.console.page_language import _
from jauspy.ocu.robot import Robot
from jauspy.platform.link_clearances import clearances_of
from jauspy.printable import printable

if TYPE_CHECKING:
    from jauspy.console.console import Console
    from jauspy.geometry.link_clearances import LinkClearances

NEAR: Final = 0.02
"""Metres below which the distance to the robot's own links, and to the ground, is told."""


class WantedPosture:
    """The line below the sliders of one page, which `token` names."""

    def __init__(self, console: Console, token: str) -> None:
        self._console = console
        self._token = token
        self._robot: Robot | None = None
        self._shown: dict[str, float] = {}
        self._clearances: tuple[frozenset[str], LinkClearances] | None = None
        """Those that change with these joints."""
        self._text = ui.label("").classes("hint wanted-posture").props('role="status"')

    def show(self, robot: Robot | None) -> None:
        """Show postures of this robot."""
        if robot is None or self._robot is None or robot.id != self._robot.id:
            self._shown, self._clearances = {}, None
            self._text.set_text("")
        self._robot = robot

    def update(self, wanted: Mapping[str, float]) -> None:
        """Show the posture with these positions of joints; none when nothing is asked for."""
        if wanted == self._shown or self._robot is None:
            return
        self._shown = dict(wanted)
        text, touches = self._nearest(wanted) if wanted else ("", False)
        self._text.set_text(text)
        attributes(self._text, data_touches=touches)
        call("jauspy.world.setWanted", {"positions": dict(wanted), "touches": touches} if wanted else None)

    def _nearest(self, wanted: Mapping[str, float]) -> tuple[str, bool]:
        """What the robot would touch, or nearly so, and whether it touches.

        The text is empty if the robot is clear, or if its description is not known here.

        The description is known from the time on at which the view World has been opened.
        """
        assert self._robot is not None
        world = self._console.worlds.get(self._robot.id)
        if world is None or world.model is None or not wanted.keys() <= world.model.description.joints.keys():
            return "", False
        joints = frozenset(wanted)
        if self._clearances is None or self._clearances[0] != joints:
            self._clearances = (joints, clearances_of(world.model, joints))
        now = self._clearances[1].at(world.positions, NEAR)
        then = self._clearances[1].at({**world.positions, **wanted}, NEAR)
        pairs = {
            pair: far for pair, far in then.items() if far < now.get(pair, NEAR)
        }  # boxes that touch anyway do not count
        if not pairs:
            return "", False
        pair, far = min(pairs.items(), key=lambda each: each[1])
        one, other = (printable(joint_label(name)).replace("_", " ") for name in pair)
        if far <= 0.0:
            return _("would touch: {one} and {other}", one=one, other=other), True
        return _("{distance:.1f} cm between {one} and {other}", distance=100.0 * far, one=one, other=other), False
