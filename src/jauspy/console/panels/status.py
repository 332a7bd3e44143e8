"""The line below the bar: mode, battery, link, age of the video, alarms with acknowledgement, and what has happened."""

from __future__ import annotations

from collections.abc import Iterable
from datetime import datetime
from typing import Any, Final

from nicegui import ui

from jauspy.console.alarms import Alarm, Alarms
from jauspy.console.console import Console, Event
from jauspy.console.fleet import NOTHING
from jauspy.console.languages import joined, sentence
from jauspy.console.markup import attributes, call, plain_text
from jauspy.console.operation import Operation
from jauspy.console.page_language import _, translated
from jauspy.console.panels.battery import BatteryLabel
from jauspy.console.panels.drive import NAMES, WAYPOINTS
from jauspy.console.panels.link import LinkPanel
from jauspy.console.users import LOCAL
from jauspy.ocu.robot import Robot
from jauspy.printable import printable

UPDATE_INTERVAL: Final = 0.5
STATES: Final = ("EMERGENCY", "FAILURE", "SHUTDOWN", "INIT", "READY", "STANDBY")
"""States of components; the mode names the first that one of them has."""
KINDS: Final = {
    "stop": ("EMERGENCY", "emergency", "STOP"),
    "problem": (
        "not answer",
        "refused",
        "was stopped",
        "no video",
        "has gone",
        "failed",
        "silent",
        "too slow",
        "FAILURE",
    ),
    "control": ("operates", "controlled", "control of", "asks", "holds"),
}
"""Kinds of events by their words, for the colours of the line of time."""
BAD_LINK_TIME: Final = 3.0
"""Seconds for which a link must be bad to be an alarm: single packets are late now and then."""
MAX_MARKS: Final = 200
"""Events that a page is sent at once for its line of time."""


class StatusBar:
    """The line of one page, which `token` names; it reads what the label and the panel have asked the robot."""

    def __init__(self, console: Console, token: str) -> None:
        self._console = console
        self._token = token
        self._robot: Robot | None = None
        self._gone = ""
        """The robot that was shown until it fell silent."""
        self._was_mine = False
        self._lost = ""
        """Why this page has lost control; empty after it took control again, or was acknowledged."""
        self._video_is_old = False
        self._bad_link = 0
        """Updates since which the link is bad."""
        self._alarms = Alarms()
        self.link: LinkPanel | None = None
        """The panel that measures the link; set by the page."""
        self._mode = ui.label("").classes("mode").props('role="status"')
        self._battery = BatteryLabel()
        self._link = ui.label("").classes("status-link")
        ui.html('<span id="video-age"></span>', sanitize=False).tooltip(_("age of the large picture when it was drawn"))
        with ui.element("div").classes("alarms").props('role="alert"') as self._place:
            with ui.label("").classes("alarm-text") as self._text:
                self._all = ui.tooltip("").classes("alarm-list")
            self._acknowledge = ui.button(_("acknowledge"), on_click=self._acknowledge_all, color=None)
            self._acknowledge.props("flat dense no-caps").classes("acknowledge")  # console.js gives it a title
        with ui.element("div").classes("time-line"):
            line = ui.element("div").props('id=time-line role="img"')
            attributes(line, aria_label=_("events of the last ten minutes; the view Events lists them"))
            attributes(plain_text("", tag="button").props("id=alarm-sound").classes("quiet"), data_do="sound")
        ui.on("alarms_acknowledged", self._acknowledge_all)
        ui.on("video_is_old", self._take_video)
        ui.timer(UPDATE_INTERVAL, self._update)

    def show(self, robot: Robot | None) -> None:
        """Show the state of this robot."""
        self._battery.show(robot)
        if robot is None and self._robot is not None:
            self._gone = sentence(
                "robot {id} {name} does not answer any more",
                id=self._robot.id,
                name=printable(self._robot.name),
            )
        elif robot is not None:
            self._gone = ""
        if robot is None or self._robot is None or robot.id != self._robot.id:
            self._was_mine, self._lost, self._video_is_old = False, "", False
        self._robot = robot
        self._update()

    def close(self) -> None:
        """Handle the end of the page."""
        self._battery.close()
        self._robot = None

    def tell(self, events: Iterable[Event]) -> None:
        """Add events to the line of time."""
        newest = list(events)[-MAX_MARKS:]
        marks = [_mark(event.time, event.line_of(translated(event.text)), kind_of(event.text)) for event in newest]
        if marks:
            call("jauspy.timeLine.add", marks)

    def _take_video(self, event: Any) -> None:
        self._video_is_old = event.args is True

    def _acknowledge_all(self) -> None:
        self._lost = ""
        acknowledged = self._alarms.acknowledge()
        if acknowledged:
            self._console.act(sentence("acknowledged: {alarms}", alarms=joined(alarm.text for alarm in acknowledged)))
        self._update()

    def _update(self) -> None:
        robot = self._robot
        operation = self._console.operation(robot.id) if robot is not None else None
        self._follow_control(operation)
        text, state = self._mode_of(robot, operation)
        self._mode.set_text(text)
        attributes(self._mode, data_state=state)
        self._mode.set_visibility(bool(text))
        self._link.set_text(translated(self.link.summary) if self.link is not None and robot is not None else "")
        new = self._alarms.update(self._causes(robot))
        if new:
            now = datetime.now().astimezone()
            texts = [_("alarm: {text}", text=alarm.text) for alarm in new]
            marks = [f"{now:%H:%M:%S}  {text}" for text in texts]
            call("jauspy.timeLine.add", [_mark(now, text, "problem") for text in marks])
        self._show_alarms()
        if new or not self._alarms.is_loud:
            call("jauspy.alarm.set", self._alarms.is_loud, bool(new))

    def _follow_control(self, operation: Operation | None) -> None:
        is_mine = operation is not None and operation.is_controlled and operation.operator == self._token
        if self._was_mine and not is_mine and operation is not None:
            self._lost = lost_control(operation, self._token)
        if is_mine:
            self._lost = ""
        self._was_mine = is_mine

    def _mode_of(self, robot: Robot | None, operation: Operation | None) -> tuple[str, str]:
        """What the robot is doing for whom, and its state for the colour."""
        if robot is None:
            return "", "other"
        states = {self._console.fleet.states.get(component.id, NOTHING).status for component in robot.components}
        state = next((state for state in STATES if state in states), "")
        if operation is None or not operation.is_controlled:
            who = _("observing")
        elif operation.operator != self._token:
            who = _("{user} operates", user=operation.user.name)
        else:
            world = self._console.worlds.get(robot.id)
            is_on_its_way = world is not None and world.route.active is not None
            way = WAYPOINTS if is_on_its_way else operation.mode
            who = _("you operate, {mode}", mode=NAMES[way])
        return f"{state.lower()}, {who}".lstrip(", "), state.lower()

    def _causes(self, robot: Robot | None) -> Iterable[Alarm]:
        """What is wrong now, the most important first."""
        if self._gone:
            yield Alarm("gone", self._gone, is_urgent=True)
        if self._lost:
            yield Alarm("control", self._lost, is_urgent=True)
        if robot is None:
            return
        fleet = self._console.fleet
        silent = [part for part in robot.components if fleet.is_silent(part.id) and part.find("Management")]
        if silent:
            names = ", ".join(str(part.id) for part in silent[:3]) + (" \u2026" if len(silent) > 3 else "")
            yield Alarm("silent", sentence("silent: {names}", names=names), is_urgent=True)
        status = {part.id: fleet.states.get(part.id, NOTHING).status for part in robot.components}
        if failed := [str(id) for id, state in status.items() if state == "FAILURE"]:
            yield Alarm(
                "failure", sentence("failure of {components}", components=", ".join(failed[:3])), is_urgent=True
            )
        if any(state == "EMERGENCY" for state in status.values()):
            yield Alarm("emergency", sentence("the robot is in emergency"))
        if self._battery.level in ("low", "empty"):
            yield Alarm(f"battery {self._battery.level}", self._battery.text, is_urgent=self._battery.level == "empty")
        self._bad_link = self._bad_link + 1 if self.link is not None and self.link.problem else 0
        if self.link is not None and self._bad_link * UPDATE_INTERVAL >= BAD_LINK_TIME:
            yield Alarm("link", self.link.problem)
        if self._video_is_old:
            yield Alarm("video", sentence("the large picture is old"))

    def _show_alarms(self) -> None:
        shown = self._alarms.shown
        self._place.set_visibility(bool(shown))
        texts = [
            _("{alarm} (is over)", alarm=alarm.text) if alarm.has_ended else translated(alarm.text) for alarm in shown
        ]
        self._text.set_text("; ".join(texts))
        self._all.set_text("\n".join(texts))
        if not shown:
            return
        first = shown[0]
        attributes(
            self._place,
            data_level="known" if first.is_acknowledged else "urgent" if first.is_urgent else "warning",
        )
        self._acknowledge.set_visibility(not first.is_acknowledged)


def lost_control(operation: Operation, token: str) -> str:
    """Why a page has lost control, which it had until now; empty if it has released it or handed it over."""
    if operation.is_controlled and operation.taken_from == token:
        user = sentence("another browser") if operation.user == LOCAL else operation.user.name
        return sentence("control was lost: {user} has taken it over", user=user)
    problem = operation.problem_for(token)
    return sentence("control was lost: {problem}", problem=printable(problem)) if problem else ""


def _mark(time: datetime, text: str, kind: str) -> dict[str, object]:
    return {"time": 1000.0 * time.timestamp(), "text": text, "kind": kind}


def kind_of(text: str) -> str:
    """The kind of an event: `stop`, `problem`, `control`, or `info`."""
    return next((kind for kind, words in KINDS.items() if any(word in text for word in words)), "info")
