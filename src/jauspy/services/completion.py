"""How a command that takes time ended: told once, by the service that carries it out."""

from __future__ import annotations

from collections.abc import Callable


class CommandCompletion:
    """Call it when the command has ended."""

    __slots__ = ("_tell", "claimed")

    def __init__(self, tell: Callable[[bool], None] | None = None) -> None:
        self._tell = tell
        self.claimed = False
        """True once a service said that its command takes time."""

    def __call__(self, success: bool) -> None:
        """True: it was carried out, False: it was given up. Later calls do nothing."""
        tell, self._tell = self._tell, None
        if tell is not None:
            tell(success)
