"""The task to build an arm of modules: the UR10 takes parts out of the bins and joins them on a platform.

Each grasp and each joint is verified by the state of the connectors and by force. What fails is tried again another
way: the gripper turned, the part measured anew, another part of the type.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from functools import partial
from itertools import pairwise
from typing import Final

import numpy as np
import pinocchio as pin

from jauspy.cell.frames import Array, se3, se3_of_pose, shifted, tilt_between, turned
from jauspy.cell.handling import Handling, PickPlan
from jauspy.cell.held_load import MOST
from jauspy.cell.interface import GRIPPER, Cell, SeenPart
from jauspy.cell.motion import GENTLE, MotionPlanner, NoPath, Path, profile
from jauspy.cell.scene import Clearance, Layout, connector_frame
from jauspy.cell.schedule import Schedule, TaskFailed, Timeline
from jauspy.errors import JausError
from jauspy.geometry.vectors import GRAVITY, Z
from jauspy.platform.modular.connector import ConnectorError, ConnectorState
from jauspy.platform.modular.parts import PartKind, PartType, mass_of

GRASPS: Final = 4
"""Attempts to grasp one part before another of its type is taken."""
JOINS: Final = 4
"""Attempts to join one part before it is put down."""
PARTS: Final = 3
"""Parts that are tried for one place in the arm."""
SEAL_TIME: Final = 0.06
"""Seconds after which a connector that is not in contact, by its report, does not attach without a further press."""
ATTACH_TIME: Final = 0.6
"""Seconds in which a connector in contact must attach: it evacuates, or its latch closes."""
PRESSES: Final = 3
"""How often the arm presses on while a connector does not attach."""
NEAR_SPEED: Final = 0.3
INSERT_SPEED: Final = 0.15
LIFT_SPEED: Final = 0.3
"""Fractions of the UR10's speed on the way to what it is about to touch, and away from there."""
TOUCH_SPEED: Final = 0.004
"""m/s of the tool in the last millimetres before contact. Its mass of some 20 kg then stops within the give of a plate,
about 5 ms, with 20 N."""
HEAVY_TOUCH_SPEED: Final = 0.002
"""The same towards what is bolted down, or heavy: it gives way less than a part in a bin."""
CONTACT_FORCE: Final = 8.0
"""Newtons by which the force on the gripper must change for what it holds to be in contact."""
STEP: Final = 1e-6
"""Radians of a difference quotient."""
LEANS: Final = 24
LEAN_SPEED: Final = 0.02
LEAN_TIME: Final = 0.1
"""Parts in which a load is taken up, the fraction of the UR10's speed, and seconds in which the force settles."""
TAKEN_UP: Final = 0.9
"""Fraction of a load's weight from which on the gripper carries it."""
MAX_TILT: Final = math.radians(2.0)
MAX_SHIFT: Final = 0.0025
"""Metres and radians off the connector above which a part is taken off again and joined anew."""
STALE: Final = 0.5
"""Seconds since a part was last seen from which on it is looked for again before it is grasped."""
WEIGHT_TOLERANCE: Final = 0.3
"""Fraction of a part's mass by which what hangs on the gripper may differ, beside the uncertainty."""
SURE: Final = 3.0
"""Standard deviations of the mass by the UR10's motors within which it is certain."""
CHECK_ANGLE: Final = 0.06
"""Radians that a joint turns to and fro when it is checked."""
CHECK_TIME: Final = 0.5
PUT_DOWN: Final = ((-0.45, 0.0), (-0.45, 0.12), (-0.45, -0.12), (0.5, 0.0), (0.0, 0.45), (0.0, -0.45))
"""Places on the floor where parts are put down that could not be joined, metres."""
PUT_DOWN_HEIGHT: Final = 0.2
"""Height of the gripper above the floor, metres."""
PARKED: Final = np.array([-2.6, -1.9, 2.1, -1.77, -1.57, 0.0])
"""The UR10's posture away from platforms and conveyor, in radians."""
QUARTERS: Final = (0.0, math.pi, math.pi / 2.0, -math.pi / 2.0)
WHEEL_TURNS: Final = 12
"""Angles about its axis at which a wheel may be joined."""
BACK: Final = 0.02
BACK_STEPS: Final = 4
"""Metres, and how often, that the gripper moves back from what it has released until there is room around it."""
FULL: Final = 0.85
"""Fraction of the whole vacuum from which on a part is lifted: a cup that leaks does not reach it."""
EVACUATED_TIME: Final = 0.15
"""Seconds after an attachment in which the gripper's pump reaches the full vacuum."""
RELEASE_TIME: Final = 0.2
"""Seconds until a connector has let go."""
POLL: Final = 0.02
"""Seconds between two queries of a connector."""
STRAIGHT: Final = 0.999
"""Cosine of the angle from which on two axes count as parallel."""
OUT_OF_CONTACT: Final = (ConnectorError.NO_CONTACT, ConnectorError.TOO_FAR, ConnectorError.NOT_ALIGNED)
SEARCH: Final = (0.0, 0.0015, -0.0015, 0.003)
"""Metres beside the connector at which the attempts to join press the part down."""


@dataclass(frozen=True, slots=True)
class Slot:
    """A place in the arm: what it is called in the results, and the types that fit, the best first."""

    name: str
    types: tuple[str, ...]
    connector: str = "output"
    """The connector of the part in this place to which the next one is attached."""
    turns: tuple[float, ...] = ()
    """Radians about the connector's normal from where the part is square to the one before: as it is wanted, and then
    others with which it does as well. Empty: by its type."""


FIVE_JOINTS: Final = (
    Slot("joint 1", ("x5_9_inline", "x5_4_inline")),
    Slot("bracket", ("bracket_straight",)),
    Slot("joint 2", ("x8_16_elbow", "x8_9_elbow")),
    Slot("upper arm", ("tube_long",)),
    Slot("joint 3", ("x8_9_elbow", "x5_9_elbow")),
    Slot("forearm", ("tube_short",)),
    Slot("joint 4", ("x8_9_elbow", "x5_9_elbow")),
    Slot("joint 5", ("x5_4_inline", "x5_1_inline")),
)
"""The arm with five joints, base to tip."""


@dataclass(slots=True)
class PartResult:
    """Measurements of one part."""

    slot: str
    part: str = ""
    fetch_time: float = 0.0
    join_time: float = 0.0
    attempts: list[str] = field(default_factory=list)
    """Texts of the failed attempts."""
    grasp_force: float = 0.0
    """Newtons that the gripper measured while the part hung still."""
    mass: float = 0.0
    """Kilograms by the UR10's motors, and their standard deviation; zero while they are not known."""
    mass_deviation: float = 0.0
    joint_force: float = 0.0
    joint_moment: float = 0.0
    shift: float = 0.0
    """Metres off the connector, and radians, by the connector's own report."""
    tilt: float = 0.0


@dataclass(slots=True)
class AssemblyResult:
    """Measurements of the whole task."""

    base: str
    parts: list[PartResult] = field(default_factory=list)
    clearance: Clearance = field(default_factory=lambda: Clearance(1.0))
    """The smallest distance along all motions, without those that end in contact."""
    duration: float = 0.0
    timeline: Timeline = field(default_factory=Timeline)
    failure: str = ""
    """Why it ended early; empty after a success."""

    @property
    def retries(self) -> int:
        """Attempts that failed."""
        return sum(len(part.attempts) for part in self.parts)


@dataclass(slots=True)
class Held:
    """The part in the gripper."""

    name: str
    grasp: pin.SE3
    """The gripper in the part's frame, as the gripper reports it."""


class Assembler:
    """Builds arms; one object for one task."""

    def __init__(self, cell: Cell, layout: Layout, *, seed: int = 0) -> None:
        self.cell = cell
        self.layout = layout
        self.scene = layout.scene()
        self.planner = MotionPlanner(self.scene, layout.kinematics, seed=seed)
        self.handling = Handling(layout, self.scene, self.planner)
        self.at: Array = layout.home
        """The UR10's present posture."""
        self.rejected: set[str] = set()
        """Parts that are not tried again."""
        self.out_of_reach: set[str] = set()
        """Parts that cannot be had for the present place; for another one they may."""
        self.used: set[str] = set()
        self.carried: set[str] = set()
        """Parts that are attached to another one and move with it: their shapes are with those of the other."""
        self.placed: dict[str, tuple[float, pin.SE3]] = {}
        """When and where this robot put down a part, which counts until the sensor sees it again."""
        self.clearance = Clearance(1.0)
        self.held: Held | None = None
        self.seen: Mapping[str, SeenPart] = {}

    # --- the task -------------------------------------------------------------------------------------------------

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

    async def go_home(self) -> None:
        """Move the UR10 to its posture at the start."""
        await self.go(await self._path_to(self.layout.home))

    async def park(self) -> None:
        """Move the UR10 out of the way of what stands on the platforms and on the conveyor."""
        await self.look()
        await self.back_off()
        await self.go(await self._path_to(PARKED))

    async def back_off(self) -> None:
        """Move straight back from what the gripper has released while that is too close to plan a path from here."""
        for _ in range(BACK_STEPS):
            here = self.scene.clearance(self.at).distance
            if here >= self.planner.margin:
                return
            back = self.handling.retreat(self.at, BACK)
            if self.scene.clearance(back.end).distance <= here:
                return
            await self.go(back, speed=LIFT_SPEED, contact=True)

    async def _path_to(self, posture: Array) -> Path:
        return await self.cell.compute(partial(self.planner.to_posture, self.at, posture))

    async def go(
        self,
        path: Path,
        *,
        speed: float = 1.0,
        tool_speed: float = math.inf,
        contact: bool = False,
        gentle: bool = False,
    ) -> None:
        """Move along a path; paths that do not end in contact count for the smallest distance.

        It speeds up slowly where what the gripper holds would load it too much otherwise. Raises `NoPath` where it does
        at any acceleration.
        """
        if not gentle and self.load_used(path, speed, 1.0) > MOST:
            gentle = True
        if gentle and (used := self.load_used(path, speed, GENTLE)) > MOST:
            raise NoPath(f"the gripper would use {used:.0%} of its strength on the way, at most {MOST:.0%} is safe")
        if not contact and path.clearance.distance < self.clearance.distance:
            self.clearance = path.clearance
        self.at = path.end
        try:
            await self.cell.follow(path, speed=speed, tool_speed=tool_speed, gentle=gentle)
        except JausError:
            self.at = await self.cell.posture()
            raise

    def load_used(self, path: Path, speed: float, acceleration: float) -> float:
        """Largest fraction of the gripper's strength that what it holds uses along a path.

        `speed` and `acceleration` are fractions of the UR10's, as in a motion along it.
        """
        load, layout = self.planner.load, self.layout
        if load is None:
            return 0.0
        used = 0.0
        for start, goal in pairwise(path.points):
            rates = profile(start, goal, layout.speeds * speed, layout.accelerations * acceleration).accelerations
            change = np.sign(goal - start) * np.where(goal == start, 0.0, rates)
            for posture, sign in ((start, 1.0), (goal, -1.0)):
                tool, jacobian = layout.kinematics.forward(posture), layout.kinematics.jacobian(posture)
                used = max(used, load.utilisation(tool, sign * jacobian[:3] @ change))
        return used

    async def _make_safe(self) -> None:
        """Leave the UR10 at rest; it keeps holding its part, which would fall otherwise."""
        self.at = await self.cell.posture()
        if self.held is None:
            try:
                await self.go(self.handling.retreat(self.at, 0.05))
                await self.go_home()
            except JausError:
                return  # it stands where it is, at rest

    # --- fetching -------------------------------------------------------------------------------------------------

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

    def know(self, frames: Mapping[str, pin.SE3]) -> None:
        """Take parts for where connectors and joints report them, until the sensor sees them; they are not grasped."""
        self.placed |= {name: (self.cell.now(), frame) for name, frame in frames.items()}
        self.rejected |= set(frames)

    def stands(self, frames: Mapping[str, pin.SE3]) -> None:
        """Parts stand where connectors and joints report them, whatever the sensor sees, until they are taken off."""
        self.used |= set(frames)
        self.rejected -= set(frames)
        for name, frame in frames.items():
            self.scene.put(name, self.handling.pieces(name), frame)

    async def look(self, *, fresh: bool = False) -> None:
        """Measure where the parts are, and put them there in the scene."""
        self.seen = await self.cell.observe(fresh=fresh)
        for name, seen in self.seen.items():
            if name not in self.used and name not in self.carried and (self.held is None or name != self.held.name):
                moved, pose = self.placed.get(name, (-math.inf, seen.pose))
                hidden_since = moved > self.cell.now() - seen.age
                self.scene.put(name, self.handling.pieces(name), pose if hidden_since else seen.pose)
        for part in self.layout.setup.parts:
            if part.name in self.seen or part.fixed or part.name in self.used:
                continue
            if part.name in self.placed:
                self.scene.put(part.name, self.handling.pieces(part.name), self.placed[part.name][1])
            else:
                self.scene.remove(part.name)

    async def _see(self, part: str) -> bool:
        """True if the sensor sees a part now, if need be after the UR10 has moved home, out of the cameras' view."""
        for hidden in (False, True):
            if hidden and self.held is None:
                await self.go_home()
                await self.look(fresh=True)
            if part in self.seen and self.seen[part].age <= STALE:
                return True
        return False

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
        if state.attached_to != plan.part or (self.layout.locks(GRIPPER, plan.part) and not state.latched):
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
        self._hold(plan.part, se3(state.offset).inverse())
        if heavy and self.planner.load is not None:
            load = self.planner.load.inertia
            await self.take_up(load.mass, self.layout.kinematics.forward(self.at).act(load.lever))
        await self.go(Path((self.at, *plan.lift.points[1:])), speed=LIFT_SPEED, contact=True, gentle=heavy)
        await self.cell.sleep(0.15)
        state = await self.cell.connector(GRIPPER)
        if state.attached_to != plan.part:
            self._drop(plan.part)
            return f"it was dropped while it was lifted{_because(state)}"
        self._hold(plan.part, se3(state.offset).inverse())
        row.grasp_force = state.force
        if math.isfinite(state.mass_deviation):
            row.mass, row.mass_deviation = state.mass, state.mass_deviation
        type = self.layout.type_of(plan.part)
        if weigh and (why := _wrong_weight(state, mass_of(type))):
            await self._put_back(plan, release)
            return why
        return ""

    async def _withdraw(self) -> None:
        """Let go of what was not grasped well, and move back from it."""
        await self.cell.enable(GRIPPER, False)
        await self.go(self.handling.retreat(self.at), contact=True)

    def _hold(self, part: str, grasp: pin.SE3) -> None:
        self.held = Held(part, grasp)
        self.planner.load = self.handling.load(part, grasp)
        self.scene.hold(part, self.handling.pieces(part), grasp.inverse())

    def forget_held(self) -> None:
        """Plan without what the gripper has held."""
        self.held = self.planner.load = None
        self.scene.release()

    def _drop(self, part: str) -> None:
        self.forget_held()
        self.used.discard(part)

    async def _put_back(self, plan: PickPlan, connector: str = "") -> None:
        await self.go(Path((self.at, *plan.lift.points[-2::-1])), speed=0.1, contact=True)
        if connector:
            await self.cell.enable(connector, True)
            await self._wait_held(connector)
        await self.cell.enable(GRIPPER, False)
        self._drop(plan.part)
        await self.go(self.handling.retreat(self.at), contact=True)

    # --- joining --------------------------------------------------------------------------------------------------

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
        self._hold(part, frame.actInv(self.layout.kinematics.forward(self.at)))

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

    async def put_here(self, part: str, frame: pin.SE3) -> None:
        """Let go of the held part, which then is at `frame` in the world until the sensor sees it."""
        await self.cell.enable(GRIPPER, False)
        await self.cell.sleep(0.3)
        self._drop(part)
        self.placed[part] = self.cell.now(), frame
        self.scene.put(part, self.handling.pieces(part), frame)
        await self.go(self.handling.retreat(self.at), speed=LIFT_SPEED, contact=True)

    async def put_down(self, part: str) -> None:
        """Let the part lie where there is room on the floor, so that another one can be taken."""
        self.rejected.add(part)
        solve, down = self.layout.kinematics.solve, turned("x", math.pi)
        postures = [solution for x, y in PUT_DOWN for solution in solve(shifted(x, y, PUT_DOWN_HEIGHT) * down, self.at)]
        try:
            path = await self.cell.compute(partial(self.planner.to_any, self.at, postures))
        except NoPath as error:
            raise TaskFailed(f"{part} cannot be joined, and cannot be put down: {error}") from error
        await self.go(path)
        await self.cell.enable(GRIPPER, False)
        await self.cell.sleep(0.3)
        self._drop(part)
        await self.go(self.handling.retreat(self.at, 0.05), contact=True)

    # --- verifying ------------------------------------------------------------------------------------------------

    async def touch(self, path: Path, connector: str, frame: pin.SE3, *, speed: float = TOUCH_SPEED) -> ConnectorState:
        """Move until a connector attaches something; press on, along -z of `frame`, while none does."""
        for press in range(PRESSES + 1):
            await self.cell.touch(path, connector, tool_speed=speed)
            state = await self._wait_held(connector)
            self.at = await self.cell.posture()
            if state.attached_to or not state.enabled or press == PRESSES:
                break
            path = self.handling.pressed(self.at, frame)
        return state

    async def press(self, path: Path) -> None:
        """Lower what the gripper holds along a path, until it is in contact or at the end."""
        await self.cell.touch(path, GRIPPER, tool_speed=TOUCH_SPEED, contact=CONTACT_FORCE)
        self.at = await self.cell.posture()

    async def take_up(self, mass: float, center: Array) -> None:
        """Lean against a load until the gripper carries its weight, so that it neither drops nor tilts when it is free.

        `mass` in kilograms, `center` of mass in the world. What the gripper holds stands or is attached elsewhere, and
        stays where it is; the joints are sent where the weight would bend them from. The UR10 has not found out the
        load yet: it learns while it moves.
        """
        k, group = self.layout.kinematics, self.layout.group
        local = k.forward(self.at).actInv(center)
        height = float(center[2])
        torques = np.array(
            [(k.forward(self.at + STEP * axis).act(local)[2] - height) / STEP for axis in np.eye(len(self.at))]
        )
        stiffness = np.array([group.gains[name].position.p for name in group.joints])
        bend = GRAVITY * mass * torques / stiffness
        for _ in range(LEANS):
            if (await self.cell.connector(GRIPPER)).force >= TAKEN_UP * GRAVITY * mass:
                return
            await self.go(Path((self.at, self.at + bend / LEANS)), speed=LEAN_SPEED, contact=True, gentle=True)
            await self.cell.sleep(LEAN_TIME)

    async def _wait_held(self, connector: str) -> ConnectorState:
        """Wait until a connector has attached something, and locked it if it can, or reports why it does not."""
        begun = self.cell.now()
        while True:
            state = await self.cell.connector(connector)
            waited = self.cell.now() - begun
            gives_up = not state.enabled or state.error in OUT_OF_CONTACT or (state.attached_to and state.last_error)
            held = state.attached_to and (state.latched or not self.layout.locks(connector, state.attached_to))
            if held or waited > (SEAL_TIME if gives_up else ATTACH_TIME):
                return state
            await self.cell.sleep(POLL)

    async def _check_joint(self, part: str) -> None:
        """Turn a new joint to and fro: it has power, belongs to the arm and moves."""
        if self.layout.type_of(part).kind is not PartKind.SERVO:
            return
        until = self.cell.now() + 3.0
        while part not in (state := await self.cell.arm()).joints:
            if self.cell.now() > until:
                raise TaskFailed(f"{part} was joined, but is not a joint of the arm 3 s later; has it power?")
            await self.cell.sleep(0.1)
        index = state.joints.index(part)
        for angle in (CHECK_ANGLE, 0.0):
            goal = [math.nan] * len(state.joints)
            goal[index] = angle
            await self.cell.move_arm(goal, CHECK_TIME)

    # --- geometry -------------------------------------------------------------------------------------------------

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


class Tip:
    """The connector to which the next part is joined."""

    def __init__(self, connector: str, part: str, frame: pin.SE3) -> None:
        self.connector = connector
        self.part = part
        self.frame = frame
        """Frame of the part in the world."""
        self.square = pin.SE3.Identity()
        """The turn about the connector's axis after which a part is square to the base."""

    def advance(self, part: str, connector: str, frame: pin.SE3, output: pin.SE3, turn: float = 0.0) -> None:
        """The next part is joined to this one, whose frame is `frame`, and was to be turned by `turn` radians."""
        wanted = self.frame * self.square * turned("z", turn) * output
        self.connector, self.part, self.frame = f"{part}/{connector}", part, frame * output
        x = self.frame.rotation.T @ wanted.rotation[:, 0]
        self.square = turned("z", math.atan2(x[1], x[0]))


def slot_goals(layout: Layout, slot: Slot, tip: Tip) -> list[pin.SE3]:
    """The frames in the world that a part in a place may have: on the connector, square to the base."""
    type = layout.setup.types[slot.types[0]]
    turns: Sequence[float] = QUARTERS if is_straight(type) else QUARTERS[:1]
    if type.kind is PartKind.WHEEL:
        turns = [math.tau * number / WHEEL_TURNS for number in range(WHEEL_TURNS)]
    return [tip.frame * tip.square * turned("z", turn) for turn in slot.turns or turns]


def is_straight(type: PartType) -> bool:
    """True if a part has all its axes along its own z: turned about it, it carries the next part as well."""
    axes = [frame.rotate(Z) for frame in type.connectors.values()]
    axes += [type.servo.axis] if type.servo is not None else []
    return all(axis[2] > STRAIGHT for axis in axes)


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
