"""Command events: a client sends a command and is notified once whether it was carried out (AS5710 1.1).

The client acknowledges the confirmation and the notification. A request that is repeated, because its confirmation was
lost or late, is confirmed again and does not start the command again, even when that has ended meanwhile.
"""

from __future__ import annotations

from typing import Final

from jauspy.codec.message import Message
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
"""Seconds during which a repeated request is recognized: as long as the OCU of this package repeats it."""
MAX_COMPLETED_COMMANDS: Final = 64
"""Completed commands that are remembered."""
_EVENT_REQUESTS: Final = frozenset(kind.CODE for kind in (CreateEvent, UpdateEvent, CancelEvent, CreateCommandEvent))
"""Commands of this service itself, which are answered anyway."""


class CompletedCommands:
    """Commands that have ended, while their clients may repeat the request; the oldest is dropped first."""

    def __init__(self) -> None:
        self._until: dict[PendingCommand, float] = {}

    def __len__(self) -> int:
        return len(self._until)

    def add(self, command: PendingCommand, now: float) -> None:
        """Remember a command that has ended now."""
        self.forget(command)
        self._until[command] = now + COMPLETED_COMMAND_LIFETIME
        if len(self._until) > MAX_COMPLETED_COMMANDS:
            self.forget(next(iter(self._until)))

    def find(self, client: JausID, request: bytes, now: float) -> PendingCommand | None:
        """The command of this request, None when it is not remembered."""
        for command, until in self._until.items():
            if now < until and command.client == client and command.request == request:
                return command
        return None

    def holds(self, command: PendingCommand) -> bool:
        """True while it is remembered."""
        return command in self._until

    def forget(self, command: PendingCommand) -> None:
        """Forget the command, if it is remembered."""
        self._until.pop(command, None)

    def forget_of(self, client: JausID) -> None:
        """Forget the commands of a client."""
        for command in [key for key in self._until if key.client == client]:
            self.forget(command)

    def clear(self) -> None:
        """Remove all completed commands."""
        self._until.clear()


class CommandEvents(Service):
    """The part of Events for command events. The command acts as if its client had sent it directly."""

    subscriptions: Subscriptions
    completed: CompletedCommands
    _current: ClientEvent | None

    def is_command_supported(self, msg: CreateCommandEvent, source: JausID) -> bool:
        """The component takes this command, and the client may have another event."""
        command = self._command(msg)
        return command is not None and not self._exceeds_limit(msg, source)

    def create_command_event(self, msg: CreateCommandEvent, source: JausID) -> None:
        """Carry out the command, after the confirmation."""
        self._perform(self.subscriptions.free_id(), msg, source)

    def update_command_event(self, msg: CreateCommandEvent, source: JausID) -> None:
        """The client repeats its request (answered again), or sends the command anew (carried out again)."""
        before = self._find_command(msg, source)
        if before is None:
            return
        if before.request != encoded(msg):
            self._perform(before.id, msg, source)
            return
        self._current = before
        if before.success is not None:
            self.host.fire("CommandCompleted", before, source)  # after the confirmation

    def start_command_timer(self, msg: CreateCommandEvent) -> None:
        """Limit the duration of the command; 0 s suffices for one that takes no time."""
        command = self._current
        if isinstance(command, PendingCommand) and command.success is None:
            deadline = self.host.now + msg.maximum_allowed_duration
            self.host.set_timer(("command", command.id), deadline, lambda: self._on_expired(command))

    def stop_command_timer(self, msg: PendingCommand) -> None:
        """Cancel the time-out of a command that has ended."""
        self.host.cancel_timer(("command", msg.id))

    def send_command_event(self, msg: PendingCommand) -> None:
        """Notify the client how its command ended, and end the event."""
        result = CommandEvent.CommandResult.SUCCESSFUL if msg.success else CommandEvent.CommandResult.UNSUCCESSFUL
        self.host.send(msg.client, CommandEvent(event_id=msg.id, command_result=result), on_acknowledged=lambda _: None)
        self.subscriptions.remove(msg)
        if not msg.confirmation_acknowledged:
            self.completed.add(msg, self.host.now)

    def _confirm_command(self, command: PendingCommand, request_id: int) -> None:
        confirmation = ConfirmEventRequest(request_id=request_id, event_id=command.id, confirmed_periodic_rate=0.0)
        self.host.send(
            command.client, confirmation, on_acknowledged=lambda acknowledged: self._on_confirmed(command, acknowledged)
        )

    def _on_confirmed(self, command: PendingCommand, acknowledged: bool) -> None:
        if acknowledged:
            command.confirmation_acknowledged = True
            self.completed.forget(command)

    def _find_command(self, msg: CreateCommandEvent, source: JausID) -> PendingCommand | None:
        """The client's pending event for this command, or the completed one of this request."""
        pending = self.subscriptions.same_command(source, encoded(msg.command_message))
        return pending or self.completed.find(source, encoded(msg), self.host.now)

    def _exceeds_limit(self, msg: CreateCommandEvent, source: JausID) -> bool:
        return self._find_command(msg, source) is None and self._is_full_for(source)

    def _is_full_for(self, client: JausID) -> bool:
        return self.subscriptions.full_for(client, in_control=client == self.host.controller)

    def _command(self, msg: CreateCommandEvent) -> Message | None:
        command = self.host.read(msg.command_message)
        takes = command is not None and not self.host.is_query(command) and command.CODE not in _EVENT_REQUESTS
        return command if takes else None

    def _perform(self, id: int, msg: CreateCommandEvent, source: JausID) -> None:
        message = self._command(msg)
        assert message is not None
        command = PendingCommand(id, source, msg.request_id, message, encoded(msg))
        self.subscriptions.add(command)
        self._current = command
        self.host.perform(message, source, lambda success: self._on_ended(command, success))

    def _on_ended(self, command: PendingCommand, success: bool) -> None:
        if self.subscriptions.holds(command) and command.success is None:
            command.success = success
            self.host.fire("CommandCompleted", command, command.client)

    def _on_expired(self, command: PendingCommand) -> None:
        if self.subscriptions.holds(command) and command.success is None:
            command.success = False
            self.host.fire("CommandExpired", command, command.client)


def encoded(message: Message | bytes) -> bytes:
    """The bytes of a message inside another one."""
    return message.encode(strict=False) if isinstance(message, Message) else message
