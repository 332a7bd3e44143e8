"""What a command says when an extra is not installed. `make wheel-test` shows it with a wheel alone, more slowly."""

import subprocess
import sys

import pytest

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
