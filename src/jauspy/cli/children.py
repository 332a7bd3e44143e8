"""Verbs in processes of their own, which never outlive the one that started them."""

from __future__ import annotations

import asyncio
import os
import signal
import sys
from collections import deque
from collections.abc import AsyncIterator, Callable, Sequence
from types import TracebackType
from typing import Final, Self

from jauspy.errors import JausError

START_TIMEOUT: Final = 30.0  # seconds; a cold start of the physics is the slowest
STOP_TIMEOUT: Final = 5.0
_KEPT_LINES: Final = 50
_LONGEST_LINE: Final = 1 << 16  # bytes; the rest of a longer line is another one


class ChildFailed(JausError):
    """A part that runs in its own process did not start, or ended by itself; says what it said last."""


class Child:
    """`jauspy VERB ... --with-parent` as a child process: `async with` starts it, waits for its first line, stops it.

    The child watches its standard input, a pipe whose only other end is here; so it also ends when this process is
    killed. It gets its own session: Ctrl-C reaches only the parent, which stops its children in order.
    """

    def __init__(self, name: str, arguments: Sequence[str], *, heard: Callable[[str], None] | None = None) -> None:
        """`heard` gets what it says on standard error once it is ready; without it, the error at its end tells."""
        self.name = name
        self._heard = heard
        self._arguments = tuple(arguments)
        self._process: asyncio.subprocess.Process | None = None
        self._readers: list[asyncio.Task[None]] = []
        self._lines: deque[str] = deque(maxlen=_KEPT_LINES)
        self._ready = asyncio.Event()

    async def __aenter__(self) -> Self:
        self._process = await asyncio.create_subprocess_exec(
            sys.executable,
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
        """Wait until the child ends by itself; returns the error that tells why."""
        assert self._process is not None
        status = await self._process.wait()
        await asyncio.gather(*self._readers)
        how = f"ended by signal {-status}" if status < 0 else f"ended with exit status {status}"
        said = " ".join(self._lines).removeprefix("Error: ")
        if said and status < 0:
            how += f"; it said: {said}"
        return ChildFailed(f"{self.name}: {said if said and status > 0 else how}")

    def signal(self, number: signal.Signals) -> None:
        """Send it a signal, if it runs."""
        if self._process is not None and self._process.returncode is None:
            self._process.send_signal(number)

    async def stop(self) -> None:
        """Ask the child to end; make it end if it does not within `STOP_TIMEOUT`. Twice is fine."""
        process = self._process
        if process is None:
            return
        if process.returncode is None:
            try:
                process.send_signal(signal.SIGTERM)
                await asyncio.wait_for(process.wait(), STOP_TIMEOUT)
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
            asyncio.create_task(self._await_first_line(self._process.stdout)),
            asyncio.create_task(self._listen(self._process.stderr)),
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

    async def _await_first_line(self, stream: asyncio.StreamReader) -> None:
        """What it says first on standard output says that it is ready; the rest is for people who start it alone."""
        async for _ in _lines(stream):
            self._ready.set()

    async def _listen(self, stream: asyncio.StreamReader) -> None:
        async for line in _lines(stream):
            if self._ready.is_set() and self._heard is not None:
                self._heard(line)
            else:
                self._lines.append(line)


async def _lines(stream: asyncio.StreamReader) -> AsyncIterator[str]:
    """Lines of any length, the longest in pieces; the stream's own iteration ends with an error at 64 KiB."""
    rest = b""
    while data := await stream.read(_LONGEST_LINE):
        *whole, rest = (rest + data).split(b"\n")
        if len(rest) > _LONGEST_LINE:
            whole, rest = [*whole, rest], b""
        for line in whole:
            yield line.decode(errors="replace").rstrip()
    if rest:
        yield rest.decode(errors="replace").rstrip()
