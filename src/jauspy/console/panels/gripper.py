"""The panel Gripper: fingers with force and opening, or a vacuum connector; part of the panel Arm."""

from __future__ import annotations

import math
from collections.abc import Awaitable, Callable
from typing import Final

from nicegui import ui

from jauspy.console.console import Console
from jauspy.console.languages import sentence
from jauspy.console.manipulators import CONNECTOR, operated
from jauspy.console.markup import attributes
from jauspy.console.motion import Motion
from jauspy.console.page_language import _, translated
from jauspy.errors import ConfigError, JausError
from jauspy.messages.cell import QueryConnectorState, ReportConnectorState, SetConnector
from jauspy.ocu.gripper import DRIVER, Gripper
from jauspy.ocu.robot import FORCE_TORQUE, Robot
from jauspy.ocu.service import ServiceClient
from jauspy.printable import printable

UPDATE_INTERVAL: Final = 0.4
"""Seconds between two queries of the fingers."""
DEFAULT_SHARE: Final = 0.5
"""The initial force, as a share of the greatest one."""
ALL_FIELDS: Final = 0xFFFF_FFFF
NO_FORCE: Final = 0.5
"""Newtons of a finger below which it counts as free: friction and noise."""


class GripperPanel:
    """The gripper of the chosen robot, for one page."""

    def __init__(self, console: Console, token: str) -> None:
        self._motion = Motion(console, token)
        self._robot: Robot | None = None
        self._gripper: Gripper | None = None
        self._connector: ServiceClient | None = None
        self._max_force: float | None = None
        self._is_known = False
        self._has_width = False
        with ui.element("section").classes("panel gripper") as self._panel:
            with ui.element("div").classes("row"):
                ui.label(_("Gripper")).classes("heading grow")
                self._open = ui.button(_("open"), on_click=lambda: self._grip(close=False)).props(
                    "outline no-caps dense"
                )
                self._open.classes("grip-open")
                self._close = ui.button(_("close"), on_click=lambda: self._grip(close=True)).props(
                    "outline no-caps dense"
                )
                self._close.classes("grip-close")
            self._state = ui.label("").classes("hint")
            with ui.element("div").classes("row"):
                with ui.element("div").classes("setting") as self._force_part:
                    self._force_text = ui.label("").classes("hint")
                    self._force = ui.slider(min=1, max=100, step=1, value=50, on_change=self._show_force)
                    attributes(self._force, aria_label=_("force"))
                with ui.element("div").classes("setting") as self._opening_part:
                    self._opening_text = ui.label("").classes("hint")
                    self._opening = ui.slider(min=0.0, max=1.0, step=0.001, value=0.0, on_change=self._show_opening)
                    attributes(self._opening, aria_label=_("width"))
                self._set = ui.button(_("set"), on_click=self._open_to).props("outline no-caps dense")
            self._problem = ui.label("").classes("problem").props('role="status"')
        self._panel.set_visibility(False)
        ui.timer(UPDATE_INTERVAL, self._update)

    def show(self, robot: Robot | None) -> None:
        """Show the gripper of this robot; nothing if it has none, or several."""
        self._motion.stop()
        self._robot, self._gripper, self._connector, self._is_known = robot, None, None, False
        if robot is not None and len(list(robot.info.offering(DRIVER))) == 1:
            self._gripper = robot.gripper
        elif robot is not None:
            ids = set(operated(robot))
            found = [
                component for component in robot.components if component.find(CONNECTOR) and str(component.id) in ids
            ]
            if len(found) == 1:
                self._connector = robot.component(str(found[0].id)).service(CONNECTOR)
        self._panel.set_visibility(self._gripper is not None or self._connector is not None)
        self._force_part.set_visibility(self._gripper is not None)
        self._opening_part.set_visibility(False)
        self._set.set_visibility(False)
        self._open.set_text(_("open") if self._connector is None else _("release"))
        self._close.set_text(_("close") if self._connector is None else _("attach"))

    def close(self) -> None:
        """Handle the end of the page."""
        self._motion.stop()
        self._robot = None

    async def _update(self) -> None:
        if self._robot is None or (self._gripper is None and self._connector is None):
            return
        may = not self._motion.refusal(self._robot.id) and not self._motion.is_running
        for button in (self._open, self._close, self._set):
            button.set_enabled(may)
        self._problem.set_text(printable(translated(self._motion.problem)))
        try:
            if self._connector is not None:
                self._state.set_text(await connector_state(self._connector))
            elif self._gripper is not None:
                await self._show_fingers(self._gripper)
        except JausError as error:
            self._state.set_text(_("does not answer"))
            self._problem.set_text(printable(translated(str(error))))

    async def _show_fingers(self, gripper: Gripper) -> None:
        if not self._is_known:
            self._max_force, self._has_width = await gripper.max_force(), await gripper.has_width()
            if self._max_force:
                attributes(self._force, max=self._max_force)
                self._force.set_value(round(DEFAULT_SHARE * self._max_force))
            if self._has_width:
                low, high = await gripper.width_limits()
                attributes(self._opening, min=low, max=high)
                self._opening.set_value(await gripper.width())
            self._opening_part.set_visibility(self._has_width)
            self._set.set_visibility(self._has_width)
            self._is_known = True
            self._show_force()
            self._show_opening()
        if self._has_width:
            parts = [_("fingers open {width:.0f} mm", width=1000.0 * await gripper.width())]
            if (force := await gripper.force()) is not None:
                parts.append(pressing_text(force))
            if (weight := await self._wrist()) is not None:
                parts.append(_("wrist {force:.1f} N", force=weight))
            self._state.set_text(", ".join(parts))
            return
        fingers = ", ".join(f"{value:.3f}" for value in (await gripper.joints()).positions.values())
        self._state.set_text(
            _("fingers at {positions}", positions=fingers) if fingers else _("does not report its fingers")
        )

    async def _wrist(self) -> float | None:
        """Newtons that the wrist measures, such as the weight of what is held; None for a robot without sensor."""
        robot = self._robot
        if robot is None or not any(robot.info.offering(FORCE_TORQUE)):
            return None
        return math.hypot(*(await robot.force_torque()).force)

    def _show_force(self) -> None:
        unit = "N" if self._max_force else "%"
        self._force_text.set_text(_("force {force:g} {unit}", force=self._force.value, unit=unit))

    def _show_opening(self) -> None:
        self._opening_text.set_text(_("width {width:.0f} mm", width=1000.0 * self._opening.value))

    def _grip(self, *, close: bool) -> None:
        value = float(self._force.value)
        force, effort = (value, None) if self._max_force else (None, value)
        gripper, connector = self._gripper, self._connector
        what = sentence("closing the gripper") if close else sentence("opening the gripper")
        if connector is not None:
            self._begin(lambda: switch(connector, on=close), what)
        elif gripper is not None:
            self._begin(lambda: gripper.close(force=force, effort=effort) if close else gripper.open(), what)

    def _open_to(self) -> None:
        if (gripper := self._gripper) is not None:
            self._begin(lambda: gripper.open_to(float(self._opening.value)), sentence("setting the width"))

    def _begin(self, act: Callable[[], Awaitable[object]], what: str) -> None:
        async def run() -> None:
            await act()

        if self._robot is not None:
            self._motion.begin(self._robot.id, run(), what)


def pressing_text(force: float) -> str:
    """The measured force of each finger as text; inwards is positive."""
    if abs(force) < NO_FORCE:
        return _("without force")
    if force > 0.0:
        return _("press {force:.0f} N", force=force)
    return _("push outwards {force:.0f} N", force=-force)


async def switch(connector: ServiceClient, *, on: bool) -> None:
    """Switch a vacuum connector on (pump) or off (vent)."""
    await connector.send(SetConnector(1, SetConnector.Enabled(on)), ack=True)


async def connector_state(connector: ServiceClient) -> str:
    """A text with the state of a vacuum connector and its load."""
    report = await connector.query(QueryConnectorState(ALL_FIELDS, 1))
    if not isinstance(report, ReportConnectorState):
        raise ConfigError(sentence("{connector} does not report its state", connector=connector.id))
    if report.attached_to:
        return printable(_("holds {part}", part=report.attached_to))
    return printable(_("on, holds nothing: {problem}", problem=report.error_text) if report.enabled else _("off"))
