"""The card Sound: what the robot's microphone hears, and announcements on its loudspeaker.

Browsers do not play RTP: the console receives it, and sends an endless WAV file (`listening.py`), which the browser's
own control plays, with its volume and mute. There is no talking: announcements are files.
"""

from __future__ import annotations

import asyncio
import tempfile
from pathlib import Path
from typing import Final

from nicegui import background_tasks, ui
from nicegui.events import UploadEventArguments

from jauspy.console.console import Console
from jauspy.console.languages import sentence
from jauspy.console.listening import SILENT
from jauspy.console.markup import attributes
from jauspy.console.page_language import _, translated
from jauspy.console.trajectory import MAX_FILE, not_taken
from jauspy.console.users import User
from jauspy.errors import JausError
from jauspy.ids import JausID
from jauspy.ocu.control import DEFAULT_AUTHORITY
from jauspy.ocu.robot import Robot
from jauspy.ocu.sound import ANNOUNCER, MICROPHONE
from jauspy.printable import printable

UPDATE_INTERVAL: Final = 0.2


class SoundCard:
    """Listening with a level meter, and a file for the loudspeaker; hidden for robots without sound."""

    def __init__(self, console: Console, token: str, user: User) -> None:
        self._console, self._token, self._user = console, token, user
        self._robot: Robot | None = None
        self._hears: JausID | None = None
        self._playing = ""
        self._said = ""
        self._task: asyncio.Task[None] | None = None
        with ui.element("section").classes("card sound") as self._card:
            attributes(self._card, aria_label=_("Sound"))
            with ui.element("div").classes("row"):
                ui.label(_("Sound")).classes("heading")
                self._state = ui.label("").classes("state grow").props('role="status"')
            with ui.element("div").classes("listen") as self._ear:
                with ui.element("div").classes("row start"):
                    self._listen = ui.button(_("listen"), on_click=self._toggle).props("unelevated no-caps")
                    self._level = ui.linear_progress(0.0, show_value=False, size="8px").classes("grow")
                    attributes(self._level, aria_label=_("loudness"))
                    self._decibels = ui.label("").classes("hint level")
                self._player = ui.element("div")
            with ui.element("div").classes("row start") as self._mouth:
                self._upload = ui.upload(on_upload=self._announce, auto_upload=True, max_file_size=MAX_FILE)
                self._upload.props('accept=".wav"').classes("hidden").on_rejected(self._rejected)
                announce = ui.button(_("announce a WAV file")).props("outline no-caps")
                self._pick = announce.on("click", js_handler="() => jauspy.pickFile('.sound')")
                self._end = ui.button(_("stop"), on_click=self._stop).props("outline no-caps color=negative")
                attributes(self._end, aria_label=_("stop the announcement"))
            ui.label(_("up to {most} kB: 10 s at 48 kHz, a minute at 8 kHz", most=MAX_FILE >> 10)).classes("hint")
            self._problem = ui.label("").classes("problem").props('role="alert"')
        self._card.set_visibility(False)
        ui.timer(UPDATE_INTERVAL, self._update)

    def show(self, robot: Robot | None) -> None:
        """Offer the sound of this robot."""
        self._silence()
        self._stop()
        self._robot, self._said = robot, ""
        self._hears = None if robot is None else next((part.id for part in robot.info.offering(MICROPHONE)), None)
        speaks = robot is not None and any(robot.info.offering(ANNOUNCER))
        self._ear.set_visibility(self._hears is not None)
        self._mouth.set_visibility(speaks)
        self._card.set_visibility(speaks or self._hears is not None)

    def close(self) -> None:
        """Handle the end of the page."""
        self._stop()
        self._console.levels.forget(self._token)
        self._robot = None

    # --- listening

    def _toggle(self) -> None:
        if self._player.default_slot.children:
            self._silence()
        elif self._hears is not None:
            self._console.levels.problems.pop(self._token, None)
            with self._player:
                ui.audio(f"/sound/{self._hears}/{self._token}", autoplay=True).classes("player")

    def _silence(self) -> None:
        self._player.clear()  # the browser ends the stream

    # --- announcing

    async def _announce(self, event: UploadEventArguments) -> None:
        data, name = await event.file.read(), printable(event.file.name)
        self._upload.reset()
        robot = self._robot
        if robot is None or self._task is not None:
            return
        if not self._user.may_operate:
            self._said = sentence("{user} may only observe ({role})", user=self._user.name, role=self._user.role)
            return
        self._said, self._playing = "", name
        self._task = background_tasks.create(self._play(robot, data), name=f"console: announcement by {robot.id}")

    def _rejected(self) -> None:
        self._said = not_taken(".wav")

    async def _play(self, robot: Robot, data: bytes) -> None:
        try:
            with tempfile.TemporaryDirectory(prefix="jauspy-announce-") as folder:
                path = Path(folder) / "announcement.wav"
                await asyncio.to_thread(path.write_bytes, data)
                self._console.act(sentence("robot {robot} announces {playing}", robot=robot.id, playing=self._playing))
                seconds = await robot.announcer.play(path, authority=min(DEFAULT_AUTHORITY, self._user.authority))
                self._said = sentence("played {seconds:.1f} s of {playing}", seconds=seconds, playing=self._playing)
        except JausError as error:
            self._said = str(error).replace(str(path), self._playing)
        finally:
            self._playing, self._task = "", None

    def _stop(self) -> None:
        if self._task is not None:
            self._task.cancel()

    def _update(self) -> None:
        if self._robot is None or not self._card.visible:
            return
        levels = self._console.levels
        level, problem = levels.of(self._token), levels.problems.get(self._token, "")
        if problem:
            self._silence()
        self._listen.set_text(_("mute") if self._player.default_slot.children else _("listen"))
        self._level.set_value(0.0 if level is None else round(1.0 - level / SILENT, 3))
        self._decibels.set_text("" if level is None else f"{level:.0f} dB")
        self._pick.set_enabled(self._task is None and self._user.may_operate)
        self._end.set_visibility(self._task is not None)
        self._state.set_text(_("plays {playing}", playing=self._playing) if self._playing else translated(self._said))
        self._problem.set_text(translated(problem))
