"""What the generated classes have in common: an asynchronous object, and the portal to where it lives."""

from __future__ import annotations

import atexit
from types import TracebackType
from typing import TYPE_CHECKING, Generic, NoReturn, Self, TypeVar

from jauspy.ocu.client import OCU
from jauspy.sync.portal import Portal

A = TypeVar("A")


class Facade(Generic[A]):
    """`asynchronous` does the work, in the event loop of the portal's thread."""

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
    """The OCU: its portal is open while it is. A program or notebook that ends closes it, too."""

    def open(self) -> None:
        """Connect; raises `TransportError` that says what to do, `ConfigError` for a wrong `connect`. Twice is fine."""
        self._portal.open()
        try:
            self._portal.run(self._async.open())
        except BaseException:
            self._portal.close()
            raise
        atexit.register(self.close)

    def close(self) -> None:
        """Give back what is controlled, in Standby, disconnect, and end what still waits. Twice is fine."""
        atexit.unregister(self.close)
        if self._portal.is_open:
            try:
                self._portal.run(self._async.close())
            finally:
                self._portal.close()

    def __enter__(self) -> Self:
        self.open()
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self.close()
