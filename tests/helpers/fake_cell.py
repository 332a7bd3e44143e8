"""A cell without physics or messages for tests of tasks: motions arrive at once, and failures happen when told to."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Callable, Mapping, Sequence
from itertools import pairwise

import numpy as np
import pinocchio as pin

from jauspy.cell.frames import Array, se3_of_pose, tilt_between, transform
from jauspy.cell.interface import GRIPPER, SeenPart, T
from jauspy.cell.motion import Path, profile
from jauspy.cell.scene import Layout, connector_frame
from jauspy.geometry.vectors import GRAVITY
from jauspy.platform.modular.arm import ModularArmState, TrajectoryPoint
from jauspy.platform.modular.connector import ConnectorState
from jauspy.platform.modular.parts import PartKind

NEAR = 0.004
"""Metres at which plates attach, as the cell's connectors do."""


class FakeCell:
    """Implements `jauspy.cell.interface.Cell`. `fails(connector, part)` is called before anything attaches."""

    def __init__(self, layout: Layout, *, fails: Callable[[str, str], str] = lambda connector, part: "") -> None:
        self.layout = layout
        self.fails = fails
        self.drops: Callable[[str], bool] = lambda part: False
        """Called with the part in the gripper after each motion: true drops it."""
        self.hidden: set[str] = set()
        self.time = 0.0
        self.at = layout.home
        self.poses = {each.name: se3_of_pose(each.pose) for each in layout.setup.parts}
        self.enabled: Counter[str] = Counter()
        self.starts: Counter[str] = Counter()
        """How often the pump of each connector was started."""
        self.attached: dict[str, tuple[str, pin.SE3]] = {}
        self.errors: dict[str, str] = {}
        self.log: list[str] = []

    def now(self) -> float:
        return self.time

    async def sleep(self, seconds: float) -> None:
        self.time += seconds

    async def compute(self, function: Callable[[], T]) -> T:
        return function()

    async def posture(self) -> Array:
        return self.at

    async def follow(
        self, path: Path, *, speed: float = 1.0, tool_speed: float = math.inf, gentle: bool = False
    ) -> None:
        assert np.max(np.abs(path.points[0] - self.at)) < 1e-6, "a path begins where the arm is"
        for a, b in pairwise(path.points):
            self.time += profile(a, b, self.layout.speeds * speed, self.layout.accelerations).duration
        self.at = path.end
        self._carry()
        held, _ = self.attached.get(GRIPPER, ("", None))
        if held and self.drops(held):
            del self.attached[GRIPPER]
            self.poses[held] = pin.SE3(np.eye(3), np.array([-0.9, 0.9, 0.0]))
            self.errors[GRIPPER] = "broken off"
        self._attach()

    async def touch(
        self, path: Path, connector: str, *, tool_speed: float, contact: float = math.inf
    ) -> ConnectorState:
        await self.follow(path, tool_speed=tool_speed)
        return await self.connector(connector)

    async def blocked(self) -> str:
        return ""

    async def observe(self, *, fresh: bool = False) -> Mapping[str, SeenPart]:
        self.time += 0.8 if fresh else 0.0
        return {
            name: SeenPart(self.layout.type_of(name).name, pose)
            for name, pose in self.poses.items()
            if name not in self.hidden
        }

    async def connector(self, name: str) -> ConnectorState:
        part, offset = self.attached.get(name, ("", pin.SE3.Identity()))
        force = GRAVITY * sum(each.mass for each in self._solids(part)) if part else 0.0
        return ConnectorState(
            True,
            bool(self.enabled[name]),
            part,
            transform(offset),
            force,
            latched=bool(part),
            last_error=self._error(name),
        )

    async def enable(self, name: str, enabled: bool) -> None:
        self.enabled[name] = enabled
        self.starts[name] += enabled
        if not enabled:
            self.attached.pop(name, None)
        self._attach()

    async def leave(self, part: str) -> None:
        self.log.append(f"leave {part}")

    async def arm(self, name: str = "") -> ModularArmState:
        joints, at = [], "platform_1/top"
        while at in self.attached:
            part, _ = self.attached[at]
            if self.layout.type_of(part).kind is PartKind.SERVO:
                joints.append(part)
            at = f"{part}/output"
        zeros = (0.0,) * len(joints)
        return ModularArmState("platform_1/top", at, tuple(joints), (), zeros, zeros, zeros, zeros)

    async def move_arm(self, positions: Sequence[float], duration: float = 0.0, *, name: str = "") -> None:
        assert len(positions) == len((await self.arm()).joints)
        self.log.append(f"move {[None if math.isnan(each) else each for each in positions]}")
        self.time += duration

    async def follow_arm(self, joints: Sequence[str], points: Sequence[TrajectoryPoint], *, name: str = "") -> None:
        self.log.append(f"follow {', '.join(joints)}")
        self.time += points[-1].time

    # --- inside ---------------------------------------------------------------------------------------------------

    def _solids(self, part: str) -> list:
        type = self.layout.type_of(part)
        return [*type.solids, *(type.servo.output if type.servo else ())]

    def _error(self, name: str) -> str:
        return self.errors.get(name, "")

    def _carry(self) -> None:
        if GRIPPER in self.attached:
            part, offset = self.attached[GRIPPER]
            self.poses[part] = self.layout.kinematics.forward(self.at) * offset

    def _connectors(self) -> dict[str, pin.SE3]:
        found = {GRIPPER: self.layout.kinematics.forward(self.at)}
        for name, pose in self.poses.items():
            type = self.layout.type_of(name)
            for connector in type.connectors:
                found[f"{name}/{connector}"] = pose * connector_frame(type, connector)
        return found

    def _attach(self) -> None:
        for connector, frame in self._connectors().items():
            if not self.enabled[connector] or connector in self.attached:
                continue
            for part, pose in self.poses.items():
                if connector.startswith(f"{part}/") or (connector != GRIPPER and self._held_by_other(part, connector)):
                    continue
                plate = pose * self.layout.grasp(part) if connector == GRIPPER else pose
                if (
                    float(np.linalg.norm(plate.translation - frame.translation)) > NEAR
                    or tilt_between(plate, frame) > 0.07
                ):
                    continue
                if why := self.fails(connector, part):
                    self.errors[connector] = why
                    continue
                self.errors[connector] = ""
                self.attached[connector] = part, frame.actInv(pose)

    def _held_by_other(self, part: str, connector: str) -> bool:
        return any(held == part and other not in (GRIPPER, connector) for other, (held, _) in self.attached.items())
