"""The messages between the robot's process and the worker processes of microphones and loudspeakers."""

from __future__ import annotations

from dataclasses import dataclass

from jauspy.platform.sound import Address, AudioSettings, Coding, LoudspeakerSetup
from jauspy.platform.sound_scene import MachineState, SoundScene


@dataclass(frozen=True, slots=True)
class StartMicrophone:
    """The first message to the worker of a microphone."""

    scene: SoundScene
    settings: AudioSettings


@dataclass(frozen=True, slots=True)
class StartLoudspeaker:
    """The first message to the worker of a loudspeaker."""

    setup: LoudspeakerSetup
    settings: AudioSettings


@dataclass(frozen=True, slots=True)
class ChangeAudio:
    """Use these settings from now on."""

    settings: AudioSettings


@dataclass(frozen=True, slots=True)
class AddListener:
    """Send to this address, or pause sending."""

    address: Address
    playing: bool
    coding: Coding


@dataclass(frozen=True, slots=True)
class RemoveListener:
    """Send to this address no more."""

    address: Address


@dataclass(frozen=True, slots=True)
class MachineMoved:
    """The moving parts of the robot now."""

    state: MachineState


@dataclass(frozen=True, slots=True)
class SoundPlayed:
    """A loudspeaker of the robot plays a frame: 20 ms, float32 at 48 kHz."""

    loudspeaker: str
    frame: bytes


@dataclass(frozen=True, slots=True)
class OpenPort:
    """Receive at this address of the machine, at that port if it is free; 0 stands for any."""

    host: str
    port: int = 0


@dataclass(frozen=True, slots=True)
class PortOpened:
    """The port that receives; 0 when it could not be opened."""

    host: str
    port: int


@dataclass(frozen=True, slots=True)
class PlaySource:
    """Play what arrives from these addresses, and that port if there is one; without addresses: nothing."""

    hosts: frozenset[str]
    port: int | None = None
