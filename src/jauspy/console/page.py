"""The console's page: fleet, video, driving, arm and log on one calm screen (NiceGUI)."""

from __future__ import annotations

import math
from contextlib import suppress
from typing import Any, Final

from fastapi import FastAPI
from nicegui import ui

from jauspy.console.arm_panel import ArmPanel
from jauspy.console.drive_modes import DriveModes
from jauspy.console.fleet import NOTHING
from jauspy.console.log_panel import LogPanel
from jauspy.console.plots_panel import PlotsPanel
from jauspy.console.server import Console
from jauspy.console.users import User
from jauspy.console.video_panel import VideoPanel
from jauspy.console.world_panel import WorldPanel
from jauspy.errors import JausError
from jauspy.ocu.control import DEFAULT_AUTHORITY
from jauspy.ocu.robot import Robot
from jauspy.ocu.state import RobotPose
from jauspy.printable import printable

REFRESH_INTERVAL: Final = 0.4
"""Seconds between two looks at the fleet."""
POSE_INTERVAL: Final = 0.2
TABS: Final = ("Video", "World", "Plots", "Log")
SCRIPTS: Final = ("console", "video", "plots", "world", "map")
STYLES: Final = ("console", "video", "world")
STATUS_COLOURS: Final = {
    "READY": "ready",
    "STANDBY": "standby",
    "EMERGENCY": "emergency",
    "FAILURE": "failure",
}
"""Classes of console.css; each state has a sign beside its colour, too."""
SIGNS: Final = {"READY": "\u25b6", "STANDBY": "\u2016", "EMERGENCY": "\u26a0", "FAILURE": "\u2716"}


def add_page(app: FastAPI, console: Console) -> None:
    """Add the page at `/`."""

    @ui.page("/", title="jauspy console", favicon="\U0001f6f0", dark=None)
    def index() -> None:
        browser = console.new_browser()
        if browser is None:
            ui.label("too many pages of this console are open; close one, then load this page again")
            return
        token, user = browser
        page = _Page(console, token, user)
        page.build()

        def leave() -> None:
            page.arm.close()
            page.plots.close()
            page.world.close()
            page.videos.close()
            console.forget(token)

        ui.context.client.on_delete(leave)

    ui.run_with(app, storage_secret=None, show_welcome_message=False, reconnect_timeout=3.0, tailwind=False)


class _Page:
    """One browser's page."""

    def __init__(self, console: Console, token: str, user: User) -> None:
        self.console = console
        self.token = token
        self.user = user
        self.robot: Robot | None = None
        self._shown: tuple[Any, ...] = ()
        self._logged = 0

    # --- building -------------------------------------------------------------------------------------------------

    def build(self) -> None:
        ui.colors(primary="#1f6feb")
        ui.add_head_html("".join(f'<link rel="stylesheet" href="/static/{name}.css">' for name in STYLES))
        scripts = "".join(f'<script src="/static/{name}.js"></script>' for name in SCRIPTS)
        ui.add_body_html(f'{scripts}<script>jauspy.start("{self.token}")</script>')
        with ui.element("header").classes("bar"):
            ui.label("jauspy").classes("brand")
            self.title = ui.label("looking for robots \u2026").classes("title")
            ui.element("div").classes("space")
            ui.html('<span id="stop-answer" role="status"></span>', sanitize=False)
            ui.html(
                '<button id="stop" onclick="jauspy.stop(\'all\')" title="Escape">STOP ALL <kbd>Esc</kbd></button>',
                sanitize=False,
            )
            ui.html('<button class="quiet" onclick="jauspy.clear(\'all\')">release</button>', sanitize=False)
        with ui.element("main").classes("grid"):
            with ui.element("section").classes("panel fleet"):
                ui.label("Fleet").classes("heading")
                self.fleet = ui.element("div").classes("list")
            self._build_centre()
            with ui.element("aside").classes("side"):
                self._build_control()
                self._build_drive()
                self.arm = ArmPanel(self.console, self.token)
        ui.timer(REFRESH_INTERVAL, self._refresh)
        ui.timer(POSE_INTERVAL, self._refresh_pose)

    def _build_centre(self) -> None:
        with ui.element("section").classes("centre"):
            with ui.element("nav").classes("tabs").props('role="tablist"'):
                self._tabs = {name: self._tab(name) for name in TABS}
            with ui.element("div").classes("panel plots") as world:
                self.world = WorldPanel(self.console, self.token)
            with ui.element("div").classes("videos") as videos:
                self.videos = VideoPanel(self.console)
            with ui.element("div").classes("panel plots") as plots:
                self.plots = PlotsPanel(self.console.ocu)
            with ui.element("div").classes("panel messages") as messages:
                self.messages = LogPanel(self.console.traffic)
            with ui.element("div").classes("panel log") as events:
                ui.label("Events").classes("heading")
                self.log = ui.log(max_lines=200).classes("lines")
        self._parts = {
            "Video": (videos, events), "World": (world,), "Plots": (plots, events), "Log": (messages,)
        }  # fmt: skip
        self._show_tab(TABS[0])

    def _tab(self, name: str) -> ui.button:
        return ui.button(name, on_click=lambda: self._show_tab(name), color=None).props('flat no-caps dense role="tab"')

    def _show_tab(self, name: str) -> None:
        for part in {part for parts in self._parts.values() for part in parts}:
            part.set_visibility(part in self._parts[name])
        for each, button in self._tabs.items():
            button.classes(add="chosen" if each == name else "", remove="" if each == name else "chosen")
        self.messages.visible = name == "Log"
        self.world.visible = name == "World"

    def _build_control(self) -> None:
        with ui.element("section").classes("panel"):
            with ui.element("div").classes("row"):
                ui.label("Control").classes("heading")
                self.state = ui.label("").classes("state")
            with ui.element("div").classes("row"):
                self.authority = ui.number("authority", value=DEFAULT_AUTHORITY, min=0, max=255, precision=0)
                self.take = ui.button("take", on_click=self._take).props("unelevated no-caps")
                self.release = ui.button("release", on_click=self._release).props("outline no-caps")
            self.problem = ui.label("").classes("problem")

    def _build_drive(self) -> None:
        with ui.element("section").classes("panel") as self.drive_panel:
            with ui.element("div").classes("row"):
                ui.label("Drive").classes("heading")
                ui.label("W A S D, arrows, stick, gamepad").classes("hint")
            self.modes = DriveModes(self.console, self.token, lambda: self._show_tab("World"), self._show_limit)
            with ui.element("div").classes("row"):
                ui.html(
                    '<div id="stick" aria-label="drive"><div id="stick-knob"></div></div>',
                    sanitize=False,
                )
                with ui.element("div").classes("facts"):
                    self.pose = ui.html("", sanitize=False)
                    self.limit = ui.slider(min=0.1, max=1.5, step=0.1, value=0.5, on_change=self._limit).props("label")
                    self.limit_text = ui.label("limit 0.5 m/s").classes("hint")
            ui.html('<span id="drive-answer" class="problem" role="status"></span>', sanitize=False)

    # --- refreshing -----------------------------------------------------------------------------------------------

    def _refresh(self) -> None:
        fleet = self.console.fleet
        if self.robot is not None and self.robot.id not in fleet.robots:
            self.robot = None
        if self.robot is None and fleet.robots:
            self._select(next(iter(fleet.robots)))
        if not fleet.robots:
            self.title.set_text("looking for robots \u2026")
        shown = tuple(
            (robot.id, robot.name, component.id, component.name, fleet.states.get(component.id, NOTHING).status,
             fleet.states.get(component.id, NOTHING).controller, fleet.is_silent(component.id))
            for robot in fleet.robots.values()
            for component in robot.components
        )  # fmt: skip
        if shown != self._shown:
            self._shown = shown
            self._show_fleet()
        self._show_control()
        new = self.console.total_events - self._logged
        self._logged = self.console.total_events
        for event in list(self.console.events)[-new:] if new else ():
            self.log.push(f"{event.time:%H:%M:%S}  {event.text}")

    def _show_fleet(self) -> None:
        fleet = self.console.fleet
        self.fleet.clear()
        with self.fleet:
            for robot in fleet.robots.values():
                chosen = " chosen" if self.robot is not None and self.robot.id == robot.id else ""
                with (
                    ui.element("div")
                    .classes(f"robot{chosen}")
                    .on("click", lambda subsystem=robot.id: self._select(subsystem))
                ):
                    ui.label(f"{robot.id}  {printable(robot.name)}").classes("name")
                    for component in robot.components:
                        state = fleet.states.get(component.id, NOTHING)
                        silent = fleet.is_silent(component.id)
                        status = "silent" if silent else state.status
                        who = state.controller if not silent else ""
                        with ui.element("div").classes("component"):
                            ui.label(f"{component.id.node}.{component.id.component}").classes("id")
                            ui.label(printable(component.name) or "component").classes("grow")
                            ui.label(f"{SIGNS.get(status, '')} {status.lower()}").classes(
                                f"chip {STATUS_COLOURS.get(status, 'other')}"
                            )
                            if who:
                                ui.label(f"controlled by {self._who(who)}").classes("controller")

    def _who(self, controller: str) -> str:
        return "this console" if controller == str(self.console.ocu.id) else controller

    def _select(self, id: int) -> None:
        robot = self.console.fleet.robots.get(id)
        if robot is None or (self.robot is not None and self.robot.id == id):
            return
        self.robot = robot
        self._shown = ()
        self.plots.show(robot)
        self.world.show(robot)
        self.modes.show(robot)
        self.title.set_text(f"{robot.id}  {printable(robot.name)}")
        ui.run_javascript(f"jauspy.selectRobot({robot.id})")
        self.videos.show(robot)
        drives = any(each.find("PrimitiveDriver") or each.find("VelocityStateDriver") for each in robot.components)
        self.drive_panel.set_visibility(drives)
        self.arm.show(robot)

    def _show_control(self) -> None:
        operation = self.console.operation(self.robot.id) if self.robot is not None else None
        if operation is None:
            self.state.set_text("")
            return
        mine = operation.operator == self.token and operation.is_controlled
        others = "another browser operates it" if operation.is_controlled else "observing"
        self.state.set_text("you operate this robot" if mine else others)
        self.take.set_text("take over" if operation.is_controlled and not mine else "take")
        self.take.set_enabled(not mine)
        self.release.set_enabled(mine)
        self.problem.set_text(operation.problem)

    async def _refresh_pose(self) -> None:
        if self.robot is None:
            return
        pose: RobotPose | None = None
        with suppress(JausError):
            pose = await self.robot.pose()
        if pose is None:
            self.pose.set_content("")
            return
        heading = round(math.degrees(-pose.yaw)) % 360
        self.pose.set_content(
            f"<b>x {round(pose.x, 2) + 0.0:.2f} m, y {round(pose.y, 2) + 0.0:.2f} m</b><br>heading {heading}\u00b0<br>"
            f"pitch {round(math.degrees(pose.pitch))}\u00b0, roll {round(math.degrees(pose.roll))}\u00b0"
        )

    # --- commands -------------------------------------------------------------------------------------------------

    async def _take(self) -> None:
        if self.robot is None or (operation := self.console.operation(self.robot.id)) is None:
            return
        problem = await operation.take(self.token, int(self.authority.value or 0), self.user)
        if problem:
            self.problem.set_text(problem)

    async def _release(self) -> None:
        if self.robot is not None and (operation := self.console.operation(self.robot.id)) is not None:
            await operation.release()

    def _show_limit(self) -> None:
        self.limit_text.set_text(self.modes.limit_text(self.limit.value))

    def _limit(self) -> None:
        self._show_limit()
        if self.robot is not None and (operation := self.console.operation(self.robot.id)) is not None:
            operation.speed_limit = float(self.limit.value)
