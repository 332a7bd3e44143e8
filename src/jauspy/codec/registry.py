"""Finding message classes by name and by code; modules are imported when a message of theirs is first used."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from difflib import get_close_matches
from functools import cached_property
from importlib import import_module
from typing import TYPE_CHECKING, Any, Literal, overload

from jauspy.codec.base import FAST_ERRORS, MAX_NESTING, Deviation, Message
from jauspy.codec.shape import same_layout
from jauspy.errors import ConfigError, DecodeError

if TYPE_CHECKING:
    from jauspy.schema.model import Schema


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
    def order(self) -> tuple[int, ...]:
        """Orders versions, oldest first."""
        return tuple(int(part) for part in self.version.split(".") if part.isdigit())


def entries(module: str, service: str, version: str, *messages: tuple[Any, ...]) -> Iterator[Entry]:
    """The entries of one module: for each message its code and name, and its class where that has another name."""
    for code, name, *cls in messages:
        yield Entry(code, name, service, version, module, cls[0] if cls else name)


@dataclass(frozen=True, slots=True)
class Collision:
    """A message id that means different things in different services; only `service=` tells which is meant."""

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


class Registry:
    """The known messages.

    One layered over another (`base`) finds its own first; a service that it has in the same version replaces that of
    the base. Different services may use one message id: see `collisions`.
    """

    def __init__(self, entries: Iterable[Entry], base: Registry | None = None) -> None:
        self._base = base
        self._own: tuple[Entry, ...] = tuple(sorted(entries, key=lambda entry: entry.order, reverse=True))
        replaced = {(entry.service, entry.version) for entry in self._own}
        kept = (entry for entry in (base.entries if base else ()) if (entry.service, entry.version) not in replaced)
        self._entries: tuple[Entry, ...] = (*self._own, *kept)
        self.files: dict[tuple[str, str], str] = {}
        """Which file defines a service (URN and version), as far as it is known; for reports only."""
        self.schema: Schema | None = None
        """The definitions that `jauspy.load` made these messages from: with it a component can run their services."""
        self._codes: dict[int, tuple[Entry, ...]] = {}
        self._names: dict[str, tuple[Entry, ...]] = {}
        for entry in self._entries:
            self._codes[entry.code] = (*self._codes.get(entry.code, ()), entry)
            key = entry.name.casefold()
            self._names[key] = (*self._names.get(key, ()), entry)
        self._newest: dict[int, type[Message]] = {}

    def __len__(self) -> int:
        return len(self._entries)

    def __iter__(self) -> Iterator[type[Message]]:
        """Every message class; imports all modules."""
        return (entry.load() for entry in self._entries)

    def __repr__(self) -> str:
        return f"<Registry of {len(self)} messages>"

    @property
    def entries(self) -> tuple[Entry, ...]:
        """What is known without importing a message: own layer first, newest version first."""
        return self._entries

    @cached_property
    def collisions(self) -> tuple[Collision, ...]:
        """The message ids that mean different things in different services, lowest first.

        `decode` refuses them unless it is told the service. A newer version of a message, in its own service or in
        another one of the same set, replaces the older one and collides with nothing.
        """
        found = map(self.collision, sorted(self._codes))
        return tuple(collision for collision in found if collision)

    def collision(self, code: int) -> Collision | None:
        """What a message id means in different services; None when that is one thing, or nothing."""
        if len(self._codes.get(code, ())) < 2:
            return None
        meanings = _meanings(self._candidates(code))
        if len(meanings) < 2:
            return None
        return Collision(code, meanings, tuple(self.file_of(entry) for entry in meanings))

    def _candidates(self, code: int) -> list[Entry]:
        """The first entry of each service set, and its equals: other services' entries of the same layer and version.

        Of a service that has one id twice, as one published does, the first counts: no service tells those apart.
        """
        firsts: dict[str, tuple[bool, str]] = {}
        found: dict[str, Entry] = {}
        for entry in self._codes.get(code, ()):
            rank = (entry in self._own, entry.version)
            if firsts.setdefault(entry.service.rpartition(":")[0], rank) == rank:
                found.setdefault(entry.service, entry)
        return list(found.values())

    def file_of(self, entry: Entry) -> str:
        """The file that defines a message; its Python module where that is not known."""
        known = self.files.get((entry.service, entry.version))
        if known is not None:
            return known
        if self._base is not None and entry not in self._own:
            return self._base.file_of(entry)
        return _shipped_file(entry) or entry.module

    def by_code(self, code: int) -> tuple[type[Message], ...]:
        """The classes of this message id, newest version first; empty when there is none."""
        return tuple(entry.load() for entry in self._codes.get(code, ()))

    def by_name(self, name: str, *, service: str | None = None, version: str | None = None) -> type[Message]:
        """The newest message of this JAUS name, upper and lower case alike; `ConfigError` with close matches."""
        found = _choose(self._names.get(name.casefold(), ()), service, version)
        if found is not None:
            return found.load()
        names = sorted({entry.name for entry in self._entries})
        by_key = {known.casefold(): known for known in names}
        close = [by_key[key] for key in get_close_matches(name.casefold(), by_key, 3, 0.6)]
        which = " ".join(part for part in (name, f"of {service}" if service else "", version) if part)
        hint = f"; did you mean {' or '.join(close)}?" if close else ""
        raise ConfigError(f"no message {which} is known{hint}")

    @overload
    def decode(
        self,
        data: bytes | bytearray | memoryview,
        *,
        service: str | None = None,
        version: str | None = None,
        strict: Literal[True] = True,
    ) -> Message: ...

    @overload
    def decode(
        self,
        data: bytes | bytearray | memoryview,
        *,
        service: str | None = None,
        version: str | None = None,
        strict: Literal[False],
    ) -> tuple[Message, list[Deviation]]: ...

    def decode(
        self,
        data: bytes | bytearray | memoryview,
        *,
        service: str | None = None,
        version: str | None = None,
        strict: bool = True,
    ) -> Message | tuple[Message, list[Deviation]]:
        """The message these bytes are, newest version unless told otherwise; raises `DecodeError`.

        A message id that means different things in different services (see `collisions`) needs `service`.
        `strict=False` as in `Message.decode`: then only an unknown, ambiguous or missing message id raises.
        """
        cls = self._class_for(bytes(data), service, version)
        return cls.decode(data) if strict else cls.decode(data, strict=False)

    def _class_for(self, data: bytes, service: str | None, version: str | None) -> type[Message]:
        if len(data) < 2:
            raise DecodeError(f"{len(data)} bytes are too short for a message id")
        code = data[0] | data[1] << 8
        if service is None and version is None:
            cls = self._newest.get(code)
            if cls is not None:
                return cls
        entry = _choose(self._codes.get(code, ()), service, version)
        if entry is None:
            which = " ".join(part for part in (f"of {service}" if service else "", version) if part)
            raise DecodeError(f"unknown message id 0x{code:04X}{' ' + which if which else ''}")
        cls = entry.load()
        if service is None and version is None:
            if collision := self.collision(code):
                raise DecodeError(f"{collision}; say which service is meant")
            self._newest[code] = cls
        return cls

    def nested(self, data: bytes, depth: int) -> Message | bytes:
        """The message inside a message when it decodes strictly and encodes to the same bytes, else the bytes."""
        if depth >= MAX_NESTING or len(data) < 2 or (data[0] | data[1] << 8) not in self._codes:
            return data
        try:
            message = self._class_for(data, None, None)._unpack(data, depth + 1)  # noqa: SLF001 - the fast road
            return message if message._pack() == data else data  # noqa: SLF001
        except (DecodeError, *FAST_ERRORS):
            return data

    def from_dict(self, data: Mapping[str, Any]) -> Message:
        """The inverse of `message_to_dict`: `message` names it, `service` and `version` may, `fields` has the rest."""
        name = data.get("message")
        if not isinstance(name, str):
            raise ConfigError(f"{data!r} does not say which message it is")
        cls = self.by_name(name, service=data.get("service"), version=data.get("version"))
        return cls.from_dict(dict(data.get("fields") or {}))


def _choose(entries: tuple[Entry, ...], service: str | None, version: str | None) -> Entry | None:
    for entry in entries:
        if service in (None, entry.service) and version in (None, entry.version):
            return entry
    return None


def _meanings(entries: Iterable[Entry]) -> tuple[Entry, ...]:
    """The first entry of each name and layout."""
    names: dict[str, list[Entry]] = {}
    for entry in entries:
        same_name = names.setdefault(entry.name, [])
        if not any(same_layout(other.load().layout(), entry.load().layout()) for other in same_name):
            same_name.append(entry)
    return tuple(entry for same_name in names.values() for entry in same_name)


def _shipped_file(entry: Entry) -> str:
    """The file of a built-in message; empty when it is not built in."""
    if not entry.module.startswith("jauspy.messages."):
        return ""
    from jauspy.schema import load_builtin  # noqa: PLC0415 - reads XML, which decoding never needs

    where = load_builtin().service(entry.service, entry.version).where
    return where.file if where else ""
