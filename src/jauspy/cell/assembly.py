"""The task to build an arm of modules: the UR10 takes parts out of the bins and joins them on a platform.

Each grasp and each joint is verified by the state of the connectors and by force. What fails is tried again another
way: the gripper turned, the part measured anew, another part of the type.
"""

from __future__ import annotations

import math
from functools import partial
from typing import Final

import numpy as np
import pinocchio as pin

from jauspy.cell.carrying import HEAVY_TOUCH_SPEED, INSERT_SPEED, LIFT_SPEED, NEAR_SPEED, TOUCH_SPEED, Carrier
from jauspy.cell.frames import se3, se3_of_pose, shifted, tilt_between, turned
from jauspy.cell.handling import PickPlan
from jauspy.cell.held_load import MOST
from jauspy.cell.interface import GRIPPER
from jauspy.cell.motion import NoPath, Path
from jauspy.cell.scene import connector_frame
from jauspy.cell.schedule import Schedule, TaskFailed
from jauspy.cell.slots import FIVE_JOINTS, AssemblyResult, PartResult, Slot, Tip, slot_goals
from jauspy.cell.standing import arm_with
from jauspy.errors import JausError, RequestError
from jauspy.geometry.vectors import GRAVITY
from jauspy.platform.modular.connector import ConnectorState
from jauspy.platform.modular.parts import PartKind, mass_of

GRASPS: Final = 4
"""Attempts to grasp one part before another of its type is taken."""
JOINS: Final = 4
"""Attempts to join one part before it is put down."""
PARTS: Final = 3
"""Parts that are tried for one place in the arm."""
MAX_TILT: Final = math.radians(2.0)
MAX_SHIFT: Final = 0.0025
"""Metres and radians off the connector above which a part is taken off again and joined anew."""
WEIGHT_TOLERANCE: Final = 0.3
"""Fraction of a part's mass by which what hangs on the gripper may differ, beside the uncertainty."""
SURE: Final = 3.0
"""Standard deviations of the mass by the UR10's motors within which it is certain."""
SEARCH: Final = (0.0, 0.0015, -0.0015, 0.003)
"""Metres beside the connector at which the attempts to join press the part down."""
CHECK_ANGLE: Final = 0.06
CHECK_TIME: Final = 0.5
"""Radians that a joint turns to and fro when it is checked, and seconds of each turn."""
FULL: Final = 0.85
"""Fraction of the whole vacuum from which on a part is lifted: a cup that leaks does not reach it."""
EVACUATED_TIME: Final = 0.15
"""Seconds after an attachment in which the gripper's pump reaches the full vacuum."""
RELEASE_TIME: Final = 0.2
"""Seconds until a connector has let go."""


class Assembler(Carrier):
    """Builds arms; one object for one task."""

    # --- the task ---

    async def build(
        self, base: str = "platform_1", connector: str = "top", slots: tuple[Slot, ...] = FIVE_JOINTS
    ) -> AssemblyResult:
        """Build an arm on a base. If it fails, `failure` of the result is the reason, and the UR10 stands still."""
        result = AssemblyResult(base)
        begun = self.cell.now()
        tip = Tip(f"{base}/{connector}", base, await self._base_pose(base) * self._connector(base, connector))
        schedule = Schedule(self.cell.now)
        before: list[str] = []
        for slot in slots:
            row = PartResult(slot.name)
            result.parts.append(row)

            async def fetch(slot: Slot = slot, row: PartResult = row) -> None:
                await self.fetch_for(slot, row, tip)

            async def join(slot: Slot = slot, row: PartResult = row) -> None:
                await self.join_to(slot, row, tip)

            async def check(row: PartResult = row) -> None:
                await self._check_joint(row.part)

            fetched = schedule.add(f"fetch {slot.name}", fetch, after=before, uses=["ur10"])
            joined = schedule.add(f"join {slot.name}", join, after=[fetched], uses=["ur10", "arm"])
            if slot.name.startswith("joint"):
                schedule.add(f"check {slot.name}", check, after=[joined], uses=["arm"])
            before = [joined]
        schedule.add("home", self.go_home, after=before, uses=["ur10"])
        try:
            result.timeline = await schedule.run()
        except (TaskFailed, JausError) as error:
            result.failure = str(error)
            result.timeline = schedule.timeline
            await self._make_safe()
        result.duration = self.cell.now() - begun
        result.clearance = self.clearance
        return result

    async def _make_safe(self) -> None:
        """Leave the UR10 at rest; it keeps holding its part, which would fall otherwise."""
        self.at = await self.cell.posture()
        if self.held is None:
            try:
                await self.go(self.handling.retreat(self.at, 0.05))
                await self.go_home()
            except JausError:
                return  # it stands where it is, at rest

    # --- fetching ---

    async def fetch_for(self, slot: Slot, row: PartResult, tip: Tip) -> None:
        """Grasp a part that fits this place at the tip, and lift it; raises `TaskFailed`."""
        begun = self.cell.now()
        await self.fetch(slot, row, self.goals(slot, tip))
        row.fetch_time += self.cell.now() - begun

    def goals(self, slot: Slot, tip: Tip) -> list[pin.SE3]:
        """The frames in the world that a part in this place may have."""
        return slot_goals(self.layout, slot, tip)

    async def fetch(self, slot: Slot, row: PartResult, goals: list[pin.SE3]) -> None:
        """Grasp a part for this place, and lift it; raises `TaskFailed` when no part can be had."""
        self.out_of_reach.clear()
        for _ in range(PARTS):
            await self.look()
            part = self._choose(slot)
            if part is None:
                break
            row.part = part
            if await self._grasp(part, row, goals):
                return
            if part not in self.out_of_reach:
                self.rejected.add(part)
        tried = "; ".join(row.attempts) or "none is left"
        raise TaskFailed(f"no {' or '.join(slot.types)} could be grasped for {slot.name}: {tried}")

    def _choose(self, slot: Slot) -> str | None:
        """The next part of a fitting type that lies somewhere and was not rejected."""
        for name in self.layout.of_types(slot.types):
            if name in self.seen and name not in self.rejected | self.out_of_reach | self.used:
                return name
        return None

    async def _grasp(self, part: str, row: PartResult, goals: list[pin.SE3]) -> bool:
        for attempt in range(GRASPS):
            if not await self._see(part):
                row.attempts.append(f"{part}: it is lost, the sensor does not see it")
                return False
            try:
                pose = self.seen[part].pose
                plan = await self.cell.compute(partial(self.handling.pick, part, pose, self.at, goals, skip=attempt))
            except NoPath as error:
                row.attempts.append(f"{part}: {error}")
                self.out_of_reach.add(part)
                return False
            why = await self.try_grasp(plan, row)
            if not why:
                return True
            row.attempts.append(f"{part}: {why}")
            await self.look(fresh=True)
        return False

    async def try_grasp(self, plan: PickPlan, row: PartResult, *, weigh: bool = True, release: str = "") -> str:
        """One attempt; returns why it failed, or an empty text.

        `weigh` compares the force with the part's weight. `release` is a connector that holds the part, and lets go of
        it before it is lifted.
        """
        await self.go(plan.approach)
        await self.cell.enable(GRIPPER, True)
        await self.go(plan.near, speed=NEAR_SPEED, contact=True)
        backward = self.layout.kinematics.forward(plan.contact.end) * turned("x", math.pi)
        heavy = plan.part in self.handling.composites
        if release:
            await self.cell.leave(plan.part)
        stiff = heavy or bool(release)
        state = await self.touch(plan.contact, GRIPPER, backward, speed=HEAVY_TOUCH_SPEED if stiff else TOUCH_SPEED)
        if state.attached_to != plan.part or self._needs_lock(state):
            if state.attached_to == plan.part:  # the gripper has found where it is better than the sensor
                where = self.layout.kinematics.forward(self.at) * se3(state.offset)
                self.placed[plan.part] = self.cell.now(), where
            await self._withdraw()
            return state.last_error or f"the gripper holds {state.attached_to or 'nothing'}, or has not locked it"
        if not state.latched:
            await self.cell.sleep(EVACUATED_TIME)
            state = await self.cell.connector(GRIPPER)
            full = self.layout.setup.limits.gripper.pressure
            if state.attached_to != plan.part or state.vacuum < FULL * full:
                await self._withdraw()
                return f"the gripper holds it with {1e-3 * state.vacuum:.0f} of {1e-3 * full:.0f} kPa{_because(state)}"
        if release:
            await self.cell.enable(release, False)
            await self.cell.sleep(RELEASE_TIME)
        self._hold_as_reported(plan.part, state)
        if heavy and self.planner.load is not None:
            load = self.planner.load.inertia
            await self.take_up(load.mass, self.layout.kinematics.forward(self.at).act(load.lever))
        await self.go(Path((self.at, *plan.lift.points[1:])), speed=LIFT_SPEED, contact=True, gentle=heavy)
        await self.cell.sleep(0.15)
        state = await self.cell.connector(GRIPPER)
        if state.attached_to != plan.part:
            self._drop(plan.part)
            return f"it was dropped while it was lifted{_because(state)}"
        self._hold_as_reported(plan.part, state)
        row.grasp_force = state.force
        if math.isfinite(state.mass_deviation):
            row.mass, row.mass_deviation = state.mass, state.mass_deviation
        type = self.layout.type_of(plan.part)
        if weigh and (why := _wrong_weight(state, mass_of(type))):
            await self._put_back(plan, release)
            return why
        return ""

    def _needs_lock(self, state: ConnectorState) -> bool:
        """True if the gripper's latch could have locked what it holds, has not, and its cup alone is too weak."""
        if state.latched or not self._locks(GRIPPER, state):
            return False
        load = self.handling.load(state.attached_to, se3(state.offset).inverse(), latched=False)
        return load.worst > MOST

    async def _withdraw(self) -> None:
        """Let go of what was not grasped well, and move back from it.

        A gripper that presses on it nearly as hard as counts as a contact may stop at that once more as it begins to
        move; the effort has fallen then.
        """
        await self.cell.enable(GRIPPER, False)
        try:
            await self.go(self.handling.retreat(self.at), contact=True)
        except RequestError:
            if not await self.cell.blocked():
                raise
            await self.go(self.handling.retreat(self.at), contact=True)

    async def _put_back(self, plan: PickPlan, connector: str = "") -> None:
        await self.go(Path((self.at, *plan.lift.points[-2::-1])), speed=0.1, contact=True)
        if connector:
            await self.cell.enable(connector, True)
            await self._wait_held(connector)
        await self.cell.enable(GRIPPER, False)
        self._drop(plan.part)
        await self.go(self.handling.retreat(self.at), contact=True)

    # --- joining ---

    async def join_to(self, slot: Slot, row: PartResult, tip: Tip) -> None:
        """Join the held part to the tip, or another one when it is lost; raises `TaskFailed`."""
        begun = self.cell.now()
        goals = self.goals(slot, tip)
        for _ in range(PARTS):
            if await self.join(slot, row, tip, goals):
                row.join_time += self.cell.now() - begun
                return
            self.rejected.add(row.part)
            await self.fetch(slot, row, goals)
        raise TaskFailed(f"{slot.name} could not be joined to {tip.connector}: {'; '.join(row.attempts)}")

    async def join(self, slot: Slot, row: PartResult, tip: Tip, goals: list[pin.SE3]) -> bool:
        """Join the held part to the tip; false when it was lost or put down, and another one is needed."""
        part = row.part
        search = iter(SEARCH)
        aside = next(search)
        for attempt in range(JOINS):
            held = self.held
            state = await self.cell.connector(GRIPPER)
            if held is None or state.attached_to != part:
                self._drop(part)
                row.attempts.append(f"{part}: it was dropped on the way{_because(state)}")
                return False
            beside = [goal * shifted(x=aside) for goal in goals]
            place = partial(self.handling.place, part, held.grasp, self.at, beside, touches=[tip.part])
            try:
                plan = await self.cell.compute(place)
            except NoPath as error:
                row.attempts.append(f"{part}: {error}")
                if attempt == 0:
                    await self.put_down(part)
                    return False
                aside = next(search, 0.0)
                continue
            await self.go(plan.transfer)
            await self.go(plan.insert, speed=INSERT_SPEED, contact=True)
            await self.press(plan.contact)
            await self.cell.enable(tip.connector, True)  # in contact: enabled before, it would leave a gap of its lip
            state = await self.touch(Path((self.at,)), tip.connector, plan.goal)
            why = self._joined_wrongly(tip.connector, part, state)
            if not why:
                await self._let_go(part, row, tip, slot, state)
                return True
            row.attempts.append(f"{part}: {why}")
            if state.attached_to == part:
                self._correct_grasp(part, tip.frame * se3(state.offset))
            else:
                aside = next(search, 0.0)
            await self.cell.enable(tip.connector, False)
            await self.cell.sleep(RELEASE_TIME)
            back = plan.insert.points[0]
            await self.go(Path((self.at, plan.insert.end, back)), speed=NEAR_SPEED, contact=True)
        if self.held is not None:
            await self.put_down(part)
        return False

    def _correct_grasp(self, part: str, frame: pin.SE3) -> None:
        """Take over how the part really is in the gripper, after a connector has found it at `frame`."""
        latched = self.held is not None and self.held.latched
        self._hold(part, frame.actInv(self.layout.kinematics.forward(self.at)), latched=latched)

    def _joined_wrongly(self, connector: str, part: str, state: ConnectorState) -> str:
        if state.attached_to != part:
            return state.last_error or f"the connector holds {state.attached_to or 'nothing'}"
        offset = se3(state.offset)
        tilt, shift = tilt_between(pin.SE3.Identity(), offset), float(np.linalg.norm(offset.translation))
        if tilt > MAX_TILT or shift > MAX_SHIFT:
            return f"it sits {1000 * shift:.1f} mm and {math.degrees(tilt):.1f} degrees off"
        if self.layout.locks(connector, part) and not state.latched:
            return state.last_error or f"{connector} does not lock it"
        return ""

    async def _let_go(self, part: str, row: PartResult, tip: Tip, slot: Slot, state: ConnectorState) -> None:
        await self.cell.enable(GRIPPER, False)
        await self.cell.sleep(0.1)
        self.forget_held()
        offset = se3(state.offset)
        frame = tip.frame * offset
        self.used.add(part)
        self.scene.put(part, self.handling.pieces(part), frame)
        await self.go(self.handling.retreat(self.at), speed=0.6, contact=True)
        after = await self.cell.connector(tip.connector)
        if after.attached_to != part:
            self.used.discard(part)
            raise TaskFailed(f"{part} came off {tip.connector} when the gripper let go{_because(after)}")
        row.shift, row.tilt = float(np.linalg.norm(offset.translation)), tilt_between(pin.SE3.Identity(), offset)
        row.joint_force, row.joint_moment = after.force, after.moment
        if slot.connector in self.layout.type_of(part).connectors:
            tip.advance(part, slot.connector, frame, self._connector(part, slot.connector), (*slot.turns, 0.0)[0])

    async def _check_joint(self, part: str) -> None:
        """Turn a new joint to and fro: it has power, belongs to the arm and moves."""
        if self.layout.type_of(part).kind is not PartKind.SERVO:
            return
        until = self.cell.now() + 3.0
        while (found := await arm_with(self.cell, self.layout.arms, {part})) is None:
            if self.cell.now() > until:
                raise TaskFailed(f"{part} was joined, but is not a joint of the arm 3 s later; has it power?")
            await self.cell.sleep(0.1)
        name, state = found
        index = state.joints.index(part)
        for angle in (CHECK_ANGLE, 0.0):
            goal = [math.nan] * len(state.joints)
            goal[index] = angle
            await self.cell.move_arm(goal, CHECK_TIME, name=name)

    # --- geometry ---

    async def _base_pose(self, base: str) -> pin.SE3:
        await self.look()
        for part in self.layout.setup.parts:
            if part.name == base and part.fixed:
                return se3_of_pose(part.pose)
        if base not in self.seen:
            raise TaskFailed(f"the sensor does not see {base}, on which the arm is to be built")
        return self.seen[base].pose

    def _connector(self, part: str, connector: str) -> pin.SE3:
        return connector_frame(self.layout.type_of(part), connector)


def _wrong_weight(state: ConnectorState, mass: float) -> str:
    """Why what hangs on the gripper is not a part of this mass, kg: by the gripper's force and by the UR10's motors."""
    tolerance = WEIGHT_TOLERANCE * mass
    if abs(state.force / GRAVITY - mass) > tolerance:
        return (
            f"the gripper measures {state.force:.1f} N where {GRAVITY * mass:.1f} N should hang; it may be stuck, "
            "or another part hangs on it"
        )
    if math.isfinite(state.mass_deviation) and abs(state.mass - mass) > tolerance + SURE * state.mass_deviation:
        found = f"{state.mass:.2f} kg (deviation {state.mass_deviation:.2f} kg)"
        return f"the motors carry {found} where {mass:.2f} kg should hang; it may be stuck, or another part hangs on it"
    return ""


def _because(state: ConnectorState) -> str:
    return f": {state.last_error}" if state.last_error else ""
