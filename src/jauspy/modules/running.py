"""The components of a robot's modules while it runs: those of a factory cell appear and disappear with their power."""

from __future__ import annotations

import asyncio
from collections.abc import Callable, Iterable
from typing import Final

from jauspy.component.component import Component
from jauspy.errors import TransportError
from jauspy.logs import get_logger
from jauspy.modules.config import ModuleConfig
from jauspy.services.core import Discovery
from jauspy.services.host import Host

CHECK_PERIOD: Final = 0.05
"""Seconds between two checks which modules have power."""

RETRY_DELAY: Final = 1.0
"""Seconds until a component that could not be opened is tried again."""

_LOG: Final = get_logger("jauspy.modules")


class RunningModules:
    """Opens the components of the modules that are present, and closes those of modules that are not.

    The Discovery of each reports the services of all that are open. `make` makes the component of a module;
    `is_present` says whether a module is there now.
    """

    def __init__(
        self,
        modules: Iterable[ModuleConfig],
        make: Callable[[ModuleConfig], Component],
        is_present: Callable[[ModuleConfig], bool],
    ) -> None:
        self._modules = tuple(modules)
        self._make = make
        self._is_present = is_present
        self._components: dict[int, Component] = {}
        self._tried: dict[int, float] = {}

    @property
    def open(self) -> tuple[tuple[Component, ModuleConfig], ...]:
        """The components that are open, with their modules, in the order of the configuration."""
        return tuple((self._components[at], self._modules[at]) for at in sorted(self._components))

    def hosts(self) -> list[Host]:
        """The hosts of the components that are open."""
        return [component.host for component, _ in self.open]

    async def start(self) -> None:
        """Open the components of the modules that are present. Raises `TransportError` if one cannot be opened."""
        for at, module in enumerate(self._modules):
            if self._is_present(module):
                await self._open(at)

    async def follow(self) -> None:
        """Open and close components as modules appear and disappear, until cancelled."""
        while True:
            await asyncio.sleep(CHECK_PERIOD)
            await self.update()

    async def update(self) -> None:
        """Open and close components once; one that cannot be opened is logged, and tried again later."""
        now = asyncio.get_running_loop().time()
        for at, module in enumerate(self._modules):
            present, component = self._is_present(module), self._components.get(at)
            if component is not None and not present:
                await self._close(at)
            elif component is None and present and now - self._tried.get(at, -RETRY_DELAY) >= RETRY_DELAY:
                await asyncio.sleep(0)  # making one takes 20 ms, and others may wait for the event loop
                try:
                    await self._open(at)
                except TransportError as error:
                    self._tried[at] = now
                    _LOG.warning("%s %s cannot be opened: %s", module.type, module.part or "", error)

    async def close(self) -> None:
        """Close all components, the last one first. May be called twice."""
        for at in sorted(self._components, reverse=True):
            await self._close(at)

    async def _open(self, at: int) -> None:
        component = self._make(self._modules[at])
        others = self.hosts()
        await component.open()
        self._components[at] = component
        self._tried.pop(at, None)
        _list_each_other(component.host, others)

    async def _close(self, at: int) -> None:
        component = self._components[at]
        for host in self.hosts():
            if host is not component.host and (discovery := host.service(Discovery)) is not None:
                discovery.remove_local(component.id)
        await component.close()
        del self._components[at]


def _list_each_other(new: Host, others: Iterable[Host]) -> None:
    """Have the Discovery of each report the services of the other."""
    others = list(others)
    if (discovery := new.service(Discovery)) is not None:
        discovery.add_local(others)
    for other in others:
        if (discovery := other.service(Discovery)) is not None:
            discovery.add_local([new])
