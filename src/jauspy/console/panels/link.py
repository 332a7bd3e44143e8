"""The panel Link: delay, loss, rate and queue between the chosen robot and the console, with an alarm."""

from __future__ import annotations

from typing import Final

from nicegui import ui

from jauspy.console.languages import sentence
from jauspy.console.markup import attributes
from jauspy.console.page_language import _, translated
from jauspy.errors import JausError
from jauspy.ocu.robot import COMMUNICATOR, HEALTH, Robot
from jauspy.ocu.state import HealthReport, LinkHealth

UPDATE_INTERVAL: Final = 1.0
MAX_ROUND_TRIP: Final = 0.5
"""Seconds from which on the operator is warned."""
MAX_LOSS: Final = 0.2
"""Fraction of the packets."""


class LinkPanel:
    """The link to the chosen robot; hidden for robots that do not measure it."""

    def __init__(self) -> None:
        self._robot: Robot | None = None
        self._asks = False
        self.summary = self.problem = ""
        """The link in short, and why it is bad; both empty for a robot that does not measure it."""
        with ui.element("section").classes("panel link") as self._panel:
            attributes(self._panel, aria_label=_("Link"))
            with ui.element("div").classes("row"):
                ui.label(_("Link")).classes("heading")
                self._state = ui.label("").classes("state grow").props('role="status"')
            self._problem = ui.label("").classes("problem").props('role="alert"')
        self._panel.set_visibility(False)
        ui.timer(UPDATE_INTERVAL, self._update)

    def show(self, robot: Robot | None) -> None:
        """Show the link to this robot."""
        measures = robot is not None and any(robot.info.offering(COMMUNICATOR))
        self._robot = robot if measures else None
        self._panel.set_visibility(measures)
        self._state.set_text("")
        self._problem.set_text("")
        self.summary = self.problem = ""

    def close(self) -> None:
        """Handle the end of the page."""
        self._robot = None

    async def _update(self) -> None:
        robot = self._robot
        if robot is None or self._asks:
            return
        self._asks = True
        state, problem, summary = "", "", ""
        try:
            health = await robot.link()
            reports = await robot.health() if any(robot.info.offering(HEALTH)) else []
        except JausError:
            problem, summary = sentence("the robot does not answer"), sentence("no link")
        else:
            state, problem = described(health), alarm(health) or queue_alarm(reports)
            summary = in_short(health)
        finally:
            self._asks = False
        if self._robot is robot:
            self.summary, self.problem = summary, problem
            self._state.set_text(state)
            self._problem.set_text(translated(problem))


def described(health: LinkHealth) -> str:
    """The values in short."""
    parts = [_("{loss:.0f} % lost or late", loss=100.0 * health.loss)]
    if health.round_trip is not None:
        parts.insert(0, _("{delay:.0f} ms there and back", delay=1000.0 * health.round_trip))
    if health.rate is not None:
        parts.append(f"{health.rate / 1e6:.2f} Mbit/s")
    return ", ".join(parts)


def in_short(health: LinkHealth) -> str:
    """Round trip and loss, for the line below the bar."""
    loss = 100.0 * health.loss
    if health.round_trip is None:
        return sentence("link {loss:.0f} % lost", loss=loss)
    return sentence("link {delay:.0f} ms, {loss:.0f} % lost", delay=1000.0 * health.round_trip, loss=loss)


def queue_alarm(reports: list[HealthReport]) -> str:
    """What the robot says of queues that are long; empty if none is."""
    name = COMMUNICATOR.rpartition(":")[2]
    return next((report.text for report in reports if report.service.endswith(f":{name}") and not report.is_well), "")


def alarm(health: LinkHealth) -> str:
    """The warning for the operator; empty if the link is good."""
    if not health.is_up:
        return sentence("the robot's messages do not arrive here")
    if health.loss > MAX_LOSS:
        return sentence(
            "{loss:.0f} % of the packets are lost or late: drive slowly, or come nearer", loss=100.0 * health.loss
        )
    if health.round_trip is not None and health.round_trip > MAX_ROUND_TRIP:
        return sentence(
            "commands and pictures are late: {round_trip:.1f} s there and back", round_trip=health.round_trip
        )
    return ""
