"""What is known of messages without importing them, and which ids mean several things."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from importlib import import_module
from typing import Any, Final

from jauspy.codec.base import Message
from jauspy.codec.shape import same_layout
from jauspy.ids import is_called

STANDARD: Final = "urn:jaus:jss:"
"""How the URNs of published service sets begin."""


@dataclass(frozen=True, slots=True)
class Entry:
    """One message of one service version, and the module and class it lives in."""

    code: int
    name: str
    service: str
    version: str
    module: str
    cls: str

    def load(self) -> type[Message]:
        """The message class."""
        found = getattr(import_module(self.module), self.cls)
        assert isinstance(found, type)
        assert issubclass(found, Message)
        return found

    @property
    def edition(self) -> str:
        """What gets its versions as a whole: a set of the standard, of anybody else each service."""
        return self.service.rpartition(":")[0] if self.service.startswith(STANDARD) else self.service

    @property
    def order(self) -> tuple[int, ...]:
        """Orders versions, oldest first."""
        return tuple(int(part) for part in self.version.split(".") if part.isdigit())


def entries(module: str, service: str, version: str, *messages: tuple[Any, ...]) -> Iterator[Entry]:
    """The entries of one module: for each message its code and name, and its class where that has another name."""
    for code, name, *cls in messages:
        yield Entry(code, name, service, version, module, cls[0] if cls else name)


@dataclass(frozen=True, slots=True)
class Hints:
    """What narrows a search: the end of a service's URN, a version, a message's name; case does not matter."""

    service: str | None = None
    version: str | None = None
    message: str | None = None

    def fit(self, entry: Entry) -> bool:
        """True when the entry is one of those that are meant."""
        return (
            (self.service is None or is_called(entry.service, self.service))
            and self.version in (None, entry.version)
            and (self.message is None or self.message.casefold() == entry.name.casefold())
        )

    def __str__(self) -> str:
        service = f"of {self.service}" if self.service else ""
        return " ".join(part for part in (self.message, service, self.version) if part)


NO_HINTS = Hints()


@dataclass(frozen=True, slots=True)
class Collision:
    """A message id that means different things; `remedy` is what tells them apart."""

    code: int
    entries: tuple[Entry, ...]
    """One for each meaning."""
    files: tuple[str, ...]
    """Where those are defined, in the same order."""

    def __str__(self) -> str:
        meanings = (
            f"{entry.name} of {entry.service} {entry.version} ({file})"
            for entry, file in zip(self.entries, self.files, strict=True)
        )
        return f"message id 0x{self.code:04X} is {' and '.join(meanings)}"

    @property
    def remedy(self) -> str:
        """What `decode` has to be told: the service, or the message where one service gives one id to several."""
        services = {(entry.service, entry.version) for entry in self.entries}
        return "service" if len(services) == len(self.entries) else "message"


def meanings(entries: Iterable[Entry]) -> tuple[Entry, ...]:
    """The first entry of each name and layout."""
    names: dict[str, list[Entry]] = {}
    for entry in entries:
        same_name = names.setdefault(entry.name, [])
        if not any(same_layout(other.load().layout(), entry.load().layout()) for other in same_name):
            same_name.append(entry)
    return tuple(entry for same_name in names.values() for entry in same_name)
