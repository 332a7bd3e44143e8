"""The multicast group on interfaces that come and go."""

import socket
from types import SimpleNamespace
from typing import Any

import psutil
import pytest

from jauspy.transport import memberships, multicast
from jauspy.transport.memberships import ALL, Memberships

GROUP = "239.255.0.7"


class Machine:
    """Interfaces by name with their addresses, and what was joined."""

    def __init__(self) -> None:
        self.interfaces: dict[str, list[str]] = {"lo": ["127.0.0.1"], "eth0": ["10.0.0.1", "10.0.0.2"]}
        self.down: set[str] = set()
        self.joined: list[str] = []

    def addresses(self) -> dict[str, list[Any]]:
        found = {
            name: [SimpleNamespace(family=socket.AF_INET, address=each) for each in own]
            for name, own in self.interfaces.items()
        }
        for own in found.values():
            own.append(SimpleNamespace(family=socket.AF_INET6, address="fe80::1"))
        return found

    def join(self, _sock: object, _group: str, interfaces: list[str]) -> int:
        new = [each for each in interfaces if each not in self.down]
        self.joined += new
        return len(new)


@pytest.fixture
def machine(monkeypatch: pytest.MonkeyPatch) -> Machine:
    made = Machine()
    monkeypatch.setattr(psutil, "net_if_addrs", made.addresses)
    monkeypatch.setattr(multicast, "join", made.join)
    return made


@pytest.mark.parametrize(
    ("chosen", "found"),
    [
        ([ALL], ("10.0.0.1", "10.0.0.2")),
        (["eth0"], ("10.0.0.1", "10.0.0.2")),
        (["10.0.0.2", "10.0.0.9"], ("10.0.0.2",)),
        (["wlan0"], ()),
        ([multicast.ANY], (multicast.ANY,)),
        (["lo", ALL, "10.0.0.1"], ("127.0.0.1", "10.0.0.1", "10.0.0.2")),
    ],
)
def test_interfaces_are_chosen_by_address_name_or_all(machine: Machine, chosen: list[str], found: tuple[str]) -> None:
    assert memberships.addresses(chosen) == found


def test_joins_what_comes_and_leaves_what_goes(machine: Machine) -> None:
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as sock:
        held = Memberships(sock, GROUP, [ALL])
        assert held.current == ("10.0.0.1", "10.0.0.2")
        machine.interfaces["wlan0"] = ["10.1.0.1"]
        del machine.interfaces["eth0"]
        held.refresh()
        assert (held.current, held.joined) == (("10.1.0.1",), 1)
        machine.interfaces["eth0"] = ["10.0.0.1"]
        held.refresh()
        assert machine.joined == ["10.0.0.1", "10.0.0.2", "10.1.0.1", "10.0.0.1"]


def test_tries_again_where_it_did_not_work(machine: Machine) -> None:
    machine.down.add(multicast.ANY)
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as sock:
        held = Memberships(sock, GROUP, [multicast.ANY])
        assert held.joined == 0
        machine.down.clear()
        held.refresh()
        held.refresh()
        assert machine.joined == [multicast.ANY]


def test_two_addresses_of_one_interface_are_both_joined() -> None:
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as sock:
        if not multicast.join(sock, GROUP, ["127.0.0.1"]):
            pytest.skip("this kernel does not multicast on its loopback interface")
        assert multicast.join(sock, GROUP, ["127.0.0.1"]) == 1
