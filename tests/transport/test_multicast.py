"""The multicast group on interfaces that come and go."""

import errno
import logging
import os
import socket
from types import SimpleNamespace
from typing import Any

import psutil
import pytest

from jauspy.transport import multicast
from jauspy.transport.multicast import ALL_INTERFACES, Memberships

GROUP = "239.255.0.1"


class Machine:
    """Interfaces by name with their addresses, and a socket on it that can join where `down` does not say otherwise."""

    def __init__(self) -> None:
        self.interfaces: dict[str, list[str]] = {"lo": ["127.0.0.1"], "eth0": ["10.0.0.1", "10.0.0.2"]}
        self.down: set[str] = set()
        self.members: set[str] = set()

    def addresses(self) -> dict[str, list[Any]]:
        found = {
            name: [SimpleNamespace(family=socket.AF_INET, address=each) for each in own]
            for name, own in self.interfaces.items()
        }
        for own in found.values():
            own.append(SimpleNamespace(family=socket.AF_INET6, address="fe80::1"))
        return found

    def setsockopt(self, level: int, option: int, value: bytes) -> None:
        assert level == socket.IPPROTO_IP
        assert value[:4] == socket.inet_aton(GROUP)
        interface = socket.inet_ntoa(value[4:])
        if option == socket.IP_DROP_MEMBERSHIP:
            self.members.discard(interface)
        elif interface in self.down:
            raise OSError(errno.ENODEV, os.strerror(errno.ENODEV))
        elif interface in self.members:
            raise OSError(errno.EADDRINUSE, os.strerror(errno.EADDRINUSE))
        else:
            self.members.add(interface)

    def join(self, *chosen: str) -> Memberships:
        return Memberships(self, GROUP, chosen)  # type: ignore[arg-type]  # all that is used of a socket


@pytest.fixture
def machine(monkeypatch: pytest.MonkeyPatch) -> Machine:
    made = Machine()
    monkeypatch.setattr(psutil, "net_if_addrs", made.addresses)
    return made


@pytest.mark.parametrize(
    ("chosen", "found"),
    [
        ([ALL_INTERFACES], ("10.0.0.1", "10.0.0.2")),
        (["eth0"], ("10.0.0.1", "10.0.0.2")),
        (["10.0.0.2", "10.0.0.9"], ("10.0.0.2",)),
        (["wlan0"], ()),
        ([multicast.ANY], (multicast.ANY,)),
        (["lo", ALL_INTERFACES, "10.0.0.1"], ("127.0.0.1", "10.0.0.1", "10.0.0.2")),
    ],
)
def test_interfaces_are_selected_by_address_name_or_all(machine: Machine, chosen: list[str], found: tuple[str]) -> None:
    assert multicast.addresses(chosen) == found


def test_present_interfaces_are_joined_and_others_warned_once(
    machine: Machine, caplog: pytest.LogCaptureFixture
) -> None:
    joining = machine.join("10.0.0.1", "10.0.0.9")
    joining.refresh()
    assert (machine.members, joining.joined) == ({"10.0.0.1"}, 1)
    [warning] = caplog.messages
    assert "no multicasts on interface 10.0.0.9: No such device" in warning


def test_late_interface_is_joined_and_logged(machine: Machine, caplog: pytest.LogCaptureFixture) -> None:
    machine.down.add(multicast.ANY)
    joining = machine.join(multicast.ANY)
    assert joining.joined == 0
    machine.down.clear()
    joining.refresh()
    joining.refresh()
    assert (machine.members, joining.joined) == ({multicast.ANY}, 1)
    assert caplog.messages[1:] == [f"joined {GROUP} on {multicast.ANY}"]


def test_returning_interface_is_joined_again(machine: Machine, caplog: pytest.LogCaptureFixture) -> None:
    joining = machine.join("10.0.0.1")
    machine.down.add("10.0.0.1")
    machine.members.clear()
    joining.refresh()
    assert joining.joined == 0
    machine.down.clear()
    joining.refresh()
    assert (machine.members, joining.joined) == ({"10.0.0.1"}, 1)
    assert [record.levelno for record in caplog.records] == [logging.WARNING, logging.WARNING]


def test_memberships_follow_interfaces(machine: Machine) -> None:
    joining = machine.join(ALL_INTERFACES)
    assert joining.current == ("10.0.0.1", "10.0.0.2")
    machine.interfaces["wlan0"] = ["10.1.0.1"]
    del machine.interfaces["eth0"]
    joining.refresh()
    assert (joining.current, joining.joined, machine.members) == (("10.1.0.1",), 1, {"10.1.0.1"})


def test_two_addresses_of_one_interface_are_both_joined() -> None:
    """To the kernel the second one is in use already."""
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as sock:
        if not Memberships(sock, GROUP, ["127.0.0.1"]).joined:
            pytest.skip("this kernel does not multicast on its loopback interface")
        assert Memberships(sock, GROUP, ["127.0.0.1", "127.0.0.2"]).joined == 2


@pytest.mark.parametrize(
    ("chosen", "found"),
    [
        (ALL_INTERFACES, ("eth0", "wlan0")),
        ("wlan0", ("wlan0",)),
        ("fd00::1", ("eth0",)),
        ("10.0.0.1", ("eth0",)),
        ("127.0.0.1", ("lo",)),
        (multicast.ANY, (multicast.ANY,)),
        ("eth1", ()),
    ],
)
def test_ipv6_interfaces_are_selected_by_name_or_address(
    monkeypatch: pytest.MonkeyPatch, chosen: str, found: tuple[str, ...]
) -> None:
    four, six = socket.AF_INET, socket.AF_INET6
    machine = {
        "lo": [(four, "127.0.0.1"), (six, "::1")],
        "eth0": [(four, "10.0.0.1"), (six, "fe80::1%eth0"), (six, "fd00::1")],
        "eth1": [(four, "10.0.0.2")],
        "wlan0": [(six, "fe80::2%wlan0")],
    }
    reported = {
        name: [SimpleNamespace(family=family, address=address) for family, address in own]
        for name, own in machine.items()
    }
    monkeypatch.setattr(psutil, "net_if_addrs", lambda: reported)
    assert multicast.names([chosen]) == found
