"""CM-AUD: microphones and loudspeakers."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, ClassVar, Final

from jauspy.platform.contract import RobotParts
from jauspy.platform.sound import Coding
from jauspy.services import iop
from jauspy.services.environment_sensing import DigitalResourceDiscovery
from jauspy.services.environment_sensing.digital_resource_discovery import MediaStreams
from jauspy.services.iop.sound_devices import CodedMicrophone, SoundDevices

from .kind import Kind, ModuleBuild, ServiceEntry

MICROPHONES: Final = "microphones"
LOUDSPEAKERS: Final = "loudspeakers"


@dataclass(frozen=True, slots=True)
class AudioContext:
    """Parts from which the services of a CM-AUD are made."""

    module: ClassVar[str] = "CM-AUD"
    moving: ClassVar[None] = None
    robot: RobotParts
    devices: SoundDevices
    opus: MediaStreams
    """End points of clients, to which microphones send Opus."""
    telephony: MediaStreams
    """End points of AEODRS, to which they send mu-law: its definition has no Opus."""


SERVICES: Final[Mapping[str, ServiceEntry[Any]]] = {
    "DigitalAudio": ServiceEntry(AudioContext, lambda context: iop.DigitalAudio(context.devices, context.opus)),
    "DigitalResourceDiscovery": ServiceEntry(
        AudioContext,
        lambda context: DigitalResourceDiscovery(context.opus) if context.devices.microphones else None,
        needs=MICROPHONES,
    ),
    "AEODRSDigitalAudioSensor": ServiceEntry(
        AudioContext,
        lambda context: (
            iop.DigitalAudioSensor(context.devices, context.telephony) if context.devices.microphones else None
        ),
        needs=MICROPHONES,
    ),
    "DigitalAudioAnnunciator": ServiceEntry(
        AudioContext,
        lambda context: iop.DigitalAudioAnnunciator(context.devices) if context.devices.loudspeakers else None,
        needs=LOUDSPEAKERS,
    ),
    "AEODRSDigitalAudioAnnunciator": ServiceEntry(
        AudioContext,
        lambda context: iop.AnnunciatorStreams(context.devices) if context.devices.loudspeakers else None,
        needs=LOUDSPEAKERS,
    ),
}


class Audio(Kind[AudioContext]):
    """The kind CM-AUD."""

    type: ClassVar[str] = "CM-AUD"
    services: ClassVar[Mapping[str, ServiceEntry[Any]]] = SERVICES

    def context(self, build: ModuleBuild) -> AudioContext:
        """All microphones and loudspeakers of the robot, in the order of its file."""
        microphones = dict(enumerate(build.shared.microphones, start=1))
        loudspeakers = dict(enumerate(build.shared.loudspeakers, start=1 + len(microphones)))
        streams = [
            MediaStreams(
                {number: CodedMicrophone(microphone, coding) for number, microphone in microphones.items()},
                build.video_targets,
            )
            for coding in (Coding.OPUS, Coding.PCMU)
        ]
        return AudioContext(build.robot, SoundDevices(microphones, loudspeakers, build.video_targets), *streams)
