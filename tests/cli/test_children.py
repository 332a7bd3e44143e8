"""Verbs in processes of their own: ready, failed, gone."""

import os
import signal
import subprocess
import sys

import psutil
import pytest

from jauspy.cli.children import Child, ChildFailed


async def test_a_child_is_ready_when_it_says_so_and_gone_afterwards(free_port, local_root):
    async with Child(
        "node manager", ["node-manager", "--port", str(free_port), "--local-root", str(local_root)]
    ) as child:
        assert child.first_line.startswith("node manager ready")
        assert psutil.pid_exists(child.pid)
    assert not psutil.pid_exists(child.pid)
    await child.stop()  # twice is fine


async def test_a_child_that_fails_says_why(free_port, local_root):
    arguments = ["node-manager", "--port", str(free_port), "--local-root", str(local_root), "--address", "203.0.113.9"]
    with pytest.raises(ChildFailed, match=r"^node manager: 203\.0\.113\.9 is no address of this machine"):
        async with Child("node manager", arguments):
            pass


async def test_a_child_that_ends_is_noticed(free_port, local_root):
    arguments = ["node-manager", "--port", str(free_port), "--local-root", str(local_root)]
    async with Child("node manager", arguments) as child:
        os.kill(child.pid, signal.SIGKILL)
        error = await child.ended()
    assert "node manager" in str(error)


PARENT = """
import asyncio, sys
from jauspy.cli.children import Child

async def main():
    async with Child("node manager", ["node-manager", "--port", sys.argv[1], "--local-root", sys.argv[2]]) as child:
        print(child.pid, flush=True)
        await asyncio.Event().wait()

asyncio.run(main())
"""


def test_a_killed_parent_takes_its_child_along(free_port, local_root):
    parent = subprocess.Popen(
        [sys.executable, "-c", PARENT, str(free_port), str(local_root)], stdout=subprocess.PIPE, text=True
    )
    child = psutil.Process(int(parent.stdout.readline()))
    parent.kill()
    parent.wait()
    parent.stdout.close()
    child.wait(timeout=10)
    assert not child.is_running()
    assert not list(local_root.iterdir())
