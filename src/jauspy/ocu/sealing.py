"""Seals the commands of an OCU with its operator's key, for components with CommandSeal. See docs/security.md.

A component gives a challenge, to which the seals of the next commands refer. A component that gives none, since it has
no CommandSeal, is sent commands without a seal, as are wildcard ids.
"""

from __future__ import annotations

import asyncio
import math
import stat
from collections import OrderedDict
from collections.abc import Awaitable, Callable
from pathlib import Path
from typing import Final

from jauspy.codec.message import Message
from jauspy.codec.registry import Registry
from jauspy.errors import ConfigError, JausError
from jauspy.ids import JausID
from jauspy.logs import get_logger
from jauspy.messages.operators import RejectCommand, ReportSealChallenge
from jauspy.protocol.seal import OperatorKey
from jauspy.services.core.command_seal import CHALLENGE_LIFETIME, explained, is_stop, needs_seal
from jauspy.user_files import read_file

_LOG: Final = get_logger("jauspy.ocu")

REFRESH_AFTER: Final = 60.0
"""Seconds after which another challenge is requested, while the old one is still used."""
RETRY_AFTER: Final = 10.0
"""Seconds after which a component that gave no challenge is queried again; its commands do not wait for that."""
MAX_COMPONENTS: Final = 1024
"""Components whose challenges are known; the oldest is forgotten first."""

MAX_REFUSALS: Final = 256
"""Refusals that are remembered, so as to be logged once."""
MIN_ASK_INTERVAL: Final = 0.2
"""Seconds between two challenges of a component, however often it refuses what was sealed."""

_NEED_CHALLENGE: Final = frozenset(
    {
        RejectCommand.Reason.NO_SEAL,
        RejectCommand.Reason.UNKNOWN_CHALLENGE,
        RejectCommand.Reason.STALE,
        RejectCommand.Reason.REPLAYED,
    }
)
"""Reasons for which another challenge helps: the component was restarted, for instance."""


def load_key(path: str | Path) -> OperatorKey:
    """Read a key from a file that only its owner may read; raises `ConfigError` for any other file."""
    path = Path(path)
    try:
        mode = path.stat().st_mode
        content = read_file(path)
    except OSError as error:
        raise ConfigError(f"operator {path}: {error.strerror}; `jauspy keys new NAME` writes a key") from error
    except ConfigError as error:
        raise ConfigError(f"operator {error}") from None
    if mode & (stat.S_IRWXG | stat.S_IRWXO):
        raise ConfigError(f"operator {path}: other users may read it; do: chmod 600 {path}")
    try:
        return OperatorKey.from_pem(content)
    except ConfigError as error:
        raise ConfigError(f"operator {path}: {error}") from error


class CommandSealer:
    """Seals the commands of one OCU with the key of its operator; `ask` queries a component for a challenge."""

    def __init__(
        self, key: OperatorKey, own_id: JausID, ask: Callable[[JausID], Awaitable[ReportSealChallenge]]
    ) -> None:
        self._key = key
        self._own_id = own_id
        self._ask = ask
        self._components: OrderedDict[JausID, _Component] = OrderedDict()

    async def prepare(self, destination: JausID, message: Message) -> None:
        """Get a challenge of the destination before this command is sent; a stop does not wait for it."""
        if destination.is_wildcard or not needs_seal(message):
            return
        component = self._component(destination)
        now = asyncio.get_running_loop().time()
        if not component.is_usable(now) and now >= component.ask_at:
            may_take_seals = component.challenge is not None or component.asked_at == -math.inf
            task = self._renew(destination, component)
            if may_take_seals and not is_stop(message):
                await asyncio.wait({task})

    def seal(self, destination: JausID, message: Message) -> Message:
        """The sealed command; other messages, and commands to those that take no seals, as they are."""
        if destination.is_wildcard or not needs_seal(message):
            return message
        component = self._component(destination)
        now = asyncio.get_running_loop().time()
        if now - component.since > REFRESH_AFTER and now >= component.ask_at:
            self._renew(destination, component)
        if component.challenge is None or now - component.since > CHALLENGE_LIFETIME:
            return message
        component.counter += 1
        return self._key.seal(
            message,
            component.challenge,
            destination=destination,
            source=self._own_id,
            elapsed=now - component.since,
            counter=component.counter,
        )

    def can_help(self, reject: RejectCommand) -> bool:
        """True when the command would be taken with another challenge."""
        return reject.reason in _NEED_CHALLENGE

    def on_reject(self, reject: RejectCommand, source: JausID) -> bool:
        """Request another challenge if that helps; false when it does not."""
        if not self.can_help(reject):
            return False
        component = self._components.get(source)
        if component is not None:
            component.outdated = True
            if asyncio.get_running_loop().time() >= component.asked_at + MIN_ASK_INTERVAL:
                self._renew(source, component)
        return True

    def close(self) -> None:
        """End the queries for challenges."""
        for component in self._components.values():
            if component.asking is not None:
                component.asking.cancel()

    def _component(self, id: JausID) -> _Component:
        if id not in self._components:
            self._components[id] = _Component()
            if len(self._components) > MAX_COMPONENTS:
                _, oldest = self._components.popitem(last=False)
                if oldest.asking is not None:
                    oldest.asking.cancel()
        return self._components[id]

    def _renew(self, id: JausID, component: _Component) -> asyncio.Task[None]:
        if component.asking is None:
            component.asked_at = asyncio.get_running_loop().time()
            component.asking = asyncio.create_task(self._ask_for_challenge(id, component), name=f"challenge of {id}")
        return component.asking

    async def _ask_for_challenge(self, id: JausID, component: _Component) -> None:
        clock = asyncio.get_running_loop().time
        try:
            component.challenge = await self._ask(id)
            component.since, component.counter, component.outdated = clock(), 0, False
        except JausError:
            component.ask_at = clock() + RETRY_AFTER
        finally:
            component.asking = None


class Refusals:
    """Logs the refusals of commands that nobody waits for, once for each component and reason."""

    def __init__(self) -> None:
        self._logged: OrderedDict[tuple[JausID, int], None] = OrderedDict()

    def log(self, reject: RejectCommand, source: JausID, registry: Registry) -> None:
        """Log this refusal, if it is the first of its kind."""
        key = (source, int(reject.reason))
        if key in self._logged:
            return
        self._logged[key] = None
        if len(self._logged) > MAX_REFUSALS:
            self._logged.popitem(last=False)
        known = registry.by_code(reject.message_code)
        name = known[0].NAME if known else f"{reject.message_code:04X}h"
        _LOG.warning("%s refused %s: %s", source, name, explained(reject.reason))


class _Component:
    """The challenge that a component has given."""

    __slots__ = ("ask_at", "asked_at", "asking", "challenge", "counter", "outdated", "since")

    def __init__(self) -> None:
        self.challenge: ReportSealChallenge | None = None
        self.since = -math.inf
        """When the challenge arrived."""
        self.counter = 0
        self.outdated = False
        """The component has refused a seal with this challenge."""
        self.asking: asyncio.Task[None] | None = None
        self.asked_at = -math.inf
        self.ask_at = -math.inf
        """Not asked before this time, since it gave no answer."""

    def is_usable(self, now: float) -> bool:
        return self.challenge is not None and not self.outdated and now - self.since <= CHALLENGE_LIFETIME / 2
