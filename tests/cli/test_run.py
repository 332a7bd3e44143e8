"""Verbs that are told to stop, and verbs whose parent dies."""

import re
import signal
import subprocess
import sys
from pathlib import Path

import pytest

WAIT = "import asyncio\nfrom jauspy.cli.processes import run, end_with_parent\n"

FOREVER = (
    WAIT
    + """
async def main():
    try:
        print("ready", flush=True)
        await asyncio.Event().wait()
    finally:
        print("in order", flush=True)

run(main())
"""
)

STUBBORN = (
    WAIT
    + """
import signal, threading
from jauspy.cli import processes
processes.PARENT_GRACE = 0.1
signal.signal(signal.SIGTERM, signal.SIG_IGN)
end_with_parent()
print("ready", flush=True)
threading.Event().wait()
"""
)


def start(code):
    process = subprocess.Popen(
        [sys.executable, "-c", code], stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True
    )
    assert process.stdout.readline() == "ready\n"
    return process


@pytest.mark.parametrize("number", [signal.SIGTERM, signal.SIGHUP])
def test_sigterm_ends_in_order_without_failure(number):
    process = start(FOREVER)
    process.send_signal(number)
    out, err = process.communicate(timeout=20)
    assert (out, err, process.returncode) == ("in order\n", "", 0)


def test_sighup_stays_ignored_under_nohup():
    process = start("import signal; signal.signal(signal.SIGHUP, signal.SIG_IGN)\n" + FOREVER)
    status = Path(f"/proc/{process.pid}/status").read_text()
    assert int(re.search(r"SigIgn:\s*(\w+)", status)[1], 16) >> (signal.SIGHUP - 1) & 1
    process.send_signal(signal.SIGTERM)
    out, _ = process.communicate(timeout=20)
    assert (out, process.returncode) == ("in order\n", 0)


def test_ctrl_c_ends_in_order_and_raises_keyboard_interrupt():
    process = start(FOREVER)
    process.send_signal(signal.SIGINT)
    out, err = process.communicate(timeout=20)
    assert out == "in order\n"
    assert "KeyboardInterrupt" in err


def test_closed_parent_pipe_ends_a_child_that_ignores_signals():
    process = start(STUBBORN)
    process.stdin.close()
    assert process.wait(timeout=20) == 1
    process.stdout.close()
    process.stderr.close()


def test_closed_parent_pipe_ends_the_child_in_order():
    process = start(FOREVER.replace("run(main())", "end_with_parent()\nrun(main())"))
    process.stdin.close()
    process.stdin = None
    out, err = process.communicate(timeout=20)
    assert (out, err, process.returncode) == ("in order\n", "", 0)


def test_result_and_error_are_passed_on():
    code = WAIT + "async def main():\n    return 7\nprint(run(main()))"
    assert subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout == "7\n"
