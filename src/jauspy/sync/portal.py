"""An event loop in its own thread, for code without an event loop, or that must not block its event loop.

The base classes of the generated classes have an asynchronous object, and the portal to its event loop.
"""

from __future__ import annotations

import asyncio
import atexit
import signal
import threading
import time
from collections.abc import AsyncGenerator, AsyncIterable, AsyncIterator, Coroutine, Generator
from concurrent.futures import Future, wait
from contextlib import ExitStack, suppress
from inspect import CORO_CREATED, getcoroutinestate
from types import TracebackType
from typing import TYPE_CHECKING, Any, Final, Generic, NoReturn, Self, TypeVar, cast

from jauspy.errors import TransportError
from jauspy.ocu.client import OCU, leave, orderly

T = TypeVar("T")

CLEANUP_TIMEOUT: Final = 10.0
"""Seconds for the clean-up of an interrupted call, such as sending Standby or cancelling an event."""


class Portal:
    """`portal.run(coroutine)` runs a coroutine in the thread and returns its result; any thread may call this.

    Ctrl-C meanwhile cancels the coroutine, waits for its clean-up, and then raises `KeyboardInterrupt`. The thread is
    a daemon: it does not keep a program from ending.
    """

    def __init__(self, name: str = "jauspy") -> None:
        self._name = name
        self._lock = threading.Lock()
        self._loop: asyncio.AbstractEventLoop | None = None
        self._thread: threading.Thread | None = None
        self._counting = threading.Lock()
        self._calls = 0
        self._last_call = time.monotonic()

    def idle(self) -> float:
        """Seconds since a call ended; zero during a call."""
        return 0.0 if self._calls else time.monotonic() - self._last_call

    @property
    def is_open(self) -> bool:
        """True between `open` and `close`; false in a forked process, which does not have the thread."""
        return self._loop is not None and self._thread is not None and self._thread.is_alive()

    def open(self) -> None:
        """Start the thread; without effect when open."""
        with self._lock:
            if not self.is_open:
                ready: Future[asyncio.AbstractEventLoop] = Future()
                self._thread = threading.Thread(target=_run_loop, args=(ready,), name=self._name, daemon=True)
                self._thread.start()
                self._loop = ready.result()

    def close(self) -> None:
        """Cancel running coroutines, wait for them, and end the thread; without effect when closed."""
        with self._lock:
            loop, self._loop = self._loop, None
            if loop is not None:
                loop.call_soon_threadsafe(loop.stop)
        if loop is not None and self._thread is not None:
            self._thread.join()

    def run(self, coroutine: Coroutine[Any, Any, T]) -> T:
        """The result of the coroutine; raises its errors, and `TransportError` when the portal is closed."""
        call: _Call[T] = _Call(coroutine)
        self._count(+1)
        try:
            with self._lock:  # so that a call made before `close` starts before the loop stops
                call.schedule(self._usable())
            return call.ended.result()
        except asyncio.CancelledError:
            raise TransportError("the portal was closed during this call") from None
        except BaseException:
            call.interrupt()
            raise
        finally:
            self._count(-1)

    def _count(self, change: int) -> None:
        with self._counting:
            self._calls += change
            self._last_call = time.monotonic()

    def leave(self, coroutine: Coroutine[Any, Any, object]) -> None:
        """Run the end of a `with` block; without effect when the portal was closed inside, which has ended it."""
        with suppress(TransportError):
            self.run(coroutine)

    def iterate(self, iterable: AsyncIterable[T]) -> Generator[T, None, None]:
        """The items of an asynchronous iterable; leaving the loop closes the asynchronous iterator."""
        iterator = aiter(iterable)
        try:
            while (item := self._run_next(iterator)) is not _END:
                yield cast("T", item)
        finally:
            if isinstance(iterator, AsyncGenerator):
                self.leave(_end(iterator))

    def _run_next(self, iterator: AsyncIterator[T]) -> T | object:
        """The next item. A loop spends its time here, so that Ctrl-C may arrive just before `run` begins."""
        coroutine = _next(iterator)
        try:
            return self.run(coroutine)
        except BaseException:
            if getcoroutinestate(coroutine) == CORO_CREATED:
                coroutine.close()
            raise

    def __enter__(self) -> Self:
        self.open()
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self.close()

    def _usable(self) -> asyncio.AbstractEventLoop:
        if self._loop is None or not self.is_open:
            raise TransportError("it is not open; use it inside `with`, and in the process that opened it")
        if threading.current_thread() is self._thread:
            raise TransportError("called from its own event loop, which would wait for itself; use `await` there")
        return self._loop


class _Call(Generic[T]):
    """One coroutine that runs in the thread; `ended` is done after its clean-up."""

    def __init__(self, coroutine: Coroutine[Any, Any, T]) -> None:
        self.ended: Future[T] = Future()
        self._coroutine = coroutine
        self._loop: asyncio.AbstractEventLoop | None = None
        self._task: asyncio.Task[T] | None = None

    def schedule(self, loop: asyncio.AbstractEventLoop) -> None:
        """Start it in the loop's thread."""
        self._loop = loop
        loop.call_soon_threadsafe(self._start)

    def interrupt(self) -> None:
        """Cancel it unless it has ended, and wait for its clean-up."""
        if self._loop is None:
            self._coroutine.close()
        elif not self.ended.done():
            self._loop.call_soon_threadsafe(self._cancel)
            wait({self.ended}, CLEANUP_TIMEOUT)

    def _start(self) -> None:
        self._task = asyncio.create_task(self._coroutine)
        self._task.add_done_callback(self._done)

    def _cancel(self) -> None:
        if self._task is not None:
            self._task.cancel()
        else:  # interrupted before it was started
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


def _run_loop(ready: Future[asyncio.AbstractEventLoop]) -> None:
    with asyncio.Runner() as runner:  # on exit it cancels running tasks and waits for them
        loop = runner.get_loop()
        asyncio.set_event_loop(loop)
        ready.set_result(loop)
        loop.run_forever()


A = TypeVar("A")


class Facade(Generic[A]):
    """Calls the methods of `asynchronous` in the event loop of the portal."""

    def __init__(self, portal: Portal, asynchronous: A) -> None:
        self._portal = portal
        self._async = asynchronous

    def __repr__(self) -> str:
        return repr(self._async)

    if not TYPE_CHECKING:

        def __aenter__(self) -> NoReturn:
            raise TypeError(f"use `with` for this {type(self).__name__}; `async with` is for what jauspy.OCU gives")

        __aexit__ = __aenter__


class OpensPortal(Facade[OCU]):
    """The OCU, whose portal is open while it is; it is closed at the end of the program."""

    def open(self) -> None:
        """Connect; without effect when open. Raises `TransportError`, and `ConfigError` for an invalid `connect`.

        While it is open, SIGTERM and SIGHUP end the program as `sys.exit` does, unless the program handles them.
        """
        if self._portal.is_open:
            return
        self._portal.open()
        self._async.watch_program(self._portal.idle)
        try:
            self._portal.run(self._async.open())
        except BaseException:
            self._portal.close()
            raise
        atexit.register(self.close)
        self._signals = ExitStack()
        self._signals.enter_context(orderly(_on_signal, _as_before))

    def close(self) -> None:
        """Put controlled components in Standby, release them, cancel events, disconnect; without effect when closed."""
        atexit.unregister(self.close)
        if self._portal.is_open:
            try:
                self._portal.run(self._async.close())
            finally:
                self._portal.close()
                self._signals.close()

    def __enter__(self) -> Self:
        self.open()
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self.close()


def _on_signal(number: int) -> None:
    signal.signal(number, leave)


def _as_before(number: int) -> None:
    signal.signal(number, signal.SIG_DFL)
