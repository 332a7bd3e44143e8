"""The panel Conveyor: the belt's speed and direction, a stop, and what lies on it by the sensor of parts."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final

from nicegui import ui

from jauspy.console.console import Console
from jauspy.console.languages import sentence
from jauspy.console.manipulators import CONVEYOR
from jauspy.console.markup import attributes
from jauspy.console.motion import Motion
from jauspy.console.page_language import _, translated
from jauspy.console.world import PART_SENSOR
from jauspy.errors import ConfigError, JausError
from jauspy.geometry.poses import Transform
from jauspy.messages.cell import QueryConveyorState, ReportConveyorState, SetConveyorSpeed
from jauspy.ocu.robot import ComponentClient, Robot
from jauspy.ocu.service import ServiceClient
from jauspy.platform.modular.parts import ConveyorSetup
from jauspy.printable import printable

UPDATE_INTERVAL: Final = 0.4
"""Seconds between two queries of the belt and of the parts."""
ALL_FIELDS: Final = 0xFF
DEFAULT_SHARE: Final = 0.2
"""The initial speed, as a share of the greatest one."""
ABOVE: Final = (-0.02, 0.3)
"""Metres above the belt between which the frame of a part is that lies on it."""
MAX_ITEMS: Final = 12
"""Parts that are named."""
FORWARD: Final = "forward"
DIRECTIONS: Final = {FORWARD: sentence("forward"), "backward": sentence("backward")}


class ConveyorPanel:
    """The conveyor of the chosen robot, for one page, which `token` names."""

    def __init__(self, console: Console, token: str) -> None:
        self._console = console
        self._motion = Motion(console, token)
        self._robot: Robot | None = None
        self._belt: ServiceClient | None = None
        self._sensor: ComponentClient | None = None
        self._place: ConveyorSetup | None = None
        self._max_speed: float | None = None
        with ui.element("section").classes("panel conveyor") as self._panel:
            attributes(self._panel, aria_label=_("Conveyor"))
            with ui.element("div").classes("row"):
                ui.label(_("Conveyor")).classes("heading")
                self._state = ui.label("").classes("hint grow").props('role="status"')
                self._run = ui.button(_("run"), on_click=self._start).props("outline no-caps dense")
                self._stop = ui.button(_("stop"), on_click=self._halt).props("outline no-caps dense color=negative")
            with ui.element("div").classes("row"):
                with ui.element("div").classes("setting"):
                    self._speed_text = ui.label("").classes("hint")
                    self._speed = ui.slider(min=0.0, max=1.0, step=0.01, value=0.1, on_change=self._show_speed)
                    attributes(self._speed, aria_label=_("speed of the belt in m/s"))
                self._direction = ui.toggle(
                    {name: translated(label) for name, label in DIRECTIONS.items()}, value=FORWARD
                ).props("no-caps dense unelevated")
            self._items = ui.label("").classes("hint items")
            self._problem = ui.label("").classes("problem").props('role="status"')
        self._panel.set_visibility(False)
        ui.timer(UPDATE_INTERVAL, self._update)

    def show(self, robot: Robot | None) -> None:
        """Show the conveyor of this robot; nothing if it has none."""
        self._motion.stop()
        self._robot, self._max_speed, self._place = robot, None, None
        belt, self._sensor = _component(robot, CONVEYOR), _component(robot, PART_SENSOR)
        self._belt = None if belt is None else belt.service(CONVEYOR)
        self._panel.set_visibility(self._belt is not None)
        for text in (self._state, self._items, self._problem):
            text.set_text("")

    def close(self) -> None:
        """Handle the end of the page."""
        self._motion.stop()
        self._robot = None

    async def _update(self) -> None:
        robot, belt = self._robot, self._belt
        if robot is None or belt is None:
            return
        why = self._motion.refusal(robot.id)
        self._run.set_enabled(not why)
        self._stop.set_enabled(not why)
        self._problem.set_text(printable(translated(self._motion.problem)))
        try:
            report = await belt_state(belt)
            if self._robot is not robot:
                return  # another one was chosen meanwhile
            self._state.set_text(belt_text(report))
            self._limit(report.max_speed)
            self._items.set_text(await self._seen(robot))
        except JausError as error:
            self._state.set_text(printable(translated(str(error))))

    def _limit(self, max_speed: float | None) -> None:
        """Set the range of the slider, once the greatest speed is known."""
        if max_speed and max_speed != self._max_speed:
            self._max_speed = max_speed
            attributes(self._speed, max=max_speed)
            self._speed.set_value(DEFAULT_SHARE * max_speed)
            self._show_speed()

    async def _seen(self, robot: Robot) -> str:
        """A text with the parts on the belt; empty if the place of the belt, or no sensor of parts, is known."""
        if self._place is None:
            cell = await self._console.worlds.cell(robot)
            self._place = cell.conveyor if cell is not None else None
        if self._place is None or self._sensor is None or self._robot is not robot:
            return ""
        return items_text(items(self._place, (await self._sensor.part_station.observe()).poses))

    def _show_speed(self) -> None:
        self._speed_text.set_text(_("speed {speed:.2f} m/s", speed=self._speed.value))

    def _start(self) -> None:
        sign = 1.0 if self._direction.value == FORWARD else -1.0
        self._command(sign * float(self._speed.value), sentence("running the belt"))

    def _halt(self) -> None:
        self._command(0.0, sentence("stopping the belt"))

    def _command(self, speed: float, what: str) -> None:
        belt = self._belt
        if self._robot is None or belt is None:
            return

        async def send() -> None:
            await belt.send(SetConveyorSpeed(speed), ack=True)

        self._motion.begin(self._robot.id, send(), what)


def _component(robot: Robot | None, service: str) -> ComponentClient | None:
    """The first component with a service."""
    if robot is None:
        return None
    ids = [str(component.id) for component in robot.components if component.find(service)]
    return robot.component(ids[0]) if ids else None


async def belt_state(belt: ServiceClient) -> ReportConveyorState:
    """The motion of a belt. Raises `ConfigError` if it does not report it."""
    report = await belt.query(QueryConveyorState(ALL_FIELDS))
    if not isinstance(report, ReportConveyorState):
        raise ConfigError(sentence("{belt} does not report its state", belt=belt.id))
    return report


def belt_text(report: ReportConveyorState) -> str:
    """A text with the motion of a belt."""
    speed, wanted, travel = report.speed or 0.0, report.commanded_speed or 0.0, report.position or 0.0
    if abs(speed) < 0.0005:
        text = _("stands")
    elif speed > 0.0:
        text = _("{speed:.2f} m/s forward", speed=speed)
    else:
        text = _("{speed:.2f} m/s backward", speed=-speed)
    if abs(speed - wanted) > 0.005:
        text += _(", to be {speed:.2f} m/s", speed=wanted)
    return text + _(", moved {distance:.2f} m", distance=round(travel, 2) + 0.0)


def items(belt: ConveyorSetup, poses: Mapping[str, Transform]) -> list[tuple[str, float]]:
    """Parts on a belt with their metres from its begin, the first to leave it first."""
    frame = Transform.from_pose(belt.pose).inverse()
    found = []
    for name, pose in poses.items():
        x, y, z = frame.apply(pose.position)
        if abs(x) <= belt.length / 2.0 and abs(y) <= belt.width / 2.0 and ABOVE[0] <= z <= ABOVE[1]:
            found.append((name, x + belt.length / 2.0))
    return sorted(found, key=lambda item: -item[1])


def items_text(found: list[tuple[str, float]]) -> str:
    """A text with parts on a belt."""
    named = ", ".join(
        _("{name} at {place:.2f} m", name=printable(name), place=place) for name, place in found[:MAX_ITEMS]
    )
    more = _(" and {count} more", count=len(found) - MAX_ITEMS) if len(found) > MAX_ITEMS else ""
    return _("on it: {names}", names=named + more) if found else _("nothing on it")
