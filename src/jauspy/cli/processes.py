"""Runs a verb until it ends or is stopped, and starts verbs as child processes."""

from __future__ import annotations

import asyncio
import os
import signal
import sys
import threading
import time
from collections import deque
from collections.abc import AsyncIterator, Callable, Coroutine, Iterator, Sequence
from contextlib import contextmanager, suppress
from pathlib import Path
from types import TracebackType
from typing import Any, Final, Self, TypeVar

from jauspy.errors import JausError

T = TypeVar("T")

START_TIMEOUT: Final = 30.0
"""Seconds; the physics engine is slowest to start."""
STOP_TIMEOUT: Final = 5.0
"""Seconds from SIGTERM to SIGKILL."""
PARENT_GRACE: Final = 4.0
"""Seconds in which a child ends after its parent died."""
REPEATED_SIGNAL_TIME: Final = 5.0
"""Seconds in which a second Ctrl-C is ignored, so that it does not interrupt the orderly end."""
MAX_KEPT_LINES: Final = 50
MAX_LINE: Final = 1 << 16
"""Bytes; a longer line is read as several."""


def run(main: Coroutine[Any, Any, T]) -> T | None:
    """Run `main`; Ctrl-C, SIGTERM and SIGHUP cancel it, so that its `async with` blocks are left in order.

    Returns None after SIGTERM and SIGHUP; Ctrl-C raises `KeyboardInterrupt`. SIGINT counts also if this process was
    started with SIGINT ignored, as by a script with `&`: a signal that is sent to it is meant for it. SIGHUP stays
    ignored when it was, as by nohup.
    """
    terminated = False
    if signal.getsignal(signal.SIGINT) is signal.SIG_IGN:
        signal.signal(signal.SIGINT, signal.default_int_handler)

    async def guarded() -> T:
        nonlocal terminated
        task = asyncio.ensure_future(main)

        def terminate() -> None:
            nonlocal terminated
            terminated = True
            task.cancel()

        for number in (signal.SIGTERM, *_hangup()):
            asyncio.get_running_loop().add_signal_handler(number, terminate)
        return await task

    try:
        return asyncio.run(guarded())
    except asyncio.CancelledError:
        if terminated:
            return None
        raise


def _hangup() -> list[signal.Signals]:
    """SIGHUP, unless this process was started with it ignored."""
    return [] if signal.getsignal(signal.SIGHUP) is signal.SIG_IGN else [signal.SIGHUP]


@contextmanager
def stoppable() -> Iterator[Callable[[], int]]:
    """Let Ctrl-C, SIGTERM and SIGHUP raise `KeyboardInterrupt`; yields a function that returns the exit status then.

    Signals that follow within `REPEATED_SIGNAL_TIME` are ignored. Without effect in other threads than the main one,
    which get no signals.
    """
    received: list[tuple[float, int]] = []

    def stop(number: int, frame: object) -> None:  # noqa: ARG001 - a signal handler
        now = time.monotonic()
        if not received or now - received[-1][0] > REPEATED_SIGNAL_TIME:
            received.append((now, number))
            raise KeyboardInterrupt

    numbers: tuple[int, ...] = (signal.SIGINT, signal.SIGTERM, *_hangup())
    if threading.current_thread() is not threading.main_thread():
        numbers = ()
    before = {number: signal.signal(number, stop) for number in numbers}
    try:
        yield lambda: 128 + (received[-1][1] if received else signal.SIGINT)
    finally:
        for signal_number, handler in before.items():
            signal.signal(signal_number, handler)


def end_with_parent() -> None:
    """Stop this process when its standard input closes: the kernel closes the parent's end however the parent dies."""
    threading.Thread(target=_wait_for_parent, name="parent-watch", daemon=True).start()


def _wait_for_parent() -> None:
    while os.read(sys.stdin.fileno(), 4096):
        pass
    os.kill(os.getpid(), signal.SIGTERM)
    threading.Event().wait(PARENT_GRACE)
    os._exit(1)


def remove_if_empty(root: Path) -> None:
    """Remove a directory of sockets if no other process uses it."""
    with suppress(OSError):
        root.rmdir()


class ChildFailed(JausError):
    """A child process did not start, or ended unexpectedly; the message contains its last lines of output."""


class ChildProcess:
    """`jauspy VERB ... --with-parent` as a child process: `async with` starts it, waits for its first line, stops it.

    The child watches its standard input, a pipe whose other end is held here, so it also ends when this process is
    killed. It has its own session: Ctrl-C reaches only the parent, which stops its children in order.
    """

    def __init__(
        self, name: str, arguments: Sequence[str], *, on_error_line: Callable[[str], None] | None = None
    ) -> None:
        """`on_error_line` gets each line of standard error once the child is ready; else `ChildFailed` has the last."""
        self.name = name
        self.first_line = ""
        """Output of the process when it was ready."""
        self._on_error_line = on_error_line
        self._arguments = tuple(arguments)
        self._process: asyncio.subprocess.Process | None = None
        self._readers: list[asyncio.Task[None]] = []
        self._lines: deque[str] = deque(maxlen=MAX_KEPT_LINES)
        self._ready = asyncio.Event()

    async def __aenter__(self) -> Self:
        self._process = await asyncio.create_subprocess_exec(
            sys.executable,
            "-P",  # nothing from the current directory, which may be a stranger's
            "-m",
            "jauspy.cli.main",
            *self._arguments,
            "--with-parent",
            stdin=asyncio.subprocess.PIPE,
            stdout=asyncio.subprocess.PIPE,
            stderr=asyncio.subprocess.PIPE,
            start_new_session=True,
            env={**os.environ, "PYTHONUNBUFFERED": "1"},
        )
        try:
            await self._wait_until_ready()
        except BaseException:
            await self.stop()
            raise
        return self

    async def __aexit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        await self.stop()

    @property
    def pid(self) -> int | None:
        """The process id; None before the start."""
        return None if self._process is None else self._process.pid

    async def ended(self) -> ChildFailed:
        """Wait until the child ends unexpectedly; returns the error to raise."""
        assert self._process is not None
        status = await self._process.wait()
        await asyncio.gather(*self._readers)
        how = f"ended by signal {-status}" if status < 0 else f"ended with exit status {status}"
        output = " ".join(self._lines).removeprefix("Error: ")
        if output and status < 0:
            how += f"; its output: {output}"
        return ChildFailed(f"{self.name}: {output if output and status > 0 else how}")

    def signal(self, number: signal.Signals) -> None:
        """Send the child a signal if it runs."""
        if self._process is not None and self._process.returncode is None:
            self._process.send_signal(number)

    async def stop(self) -> None:
        """End the child: SIGTERM, and SIGKILL after `STOP_TIMEOUT`. May be called again."""
        process = self._process
        if process is None:
            return
        if process.returncode is None:
            try:
                process.send_signal(signal.SIGTERM)
                async with asyncio.timeout(STOP_TIMEOUT):
                    await process.wait()
            except TimeoutError:
                process.kill()
                await process.wait()
            except ProcessLookupError:
                await process.wait()
        await asyncio.gather(*self._readers)

    async def _wait_until_ready(self) -> None:
        assert self._process is not None
        assert self._process.stdout is not None
        assert self._process.stderr is not None
        self._readers = [
            asyncio.create_task(self._read_output(self._process.stdout)),
            asyncio.create_task(self._read_errors(self._process.stderr)),
        ]
        ready = asyncio.create_task(self._ready.wait())
        ended = asyncio.create_task(self.ended())
        try:
            await asyncio.wait((ready, ended), timeout=START_TIMEOUT, return_when=asyncio.FIRST_COMPLETED)
            if self._ready.is_set():
                return
            if ended.done():
                raise ended.result()
            raise ChildFailed(f"{self.name} is not ready after {START_TIMEOUT:.0f} s")
        finally:
            ready.cancel()
            ended.cancel()

    async def _read_output(self, stream: asyncio.StreamReader) -> None:
        """Read standard output. Its first line means that the child is ready; the rest is discarded."""
        async for line in _lines(stream):
            if not self._ready.is_set():
                self.first_line = line
                self._ready.set()

    async def _read_errors(self, stream: asyncio.StreamReader) -> None:
        async for line in _lines(stream):
            if self._ready.is_set() and self._on_error_line is not None:
                self._on_error_line(line)
            else:
                self._lines.append(line)


async def _lines(stream: asyncio.StreamReader) -> AsyncIterator[str]:
    """Lines of any length, those above `MAX_LINE` in pieces; `StreamReader` itself raises for lines above 64 KiB."""
    rest = b""
    while data := await stream.read(MAX_LINE):
        *whole, rest = (rest + data).split(b"\n")
        if len(rest) > MAX_LINE:
            whole, rest = [*whole, rest], b""
        for line in whole:
            yield line.decode(errors="replace").rstrip()
    if rest:
        yield rest.decode(errors="replace").rstrip()
