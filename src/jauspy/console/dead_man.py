"""The dead-man's switch of motions that a browser repeats: driving, and jogging of an arm."""

from __future__ import annotations

import asyncio
from collections.abc import Callable
from typing import Final

DEAD_MAN_TIME: Final = 0.2
"""Seconds without a message of the operator's browser after which its motion is stopped."""
LATE: Final = 0.05
"""Seconds by which the event loop of the console is late before its own silence is not the browser's."""
GRACE: Final = 0.1
"""Seconds in which a console that was late reads what the browser has sent meanwhile."""
MAX_GRACES: Final = 3
"""How often this time is given before a stop: a console on a loaded machine may be late again within it."""


class DeadMan:
    """Calls `stop` when a motion has not been repeated for `DEAD_MAN_TIME`.

    When this process did not run, as on a loaded machine, messages of the browser wait in its socket. They are read
    first; a browser that is really silent is stopped `GRACE` later, or at most `MAX_GRACES` times this.
    """

    def __init__(self, stop: Callable[[], None]) -> None:
        self._stop = stop
        self._timer: asyncio.TimerHandle | None = None
        self._graces = 0

    def repeat(self) -> None:
        """Handle a message of the browser that keeps the motion alive."""
        self._graces = 0
        self._wait(DEAD_MAN_TIME)

    def end(self) -> None:
        """Wait for no more messages: the motion has ended."""
        if self._timer is not None:
            self._timer.cancel()
            self._timer = None

    def _wait(self, seconds: float) -> None:
        self.end()
        self._timer = asyncio.get_running_loop().call_later(seconds, self._is_due)

    def _is_due(self) -> None:
        assert self._timer is not None
        late = asyncio.get_running_loop().time() - self._timer.when()
        if late > LATE and self._graces < MAX_GRACES:
            self._graces += 1
            self._wait(GRACE)
        else:
            self._timer = None
            self._stop()
