"""The dialogues of a mission: speed and action of a waypoint; save, load, upload, download; no-go areas."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any, Final

from nicegui import ui
from nicegui.events import UploadEventArguments

from jauspy.console.confirmation import confirmed
from jauspy.console.conventions import Conventions
from jauspy.console.geographic_frame import GeographicFrame
from jauspy.console.languages import sentence
from jauspy.console.markup import attributes
from jauspy.console.mission import (
    MAX_SPEED,
    MAX_WAIT,
    MIN_SPEED,
    Action,
    Look,
    Mission,
    Step,
    Still,
    Wait,
    check_speed,
)
from jauspy.console.page_language import _, translated
from jauspy.console.panels.quantity_field import QuantityField
from jauspy.console.saved_files import SavedByOther, SavedFiles, checked_name
from jauspy.console.trajectory import MAX_FILE, not_taken
from jauspy.errors import ConfigError
from jauspy.printable import printable

ACTIONS: Final = {
    "": sentence("drive on"),
    "wait": sentence("wait"),
    "look": sentence("look (pan, tilt)"),
    "still": sentence("save a still image"),
}
DEFAULT_NAME: Final = "mission"


class StepDialog:
    """Speed and action of one waypoint; `on_change` is called with its index and the new step."""

    def __init__(self, on_change: Callable[[int, Step], None], conventions: Conventions) -> None:
        self._on_change = on_change
        self._conventions = conventions
        self._index = 0
        with attributes(ui.dialog(), aria_label=_("speed and action")) as self._dialog, ui.card().classes("mission"):
            self._title = ui.label("").classes("heading")
            self._speed = QuantityField(
                conventions,
                "length",
                lambda unit: _("speed in {unit}/s; empty: that of the list", unit=unit),
                MIN_SPEED,
                MAX_SPEED,
            )
            self._kind = ui.select(
                {kind: translated(label) for kind, label in ACTIONS.items()},
                label=_("at the waypoint"),
                value="",
                on_change=self._show_fields,
            )
            self._kind.props("dense outlined options-dense")
            self._seconds = _number(_("seconds"), 0.1, MAX_WAIT)
            self._pan = QuantityField(
                conventions, "angle", lambda unit: _("pan in {unit}, to the left", unit=unit), -math.pi, math.pi
            )
            self._tilt = QuantityField(
                conventions, "angle", lambda unit: _("tilt in {unit}, downwards", unit=unit), -math.pi, math.pi
            )
            self._camera = ui.input(_("name of the camera, if there are several")).props("dense outlined")
            self._problem = ui.label("").classes("problem").props('role="status"')
            with ui.element("div").classes("row"):
                ui.button(_("apply"), on_click=self._apply).props("unelevated no-caps")
                ui.button(_("cancel"), on_click=self._dialog.close).props("outline no-caps")

    def open(self, index: int, step: Step) -> None:
        """Edit a step."""
        self._index = index
        self._title.set_text(_("waypoint {number}", number=index + 1))
        self._problem.set_text("")
        self._speed.set_value(step.speed)
        action = step.action
        self._kind.set_value("" if action is None else action.kind)
        self._seconds.set_value(action.seconds if isinstance(action, Wait) else 5.0)
        self._pan.set_value(action.pan if isinstance(action, Look) else 0.0)
        self._tilt.set_value(action.tilt if isinstance(action, Look) else 0.0)
        self._camera.set_value(action.camera if isinstance(action, Still) else "")
        self._show_fields()
        self._dialog.open()

    def _show_fields(self) -> None:
        kind = self._kind.value
        self._seconds.set_visibility(kind == "wait")
        for field in (self._pan, self._tilt):
            field.element.set_visibility(kind == "look")
        self._camera.set_visibility(kind == "still")

    def _apply(self) -> None:
        try:
            step = Step(self._speed_value(), self._action())
        except (TypeError, ValueError, ConfigError) as error:
            self._problem.set_text(printable(translated(str(error))).partition("\n")[0])
            return
        self._on_change(self._index, step)
        self._dialog.close()

    def _speed_value(self) -> float | None:
        speed = self._speed.value
        if speed is not None:
            check_speed(speed, self._conventions.exact_speed)
        return speed

    def _action(self) -> Action | None:
        match self._kind.value:
            case "wait":
                seconds = float(self._seconds.value or 0.0)
                if not 0.0 < seconds <= MAX_WAIT:
                    raise ValueError(sentence("a robot waits more than 0 and at most {most:g} s", most=MAX_WAIT))
                return Wait(seconds=seconds)
            case "look":
                pan, tilt = (field.value or 0.0 for field in (self._pan, self._tilt))
                if not (abs(pan) <= math.pi and abs(tilt) <= math.pi):
                    raise ValueError(sentence("pan and tilt are -180 to 180 degrees"))
                return Look(pan=pan, tilt=tilt)
            case "still":
                return Still(camera=str(self._camera.value or "")[:64])
        return None


class MissionDialog:
    """Saved missions and no-go areas; `mission` gets the present one, `take` sets another, `draw` begins an area."""

    def __init__(
        self,
        files: Callable[[], SavedFiles | None],
        mission: Callable[[], Mission],
        take: Callable[[Mission], None],
        draw: Callable[[], None],
        frame: Callable[[], GeographicFrame | None],
    ) -> None:
        self._files, self._mission, self._take, self._frame = files, mission, take, frame
        self._robot = ""

        def begin_area() -> None:
            self._dialog.close()
            draw()

        with attributes(ui.dialog(), aria_label=_("mission")) as self._dialog, ui.card().classes("mission"):
            ui.label(_("Mission")).classes("heading")
            with ui.element("div").classes("row"):
                self._name = ui.input(_("name"), value=DEFAULT_NAME).props("dense outlined").classes("grow")
                ui.button(_("save"), on_click=self._save).props("unelevated no-caps")
            with ui.element("div").classes("row"):
                self._saved = (
                    ui.select([], label=_("saved missions")).props("dense outlined options-dense").classes("grow")
                )
                ui.button(_("load"), on_click=self._load).props("outline no-caps")
                ui.button(_("delete"), on_click=self._delete).props("flat no-caps")
            with ui.element("div").classes("row"):
                self._upload = ui.upload(on_upload=self._upload_file, auto_upload=True, max_file_size=MAX_FILE)
                self._upload.props('accept=".json"').classes("hidden").on_rejected(self._rejected)
                ui.button(_("upload")).props("outline no-caps dense").on(
                    "click", js_handler="() => jauspy.pickFile('.mission')"
                )
                ui.button(_("download"), on_click=self._download).props("outline no-caps dense")
                self._global = ui.checkbox(_("in degrees")).props("dense")
            self._said = ui.label("").classes("problem").props('role="status"')
            with ui.element("div").classes("row"):
                ui.label(_("No-go areas")).classes("heading")
                ui.button(_("draw an area"), on_click=begin_area).props("outline no-caps dense")
            ui.label(_("checked when the robot is started; manual driving ignores them")).classes("hint")
            self._areas = ui.element("div").classes("areas")
            ui.button(_("close"), on_click=self._dialog.close).props("outline no-caps")

    def open(self, robot: str) -> None:
        """Show it for the robot of this name."""
        self._robot = robot
        self._said.set_text("")
        self._global.set_visibility(self._frame() is not None)
        self._show_saved()
        self._show_areas()
        self._dialog.open()

    def _show_saved(self) -> None:
        files = self._files()
        names = [] if files is None else files.missions()
        self._saved.set_options(names, value=self._saved.value if self._saved.value in names else None)

    def _show_areas(self) -> None:
        self._areas.clear()
        with self._areas:
            for index, area in enumerate(self._mission().areas):
                with ui.element("div").classes("waypoint"):
                    ui.label(area.name or _("area {number}", number=index + 1)).classes("grow")
                    ui.label(_("{count} corners", count=len(area.corners))).classes("hint")
                    remove = ui.button("\u00d7", on_click=lambda at=index: self._remove(at))
                    attributes(remove.props("flat dense"), aria_label=_("remove area {number}", number=index + 1))

    def _remove(self, index: int) -> None:
        mission = self._mission()
        self._take(Mission(mission.waypoints, mission.steps, mission.areas[:index] + mission.areas[index + 1 :]))
        self._show_areas()

    async def _save(self) -> None:
        await self._change(lambda files, name, seen: files.save_mission(name, self._mission(), self._robot, seen=seen))

    async def _delete(self) -> None:
        if self._saved.value:
            self._name.set_value(self._saved.value)
            await self._change(lambda files, name, seen: files.delete_mission(name, seen=seen))

    async def _change(self, act: Callable[[SavedFiles, str, Any], None]) -> None:
        """Save or delete; what somebody else has saved only after a question."""
        files = self._files()
        if files is None:
            return
        try:
            name = checked_name(str(self._name.value or ""))
            try:
                act(files, name, None)
            except SavedByOther as error:
                if await confirmed(_("{error}. Replace or delete it?", error=error), _("replace or delete")):
                    act(files, name, error.author)
            self._said.set_text("")
        except ConfigError as error:
            self._said.set_text(translated(str(error)))
        self._show_saved()

    def _load(self) -> None:
        files = self._files()
        if files is None or not self._saved.value:
            return
        try:
            self._take(files.mission(str(self._saved.value), self._frame()))
        except ConfigError as error:
            self._said.set_text(translated(str(error)))
            return
        self._name.set_value(self._saved.value)
        self._dialog.close()

    async def _upload_file(self, event: UploadEventArguments) -> None:
        try:
            content, name = await event.file.read(), printable(event.file.name)
            self._take(Mission.from_json(content, name, self._frame()))
            self._said.set_text("")
        except ConfigError as error:
            self._said.set_text(translated(str(error)))
        self._upload.reset()
        self._show_areas()

    def _rejected(self) -> None:
        self._said.set_text(translated(not_taken(".json")))

    def _download(self) -> None:
        try:
            name = checked_name(str(self._name.value or "")).replace(" ", "_")
        except ConfigError:
            name = DEFAULT_NAME
        frame = self._frame() if self._global.value else None
        ui.download.content(self._mission().to_json(self._robot, frame=frame), f"{name}.json", "application/json")


def _number(label: str, least: float, most: float) -> ui.number:
    return ui.number(label, min=least, max=most).props("dense outlined")
