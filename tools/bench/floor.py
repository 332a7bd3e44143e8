"""The floor that the node manager is measured against: forwards datagrams between two fixed sockets, no routing at all.

python tools/bench/floor.py A_IN A_OUT B_IN B_OUT; each `unix:PATH` or `udp:PORT` on 127.0.0.1. What arrives at A_IN
goes to B_OUT, what arrives at B_IN goes to A_OUT.
"""

from __future__ import annotations

import selectors
import socket
import sys

BURST = 64


def address(text: str) -> tuple[socket.AddressFamily, str | tuple[str, int]]:
    """Family and address of `unix:PATH` or `udp:PORT`."""
    kind, _, rest = text.partition(":")
    return (socket.AF_UNIX, rest) if kind == "unix" else (socket.AF_INET, ("127.0.0.1", int(rest)))


def bound(text: str) -> socket.socket:
    """A socket to receive on."""
    family, where = address(text)
    sock = socket.socket(family, socket.SOCK_DGRAM)
    sock.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 1 << 22)
    sock.bind(where)
    return sock


def main(a_in: str, a_out: str, b_in: str, b_out: str) -> None:
    """Forward until killed."""
    selector = selectors.DefaultSelector()
    for source, target in ((a_in, b_out), (b_in, a_out)):
        family, where = address(target)
        selector.register(bound(source), selectors.EVENT_READ, (socket.socket(family, socket.SOCK_DGRAM), where))
    print("ready", flush=True)
    buffer = bytearray(65536)
    view = memoryview(buffer)
    while True:
        for key, _ in selector.select():
            out, where = key.data
            for _ in range(BURST):
                try:
                    size = key.fileobj.recv_into(buffer, 0, socket.MSG_DONTWAIT)  # type: ignore[union-attr]
                except BlockingIOError:
                    break
                out.sendto(view[:size], where)


if __name__ == "__main__":
    main(*sys.argv[1:])
