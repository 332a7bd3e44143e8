"""Directories that nobody else uses."""

import shutil
import tempfile
from pathlib import Path

import pytest


@pytest.fixture(autouse=True)
def width(monkeypatch):
    """Of the terminal, in columns: what it is where nobody says."""
    monkeypatch.setenv("COLUMNS", "80")


def _root():
    root = Path(tempfile.mkdtemp(prefix="jauspy-"))
    yield root
    shutil.rmtree(root)


@pytest.fixture
def local_root():
    """A local root whose name is short enough for Unix sockets."""
    yield from _root()


@pytest.fixture
def other_root():
    """Another one."""
    yield from _root()
