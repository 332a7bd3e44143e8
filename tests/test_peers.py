"""The tables of docs/peers.md name tests that exist, and leave none of their numbers out."""

import re
from pathlib import Path

import pytest

TESTS = Path(__file__).parent
TEXT = (TESTS.parent / "docs/peers.md").read_text()
NAMED = sorted(set(re.findall(r"`([a-z_0-9/]+\.py)::(\w+)`", TEXT)))


@pytest.mark.parametrize(("file", "name"), NAMED)
def test_named_tests_exist(file: str, name: str) -> None:
    assert re.search(rf"^(async )?def {name}\(", (TESTS / file).read_text(), re.M)


@pytest.mark.parametrize(("letter", "count"), [("J", 16), ("P", 12), ("C", 4), ("O", 2), ("", 20)])
def test_numbers_are_consecutive(letter: str, count: int) -> None:
    """Each row ends in what tests it."""
    found = [int(number) for number in re.findall(rf"^\| {letter}(\d+) \| .*`[^|]*\|$", TEXT, re.M)]
    assert found == list(range(1, count + 1))


@pytest.mark.parametrize("file", ["node/test_checks.py", "node/test_captures.py"])
def test_table_has_all_checks_and_captures(file: str) -> None:
    there = re.findall(r"^(?:async )?def (test_\w+)\(", (TESTS / file).read_text(), re.M)
    assert {(file, name) for name in there} <= set(NAMED)
