"""The users of the console and their sessions.

Users have names, roles and hashes of passwords, in a file that `jauspy console user` edits. Sessions are bounded in
number and time; they read no clock: `now` is in seconds of a monotonic one.
"""

from __future__ import annotations

import asyncio
import hmac
import os
import re
import secrets
import stat
from collections.abc import Iterator, Mapping
from contextvars import ContextVar
from dataclasses import dataclass, field
from pathlib import Path
from typing import Annotated, Final

from cryptography.exceptions import InvalidKey
from cryptography.hazmat.primitives.kdf.argon2 import Argon2id
from pydantic import BaseModel, ConfigDict, Field, ValidationError

from jauspy.config_errors import explain
from jauspy.errors import ConfigError
from jauspy.printable import printable
from jauspy.protocol.seal import DEFAULT_ROLES
from jauspy.user_files import parse_toml, read_file

NAME: Final = re.compile(r"[A-Za-z0-9_-]{1,32}")
MIN_PASSWORD: Final = 8
MAX_PASSWORD: Final = 256
MEMORY_COST: Final = 64 * 1024
"""KiB; with the iterations and lanes the second recommendation of RFC 9106, section 4."""
ITERATIONS: Final = 3
LANES: Final = 4
_HASH: Final = re.compile(
    r"\$argon2id\$v=19\$m=(?P<memory>[0-9]{1,6}),t=(?P<iterations>[0-9]{1,2}),p=(?P<lanes>[0-9]{1,2})"
    r"\$[A-Za-z0-9+/]{11,86}\$[A-Za-z0-9+/]{22,86}"
)
MAX_MEMORY_COST: Final = 1 << 18
"""KiB that a hash of the file may cost."""
MAX_COST: Final = 1 << 20
"""KiB, times iterations: up to five times the cost of a hash that jauspy makes."""
MAX_LANES: Final = 16
MAX_FILE: Final = 1 << 20
"""Bytes of the file."""
MAX_USERS: Final = 1000
MAX_SHOWN: Final = 5
"""Mistakes of a file in one error."""
MAX_PROBLEM: Final = 300
"""Characters of one."""
HEADING: Final = "# Users of the console in the browser; `jauspy console user` edits this file.\n"


@dataclass(frozen=True, slots=True)
class User:
    """A user of the console; `authority` is the highest of the role, 0 may only observe and stop."""

    name: str
    role: str
    authority: int

    @property
    def may_operate(self) -> bool:
        """False for users who may only observe and stop robots."""
        return self.authority > 0


LOCAL: Final = User("local", "supervisor", 255)
"""The user of a console without a login, which serves its own machine only."""


class _UserConfig(BaseModel):
    model_config = ConfigDict(extra="forbid", frozen=True)

    role: str
    password: str


class _UsersConfig(BaseModel):
    model_config = ConfigDict(extra="forbid", frozen=True)

    roles: Mapping[str, Annotated[int, Field(ge=0, le=255)]] = {}
    users: Mapping[str, _UserConfig] = {}


class Users:
    """The users of a file; raises `ConfigError` that names the mistake."""

    def __init__(self, path: Path) -> None:
        try:
            mode = path.stat().st_mode
        except OSError as error:
            raise ConfigError(f"users: {path}: cannot be read: {error.strerror}") from error
        if mode & stat.S_IWOTH:
            raise ConfigError(f"{path}: all users may change it; do: chmod o-w {path}")
        config = _parsed(path, read_file(path, MAX_FILE))
        roles = {**DEFAULT_ROLES, **config.roles}
        self._found: dict[str, tuple[User, str]] = {}
        for name, user in config.users.items():
            if user.role not in roles:
                raise ConfigError(
                    f"{path}: users.{name}.role = {user.role[:40]!r}; the roles are: {', '.join([*roles][:20])}"
                )
            if not _is_hash(user.password):
                raise ConfigError(
                    f"{path}: users.{name}.password is not a hash (Argon2id); make one: jauspy console user add {name}"
                )
            self._found[name] = (User(name, user.role, roles[user.role]), user.password)
        self._nobody = hashed("nobody has this password")

    def __len__(self) -> int:
        return len(self._found)

    def __iter__(self) -> Iterator[User]:
        return (user for user, _ in self._found.values())

    def verified(self, name: str, password: str) -> User | None:
        """The user, if the password is correct. It takes 0.1 to 0.5 s and 64 MiB, for names that do not exist, too."""
        user, expected = self._found.get(name, (None, self._nobody))
        try:
            Argon2id.verify_phc_encoded(password[:MAX_PASSWORD].encode("utf-8", "replace"), expected)
        except (InvalidKey, ValueError):
            return None
        return user

    def device_tag(self, name: str, device: str) -> str:
        """The proof that this user has logged in with a device; empty for unknown names.

        Its key is the hash of the password, so it survives a restart of the console and ends with the password.
        """
        if name not in self._found:
            return ""
        user, key = self._found[name]
        return hmac.digest(key.encode(), f"jauspy console device {user.name} {device}".encode(), "sha256").hex()


def hashed(password: str) -> str:
    """The hash of a password with a salt of its own, in the PHC format."""
    kdf = Argon2id(salt=os.urandom(16), length=32, iterations=ITERATIONS, lanes=LANES, memory_cost=MEMORY_COST)
    text: str = kdf.derive_phc_encoded(password.encode())
    return text


def add_user(path: Path, name: str, role: str, password: str) -> bool:
    """Write a user to the file, which is made if it does not exist; true if it replaces one of that name."""
    if not NAME.fullmatch(name):
        raise ConfigError(f"{name!r} is not a name of a user: 1 to 32 letters, digits, _ and -")
    if not MIN_PASSWORD <= len(password) <= MAX_PASSWORD:
        raise ConfigError(f"a password has {MIN_PASSWORD} to {MAX_PASSWORD} characters")
    text = read_file(path, MAX_FILE).decode("utf-8", "replace") if path.exists() else HEADING
    roles = {**DEFAULT_ROLES, **_parsed(path, text.encode()).roles}
    if role not in roles:
        raise ConfigError(f"--role {role}: the roles are: {', '.join(roles)}")
    rest = _without(text, name)
    _write(path, f'{rest.rstrip()}\n\n[users.{name}]\nrole = "{role}"\npassword = "{hashed(password)}"\n')
    return rest != text


def remove_user(path: Path, name: str) -> None:
    """Remove a user from the file; raises `ConfigError` if there is none of this name."""
    text = read_file(path, MAX_FILE).decode("utf-8", "replace")
    rest = _without(text, name)
    if rest == text:
        raise ConfigError(f"{path}: there is no user {name!r}; list them: jauspy console user ls")
    _write(path, rest)


def _without(text: str, name: str) -> str:
    """The file without the table of a user: its lines up to the next table or comment."""
    kept, leaving_out = [], False
    for line in text.splitlines(keepends=True):
        if line.startswith(("[", "#")):
            leaving_out = line.strip() == f"[users.{name}]"
        if not leaving_out:
            kept.append(line)
    return "".join(kept)


def _write(path: Path, text: str) -> None:
    """Replace the file as a whole; only its owner may read it."""
    _parsed(path, text.encode())
    new = path.with_name(f"{path.name}.new")
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        with os.fdopen(os.open(new, os.O_WRONLY | os.O_CREAT | os.O_TRUNC, 0o600), "w", encoding="utf-8") as stream:
            stream.write(text)
        new.replace(path)
    except OSError as error:
        raise ConfigError(f"cannot write {path}: {error.strerror}") from error


def _parsed(path: Path, data: bytes) -> _UsersConfig:
    try:
        config = _UsersConfig.model_validate(parse_toml(data, str(path)))
    except ValidationError as error:
        errors = error.errors(include_url=False)[:MAX_SHOWN]
        problems = "\n".join(f"  {printable(explain(problem, _UsersConfig))[:MAX_PROBLEM]}" for problem in errors)
        raise ConfigError(f"{path}: is not a file of users of the console:\n{problems}") from error
    for kind, names in (("user", config.users), ("role", config.roles)):
        if wrong := next((name for name in names if not NAME.fullmatch(name)), None):
            raise ConfigError(
                f"{path}: {wrong[:40]!r} is not a name of a {kind}: 1 to 32 letters, digits, _ and -; correct it"
            )
    if len(config.users) > MAX_USERS:
        raise ConfigError(f"{path}: has more than {MAX_USERS} users")
    return config


def _is_hash(text: str) -> bool:
    found = _HASH.fullmatch(text)
    if found is None:
        return False
    memory, iterations, lanes = (int(found[name]) for name in ("memory", "iterations", "lanes"))
    return (
        1 <= lanes <= MAX_LANES
        and 8 * lanes <= memory <= MAX_MEMORY_COST
        and iterations >= 1
        and memory * iterations <= MAX_COST
    )


MAX_SESSIONS: Final = 32
"""Further logins are refused."""
MAX_SESSIONS_OF_USER: Final = 4
"""A further login ends the oldest one of that user."""
LIFETIME: Final = 12 * 3600.0
"""Seconds after which a session ends."""
IDLE_TIME: Final = 1800.0
"""Seconds after which a session ends of which no page is open."""


@dataclass(eq=False)
class Session:
    """A login of one browser."""

    user: User
    address: str
    key: str = field(default_factory=lambda: secrets.token_urlsafe(32), repr=False)
    """The value of the cookie."""
    peer: int | None = None
    """The user id of this machine whose browser began it; None if unknown."""
    began: float = 0.0
    seen: float = 0.0
    sockets: int = 0
    """Number of open sockets beside `control_sockets`; a session with open sockets is not idle."""
    control_sockets: int = 0
    """Sockets for stopping and driving that are open."""
    ended: asyncio.Event = field(default_factory=asyncio.Event)

    @property
    def has_sockets(self) -> bool:
        """True while a page of it is open."""
        return self.sockets + self.control_sockets > 0


current: ContextVar[Session | None] = ContextVar("jauspy console session", default=None)
"""The session of the present request or socket, in all tasks that it starts."""


def current_user() -> User | None:
    """The user on whose behalf the present task runs; None for tasks of the console itself."""
    session = current.get()
    return None if session is None else session.user


class Sessions:
    """The sessions of a console. With `lasting`, as at a console without a login, they end only when there are more."""

    def __init__(self, *, lasting: bool = False) -> None:
        self._lasting = lasting
        self._open: dict[str, Session] = {}

    def __len__(self) -> int:
        return len(self._open)

    def __iter__(self) -> Iterator[Session]:
        return iter(self._open.values())

    def begin(self, user: User, address: str, now: float) -> Session | None:
        """A new session; None when there are too many."""
        self.expire(now)
        own_sessions = [session for session in self._open.values() if session.user.name == user.name]
        if len(own_sessions) >= (MAX_SESSIONS if self._lasting else MAX_SESSIONS_OF_USER):
            self.end(min(own_sessions, key=lambda session: (self._lasting and session.has_sockets, session.began)))
        if len(self._open) >= MAX_SESSIONS:
            return None
        session = Session(user, address, began=now, seen=now)
        self._open[session.key] = session
        return session

    def find(self, key: str, now: float) -> Session | None:
        """The session of a cookie; it counts as used."""
        self.expire(now)
        session = self._open.get(key)
        if session is not None:
            session.seen = now
        return session

    def end(self, session: Session) -> None:
        """Log out; its sockets are closed by those who wait for `ended`."""
        self._open.pop(session.key, None)
        session.ended.set()

    def expire(self, now: float) -> None:
        """End those that are too old or idle."""
        for session in list(self._open.values()):
            if session.has_sockets:
                session.seen = now
            if not self._lasting and (now - session.began >= LIFETIME or now - session.seen >= IDLE_TIME):
                self.end(session)
