"""The panel Control: who operates the robot; taking control, asking for it, handing it over, releasing it."""

from __future__ import annotations

from typing import Final

from nicegui import ui

from jauspy.console.console import Console
from jauspy.console.markup import attributes, call
from jauspy.console.operation import Operation
from jauspy.console.page_language import _, translated
from jauspy.console.users import LOCAL, User
from jauspy.ocu.control import DEFAULT_AUTHORITY
from jauspy.ocu.robot import Robot

UPDATE_INTERVAL: Final = 0.4


class ControlPanel:
    """Control of the chosen robot, for one page, which `token` names."""

    def __init__(self, console: Console, token: str, user: User) -> None:
        self._console = console
        self._token = token
        self._user = user
        self._robot: Robot | None = None
        self._shown = ""
        """The problem that this page was told last."""
        self._operates = False
        """What the browser was told: a gamepad moves something only while its page operates the robot."""
        with ui.element("section").classes("panel control") as self._panel:
            attributes(self._panel, aria_label=_("Control"))
            with ui.element("div").classes("row"):
                ui.label(_("Control")).classes("heading")
                self._state = ui.label("").classes("state grow").props('role="status"')
                self._release = ui.button(_("release"), on_click=self._release_control).props("outline no-caps dense")
            with ui.element("div").classes("asked").props('role="alert"') as self._asked:
                self._question = ui.label("")
                with ui.element("div").classes("row"):
                    ui.button(_("hand over"), on_click=self._grant).props("unelevated no-caps")
                    ui.button(_("refuse"), on_click=self._refuse).props("outline no-caps")
            with ui.element("div").classes("row start") as self._start:
                highest = user.authority
                self._authority = ui.number(
                    _("authority"), value=min(DEFAULT_AUTHORITY, highest), min=0, max=highest, precision=0
                ).props("dense outlined")
                self._take = ui.button(_("take"), on_click=self._take_control).props("unelevated no-caps")
                self._ask = ui.button(_("ask"), on_click=self._ask_for_control).props("unelevated no-caps")
            self._problem = ui.label("").classes("problem").props('role="alert"')
        self._update()
        ui.timer(UPDATE_INTERVAL, self._update)

    def show(self, robot: Robot | None) -> None:
        """Show control of this robot."""
        self._robot = robot
        self._shown = ""
        self._problem.set_text("")
        self._update()

    def close(self) -> None:
        """Handle the end of the page."""
        self._robot = None

    @property
    def _operation(self) -> Operation | None:
        return self._console.operation(self._robot.id) if self._robot is not None else None

    def _update(self) -> None:
        operation = self._operation
        held = operation is not None and operation.is_controlled
        mine = held and operation is not None and operation.operator == self._token
        others = held and not mine
        if mine != self._operates:
            self._tell_browser(operates=mine)
        self._take.set_text(_("take over") if others else _("take"))
        self._take.set_visibility(not mine)
        self._ask.set_visibility(others)
        self._release.set_visibility(mine)
        self._start.set_visibility(not mine)
        request = operation.request if operation is not None else None
        self._asked.set_visibility(mine and request is not None)
        if operation is None:
            self._state.set_text("")
            for button in (self._take, self._ask):
                button.set_enabled(False)
            return
        if mine and request is not None:
            self._question.set_text(
                _(
                    "{user} asks for control, with authority {authority}.",
                    user=_name(request.user),
                    authority=request.authority,
                )
            )
        may = self._user.may_operate
        self._take.set_enabled(may and operation.may_take_over(self._user, self._wanted))
        self._ask.set_enabled(may and (request is None or request.token != self._token))
        self._state.set_text(
            _("you operate this robot")
            if mine
            else _("{user} operates it", user=_name(operation.user))
            if held
            else _("observing")
            if may
            else _("observing ({role})", role=self._user.role)
        )
        if (problem := operation.problem_for(self._token)) != self._shown:  # also when it is over
            self._shown = problem
            self._problem.set_text(translated(problem))

    def _tell_browser(self, *, operates: bool) -> None:
        self._operates = operates
        call("jauspy.operate", operates)

    @property
    def _wanted(self) -> int:
        return int(self._authority.value or 0)

    async def _take_control(self) -> None:
        if (operation := self._operation) is not None:
            self._tell_browser(operates=False)  # it may have lost control a moment ago
            problem = await operation.take(self._token, self._wanted, self._user)
            self._update()
            self._problem.set_text(translated(problem))

    async def _release_control(self) -> None:
        operation = self._operation
        if operation is not None and operation.operator == self._token:
            await operation.release(self._token)
            self._update()

    def _ask_for_control(self) -> None:
        if (operation := self._operation) is not None:
            operation.ask(self._token, self._wanted, self._user)
            self._problem.set_text(_("asked; {user} has not answered yet", user=_name(operation.user)))
            self._update()

    async def _grant(self) -> None:
        if (operation := self._operation) is not None:
            problem = await operation.answer(self._token, grant=True)
            self._update()
            self._problem.set_text(translated(problem))

    async def _refuse(self) -> None:
        if (operation := self._operation) is not None:
            await operation.answer(self._token, grant=False)
            self._update()


def _name(user: User) -> str:
    return _("another browser") if user == LOCAL else user.name
