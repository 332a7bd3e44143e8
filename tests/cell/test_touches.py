"""How gently connectors meet what they attach, as the simulation measures it at each step."""

from __future__ import annotations

import asyncio

import pytest

pytest.importorskip("mujoco", reason="needs the extra `sim`")

from jauspy.cell.assembly import Assembler
from jauspy.cell.measurements import Measured
from jauspy.cell.physics import GENTLE_FORCE, GENTLE_SPEED, Meeting
from jauspy.cell.scene import connector_frame
from jauspy.cell.session import UNDISTURBED, Session
from jauspy.cell.slots import FIVE_JOINTS, PartResult, Tip
from jauspy.cell.tasks import run_one


async def first_part(session: Session, seed: int) -> Measured:
    """Take one servo module out of its bin, and join it to the platform."""
    ur10 = Assembler(session.cell, session.layout, seed=seed)
    frame = session.true.pose("platform_1") * connector_frame(session.layout.type_of("platform_1"), "top")
    tip, row = Tip("platform_1/top", "platform_1", frame), PartResult("joint 1")
    await ur10.fetch_for(FIVE_JOINTS[0], row, tip)
    await ur10.join_to(FIVE_JOINTS[0], row, tip)
    return Measured(seed, "first part", success=True)


def of_first_part() -> list[Meeting]:
    found = asyncio.run(run_one("first part", 1, UNDISTURBED, run=first_part))
    assert found.physics is not None
    assert {meeting.first for meeting in found.physics.attaches} == {"gripper", "platform_1/top"}
    return found.physics.attaches


def hard(meetings: list[Meeting]) -> list[Meeting]:
    return [meeting for meeting in meetings if meeting.speed > GENTLE_SPEED or meeting.force > GENTLE_FORCE]


@pytest.mark.slow
def test_the_ur10_touches_gently() -> None:
    assert hard(of_first_part()) == []


@pytest.mark.slow
def test_touches_that_are_not_slow_are_found(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("jauspy.cell.assembly.TOUCH_SPEED", 0.1)
    monkeypatch.setattr("jauspy.cell.client.GENTLE", 1.0)
    assert hard(of_first_part())
