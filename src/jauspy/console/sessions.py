"""Who is logged in to the console: sessions, bounded in number and time, and how often a login may fail.

Nothing here reads a clock: `now` is in seconds of a monotonic one.
"""

from __future__ import annotations

import asyncio
import ipaddress
import secrets
from collections import OrderedDict, deque
from contextvars import ContextVar
from dataclasses import dataclass, field
from typing import Final

from jauspy.console.users import LOCAL, User

MAX_SESSIONS: Final = 32
"""Further logins are refused."""
MAX_SESSIONS_OF_USER: Final = 4
"""A further login ends the oldest one of that user."""
LIFETIME: Final = 12 * 3600.0
"""Seconds after which a session ends."""
IDLE_TIME: Final = 1800.0
"""Seconds after which a session ends of which no page is open."""
MAX_FAILURES: Final = 5
"""Logins that may fail for one address within `FAILURE_TIME`."""
MAX_FAILURES_IN_ALL: Final = 100
FAILURE_TIME: Final = 300.0
MAX_ADDRESSES: Final = 1024


@dataclass(eq=False)
class Session:
    """A login of one browser."""

    user: User
    address: str
    key: str = field(default_factory=lambda: secrets.token_urlsafe(32), repr=False)
    """The value of the cookie."""
    began: float = 0.0
    seen: float = 0.0
    sockets: int = 0
    """That are open; a session with open sockets is not idle."""
    ended: asyncio.Event = field(default_factory=asyncio.Event)


current: ContextVar[Session | None] = ContextVar("jauspy console session", default=None)
"""Of the request or socket on whose behalf something is done, in all tasks that come of it."""


def current_user() -> User | None:
    """On whose behalf something is done; None for what the console does by itself."""
    session = current.get()
    return None if session is None else session.user


class Sessions:
    """The sessions of a console."""

    def __init__(self) -> None:
        self._open: dict[str, Session] = {}

    def __len__(self) -> int:
        return len(self._open)

    def begin(self, user: User, address: str, now: float) -> Session | None:
        """A new session; None when there are too many."""
        self.expire(now)
        own = [each for each in self._open.values() if each.user.name == user.name]
        if len(own) >= MAX_SESSIONS_OF_USER:
            self.end(min(own, key=lambda each: each.began))
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
        for each in list(self._open.values()):
            if each.sockets:
                each.seen = now
            if now - each.began >= LIFETIME or now - each.seen >= IDLE_TIME:
                self.end(each)


def local_session() -> Session:
    """The session of all browsers at a console without a login."""
    return Session(LOCAL, "localhost")


class LoginLimit:
    """Counts logins that failed, by address (IPv6: by network of 64 bits) and in all."""

    def __init__(self) -> None:
        self._failures: OrderedDict[str, deque[float]] = OrderedDict()
        self._all: deque[float] = deque(maxlen=MAX_FAILURES_IN_ALL)

    def wait(self, address: str, now: float) -> float:
        """Seconds until this address may try again; 0 if it may now."""
        own = self._failures.get(_network(address), deque())
        waits = [
            times[0] + FAILURE_TIME - now
            for times, limit in ((own, MAX_FAILURES), (self._all, MAX_FAILURES_IN_ALL))
            if len(times) >= limit
        ]
        return max(0.0, *waits) if waits else 0.0

    def failed(self, address: str, now: float) -> None:
        """A login failed."""
        times = self._failures.setdefault(_network(address), deque(maxlen=MAX_FAILURES))
        self._failures.move_to_end(_network(address))
        if len(self._failures) > MAX_ADDRESSES:
            self._failures.popitem(last=False)
        times.append(now)
        self._all.append(now)

    def succeeded(self, address: str) -> None:
        """A login of this address succeeded: its failures are forgotten."""
        self._failures.pop(_network(address), None)


def _network(address: str) -> str:
    try:
        found = ipaddress.ip_address(address.partition("%")[0])
    except ValueError:
        return address
    if isinstance(found, ipaddress.IPv6Address) and found.ipv4_mapped is None:
        return str(ipaddress.ip_network((found, 64), strict=False))
    return str(found)
