"""The published rules of ARIAC 2023 for kits, one by one, and mutants of each rule."""

from __future__ import annotations

import itertools
from collections.abc import Callable

import pytest
from hypothesis import given, strategies as st

from jauspy.cell.ariac import scoring
from jauspy.cell.ariac.board import OrderBoard
from jauspy.cell.ariac.runner import priority_violations
from jauspy.cell.ariac.scoring import Lying, Wanted, efficiency, kit_score, quadrant_points, trial_score
from jauspy.cell.ariac.summary import by_challenge, by_trial
from jauspy.cell.measurements import Measured
from jauspy.errors import ConfigError

LONG = Wanted("tube", "tube_long")
TABLE = [
    (Lying("a", "tube", "tube_long", 1), 3),
    (Lying("a", "tube", "tube_short", 1), 2),
    (Lying("a", "tube", "tube_long", 1, flipped=True), 2),
    (Lying("a", "tube", "tube_short", 1, flipped=True), 1),
    (Lying("a", "wheel", "wheel", 1), 0),
    (Lying("a", "tube", "tube_long", 1, faulty=True), 0),
    (Lying("a", "tube", "tube_short", 1, flipped=True, faulty=True), 0),
    (None, 0),
]
"""The published table of a quadrant; its last row here is an empty quadrant."""


def rules_hold(points: Callable[[Wanted, Lying | None], int] = quadrant_points) -> bool:
    return all(points(LONG, lying) == expected for lying, expected in TABLE)


def test_the_points_of_a_quadrant_are_those_of_the_published_table() -> None:
    assert rules_hold()


@pytest.mark.parametrize(
    "mutant",
    [
        lambda _, lying: 3 if lying else 0,
        lambda wanted, lying: quadrant_points(wanted, lying) if lying is None or not lying.faulty else 1,
        lambda wanted, lying: min(3, quadrant_points(wanted, lying) + bool(lying and lying.flipped)),
        lambda wanted, lying: 0 if lying and lying.type != wanted.type else quadrant_points(wanted, lying),
    ],
)
def test_the_table_catches_each_rule_that_is_left_out(mutant: Callable[[Wanted, Lying | None], int]) -> None:
    assert not rules_hold(mutant)


def perfect(count: int) -> tuple[dict[int, Wanted], list[Lying]]:
    wanted = dict.fromkeys(range(1, count + 1), LONG)
    return wanted, [Lying(f"tube_{quadrant}", "tube", "tube_long", quadrant) for quadrant in wanted]


@pytest.mark.parametrize("count", [1, 2, 3, 4])
def test_a_perfect_kit_has_the_tray_three_points_a_part_and_the_bonus(count: int) -> None:
    score = kit_score(*perfect(count))
    assert (score.tray, score.bonus, score.penalty) == (3, count, 0)
    assert score.total == score.most == 3 + 4 * count


def test_one_defect_costs_its_point_and_the_bonus() -> None:
    wanted, lying = perfect(4)
    lying[0] = Lying("tube_1", "tube", "tube_long", 1, flipped=True)
    assert kit_score(wanted, lying).total == 3 + 3 * 4 - 1


def test_the_wrong_tray_costs_its_points_and_a_wrong_destination_all() -> None:
    wanted, lying = perfect(2)
    assert kit_score(wanted, lying, right_tray=False).total == 8
    assert kit_score(wanted, lying, right_destination=False).total == 0


def test_parts_too_many_cost_one_point_each_and_never_more_than_there_are() -> None:
    wanted, lying = perfect(2)
    more = [Lying(f"box_{number}", "box", "box", 4) for number in range(3)]
    assert kit_score(wanted, lying + more).total == 11 - 3
    assert kit_score(wanted, lying[:1] + more[:1]).penalty == 0, "not more parts than the order wants"
    assert kit_score({1: LONG}, more * 9, right_tray=False).total == 0


def test_of_two_parts_in_a_quadrant_the_better_one_counts_and_the_other_is_too_many() -> None:
    wanted, lying = perfect(1)
    score = kit_score(wanted, [*lying, Lying("tube_9", "tube", "tube_short", 1)])
    assert (score.quadrants, score.penalty) == ({1: 3}, 1)


LYING = st.builds(
    Lying,
    st.text("ab", min_size=1, max_size=3),
    st.sampled_from(["tube", "wheel"]),
    st.sampled_from(["tube_long", "tube_short", "wheel"]),
    st.integers(1, 4),
    st.booleans(),
    st.booleans(),
)


@given(st.lists(LYING, max_size=8), st.integers(1, 4))
def test_no_kit_has_less_than_nothing_or_more_than_a_perfect_one(lying: list[Lying], count: int) -> None:
    wanted, _ = perfect(count)
    score = kit_score(wanted, lying)
    assert 0 <= score.total <= score.most
    assert (score.total == score.most) == (
        len(lying) == count
        and {part.quadrant for part in lying} == set(wanted)
        and all(quadrant_points(LONG, part) == 3 for part in lying)
    )


def test_the_score_of_a_trial_weighs_orders_by_priority_and_efficiency() -> None:
    assert trial_score([(1.0, 1.2, 10.0), (2.0, 0.5, 8.0)], cost_factor=0.5) == pytest.approx(10.0)
    assert efficiency(10.0, [10.0, 20.0]) == pytest.approx(1.5)
    assert efficiency(20.0, [10.0, 20.0]) == pytest.approx(0.75)
    assert efficiency(0.0, [1.0]) == 0.0


class Clock:
    def __init__(self) -> None:
        self.time = 0.0

    def __call__(self) -> float:
        self.time += 1.0
        return self.time


def test_a_board_has_orders_with_priority_first_and_changes_only_what_is_open() -> None:
    submitted: list[str] = []
    board = OrderBoard(Clock(), lambda order: submitted.append(order.id))
    board.announce("A", 1, {1: "wheel"}, priority=False)
    board.announce("B", 2, {1: "box"}, priority=True)
    urgent = board.most_urgent()
    assert urgent is not None
    assert urgent.id == "B"
    assert board.change("A", {2: "box"})
    assert board.orders["A"].products == {2: "box"}
    board.submit("B")
    assert submitted == ["B"]
    assert not board.change("B", {1: "wheel"}), "it is submitted"
    assert not board.is_done
    board.is_complete = True
    board.submit("A")
    assert board.is_done
    assert board.most_urgent() is None
    for id in ("A", "C"):
        with pytest.raises(ConfigError, match=f"the order '{id}' is not open"):
            board.submit(id)


@pytest.mark.parametrize("ids", list(itertools.permutations("AB")))
def test_an_order_that_is_submitted_before_an_open_one_with_priority_counts(ids: tuple[str, ...]) -> None:
    board = OrderBoard(Clock())
    board.announce("A", 1, {1: "wheel"}, priority=False)
    board.announce("B", 2, {1: "box"}, priority=True)
    for id in ids:
        board.submit(id)
    assert priority_violations(board) == (ids == ("A", "B"))


def run(seed: int, trial: str, time: float, score: float, *challenges: str, success: bool = True) -> Measured:
    values = {"score": score, "most_points": 11.0, "order_time A": time, "score A": score}
    rows = [{"trial": trial, "challenges": list(challenges)}]
    return Measured(seed, "ariac", success=success, duration=time, values=values, rows=rows)


def test_a_summary_has_each_trial_and_each_challenge() -> None:
    results = [
        run(0, "plain", 10.0, 11.0),
        run(1, "plain", 30.0, 11.0),
        run(2, "drops", 20.0, 8.0, "dropped parts", success=False),
    ]
    drops, plain = by_trial(results)
    assert (plain.trial, plain.runs, plain.successes, plain.score, plain.duration) == ("plain", 2, 2, 11.0, 20.0)
    assert plain.trial_score == pytest.approx(11.0 * (2.0 + 2.0 / 3.0) / 2.0)
    assert (drops.successes, drops.challenges) == (0, ("dropped parts",))
    assert by_challenge(results) == {"dropped parts": (1, 0), "none": (2, 2)}


def test_the_weights_are_those_that_were_published() -> None:
    assert (scoring.TRAY_POINTS, scoring.QUADRANT_POINTS) == (3, 3)
