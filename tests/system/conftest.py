"""Processes of the command line, and what is needed to end them whatever happens."""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Callable, Iterator
from contextlib import ExitStack

import pytest

Start = Callable[..., subprocess.Popen[str]]


@pytest.fixture
def start() -> Iterator[Start]:
    """Starts `jauspy ...` as a process that is waited for until it says `ready`; `within` comes before the command."""
    with ExitStack() as stack:

        def make(*arguments: str, ready: str, within: tuple[str, ...] = ()) -> subprocess.Popen[str]:
            command = [*within, sys.executable, "-m", "jauspy.cli.main", *arguments]
            process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
            stack.callback(_end, process)
            assert process.stdout is not None
            said = []
            for line in process.stdout:
                said.append(line)
                if ready in line:
                    return process
            pytest.fail(f"{ready!r} was never said: {said}")

        yield make


def _end(process: subprocess.Popen[str]) -> None:
    """In order, so that it ends its own children."""
    process.terminate()
    try:
        process.communicate(timeout=20)
    except subprocess.TimeoutExpired:
        process.kill()
        process.communicate()
        raise
