"""Reading address books: our own TOML, `nm.cfg` of the JAUS Toolset (XML), and FKIE's YAML."""

from __future__ import annotations

import ipaddress
import tomllib
from collections.abc import Callable, Iterable, Iterator, Mapping
from pathlib import Path
from typing import Any, Final
from urllib.parse import urlsplit

import yaml
from lxml import etree

from jauspy.errors import ConfigError
from jauspy.ids import JausID
from jauspy.plain_yaml import parse_yaml
from jauspy.protocol import judp
from jauspy.protocol.addressing import NetworkPort, SerialPort, TcpPort, UdpPort
from jauspy.user_files import read_file

AddressEntries = dict[JausID, tuple[NetworkPort, ...]]
_Pairs = Iterator[tuple[JausID, NetworkPort]]

FORMS: Final = "udp://IP[:PORT], tcp://HOST[:PORT], serial:DEVICE or IP:PORT (which means UDP)"
_WRAPPED: Final = ":value"
"""Key of a value that FKIE's files wrap together with its description."""


def load_address_book(path: Path) -> AddressEntries:
    """The entries of an address book; raises `ConfigError` that names file and entry."""
    readers: dict[str, Callable[[bytes], _Pairs]] = {
        ".toml": _toml,
        ".cfg": _xml,
        ".xml": _xml,
        ".yaml": _yaml,
        ".yml": _yaml,
    }
    reader = readers.get(path.suffix.lower())
    if reader is None:
        raise ConfigError(f"address book {path}: use one of {', '.join(readers)}")
    try:
        data = read_file(path)
    except ConfigError as error:
        raise ConfigError(f"address book {error}") from None
    try:
        return _collect(reader(data))
    except RecursionError:
        raise ConfigError(f"address book {path}: is nested too deeply") from None
    except (tomllib.TOMLDecodeError, UnicodeDecodeError, etree.XMLSyntaxError, yaml.YAMLError) as error:
        raise ConfigError(f"address book {path}: {error}") from error
    except ConfigError as error:
        raise ConfigError(f"address book {path}: {error}") from None


def parse_entries(table: Mapping[str, Any]) -> AddressEntries:
    """The entries of a table as in our own TOML: `"101.1.255" = "udp://10.0.0.5"`, or a list of such addresses."""
    return _collect(_pairs(table))


def parse_address(text: str) -> NetworkPort:
    """The address in a configuration; raises `ConfigError` that lists the forms."""
    if text.startswith("serial:"):
        device = text.removeprefix("serial:")
        if device.startswith("/"):
            return SerialPort(device)
        raise ConfigError(f"{text!r} names no device; write it as in serial:/dev/ttyS0")
    try:
        parts = urlsplit(text if "://" in text else f"udp://{text}")
        host, port = parts.hostname, parts.port if parts.port is not None else judp.PORT
    except ValueError:
        host, port, parts = None, 0, urlsplit("")
    if not host or not 0 < port < 65536 or parts.path or parts.scheme not in ("udp", "tcp"):
        raise ConfigError(f"{text!r} is not an address; write {FORMS}")
    if parts.scheme == "tcp":
        return TcpPort(host, port)
    try:
        ipaddress.ip_address(host)
    except ValueError:
        raise ConfigError(f"{text!r}: write the IP address; host names are not resolved for UDP") from None
    return UdpPort(host, port)


def _collect(pairs: Iterable[tuple[JausID, NetworkPort]]) -> AddressEntries:
    found: dict[JausID, dict[NetworkPort, None]] = {}
    for id, port in pairs:
        found.setdefault(id, {})[port] = None
    return {id: tuple(ports) for id, ports in found.items()}


def _pairs(table: Mapping[str, Any]) -> _Pairs:
    for id, value in table.items():
        for address in value if isinstance(value, list) else [value]:
            if not isinstance(address, str):
                raise ConfigError(f"{id} = {address!r}: write {FORMS}")
            yield JausID.parse(id), parse_address(address)


def _toml(data: bytes) -> _Pairs:
    table = tomllib.loads(data.decode()).get("addresses")
    if not isinstance(table, dict):
        raise ConfigError('it has no table [addresses] with lines such as "101.1.255" = "udp://10.0.0.5:3794"')
    return _pairs(table)


def _xml(data: bytes) -> _Pairs:
    """`<AddressBook J8257803="10.0.0.5:3794"/>`: ids in decimal, as attributes of any number of such elements."""
    root = etree.fromstring(data, etree.XMLParser(resolve_entities=False, no_network=True))
    for element in root.iter("AddressBook"):
        for name, value in element.attrib.items():
            number = str(name).removeprefix("J")
            if not (number.isascii() and number.isdigit() and len(number) <= 10 and int(number) <= 0xFFFFFFFF):
                raise ConfigError(f"{name!s}={value!r}: write J and the id in decimal, as in J8257803 for 126.1.11")
            yield JausID.from_int(int(number)), parse_address(str(value))


def _yaml(data: bytes) -> _Pairs:
    """`addrbook: {udp: {"10.0.0.5:3794": 101.1.255}}`: one id or a list of ids by address."""
    content = parse_yaml(data)
    book = _unwrap(content.get("addrbook")) if isinstance(content, dict) else None
    if not isinstance(book, dict):
        raise ConfigError("it has no key 'addrbook'")
    for transport, table in book.items():
        if transport not in ("udp", "tcp"):
            raise ConfigError(f"addrbook/{transport}: only udp and tcp are known")
        table_entries = _unwrap(table) or {}
        if not isinstance(table_entries, dict):
            raise ConfigError(f'addrbook/{transport} = {table_entries!r}: write lines such as "10.0.0.5:3794": 101.1.1')
        for where, ids in table_entries.items():
            for id in _as_list(_unwrap(ids)):
                yield JausID.parse(str(id)), parse_address(f"{transport}://{where}")


def _unwrap(value: Any) -> Any:
    return value[_WRAPPED] if isinstance(value, dict) and _WRAPPED in value else value


def _as_list(value: Any) -> list[Any]:
    return value if isinstance(value, list) else [value]
