"""Access control of one component as an `async with` block."""

from __future__ import annotations

import asyncio
import logging
from contextlib import ExitStack
from types import TracebackType
from typing import TYPE_CHECKING, Final, Self

from jauspy.arguments import check_number
from jauspy.codec.message import Message
from jauspy.errors import ConfigError, ControlRejected, ProtocolError, ResponseTimeout, TransportError
from jauspy.ids import JausID
from jauspy.messages.core import (
    ConfirmControl,
    QueryControl,
    QueryStatus,
    RejectControl,
    ReleaseControl,
    ReportControl,
    ReportStatus,
    RequestControl,
    Reset,
    Resume,
    SetEmergency,
    Shutdown,
    Standby,
)
from jauspy.ocu.link import Link
from jauspy.ocu.only_async import use
from jauspy.ocu.patience import Patience
from jauspy.ocu.standing import ASK_TIMEOUT, NOBODY, Standing, holder, status_name
from jauspy.protocol.header import Ack

_LOG: Final = logging.getLogger("jauspy.ocu")

LEAVE: Final = 0.5
"""Seconds for which leaving the block waits for the component to say that control is released, if it did not
acknowledge that it has heard of it."""
ECHOES: Final = 1.0
"""Seconds in which what was said of control that this OCU had before, or asked for, may still come in."""
LOOK: Final = 2.0
"""Seconds, at most, between two looks at whether the component still knows of us and does what it was told."""
SILENCE: Final = 10.0
"""Seconds without any answer after which a component is gone that would never take control back by itself."""
REQUESTS: Final = 4
"""Renewals of control that are sent at most each time, until one is confirmed."""
_CALMING: Final = tuple(each.CODE for each in (Standby, SetEmergency, Reset, Shutdown))
"""After one of these from us it is no wonder that the component leaves Ready."""


class Control:
    """Holds control from `async with` on, keeps it alive, and on the way out leaves Standby and releases it.

    Entering raises `ControlRejected`, naming who holds it. When control is lost meanwhile, `lost` says why and
    commands to the component raise `ControlRejected`; the block itself is not interrupted. Control also counts as lost
    when the component has left Ready by itself, as after a restart: from then on it would ignore every command.
    """

    def __init__(self, link: Link, id: JausID, authority: int, patience: Patience) -> None:
        check_number(authority, "authority", whole=True)
        if not 0 <= authority <= 255:
            raise ConfigError(f"authority {authority} is outside 0..255")
        self.id = id
        self.authority = authority
        self.timeout = 0.0
        """Seconds after which the component takes control back from a silent client; 0 when it never does."""
        self.lost = ""
        """Why control was lost; empty while it is held."""
        self._taken = self._parted = False
        self._standing = Standing(link, id, patience)
        self._gone = asyncio.Event()
        self._ready = False
        self._calmed = False
        self._link = link
        self._patience = patience
        self._taken_at = self._confirmed_at = self._known_at = 0.0
        self._stack = ExitStack()
        self._keeper: asyncio.Task[None] | None = None
        self._asker: asyncio.Task[None] | None = None

    def __repr__(self) -> str:
        state = "held" if self.held else self.lost or "not held"
        return f"<control of {self.id} with authority {self.authority}: {state}>"

    @property
    def held(self) -> bool:
        """True while the component has not taken control back."""
        return self._keeper is not None and not self.lost

    def check(self) -> None:
        """Raise `ControlRejected` when control was lost."""
        if self.lost:
            raise self._standing.rejected(f"control of {self.id} was lost: {self.lost}")

    async def until_lost(self) -> None:
        """Wait until control is lost, and `lost` says why, or until the block is left."""
        await self._gone.wait()

    def sent(self, message: Message) -> None:
        """The OCU has sent this to the component: whether it may leave Ready now."""
        if message.CODE == Resume.CODE or message.CODE in _CALMING:
            self._ready, self._calmed = False, message.CODE != Resume.CODE

    async def __aenter__(self) -> Self:
        self._link.controls.take(self.id, self)
        self.lost = ""
        self._taken = self._parted = self._ready = self._calmed = False
        self._gone.clear()
        try:
            await self._acquire()
        except BaseException as error:
            self._link.controls.drop(self.id, self)
            if isinstance(error, ResponseTimeout):
                await self._link.assure(self.id, ReleaseControl())  # it may have been granted, and nobody uses it
            elif not isinstance(error, ControlRejected):
                self._quietly(ReleaseControl(), Ack.REQUIRED)
            raise
        self._stack.enter_context(self._link.replies.tapped(self.id, self._heard, ConfirmControl, RejectControl))
        self._stack.enter_context(self._link.before_closing(self._let_go))
        self._keeper = asyncio.create_task(self._keep(), name=f"control of {self.id}")
        return self

    async def __aexit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        keeper, self._keeper = self._keeper, None
        self._stack.close()
        left = asyncio.Event()
        self._stack.enter_context(self._link.before_closing(left.wait))  # closing the OCU waits for what follows
        try:
            tasks = {each for each in (keeper, self._asker) if each is not None}
            for each in tasks:
                each.cancel()
            if not self._taken and not self._parted:
                await self._give_back()
        finally:
            left.set()
            self._stack.close()
            self._gone.set()
            self._link.controls.drop(self.id, self)
            if tasks:
                await asyncio.wait(tasks)

    if not TYPE_CHECKING:
        __enter__ = __exit__ = use("`async with`")

    # --- taking ---------------------------------------------------------------------------------------------------

    async def _acquire(self) -> None:
        codes, code = ConfirmControl.ResponseCode, await self._asked()
        if code == codes.INSUFFICIENT_AUTHORITY and await self._standing.is_open_to(self.authority):
            code = await self._asked()  # it was an echo: the answer to an earlier request
        if code != codes.CONTROL_ACCEPTED:
            raise self._standing.rejected(await self._standing.explain(code, self.authority))
        self._taken_at = self._confirmed_at = asyncio.get_running_loop().time()
        self.timeout = await self._standing.timeout()

    async def _asked(self) -> int:
        """What it says to a request for control."""
        request = RequestControl(authority_code=self.authority)
        answer = await self._link.request(self.id, request, ConfirmControl, patience=self._patience)
        assert isinstance(answer, ConfirmControl)
        return answer.response_code

    # --- keeping --------------------------------------------------------------------------------------------------

    async def _keep(self) -> None:
        """Look, and ask again, at a third of the timeout, so that a gap in the network does no harm."""
        clock = asyncio.get_running_loop().time
        interval = min(self.timeout / 3 or LOOK, LOOK)
        patience = Patience(min(self._patience.timeout, interval / 3), 1)
        due = self._confirmed_at
        while not self.lost:
            due = max(due + interval, clock())
            await asyncio.sleep(due - clock())
            # And not until now: this event loop may have been busy since.
            silence = due - max(self._known_at, self._confirmed_at)
            if silence > (self.timeout or SILENCE):
                most = f", and its timeout is {self.timeout:g} s" if self.timeout else ""
                self._lose(f"{self.id} has not answered for {silence:.1f} s{most}")
                return
            # Before asking: a component that was started anew would just give control again, and stand still.
            await self._look(patience)
            if self.timeout and not self.lost:
                await self._renew(interval / 2)

    async def _renew(self, seconds: float) -> None:
        """Ask for control again, several times within these seconds while it is not confirmed: packets get lost."""
        clock = asyncio.get_running_loop().time
        asked_at = clock()
        for _ in range(REQUESTS):
            self._quietly(RequestControl(authority_code=self.authority))
            await asyncio.sleep(seconds / REQUESTS)
            if self.lost or self._confirmed_at >= asked_at:
                return

    async def _look(self, patience: Patience) -> None:
        """See whether the component still holds us for its controller, and is as we left it; silence says nothing."""
        control, status = await asyncio.gather(
            self._standing.ask(QueryControl(), patience), self._standing.ask(QueryStatus(), patience)
        )
        if not self.timeout and (control or status):  # it is not asked to confirm
            self._known_at = asyncio.get_running_loop().time()
        if isinstance(control, ReportControl) and not self.lost:
            if self._standing.is_elsewhere(control):
                self._taken = True
                self._lose(f"{self.id} {self._standing.held_by()}")
            elif holder(control) == NOBODY:
                self._lose(f"{self.id} says that nobody is in control; it was started anew, or did not hear us in time")
            else:
                self._known_at = asyncio.get_running_loop().time()
        if isinstance(status, ReportStatus) and not self._calmed:
            if status.status == ReportStatus.Status.READY:
                self._ready = True
            elif self._ready:
                self._lose(f"{self.id} went from READY to {status_name(status)} without being told to by this OCU")

    def _heard(self, message: Message, source: JausID) -> None:
        """A confirmation keeps it; anything else says that it is gone."""
        if isinstance(message, RejectControl):
            if message.response_code == RejectControl.ResponseCode.CONTROL_RELEASED:
                self._take_from(f"{source} took it back: another client outranked you, you were silent, or it ended")
        elif isinstance(message, ConfirmControl):
            if message.response_code == ConfirmControl.ResponseCode.INSUFFICIENT_AUTHORITY:
                self._take_from(f"{source} gave it to another client; your authority of {self.authority} is too low")
            else:  # in an emergency it is not available, but ours
                self._confirmed_at = asyncio.get_running_loop().time()

    def _take_from(self, why: str) -> None:
        """It is lost from now on; who waits for that is told when it is known who has it."""
        if self._taken or (self._asker is not None and not self._asker.done()):
            return
        if asyncio.get_running_loop().time() - self._taken_at > ECHOES:
            self._taken, self.lost = True, self.lost or why
        self._asker = asyncio.create_task(self._ask_who(why, self._link.id), name=f"who controls {self.id}")

    async def _ask_who(self, why: str, me: JausID) -> None:
        """An echo of what was said before does not count; the OCU may be closed when the answer is looked at."""
        control = await self._standing.ask(QueryControl(), ASK_TIMEOUT)
        if isinstance(control, ReportControl):
            if not self._taken and holder(control) == me:
                return
            if self._standing.is_elsewhere(control):
                why = f"{self.id} took it back, and {self._standing.held_by()}; you had {self.authority}"
                self.lost = ""
        self._taken, self.lost = True, self.lost or why
        self._gone.set()

    def _lose(self, why: str) -> None:
        self.lost = self.lost or why
        self._gone.set()

    # --- giving back ----------------------------------------------------------------------------------------------

    async def _let_go(self) -> None:
        """The OCU is being closed inside the block."""
        self._lose("the OCU was closed")
        if not self._taken:
            self._parted = True
            await self._give_back()

    async def _give_back(self) -> None:
        """Standby has to be there first: once control is released, it is not obeyed any more."""
        try:
            await self._link.assure(self.id, Standby())
            if not await self._released():
                self._quietly(ReleaseControl(), Ack.REQUIRED)  # nobody waits for this one
        except BaseException:
            self._quietly(ReleaseControl(), Ack.REQUIRED)
            raise

    async def _released(self) -> bool:
        """Release it. Sent only once, apart from resends: a second one could come late, and end what follows this."""
        with self._link.replies.waiting(self.id, RejectControl) as waiter:
            if await self._link.assure(self.id, ReleaseControl()):
                return True
            await asyncio.wait({waiter.arrival}, timeout=LEAVE)
            return waiter.arrival.done()

    def _quietly(self, message: Message, ack: Ack = Ack.NONE) -> None:
        try:
            self._link.send(self.id, message, ack=ack)
        except TransportError:
            self._lose("the OCU was closed")
        except ProtocolError:
            _LOG.warning("%s cannot be sent %s: too much is under way", self.id, message.NAME)
