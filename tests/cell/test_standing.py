"""What stands on a base, by the reports of connectors that the test makes up."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

import numpy as np
import pinocchio as pin
import pytest

from jauspy.cell.frames import shifted, transform, turned
from jauspy.cell.interface import SeenPart
from jauspy.cell.scene import Layout, connector_frame
from jauspy.cell.schedule import TaskFailed
from jauspy.cell.standing import all_frames, base_frame, chain_of, frames_of, standing_on
from jauspy.platform.modular.arm import ModularArmState
from jauspy.platform.modular.connector import ConnectorState

BASE = "platform_1/top"
CHAIN = {BASE: "servo_1", "servo_1/output": "bracket_1", "bracket_1/output": "servo_2", "servo_2/output": "box_1"}
OFFSET = shifted(0.0002, -0.0001) * turned("z", 0.3)


@dataclass
class Reports:
    """A cell whose connectors hold `held`, each with `OFFSET`."""

    held: dict[str, str]
    seen: dict[str, pin.SE3] = field(default_factory=dict)
    joints: dict[str, float] = field(default_factory=dict)
    asked: list[str] = field(default_factory=list)

    async def connector(self, name: str) -> ConnectorState:
        self.asked.append(name)
        return ConnectorState(True, True, self.held.get(name, ""), transform(OFFSET))

    async def observe(self, *, fresh: bool = False) -> Mapping[str, SeenPart]:
        return {name: SeenPart("", pose) for name, pose in self.seen.items()}

    async def arm(self, name: str = "") -> ModularArmState:
        zeros = (0.0,) * len(self.joints)
        return ModularArmState(BASE, "", tuple(self.joints), (), tuple(self.joints.values()), zeros, zeros, zeros)


async def test_nothing_stands_on_a_connector_that_holds_nothing(layout: Layout) -> None:
    cell = Reports({})
    assert await standing_on(cell, layout, BASE) == []
    assert cell.asked == [BASE], "connectors without power are not asked"


async def test_parts_come_after_what_holds_them(layout: Layout) -> None:
    found = await standing_on(Reports(CHAIN), layout, BASE)
    assert [(item.connector, item.part) for item in found] == list(CHAIN.items())
    assert found[0].offset.isApprox(OFFSET)


async def test_a_branch_is_listed_whole_before_the_next(forked: Layout) -> None:
    held = {BASE: "bracket_1", "bracket_1/output": "servo_1", "servo_1/output": "tube_1", "bracket_1/side": "servo_2"}
    found = await standing_on(Reports(held), forked, BASE)
    assert [item.part for item in found] == ["bracket_1", "servo_1", "tube_1", "servo_2"]
    assert [item.part for item in chain_of(forked, found)] == ["bracket_1", "servo_1", "tube_1"]
    frames = frames_of(forked, pin.SE3.Identity(), found, {})
    side = connector_frame(forked.type_of("bracket_1"), "side")
    assert frames["servo_2"].isApprox(OFFSET * side * OFFSET)


async def test_connectors_of_a_base_are_apart(layout: Layout) -> None:
    cell = Reports({"car/front_left": "servo_6", "servo_6/output": "wheel_1", "car/top": "servo_1"})
    assert [item.part for item in await standing_on(cell, layout, "car/front_left")] == ["servo_6", "wheel_1"]
    assert [item.part for item in await standing_on(cell, layout, "car/top")] == ["servo_1"]


async def test_a_connector_that_holds_on_to_a_base_ends_the_arm(layout: Layout) -> None:
    found = await standing_on(Reports({BASE: "servo_1", "servo_1/output": "platform_2"}), layout, BASE)
    assert [item.part for item in found] == ["servo_1"]


async def test_reports_in_a_circle_end(layout: Layout) -> None:
    found = await standing_on(
        Reports({BASE: "servo_1", "servo_1/output": "servo_2", "servo_2/output": "servo_1"}), layout, BASE
    )
    assert [item.part for item in found] == ["servo_1", "servo_2"]


async def test_the_chain_of_an_arm_is_without_its_box(layout: Layout) -> None:
    chain = chain_of(layout, await standing_on(Reports(CHAIN), layout, BASE))
    assert [item.part for item in chain] == ["servo_1", "bracket_1", "servo_2"]
    assert chain_of(layout, []) == []


async def test_frames_follow_joints_and_offsets(layout: Layout) -> None:
    joined = await standing_on(Reports(CHAIN), layout, BASE)
    base = await base_frame(Reports({}), layout, BASE)
    assert base.translation == pytest.approx([0.6, 0.22, 0.2])
    found = frames_of(layout, base, joined, {"servo_1": 0.7})
    turned_output = connector_frame(layout.type_of("servo_1"), "output", 0.7)
    assert found["servo_1"].isApprox(base * OFFSET)
    assert found["bracket_1"].isApprox(base * OFFSET * turned_output * OFFSET)
    straight = frames_of(layout, base, joined, {})
    assert not straight["bracket_1"].isApprox(found["bracket_1"])


async def test_a_base_that_moves_is_where_it_is_seen(layout: Layout) -> None:
    pose = shifted(1.0, 0.3, 0.25) * turned("z", 0.5)
    found = await base_frame(Reports({}, {"car": pose}), layout, "car/top")
    assert found.isApprox(pose * connector_frame(layout.type_of("car"), "top"))
    with pytest.raises(TaskFailed, match="the sensor does not see car"):
        await base_frame(Reports({}), layout, "car/top")


async def test_all_parts_on_all_bases_are_known(layout: Layout) -> None:
    held = CHAIN | {"car/front_left": "servo_6", "servo_6/output": "wheel_1"}
    cell = Reports(held, {"car": shifted(-0.65)}, {"servo_1": 0.1, "servo_2": -0.2})
    found = await all_frames(cell, layout)
    assert set(found) == {"servo_1", "bracket_1", "servo_2", "box_1", "servo_6", "wheel_1"}
    joined = await standing_on(cell, layout, BASE)
    wanted = frames_of(layout, await base_frame(cell, layout, BASE), joined, cell.joints)
    assert all(np.allclose(found[name].homogeneous, frame.homogeneous) for name, frame in wanted.items())
