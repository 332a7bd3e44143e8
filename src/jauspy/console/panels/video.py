"""The tab Video: the cameras of a robot, live, with still images, recordings and settings."""

from __future__ import annotations

from contextlib import suppress
from datetime import datetime
from typing import Any, Final

from nicegui import events, ui

from jauspy.console.camera_settings import LENS, LIGHTS, VIDEO, Setting, read_settings, sensor_name, write_setting
from jauspy.console.console import Console
from jauspy.console.conventions import Conventions
from jauspy.console.languages import sentence
from jauspy.console.markup import attributes, call
from jauspy.console.page_language import _, translated
from jauspy.console.panels.pointing import Pointing
from jauspy.console.users import User
from jauspy.console.video import SharedCamera
from jauspy.errors import JausError, RequestError
from jauspy.ocu.control import DEFAULT_AUTHORITY
from jauspy.ocu.robot import Robot
from jauspy.ocu.subsystems import ComponentInfo
from jauspy.printable import printable

UPDATE_INTERVAL: Final = 0.5
"""Seconds between two updates of recordings."""
NAMING_INTERVAL: Final = 3.0
"""Seconds after which a camera that did not tell its name is asked again."""
HEADINGS: Final = {VIDEO: sentence("Stream"), LENS: sentence("Lens"), LIGHTS: sentence("Lights")}


class VideoPanel:
    """The cameras of the chosen robot, for the page of this token."""

    def __init__(self, console: Console, token: str, user: User, conventions: Conventions) -> None:
        self._console = console
        self._token = token
        self._user = user
        self._robot: Robot | None = None
        self._figures: dict[str, ui.element] = {}
        self._captions: dict[str, ui.label] = {}
        self._unnamed: set[str] = set()
        """Cameras that have not told their names."""
        self._naming = False
        self._chosen = ""
        self._filling = False
        with ui.element("div").classes("video-bar"):
            ui.element("div").classes("space")
            self._pointing = Pointing(console, token, self._component, self._say, conventions)
            self._still = _button(_("still"), self._take_still, _("save a picture"))
            self._record = _button(
                _("record"), self._toggle_recording, _("record what arrives, on the console's machine")
            )
            self._overlay = _button(_("overlay"), self._toggle_overlay, _("heading, speed, pitch and roll"))
            self._open_settings = _button(_("settings"), self._toggle_settings, _("camera and lights"))
        with ui.element("div").classes("video-notes"):
            self._recorded = ui.label("").classes("recording")
            self._said = ui.label("").classes("video-said")
            ui.html('<span id="video-load" role="status"></span>', sanitize=False)
        with ui.element("div").classes("video-split"):
            self._figures_place = ui.element("div").classes("figures")
            with self._figures_place:
                self._place = ui.element("div").classes("pictures")
            self._side = ui.element("div").classes("video-settings")
        self._side.set_visibility(False)
        with self._side:
            self._refused = ui.label("")
        ui.on("camera_settings_closed", lambda: self._side.set_visibility(False))
        ui.timer(UPDATE_INTERVAL, self._update)
        ui.timer(NAMING_INTERVAL, self._name_cameras)

    def show(self, robot: Robot | None) -> None:
        """Show the cameras of this robot."""
        self._robot = robot
        self._pointing.show(robot)
        components = robot.components if robot is not None else ()
        cameras = [component for component in components if component.find(VIDEO)]
        self._place.clear()
        self._figures, self._captions, self._chosen = {}, {}, ""
        self._unnamed = {str(camera.id) for camera in cameras}
        self._said.set_text("")
        with self._place:
            for camera in cameras:
                self._add_figure(camera)
            if robot is not None and not cameras:
                ui.label(_("this robot has no camera")).classes("hint")
        for button in (self._still, self._record, self._overlay, self._open_settings):
            button.set_visibility(bool(cameras))
        self._record.set_enabled(self._user.may_operate)
        if cameras:
            self._choose(str(cameras[0].id))
            ui.timer(0.1, self._name_cameras, once=True)
        else:
            self._side.set_visibility(False)

    def close(self) -> None:
        """Handle the end of the page; recordings continue."""
        self._pointing.close()

    def _say(self, text: str, instead_of: str | None = None) -> None:
        """Show a text, or only where another one is still shown."""
        if instead_of is None or self._said.text == instead_of:
            self._said.set_text(text)

    # --- cameras ----------------------------------------------------------------------------------------------------

    def _add_figure(self, camera: ComponentInfo) -> None:
        id = str(camera.id)
        with ui.element("figure").props('tabindex="0" role="button"') as figure:
            attributes(figure, aria_label=_("camera {id}", id=id))
            picture = ui.element("canvas").props('width=640 height=480 role="img"')
            attributes(picture, data_component=id, aria_label=_("picture of the camera {id}", id=id))
            ui.html(
                '<div class="overlay"></div><span class="video-note" role="status"></span>'
                '<span class="video-says" role="status"></span>',
                sanitize=False,
            ).style("display: contents")
            with ui.element("figcaption"):
                self._captions[id] = ui.label(f"{id}  {printable(camera.name)}")
                ui.html('<span class="video-facts"></span>', sanitize=False)
        figure.on("click", lambda: self._choose(id)).on("keydown.enter", lambda: self._choose(id))
        self._figures[id] = figure

    def _choose(self, id: str) -> None:
        """Enlarge a camera; the buttons are for it."""
        if id == self._chosen or id not in self._figures:
            return
        self._chosen = id
        for element, figure in self._figures.items():
            figure.classes(add="large" if element == id else "", remove="" if element == id else "large")
        self._update()
        self._pointing.chose()
        if self._side.visible:
            ui.timer(0.0, self._fill_settings, once=True)

    async def _name_cameras(self) -> None:
        """Ask the cameras whose names are not known, one after another."""
        robot = self._robot
        if robot is None or self._naming or not self._unnamed:
            return
        self._naming = True
        try:
            for id in sorted(self._unnamed):
                with suppress(JausError):
                    name = await sensor_name(robot.component(id))
                    if self._robot is not robot or id not in self._captions:
                        return
                    self._captions[id].set_text(f"{printable(name)}  {id}")
                    self._unnamed.discard(id)
        finally:
            self._naming = False

    def _camera(self) -> SharedCamera | None:
        component = self._component()
        return None if component is None else self._console.camera(component.id)

    def _component(self) -> ComponentInfo | None:
        components = self._robot.components if self._robot is not None else ()
        return next((component for component in components if str(component.id) == self._chosen), None)

    def _toggle_overlay(self) -> None:
        plain = "plain" not in self._figures_place.classes
        self._figures_place.classes(add="plain" if plain else "", remove="" if plain else "plain")
        self._overlay.classes(add="off" if plain else "", remove="" if plain else "off")

    # --- still images and recordings ------------------------------------------------------------------------------

    async def _take_still(self) -> None:
        """Take a still from the robot's StillImage service; otherwise the picture that is shown."""
        robot, component = self._robot, self._component()
        if robot is None or component is None:
            return
        name = f"{component.id}-{datetime.now().astimezone():%Y%m%d-%H%M%S}"
        if component.find("StillImage") is None:
            call("jauspy.video.save", str(component.id), f"{name}.png")
            self._said.set_text(_("saved the picture that is shown as {name}.png", name=name))
            return
        self._said.set_text(_("taking a picture …"))
        self._still.disable()
        try:
            photo = await robot.component(str(component.id)).camera.still()
        except JausError as error:
            self._said.set_text(printable(translated(str(error))))
        else:
            suffix = {"JPEG": "jpg"}.get(photo.format, photo.format.lower())
            suffix = suffix if suffix.isalnum() else "bin"
            ui.download.content(photo.content, f"{name}.{suffix}")
            self._said.set_text(
                _("saved {name}.{suffix}, {size} kB", name=name, suffix=suffix, size=len(photo.content) // 1000)
            )
        finally:
            self._still.enable()

    async def _toggle_recording(self) -> None:
        camera = self._camera()
        if camera is None:
            return
        if camera.recording is not None and not camera.recording.ended:
            await camera.stop_recording()
            self._said.set_text(translated(camera.recording.summary))
            return
        try:
            camera.record(self._console.recordings)
        except JausError as error:
            self._said.set_text(translated(str(error)))
        else:
            self._said.set_text("")
        self._update()

    def _update(self) -> None:
        """Show the recordings, which are common to all browsers; each browser can stop them."""
        camera = self._camera()
        recording = camera.recording if camera is not None else None
        running = recording is not None and not recording.ended
        self._record.set_text(_("stop recording") if running else _("record"))
        text = ""
        if recording is not None and running:
            text = f"● {recording.seconds // 60}:{recording.seconds % 60:02} {recording.size / 1e6:.1f} MB"
            if self._said.text == "":
                self._said.set_text(_("recording to {path}", path=recording.path))
        elif recording is not None and recording.problem:
            self._said.set_text(translated(recording.summary))
        self._recorded.set_text(text)

    # --- settings ---------------------------------------------------------------------------------------------------

    async def _toggle_settings(self) -> None:
        self._side.set_visibility(not self._side.visible)
        if self._side.visible:
            await self._fill_settings()

    async def _fill_settings(self) -> None:
        """Show what the camera and the lights offer."""
        robot, chosen = self._robot, self._chosen
        if robot is None or not chosen or self._filling:
            return
        self._filling = True
        try:
            ids = [chosen] + [
                str(component.id)
                for component in robot.components
                if component.find(LIGHTS) and str(component.id) != chosen
            ]
            found = [(id, *await read_settings(robot.component(id))) for id in ids]
        finally:
            self._filling = False
        if (robot, chosen) != (self._robot, self._chosen):
            return
        self._side.clear()
        heading = ""
        with self._side:
            for id, settings, problems in found:
                for setting in settings:
                    if HEADINGS.get(setting.service, heading) != heading:
                        heading = HEADINGS[setting.service]
                        ui.label(heading).classes("heading")
                    self._add_setting(id, setting)
                for problem in problems:
                    ui.label(printable(translated(problem))).classes("problem")
            if not heading:
                ui.label(_("this camera offers no settings")).classes("hint")
            self._refused = ui.label("").classes("problem")

    def _add_setting(self, id: str, setting: Setting) -> None:
        async def change(event: events.ValueChangeEventArguments[Any]) -> None:
            await self._set(id, setting, event.value)

        label = printable(translated(setting.label))
        if setting.choices is not None and set(setting.choices.values()) == {"off", "on"}:
            ui.switch(label, value=bool(setting.value), on_change=change).props("dense left-label")
        elif setting.choices is not None:
            value = setting.value if setting.value in setting.choices else None
            choices = {code: translated(text) for code, text in setting.choices.items()}
            choice = ui.select(choices, label=label, value=value, on_change=change)
            choice.props("dense outlined options-dense")
        else:
            with ui.element("div").classes("setting-name"):
                ui.label(label)
                shown = ui.label()
            slider = ui.slider(min=setting.low, max=setting.high, step=setting.step, value=setting.value or 0)
            shown.bind_text_from(slider, "value", lambda value: f"{value:g} {setting.unit}".rstrip())
            attributes(slider, aria_label=label).on("change", lambda: self._set(id, setting, slider.value))

    async def _set(self, id: str, setting: Setting, value: float | None) -> None:
        robot = self._robot
        if robot is None or value is None:
            return
        self._refused.set_text("")
        operation = self._console.operation(robot.id)
        try:
            if not self._user.may_operate:
                raise RequestError(
                    sentence("your role is {role}: you may watch and save pictures only", role=self._user.role)
                )
            if operation is not None and operation.operator not in ("", self._token):
                raise RequestError(sentence("another browser operates this robot"))
            authority = min(DEFAULT_AUTHORITY, self._user.authority)
            await write_setting(robot.component(id), setting, float(value), authority=authority)
        except JausError as error:
            said = printable(f"{translated(setting.label)}: {translated(str(error))}")
            await self._fill_settings()
            self._refused.set_text(said)
            return
        chosen = (setting.choices or {}).get(int(value), f"{value:g}")
        self._console.note(sentence("{id}: {setting} was set to {value}", id=id, setting=setting.label, value=chosen))
        if setting.field.endswith("_mode") or setting.field == "frame_size":  # others appear, or go
            await self._fill_settings()


def _button(text: str, action: events.Handler[events.ClickEventArguments], tip: str) -> ui.button:
    return ui.button(text, on_click=action, color=None).props("outline no-caps dense").tooltip(tip)
