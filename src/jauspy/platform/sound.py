"""Microphones, loudspeakers, and what sounds in the simulated world; levels in dB re 20 uPa."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from enum import Enum
from typing import Annotated, Final, Protocol, TypeAlias

from annotated_types import Interval, Len

from jauspy.platform.tables import Identifier, Position, Seed, Table, UrdfName

SAMPLE_RATE: Final = 48_000
"""Samples per second of all sound inside the robot, and of Opus (RFC 7587, 4.1)."""

Level: TypeAlias = Annotated[float, Interval(ge=0.0, le=130.0)]
"""Sound pressure level, dB."""


@dataclass(frozen=True, slots=True)
class MicrophoneSetup(Table):
    """A microphone, which hears all around: a table `[[microphones]]`."""

    name: UrdfName
    link: UrdfName
    full_scale: Annotated[float, Interval(ge=60.0, le=160.0)] = 110.0
    """Level of the loudest sine that it takes without clipping, dB."""
    ambient: Level = 35.0
    """Level of the noise around, and of its own, dB; in a simulation."""
    seed: Seed = 0
    """Seed of that noise, and of the noise of tracks."""


@dataclass(frozen=True, slots=True)
class LoudspeakerSetup(Table):
    """An announcer: a table `[[loudspeakers]]`."""

    name: Identifier
    """Files with what it plays are named after it."""
    link: UrdfName
    level: Level = 95.0
    """Level of the loudest sine at a distance of 1 m, dB."""
    port: Annotated[int, Interval(ge=0, le=65534)] = 0
    """UDP port that takes what it is to play; 0 stands for any free one."""
    folder: Annotated[str, Len(1, 4096)] | None = None
    """Folder for recordings (WAV) of what it plays; a relative path starts at the TOML file. None: nothing is kept."""
    sound_card: bool = False
    """True to play on the sound card of the machine, too."""


@dataclass(frozen=True, slots=True)
class ToneSetup(Table):
    """Something in the simulated world that sounds all the time: a table `[[tones]]`."""

    position: Position
    """Metres in the world's frame, whose origin is where the robot starts."""
    frequency: Annotated[float, Interval(ge=20.0, le=20_000.0)] = 1000.0
    """Hz."""
    level: Level = 80.0
    """At a distance of 1 m, dB."""


class Coding(Enum):
    """How sound travels in RTP; the values are payload types."""

    PCMU = 0
    """G.711 mu-law at 8 kHz (RFC 3551, 4.5.14)."""
    OPUS = 97
    """Opus (RFC 7587), a dynamic payload type."""


MIN_BIT_RATE, MAX_BIT_RATE = 6, 256
"""Kilobits per second of one channel of Opus (RFC 7587, 6.1; libopus takes 256 for each channel)."""


@dataclass(frozen=True, slots=True)
class AudioSettings:
    """Settings of a microphone or loudspeaker."""

    bit_rate: int = 48
    """Kilobits per second of Opus; PCMU always has 64."""
    gain: float = 0.5
    """0..1; 0.5 leaves the sound as it is, 1 doubles the amplitude."""


Address: TypeAlias = tuple[str, int]


class Microphone(Protocol):
    """Hears, encodes and sends to all listening addresses. No method blocks."""

    @property
    def setup(self) -> MicrophoneSetup:
        """Name and link."""
        ...

    @property
    def settings(self) -> AudioSettings:
        """Bit rate and gain."""
        ...

    @settings.setter
    def settings(self, settings: AudioSettings) -> None: ...

    def watch(self, address: Address, *, playing: bool = True, coding: Coding = Coding.OPUS) -> None:
        """Send to an address, or pause it; raises `ConfigError` if there are too many."""
        ...

    def leave(self, address: Address) -> None:
        """Stop sending to an address."""
        ...


class Loudspeaker(Protocol):
    """Plays what one sender sends by RTP. No method blocks."""

    @property
    def setup(self) -> LoudspeakerSetup:
        """Name, link and level."""
        ...

    @property
    def settings(self) -> AudioSettings:
        """Bit rate that senders are to use, and volume."""
        ...

    @settings.setter
    def settings(self, settings: AudioSettings) -> None: ...

    def listen(self, client: str, then: Callable[[Address | None], None]) -> None:
        """Open a port towards the address of a client; pass the own address to `then` later, None if that fails."""
        ...

    def play(self, hosts: frozenset[str], port: int | None = None) -> None:
        """Play what arrives from these addresses (and that port), the first source of it."""
        ...

    def stop(self) -> None:
        """Play nothing, and end the recording."""
        ...
