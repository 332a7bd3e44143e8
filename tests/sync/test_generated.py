"""The committed facade is what the generator gives, and covers everything that is public."""

from __future__ import annotations

import inspect
import runpy
from pathlib import Path

import pytest

import jauspy.ocu
import jauspy.sync

GENERATOR = Path(__file__).parents[2] / "tools" / "generate_sync.py"


def test_committed_facade_matches_the_generator():
    generator = runpy.run_path(str(GENERATOR))
    assert generator["generated"]() == generator["TARGET"].read_text()


@pytest.mark.parametrize("name", jauspy.sync.__all__)
def test_facade_is_complete_and_synchronous(name):
    asynchronous = getattr(jauspy.ocu, name)
    facade = getattr(jauspy.sync, name)
    public = {each for each in vars(asynchronous) if not each.startswith("_")} - {
        "on_sent",
        "on_ready",
        "watch_program",
        "trace",
    }
    assert public <= set(dir(facade))
    for each in public:
        member = getattr(facade, each)
        assert not inspect.iscoroutinefunction(member), each
        assert not inspect.isasyncgenfunction(member), each
        assert "await " not in (member.__doc__ or ""), each
