"""Defects that victims can be given, to test that the attacks notice them: `python -m tools.attack --mutant NAME`.

`observed.py` applies a mutant in the process of a victim, before the command starts. No product code knows of them.
"""

from __future__ import annotations

import asyncio
import hmac
import math
import socket
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, Final

from jauspy.ids import JausID
from jauspy.logs import LogRateLimit
from jauspy.node.ingress import Ingress
from jauspy.node.links import TcpPeers
from jauspy.planning.service import MotionPlannerService, Work
from jauspy.protocol.duplicates import ReplayWindow
from jauspy.protocol.routing import Router
from jauspy.protocol.seal import PublicKey
from jauspy.protocol.sources import SourceChecks
from jauspy.services.command_timeout import ContinuousCommands
from jauspy.services.core import AccessControl, Management
from jauspy.services.core.event_clients import EventClients
from jauspy.services.core.subscriptions import Subscriptions
from jauspy.transport.age import DatagramReader
from jauspy.transport.send_queue import SendQueue
from jauspy.transport.tcp import StreamLink


@dataclass(frozen=True, slots=True)
class Mutant:
    """A defect: `patch` makes it; `noticed_by` names the attacks that break a bound because of it."""

    patch: Callable[[], None]
    noticed_by: tuple[str, ...]


def replaced(owner: Any, name: str, value: Any) -> Callable[[], None]:
    """A patch that replaces an attribute."""

    def patch() -> None:
        if not hasattr(owner, name):
            raise AttributeError(f"{owner} has no {name}: this mutant is out of date")
        setattr(owner, name, value)

    return patch


def _true(*_: Any, **__: Any) -> bool:
    return True


def _false(*_: Any, **__: Any) -> bool:
    return False


def _any_client(_: AccessControl, msg: object, source: JausID) -> bool:  # noqa: ARG001 - bound by their names
    return True


def _any_id(_: Management, source: JausID) -> bool:  # noqa: ARG001
    return True


def _clear_all(self: Management, source: JausID) -> None:  # noqa: ARG001
    self._emergency_clients = {}


def _no_timer(_: AccessControl) -> None:
    pass


def _nothing(*_: Any, **__: Any) -> None:
    pass


def leaking() -> None:
    """A descriptor stays open for each JTCP connection."""
    accept, leaked = TcpPeers._accepted, []  # noqa: SLF001 - a defect of it

    def accepted(self: TcpPeers, link: StreamLink) -> None:
        leaked.append(socket.socket())
        accept(self, link)

    replaced(TcpPeers, "_accepted", accepted)()


def no_control_timeout() -> None:
    """Neither silence of the client in control nor the lack of commands has an effect."""
    replaced(AccessControl, "reset_timer", _no_timer)()
    replaced(ContinuousCommands, "expect_next_command", _nothing)()


def events_for_ever() -> None:
    """Events of clients that are not heard go on."""
    replaced(EventClients, "is_gone", _false)()
    replaced(EventClients, "may_report", _true)()


def anybody_clears() -> None:
    """Each client ends an emergency of all others."""
    replaced(Management, "is_id_stored", _any_id)()
    replaced(Management, "delete_id", _clear_all)()


def any_age() -> None:
    """Commands may have waited for any time."""
    replaced(DatagramReader, "receiver", lambda self, _: self.receive)()
    replaced(Ingress, "_route_from", _route_anything)()
    replaced(SendQueue, "drop_stale", lambda _: 0)()


def every_plan() -> None:
    """Each request is planned, after all that came before it."""

    def begin(self: MotionPlannerService, work: Work) -> None:
        kept.add(task := asyncio.get_running_loop().create_task(self._perform(work)))
        task.add_done_callback(kept.discard)

    kept: set[asyncio.Task[None]] = set()
    replaced(MotionPlannerService, "_begin", begin)()


def _route_anything(self: Ingress, queues: Any, left: int, _: float, /) -> int:
    return _ROUTE_FROM(self, queues, left, -math.inf)


_ROUTE_FROM: Final = Ingress._route_from  # noqa: SLF001 - a defect of it
MUTANTS: Final[dict[str, Mutant]] = {
    "anybody-controls": Mutant(replaced(AccessControl, "is_controlling_client", _any_client), ("commands",)),
    "any-source": Mutant(replaced(SourceChecks, "check_address", _true), ("commands",)),
    "any-own-id": Mutant(replaced(Router, "_is_own", _false), ("own-ids",)),
    "any-key": Mutant(replaced(hmac, "compare_digest", _true), ("wrong-key",)),
    "any-replay": Mutant(replaced(ReplayWindow, "is_new", _true), ("replay",)),
    "any-seal": Mutant(replaced(PublicKey, "has_signed", _true), ("seals",)),
    "any-sealed-replay": Mutant(replaced(ReplayWindow, "is_new", _true), ("seals",)),
    "any-age": Mutant(any_age, ("stalled-robot",)),
    "anybody-clears": Mutant(anybody_clears, ("emergencies",)),
    "no-control-timeout": Mutant(no_control_timeout, ("cut-off",)),
    "unbounded-events": Mutant(replaced(Subscriptions, "full_for", _false), ("events",)),
    "events-for-ever": Mutant(events_for_ever, ("amplification",)),
    "every-plan": Mutant(every_plan, ("planner",)),
    "leaking-descriptors": Mutant(leaking, ("tcp",)),
    "unbounded-logs": Mutant(replaced(LogRateLimit, "filter", _true), ("local-udp",)),
}


def apply(name: str) -> None:
    """Give this process a defect."""
    MUTANTS[name].patch()
