"""Microphones and loudspeakers of a component, as its services see them: one numbering, and the machines of clients."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import Final

from jauspy.errors import ConfigError
from jauspy.platform.sound import Address, Coding, Loudspeaker, Microphone
from jauspy.protocol.addressing import Location
from jauspy.services.environment_sensing.digital_resource_discovery import Network

LOOPBACK: Final = frozenset({"127.0.0.1", "::1"})


@dataclass(frozen=True, slots=True)
class SoundDevices:
    """Devices by the numbers that services use: microphones from 1, then loudspeakers."""

    microphones: Mapping[int, Microphone]
    loudspeakers: Mapping[int, Loudspeaker]
    targets: tuple[Network, ...] = ()
    """Networks with which any client may exchange sound, beside its own machine."""

    @property
    def all(self) -> Mapping[int, Microphone | Loudspeaker]:
        """All devices."""
        return {**self.microphones, **self.loudspeakers}


@dataclass(frozen=True, slots=True)
class CodedMicrophone:
    """A microphone as a source of streams of one coding."""

    microphone: Microphone
    coding: Coding

    def watch(self, address: Address, *, playing: bool = True) -> None:
        """Send to an address, or pause it; raises `ConfigError` if there are too many."""
        self.microphone.watch(address, playing=playing, coding=self.coding)

    def leave(self, address: Address) -> None:
        """Stop sending to an address."""
        self.microphone.leave(address)


def hosts_of(location: Location) -> frozenset[str]:
    """The addresses from which a client's packets come; raises `ConfigError` if its machine is not known."""
    hosts = location.hosts | LOOPBACK if location.is_here else location.hosts
    if not hosts:
        raise ConfigError("the machine of the client is not known")
    return hosts


def address_of(location: Location) -> str:
    """One address of a client's machine; raises `ConfigError` if it is not known."""
    return "127.0.0.1" if location.is_here else min(hosts_of(location))


def chosen(number: int, known: Iterable[int]) -> list[int]:
    """The devices that a query asks for: one, or all for 0; none for an unknown one."""
    return [device for device in known if number in (0, device)]
