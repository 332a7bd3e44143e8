"""The operator control unit: a component of its own, and a client of all others."""

# ruff: noqa: ASYNC109 - a timeout ends in an error that says what was asked, and of whom

from __future__ import annotations

from collections.abc import AsyncGenerator, Mapping
from datetime import UTC, datetime
from types import TracebackType
from typing import TYPE_CHECKING, Any, Self, TypeVar, overload

from jauspy.arguments import check_text, described
from jauspy.codec.message import Message, Query
from jauspy.codec.registry import Registry
from jauspy.component import Shell
from jauspy.errors import ConfigError
from jauspy.ids import JausID
from jauspy.ocu import discovery
from jauspy.ocu.link import Link
from jauspy.ocu.only_async import use
from jauspy.ocu.patience import Patience
from jauspy.ocu.robot import Robot
from jauspy.ocu.stats import Stats
from jauspy.ocu.watch import News, watch
from jauspy.protocol.delivery import Delivery
from jauspy.services.core import Discovery, Identity, Liveness
from jauspy.services.core.identity import COMPONENT, NODE, SUBSYSTEM, SYSTEM
from jauspy.services.host import Host
from jauspy.transport import Transport
from jauspy.transport.connect import transport_for

R = TypeVar("R", bound=Message)

_OCU_TYPE = 20001
_COMPONENT_TYPE = 60001
_NODE_TYPE = 40001


class OCU:
    """`async with jauspy.OCU("42.1.1") as ocu: robot = await ocu.discover(subsystem=101)`.

    `connect`: None (the node manager of this machine, else multicast), `"udp://HOST[:PORT]"`, `"tcp://HOST[:PORT]"` or
    `"local:DIRECTORY"`.
    `timeout` (seconds) and `retries` are what queries use unless told otherwise; `registry` has the known messages;
    `delivery` the settings of reliable delivery and of large messages.
    Others see the OCU as a subsystem with one component that answers discovery and heartbeat.
    """

    def __init__(
        self,
        id: str | JausID = "42.1.1",
        connect: str | None = None,
        *,
        name: str = "jauspy OCU",
        timeout: float = 0.5,
        retries: int = 5,
        registry: Registry | None = None,
        transport: Transport | None = None,
        delivery: Delivery | None = None,
    ) -> None:
        self.id: JausID = JausID.of(id)
        if self.id.is_wildcard or 0 in (self.id.subsystem, self.id.node, self.id.component):
            raise ConfigError(f"{self.id} cannot be an OCU's id; use 1..65534, 1..254 and 1..254, as in 42.1.1")
        self._connect = connect
        self._transport = transport
        self._name = name
        self._delivery = delivery
        check_text(name, "an OCU's name")
        if registry is not None and not isinstance(registry, Registry):
            raise TypeError(f"registry is what `jauspy.load` gives, not {described(registry)}")
        self._link = Link(registry or _builtin(), Patience(timeout, retries))
        self._component: Shell | None = None

    def __repr__(self) -> str:
        return f"<OCU {self.id}, {'open' if self.is_open else 'closed'}>"

    @property
    def stats(self) -> Stats:
        """Messages and round-trip times so far."""
        return self._link.recorder.snapshot()

    @property
    def counters(self) -> Mapping[str, int]:
        """What the floors below counted; empty while the OCU is closed."""
        return self._component.counters if self._component else {}

    @property
    def is_open(self) -> bool:
        """True between `open` and `close`."""
        return self._component is not None

    async def open(self) -> None:
        """Connect; raises `TransportError` that says what to do, `ConfigError` for a wrong `connect`. Twice is fine."""
        if self._component is not None:
            return
        transport = self._transport or await transport_for(self.id, self._connect)
        host = Host(self.id, _services(self._name), utc_now=lambda: datetime.now(UTC))
        component = Shell(host, transport, intercept=self._link.receive, delivery=self._delivery)
        await component.open()
        self._component = component
        self._link.attach(component)

    async def close(self) -> None:
        """Give back what is controlled, in Standby, cancel events, and disconnect. Twice is fine.

        It waits until that was heard, for little more than a second. Whatever still waits for an answer or an event
        ends with `TransportError`.
        """
        component, self._component = self._component, None
        if component is None:
            return
        try:
            await self._link.say_goodbye()
        finally:
            self._link.detach()
            await component.close()

    async def __aenter__(self) -> Self:
        await self.open()
        return self

    async def __aexit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        await self.close()

    if not TYPE_CHECKING:
        __enter__ = __exit__ = use("`async with`")

    # --- finding --------------------------------------------------------------------------------------------------

    async def discover(self, subsystem: int, *, timeout: float = 5.0) -> Robot:
        """The subsystem of this number; raises `ResponseTimeout` when it does not answer for `timeout` seconds."""
        return Robot(self._link, await discovery.discover(self._link, subsystem, timeout))

    async def discover_all(self, *, timeout: float = 2.0) -> tuple[Robot, ...]:
        """Everybody who answers within `timeout` seconds, other OCUs too, in the order of their numbers."""
        return tuple(Robot(self._link, each) for each in await discovery.discover_all(self._link, timeout))

    async def watch(
        self, subsystem: int | None = None, *, interval: float = 2.0, silence: float = 7.0
    ) -> AsyncGenerator[News, None]:
        """`async for news in ocu.watch()`: what is there, and then what appears, changes and vanishes, for ever.

        All are asked every `interval` seconds; who has said nothing for `silence` seconds has vanished. `subsystem`
        narrows it to one. A reader that is slow gets the sum of what happened meanwhile.
        """
        async for news in watch(self._link, subsystem, interval, silence):
            yield news

    # --- talking without discovery --------------------------------------------------------------------------------

    @overload
    async def query(
        self,
        destination: str | JausID,
        message: Message,
        *,
        expects: type[R],
        timeout: float | None = ...,
        retries: int | None = ...,
    ) -> R: ...

    @overload
    async def query(
        self,
        destination: str | JausID,
        message: Query[R],
        *,
        expects: None = ...,
        timeout: float | None = ...,
        retries: int | None = ...,
    ) -> R: ...

    @overload
    async def query(
        self,
        destination: str | JausID,
        message: Message,
        *,
        expects: None = ...,
        timeout: float | None = ...,
        retries: int | None = ...,
    ) -> Any: ...

    async def query(
        self,
        destination: str | JausID,
        message: Any,
        *,
        expects: type[Message] | None = None,
        timeout: float | None = None,
        retries: int | None = None,
    ) -> Any:
        """Ask any component; of several that a wildcard id reaches, the first answer counts."""
        patience = self._link.patience.changed(timeout, retries)
        return await self._link.query(JausID.of(destination), message, patience=patience, expects=expects)

    async def query_each(
        self, destination: str | JausID, message: Message, *, within: float = 2.0, expects: type[Message] | None = None
    ) -> AsyncGenerator[tuple[JausID, Any], None]:
        """Ask all that a wildcard id reaches: who answered and what, as it comes in the next `within` seconds."""
        async for answer, source in self._link.query_each(JausID.of(destination), message, within, expects):
            yield source, answer

    async def send(self, destination: str | JausID, message: Message, *, ack: bool = False) -> None:
        """Send to any component, or to all that a wildcard id reaches; raises `ControlRejected` as a service's `send`.

        With `ack` it is resent until that one component acknowledges it, or `ResponseTimeout` is raised.
        """
        await self._link.tell(JausID.of(destination), message, ack=ack)


def _services(name: str) -> list[Discovery | Liveness]:
    identities = {
        SYSTEM: Identity(name, _OCU_TYPE),
        SUBSYSTEM: Identity(name, _OCU_TYPE),
        NODE: Identity(f"{name} node", _NODE_TYPE),
        COMPONENT: Identity(name, _COMPONENT_TYPE),
    }
    return [Discovery(identities), Liveness()]


def _builtin() -> Registry:
    from jauspy.messages import registry  # noqa: PLC0415 - only when no other registry is given

    return registry
