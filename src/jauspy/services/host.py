"""`Host` runs the services of one component without I/O: messages and time in, messages and timers out."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Sequence
from datetime import datetime
from typing import Any, Final, Literal

from jauspy.codec.message import Message
from jauspy.codec.registry import Registry
from jauspy.errors import ConfigError
from jauspy.ids import JausID, message_id
from jauspy.messages.core import ReportStatus
from jauspy.schema.model import Schema
from jauspy.services.binding import bind_services
from jauspy.services.core.management import Management
from jauspy.services.definitions import registry_for
from jauspy.services.messaging import InputDecoder, Outgoing
from jauspy.services.service import Service, ServiceHost, Timers
from jauspy.services.state_machine import Trigger, TriggerOutcome

MAX_BACKGROUND_TIMERS: Final = 2
"""Background timers, such as events of clients without control, that are run in one turn: a robot has many modules."""
BACKGROUND_RATE: Final = 1000.0
"""Maximum background timers per second."""
BACKGROUND_BURST: Final = 128
"""Background timers that may be run in a burst above that rate."""
BACKLOG_INTERVAL: Final = 0.005
"""Seconds until background timers are retried when the transport's queue is full."""


class Host(ServiceHost):
    """Binds and runs the services of one component, without I/O: the caller passes in messages and the time.

    Core services that are inherited from but not given are added with their defaults. Raises `ConfigError` that names
    every action, predicate and report that a service lacks. An exception in an action is logged, counted and contained;
    then, with `on_action_error="failure"`, the component goes to its state Failure until it is restarted. With
    `older_versions`, Discovery also lists version 1.0 of the services that are answered in that version, too.
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
        older_versions: bool = False,
    ) -> None:
        if on_action_error not in ("failure", "stay"):
            raise ConfigError(f"on_action_error is {on_action_error!r}; it must be 'stay' or 'failure'")
        super().__init__(id, utc_now=utc_now, now=now, max_output=max_output)
        self.older_versions = older_versions
        self._background_from = self._background_end = -math.inf
        self._fails_on_error = on_action_error == "failure"
        given = list(services)
        registry = registry or registry_for(given)
        self._bound = bind_services(given, schema, registry, self._reply, self._errors)
        self._decoder = InputDecoder(self._bound.inputs, registry, self.count)
        for service in self.services:
            service.host = self
        for service in self.services:
            service.attached()
        for machine in self._bound.machines.values():
            machine.start()
        self._triggers.start()

    @property
    def status(self) -> ReportStatus.Status | None:
        """The status that Management reports; None without that service."""
        management = self.service(Management)
        return management.status if management else None

    def receive(self, payload: bytes, source: JausID, now: float) -> None:
        """Handle one message (two bytes of message id, then the body). Never raises for what it contains.

        Timers that are overdue come first: a client whose control has timed out must not act because of a late call.
        """
        self.now = now
        due = self._timers.next()
        if due is not None and due < now:
            self._run_timers(self._timers, now)
        if len(payload) >= 2 and (expected := self._answers.get(message_id(payload))) is not None:
            self._take_answer(payload, source, *expected)
            return
        message = self._decoder.decode(payload, source)
        if message is None:
            return
        self.counters["received"] += 1
        for heard in self.heard_by:
            heard(source)
        if self.admission is None:
            self._handle(message, source)
        elif (admitted := self.admission.admit(message, payload, source)) is not None:
            try:
                self.admission.handled(self._handle(admitted, source))
            finally:
                self.operator = None

    def poll_output(self, now: float) -> list[Outgoing]:
        """Return the messages to be sent, oldest first, and remove them."""
        self.now = now
        return self._output.drain()

    def next_timeout(self) -> float | None:
        """Time at which to call `handle_timeout`; None when no timer is set."""
        due, background = self._timers.next(), self._background.next()
        if background is None:
            return due
        background = max(background, self._background_from)
        return background if due is None or background < due else due

    def handle_timeout(self, now: float, *, room: bool = True) -> None:
        """Run every timer that is due by `now`, once.

        Of those that may wait only some, and none without `room` for what they send.
        """
        self.now = now
        self._run_timers(self._timers, now)
        if not room:
            self._background_from = now + BACKLOG_INTERVAL
        elif now >= self._background_from:
            count = self._run_timers(self._background, now, MAX_BACKGROUND_TIMERS)
            # As many as `BACKGROUND_BURST` may come at once, and then one after the other.
            self._background_end = max(self._background_end, now) + count / BACKGROUND_RATE
            self._background_from = self._background_end - BACKGROUND_BURST / BACKGROUND_RATE

    def _run_timers(self, timers: Timers, now: float, limit: int | None = None) -> int:
        """Returns how many were due."""
        found = timers.due(now, limit)
        for due in found:
            call = timers.take(due)
            if call is not None:
                try:
                    call()
                except Exception as error:  # noqa: BLE001 - any bug of a service
                    name = f"timer {getattr(due[2], '__qualname__', due[2])}"
                    self._errors.record(name, Trigger("timer"), error)
        return len(found)

    def unreachable(self, client: JausID, now: float) -> None:
        """Notify the services that this client does not acknowledge messages any more: its events and control end."""
        self.now = now
        self._call_each(Trigger("client_lost", source=client), lambda service: service.client_lost(client))

    def close(self, now: float) -> None:
        """End control and events, and stop all motion. May be called twice."""
        self.leave(now)
        self.control_lost()
        self.take_id(self.id, now)

    def leave(self, now: float) -> None:
        """Notify the services that the id is given up; they notify clients of events and control that end."""
        self.now = now
        self._call_each(Trigger("leaving"), lambda service: service.leaving())

    def take_id(self, id: JausID, now: float) -> None:
        """Change to this id."""
        self.now = now
        self.id, self.requested_id = id, None
        self._call_each(Trigger("joined"), lambda service: service.joined())

    def _take_answer(
        self, payload: bytes, source: JausID, kind: type[Message], takers: Sequence[Callable[[Any, JausID], None]]
    ) -> None:
        message = self._decoder.decode_answer(kind, payload, source)
        if message is None:
            return
        self.counters["answers"] += 1
        for take in takers:
            try:
                take(message, source)
            except Exception as error:  # noqa: BLE001 - any bug of a service
                name = f"answer {getattr(take, '__qualname__', take)}"
                self._errors.record(name, Trigger(message.CODE, message, source), error)

    def _handle(self, message: Message, source: JausID) -> TriggerOutcome:
        outcome = self._triggers.handle(Trigger(message.CODE, message, source))
        if outcome is TriggerOutcome.IGNORED:
            self.counters["ignored"] += 1
        return outcome

    def _on_action_error(self) -> None:
        """Go to Failure, if the component has that state; not again when an action fails there."""
        if self._fails_on_error and "Failure" in self._bound.event_names and "Failure" not in self.path:
            self.fire("Failure")
