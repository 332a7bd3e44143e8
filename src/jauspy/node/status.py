"""Status of a running node manager: a Unix stream socket that sends one JSON document to each reader."""

from __future__ import annotations

import asyncio
import json
import os
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Final

from jauspy.ids import JausID
from jauspy.messages import registry
from jauspy.node.config import NodeConfig
from jauspy.node.link_shaper import LinkShaper
from jauspy.node.network import Network
from jauspy.protocol.addressing import NetworkPort, format_port
from jauspy.protocol.gateway import Refused
from jauspy.protocol.link_limits import LeftOut, link_of
from jauspy.protocol.routing import Router
from jauspy.transport import local
from jauspy.transport.listener import StreamServer
from jauspy.transport.node_status import READ_TIMEOUT, SOCKET_NAME, read

__all__ = ["SOCKET_NAME", "NodeState", "StatusServer", "read", "with_rates"]

MAX_READERS: Final = 8
RATE_INTERVAL: Final = 0.5
"""Seconds between two reads for `with_rates`."""


@dataclass(frozen=True, slots=True, kw_only=True)
class NodeState:
    """References into a running node manager; `queued` counts datagrams per local socket, `now` is loop time."""

    config: NodeConfig
    router: Router
    networks: Mapping[str, Network]
    queued: Mapping[str, int]
    queued_bytes: Mapping[str, int]
    ingress: int
    shapers: Mapping[str, LinkShaper]
    now: float

    def as_dict(self, started: float) -> dict[str, Any]:
        """The JSON document; times in seconds."""
        return {
            "pid": os.getpid(),
            "uptime": round(self.now - started, 3),
            "local_root": str(self.config.local_root),
            "networks": [self._network(name, network) for name, network in self.networks.items()],
            "components": [self._component(id, format_port(port)) for id, port in sorted(self.router.components)],
            "peers": [self._peer(*entry) for entry in self.router.address_book],
            "clashes": [self._clash(*entry) for entry in self.router.clashes.recent(self.now)],
            "refused": [self._refused(*entry) for entry in self._gateway_refusals()],
            "left_out": [self._left_out(*entry) for entry in self._most_left_out()],
            "queues": {"ingress": self.ingress, "unknown_destinations": self.router.pending_messages},
            "counters": dict(sorted(self.router.counters.items())),
        }

    def _network(self, name: str, network: Network) -> dict[str, Any]:
        buffer = network.receive_buffer
        config = next(setup for setup in self.config.all_networks if setup.name == name)
        inside = self.config.gateway is not None and name in self.config.gateway.inside
        return {
            "name": name,
            "address": f"{config.address}:{network.port}",
            "address6": None if config.address6 is None else f"[{config.address6}]:{network.port}",
            "multicast_group": config.multicast_group,
            "multicast_group6": config.multicast_group6,
            "inside": inside,
            "authenticated": network.authenticator is not None,
            "limit": dict(config.limit),
            "send_queue": network.send_queue + (self.shapers[name].queued_bytes if name in self.shapers else 0),
            "receive_buffer": {"bytes": buffer.bytes, "limit": buffer.limit, "dropped": buffer.dropped},
        }

    def _component(self, id: int, path: str) -> dict[str, Any]:
        return {"id": str(JausID.from_int(id)), "path": path, "waiting": self.queued.get(path, 0)} | {
            "waiting_bytes": self.queued_bytes.get(path, 0)
        }

    def _clash(self, id: int, port: NetworkPort, heard: float) -> dict[str, Any]:
        return {"id": str(JausID.from_int(id)), "address": format_port(port), "heard": round(heard, 3)}

    def _gateway_refusals(self) -> list[tuple[Refused, int]]:
        """Count the packets that the gateway refused, the most frequent kind first."""
        gateway = self.router.gateway
        return sorted(gateway.refused.items(), key=lambda entry: -entry[1]) if gateway is not None else []

    def _refused(self, kind: Refused, count: int) -> dict[str, Any]:
        return {"message": _message_name(kind.code), "network": kind.network, "why": kind.why, "count": count}

    def _most_left_out(self) -> list[tuple[LeftOut, int]]:
        """Count the messages that links did not carry, the most frequent kind first."""
        return sorted(self.router.limits.left_out.items(), key=lambda entry: -entry[1])

    def _left_out(self, kind: LeftOut, count: int) -> dict[str, Any]:
        return {"message": _message_name(kind.code), "link": kind.link, "limit": kind.limit, "count": count}

    def _peer(self, id: int, port: NetworkPort, heard: float | None) -> dict[str, Any]:
        return {
            "id": str(JausID.from_int(id)),
            "address": format_port(port),
            "network": port.network,
            "link": link_of(port),
            "sent_bytes": self.networks[port.network].sent_bytes(port.host) if port.network in self.networks else 0,
            "heard": None if heard is None else round(self.now - heard, 3),
        }


def _message_name(code: int | None) -> str:
    """The name and id of a message, as in `SetWrenchEffort 0405h`; vendors' messages have only their id here."""
    if code is None:
        return "ACK or further fragment"
    names = dict.fromkeys(entry.name for entry in registry.entries_of(code))
    return " or ".join(names) + f"{' ' if names else ''}{code:04X}h"


class StatusServer:
    """Serves the status; what readers send is ignored."""

    def __init__(self, path: Path, mode: int, group: str | None, state: Callable[[], NodeState]) -> None:
        self._path = path
        self._mode = mode
        self._group = group
        self._state = state
        self._started = asyncio.get_running_loop().time()
        self._readers = 0
        self._server: StreamServer | None = None

    async def __aenter__(self) -> None:
        sock = local.listen(self._path, self._mode, self._group, setting="status")
        self._server = StreamServer(sock, self._serve, self._state().router.counters)

    async def __aexit__(self, *error: object) -> None:
        if self._server is not None:
            await self._server.close()
        self._path.unlink(missing_ok=True)

    async def _serve(self, _: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
        self._readers += 1
        try:
            if self._readers <= MAX_READERS:
                writer.write(json.dumps(self._state().as_dict(self._started)).encode() + b"\n")
                async with asyncio.timeout(READ_TIMEOUT):
                    await writer.drain()
                    writer.close()
                    await writer.wait_closed()
        except (OSError, TimeoutError):
            writer.transport.abort()
        finally:
            self._readers -= 1
            writer.close()


def with_rates(before: dict[str, Any], after: dict[str, Any]) -> dict[str, Any]:
    """The later status, with `rates`: the counts per second between both."""
    seconds = max(after["uptime"] - before["uptime"], 1e-3)
    counted = after["counters"]
    rates = {name: round((count - before["counters"].get(name, 0)) / seconds, 1) for name, count in counted.items()}
    return after | {"rates": rates}
