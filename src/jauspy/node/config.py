"""The settings of a node manager, with their defaults."""

from __future__ import annotations

import ipaddress
from collections.abc import Mapping
from pathlib import Path
from typing import Annotated, Any

from pydantic import AfterValidator, BaseModel, ConfigDict, Field, ValidationError

from jauspy.errors import ConfigError
from jauspy.node.addresses import Entries, entries, load
from jauspy.protocol import judp
from jauspy.protocol.address_book import LIFETIME
from jauspy.transport.multicast import ANY
from jauspy.transport.serial_link import SerialLine


def _ipv4(text: str) -> str:
    try:
        return str(ipaddress.IPv4Address(text))
    except ValueError:
        raise ValueError("write an IPv4 address, as in 192.168.1.10") from None


def _group(text: str) -> str:
    if not ipaddress.IPv4Address(_ipv4(text)).is_multicast:
        raise ValueError("write an IPv4 multicast address, as in 239.255.0.1")
    return text


def _ipv6(text: str) -> str:
    try:
        return str(ipaddress.IPv6Address(text))
    except ValueError:
        raise ValueError("write an IPv6 address, as in fd00::1, or :: for all") from None


def _interface(text: str) -> str:
    if text and not text[0].isdigit():
        return text
    return _ipv4(text)


def _addresses(table: Mapping[str, Any]) -> Mapping[str, Any]:
    try:
        entries(table)
    except ConfigError as error:
        raise ValueError(str(error)) from None
    return table


IPv4 = Annotated[str, AfterValidator(_ipv4)]


class NodeConfig(BaseModel):
    """What a node manager binds and joins. Port 0 takes any free port."""

    model_config = ConfigDict(frozen=True, extra="forbid")

    address: IPv4 = ANY
    port: int = Field(default=judp.PORT, ge=0, le=65535)
    local_root: Path = Path("/tmp")  # noqa: S108  # where the standard's components look for it
    local_mode: int = Field(default=0o660, ge=0, le=0o777)
    multicast_group: Annotated[str, AfterValidator(_group)] = judp.MULTICAST_GROUP
    multicast_ttl: int = Field(default=judp.MULTICAST_TTL, ge=0, le=255)
    multicast_interfaces: tuple[Annotated[str, AfterValidator(_interface)], ...] = ()
    """Interfaces to join on and send by: IPv4 addresses, names, or "all". Empty: the one of `address`, or the kernel's
    choice. They may come and go."""

    address6: Annotated[str, AfterValidator(_ipv6)] | None = None
    """An IPv6 address to speak JUDP on as well, without multicast."""
    local_udp: bool = True
    """Whether components of this machine may connect by UDP, as ROS/IOP's do."""
    tcp: bool = False
    """Whether to take JTCP connections. Peers of the address book are connected to in any case."""
    tcp_port: int | None = Field(default=None, ge=0, le=65535)
    """By default the same as `port`."""
    serial: tuple[SerialLine, ...] = ()
    addresses: Annotated[Mapping[str, Any], AfterValidator(_addresses)] = Field(default_factory=dict)
    """Addresses by id, which may have wildcards: "101.1.255" = "udp://10.0.0.5:3794", or a list of such addresses."""
    address_books: tuple[Path, ...] = ()
    """Files with more of them: our TOML, nm.cfg of the JAUS Toolset, or FKIE's YAML."""
    address_lifetime: float = Field(default=LIFETIME, gt=0)
    """Seconds of silence after which a learned address is forgotten."""

    @classmethod
    def make(cls, **settings: Any) -> NodeConfig:
        """Check settings from outside; raises `ConfigError` with one sentence per mistake."""
        try:
            return cls(**settings)
        except ValidationError as error:
            told = (f"{'.'.join(map(str, e['loc']))} = {e['input']!r}: {_plain(e['msg'])}" for e in error.errors())
            raise ConfigError(f"node manager setting {'; '.join(told)}") from None

    def known_addresses(self) -> Entries:
        """All entries of `addresses` and `address_books`; raises `ConfigError` that names the file."""
        found = {id: list(ports) for id, ports in entries(self.addresses).items()}
        for path in self.address_books:
            for id, ports in load(path).items():
                found.setdefault(id, []).extend(ports)
        return {id: tuple(dict.fromkeys(ports)) for id, ports in found.items()}

    @property
    def interfaces(self) -> tuple[str, ...]:
        """Where multicasts leave and arrive."""
        return self.multicast_interfaces or (self.address,)


def _plain(message: str) -> str:
    return message.removeprefix("Value error, ")
