"""Control of several components of a robot as one `async with` block."""

from __future__ import annotations

import asyncio
from collections.abc import Awaitable, Callable, Coroutine, Iterable, Sequence
from types import TracebackType
from typing import TYPE_CHECKING, Any, Final, Self

from jauspy.arguments import async_only
from jauspy.errors import ConfigError
from jauspy.ids import JausID
from jauspy.ocu.connection import Connection
from jauspy.ocu.control import Control
from jauspy.ocu.service import ServiceClient
from jauspy.ocu.subsystems import ServiceInfo


class RobotControl:
    """Controls components of a robot in the block: takes control and resumes them; Standby and release at the end.

    Entering raises `ControlRejected`, which names the client in control, and then controls nothing. When control of a
    component is lost later, commands to it raise `ControlRejected`, and `lost` gives the reason.
    """

    def __init__(
        self, connection: Connection, ids: Sequence[JausID], authority: int, leave: Callable[[], Awaitable[None]]
    ) -> None:
        if not ids:
            raise ConfigError("there is nothing to control: the robot offers no service that moves it")
        self.ids: tuple[JausID, ...] = tuple(ids)
        """The components, as their robot lists them."""
        self._connection = connection
        self._authority = authority
        self._leave = leave
        self._controls: list[Control] = []

    def __repr__(self) -> str:
        return (
            f"<control of {', '.join(map(str, self.ids))}: {self.lost or ('held' if self._controls else 'not held')}>"
        )

    @property
    def held(self) -> bool:
        """True while all components are controlled."""
        return bool(self._controls) and all(each.held for each in self._controls)

    @property
    def lost(self) -> str:
        """Why control of a component was lost; empty while all are held."""
        return next((each.lost for each in self._controls if each.lost), "")

    def check(self) -> None:
        """Raise `ControlRejected` when control of a component was lost."""
        for each in self._controls:
            each.check()

    async def resume(self) -> None:
        """Resume the components again, as after the link was lost, an emergency, or a Standby from somewhere else.

        They obey commands that come from now on; nothing that was under way goes on by itself.
        """
        self.check()
        await _together(self._resume(each) for each in self._controls)

    async def until_lost(self) -> None:
        """Wait until control of a component is lost, or until the block is left."""
        waiting = [asyncio.ensure_future(each.until_lost()) for each in self._controls]
        try:
            await asyncio.wait(waiting, return_when=asyncio.FIRST_COMPLETED)
        finally:
            for each in waiting:
                each.cancel()

    async def __aenter__(self) -> Self:
        connection = self._connection
        controls = [Control(connection, id, self._authority, connection.retry) for id in self.ids]
        try:
            await _together(self._enter(each) for each in controls)
        except BaseException as error:
            await self._exit(error)
            raise
        return self

    async def _enter(self, control: Control) -> None:
        await control.__aenter__()
        self._controls.append(control)
        await self._resume(control)

    async def _resume(self, control: Control) -> None:
        await ServiceClient(self._connection, control.id, _MANAGEMENT).resume()

    async def __aexit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        try:
            await self._leave()
        finally:
            await self._exit(error)

    async def _exit(self, error: BaseException | None) -> None:
        controls, self._controls = self._controls, []
        kind = None if error is None else type(error)
        await _together(each.__aexit__(kind, error, None) for each in controls)

    if not TYPE_CHECKING:
        __enter__ = __exit__ = async_only("`async with`")


_MANAGEMENT: Final = ServiceInfo("urn:jaus:jss:core:Management", "1.1")


async def _together(work: Iterable[Coroutine[Any, Any, None]]) -> None:
    """Run all to their ends, then raise the first error: a component that fails must not leave others half way."""
    results = await asyncio.gather(*work, return_exceptions=True)
    for each in results:
        if isinstance(each, BaseException):
            raise each
