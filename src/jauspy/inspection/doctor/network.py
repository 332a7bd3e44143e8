"""Checks of the network: whether multicasts leave and come back, who answers, from which port, and how far away."""

from __future__ import annotations

import errno
import os
from collections.abc import Iterator, Sequence
from typing import Final

from jauspy.ids import JausID
from jauspy.inspection.doctor.findings import Finding, fail, ok, warn
from jauspy.inspection.doctor.probe import Probe, Reply
from jauspy.protocol import judp
from jauspy.transport import multicast

INITIAL_TTLS: Final = (64, 128, 255)
"""TTLs that systems send unicasts with."""
DENIED: Final = frozenset({os.strerror(errno.EPERM), os.strerror(errno.EACCES)})
"""What the kernel answers when a rule of a firewall rejects what is sent."""
MAX_LISTED: Final = 8
"""Addresses or ids that a sentence names."""


def check_network(probe: Probe, own: frozenset[str] | None = None) -> Iterator[Finding]:
    """What the answers to discovery tell. `own` are the addresses of this machine."""
    own = multicast.own_addresses() if own is None else own
    yield from check_sending(probe)
    yield from check_group(probe)
    yield _check_answers(probe, own)
    yield from check_source_ports(probe.replies, probe.group[1])
    yield from check_ttl(probe)
    yield from check_duplicates(probe.replies)
    for address, problem in list(probe.malformed.items())[:MAX_LISTED]:
        yield warn(
            "header",
            f"{_text(address)} sends packets that are not AS5669A",
            problem,
            "look at them with `jauspy record` and `jauspy decode`; its version of JUDP may be older",
        )


def check_sending(probe: Probe) -> Iterator[Finding]:
    """Interfaces by which nothing could be sent, with the error of the system."""
    for interface, problem in probe.errors.items():
        denied = problem in DENIED
        yield fail(
            "firewall" if denied else "sending",
            f"nothing can be sent by {interface}: {problem}",
            f"UDP from {interface} to {_text(probe.group)}",
            f"a firewall of this machine rejects it; allow UDP port {probe.group[1]} out: nft list ruleset, ufw status"
            if denied
            else f"give {interface} a route for multicasts: ip route add 224.0.0.0/4 dev DEVICE",
        )


def check_group(probe: Probe) -> Iterator[Finding]:
    """Whether the doctor's own multicasts came back, as they do unless something of this machine filters them."""
    if probe.group_problem:
        yield warn(
            "multicast",
            f"{_text(probe.group)} could not be listened to: {probe.group_problem}",
            "a program has the port for itself: a node manager of another user, or one of the JAUS Toolset",
            "stop that program for a moment to have this checked, too",
        )
        return
    for interface in probe.interfaces:
        if interface in probe.own_multicast:
            yield ok("multicast", f"multicasts by {interface} leave and arrive")
        elif interface not in probe.errors:
            yield fail(
                "firewall",
                f"multicasts that arrive by {interface} are filtered on this machine",
                f"what was sent to {_text(probe.group)} did not come back to the doctor's own socket",
                f"allow UDP port {probe.group[1]} in: nft add rule inet filter input udp dport {probe.group[1]} accept",
            )


def _check_answers(probe: Probe, own: frozenset[str]) -> Finding:
    ids = sorted({reply.source for reply in probe.replies})
    if not ids:
        return fail(
            "discovery",
            "nobody answered discovery",
            f"QueryIdentification to {_text(probe.group)} by {', '.join(probe.interfaces) or 'no interface'}",
            "start a robot (`jauspy up inc1`), or connect to its network; switches with IGMP snooping need a querier",
        )
    elsewhere = {reply.address[0] for reply in probe.replies} - own
    where = _listed(sorted(elsewhere)) if elsewhere else "on this machine only"
    return ok("discovery", f"{len(ids)} components answered, {where}", _listed([str(id) for id in ids]))


def check_source_ports(replies: Sequence[Reply], port: int) -> Iterator[Finding]:
    """Peers that answer from another port than the registered one."""
    odd = sorted({reply.address for reply in replies if reply.address[1] != port})
    if odd:
        yield warn(
            "source port",
            f"answers come from other ports than {port}: {_listed([_text(a) for a in odd])}",
            "a firewall that allows only this port drops them, and peers that answer to it do not reach them",
            f"let the peer send from UDP port {port} (a node manager there does), or allow its port in firewalls",
        )
    elif replies:
        yield ok("source port", f"all answers come from UDP port {port}")


def hops(ttl: int) -> int:
    """Routers that a unicast has passed, by the usual initial values of the TTL."""
    return next(initial for initial in INITIAL_TTLS if initial >= ttl) - ttl


def check_ttl(probe: Probe) -> Iterator[Finding]:
    """Peers behind routers, and multicasts that the next router would stop."""
    distances = {reply.address[0]: hops(reply.ttl) for reply in probe.replies if reply.ttl is not None}
    routed = {host: count for host, count in distances.items() if count > 0}
    far = {host: count for host, count in routed.items() if count >= judp.MULTICAST_TTL}
    if far:
        yield fail(
            "TTL",
            f"multicasts do not reach {_listed(sorted(far))}",
            f"{max(far.values())} routers away, and the TTL of multicasts is {judp.MULTICAST_TTL}",
            "raise multicast_ttl of both node managers, or give static addresses (docs/node-manager.md)",
        )
    elif routed:
        yield warn(
            "TTL",
            f"{_listed(sorted(routed))} is behind routers",
            f"{max(routed.values())} routers by the TTL of its answers",
            "routers pass multicasts only if told to; give static addresses (docs/node-manager.md) where they do not",
        )
    short = {address[0]: ttl for address, ttl in probe.group_heard.items() if ttl is not None and ttl <= 1}
    if short:
        yield warn(
            "TTL",
            f"multicasts of {_listed(sorted(short))} have a TTL of 1",
            "the first router on the way drops them",
            f"set MulticastTTL of its node manager to {judp.MULTICAST_TTL}, as the standard's are",
        )
    if distances and not routed and not short:
        yield ok("TTL", "no router is on the way to those that answered")


def check_duplicates(replies: Sequence[Reply]) -> Iterator[Finding]:
    """Ids that answered one question from two machines."""
    seen: dict[tuple[JausID, str], set[str]] = {}
    for reply in replies:
        seen.setdefault((reply.source, reply.interface), set()).add(_text(reply.address))
    for id, addresses in sorted({id: hosts for (id, _), hosts in seen.items() if len(hosts) > 1}.items()):
        yield fail(
            "duplicate id",
            f"{id} is used twice",
            f"answers from {_listed(sorted(addresses))}",
            "give one of both another id; until then each message reaches one of them, and not always the same",
        )


def _listed(names: Sequence[str]) -> str:
    rest = len(names) - MAX_LISTED
    return ", ".join(names[:MAX_LISTED]) + (f" and {rest} more" if rest > 0 else "")


def _text(address: tuple[str, int]) -> str:
    return f"{address[0]}:{address[1]}"
