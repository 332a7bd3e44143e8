"""Worker processes must not delay their parent, and end with it."""

from __future__ import annotations

import asyncio
import json
import os
import signal
import subprocess
import sys
from pathlib import Path

import pytest

from jauspy import worker_process
from jauspy.worker_process import WorkerProcess

PROGRAM = """
import json, os
from jauspy.worker_process import lower_priority
lower_priority(7)
print(json.dumps([os.nice(0), sorted(os.sched_getaffinity(0))]))
"""


def lowered(processors: set[int]) -> tuple[int, set[int]]:
    """The niceness that a process added, and the processors that it kept of these."""
    ours = os.sched_getaffinity(0)
    os.sched_setaffinity(0, processors)
    try:
        out = subprocess.run([sys.executable, "-c", PROGRAM], check=True, stdout=subprocess.PIPE).stdout
    finally:
        os.sched_setaffinity(0, ours)
    nice, kept = json.loads(out)
    return nice - os.nice(0), set(kept)


def test_the_first_processor_is_left_to_the_parent() -> None:
    processors = os.sched_getaffinity(0)
    if len(processors) < 2:
        pytest.skip("one processor only")
    assert lowered(processors) == (7, processors - {min(processors)})


def test_a_single_processor_is_shared() -> None:
    processors = {min(os.sched_getaffinity(0))}
    assert lowered(processors) == (7, processors)


async def test_a_worker_that_does_not_end_is_killed_in_a_cancelled_task(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(worker_process, "STOP_TIMEOUT", 0.1)
    monkeypatch.setenv(
        "PYTHONPATH", str(Path(__file__).parents[1])
    )  # workers import nothing from the current directory
    process = await WorkerProcess.start("tests.helpers.stubborn_worker", 0, ())
    process.send("begin")
    messages = process.messages()
    assert await anext(messages) == "began"

    async def until_cancelled() -> None:
        try:
            await asyncio.Event().wait()
        finally:
            await process.stop()

    task = asyncio.create_task(until_cancelled())
    await asyncio.sleep(0)
    task.cancel()
    with pytest.raises(asyncio.CancelledError):
        await task
    assert await process.wait() == -signal.SIGKILL
    await messages.aclose()
