"""Command events: a client sends a command and is told once when it has been carried out, or has not (AS5710 1.1).

What the client is told is to be acknowledged. A request that comes again, because its confirmation was lost or late, is
confirmed again and does not begin the command again, nor when that has ended meanwhile.
"""

from __future__ import annotations

from typing import Final

from jauspy.codec.base import Message
from jauspy.ids import JausID
from jauspy.messages.core import (
    CancelEvent,
    CommandEvent,
    ConfirmEventRequest,
    CreateCommandEvent,
    CreateEvent,
    UpdateEvent,
)
from jauspy.services.core.subscriptions import ClientEvent, PendingCommand, Subscriptions
from jauspy.services.service import Service

COMPLETED_COMMAND_LIFETIME: Final = 3.0
"""Seconds; as long as our own OCU asks again, and longer than any known link takes."""
MAX_COMPLETED_COMMANDS: Final = 64


class CompletedCommands:
    """By their requests, each for a while; the oldest goes first."""

    def __init__(self) -> None:
        self._until: dict[PendingCommand, float] = {}

    def __len__(self) -> int:
        return len(self._until)

    def add(self, watch: PendingCommand, now: float) -> None:
        """It has ended just now; with one more than `MAX_COMPLETED_COMMANDS`, the oldest is forgotten."""
        self.forget(watch)
        self._until[watch] = now + COMPLETED_COMMAND_LIFETIME
        if len(self._until) > MAX_COMPLETED_COMMANDS:
            self.forget(next(iter(self._until)))

    def find(self, client: JausID, request: bytes, now: float) -> PendingCommand | None:
        """That of this very request."""
        for watch, until in self._until.items():
            if now < until and watch.client == client and watch.request == request:
                return watch
        return None

    def holds(self, watch: PendingCommand) -> bool:
        """True while it is remembered."""
        return watch in self._until

    def forget(self, watch: PendingCommand) -> None:
        """Its client knows; fine when it is gone."""
        self._until.pop(watch, None)

    def forget_of(self, client: JausID) -> None:
        """Those of a client that is gone."""
        for watch in [each for each in self._until if each.client == client]:
            self.forget(watch)

    def clear(self) -> None:
        """Forget all."""
        self._until.clear()


_OF_EVENTS: Final = frozenset(kind.CODE for kind in (CreateEvent, UpdateEvent, CancelEvent, CreateCommandEvent))
"""Commands of this service itself, which are answered anyway."""


class CommandEvents(Service):
    """The part of Events that is about commands. The command acts as if its client had sent it by itself."""

    subscriptions: Subscriptions
    ended: CompletedCommands
    _current: ClientEvent | None

    def is_command_supported(self, msg: CreateCommandEvent, source: JausID) -> bool:
        """It is a command that the component takes, and the client may have one more event."""
        command = self._command(msg)
        return command is not None and not self._is_one_too_many(msg, source)

    def create_command_event(self, msg: CreateCommandEvent, source: JausID) -> None:
        """Carry out the command, right after this has been confirmed."""
        self._watch(self.subscriptions.free_id(), msg, source)

    def update_command_event(self, msg: CreateCommandEvent, source: JausID) -> None:
        """The client sends the same command once more, while it is carried out: it has its full time again."""
        before = self._find_command(msg, source)
        if before is None:
            return
        if before.request != encoded(msg):
            self._watch(before.id, msg, source)
            return
        self._current = before
        if before.success is not None:
            self.host.fire("CommandCompleted", before, source)  # after the confirmation

    def start_command_timer(self, msg: CreateCommandEvent) -> None:
        """The command may take this long; 0 s only does for one that takes no time."""
        watch = self._current
        if isinstance(watch, PendingCommand) and watch.success is None:
            at = self.host.now + msg.maximum_allowed_duration
            self.host.set_timer(("command", watch.id), at, lambda: self._expired(watch))

    def stop_command_timer(self, msg: PendingCommand) -> None:
        """It has ended in time."""
        self.host.cancel_timer(("command", msg.id))

    def send_command_event(self, msg: PendingCommand) -> None:
        """Tell the client how its command ended; that is the end of the event."""
        result = CommandEvent.CommandResult.SUCCESSFUL if msg.success else CommandEvent.CommandResult.UNSUCCESSFUL
        self.host.send(msg.client, CommandEvent(event_id=msg.id, command_result=result), on_acknowledged=lambda _: None)
        self.subscriptions.remove(msg)
        if not msg.known:
            self.ended.add(msg, self.host.now)

    def _confirm_command(self, watch: PendingCommand, request_id: int) -> None:
        confirmation = ConfirmEventRequest(request_id=request_id, event_id=watch.id, confirmed_periodic_rate=0.0)
        self.host.send(watch.client, confirmation, on_acknowledged=lambda delivered: self._confirmed(watch, delivered))

    def _confirmed(self, watch: PendingCommand, delivered: bool) -> None:
        if delivered:
            watch.known = True
            self.ended.forget(watch)

    def _find_command(self, msg: CreateCommandEvent, source: JausID) -> PendingCommand | None:
        """Under way, or of this very request."""
        under_way = self.subscriptions.same_command(source, encoded(msg.command_message))
        return under_way or self.ended.find(source, encoded(msg), self.host.now)

    def _is_one_too_many(self, msg: CreateCommandEvent, source: JausID) -> bool:
        return self._find_command(msg, source) is None and self.subscriptions.full_for(source)

    def _command(self, msg: CreateCommandEvent) -> Message | None:
        command = self.host.read(msg.command_message)
        takes = command is not None and not self.host.is_query(command) and command.CODE not in _OF_EVENTS
        return command if takes else None

    def _watch(self, id: int, msg: CreateCommandEvent, source: JausID) -> None:
        command = self._command(msg)
        assert command is not None
        watch = PendingCommand(id, source, msg.request_id, command, encoded(msg))
        self.subscriptions.add(watch)
        self._current = watch
        self.host.perform(command, source, lambda success: self._ended(watch, success))

    def _ended(self, watch: PendingCommand, success: bool) -> None:
        if self.subscriptions.holds(watch) and watch.success is None:
            watch.success = success
            self.host.fire("CommandCompleted", watch, watch.client)

    def _expired(self, watch: PendingCommand) -> None:
        if self.subscriptions.holds(watch) and watch.success is None:
            watch.success = False
            self.host.fire("CommandExpired", watch, watch.client)


def encoded(message: Message | bytes) -> bytes:
    """The bytes of a message inside another one."""
    return message.encode(strict=False) if isinstance(message, Message) else message
