"""The client of one service of one component."""

# ruff: noqa: ASYNC109 - a timeout ends in an error that says what was asked, and of whom

from __future__ import annotations

import asyncio
from collections.abc import Mapping
from contextlib import suppress
from typing import Any, Final, TypeVar, overload

from jauspy.arguments import check_number
from jauspy.codec.message import Message, Query
from jauspy.errors import RequestError, ResponseTimeout
from jauspy.ids import JausID
from jauspy.messages.core import QueryStatus, ReportStatus, Resume, Standby
from jauspy.messages.environment_sensing.v2_0.visual_sensor import ConfirmSensorConfiguration
from jauspy.ocu.commands import CommandStream, perform
from jauspy.ocu.connection import Connection
from jauspy.ocu.control import DEFAULT_AUTHORITY, REMEDIES, Control
from jauspy.ocu.explain import explain
from jauspy.ocu.lists import Elements
from jauspy.ocu.replies import reply_class
from jauspy.ocu.stills import Photo, configuration, take_photo
from jauspy.ocu.subscription import Subscription, subscribe
from jauspy.ocu.subsystems import ServiceInfo

R = TypeVar("R", bound=Message)

_STATUS_INTERVAL: Final = 0.05
"""Seconds between two status queries."""
_NOT_IN_CONTROL: Final = "it accepts commands only from the client in control: use `control()` first"
_REFUSES: Final = "you are in control, so it refuses or takes longer; see its log, or allow more `timeout`"
_HINTS: Final[Mapping[int, str]] = {
    ReportStatus.Status.INITIALIZE: "it is still starting; allow more `timeout`",
    **REMEDIES,
}


class ServiceClient:
    """Sends to one component. `timeout` is for each attempt, in seconds; `retries` is the number of further ones."""

    def __init__(self, connection: Connection, id: JausID, info: ServiceInfo) -> None:
        self.id = id
        self.info = info
        self._connection = connection
        self._elements = Elements(connection, id, info)

    def __repr__(self) -> str:
        return f"<{self.info} at {self.id}>"

    @property
    def elements(self) -> Elements:
        """The element list of the component, of services with a list manager."""
        return self._elements

    @property
    def waypoints(self) -> Elements:
        """Another name of `elements`, for LocalWaypointListDriver and GlobalWaypointListDriver."""
        return self._elements

    def message(self, name: str) -> type[Any]:
        """The message class of this JAUS name as the service has it, in the component's version when that is known."""
        return self._connection.message_class(self.info.urn, self.info.version, name)

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
        """The report that answers a query, such as `ReportStatus` for `QueryStatus`; `expects` names another class.

        If no answer arrives, `ResponseTimeout` is raised.
        """
        retry = self._connection.retry.replaced(timeout, retries)
        return await self._connection.query(self.id, message, retry=retry, expects=expects)

    async def send(self, message: Message, *, ack: bool = False) -> None:
        """Send a command; raises `ControlRejected` when control was taken and has been lost.

        With `ack` it is resent until the component acknowledges it. If it does not, `ResponseTimeout` is raised.
        """
        await self._connection.send_checked(self.id, message, ack=ack)

    async def configure(self, settings: Message, what: str = "the settings") -> None:
        """Send settings of sensors; raises `RequestError` with the component's reason if it refuses them.

        `what` names the settings in the error. Needs control.
        """
        answer = await self.query(settings, expects=ConfirmSensorConfiguration)
        for sensor in answer.confirm_sensor_list:
            if text := getattr(sensor, "error_message", ""):
                raise RequestError(f"{self.id} refused {what}: {text}")

    async def perform(self, command: Message, *, within: float) -> None:
        """Send a command and wait until it has been carried out, for example until an arm has reached its target.

        It may take `within` seconds. Raises `RequestError` when the component gave the command up, `EventRejected` when
        it does not take the command or has no command events (Events 1.1), `ControlRejected` and `ResponseTimeout`.
        Cancelling this call does not stop the command. The command is sent again when no answer arrives: components of
        jauspy recognise it, others may execute it twice.
        """
        await perform(self._connection, self.id, command, within)

    def streaming(self, rate: float = 20.0) -> CommandStream:
        """`async with driver.streaming(rate=20) as stream: await stream.send(command)`: a repeated command.

        It is sent again at `rate` Hz only while the event loop of the program runs, so that the robot stops when the
        program hangs. Needs control.
        """
        return CommandStream(self._connection, self.id, rate)

    async def explain(self, command: Message | None = None) -> str:
        """Why the component ignores commands, or this one, as one sentence; empty if nothing is found.

        JAUS has no answer to a command that is ignored, so this queries control, status, services, joints and limits.
        """
        return await explain(self._connection, self.id, command)

    def control(
        self, authority: int = DEFAULT_AUTHORITY, *, timeout: float | None = None, retries: int | None = None
    ) -> Control:
        """Control of the component for an `async with` block, with this authority (0..255)."""
        return Control(self._connection, self.id, authority, self._connection.retry.replaced(timeout, retries))

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

        `silence` (seconds) is how long reports may be missing before reading raises `ResponseTimeout`: by default ten
        periods, at least 2 s; without limit on change. At most `buffer` reports wait to be read.
        """
        kind = reply_class(self._connection.registry, query, expects, "subscribe()")
        return subscribe(self._connection, self.id, query, kind, rate=rate, buffer=buffer, silence=silence)

    async def still(
        self,
        *,
        size: tuple[int, int] | None = None,
        format: str | None = None,
        sensor: int = 1,
        timeout: float = 10.0,
    ) -> Photo:
        """An image of a camera with the service StillImage; a camera that is off needs some seconds to start.

        `size` (width, height in pixels) and `format` ("jpeg", "png") are set for this one image, for which control is
        taken for a moment; None leaves them as the camera is configured. Raises `RequestError` when the camera rejects
        them or has no image.
        """
        return await take_photo(self._connection, self.id, configuration(sensor, size, format), timeout)

    async def status(self) -> ReportStatus.Status | int:
        """The status that the Management service reports."""
        return (await self.query(QueryStatus(), expects=ReportStatus)).status

    async def resume(self, timeout: float = 3.0) -> None:
        """Enter Ready, in which commands take effect.

        Needs control; raises `RequestError` if `timeout` seconds pass first.
        """
        await self._change(Resume(), ReportStatus.Status.READY, timeout)
        self._connection.controls.on_ready(self.id)

    async def standby(self, timeout: float = 3.0) -> None:
        """Enter Standby, in which motion stops.

        Needs control; raises `RequestError` if `timeout` seconds pass first.
        """
        await self._change(Standby(), ReportStatus.Status.STANDBY, timeout)

    async def _change(self, command: Message, wanted: ReportStatus.Status, timeout: float) -> None:
        check_number(timeout, "timeout")
        status: ReportStatus.Status | int | None = None
        try:
            async with asyncio.timeout(timeout) as limit:
                while True:
                    with suppress(ResponseTimeout):
                        # Without ack it could arrive late and undo the next command, such as Resume after Standby.
                        await self.send(command, ack=True)
                    with suppress(ResponseTimeout):
                        status = await self.status()
                        if status == wanted:
                            return
                        await asyncio.sleep(_STATUS_INTERVAL)
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
        in_control = self.id in self._connection.controls
        hint = _HINTS.get(status, _REFUSES if in_control else _NOT_IN_CONTROL)
        name = getattr(status, "name", status)
        return RequestError(f"{self.id} still reports {name} {timeout:g} s after {command.NAME}; {hint}")
