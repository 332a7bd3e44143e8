"""Kitting orders in the style of ARIAC 2018: products to a tray by pose, scored by its rules.

NIST, "Agile Robotics for Industrial Automation Competition 2018", scoring of a shipment: one point for each product of
a right type, one more if its pose is within 3 cm and 0.1 rad, and as many points again as there are products when all
are right and nothing else is there.
"""

from __future__ import annotations

import math
from collections.abc import Awaitable, Callable, Collection, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, field
from typing import Final

import coal
import numpy as np
import pinocchio as pin

from jauspy.cell.assembly import Assembler
from jauspy.cell.carrying import PARKED
from jauspy.cell.client import CellClient
from jauspy.cell.frames import Array, se3, shifted, turned
from jauspy.cell.interface import GRIPPER
from jauspy.cell.modular_arm import PRESS, TOUCH, ArmOperator
from jauspy.cell.motion import NoPath
from jauspy.cell.scene import Layout, Piece
from jauspy.cell.schedule import Schedule, TaskFailed, Timeline
from jauspy.cell.shares import ALONE, Planned, Share, StepTimes, best_share, estimated
from jauspy.cell.slots import PartResult, Slot
from jauspy.errors import JausError
from jauspy.platform.modular.parts import PartKind

MAX_DISTANCE: Final = 0.03
MAX_ANGLE: Final = 0.1
"""Metres and radians within which a product counts as in its pose."""
TRAY: Final = (0.97, 0.5)
"""The middle of the tray on the belt, metres in the world; its axes are those of the world."""
ARM_ZONE: Final = ((0.5, 1.4), (-0.5, 0.8), (0.25, 1.6))
"""x, y and z of the space that the modular arm may use while the UR10 is at the bins, metres."""
DROP: Final = 0.003
"""Metres above the belt at which products are let go of."""
ABOVE: Final = 0.07
REST: Final = np.array([-1.2, 0.9, 1.5, 0.5, 0.0])
"""Posture of an arm with five joints in which it is out of the UR10's way to the tray, radians."""
ADVANCE: Final = 0.39
"""Metres by which the belt brings the boxes nearer before the first order."""
ADVANCE_SPEED: Final = 0.15
TOUCH_TIME: Final = 1.0
"""Seconds of the modular arm's slow motion into contact with a box: at most 11 mm/s."""
STEP_TIMES: Final = {"fetch": 4.4, "fetch box": 3.5, "place": 4.3, "take": 3.9, "put": 7.6}
"""Seconds of steps until some were measured: means of orders of this cell; "take" has 0.8 s more than its mean before
boxes were touched slowly."""
ARM_TIME: Final = 0.8
"""Seconds of the modular arm's short straight motions."""


@dataclass(frozen=True, slots=True)
class Product:
    """One product of an order: its type and its place on the tray: x, y (m) and yaw (rad) in the tray's frame."""

    type: str
    x: float
    y: float
    yaw: float = 0.0


@dataclass(slots=True)
class Kit:
    """Products that were put on the tray."""

    products: list[tuple[Product, str]] = field(default_factory=list)
    """Each product, and the part that was taken for it."""
    failures: list[str] = field(default_factory=list)
    timeline: Timeline = field(default_factory=Timeline)
    time: float = 0.0
    """Seconds from the start of the order until both arms had done their part."""
    share: Share = ALONE
    """What the modular arm did, and the estimates."""


def drawn_order(seed: int) -> tuple[Product, ...]:
    """An order of two products from the bins and two boxes from the belt, with places that are drawn with a seed."""
    random = np.random.default_rng((2018, seed))
    kinds = list(random.permutation(["bracket_angled", "tube_long", "wheel"]))[:2]
    places = [(-0.10, 0.16), (0.10, 0.16), (-0.10, -0.12), (0.12, -0.12)]
    found = []
    for kind, (x, y) in zip([*kinds, "box", "box"], places, strict=True):
        dx, dy = random.uniform(-0.015, 0.015, 2)
        yaw = float(random.uniform(-0.4, 0.4))
        found.append(Product(str(kind), x + float(dx), y + float(dy), yaw))
    return tuple(found)


def score(placed: Mapping[int, tuple[float, float]], count: int, extra: int = 0) -> int:
    """The points of a kit of `count` products.

    `placed`: for each product that is on the tray, by number, the distance (m) and angle (rad) from its pose. `extra`:
    how many other things are on the tray.
    """
    right = [number for number, (far, turn) in placed.items() if far <= MAX_DISTANCE and turn <= MAX_ANGLE]
    whole = len(right) == count and not extra
    return len(placed) + len(right) + (count if whole else 0)


class Kitter:
    """Carries out orders with the UR10, and with a modular arm if there is one."""

    def __init__(self, cell: CellClient, layout: Layout, ur10: Assembler, arm: ArmOperator | None = None) -> None:
        if layout.setup.conveyor is None:
            raise TaskFailed("the cell has no conveyor, on which the tray is")
        self.cell = cell
        self.layout = layout
        self.ur10 = ur10
        self.arm = arm
        self.tray = shifted(*TRAY, layout.setup.conveyor.pose.z)
        self.times = StepTimes(STEP_TIMES)
        self._states: dict[tuple[int, int], dict[str, str]] = {}
        self._taken: set[str] = set()
        self._boxes = [part.name for part in layout.setup.parts if layout.type_of(part.name).kind is PartKind.BOX]

    # --- poses ----------------------------------------------------------------------------------------------------

    def goal(self, product: Product, part: str) -> pin.SE3:
        """The frame in the world of a part in its place, with its grasp upward."""
        down = turned("z", product.yaw) * turned("x", math.pi)
        held = self.tray * shifted(product.x, product.y, self.layout.thickness(part)) * down
        return held * self.layout.grasp(part).inverse()

    # --- orders ---------------------------------------------------------------------------------------------------

    async def prepare(self) -> None:
        """Bring the boxes nearer, and the modular arm out of the UR10's way."""
        await self.cell.run_conveyor(ADVANCE_SPEED)
        await self.cell.sleep(ADVANCE / ADVANCE_SPEED)
        await self.cell.run_conveyor(0.0)
        await self.cell.observe(fresh=True)
        if self.arm is not None:
            await self.arm.look(*self._boxes)
            await self.arm.go(REST)

    async def fill(self, order: Sequence[Product], by_arm: Collection[int] | None = None) -> Kit:
        """Carry out one order; what fails is left out, and named in the kit.

        `by_arm` are the numbers of the boxes that the modular arm moves; by default those with which the order is
        estimated to be done sooner.
        """
        possible = [n for n, product in enumerate(order) if product.type == "box"] if self.arm is not None else []
        share = best_share(possible if by_arm is None else (), lambda chosen: self._planned(order, chosen))
        if by_arm is not None:
            chosen = frozenset(by_arm)
            share = Share(chosen, share.alone, estimated(self._planned(order, chosen)))
        kit = Kit(share=share)
        begun = self.cell.now()
        schedule = Schedule(self.cell.now)
        for action in self._planned(order, share.by_arm):
            number = int(action.name.split()[-1])
            run = self._work(action.name.split()[0], order[number], number, share.by_arm, kit)
            schedule.add(action.name, run, after=action.after, uses=action.uses)
        kit.timeline = await schedule.run()
        kit.time = self.cell.now() - begun
        self.times.learn(kit.timeline, self._kinds(order))
        return kit

    def _kinds(self, order: Sequence[Product]) -> dict[str, str]:
        """The kind of each possible action, by its name, for the times of steps."""
        kinds = {f"{verb} {n}": verb for n in range(len(order)) for verb in ("fetch", "place", "take", "put")}
        return kinds | {f"fetch {n}": "fetch box" for n, product in enumerate(order) if product.type == "box"}

    def _planned(self, order: Sequence[Product], by_arm: frozenset[int]) -> list[Planned]:
        """The actions of an order: those of the UR10 one after the other, those of the modular arm beside them.

        While the UR10 is at the tray or at the belt, the modular arm stands still.
        """
        kinds = self._kinds(order)

        def planned(name: str, after: Sequence[str], *uses: str) -> Planned:
            return Planned(name, self.times[kinds[name]], tuple(after), frozenset(uses))

        found: list[Planned] = []
        places: list[str] = []
        for number, product in enumerate(order):
            if number not in by_arm:
                at_belt = ("arm",) if product.type == "box" and self.arm is not None else ()
                found.append(planned(f"fetch {number}", places[-1:], "ur10", *at_belt))
                places.append(f"place {number}")
                found.append(planned(f"place {number}", [f"fetch {number}"], "ur10", "arm", "tray"))
        put: list[str] = []
        for count, number in enumerate(sorted(by_arm)):
            found.append(planned(f"take {number}", put, "arm"))
            put = [f"put {number}"]
            # not earlier, or the UR10 would wait with its product until the box is on the tray
            found.append(planned(f"put {number}", [f"take {number}", *places[count : count + 1]], "arm", "tray"))
        return found

    def _work(
        self, verb: str, product: Product, number: int, by_arm: frozenset[int], kit: Kit
    ) -> Callable[[], Awaitable[None]]:
        """The coroutine function of an action."""
        state = self._states.setdefault((id(kit), number), {})

        async def work() -> None:
            if verb == "fetch":
                await self._guarded(self._fetch(product, state), product, kit)
            elif verb == "take":
                await self._guarded(self._take_box(state), product, kit)
            elif state and number in by_arm:
                await self._guarded(self._put_box(product, state["part"], kit), product, kit)
            elif state:
                await self._guarded(self._place(product, state["part"], kit), product, kit)

        return work

    async def _guarded(self, work: Awaitable[None], product: Product, kit: Kit) -> None:
        try:
            await work
        except JausError as error:
            kit.failures.append(f"{product.type}: {error}")
            if self.ur10.held is not None:
                await self.cell.enable(GRIPPER, False)
                self.ur10.forget_held()

    async def _fetch(self, product: Product, state: dict[str, str]) -> None:
        """The UR10 grasps a product, outside the space of the modular arm if there is one."""
        ur10 = self.ur10
        slot = Slot(product.type, (product.type,))
        await ur10.look()
        self._fence(on=self.arm is not None and product.type != "box")
        try:
            row = PartResult(product.type)
            example = self.layout.of_types((product.type,))[0]
            ur10.rejected |= self._taken
            await self._face(product)
            await ur10.fetch(slot, row, [self.goal(product, example)])
            state["part"] = row.part
            self._taken.add(row.part)
        finally:
            self._fence(on=False)

    async def _face(self, product: Product) -> None:
        """Turn the UR10 towards the first part of a type, so that ways are short."""
        ur10 = self.ur10
        free = [name for name in self.layout.of_types((product.type,)) if name in ur10.seen and name not in self._taken]
        if not free:
            return
        x, y, _ = ur10.seen[free[0]].pose.translation
        tool = self.layout.kinematics.forward(self.layout.home).translation
        facing = np.array(self.layout.home)
        facing[0] = math.atan2(y, x) - math.atan2(tool[1], tool[0])
        with suppress(NoPath):
            await ur10.go(ur10.planner.to_posture(ur10.at, facing))

    async def _place(self, product: Product, part: str, kit: Kit) -> None:
        ur10 = self.ur10
        held = ur10.held
        if held is None:
            raise TaskFailed(f"{part} is not in the gripper")
        if self.arm is not None:
            await ur10.look()  # the modular arm stands still now
        goal = self.goal(product, part)
        plan = ur10.handling.place(
            part, held.grasp, ur10.at, [goal], along=shifted(z=ABOVE), touches=["conveyor"], press=-DROP
        )
        await ur10.go(plan.transfer)
        await ur10.go(plan.insert, speed=0.3, contact=True)
        await ur10.press(plan.contact)
        await self.cell.enable(GRIPPER, False)
        await self.cell.sleep(0.15)
        ur10.forget_held()
        ur10.used.add(part)
        ur10.scene.put(part, ur10.handling.pieces(part), goal)
        await ur10.go(ur10.handling.retreat(ur10.at, 0.1), contact=True)
        await ur10.go(ur10.planner.to_posture(ur10.at, PARKED))
        kit.products.append((product, part))

    def _fence(self, *, on: bool) -> None:
        scene = self.ur10.scene
        if not on:
            scene.remove("the arm's space")
            return
        sizes = [high - low for low, high in ARM_ZONE]
        middle = [(high + low) / 2.0 for low, high in ARM_ZONE]
        own = shifted(*middle)
        scene.put("the arm's space", [Piece(coal.Box(*sizes), pin.SE3.Identity())], own)

    # --- by the modular arm ---------------------------------------------------------------------------------------

    async def _take_box(self, state: dict[str, str]) -> None:
        """Take the nearest box that is not on the tray; the arm then stands still above the belt."""
        arm = self.arm
        assert arm is not None
        box = self._next_box()
        self._taken.add(box)
        pose = (await self.cell.observe())[box].pose
        top = pose * self.layout.grasp(box)
        x, y, z = (float(coordinate) for coordinate in top.translation)
        await arm.look(*self._boxes)
        over = arm.above((x, y, z + ABOVE), await arm.positions())[0]
        await arm.go(over)
        near = arm.chain.solve_down((x, y, z + TOUCH), over)
        down = None if near is None else arm.chain.solve_down((x, y, z - PRESS), near)
        if near is None or down is None:
            raise NoPath(f"the arm cannot reach {box}")
        await arm.move(near, ARM_TIME)
        await self.cell.enable(arm.tip, True)
        await self.cell.command_arm(await arm.vector(down), TOUCH_TIME)  # it presses, and so does not arrive
        if await arm.wait_attached(arm.tip, 2.0 * TOUCH_TIME) != box:
            await self.cell.enable(arm.tip, False)
            await arm.move(over, ARM_TIME)
            raise TaskFailed(f"the arm could not attach {box}")
        await arm.move(over, ARM_TIME)
        state["part"] = box

    async def _put_box(self, product: Product, box: str, kit: Kit) -> None:
        """Bring the tip above its place, turn the box as ordered, lower it and let go."""
        arm = self.arm
        assert arm is not None
        held = self.goal(product, box) * se3((await self.cell.connector(arm.tip)).offset).inverse()
        place = held.translation
        above = arm.above((place + np.array([0.0, 0.0, ABOVE])).tolist(), await arm.positions())[0]
        above = _turned_to(arm, above, held)
        await arm.go(above)
        low = arm.chain.solve_down((place + np.array([0.0, 0.0, DROP])).tolist(), above)
        if low is None:
            raise NoPath("the arm cannot reach the place on the tray")
        low = _turned_to(arm, low, held)
        await arm.move(low, ARM_TIME)
        await self.cell.enable(arm.tip, False)
        await self.cell.sleep(0.15)
        await arm.move(above, ARM_TIME)
        await arm.go(REST)
        kit.products.append((product, box))

    def _next_box(self) -> str:
        free = []
        for box in self._boxes:
            _, pose = self.cell.latest(box)
            if box not in self._taken:
                free.append((float(np.linalg.norm(pose.translation[:2] - self.tray.translation[:2])), box))
        if not free:
            raise TaskFailed("there is no box left")
        return min(free)[1]


def _turned_to(arm: ArmOperator, posture: Array, held: pin.SE3) -> Array:
    """The posture with the last joint turned so that the tip has the heading of `held`."""
    x = arm.chain.forward(posture).rotation.T @ held.rotation[:, 0]
    angle = math.atan2(x[1], x[0])
    found = np.array(posture)
    found[-1] += angle
    return found
