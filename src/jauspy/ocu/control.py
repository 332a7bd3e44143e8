"""Access control of one component as an `async with` block (Access Control service, AS5710)."""

from __future__ import annotations

import asyncio
from collections.abc import Mapping
from contextlib import ExitStack
from types import TracebackType
from typing import TYPE_CHECKING, Final, Self

from jauspy.arguments import async_only, check_number
from jauspy.codec.message import Message
from jauspy.errors import ConfigError, ControlRejected, ProtocolError, ResponseTimeout, TransportError
from jauspy.ids import JausID
from jauspy.logs import get_logger
from jauspy.messages.core import (
    ConfirmControl,
    QueryAuthority,
    QueryControl,
    QueryStatus,
    QueryTimeout,
    RejectControl,
    ReleaseControl,
    ReportAuthority,
    ReportControl,
    ReportStatus,
    ReportTimeout,
    RequestControl,
    Resume,
    Standby,
)
from jauspy.ocu.connection import LEAVES_READY, Connection, RetryPolicy
from jauspy.protocol.header import Ack

_LOG: Final = get_logger("jauspy.ocu")

DEFAULT_AUTHORITY: Final = 127
"""The middle of 0..255: clients that must be able to take over use a higher one."""
DEFAULT_CONTROL_TIMEOUT: Final = 3.0
"""Seconds; assumed for a component that does not report its control timeout."""
STATUS_RETRY: Final = RetryPolicy(timeout=0.3, retries=3)
"""Retries of the queries after control was granted or lost: the control timeout is running already."""
CHECK_INTERVAL: Final = 2.0
"""Seconds, at most, between two queries for controller and status of the component."""
MAX_RENEWALS: Final = 4
"""Control requests per interval, until one is confirmed."""
MAX_SILENCE: Final = 10.0
"""Seconds without an answer after which control counts as lost, for a component without a control timeout."""
STALE_REPLY_TIME: Final = 1.0
"""Seconds in which replies to requests of an earlier control of this OCU may still arrive."""
RELEASE_TIMEOUT: Final = 0.5
"""Seconds to wait for the confirmation of a release that was not acknowledged."""
NO_CONTROLLER: Final = JausID(0, 0, 0)
"""The controller that ReportControl names when no client has control."""

REMEDIES: Final[Mapping[int, str]] = {
    ReportStatus.Status.EMERGENCY: "whoever set the emergency must clear it",
    ReportStatus.Status.FAILURE: "send Reset, which needs no control in this state; its log says why it failed",
    ReportStatus.Status.SHUTDOWN: "start the component again",
}
"""Commands that end the states in which a component gives control to nobody (AS5710), apart from initialization."""


class ControlStatus:
    """Queries one component about control, and remembers which other client was last reported to have it."""

    def __init__(self, connection: Connection, id: JausID, retry: RetryPolicy) -> None:
        self._connection = connection
        self._id = id
        self._retry = retry
        self._other: tuple[JausID | None, int | None] = (None, None)

    async def query(self, query: Message, retry: RetryPolicy | None = None) -> Message | None:
        """The report; None when none arrives."""
        try:
            return await self._connection.query(self._id, query, retry=retry or self._retry)
        except (ResponseTimeout, TransportError):
            return None

    async def timeout(self) -> float:
        """Seconds after which the component takes control back from a silent client; 0 when it never does."""
        report = await self.query(QueryTimeout(), STATUS_RETRY)
        return float(report.timeout) if isinstance(report, ReportTimeout) else DEFAULT_CONTROL_TIMEOUT

    async def explain(self, code: int, authority: int) -> str:
        """Why it refused control to a client with this authority."""
        asked = f"requested with {authority}"
        if code == ConfirmControl.ResponseCode.NOT_AVAILABLE:
            status = await self.query(QueryStatus())
            if not isinstance(status, ReportStatus):
                return f"{self._id} is not available for control; clear an emergency, or wait until it is ready"
            remedy = REMEDIES.get(status.status, "wait until it is in Standby")
            return f"{self._id} is not available for control (its status is {status_name(status)}); {remedy}"
        if isinstance(control := await self.query(QueryControl()), ReportControl) and self.is_held_by_other(control):
            return f"{self._id} {self.held_by()}; {asked}"
        least = await self.query(QueryAuthority())
        if isinstance(least, ReportAuthority):
            return f"{self._id} gives control to authority {least.authority_code} and above; {asked}"
        return f"{self._id} refused control (code {code}); {asked}"

    async def is_available_to(self, authority: int) -> bool:
        """True when this client, nobody, or a client of lower authority has control."""
        control = await self.query(QueryControl())
        if not isinstance(control, ReportControl):
            return False
        return not self.is_held_by_other(control) or control.authority_code < authority

    def is_held_by_other(self, control: ReportControl) -> bool:
        """True when another client has control; remembers which."""
        found = controller(control)
        if found in (NO_CONTROLLER, self._connection.id):
            return False
        self._other = (found, control.authority_code)
        return True

    def held_by(self) -> str:
        """A description of the other client."""
        return "is held by {} with authority {}".format(*self._other)

    def rejected(self, why: str) -> ControlRejected:
        """The error, with the other client as holder."""
        found, authority = self._other
        return ControlRejected(why, holder=found, authority=authority)


class Control:
    """Holds control inside `async with`, renews it, and on exit sends Standby and releases control.

    Entering raises `ControlRejected`, which names the client in control. When control is lost later, `lost` gives the
    reason and commands to the component raise `ControlRejected`; the block itself is not interrupted. Control also
    counts as lost when the component left Ready without a command of this client, as after a restart, since it then
    ignores commands.
    """

    def __init__(self, connection: Connection, id: JausID, authority: int, retry: RetryPolicy) -> None:
        check_number(authority, "authority", whole=True)
        if not 0 <= authority <= 255:
            raise ConfigError(f"authority {authority} is outside 0..255")
        self.id = id
        self.authority = authority
        self.timeout = 0.0
        """Seconds after which the component takes control back from a silent client; 0 when it never does."""
        self.lost = ""
        """Why control was lost; empty while it is held."""
        self.released: bool | None = None
        """After the block: true when the component has acknowledged Standby and release; false when it has not, and
        may move on until its time-outs. None before, and when another client has taken control."""
        self._connection = connection
        self._retry = retry
        self._status = ControlStatus(connection, id, retry)
        self._ended = asyncio.Event()
        self._taken = False
        """Another client has control, or the component took it back: nothing is released on exit."""
        self._returned = False
        """Control was released already, because the OCU is being closed."""
        self._was_ready = False
        self._may_leave_ready = False
        self._granted_at = self._confirmed_at = self._answered_at = 0.0
        self._stack = ExitStack()
        self._renewal: asyncio.Task[None] | None = None
        self._holder_query: asyncio.Task[None] | None = None

    def __repr__(self) -> str:
        state = "held" if self.held else self.lost or "not held"
        return f"<control of {self.id} with authority {self.authority}: {state}>"

    @property
    def held(self) -> bool:
        """True while the component has not taken control back."""
        return self._renewal is not None and not self.lost

    def check(self) -> None:
        """Raise `ControlRejected` when control was lost."""
        if self.lost:
            raise self._status.rejected(f"control of {self.id} was lost: {self.lost}")

    async def until_lost(self) -> None:
        """Wait until control is lost, and `lost` gives the reason, or until the block is left."""
        await self._ended.wait()

    def on_sent(self, message: Message) -> None:
        """Called for each message that the OCU sends to the component, which may now leave Ready."""
        if message.CODE == Resume.CODE or message.CODE in LEAVES_READY:
            self._was_ready, self._may_leave_ready = False, message.CODE != Resume.CODE

    def on_ready(self) -> None:
        """Called when the component has reported Ready after a Resume of this OCU: from now on it should not leave."""
        self._was_ready = not self._may_leave_ready

    async def __aenter__(self) -> Self:
        self._connection.controls.add(self.id, self)
        self.lost, self.released = "", None
        self._taken = self._returned = self._was_ready = self._may_leave_ready = False
        self._ended.clear()
        try:
            await self._acquire()
        except BaseException as error:
            self._connection.controls.remove(self.id, self)
            if isinstance(error, ResponseTimeout):
                await self._connection.deliver(self.id, ReleaseControl())  # it may have been granted all the same
            elif not isinstance(error, ControlRejected):
                self._try_send(ReleaseControl(), Ack.REQUIRED)
            raise
        replies = self._connection.replies.listening(self.id, self._on_message, ConfirmControl, RejectControl)
        self._stack.enter_context(replies)
        self._stack.enter_context(self._connection.on_close(self._on_close))
        self._renewal = asyncio.create_task(self._keep_alive(), name=f"control of {self.id}")
        return self

    async def __aexit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        renewal, self._renewal = self._renewal, None
        self._stack.close()
        left = asyncio.Event()
        self._stack.enter_context(self._connection.on_close(left.wait))  # closing the OCU waits for what follows
        try:
            tasks = {task for task in (renewal, self._holder_query) if task is not None}
            for task in tasks:
                task.cancel()
            if not self._taken and not self._returned:
                await self._release()
        finally:
            left.set()
            self._stack.close()
            self._ended.set()
            self._connection.controls.remove(self.id, self)
            if tasks:
                await asyncio.wait(tasks)

    if not TYPE_CHECKING:
        __enter__ = __exit__ = async_only("`async with`")

    # --- acquiring ------------------------------------------------------------------------------------------------

    async def _acquire(self) -> None:
        codes, code = ConfirmControl.ResponseCode, await self._request()
        if code == codes.INSUFFICIENT_AUTHORITY and await self._status.is_available_to(self.authority):
            code = await self._request()  # the first reply was a late one, to an earlier request
        if code != codes.CONTROL_ACCEPTED:
            raise self._status.rejected(await self._status.explain(code, self.authority))
        self._granted_at = self._confirmed_at = asyncio.get_running_loop().time()
        self.timeout = await self._status.timeout()

    async def _request(self) -> int:
        """Request control; returns the response code."""
        request = RequestControl(authority_code=self.authority)
        answer = await self._connection.request(self.id, request, ConfirmControl, retry=self._retry)
        assert isinstance(answer, ConfirmControl)
        return answer.response_code

    # --- keeping --------------------------------------------------------------------------------------------------

    async def _keep_alive(self) -> None:
        """Keep control until the block is left; when the event loop is ended around the block, stop the component.

        `asyncio.run` cancels what still runs when the program ends by an error, in the block or outside.
        """
        try:
            await self._check_and_renew()
        except asyncio.CancelledError:
            if self._renewal is not None and not self._taken and not self._returned:
                self._returned = True
                await self._release()
            raise

    async def _check_and_renew(self) -> None:
        """Check and renew control at a third of its timeout, so that single lost packets do not end it."""
        clock = asyncio.get_running_loop().time
        interval = min(self.timeout / 3 or CHECK_INTERVAL, CHECK_INTERVAL)
        retry = RetryPolicy(min(self._retry.timeout, interval / 3), 1)
        due = self._confirmed_at
        while not self.lost:
            due = max(due + interval, clock())
            await asyncio.sleep(due - clock())
            # Up to `due`, not up to now: this event loop may have been blocked in between.
            silence = due - max(self._answered_at, self._confirmed_at)
            if silence > (self.timeout or MAX_SILENCE):
                most = f", and its timeout is {self.timeout:g} s" if self.timeout else ""
                self._lose(f"{self.id} has not answered for {silence:.1f} s{most}")
                return
            # Before the renewal: a component that was restarted would grant control again, and stay in Standby.
            await self._check(retry)
            if self.timeout and not self.lost:
                await self._renew(interval / 2)

    async def _renew(self, seconds: float) -> None:
        """Request control again, several times within these seconds until it is confirmed: packets get lost."""
        clock = asyncio.get_running_loop().time
        requested_at = clock()
        for _ in range(MAX_RENEWALS):
            self._try_send(RequestControl(authority_code=self.authority))
            await asyncio.sleep(seconds / MAX_RENEWALS)
            if self.lost or self._confirmed_at >= requested_at:
                return

    async def _check(self, retry: RetryPolicy) -> None:
        """Check that this OCU is the controller and that the component has not left Ready; no answer is no loss."""
        control, status = await asyncio.gather(
            self._status.query(QueryControl(), retry), self._status.query(QueryStatus(), retry)
        )
        if not self.timeout and (control or status):  # there are no renewals that it could confirm
            self._answered_at = asyncio.get_running_loop().time()
        if isinstance(control, ReportControl) and not self.lost:
            if self._status.is_held_by_other(control):
                self._taken = True
                self._lose(f"{self.id} {self._status.held_by()}")
            elif controller(control) == NO_CONTROLLER:
                self._lose(
                    f"{self.id} reports no client in control; it was restarted, or renewals did not arrive in time"
                )
            else:
                self._answered_at = asyncio.get_running_loop().time()
        if isinstance(status, ReportStatus) and not self._may_leave_ready:
            if status.status == ReportStatus.Status.READY:
                self._was_ready = True
            elif self._was_ready:
                why = (
                    "since its emergency was set"
                    if status.status == ReportStatus.Status.EMERGENCY
                    else "without a command of this OCU"
                )
                self._lose(f"{self.id} went from READY to {status_name(status)} {why}")

    def _on_message(self, message: Message, source: JausID) -> None:
        if isinstance(message, RejectControl):
            if message.response_code == RejectControl.ResponseCode.CONTROL_RELEASED:
                self._on_taken(f"{source} took it back")
        elif isinstance(message, ConfirmControl):
            if message.response_code == ConfirmControl.ResponseCode.INSUFFICIENT_AUTHORITY:
                self._on_taken(f"{source} gave it to another client; your authority of {self.authority} is too low")
            else:  # NOT_AVAILABLE too: in an emergency control remains with this OCU
                self._confirmed_at = asyncio.get_running_loop().time()

    def _on_taken(self, why: str) -> None:
        """Control is lost from now on; `until_lost` returns when the new controller is known."""
        if self._taken or (self._holder_query is not None and not self._holder_query.done()):
            return
        if asyncio.get_running_loop().time() - self._granted_at > STALE_REPLY_TIME:
            self._taken, self.lost = True, self.lost or why
        self._holder_query = asyncio.create_task(self._query_holder(why), name=f"who controls {self.id}")

    async def _query_holder(self, why: str) -> None:
        """A stale reply does not count."""
        control = await self._status.query(QueryControl(), STATUS_RETRY)
        if self.lost == why:  # it is known better now
            self.lost = ""
        if isinstance(control, ReportControl):
            if not self._taken and controller(control) == self._connection.id:
                return
            if self._status.is_held_by_other(control):
                why = f"{self.id} took it back, and {self._status.held_by()}; you had {self.authority}"
                self.lost = ""
            elif controller(control) == NO_CONTROLLER:
                why = f"{why}{self._freed()}"
        else:
            why = f"{why}, and does not tell who has it now: it has ended, or packets are lost"
        self._taken, self.lost = True, self.lost or why
        self._ended.set()

    def _freed(self) -> str:
        """Why nobody has control now, as far as this client can tell."""
        silence = asyncio.get_running_loop().time() - self._confirmed_at
        if self.timeout and silence >= self.timeout:
            return f": it has confirmed no renewal for {silence:.1f} s, and its timeout is {self.timeout:g} s"
        return ", and nobody has it: it was reset, has failed or is ending"

    def _lose(self, why: str) -> None:
        self.lost = self.lost or why
        self._ended.set()

    # --- releasing ------------------------------------------------------------------------------------------------

    async def _on_close(self) -> None:
        """The OCU is closed inside the block."""
        self._lose("the OCU was closed")
        if not self._taken:
            self._returned = True
            await self._release()

    async def _release(self) -> None:
        """Standby must arrive first: a component ignores commands of a client that has released control."""
        self.released = False
        try:
            stands = await self._connection.deliver(self.id, Standby())
            left = await self._released()
            if not left:
                self._try_send(ReleaseControl(), Ack.REQUIRED)  # resent in the background
            self.released = stands and left
            if not self.released:
                _LOG.warning("%s did not acknowledge Standby and release of control; it may move on", self.id)
        except BaseException:
            self._try_send(ReleaseControl(), Ack.REQUIRED)
            raise

    async def _released(self) -> bool:
        """Send ReleaseControl once, apart from resends: a late second one could end a control that follows."""
        with self._connection.replies.waiting(self.id, RejectControl) as waiter:
            if await self._connection.deliver(self.id, ReleaseControl()):
                return True
            await asyncio.wait({waiter.reply}, timeout=RELEASE_TIMEOUT)
            return waiter.reply.done()

    def _try_send(self, message: Message, ack: Ack = Ack.NONE) -> None:
        try:
            self._connection.send(self.id, message, ack=ack)
        except TransportError:
            self._lose("the OCU was closed")
        except ProtocolError:
            _LOG.warning("%s cannot be sent %s: too many messages are under way", self.id, message.NAME)


def controller(control: ReportControl) -> JausID:
    """The client in control."""
    return JausID(control.subsystem_id, control.node_id, control.component_id)


def status_name(report: ReportStatus) -> str:
    """The status by name, as in READY."""
    return getattr(report.status, "name", str(report.status))
