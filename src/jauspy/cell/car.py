"""The UR10 builds the car, puts it on the conveyor and the arm on top; the car is then driven over JAUS."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field, replace
from itertools import islice
from typing import Final

import numpy as np
import pinocchio as pin

from jauspy.cell.assembly import GRASPS, Assembler
from jauspy.cell.carrying import HEAVY_TOUCH_SPEED, NEAR_SPEED, PARKED
from jauspy.cell.client import CellClient
from jauspy.cell.frames import Array, se3, se3_of_pose, shifted, turned
from jauspy.cell.handling import LINE_MARGIN, MAX_PLANS, PRESS, SLOW
from jauspy.cell.held_load import inertia_of
from jauspy.cell.interface import GRIPPER
from jauspy.cell.modular_arm import ArmOperator
from jauspy.cell.motion import NoPath, Path
from jauspy.cell.scene import Layout, Piece, connector_frame, pieces_of_part
from jauspy.cell.schedule import TaskFailed
from jauspy.cell.slots import PartResult, Slot, Tip
from jauspy.cell.standing import base_frame, standing_on
from jauspy.platform.modular.connector import ConnectorState
from jauspy.platform.modular.parts import PartKind

CORNERS: Final = ("front_left", "rear_left", "front_right", "rear_right")
TURNER: Final = Slot("wheel servo", ("x5_1_inline",))
WHEEL: Final = Slot("wheel", ("wheel",), "")
CARRY_SPEED: Final = 0.25
"""Fraction of the UR10's speed with the car in the gripper."""
ARM_SPEED: Final = 0.08
"""The same with the arm, whose joints have no power then and are held by friction only."""
LOCKING_TIME: Final = 0.3
"""Seconds in which the gripper's latch has locked, if it does."""
RELEASE_TIME: Final = 0.2
"""Seconds in which a connector has let go."""
BESIDE: Final = (0.015, 0.12)
"""Metres from the middle of the belt towards the UR10, and from the line of the arm against the belt's direction, at
which the car is put down."""
AWAY: Final = 0.1
"""Metres that the gripper moves back from the arm on the car."""
ROOM: Final = 0.42
"""Metres along the belt from the middle of the car to that of a box beside it, which arm and gripper pass."""
ON_BELT: Final = 0.1
"""Metres above or below the belt within which a box lies on it."""
BELT_SPEED: Final = 0.12
"""m/s."""
BEFORE_END: Final = 0.35
"""Metres before the end of the belt to which the car rides."""
RIDE_SLACK: Final = 3.0
"""Seconds more than the belt needs by its speed, in which the car must get there."""
DEEPER: Final = 0.003
"""Metres below where contact is expected to which car and arm are lowered at most: the errors of measured poses."""
DRIVE_EFFORT: Final = 35.0
"""Percent."""
DRIVE_TIME: Final = 4.0
"""Seconds of the drive off the conveyor."""
MOVED: Final = 0.8
"""Metres that the car must have driven."""
NOD: Final = (0.0, 0.25, -0.5, 0.25, 0.6)
"""How far the arm's joints move from upright and back on the driving car, radians."""
NOD_TIME: Final = 1.5


@dataclass(slots=True)
class CarResult:
    """Measurements of building and driving the car."""

    parts: list[PartResult] = field(default_factory=list)
    failed_grasps: list[str] = field(default_factory=list)
    """Reasons of the attempts in which the gripper did not hold the car or the arm, or the car not the arm."""
    build_time: float = 0.0
    load_time: float = 0.0
    """Seconds in which car and arm were put on the conveyor."""
    car_force: float = 0.0
    """Newtons that the gripper measured with the car."""
    arm_force: float = 0.0
    arm_moment: float = 0.0
    """Newtons and newton metres that the gripper measured with the arm."""
    driven: float = 0.0
    """Metres, by the car's pose sensor."""
    arm_error: float = 0.0
    """Largest error of the arm's joints after its motions on the driving car, radians."""
    arm_motions: int = 0


@dataclass(frozen=True, slots=True)
class CarryPlan:
    """Motions of the UR10: to a point before the bracket, close to it, slowly to contact, up with the arm, and over."""

    approach: Path
    near: Path
    touch: Path
    up: Path
    over: Path


class CarTask:
    """Builds, loads and drives the car; the arm stands on `base`, or is built there when the car is loaded."""

    arm: ArmOperator

    def __init__(self, cell: CellClient, layout: Layout, ur10: Assembler, base: str = "platform_1/top") -> None:
        if not layout.setup.car or layout.setup.conveyor is None:
            raise TaskFailed("the cell has no car, or no conveyor")
        self.cell = cell
        self.layout = layout
        self.ur10 = ur10
        self.base = base
        self.car = layout.setup.car
        self.belt = layout.setup.conveyor
        self.result = CarResult()

    async def run(self) -> CarResult:
        """Build the car, put it and the arm on the conveyor, and drive off. Raises `TaskFailed`."""
        begun = self.cell.now()
        for corner in CORNERS:
            await self._build_corner(corner)
        self.result.build_time = self.cell.now() - begun
        begun = self.cell.now()
        await self._make_room()
        await self._load_car()
        self.result.load_time = self.cell.now() - begun
        await self._find_arm()
        begun = self.cell.now()
        await self._load_arm()
        self.result.load_time += self.cell.now() - begun
        await self._drive()
        return self.result

    async def _find_arm(self) -> None:
        """The arm that stands on the base, or a new one that is built there. Raises `TaskFailed`."""
        if not await standing_on(self.cell, self.layout, self.base):
            base, _, connector = self.base.partition("/")
            built = await self.ur10.build(base, connector)
            if built.failure:
                raise TaskFailed(f"the arm was not built: {built.failure}")
            self.result.parts += built.parts
        self.arm = await ArmOperator.found(self.cell, self.layout, self.base)
        self.ur10.know(self._arm_frames(await self.arm.positions()))
        self.ur10.used -= set(self.arm.parts)

    # --- building -------------------------------------------------------------------------------------------------

    async def _build_corner(self, corner: str) -> None:
        ur10 = self.ur10
        await ur10.look()
        pose = ur10.seen[self.car].pose
        frame = pose * connector_frame(self.layout.type_of(self.car), corner)
        tip = Tip(f"{self.car}/{corner}", self.car, frame)
        for slot in (TURNER, WHEEL):
            row = PartResult(f"{slot.name} {corner.replace('_', ' ')}")
            self.result.parts.append(row)
            await ur10.fetch_for(slot, row, tip)
            await ur10.join_to(slot, row, tip)

    # --- loading --------------------------------------------------------------------------------------------------

    def _composite(self, root: str, members: list[str]) -> None:
        """Treat a part with others attached as one: their shapes move with it."""
        scene, handling = self.ur10.scene, self.ur10.handling
        at = scene.poses[root]
        pieces = list(pieces_of_part(self.layout.type_of(root)))
        frames = [(name, at.actInv(scene.poses[name])) for name in members]
        for name, offset in frames:
            pieces += [Piece(piece.shape, offset * piece.frame) for piece in scene.pieces(name)]
        handling.composites[root], handling.members[root] = pieces, frames
        for name in members:
            scene.remove(name)
        self.ur10.carried |= set(members)
        scene.put(root, pieces, at)

    async def _place(self) -> tuple[float, float]:
        """Where the car is put down: x and y in the world, metres."""
        base = (await base_frame(self.cell, self.layout, self.base)).translation
        return self.belt.pose.x - BESIDE[0], float(base[1]) - BESIDE[1]

    async def _make_room(self) -> None:
        """Have the belt take back what lies where the car is to be put. Raises `TaskFailed` if it would fall off."""
        belt, needed = se3_of_pose(self.belt.pose), 0.0
        seen = await self.cell.observe(fresh=True)
        along = {
            name: belt.actInv(part.pose).translation
            for name, part in seen.items()
            if self.layout.type_of(name).kind is PartKind.BOX
        }
        on_belt = [
            float(at[0])
            for at in along.values()
            if abs(at[0]) < self.belt.length / 2.0 and abs(at[1]) < self.belt.width / 2.0 and abs(at[2]) < ON_BELT
        ]
        x, y = await self._place()
        middle = float(belt.actInv(pin.SE3(np.eye(3), np.array([x, y, self.belt.pose.z]))).translation[0])
        for at in on_belt:
            if abs(at - middle) < ROOM:
                needed = max(needed, at - (middle - ROOM))
        if not needed:
            return
        if min(on_belt) - needed < -self.belt.length / 2.0:
            raise TaskFailed("there is no room for the car on the belt: boxes would fall off its beginning")
        await self.cell.run_conveyor(-BELT_SPEED)
        await self.cell.sleep(needed / BELT_SPEED)
        await self.cell.run_conveyor(0.0)

    async def _load_car(self) -> None:
        """Lift the car by its top, and put it on the belt beside the arm."""
        ur10 = self.ur10
        await ur10.look()
        self._composite(self.car, [row.part for row in self.result.parts])
        radius = max(solid.size[0] for solid in self.layout.type_of(self.result.parts[1].part).solids)
        axle = float(connector_frame(self.layout.type_of(self.car), CORNERS[0]).translation[2])
        x, y = await self._place()
        goals = [shifted(x, y, self.belt.pose.z + radius - axle) * turned("z", math.pi / 2.0)]
        row = PartResult("car", self.car)
        for _ in range(GRASPS):
            pose = ur10.scene.poses[self.car]
            plan = ur10.handling.pick(self.car, pose, ur10.at, goals, lift=0.12, supports=["stand"])
            why = await ur10.try_grasp(plan, row, weigh=False)
            if not why:
                break
            self.result.failed_grasps.append(why)
            await ur10.look(fresh=True)
        else:
            raise TaskFailed(f"the car cannot be lifted: {'; '.join(self.result.failed_grasps)}")
        self.result.car_force = row.grasp_force
        held = ur10.held
        assert held is not None
        place = ur10.handling.place(
            self.car, held.grasp, ur10.at, goals, along=shifted(z=0.06), touches=["conveyor"], press=DEEPER
        )
        await ur10.go(place.transfer, speed=CARRY_SPEED, gentle=True)
        state = await self.cell.connector(GRIPPER)
        if state.attached_to != self.car:
            ur10.forget_held()
            raise TaskFailed(f"the car was dropped on the way to the belt: {state.last_error or 'nothing is held'}")
        await ur10.go(place.insert, speed=0.1, contact=True, gentle=True)
        await ur10.press(place.contact)
        await self._release(self.car, place.goal)
        await ur10.go(ur10.handling.retreat(ur10.at, 0.12), speed=0.3, contact=True)

    async def _release(self, part: str, pose: pin.SE3) -> None:
        ur10 = self.ur10
        await self.cell.enable(GRIPPER, False)
        await self.cell.sleep(0.3)
        ur10.forget_held()
        ur10.scene.put(part, ur10.handling.pieces(part), pose)

    async def _load_arm(self) -> None:
        """Turn the arm so that its bracket faces the UR10, and carry it upright onto the car."""
        ur10, arm = self.ur10, self.arm
        await ur10.look()
        grasped = arm.members[1].name
        car = (await self.cell.observe(fresh=True))[self.car].pose
        ur10.scene.put(self.car, ur10.handling.pieces(self.car), car)
        top = car * connector_frame(self.layout.type_of(self.car), "top")
        root = arm.members[0].name
        reasons = []
        for turn in (math.pi, math.pi * 0.75, -math.pi * 0.75, math.pi / 2.0, -math.pi / 2.0, 0.0):
            goal = np.zeros(arm.chain.model.nq)
            goal[0] = turn
            arm_at = self._arm_frames(goal)
            try:
                plan = self._plan_carry(grasped, root, arm_at, top)
            except NoPath as error:
                reasons.append(f"turned by {math.degrees(turn):.0f} degrees: {error}")
                continue
            await arm.go(goal)
            await self._carry(plan, grasped, root, top)
            return
        raise TaskFailed(f"the UR10 cannot carry the arm to the car: {'; '.join(reasons)}")

    def _arm_frames(self, positions: Array) -> dict[str, pin.SE3]:
        """The frames of the arm's parts in the world, in a posture."""
        found, frame = {}, self.arm.base
        by_name = dict(zip(self.arm.chain.joints, positions.tolist(), strict=True))
        for member in self.arm.members:
            frame = frame * member.offset
            found[member.name] = frame
            frame = frame * connector_frame(member.type, member.connector, by_name.get(member.name, 0.0))
        return found

    def _plan_carry(self, grasped: str, root: str, frames: dict[str, pin.SE3], top: pin.SE3) -> CarryPlan:
        """Paths to the bracket, up, and sideways to above the car's connector; the arm stays upright on them."""
        ur10 = self.ur10
        scene, planner, k = ur10.scene, ur10.planner, self.layout.kinematics
        for name, frame in frames.items():
            scene.put(name, pieces_of_part(self.layout.type_of(name)), frame)
        reasons: list[str] = []
        searched: list[str] = []
        second_best: CarryPlan | None = None
        moved = shifted(*(top.translation - frames[root].translation).tolist())
        # a search for a way around obstacles takes seconds to fail: straight parts are planned before, at once
        for lines in islice(self._lines_to_carry(grasped, root, frames, top, reasons), MAX_PLANS):
            try:
                approach = planner.to_posture(ur10.at, lines.near.points[0])
            except NoPath as error:
                searched.append(str(error))
                continue
            plan = replace(lines, approach=approach)
            try:
                self._check_way_out(plan.over.end, moved * k.forward(plan.touch.end), grasped, frames, moved)
            except NoPath:
                second_best = second_best or plan
                continue
            return plan
        if second_best is not None:
            return second_best
        raise NoPath((searched or reasons or ["the bracket is out of reach"])[0])

    def _lines_to_carry(
        self, grasped: str, root: str, frames: dict[str, pin.SE3], top: pin.SE3, reasons: list[str]
    ) -> Iterator[CarryPlan]:
        """All ways to grasp the bracket and to carry the arm whose straight parts are free, without the approach."""
        ur10 = self.ur10
        scene, planner, k = ur10.scene, ur10.planner, self.layout.kinematics
        for grasp in ur10.handling.grasps(grasped):
            contact = frames[grasped] * grasp
            for posture in k.solve(contact * shifted(z=-0.06), ur10.at):
                if not scene.is_free(posture.positions, planner.margin):
                    reasons.append(f"no posture before {grasped} is free")
                    continue
                try:
                    with scene.without(grasped):
                        near = planner.line(posture.positions, contact * shifted(z=-SLOW), margin=-0.002)
                        touch = planner.line(near.end, contact * shifted(z=PRESS), margin=-0.002)
                    up, over = self._plan_across(touch.end, contact, frames, root, top)
                except NoPath as error:
                    reasons.append(str(error))
                else:
                    yield CarryPlan(Path((posture.positions,)), near, touch, up, over)

    def _plan_across(
        self, start: Array, contact: pin.SE3, frames: dict[str, pin.SE3], root: str, top: pin.SE3
    ) -> tuple[Path, Path]:
        scene, planner = self.ur10.scene, self.ur10.planner
        pieces = [
            Piece(piece.shape, contact.actInv(frame) * piece.frame)
            for name, frame in frames.items()
            for piece in pieces_of_part(self.layout.type_of(name))
        ]
        foot = frames[root]
        try:
            for name in frames:
                scene.remove(name)
            scene.hold("the arm", pieces, pin.SE3.Identity())
            rise = float(top.translation[2] - foot.translation[2]) + 0.08
            # the foot goes up, across to above the car, and down; it keeps its heading
            raised = shifted(z=max(rise, 0.05)) * contact
            move = top.translation - foot.translation
            across = shifted(float(move[0]), float(move[1])) * raised
            with scene.without("platform_1"):
                up = planner.line(start, raised, margin=LINE_MARGIN)
            over = planner.line(up.end, across, margin=LINE_MARGIN)
            return up, over
        finally:
            scene.release()
            for name, frame in frames.items():
                scene.put(name, pieces_of_part(self.layout.type_of(name)), frame)

    def _check_way_out(
        self, above: Array, tool: pin.SE3, grasped: str, frames: Mapping[str, pin.SE3], moved: pin.SE3
    ) -> None:
        """Check that the gripper gets away from the arm on the car, to where `moved` takes it, and the UR10 parks.

        `tool` is the gripper's frame then. Raises `NoPath`.
        """
        ur10 = self.ur10
        scene, planner = ur10.scene, ur10.planner
        try:
            for name, frame in frames.items():
                scene.put(name, pieces_of_part(self.layout.type_of(name)), moved * frame)
            with scene.without(grasped):
                put = planner.line(above, tool)
                back = ur10.handling.retreat(put.end, AWAY)
            if back.clearance.distance < 0.0:
                raise NoPath(f"the gripper could not get away: {' and '.join(back.clearance.between)} would touch")
            planner.to_posture(back.end, PARKED)
        finally:
            for name, frame in frames.items():
                scene.put(name, pieces_of_part(self.layout.type_of(name)), frame)

    async def _carry(self, plan: CarryPlan, grasped: str, root: str, top: pin.SE3) -> None:
        ur10, arm = self.ur10, self.arm
        base = arm.base_name
        await ur10.go(plan.approach)
        for _ in range(GRASPS):
            await self.cell.enable(GRIPPER, True)
            await ur10.go(plan.near, speed=NEAR_SPEED, contact=True)
            backward = self.layout.kinematics.forward(plan.touch.end) * turned("x", math.pi)
            state = await ur10.touch(plan.touch, GRIPPER, backward, speed=HEAVY_TOUCH_SPEED)
            if state.attached_to == grasped:
                await self.cell.sleep(LOCKING_TIME)
                state = await self.cell.connector(GRIPPER)
            if state.attached_to == grasped and state.latched:
                break
            self.result.failed_grasps.append(state.last_error or f"nothing attaches to {grasped}")
            await self.cell.enable(GRIPPER, False)
            await ur10.go(Path((ur10.at, *plan.near.points[::-1])), speed=0.1, contact=True)
        else:
            raise TaskFailed(f"the gripper does not lock {grasped}: {'; '.join(self.result.failed_grasps)}")
        frames = self._arm_frames(arm.last_goal)
        load = inertia_of([(member.type, frames[member.name]) for member in arm.members])
        await ur10.take_up(load.mass, load.lever)
        for part in arm.parts:
            await self.cell.leave(part)
        await self.cell.enable(base, False)
        await self.cell.sleep(RELEASE_TIME)
        tool = self.layout.kinematics.forward(ur10.at)
        foot = tool * se3(state.offset) * self._root_from(grasped, root)
        first = self.layout.kinematics.forward(plan.up.points[0])
        shift = shifted(*(tool.translation - first.translation).tolist())
        for path in (plan.up, plan.over):
            goal = shift * self.layout.kinematics.forward(path.end)
            await ur10.go(ur10.planner.line(ur10.at, goal), speed=ARM_SPEED, contact=True, gentle=True)
        state = await self.cell.connector(GRIPPER)
        self.result.arm_force, self.result.arm_moment = state.force, state.moment
        # the foot now hangs over the car: put it down where the connector is
        tool = self.layout.kinematics.forward(ur10.at)
        foot = tool * se3(state.offset) * self._root_from(grasped, root)
        state = await self._put_on_top(top.translation - foot.translation, root, top)
        frames = self._arm_frames(self.arm.last_goal)
        stands = top * se3(state.offset) * frames[root].inverse()
        ur10.know({name: stands * frame for name, frame in frames.items()})
        await self.cell.enable(GRIPPER, False)
        await self.cell.sleep(RELEASE_TIME)
        await ur10.go(ur10.handling.retreat(ur10.at, AWAY), speed=0.2, contact=True)

    async def _put_on_top(self, move: Array, root: str, top: pin.SE3) -> ConnectorState:
        """Lower the arm by `move` until the car's connector locks its foot; where it does not, by what it reports."""
        ur10, connector = self.ur10, f"{self.car}/top"
        for _ in range(GRASPS):
            tool = self.layout.kinematics.forward(ur10.at)
            above = shifted(float(move[0]), float(move[1]), float(move[2]) + SLOW) * tool
            down = shifted(float(move[0]), float(move[1]), float(move[2]) - DEEPER) * tool
            await ur10.go(ur10.planner.line(ur10.at, above), speed=ARM_SPEED, contact=True, gentle=True)
            await ur10.press(ur10.planner.line(ur10.at, down))
            await self.cell.enable(connector, True)
            state = await ur10.touch(Path((ur10.at,)), connector, top)
            if state.attached_to == root and state.latched:
                return state
            self.result.failed_grasps.append(state.last_error or f"nothing attaches to {connector}")
            off = top.rotation @ np.asarray(state.offset.position) if state.attached_to == root else np.zeros(3)
            await self.cell.enable(connector, False)
            await self.cell.sleep(RELEASE_TIME)
            landed = self.layout.kinematics.forward(ur10.at)
            raised = ur10.planner.line(ur10.at, shifted(z=SLOW) * landed)
            await ur10.go(raised, speed=NEAR_SPEED, contact=True, gentle=True)
            move = np.array((-off[0], -off[1], -SLOW))
        raise TaskFailed(f"{connector} does not hold the arm: {'; '.join(self.result.failed_grasps[-GRASPS:])}")

    def _root_from(self, grasped: str, root: str) -> pin.SE3:
        """The frame of the arm's first part in that of the one that is held, where the joints went last."""
        frames = self._arm_frames(self.arm.last_goal)
        return frames[grasped].actInv(frames[root])

    # --- driving --------------------------------------------------------------------------------------------------

    async def _ride(self) -> None:
        """Have the belt carry the car to its end. Raises `TaskFailed` if the car does not get there."""
        begun = self.cell.now()
        seen, left = self._ride_left()
        until = begun + left / BELT_SPEED + RIDE_SLACK
        await self.cell.run_conveyor(BELT_SPEED)
        try:
            while left >= 0.0:
                if (now := self.cell.now()) > until:
                    raise TaskFailed(
                        f"the car is {left:.2f} m short of the end of the belt after {now - begun:.1f} s; "
                        f"the sensor saw it {max(0.0, now - seen):.1f} s ago"
                    )
                await self.cell.sleep(0.1)
                seen, left = self._ride_left()
        finally:
            await self.cell.run_conveyor(0.0)

    def _ride_left(self) -> tuple[float, float]:
        """When the car was seen last, and the metres that it had to ride on the belt then."""
        seen, pose = self.cell.latest(self.car)
        along = float(se3_of_pose(self.belt.pose).actInv(pose).translation[0])
        return seen, self.belt.length / 2.0 - BEFORE_END - along

    async def _drive(self) -> None:
        """Ride on the belt, drive off its end, and move the arm meanwhile."""
        arm = self.arm
        await self.ur10.park()
        await arm.ready()
        await self._ride()
        robot = await self.cell.car()
        start = await robot.pose()
        upright = arm.last_goal
        goals = (upright + np.array(NOD), upright)
        until = self.cell.now() + DRIVE_TIME
        await robot.drive_effort(DRIVE_EFFORT)
        while self.cell.now() < until:
            goal = goals[self.result.arm_motions % 2]
            await arm.move(goal, NOD_TIME)
            off = float(np.max(np.abs(await arm.positions() - goal)))
            self.result.arm_error = max(self.result.arm_error, off)
            self.result.arm_motions += 1
            await robot.drive_effort(DRIVE_EFFORT)
        await robot.stop()
        await self.cell.sleep(1.0)
        end_pose = await robot.pose()
        self.result.driven = math.dist((start.x, start.y), (end_pose.x, end_pose.y))
