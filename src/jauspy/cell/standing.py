"""Parts that stand on a base, as the connectors that hold them report it: where a task finds an arm or a car."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Protocol

import pinocchio as pin

from jauspy.cell.frames import se3, se3_of_pose
from jauspy.cell.interface import SeenPart
from jauspy.cell.scene import Layout, connector_frame
from jauspy.cell.schedule import TaskFailed
from jauspy.platform.modular.arm import ModularArmState
from jauspy.platform.modular.connector import ConnectorState
from jauspy.platform.modular.parts import PartKind


class Reports(Protocol):
    """A cell that reports its state."""

    async def connector(self, name: str) -> ConnectorState:
        """Measurements of a connector."""
        ...

    async def observe(self, *, fresh: bool = False) -> Mapping[str, SeenPart]:
        """The parts that the sensor has seen."""
        ...

    async def arm(self, name: str = "") -> ModularArmState:
        """The joints of a modular arm, of the first one without a name."""
        ...


@dataclass(frozen=True, slots=True)
class Joined:
    """A part on a connector."""

    part: str
    connector: str
    """The connector that holds it, as in `servo_1/output`."""
    offset: pin.SE3
    """Frame of the part in that of the connector."""


async def standing_on(cell: Reports, layout: Layout, base: str) -> list[Joined]:
    """Parts that a connector holds, directly or through others; each comes after the part that holds it.

    A branch is listed whole before the next one. Parts have power while they are attached, so that their connectors
    report.
    """
    found: list[Joined] = []
    waiting, seen = [base], set[str]()
    while waiting:
        connector = waiting.pop()
        state = await cell.connector(connector)
        part = state.attached_to
        if not part or part in seen or layout.type_of(part).kind is PartKind.BASE:
            continue
        seen.add(part)
        found.append(Joined(part, connector, se3(state.offset)))
        waiting += [f"{part}/{name}" for name in reversed(list(layout.type_of(part).connectors))]
    return found


def chain_of(layout: Layout, joined: Sequence[Joined]) -> list[Joined]:
    """The parts from the base to the part that the most servo modules carry, without boxes."""
    by_part = {item.part: item for item in joined}
    chains = []
    for item in joined:
        chain = [item]
        while (owner := chain[0].connector.partition("/")[0]) in by_part:
            chain.insert(0, by_part[owner])
        if layout.type_of(item.part).kind is not PartKind.BOX:
            chains.append(chain)
    return max(chains, key=lambda chain: (_servos(layout, chain), len(chain)), default=[])


def _servos(layout: Layout, chain: Iterable[Joined]) -> int:
    return sum(layout.type_of(item.part).servo is not None for item in chain)


async def base_frame(cell: Reports, layout: Layout, connector: str) -> pin.SE3:
    """The frame in the world of a connector of a base: by the layout if that is bolted down, else as it is seen.

    Raises `TaskFailed` for a base that the sensor does not see.
    """
    owner, _, name = connector.partition("/")
    frame = connector_frame(layout.type_of(owner), name)
    for part in layout.setup.parts:
        if part.name == owner and part.fixed:
            return se3_of_pose(part.pose) * frame
    seen = await cell.observe()
    if owner not in seen:
        raise TaskFailed(f"the sensor does not see {owner}")
    return seen[owner].pose * frame


def frames_of(
    layout: Layout, base: pin.SE3, joined: Iterable[Joined], positions: Mapping[str, float]
) -> dict[str, pin.SE3]:
    """Frames of parts in the world.

    `base` is the frame of the first connector, `positions` are those of servo modules by name, in radians; modules that
    are not named are at zero.
    """
    found: dict[str, pin.SE3] = {}
    for item in joined:
        owner, _, name = item.connector.partition("/")
        frame = base
        if owner in found:
            frame = found[owner] * connector_frame(layout.type_of(owner), name, positions.get(owner, 0.0))
        found[item.part] = frame * item.offset
    return found


async def arm_with(cell: Reports, names: Iterable[str], joints: Collection[str]) -> tuple[str, ModularArmState] | None:
    """The first of these modular arms that has one of the joints, by name, and its state."""
    for name in names:
        state = await cell.arm(name)
        if any(joint in joints for joint in state.joints):
            return name, state
    return None


async def joint_positions(cell: Reports, layout: Layout) -> dict[str, float]:
    """Positions of the joints of all modular arms, by servo module, in radians."""
    found: dict[str, float] = {}
    for name in layout.arms:
        state = await cell.arm(name)
        found |= zip(state.joints, state.positions, strict=True)
    return found


async def all_frames(cell: Reports, layout: Layout) -> dict[str, pin.SE3]:
    """Frames in the world of all parts that stand on bases, by the reports of connectors and joints."""
    positions = await joint_positions(cell, layout)
    found: dict[str, pin.SE3] = {}
    for part in layout.setup.parts:
        kind = layout.type_of(part.name)
        for name in kind.connectors if kind.kind is PartKind.BASE else ():
            connector = f"{part.name}/{name}"
            if joined := await standing_on(cell, layout, connector):
                found |= frames_of(layout, await base_frame(cell, layout, connector), joined, positions)
    return found
