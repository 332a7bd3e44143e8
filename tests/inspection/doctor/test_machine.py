"""Each diagnosis of this machine: by a fault on a port or in a directory of the test, or by the text of a table."""

from __future__ import annotations

import os
import socket
from collections.abc import Iterator
from contextlib import contextmanager
from datetime import UTC, datetime
from pathlib import Path

import pytest

from jauspy.inspection.doctor import machine
from jauspy.inspection.doctor.findings import Severity, has_failed
from jauspy.inspection.doctor.machine import Interface, check_interfaces, check_joined, check_port, check_sockets
from jauspy.node import NodeConfig, NodeManager
from jauspy.protocol import junior
from jauspy.transport import node_status

GROUP = "239.255.0.1"
IGMP = """Idx\tDevice    : Count Querier\tGroup    Users Timer\tReporter
1\tlo        :     1      V3
\t\t\t\t010000E0     1 0:00000000\t\t0
2\teth0      :     2      V3
\t\t\t\t0100FFEF     1 0:00000000\t\t0
\t\t\t\t010000E0     1 0:00000000\t\t0
\t\t\t\tnonsense     1 0:00000000\t\t0
3\twlan0     :     1      V3
\t\t\t\t010000E0     1 0:00000000\t\t0
"""
LO = Interface("lo", ("127.0.0.1",), True, 65536, frozenset({"up", "loopback"}))
ETH = Interface("eth0", ("10.0.0.5",), True, 1500, frozenset({"up", "broadcast", "multicast"}))
WLAN = Interface("wlan0", ("10.0.1.5",), True, 1500, frozenset({"up", "multicast"}))


@contextmanager
def taken(port: int) -> Iterator[None]:
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as sock:
        sock.bind(("0.0.0.0", port))
        yield


def test_port_of_another_process(free_port: int, root: Path) -> None:
    with taken(free_port):
        found = check_port(free_port, root, {})
    assert found.severity is Severity.FAIL
    assert f"UDP port {free_port} is taken by process {os.getpid()} (" in found.what


def test_free_port(free_port: int, root: Path) -> None:
    found = check_port(free_port, root, {})
    assert (found.severity, found.what) == (
        Severity.WARN,
        f"no node manager is on UDP port {free_port} of this machine",
    )


async def test_node_manager_on_the_port_and_on_another(free_port: int, root: Path) -> None:
    config = NodeConfig.make(local_root=root, port=free_port, address="127.0.0.1")
    async with NodeManager(config):
        status = await node_status.read(root)
        assert check_port(free_port, root, status).severity is Severity.OK
        other = check_port(free_port - 1, root, status)
        assert check_sockets(root).severity is Severity.OK
    assert other.severity is Severity.FAIL
    assert "is not on UDP port" in other.what


def test_sockets(root: Path) -> None:
    assert check_sockets(root / "missing").severity is Severity.FAIL
    assert check_sockets(root).severity is Severity.WARN
    with socket.socket(socket.AF_UNIX, socket.SOCK_DGRAM) as sock:
        sock.bind(str(root / junior.SOCKET_NAME))
    assert "is left over" in check_sockets(root).what


@pytest.mark.skipif(os.geteuid() != 0, reason="needs root to act as another user")
def test_socket_of_another_user(root: Path) -> None:
    path = root / junior.SOCKET_NAME
    root.chmod(0o777)
    for folder in root.parents:
        if folder.stat().st_mode & 0o005 != 0o005:
            pytest.skip(f"other users may not enter {folder}")
    with socket.socket(socket.AF_UNIX, socket.SOCK_DGRAM) as sock:
        sock.bind(str(path))
        path.chmod(0o600)
        os.seteuid(65534)
        try:
            found = check_sockets(root)
        finally:
            os.seteuid(0)
    assert found.severity is Severity.FAIL
    assert "this user may not use" in found.what
    assert found.evidence.startswith("srw------- root:root")


def test_interfaces() -> None:
    down = Interface("eth1", ("10.0.2.5",), False, 1500, frozenset())
    tunnel = Interface("tun0", ("10.9.0.2",), True, 576, frozenset({"up", "pointopoint"}))
    found = list(check_interfaces([LO, ETH, down, tunnel], ()))
    faults = {finding.what for finding in found if finding.severity is Severity.FAIL}
    assert faults == {
        "interface eth1 (10.0.2.5) is down",
        "interface tun0 (10.9.0.2) does not send multicasts, which discovery needs",
    }
    (small,) = [finding for finding in found if finding.severity is Severity.WARN]
    assert small.what == "tun0 has an MTU of 576 bytes only"
    assert "takes 8 IP fragments" in small.evidence
    (alone,) = check_interfaces([LO], ())
    assert alone.what == "no interface leads to another machine"
    (missing,) = check_interfaces([LO, ETH], ("10.0.0.9",))
    assert missing.what == "this machine has no interface 10.0.0.9"


def test_groups() -> None:
    joined = machine.memberships(IGMP)
    assert joined == {
        "lo": {"224.0.0.1"},
        "eth0": {"239.255.0.1", "224.0.0.1"},
        "wlan0": {"224.0.0.1"},
    }
    assert check_joined(joined, [LO, ETH], GROUP, ()).severity is Severity.OK
    partly = check_joined(joined, [LO, ETH, WLAN], GROUP, ())
    assert (partly.severity, partly.what) == (Severity.WARN, f"{GROUP} is joined on eth0, but not on wlan0")
    assert check_joined(joined, [LO, WLAN], GROUP, ()).severity is Severity.FAIL
    assert check_joined(joined, [LO, WLAN], GROUP, (), is_free=True).severity is Severity.WARN
    assert machine.memberships("") == {}


def test_clock() -> None:
    assert has_failed([machine.check_clock(datetime(1970, 1, 1, tzinfo=UTC))])
    assert not has_failed([machine.check_clock(datetime(2026, 1, 1, tzinfo=UTC))])


def test_counters_of_the_node_manager() -> None:
    status = {
        "clashes": [{"id": "101.1.1", "address": "10.0.0.7:3794", "heard": 1.0}, "no object"],
        "counters": {"dropped.auth.unknown_key": 3, "dropped.malformed.size": 2, "sent": 9},
        "networks": [{"name": "lan", "receive_buffer": {"dropped": 4, "limit": 1000}}, {"receive_buffer": None}],
    }
    found = [finding.what for finding in machine.check_status(status)]
    assert found == [
        "101.1.1 is used on this machine and at 10.0.0.7:3794",
        "3 packets were dropped, because they are not authenticated with the key of the network",
        "2 packets were dropped, because they are malformed",
        "4 datagrams were lost before the node manager read them",
    ]
    assert list(machine.check_status({})) == []
    assert list(machine.check_status({"clashes": 1, "counters": [], "networks": {}})) == []
