"""The task of a trial: the UR10 fills trays for orders, and decides anew after each product what comes next.

Each grasp, transport and test is verified by what components report: a part that lies upside down by the part sensor,
a dropped one by the gripper's vacuum, a faulty servo module by its motion on the base for quality control.
"""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Coroutine, Sequence
from contextlib import suppress
from dataclasses import dataclass, field
from functools import partial
from typing import Any, Final

import pinocchio as pin

from jauspy.cell.ariac.belt import STILL, BeltPicker
from jauspy.cell.ariac.board import OpenOrder, OrderBoard
from jauspy.cell.ariac.workcell import PLACES, QUALITY_CONTROL, TrayPlace
from jauspy.cell.assembly import Assembler
from jauspy.cell.carrying import INSERT_SPEED
from jauspy.cell.client import SILENT, CellClient
from jauspy.cell.frames import se3_of_pose, shifted, turned
from jauspy.cell.handling import APPROACH, CONDITION, TURNS
from jauspy.cell.interface import GRIPPER
from jauspy.cell.scene import Layout, connector_frame
from jauspy.cell.schedule import TaskFailed
from jauspy.cell.slots import PartResult, Slot, Tip
from jauspy.errors import JausError
from jauspy.platform.modular.parts import PartKind

ABOVE: Final = 0.06
"""Metres above its place from which a part is lowered."""
DROP: Final = 0.002
"""Metres above the tray at which a part that does not report contact is let go of."""
ATTEMPTS: Final = 3
"""Attempts to put a product into its quadrant before its order is submitted without it."""
PARTS: Final = 4
"""Parts of a type that are tried for one product."""
TEST_ANGLE: Final = 0.3
TEST_TIME: Final = 0.6
"""Radians and seconds of the motion by which a servo module is tested."""
TEST_ERROR: Final = 0.03
"""Radians from the goal of the test within which a module has passed."""
POWER_TIME: Final = 3.0
"""Seconds in which a module on the base for quality control must have power."""
BASE_TURNS: Final = 8
"""Angles about its axis at which a part may stand on the base."""
YAWS: Final = (math.pi / 2.0, -math.pi / 2.0)
"""Turns of a part on a tray: the longer side of a quadrant is along y."""
MIN_UPRIGHT: Final = 0.7
"""Cosine of the slope of a face up to which a part can be grasped there from above."""
WAIT: Final = 0.1
RELEASE_TIME: Final = 0.15
GONE: Final = 0.5
"""Seconds after a drop from which on an observation says where the part has come to rest."""


class Dropped(TaskFailed):
    """The gripper has lost what it held."""


@dataclass(slots=True)
class PackerLog:
    """What the task did, for measurements."""

    lines: list[str] = field(default_factory=list)
    turned_over: list[str] = field(default_factory=list)
    rejected_by_test: list[str] = field(default_factory=list)
    lost: list[str] = field(default_factory=list)
    removed: list[str] = field(default_factory=list)


class Packer(Assembler):
    """Fills the trays of a board's orders with the UR10."""

    def __init__(self, cell: CellClient, layout: Layout, board: OrderBoard, *, seed: int = 0) -> None:
        super().__init__(cell, layout, seed=seed)
        self.client = cell
        self.board = board
        self.log = PackerLog()
        self.trays: dict[int, dict[int, str]] = {number: {} for number in PLACES}
        """Parts on each tray, by quadrant."""
        self.belt = BeltPicker(self, cell, self._hold_as_reported)
        self._failures: Counter[tuple[str, int, str]] = Counter()
        self._dropped: dict[str, float] = {}
        self._base = f"{QUALITY_CONTROL}/{next(iter(layout.type_of(QUALITY_CONTROL).connectors))}"

    # --- orders ---------------------------------------------------------------------------------------------------

    async def run(self) -> None:
        """Work until all orders are submitted, and no further one will come."""
        while not self.board.is_done:
            order = self.board.most_urgent()
            if order is None:
                await self.cell.sleep(WAIT)
            else:
                await self._advance(order)

    async def _advance(self, order: OpenOrder) -> None:
        """The next step of an order: take away what it does not want, add what is missing, or submit it."""
        tray = self.trays[order.tray]
        for quadrant, part in list(tray.items()):
            if not self._fits(part, order.products.get(quadrant, "")):
                await self._guarded(order, quadrant, self._remove(order.tray, quadrant))
                return
        for quadrant, type in await self._by_urgency(order):
            if quadrant not in tray and self._failures[order.id, quadrant, type] < ATTEMPTS:
                await self._guarded(order, quadrant, self._supply(order, quadrant, type))
                return
        self.board.submit(order.id)
        for part in tray.values():
            self.scene.remove(part)
        tray.clear()

    async def _by_urgency(self, order: OpenOrder) -> list[tuple[int, str]]:
        """The products of an order by quadrant: those that come on a moving belt first, since they leave it."""
        products = list(order.products.items())
        if abs(await self.belt.speed()) > STILL:
            self.seen = await self.cell.observe()
            products.sort(key=lambda product: not any(self._is_on_belt(part) for part in self._left(product[1])))
        return products

    def _is_on_belt(self, part: str) -> bool:
        return self.belt.is_on_belt(part, self.seen[part].pose)

    def _fits(self, part: str, type: str) -> bool:
        """True if a part is of a type, or was taken for it because there was no other."""
        have = self.layout.type_of(part)
        return bool(type) and (have.name == type or (have.name in self._substitutes(type) and not self._left(type)))

    async def _guarded(self, order: OpenOrder, quadrant: int, work: Coroutine[Any, Any, None]) -> None:
        try:
            await work
        except JausError as error:
            type = order.products.get(quadrant, "")
            self._failures[order.id, quadrant, type] += 1
            self.log.lines.append(f"{order.id}, quadrant {quadrant}: {error}")
            await self._recover()

    async def _recover(self) -> None:
        """Leave the gripper empty, and the UR10 clear of what it was about to touch."""
        self.at = await self.cell.posture()
        if self.held is not None and (await self.cell.connector(GRIPPER)).attached_to == self.held.name:
            with suppress(JausError):
                await self.put_down(self.held.name)
        if self.held is not None:
            self._drop(self.held.name)
        await self.cell.enable(GRIPPER, False)
        with suppress(JausError):
            await self.go(self.handling.retreat(self.at, 0.05), contact=True)
        await self._clear_base()

    async def _clear_base(self) -> None:
        """Take a part off the base that could not be taken off before, by any face, and put it down."""
        part = (await self.cell.connector(self._base)).attached_to
        if part:
            for face in self.layout.grasps(part):
                try:
                    await self._take_off(part, [], face=face)
                    await self.put_down(part)
                except JausError as error:
                    self.log.lines.append(f"{part} stays on {self._base}: {error}")
                else:
                    return

    async def _supply(self, order: OpenOrder, quadrant: int, type: str) -> None:
        """Fetch a product, and put it where it is wanted by then."""
        part = await self._take(type, PLACES[order.tray], quadrant)
        target = self._target(order, quadrant, part)
        if target is None:
            self.log.lines.append(f"{part} is not wanted any more")
            await self.put_down(part)
            self.rejected.discard(part)
            return
        await self._put(part, *target)

    def _target(self, order: OpenOrder, quadrant: int, part: str) -> tuple[int, int] | None:
        """Tray and quadrant for a part in the gripper: those that it was fetched for, or others that want its type."""
        if order.submitted is None and self._fits(part, order.products.get(quadrant, "")):
            return order.tray, quadrant
        type = self.layout.type_of(part).name
        for other in self.board.orders.values():
            for free, wanted in other.products.items():
                if other.submitted is None and wanted == type and free not in self.trays[other.tray]:
                    return other.tray, free
        return None

    # --- parts ----------------------------------------------------------------------------------------------------

    def _left(self, type: str) -> list[str]:
        """The parts of a type that can be taken, the easiest first."""
        found = []
        for name in self.layout.of_types((type,)):
            if name not in self.seen or name in self.rejected or name in self.used or not self._is_known(name):
                continue
            if not self._lies_wrongly(name) or self.layout.type_of(name).further_grasps:
                found.append(name)
        return sorted(found, key=lambda name: (name in self._dropped, self._lies_wrongly(name)))

    def _lies_wrongly(self, part: str) -> bool:
        """True if a part is to be turned over before it is laid on a tray."""
        return self._upright(part) < MIN_UPRIGHT

    def _upright(self, part: str) -> float:
        """The cosine between the world's z axis and the normal of the face at which a part is grasped, as seen."""
        return -float((self.seen[part].pose * self.layout.grasp(part)).rotation[2, 2])

    def _is_known(self, part: str) -> bool:
        """True unless a part was dropped after it was last seen."""
        seen = self.cell.now() - self.client.silence() - self.seen[part].age
        return seen > self._dropped.get(part, -math.inf) + GONE

    def _substitutes(self, type: str) -> list[str]:
        """Other types of the same kind."""
        types = self.layout.setup.types
        return [name for name, other in types.items() if other.kind is types[type].kind and name != type]

    async def _next(self, type: str) -> str | None:
        """The part to take for a product: of its type, or of another of the same kind if there is none."""
        moves = abs(await self.belt.speed()) > STILL
        for wanted in (type, *self._substitutes(type)):
            found = self._left(wanted)
            carried = [part for part in found if moves and self._is_on_belt(part)]
            found = [part for part in found if part not in carried] + self.belt.coming(carried)
            if found:
                return found[0]
        return None

    async def look(self, *, fresh: bool = False) -> None:
        """Same as for an assembly, with the space that parts on a moving belt need."""
        await super().look(fresh=fresh)
        await self.belt.fence()

    async def _see(self, part: str) -> bool:
        """Same as for an assembly; while the sensor is silent, parts are where they were seen last."""
        if self.client.silence() > SILENT:
            return part in self.seen
        return await super()._see(part)

    async def _take(self, type: str, place: TrayPlace, quadrant: int) -> str:
        """Grasp a part for a product, turned over if it lies upside down, and tested if it is a servo module."""
        reasons: list[str] = []
        for _ in range(PARTS):
            await self.look()
            part = await self._next(type)
            if part is None:
                break
            kind = self.layout.type_of(part)
            flipped, tested = self._lies_wrongly(part), kind.kind is PartKind.SERVO
            row = PartResult(type, part)
            if self._is_on_belt(part) and abs(await self.belt.speed()) > STILL:
                if not (why := await self.belt.pick(part, row)):
                    return part
                reasons.append(f"{part}: {why}")
                continue
            goals = self.tray_goals(part, place, quadrant)
            via_base = flipped or tested
            stands = await self.cell.compute(partial(self._base_goals, part, goals)) if via_base else []
            grasped = await self._grasp(part, row, stands or goals)
            if grasped and via_base:
                await self._stand(part, row, stands)
            reasons += row.attempts
            if not grasped:
                self.rejected.add(part)
                continue
            if not via_base:
                return part
            passed = not tested or await self._passes(part)
            await self._take_off(part, goals if passed else [])
            if passed:
                self.log.turned_over += [part] * flipped
                return part
            self.log.rejected_by_test.append(part)
            await self.put_down(part)
        raise TaskFailed(f"no {type} could be had: {'; '.join(reasons) or 'none is left'}")

    # --- trays ----------------------------------------------------------------------------------------------------

    def tray_goals(self, part: str, place: TrayPlace, quadrant: int) -> list[pin.SE3]:
        """The frames in the world of a part in a quadrant, with its grasp upward."""
        x, y = place.quadrant(quadrant)
        top = shifted(x, y, float(place.frame.translation[2]) + self.layout.thickness(part))
        back = self.layout.grasp(part).inverse()
        return [top * turned("z", yaw) * turned("x", math.pi) * back for yaw in YAWS]

    async def _put(self, part: str, tray: int, quadrant: int) -> None:
        """Lay the held part into a quadrant, and let go of it."""
        held, place = self.held, PLACES[tray]
        if held is None:
            raise TaskFailed(f"{part} is not in the gripper")
        await self.look()
        goals = self.tray_goals(part, place, quadrant)
        plan = await self.cell.compute(
            partial(
                self.handling.place,
                part,
                held.grasp,
                self.at,
                goals,
                along=shifted(z=ABOVE),
                touches=[place.name],
                press=-DROP,
            )
        )
        await self.go(plan.transfer)
        await self._check_held(part)
        await self.go(plan.insert, speed=INSERT_SPEED, contact=True)
        await self.press(plan.contact)
        await self._check_held(part)
        await self.cell.enable(GRIPPER, False)
        await self.cell.sleep(RELEASE_TIME)
        self.held = None
        self.scene.release()
        self.used.add(part)
        self.scene.put(part, self.handling.pieces(part), plan.goal)
        self.trays[tray][quadrant] = part
        await self.go(self.handling.retreat(self.at, ABOVE), contact=True)

    async def _check_held(self, part: str) -> None:
        """Raise `Dropped` if the gripper reports that it does not hold the part."""
        state = await self.cell.connector(GRIPPER)
        if state.attached_to == part:
            return
        self._drop(part)
        self._dropped[part] = self.cell.now()
        self.log.lost.append(part)
        raise Dropped(f"{part} was lost: {state.last_error or 'the gripper holds nothing'}")

    async def _remove(self, tray: int, quadrant: int) -> None:
        """Take a part off a tray, and put it where it is wanted, or down."""
        part = self.trays[tray][quadrant]
        pose = self.scene.poses[part]
        pick = partial(self.handling.pick, part, pose, self.at, supports=[PLACES[tray].name])
        why = await self.try_grasp(await self.cell.compute(pick), PartResult("", part))
        if why:
            raise TaskFailed(f"{part} could not be taken off its tray: {why}")
        del self.trays[tray][quadrant]
        self.used.discard(part)
        self.log.removed.append(part)
        for order in self.board.orders.values():
            if order.submitted is None and (target := self._target(order, 0, part)) is not None:
                await self._put(part, *target)
                return
        await self.put_down(part)
        self.rejected.discard(part)

    # --- the base for quality control -----------------------------------------------------------------------------

    def _base_goals(self, part: str, goals: Sequence[pin.SE3]) -> list[pin.SE3]:
        """The frames in the world of a part on the base, from which it can be taken as its type says to its goals."""
        frames = [self._base_frame() * turned("z", number * math.tau / BASE_TURNS) for number in range(BASE_TURNS)]
        return [frame for frame in frames if self._can_be_taken(part, frame, goals)]

    def _can_be_taken(self, part: str, frame: pin.SE3, goals: Sequence[pin.SE3]) -> bool:
        """True if the UR10 can reach for a part at `frame`, and from there for one of `goals`."""
        k, scene = self.layout.kinematics, self.scene
        for number in range(TURNS):
            grasp = self.layout.grasp(part) * turned("z", math.tau * number / TURNS)
            for posture in k.solve(frame * grasp * shifted(z=-APPROACH), self.at, condition=CONDITION):
                if scene.is_free(posture.positions, self.planner.margin) and any(
                    k.solve(goal * shifted(z=ABOVE) * grasp, posture.positions, condition=CONDITION) for goal in goals
                ):
                    return True
        return False

    def _base_frame(self) -> pin.SE3:
        owner, _, name = self._base.partition("/")
        (base,) = (part for part in self.layout.setup.parts if part.name == owner)
        return se3_of_pose(base.pose) * connector_frame(self.layout.type_of(owner), name)

    async def _stand(self, part: str, row: PartResult, goals: list[pin.SE3]) -> None:
        """Attach the held part to the base, and let go of it."""
        tip = Tip(self._base, QUALITY_CONTROL, self._base_frame())
        if not await self.join(Slot(self._base, (row.slot,)), row, tip, goals):
            await self.cell.enable(self._base, False)
            if self.held is None and (await self.cell.connector(GRIPPER)).attached_to != part:
                self._dropped[part] = self.cell.now()
            raise TaskFailed(f"{part} does not stand on {self._base}: {'; '.join(row.attempts)}")

    async def _take_off(self, part: str, goals: Sequence[pin.SE3], face: pin.SE3 | None = None) -> None:
        """Grasp a part that stands on the base, by its usual face or another one, and take it off."""
        pose, row = self.scene.poses[part], PartResult(self._base, part)
        face = face or self.layout.grasp(part)
        for attempt in range(ATTEMPTS):
            pick = partial(
                self.handling.pick, part, pose, self.at, goals, supports=[QUALITY_CONTROL], skip=attempt, face=face
            )
            why = await self.try_grasp(await self.cell.compute(pick), row, release=self._base)
            if not why:
                self.used.discard(part)
                return
            row.attempts.append(why)
            if (await self.cell.connector(self._base)).attached_to != part:
                self._dropped[part] = self.cell.now()
                raise Dropped(f"{part} was lost when it was taken off {self._base}: {why}")
        raise TaskFailed(f"{part} could not be taken off {self._base}: {'; '.join(row.attempts)}")

    async def _passes(self, part: str) -> bool:
        """True if a servo module on the base turns to and fro as commanded."""
        until = self.cell.now() + POWER_TIME
        while part not in (state := await self.cell.arm()).joints:
            if self.cell.now() > until:
                return False
            await self.cell.sleep(WAIT)
        index = state.joints.index(part)
        for angle in (state.positions[index] + TEST_ANGLE, state.positions[index]):
            goal = [math.nan] * len(state.joints)
            goal[index] = angle
            await self.client.command_arm(goal, TEST_TIME)
            await self.cell.sleep(2.0 * TEST_TIME)
            if abs((await self.cell.arm()).positions[index] - angle) > TEST_ERROR:
                return False
        return True
