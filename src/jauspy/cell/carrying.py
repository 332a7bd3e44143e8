"""The UR10 as it carries parts: its motions, where parts are, what the gripper holds, touching and putting down."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from functools import partial
from itertools import pairwise
from typing import Final

import numpy as np
import pinocchio as pin

from jauspy.cell.frames import Array, se3, shifted, turned
from jauspy.cell.handling import Handling
from jauspy.cell.held_load import MOST
from jauspy.cell.interface import GRIPPER, Cell, SeenPart
from jauspy.cell.motion import GENTLE, MotionPlanner, NoPath, Path, profile
from jauspy.cell.scene import Clearance, Layout
from jauspy.cell.schedule import TaskFailed
from jauspy.errors import JausError
from jauspy.geometry.vectors import GRAVITY
from jauspy.platform.modular.connector import ConnectorError, ConnectorState

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
STALE: Final = 0.5
"""Seconds since a part was last seen from which on it is looked for again before it is grasped."""
PUT_DOWN: Final = ((-0.45, 0.0), (-0.45, 0.12), (-0.45, -0.12), (0.5, 0.0), (0.0, 0.45), (0.0, -0.45))
"""Places on the floor where parts are put down that could not be joined, metres."""
PUT_DOWN_HEIGHT: Final = 0.2
"""Height of the gripper above the floor, metres."""
PARKED: Final = np.array([-2.6, -1.9, 2.1, -1.77, -1.57, 0.0])
"""The UR10's posture away from platforms and conveyor, in radians."""
BACK: Final = 0.02
BACK_STEPS: Final = 4
"""Metres, and how often, that the gripper moves back from what it has released until there is room around it."""
POLL: Final = 0.02
"""Seconds between two queries of a connector."""
OUT_OF_CONTACT: Final = (ConnectorError.NO_CONTACT, ConnectorError.TOO_FAR, ConnectorError.NOT_ALIGNED)


@dataclass(slots=True)
class Held:
    """The part in the gripper."""

    name: str
    grasp: pin.SE3
    """The gripper in the part's frame, as the gripper reports it."""
    latched: bool = False
    """True if the gripper's latch has locked on it."""


class Carrier:
    """Moves the UR10 and what its gripper holds, and knows where the parts are; one object for one task."""

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

    # --- motions ---

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

    # --- where parts are ---

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

    # --- what the gripper holds ---

    def _hold(self, part: str, grasp: pin.SE3, *, latched: bool) -> None:
        self.held = Held(part, grasp, latched)
        self.planner.load = self.handling.load(part, grasp, latched=latched)
        self.scene.hold(part, self.handling.pieces(part), grasp.inverse())

    def _hold_as_reported(self, part: str, state: ConnectorState) -> None:
        """Plan with a part as the gripper reports it."""
        self._hold(part, se3(state.offset).inverse(), latched=state.latched)

    def forget_held(self) -> None:
        """Plan without what the gripper has held."""
        self.held = self.planner.load = None
        self.scene.release()

    def _drop(self, part: str) -> None:
        self.forget_held()
        self.used.discard(part)

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

    # --- touching ---

    async def touch(self, path: Path, connector: str, frame: pin.SE3, *, speed: float = TOUCH_SPEED) -> ConnectorState:
        """Move until a connector attaches something; press on, along -z of `frame`, while none does.

        Pressing harder would not help where the UR10 has found what it presses on, nor where the cup leaks on a part
        that it was pressed onto already: it would load the part, and what that lies on.
        """
        leaked = False
        for press in range(PRESSES + 1):
            await self.cell.touch(path, connector, tool_speed=speed)
            state = await self._wait_held(connector)
            self.at = await self.cell.posture()
            if state.attached_to or not state.enabled or press == PRESSES or await self.cell.blocked():
                break
            leaks = state.error is ConnectorError.FAILED
            if leaks and leaked:
                break
            leaked = leaks
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

    def _locks(self, connector: str, state: ConnectorState) -> bool:
        """True if a connector's latch locks on what it holds, where it holds it."""
        return self.layout.locks(connector, state.attached_to, se3(state.offset).inverse())

    async def _wait_held(self, connector: str) -> ConnectorState:
        """Wait until a connector has attached something, and locked it if it can, or reports why it does not."""
        begun = self.cell.now()
        while True:
            state = await self.cell.connector(connector)
            waited = self.cell.now() - begun
            gives_up = not state.enabled or state.error in OUT_OF_CONTACT or (state.attached_to and state.last_error)
            held = state.attached_to and (state.latched or not self._locks(connector, state))
            if held or waited > (SEAL_TIME if gives_up else ATTACH_TIME):
                return state
            await self.cell.sleep(POLL)
