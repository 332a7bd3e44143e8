"""Processes that work for another, and must not hold it up."""

from __future__ import annotations

import json
import os
import subprocess
import sys

import pytest

PROGRAM = """
import json, os
from jauspy.workers import give_way
give_way(7)
print(json.dumps([os.nice(0), sorted(os.sched_getaffinity(0))]))
"""


def given_way(processors: set[int]) -> tuple[int, set[int]]:
    """How much nicer a process is that gave way, and the processors that it kept of these."""
    ours = os.sched_getaffinity(0)
    os.sched_setaffinity(0, processors)
    try:
        out = subprocess.run([sys.executable, "-c", PROGRAM], check=True, stdout=subprocess.PIPE).stdout
    finally:
        os.sched_setaffinity(0, ours)
    nice, kept = json.loads(out)
    return nice - os.nice(0), set(kept)


def test_a_process_that_gives_way_leaves_the_first_processor_alone() -> None:
    processors = os.sched_getaffinity(0)
    if len(processors) < 2:
        pytest.skip("one processor only")
    assert given_way(processors) == (7, processors - {min(processors)})


def test_where_there_is_one_processor_it_is_shared() -> None:
    processors = {min(os.sched_getaffinity(0))}
    assert given_way(processors) == (7, processors)
