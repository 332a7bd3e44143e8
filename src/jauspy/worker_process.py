"""Worker processes: the parent's side starts them, sends commands, and restarts them when they die.

`Parent` is the worker's side.

`SupervisedWorker` is the side of the parent. `python -m jauspy.worker_process MODULE NICENESS` is the worker: it calls
`MODULE.run(first message, Parent)`. Messages are pickled objects with their length before them, on standard input and
standard output. A worker ends when its standard input does, and so with its parent, however that ends.
"""

from __future__ import annotations

import asyncio
import logging
import os
import pickle
import select
import sys
from abc import ABC, abstractmethod
from collections import Counter
from collections.abc import AsyncIterator, Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass
from importlib import import_module
from types import TracebackType
from typing import Final, Self

RESTART_DELAYS: Final = (0.5, 10.0)
"""Seconds before a worker that died is restarted: at first, and at most; doubled each time."""
STABLE_TIME: Final = 30.0
"""Seconds that a worker must have run for the delay to be short again."""
STOP_TIMEOUT: Final = 5.0
"""Seconds that a worker may take to end before it is killed."""
MAX_UNREAD: Final = 1 << 22
"""Bytes that a worker may leave unread, besides the largest message, until it counts as hung."""
_LENGTH: Final = 4
"""Bytes of the length before a message."""
_READ_SIZE: Final = 1 << 16


@dataclass(frozen=True, slots=True)
class WorkerReady:
    """The worker has opened its camera: how it makes images, and whether these are worse than on other machines."""

    description: str
    reduced: bool = False


@dataclass(frozen=True, slots=True)
class CountersReport:
    """The counters of the worker."""

    counters: Mapping[str, int]


def _encoded(message: object) -> bytes:
    body = pickle.dumps(message)
    return len(body).to_bytes(_LENGTH, "big") + body


def _decoded(body: bytes) -> object:
    return pickle.loads(body)  # noqa: S301 # nosec B301 # both ends of the pipe are ours


# --- in the parent ----------------------------------------------------------------------------------------------------


class WorkerProcess:
    """One worker, from its start to its end."""

    def __init__(self, process: asyncio.subprocess.Process) -> None:
        assert process.stdin is not None
        assert process.stdout is not None
        self._process, self._input, self._output = process, process.stdin, process.stdout
        self._largest = 0
        """Bytes of the largest message; that with which a camera starts may have the whole model of its world."""

    @classmethod
    async def start(cls, module: str, niceness: int, descriptors: Sequence[int]) -> Self:
        """Start a worker that inherits these files; it waits for its first message."""
        process = await asyncio.create_subprocess_exec(
            sys.executable,
            "-P",  # nothing from the current directory, which may be a stranger's
            "-m",
            "jauspy.worker_process",
            module,
            str(niceness),
            stdin=asyncio.subprocess.PIPE,
            stdout=asyncio.subprocess.PIPE,
            pass_fds=descriptors,
            process_group=0,  # no Ctrl-C; a session of its own would have its own share of the processor
            env={**os.environ, "PYTHONUNBUFFERED": "1"},
        )
        return cls(process)

    @property
    def pid(self) -> int:
        """The process id."""
        return self._process.pid

    def send(self, message: object) -> bool:
        """Send a message; false when the worker has left too much unread, so that it counts as hung."""
        if self._input.is_closing():
            return True
        encoded = _encoded(message)
        self._largest = max(self._largest, len(encoded))
        self._input.write(encoded)
        return self._input.transport.get_write_buffer_size() <= MAX_UNREAD + self._largest

    async def messages(self) -> AsyncIterator[object]:
        """The messages of the worker, until it has ended."""
        with suppress(asyncio.IncompleteReadError):
            while True:
                length = int.from_bytes(await self._output.readexactly(_LENGTH), "big")
                yield _decoded(await self._output.readexactly(length))

    async def wait(self) -> int:
        """Wait for its end; returns the exit status, negative for a signal."""
        return await self._process.wait()

    def kill(self) -> None:
        """Kill it; without effect when it has ended."""
        with suppress(ProcessLookupError):
            self._process.kill()

    async def stop(self) -> None:
        """Close its standard input and wait for its end; kill it after `STOP_TIMEOUT`."""
        self._input.close()
        ended = asyncio.ensure_future(self._process.communicate())
        try:  # without `asyncio.timeout`, which in a cancelled task raises CancelledError until Python 3.11.2
            await asyncio.wait([ended], timeout=STOP_TIMEOUT)
        finally:
            if not ended.done():
                self.kill()
        await ended


class SupervisedWorker(ABC):
    """Runs one worker after the other until `close`. Counters: those of the workers, `started` and `hung` ones."""

    def __init__(self, module: str, niceness: int, name: str, logger: logging.Logger) -> None:
        self._module, self._niceness, self._name, self._logger = module, niceness, name, logger
        self._own: Counter[str] = Counter()
        self._reported: Counter[str] = Counter()
        self._ended: Counter[str] = Counter()
        self._process: WorkerProcess | None = None
        self._task: asyncio.Task[None] | None = None
        self.description = ""
        """How the worker makes its images; empty before it is ready."""

    @property
    def pid(self) -> int | None:
        """The process id of the running worker; None between two."""
        return None if self._process is None else self._process.pid

    @property
    def counters(self) -> Mapping[str, int]:
        """Counters of all workers so far."""
        return self._own + self._ended + self._reported

    async def close(self) -> None:
        """Stop the worker; without effect when closed."""
        task, self._task = self._task, None
        if task is not None:
            task.cancel()
            with suppress(asyncio.CancelledError):
                await task

    async def __aenter__(self) -> Self:
        await self.open()
        return self

    async def __aexit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        await self.close()

    @abstractmethod
    async def open(self) -> None:
        """Allow workers, which start now or when they are first needed; without effect when open."""

    @property
    @abstractmethod
    def _descriptors(self) -> Sequence[int]:
        """The files that a worker inherits."""

    @abstractmethod
    def _on_started(self) -> None:
        """Send the first messages."""

    def _on_message(self, message: object) -> None:
        """Take a message of the worker."""
        match message:
            case WorkerReady(description, reduced):
                if description != self.description:
                    level = logging.WARNING if reduced else logging.INFO
                    self._logger.log(level, "%s: %s", self._name, description)
                self.description = description
            case CountersReport(counters):
                self._reported = Counter(counters)

    def _on_ended(self) -> None:  # noqa: B027 - most have nothing to do
        """Called when a worker has ended."""

    def _send(self, message: object) -> None:
        """Send a message to the running worker, if there is one; kill it when it counts as hung."""
        if self._process is not None and not self._process.send(message):
            self._kill(self._process)

    def _kill(self, process: WorkerProcess) -> None:
        self._own["hung"] += 1
        process.kill()

    def _supervise(self) -> None:
        """Start the first worker; without effect when it has been started."""
        if self._task is None:
            self._task = asyncio.get_running_loop().create_task(self._run(), name=self._name)

    async def _run(self) -> None:
        delay, longest = RESTART_DELAYS
        loop = asyncio.get_running_loop()
        while True:
            started_at = loop.time()
            status = await self._run_once()
            delay = RESTART_DELAYS[0] if loop.time() - started_at > STABLE_TIME else delay
            self._logger.warning("%s: its process ended (%s); it starts again in %.1f s", self._name, status, delay)
            await asyncio.sleep(delay)
            delay = min(longest, 2.0 * delay)

    async def _run_once(self) -> int:
        """One worker from its start to its end; returns its exit status."""
        process = self._process = await WorkerProcess.start(self._module, self._niceness, self._descriptors)
        self._own["started"] += 1
        try:
            self._on_started()
            async for message in process.messages():
                self._on_message(message)
            return await process.wait()
        finally:
            self._process = None
            self._ended += self._reported
            self._reported = Counter()
            self._on_ended()
            await process.stop()


# --- in the worker ----------------------------------------------------------------------------------------------------


class Parent:
    """The connection of a worker to its parent; `ended` is true when the parent has closed it."""

    def __init__(self) -> None:
        self._input = sys.stdin.fileno()
        self._output = os.dup(sys.stdout.fileno())
        os.dup2(sys.stderr.fileno(), sys.stdout.fileno())  # what libraries print goes to standard error
        self._buffer = bytearray()
        self.ended = False

    def send(self, message: object) -> None:
        """Send a message; raises `BrokenPipeError` when the parent has ended."""
        rest = _encoded(message)
        while rest:
            rest = rest[os.write(self._output, rest) :]

    def receive(self, timeout: float | None) -> Iterator[object]:
        """The messages that have arrived, or arrive within `timeout` seconds; None waits without limit."""
        limit = 0.0 if self._message_end() else timeout
        if not self.ended and select.select([self._input], [], [], limit)[0]:
            data = os.read(self._input, _READ_SIZE)
            self.ended = not data
            self._buffer += data
        while end := self._message_end():
            body = bytes(self._buffer[_LENGTH:end])
            del self._buffer[:end]
            yield _decoded(body)

    def _message_end(self) -> int:
        """Where the first message ends in the buffer; 0 while it is incomplete."""
        end = _LENGTH + int.from_bytes(self._buffer[:_LENGTH], "big")
        return end if _LENGTH < end <= len(self._buffer) else 0


def lower_priority(niceness: int) -> None:
    """Add `niceness` to this process, and leave the first processor to others if there is another one.

    Niceness determines shares of processor time, not latency: a process that wakes up may wait 4 ms until a nicer one
    is interrupted.
    """
    os.nice(niceness)
    processors = sorted(os.sched_getaffinity(0))
    os.sched_setaffinity(0, processors[1:] or processors)


def main(module: str, niceness: str) -> None:
    """Wait for the first message, then run the worker until it returns."""
    parent = Parent()
    lower_priority(int(niceness))
    first: object = None
    while first is None and not parent.ended:
        first = next(parent.receive(None), None)
    if first is not None:
        with suppress(BrokenPipeError):  # the parent has ended
            import_module(module).run(first, parent)


if __name__ == "__main__":
    main(*sys.argv[1:])
