"""Joining the multicast group where and when the network lets us."""

import errno
import logging
import os
import socket

import pytest

from jauspy.transport.memberships import Memberships


class Network:
    """Stands in for a socket: a membership is possible on interfaces that are `up`."""

    def __init__(self, *up: str) -> None:
        self.up = set(up)
        self.members: set[str] = set()

    def setsockopt(self, level: int, option: int, value: bytes) -> None:
        assert (level, option) == (socket.IPPROTO_IP, socket.IP_ADD_MEMBERSHIP)
        assert value[:4] == bytes([239, 255, 0, 1])
        interface = socket.inet_ntoa(value[4:])
        if interface not in self.up:
            raise OSError(errno.ENODEV, os.strerror(errno.ENODEV))
        if interface in self.members:
            raise OSError(errno.EADDRINUSE, os.strerror(errno.EADDRINUSE))
        self.members.add(interface)


def memberships(network: Network, *interfaces: str) -> Memberships:
    return Memberships(network, "239.255.0.1", interfaces)  # type: ignore[arg-type]  # all that is used of a socket


def test_joins_where_it_can_and_warns_once_of_the_rest(caplog: pytest.LogCaptureFixture) -> None:
    network = Network("10.0.0.1")
    joining = memberships(network, "10.0.0.1", "10.0.0.2")
    joining.refresh()
    assert (network.members, joining.joined) == ({"10.0.0.1"}, 1)
    [warning] = caplog.messages
    assert "no multicasts on interface 10.0.0.2: No such device" in warning


def test_joins_later_and_says_so(caplog: pytest.LogCaptureFixture) -> None:
    network = Network()
    joining = memberships(network, "0.0.0.0")
    network.up.add("0.0.0.0")
    joining.refresh()
    joining.refresh()
    assert (network.members, joining.joined) == ({"0.0.0.0"}, 1)
    assert caplog.messages[1:] == ["joined 239.255.0.1 on 0.0.0.0"]


def test_joins_again_on_an_interface_that_went_and_came_back(caplog: pytest.LogCaptureFixture) -> None:
    network = Network("10.0.0.1")
    joining = memberships(network, "10.0.0.1")
    network.up.clear()
    network.members.clear()
    joining.refresh()
    assert joining.joined == 0
    network.up.add("10.0.0.1")
    joining.refresh()
    assert (network.members, joining.joined) == ({"10.0.0.1"}, 1)
    assert [record.levelno for record in caplog.records] == [logging.WARNING, logging.WARNING]
