"""The settings of a node manager, with their defaults, its TOML file, and the gateway, limits and keys they describe.

The docstring of each setting is its comment in the output of `jauspy node-manager --print-config`.
"""

from __future__ import annotations

import ipaddress
import json
import re
import secrets
import stat
import textwrap
from collections import Counter
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Annotated, Any, Final, Literal, Self

from pydantic import AfterValidator, BaseModel, BeforeValidator, ConfigDict, Field, ValidationError, model_validator
from pydantic.fields import FieldInfo

from jauspy.config_errors import explain, line_prefix, models_in
from jauspy.errors import ConfigError
from jauspy.ids import JausID
from jauspy.messages import registry
from jauspy.node.address_books import AddressEntries, load_address_book, parse_entries
from jauspy.node.link_limits import make_link_limit, parse_codes
from jauspy.protocol import authentication, judp
from jauspy.protocol.address_book import ADDRESS_LIFETIME, MAX_IDS, MAX_IDS_PER_HOST, IdBounds
from jauspy.protocol.addressing import DEFAULT_NETWORK
from jauspy.protocol.authentication import Authenticator
from jauspy.protocol.gateway import Gateway, GatewayRule, GatewayRules
from jauspy.protocol.link_limits import LinkLimit
from jauspy.protocol.sources import SourceLimits
from jauspy.transport.age import MAX_AGE
from jauspy.transport.multicast import ANY, RECEIVE_BUFFER
from jauspy.transport.serial import SerialLine
from jauspy.user_files import read_file, read_toml

MAX_SUBSYSTEM: Final = 65534
MAX_SUBSYSTEM_RANGES: Final = 64
"""Entries of `further_subsystems`: each packet is compared with them."""
_SUBSYSTEMS: Final = re.compile(r"(\d{1,5})(?:-(\d{1,5}))?", re.ASCII)


class NodeSettings(BaseModel):
    """Frozen, without unknown keys; the docstring of each field is its comment in the configuration file."""

    model_config = ConfigDict(frozen=True, extra="forbid", use_attribute_docstrings=True)


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


def _group6(text: str) -> str:
    if not ipaddress.IPv6Address(_ipv6(text)).is_multicast:
        raise ValueError("write an IPv6 multicast address, as in ff15::6a61:7573")
    return _ipv6(text)


def _interface(text: str) -> str:
    if ":" in text:
        return _ipv6(text)
    return text if text and not text[0].isdigit() else _ipv4(text)


def _addresses(table: Mapping[str, Any]) -> Mapping[str, Any]:
    try:
        parse_entries(table)
    except ConfigError as error:
        raise ValueError(str(error)) from None
    return table


def _limits(table: Mapping[str, str]) -> Mapping[str, str]:
    try:
        make_link_limit(table)
    except ConfigError as error:
        raise ValueError(str(error)) from None
    return table


def _host_port(text: str) -> str:
    host, colon, port = text.rpartition(":")
    if not colon or not port.isdecimal() or not 0 <= int(port) <= 65535:
        raise ValueError("write ADDRESS:PORT, as in 127.0.0.1:9794")
    return f"{_ipv4(host)}:{int(port)}"


def _mode(number: int) -> int:
    if not 0 <= number <= 0o777:
        raise ValueError("write three octal digits, as in 0o660")
    return number


def _mirror(text: str) -> str:
    return f"udp:{_host_port(text[4:])}" if text.startswith("udp:") else text


def _id_pattern(text: str) -> str:
    parse_pattern(text)
    return text


def _message(value: object) -> object:
    """Accept a number in place of its hexadecimal form."""
    return f"0x{value:04X}" if isinstance(value, int) and 0 <= value <= 0xFFFF else value


def parse_subsystems(text: str) -> range:
    """The subsystems of `102` or `102-120`; raises `ValueError`."""
    found = _SUBSYSTEMS.fullmatch(text)
    first, last = (int(found[1]), int(found[2] or found[1])) if found is not None else (0, 0)
    if not 1 <= first <= last <= MAX_SUBSYSTEM:
        raise ValueError(f"write a subsystem or a range of them from 1 to {MAX_SUBSYSTEM}, as in 102-120")
    return range(first, last + 1)


def _subsystems(text: str) -> str:
    parse_subsystems(text)
    return text


def _number(value: object) -> object:
    """Accept a number in place of its text."""
    return str(value) if type(value) is int else value


def parse_pattern(text: str) -> JausID:
    """The id with wildcards for a pattern such as `42.*.*`; raises `ValueError`."""
    parts = text.split(".")
    if len(parts) == 3:
        parts = [top if part == "*" else part for part, top in zip(parts, ("65535", "255", "255"), strict=True)]
    try:
        return JausID.parse(".".join(parts))
    except ConfigError:
        raise ValueError("write SUBSYSTEM.NODE.COMPONENT with * for any, as in 42.*.*") from None


IPv4 = Annotated[str, AfterValidator(_ipv4)]
IPv6 = Annotated[str, AfterValidator(_ipv6)]
Interface = Annotated[str, AfterValidator(_interface)]
Addresses = Annotated[Mapping[str, str | list[str]], AfterValidator(_addresses)]
Limits = Annotated[Mapping[str, str], AfterValidator(_limits)]
Group = Annotated[str, AfterValidator(_group)]
Group6 = Annotated[str, AfterValidator(_group6)]
HostPort = Annotated[str, AfterValidator(_host_port)]
Mirror = Annotated[str, AfterValidator(_mirror)]
Name = Annotated[str, Field(pattern=r"^[A-Za-z0-9_-]{1,32}$")]
IdPattern = Annotated[str, AfterValidator(_id_pattern)]
Subsystems = Annotated[str, BeforeValidator(_number), AfterValidator(_subsystems)]
MessageName = Annotated[str, BeforeValidator(_message)]
Mode = Annotated[int, AfterValidator(_mode), Field(json_schema_extra={"octal": True})]


class NetworkConfig(NodeSettings):
    """A network that the node manager is on."""

    name: Name = DEFAULT_NETWORK
    """Name of this network in rules, counters and the status."""
    address: IPv4 = ANY
    """Local address to receive on; 0.0.0.0 is all addresses. With several networks, each needs its own address."""
    port: int = Field(default=judp.PORT, ge=0, le=65535)
    """UDP port of all node managers on this network; 3794 is registered for JAUS. 0 selects any free port."""
    multicast_group: Group = judp.MULTICAST_GROUP
    """Multicast group for broadcasts, and for probes for unknown ids."""
    multicast_ttl: int = Field(default=judp.MULTICAST_TTL, ge=0, le=255)
    """Maximum number of routers that a multicast may pass."""
    multicast_interfaces: tuple[Interface, ...] = ()
    """Interfaces on which the group is joined and multicasts are sent: addresses, names, or "all"; they may
    be absent at times. Empty: the interface of `address`, or the kernel's choice."""
    address6: IPv6 | None = Field(default=None, examples=["::"])
    """IPv6 address for JUDP, in addition to `address`, on the same port."""
    multicast_group6: Group6 | None = Field(default=None, examples=["ff15::6a61:7573"])
    """Group for IPv6 multicasts, in addition to `multicast_group`; needs `address6`. None is registered for JAUS."""
    key_file: Path | None = Field(default=None, examples=["/etc/jauspy/lan.key"])
    """File with a key of at least 16 bytes that all node managers of this network share. Every packet is then
    authenticated, and other packets are dropped. Only jauspy supports this. See docs/security.md."""

    limit: Limits = Field(default_factory=dict)
    """What this network carries: "all" in bits per second, and messages in bits per second, or in messages per second
    from one component to another, as in "all" = "250 kbit/s", "ReportLocalPose" = "5/s", "0x4A00-0x4AFF" =
    "100 kbit/s". Safety-critical packets always pass, first. See docs/node-manager.md."""

    @property
    def interfaces(self) -> tuple[str, ...]:
        """The interfaces for multicasts."""
        return self.multicast_interfaces or (self.address,)

    @model_validator(mode="after")
    def _check_ipv6(self) -> Self:
        if self.multicast_group6 is not None and self.address6 is None:
            raise ValueError('multicast_group6: needs IPv6; set `address6`, as in address6 = "::"')
        return self


class RuleConfig(NodeSettings):
    """One rule of a gateway; it applies to packets that match all of its conditions."""

    action: Literal["allow", "deny"] = "allow"
    """`allow` forwards matching packets, `deny` drops them."""
    source: IdPattern = "*.*.*"
    """Source ids; * is any."""
    destination: IdPattern = "*.*.*"
    """Destination ids; broadcasts match only *.*.*, or the same wildcards."""
    network: Name | None = Field(default=None, examples=["lan"])
    """Network of origin; omitted: every network outside."""
    messages: tuple[MessageName, ...] | None = Field(
        default=None, examples=[["SetWrenchEffort", "0x0405", "0x2000-0x2FFF"]]
    )
    """Messages by name, id or range of ids; omitted: all. Acknowledgements match any of them."""
    rate: float | None = Field(default=None, gt=0, examples=[100.0])
    """Messages per second allowed from each source; further ones are dropped."""


class GatewayConfig(NodeSettings):
    """Forwarding between the networks of this node manager."""

    subsystem: int = Field(ge=1, le=MAX_SUBSYSTEM, examples=[101])
    """The subsystem whose ids are forwarded."""
    further_subsystems: tuple[Subsystems, ...] = Field(
        default=(), max_length=MAX_SUBSYSTEM_RANGES, examples=[["102-120", "42"]]
    )
    """Further subsystems inside, or ranges of them, where this is the gateway of a site with several robots or
    operators. See docs/sites.md."""
    inside: tuple[Name, ...] = Field(default=(), examples=[["vehicle"]])
    """The networks inside the subsystem; all others are outside. The components of this machine are inside."""
    rules: tuple[RuleConfig, ...] = ()
    """The first matching rule decides. With rules, packets from outside that match none are dropped; without rules, all
    packets addressed to the subsystem may enter. Packets that are not addressed to it never enter."""


class SerialConfig(NodeSettings):
    """A serial line, with 8 data bits."""

    device: str = Field(examples=["/dev/ttyUSB0"])
    """Path of the device."""
    baud_rate: int = Field(default=19200, gt=0)
    """Bits per second."""
    parity: Literal["N", "E", "O"] = "N"
    """Parity: none, even or odd."""
    stop_bits: Literal[1, 2] = 1
    """Number of stop bits."""
    hardware_flow_control: bool = False
    """Flow control by RTS and CTS."""
    software_flow_control: bool = False
    """Flow control by XON and XOFF."""
    limit: Limits = Field(default_factory=dict)
    """What this line carries, as `limit` of a network says it: what a radio modem sends on, if it is less than the
    line."""

    @property
    def line(self) -> SerialLine:
        """The settings for the transport."""
        return SerialLine(**self.model_dump(exclude={"limit"}))


class NodeConfig(NetworkConfig):
    """The configuration of a node manager. The settings of its first network are at the top level."""

    local_root: Path = Path("/tmp")  # noqa: S108 # nosec B108 # where the standard's components look for it
    """Directory of the local sockets. Components of the JAUS Toolset use /tmp only."""
    local_mode: Mode = 0o660
    """Permissions of the local socket: who may connect as a component. 0o660: the same user and group."""
    local_group: str | None = Field(default=None, examples=["jaus"])
    """Group that owns the local sockets; omitted: that of the node manager's process."""
    networks: tuple[NetworkConfig, ...] = Field(
        default=(), examples=[NetworkConfig(name="vehicle", address="192.168.50.1")]
    )
    """Further networks. Without [gateway], nothing is forwarded between networks."""
    gateway: GatewayConfig | None = Field(
        default=None,
        examples=[
            GatewayConfig(subsystem=101, inside=("vehicle",), rules=(RuleConfig(source="42.*.*", rate=500.0),)),
        ],
    )
    """Makes the node manager a gateway between the networks inside and outside of a subsystem, and a filter for its own
    components."""
    source_check: bool = True
    """Drop packets whose source id was heard from another host or network in the last 30 s."""
    rate_limit: float = Field(default=0.0, ge=0)
    """Messages per second that each source id may send; 0 is no limit. Safety-critical messages have a separate budget
    of the same size."""
    rate_burst: float = Field(default=1000.0, ge=1)
    """Messages that a source may send in a burst under `rate_limit`."""
    max_message_age: float = Field(default=MAX_AGE, ge=0)
    """Seconds for which a command may wait in a socket or queue of the node manager. An older one is dropped, unless it
    is acknowledged: it may be from an operator who has left. 0 is no limit."""
    local_udp: bool = True
    """Allow components of this machine to connect by UDP, as those of ROS/IOP do, if their user may use the local
    socket."""
    own_ids: tuple[IdPattern, ...] = Field(default=(), examples=[("101.1.*",)])
    """Ids of this machine's components: packets from networks that have them are dropped, also while no component is
    connected with them. Any other id belongs to the host that uses it first, until that host is silent for 30 s."""
    header_compression: Literal["off", "accept", "propose"] = "accept"
    """Header compression on UDP. accept: accept proposals, and compress for peers that propose. propose: probe all
    peers with an empty packet, which peers without compression drop as malformed. off: ignore proposals."""
    tcp: bool = False
    """Accept JTCP connections. TCP peers among the addresses are connected to in any case."""
    tcp_port: int | None = Field(default=None, ge=0, le=65535, examples=[3794])
    """TCP port on `address` and `address6`; omitted: the same as `port`."""
    serial: tuple[SerialConfig, ...] = Field(default=(), examples=[SerialConfig(device="/dev/ttyUSB0")])
    """Serial lines with JSerial; needs the extra `serial`. They and JTCP belong to the first network."""
    addresses: Addresses = Field(default_factory=dict)
    """Addresses of ids that multicast does not reach, as in "101.1.255" = "udp://10.0.0.5:3794", or with tcp:// or
    serial:, or a list of these; 65535 and 255 are wildcards. Broadcasts are sent to them as well."""
    address_books: tuple[Path, ...] = Field(default=(), examples=[("/etc/jauspy/nm.cfg",)])
    """Files with further addresses: TOML with a table [addresses], nm.cfg of the JAUS Toolset, or YAML of FKIE."""
    address_lifetime: float = Field(default=ADDRESS_LIFETIME, gt=0)
    """Seconds without a packet after which a learned address expires."""
    max_ids: int = Field(default=MAX_IDS, ge=64, le=1 << 20)
    """Ids on networks whose addresses and rates are remembered: at least the components of all robots and operators.
    Beyond that the one heard longest ago is forgotten, and searched by multicast again. Each needs about 0.6 kB."""
    max_ids_per_host: int = Field(default=MAX_IDS_PER_HOST, ge=64, le=1 << 20)
    """Ids of one host among these, so that one host cannot displace all others. A gateway of many robots needs more."""
    receive_buffer: int = Field(default=RECEIVE_BUFFER, ge=4096, le=1 << 30)
    """Bytes of each UDP receive buffer; the kernel grants at most net.core.rmem_max."""
    queue_memory: int = Field(default=64 << 20, ge=1 << 20)
    """Bytes of all queues for components and connections together; the longest queue loses its oldest messages of the
    lowest priority first."""
    status: bool = True
    """Serve `jauspy node-manager --status` on the local socket JuniorRTE.status."""
    metrics: HostPort | None = Field(default=None, examples=["127.0.0.1:9794"])
    """Address of the HTTP server for Prometheus metrics."""
    mirror: Mirror | None = Field(default=None, examples=["/var/log/jauspy/all.pcapng"])
    """Copy all routed packets to a pcapng file, or as pcapng datagrams to udp:ADDRESS:PORT."""
    mirror_limit: int = Field(default=1 << 30, ge=4096)
    """Maximum size of the mirror's file in bytes."""
    mirror_socket: bool = True
    """Copy all routed packets to the readers of the local socket JuniorRTE.mirror, such as `jauspy echo`."""
    log: Literal["text", "json"] = "text"
    """Format of the log on stderr."""
    log_level: Literal["debug", "info", "warning", "error"] = "warning"
    """Log level; debug includes the first drop of each reason."""

    @classmethod
    def make(cls, **settings: Any) -> NodeConfig:
        """The configuration with these settings; raises `ConfigError` with one sentence per mistake."""
        try:
            return cls(**settings)
        except ValidationError as error:
            problems = (explain(problem, cls) for problem in error.errors(include_url=False))
            raise ConfigError(f"node manager setting {'; '.join(problems)}") from None

    def known_addresses(self) -> AddressEntries:
        """All static addresses, those of `addresses` and `address_books`; raises `ConfigError` that names the file."""
        found = {id: list(ports) for id, ports in parse_entries(self.addresses).items()}
        for path in self.address_books:
            for id, ports in load_address_book(path).items():
                found.setdefault(id, []).extend(ports)
        return {
            id: tuple(dict.fromkeys(port._replace(network=self.name) for port in ports)) for id, ports in found.items()
        }

    @property
    def link_limits(self) -> dict[str, LinkLimit]:
        """The limits of links that have some, by the name of the network or the device of the serial line."""
        links = [(network.name, network.limit) for network in self.all_networks]
        links += [(line.device, line.limit) for line in self.serial]
        return {name: make_link_limit(limit) for name, limit in links if limit}

    @property
    def id_bounds(self) -> IdBounds:
        """The bounds of tables of ids."""
        return IdBounds(self.max_ids, self.max_ids_per_host)

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


def load_key(path: Path | None) -> Authenticator | None:
    """An authenticator with the key in this file, without surrounding white space; None without a file.

    Raises `ConfigError` when the key is too short, or readable for all users.
    """
    if path is None:
        return None
    try:
        mode = path.stat().st_mode
        key = read_file(path).strip()
    except OSError as error:
        raise ConfigError(f"key_file {path}: {error.strerror}") from error
    except ConfigError as error:
        raise ConfigError(f"key_file {error}") from None
    if mode & stat.S_IROTH:
        raise ConfigError(f"key_file {path}: all users may read it; do: chmod o-rwx {path}")
    if len(key) < authentication.MIN_KEY_LENGTH:
        raise ConfigError(
            f"key_file {path}: has {len(key)} bytes, needs {authentication.MIN_KEY_LENGTH}; "
            "make one with: openssl rand -hex 32"
        )
    return Authenticator(key, secrets.randbits(64))


def source_limits(config: NodeConfig) -> SourceLimits:
    """The limits of sources."""
    return SourceLimits(check_address=config.source_check, rate=config.rate_limit, burst=config.rate_burst)


def make_gateway(config: NodeConfig) -> Gateway | None:
    """The gateway, or None without one; raises `ConfigError` for an unknown message."""
    settings = config.gateway
    if settings is None:
        return None
    rules = GatewayRules(
        [_make_rule(number, rule) for number, rule in enumerate(settings.rules)], inside=settings.inside
    )
    subsystems = [
        range(settings.subsystem, settings.subsystem + 1),
        *map(parse_subsystems, settings.further_subsystems),
    ]
    return Gateway(subsystems, [network.name for network in config.all_networks], settings.inside, rules)


def _make_rule(number: int, config: RuleConfig) -> GatewayRule:
    return GatewayRule(
        allow=config.action == "allow",
        source=parse_pattern(config.source),
        destination=parse_pattern(config.destination),
        network=config.network,
        messages=None
        if config.messages is None
        else tuple(_message_ids(number, message) for message in config.messages),
        rate=config.rate,
    )


def _message_ids(number: int, text: str) -> range:
    codes = parse_codes(text)
    if codes is not None:
        return codes
    try:
        code = registry.by_name(text).CODE
    except ConfigError as error:
        raise ConfigError(f"gateway.rules[{number}].messages: {error}; or write its id, as in 0x2301") from None
    return range(code, code + 1)


_COMMENT_WIDTH: Final = 100


def load_config(path: Path | None, overrides: Mapping[str, Any] | None = None) -> NodeConfig:
    """The settings of a TOML file; `overrides` that are not None, as of the command line, take precedence.

    Raises `ConfigError` that names the file, the line, the key and its permitted values.
    """
    given = {key: value for key, value in (overrides or {}).items() if value is not None}
    if path is None:
        return NodeConfig.make(**given)
    data = read_toml(path)
    try:
        return NodeConfig.model_validate(data | given)
    except ValidationError as error:
        text = path.read_text()
        problems = "".join(
            f"\n  {'' if problem['loc'][:1] and problem['loc'][0] in given else line_prefix(text, problem['loc'])}"
            f"{explain(problem, NodeConfig)}"
            for problem in error.errors(include_url=False)
        )
        raise ConfigError(f"{path}: is not a configuration of a node manager:{problems}") from None


def to_toml(config: NodeConfig) -> str:
    """All settings as a TOML file for `load`; those without a value are comments."""
    head = "# Configuration of jauspy node-manager. Omitted keys have defaults; command line options take precedence."
    return "\n".join([head, *_toml_table(config, "")]).rstrip() + "\n"


def _toml_table(model: BaseModel, prefix: str) -> Iterator[str]:
    """The lines of a table: its own values first, then its tables."""
    fields = type(model).model_fields
    tables = [name for name, field in fields.items() if any(models_in(field.annotation)) or _toml_is_mapping(field)]
    for name, field in fields.items():
        if name not in tables:
            yield from ["", *_toml_comment(field), _toml_line(name, getattr(model, name), field)]
    for name in tables:
        yield from ["", *_toml_comment(fields[name])]
        yield from _toml_tables(getattr(model, name), f"{prefix}{name}", fields[name])


def _toml_tables(value: object, name: str, field: FieldInfo) -> Iterator[str]:
    if isinstance(value, BaseModel):
        yield from [f"[{name}]", *_toml_table(value, f"{name}.")]
    elif isinstance(value, Mapping):
        yield f"[{name}]"
        yield from (f"{json.dumps(str(key))} = {_toml_value(item)}" for key, item in value.items())
    elif value:
        for item in value:  # type: ignore[attr-defined]  # a tuple of models
            yield from [f"[[{name}]]", *_toml_table(item, f"{name}.")]
    else:
        for example in field.examples or ():
            lines = _toml_tables((example,) if value == () else example, name, field)
            yield from ("#" if not line else line if line[0] == "#" else f"# {line}" for line in lines)


def _toml_is_mapping(field: FieldInfo) -> bool:
    return getattr(field.annotation, "__origin__", None) in (dict, Mapping)


def _toml_comment(field: FieldInfo) -> list[str]:
    text = " ".join((field.description or "").split())
    if field.is_required():
        text += " It must be given."
    elif (default := field.get_default(call_default_factory=True)) not in (None, (), {}):
        text += f" Default: {_toml_value(default, octal=_toml_is_octal(field))}."
    return textwrap.wrap(text, _COMMENT_WIDTH, initial_indent="# ", subsequent_indent="# ")


def _toml_line(name: str, value: object, field: FieldInfo) -> str:
    if value is None:
        return f"# {name} = {_toml_value(field.examples[0] if field.examples else '')}"
    return f"{name} = {_toml_value(value, octal=_toml_is_octal(field))}"


def _toml_is_octal(field: FieldInfo) -> bool:
    extra = field.json_schema_extra
    return isinstance(extra, dict) and bool(extra.get("octal"))


def _toml_value(value: object, *, octal: bool = False) -> str:
    """TOML of a scalar or a list."""
    match value:
        case bool():
            return str(value).lower()
        case int():
            return f"0o{value:o}" if octal else str(value)
        case float():
            return repr(value)
        case tuple() | list():
            return f"[{', '.join(_toml_value(item) for item in value)}]"
        case _:
            return json.dumps(str(value))
