"""What a command says when an extra is not installed. `make wheel-test` shows it with a wheel alone, more slowly."""

import subprocess
import sys
import tomllib
from pathlib import Path

import pytest

from jauspy.cli import EXTRA_OF_VERB
from jauspy.cli.main import GROUPS, VERBS

WITHOUT = """
import sys
sys.modules[sys.argv[1]] = None  # as if it were not installed
del sys.argv[1]
from jauspy.cli import main
main()
"""


@pytest.mark.slow
@pytest.mark.parametrize(
    ("package", "command", "extra"),
    [("typer", "ls", "cli"), ("xacro", "up inc1", "robot"), ("numpy", "map yard", "map")],
)
def test_one_sentence_names_the_extra(package: str, command: str, extra: str) -> None:
    run = (sys.executable, "-c", WITHOUT, package, *command.split())
    done = subprocess.run(run, capture_output=True, text=True, check=False)
    [line] = done.stderr.splitlines()
    assert f"pip install 'jauspy[{extra}]'" in line
    assert done.returncode == 1


EXTRAS: dict[str, list[str]] = tomllib.loads((Path(__file__).parents[2] / "pyproject.toml").read_text())["project"][
    "optional-dependencies"
]


def packages(extra: str) -> set[str]:
    """The requirements of an extra and of those that it includes."""
    found: set[str] = set()
    for requirement in EXTRAS[extra]:
        if requirement.startswith("jauspy["):
            for included in requirement.removeprefix("jauspy[").removesuffix("]").split(","):
                found |= packages(included)
        else:
            found.add(requirement)
    return found


@pytest.mark.parametrize(("verb", "extra"), EXTRA_OF_VERB.items())
def test_the_extra_of_a_verb_is_enough_for_it(verb: str, extra: str) -> None:
    assert verb in VERBS or verb in GROUPS
    assert packages("cli") <= packages(extra)


def test_the_extra_all_includes_every_other_one() -> None:
    special = ("cell-cluster", "teleop", "sound")
    every = {requirement for extra in EXTRAS if extra not in special for requirement in packages(extra)}
    assert packages("all") == every, "cell-cluster is for several machines, evdev is compiled, sound needs PortAudio"
