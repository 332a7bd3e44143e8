"""A bad switch between Ethernet ports, run as a program: loses, delays, doubles and reorders UDP, and passes the rest.

python relay.py '{"ports": ["p0", "p1"], "loss": 0.1, "twice": 0.05, "delay": 0.02, "seed": 1}'
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


def main() -> None:
    reported = json.loads(sys.argv[1])
    chance = random.Random(reported["seed"])
    selector = selectors.DefaultSelector()
    sockets = []
    for name in reported["ports"]:
        sock = socket.socket(socket.AF_PACKET, socket.SOCK_RAW, socket.htons(ALL_FRAMES))
        sock.bind((name, ALL_FRAMES))
        sock.setblocking(False)
        selector.register(sock, selectors.EVENT_READ)
        sockets.append(sock)
    late: list[tuple[float, int, socket.socket, bytes]] = []
    order = itertools.count()
    print("ready", flush=True)
    while True:
        pause = late[0][0] - time.monotonic() if late else None
        for key, _ in selector.select(None if pause is None else max(pause, 0)):
            frame, sender = key.fileobj.recvfrom(70000)  # type: ignore[union-attr]
            if sender[2] == OUTGOING:
                continue
            bad = frame[23:24] == UDP
            for sock in sockets:
                if sock is key.fileobj or (bad and chance.random() < reported["loss"]):
                    continue
                for _ in range(1 + (bad and chance.random() < reported["twice"])):
                    at = time.monotonic() + (reported["delay"] * chance.random() if bad else 0)
                    heapq.heappush(late, (at, next(order), sock, frame))
        while late and late[0][0] <= time.monotonic():
            _, _, sock, frame = heapq.heappop(late)
            try:
                sock.send(frame)
            except OSError:  # its other end is gone, or its queue is full: frames are lost on such a switch
                continue


if __name__ == "__main__":
    main()
