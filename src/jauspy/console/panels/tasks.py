"""The view Tasks: driving back, following, handoff and sound, as far as the chosen robot offers them."""

from __future__ import annotations

from typing import Final

from jauspy.console.console import Console
from jauspy.console.conventions import Conventions
from jauspy.console.panels.following import FollowingCard
from jauspy.console.panels.handoff import HandoffCard
from jauspy.console.panels.sound import SoundCard
from jauspy.console.panels.way_back import WayBackCard
from jauspy.console.users import User
from jauspy.ocu.robot import Robot

Card = WayBackCard | FollowingCard | HandoffCard | SoundCard
OFFERED: Final = (
    *("iop:Retrotraverse", "iop:LeaderFollowerDriver", "iop:EnhancedAccessControl"),
    *("aeodrs:DigitalAudioSensor", "aeodrs:DigitalAudioAnnuciator"),
)
"""Services for which the view is useful."""


class TasksPanel:
    """The cards of one page, which `token` names."""

    def __init__(self, console: Console, token: str, user: User, conventions: Conventions) -> None:
        self._cards: list[Card] = [
            WayBackCard(console, token, conventions),
            FollowingCard(console, token, conventions),
            HandoffCard(console, token, user),
            SoundCard(console, token, user),
        ]

    def show(self, robot: Robot | None) -> None:
        """Show the tasks of this robot."""
        for card in self._cards:
            card.show(robot)

    def close(self) -> None:
        """Handle the end of the page."""
        for card in self._cards:
            card.close()
