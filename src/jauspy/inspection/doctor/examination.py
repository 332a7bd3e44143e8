"""The whole examination: this machine, the network, and one component if one is named. It takes about five seconds."""

from __future__ import annotations

import ipaddress
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Final

from jauspy.ids import JausID
from jauspy.inspection.doctor.findings import Finding
from jauspy.inspection.doctor.machine import check_machine, interfaces
from jauspy.inspection.doctor.network import check_network
from jauspy.inspection.doctor.peer import PeerExamination
from jauspy.inspection.doctor.probe import Probe
from jauspy.protocol import judp
from jauspy.protocol.address_book import Address
from jauspy.protocol.seal import OperatorKey
from jauspy.transport import multicast, node_status

DISCOVERY_TIME: Final = 1.0
"""Seconds to wait for answers to discovery."""
MAX_INTERFACES: Final = 8
ANY_ADDRESS: Final = "0.0.0.0"  # noqa: S104 # nosec B104 # compared only


@dataclass(frozen=True, slots=True, kw_only=True)
class Examination:
    """What to examine, and how."""

    ids: tuple[JausID, ...]
    """Ids of the doctor, one for each of `used_interfaces`."""
    used_interfaces: tuple[str, ...]
    """Addresses of the interfaces for queries."""
    root: Path
    chosen: tuple[str, ...] = ()
    """The interfaces that the user named; empty for all."""
    port: int = judp.PORT
    group: str = judp.MULTICAST_GROUP
    peer: JausID | None = None
    address: Address | None = None
    """Where the peer is, if discovery does not tell."""
    authority: int = 127
    """With what a client would request control; nothing is requested."""
    key: OperatorKey | None = None
    """The operator's key to test."""

    def findings(self) -> Iterator[Finding]:
        """All findings, in the order of the checks, each as soon as it is there."""
        yield from check_machine(self.port, self.root, self.group, self.chosen)
        with Probe(self.ids, self.used_interfaces, self.group, self.port) as probe:
            probe.discover(DISCOVERY_TIME)
            yield from check_network(probe)
            if self.peer is not None:
                address = self.address or known_address(self.root, self.peer, self.used_interfaces)
                yield from PeerExamination(probe, self.peer, address, self.authority, self.key).findings()


def usable_interfaces(chosen: tuple[str, ...]) -> tuple[str, ...]:
    """The addresses to send queries by: those of the chosen interfaces, else of all; this machine's own without any."""
    selected = multicast.addresses(chosen or (multicast.ALL_INTERFACES,))
    if not selected and not chosen:
        selected = tuple(address for i in interfaces() if i.is_loopback for address in i.addresses[:1])
    return selected[:MAX_INTERFACES]


def known_address(root: Path, id: JausID, own: tuple[str, ...] = ()) -> Address | None:
    """The address that the node manager of this machine has learned for a component, or its own for those attached.

    `own` are addresses of this machine, the first of which stands for a node manager that receives on all.
    """
    status = node_status.read_at_once(root)
    for peer in status.get("peers", ()):
        if str(peer["id"]) == str(id) and (address := _address(peer["address"])) is not None:
            return address
    if all(str(component["id"]) != str(id) for component in status.get("components", ())):
        return None
    networks = status.get("networks")
    for network in networks if isinstance(networks, list) else ():
        address = _address(network.get("address")) if isinstance(network, dict) else None
        if address is not None:
            return (own[0] if own and address[0] == ANY_ADDRESS else address[0]), address[1]
    return None


def _address(text: object) -> Address | None:
    """An IPv4 address with its port, as a status writes it."""
    host, _, port = str(text).rpartition(":")
    if not (port.isdecimal() and len(port) < 6 and _is_ipv4(host)):
        return None
    return host, min(int(port), 65535)


def _is_ipv4(host: str) -> bool:
    try:
        ipaddress.IPv4Address(host)
    except ValueError:
        return False
    return True
