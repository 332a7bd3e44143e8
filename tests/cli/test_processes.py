"""Verbs in processes of their own: ready, failed, gone."""

import os
import signal
import subprocess
import sys

import psutil
import pytest

from jauspy.cli.processes import ChildFailed, ChildProcess
from jauspy.transport.local import is_alive


@pytest.mark.slow
async def test_child_is_ready_after_its_first_line_and_ends_on_exit(free_port, local_root):
    async with ChildProcess(
        "node manager", ["node-manager", "--port", str(free_port), "--local-root", str(local_root)]
    ) as child:
        assert is_alive(local_root / "JuniorRTE")
        assert psutil.pid_exists(child.pid)
    assert not psutil.pid_exists(child.pid)
    await child.stop()  # twice is fine


@pytest.mark.slow
async def test_failed_child_error_has_its_output(free_port, local_root):
    arguments = ["node-manager", "--port", str(free_port), "--local-root", str(local_root), "--address", "203.0.113.9"]
    with pytest.raises(ChildFailed, match=r"^node manager: 203\.0\.113\.9 is not an address of this machine"):
        async with ChildProcess("node manager", arguments):
            pass


@pytest.mark.slow
async def test_end_of_a_child_is_detected(free_port, local_root):
    where = ["--port", str(free_port), "--interface", "127.0.0.1", "--local-root", str(local_root)]
    arguments = ["node-manager", *where]
    async with ChildProcess("node manager", arguments) as child:
        os.kill(child.pid, signal.SIGKILL)
        error = await child.ended()
    assert str(error) == "node manager: ended by signal 9"


async def test_long_lines_are_read(monkeypatch, tmp_path):
    lines = []
    say = tmp_path / "say"
    say.write_text(
        "#!/bin/sh\ntrap go=1 USR1\nhead -c 200000 /dev/zero | tr '\\0' x; echo\n"
        "until [ $go ]; do sleep 0.05; done\n"
        "head -c 200000 /dev/zero | tr '\\0' y >&2; echo >&2; echo last >&2; exit 3\n"
    )
    say.chmod(0o755)
    monkeypatch.setattr(sys, "executable", str(say))
    async with ChildProcess("talker", [], on_error_line=lines.append) as child:
        child.signal(signal.SIGUSR1)
        assert str(await child.ended()) == "talker: ended with exit status 3"
    assert lines[-1] == "last"
    assert "".join(lines[:-1]) == "y" * 200000
    async with ChildProcess("talker", []) as child:
        child.signal(signal.SIGUSR1)
        message = str(await child.ended())
    assert message.startswith("talker: yyy")
    assert message.endswith(" last")


PARENT = """
import asyncio, sys
from jauspy.cli.processes import ChildProcess

async def main():
    arguments = ["node-manager", "--port", sys.argv[1], "--local-root", sys.argv[2]]
    async with ChildProcess("node manager", arguments) as child:
        print(child.pid, flush=True)
        await asyncio.Event().wait()

asyncio.run(main())
"""


def test_child_ends_when_its_parent_is_killed(free_port, local_root):
    parent = subprocess.Popen(
        [sys.executable, "-c", PARENT, str(free_port), str(local_root)], stdout=subprocess.PIPE, text=True
    )
    child = psutil.Process(int(parent.stdout.readline()))
    parent.kill()
    parent.wait()
    parent.stdout.close()
    child.wait(timeout=30)
    assert not child.is_running()
    assert not list(local_root.iterdir())
