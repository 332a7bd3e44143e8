"""Handoff of control between the console and other clients, of components with EnhancedAccessControl (IOP v3)."""

from __future__ import annotations

import asyncio
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Final

from jauspy.console.languages import sentence
from jauspy.console.operation import Operation
from jauspy.console.users import User
from jauspy.errors import JausError
from jauspy.ids import JausID
from jauspy.ocu import OCU
from jauspy.ocu.control import Control
from jauspy.ocu.robot import Robot
from jauspy.printable import printable
from jauspy.services.iop.handoff import Decision, HandoffRequest

SERVICE: Final = "iop:EnhancedAccessControl"
REQUEST_TIME: Final = 15.0
"""Seconds for which a request is shown after the component has shown it last; most components end it then."""
MAX_SHOWN: Final = 64
"""Requests that are shown; the oldest give way."""


@dataclass(frozen=True, slots=True)
class Held:
    """A component that a page has taken, or was handed."""

    token: str
    user: User
    control: Control


class Handoffs:
    """Components that pages of the console hold beside the robots that they operate, and requests of other clients.

    `operation` finds who operates a robot: this page answers requests for its components, too.
    """

    def __init__(
        self,
        ocu: OCU,
        robots: Callable[[], Mapping[int, Robot]],
        on_event: Callable[[str], None],
        operation: Callable[[int], Operation | None],
    ) -> None:
        self._ocu = ocu
        self._robots = robots
        self._on_event = on_event
        self._operation = operation
        self._held: dict[JausID, Held] = {}
        self._shown: dict[tuple[JausID, int], tuple[HandoffRequest, float]] = {}
        ocu.decide_handoffs(self._on_request)

    def held(self, component: JausID) -> Held | None:
        """Who holds a component; None when no page of this console does."""
        found = self._held.get(component)
        return found if found is not None and found.control.held else None

    def requests(self, component: JausID) -> list[HandoffRequest]:
        """Requests of other clients for a component that this console controls, oldest first."""
        now = asyncio.get_running_loop().time()
        self._shown = {key: entry for key, entry in self._shown.items() if now - entry[1] <= REQUEST_TIME}
        return [request for (id, _), (request, _) in self._shown.items() if id == component]

    def may_answer(self, token: str, component: JausID) -> bool:
        """True for the page that holds the component, or operates its robot while nobody holds it."""
        if (held := self.held(component)) is not None:
            return held.token == token
        operation = self._operation(component.subsystem)
        return operation is not None and operation.operator == token

    async def take(self, token: str, user: User, component: JausID, authority: int) -> str:
        """Take control of a component that is free; returns why not, or an empty string."""
        return await self._enter(token, user, component, authority)

    async def ask(self, token: str, user: User, component: JausID, authority: int, reason: str) -> str:
        """Ask the client in control, and take what it hands over; returns why not, or an empty string."""
        if problem := self._refusal(token, user, component, authority):
            return problem
        self._on_event(
            sentence(
                "{user} asks for control of {component}: {reason}",
                user=user.name,
                component=component,
                reason=printable(reason),
            )
        )
        try:
            await self._ocu.request_handoff(component, reason, authority=authority)
        except JausError as error:
            return str(error)
        return await self._enter(token, user, component, authority)

    def answer(self, token: str, component: JausID, id: int, *, grant: bool) -> None:
        """Decide on a request; without effect for other pages."""
        if not self.may_answer(token, component) or (entry := self._shown.pop((component, id), None)) is None:
            return
        self._ocu.answer_handoff(component, id, Decision.GRANTED if grant else Decision.DENIED)
        values = {"component": component, "client": entry[0].client}
        if grant:
            self._on_event(sentence("{component} is handed over to {client}", **values))
        else:
            self._on_event(sentence("{component} is not handed over to {client}", **values))

    async def release(self, token: str, component: JausID) -> None:
        """Release a component; without effect for other pages."""
        if (held := self._held.get(component)) is not None and held.token == token:
            del self._held[component]
            await held.control.__aexit__(None, None, None)
            self._on_event(sentence("{component} was released by {user}", component=component, user=held.user.name))

    async def forget(self, token: str) -> None:
        """Release what a page holds that has ended."""
        for component in [component for component, held in self._held.items() if held.token == token]:
            await self.release(token, component)

    async def close(self) -> None:
        """Release all."""
        for component, held in list(self._held.items()):
            await self.release(held.token, component)

    def _refusal(self, token: str, user: User, component: JausID, authority: int) -> str:
        if not user.may_operate:
            return sentence("{user} may only observe ({role})", user=user.name, role=user.role)
        if authority > user.authority:
            return sentence(
                "{user} has an authority of at most {authority} ({role})",
                user=user.name,
                authority=user.authority,
                role=user.role,
            )
        held = self.held(component)
        if held is not None and held.token != token:
            return sentence(
                "{user} holds {component} in another browser of this console", user=held.user.name, component=component
            )
        return ""

    async def _enter(self, token: str, user: User, component: JausID, authority: int) -> str:
        if problem := self._refusal(token, user, component, authority):
            return problem
        if (before := self._held.pop(component, None)) is not None:
            await before.control.__aexit__(None, None, None)
        try:
            robot = self._robots()[component.subsystem]
            control = robot.component(component).service(SERVICE).control(authority=authority)
            await control.__aenter__()
        except KeyError:
            return sentence("robot {subsystem} has gone", subsystem=component.subsystem)
        except JausError as error:
            return str(error)
        self._held[component] = Held(token, user, control)
        self._on_event(
            sentence(
                "{user} holds {component} with authority {authority}",
                user=user.name,
                component=component,
                authority=authority,
            )
        )
        return ""

    def _on_request(self, component: JausID, request: HandoffRequest) -> Decision | None:
        """Show a request, and leave it open until a page answers."""
        if (component, request.id) not in self._shown:
            self._on_event(
                sentence(
                    "{client} asks for control of {component}: {explanation}",
                    client=request.client,
                    component=component,
                    explanation=printable(request.explanation),
                )
            )
        self._shown[component, request.id] = (request, asyncio.get_running_loop().time())
        while len(self._shown) > MAX_SHOWN:
            del self._shown[next(iter(self._shown))]
        return None
