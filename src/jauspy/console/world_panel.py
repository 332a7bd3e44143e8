"""The tab World: the robot in three dimensions as it is measured, and the map with its waypoints."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Final

from nicegui import ui

from jauspy.console.map_panel import MapPanel
from jauspy.ocu.robot import Robot

if TYPE_CHECKING:
    from jauspy.console.server import Console

VIEWS: Final = {"both": "both", "three": "3-D", "map": "map"}
ON_MAP: Final = ("LocalPoseSensor", "RangeSensor")
"""Services of which the map shows something."""
_THREE_JS: Final = ui.scene
"""Naming it puts three.js, which static/world.js draws with, among the page's modules; no scene of NiceGUI is made."""


class WorldPanel:
    """The views and their switches, for one page; what moves comes by a socket of its own (`world_socket`)."""

    def __init__(self, console: Console, token: str) -> None:
        with ui.element("div").props("id=world").classes("world"):
            with ui.element("div").classes("choice"):
                view = ui.toggle(VIEWS, value="both").props("no-caps dense unelevated")
                self._follow = _switch("follow", value=True)
                _switch("scan", value=True)
                _switch("frames", value=False)
                ui.element("div").classes("space")
                for sign, factor, name in (("\u2212", 0.7, "smaller"), ("+", 1.4, "larger")):
                    ui.html(
                        f'<button class="quiet" title="{name}" onclick="jauspy.map.zoom({factor})">{sign}</button>',
                        sanitize=False,
                    )
            views = ui.element("div").classes("views").props('data-view="both"')
            with views:
                with ui.element("div").classes("three"):
                    ui.element("div").props("id=world-3d")
                    ui.html('<p data-line="waiting" class="waiting" role="status"></p>', sanitize=False)
                self.map = MapPanel(console, token)
            with ui.element("div").classes("row notes"):
                ui.html('<span data-line="source" class="hint"></span>', sanitize=False)
                ui.html('<span data-line="age" class="problem"></span>', sanitize=False)
                ui.html('<span data-line="notes" class="hint"></span>', sanitize=False)
        self._view = view
        view.on_value_change(lambda event: views.props(f'data-view="{event.value}"'))
        ui.on("world_follow", self._followed)

    @property
    def visible(self) -> bool:
        """Set by the page."""
        return self.map.visible

    @visible.setter
    def visible(self, value: bool) -> None:
        self.map.visible = value

    def show(self, robot: Robot | None) -> None:
        """Show another robot; one that tells neither pose nor ranges has nothing for the map."""
        has_map = robot is None or any(each.find(name) for each in robot.components for name in ON_MAP)
        self._view.set_value("both" if has_map else "three")
        self.map.show(robot)

    def close(self) -> None:
        """The page has gone. The socket ends with it, and `Console.forget` ends what it followed."""
        self.map.visible = False

    def _followed(self, event: Any) -> None:
        """The map was dragged away from the robot."""
        self._follow.set_value(bool(event.args))


def _switch(name: str, *, value: bool) -> ui.checkbox:
    box = ui.checkbox(name, value=value).props("dense")
    box.on_value_change(
        lambda event: ui.run_javascript(f"jauspy.world.set('{name}', {str(bool(event.value)).lower()})")
    )
    return box
