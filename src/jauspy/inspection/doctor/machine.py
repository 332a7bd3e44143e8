"""Checks of this machine: the port, the local sockets, interfaces, the multicast group, the clock."""

from __future__ import annotations

import errno
import os
import socket
import stat
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from datetime import UTC, datetime
from pathlib import Path
from typing import Any, Final

import psutil

from jauspy.inspection.doctor.findings import Finding, Severity, fail, ok, warn
from jauspy.protocol import junior
from jauspy.transport import local, node_status
from jauspy.transport.multicast import ANY
from jauspy.transport.port_owner import udp_port_owner

IGMP_TABLE: Final = Path("/proc/net/igmp")
MIN_MTU: Final = 1280
"""Bytes; the smallest MTU that IPv6 allows. Links below are tunnels or wrong settings."""
FIRST_YEAR: Final = 2025
"""A clock before has never been set."""
_FRAGMENTED: Final = 4096
"""Bytes of the largest datagram of JUDP, which has to go through the MTU in fragments."""


@dataclass(frozen=True, slots=True)
class Interface:
    """A network interface with IPv4, as the system describes it."""

    name: str
    addresses: tuple[str, ...]
    is_up: bool
    mtu: int
    flags: frozenset[str]

    @property
    def is_loopback(self) -> bool:
        """True for the interface of this machine only."""
        return "loopback" in self.flags or all(address.startswith("127.") for address in self.addresses)


def interfaces() -> list[Interface]:
    """The interfaces of this machine that have an IPv4 address, or could have one."""
    stats = psutil.net_if_stats()
    addresses = psutil.net_if_addrs()
    return [
        Interface(
            name,
            tuple(entry.address for entry in addresses.get(name, ()) if entry.family == socket.AF_INET),
            state.isup,
            state.mtu,
            frozenset(state.flags.split(",")),
        )
        for name, state in stats.items()
    ]


# --- the port ---------------------------------------------------------------------------------------------------------


def check_port(port: int, root: Path, status: Mapping[str, Any]) -> Finding:
    """Who has the UDP port: nobody, the node manager of the local root, or another process."""
    if _is_free(port):
        if local.is_alive(root / junior.SOCKET_NAME):
            return fail(
                "port",
                f"the node manager of {root} is not on UDP port {port}: it reaches no other machine",
                f"{root / junior.SOCKET_NAME} answers, and UDP port {port} is free",
                f"start it with --port {port} again, or name its port here with --port",
            )
        return warn(
            "port",
            f"no node manager is on UDP port {port} of this machine",
            "the port is free",
            "start one with `jauspy node-manager`, unless this machine has only clients that use UDP themselves",
        )
    owner = udp_port_owner(port)
    if any(str(network.get("address")).endswith(f":{port}") for network in _rows(status, "networks")):
        return ok("port", f"UDP port {port} has the node manager of {root}", owner)
    if local.is_alive(root / junior.SOCKET_NAME) and not status:
        return ok("port", f"UDP port {port} is taken, and a node manager without a status answers in {root}", owner)
    return fail(
        "port",
        f"UDP port {port} is taken by {owner}, which is not the node manager of {root}",
        "no other program can bind it",
        "stop that process, or, if it is a node manager, name its directory of sockets with --local-root",
    )


def _is_free(port: int) -> bool:
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as probe:
        try:
            probe.bind((ANY, port))
        except OSError as error:
            return error.errno != errno.EADDRINUSE
    return True


# --- sockets ----------------------------------------------------------------------------------------------------------


def check_sockets(root: Path) -> Finding:
    """Whether this user's components can reach the node manager's socket, and bind their own beside it."""
    path = root / junior.SOCKET_NAME
    if not root.is_dir():
        return fail("sockets", f"{root} is not a directory", "", "create it, or choose another with --local-root")
    if not os.access(root, os.W_OK | os.X_OK):
        return fail(
            "sockets",
            f"this user may not create sockets in {root}, so no component of this user can attach",
            _owner(root),
            "run as its owner or in its group, or choose another directory with --local-root",
        )
    if not path.exists():
        return warn(
            "sockets",
            f"no node manager has its socket in {root}",
            f"{path} does not exist",
            f"start one with `jauspy node-manager --local-root {root}`",
        )
    if local.is_alive(path):
        return ok("sockets", f"the node manager's socket {path} answers", _owner(path))
    if local.is_dead(path):
        return fail(
            "sockets",
            f"{path} is left over: the node manager that made it has ended",
            _owner(path),
            f"start it again with `jauspy node-manager --local-root {root}`, which replaces the file",
        )
    return fail(
        "sockets",
        local.refusal(path) or f"{path} cannot be used",
        _owner(path),
        "add this user to the socket's group, or start the node manager with --socket-mode 666",
    )


def _owner(path: Path) -> str:
    try:
        found = path.stat()
    except OSError as error:  # removed meanwhile
        return f"{path}: {error.strerror}"
    names = f"{local.user_name(found.st_uid)}:{local.group_name(found.st_gid)}"
    return f"{stat.filemode(found.st_mode)} {names} {path}"


# --- interfaces and the group -----------------------------------------------------------------------------------------


def check_interfaces(found: Sequence[Interface], chosen: Sequence[str]) -> Iterator[Finding]:
    """Interfaces that are down, without multicast, or with a small MTU; `chosen` are the addresses to use, if any."""
    wanted = [i for i in found if set(chosen) & {i.name, *i.addresses}] if chosen else _outward(found)
    for missing in sorted({*chosen} - {name for i in found for name in (i.name, *i.addresses)}):
        yield fail(
            "interface",
            f"this machine has no interface {missing}",
            "it has " + ", ".join(f"{i.name} ({', '.join(i.addresses) or 'no address'})" for i in found),
            "choose one of these with --interface",
        )
    if not wanted and not chosen:
        yield fail(
            "interface",
            "no interface leads to another machine",
            "only the loopback interface has an address",
            "connect the network and give the interface an address: ip addr add 192.168.1.10/24 dev eth0",
        )
    for interface in wanted:
        yield _check_interface(interface)
        if interface.is_up:
            yield _check_mtu(interface)


def _outward(found: Sequence[Interface]) -> list[Interface]:
    """Interfaces to other machines: with an address, or down and without one."""
    return [i for i in found if not i.is_loopback and i.addresses]


def _check_interface(interface: Interface) -> Finding:
    where = f"{interface.name} ({', '.join(interface.addresses)})"
    if not interface.is_up:
        fix = f"connect its cable, or: ip link set {interface.name} up"
        return fail("interface", f"interface {where} is down", "", fix)
    if interface.flags and "multicast" not in interface.flags and not interface.is_loopback:
        return fail(
            "interface",
            f"interface {where} does not send multicasts, which discovery needs",
            f"flags: {', '.join(sorted(interface.flags))}",
            f"ip link set {interface.name} multicast on; where that fails (tunnels), give static addresses "
            "(docs/node-manager.md)",
        )
    return ok("interface", f"interface {where} is up", f"MTU {interface.mtu}")


def _check_mtu(interface: Interface) -> Finding:
    if interface.mtu >= MIN_MTU:
        return ok("MTU", f"{interface.name} has an MTU of {interface.mtu} bytes")
    parts = -(-_FRAGMENTED // max(interface.mtu - 28, 1))
    return warn(
        "MTU",
        f"{interface.name} has an MTU of {interface.mtu} bytes only",
        f"a full packet of {_FRAGMENTED} bytes takes {parts} IP fragments, and is lost with any of them",
        f"ip link set {interface.name} mtu 1500, on both ends",
    )


def memberships(table: str) -> dict[str, frozenset[str]]:
    """The groups that each interface has joined, from the text of /proc/net/igmp; lines of another form are skipped."""
    joined: dict[str, frozenset[str]] = {}
    name = ""
    for line in table.splitlines()[1:]:
        words = line.split()
        if not line[:1].isspace() and len(words) > 1:
            name = words[1].rstrip(":")
            joined[name] = frozenset()
        elif name and words and len(words[0]) == 8:
            try:
                group = socket.inet_ntoa(int(words[0], 16).to_bytes(4, "little"))
            except ValueError:
                continue
            joined[name] |= {group}
    return joined


def check_joined(
    joined: Mapping[str, frozenset[str]],
    found: Sequence[Interface],
    group: str,
    chosen: Sequence[str],
    *,
    is_free: bool = False,
) -> Finding:
    """Whether the group is joined on the interfaces that lead to other machines.

    `is_free`: no program has the port, so that nobody is expected to have joined.
    """
    wanted = [i for i in found if set(chosen) & {i.name, *i.addresses}] if chosen else _outward(found)
    members = [i.name for i in wanted if group in joined.get(i.name, ())]
    others = [i.name for i in wanted if i.is_up and i.name not in members]
    if not wanted or not others:
        return ok("group", f"{group} is joined on {', '.join(members) or 'no interface'}")
    evidence = f"/proc/net/igmp has it on {', '.join(n for n in joined if group in joined[n]) or 'no interface'}"
    if not members:
        severity = Severity.WARN if is_free else Severity.FAIL
        return Finding(
            "group",
            severity,
            f"no program of this machine has joined {group} on {', '.join(others)}: broadcasts and discovery of others "
            "are not heard",
            evidence,
            f"start the node manager with --interface {others[0]}, or start one at all",
        )
    return warn(
        "group",
        f"{group} is joined on {', '.join(members)}, but not on {', '.join(others)}",
        evidence,
        'for robots there, start the node manager with multicast_interfaces = "all"',
    )


# --- clock ------------------------------------------------------------------------------------------------------------


def check_clock(now: datetime) -> Finding:
    """Whether this machine's clock has ever been set."""
    if now.year < FIRST_YEAR:
        return fail(
            "clock",
            f"the clock of this machine says {now:%Y-%m-%d}",
            "it has not been set since the machine was started",
            "set it: timedatectl set-ntp true, or date -s",
        )
    return ok("clock", f"the clock of this machine says {now:%Y-%m-%d %H:%M:%S} UTC")


# --- the node manager's own counters ----------------------------------------------------------------------------------

_DROPS: Final = {
    "dropped.auth.": (
        "are not authenticated with the key of the network",
        "give both node managers the same key_file, and clocks that agree (docs/security.md)",
    ),
    "dropped.address_mismatch": (
        "have an id that is heard from another address",
        "give each machine ids of its own; wait 30 s after a machine has changed its address",
    ),
    "dropped.malformed.": (
        "are malformed",
        "record them with `jauspy record` and look with `jauspy decode --explain`",
    ),
}
"""Counters of the node manager that are diagnoses: what the packets are, and the fix."""


def check_status(status: Mapping[str, Any]) -> Iterator[Finding]:
    """What the node manager of this machine has counted itself: clashes of ids, and what it drops and why."""
    for clash in _rows(status, "clashes"):
        yield fail(
            "duplicate id",
            f"{clash.get('id')} is used on this machine and at {clash.get('address')}",
            "the node manager has heard it from there",
            "give one of both another id",
        )
    counters = status.get("counters")
    counters = counters if isinstance(counters, Mapping) else {}
    for prefix, (what, fix) in _DROPS.items():
        count = sum(n for name, n in counters.items() if name.startswith(prefix) and isinstance(n, int))
        if count:
            yield warn("node manager", f"{count} packets were dropped, because they {what}", f"counter {prefix}", fix)
    for network in _rows(status, "networks"):
        buffer = network.get("receive_buffer")
        if isinstance(buffer, Mapping) and buffer.get("dropped"):
            yield warn(
                "node manager",
                f"{buffer['dropped']} datagrams were lost before the node manager read them",
                f"network {network.get('name')}, receive buffer of {buffer.get('limit')} bytes",
                "raise net.core.rmem_max, and look for a sender that floods",
            )


def _rows(status: Mapping[str, Any], name: str) -> list[dict[str, Any]]:
    """The objects of a list in a status, which any program that may write to the local root can serve."""
    rows = status.get(name)
    return [row for row in rows if isinstance(row, dict)] if isinstance(rows, list) else []


def check_machine(port: int, root: Path, group: str, chosen: Sequence[str]) -> Iterator[Finding]:
    """All checks of this machine."""
    status = node_status.read_at_once(root)
    found = interfaces()
    yield check_port(port, root, status)
    yield check_sockets(root)
    yield from check_interfaces(found, chosen)
    try:
        table = IGMP_TABLE.read_text()
    except OSError as error:
        yield warn("group", "the joined groups are not known", f"{IGMP_TABLE}: {error.strerror}", "run it on Linux")
    else:
        yield check_joined(memberships(table), found, group, chosen, is_free=_is_free(port))
    yield from check_status(status)
    yield check_clock(datetime.now(UTC))
