"""A component without I/O: its services, their merged state machines, timers and what it wants to send."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Hashable, Iterable, Mapping
from datetime import datetime
from typing import TYPE_CHECKING, Any, Literal, TypeVar

from jauspy.codec.base import Message
from jauspy.codec.registry import Registry
from jauspy.errors import ConfigError
from jauspy.ids import JausID, component_id
from jauspy.protocol.header import Broadcast, Priority
from jauspy.schema.model import Schema, Service as Definition
from jauspy.services.binding import BoundServices, bind_services
from jauspy.services.core.access_control import AccessControl
from jauspy.services.core.management import Management
from jauspy.services.core.time import Time
from jauspy.services.deferred import Deferred, DeferredReplies
from jauspy.services.definitions import registry_for
from jauspy.services.drops import Drops
from jauspy.services.inputs import InputDecoder
from jauspy.services.output import MessageSender, Outgoing, OutputQueue, Reply, requested_part
from jauspy.services.service import Service
from jauspy.services.state_machine import ActionErrors, CommandCompletion, Trigger, TriggerOutcome, TriggerQueue
from jauspy.services.timers import Timers

if TYPE_CHECKING:
    from jauspy.messages.core import ReportStatus

S = TypeVar("S", bound=Service)


class Host:
    """Runs the services of one component.

    `utc_now` is the wall clock; every other time is `now`, seconds of one monotonic clock. Core services that are
    inherited from but not given are added with their defaults. Raises `ConfigError` that names every action, predicate
    and report a service lacks. A bug in an action is logged, counted and contained; then the component goes to Failure,
    where it stays until it is started anew, or, by default, goes on.
    """

    def __init__(
        self,
        id: JausID,
        services: Iterable[Service],
        *,
        utc_now: Callable[[], datetime],
        now: float = 0.0,
        schema: Schema | None = None,
        registry: Registry | None = None,
        max_output: int = 1024,
        on_action_error: Literal["failure", "stay"] = "stay",
    ) -> None:
        if on_action_error not in ("failure", "stay"):
            raise ConfigError(f"on_action_error is {on_action_error!r}; it must be 'stay' or 'failure'")
        self.id = id
        self.utc_now = utc_now
        self.now = now
        self.wanted_id: JausID | None = None
        """The id that the component asks its shell for."""
        self.counters: Counter[str] = Counter()
        self._outbox = OutputQueue(max_output, self.counters)
        self._drops = Drops(self.counters, lambda: self.id)
        self._timers = Timers()
        self.prompt: Callable[[], None] = lambda: None
        """Called when something happened outside of a call: `next_timeout` says now. For the shell to set."""
        self._agenda = TriggerQueue(self._dispatch, lambda trigger: self.count("event_dropped", f"{trigger.key}"))
        self._bugs = ActionErrors(self.counters, self._fail if on_action_error == "failure" else lambda: None)
        self._laters = DeferredReplies(self, self._bugs)
        self._sending = MessageSender(self._dispatch, self._bugs, self.counters)
        self._found: dict[type[Service], Service | None] = {}
        given = list(services)
        registry = registry or registry_for(given)
        self._built: BoundServices = bind_services(given, schema, registry, self._reply, self._bugs)
        self._inputs = InputDecoder(self._built.inputs, registry, self.count)
        for service in self.services:
            service.host = self
        for service in self.services:
            service.attached()
        for machine in self._built.machines.values():
            machine.start()
        self._agenda.open()

    # --- what the shell calls -------------------------------------------------------------------------------------

    def receive(self, payload: bytes, source: JausID, now: float) -> None:
        """Take one message (two id bytes, then the body). Never raises for what it contains.

        Timers that are overdue come first: a late caller must not let a client act whose control has run out.
        """
        self.now = now
        due = self._timers.next()
        if due is not None and due < now:
            self.handle_timeout(now)
        message = self._inputs.decode(payload, source)
        if message is not None:
            self.counters["received"] += 1
            if self._agenda.run(Trigger(message.CODE, message, source)) is TriggerOutcome.IGNORED:
                self.counters["ignored"] += 1

    def poll_output(self, now: float) -> list[Outgoing]:
        """What is to be sent, oldest first; empty afterwards."""
        self.now = now
        return self._outbox.drain()

    def next_timeout(self) -> float | None:
        """When `handle_timeout` wants to be called; None when nothing is waited for."""
        return self._timers.next()

    def handle_timeout(self, now: float) -> None:
        """Let every timer that is due by `now` do its work, once."""
        self.now = now
        for due in self._timers.due(now):
            call = self._timers.take(due)
            if call is not None:
                try:
                    call()
                except Exception as error:  # noqa: BLE001 - any bug of a service
                    self._bugs.met(f"timer {getattr(due[2], '__qualname__', due[2])}", Trigger("timer"), error)

    def unreachable(self, client: JausID, now: float) -> None:
        """Tell the services that messages to this client do not arrive any more: its events and its control end."""
        self.now = now
        self._tell_all(Trigger("client_lost", source=client), lambda service: service.client_lost(client))

    def close(self, now: float) -> None:
        """Say goodbye to the clients, and stop what moves whoever is in control. Twice is fine."""
        self.leave(now)
        self.control_lost()
        self.take_id(self.id, now)

    def leave(self, now: float) -> None:
        """Say goodbye under the id that is given up: the services end what clients know under it."""
        self.now = now
        self._tell_all(Trigger("leaving"), lambda service: service.leaving())

    def take_id(self, id: JausID, now: float) -> None:
        """Have this id from now on."""
        self.now = now
        self.id, self.wanted_id = id, None
        self._tell_all(Trigger("joined"), lambda service: service.joined())

    # --- what may be asked ----------------------------------------------------------------------------------------

    @property
    def services(self) -> tuple[Service, ...]:
        """The services of the component, most derived first, parents included."""
        return tuple(self._built.services.values())

    @property
    def definitions(self) -> Mapping[str, Definition]:
        """The definitions of the services, by URN, in the order of `services`."""
        return self._built.definitions

    @property
    def state(self) -> str:
        """The innermost active state of the receiving machine, as a dotted path."""
        return ".".join(self.path)

    @property
    def path(self) -> tuple[str, ...]:
        """The names of the active states of the receiving machine, outermost first."""
        machine = self._built.machines.get("ReceiveFSM")
        return machine.path if machine else ()

    @property
    def status(self) -> ReportStatus.Status | None:
        """What Management reports; None without that service."""
        management = self.service(Management)
        return management.status if management else None

    @property
    def controller(self) -> JausID | None:
        """The client in control, if any."""
        access = self.service(AccessControl)
        return access.controller if access else None

    @property
    def utc_time(self) -> datetime:
        """The date and time as the component sees it: as a client set it, if there is the service Time."""
        time = self.service(Time)
        return time.current if time else self.utc_now()

    def service(self, kind: type[S]) -> S | None:
        """The service of this class, if the component has one."""
        if kind not in self._found:
            self._found[kind] = next((each for each in self.services if isinstance(each, kind)), None)
        return self._found[kind]  # type: ignore[return-value]  # kept by its class

    # --- what services call ---------------------------------------------------------------------------------------

    def send(
        self,
        destination: JausID,
        message: Message,
        *,
        priority: Priority = Priority.STANDARD,
        broadcast: Broadcast = Broadcast.NONE,
        told: Callable[[bool], None] | None = None,
    ) -> None:
        """Send a message; one that cannot be encoded is a bug: it is logged, counted and not sent.

        With `told` it is sent up to four times, until the one component that it is for acknowledges it; `told` hears
        whether it did, unless the component is closed before, or so many are under way that it is sent only once. Who
        does not acknowledge is not taken for gone.
        """
        self._sending.send(destination, message, priority, broadcast, told)

    def output(self, outgoing: Outgoing) -> None:
        """Queue an encoded message; only the Transport service calls this."""
        self._outbox.put(outgoing)

    def ask(self, query: Message, source: JausID) -> tuple[TriggerOutcome, Reply]:
        """What the component would answer `source` now; nothing is sent, and the state cannot change."""
        return self._sending.answer(self._built.machines["ReceiveFSM"], Trigger(query.CODE, query, source))

    def later(self, otherwise: Callable[[], Message | None]) -> Deferred:
        """For an action that cannot report yet: it returns this, to fulfil it; if it does not, `otherwise` reports."""
        return self._laters.begin(otherwise)

    def fire(self, event: str, msg: Any = None, source: JausID | None = None) -> None:
        """Raise an internal event of the JSIDL; handled as soon as what happens now is done.

        Raises `ConfigError` for one that no service of the component has.
        """
        if event not in self._built.event_names:
            known = ", ".join(sorted(self._built.event_names))
            raise ConfigError(f"no service of {self.id} has an internal event {event}; there are {known}")
        self._agenda.put(Trigger(event, msg, source))

    def perform(self, command: Message, source: JausID, ended: Callable[[bool], None]) -> None:
        """Handle a command as if `source` had just sent it. `ended` is told whether it was carried out.

        A command that no state takes, or that fails, was not. One that takes time ends when its service says so
        (`begin_command`), any other one as soon as it is taken.
        """
        self._agenda.put(Trigger(command.CODE, command, source), CommandCompletion(ended))

    def begin_command(self) -> CommandCompletion:
        """For an action that starts something which takes time: call what this returns when it has ended."""
        return self._agenda.begin_command()

    def ask_for_id(self, id: JausID) -> None:
        """Want to be the component of this id; the shell moves there as soon as what waits is sent.

        Raises `ConfigError` for an id that no component can have.
        """
        self.wanted_id = None if id == self.id else component_id(id)

    def set_timer(self, key: Hashable, at: float, call: Callable[[], None]) -> None:
        """Call `call` at time `at`; a timer with the same key is replaced."""
        self._timers.set(key, at, call)

    def cancel_timer(self, key: Hashable) -> None:
        """Forget the timer, if there is one."""
        self._timers.cancel(key)

    def control_lost(self) -> None:
        """Tell every service that the controlling client is gone, or is another one now."""
        self._tell_all(Trigger("control_lost"), lambda service: service.control_lost())

    def read(self, content: Message | bytes) -> Message | None:
        """A message inside another one as an input of this component; None when it is not one."""
        return self._inputs.read(content)

    def is_query(self, message: Message) -> bool:
        """True for an input that is no command and is answered, whatever its code: messages of users have any."""
        return message.CODE in self._built.queries and not message.IS_COMMAND

    def count(self, reason: str, detail: str) -> None:
        """Count something dropped; logged at DEBUG the first time."""
        self._drops.count(reason, detail)

    # --- inside ---------------------------------------------------------------------------------------------------

    def _tell_all(self, what: Trigger, tell: Callable[[Service], None]) -> None:
        for service in self.services:
            try:
                tell(service)
            except Exception as error:  # noqa: BLE001 - any bug of a service
                self._bugs.met(f"{type(service).__name__}.{what.key}", what, error)

    def _fail(self) -> None:
        """Go to Failure, if it has one and is not there already: an action that fails there must not start over."""
        if "Failure" in self._built.event_names and "Failure" not in self.path:
            self.fire("Failure")

    def _dispatch(self, trigger: Trigger) -> TriggerOutcome:
        machine = self._built.events.get(trigger.key) or self._built.receiver
        return machine.handle(trigger) if machine else TriggerOutcome.IGNORED

    def _reply(self, result: object, trigger: Trigger, to_source: bool) -> None:
        """Send what a report method made: to the sender, to whom an internal event is about, or to the controller."""
        if isinstance(result, Deferred):
            if not self._sending.keeps(result, to_source=to_source):
                self._laters.answer(result, trigger, lambda report: self._reply(report, trigger, to_source))
            return
        if not isinstance(result, Message):
            return
        about = to_source or not trigger.is_message
        destination = (trigger.source if about else None) or self.controller
        if destination is None:
            self.count("nobody_to_send_to", result.NAME)
            return
        self.send(destination, requested_part(result, trigger))
