"""Picks parts off a moving belt: the UR10 follows a part by the belt's reported travel, whatever its speed does."""

from __future__ import annotations

import math
from collections import deque
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from typing import Final

import coal
import numpy as np
import pinocchio as pin

from jauspy.cell.assembly import Assembler
from jauspy.cell.client import CellClient
from jauspy.cell.frames import Array, se3_of_pose, shifted, turned
from jauspy.cell.interface import GRIPPER
from jauspy.cell.motion import NoPath
from jauspy.cell.scene import Piece
from jauspy.cell.slots import PartResult
from jauspy.platform.modular.connector import ConnectorState

STILL: Final = 0.005
"""m/s below which the belt stands still."""
WINDOW: Final = (-0.70, -0.22)
"""y between which parts are met on the belt, metres in the world: where it goes on along y."""
LEAVES: Final = -0.12
"""y from which on a part is not followed any more, metres."""
HOVER: Final = 0.06
"""Metres above a part in which the gripper waits for it."""
SLOW: Final = 0.003
"""Metres above a part from which on the gripper is lowered slowly."""
DEEPEST: Final = -0.003
"""Metres above the seen top of a part at which the gripper is no longer lowered."""
FAST_RATE: Final = 0.08
SLOW_RATE: Final = 0.002
RAISE_RATE: Final = 0.10
"""m/s at which the gripper is lowered and raised while it follows a part."""
RAISE_ACCELERATION: Final = 0.3
"""m/s^2."""
IN_CONTACT: Final = 3000.0
"""Pascals of vacuum that a cup reports only in contact."""
RELIEF: Final = 0.0004
"""Metres by which the gripper is raised at once in contact: it has gone further until that was reported."""
SEAL_TIME: Final = 1.0
"""Seconds in contact in which the gripper must have attached the part."""
RAISED: Final = 0.16
"""Metres above its place on the belt at which a part is no longer followed."""
ALIGNED: Final = 0.006
"""Metres along the belt within which the gripper is over the part."""
PERIOD: Final = 0.02
"""Seconds between two setpoints."""
LEAD: Final = 0.03
"""Seconds by which a setpoint is ahead, for the way of the messages and the arm's lag."""
PATIENCE: Final = 60.0
"""Seconds to wait for a part."""
TRAVEL_TIME: Final = 2.0
"""Seconds in which the UR10 is above the place where it meets a part."""
TURNS: Final = 8
"""Angles of the gripper about its axis that are tried."""
SETTLE: Final = 0.3
"""Seconds until the UR10 stands still."""
FENCE: Final = "what the belt brings"
FENCE_HEIGHT: Final = 0.13
"""Metres above a moving belt that parts on it need."""
HISTORY: Final = 600
"""Reports of the belt that are kept: 12 s."""


class BeltEncoder:
    """Reports of the belt's travel (m) with their times (s), to know where a part is that was seen a while ago."""

    def __init__(self) -> None:
        self._reports: deque[tuple[float, float]] = deque(maxlen=HISTORY)
        self.speed = 0.0
        """m/s, as last reported."""

    def add(self, time: float, travel: float, speed: float) -> None:
        """Keep a report."""
        self._reports.append((time, travel))
        self.speed = speed

    def travel(self, time: float) -> float:
        """Travel at a time, interpolated; before the first report and after the last one by the last speed."""
        times = [report[0] for report in self._reports]
        travels = [report[1] for report in self._reports]
        if time < times[0]:
            return travels[0] + (time - times[0]) * self.speed
        if time > times[-1]:
            return travels[-1] + (time - times[-1]) * self.speed
        return float(np.interp(time, times, travels))


@dataclass(slots=True)
class _Chase:
    """One attempt to pick a part that moves."""

    part: str
    x: float
    top: float
    """z of the face at which it is grasped, metres."""
    yaw: float
    posture: Array
    height: float = HOVER
    """Metres of the gripper above the part."""


class BeltPicker:
    """Picks parts off the belt with the UR10 of an assembler; `on_hold` is called with what the gripper then holds."""

    def __init__(
        self, ur10: Assembler, cell: CellClient, on_hold: Callable[[str, ConnectorState], None] = lambda *_: None
    ) -> None:
        self._on_hold = on_hold
        self._ur10, self._cell, self._layout = ur10, cell, ur10.layout
        self._encoder = BeltEncoder()

    def is_on_belt(self, part: str, pose: pin.SE3) -> bool:
        """True if a part that was seen at `pose` lies on the belt."""
        belt = self._layout.setup.conveyor
        if belt is None:
            return False
        x, y, top = (pose * self._layout.grasp(part)).translation.tolist()
        beside = abs(y - belt.pose.y) > belt.length / 2.0 or abs(x - belt.pose.x) > belt.width / 2.0
        return not beside and abs(float(top) - self._layout.thickness(part) - belt.pose.z) < 0.5 * HOVER

    async def fence(self) -> None:
        """Keep the UR10 out of the space over a moving belt that parts on it need: they are not where they were."""
        scene, belt = self._ur10.scene, self._layout.setup.conveyor
        scene.remove(FENCE)
        if belt is not None and abs(await self.speed()) > STILL:
            middle = se3_of_pose(belt.pose) * shifted(z=FENCE_HEIGHT / 2.0)
            scene.put(FENCE, [Piece(coal.Box(belt.length, belt.width, FENCE_HEIGHT), pin.SE3.Identity())], middle)

    async def speed(self) -> float:
        """The belt's present speed, m/s."""
        await self._read()
        return self._encoder.speed

    def coming(self, parts: Iterable[str]) -> list[str]:
        """The parts that can still be met on the belt, the first to leave it first."""
        found = [(self._y(part, TRAVEL_TIME), part) for part in parts]
        return [part for y, part in sorted(found, reverse=True) if y < WINDOW[1]]

    async def pick(self, part: str, row: PartResult) -> str:
        """Wait for a part, follow it and lift it off; returns why that failed, or an empty text."""
        chase = await self._wait_for(part)
        if isinstance(chase, str):
            return chase
        await self._cell.enable(GRIPPER, True)
        await self._cell.full_speed()
        state = await self._lower(chase)
        if state.attached_to != part:
            await self._cell.enable(GRIPPER, False)
        await self._raise(chase)
        await self._cell.hold()
        await self._cell.sleep(SETTLE)
        self._ur10.at = await self._cell.posture()
        state = await self._cell.connector(GRIPPER)
        if state.attached_to != part:
            return state.last_error or f"the gripper holds {state.attached_to or 'nothing'}"
        self._on_hold(part, state)
        row.grasp_force = state.force
        return ""

    # --- where it is ----------------------------------------------------------------------------------------------

    async def _read(self) -> None:
        asked = self._cell.now()
        state = await self._cell.belt()
        self._encoder.add(0.5 * (asked + self._cell.now()), state.position, state.speed)

    def _y(self, part: str, ahead: float = 0.0) -> float:
        """Y of the middle of a part `ahead` seconds from now, by its last observation and the belt's travel since."""
        seen, pose = self._cell.latest(part)
        grasp = pose * self._layout.grasp(part)
        travel = self._encoder.travel
        return float(grasp.translation[1]) + travel(self._cell.now() + ahead) - travel(seen)

    # --- motions --------------------------------------------------------------------------------------------------

    async def _wait_for(self, part: str) -> _Chase | str:
        """Move above the belt where the part will be soon; returns why that is not possible."""
        ur10 = self._ur10
        _, pose = self._cell.latest(part)
        grasp = pose * self._layout.grasp(part)
        x, _, top = grasp.translation.tolist()
        yaw = math.atan2(grasp.rotation[1, 0], grasp.rotation[0, 0])
        await self._read()
        speed = self._encoder.speed
        y = max(WINDOW[0], self._y(part, ahead=TRAVEL_TIME if abs(speed) > STILL else 0.0))
        if y > WINDOW[1]:
            return f"{part} leaves the belt before it can be met"
        over = shifted(x, y, top + HOVER) * turned("z", yaw) * turned("x", math.pi)
        turns = [over * turned("z", number * math.tau / TURNS) for number in range(TURNS)]
        solve = self._layout.kinematics.solve
        postures = [posture for turn in turns for posture in solve(turn, ur10.at)]
        with ur10.scene.without(part):
            path = await self._cell.compute(lambda: ur10.planner.to_any(ur10.at, postures))
        await ur10.go(path)
        turn = self._layout.kinematics.forward(path.end)
        yaw = math.atan2(turn.rotation[1, 0], turn.rotation[0, 0])
        chase = _Chase(part, x, top, yaw, path.end)
        until = self._cell.now() + PATIENCE
        while self._y(part, LEAD) < y - ALIGNED:
            await self._read()
            if self._cell.now() > until:
                return f"{part} has not come within {PATIENCE:g} s"
            await self._cell.sleep(PERIOD)
        return chase

    async def _lower(self, chase: _Chase) -> ConnectorState:
        """Follow the part, and lower the gripper until its cup is in contact; follow on until it has attached the part.

        The belt is stiff, and so is the UR10: pressed further, the box would be held against the belt's friction.
        """
        state, touched = await self._cell.connector(GRIPPER), math.inf
        while not state.attached_to and chase.height > DEEPEST and self._cell.now() < touched + SEAL_TIME:
            await self._read()
            y = self._y(chase.part, LEAD)
            if y > LEAVES:
                break
            here = self._layout.kinematics.forward(await self._cell.posture())
            if state.vacuum > IN_CONTACT:
                chase.height += RELIEF if math.isinf(touched) else 0.0
                touched = min(touched, self._cell.now())
            elif abs(float(here.translation[1]) - y) < ALIGNED:
                chase.height -= PERIOD * (FAST_RATE if chase.height > SLOW else SLOW_RATE)
            await self._step(chase, y)
            state = await self._cell.connector(GRIPPER)
        return state

    async def _raise(self, chase: _Chase) -> None:
        """Lift the gripper, with or without the part, and follow the belt meanwhile so that nothing is dragged."""
        rate = 0.0
        while chase.height < RAISED:
            await self._read()
            rate = min(RAISE_RATE, rate + PERIOD * RAISE_ACCELERATION)
            chase.height += PERIOD * rate
            await self._step(chase, min(LEAVES, self._y(chase.part, LEAD)))

    async def _step(self, chase: _Chase, y: float) -> None:
        """Send the setpoint over a place of the belt, and wait for the next one to be due."""
        due = self._cell.now() + PERIOD
        goal = shifted(chase.x, y, chase.top + chase.height) * turned("z", chase.yaw) * turned("x", math.pi)
        posture = self._layout.kinematics.solve_from(goal, chase.posture)
        if posture is None:
            raise NoPath(f"the UR10 cannot follow {chase.part} on the belt")
        chase.posture = posture
        await self._cell.aim(posture)
        await self._cell.sleep(max(0.0, due - self._cell.now()))
