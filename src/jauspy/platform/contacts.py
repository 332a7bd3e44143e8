"""Contacts of a simulated robot, to judge what it does: no robot measures this, and no service reports it."""

from __future__ import annotations

from abc import abstractmethod
from collections.abc import Mapping
from typing import TypeAlias

from jauspy.platform.contract import OptionalPart, PartId, RobotLink

ContactCounts: TypeAlias = Mapping[str, Mapping[str, int]]
"""Samples by joint group and body of the world in which a link of the group, or what is mounted on it, touched it."""


class Contacts(OptionalPart):
    """Counts the contacts of a robot's joint groups with the world since it was opened."""

    @property
    def id(self) -> PartId:
        """A robot has at most one."""
        return PartId(Contacts)

    @abstractmethod
    def state(self) -> ContactCounts:
        """The counts so far; bodies that were not touched are missing."""

    def proxy(self, link: RobotLink) -> Contacts:
        """The contacts for other threads."""
        return _ContactsProxy(link)


class _ContactsProxy(Contacts):
    def __init__(self, link: RobotLink) -> None:
        self._link = link

    def state(self) -> ContactCounts:
        state = self._link.snapshot.parts[self.id]
        assert isinstance(state, Mapping)
        return state
