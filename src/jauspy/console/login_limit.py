"""How often logins may fail, so that guessing is slow and nobody is locked out by the guesses of others.

An address that fails is delayed, and so is a device, which is a browser that a user has logged in with before. An
account is never locked: while it is attacked from many addresses, each further address has one attempt instead of
several. `now` is in seconds of a monotonic clock.
"""

from __future__ import annotations

import asyncio
import hashlib
import secrets
from collections import Counter, OrderedDict, deque
from collections.abc import Callable
from contextlib import suppress
from typing import Final, TypeVar

from jauspy.console.connections import network_of

MAX_FAILURES: Final = 5
"""Logins that may fail for one address, and for one device, within `FAILURE_TIME`."""
FAILURE_TIME: Final = 300.0
MAX_FAILURES_OF_ACCOUNT: Final = 20
"""Failures for one name from all addresses, after which each address has one attempt for it."""
MAX_FAILURES_IN_ALL: Final = 100
"""Failures for all names, after which each address has one attempt for any."""
MAX_COUNTED: Final = 4096
"""Addresses, devices and accounts of each whose failures are remembered."""
MAX_LOGINS: Final = 8
"""Logins of unknown devices that wait for verification. They are verified one at a time, since each needs 64 MiB."""
MAX_LOGINS_OF_HOST: Final = 2
MAX_LOGINS_OF_DEVICES: Final = 4

T = TypeVar("T")


class _Failures:
    """The times of the latest failures of each key; the key that failed longest ago is forgotten."""

    def __init__(self, allowed: int) -> None:
        self._kept = allowed + MAX_LOGINS  # attempts that are verified now may be taken back
        self._times: OrderedDict[str, deque[float]] = OrderedDict()

    def __len__(self) -> int:
        return len(self._times)

    def wait(self, key: str, allowed: int, now: float) -> float:
        """Seconds until this key has failed less than `allowed` times within `FAILURE_TIME`."""
        times = self._times.get(key, ())
        return 0.0 if len(times) < allowed else max(0.0, times[-allowed] + FAILURE_TIME - now)

    def add(self, key: str, now: float) -> None:
        """Count a failure."""
        self._times.setdefault(key, deque(maxlen=self._kept)).append(now)
        self._times.move_to_end(key)
        if len(self._times) > MAX_COUNTED:
            self._times.popitem(last=False)

    def remove(self, key: str, now: float) -> None:
        """Take back the failure that was counted at this time."""
        with suppress(KeyError, ValueError):
            self._times[key].remove(now)


class LoginLimit:
    """Counts failed logins by device, by address (IPv6: by network of 64 bits), by account and in all."""

    def __init__(self) -> None:
        self._devices = _Failures(MAX_FAILURES)
        self._addresses = _Failures(MAX_FAILURES)
        self._accounts = _Failures(MAX_FAILURES_OF_ACCOUNT)
        self._all = _Failures(MAX_FAILURES_IN_ALL)
        self._key = secrets.token_bytes(16)

    def trusts(self, device: str, now: float) -> bool:
        """True for a device whose own failures do not delay it; an empty one is unknown."""
        return bool(device) and not self._devices.wait(device, MAX_FAILURES, now)

    def wait(self, address: str, name: str, device: str, now: float) -> float:
        """Seconds until this browser may try again; 0 if it may now."""
        if self.trusts(device, now):
            return 0.0
        is_attacked = self._accounts.wait(self._account(name), MAX_FAILURES_OF_ACCOUNT, now) or self._all.wait(
            "", MAX_FAILURES_IN_ALL, now
        )
        return self._addresses.wait(network_of(address), 1 if is_attacked else MAX_FAILURES, now)

    def begin(self, address: str, name: str, device: str, now: float) -> Callable[[], None]:
        """Count an attempt as failed, so that attempts at the same time count, too; call the result if it succeeds."""
        counted = (
            [(self._devices, device)]
            if self.trusts(device, now)
            else [(self._addresses, network_of(address)), (self._accounts, self._account(name)), (self._all, "")]
        )
        for failures, key in counted:
            failures.add(key, now)

        def succeeded() -> None:
            for failures, key in counted:
                failures.remove(key, now)

        return succeeded

    def _account(self, name: str) -> str:
        """A name as a key of bounded length; names that do not exist count like others, so that none is revealed."""
        return hashlib.blake2b(name.encode("utf-8", "replace"), key=self._key, digest_size=8).hexdigest()


class Turns:
    """The order in which passwords are verified: one at a time; devices before others, which use half of the time."""

    def __init__(self) -> None:
        self._verifying = asyncio.Lock()
        self._others = asyncio.Lock()
        self._waiting: Counter[str] = Counter()
        self._devices = 0
        self._free_at = 0.0

    def has_room(self, address: str, *, trusted: bool) -> bool:
        """True if one more login of this address may wait."""
        if trusted:
            return self._devices < MAX_LOGINS_OF_DEVICES
        return self._waiting.total() < MAX_LOGINS and self._waiting[network_of(address)] < MAX_LOGINS_OF_HOST

    async def take(self, verify: Callable[[], T], address: str, *, trusted: bool) -> T:
        """Call `verify` in a thread when it is the turn of this login; returns its result."""
        if trusted:
            self._devices += 1
            try:
                return await self._verify(verify)
            finally:
                self._devices -= 1
        host = network_of(address)
        self._waiting[host] += 1
        try:
            async with self._others:
                return await self._after_pause(verify)
        finally:
            self._waiting -= Counter({host: 1})

    async def _after_pause(self, verify: Callable[[], T]) -> T:
        clock = asyncio.get_running_loop().time
        await asyncio.sleep(max(0.0, self._free_at - clock()))
        began = clock()
        try:
            return await self._verify(verify)
        finally:
            self._free_at = 2 * clock() - began

    async def _verify(self, verify: Callable[[], T]) -> T:
        async with self._verifying:
            return await asyncio.to_thread(verify)
