"""The forms that single settings of a node manager may have."""

from __future__ import annotations

import ipaddress
import re
from collections.abc import Mapping
from typing import Annotated, Any, Final

from pydantic import AfterValidator, BaseModel, BeforeValidator, ConfigDict, Field

from jauspy.errors import ConfigError
from jauspy.ids import JausID
from jauspy.node.address_books import parse_entries

_RANGE: Final = re.compile(r"(0[xX][0-9a-fA-F]{1,4})(?:-(0[xX][0-9a-fA-F]{1,4}))?")


class NodeSettings(BaseModel):
    """Frozen, without unknown keys; the docstring under each field is its comment in the configuration file."""

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
    """A number is as good as its hexadecimal form."""
    return f"0x{value:04X}" if isinstance(value, int) and 0 <= value <= 0xFFFF else value


def parse_pattern(text: str) -> JausID:
    """The id with wildcards that `42.*.*` stands for; raises `ValueError`."""
    parts = text.split(".")
    if len(parts) == 3:
        parts = [top if part == "*" else part for part, top in zip(parts, ("65535", "255", "255"), strict=True)]
    try:
        return JausID.parse(".".join(parts))
    except ConfigError:
        raise ValueError("write SUBSYSTEM.NODE.COMPONENT with * for any, as in 42.*.*") from None


def parse_codes(text: str) -> range | None:
    """The message ids that `0x0405` or `0x2000-0x2FFF` stands for; None when it is something else, as a name."""
    found = _RANGE.fullmatch(text)
    if found is None:
        return None
    first = int(found[1], 16)
    return range(first, int(found[2] or found[1], 16) + 1)


IPv4 = Annotated[str, AfterValidator(_ipv4)]
IPv6 = Annotated[str, AfterValidator(_ipv6)]
Interface = Annotated[str, AfterValidator(_interface)]
Addresses = Annotated[Mapping[str, str | list[str]], AfterValidator(_addresses)]
Group = Annotated[str, AfterValidator(_group)]
Group6 = Annotated[str, AfterValidator(_group6)]
HostPort = Annotated[str, AfterValidator(_host_port)]
Mirror = Annotated[str, AfterValidator(_mirror)]
Name = Annotated[str, Field(pattern=r"^[A-Za-z0-9_-]{1,32}$")]
IdPattern = Annotated[str, AfterValidator(_id_pattern)]
MessageName = Annotated[str, BeforeValidator(_message)]
Mode = Annotated[int, AfterValidator(_mode), Field(json_schema_extra={"octal": True})]
