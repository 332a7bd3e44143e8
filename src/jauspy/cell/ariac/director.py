"""The director of a trial: it announces orders, causes faults in the simulation, and judges what truly lies on trays.

It reads the true state of the simulation. Tasks learn of faults only by what the components of the cell report.
"""

from __future__ import annotations

import asyncio
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from functools import partial
from typing import Final, Self

from jauspy.cell.ariac.board import OpenOrder, OrderBoard
from jauspy.cell.ariac.scoring import KitScore, Lying, Wanted, kit_score
from jauspy.cell.ariac.trial_file import Condition, DroppedPart, Order, OrderChange, Product, SensorBlackout, Trial
from jauspy.cell.ariac.workcell import PLACES, TRAY_SIZE, TrayPlace, is_flipped
from jauspy.cell.frames import se3
from jauspy.cell.interface import GRIPPER
from jauspy.cell.judge import Judge
from jauspy.cell.scene import Layout
from jauspy.geometry.poses import Pose

PERIOD: Final = 0.02
"""Seconds between two looks at the gripper."""
LOOK_PERIOD: Final = 0.1
"""Seconds between two checks of conditions."""
ON_TRAY: Final = (-0.01, 0.2)
"""Metres above a tray between which the grasp of a part is that lies on it."""
STORE: Final = (6.0, 6.0)
"""x and y of the store where the parts of submitted kits stand, metres."""
STORE_STEP: Final = 0.4


@dataclass(frozen=True, slots=True)
class Event:
    """An event of a trial: seconds from its start, and a sentence."""

    time: float
    what: str


@dataclass(frozen=True, slots=True)
class Verdict:
    """What truly lay on the tray of an order when it was submitted, and its score."""

    order: OpenOrder
    score: KitScore
    lying: tuple[Lying, ...]


@dataclass(slots=True)
class _Drop:
    """A drop that is to come: how often the type was picked, and when the gripper vents."""

    challenge: DroppedPart
    picks: int = 0
    due: float | None = None
    is_done: bool = False


class Director:
    """`async with Director(trial, judge, layout, clock) as director:` runs the events of a trial in the block.

    `clock` gives seconds; `run_belt` sets the belt's speed, in m/s.
    """

    def __init__(
        self, trial: Trial, judge: Judge, layout: Layout, clock: Callable[[], float], run_belt: Callable[[float], None]
    ) -> None:
        self._set_belt = run_belt
        self._trial, self._judge, self._layout, self._clock = trial, judge, layout, clock
        self._begun = clock()
        self.board = OrderBoard(self.time, self._submitted)
        self.events: list[Event] = []
        self.verdicts: dict[str, Verdict] = {}
        self.dropped: list[str] = []
        """Parts that the gripper has lost by the trial's doing."""
        self._drops = [_Drop(challenge) for challenge in trial.dropped_parts]
        self._held = ""
        self._stored = 0
        self._next_look = 0.0
        self._unannounced = len(trial.orders)
        self._pending: list[tuple[Condition, Callable[[], None]]] = [
            *((order.announcement, partial(self._announce, order)) for order in trial.orders),
            *((change.when, partial(self._change, change)) for change in trial.changes),
            *((blackout.when, partial(self._black_out, blackout)) for blackout in trial.sensor_blackouts),
            *((belt.when, partial(self._run_belt, belt.speed)) for belt in trial.belt_speeds),
        ]
        self._task: asyncio.Task[None] | None = None

    def time(self) -> float:
        """Seconds from the start of the trial."""
        return self._clock() - self._begun

    async def __aenter__(self) -> Self:
        for servo in self._trial.faulty_parts:
            self._judge.faults.seize(servo)
            self._note(f"the gear of {servo} has seized")
        self._step()
        self._task = asyncio.create_task(self._run(), name="director")
        return self

    async def __aexit__(self, *_: object) -> None:
        assert self._task is not None
        self._task.cancel()
        await asyncio.wait({self._task})
        if not self._task.cancelled():
            self._task.result()

    async def _run(self) -> None:
        while True:
            await asyncio.sleep(PERIOD)
            self._step()

    # --- events ---------------------------------------------------------------------------------------------------

    def _step(self) -> None:
        self._drop_parts()
        if self.time() < self._next_look:
            return
        self._next_look = self.time() + LOOK_PERIOD
        due = [entry for entry in self._pending if self._is_met(entry[0])]
        for entry in due:
            self._pending.remove(entry)
            entry[1]()

    def _is_met(self, condition: Condition) -> bool:
        if condition.time_condition is not None:
            return self.time() >= condition.time_condition
        if condition.submission_condition is not None:
            order = self.board.orders.get(condition.submission_condition)
            return order is not None and order.submitted is not None
        placed = condition.part_place_condition
        assert placed is not None
        return bool(self.lying(PLACES[placed.tray], placed.type))

    def _announce(self, order: Order) -> None:
        self.board.announce(order.id, order.tray, by_quadrant(order.products), priority=order.priority)
        self._unannounced -= 1
        self.board.is_complete = not self._unannounced
        self._note(f"order {order.id} is announced{', with priority' if order.priority else ''}")

    def _change(self, change: OrderChange) -> None:
        came = self.board.change(change.order, by_quadrant(change.products))
        self._note(f"order {change.order} is changed" if came else f"a change of order {change.order} came too late")

    def _black_out(self, blackout: SensorBlackout) -> None:
        self._judge.faults.blind(blackout.duration)
        self._note(f"the part sensor is blind for {blackout.duration:g} s")

    def _run_belt(self, speed: float) -> None:
        self._set_belt(speed)
        self._note(f"the belt runs at {speed:g} m/s")

    def _drop_parts(self) -> None:
        """Count what the gripper picks, and vent it when a drop is due."""
        held = self._judge.attached().get(GRIPPER, "") if self._drops else ""
        if held and held != self._held:
            for drop in self._drops:
                if drop.challenge.type == self._layout.type_of(held).name:
                    drop.picks += 1
                    if drop.picks > drop.challenge.drop_after and not drop.is_done:
                        drop.due = self.time() + drop.challenge.delay
        self._held = held
        for drop in self._drops:
            if not held or self._layout.type_of(held).name != drop.challenge.type:
                drop.due = None  # it was put down before
            elif drop.due is not None and self.time() >= drop.due:
                self._judge.faults.vent(GRIPPER)
                drop.due, drop.is_done = None, True
                self.dropped.append(held)
                self._note(f"the gripper loses {held}")

    # --- judging --------------------------------------------------------------------------------------------------

    def lying(self, place: TrayPlace, type: str = "") -> tuple[Lying, ...]:
        """What truly lies on a tray, and nothing holds; of one type only, if it is given."""
        held = set(self._judge.attached().values())
        found = []
        for part in self._layout.setup.parts:
            if part.fixed or part.name in held or part.type != (type or part.type):
                continue
            kind = self._layout.type_of(part.name)
            frame = self._judge.pose(part.name)
            x, y, z = (frame * se3(kind.grasp)).translation.tolist()
            quadrant = place.quadrant_of(x, y)
            if quadrant is None or not ON_TRAY[0] < z - TRAY_SIZE[2] < ON_TRAY[1]:
                continue
            faulty = part.name in self._trial.faulty_parts
            flipped = is_flipped(frame, kind.grasp)
            found.append(Lying(part.name, kind.kind.value, kind.name, quadrant, flipped, faulty))
        return tuple(found)

    def _submitted(self, order: OpenOrder) -> None:
        lying = self.lying(PLACES[order.tray])
        types = self._layout.setup.types
        wanted = {number: Wanted(types[type].kind.value, type) for number, type in order.products.items()}
        self.verdicts[order.id] = Verdict(order, kit_score(wanted, lying), lying)
        self._note(f"order {order.id} is submitted with {', '.join(found.part for found in lying) or 'nothing'}")
        for found in lying:  # the kit leaves the cell
            self._judge.place(found.part, Pose(STORE[0], STORE[1] + STORE_STEP * self._stored, 0.0, 0.0, 0.0, 0.0))
            self._stored += 1

    def _note(self, what: str) -> None:
        self.events.append(Event(self.time(), what))


def by_quadrant(products: Iterable[Product]) -> dict[int, str]:
    """Types of products by the quadrant of their tray."""
    return {product.quadrant: product.type for product in products}
