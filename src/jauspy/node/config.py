"""The settings of a node manager, with their defaults.

The docstring under each setting is its comment in what `jauspy node-manager --print-config` prints.
"""

from __future__ import annotations

from collections import Counter
from pathlib import Path
from typing import Any, Literal, Self

from pydantic import Field, ValidationError, model_validator

from jauspy.errors import ConfigError
from jauspy.node.addresses import Entries, entries, load
from jauspy.node.explain import explain
from jauspy.node.settings import (
    Addresses,
    Group,
    Group6,
    HostPort,
    IdPattern,
    Interface,
    IPv4,
    IPv6,
    MessageName,
    Mirror,
    Mode,
    Name,
    Settings,
)
from jauspy.protocol import judp
from jauspy.protocol.address_book import ADDRESS_LIFETIME
from jauspy.protocol.addressing import DEFAULT_NETWORK
from jauspy.transport.multicast import ANY, RECEIVE_BUFFER
from jauspy.transport.serial_link import SerialLine


class NetworkConfig(Settings):
    """A network that the node manager is on."""

    name: Name = DEFAULT_NETWORK
    """What rules, counters and the status call this network."""
    address: IPv4 = ANY
    """Local address to receive on; 0.0.0.0 is all. With several networks each needs an address of its own."""
    port: int = Field(default=judp.PORT, ge=0, le=65535)
    """UDP port, here and of the others on this network; 3794 is registered for JAUS. 0 takes any free port."""
    multicast_group: Group = judp.MULTICAST_GROUP
    """Group that broadcasts, and questions for unknown ids, are sent to."""
    multicast_ttl: int = Field(default=judp.MULTICAST_TTL, ge=0, le=255)
    """How many routers a multicast may pass."""
    multicast_interfaces: tuple[Interface, ...] = ()
    """Interfaces to join on and send by: addresses, names, or "all"; they may come and go. Empty: the one of `address`,
    or the kernel's choice."""
    address6: IPv6 | None = Field(default=None, examples=["::"])
    """IPv6 address to speak JUDP on as well, on the same port."""
    multicast_group6: Group6 | None = Field(default=None, examples=["ff15::6a61:7573"])
    """Group for IPv6 multicasts, beside `multicast_group`; needs `address6`. None is registered for JAUS."""
    key_file: Path | None = Field(default=None, examples=["/etc/jauspy/lan.key"])
    """File with a key of at least 16 bytes that all node managers of this network share. With it every packet is
    authenticated, and packets of others are dropped: only jauspy speaks this. See docs/security.md."""

    @property
    def interfaces(self) -> tuple[str, ...]:
        """Where multicasts leave and arrive."""
        return self.multicast_interfaces or (self.address,)

    @model_validator(mode="after")
    def _check_ipv6(self) -> Self:
        if self.multicast_group6 is not None and self.address6 is None:
            raise ValueError('multicast_group6: needs IPv6; set `address6`, as in address6 = "::"')
        return self


class RuleConfig(Settings):
    """One rule of a gateway; it goes for packets that match all of it."""

    action: Literal["allow", "deny"] = "allow"
    """What becomes of a packet that matches."""
    source: IdPattern = "*.*.*"
    """Ids that it comes from; * is any."""
    destination: IdPattern = "*.*.*"
    """Ids that it is for; broadcasts match only *.*.*, or the same wildcards."""
    network: Name | None = Field(default=None, examples=["lan"])
    """Network that it comes from; left out: every network outside."""
    messages: tuple[MessageName, ...] | None = Field(
        default=None, examples=[["SetWrenchEffort", "0x0405", "0x2000-0x2FFF"]]
    )
    """Messages by name, id or range of ids; left out: all. Acknowledgements match any of them."""
    rate: float | None = Field(default=None, gt=0, examples=[100.0])
    """Messages per second from each source that it allows; what is more is dropped."""


class GatewayConfig(Settings):
    """What crosses between the networks of this node manager."""

    subsystem: int = Field(ge=1, le=65534, examples=[101])
    """The subsystem whose ids are forwarded."""
    inside: tuple[Name, ...] = Field(default=(), examples=[["vehicle"]])
    """The networks inside the subsystem; all others are outside. The components of this machine are inside, too."""
    rules: tuple[RuleConfig, ...] = ()
    """The first that matches decides. With rules, what comes from outside and matches none is dropped; without any,
    everything addressed to the subsystem may enter. What is not addressed to it never does."""


class SerialConfig(Settings):
    """A serial line, with 8 data bits."""

    device: str = Field(examples=["/dev/ttyUSB0"])
    """The device."""
    baud_rate: int = Field(default=19200, gt=0)
    """Bits per second."""
    parity: Literal["N", "E", "O"] = "N"
    """None, even or odd."""
    stop_bits: Literal[1, 2] = 1
    """Stop bits."""
    hardware_flow_control: bool = False
    """RTS and CTS."""
    software_flow_control: bool = False
    """XON and XOFF."""

    @property
    def line(self) -> SerialLine:
        """What the transport wants to know."""
        return SerialLine(**self.model_dump())


class NodeConfig(NetworkConfig):
    """What a node manager binds, joins, allows and tells. The settings of its first network stand at the top."""

    local_root: Path = Path("/tmp")  # noqa: S108  # where the standard's components look for it
    """Folder of the local sockets. The JAUS Toolset's components know only /tmp."""
    local_mode: Mode = 0o660
    """Who may connect as a component: permissions of the local socket. 0o660: the same user and group."""
    local_group: str | None = Field(default=None, examples=["jaus"])
    """Group that owns the local sockets; left out: the one that the node manager runs with."""
    networks: tuple[NetworkConfig, ...] = Field(
        default=(), examples=[NetworkConfig(name="vehicle", address="192.168.50.1")]
    )
    """Further networks. Without [gateway] nothing crosses between networks."""
    gateway: GatewayConfig | None = Field(
        default=None,
        examples=[
            GatewayConfig(subsystem=101, inside=("vehicle",), rules=(RuleConfig(source="42.*.*", rate=500.0),)),
        ],
    )
    """Makes the node manager a gateway between the networks inside and outside of a subsystem, and a filter before
    its own components."""
    source_check: bool = True
    """Drop packets whose source id was heard from another host or network in the last 30 s."""
    rate_limit: float = Field(default=0.0, ge=0)
    """Messages per second that each source id may send; 0 is no limit. Safety-critical ones have the same once more."""
    rate_burst: float = Field(default=1000.0, ge=1)
    """Messages that a source may send at once under `rate_limit`."""
    local_udp: bool = True
    """Let components of this machine connect by UDP, as those of ROS/IOP do."""
    header_compression: Literal["off", "accept", "propose"] = "accept"
    """Compressed headers on UDP. accept: take what peers propose, and compress for those that do. propose: ask all
    peers, with an empty packet that those who know nothing of it misread and drop. off: read past proposals."""
    tcp: bool = False
    """Take JTCP connections. TCP peers among the addresses are connected to in any case."""
    tcp_port: int | None = Field(default=None, ge=0, le=65535, examples=[3794])
    """TCP port on `address` and `address6`; left out: the same as `port`."""
    serial: tuple[SerialConfig, ...] = Field(default=(), examples=[SerialConfig(device="/dev/ttyUSB0")])
    """Serial lines that speak JSerial; needs the extra `serial`. They and JTCP belong to the first network."""
    addresses: Addresses = Field(default_factory=dict)
    """Where ids are that multicast does not find, as in "101.1.255" = "udp://10.0.0.5:3794"; 65535 and 255 are
    wildcards, tcp:// and serial: are other ways, and a list is several. They get copies of broadcasts, too."""
    address_books: tuple[Path, ...] = Field(default=(), examples=[("/etc/jauspy/nm.cfg",)])
    """Files with more addresses: TOML with a table [addresses], nm.cfg of the JAUS Toolset, or FKIE's YAML."""
    address_lifetime: float = Field(default=ADDRESS_LIFETIME, gt=0)
    """Seconds of silence after which a learned address is forgotten, and asked for again."""
    receive_buffer: int = Field(default=RECEIVE_BUFFER, ge=4096, le=1 << 30)
    """Bytes of each UDP receive buffer; the kernel gives at most net.core.rmem_max."""
    status: bool = True
    """Answer `jauspy node-manager --status` on the local socket JuniorRTE.status."""
    metrics: HostPort | None = Field(default=None, examples=["127.0.0.1:9794"])
    """Address where Prometheus gets metrics by HTTP."""
    mirror: Mirror | None = Field(default=None, examples=["/var/log/jauspy/all.pcapng"])
    """Copy all routed packets to a pcapng file, or as pcapng datagrams to udp:ADDRESS:PORT."""
    mirror_limit: int = Field(default=1 << 30, ge=4096)
    """Bytes after which the mirror's file ends."""
    log: Literal["text", "json"] = "text"
    """Form of the log on stderr."""
    log_level: Literal["debug", "info", "warning", "error"] = "warning"
    """How much is logged; debug tells the first drop of each reason."""

    @classmethod
    def make(cls, **settings: Any) -> NodeConfig:
        """Check settings from outside; raises `ConfigError` with one sentence per mistake."""
        try:
            return cls(**settings)
        except ValidationError as error:
            told = (explain(problem, cls) for problem in error.errors(include_url=False))
            raise ConfigError(f"node manager setting {'; '.join(told)}") from None

    def known_addresses(self) -> Entries:
        """All entries of `addresses` and `address_books`; raises `ConfigError` that names the file."""
        found = {id: list(ports) for id, ports in entries(self.addresses).items()}
        for path in self.address_books:
            for id, ports in load(path).items():
                found.setdefault(id, []).extend(ports)
        return {
            id: tuple(dict.fromkeys(port._replace(network=self.name) for port in ports)) for id, ports in found.items()
        }

    @property
    def all_networks(self) -> tuple[NetworkConfig, ...]:
        """The first network, and the others."""
        return (self, *self.networks)

    @model_validator(mode="after")
    def _check_networks(self) -> Self:
        for name, count in Counter(network.name for network in self.all_networks).items():
            if count > 1:
                raise ValueError(f"networks: {count} are named {name!r}; give each its own `name`")
        ports = Counter(network.port for network in self.all_networks if network.port)
        for network in self.all_networks:
            if network.address == ANY and ports[network.port] > 1:
                raise ValueError(f"networks: {network.name!r} has all of port {network.port}; give it an `address`")
        return self

    @model_validator(mode="after")
    def _check_gateway(self) -> Self:
        known = {network.name for network in self.all_networks}
        rules = self.gateway.rules if self.gateway else ()
        named = {*(self.gateway.inside if self.gateway else ()), *(rule.network for rule in rules if rule.network)}
        if named - known:
            raise ValueError(
                f"gateway: there is no network {sorted(named - known)[0]!r}; known are: {', '.join(sorted(known))}"
            )
        return self
