"""The operator of a modular arm: its kinematics by parts and connectors, free paths in the planning scene, motions."""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from itertools import pairwise, zip_longest
from typing import Final

import numpy as np
import pinocchio as pin

from jauspy.cell.arm_loads import Used, largest_load, sampled_states, smooth_states
from jauspy.cell.carrying import PARKED
from jauspy.cell.client import CellClient
from jauspy.cell.frames import Array, se3, turned
from jauspy.cell.held_load import MOST
from jauspy.cell.motion import STEP, MotionPlanner, NoPath, Path
from jauspy.cell.scene import (
    Clearance,
    Layout,
    LinkPiece,
    Piece,
    PlanningScene,
    pieces_of,
    pieces_of_part,
)
from jauspy.cell.schedule import TaskFailed
from jauspy.cell.smoothing import smoothed
from jauspy.cell.standing import arm_with, base_frame, chain_of, standing_on
from jauspy.errors import ConfigError
from jauspy.ocu.cell import MotionRefused
from jauspy.platform.modular.arm import ModularArmState, TrajectoryPoint
from jauspy.platform.modular.dynamics import solid_inertia
from jauspy.platform.modular.parts import PartSolid, PartType

FIVE_JOINTS: Final = ("servo_1", "bracket_1", "servo_2", "tube_1", "servo_3", "tube_2", "servo_11", "servo_5")
"""The parts of the arm with five joints, base to tip, when no part of another type had to be taken.

Its fourth joint is as strong as the third: it carries all others when the arm stands on its other end."""
SHARE: Final = 0.6
"""Fraction of the joints' speed at which the arm moves between tasks."""
PEAK: Final = 1.9
"""Largest speed of a motion that begins and ends smoothly, as a multiple of its mean."""
MIN_TIME: Final = 0.6
"""Seconds of the shortest motion."""
ACCELERATION: Final = 5.0
"""rad/s^2 of the joints on smooth paths."""
SLOWER: Final = 1.3
"""Factor of the times of a motion for which the arm, or its connections, are too weak."""
SLOWER_ROUNDS: Final = 4
SLOWEST_ROUNDS: Final = 12
"""How often a motion is slowed down so that its connections hold."""
RESTING: Final = 1e3
"""Seconds of a motion whose accelerations load nothing."""
TOUCH: Final = 0.004
"""Metres over what the tip is to hold from which on it moves slowly: errors of calibrated arms are smaller."""
PRESS: Final = 0.0015
"""Metres below contact to which the tip is sent."""
POLL: Final = 0.02


class ArmOperator:
    """Moves an arm that stands on a connector. `members` are its parts, base to tip."""

    def __init__(
        self,
        cell: CellClient,
        layout: Layout,
        base: pin.SE3,
        members: Sequence[Member],
        ur10: Array = PARKED,
        *,
        base_name: str = "",
        name: str = "",
    ) -> None:
        self._ur10 = ur10
        self.name = name
        """Name of the modular arm in the cell's file; the first one if it is empty."""
        self.cell = cell
        self.layout = layout
        self.members = tuple(members)
        self.base = base
        """The frame in the world of the connector that carries the arm at first."""
        self.base_name = base_name
        """Name of that connector; empty if it is not known."""
        self.last_goal: Array = np.zeros(sum(member.type.servo is not None for member in self.members))
        """Goal of the last motion."""
        self.clearance = Clearance(1.0)
        owner = base_name.partition("/")[0]
        self.stand(Chain(base, self.members, base_latch=not owner or layout.type_of(owner).latch))
        self.tip = f"{self.members[-1].name}/{self.members[-1].connector}"
        """The connector at the end."""

    @property
    def parts(self) -> tuple[str, ...]:
        """Names of its parts, base to tip."""
        return tuple(member.name for member in self.members)

    def stand(self, chain: Chain) -> None:
        """Plan for the arm as this chain describes it, from now on."""
        self.chain = chain
        self.scene = self._make_scene()
        self.planner = MotionPlanner(self.scene, chain, margin=0.01)

    @classmethod
    async def found(cls, cell: CellClient, layout: Layout, base: str = "platform_1/top") -> ArmOperator:
        """The operator of the arm that stands on a base, by what connectors report; raises `TaskFailed` without one."""
        chain = chain_of(layout, await standing_on(cell, layout, base))
        if not chain:
            raise TaskFailed(f"no arm stands on {base}")
        members = []
        for item, after in zip_longest(chain, chain[1:]):
            type = layout.type_of(item.part)
            output = after.connector.partition("/")[2] if after is not None else next(iter(type.connectors), "")
            members.append(Member(item.part, type, item.offset, output))
        frame = await base_frame(cell, layout, base)
        return cls(cell, layout, frame, members, base_name=base, name=await _arm_of(cell, layout, members))

    def _make_scene(self) -> PlanningScene:
        """The obstacles around the arm: the cell without the arm's own parts, and the UR10 at rest."""
        whole = self.layout.scene()
        # a box at the tip is as close to the last servo module as that is long
        scene = PlanningScene(self.chain, self.chain.links, wrist=self.chain.model.njoints - 3)
        own = {member.name for member in self.members}
        for name, pose in whole.poses.items():
            if name not in own:
                scene.put(name, whole.pieces(name), pose)
        for link, piece, pose in whole.links_at(self._ur10):
            scene.put(f"ur10 {link}", [piece], pose)
        return scene

    # --- state ----------------------------------------------------------------------------------------------------

    async def state(self) -> ModularArmState:
        """The arm's state, in the order of the chain; raises `TaskFailed` if it has other joints."""
        state = await self.cell.arm(self.name)
        if sorted(state.joints) != sorted(self.chain.joints):
            raise TaskFailed(f"the arm has the joints {', '.join(state.joints)}, not {', '.join(self.chain.joints)}")
        return state

    async def positions(self) -> Array:
        """Positions of the joints, base to tip, in radians."""
        state = await self.state()
        return self.ordered(state, state.positions)

    def ordered(self, state: ModularArmState, values: Sequence[float]) -> Array:
        """Values in the order of the controller's joints, in that of the chain."""
        by_name = dict(zip(state.joints, values, strict=True))
        return np.array([by_name[name] for name in self.chain.joints])

    async def ready(self, within: float = 5.0) -> None:
        """Wait until the arm has all its joints; raises `TaskFailed`."""
        until = self.cell.now() + within
        while sorted((await self.cell.arm(self.name)).joints) != sorted(self.chain.joints):
            if self.cell.now() > until:
                await self.state()
            await self.cell.sleep(0.1)

    # --- motions --------------------------------------------------------------------------------------------------

    async def look(self, *ignored: str) -> None:
        """Put the parts where the sensor sees them, without the arm's own and those ignored."""
        own = {member.name for member in self.members} | set(ignored)
        for name, seen in (await self.cell.observe()).items():
            if name in own:
                self.scene.remove(name)
            else:
                self.scene.put(name, pieces_of_part(self.layout.type_of(name)), seen.pose)

    async def go(self, goal: Array, *, share: float = SHARE, margin: float | None = None) -> None:
        """Move to a posture on a free path, smoothly if that is free, too; raises `NoPath` or `RequestError`."""
        start = await self.positions()
        path = self.planner.to_posture(start, goal, margin=margin)
        if len(path.points) > 2 and await self._flow(path, share):
            return
        self._passed(path.clearance)
        for a, b in pairwise(path.points):
            await self.move(b, self.time(a, b, share))

    def _passed(self, clearance: Clearance) -> None:
        if clearance.distance < self.clearance.distance:
            self.clearance = clearance

    async def _flow(self, path: Path, share: float) -> bool:
        """Move along a spline near a path, without stops; False if none is as free, or the arm is too weak for it."""
        least = min(path.clearance.distance, self.planner.margin)
        clearances: list[Clearance] = []

        def is_free(postures: Sequence[Array]) -> bool:
            clearances.append(self.scene.along(postures, STEP))
            return clearances[-1].distance >= least

        speeds, accelerations = self.chain.speeds * share, np.full(len(self.chain.speeds), ACCELERATION)
        points = smoothed(path.points, speeds, accelerations, is_free)
        for _ in range(SLOWER_ROUNDS if points else 0):
            assert points is not None
            rows = [path.points[0], *(np.array(point.positions) for point in points)]
            if self.used(sampled_states([0.0, *(point.time for point in points)], rows)).fraction > MOST:
                points = [TrajectoryPoint(point.time * SLOWER, point.positions) for point in points]
                continue
            try:
                self.last_goal = path.end
                await self.cell.follow_arm(self.chain.joints, points, name=self.name)
            except MotionRefused:
                points = [TrajectoryPoint(point.time * SLOWER, point.positions) for point in points]
            else:
                self._passed(clearances[-1])
                return True
        return False

    def time(self, start: Array, goal: Array, share: float) -> float:
        """Seconds for a motion at this fraction of the joints' speed, with smooth ends."""
        return max(MIN_TIME, smooth_duration(start, goal, self.chain.speeds * share))

    async def move(self, goal: Array, duration: float) -> None:
        """Move straight in joint space, and wait until the arm is there; obstacles are not checked.

        It takes `duration` seconds, or more where the connections of the arm would be loaded too much. Raises `NoPath`
        where they are at any speed.
        """
        duration = self.held_duration(await self.positions(), goal, duration)
        self.last_goal = goal
        await self.cell.move_arm(await self.vector(goal), duration, name=self.name)

    def held_duration(self, start: Array, goal: Array, duration: float) -> float:
        """Seconds of a motion, at least `duration`, in which no connection is loaded beyond what is safe."""
        at_rest = self.used(smooth_states(start, goal, RESTING))
        if at_rest.fraction > MOST:
            raise NoPath(f"the arm cannot move there: even at rest {at_rest}")
        for _ in range(SLOWEST_ROUNDS):
            used = self.used(smooth_states(start, goal, duration))
            if used.fraction <= MOST:
                return duration
            duration *= SLOWER
        raise NoPath(f"the arm cannot move there in {duration / SLOWER:.1f} s: {used}")

    def used(self, states: Iterable[tuple[Array, Array, Array]]) -> Used:
        """The most loaded connection of the arm along states of its joints (rad, rad/s, rad/s^2)."""
        return largest_load(self.chain, states, self.layout.setup.limits)

    async def vector(self, goal: Array) -> list[float]:
        """Positions in the order in which the arm's controller counts its joints."""
        order = (await self.cell.arm(self.name)).joints
        by_name = dict(zip(self.chain.joints, goal.tolist(), strict=True))
        return [by_name.get(name, math.nan) for name in order]

    def above(self, point: Sequence[float], near: Array, direction: Sequence[float] = (0.0, 0.0, -1.0)) -> list[Array]:
        """Free postures with the tip at a point, pointing down, the closest first; raises `NoPath` without one."""
        found = self.chain.pointing(np.array(point), np.array(direction), near)
        if not found:
            raise NoPath(f"the arm cannot point down at {', '.join(f'{coordinate:.2f}' for coordinate in point)}")
        free = [posture for posture in found if self.scene.is_free(posture, 0.0)]
        if not free:
            raise NoPath(f"no posture at the point is free: {self.scene.explain(found[0])}")
        return free

    async def wait_attached(self, connector: str, within: float) -> str:
        """The part that a connector has attached, and locked if it can; empty if it has not within so many seconds."""
        until = self.cell.now() + within
        while True:
            state = await self.cell.connector(connector)
            if state.attached_to and (state.latched or not self.layout.locks(connector, state.attached_to)):
                return state.attached_to
            if self.cell.now() > until:
                return ""
            await self.cell.sleep(POLL)


async def _arm_of(cell: CellClient, layout: Layout, members: Sequence[Member]) -> str:
    """The name of the modular arm to which a chain belongs; empty, for the first one, if no other has joints of it."""
    own = {member.name for member in members}
    found = await arm_with(cell, layout.arms[1:], own)
    return found[0] if found is not None else ""


def smooth_duration(start: Array, goal: Array, speeds: Array) -> float:
    """Seconds for a motion that begins and ends smoothly, whose joints stay below these speeds in rad/s."""
    return PEAK * float(np.max(np.abs(goal - start) / speeds))


MAX_ITERATIONS: Final = 60
TOLERANCE: Final = 1e-5
"""Metres and radians."""
LEANING: Final = 0.02
"""Radians by which the tip may lean: four joints cannot also make up for parts that sit askew."""
LEAN_WEIGHT: Final = 0.03
"""Metres of the tip's place that count as much as a radian of its direction."""
DAMPING: Final = 1e-7
MAX_STEP: Final = 0.4
BENDS: Final = (-1.9, -1.1, -0.4, 0.4, 1.1, 1.9)
"""Starts of the joints in the middle, in radians."""


BASE: Final = "base"
"""What the connector under an arm is called among its connections."""
AROUND: Final = turned("x", math.pi)


@dataclass(frozen=True, slots=True)
class Member:
    """One part of a chain."""

    name: str
    type: PartType
    offset: pin.SE3
    """Frame of the part in that of the connector that holds it."""
    connector: str
    """Connector of the part that holds the next part, or is the tip."""


@dataclass(frozen=True, slots=True)
class Connection:
    """A connector of a chain that holds what is beyond it."""

    name: str
    joint: int
    """Number of the joint that moves it; 0 before the first."""
    frame: pin.SE3
    """Its frame in that of the joint, z towards the tip."""
    first: int
    """Index of the first of the chain's bodies beyond it."""
    latched: bool
    """True if both sides have a latch; otherwise its cup alone holds."""


class Chain:
    """An arm that stands on a connector; joints are in the order base to tip."""

    def __init__(self, base: pin.SE3, members: Iterable[Member], *, base_latch: bool = True) -> None:
        self.members = tuple(members)
        self.base = base
        """The frame in the world of the connector that it stands on."""
        self._base_latch = base_latch
        """True if what it stands on has a latch."""
        self.model = pin.Model()
        self.joints: list[str] = []
        self.links: list[LinkPiece] = []
        """Shapes of the parts, each with the number of the joint that moves it."""
        self.mounts: list[tuple[str, int, pin.SE3]] = []
        """Connectors of the parts: name, number of the joint that moves it, and its frame in that of the joint."""
        self.bodies: list[tuple[int, pin.Inertia]] = []
        """Masses from the base to the tip: number of the joint that moves them, and inertia in its frame."""
        self.connections: list[Connection] = []
        """From the base to the tip."""
        joint, frame = self._build(base)
        self.tool = self.model.addFrame(pin.Frame("tip", joint, 0, frame, pin.FrameType.OP_FRAME))
        self.data = self.model.createData()
        fastest = {member.name: member.type.servo.max_speed for member in self.members if member.type.servo is not None}
        self.speeds = np.array([fastest[name] for name in self.joints])
        self.lower, self.upper = np.full(len(fastest), -math.tau), np.full(len(fastest), math.tau)

    def _build(self, base: pin.SE3) -> tuple[int, pin.SE3]:
        """Make the model; returns the last joint, and the frame of the tip after it."""
        joint, frame, held_by, latch = 0, base, BASE, self._base_latch
        for member in self.members:
            latched = latch and member.type.latch
            self.connections.append(Connection(held_by, joint, frame, len(self.bodies), latched))
            held_by, latch = f"{member.name}/{member.connector}", member.type.latch
            frame = frame * member.offset
            self._add_links(member.name, pieces_of(member.type.solids, frame), joint)
            self._add_mass(member.type.solids, joint, frame)
            if member.type.servo is not None:
                servo = member.type.servo
                placement = frame * se3(servo.joint)
                axis = se3(servo.joint).rotation.T @ np.array(servo.axis)
                joint = self.model.addJoint(joint, pin.JointModelRevoluteUnaligned(axis), placement, member.name)
                self.joints.append(member.name)
                self._add_links(member.name, pieces_of(servo.output), joint)
                self._add_mass(servo.output, joint, pin.SE3.Identity())
                frame = pin.SE3.Identity()
            if member.connector not in member.type.connectors:
                raise ConfigError(f"{member.name} has no connector {member.connector!r}")
            frame = frame * se3(member.type.connectors[member.connector])
            self.mounts.append((held_by, joint, frame))
        return joint, frame

    def _add_mass(self, solids: Iterable[PartSolid], joint: int, frame: pin.SE3) -> None:
        for solid in solids:
            self.bodies.append((joint, frame.act(solid_inertia(solid))))
            if joint:
                self.model.appendBodyToJoint(joint, solid_inertia(solid), frame)

    def _add_links(self, name: str, pieces: Iterable[Piece], joint: int) -> None:
        self.links += [LinkPiece(name, piece, joint) for piece in pieces]

    def forward(self, positions: Array) -> pin.SE3:
        """The frame of the tip in the world."""
        pin.framesForwardKinematics(self.model, self.data, positions)
        return self.data.oMf[self.tool].copy()

    @property
    def root(self) -> Array:
        """Position of the first joint in the world, metres."""
        return np.array(self.model.jointPlacements[1].translation)

    def solve_from(self, goal: pin.SE3, start: Array) -> Array | None:
        """The posture near `start` with the tip at the place of `goal` and its z along that of `goal`."""
        return self._solve(goal.translation, goal.rotation[:, 2], start)

    def solve_down(self, point: Sequence[float], start: Array) -> Array | None:
        """The posture near `start` with the tip at a point, pointing down; None without one."""
        return self._solve(np.array(point), np.array([0.0, 0.0, -1.0]), start)

    def velocity(self, positions: Array, velocities: Array) -> Array:
        """Linear velocity of the tip in the world, m/s."""
        jacobian = pin.computeFrameJacobian(self.model, self.data, positions, self.tool, pin.LOCAL_WORLD_ALIGNED)
        return np.asarray(jacobian[:3] @ velocities)

    def pointing(
        self, position: Array, direction: Array, near: Array, *, bends: Sequence[float] = BENDS
    ) -> list[Array]:
        """Postures with the tip at a point and its z along a direction, in the world; closest to `near` first."""
        found: list[Array] = []
        for start in self._starts(position, near, bends):
            q = self._solve(position, direction, start)
            if q is None:
                continue
            q = near + np.mod(q - near + math.pi, math.tau) - math.pi
            if all(np.max(np.abs(q - posture)) > 1e-2 for posture in found):
                found.append(q)
        return sorted(found, key=lambda posture: float(np.max(np.abs(posture - near))))

    def _starts(self, position: Array, near: Array, bends: Sequence[float]) -> Iterable[Array]:
        yield near
        count = self.model.nq
        if count < 3:
            return
        first = pin.SE3(self.model.jointPlacements[1])
        local = first.actInv(np.asarray(position))
        yaw = math.atan2(local[1], local[0])
        for turn in (yaw, yaw + math.pi, -yaw, math.pi - yaw):  # the axis may point either way
            for bend in itertools.product(bends, repeat=min(2, count - 2)):
                start = np.zeros(count)
                start[0] = turn
                start[1 : 1 + len(bend)] = bend
                yield start

    def _solve(self, position: Array, direction: Array, start: Array) -> Array | None:
        q = np.array(start)
        for _ in range(MAX_ITERATIONS):
            tip = self.forward(q)
            off = np.concatenate([position - tip.translation, np.cross(tip.rotation[:, 2], direction)])
            facing = float(tip.rotation[:, 2] @ direction)
            if np.max(np.abs(off)) < TOLERANCE:
                return q if facing > 0.0 else None
            off[3:] *= LEAN_WEIGHT
            jacobian = pin.computeFrameJacobian(self.model, self.data, q, self.tool, pin.LOCAL_WORLD_ALIGNED)
            # of the rotation only what turns the z axis counts
            axis = tip.rotation[:, 2]
            across = np.eye(3) - np.outer(axis, axis)
            rows = np.vstack([jacobian[:3], LEAN_WEIGHT * across @ jacobian[3:]])
            step = rows.T @ np.linalg.solve(rows @ rows.T + DAMPING * np.eye(6), off)
            far = float(np.max(np.abs(step)))
            # a joint about the tip's axis may turn on and on without moving it
            settled = np.max(np.abs(rows @ step)) < 0.1 * TOLERANCE
            if settled and np.max(np.abs(off[:3])) < 20.0 * TOLERANCE:
                return q if facing > math.cos(LEANING) else None
            q = q + step * min(1.0, MAX_STEP / max(far, 1e-12))
        return None


class HangingChain(Chain):
    """An arm that stands on its last connector, whose frame in the world is `base`; the first part is free.

    The joints are in the order from there, and their positions are those of the servo modules, as before. The tip is
    the input flange of the first part.
    """

    def _build(self, base: pin.SE3) -> tuple[int, pin.SE3]:
        joint, frame, latch = 0, base, self._base_latch
        for member in reversed(self.members):
            held_by, latched = f"{member.name}/{member.connector}", latch and member.type.latch
            self.connections.append(Connection(held_by, joint, frame * AROUND, len(self.bodies), latched))
            latch = member.type.latch
            frame = frame * se3(member.type.connectors[member.connector]).inverse()
            if member.type.servo is not None:
                servo = member.type.servo
                self._add_mass(servo.output, joint, frame)
                self._add_links(member.name, pieces_of(servo.output, frame), joint)
                axis = se3(servo.joint).rotation.T @ np.array(servo.axis)
                joint = self.model.addJoint(joint, pin.JointModelRevoluteUnaligned(-axis), frame, member.name)
                self.joints.append(member.name)
                frame = se3(servo.joint).inverse()
            self._add_links(member.name, pieces_of(member.type.solids, frame), joint)
            self._add_mass(member.type.solids, joint, frame)
            frame = frame * member.offset.inverse()
        return joint, frame
