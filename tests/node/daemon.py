"""A node manager with all links, and everybody around it, in hexadecimal."""

import contextlib
import os
import pty
import select
import socket
import struct
import subprocess
import sys
import tty
from pathlib import Path

import pytest

from jauspy.ids import JausID
from jauspy.node import NodeManager
from jauspy.node.config import load_config
from jauspy.sync.portal import Portal

TIMEOUT = 20
IP_RECVTTL = 12
"""From linux/in.h."""
TEN = "00010203040506070809"
CONFIG = """
address = "127.0.0.1"
port = {port}
local_root = "{root}"
tcp = true
multicast_group = "239.255.0.9"
[[serial]]
device = "{device}"
"""


CONNECT = "01 0000 0010 06 02 0100 00000000 {} 0000 0000"
ACCEPT = "01 0000 0010 06 02 0200 {} 00000000 0000 0000"
CANCEL = "01 0000 0010 06 02 0300 00000000 {} 0000 0000"
"""With the id of the component, low byte first."""


def plain(text: str) -> str:
    return bytes.fromhex(text).hex()


class End:
    """One who talks to the node manager, in hexadecimal."""

    def __init__(self, sock: socket.socket, node: str | tuple[str, int] | None) -> None:
        self.socket = sock
        self._node = node
        sock.settimeout(TIMEOUT)

    def says(self, text: str) -> None:
        if self._node is None:
            self.socket.sendall(bytes.fromhex(text))
        else:
            self.socket.sendto(bytes.fromhex(text), self._node)

    def next(self) -> str:
        return self.socket.recv(70000).hex()

    def hears(self, text: str) -> None:
        assert self.next() == plain(text)

    def hears_stream(self, text: str) -> None:
        arrived = b""
        while len(arrived) < len(plain(text)) // 2:
            arrived += self.socket.recv(1)
        assert arrived.hex() == plain(text)

    def hears_ttl(self) -> int:
        """How many routers the next datagram may still pass; set `IP_RECVTTL` before it comes."""
        _, ((_, _, ttl),), _, _ = self.socket.recvmsg(70000, 100)
        return int.from_bytes(ttl, sys.byteorder)

    def hears_nothing(self) -> None:
        """Until now; say before what would have come after it."""
        assert not select.select([self.socket], [], [], 0)[0]


class Daemon:
    """The node manager in a thread of this process, and everybody around it."""

    def __init__(self, stack: contextlib.ExitStack, root: Path, port: int) -> None:
        self._stack = stack
        self.root = root
        self.port = port
        self.line, device = pty.openpty()
        for file in (self.line, device):
            tty.setraw(file)
            stack.callback(os.close, file)
        config = root / "nm.toml"
        config.write_text(CONFIG.format(port=port, root=root, device=os.ttyname(device)))
        self._config = config
        self.start()

    def start(self) -> None:
        portal, manager = Portal("node manager"), NodeManager(load_config(self._config))
        portal.open()
        self._stack.callback(portal.close)
        portal.run(manager.open())
        self._stack.callback(lambda: portal.run(manager.close()))

    def component(self, id: int | str, *, connect: bool = True) -> End:
        """A component on its Unix socket, by the number that names it."""
        number = id if isinstance(id, int) else int(JausID.parse(id))
        sock = self._stack.enter_context(socket.socket(socket.AF_UNIX, socket.SOCK_DGRAM))
        (self.root / str(number)).unlink(missing_ok=True)
        sock.bind(str(self.root / str(number)))
        end = End(sock, str(self.root / "JuniorRTE"))
        if connect:
            own = struct.pack("<I", number).hex()
            end.says(CONNECT.format(own))
            end.hears(ACCEPT.format(own))
        return end

    def peer(self) -> End:
        """A node manager elsewhere, on a port of its own."""
        sock = self._stack.enter_context(socket.socket(socket.AF_INET, socket.SOCK_DGRAM))
        sock.bind(("127.0.0.1", 0))
        return End(sock, ("127.0.0.1", self.port))

    def group(self) -> End:
        """Whoever listens to the multicast group."""
        sock = self._stack.enter_context(socket.socket(socket.AF_INET, socket.SOCK_DGRAM))
        sock.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        sock.bind(("239.255.0.9", self.port))
        try:
            sock.setsockopt(
                socket.IPPROTO_IP,
                socket.IP_ADD_MEMBERSHIP,
                socket.inet_aton("239.255.0.9") + socket.inet_aton("127.0.0.1"),
            )
        except OSError:
            pytest.skip("this kernel does not multicast on its loopback interface")
        return End(sock, None)

    def stream(self) -> End:
        """A peer by TCP."""
        return End(self._stack.enter_context(socket.create_connection(("127.0.0.1", self.port))), None)


class DaemonProcess(Daemon):
    """`jauspy node-manager`, which can be killed and stopped."""

    def start(self) -> None:
        """Also again, after `die`."""
        command = (sys.executable, "-m", "jauspy.cli.main", "node-manager", "--config", str(self._config))
        self.process = self._stack.enter_context(
            subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
        )
        self._stack.callback(self.process.terminate)
        assert self.process.stdout is not None
        assert "ready" in self.process.stdout.readline()

    def die(self) -> None:
        """Without a word."""
        self.process.kill()
        self.process.wait()
