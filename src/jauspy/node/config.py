"""The settings of a node manager, with their defaults."""

from __future__ import annotations

import ipaddress
from pathlib import Path
from typing import Annotated, Any

from pydantic import AfterValidator, BaseModel, ConfigDict, Field, ValidationError

from jauspy.errors import ConfigError
from jauspy.protocol import judp
from jauspy.transport.multicast import ANY


def _ipv4(text: str) -> str:
    try:
        return str(ipaddress.IPv4Address(text))
    except ValueError:
        raise ValueError("write an IPv4 address, as in 192.168.1.10") from None


def _group(text: str) -> str:
    if not ipaddress.IPv4Address(_ipv4(text)).is_multicast:
        raise ValueError("write an IPv4 multicast address, as in 239.255.0.1")
    return text


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
    multicast_interfaces: tuple[IPv4, ...] = ()
    """IPv4 addresses of the interfaces to join on and send by; empty: the one of `address`, or the kernel's choice."""

    @classmethod
    def make(cls, **settings: Any) -> NodeConfig:
        """Check settings from outside; raises `ConfigError` with one sentence per mistake."""
        try:
            return cls(**settings)
        except ValidationError as error:
            told = (f"{'.'.join(map(str, e['loc']))} = {e['input']!r}: {_plain(e['msg'])}" for e in error.errors())
            raise ConfigError(f"node manager setting {'; '.join(told)}") from None

    @property
    def interfaces(self) -> tuple[str, ...]:
        """Where multicasts leave and arrive."""
        return self.multicast_interfaces or (self.address,)


def _plain(message: str) -> str:
    return message.removeprefix("Value error, ")
