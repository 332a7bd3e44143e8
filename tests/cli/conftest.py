"""Ports and directories that nobody else uses."""

import shutil
import socket
import tempfile
from pathlib import Path

import pytest


@pytest.fixture
def free_port():
    """A UDP port that was free a moment ago."""
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as probe:
        probe.bind(("0.0.0.0", 0))
        return probe.getsockname()[1]


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
