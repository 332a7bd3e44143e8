"""An event loop in a thread of its own, for code that has none or must not block the one it has."""

from __future__ import annotations

import asyncio
import threading
from collections.abc import AsyncGenerator, AsyncIterable, AsyncIterator, Coroutine, Generator
from concurrent.futures import Future, wait
from contextlib import suppress
from types import TracebackType
from typing import Any, Final, Generic, Self, TypeVar, cast

from jauspy.errors import TransportError

T = TypeVar("T")

CLEANUP: Final = 10.0
"""Seconds that what was interrupted may take to tidy up: to leave a robot in Standby, to cancel an event."""


class Portal:
    """`portal.run(coroutine)` runs it in the thread and returns what it returns; any thread may call.

    Ctrl-C while it waits cancels the coroutine, waits for its clean-up, and is raised on. The thread is a daemon: it
    does not keep a program from ending.
    """

    def __init__(self, name: str = "jauspy") -> None:
        self._name = name
        self._lock = threading.Lock()
        self._loop: asyncio.AbstractEventLoop | None = None
        self._thread: threading.Thread | None = None

    @property
    def is_open(self) -> bool:
        """True between `open` and `close`; false in a process that was forked, which has the thread no more."""
        return self._loop is not None and self._thread is not None and self._thread.is_alive()

    def open(self) -> None:
        """Start the thread; twice is fine."""
        with self._lock:
            if not self.is_open:
                ready: Future[asyncio.AbstractEventLoop] = Future()
                self._thread = threading.Thread(target=_live, args=(ready,), name=self._name, daemon=True)
                self._thread.start()
                self._loop = ready.result()

    def close(self) -> None:
        """Cancel what still runs, wait for it, and end the thread; twice is fine."""
        with self._lock:
            loop, self._loop = self._loop, None
            if loop is not None:
                loop.call_soon_threadsafe(loop.stop)
        if loop is not None and self._thread is not None:
            self._thread.join()

    def run(self, coroutine: Coroutine[Any, Any, T]) -> T:
        """What the coroutine returns or raises; `TransportError` when the portal is closed, or closes meanwhile."""
        call: _Call[T] = _Call(coroutine)
        try:
            with self._lock:  # so that what is handed in before `close` is begun before the loop stops
                call.hand_to(self._usable())
            return call.ended.result()
        except asyncio.CancelledError:
            raise TransportError("this was closed while it waited") from None
        except BaseException:
            call.interrupt()
            raise

    def leave(self, coroutine: Coroutine[Any, Any, object]) -> None:
        """Run what ends a `with` block; fine when the portal was closed inside, which has ended it already."""
        with suppress(TransportError):
            self.run(coroutine)

    def iterate(self, iterable: AsyncIterable[T]) -> Generator[T, None, None]:
        """What `async for` would give; leaving the loop ends the asynchronous iterator, too."""
        iterator = aiter(iterable)
        try:
            while (item := self.run(_next(iterator))) is not _END:
                yield cast("T", item)
        finally:
            if isinstance(iterator, AsyncGenerator):
                self.leave(_end(iterator))

    def __enter__(self) -> Self:
        self.open()
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self.close()

    def _usable(self) -> asyncio.AbstractEventLoop:
        if self._loop is None or not self.is_open:
            raise TransportError("this is not open; use it inside `with`, and in the process that opened it")
        if threading.current_thread() is self._thread:
            raise TransportError("called from its own event loop, which would wait for itself; use `await` there")
        return self._loop


class _Call(Generic[T]):
    """One coroutine on its way through the thread; `ended` is done when its clean-up is, too."""

    def __init__(self, coroutine: Coroutine[Any, Any, T]) -> None:
        self.ended: Future[T] = Future()
        self._coroutine = coroutine
        self._loop: asyncio.AbstractEventLoop | None = None
        self._task: asyncio.Task[T] | None = None

    def hand_to(self, loop: asyncio.AbstractEventLoop) -> None:
        """Let it begin in the loop's thread."""
        self._loop = loop
        loop.call_soon_threadsafe(self._begin)

    def interrupt(self) -> None:
        """Cancel it unless it has ended, and wait until it has tidied up."""
        if self._loop is None:
            self._coroutine.close()
        elif not self.ended.done():
            self._loop.call_soon_threadsafe(self._cancel)
            wait({self.ended}, CLEANUP)

    def _begin(self) -> None:
        self._task = asyncio.create_task(self._coroutine)
        self._task.add_done_callback(self._done)

    def _cancel(self) -> None:
        if self._task is not None:
            self._task.cancel()
        else:  # interrupted on the way here: it was never begun
            self._coroutine.close()
            self.ended.set_exception(asyncio.CancelledError())

    def _done(self, task: asyncio.Task[T]) -> None:
        error = asyncio.CancelledError() if task.cancelled() else task.exception()
        if error is not None:
            self.ended.set_exception(error)
        else:
            self.ended.set_result(task.result())


_END: Final = object()


async def _next(iterator: AsyncIterator[T]) -> T | object:
    return await anext(iterator, _END)


async def _end(iterator: AsyncGenerator[Any, None]) -> None:
    await iterator.aclose()


def _live(ready: Future[asyncio.AbstractEventLoop]) -> None:
    with asyncio.Runner() as runner:  # on leaving it cancels what still runs, and waits for it
        loop = runner.get_loop()
        asyncio.set_event_loop(loop)
        ready.set_result(loop)
        loop.run_forever()
