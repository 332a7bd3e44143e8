"""`make attack` itself: it finds broken bounds, says them in one sentence, and writes its table."""

import os
import subprocess
import sys
from pathlib import Path

import pytest
from tools.attack import __main__ as harness, table
from tools.attack.arena import Arena
from tools.attack.attack import Attack, Attacker, Bounds, Layout, NotPossible, Result, Victims
from tools.attack.attacks import ALL
from tools.attack.hosts import Lan

pytestmark = pytest.mark.alone

ROOT = Path(__file__).parents[2]
ALONE = Lan({}, "this is a test")


def attack(name: str, run: object, **bounds: float) -> Attack:
    return Attack(name, Attacker.REMOTE, "datagrams", run, Bounds(**bounds), Layout(Victims.COMMANDS))


def good(arena: Arena) -> None:
    for _ in arena.paced(1000.0):
        arena.sent += 1


def bad(arena: Arena) -> None:
    arena.require(False, "the victim fell over")


def loses(arena: Arena) -> None:
    arena.asked, arena.lost, arena.memory = 100, 2, 30.0


def impossible(arena: Arena) -> None:
    raise NotPossible("there is no network")


def test_a_broken_bound_is_a_sentence_and_the_others_go_on() -> None:
    attacks = [attack(each.__name__, each) for each in (good, bad, loses, impossible, good)]
    results = harness.run(attacks, ALONE, 0.02, 1, keep=False)
    assert [each.broken for each in results] == [
        [],
        ["bad: the victim fell over"],
        [
            "loses: 2 of 100 honest queries were lost, 0% may be",
            "loses: the victim's memory grew by 30 MiB; the bound is 24 MiB",
        ],
        [],
        [],
    ]
    assert results[3].skipped == "there is no network"
    assert 1 <= results[0].sent <= 25


def test_each_measured_value_has_a_bound() -> None:
    limits = {"lost": 0.5, "silence": 1.0, "memory": 2.0, "descriptors": 3, "tasks": 4, "lines": 5}
    inside = Result(attack("a", good, **limits), 9, 10, 5, 1.0, 2.0, 3, 4, 5)
    inside.compare()
    assert inside.broken == []
    outside = Result(attack("a", good, **limits), 9, 10, 6, 1.1, 2.1, 4, 5, 6)
    outside.compare()
    assert len(outside.broken) == len(limits)


@pytest.mark.slow
def test_the_exit_status_tells_and_the_table_is_written(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    page = tmp_path / "page.md"
    page.write_text(f"before\n\n{table.BEGIN}\nold\n{table.END}\n\nafter\n")
    monkeypatch.setattr(harness, "MIN_SECONDS", 0.02)
    for attacks, status in (([attack("one", good)], 0), ([attack("one", good), attack("two", loses)], 1)):
        monkeypatch.setattr(harness, "ALL", attacks)
        monkeypatch.setattr(sys, "argv", ["attack", "--seconds", "0", "--write", str(page)])
        assert harness.main() == status
    reported = capsys.readouterr()
    assert "two: 2 of 100 honest queries were lost" in reported.err
    text = page.read_text()
    assert text.startswith("before\n\n")
    assert text.endswith("\n\nafter\n")
    assert "old" not in text
    assert "| two | remote, without the key | 0 datagrams | 100, 2 |" in text
    assert text.count(table.BEGIN) == text.count(table.END) == 1


def test_the_documentation_has_the_place_for_the_table() -> None:
    text = (ROOT / "docs/security.md").read_text()
    assert text.count(table.BEGIN) == text.count(table.END) == 1


def test_names_and_attackers() -> None:
    assert len({each.name for each in ALL}) == len(ALL)
    assert {each.attacker for each in ALL} == set(Attacker)


@pytest.mark.slow
@pytest.mark.parametrize("name", ["malformed", "local-udp", "configurations"])
def test_real_attacks_for_a_second(name: str) -> None:
    done = subprocess.run(
        (sys.executable, "-m", "tools.attack", "--seconds", "1", "--only", name),
        cwd=ROOT,
        env={**os.environ, "PYTHONPATH": ""},
        capture_output=True,
        text=True,
        timeout=120,
        check=False,
    )
    assert done.returncode == 0, done.stdout + done.stderr
    assert f"{name} " in done.stdout
