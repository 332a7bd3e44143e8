"""The benchmark's messages, decoded and encoded by code that is written by hand with `struct`."""

from __future__ import annotations

import struct
from dataclasses import dataclass

LINEAR, RMS, RATE, RATE_RMS = 655.35 / 0xFFFFFFFF, 100 / 0xFFFFFFFF, 0.001, 3.141592653589793 / 0xFFFF


@dataclass(slots=True)
class Time:
    """The time stamp of the code written by hand."""

    milliseconds: int
    seconds: int
    minutes: int
    hour: int
    day: int


@dataclass(slots=True)
class Velocity:
    """A velocity state as one would write it by hand."""

    velocity_x: float | None
    velocity_y: float | None
    velocity_z: float | None
    velocity_rms: float | None
    roll_rate: float | None
    pitch_rate: float | None
    yaw_rate: float | None
    rate_rms: float | None
    time_stamp: Time | None


U16, U32 = struct.Struct("<H"), struct.Struct("<I")


def velocity_decode(data: bytes) -> Velocity:
    """Branches over the presence vector, checks what a strict decoder has to check."""
    code, mask = struct.unpack_from("<HH", data)
    if code != 0x4404:
        raise ValueError(code)
    at = 4
    values: list[float | None] = []
    for bit, lower, step in ((1, -327.68, LINEAR), (2, -327.68, LINEAR), (4, -327.68, LINEAR), (8, 0.0, RMS)):
        if mask & bit:
            values.append(lower + U32.unpack_from(data, at)[0] * step)
            at += 4
        else:
            values.append(None)
    for bit, lower, step in ((16, -32.768, RATE), (32, -32.768, RATE), (64, -32.768, RATE), (128, 0.0, RATE_RMS)):
        if mask & bit:
            values.append(lower + U16.unpack_from(data, at)[0] * step)
            at += 2
        else:
            values.append(None)
    time = None
    if mask & 256:
        (raw,) = U32.unpack_from(data, at)
        at += 4
        time = Time(raw & 0x3FF, raw >> 10 & 0x3F, raw >> 16 & 0x3F, raw >> 22 & 0x1F, raw >> 27)
        if time.milliseconds > 999 or time.seconds > 59 or time.minutes > 59 or time.hour > 23 or not time.day:
            raise ValueError(time)
    if at != len(data):
        raise ValueError(at)
    return Velocity(*values, time)  # type: ignore[call-arg, arg-type]  # eight numbers


def _raw(value: float, lower: float, upper: float, step: float) -> int:
    if not lower <= value <= upper:
        raise ValueError(value)
    return int((value - lower) / step + 0.5)


def velocity_encode(v: Velocity) -> bytes:
    """The same in the other direction."""
    mask, parts = 0, [b""]
    for bit, value in ((1, v.velocity_x), (2, v.velocity_y), (4, v.velocity_z)):
        if value is not None:
            mask |= bit
            parts.append(U32.pack(_raw(value, -327.68, 327.67, LINEAR)))
    if v.velocity_rms is not None:
        mask |= 8
        parts.append(U32.pack(_raw(v.velocity_rms, 0.0, 100.0, RMS)))
    for bit, value in ((16, v.roll_rate), (32, v.pitch_rate), (64, v.yaw_rate)):
        if value is not None:
            mask |= bit
            parts.append(U16.pack(_raw(value, -32.768, 32.767, RATE)))
    if v.rate_rms is not None:
        mask |= 128
        parts.append(U16.pack(_raw(v.rate_rms, 0.0, 3.141592653589793, RATE_RMS)))
    if v.time_stamp is not None:
        t = v.time_stamp
        mask |= 256
        if t.milliseconds > 999 or t.seconds > 59 or t.minutes > 59 or t.hour > 23 or not t.day:
            raise ValueError(t)
        parts.append(U32.pack(t.milliseconds | t.seconds << 10 | t.minutes << 16 | t.hour << 22 | t.day << 27))
    parts[0] = struct.pack("<HH", 0x4404, mask)
    return b"".join(parts)


@dataclass(slots=True)
class Service:
    """A service as one would write it by hand; so the next two."""

    uri: str
    major: int
    minor: int


@dataclass(slots=True)
class Component:
    """A component and its services."""

    component: int
    instance: int
    services: list[Service]


@dataclass(slots=True)
class Node:
    """A node and its components."""

    node: int
    components: list[Component]


def services_decode(data: bytes) -> list[Node]:
    """Lists in lists."""
    nodes: list[Node] = []
    at = 3
    for _ in range(data[2]):
        node, count = data[at], data[at + 1]
        at += 2
        components: list[Component] = []
        for _ in range(count):
            component, instance, listed = data[at], data[at + 1], data[at + 2]
            at += 3
            services: list[Service] = []
            for _ in range(listed):
                end = at + 1 + data[at]
                services.append(Service(data[at + 1 : end].decode("latin-1"), data[end], data[end + 1]))
                at = end + 2
            components.append(Component(component, instance, services))
        nodes.append(Node(node, components))
    if at != len(data):
        raise ValueError(at)
    return nodes


def services_encode(nodes: list[Node]) -> bytes:
    """The same in the other direction."""
    out = bytearray(b"\x03\x4b")
    out.append(len(nodes))
    for node in nodes:
        out += bytes((node.node, len(node.components)))
        for component in node.components:
            out += bytes((component.component, component.instance, len(component.services)))
            for service in component.services:
                raw = service.uri.encode("latin-1")
                out.append(len(raw))
                out += raw
                out += bytes((service.major, service.minor))
    return bytes(out)


@dataclass(slots=True)
class Effort:
    """The effort of one joint."""

    joint_effort: float


EFFORT = 200 / 0xFFFF


def efforts_decode(data: bytes) -> list[Effort]:
    """A list of numbers."""
    code, count = struct.unpack_from("<HB", data)
    if code != 0xD601 or len(data) != 3 + 2 * count:
        raise ValueError(data)
    return [Effort(-100.0 + raw * EFFORT) for raw in struct.unpack_from(f"<{count}H", data, 3)]


def efforts_encode(efforts: list[Effort]) -> bytes:
    """The same in the other direction."""
    raw = [_raw(effort.joint_effort, -100.0, 100.0, EFFORT) for effort in efforts]
    return struct.pack(f"<HB{len(raw)}H", 0xD601, len(raw), *raw)
