"""What tshark shows of packets with a Lua dissector, and what our decoder says that it should show."""

from __future__ import annotations

import re
import shutil
import subprocess
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import dpkt
import pytest
from lxml import etree

from jauspy.capture import writer
from jauspy.codec import items, layout
from jauspy.codec.items import Item
from jauspy.codec.message import Message
from jauspy.codec.names import set_package, snake, unit_symbol

needs_tshark = pytest.mark.skipif(shutil.which("tshark") is None, reason="tshark is not installed")
EXPERTS = ("jaus.malformed.", "jaus.unknown", "jaus.limit", "jaus.failed")
A, B = ("127.0.0.1", 3794), ("127.0.0.2", 3794)


def capture_of(datagrams: Iterable[bytes], path: Path) -> Path:
    """A capture file with these UDP payloads."""
    packets = [writer.packet(A, B, data, 1_000_000 * number) for number, data in enumerate(datagrams)]
    path.write_bytes(b"".join([writer.preamble(), *packets]))
    return path


def tshark(lua: Path, capture: Path, *options: str) -> str:
    """The output of tshark; fails on Lua errors."""
    command = ["tshark", "-n", "-X", f"lua_script:{lua}", "-r", str(capture), *options]
    done = subprocess.run(command, capture_output=True, check=False)
    errors = done.stderr.decode("utf-8", "replace")
    assert done.returncode == 0, errors
    output = done.stdout.decode("utf-8", "replace")
    assert "Lua" not in errors.replace("running Lua", ""), errors
    assert "Lua Error" not in output
    return output


@dataclass
class Shown:
    """A field that tshark shows, or that it should show; `nested` are the fields of a message in it."""

    name: str
    value: Any
    text: str = ""
    raw: bytes = b""
    nested: ShownMessage | None = None


@dataclass
class ShownMessage:
    """A message with its fields in the order of the bytes."""

    name: str
    fields: list[Shown] = field(default_factory=list)


@dataclass
class Frame:
    """A dissected frame: its messages, and the names of its expert infos outside of messages in messages."""

    messages: list[ShownMessage]
    experts: list[str]


def frames(lua: Path, capture: Path, *options: str) -> list[Frame]:
    """All frames of a capture as tshark shows them."""
    document = etree.fromstring(tshark(lua, capture, "-T", "pdml", *options).encode(), etree.XMLParser(huge_tree=True))
    found = []
    for packet in document.iter("packet"):
        experts = [
            name
            for element in packet.iter("field")
            if (name := element.get("name") or "").startswith(EXPERTS) and not _is_nested(element)
        ]
        found.append(Frame([_message(element) for element in _outermost(packet)], experts))
    return found


def _is_nested(element: Any) -> bool:
    return sum(outer.get("name") == "jaus.message" for outer in element.iterancestors()) > 1


def _outermost(element: Any) -> Iterator[Any]:
    for child in element:
        if child.get("name") == "jaus.message":
            yield child
        else:
            yield from _outermost(child)


def _message(element: Any) -> ShownMessage:
    return ShownMessage(element.get("show"), list(_fields(element)))


def _fields(element: Any) -> Iterator[Shown]:
    for child in element:
        name = child.get("name") or ""
        if name.startswith("jaus.") and not name.startswith(
            ("jaus.message", "jaus.data", "jaus.malformed", "jaus.unknown")
        ):
            nested = next((_message(inner) for inner in child if inner.get("name") == "jaus.message"), None)
            raw = child.get("value") or ""
            data = bytes.fromhex(raw) if len(raw) % 2 == 0 else b""  # of bits it is their number in hex
            yield Shown(name, child.get("show"), child.get("showname") or "", data, nested)
            if nested is not None:
                continue
        yield from _fields(child)


def expected(message: Message) -> ShownMessage:
    """What should be shown of a message that our decoder has read."""
    prefix = f"jaus.{set_package(message.SERVICE)}.{snake(message.NAME)}"
    return ShownMessage(message.NAME, list(_expected(message.layout(), message, prefix)))


def _expected(item: Item, value: Any, path: str) -> Iterator[Shown]:
    match item:
        case layout.Composite():
            if item.presence:
                optional = [slot for slot in item.slots if slot.optional]
                mask = sum(1 << bit for bit, slot in enumerate(optional) if getattr(value, slot.name) is not None)
                yield Shown(f"{path}.presence_vector", mask | getattr(value, "reserved_presence", 0))
            for slot in item.slots:
                part = getattr(value, slot.name)
                if part is not None:
                    yield from _expected(slot.item, part, f"{path}.{slot.name}")
        case layout.Repeat():
            yield Shown(f"{path}.count", len(value))
            for part in value:
                fields = _expected(item.item, part, path)
                if isinstance(item.item, layout.Repeat):
                    yield Shown(f"{path}.count_2", len(part))
                    next(fields)
                yield from fields
        case layout.Grid():
            inner = layout.Grid(item.item, item.sizes[1:]) if len(item.sizes) > 1 else item.item
            for part in value:
                yield from _expected(inner, part, path)
        case layout.Union():
            for tag, (name, arm) in enumerate(item.arms.items()):
                if type(value) is arm.cls:
                    yield Shown(f"{path}.tag", tag, name)
                    yield from _expected(arm, value, f"{path}.{name}")
        case items.Bits():
            raw = getattr(value, "reserved_bits", 0) | sum(int(getattr(value, b.name)) << b.shift for b in item.bits)
            yield Shown(path, raw)
            for bit in item.bits:
                yield Shown(f"{path}.{bit.name}", *_number(getattr(value, bit.name)))
        case items.Choice():
            yield Shown(f"{path}.choice", *_number(value.choice))
            inner = item.items[value.choice]
            yield Shown(f"{path}.value", *_number(value.value, inner.units))
        case items.Text():
            data = value.encode("latin-1")
            if item.count:
                yield Shown(f"{path}.count", len(data))
            yield Shown(path, data.ljust(item.length, b"\0"), value if value.isascii() and value.isprintable() else "")
        case items.Blob():
            yield from _bytes(value, f"{path}.count", path)
        case items.Formatted():
            yield Shown(f"{path}.format", *_number(value.format))
            yield from _bytes(value.data, f"{path}.data.count", f"{path}.data")
        case items.Number() | items.Real():
            yield Shown(path, *_number(value, item.units))


def _number(value: Any, units: str = "one") -> tuple[Any, str]:
    return value, getattr(value, "name", "") or unit_symbol(units)


def _bytes(value: Any, count: str, path: str) -> Iterator[Shown]:
    data = value.encode(strict=False) if isinstance(value, Message) else value
    yield Shown(count, len(data))
    yield Shown(path, data, "", b"", expected(value) if isinstance(value, Message) else None)


def difference(shown: ShownMessage, wanted: ShownMessage, *, cut: bool = False) -> str:
    """The first difference, or nothing.

    A message that is damaged (`cut`) may be shown with fewer fields; then its counts and presence vectors are as they
    were sent, and ours as far as they are true. An alternative that is not defined is the last field.
    """
    if shown.name != wanted.name:
        return f"{shown.name} instead of {wanted.name}"
    ends = (".tag", ".choice")
    for one, other in zip(shown.fields, wanted.fields, strict=False):
        if one.name != other.name:
            return f"{one.name} instead of {other.name}"
        if cut and (".count" in one.name or one.name.endswith(".presence_vector")):
            if int(one.value, 0) < other.value:
                return f"{one.name}: {one.value} is less than {other.value}"
        elif cut and one is shown.fields[-1] and one.name.endswith(ends):
            continue
        elif not _equal(one, other.value):
            return f"{one.name}: {one.value} instead of {other.value}"
        if other.text and other.text not in one.text:
            return f"{one.name}: {one.text!r} without {other.text!r}"
        if other.nested and not one.nested:
            return f"{one.name}: no message in it"
        if other.nested and one.nested and (found := difference(one.nested, other.nested)):
            return f"{one.name}: {found}"
    if len(shown.fields) > len(wanted.fields) or (len(shown.fields) < len(wanted.fields) and not cut):
        return f"{len(shown.fields)} fields instead of {len(wanted.fields)}"
    return ""


def _equal(shown: Shown, wanted: Any) -> bool:
    if isinstance(wanted, bytes):
        return shown.raw == wanted
    if isinstance(wanted, float):
        if shown.value == f"{wanted:.15g}":  # of the largest numbers these digits are infinite, when they are read
            return True
        return float(shown.value) == pytest.approx(wanted, rel=1e-5, abs=1e-9, nan_ok=True)
    number = int(shown.value, 0) if re.fullmatch(r"-?\d+|0x[0-9a-f]+", shown.value) else float(shown.value)
    return number == int(wanted)


def tcp_capture(segments: Iterable[bytes], path: Path) -> Path:
    """A capture of one direction of a TCP connection to port 3794, with these segments."""
    sequence = 1000
    with path.open("wb") as file:
        pcap = dpkt.pcap.Writer(file, linktype=dpkt.pcap.DLT_RAW)
        for number, data in enumerate([b"", *segments]):
            flags = dpkt.tcp.TH_ACK if number else dpkt.tcp.TH_SYN
            tcp = dpkt.tcp.TCP(sport=50000, dport=3794, seq=sequence, ack=1, flags=flags, data=data)
            ip = dpkt.ip.IP(src=b"\x7f\0\0\1", dst=b"\x7f\0\0\2", p=dpkt.ip.IP_PROTO_TCP, data=tcp)
            ip.len = len(ip)
            pcap.writepkt(bytes(ip), ts=number / 1000)
            sequence += len(data) if number else 1
    return path


def serial_capture(records: Iterable[bytes], path: Path) -> Path:
    """A capture with the link type USER0, whose records are bytes of a serial line."""
    with path.open("wb") as file:
        pcap = dpkt.pcap.Writer(file, linktype=147)
        for number, data in enumerate(records):
            pcap.writepkt(data, ts=number / 1000)
    return path
