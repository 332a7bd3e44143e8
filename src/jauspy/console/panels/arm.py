"""The panel Arm: a slider for each joint, the tool along and about axes, named poses, and the gripper."""

from __future__ import annotations

import math
from collections.abc import Coroutine
from typing import Any, Final

from nicegui import ui

from jauspy.console.confirmation import confirmed
from jauspy.console.console import Console
from jauspy.console.languages import sentence
from jauspy.console.manipulators import JointInfo, Manipulator, joint_label, manipulators
from jauspy.console.markup import attributes, plain_text, style_number
from jauspy.console.motion import MAX_SPEED, MAX_TURN, Motion
from jauspy.console.page_language import _, translated
from jauspy.console.panels.gripper import GripperPanel
from jauspy.console.panels.wanted_posture import WantedPosture
from jauspy.console.saved_files import Pose, SavedByOther, SavedFiles
from jauspy.errors import JausError
from jauspy.ocu.robot import Robot
from jauspy.printable import printable

UPDATE_INTERVAL: Final = 0.25
"""Seconds between two updates of the joints."""
VIEWS: Final = {"joints": sentence("joints"), "tool": sentence("tool"), "poses": sentence("poses")}
AXES: Final = (("x", "I", "K"), ("y", "J", "L"), ("z", "U", "O"))
"""Axes with the keys that move along them, and, with Shift, turn about them."""
TURNS: Final = (sentence("roll"), sentence("pitch"), sentence("yaw"))
MAX_ROBOT_POSES: Final = 64
"""Poses of the robot that are shown."""
AT_LIMIT: Final = 0.02
"""Radians or metres from a limit at which a joint is shown as being there."""
NEAR: Final = 0.005
"""Radians or metres by which a measured position may differ before the wanted one follows it."""


class ArmPanel:
    """The arms and the gripper of the chosen robot, for one page, which `token` names."""

    def __init__(self, console: Console, token: str) -> None:
        self._console = console
        self._robot: Robot | None = None
        self._arms: dict[str, Manipulator] = {}
        self._arm: Manipulator | None = None
        self._joints: tuple[JointInfo, ...] = ()
        self._robot_poses: tuple[str, ...] = ()
        """The poses that the robot knows for the arm."""
        self._rows: dict[str, _JointRow] = {}
        self._motion = Motion(console, token)
        with ui.element("section").classes("panel arm") as self._panel:
            with ui.element("div").classes("row"):
                ui.label(_("Arm")).classes("heading")
                self._view = ui.toggle(
                    {name: translated(label) for name, label in VIEWS.items()}, value="joints"
                ).props("no-caps dense unelevated")
            self._choice = ui.select({}, on_change=self._choose).props("dense outlined options-dense")
            attributes(self._choice, aria_label=_("arm"))
            with ui.element("div").bind_visibility_from(self._view, "value", value="joints"):
                self._sliders = ui.element("div").classes("joints")
                self._wanted = WantedPosture(console, token)
                with ui.element("div").classes("row"):
                    self._move = ui.button(_("move"), on_click=self._move_joints).props("unelevated no-caps")
                    self._reset = ui.button(_("reset"), on_click=self._follow_measured).props("flat no-caps dense")
                    self._share = _slider(_("speed"), (5, 100, 5), 50, "%")
            with ui.element("div").bind_visibility_from(self._view, "value", value="tool"):
                self._build_tool()
            with ui.element("div").bind_visibility_from(self._view, "value", value="poses"):
                self._poses = ui.element("div").classes("poses")
                with ui.element("div").classes("row"):
                    self._name = ui.input(_("name of the present pose")).props("dense outlined").classes("grow")
                    ui.button(_("save"), on_click=self._save_pose).props("outline no-caps")
            self._stop = ui.button(_("stop"), on_click=self._motion.stop).props("outline no-caps color=negative")
            self._problem = ui.label("").classes("problem").props('role="status"')
        self._panel.set_visibility(False)
        self._gripper = GripperPanel(console, token)
        ui.timer(UPDATE_INTERVAL, self._update)

    def show(self, robot: Robot | None) -> None:
        """Show the arms of this robot; nothing if it has none."""
        self._motion.stop()
        self._robot = robot
        self._wanted.show(robot)
        self._gripper.show(robot)
        self._take(manipulators(robot) if robot is not None else {})

    def close(self) -> None:
        """Handle the end of the page."""
        self._motion.stop()
        self._gripper.close()
        self._robot = None

    # --- which arm ------------------------------------------------------------------------------------------------

    def _take(self, arms: dict[str, Manipulator]) -> None:
        chosen = self._choice.value if self._choice.value in arms else next(iter(arms), None)
        self._arms = arms
        self._panel.set_visibility(bool(arms))
        self._choice.set_options({id: self._title(arm) for id, arm in arms.items()}, value=chosen)
        self._choice.set_visibility(len(arms) > 1)
        self._choose()

    def _title(self, arm: Manipulator) -> str:
        """What the component moves, as `flippers`, with its name and id."""
        part = self._console.names.of(arm.info)
        return f"{part}  {arm.title}" if part and part != arm.info.name else arm.title

    def _choose(self) -> None:
        arm = self._arms.get(str(self._choice.value))
        if arm is self._arm:
            return
        self._motion.stop()
        self._arm, self._joints, self._robot_poses = arm, (), ()
        self._show_joints((), {})
        has_tool = arm is not None and arm.has_tool
        attributes(self._jog, data_component=str(arm.info.id) if arm is not None and has_tool else "")
        self._jog.set_visibility(has_tool)
        self._no_tool.set_visibility(not has_tool)
        self._share.set_visibility(arm is not None and arm.has_speed)
        self._show_poses()

    def _look_for_changes(self) -> None:
        """Rebuild the panel when arms have appeared or disappeared."""
        found = self._console.fleet.robots.get(self._robot.id) if self._robot is not None else None
        if found is not None:
            arms = manipulators(found)
            titles = {id: self._title(arm) for id, arm in arms.items()}
            if arms.keys() != self._arms.keys() or titles != self._choice.options:
                self._robot = found
                self._take(arms)

    # --- joints ---------------------------------------------------------------------------------------------------

    async def _update(self) -> None:
        self._look_for_changes()
        arm = self._arm
        if arm is None:
            return
        refused = self._motion.refusal(arm.robot.id)
        self._move.set_enabled(bool(self._rows) and not refused and not self._motion.is_running)
        self._stop.set_visibility(self._motion.is_running)
        self._problem.set_text(printable(translated(self._motion.problem)))
        try:
            positions = await arm.positions()
            if positions.keys() != {joint.name for joint in self._joints} or not self._joints:
                joints, poses = await arm.joints(), await arm.poses()
                if arm is self._arm:
                    self._robot_poses = poses
                    self._show_joints(joints, positions)
            tool = await arm.tool() if self._view.value == "tool" else ""
        except JausError as error:
            self._problem.set_text(printable(translated(str(error))))
            return
        if arm is not self._arm:
            return
        self._pose.set_text(tool)
        for name, row in self._rows.items():
            if name in positions:
                row.measured(positions[name])
        self._wanted.update({name: row.wanted for name, row in self._rows.items() if row.touched})

    def _show_joints(self, joints: tuple[JointInfo, ...], positions: dict[str, float]) -> None:
        self._joints = joints
        self._sliders.clear()
        with self._sliders:
            self._rows = {joint.name: _JointRow(joint, positions.get(joint.name, 0.0)) for joint in joints}
            if not joints:
                ui.label(_("no joints now")).classes("hint")
        self._show_poses()

    def _follow_measured(self) -> None:
        for row in self._rows.values():
            row.touched = False

    def _follow_reached(self, wanted: dict[str, float]) -> None:
        """Set the wanted positions to the measured ones after a motion, unless the user has changed them."""
        for name, value in wanted.items():
            if name in self._rows and self._rows[name].wanted == value:
                self._rows[name].touched = False

    def _move_joints(self) -> None:
        wanted = {name: row.wanted for name, row in self._rows.items() if row.touched}
        if not wanted:
            self._motion.problem = sentence("move a slider first, or enter a position")
            return
        self._go(wanted, sentence("the motion"))

    def _go(self, wanted: dict[str, float], what: str) -> None:
        arm = self._arm
        if arm is not None:
            self._motion.begin(arm.robot.id, self._moved(arm, wanted), what)

    async def _moved(self, arm: Manipulator, wanted: dict[str, float]) -> None:
        await arm.move(wanted, float(self._share.value) / 100.0)
        self._follow_reached(wanted)

    # --- tool -----------------------------------------------------------------------------------------------------

    def _build_tool(self) -> None:
        self._no_tool = ui.label(_("this arm takes no velocities or poses of its tool")).classes("hint")
        with ui.element("div").classes("jog").props('data-frame="robot"') as self._jog:
            with ui.element("div").classes("row"):
                ui.label(_("frame")).classes("hint")
                frames = {"robot": _("base"), "tool": _("tool")}
                ui.toggle(
                    frames, value="robot", on_change=lambda event: attributes(self._jog, data_frame=str(event.value))
                ).props("no-caps dense unelevated")
                ui.label(_("hold; Shift: turn")).classes("hint")
            self._pose = ui.label("").classes("pose")
            with ui.element("div").classes("pad"):
                for number, (axis, plus, minus) in enumerate(AXES):
                    _jog_button(f"{axis} \u2212", number, -1, minus)
                    _jog_button(f"{axis} +", number, 1, plus)
                    turn = translated(TURNS[number])
                    _jog_button(f"{turn} \u2212", number + 3, -1, f"\u21e7{minus}")
                    _jog_button(f"{turn} +", number + 3, 1, f"\u21e7{plus}")
            with ui.element("div").classes("row"):
                linear = _slider(_("linear"), (10, round(1000 * MAX_SPEED), 10), 50, "mm/s")
                linear.on_value_change(lambda event: attributes(self._jog, data_linear=event.value / 1000.0))
                angular = _slider(_("angular"), (2, math.floor(math.degrees(MAX_TURN)), 1), 15, "\u00b0/s")
                angular.on_value_change(lambda event: attributes(self._jog, data_angular=math.radians(event.value)))
            attributes(self._jog, data_linear=0.05, data_angular=math.radians(15.0))
            ui.html('<span class="jog-answer problem" role="status"></span>', sanitize=False)

    # --- poses ----------------------------------------------------------------------------------------------------

    def _files(self) -> SavedFiles | None:
        return None if self._robot is None else self._console.files(self._robot)

    def _show_poses(self) -> None:
        self._poses.clear()
        files, arm = self._files(), self._arm
        if files is None or arm is None:
            return
        id = str(arm.info.id)
        try:
            poses = files.poses(id)
        except JausError as error:
            poses, self._motion.problem = {}, str(error)
        with self._poses:
            given = self._given_poses()
            if not poses and not given and not self._robot_poses:
                ui.label(_("no poses yet")).classes("hint")
            for name in self._robot_poses[:MAX_ROBOT_POSES]:
                self._add_robot_pose(name, arm)
            if left_out := len(self._robot_poses[MAX_ROBOT_POSES:]):
                ui.label(_("further poses of the robot: {left_out}", left_out=left_out)).classes("hint")
            for name, positions in given.items():
                with ui.element("div").classes("row"):
                    ui.label(name).classes("grow").tooltip(_("of the file that the console was started with"))
                    self._add_go(name, positions)
            for name, pose in poses.items():
                with ui.element("div").classes("row"):
                    ui.label(name).classes("grow").tooltip(translated(str(pose.author)))
                    self._add_go(name, pose.positions, pose)
                    delete = ui.button("\u00d7", on_click=lambda name=name: self._delete_pose(name))
                    attributes(delete.props("flat dense"), aria_label=_("delete {name}", name=name))
            if left_out := len(self._console.poses.get(self._robot_name, {})) - len(given):
                ui.label(_("poses of the file for other joints: {left_out}", left_out=left_out)).classes("hint")

    def _add_robot_pose(self, name: str, arm: Manipulator) -> None:
        """A row of a pose that the robot knows: it chooses the way."""
        shown = printable(name)

        def begin(motion: Coroutine[Any, Any, Any], joints: str) -> None:
            self._motion.begin(
                arm.robot.id, motion, sentence("the motion of {joints} to {pose}", joints=joints, pose=shown)
            )

        with ui.element("div").classes("row"):
            ui.label(shown).classes("grow").tooltip(_("of the robot, which finds a way without contact"))
            go = ui.button(_("go"), on_click=lambda: begin(arm.move_to(name), sentence("the arm")))
            attributes(go.props("outline dense no-caps"), aria_label=_("go to {name}", name=shown))
            all_joints = ui.button(_("all"), on_click=lambda: begin(arm.robot.move_to(name), sentence("all joints")))
            all_joints.props("outline dense no-caps").tooltip(
                _("with all other joints that the pose names, as flippers")
            )
            attributes(all_joints, aria_label=_("all to {name}", name=shown))

    @property
    def _robot_name(self) -> str:
        return "" if self._robot is None else self._robot.name

    def _given_poses(self) -> dict[str, dict[str, float]]:
        """Poses of the file with a joint of this arm; a joint that it does not have is an error when it is to move."""
        joints = {joint.name for joint in self._joints}
        return {
            name: positions
            for name, positions in self._console.poses.get(self._robot_name, {}).items()
            if joints & positions.keys()
        }

    def _add_go(self, name: str, positions: dict[str, float], shown: Pose | None = None) -> None:
        def go() -> None:
            if shown is None or self._is_as_shown(name, shown):
                self._go(positions, sentence("the motion to {name}", name=name))

        button = ui.button(_("go"), on_click=go)
        attributes(button.props("outline dense no-caps"), aria_label=_("go to {name}", name=name))

    def _is_as_shown(self, name: str, shown: Pose) -> bool:
        """False, with the reason shown, for a pose that was changed or deleted since it is on this page."""
        files, arm = self._files(), self._arm
        if files is None or arm is None:
            return False
        try:
            now = files.poses(str(arm.info.id)).get(name)
        except JausError as error:
            self._motion.problem = str(error)
            return False
        if now == shown:
            return True
        changed = sentence("deleted") if now is None else sentence("changed ({author})", author=now.author)
        self._motion.problem = sentence(
            "{name} was {changed} since it is shown here; nothing moves", name=name, changed=changed
        )
        self._show_poses()
        return False

    async def _save_pose(self) -> None:
        files, arm = self._files(), self._arm
        if files is None or arm is None:
            return
        id, name = str(arm.info.id), str(self._name.value or "")
        try:
            positions = await arm.positions()
            try:
                files.save_pose(id, name, positions)
            except SavedByOther as other:
                if not await confirmed(_("{other}. Replace it?", other=other), _("replace")):
                    return
                files.save_pose(id, name, positions, seen=other.author)
        except JausError as error:
            self._motion.problem = str(error)
            return
        self._motion.problem = ""
        self._name.set_value("")
        self._show_poses()

    async def _delete_pose(self, name: str) -> None:
        files, arm = self._files(), self._arm
        if files is None or arm is None:
            return
        id = str(arm.info.id)
        try:
            try:
                files.delete_pose(id, name)
            except SavedByOther as other:
                if not await confirmed(_("{other}. Delete it?", other=other), _("delete")):
                    return
                files.delete_pose(id, name, seen=other.author)
        except JausError as error:
            self._motion.problem = str(error)
        self._show_poses()


def limits_text(joint: JointInfo) -> str:
    """The limits of a joint as text."""
    low, high = (f"{end:.3f}" if math.isfinite(end) else _("no limit") for end in (joint.lower, joint.upper))
    return _("limits: {low} to {high} {unit}", low=low, high=high, unit=joint.unit)


class _JointRow:
    """One joint: its measured position as a mark, and a slider and a field for the wanted one."""

    def __init__(self, joint: JointInfo, position: float) -> None:
        self.touched = False
        """True when the user has set the wanted position."""
        self._low, self._high = joint.shown_range(position)
        self._joint = joint
        self._setting = False
        self._at = math.nan
        limited = math.isfinite(joint.lower) and math.isfinite(joint.upper)
        ui.label(joint_label(joint.name)).classes("joint").tooltip(printable(joint.name))
        self._now = ui.label("").classes("joint-value").tooltip(limits_text(joint))
        self._number = (
            ui.number(value=round(position, 3) + 0.0, step=0.01, format="%.3f", on_change=self._entered)
            .props('dense borderless input-class="text-right"')
            .classes("joint-wanted")
        )
        attributes(self._number, aria_label=joint.name)
        with ui.element("div").classes("track" if limited else "track endless"):
            self._mark = ui.element("i").classes("measured")
            step = 0.01 if joint.is_revolute else 0.001
            self._slider = ui.slider(
                min=round(self._low, 3), max=round(self._high, 3), step=step, value=position, on_change=self._slid
            )
            attributes(self._slider, aria_label=joint.name)
        self.measured(position)

    @property
    def wanted(self) -> float:
        """Radians or metres."""
        return float(self._number.value if self._number.value is not None else self._slider.value)

    def measured(self, position: float) -> None:
        """Show the measured position; the wanted one follows unless the user has set it."""
        if abs(position - self._at) <= 5e-4:
            if self.touched or abs(self.wanted - position) <= NEAR:
                return
        else:
            self._at = position
            self._show_turn(position)
            at_limit = min(position - self._joint.lower, self._joint.upper - position) < AT_LIMIT
            self._now.set_text(f"{round(position, 3) + 0.0:.3f} {self._joint.unit}")
            self._now.classes(add="at-limit" if at_limit else "", remove="" if at_limit else "at-limit")
            share = (position - self._low) / (self._high - self._low)
            style_number(self._mark, "at", min(1.0, max(0.0, share)))
        if not self.touched and abs(self.wanted - position) > NEAR:
            self._set(position)

    def _show_turn(self, position: float) -> None:
        """A joint without limits has left the turn that the slider shows."""
        now = self._joint.shown_range(position)
        if not self._low <= position <= self._high and now != (self._low, self._high):
            self._low, self._high = now
            attributes(self._slider, min=round(self._low, 3), max=round(self._high, 3))

    def _set(self, value: float) -> None:
        self._setting = True
        self._slider.set_value(round(min(self._high, max(self._low, value)), 3))
        self._number.set_value(round(value, 3) + 0.0)
        self._setting = False

    def _slid(self) -> None:
        if not self._setting:
            self.touched = True
            self._set(float(self._slider.value))

    def _entered(self) -> None:
        if not self._setting and self._number.value is not None:
            self.touched = True
            self._set(float(self._number.value))


def _slider(name: str, span: tuple[float, float, float], value: float, unit: str) -> ui.slider:
    """A slider with its value as text; `span` is the least value, the greatest value and the step."""
    low, high, step = span
    with ui.element("div").classes("setting"):
        label = ui.label().classes("hint")
        slider = attributes(ui.slider(min=low, max=high, step=step, value=value), aria_label=name)
        label.bind_text_from(slider, "value", lambda number: f"{name} {number:g} {unit}")
    return slider


def _jog_button(text: str, axis: int, sign: int, key: str) -> None:
    with ui.element("button").classes("jog-button").props('type="button"') as button:
        plain_text(text)
        plain_text(key, tag="kbd")
    attributes(button, data_axis=axis, data_sign=sign)
