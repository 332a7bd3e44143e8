"""Where components under test meet: the same few methods in memory and on a real node manager."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Iterable
from contextlib import AbstractAsyncContextManager
from dataclasses import replace
from datetime import datetime
from typing import Any

from jauspy.component import Component, ComponentOptions
from jauspy.ids import JausID
from jauspy.modules.robot import RobotRunner
from jauspy.ocu import OCU
from jauspy.services.service import Service
from jauspy.transport import Transport


class Place(ABC):
    """Makes components and OCUs that reach each other; each is to be used with `async with`."""

    @abstractmethod
    def transport(self, id: str | JausID) -> Transport:
        """A way in for the component of this id."""

    @abstractmethod
    def robot(self, name: str = "inc1") -> AbstractAsyncContextManager[RobotRunner]:
        """A whole robot of this name on the `kinematic` backend."""

    @abstractmethod
    def now(self) -> float:
        """Seconds of the monotonic clock that components here live on."""

    @abstractmethod
    def utc_now(self) -> datetime:
        """The wall clock here."""

    def component(self, id: str | JausID, services: Iterable[Service], **options: Any) -> Component:
        """A component of these services; `options` are those of `Component`."""
        own = replace(options.pop("options", ComponentOptions()), clock=self.now, utc_now=self.utc_now)
        return Component(id, services, transport=self.transport(id), options=own, **options)

    def ocu(self, id: str | JausID = "42.1.1", **options: Any) -> OCU:
        """An OCU; `options` are those of `OCU`."""
        return OCU(id, transport=self.transport(id), **options)
