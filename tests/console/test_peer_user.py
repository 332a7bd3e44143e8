"""The user at the other end of a connection over loopback."""

from __future__ import annotations

import os
import socket
import subprocess
import sys

import pytest

from jauspy.console.peer_user import LISTS, peer_user

pytestmark = pytest.mark.skipif(not LISTS[0].exists(), reason="the system does not list the users of connections")
NOBODY = 65534
CONNECT = """
import os, socket, sys
os.setuid(int(sys.argv[2]))
sock = socket.socket()
sock.connect(("127.0.0.1", int(sys.argv[1])))
sys.stdin.read()
"""


@pytest.mark.parametrize(
    ("family", "listening", "address"),
    [
        (socket.AF_INET, "127.0.0.1", "127.0.0.1"),
        (socket.AF_INET6, "::1", "::1"),
        (socket.AF_INET6, "127.0.0.1", "::ffff:127.0.0.1"),
    ],
)
def test_the_own_user(family: socket.AddressFamily, listening: str, address: str) -> None:
    try:
        listener = socket.create_server((listening, 0), family=socket.AF_INET6 if ":" in listening else socket.AF_INET)
    except OSError:
        pytest.skip("this machine has no IPv6")
    with listener, socket.socket(family) as client:
        client.connect((address, listener.getsockname()[1]))
        accepted, peer = listener.accept()
        with accepted:
            assert peer_user(peer[:2], accepted.getsockname()[:2]) == os.getuid()
            assert peer_user((peer[0], peer[1] ^ 1), accepted.getsockname()[:2]) is None
    assert peer_user(("testclient", 1), ("localhost", 80)) is None


@pytest.mark.skipif(os.getuid() != 0, reason="needs root, to be another user")
def test_another_user() -> None:
    with socket.create_server(("127.0.0.1", 0)) as listener:
        command = [sys.executable, "-c", CONNECT, str(listener.getsockname()[1]), str(NOBODY)]
        listener.settimeout(20.0)
        with subprocess.Popen(command, stdin=subprocess.PIPE):
            accepted, peer = listener.accept()
            with accepted:
                assert peer_user(peer, accepted.getsockname()) == NOBODY
