"""Users of UDP ports, and who may use a local socket."""

import os
import pwd
import socket
from pathlib import Path

import pytest

from jauspy.node import local_users
from jauspy.node.local_users import LocalUsers, users_of
from jauspy.protocol.addressing import TcpPort, UdpPort

ME = os.geteuid()


@pytest.mark.parametrize(
    ("family", "address"),
    [
        (socket.AF_INET, "127.0.0.1"),
        (socket.AF_INET, "0.0.0.0"),
        (socket.AF_INET6, "::"),
        (socket.AF_INET6, "::ffff:127.0.0.1"),
    ],
)
def test_the_user_of_a_port_is_found(family: socket.AddressFamily, address: str) -> None:
    try:
        sock = socket.socket(family, socket.SOCK_DGRAM)
        sock.bind((address, 0))
    except OSError:
        pytest.skip("this system has no IPv6")
    with sock:
        port = UdpPort("127.0.0.1", sock.getsockname()[1])
        mine, others = LocalUsers(lambda user: user == ME), LocalUsers(lambda user: user != ME)
        assert (mine.may_connect(port), mine.is_abandoned(port), mine.has_left(port)) == (True, False, False)
        assert (others.may_connect(port), others.is_abandoned(port), others.has_left(port)) == (False, True, True)
    assert (mine.may_connect(port), mine.is_abandoned(port)) == (False, True)


def test_addresses_of_other_machines_are_not_judged() -> None:
    users = LocalUsers(lambda user: False)
    for port in (UdpPort("192.0.2.1", 9), UdpPort("fe80::1%2", 9), TcpPort("127.0.0.1", 9)):
        assert not users.is_abandoned(port)


def test_readings_are_limited_and_without_one_nobody_comes_and_nobody_goes(monkeypatch: pytest.MonkeyPatch) -> None:
    users, nobody = LocalUsers(lambda user: True, lambda: 0.0), UdpPort("127.0.0.1", 1)
    read: list[int] = []
    owners = {1: {("127.0.0.1", 7)}}
    monkeypatch.setattr(local_users, "read_port_owners", lambda: read.append(1) or owners)
    for _ in range(3 * int(local_users.READ_RATE)):
        users.may_connect(nobody)
    assert len(read) == local_users.READ_RATE
    assert (users.may_connect(nobody), users.is_abandoned(nobody), users.has_left(nobody)) == (False, False, False)


def test_a_system_without_a_list_of_ports(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.setattr(local_users, "PORT_LISTS", (tmp_path / "nothing",))
    users, nobody = LocalUsers(lambda user: True), UdpPort("127.0.0.1", 1)
    assert (users.may_connect(nobody), users.is_abandoned(nobody), users.has_left(nobody)) == (False, False, False)


def test_the_mode_of_the_socket_decides(tmp_path: Path) -> None:
    path = tmp_path / "socket"
    path.touch()
    me, group = os.geteuid(), path.stat().st_gid
    other = next(user.pw_uid for user in pwd.getpwall() if user.pw_gid not in (group, 0) and user.pw_uid not in (me, 0))
    answers = {}
    for mode in (0o600, 0o660, 0o666):
        path.chmod(mode)
        may_use = users_of(path)
        answers[mode] = (may_use(0), may_use(me), may_use(other))
    assert answers == {0o600: (True, True, False), 0o660: (True, True, False), 0o666: (True, True, True)}


def test_members_of_the_group_may_use_it(tmp_path: Path) -> None:
    member = next((user for user in pwd.getpwall() if user.pw_uid not in (ME, 0)), None)
    if ME or member is None:
        pytest.skip("needs root to give a file to another group")
    path = tmp_path / "socket"
    path.touch()
    os.chown(path, 0, member.pw_gid)
    path.chmod(0o660)
    assert users_of(path)(member.pw_uid)
    path.chmod(0o600)
    assert not users_of(path)(member.pw_uid)
