"""The robot that an operator has chosen: never one by itself, and not another one under the same number."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import pytest

from jauspy.console.choice import MAX_TEXT, Choice


def robots(**named: str) -> Any:
    """Robots by number: `robots(r101="inc1")`."""
    return {int(key[1:]): SimpleNamespace(id=int(key[1:]), name=name) for key, name in named.items()}


def test_none_is_chosen_for_the_operator() -> None:
    choice = Choice()
    assert choice.robot(robots(r7="stranger", r101="inc1")) is None
    assert choice.hint({}) == ""
    assert "chooses none by itself" in choice.hint(robots(r7="stranger"))
    assert choice.for_browser() is None


def test_the_chosen_one_is_shown_while_others_come_and_go() -> None:
    choice = Choice(101, "inc1")
    for found in (robots(r101="inc1"), robots(r7="stranger", r101="inc1"), robots(r101="inc1", r102="other")):
        assert choice.robot(found).id == 101
    assert choice.for_browser() == [101, "inc1"]


def test_one_that_falls_silent_is_shown_again() -> None:
    choice = Choice(101)
    assert choice.robot(robots(r101="inc1")).name == "inc1"
    assert choice.robot(robots(r7="stranger")) is None
    assert choice.hint(robots(r7="stranger")).startswith("Robot 101 inc1 does not answer.")
    assert choice.robot(robots(r101="inc1")).name == "inc1"


def test_another_one_with_its_number_is_not() -> None:
    choice = Choice(101)
    choice.robot(robots(r101="inc1"))
    for other in ("stranger", ""):
        choice.robot({})
        assert choice.robot(robots(r101=other)) is None
        assert choice.robot(robots(r101=other)) is None
    assert "You chose robot 101 inc1; now stranger answers with this number." in choice.hint(robots(r101="stranger"))
    assert choice.robot(robots(r101="inc1")).name == "inc1"
    assert choice.robot(robots(r101="stranger")) is None, "not even without a pause"


def test_a_shown_one_may_leave_its_name_out() -> None:
    choice = Choice(101, "inc1")
    choice.robot(robots(r101="inc1"))
    assert choice.robot(robots(r101="")) is not None


def test_a_browser_keeps_the_choice() -> None:
    chosen = Choice.from_text('[101, "inc1"]')
    assert chosen is not None
    assert chosen.for_browser() == [101, "inc1"]


@pytest.mark.parametrize(
    "text",
    [
        *(None, 7, "", "[]", "[0, 'x']", '[70000, "x"]', '[true, "x"]', '["101", "x"]', "[101, 5]", "{}", "[" * 1500),
        '[101, "' + "x" * MAX_TEXT + '"]',
    ],
)
def test_anything_else_is_no_choice(text: object) -> None:
    assert Choice.from_text(text) is None
