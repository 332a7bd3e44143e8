"""What a running node manager tells about itself, as plain data."""

from __future__ import annotations

import os
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from jauspy.ids import JausID
from jauspy.node.config import NodeConfig
from jauspy.node.network import Network
from jauspy.protocol.addressing import NetworkPort, format_port
from jauspy.protocol.routing import Router


@dataclass(frozen=True, slots=True)
class NodeState:
    """References into a running node manager; `waiting` is the queue of each local socket, `now` in loop time."""

    config: NodeConfig
    core: Router
    networks: Mapping[str, Network]
    waiting: Mapping[str, int]
    ingress: int
    now: float

    def as_dict(self, started: float) -> dict[str, Any]:
        """JSON of it; times in seconds."""
        return {
            "pid": os.getpid(),
            "uptime": round(self.now - started, 3),
            "local_root": str(self.config.local_root),
            "networks": [self._network(name, network) for name, network in self.networks.items()],
            "components": [self._component(id, format_port(port)) for id, port in sorted(self.core.components)],
            "peers": [self._peer(*entry) for entry in self.core.address_book],
            "queues": {"ingress": self.ingress, "unknown_destinations": self.core.pending_messages},
            "counters": dict(sorted(self.core.counters.items())),
        }

    def _network(self, name: str, network: Network) -> dict[str, Any]:
        config, buffered = network.config, network.buffered
        inside = self.config.gateway is not None and name in self.config.gateway.inside
        return {
            "name": name,
            "address": f"{config.address}:{network.port}",
            "multicast_group": config.multicast_group,
            "inside": inside,
            "authenticated": network.seal is not None,
            "receive_buffer": {"bytes": buffered.bytes, "limit": buffered.limit, "dropped": buffered.dropped},
        }

    def _component(self, id: int, path: str) -> dict[str, Any]:
        return {"id": str(JausID.from_int(id)), "path": path, "waiting": self.waiting.get(path, 0)}

    def _peer(self, id: int, port: NetworkPort, heard: float | None) -> dict[str, Any]:
        return {
            "id": str(JausID.from_int(id)),
            "address": format_port(port),
            "network": port.network,
            "heard": None if heard is None else round(self.now - heard, 3),
        }
