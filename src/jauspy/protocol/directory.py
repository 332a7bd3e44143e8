"""The components of this machine: which id listens on which socket."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Final

from jauspy.protocol import addressing

MAX_COMPONENTS: Final = 1024


class Directory:
    """Ids (32-bit numbers) and the socket paths they were last heard from."""

    def __init__(self) -> None:
        self._paths: dict[int, str] = {}

    def __len__(self) -> int:
        return len(self._paths)

    def __contains__(self, id: int) -> bool:
        return id in self._paths

    def __iter__(self) -> Iterator[tuple[int, str]]:
        return iter(list(self._paths.items()))

    def path(self, id: int) -> str | None:
        """The socket of exactly this id."""
        return self._paths.get(id)

    def register(self, id: int, path: str) -> bool:
        """Note that `id` listens on `path`, the last one to say so wins; False when there is no room or no id."""
        if id == 0 or (id not in self._paths and len(self._paths) >= MAX_COMPONENTS):
            return False
        self._paths[id] = path
        return True

    def remove(self, id: int) -> None:
        """Forget a component."""
        self._paths.pop(id, None)

    def remove_path(self, path: str) -> list[int]:
        """Forget all that listen on this socket; returns their ids."""
        gone = [id for id, own in self._paths.items() if own == path]
        for id in gone:
            del self._paths[id]
        return gone

    def reached_by(self, destination: int, *, besides: int | None = None) -> list[str]:
        """The sockets of all components that a broadcast addresses, except the one it comes from."""
        return [path for id, path in self._paths.items() if id != besides and addressing.reaches(destination, id)]
