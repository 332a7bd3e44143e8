"""`Service`, which authors of services subclass, and `ServiceHost`, which they use as `self.host`."""

from __future__ import annotations

import heapq
import math
from collections.abc import Callable, Collection, Hashable, Iterable, Mapping
from dataclasses import dataclass
from datetime import datetime, timedelta
from itertools import count
from typing import TYPE_CHECKING, Any, ClassVar, Final, Protocol, TypeAlias, TypeVar

from jauspy.arguments import check_number, described
from jauspy.beats import next_beat
from jauspy.codec.message import Message
from jauspy.codec.registry import Registry
from jauspy.errors import ConfigError
from jauspy.ids import JausID, component_id
from jauspy.logs import get_logger
from jauspy.protocol.addressing import HERE, Location
from jauspy.protocol.counters import Counters
from jauspy.protocol.header import Broadcast, Priority
from jauspy.protocol.seal import Operator
from jauspy.schema.model import ServiceDefinition as Definition
from jauspy.services.deferred import Deferred, DeferredReplies
from jauspy.services.messaging import InputDecoder, MessageSender, Outgoing, OutputQueue, Reply
from jauspy.services.presence_vectors import requested_report
from jauspy.services.state_machine import (
    ActionErrors,
    CommandCompletion,
    MachineInstance,
    Trigger,
    TriggerKey,
    TriggerOutcome,
    TriggerQueue,
)

Due: TypeAlias = tuple[float, int, Hashable]
"""A deadline, a serial number and the key."""

_MAX_STALE: Final = 64
"""Cancelled entries that the heap may have beyond the number of active timers."""


class Timers:
    """Each key has at most one deadline; setting it again moves it."""

    def __init__(self) -> None:
        self._active: dict[Hashable, tuple[int, Callable[[], None]]] = {}
        self._heap: list[Due] = []
        self._serial = count()

    def __len__(self) -> int:
        return len(self._active)

    def set(self, key: Hashable, due: float, call: Callable[[], None]) -> None:
        """Call `call` once, at time `due` (seconds)."""
        serial = next(self._serial)
        self._active[key] = (serial, call)
        heapq.heappush(self._heap, (due, serial, key))
        if len(self._heap) > 2 * len(self._active) + _MAX_STALE:
            self._compact()

    def cancel(self, key: Hashable) -> None:
        """Cancel the timer, if it is set."""
        self._active.pop(key, None)

    def next(self) -> float | None:
        """The earliest deadline, or None."""
        while self._heap and self._stale(self._heap[0]):
            heapq.heappop(self._heap)
        return self._heap[0][0] if self._heap else None

    def due(self, now: float, limit: int | None = None) -> list[Due]:
        """Timers that are due, earliest first. `take` each: an earlier one may cancel or move a later one."""
        found: list[Due] = []
        while self._heap and self._heap[0][0] <= now and (limit is None or len(found) < limit):
            entry = heapq.heappop(self._heap)
            if not self._stale(entry):
                found.append(entry)
        return found

    def take(self, due: Due) -> Callable[[], None] | None:
        """Remove a due timer and return its callback; None when it was cancelled or moved meanwhile."""
        return None if self._stale(due) else self._active.pop(due[2])[1]

    def _stale(self, entry: Due) -> bool:
        active = self._active.get(entry[2])
        return active is None or active[0] != entry[1]

    def _compact(self) -> None:
        self._heap = [entry for entry in self._heap if not self._stale(entry)]
        heapq.heapify(self._heap)


_LOG: Final = get_logger("jauspy.services")

S = TypeVar("S", bound="Service")


def check_services(services: object) -> list[Service]:
    """The services as a list; raises `TypeError` for anything that is not a service."""
    if isinstance(services, Service) or not isinstance(services, Iterable) or isinstance(services, str):
        raise TypeError(f"services are a list, as in [Battery()], not {described(services)}")
    found = list(services)
    for candidate in found:
        if isinstance(candidate, type) and issubclass(candidate, Service):
            raise TypeError(
                f"services are made from their classes: write {candidate.__name__}(), not {candidate.__name__}"
            )
        if not isinstance(candidate, Service):
            raise TypeError(
                f"a service is made from a class that inherits from jauspy.Service, not {described(candidate)}"
            )
    return found


class Service:
    """A JAUS service: the actions, predicates and reports of one definition.

    A subclass names its definition: `class PrimitiveDriver(Service, urn="urn:jaus:jss:mobility:PrimitiveDriver")`.
    Every action and predicate of the JSIDL is a method with its name in snake_case (`isControllingClient` ->
    `is_controlling_client`); `Send('ReportX', ...)` calls `report_x` and sends what it returns (None: nothing).
    Methods take what they need by name: `msg` or `query` (the message that triggered), `source` (its sender),
    `code` (the literal that the JSIDL gives, as in `'CONTROL_RELEASED'`). An action that returns a message answers
    with it; one that returns `self.host.defer(...)` answers when the result of that is set. `definitions`, from
    `jauspy.load`, has the definition of a service that is not built in.
    """

    urn: ClassVar[str] = ""
    version: ClassVar[str | None] = None
    """The version of the definition; None: the one that inheriting services need, else the newest."""
    definitions: ClassVar[Registry | None] = None
    """Has the definition and its messages, if they are not built in."""
    private: ClassVar[bool] = False
    """True when services that inherit from this one must not use its actions."""

    omits: ClassVar[frozenset[str]] = frozenset()
    """Methods for actions that are never called, since a predicate of this class excludes them."""

    own_events: ClassVar[frozenset[str]] = frozenset()
    """Internal events that another service of the component may have under the same name: fire `own_event(name)`."""

    host: ServiceHost
    """The component this service runs in; set before `attached`."""

    def __init_subclass__(
        cls,
        *,
        urn: str = "",
        version: str | None = None,
        definitions: Registry | None = None,
        private: bool = False,
    ) -> None:
        super().__init_subclass__()
        if definitions is not None and not isinstance(definitions, Registry):
            raise TypeError(f"definitions must be a result of `jauspy.load`, not {described(definitions)}")
        cls.urn = urn or cls.urn
        cls.version = version or cls.version
        cls.definitions = definitions or cls.definitions
        cls.private = private or cls.private

    if not TYPE_CHECKING:

        def __getattr__(self, name: str) -> object:
            """Explain the most frequent mistake: use of `host` in `__init__`."""
            if name == "host":
                hint = "it is there from `attached()` on, so set timers up there"
                text = f"{type(self).__name__!r} object has no attribute {name!r}; {hint}"
                raise AttributeError(text, name=name, obj=self)
            return self.__getattribute__(name)  # which says why, also when a property of the user has failed

    def every(self, seconds: float, call: Callable[[], None]) -> None:
        """Call a method of this service periodically, first in `seconds`; a second `every` replaces the period.

        Calls missed while the program was blocked are skipped. `self.host.cancel_timer(call)` ends it.
        """
        check_number(seconds, "the seconds of every()")
        if not 0 < seconds < math.inf:
            raise ConfigError(f"every(): the period {seconds} s must be above 0")
        self.host.repeat(call, seconds, call, first=self.host.now + seconds)

    @classmethod
    def own_event(cls, name: str) -> str:
        """The name of one of `own_events` for `host.fire`, which only transitions of this service take."""
        return f"{name} of {cls.urn}"

    def attached(self) -> None:
        """Called once, when `host` is set and before anything is received."""

    def client_lost(self, client: JausID) -> None:
        """Called when a client does not acknowledge messages any more."""

    def control_lost(self) -> None:
        """Called when the controlling client lost or released control, or another took it. Stop all motion."""

    def control_taken(self) -> None:
        """Called when a client has taken control of a component that nobody controlled."""

    def leaving(self) -> None:
        """Called before the component gives up its id or is closed. Clients can still be sent messages."""

    def joined(self) -> None:
        """Called after `leaving`, when the component has its new id, or can be opened again under the same one."""


@dataclass(frozen=True, slots=True, kw_only=True)
class BoundServices:
    """The services of a component, by URN, with their definitions and state machines."""

    services: Mapping[str, Service]
    definitions: Mapping[str, Definition]
    machines: Mapping[str, MachineInstance]
    receiver: MachineInstance | None
    """The machine for messages, and for internal events that no machine names."""
    inputs: Mapping[int, type[Message]]
    """The messages that are received, by code."""
    events: Mapping[TriggerKey, MachineInstance]
    """The machine that each internal event is for."""
    event_names: frozenset[str]
    """The internal events that the definitions have, whether a transition takes them or not."""
    queries: frozenset[int]
    """Codes of messages that are answered without a change of state."""


class Admission(Protocol):
    """Decides which of the received messages reach the state machines; a service sets it as `host.admission`."""

    def admit(self, message: Message, payload: bytes, source: JausID) -> Message | None:
        """The message to be handled, this one or one inside it; None when it is refused."""

    def handled(self, outcome: TriggerOutcome) -> None:
        """Called with the outcome of the message that `admit` returned last."""


class ServiceHost:
    """The interface of a component for its services, as `self.host`. `Host` binds and runs them.

    `utc_now` is the wall clock; every other time is `now`, in seconds of one monotonic clock.
    """

    _bound: BoundServices
    _decoder: InputDecoder

    def __init__(self, id: JausID, *, utc_now: Callable[[], datetime], now: float, max_output: int) -> None:
        self.id = id
        self.utc_now = utc_now
        self.now = now
        self.requested_id: JausID | None = None
        """The id that the component wants to change to."""
        self.controller: JausID | None = None
        """The client in control; set by AccessControl."""
        self.older_versions = False
        """True if Discovery lists version 1.0 of the services that the component also answers in that version."""
        self.admission: Admission | None = None
        """Decides what is handled; None: everything."""
        self.operator: Operator | None = None
        """The operator who sealed the message that is being handled; set by the admission."""
        self.clock_offset = timedelta()
        """Difference of the component's clock to the wall clock; set by Time."""
        self.on_expect: Callable[[], None] = lambda: None
        """Called when a service begins to expect a kind of message; set by the component that runs it."""
        self.on_timer_change: Callable[[], None] = lambda: None
        """Called when a timer is set from outside of the host; set by the component that runs it."""
        self.locate: Callable[[JausID, Callable[[Location], None]], None] = lambda _, found: found(HERE)
        """Calls back, now or later, with the machine of another component; set by the component that runs it."""
        self.heard_by: list[Callable[[JausID], None]] = []
        """Functions that are called with the source of each message, before it is handled; services add theirs."""
        self.counters = Counters(_LOG)
        self._output = OutputQueue(max_output, self.counters)
        self._timers = Timers()
        self._background = Timers()
        """Timers that may wait."""
        self._triggers = TriggerQueue(self._dispatch, lambda trigger: self.count("event_dropped", f"{trigger.key}"))
        self._errors = ActionErrors(self.counters, self._on_action_error)
        self._deferred = DeferredReplies(self, self._errors)
        self._sender = MessageSender(self._dispatch, self._errors, self.counters)
        self._by_class: dict[type[Service], Service | None] = {}
        self._answers: dict[int, tuple[type[Message], list[Callable[[Any, JausID], None]]]] = {}
        """Messages that services expect as clients of other components, by code."""

    @property
    def first_error(self) -> tuple[str, Exception] | None:
        """The first exception of a service, with its traceback, and which action, guard or timer raised it."""
        return self._errors.first

    @property
    def services(self) -> tuple[Service, ...]:
        """All services, most derived first."""
        return tuple(self._bound.services.values())

    @property
    def definitions(self) -> Mapping[str, Definition]:
        """The definitions of the services, by URN, in the order of `services`."""
        return self._bound.definitions

    @property
    def inputs(self) -> Collection[int]:
        """The ids of the messages that the component takes."""
        return self._bound.inputs

    @property
    def state(self) -> str:
        """The innermost active state of the receiving machine, as a dotted path."""
        return ".".join(self.path)

    @property
    def path(self) -> tuple[str, ...]:
        """The names of the active states of the receiving machine, outermost first."""
        return self._bound.receiver.path if self._bound.receiver else ()

    @property
    def utc_time(self) -> datetime:
        """The date and time of the component's clock, which a client may have set (service Time)."""
        return self.utc_now() + self.clock_offset

    def service(self, kind: type[S]) -> S | None:
        """The service of this class, None when the component has none."""
        if kind not in self._by_class:
            self._by_class[kind] = next((service for service in self.services if isinstance(service, kind)), None)
        return self._by_class[kind]  # type: ignore[return-value]  # kept by its class

    # --- messages -------------------------------------------------------------------------------------------------

    def send(
        self,
        destination: JausID,
        message: Message,
        *,
        priority: Priority = Priority.STANDARD,
        broadcast: Broadcast = Broadcast.NONE,
        on_acknowledged: Callable[[bool], None] | None = None,
    ) -> None:
        """Send a message; one that cannot be encoded is logged, counted and not sent.

        With `on_acknowledged` it is sent up to four times, until its destination, which must be one component,
        acknowledges it. The callback is called with whether it did, unless the component is closed before. When too
        many such messages are pending it is sent once, without the callback. A destination that does not acknowledge
        is not considered lost.
        """
        self._sender.send(destination, message, priority, broadcast, on_acknowledged)

    def output(self, outgoing: Outgoing) -> None:
        """Queue an encoded message; only the Transport service calls this."""
        self._output.put(outgoing)

    def ask(self, query: Message, source: JausID) -> tuple[TriggerOutcome, Reply]:
        """The answer that the component would send to `source` now; nothing is sent, and the state cannot change."""
        return self._sender.ask(self._bound.machines["ReceiveFSM"], Trigger(query.CODE, query, source))

    def defer(self, fallback: Callable[[], Message | None]) -> Deferred:
        """Make a deferred reply for an action that cannot report yet: the action returns it and sets its result later.

        Without a result after `REPLY_TIMEOUT` seconds, `fallback` makes the report.
        """
        return self._deferred.begin(fallback)

    def read(self, content: Message | bytes) -> Message | None:
        """Decode a message inside another one; None when it is no input of this component."""
        return self._decoder.read(content)

    def open(self, content: Message | bytes, source: JausID) -> Message | None:
        """Same as `read`, for a message that counts as received: what cannot be decoded is counted by reason."""
        payload = content.encode(strict=False) if isinstance(content, Message) else content
        return self.read(content) or self._decoder.decode(payload, source)

    def is_query(self, message: Message) -> bool:
        """True for an input that is no command and is answered, whatever its code: messages of users have any."""
        return message.CODE in self._bound.queries and not message.IS_COMMAND

    def takes(self, code: int) -> bool:
        """True if a received message with this id is an input of the component, or an answer that a service expects."""
        return code in self._bound.inputs or code in self._answers

    def expect(self, kind: type[Message], take: Callable[[Any, JausID], None]) -> None:
        """Call `take` with each message of this kind and its sender: an answer to a service that is itself a client.

        Several services may expect one kind, and each looks at the sender. Raises `ConfigError` for an input of the
        component.
        """
        if kind.CODE in self._bound.inputs:
            raise ConfigError(f"{kind.NAME} is an input of {self.id}, and so cannot be an answer to it")
        self._answers.setdefault(kind.CODE, (kind, []))[1].append(take)
        self.on_expect()

    # --- events, commands, timers -----------------------------------------------------------------------------------

    def fire(self, event: str, msg: Any = None, source: JausID | None = None) -> None:
        """Raise an internal event of the JSIDL; handled when the current trigger has been handled.

        Raises `ConfigError` for an event that no service of the component has.
        """
        if event not in self._bound.event_names:
            known = ", ".join(sorted(self._bound.event_names))
            raise ConfigError(f"no service of {self.id} has an internal event {event}; there are {known}")
        self._triggers.put(Trigger(event, msg, source))

    def perform(self, command: Message, source: JausID, on_ended: Callable[[bool], None]) -> None:
        """Handle a command as if `source` had sent it. `on_ended` is called with True if it was carried out.

        A command that no state takes, or whose action fails, was not. One that takes time ends when its service says
        so (`begin_command`), any other one as soon as it is taken.
        """
        self._triggers.put(Trigger(command.CODE, command, source), CommandCompletion(on_ended))

    def begin_command(self) -> CommandCompletion:
        """Begin a command that takes time; returns the function to call when it has ended."""
        return self._triggers.begin_command()

    def set_timer(self, key: Hashable, due: float, call: Callable[[], None], *, may_wait: bool = False) -> None:
        """Call `call` at time `due`; a timer with the same key is replaced.

        One that `may_wait` is called later when many of them are due, so that everything else is done in time.
        """
        timers, other = (self._background, self._timers) if may_wait else (self._timers, self._background)
        other.cancel(key)
        timers.set(key, due, call)

    def repeat(self, key: Hashable, period: float, call: Callable[[], None], *, first: float | None = None) -> None:
        """Call `call` every `period` seconds until the timer is cancelled; a timer with the same key is replaced.

        Without the time of the first call, all such calls of a robot with the same period come at the same times, so
        that its program wakes once for all of them; those of other robots on the machine come at others.
        """
        due = next_beat(self.now, period, self.id.subsystem) if first is None else first

        def tick() -> None:
            nonlocal due
            due += period * (1 + max(0, int((self.now - due) / period)))
            self.set_timer(key, due, tick)
            call()

        self.set_timer(key, due, tick)

    def cancel_timer(self, key: Hashable) -> None:
        """Cancel the timer, if it is set."""
        self._timers.cancel(key)
        self._background.cancel(key)

    # --- the component ----------------------------------------------------------------------------------------------

    def ask_for_id(self, id: JausID) -> None:
        """Change the component's id, as soon as all queued messages are sent.

        Raises `ConfigError` for an id that no component can have.
        """
        self.requested_id = None if id == self.id else component_id(id)

    def control_lost(self) -> None:
        """Notify all services that the controlling client lost control, or has changed."""
        self._call_each(Trigger("control_lost"), lambda service: service.control_lost())

    def control_taken(self) -> None:
        """Notify all services that a client has taken control, which nobody had."""
        self._call_each(Trigger("control_taken"), lambda service: service.control_taken())

    def count(self, reason: str, detail: str) -> None:
        """Count a dropped message or another event under this name; logged at DEBUG the first time."""
        self.counters.count(reason, f"{detail} ({self.id})")

    def _call_each(self, trigger: Trigger, call: Callable[[Service], None]) -> None:
        for service in self.services:
            try:
                call(service)
            except Exception as error:  # noqa: BLE001 - any bug of a service
                self._errors.record(f"{type(service).__name__}.{trigger.key}", trigger, error)

    def _on_action_error(self) -> None:
        """Called after each error of a service."""

    def _dispatch(self, trigger: Trigger) -> TriggerOutcome:
        machine = self._bound.events.get(trigger.key) or self._bound.receiver
        return machine.handle(trigger) if machine else TriggerOutcome.IGNORED

    def _reply(self, result: object, trigger: Trigger, to_source: bool) -> None:
        """Send a report: to the source of the trigger, or else to the controlling client."""
        if isinstance(result, Deferred):
            if not self._sender.captures(result, to_source=to_source):
                self._deferred.answer(result, trigger, lambda report: self._reply(report, trigger, to_source))
            return
        if not isinstance(result, Message):
            return
        to_source = to_source or not trigger.is_message
        destination = (trigger.source if to_source else None) or self.controller
        if destination is None:
            self.count("nobody_to_send_to", result.NAME)
            return
        self.send(destination, requested_report(result, trigger))
