"""The committed facade is what the generator gives, and covers everything that is public."""

from __future__ import annotations

import inspect
import runpy
from pathlib import Path

import pytest

import jauspy.ocu
import jauspy.sync

GENERATOR = Path(__file__).parents[2] / "tools" / "generate_sync.py"


def test_the_committed_facade_is_what_the_generator_gives():
    generator = runpy.run_path(str(GENERATOR))
    assert generator["generated"]() == generator["TARGET"].read_text()


@pytest.mark.parametrize("name", jauspy.sync.__all__)
def test_nothing_public_is_missing_and_nothing_is_left_to_await(name):
    asynchronous = getattr(jauspy.ocu, name)
    facade = getattr(jauspy.sync, name)
    public = {each for each in vars(asynchronous) if not each.startswith("_")} - {"on_sent"}
    assert public <= set(dir(facade))
    for each in public:
        member = getattr(facade, each)
        assert not inspect.iscoroutinefunction(member), each
        assert not inspect.isasyncgenfunction(member), each
        assert "await " not in (member.__doc__ or ""), each
