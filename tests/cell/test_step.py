"""The step between platforms without physics: no end is released unless the other one holds."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import numpy as np
import pinocchio as pin
import pytest

from jauspy.cell.frames import offset_between, shifted
from jauspy.cell.modular_arm import FIVE_JOINTS, Chain, HangingChain, Member
from jauspy.cell.scene import Layout
from jauspy.cell.schedule import TaskFailed
from jauspy.cell.step import PRESSES, Stepper
from jauspy.geometry.poses import IDENTITY
from jauspy.platform.modular.connector import ConnectorState

BASE, OTHER = "platform_1/top", "platform_2/top"


class Cell:
    """Connectors with what they hold; those of `sticky` do not let go, and `slipping` ones lose what they held."""

    def __init__(self, **held: str) -> None:
        self.time = 0.0
        self.held = {name.replace("__", "/"): part for name, part in held.items()}
        self.enabled: list[tuple[str, bool]] = []
        self.sticky: set[str] = set()
        self.slipping: set[str] = set()
        self.unlocked: set[str] = set()
        """Those whose latch does not lock."""
        self.attaches: dict[str, tuple[str, int]] = {}
        """What a connector attaches, and at which press."""
        self.presses = 0

    def now(self) -> float:
        return self.time

    async def sleep(self, seconds: float) -> None:
        self.time += seconds

    async def enable(self, name: str, enabled: bool) -> None:
        self.enabled.append((name, enabled))
        if not enabled and name not in self.sticky:
            self.held.pop(name, None)
        if not enabled:
            for other in self.slipping:
                self.held.pop(other, None)

    async def command_arm(self, positions: list[float], duration: float) -> None:
        self.presses += 1

    async def connector(self, name: str) -> ConnectorState:
        part, press = self.attaches.get(name, ("", 0))
        if part and self.presses > press:
            self.held[name] = part
        error = "" if name in self.held else "leaks"
        locked = name in self.held and name not in self.unlocked
        return ConnectorState(True, True, self.held.get(name, ""), IDENTITY, 20.0, latched=locked, last_error=error)


class Arm:
    """An arm that goes wherever it is sent."""

    def __init__(self, cell: Cell, layout: Layout, base: pin.SE3) -> None:
        self._cell = cell
        self.members = tuple(Member(name, layout.type_of(name), pin.SE3.Identity(), "output") for name in FIVE_JOINTS)
        self.tip = "servo_5/output"
        self.at = np.zeros(5)
        self.chains: list[Chain] = []
        self.stand(Chain(base, self.members))
        self.scene = SimpleNamespace(without=self._without)

    def _without(self, *names: str) -> Any:
        return pytest.MonkeyPatch.context()

    def stand(self, chain: Chain) -> None:
        self.chain = chain
        self.chains.append(chain)

    async def look(self, *ignored: str) -> None:
        """It sees what it needs."""

    async def positions(self) -> np.ndarray:
        return self.at

    def above(self, point: Any, near: np.ndarray, direction: Any = (0.0, 0.0, -1.0)) -> list[np.ndarray]:
        return self.chain.pointing(np.array(point), np.array(direction), near)

    async def go(self, goal: np.ndarray, **_: float) -> None:
        self.at = goal

    async def move(self, goal: np.ndarray, duration: float) -> None:
        self.at = goal
        self._cell.time += duration

    async def vector(self, goal: np.ndarray) -> list[float]:
        return goal.tolist()

    async def wait_attached(self, connector: str, within: float) -> str:
        return (await self._cell.connector(connector)).attached_to


def stepper(layout: Layout, cell: Cell) -> Stepper:
    client: Any = cell
    made = Stepper(client, layout, SimpleNamespace())
    arm: Any = Arm(cell, layout, made.frame(BASE))
    made.arm = arm
    return made


async def test_the_frame_of_a_platform_is_the_middle_of_its_connector(layout: Layout) -> None:
    made = stepper(layout, Cell())
    top = layout.type_of("platform_1").connectors["top"].position[2]
    (pose,) = (each.pose for each in layout.setup.parts if each.name == "platform_1")
    assert made.frame(BASE).translation == pytest.approx([pose.x, pose.y, pose.z + top])


@pytest.mark.parametrize("name", ["servo_1/output", "platform_9/top"])
def test_what_does_not_stand_still_is_no_platform(layout: Layout, name: str) -> None:
    with pytest.raises(TaskFailed, match=f"there is no platform {name.partition('/')[0]!r} that stands still"):
        stepper(layout, Cell()).frame(name)


class TestRelease:
    async def test_one_end_is_released_when_the_other_holds(self, layout: Layout) -> None:
        cell = Cell(platform_1__top="servo_1", servo_5__output="platform_2")
        made = stepper(layout, cell)
        await made._release(BASE, holds="servo_5/output", part="platform_2")
        assert cell.enabled == [(BASE, False)]
        assert made.result.steps == 1
        assert made.result.log == ["servo_5/output holds platform_2 with 20.0 N; platform_1/top is released"]

    @pytest.mark.parametrize(("held", "named"), [({}, "nothing"), ({"servo_5__output": "box_1"}, "box_1")])
    async def test_an_end_stays_enabled_while_the_other_does_not_hold(
        self, layout: Layout, held: dict[str, str], named: str
    ) -> None:
        cell = Cell(platform_1__top="servo_1", **held)
        made = stepper(layout, cell)
        with pytest.raises(TaskFailed, match=f"{BASE} stays enabled: servo_5/output holds {named}, not platform_2"):
            await made._release(BASE, holds="servo_5/output", part="platform_2")
        assert cell.enabled == []
        assert cell.held[BASE] == "servo_1"
        assert made.result.steps == 0

    async def test_an_end_stays_enabled_while_the_other_is_held_by_suction_alone(self, layout: Layout) -> None:
        cell = Cell(platform_1__top="servo_1", servo_5__output="platform_2")
        cell.unlocked.add("servo_5/output")
        with pytest.raises(TaskFailed, match=f"{BASE} stays enabled: servo_5/output has not locked platform_2"):
            await stepper(layout, cell)._release(BASE, holds="servo_5/output", part="platform_2")
        assert cell.held[BASE] == "servo_1"

    async def test_a_connector_that_does_not_let_go_is_named(self, layout: Layout) -> None:
        cell = Cell(platform_1__top="servo_1", servo_5__output="platform_2")
        cell.sticky.add(BASE)
        with pytest.raises(TaskFailed, match=f"{BASE} does not let go"):
            await stepper(layout, cell)._release(BASE, holds="servo_5/output", part="platform_2")

    async def test_an_end_that_is_lost_at_the_release_is_named(self, layout: Layout) -> None:
        cell = Cell(platform_1__top="servo_1", servo_5__output="platform_2")
        cell.slipping.add("servo_5/output")
        made = stepper(layout, cell)
        with pytest.raises(TaskFailed, match=f"servo_5/output lost platform_2 when {BASE} let go"):
            await made._release(BASE, holds="servo_5/output", part="platform_2")
        assert made.result.steps == 0


class TestStep:
    @pytest.mark.slow
    async def test_it_presses_on_until_the_end_holds(self, layout: Layout) -> None:
        cell = Cell(platform_1__top="servo_1")
        cell.attaches["servo_5/output"] = "platform_2", 2
        made = stepper(layout, cell)
        await made._to_other(OTHER)
        assert made.result.attempts == 2
        assert cell.enabled == [("servo_5/output", True), (BASE, False)]

    @pytest.mark.slow
    async def test_then_it_stands_on_the_other_platform(self, layout: Layout) -> None:
        cell = Cell(platform_1__top="servo_1")
        cell.attaches["servo_5/output"] = "platform_2", 0
        made = stepper(layout, cell)
        await made._to_other(OTHER)
        chain = made.arm.chain
        assert isinstance(chain, HangingChain)
        assert chain.joints == Chain(made.frame(BASE), made.arm.members).joints[::-1]
        platform = made._platform("platform_2")
        foot = HangingChain(platform, made.arm.members)
        assert max(offset_between(chain.forward(np.zeros(5)), foot.forward(np.zeros(5)))) < 1e-9

    @pytest.mark.slow
    async def test_an_end_that_never_holds_fails_with_the_connectors_reason_and_nothing_is_released(
        self, layout: Layout
    ) -> None:
        cell = Cell(platform_1__top="servo_1")
        made = stepper(layout, cell)
        with pytest.raises(TaskFailed, match="servo_5/output does not hold platform_2: leaks"):
            await made._to_other(OTHER)
        assert made.result.attempts == PRESSES
        assert cell.enabled == [("servo_5/output", True)]
        assert cell.held == {BASE: "servo_1"}

    async def test_out_of_reach_nothing_is_enabled(self, layout: Layout) -> None:
        cell = Cell(platform_1__top="servo_1")
        made = stepper(layout, cell)
        far = shifted(5.0) * made.frame(OTHER)
        with pytest.raises(TaskFailed, match="the end of the arm cannot be lowered onto servo_5/output"):
            await made._lower(far, np.array([0.0, 0.0, -1.0]), np.zeros(5), "servo_5/output", "platform_2")
        assert cell.enabled == []


@pytest.mark.slow
async def test_it_steps_back_so_that_its_foot_faces_as_before(layout: Layout) -> None:
    made = stepper(layout, Cell())
    hanging = HangingChain(made._platform("platform_2"), made.arm.members)
    made.arm.stand(hanging)
    there = made.frame(BASE)
    for posture in made.arm.above((there * shifted(z=0.05)).translation.tolist(), np.zeros(5), (0.0, 0.0, 1.0)):
        before = hanging.forward(posture)
        facing = hanging.forward(made._facing(posture, there))
        assert facing.translation == pytest.approx(before.translation, abs=1e-6)
        assert facing.rotation[:, 0] == pytest.approx(there.rotation[:, 0], abs=1e-3)
        assert np.max(np.abs(made._facing(posture, there))) < 2.0 * np.pi
