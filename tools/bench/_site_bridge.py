"""A bridge between sites over Zenoh, as a prototype for `tools/bench/sites.py`: no part of the product.

python _site_bridge.py '{"root": "/tmp/a", "listen": "tcp/10.77.0.1:7447", "own": "a", "other": "b", ...}'

Components of a site send to the socket `JuniorRTE` in its root, as to a node manager, and each datagram is published
for the other site with the priority of its header. What comes from there is sent to the sockets of the components.
"""

from __future__ import annotations

import json
import socket
import sys
from pathlib import Path
from typing import Any

import zenoh

from jauspy.protocol import judp, junior


def configuration(settings: dict[str, Any]) -> zenoh.Config:
    """A peer that listens or connects to one end point, finds nobody by multicast, and has the given further keys."""
    config = zenoh.Config()
    config.insert_json5("mode", '"peer"')
    config.insert_json5("scouting/multicast/enabled", "false")
    config.insert_json5("scouting/gossip/enabled", "false")
    config.insert_json5("listen/endpoints", json.dumps([settings["listen"]] if "listen" in settings else []))
    config.insert_json5("connect/endpoints", json.dumps([settings["connect"]] if "connect" in settings else []))
    for key, value in settings.get("config", {}).items():
        config.insert_json5(key, json.dumps(value))
    return config


def main() -> None:
    """Carry datagrams until the process is killed."""
    settings = json.loads(sys.argv[1])
    root = Path(settings["root"])
    session = zenoh.open(configuration(settings))
    ours = socket.socket(socket.AF_UNIX, socket.SOCK_DGRAM)
    ours.bind(str(root / junior.SOCKET_NAME))
    congestion = zenoh.CongestionControl.BLOCK if settings["block"] else zenoh.CongestionControl.DROP
    reliability = zenoh.Reliability.RELIABLE if settings["reliable"] else zenoh.Reliability.BEST_EFFORT
    priorities = (
        zenoh.Priority.DATA_LOW,
        zenoh.Priority.DATA,
        zenoh.Priority.INTERACTIVE_HIGH,
        zenoh.Priority.REAL_TIME,
    )
    publishers = [
        session.declare_publisher(
            f"site/{settings['other']}/{number}",
            congestion_control=congestion,
            priority=priority,
            express=True,
            reliability=reliability,
        )
        for number, priority in enumerate(priorities)
    ]
    out = socket.socket(socket.AF_UNIX, socket.SOCK_DGRAM)

    def deliver(sample: zenoh.Sample) -> None:
        datagram = sample.payload.to_bytes()
        try:
            out.sendto(datagram, str(root / str(judp.first_header(datagram).destination)))
        except OSError:
            return  # nobody is there any more

    subscriber = session.declare_subscriber(f"site/{settings['own']}/*", deliver)  # noqa: F841 - lives while it is named
    print("ready", flush=True)
    while True:
        datagram, sender = ours.recvfrom(70000)
        if (control := junior.parse(datagram)) is not None:
            ours.sendto(junior.accept(control.id), sender)
        else:
            publishers[judp.peek_priority(datagram)].put(datagram)


if __name__ == "__main__":
    main()
