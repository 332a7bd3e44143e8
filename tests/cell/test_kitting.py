"""Orders without a motion: points, places on the tray, failures that cost one product only."""

from __future__ import annotations

import math
from types import SimpleNamespace
from typing import Any

import numpy as np
import pinocchio as pin
import pytest
from hypothesis import given, strategies as st
from tests.helpers.fake_cell import FakeCell

from jauspy.cell.assembly import Assembler
from jauspy.cell.carrying import Held
from jauspy.cell.frames import shifted, turned
from jauspy.cell.interface import GRIPPER
from jauspy.cell.kitting import (
    MAX_ANGLE,
    MAX_DISTANCE,
    STEP_TIMES,
    TRAY,
    Kit,
    Kitter,
    Product,
    _turned_to,
    drawn_order,
    score,
)
from jauspy.cell.modular_arm import FIVE_JOINTS, Chain, Member
from jauspy.cell.scene import Layout
from jauspy.cell.schedule import TaskFailed
from jauspy.cell.shares import StepTimes, best_share, estimated

PLACED = st.dictionaries(st.integers(0, 3), st.tuples(st.floats(0.0, 0.06), st.floats(0.0, 0.2)), max_size=4)


@given(PLACED, st.integers(0, 3))
def test_a_score_is_between_none_and_three_points_a_product(placed: dict[int, Any], extra: int) -> None:
    points = score(placed, 4, extra)
    assert len(placed) <= points <= 12
    right = all(far <= MAX_DISTANCE and turn <= MAX_ANGLE for far, turn in placed.values())
    assert (points == 12) == (len(placed) == 4 and not extra and right)


@given(PLACED.filter(lambda placed: len(placed) < 4))
def test_one_more_product_in_its_place_is_never_worse(placed: dict[int, Any]) -> None:
    missing = next(number for number in range(4) if number not in placed)
    assert score({**placed, missing: (0.0, 0.0)}, 4) >= score(placed, 4) + 2


@given(st.integers(0, 10_000))
def test_products_of_an_order_do_not_touch_each_other_and_lie_on_the_tray(seed: int) -> None:
    order = drawn_order(seed)
    assert len(order) == 4
    for number, product in enumerate(order):
        assert abs(product.yaw) <= 0.4
        assert abs(product.x) <= 0.135
        assert abs(product.y) <= 0.175
        assert all(math.hypot(product.x - each.x, product.y - each.y) > 0.16 for each in order[:number])


@pytest.fixture
def kitter(layout: Layout) -> Kitter:
    cell: Any = FakeCell(layout)
    return Kitter(cell, layout, Assembler(cell, layout))


class TestPlaces:
    @pytest.mark.parametrize("type", ["bracket_angled", "tube_long", "wheel", "box"])
    def test_a_part_lies_on_the_tray_with_its_grasp_upward(self, kitter: Kitter, layout: Layout, type: str) -> None:
        part = layout.of_types((type,))[0]
        product = Product(type, 0.1, -0.05, 0.3)
        gripper = kitter.goal(product, part) * layout.grasp(part)
        top = layout.setup.conveyor.pose.z + layout.thickness(part)
        assert gripper.translation == pytest.approx([TRAY[0] + 0.1, TRAY[1] - 0.05, top])
        assert gripper.rotation[:, 2] == pytest.approx([0.0, 0.0, -1.0]), "the gripper comes from above"
        assert gripper.rotation[:, 0] == pytest.approx([math.cos(0.3), math.sin(0.3), 0.0])

    def test_each_part_is_thicker_than_nothing_and_no_thicker_than_its_longest_side(
        self, kitter: Kitter, layout: Layout
    ) -> None:
        for part in layout.setup.parts:
            solids = layout.type_of(part.name).solids
            if solids:
                assert 0.0 < layout.thickness(part.name) <= max(solids[0].size) * math.sqrt(3.0) + 1e-9


class TestFailures:
    async def test_a_failure_names_the_product_and_lets_go_of_what_is_held(self, kitter: Kitter) -> None:
        async def fail() -> None:
            raise TaskFailed("it is lost")

        kit = Kit()
        kitter.ur10.held = Held("wheel_1", pin.SE3.Identity())
        cell: Any = kitter.cell
        cell.enabled[GRIPPER] = True
        await kitter._guarded(fail(), Product("wheel", 0.0, 0.0), kit)
        assert kit.failures == ["wheel: it is lost"]
        assert kitter.ur10.held is None
        assert not cell.enabled[GRIPPER]

    async def test_an_error_of_the_program_is_no_failed_product(self, kitter: Kitter) -> None:
        async def fail() -> None:
            raise ZeroDivisionError

        with pytest.raises(ZeroDivisionError):
            await kitter._guarded(fail(), Product("wheel", 0.0, 0.0), Kit())

    async def test_what_cannot_be_fetched_costs_its_own_place_only(
        self, kitter: Kitter, monkeypatch: pytest.MonkeyPatch
    ) -> None:
        order, placed = drawn_order(1), list[str]()

        async def fetch(product: Product, state: dict[str, str]) -> None:
            if product is order[1]:
                raise TaskFailed("none is left")
            state["part"] = f"{product.type}_1"

        async def place(product: Product, part: str, kit: Kit) -> None:
            placed.append(part)
            kit.products.append((product, part))

        monkeypatch.setattr(kitter, "_fetch", fetch)
        monkeypatch.setattr(kitter, "_place", place)
        kit = await kitter.fill(order)
        assert placed == [f"{each.type}_1" for each in order if each is not order[1]]
        assert kit.failures == [f"{order[1].type}: none is left"]
        assert [each.action for each in kit.timeline.entries] == [
            f"{verb} {number}" for number in range(4) for verb in ("fetch", "place")
        ]

    def test_without_a_belt_there_is_no_tray(self, layout: Layout) -> None:
        nothing: Any = SimpleNamespace(setup=SimpleNamespace(conveyor=None))
        cell: Any = None
        with pytest.raises(TaskFailed, match="the cell has no conveyor, on which the tray is"):
            Kitter(cell, nothing, cell)


class TestShares:
    def test_one_box_by_the_arm_is_expected_to_save_time_and_the_other_is_not(self, kitter: Kitter) -> None:
        arm: Any = object()
        kitter.arm = arm
        order = drawn_order(1)
        boxes = [n for n, product in enumerate(order) if product.type == "box"]
        share = best_share(boxes, lambda chosen: kitter._planned(order, chosen))
        assert len(share.by_arm) == 1
        assert share.alone - share.expected > 4.0
        assert estimated(kitter._planned(order, frozenset(boxes))) > share.expected + 2.0

    def test_an_arm_that_is_slow_is_not_used(self, kitter: Kitter) -> None:
        arm: Any = object()
        kitter.arm = arm
        kitter.times = StepTimes(STEP_TIMES | {"take": 15.0, "put": 20.0})
        assert best_share([2, 3], lambda chosen: kitter._planned(drawn_order(1), chosen)).by_arm == frozenset()


class TestBoxes:
    def test_the_box_that_is_nearest_to_the_tray_is_next(self, kitter: Kitter, monkeypatch: pytest.MonkeyPatch) -> None:
        places = {name: shifted(1.0, 0.4 - 0.2 * number) for number, name in enumerate(kitter._boxes)}
        monkeypatch.setattr(kitter.cell, "latest", lambda name: (0.0, places[name]), raising=False)
        for expected in kitter._boxes:
            assert kitter._next_box() == expected
            kitter._taken.add(expected)
        with pytest.raises(TaskFailed, match="there is no box left"):
            kitter._next_box()


@pytest.mark.slow
@pytest.mark.parametrize("yaw", [-2.5, -0.4, 0.0, 0.7, 3.0])
def test_the_last_joint_gives_the_tip_its_heading(layout: Layout, yaw: float) -> None:
    members = [Member(name, layout.type_of(name), pin.SE3.Identity(), "output") for name in FIVE_JOINTS]
    chain = Chain(shifted(0.6, 0.22, 0.2), members)
    posture = chain.pointing(np.array([1.05, 0.22, 0.4]), np.array([0.0, 0.0, -1.0]), np.zeros(5))[0]
    held = turned("z", yaw) * turned("x", math.pi)
    arm: Any = SimpleNamespace(chain=chain)
    found = chain.forward(_turned_to(arm, posture, held))
    assert found.rotation[:, 0] @ held.rotation[:, 0] > math.cos(0.02)
    assert found.translation == pytest.approx(chain.forward(posture).translation, abs=1e-6)
