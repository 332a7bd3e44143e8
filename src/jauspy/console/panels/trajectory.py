"""The tab Trajectory: rows of joint positions with times; play, step, stop, save, load, export as a program."""

from __future__ import annotations

import copy
import math
from collections.abc import Callable
from functools import partial
from typing import Final

from nicegui import ui
from nicegui.events import UploadEventArguments, ValueChangeEventArguments

from jauspy.console.confirmation import confirmed
from jauspy.console.console import Console
from jauspy.console.languages import sentence
from jauspy.console.manipulators import JointInfo, Manipulator, joint_label, manipulators
from jauspy.console.markup import attributes, style_number
from jauspy.console.motion import Motion
from jauspy.console.page_language import _, translated
from jauspy.console.saved_files import SavedByOther, SavedFiles, checked_name
from jauspy.console.trajectory import MAX_FILE, MAX_SECONDS, Trajectory, TrajectoryRow, is_modular, not_taken
from jauspy.errors import ConfigError, JausError
from jauspy.ocu.robot import Robot
from jauspy.printable import printable

UPDATE_INTERVAL: Final = 0.25
"""Seconds between two updates of the motion."""
DEFAULT_NAME: Final = "trajectory"


class TrajectoryPanel:
    """The editor of one page, which `token` names."""

    def __init__(self, console: Console, token: str) -> None:
        self._console = console
        self._robot: Robot | None = None
        self._arms: dict[str, Manipulator] = {}
        self._joints: tuple[JointInfo, ...] = ()
        self._rows: list[ui.element] = []
        self._next = 0
        """The row that the next step moves to."""
        self._active = -1
        self._problem_here = ""
        self._motion = Motion(console, token)
        self.trajectory = Trajectory()
        self._loaded: tuple[int, str, Trajectory] | None = None
        """The robot, name and content of the file that was loaded or saved last."""
        with ui.element("div").classes("choice"):
            self._choice = ui.select({}, label=_("arm"), on_change=self._choose).props("dense outlined options-dense")
            self._choice.classes("wide named")
            self._name = ui.input(_("name"), value=DEFAULT_NAME).props("dense outlined").classes("wide")
            self._saved = ui.select([], label=_("saved"), on_change=self._load)
            self._saved.props("dense outlined options-dense").classes("wide")
            ui.button(_("save"), on_click=self._save).props("outline no-caps")
            ui.button(_("delete"), on_click=self._delete).props("flat no-caps")
            self._author = ui.label("").classes("hint")
        self._table = ui.element("div").classes("rows").props('role="table"')
        self._problem = ui.label("").classes("problem").props('role="status"')
        with ui.element("div").classes("row"):
            self._add = ui.button(_("add present positions"), on_click=self._add_present).props("outline no-caps")
            self._progress = ui.label("").classes("hint grow")
            self._play = ui.button(_("play"), on_click=self._play_all).props("unelevated no-caps")
            self._step = ui.button(_("step"), on_click=self._play_one).props("outline no-caps")
            self._stop = ui.button(_("stop"), on_click=self._motion.stop).props("outline no-caps color=negative")
        with ui.element("div").classes("row"):
            ui.label(_("0 s: as fast as the limits allow")).classes("hint grow")
            self._upload = ui.upload(on_upload=self._upload_file, auto_upload=True, max_file_size=MAX_FILE)
            self._upload.props('accept=".json"').classes("hidden").on_rejected(self._rejected)
            ui.button(_("upload")).props("outline no-caps dense").on(
                "click", js_handler="() => jauspy.pickFile('.trajectory')"
            )
            ui.button(_("download"), on_click=self._download).props("outline no-caps dense")
            ui.button(_("export as Python"), on_click=self._export).props("outline no-caps dense")
        self._render()
        ui.timer(UPDATE_INTERVAL, self._update)

    def show(self, robot: Robot | None) -> None:
        """Offer the arms of this robot."""
        self._motion.stop()
        self._robot = robot
        self._arms = manipulators(robot) if robot is not None else {}
        self._choice.set_options({id: arm.title for id, arm in self._arms.items()}, value=next(iter(self._arms), None))
        self._show_saved()

    def close(self) -> None:
        """Handle the end of the page."""
        self._motion.stop()
        self._robot = None

    @property
    def _arm(self) -> Manipulator | None:
        return self._arms.get(str(self._choice.value))

    async def _choose(self) -> None:
        """Handle the choice of another arm: rows of other joints are dropped."""
        self._motion.stop()
        arm, self._problem_here = self._arm, ""
        try:
            self._joints = await arm.joints() if arm is not None else ()
        except JausError as error:
            self._joints, self._problem_here = (), str(error)
        if self.trajectory.joints != tuple(joint.name for joint in self._joints):
            self._take(Trajectory(tuple(joint.name for joint in self._joints)))

    # --- rows -------------------------------------------------------------------------------------------------------

    def _take(self, trajectory: Trajectory) -> None:
        self.trajectory = trajectory
        self._loaded = None
        self._author.set_text("")
        self._next, self._active = 0, -1
        self._render()

    def _render(self) -> None:
        self._table.clear()
        self._rows = []
        joints, units = self.trajectory.joints, {joint.name: joint.unit for joint in self._joints}
        style_number(self._table, "joints", len(joints))
        with self._table:
            with ui.element("div").classes("line head").props('role="row"'):
                for text in ("", "s", *joints):
                    unit = f" [{units[text]}]" if text in units else ""
                    ui.label(joint_label(text)).classes("joint").tooltip(f"{printable(text)}{unit}")
            if not self.trajectory.rows:
                ui.label(_("Move the arm, then add its present positions as a row.")).classes("hint empty")
            for index, row in enumerate(self.trajectory.rows):
                with ui.element("div").classes("line").props('role="row"') as line:
                    self._rows.append(line)
                    begin = ui.button(str(index + 1), on_click=lambda index=index: self._start_at(index))
                    attributes(begin.props("flat dense"), aria_label=_("next is row {number}", number=index + 1))
                    _field(row.seconds, _("seconds of row {number}", number=index + 1), partial(_set_time, row))
                    for number, name in enumerate(joints):
                        label = _("{name} of row {number}", name=printable(name), number=index + 1)
                        _field(
                            row.positions[number],
                            label,
                            partial(_set_position, row, number),
                        )
                    with ui.element("div").classes("acts"):
                        for sign, what in (
                            ("\u2191", "up"),
                            ("\u2193", "down"),
                            ("\u21bb", "present"),
                            ("\u00d7", "delete"),
                        ):
                            act = ui.button(sign, on_click=lambda index=index, what=what: self._change(index, what))
                            act.props("flat dense").tooltip(translated(_ACTS[what]))
                            label = _("{act} row {number}", act=_ACTS[what], number=index + 1)
                            attributes(act, aria_label=label)
        self._mark()

    def _mark(self) -> None:
        for index, line in enumerate(self._rows):
            line.classes(
                add="active" if index == self._active else "", remove="" if index == self._active else "active"
            )
            line.classes(add="next" if index == self._next else "", remove="" if index == self._next else "next")

    def _start_at(self, index: int) -> None:
        self._next = index
        self._mark()

    async def _change(self, index: int, what: str) -> None:
        rows = self.trajectory.rows
        if self._motion.is_running or index >= len(rows):
            return
        if what == "delete":
            del rows[index]
        elif what == "present":
            positions = await self._present()
            if positions is not None:
                rows[index].positions = positions
        else:
            self.trajectory.move(index, -1 if what == "up" else 1)
        self._next = min(self._next, max(0, len(rows) - 1))
        self._render()

    async def _present(self) -> list[float] | None:
        arm = self._arm
        if arm is None:
            self._problem_here = sentence("this robot has no arm")
            return None
        try:
            now = await arm.positions()
        except JausError as error:
            self._problem_here = str(error)
            return None
        if not self.trajectory.rows:
            self._joints = await arm.joints()
            self.trajectory.joints = tuple(now)
        if missing := [name for name in self.trajectory.joints if name not in now]:
            self._problem_here = sentence("the arm has no joint {joint} now", joint=missing[0])
            return None
        return [round(now[name], 3) + 0.0 for name in self.trajectory.joints]

    async def _add_present(self) -> None:
        self._problem_here = self._motion.problem = ""
        positions = await self._present()
        if positions is None:
            return
        try:
            self.trajectory.add(positions)
        except ConfigError as error:
            self._problem_here = str(error)
        self._render()

    # --- playing ----------------------------------------------------------------------------------------------------

    async def _play_all(self) -> None:
        await self._begin(0, len(self.trajectory.rows))

    async def _play_one(self) -> None:
        if await self._begin(self._next, self._next + 1):
            self._next = (self._next + 1) % max(1, len(self.trajectory.rows))
            self._mark()

    async def _begin(self, start: int, end: int) -> bool:
        """Play these rows; False, with a problem shown, if nothing moves."""
        arm, trajectory = self._arm, self.trajectory
        self._problem_here = self._motion.problem = ""
        if arm is None or self._robot is None:
            self._problem_here = sentence("this robot has no arm")
            return False
        part = Trajectory(trajectory.joints, trajectory.rows[start:end])
        try:
            problem = part.problem(await arm.joints(), await arm.positions(), start + 1)
        except JausError as error:
            problem = str(error)
        if problem:
            self._problem_here = problem
            return False
        self._motion.begin(arm.robot.id, self._play_rows(arm, part, start), sentence("the trajectory"))
        self._problem_here = self._change_since_loaded()
        return not self._motion.problem

    def _change_since_loaded(self) -> str:
        """A sentence if the file has another content than the rows that are shown, and played."""
        if (files := self._files()) is None or self._robot is None or self._loaded is None:
            return ""
        robot, name, loaded = self._loaded
        if robot != self._robot.id or self.trajectory.rows != loaded.rows:
            return ""
        try:
            now = files.trajectory(name)
        except ConfigError:
            return sentence("{name} was deleted since it was loaded; the rows shown here are played", name=name)
        changed = sentence(
            "{name} was changed ({author}) since it was loaded; the rows shown here are played",
            name=name,
            author=now.author,
        )
        return "" if now == loaded else changed

    async def _play_rows(self, arm: Manipulator, part: Trajectory, start: int) -> None:
        def progress(number: int) -> None:
            self._active = start + number

        try:
            await arm.follow(part.named(), progress)
        finally:
            self._active = -1

    def _update(self) -> None:
        running = self._motion.is_running
        refused = self._motion.refusal(self._robot.id) if self._robot is not None else sentence("no robot")
        self._play.set_enabled(not running and not refused)
        self._step.set_enabled(not running and not refused)
        self._stop.set_enabled(running)
        self._mark()
        total = sum(row.seconds for row in self.trajectory.rows)
        count = len(self.trajectory.rows)
        rows = (
            _("1 row, {total:g} s", total=total)
            if count == 1
            else _("{count} rows, {total:g} s", count=count, total=total)
        )
        self._progress.set_text(
            _("row {number} of {count}", number=self._active + 1, count=count)
            if running and self._active >= 0
            else rows
        )
        said = (
            self._problem_here
            or self._motion.problem
            or (sentence("to play: {refused}", refused=refused) if refused and count else "")
        )
        self._problem.set_text(printable(translated(said)))

    # --- files ------------------------------------------------------------------------------------------------------

    def _files(self) -> SavedFiles | None:
        return None if self._robot is None else self._console.files(self._robot)

    def _show_saved(self) -> None:
        files = self._files()
        self._saved.set_options(files.trajectories() if files is not None else [], value=None)

    def _keep(self, name: str) -> None:
        """Remember what the file has, to notice when somebody else changes it."""
        assert self._robot is not None
        self._loaded = self._robot.id, name, copy.deepcopy(self.trajectory)

    async def _save(self) -> None:
        files, self._problem_here = self._files(), ""
        if files is None or self._robot is None:
            return
        name, robot = str(self._name.value or ""), self._robot.name
        try:
            try:
                files.save_trajectory(name, self.trajectory, robot)
            except SavedByOther as other:
                if not await confirmed(_("{other}. Replace it?", other=other), _("replace")):
                    return
                files.save_trajectory(name, self.trajectory, robot, seen=other.author)
        except ConfigError as error:
            self._problem_here = str(error)
            return
        self._keep(name)
        self._show_saved()

    def _load(self) -> None:
        files, name = self._files(), self._saved.value
        if files is None or not name:
            return
        self._problem_here = ""
        try:
            self._take(files.trajectory(str(name)))
        except ConfigError as error:
            self._problem_here = str(error)
            return
        self._keep(str(name))
        self._name.set_value(str(name))
        self._author.set_text(translated(str(self.trajectory.author)))

    async def _delete(self) -> None:
        files, name = self._files(), str(self._name.value or "")
        if files is None:
            return
        try:
            try:
                files.delete_trajectory(name)
            except SavedByOther as other:
                if not await confirmed(_("{other}. Delete it?", other=other), _("delete")):
                    return
                files.delete_trajectory(name, seen=other.author)
        except ConfigError as error:
            self._problem_here = str(error)
        self._show_saved()

    async def _upload_file(self, event: UploadEventArguments) -> None:
        self._problem_here = ""
        try:
            self._take(Trajectory.from_json(await event.file.read(), printable(event.file.name)))
        except ConfigError as error:
            self._problem_here = str(error)
        self._upload.reset()

    def _rejected(self) -> None:
        self._problem_here = not_taken(".json")

    def _download(self) -> None:
        text = self.trajectory.to_json(self._robot.name if self._robot is not None else "")
        ui.download.content(text, f"{self._file_name()}.json", "application/json")

    def _export(self) -> None:
        arm = self._arm
        if arm is None or not self.trajectory.rows:
            self._problem_here = sentence("there are no rows to export")
            return
        program = self.trajectory.program(arm.robot.id, str(arm.info.id), modular=is_modular(arm))
        ui.download.content(program, f"{self._file_name()}.py", "text/x-python")

    def _file_name(self) -> str:
        try:
            return checked_name(str(self._name.value or "")).replace(" ", "_")
        except ConfigError:
            return DEFAULT_NAME


_ACTS: Final = {
    "up": sentence("move up"),
    "down": sentence("move down"),
    "present": sentence("set to the present positions:"),
    "delete": sentence("delete"),
}


def _field(value: float, label: str, on_change: Callable[[ValueChangeEventArguments[float | None]], None]) -> None:
    field = ui.number(value=value, step=0.01, format="%.3f", on_change=on_change)
    attributes(field.props('dense borderless hide-bottom-space input-class="text-right"'), aria_label=label)


def _set_time(row: TrajectoryRow, event: ValueChangeEventArguments[float | None]) -> None:
    if event.value is not None and 0.0 <= event.value <= MAX_SECONDS:
        row.seconds = float(event.value)


def _set_position(row: TrajectoryRow, number: int, event: ValueChangeEventArguments[float | None]) -> None:
    if event.value is not None and math.isfinite(event.value):
        row.positions[number] = float(event.value)
