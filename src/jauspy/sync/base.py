"""Base classes of the generated classes: an asynchronous object, and the portal to its event loop."""

from __future__ import annotations

import atexit
import signal
from contextlib import ExitStack
from types import TracebackType
from typing import TYPE_CHECKING, Generic, NoReturn, Self, TypeVar

from jauspy.ocu.client import OCU, leave, orderly
from jauspy.sync.portal import Portal

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
