"""The settings of reliable delivery and large messages, and how a message that asked for an answer ended."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final, NamedTuple

from jauspy.errors import ConfigError
from jauspy.ids import JausID

MAX_MESSAGE_SIZE: Final = 64 << 20
"""Bytes of a message at most: a quarter of all sequence numbers."""


@dataclass(frozen=True, slots=True)
class Delivery:
    """Times in seconds, sizes in bytes. `ack_timeout` and `resends` are what other stacks use.

    `max_message` is for messages sent and received. `source_memory` bounds the incomplete messages of one source,
    `total_memory` those of all; by default two and eight times `max_message`.
    """

    ack_timeout: float = 0.1
    resends: int = 3
    window: int = 8
    """Pieces of one large message that wait for their ACK at once; they fit the smallest buffer of known peers."""
    max_message: int = 1 << 20
    source_memory: int = 0
    total_memory: int = 0
    patience: float = 3.0
    """How long the missing pieces of a message may stay out."""

    def __post_init__(self) -> None:
        if not (self.ack_timeout > 0 and self.patience > 0 and self.resends >= 0 and 1 <= self.window <= 256):
            raise ConfigError("delivery needs ack_timeout and patience above 0, resends from 0, window 1..256")
        if not 1 <= self.max_message <= MAX_MESSAGE_SIZE:
            raise ConfigError(f"delivery max_message = {self.max_message} is outside 1..{LARGEST}")
        object.__setattr__(self, "source_memory", self.source_memory or 2 * self.max_message)
        object.__setattr__(self, "total_memory", self.total_memory or 8 * self.max_message)

    @property
    def memory_of_resends(self) -> float:
        """Seconds in which a packet may come again because its ACK was lost; as much again for the network's delay."""
        return 2 * self.ack_timeout * (self.resends + 1)


class DeliveryOutcome(NamedTuple):
    """How a message that wanted to be acknowledged ended; `ticket` is what `send` returned."""

    ticket: int
    delivered: bool
    silent: JausID | None = None
    """Who did not acknowledge after all resends; None when it was given up for another reason."""
