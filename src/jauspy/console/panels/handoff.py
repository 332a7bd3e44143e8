"""The card Handoff: components whose control other clients ask for, and hand over (EnhancedAccessControl)."""

from __future__ import annotations

from typing import Final

from nicegui import background_tasks, ui

from jauspy.console.console import Console
from jauspy.console.fleet import NOTHING
from jauspy.console.handoffs import SERVICE
from jauspy.console.languages import sentence
from jauspy.console.markup import attributes
from jauspy.console.page_language import _, translated
from jauspy.console.users import User
from jauspy.ids import JausID
from jauspy.ocu.control import DEFAULT_AUTHORITY
from jauspy.ocu.robot import Robot
from jauspy.printable import printable

UPDATE_INTERVAL: Final = 0.4
MAX_REASON: Final = 120
"""Characters."""


class HandoffCard:
    """Ask, take, release, hand over and refuse, for one page; hidden for robots without such components."""

    def __init__(self, console: Console, token: str, user: User) -> None:
        self._console, self._token, self._user = console, token, user
        self._robot: Robot | None = None
        self._rows: dict[JausID, _Row] = {}
        self.problem = ""
        with ui.element("section").classes("card") as self._card:
            attributes(self._card, aria_label=_("Handoff"))
            with ui.element("div").classes("row"):
                ui.label(_("Handoff")).classes("heading")
                self._state = ui.label("").classes("state grow").props('role="status"')
            ui.label(_("asks another client for control, and answers those who ask")).classes("hint")
            with ui.element("div").classes("row start"):
                self.reason = ui.input(_("why, for the one in control")).props("dense outlined").classes("wide")
                self.reason.props("maxlength=120")
            self._list = ui.element("div").classes("components")
            self._problem = ui.label("").classes("problem").props('role="alert"')
        self._card.set_visibility(False)
        ui.timer(UPDATE_INTERVAL, self._update)

    def show(self, robot: Robot | None) -> None:
        """Offer it for this robot."""
        self._robot, self.problem, self._rows = robot, "", {}
        self._list.clear()
        components = [] if robot is None else [part.id for part in robot.info.offering(SERVICE)]
        self._card.set_visibility(bool(components))
        with self._list:
            for id in components:
                self._rows[id] = _Row(self, id)

    def close(self) -> None:
        """Handle the end of the page."""
        self._robot = None

    def _update(self) -> None:
        if self._robot is None or not self._card.visible:
            return
        waiting = sum(row.update(self._console, self._token, self._user) for row in self._rows.values())
        self._state.set_text(_("{waiting} asked", waiting=waiting) if waiting else "")
        self._problem.set_text(translated(self.problem))

    async def take(self, id: JausID) -> None:
        """Take control of a component."""
        self.problem = await self._console.handoffs.take(self._token, self._user, id, self._authority)

    def ask(self, id: JausID) -> None:
        """Ask for control of a component, which takes as long as the other client thinks."""
        self.problem = sentence("asked for {id}; waits for the answer", id=id)
        background_tasks.create(self._ask(id), name=f"console: handoff of {id}")

    async def _ask(self, id: JausID) -> None:
        reason = str(self.reason.value or "")[:MAX_REASON]
        self.problem = await self._console.handoffs.ask(self._token, self._user, id, self._authority, reason)

    async def release(self, id: JausID) -> None:
        """Release a component."""
        await self._console.handoffs.release(self._token, id)

    def answer(self, id: JausID, request: int, *, grant: bool) -> None:
        """Decide on a request."""
        self._console.handoffs.answer(self._token, id, request, grant=grant)

    @property
    def _authority(self) -> int:
        return min(DEFAULT_AUTHORITY, self._user.authority)


class _Row:
    """One component: who has control, what can be done, and who asks."""

    def __init__(self, card: HandoffCard, id: JausID) -> None:
        self._card, self._id = card, id
        self._shown: list[int] = []
        with ui.element("div").classes("row"):
            with ui.element("div").classes("grow"):
                ui.label(str(id)).classes("name")
                self._holder = ui.label("").classes("hint")
            self._take = self._button(_("take"), lambda: card.take(id), is_main=True)
            self._ask = self._button(_("ask"), lambda: card.ask(id), is_main=True)
            self._release = self._button(_("release"), lambda: card.release(id), is_main=False)
        self._requests = ui.element("div")

    def _button(self, text: str, on_click: object, *, is_main: bool) -> ui.button:
        button = ui.button(text, on_click=on_click)  # type: ignore[arg-type]
        button.props("unelevated no-caps dense" if is_main else "outline no-caps dense")
        return attributes(button, aria_label=f"{text} {self._id}")

    def update(self, console: Console, token: str, user: User) -> int:
        """Show the present state; returns how many clients ask."""
        id, held = self._id, console.handoffs.held(self._id)
        mine = held is not None and held.token == token
        controller = console.fleet.states.get(id, NOTHING).controller
        self._holder.set_text(
            _("you have control")
            if mine
            else _("{user} has control, in another browser", user=held.user.name)
            if held is not None
            else _("{controller} has control", controller=controller)
            if controller
            else _("nobody has control")
        )
        self._take.set_visibility(held is None and not controller)
        self._ask.set_visibility(held is None and bool(controller))
        self._release.set_visibility(mine)
        for button in (self._take, self._ask):
            button.set_enabled(user.may_operate)
        requests = console.handoffs.requests(id) if console.handoffs.may_answer(token, id) else []
        if [request.id for request in requests] != self._shown:
            self._shown = [request.id for request in requests]
            self._requests.clear()
            with self._requests:
                for request in requests:
                    with ui.element("div").classes("asked").props('role="alert"'):
                        why = printable(request.explanation) or _("it gives no reason")
                        ui.label(
                            _(
                                "{client} asks, with authority {authority}: {why}",
                                client=request.client,
                                authority=request.authority,
                                why=why,
                            )
                        )
                        with ui.element("div").classes("row"):
                            self._answer(_("hand over"), request.id, grant=True)
                            self._answer(_("refuse"), request.id, grant=False)
        return len(requests)

    def _answer(self, text: str, request: int, *, grant: bool) -> None:
        button = ui.button(text, on_click=lambda: self._card.answer(self._id, request, grant=grant))
        button.props("unelevated no-caps dense" if grant else "outline no-caps dense")
