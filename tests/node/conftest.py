"""Components and network peers as bytes."""

import contextlib
import socket
from collections.abc import Callable, Iterator
from contextlib import ExitStack
from pathlib import Path

import pytest
from tests.node.daemon import Daemon, DaemonProcess

from jauspy.ids import JausID
from jauspy.protocol import junior


@pytest.fixture
def stack() -> Iterator[ExitStack]:
    with ExitStack() as stack:
        yield stack


@pytest.fixture
def introduce(root: Path, stack: ExitStack) -> Callable[..., socket.socket]:
    """Makes the socket of a component and sends its Connect; the Accept is the first thing to arrive."""

    def make(id: JausID, folder: Path = root) -> socket.socket:
        sock = stack.enter_context(socket.socket(socket.AF_UNIX, socket.SOCK_DGRAM))
        sock.setblocking(False)
        sock.bind(str(folder / str(int(id))))
        sock.sendto(junior.connect(id), str(folder / junior.SOCKET_NAME))
        return sock

    return make


@pytest.fixture
def udp(stack: ExitStack) -> Callable[[], socket.socket]:
    """Makes a UDP socket on an address of this machine."""

    def make(host: str = "127.0.0.1") -> socket.socket:
        sock = stack.enter_context(socket.socket(socket.AF_INET, socket.SOCK_DGRAM))
        sock.setblocking(False)
        sock.bind((host, 0))
        return sock

    return make


@pytest.fixture
def daemon(root: Path, free_port: int) -> Iterator[Daemon]:
    with contextlib.ExitStack() as stack:
        yield Daemon(stack, root, free_port)


@pytest.fixture
def daemon_process(root: Path, free_port: int) -> Iterator[DaemonProcess]:
    with contextlib.ExitStack() as stack:
        yield DaemonProcess(stack, root, free_port)
