"""The tab World: the robot in three dimensions as it is measured, and the map with its waypoints."""

from __future__ import annotations

import math
from collections.abc import Awaitable, Sequence
from typing import TYPE_CHECKING, Any, Final

from nicegui import ui

from jauspy.console.conventions import Conventions
from jauspy.console.geographic_frame import GeographicFrame
from jauspy.console.languages import Sentence, sentence
from jauspy.console.markup import attributes, call, plain_text
from jauspy.console.mission import (
    MAX_AREAS,
    MAX_CORNERS,
    MAX_SPEED,
    MIN_SPEED,
    PLAIN,
    Area,
    Mission,
    Point,
    Step,
    check_speed,
    crossing,
)
from jauspy.console.mission_run import MissionRun, needs_run
from jauspy.console.motion import Motion
from jauspy.console.page_language import _, translated
from jauspy.console.panels.mission import MissionDialog, StepDialog
from jauspy.console.panels.planned_motion import PlannedMotionRow
from jauspy.console.panels.quantity_field import QuantityField
from jauspy.console.route import LIST_DRIVER, MAX_WAYPOINTS, Route, Waypoint
from jauspy.console.saved_files import SavedFiles
from jauspy.console.way_around import way_around
from jauspy.console.world import is_cell
from jauspy.errors import ConfigError, JausError
from jauspy.ocu.robot import DEFAULT_SPEED, Robot
from jauspy.ocu.state import RobotPose

if TYPE_CHECKING:
    from jauspy.console.console import Console
    from jauspy.console.world import World

UPDATE_INTERVAL: Final = 0.5
MAX_DISTANCE: Final = 10_000.0
"""Metres from the origin within which a browser may set a waypoint."""


class MapPanel:
    """The map and the list, for one page with this token. Edits stay in this page until they are sent."""

    def __init__(self, console: Console, token: str, conventions: Conventions) -> None:
        self.visible = False
        """Set by the page; the robot's list is queried only while it is shown."""
        self._console = console
        self._token = token
        self._conventions = conventions
        self._robot: Robot | None = None
        self._draft: list[Waypoint] | None = None
        """Waypoints edited here and not sent; None while the list is the robot's."""
        self._steps: tuple[Step, ...] = ()
        """Speeds and actions, by waypoint; further waypoints have none."""
        self._areas: tuple[Area, ...] = ()
        self._corners: list[Point] | None = None
        """Corners of the no-go area that is being drawn; None while a click sets a waypoint."""
        self._motion = Motion(console, token)
        self._run: MissionRun | None = None
        self._busy = False
        self._refused = ""
        self._listed: tuple[object, ...] = ()
        """Waypoints that the list was made of; its buttons stay while only the states of waypoints change."""
        self._states: list[tuple[ui.element, ui.label]] = []
        self._shown: tuple[object, ...] = ()
        ui.element("div").props("id=world-map").classes("map")
        with ui.element("div").classes("route"):
            with ui.element("div").classes("held"):
                with ui.element("div").classes("row"):
                    ui.label(_("Waypoints")).classes("heading")
                    self._count = ui.label("").classes("hint")
                self._list = ui.element("div").classes("waypoints")
            with ui.element("div").classes("execution"):
                self._build_execution()
        self._step_dialog = StepDialog(self._set_step, conventions)
        self._mission_dialog = MissionDialog(self._files, self._mission, self._load, self._begin_area, self._frame)
        for hidden in (self._drawing, self._stop):
            hidden.set_visibility(False)
        ui.on("waypoint", self._edit)
        ui.on("area_cancelled", self._cancel_area)
        ui.timer(UPDATE_INTERVAL, self._update)

    def _build_execution(self) -> None:
        """The progress, and the buttons that carry the waypoints out."""
        self._bar = ui.linear_progress(0.0, show_value=False, size="6px").props("instant-feedback")
        attributes(self._bar, aria_label=_("progress of the waypoints"))
        self._progress = ui.label("").classes("hint progress")
        self._problem = ui.label("").classes("problem")
        with ui.element("div").classes("row tight"):
            self._stop = ui.button(_("stop"), on_click=self._motion.stop).props("outline no-caps color=negative")
            attributes(self._stop, aria_label=_("stop the mission"))
            self._start = ui.button(_("start"), on_click=self._on_start).props("unelevated no-caps")
            self._pause = ui.button(_("pause"), on_click=self._on_pause).props("outline no-caps")
            self._speed = QuantityField(
                self._conventions,
                "length",
                "{}/s".format,
                0.1,
                MAX_SPEED,
                value=DEFAULT_SPEED,
                step=0.1,
                on_change=self._on_speed,
            )
            self._speed.element.props("debounce=600").classes("short")
            ui.button(_("mission …"), on_click=self._open_mission).props("outline no-caps")
            self._around = ui.button(_("around obstacles"), on_click=self._on_around).props("outline no-caps")
            self._clear = ui.button(_("clear"), on_click=self._on_clear).props("outline no-caps")
            self._discard = ui.button(_("undo edits"), on_click=self._on_discard).props("flat no-caps")
        with ui.element("div").classes("row tight") as self._drawing:
            ui.label(_("click the corners")).classes("hint grow")
            ui.button(_("done"), on_click=self._end_area).props("unelevated no-caps")
            ui.button(_("cancel"), on_click=self._cancel_area).props("outline no-caps")

    def show(self, robot: Robot | None) -> None:
        """Show another robot; edits of the one before are dropped."""
        if robot is None or self._robot is None or robot.id != self._robot.id:
            self._draft, self._refused, self._listed, self._shown = None, "", (), ()
            self._steps, self._areas, self._corners, self._run = (), (), None, None
            self._motion.stop()
            self._show_areas()
        self._robot = robot
        if (source := self._console.map) is not None:
            call("jauspy.mission.setTiles", source.min_zoom, source.max_zoom, source.attribution)

    def close(self) -> None:
        """Handle the end of the page, with which a mission ends."""
        self.visible = False
        self._motion.stop()

    # --- editing ----------------------------------------------------------------------------------------------------

    def _world(self) -> World | None:
        return None if self._robot is None else self._console.worlds.opened(self._robot.id, self._token)

    def _edit(self, event: Any) -> None:
        """Handle a click or a drag in the browser, after checking its values."""
        world, asked = self._world(), event.args
        if world is None or not isinstance(asked, dict) or not world.route.is_offered:
            return
        points = list(self._draft if self._draft is not None else world.route.waypoints)
        try:
            x, y, index = (float(asked.get(key, 0)) for key in ("x", "y", "index"))
        except (TypeError, ValueError):
            return
        if not (abs(x) < MAX_DISTANCE and abs(y) < MAX_DISTANCE):
            return
        if asked.get("what") == "corner":
            self._add_corner(round(x, 2), round(y, 2))
            return
        if self._motion.is_running:
            self._refused = sentence("a mission is running: pause it and stop it first")
            return
        if asked.get("what") == "add" and len(points) < MAX_WAYPOINTS:
            points.append(Waypoint(round(x, 2), round(y, 2)))
        elif asked.get("what") == "move" and index in range(len(points)):
            points[int(index)] = points[int(index)].moved(round(x, 2), round(y, 2))
        else:
            return
        self._take(points)

    def _remove(self, index: int) -> None:
        world = self._world()
        if world is not None:
            points = list(self._draft if self._draft is not None else world.route.waypoints)
            del points[index : index + 1]
            self._steps = self._steps[:index] + self._steps[index + 1 :]
            self._take(points)

    def _take(self, points: list[Waypoint]) -> None:
        self._draft, self._refused, self._run = points, "", None
        self._motion.problem = ""
        self._show_route()

    # --- the mission ------------------------------------------------------------------------------------------------

    def _mission(self) -> Mission:
        """What is shown, as a mission."""
        world = self._world()
        points = self._draft if self._draft is not None else () if world is None else world.route.waypoints
        places = tuple(Waypoint(point.x, point.y) for point in points if point.is_point)
        steps = (*self._steps, *[PLAIN] * len(places))[: len(places)]
        return Mission(places, steps, self._areas)

    def _load(self, mission: Mission) -> None:
        if self._motion.is_running:
            self._refused = sentence("a mission is running: pause it and stop it first")
            return
        self._steps, self._areas, self._corners = mission.steps, mission.areas, None
        self._run = None
        self._show_areas()
        if mission.waypoints or self._draft is not None:
            self._take(list(mission.waypoints))

    def _set_step(self, index: int, step: Step) -> None:
        mission = self._mission()
        if index >= len(mission.steps) or self._motion.is_running:
            return
        self._steps = mission.with_step(index, step).steps
        self._take(list(mission.waypoints))

    def _files(self) -> SavedFiles | None:
        return None if self._robot is None else self._console.files(self._robot)

    def _frame(self) -> GeographicFrame | None:
        return None if self._robot is None else self._console.worlds.positions.frame(self._robot.id)

    def _open_mission(self) -> None:
        if self._robot is not None:
            self._mission_dialog.open(self._robot.name)

    def _begin_area(self) -> None:
        self._corners = []
        self._show_areas()

    def _add_corner(self, x: float, y: float) -> None:
        if self._corners is not None and len(self._corners) < MAX_CORNERS:
            self._corners.append((x, y))
            self._show_areas()

    def _end_area(self) -> None:
        corners, self._corners = self._corners or [], None
        if len(corners) >= 3 and len(self._areas) < MAX_AREAS:
            self._areas = (*self._areas, Area(tuple(corners)))
        else:
            self._refused = sentence(
                "an area has at least 3 corners, and a mission at most {most} areas", most=MAX_AREAS
            )
        self._show_areas()
        self._show_route()

    def _cancel_area(self) -> None:
        self._corners = None
        self._show_areas()

    def _show_areas(self) -> None:
        self._drawing.set_visibility(self._corners is not None)
        drawn = [{"name": area.name, "corners": area.corners} for area in self._areas]
        call("jauspy.mission.setAreas", drawn, self._corners or [], self._corners is not None)

    async def _start_mission(self, world: World, mission: Mission, speed: float) -> None:
        """Carry out waypoints with actions, which the robot's own list cannot hold."""
        robot = self._robot
        assert robot is not None
        run = MissionRun(mission, world.route, robot, speed, folder=self._console.recordings, note=self._console.act)
        self._busy, self._refused = True, ""
        self._show_route()
        try:
            await run.check()
        except JausError as error:
            self._refused = str(error)
        finally:
            self._busy = False
        if self._world() is not world:
            return
        if not self._refused:
            self._motion.begin(robot.id, run.run(), sentence("the mission"))
            self._refused = self._motion.problem
        if not self._refused:
            self._run = run
            self._console.act(
                sentence(
                    "robot {robot}: began a mission of {count} waypoints",
                    robot=robot.id,
                    count=len(mission.waypoints),
                )
            )
        self._show_route()

    # --- showing ----------------------------------------------------------------------------------------------------

    async def _update(self) -> None:
        if not self.visible:
            return
        world = self._world()
        if world is not None:
            await world.route.look()
        self._show_route()

    def _show_route(self) -> None:
        world = self._world()
        if world is None:
            return
        route, mine = world.route, self._operates()
        points = list(self._draft if self._draft is not None else route.waypoints)
        states = [self._state_of(index, route) for index in range(len(points))]
        units = tuple(self._conventions.chosen.items())
        listed = (tuple(points), self._steps, route.is_offered, units)
        if listed != self._listed:
            self._listed = listed
            self._show_list(points)
        if (listed, states) != self._shown:
            self._shown = (listed, states)
            for (element, label), state in zip(self._states, states, strict=True):
                attributes(element, data_state=state)
                label.set_text(translated(STATE_NAMES[state]))
            drawn = [{"x": p.x, "y": p.y, "state": s} for p, s in zip(points, states, strict=True) if p.is_point]
            call("jauspy.world.setRoute", drawn)
        text, fraction = progress_of(route, world.pose, self._conventions)
        is_run = self._motion.is_running and self._run is not None
        if self._run is not None:
            text, fraction = run_progress(self._run, is_running=is_run, is_paused=route.is_paused)
        self._progress.set_text(translated(text))
        self._bar.set_value(fraction)
        self._bar.set_visibility(route.active is not None or is_run)
        self._problem.set_text(translated(self._refused or self._motion.problem or route.problem))
        self._count.set_text(
            _("a mission")
            if is_run
            else _("not sent yet")
            if self._draft is not None
            else _("on the robot")
            if points
            else ""
        )
        runs = route.active is not None and not route.is_paused
        paused = route.is_paused and (self._draft is None or is_run)
        self._start.set_text(_("resume") if paused else _("start"))
        may_start = paused if is_run else not runs or self._draft is not None
        self._start.set_enabled(mine and not self._busy and bool(points) and may_start)
        self._pause.set_enabled(mine and not self._busy and runs)
        self._clear.set_enabled(not self._busy and (mine or self._draft is not None) and bool(points))
        self._clear.set_visibility(not is_run)
        self._stop.set_visibility(is_run)
        self._around.set_enabled(not self._busy and bool(self._draft) and not is_run)
        self._discard.set_visibility(self._draft is not None and not is_run)

    def _state_of(self, index: int, route: Route) -> str:
        """The state of one waypoint, of a mission that runs or ran, or of the robot's list."""
        if (run := self._run) is None:
            return state_of(index, route, is_draft=self._draft is not None)
        if index == run.index and self._motion.is_running:
            return "waits" if route.is_paused and not run.doing else "active"
        return "reached" if index < run.index + bool(run.doing) else "not sent"

    def _show_list(self, points: Sequence[Waypoint]) -> None:
        self._list.clear()
        self._states = []
        with self._list:
            world = self._world()
            if world is not None and not world.route.is_offered:
                ui.label(_("this robot does not offer {service}", service=LIST_DRIVER)).classes("hint")
            elif not points:
                ui.label(_("click on the map to set a waypoint, drag it to move it")).classes("hint")
            for index, point in enumerate(points):
                with ui.element("div").classes("waypoint") as element:
                    ui.label(str(index + 1)).classes("number")
                    where = (
                        self._conventions.place(point.x, point.y)
                        if point.is_point
                        else getattr(point.element, "NAME", "data")
                    )
                    ui.label(where).classes("grow")
                    step = self._steps[index] if index < len(self._steps) else PLAIN
                    self._states.append((element, ui.label("").classes("hint")))
                    edit = ui.button(
                        translated(step.shown(self._conventions)) or _("drive on"),
                        on_click=lambda at=index: self._edit_step(at),
                    )
                    attributes(
                        edit.props("flat dense no-caps align=left").classes("step"),
                        aria_label=_("speed and action of waypoint {number}", number=index + 1),
                    )
                    remove = ui.button("\u00d7", on_click=lambda at=index: self._remove(at))
                    attributes(remove.props("flat dense"), aria_label=_("remove waypoint {number}", number=index + 1))

    def _edit_step(self, index: int) -> None:
        steps = self._mission().steps
        if index < len(steps):
            self._step_dialog.open(index, steps[index])

    # --- commands ---------------------------------------------------------------------------------------------------

    def _operates(self) -> bool:
        operation = self._console.operation(self._robot.id) if self._robot is not None else None
        return operation is not None and operation.is_controlled and operation.operator == self._token

    async def _command(self, what: str, command: Awaitable[None]) -> bool:
        """Carry out a command of the browser that operates; a refusal is shown and logged."""
        assert self._robot is not None
        self._busy, self._refused = True, ""
        self._show_route()
        try:
            if not self._operates():
                raise ConfigError(sentence("take control of the robot first"))
            await command
        except JausError as error:
            self._refused = str(error)
            self._console.note(
                sentence("robot {robot}: {what} was refused: {error}", robot=self._robot.id, what=what, error=error)
            )
            return False
        else:
            self._console.note(sentence("robot {robot}: {what}", robot=self._robot.id, what=what))
            return True
        finally:
            self._busy = False
            self._show_route()

    async def _on_start(self) -> None:
        world = self._world()
        if world is None:
            return
        route, draft, speed = world.route, self._draft, self._speed.value or DEFAULT_SPEED
        try:
            check_speed(speed, self._conventions.exact_speed)
        except ConfigError as error:
            self._refused = str(error)
            self._show_route()
            return
        if route.is_paused and (draft is None or self._motion.is_running):
            await self._command(
                sentence("go on through the waypoints at {speed:g} m/s", speed=speed), route.set_speed(speed)
            )
            return
        mission = self._mission()
        pose = world.pose
        begin = [] if pose is None else [(pose.x, pose.y)]
        if problem := crossing([*begin, *((point.x, point.y) for point in mission.waypoints)], mission.areas):
            self._refused = problem
            self._show_route()
            return
        if needs_run(mission):
            self._draft = list(mission.waypoints)
            await self._start_mission(world, mission, speed)
            return
        self._run = None
        many = len(draft if draft is not None else route.waypoints)
        if await self._command(
            sentence("drive through {count} waypoints at {speed:g} m/s", count=many, speed=speed),
            route.start(draft, speed),
        ):
            if self._draft is draft:
                self._draft = None
            self._show_route()

    async def _on_around(self) -> None:
        """Replace the points that were clicked by a way to them around what the map shows; it is not sent yet."""
        world, draft = self._world(), self._draft
        if world is None or not draft:
            return
        self._busy, self._refused = True, ""
        try:
            found = await way_around(world, draft, self._areas)
            if self._draft is draft:
                self._draft, self._steps = found, ()
        except JausError as error:
            self._refused = str(error)
        finally:
            self._busy = False
            self._show_route()

    async def _on_pause(self) -> None:
        world = self._world()
        if world is not None:
            await self._command(sentence("wait on the way through the waypoints"), world.route.set_speed(0.0))

    async def _on_speed(self) -> None:
        """Change the speed of a robot that drives through its list immediately."""
        world, speed = self._world(), self._speed.value or 0.0
        if world is None or not MIN_SPEED <= speed <= MAX_SPEED:
            return
        if self._operates() and world.route.active is not None and not world.route.is_paused:
            await self._command(
                sentence("go on through the waypoints at {speed:g} m/s", speed=speed), world.route.set_speed(speed)
            )

    async def _on_clear(self) -> None:
        world = self._world()
        if world is None or self._motion.is_running:
            return
        self._steps, self._run = (), None
        if (
            world.route.waypoints
            and self._operates()
            and not await self._command(sentence("delete the waypoints"), world.route.clear())
        ):
            return
        self._draft = [] if world.route.waypoints else None
        self._show_route()

    def _on_discard(self) -> None:
        self._draft, self._refused, self._run, self._steps = None, "", None, ()
        self._show_route()


def run_progress(run: MissionRun, *, is_running: bool, is_paused: bool) -> tuple[str, float]:
    """The progress of a mission: as text, and from 0 to 1."""
    many = len(run.mission.waypoints)
    if run.is_done:
        return sentence("the mission ended at waypoint {number} of {count}", number=many, count=many), 1.0
    where = {"number": run.index + 1, "count": many}
    if not is_running:
        if run.doing:
            return sentence("the mission was stopped at waypoint {number} of {count}", **where), (
                run.index + 0.9
            ) / many
        return sentence("the mission was stopped before waypoint {number} of {count}", **where), run.index / many
    if run.doing:
        text = sentence("at waypoint {number} of {count}: {action}", action=run.doing, **where)
        return text, (run.index + 0.9) / many
    return _on_the_way(run.index + 1, many, is_paused=is_paused), run.index / many


def _on_the_way(number: int, count: int, *, is_paused: bool) -> Sentence:
    if is_paused:
        return sentence("waits on the way to waypoint {number} of {count}", number=number, count=count)
    return sentence("drives to waypoint {number} of {count}", number=number, count=count)


def state_of(index: int, route: Route, *, is_draft: bool) -> str:
    """The state of one waypoint as text, which selects its colour in the browser."""
    if is_draft:
        return "not sent"
    if route.active is None:
        return "reached" if index < route.ended_at + route.has_arrived else "on the robot"
    if index == route.active:
        return "waits" if route.is_paused else "active"
    return "reached" if index < route.active else "on the robot"


def progress_of(route: Route, pose: RobotPose | None, conventions: Conventions) -> tuple[str, float]:
    """The robot's progress in its list: as text, and from 0 to 1."""
    many = len(route.waypoints)
    if route.active is None:
        if route.ended_at < 0:
            return "", 0.0
        done = route.ended_at == many - 1 and route.has_arrived
        if route.has_arrived:
            text = sentence("ended at waypoint {number} of {count}", number=route.ended_at + 1, count=many)
        else:
            text = sentence("ended on the way to waypoint {number} of {count}", number=route.ended_at + 1, count=many)
        return text, 1.0 if done else 0.0
    text = _on_the_way(route.active + 1, many, is_paused=route.is_paused)
    goal = route.waypoints[route.active]
    if pose is None or not goal.is_point:
        return text, route.active / many
    left = math.dist((pose.x, pose.y), (goal.x, goal.y))
    leg = left if route.began_at is None else math.dist(route.began_at, (goal.x, goal.y))
    part = max(0.0, 1.0 - left / leg) if leg > 0.0 else 0.0
    shown = sentence("{text}: {distance} left", text=text, distance=conventions.distance(left, 1))
    return shown, (route.active + part) / many


STATE_NAMES: Final = {
    "not sent": sentence("not sent"),
    "on the robot": sentence("on the robot"),
    "active": sentence("active"),
    "waits": sentence("waits"),
    "reached": sentence("reached"),
}
"""What pages call the states of waypoints."""
VIEWS: Final = {"both": sentence("both"), "three": sentence("3-D"), "map": sentence("map")}
ON_MAP: Final = ("LocalPoseSensor", "RangeSensor")
"""Services whose data the map shows."""
_THREE_JS: Final = ui.scene
"""Naming it puts three.js, which static/world.js draws with, among the page's modules; no scene of NiceGUI is made."""


class WorldPanel:
    """The views and their switches, for one page; changing data arrive by a separate socket (`world_socket`)."""

    def __init__(self, console: Console, token: str, conventions: Conventions) -> None:
        with ui.element("div").props("id=world").classes("world"):
            with ui.element("div").classes("choice"):
                view = ui.toggle({name: translated(label) for name, label in VIEWS.items()}, value="both").props(
                    "no-caps dense unelevated"
                )
                self._follow = _switch("follow", _("follow"), value=True)
                scan = _switch("scan", _("scan"), value=True)
                costs = _switch("costs", _("costs"), value=False)
                _switch("frames", _("frames"), value=False)
                ui.element("div").classes("space")
                smaller = _zoom("\u2212", 0.7, _("smaller"))
                larger = _zoom("+", 1.4, _("larger"))
            views = ui.element("div").classes("views").props('data-view="both"')
            with views:
                with ui.element("div").classes("three"):
                    ui.element("div").props("id=world-3d")
                    ui.html('<p data-line="waiting" class="waiting" role="status"></p>', sanitize=False)
                self.map = MapPanel(console, token, conventions)
            self._planned = PlannedMotionRow(console, token)
            with ui.element("div").classes("row notes"):
                ui.html('<span data-line="source" class="hint"></span>', sanitize=False)
                ui.html('<span data-line="age" class="problem"></span>', sanitize=False)
                ui.html('<span data-line="notes" class="hint"></span>', sanitize=False)
        self._view = view
        self._part, self._has_map = "both", True
        self._of_map: tuple[ui.element, ...] = (view, self._follow, scan, costs, smaller, larger)
        view.on_value_change(lambda event: attributes(views, data_view=str(event.value)))
        ui.on("world_follow", self._followed)

    @property
    def visible(self) -> bool:
        """True while the page shows the panel; the page sets it."""
        return self.map.visible

    @visible.setter
    def visible(self, value: bool) -> None:
        self.map.visible = value

    def show_part(self, part: str) -> None:
        """Show the map (`map`), the robot in three dimensions (`three`), or both, as far as the robot has them."""
        self._part = part
        self._view.set_value(part if self._has_map else "three")

    def show(self, robot: Robot | None) -> None:
        """Show another robot; one that reports neither pose nor ranges, or stands in a cell, has no map."""
        tells = robot is None or any(component.find(name) for component in robot.components for name in ON_MAP)
        self._has_map = has_map = tells and (robot is None or not is_cell(robot))
        self.show_part(self._part)
        for button in self._of_map:
            button.set_visibility(has_map)
        self.map.show(robot)
        self._planned.show(robot)

    def close(self) -> None:
        """Handle the end of the page, which also ends the socket; `Console.forget` ends what it followed."""
        self.map.close()
        self._planned.close()

    def _followed(self, event: Any) -> None:
        """Handle a drag of the map away from the robot."""
        self._follow.set_value(bool(event.args))


def _zoom(sign: str, factor: float, tip: str) -> ui.element:
    button = plain_text(sign, tag="button").classes("quiet").tooltip(tip)
    return attributes(button, data_do="zoom", data_to=factor, aria_label=tip)


def _switch(name: str, label: str, *, value: bool) -> ui.checkbox:
    box = ui.checkbox(label, value=value).props("dense")
    box.on_value_change(lambda event: call("jauspy.world.set", name, bool(event.value)))
    return box
