"""Samples of Foxglove channels, and the channels of one sink: an MCAP file or a live client."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Final, Protocol

import foxglove
from foxglove._foxglove_py import BaseChannel

MAX_TOPICS: Final = 10_000
"""Channels of a sink; samples of further topics are left out, but each datagram is there."""


@dataclass(frozen=True, slots=True)
class ChannelForm:
    """What the samples of a channel are."""

    encoding: str
    schema: foxglove.Schema
    metadata: Mapping[str, str] = field(default_factory=dict)


@dataclass(frozen=True, slots=True)
class Sample:
    """One encoded message of a channel."""

    topic: str
    time: int
    """Nanoseconds since 1970, UTC."""
    data: bytes = field(repr=False)
    form: ChannelForm = field(repr=False)
    state: str | None = None
    """Names the state that it tells, within its topic; the latest sample of each is what a new client gets."""
    is_bulk: bool = False
    """True for video, scans, maps and the like, which a slow client does without."""
    is_key: bool = True
    """False for a picture that cannot be decoded without the one before it."""


class SdkMessage(Protocol):
    """A message of `foxglove.messages`."""

    @staticmethod
    def get_schema() -> foxglove.Schema:
        """The published schema."""
        ...

    def encode(self) -> bytes:
        """Bytes of Protocol Buffers."""
        ...


def sample(
    topic: str,
    time: int,
    message: SdkMessage,
    *,
    state: str | None = None,
    is_bulk: bool = False,
    is_key: bool = True,
) -> Sample:
    """A sample with one of Foxglove's schemas."""
    kind = type(message)
    form = _FORMS.get(kind)
    if form is None:
        form = _FORMS[kind] = ChannelForm("protobuf", message.get_schema())
    return Sample(topic, time, message.encode(), form, state, is_bulk, is_key)


_FORMS: Final[dict[type, ChannelForm]] = {}


class Channels:
    """The channels of a context, each made with the first sample of its topic."""

    def __init__(self, context: foxglove.Context) -> None:
        self._context = context
        self._channels: dict[str, BaseChannel] = {}

    def add(self, made: Sample) -> None:
        """Log a sample."""
        channel = self.channel(made)
        if channel is not None:
            channel.log(made.data, made.time)

    def channel(self, made: Sample) -> BaseChannel | None:
        """The channel of a sample's topic; None if there are too many."""
        channel = self._channels.get(made.topic)
        if channel is None and len(self._channels) < MAX_TOPICS:
            form = made.form
            # foxglove.Channel would be kept forever in a table of its module, also those of clients that are gone
            channel = self._channels[made.topic] = self._context._create_channel(  # noqa: SLF001
                made.topic,
                message_encoding=form.encoding,
                schema=form.schema,
                metadata=dict(form.metadata),
            )
        return channel
