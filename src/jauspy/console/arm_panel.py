"""The panel Arm: a slider for each joint, and the gripper."""

from __future__ import annotations

import math
from typing import Final

from nicegui import ui

from jauspy.console.server import Console
from jauspy.errors import JausError
from jauspy.ocu.arm import POSITION_DRIVER
from jauspy.ocu.robot import Robot
from jauspy.printable import printable

UPDATE_INTERVAL: Final = 0.4
"""Seconds between two looks at who operates the robot."""


class ArmPanel:
    """The joints and the gripper of the chosen robot, for one page, which `token` names."""

    def __init__(self, console: Console, token: str) -> None:
        self._console = console
        self._token = token
        self._robot: Robot | None = None
        self._sliders: dict[str, ui.slider] = {}
        self._is_busy = False
        with ui.element("section").classes("panel") as self._panel:
            with ui.element("div").classes("row"):
                ui.label("Arm").classes("heading")
                self._open = ui.button("open", on_click=lambda: self._grip(close=False)).props("flat no-caps")
                self._close = ui.button("close", on_click=lambda: self._grip(close=True)).props("flat no-caps")
            self._joints = ui.element("div").classes("joints")
            self._move = ui.button("move", on_click=self._move_arm).props("unelevated no-caps")
        self._panel.set_visibility(False)
        ui.timer(UPDATE_INTERVAL, self._update)

    def show(self, robot: Robot | None) -> None:
        """Show the arm of this robot; nothing if it has none."""
        self._robot = robot
        has_arm = robot is not None and any(each.find(POSITION_DRIVER) for each in robot.components)
        self._panel.set_visibility(has_arm)
        if has_arm:
            with self._panel:
                ui.timer(0.1, self._show_arm, once=True)

    def close(self) -> None:
        """The page has gone."""
        self._robot = None

    async def _show_arm(self) -> None:
        robot = self._robot
        if robot is None:
            return
        try:
            limits, joints = await robot.arm.limits(), await robot.arm.joints()
        except JausError as error:
            self._joints.clear()
            with self._joints:
                ui.label(str(error)).classes("hint")
            return
        self._sliders = {}
        self._joints.clear()
        with self._joints:
            for name, limit in limits.items():
                low, high = (round(max(-math.pi, min(math.pi, value)), 3) for value in limit)
                ui.label(printable(name)).classes("joint").tooltip(printable(name))
                value = ui.label("").classes("joint-value")
                slider = ui.slider(min=low, max=high, step=0.01, value=round(joints[name], 2))
                self._sliders[name] = slider.props("label snap")
                value.bind_text_from(slider, "value", lambda angle: f"{round(angle, 2) + 0.0:.2f} rad")

    def _update(self) -> None:
        operation = self._console.operation(self._robot.id) if self._robot is not None else None
        mine = operation is not None and operation.operator == self._token and operation.is_controlled
        self._move.set_enabled(mine and not self._is_busy)
        self._open.set_enabled(mine)
        self._close.set_enabled(mine)

    async def _move_arm(self) -> None:
        if self._robot is None or self._is_busy:
            return
        self._is_busy = True
        wanted = {name: float(slider.value) for name, slider in self._sliders.items()}
        try:
            await self._robot.arm.move(wanted)
        except JausError as error:
            self._console.note(f"the arm did not move as wanted: {error}")
        finally:
            self._is_busy = False

    async def _grip(self, *, close: bool) -> None:
        if self._robot is None:
            return
        try:
            await (self._robot.gripper.close() if close else self._robot.gripper.open())
        except JausError as error:
            self._console.note(f"the gripper did not {'close' if close else 'open'}: {error}")
