"""`make attack` is tested by defects of its victims: each is noticed, and without any the bounds are kept."""

import os
import subprocess
import sys
from pathlib import Path

import pytest
from tools.attack.attacks import ALL
from tools.attack.mutants import MUTANTS

pytestmark = pytest.mark.alone

ROOT = Path(__file__).parents[2]
SECONDS = {"every-plan": 10}
"""For attacks that notice a mutant by how long work takes: enough of it, on a fast machine too."""
NAMES = sorted({name for mutant in MUTANTS.values() for name in mutant.noticed_by})


def attacked(*arguments: str) -> subprocess.CompletedProcess[str]:
    done = subprocess.run(
        (sys.executable, "-m", "tools.attack", *arguments),
        cwd=ROOT,
        env={**os.environ, "PYTHONPATH": str(ROOT / "src")},
        capture_output=True,
        text=True,
        timeout=500,
        check=False,
    )
    if "not run" in done.stdout:
        pytest.skip(f"not possible here: {done.stdout}")
    return done


def test_mutants_are_noticed_by_attacks_that_exist() -> None:
    assert len(MUTANTS) >= 10
    assert set(NAMES) <= {each.name for each in ALL}


@pytest.mark.slow
def test_each_mutant_can_be_applied() -> None:
    """In a process of its own, since the defect stays; what it replaces exists."""
    program = "from tools.attack.mutants import apply; import sys; [apply(name) for name in sys.argv[1:]]"
    subprocess.run((sys.executable, "-c", program, *MUTANTS), cwd=ROOT, check=True, timeout=60)


@pytest.mark.slow
@pytest.mark.timeout(600)  # above that of the process, which would leave its victims behind
@pytest.mark.parametrize("name", sorted(MUTANTS))
def test_the_attack_notices(name: str) -> None:
    done = attacked("--seconds", str(SECONDS.get(name, 6)), "--mutant", name)
    assert done.returncode == 0, done.stdout + done.stderr
    assert f"mutant {name}: " in done.stdout


@pytest.mark.slow
@pytest.mark.timeout(600)
def test_without_a_mutant_the_bounds_are_kept() -> None:
    done = attacked("--seconds", str(8 * len(NAMES)), "--only", *NAMES)
    assert done.returncode == 0, done.stdout + done.stderr
