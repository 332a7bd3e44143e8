"""The console's page: puts the panels together on one screen (NiceGUI)."""

from __future__ import annotations

import time
from typing import Final

from fastapi import FastAPI, Request
from nicegui import core, ui

from jauspy.console.camera_settings import VIDEO
from jauspy.console.choice import Choice
from jauspy.console.console import Console
from jauspy.console.conventions import Conventions
from jauspy.console.languages import COOKIE, browser_texts, language_of, sentence
from jauspy.console.manipulators import MODULAR_ARM
from jauspy.console.markup import attributes, call, page_files, plain_text, with_code
from jauspy.console.page_events import FrameCheck, PageEvents
from jauspy.console.page_language import LocalizedPage, _, page_language, set_language, translated
from jauspy.console.panels.arm import ArmPanel
from jauspy.console.panels.control import ControlPanel
from jauspy.console.panels.conveyor import ConveyorPanel
from jauspy.console.panels.desk import EVENTS, VIEWS, Desk
from jauspy.console.panels.drive import DRIVERS, DrivePanel
from jauspy.console.panels.fleet import FleetPanel
from jauspy.console.panels.guards import GuardsPanel
from jauspy.console.panels.link import LinkPanel
from jauspy.console.panels.log import LogPanel
from jauspy.console.panels.recordings import RecordingsPanel
from jauspy.console.panels.settings import SettingsButton
from jauspy.console.panels.status import StatusBar
from jauspy.console.panels.tasks import OFFERED as TASKS, TasksPanel
from jauspy.console.panels.trajectory import TrajectoryPanel
from jauspy.console.panels.video import VideoPanel
from jauspy.console.panels.world import WorldPanel
from jauspy.console.plots import PlotsPanel
from jauspy.console.users import LOCAL, User
from jauspy.ids import JausID
from jauspy.ocu.arm import POSITION_DRIVER
from jauspy.ocu.joints import PAN_TILT_SENSOR, POSITION_SENSOR
from jauspy.ocu.robot import Robot
from jauspy.printable import printable

REFRESH_INTERVAL: Final = 0.4
"""Seconds between two updates of the page."""
TABS: Final = tuple(name for name in VIEWS if name != EVENTS)
OFFERED: Final = {
    "Video": (VIDEO,),
    "World": ("LocalPoseSensor", "RangeSensor", POSITION_SENSOR, PAN_TILT_SENSOR, MODULAR_ARM),
    "Trajectory": (POSITION_DRIVER, MODULAR_ARM),
    "Tasks": TASKS,
}
"""Views that are useful only for a robot with one of these services."""
ALONE: Final = ("World", "Log", "Recordings")
"""Views below which there is no room for the events."""
WITHOUT_ROBOTS: Final = ("Log", "Recordings", EVENTS)
"""Views that are useful while no robot is shown."""
SCRIPTS: Final = (
    *("console", "desk", "status", "video", "sight", "plots", "world", "map", "way", "mission", "arm", "gamepad"),
    *("recordings", "settings"),
)
STYLES: Final = ("theme", "console", "desk", "video", "world", "arm", "recordings")
SCHEMES: Final = {"system": None, "light": False, "dark": True}
"""Colour schemes, in the order of the switch."""
NO_ROBOTS: Final = (
    sentence("To try it, run a robot on this machine: `jauspy up inc1`"),
    sentence(
        "Robots of the network need a node manager on this machine (`jauspy node-manager`), or "
        "`jauspy console --connect` to another one"
    ),
    sentence("See what answers: `jauspy ls`"),
)
"""What can be done while no robot answers."""


def add_page(app: FastAPI, console: Console) -> None:
    """Add the page at `/`."""
    ui.slider.LOOPBACK = False  # the browser moves a slider itself: fast presses outrun answers of the console
    app.add_middleware(FrameCheck, refused=console.refused)
    events = PageEvents(core.sio, console.refused, time.monotonic)

    @LocalizedPage("/", title="jauspy console", favicon="\U0001f6f0", dark=None)
    def index(request: Request) -> None:
        client = ui.context.client
        language = language_of(request.cookies.get(COOKIE), request.headers.get("accept-language"))
        set_language(client, language)
        browser = console.new_browser(client.delete, language)
        if browser is None:
            ui.label(_("too many pages of this console are open; close one, then load this page again"))
            return
        token, user = browser
        events.add(ui.context.client, user)
        page = _Page(console, token, user)

        def leave() -> None:
            page.close()
            console.forget(token)

        client.on_connect(lambda: console.pages.connected(token))
        client.on_delete(leave)

    ui.run_with(app, storage_secret=None, show_welcome_message=False, reconnect_timeout=8.0, tailwind=False)


class _Page:
    """One browser's page."""

    def __init__(self, console: Console, token: str, user: User) -> None:
        self._console = console
        self._choice = Choice(console.first_robot)
        self._is_own = False
        """True for a choice of the operator, which the browser keeps."""
        self._robot: Robot | None = None
        """The chosen robot while it answers."""
        self._shown_tab = TABS[0]
        self._wanted_tab = ""
        """The tab that was clicked last; until then, the first tab that is useful for the robot is shown."""
        self._logged = 0
        self._conventions = Conventions()
        ui.colors(primary="#1a63d6")
        page_files(STYLES, SCRIPTS, token, browser_texts(page_language()))
        with ui.element("header").classes("bar"):
            self._build_bar(user)
        with ui.element("div").classes("status"):
            self._status = StatusBar(console, token)
        with ui.element("main").classes("grid") as main:
            self._desk = Desk(main, self._show_arranged)
            with ui.element("section").classes("panel fleet") as fleet:
                attributes(fleet, aria_label=_("Fleet"))
                self._fleet = FleetPanel(console, self._select)
            with ui.element("section").classes("centre"):
                self._build_centre(token, user)
            with ui.element("aside").classes("side"):
                self._control = ControlPanel(console, token, user)
                self._link = self._status.link = LinkPanel()
                self._drive = DrivePanel(console, token, lambda: self._want_tab("World"), self._conventions)
                self._guards = GuardsPanel(console, token, self._conventions)
                self._arm = ArmPanel(console, token)
                self._conveyor = ConveyorPanel(console, token)
        self._of_robot = (
            self._fleet,
            self._control,
            self._link,
            self._drive,
            self._guards,
            self._arm,
            self._conveyor,
            self._videos,
            self._world,
            self._trajectory,
            self._tasks,
            self._plots,
            self._status,
        )
        self._show_tab(TABS[0])
        ui.timer(REFRESH_INTERVAL, self._refresh)

    def close(self) -> None:
        """Handle the end of the page."""
        for panel in self._of_robot:
            if not isinstance(panel, FleetPanel):
                panel.close()

    def _build_bar(self, user: User) -> None:
        ui.label("jauspy").classes("brand")
        self._title = ui.label("").classes("title")
        ui.element("div").classes("space")
        ui.html('<span id="stop-answer" role="status"></span>', sanitize=False)
        if user != LOCAL:
            with ui.element("form").props('method="post" action="/logout"').classes("user"):
                plain_text(f"{user.name}, {user.role}")
                plain_text(_("sign out"), tag="button").classes("quiet")
        SettingsButton(self._conventions)
        dark = ui.dark_mode(None)
        ui.on("scheme", lambda event: dark.set_value(SCHEMES.get(str(event.args))))
        ui.on("remembered", lambda event: self._remember(event.args))
        # These buttons need console.js only, so that they work when the rest of the page hangs.
        ui.html('<button id="scheme" class="quiet" data-do="scheme">\u25d0</button>', sanitize=False)
        clear = plain_text(_("clear emergency"), tag="button").classes("quiet")
        attributes(clear, data_do="clear", data_to="all")
        with ui.element("button").props("id=stop") as stop:
            plain_text(_("STOP ALL"))
            for key in ("Esc", "F8"):
                plain_text(" ")
                plain_text(key, tag="kbd")
        attributes(stop, data_do="stop", data_to="all")

    def _build_centre(self, token: str, user: User) -> None:
        with ui.element("nav").classes("tabs").props('role="tablist"') as tabs:
            attributes(tabs, aria_label=_("Views"))
            self._tabs = {name: self._tab(name) for name in TABS}
            self._desk.build_menu(TABS)
        with ui.element("div").classes("panel empty") as self._empty:
            with ui.element("div") as self._looking:
                plain_text(_("Looking for robots \u2026"), tag="h2")
                plain_text(
                    _("No robot has answered yet. The console asks all the time, and shows each one as it appears."),
                    tag="p",
                )
                with ui.element("ul"):
                    for hint in NO_ROBOTS:
                        with ui.element("li"):
                            with_code(translated(hint))
            with ui.element("div") as self._unchosen:
                plain_text(_("Choose a robot"), tag="h2")
                self._hint = ui.label("").classes("choose").props('role="status"')
        with self._desk.frame():
            with self._desk.pane("Video"), ui.element("div").classes("videos"):
                self._videos = VideoPanel(self._console, token, user, self._conventions)
            with self._desk.pane("World"), ui.element("div").classes("panel plots"):
                self._world = WorldPanel(self._console, token, self._conventions)
            with self._desk.pane("Trajectory"), ui.element("div").classes("panel trajectory"):
                self._trajectory = TrajectoryPanel(self._console, token)
            with self._desk.pane("Tasks"), ui.element("div").classes("panel tasks"):
                self._tasks = TasksPanel(self._console, token, user, self._conventions)
            with self._desk.pane("Plots"), ui.element("div").classes("panel plots"):
                self._plots = PlotsPanel(self._console.ocu, self._conventions)
            with self._desk.pane("Log"), ui.element("div").classes("panel messages"):
                self._messages = LogPanel(self._console.traffic)
            with self._desk.pane("Recordings"), ui.element("div").classes("panel messages"):
                RecordingsPanel()
            with self._desk.pane(EVENTS), ui.element("div").classes("panel log"):
                ui.label(_("Events")).classes("heading")
                self._log = ui.log(max_lines=200).classes("lines")

    def _tab(self, name: str) -> ui.button:
        tab = ui.button(translated(VIEWS[name]), on_click=lambda: self._want_tab(name), color=None)
        return tab.props('flat no-caps dense role="tab"')

    def _want_tab(self, name: str) -> None:
        self._wanted_tab = name
        self._desk.show_view(name)
        self._show_tab(name)

    def _show_arranged(self) -> None:
        """Follow a change of the arrangement."""
        self._world.show_part(self._desk.arrangement.world)
        self._show_tab(self._shown_tab)

    def _show_tab(self, name: str) -> None:
        """Show a view, or all of the arrangement."""
        self._shown_tab = name
        robot = self._robot
        offered = {*TABS, EVENTS} if robot is None else {*self._offered_tabs(robot), EVENTS}
        if robot is not None and self._desk.is_arranged:
            shown = self._desk.show(offered)
        else:
            with_events = [name, EVENTS] if name not in ALONE else [name]
            shown = with_events if robot is not None else [view for view in with_events if view in WITHOUT_ROBOTS]
            self._desk.show_one(shown)
        self._empty.set_visibility(robot is None and name not in ("Log", "Recordings"))
        self._show_hint()
        for tab, button in self._tabs.items():
            is_shown = tab in (shown or [name])
            button.classes(add="chosen" if is_shown else "", remove="" if is_shown else "chosen")
            attributes(button, aria_selected=is_shown)
        self._messages.visible = "Log" in shown
        self._world.visible = "World" in shown

    def _refresh(self) -> None:
        robot = self._choice.robot(self._console.fleet.robots)
        if (robot and robot.id) != (self._robot and self._robot.id):
            self._show(robot)
        elif robot is not None:
            self._follow_changes(robot)
        else:
            self._show_hint()
        new = self._console.total_events - self._logged
        self._logged = self._console.total_events
        events = list(self._console.events)[-new:] if new else []
        for event in events:
            self._log.push(event.line_of(translated(event.text)))
        self._status.tell(events)

    def _follow_changes(self, robot: Robot) -> None:
        """Update panels when cameras or drivers have appeared or disappeared; the panel Arm follows its arms itself."""
        before, self._robot = self._robot, robot
        assert before is not None
        for panel, names in ((self._videos, (VIDEO,)), (self._drive, DRIVERS)):
            if _offering(before, names) != _offering(robot, names):
                panel.show(robot)

    def _select(self, id: int) -> None:
        """Handle a click on a robot in the panel Fleet."""
        robot = self._console.fleet.robots.get(id)
        if robot is not None and (self._robot is None or robot.id != self._robot.id):
            self._choice, self._is_own = Choice(robot.id, robot.name), True
            self._show(robot)

    def _remember(self, text: object) -> None:
        """Choose what was chosen in this tab before it was loaded again; nothing if something was chosen since."""
        chosen = Choice.from_text(text)
        if chosen is not None and not self._is_own:
            self._choice, self._is_own = chosen, True

    def _show_hint(self) -> None:
        """Say what is to be done while no robot is shown."""
        robots = self._console.fleet.robots
        hint = self._choice.hint(robots)
        self._looking.set_visibility(not hint)
        self._unchosen.set_visibility(bool(hint))
        self._hint.set_text(translated(hint))

    def _show(self, robot: Robot | None) -> None:
        """Show this robot in all panels."""
        self._robot = robot
        self._title.set_text("" if robot is None else f"{robot.id}  {printable(robot.name)}")
        call(
            "jauspy.selectRobot", 0 if robot is None else robot.id, self._choice.for_browser() if self._is_own else None
        )
        for panel in self._of_robot:
            panel.show(robot)
        offered = TABS if robot is None else self._offered_tabs(robot)
        self._show_tab(self._wanted_tab if self._wanted_tab in offered else offered[0])

    @staticmethod
    def _offered_tabs(robot: Robot) -> list[str]:
        return [name for name in TABS if name not in OFFERED or _offering(robot, OFFERED[name])]


def _offering(robot: Robot, services: tuple[str, ...]) -> set[JausID]:
    """The components with one of these services."""
    return {component.id for component in robot.components if any(component.find(name) for name in services)}
