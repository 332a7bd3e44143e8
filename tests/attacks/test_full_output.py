"""Nobody reads what a node manager prints, or the disk is full."""

import asyncio
import os
import signal
import subprocess
import sys
import time
from pathlib import Path
from typing import IO

import pytest

from jauspy.errors import TransportError
from jauspy.node import status


def full_pipe() -> tuple[IO[bytes], IO[bytes]]:
    ends = os.pipe()
    os.set_blocking(ends[1], False)
    try:
        while True:
            os.write(ends[1], bytes(4096))
    except BlockingIOError:
        os.set_blocking(ends[1], True)
    return os.fdopen(ends[0], "rb"), os.fdopen(ends[1], "wb")


@pytest.mark.slow
@pytest.mark.parametrize("kind", ["disk", "pipe"])
def test_it_starts_and_ends(root: Path, free_port: int, kind: str) -> None:
    unread, output = full_pipe() if kind == "pipe" else (None, Path("/dev/full").open("wb"))  # noqa: SIM115 - for the process
    command = [sys.executable, "-m", "jauspy.cli.main", "node-manager", "--verbose", "--address", "127.0.0.1"]
    with output:
        process = subprocess.Popen(
            [*command, "--port", str(free_port), "--local-root", str(root)], stdout=output, stderr=output
        )
    try:
        until = time.monotonic() + 20
        while time.monotonic() < until:
            try:
                assert asyncio.run(status.read(root))["pid"] == process.pid
                break
            except TransportError:
                assert process.poll() is None
                time.sleep(0.05)
        process.send_signal(signal.SIGUSR1)
        assert asyncio.run(status.read(root))["pid"] == process.pid
        process.send_signal(signal.SIGTERM)
        assert process.wait(20) == 0
    finally:
        process.kill()
        process.wait()
        if unread is not None:
            unread.close()
