"""What a generated method has in hand: its local variables, and where in the bytes it stands."""

from __future__ import annotations

from jauspy.codec.names import unique


class Locals:
    """Names of local variables, each given once; they end in an underscore."""

    def __init__(self) -> None:
        self._taken: set[str] = set()

    def name(self, hint: str) -> str:
        """A new name that looks like `hint`."""
        found = unique(hint, self._taken.__contains__)
        self._taken.add(found)
        return f"{found}_"


class Position:
    """A variable and a number of bytes after it that is known when the code is generated."""

    def __init__(self, base: str, offset: int) -> None:
        self._base = base
        self._offset = offset

    def here(self, more: int = 0) -> str:
        """The position as an expression, or that of `more` bytes later."""
        offset = self._offset + more
        if not self._base:
            return str(offset)
        return f"{self._base} + {offset}" if offset else self._base

    def parenthesized(self) -> str:
        """The same, safe to stand after a minus sign."""
        return f"({self.here()})" if self._base and self._offset else self.here()

    def skip(self, size: int) -> None:
        """Go on by a known number of bytes."""
        self._offset += size

    def move(self, base: str) -> None:
        """Go on to where a variable says."""
        self._base, self._offset = base, 0

    def settled(self) -> None:
        """The variable `at` has the position now."""
        self.move("at")

    def settle(self) -> list[str]:
        """Lines that bring the position into the variable `at`, as loops, branches and calls need it."""
        here, moved = self.here(), self._base != "at"
        lines = [f"at = {here}"] if moved else [f"at += {self._offset}"] if self._offset else []
        self.settled()
        return lines
