"""The tab Video: the cameras of a robot, live."""

from __future__ import annotations

from nicegui import ui

from jauspy.console.server import Console
from jauspy.ocu.robot import Robot


class VideoPanel:
    """The cameras of the chosen robot, for one page."""

    def __init__(self, console: Console) -> None:
        self._console = console
        self._figures = ui.element("div").classes("figures")

    def show(self, robot: Robot | None) -> None:
        """Show the cameras of this robot."""
        components = robot.components if robot is not None else ()
        cameras = [each for each in components if each.find("DigitalVideo")]
        self._figures.clear()
        with self._figures:
            for camera in cameras:
                ui.html(
                    f'<canvas data-component="{camera.id}" width="640" height="480"></canvas>'
                    f'<span class="video-note"></span><figcaption>{camera.id}</figcaption>',
                    tag="figure",
                    sanitize=False,
                ).props('onclick="jauspy.enlarge(this)"')
            if robot is not None and not cameras:
                ui.label("this robot has no camera").classes("hint")

    def close(self) -> None:
        """The page has gone."""
