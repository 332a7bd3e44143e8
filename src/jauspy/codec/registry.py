"""Registries find message classes by name and by code; a module is imported when a message of it is first used."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass
from difflib import get_close_matches
from functools import cached_property
from importlib import import_module
from typing import TYPE_CHECKING, Any, Final, Literal, NamedTuple, TypeVar, overload

from jauspy.codec import slow_path
from jauspy.codec.items import join, shown
from jauspy.codec.message import FAST_ERRORS, Deviation, Message, Nesting, as_bytes, too_short
from jauspy.errors import ConfigError, DecodeError, EncodeError
from jauspy.ids import is_called

if TYPE_CHECKING:
    from jauspy.schema.model import Schema

STANDARD: Final = "urn:jaus:jss:"
"""Beginning of the URNs of published service sets."""


@dataclass(frozen=True, slots=True)
class MessageEntry:
    """One message of one service version, and the module and name of its class."""

    code: int
    name: str
    service: str
    version: str
    module: str
    cls: str
    digest: str = ""
    """Digest of the body (`jauspy.schema.digest`), equal for bodies that encode equal values to equal bytes."""

    def load(self) -> type[Message]:
        """The message class."""
        found = getattr(import_module(self.module), self.cls)
        assert isinstance(found, type)
        assert issubclass(found, Message)
        return found

    @property
    def edition(self) -> str:
        """The unit that has versions: a service set of the standard; otherwise the service."""
        return self.service.rpartition(":")[0] if self.service.startswith(STANDARD) else self.service

    @property
    def order(self) -> tuple[int, ...]:
        """Sort key of versions, oldest first."""
        return tuple(int(part) for part in self.version.split(".") if part.isdigit())


def entries(module: str, service: str, version: str, *messages: tuple[Any, ...]) -> Iterator[MessageEntry]:
    """The entries of one module: for each message code, name and digest, and its class where that has another name."""
    for code, name, digest, *cls in messages:
        yield MessageEntry(code, name, service, version, module, cls=cls[0] if cls else name, digest=digest)


class Hints(NamedTuple):
    """Narrows a search: the end of a service's URN, a version, a message's name; case does not matter."""

    service: str | None = None
    version: str | None = None
    message: str | None = None

    def fit(self, entry: MessageEntry) -> bool:
        """True if the entry fits the hints."""
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
    """An ambiguous message id; `remedy` is the argument that resolves it."""

    code: int
    entries: tuple[MessageEntry, ...]
    """One message of each meaning."""
    files: tuple[str, ...]
    """The files that define these messages, in the same order."""

    def __str__(self) -> str:
        meanings = (
            f"{entry.name} of {entry.service} {entry.version} ({file})"
            for entry, file in zip(self.entries, self.files, strict=True)
        )
        return f"message id 0x{self.code:04X} is {' and '.join(meanings)}"

    @property
    def remedy(self) -> str:
        """The argument that `decode` needs: `service`, or `message` where one service gives one id to several."""
        services = {(entry.service, entry.version) for entry in self.entries}
        return "service" if len(services) == len(self.entries) else "message"


def meanings(entries: Iterable[MessageEntry]) -> tuple[MessageEntry, ...]:
    """The first entry of each name and body, those of one name together."""
    names: dict[str, dict[str, MessageEntry]] = {}
    for entry in entries:
        names.setdefault(entry.name, {}).setdefault(entry.digest, entry)
    return tuple(entry for same_name in names.values() for entry in same_name.values())


M = TypeVar("M", bound=Message)


class Registry:
    """The known messages.

    One layered over another (`base`) finds its own first; a service that it has in the same version replaces that of
    the base. Different services, and sometimes a single one, may use one message id for several messages: see
    `collisions`.
    """

    def __init__(
        self,
        entries: Iterable[MessageEntry],
        base: Registry | None = None,
        files: Mapping[tuple[str, str], str] | None = None,
    ) -> None:
        self._base = base
        self._own: tuple[MessageEntry, ...] = tuple(sorted(entries, key=lambda entry: entry.order, reverse=True))
        replaced = {(entry.service, entry.version) for entry in self._own}
        kept = (entry for entry in (base.entries if base else ()) if (entry.service, entry.version) not in replaced)
        self._entries: tuple[MessageEntry, ...] = (*self._own, *kept)
        self.files = dict(files or {})
        """Files by service (URN and version), as far as known; for error messages only."""
        self.schema: Schema | None = None
        """The definitions that `jauspy.load` made these messages from: with it a component can run their services."""
        self._codes: dict[int, tuple[MessageEntry, ...]] = {}
        self._names: dict[str, tuple[MessageEntry, ...]] = {}
        for entry in self._entries:
            self._codes[entry.code] = (*self._codes.get(entry.code, ()), entry)
            key = entry.name.casefold()
            self._names[key] = (*self._names.get(key, ()), entry)
        self.nesting = Nesting(self)
        """Decodes nested messages by this registry."""
        self._plain: dict[int, type[Message] | None] = {}
        self._found: dict[tuple[int, Hints], Collision | None] = {}
        self._others: dict[type[Message], tuple[MessageEntry, ...]] = {}
        self._hinted: dict[Hints, dict[int, type[Message] | None]] = {}

    def __len__(self) -> int:
        return len(self._entries)

    def __iter__(self) -> Iterator[type[Message]]:
        """Every message class; imports all modules."""
        return (entry.load() for entry in self._entries)

    def __repr__(self) -> str:
        return f"<Registry of {len(self)} messages>"

    @property
    def entries(self) -> tuple[MessageEntry, ...]:
        """All entries, without importing messages: own layer first, newest version first."""
        return self._entries

    @property
    def own(self) -> tuple[MessageEntry, ...]:
        """The entries of its own layer, newest version first."""
        return self._own

    def entries_of(self, code: int) -> tuple[MessageEntry, ...]:
        """The entries of one message id, in the same order."""
        return self._codes.get(code, ())

    @cached_property
    def collisions(self) -> tuple[Collision, ...]:
        """The ambiguous message ids, lowest first.

        `decode` raises `DecodeError` for them unless `service` is given, or `message` where one service uses an id
        twice. A newer version of a message, in its own service or in another one of the same set of the standard,
        replaces the older one and is not a collision.
        """
        found = map(self.collision, sorted(self._codes))
        return tuple(collision for collision in found if collision)

    def collision(self, code: int, hints: Hints = NO_HINTS) -> Collision | None:
        """The collision that remains with these `hints`; None if there is one meaning or none."""
        if code not in self._codes:
            return None
        if (code, hints) not in self._found:
            several = self._meanings(code, hints)
            files = tuple(map(self.file_of, several)) if len(several) > 1 else ()
            self._found[code, hints] = Collision(code, several, files) if files else None
        return self._found[code, hints]

    def _meanings(self, code: int, hints: Hints) -> tuple[MessageEntry, ...]:
        candidates = self._candidates(entry for entry in self.entries_of(code) if hints.fit(entry))
        return tuple(candidates) if len(candidates) < 2 else meanings(candidates)

    def _candidates(self, entries: Iterable[MessageEntry]) -> list[MessageEntry]:
        """The relevant entries of each edition: those of the same layer and version as its first one."""
        firsts: dict[str, tuple[bool, str]] = {}
        found: list[MessageEntry] = []
        for entry in entries:
            rank = (entry in self._own, entry.version)
            if firsts.setdefault(entry.edition, rank) == rank:
                found.append(entry)
        return found

    def narrowed(self, code: int, wanted: Hints) -> Hints:
        """The wanted hints that fit some message of this id: the message's name first, then its service."""
        entries = self.entries_of(code)
        kept = NO_HINTS
        for key in ("message", "service", "version"):
            hints = kept._replace(**{key: getattr(wanted, key)})
            kept = hints if any(map(hints.fit, entries)) else kept
        return kept

    def others(self, kind: type[Message]) -> tuple[MessageEntry, ...]:
        """The other messages with the id of a message: in other versions of its set, and in `collisions`."""
        code = kind.CODE
        if kind not in self._others:
            key = (kind.NAME, kind.SERVICE, kind.VERSION)
            entries = self.entries_of(code)
            first = [entry for entry in entries if (entry.name, entry.service, entry.version) == key]
            self._others[kind] = meanings([*first, *entries])[1:] if len(entries) > 1 else ()
        return self._others[kind]

    def file_of(self, entry: MessageEntry) -> str:
        """The file that defines a message; its Python module where that is not known."""
        known = self.files.get((entry.service, entry.version))
        if known is not None:
            return known
        if self._base is not None and entry not in self._own:
            return self._base.file_of(entry)
        return _shipped_file(entry) or entry.module

    def by_code(self, code: int) -> tuple[type[Message], ...]:
        """The classes of this message id, newest version first; empty if there is none."""
        return tuple(entry.load() for entry in self.entries_of(code))

    def by_name(self, name: str, *, service: str | None = None, version: str | None = None) -> type[Message]:
        """The newest message of this JAUS name, upper and lower case alike; `ConfigError` with close matches.

        `service` is a URN or the end of one, as in `mobility:PrimitiveDriver`.
        """
        hints = Hints(service, version)
        found = [entry for entry in self._names.get(name.casefold(), ()) if hints.fit(entry)]
        if found:  # as spelt, if there is such a message; then the first
            return min(found, key=lambda entry: (entry.name != name, service not in (None, entry.service))).load()
        names = sorted({entry.name for entry in self._entries if hints.fit(entry)})
        by_key = {known.casefold(): known for known in names}
        close = [by_key[key] for key in get_close_matches(name.casefold(), by_key, 3, 0.6)]
        which = " ".join(part for part in (name, str(hints)) if part)
        hint = f"; did you mean {' or '.join(close)}?" if close else ""
        raise ConfigError(f"no message {which} is known{hint}")

    @overload
    def decode(
        self,
        data: bytes | bytearray | memoryview,
        *,
        service: str | None = None,
        version: str | None = None,
        message: str | None = None,
        strict: Literal[True] = True,
    ) -> Message: ...

    @overload
    def decode(
        self,
        data: bytes | bytearray | memoryview,
        *,
        service: str | None = None,
        version: str | None = None,
        message: str | None = None,
        strict: Literal[False],
    ) -> tuple[Message, list[Deviation]]: ...

    def decode(
        self,
        data: bytes | bytearray | memoryview,
        *,
        service: str | None = None,
        version: str | None = None,
        message: str | None = None,
        strict: bool = True,
    ) -> Message | tuple[Message, list[Deviation]]:
        """Decode a message, by default as the newest version; raises `DecodeError`.

        An ambiguous message id (see `collisions`) needs `service` (a URN or the end of one), or `message` (a name).
        Nested messages are decoded by this registry, too. `strict=False` as in
        `Message.decode`: then only an unknown, ambiguous or missing message id raises.
        """
        if type(data) is not bytes:
            data = as_bytes(data)
        hints = NO_HINTS if service is version is message is None else Hints(service, version, message)
        cls = self.class_of(data, hints)
        if cls is None:
            raise self._refusal(data, hints)
        return self.decode_as(cls, data) if strict else self.decode_as(cls, data, strict=False)

    @overload
    def decode_as(self, cls: type[M], data: bytes | bytearray | memoryview, *, strict: Literal[True] = True) -> M: ...

    @overload
    def decode_as(
        self, cls: type[M], data: bytes | bytearray | memoryview, *, strict: Literal[False]
    ) -> tuple[M, list[Deviation]]: ...

    def decode_as(
        self, cls: type[M], data: bytes | bytearray | memoryview, *, strict: bool = True
    ) -> M | tuple[M, list[Deviation]]:
        """Same as `cls.decode`, but nested messages are decoded by this registry."""
        if type(data) is not bytes:
            data = as_bytes(data)
        try:
            found = cls._unpack(data, self.nesting)
        except FAST_ERRORS:
            return (slow_path.decode if strict else slow_path.decode_tolerant)(cls, data, self.nesting)
        return found if strict else (found, [])

    def class_of(self, data: bytes, hints: Hints = NO_HINTS) -> type[Message] | None:
        """The class for the message id of these bytes; None if it is unknown or ambiguous."""
        if len(data) < 2:
            return None
        code = data[0] | data[1] << 8
        known = self._plain if hints is NO_HINTS else self._hinted.setdefault(hints, {})
        cls = known.get(code)
        if cls is None and code in self._codes and code not in known:
            found = self._meanings(code, hints)
            cls = known[code] = found[0].load() if len(found) == 1 else None
        return cls

    def _refusal(self, data: bytes, hints: Hints) -> DecodeError:
        if len(data) < 2:
            return too_short(data)
        code = data[0] | data[1] << 8
        if collision := self.collision(code, hints):
            return DecodeError(f"{collision}; specify the {collision.remedy}")
        return DecodeError(f"unknown message id 0x{code:04X} {hints}".rstrip())

    def from_dict(self, data: Mapping[str, Any]) -> Message:
        """The inverse of `message_to_dict`: `message` names it, `service` and `version` may, `fields` has the rest.

        Raises `EncodeError` with the field path. Nested messages are made by this registry, too.
        """
        return self.message_from(data, self.nesting, "")

    def message_from(self, data: object, nesting: Nesting, path: str) -> Message:
        """The same for a message inside another one, which is at `path`."""
        if not isinstance(data, Mapping) or not isinstance(data.get("message"), str):
            raise EncodeError(f"{shown(data)} does not name its message", path=path)
        named = {key: data.get(key) for key in ("service", "version")}
        for key, value in named.items():
            if not isinstance(value, str | None):
                raise EncodeError(f"{shown(value)} is no {key}", path=join(path, key))
        try:
            cls = self.by_name(data["message"], **named)
        except ConfigError as error:
            raise EncodeError(str(error), path=join(path, "message")) from None
        fields = data.get("fields")
        return cls._from_json({} if fields is None else fields, join(path, "fields") if path else "", nesting)


def _shipped_file(entry: MessageEntry) -> str:
    """The file of a built-in message; empty when it is not built in."""
    if not entry.module.startswith("jauspy.messages."):
        return ""
    from jauspy.schema import load_builtin  # noqa: PLC0415 - reads XML, which decoding never needs

    where = load_builtin().service(entry.service, entry.version).where
    return where.file if where else ""


def lazy(
    package: str, modules: Mapping[str, str]
) -> tuple[list[str], Callable[[str], object], Callable[[], list[str]]]:
    """`__all__`, `__getattr__` and `__dir__` of a package, from the names (with blanks between them) of each module."""
    names = {name: module for module, listed in modules.items() for name in listed.split()}

    def load(name: str) -> object:
        if name not in names:
            raise AttributeError(f"module {package!r} has no attribute {name!r}")
        value: object = getattr(import_module(names[name]), name)
        setattr(sys.modules[package], name, value)
        return value

    return sorted(names), load, lambda: sorted({*vars(sys.modules[package]), *names})
