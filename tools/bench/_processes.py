"""Children of the benchmarks."""

from __future__ import annotations

import socket
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager


def free_port() -> int:
    """A UDP port that nobody has."""
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as sock:
        sock.bind(("127.0.0.1", 0))
        return int(sock.getsockname()[1])


@contextmanager
def ready(*command: str) -> Iterator[subprocess.Popen[bytes]]:
    """A Python child that has said `ready` on its output."""
    with subprocess.Popen([sys.executable, *command], stdin=-1, stdout=-1, stderr=subprocess.DEVNULL) as child:
        try:
            assert child.stdout is not None
            assert b"ready" in child.stdout.readline()
            yield child
        finally:
            child.kill()


def node_manager(root: str, port: int) -> tuple[str, ...]:
    """The command of a node manager of this machine alone."""
    options = ("--address", "127.0.0.1", "--port", str(port), "--local-root", root)
    return ("-m", "jauspy.cli.main", "node-manager", *options)
