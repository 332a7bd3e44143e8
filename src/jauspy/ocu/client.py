"""The operator control unit: a component that is a client of all others."""

from __future__ import annotations

import asyncio
import atexit
import signal
import sys
import threading
from collections import Counter
from collections.abc import AsyncGenerator, Callable, Iterator, Mapping
from contextlib import ExitStack, contextmanager
from datetime import UTC, datetime
from functools import partial
from pathlib import Path
from types import TracebackType
from typing import TYPE_CHECKING, Any, Final, Self, TypeVar, overload

from jauspy.arguments import async_only, check_number, check_text, described
from jauspy.codec.message import Message, Query
from jauspy.codec.registry import Registry
from jauspy.component import Component, ComponentOptions
from jauspy.errors import ConfigError, RequestError
from jauspy.ids import JausID
from jauspy.logs import get_logger
from jauspy.ocu.connection import Connection, RetryPolicy, Stats, Trace
from jauspy.ocu.control import DEFAULT_AUTHORITY
from jauspy.ocu.discovery import News, discover, discover_all, watch
from jauspy.ocu.explain import explain
from jauspy.ocu.handoff import request_handoff
from jauspy.ocu.robot import Robot
from jauspy.ocu.sealing import load_key
from jauspy.ocu.service import ServiceClient
from jauspy.ocu.subsystems import MAX_COMPONENTS
from jauspy.protocol.address_book import IdBounds
from jauspy.protocol.delivery import Delivery
from jauspy.services.core import Discovery, Identity, Liveness
from jauspy.services.core.discovery import COMPONENT, COMPONENT_TYPE, NODE, NODE_TYPE, SUBSYSTEM, SYSTEM
from jauspy.services.host import Host
from jauspy.services.iop.handoff import DecideHandoff, Decision, HandoffController, leave_open
from jauspy.transport import Transport
from jauspy.transport.connect import transport_for

# ruff: noqa: ASYNC109 - a timeout ends in an error that says what was asked, and of whom


R = TypeVar("R", bound=Message)

_LOG: Final = get_logger("jauspy.ocu")

CLASH_INTERVAL: Final = 5.0
"""Seconds between two checks for another machine with the same id."""
MOST_COMPONENTS: Final = 1 << 20
"""Greatest bound of the components that an OCU remembers."""
_OCU_TYPE = 20001


class OCU:
    """`async with jauspy.OCU("42.1.1") as ocu: robot = await ocu.discover(subsystem=101)`.

    `connect`: None (the node manager of this machine, else multicast), `"udp://HOST[:PORT]"`, `"tcp://HOST[:PORT]"` or
    `"local:DIRECTORY"`.
    `timeout` (seconds) and `retries` are the defaults of queries; `registry` holds the known messages; `delivery` the
    settings of reliable delivery and of large messages. `operator`: the path of the file with an operator's key, which
    seals every command (`jauspy keys new`). `decide_handoff` is asked when another client wants control of a component
    that this one controls: by default such requests are left to time out. `max_components` bounds the components of all
    robots that discovery and the addresses of UDP remember; further ones are not discovered.
    To others the OCU is a subsystem with one component, which answers discovery and heartbeat queries.
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
        operator: str | Path | None = None,
        decide_handoff: DecideHandoff = leave_open,
        max_components: int = MAX_COMPONENTS,
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
            raise TypeError(f"registry is what `jauspy.load` returns, not {described(registry)}")
        key = None if operator is None else load_key(operator)
        check_number(max_components, "max_components", whole=True)
        if not 1 <= max_components <= MOST_COMPONENTS:
            raise ConfigError(f"max_components {max_components} is outside 1..{MOST_COMPONENTS}")
        self._bounds = IdBounds(max_components, -(-max_components // 4))
        retry = RetryPolicy(timeout, retries)
        self._connection = Connection(self.id, registry or _builtin(), retry, key, max_components=max_components)
        self._component: Component | None = None
        self._handoffs = HandoffController(decide_handoff)
        self._stack = ExitStack()

    def __repr__(self) -> str:
        return f"<OCU {self.id}, {'open' if self.is_open else 'closed'}>"

    @property
    def stats(self) -> Stats:
        """Messages and round-trip times so far."""
        return self._connection.stats.snapshot()

    @property
    def counters(self) -> Mapping[str, int]:
        """Counters of the component and of its transport; empty while the OCU is closed."""
        return self._component.counters if self._component else {}

    @property
    def is_open(self) -> bool:
        """True between `open` and `close`."""
        return self._component is not None

    async def open(self) -> None:
        """Connect; without effect when open. Raises `TransportError`, and `ConfigError` for an invalid `connect`.

        While it is open in the main thread, SIGTERM and SIGHUP end the program as `sys.exit` does, unless the program
        handles them: blocks are left in order, and robots stop.
        """
        if self._component is not None:
            return
        transport = self._transport or await transport_for(self.id, self._connect, self._bounds)
        host = Host(self.id, [*_services(self._name), self._handoffs], utc_now=lambda: datetime.now(UTC))
        component = Component.of_host(
            host,
            transport,
            intercept=self._connection.on_packet,
            options=ComponentOptions(delivery=self._delivery),
        )
        await component.open()
        self._component = component
        self._connection.attach(component)
        loop = asyncio.get_running_loop()
        install = partial(_on_signal, loop)
        self._stack.enter_context(orderly(install, loop.remove_signal_handler))
        at_exit = partial(self._close_at_exit, loop)
        atexit.register(at_exit)
        self._stack.callback(atexit.unregister, at_exit)
        watch = loop.create_task(self._watch_id(), name=f"id clashes of {self.id}")
        self._stack.callback(watch.cancel)

    async def close(self) -> None:
        """Put controlled components in Standby, release control, cancel events, disconnect; without effect when closed.

        Waits for acknowledgements for up to 1.3 s. Calls that still wait for an answer or an event raise
        `TransportError`.
        """
        component, self._component = self._component, None
        if component is None:
            return
        try:
            await self._connection.run_on_close()
        finally:
            self._stack.close()
            self._connection.detach()
            await component.close()

    async def _watch_id(self) -> None:
        """Log a warning when another machine has the same id: one of the two receives no answers."""
        clash = ""
        while not clash:
            await asyncio.sleep(CLASH_INTERVAL)
            clash = await self._connection.id_clash()
        _LOG.warning("%s", clash)

    def _close_at_exit(self, loop: asyncio.AbstractEventLoop) -> None:
        """Close an OCU that the program left open, if its event loop can still run."""
        if self.is_open and not loop.is_running() and not loop.is_closed():
            loop.run_until_complete(self.close())

    async def __aenter__(self) -> Self:
        await self.open()
        return self

    async def __aexit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        await self.close()

    if not TYPE_CHECKING:
        __enter__ = __exit__ = async_only("`async with`")

    def watch_program(self, silence: Callable[[], float]) -> None:
        """Stop what `CommandStream` and `Robot.drive` repeat when `silence()` exceeds a second.

        For programs whose own code does not run in this event loop, which turns even when they hang. `silence` is
        called in the event loop and returns seconds.
        """
        self._connection.program_silence = silence

    def trace(self, callback: Trace | None) -> None:
        """Call `callback(source, destination, payload, sent=)` for each message that this OCU sends and receives.

        It is called in the event loop and must be quick. None ends it.
        """
        self._connection.trace = callback

    # --- discovery ------------------------------------------------------------------------------------------------

    async def discover(self, subsystem: int, *, timeout: float = 5.0) -> Robot:
        """The subsystem with this id; raises `ResponseTimeout` when it does not answer for `timeout` seconds."""
        return Robot(self._connection, await discover(self._connection, subsystem, timeout))

    async def robot(self, subsystem: int, *, timeout: float = 5.0) -> Robot:
        """The robot with this subsystem id; the same as `discover`."""
        return await self.discover(subsystem, timeout=timeout)

    async def discover_all(self, *, timeout: float | None = None) -> tuple[Robot, ...]:
        """All subsystems that answer within `timeout` seconds, other OCUs too, in the order of their numbers.

        Without `timeout` this takes 1 s if all that answered have described themselves completely, else 2 s.
        """
        return tuple(Robot(self._connection, subsystem) for subsystem in await discover_all(self._connection, timeout))

    async def watch(
        self, subsystem: int | None = None, *, interval: float = 2.0, silence: float = 7.0, parts: bool = False
    ) -> AsyncGenerator[News, None]:
        """`async for news in ocu.watch()`: yields the robots that are present, and then every change.

        One event for each robot (and other subsystem), whose `components` are in it: `Appeared`, `Changed` with what it
        was before, and `Vanished`. With `parts`, one for each subsystem, node, component and service.
        All are queried every `interval` seconds; a component that sends nothing for `silence` seconds has vanished.
        `subsystem` restricts this to one. A slow reader gets the difference to what it read last.
        """
        async for news in watch(self._connection, subsystem, interval, silence, parts=parts):
            yield news

    async def address_towards(self, destination: str | JausID) -> str:
        """The IP address of this machine from which a component is reached, for example as the destination of video.

        Raises `RequestError` while nothing was received from the component, so that its machine is unknown.
        """
        id = JausID.of(destination)
        found = await self._connection.address_towards(id)
        if found is None:
            raise RequestError(f"{id} has sent nothing yet, so its machine is unknown; query it first")
        return found

    # --- without discovery ----------------------------------------------------------------------------------------

    def service(self, destination: str | JausID, name: str) -> ServiceClient:
        """The client of a service of any component. The component need not have been discovered, nor list the service.

        `name` is the URN or the end of it; `ConfigError` if it is not known. With AccessControl, or any service that
        inherits from it, `async with ocu.service("126.1.11", "AccessControl").control(): ...` takes control.
        """
        return ServiceClient(self._connection, JausID.of(destination), self._connection.service_info(name))

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
        """Query any component; of several that match a wildcard id, the first answer is returned."""
        retry = self._connection.retry.replaced(timeout, retries)
        return await self._connection.query(JausID.of(destination), message, retry=retry, expects=expects)

    async def query_each(
        self, destination: str | JausID, message: Message, *, within: float = 2.0, expects: type[Message] | None = None
    ) -> AsyncGenerator[tuple[JausID, Any], None]:
        """Query all components that match a wildcard id.

        Yields sender and answer as they arrive within `within` seconds.
        """
        async for answer, source in self._connection.query_each(JausID.of(destination), message, within, expects):
            yield source, answer

    async def send(self, destination: str | JausID, message: Message, *, ack: bool = False) -> None:
        """Send to any component, or to all that match a wildcard id; `ControlRejected` as `ServiceClient.send`.

        With `ack` it is resent until that one component acknowledges it. If it does not, `ResponseTimeout` is raised.
        """
        await self._connection.send_checked(JausID.of(destination), message, ack=ack)

    def decide_handoffs(self, decide: DecideHandoff) -> None:
        """Have this function decide on requests for control from now on, as `decide_handoff` of the constructor."""
        self._handoffs.decide = decide

    def answer_handoff(self, component: str | JausID, id: int, decision: Decision) -> None:
        """Decide on a request that was left open; `id` is its number at the component."""
        self._handoffs.answer(JausID.of(component), id, decision)

    async def request_handoff(
        self, destination: str | JausID, explanation: str, *, authority: int = DEFAULT_AUTHORITY, within: float = 90.0
    ) -> None:
        """Ask the client in control of a component to hand over, with the reason; wait `within` seconds at most.

        Afterwards this OCU has control: take it by `control` with the same authority before the component's time-out.
        Raises `ControlRejected` with the reason when nothing is handed over, and `ResponseTimeout` without an answer.
        """
        await request_handoff(self._connection, JausID.of(destination), explanation, authority=authority, within=within)

    async def explain(self, destination: str | JausID, command: Message | None = None) -> str:
        """Why a component ignores commands, or this one; see `ServiceClient.explain`."""
        return await explain(self._connection, JausID.of(destination), command)


def _on_signal(loop: asyncio.AbstractEventLoop, number: int) -> None:
    loop.add_signal_handler(number, leave, number)


def _services(name: str) -> list[Discovery | Liveness]:
    identities = {
        SYSTEM: Identity(name, _OCU_TYPE),
        SUBSYSTEM: Identity(name, _OCU_TYPE),
        NODE: Identity(f"{name} node", NODE_TYPE),
        COMPONENT: Identity(name, COMPONENT_TYPE),
    }
    return [Discovery(identities), Liveness()]


def _builtin() -> Registry:
    from jauspy.messages import registry  # noqa: PLC0415 - only when no other registry is given

    return registry


SIGNALS: Final = ("SIGTERM", "SIGHUP")
"""Signals that by default end the process without cleanup."""


_users: Final[Counter[int]] = Counter()
"""How many open OCUs have a handler for each signal."""
_left: Final[set[int]] = set()
"""Signals that have begun to end the program; more of them must not interrupt its orderly end."""


def leave(number: int, frame: object = None) -> None:  # noqa: ARG001 - a signal handler
    """End the program as `sys.exit` does, with the exit status that a shell gives for this signal.

    In an event loop that `asyncio.run` runs, all tasks are cancelled and waited for.
    """
    if not _left:
        _left.add(number)
        sys.exit(128 + number)


@contextmanager
def orderly(install: Callable[[int], object], remove: Callable[[int], object]) -> Iterator[None]:
    """Inside the block, `install` handles signals that would kill the process, in the main thread.

    Without effect for signals that the program handles or ignores itself.
    """
    is_main = threading.current_thread() is threading.main_thread()
    numbers = [getattr(signal, name) for name in SIGNALS if is_main and hasattr(signal, name)]
    handled = [number for number in numbers if _users[number] or signal.getsignal(number) is signal.SIG_DFL]
    for number in handled:
        if not _users[number]:
            install(number)
        _users[number] += 1
    try:
        yield
    finally:
        for number in handled:
            _users[number] -= 1
            if not _users[number]:
                remove(number)
