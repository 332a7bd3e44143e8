"""Verbs in processes of their own, which never outlive the one that started them."""

from __future__ import annotations

import asyncio
import os
import signal
import sys
from collections import deque
from collections.abc import Sequence
from types import TracebackType
from typing import Final, Self

from jauspy.errors import JausError

START_TIMEOUT: Final = 30.0  # seconds; a cold start of the physics is the slowest
STOP_TIMEOUT: Final = 5.0
_KEPT_LINES: Final = 50


class ChildFailed(JausError):
    """A part that runs in its own process did not start, or ended by itself; says what it said last."""


class Child:
    """`jauspy VERB ... --with-parent` as a child process: `async with` starts it, waits for its first line, stops it.

    The child watches its standard input, a pipe whose only other end is here; so it also ends when this process is
    killed. It gets its own session: Ctrl-C reaches only the parent, which stops its children in order.
    """

    def __init__(self, name: str, arguments: Sequence[str]) -> None:
        self.name = name
        self.first_line = ""
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
        said = " ".join(self._lines).removeprefix("Error: ") or f"it said nothing, exit status {status}"
        return ChildFailed(f"{self.name}: {said}")

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
            asyncio.create_task(self._read(self._process.stdout, says_ready=True)),
            asyncio.create_task(self._read(self._process.stderr, says_ready=False)),
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

    async def _read(self, stream: asyncio.StreamReader, *, says_ready: bool) -> None:
        async for raw in stream:
            line = raw.decode(errors="replace").rstrip()
            self._lines.append(line)
            if says_ready and not self._ready.is_set():
                self.first_line = line
                self._ready.set()
