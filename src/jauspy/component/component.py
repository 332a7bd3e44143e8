"""A component as its author sees it: an id, the services it offers, and the way to its node manager."""

from __future__ import annotations

import asyncio
import time
from collections.abc import Callable, Iterable, Mapping
from datetime import UTC, datetime
from pathlib import Path
from types import TracebackType
from typing import Final, Literal, Self, TypeVar

from jauspy.arguments import check_text
from jauspy.codec.message import Message
from jauspy.codec.registry import Registry
from jauspy.component.shell import Component
from jauspy.errors import ConfigError
from jauspy.ids import JausID, component_id
from jauspy.protocol.delivery import Delivery
from jauspy.protocol.header import Broadcast, Priority
from jauspy.schema.model import Schema
from jauspy.services.core.defaults import with_core_services
from jauspy.services.host import Host
from jauspy.services.service import Service, check_services
from jauspy.transport import LocalTransport, Transport
from jauspy.transport.connect import DEFAULT_ROOT, transport_for

S = TypeVar("S", bound=Service)

_NAME: Final = "jauspy component"


class Component:
    """`async with jauspy.Component("101.1.120", [Battery()]): ...`, or `jauspy.run(component)`.

    The core services (Transport, Events, AccessControl, Management, Time, Liveness and Discovery) are there unless they
    are given; with `core=False` only those that the others inherit from. `name` is what Discovery tells. `connect`
    says where the node manager is: None (on this machine, its sockets in /tmp), or as for `OCU`, but by
    "udp://HOST" nobody finds it who has not heard of it before; `transport` replaces it. An id with zeros, as in
    `"0.0.101"`, waits to be given the rest, see `move`. A bug in a service is logged with the message that met it;
    then the component stays as it is, or with `on_action_error="failure"` fails. `schema` and `registry` replace
    the definitions and messages that are built in or that services bring along.

    Raises `ConfigError` that names every method which a service lacks.
    """

    def __init__(
        self,
        id: str | JausID,
        services: Iterable[Service],
        *,
        name: str = _NAME,
        core: bool = True,
        connect: str | None = None,
        transport: Transport | None = None,
        delivery: Delivery | None = None,
        on_action_error: Literal["stay", "failure"] = "stay",
        schema: Schema | None = None,
        registry: Registry | None = None,
        clock: Callable[[], float] | None = None,
        utc_now: Callable[[], datetime] = lambda: datetime.now(UTC),
    ) -> None:
        me = component_id(id)
        check_text(name, "a component's name")
        given = check_services(services)
        self.host = Host(
            me,
            with_core_services(given, name) if core else given,
            utc_now=utc_now,
            now=(clock or _loop_time)(),
            on_action_error=on_action_error,
            schema=schema,
            registry=registry,
        )
        self._connect = connect
        self._transport = transport
        self._delivery = delivery
        self._clock = clock or _loop_time
        self._shell: Component | None = None
        self._closed = asyncio.Event()

    def __repr__(self) -> str:
        return f"<component {self.id} with {', '.join(each.name for each in self.host.definitions.values())}>"

    @property
    def id(self) -> JausID:
        """Its id now."""
        return self.host.id

    @property
    def state(self) -> str:
        """The state that it is in, as a dotted path."""
        return self.host.state

    @property
    def controller(self) -> JausID | None:
        """The client in control, if any."""
        return self.host.controller

    @property
    def is_open(self) -> bool:
        """True between `open` and `close`."""
        return self._shell is not None

    @property
    def is_connected(self) -> bool:
        """True while its node manager answers."""
        return self._shell is not None and self._shell.transport.connected

    @property
    def counters(self) -> Mapping[str, int]:
        """Everything counted, as `host.received`; empty while it is closed."""
        return self._shell.counters if self._shell else {}

    def service(self, kind: type[S]) -> S:
        """The service of this class; `ConfigError` when the component has none."""
        found = self.host.service(kind)
        if found is None:
            raise ConfigError(f"{self} has no service of the class {kind.__name__}")
        return found

    async def open(self) -> None:
        """Connect and start; raises `TransportError` that says what to do. Twice is fine."""
        if self._shell is not None:
            return
        transport = self._transport or await self._way()
        shell = Component(self.host, transport, clock=self._clock, delivery=self._delivery)
        await shell.open()
        self._shell = shell
        self._closed.clear()

    async def close(self) -> None:
        """Stop what moves, send what waits, disconnect. Twice is fine."""
        shell, self._shell = self._shell, None
        if shell is not None:
            await shell.close()
        self._closed.set()

    async def run(self) -> None:
        """Open, serve until closed or cancelled, close."""
        async with self:
            await self._closed.wait()

    async def __aenter__(self) -> Self:
        await self.open()
        return self

    async def __aexit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        await self.close()

    def send(
        self,
        destination: str | JausID,
        message: Message,
        *,
        priority: Priority = Priority.STANDARD,
        broadcast: Broadcast = Broadcast.NONE,
    ) -> None:
        """Send a message, now; raises `EncodeError` for a value that does not fit."""
        self._open().send(JausID.of(destination), message, priority=priority, broadcast=broadcast)

    async def deliver(self, destination: str | JausID, message: Message) -> None:
        """Send, and wait until it was acknowledged; raises `ResponseTimeout` when it was not, after all resends."""
        await self._open().deliver(JausID.of(destination), message)

    def move(self, id: str | JausID) -> None:
        """Be another component from now on: registration and Discovery have the new id, events and control end.

        Clients are told so under the old id. Raises `TransportError` when the new id is taken on this machine; the
        component then keeps its id. An action asks for the same with `self.host.ask_for_id(id)`.
        """
        self._open().move(component_id(id))

    def wake(self) -> None:
        """Call this after acting on services from outside: sends what they want to send, sets their timers."""
        self._open().wake()

    def _open(self) -> Component:
        if self._shell is None:
            raise ConfigError(f"{self} is not open; use `async with component:` first")
        return self._shell

    async def _way(self) -> Transport:
        if self._connect is None:
            return LocalTransport(self.id, Path(DEFAULT_ROOT))
        return await transport_for(self.id, self._connect)


def _loop_time() -> float:
    """Seconds of the event loop's clock, also before there is a loop."""
    try:
        return asyncio.get_running_loop().time()
    except RuntimeError:
        return time.monotonic()
