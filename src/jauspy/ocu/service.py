"""One service of one component, as a client sees it."""

# ruff: noqa: ASYNC109 - a timeout ends in an error that says what was asked, and of whom

from __future__ import annotations

import asyncio
from collections.abc import Mapping
from contextlib import suppress
from typing import Any, Final, TypeVar, overload

from jauspy.arguments import check_number, check_text
from jauspy.codec.message import Message, Query
from jauspy.errors import ConfigError, RequestError, ResponseTimeout
from jauspy.ids import JausID
from jauspy.messages.core import QueryStatus, ReportStatus, Resume, Standby
from jauspy.ocu.answers import answer_to
from jauspy.ocu.commands import perform
from jauspy.ocu.control import Control
from jauspy.ocu.elements import Elements
from jauspy.ocu.event_requests import Request
from jauspy.ocu.link import Link
from jauspy.ocu.model import ServiceInfo
from jauspy.ocu.stills import Photo, configuration, photograph
from jauspy.ocu.subscription import Subscription

R = TypeVar("R", bound=Message)

DEFAULT_AUTHORITY: Final = 127
"""The middle of 0..255: leaves room above for those who must be able to take over."""
_LISTS: Final = "urn:jaus:jss:manipulator:ManipulatorListDriver"
"""The messages that carry out a list are its, since manipulator 2.0; the drivers of its elements inherit them."""
_POLL: Final = 0.05
_OBEYS: Final = "it obeys only the client in control: use `control()` first"
_REFUSES: Final = "you are in control, so it refuses or takes longer; see its log, or allow more `timeout`"
_HINTS: Final[Mapping[int, str]] = {
    ReportStatus.Status.INITIALIZE: "it is still starting; allow more `timeout`",
    ReportStatus.Status.EMERGENCY: "whoever set the emergency must clear it",
    ReportStatus.Status.FAILURE: "see why it failed; Reset may help",
    ReportStatus.Status.SHUTDOWN: "start the component again",
}


class ServiceClient:
    """Sends to one component. Times are in seconds; `timeout` is for one attempt, `retries` attempts follow."""

    def __init__(self, link: Link, id: JausID, info: ServiceInfo) -> None:
        self.id = id
        self.info = info
        self._link = link
        self._elements = Elements(link, self)

    def __repr__(self) -> str:
        return f"<{self.info} at {self.id}>"

    @property
    def elements(self) -> Elements:
        """The list that the component carries out, of services with a list manager."""
        return self._elements

    @property
    def waypoints(self) -> Elements:
        """`elements`, as one calls them of LocalWaypointListDriver and GlobalWaypointListDriver."""
        return self._elements

    def message(self, name: str) -> type[Any]:
        """The message class of this JAUS name as the service has it, in the component's version when that is known."""
        check_text(name, "a message's name")
        registry = self._link.registry
        for urn, version in ((self.info.urn, self.info.version), *_parent(self.info), (self.info.urn, None)):
            with suppress(ConfigError):
                return registry.by_name(name, service=urn, version=version)
        if any(entry.service == self.info.urn for entry in registry.entries):
            raise ConfigError(f"{self.info.short} has no message {name}")
        raise ConfigError(f"no definition of {self.info.urn} is known here; give it: OCU(registry=jauspy.load(FILE))")

    @overload
    async def query(
        self, message: Message, *, expects: type[R], timeout: float | None = ..., retries: int | None = ...
    ) -> R: ...

    @overload
    async def query(
        self, message: Query[R], *, expects: None = ..., timeout: float | None = ..., retries: int | None = ...
    ) -> R: ...

    @overload
    async def query(
        self, message: Message, *, expects: None = ..., timeout: float | None = ..., retries: int | None = ...
    ) -> Any: ...

    async def query(
        self,
        message: Any,
        *,
        expects: type[Message] | None = None,
        timeout: float | None = None,
        retries: int | None = None,
    ) -> Any:
        """The report that answers a query, as in `ReportStatus` for `QueryStatus`; `expects` names another class.

        Raises `ResponseTimeout` when it stays out.
        """
        patience = self._link.patience.changed(timeout, retries)
        return await self._link.query(self.id, message, patience=patience, expects=expects)

    async def send(self, message: Message, *, ack: bool = False) -> None:
        """Send a command; raises `ControlRejected` when control was taken and is lost meanwhile.

        With `ack` it is resent until the component acknowledges it; raises `ResponseTimeout` when that stays out.
        """
        await self._link.tell(self.id, message, ack=ack)

    async def perform(self, command: Message, *, within: float) -> None:
        """Send a command and wait until it has been carried out, as until an arm is where it was told to be.

        It may take `within` seconds. Raises `RequestError` when it was given up, `EventRejected` when the component
        does not take it or tells no ends of commands (Events 1.1 does), `ControlRejected` and `ResponseTimeout`. Who
        stops waiting, by cancellation, does not stop the command. It is sent again when no answer comes: components of
        jauspy know it again, others may begin twice.
        """
        await perform(self._link, self.id, command, within)

    def control(
        self, authority: int = DEFAULT_AUTHORITY, *, timeout: float | None = None, retries: int | None = None
    ) -> Control:
        """Control of the component for an `async with` block, with this authority (0..255)."""
        return Control(self._link, self.id, authority, self._link.patience.changed(timeout, retries))

    @overload
    def subscribe(
        self,
        query: Message,
        *,
        rate: float | None = ...,
        expects: type[R],
        buffer: int = ...,
        silence: float | None = ...,
    ) -> Subscription[R]: ...

    @overload
    def subscribe(
        self,
        query: Query[R],
        *,
        rate: float | None = ...,
        expects: None = ...,
        buffer: int = ...,
        silence: float | None = ...,
    ) -> Subscription[R]: ...

    @overload
    def subscribe(
        self,
        query: Message,
        *,
        rate: float | None = ...,
        expects: None = ...,
        buffer: int = ...,
        silence: float | None = ...,
    ) -> Subscription[Any]: ...

    def subscribe(
        self,
        query: Any,
        *,
        rate: float | None = None,
        expects: type[Message] | None = None,
        buffer: int = 64,
        silence: float | None = None,
    ) -> Subscription[Any]:
        """Reports on `query` at `rate` Hz, or on every change.

        `silence` is how long reports may stay out; by default ten periods, at least 2 s, and any time on change.
        """
        check_number(rate, "rate", optional=True)
        if silence is None and rate:
            silence = max(2.0, 10.0 / rate)
        kind = answer_to(self._link.registry, query, expects, "subscribe()")
        return Subscription(self._link, Request(self.id, query, rate, silence, buffer), kind, self._link.patience)

    async def still(
        self,
        *,
        size: tuple[int, int] | None = None,
        format: str | None = None,
        sensor: int = 1,
        timeout: float = 10.0,
    ) -> Photo:
        """A picture by a camera with the service StillImage; a cold camera needs some seconds to start.

        `size` (width, height) and `format` ("jpeg", "png") are set for this one picture, which needs control for a
        moment; without them it is as the camera is set. Raises `RequestError` when the camera refuses or has none.
        """
        return await photograph(self._link, self, configuration(sensor, size, format), timeout)

    async def status(self) -> ReportStatus.Status | int:
        """What Management reports."""
        return (await self.query(QueryStatus(), expects=ReportStatus)).status

    async def resume(self, timeout: float = 3.0) -> None:
        """To Ready: commands take effect. Needs control; raises `RequestError` when it does not happen in time."""
        await self._change(Resume(), ReportStatus.Status.READY, timeout)

    async def standby(self, timeout: float = 3.0) -> None:
        """To Standby: what moves stops. Needs control; raises `RequestError` when it does not happen in time."""
        await self._change(Standby(), ReportStatus.Status.STANDBY, timeout)

    async def _change(self, command: Message, wanted: ReportStatus.Status, timeout: float) -> None:
        check_number(timeout, "timeout")
        status: ReportStatus.Status | int | None = None
        try:
            async with asyncio.timeout(timeout) as limit:
                while True:
                    with suppress(ResponseTimeout):
                        # Were it only sent, it could come late, and undo what is sent next, as Standby after Resume.
                        await self.send(command, ack=True)
                    with suppress(ResponseTimeout):
                        status = await self.status()
                        if status == wanted:
                            return
                        await asyncio.sleep(_POLL)
        except TimeoutError:
            if not limit.expired():
                raise
            raise self._unchanged(command, status, timeout) from None

    def _unchanged(self, command: Message, status: ReportStatus.Status | int | None, timeout: float) -> RequestError:
        if status is None:
            return ResponseTimeout(
                f"{self.id} was sent {command.NAME} and did not report its status within {timeout:g} s; check that it "
                "runs and that the node manager is reachable"
            )
        in_control = self.id in self._link.controls
        hint = _HINTS.get(status, _REFUSES if in_control else _OBEYS)
        name = getattr(status, "name", status)
        return RequestError(f"{self.id} still reports {name} {timeout:g} s after {command.NAME}; {hint}")


def _parent(info: ServiceInfo) -> tuple[tuple[str, str], ...]:
    is_driver = info.urn.startswith(_LISTS.removesuffix("ListDriver")) and info.urn.endswith("ListDriver")
    return ((_LISTS, info.version),) if is_driver else ()
