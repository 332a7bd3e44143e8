"""A bad switch between Ethernet ports, run as a program: loses, delays, doubles and reorders UDP, and passes the rest.

python relay.py '{"ports": ["p0", "p1"], "loss": 0.1, "twice": 0.05, "delay": 0.02, "seed": 1}'

`delay` is the longest of random delays, `latency` one that all frames have, in seconds. With `"wide_area": true` it is
a bad link over wide areas instead: all IPv4 is lost and delayed, so that the kernels' TCP sees it, and multicasts are
not carried. Lines on its input: `cut` (nothing passes but ARP), `mend`, and `stop`, which prints what it has carried
and how late it was, so that a user knows how much of what is measured is the relay's own.
"""

import heapq
import itertools
import json
import random
import selectors
import socket
import sys
import time

ALL_FRAMES = 3
OUTGOING = 4
UDP = b"\x11"
IPV4 = b"\x08\x00"
MAX_LATENESSES = 100_000
SO_RCVBUFFORCE = 33
"""Of asm-generic/socket.h; Python does not name it."""
RECEIVE_BUFFER = 8 << 20
"""Bytes, so that a burst is lost by chance and not because this program is slow."""


class Link:
    """Decides what becomes of a frame."""

    def __init__(self, settings: dict[str, float]) -> None:
        self.is_cut = False
        self._settings = settings
        self._chance = random.Random(settings["seed"])
        self._wide = bool(settings.get("wide_area", False))
        self.frames = self.bytes = self.lost = 0

    def delays(self, frame: bytes) -> list[float]:
        """Seconds until each copy of the frame arrives; none if it is lost."""
        self.frames += 1
        self.bytes += len(frame)
        settings, chance = self._settings, self._chance
        bad = frame[12:14] == IPV4 if self._wide else frame[23:24] == UDP
        gone = self._wide and (frame[0] & 1 or self.is_cut)
        if bad and (gone or chance.random() < settings["loss"]):
            self.lost += 1
            return []
        if not bad:
            return [0.0]
        copies = 1 + (chance.random() < settings["twice"])
        return [settings.get("latency", 0.0) + settings["delay"] * chance.random() for _ in range(copies)]

    def report(self, late: list[float]) -> str:
        """What it has carried."""
        late = sorted(late) or [0.0]
        times = {"late_p50": late[len(late) // 2], "late_p99": late[len(late) * 99 // 100], "late_max": late[-1]}
        return json.dumps({"frames": self.frames, "bytes": self.bytes, "lost": self.lost, **times})


def main() -> None:
    settings = json.loads(sys.argv[1])
    link = Link(settings)
    selector = selectors.DefaultSelector()
    sockets = []
    for name in settings["ports"]:
        sock = socket.socket(socket.AF_PACKET, socket.SOCK_RAW, socket.htons(ALL_FRAMES))
        sock.setsockopt(socket.SOL_SOCKET, SO_RCVBUFFORCE, RECEIVE_BUFFER)
        sock.bind((name, ALL_FRAMES))
        sock.setblocking(False)
        selector.register(sock, selectors.EVENT_READ)
        sockets.append(sock)
    selector.register(sys.stdin, selectors.EVENT_READ)
    waiting: list[tuple[float, int, socket.socket, bytes]] = []
    late: list[float] = []
    order = itertools.count()
    print("ready", flush=True)
    while True:
        pause = waiting[0][0] - time.monotonic() if waiting else None
        for key, _ in selector.select(None if pause is None else max(pause, 0)):
            if key.fileobj is sys.stdin:
                word = sys.stdin.readline().strip()
                if word == "stop":
                    print(link.report(late), flush=True)
                elif word:
                    link.is_cut = word == "cut"
                else:
                    selector.unregister(sys.stdin)
                continue
            frame, sender = key.fileobj.recvfrom(70000)  # type: ignore[union-attr]
            if sender[2] == OUTGOING:
                continue
            for sock in sockets:
                if sock is key.fileobj:
                    continue
                for delay in link.delays(frame):
                    heapq.heappush(waiting, (time.monotonic() + delay, next(order), sock, frame))
        while waiting and waiting[0][0] <= time.monotonic():
            at, _, sock, frame = heapq.heappop(waiting)
            if len(late) < MAX_LATENESSES:
                late.append(time.monotonic() - at)
            try:
                sock.send(frame)
            except OSError:  # its other end is gone, or its queue is full: frames are lost on such a switch
                continue


if __name__ == "__main__":
    main()
