"""Metrics for Prometheus, by HTTP in the event loop of the node manager."""

from __future__ import annotations

import asyncio
import os
import socket
from collections.abc import Callable, Iterator
from typing import Final

from prometheus_client import CollectorRegistry
from prometheus_client.core import CounterMetricFamily, GaugeMetricFamily, Metric
from prometheus_client.exposition import CONTENT_TYPE_LATEST, generate_latest
from prometheus_client.registry import Collector

from jauspy.errors import TransportError
from jauspy.ids import JausID
from jauspy.node.status import NodeState
from jauspy.protocol.addressing import format_port
from jauspy.transport.listener import StreamServer

REQUEST_TIMEOUT: Final = 5.0
"""Seconds for a request and its answer."""
MAX_REQUEST: Final = 8192
MAX_READERS: Final = 16
"""Further readers are refused: each needs a file descriptor, and so do components."""


class NodeCollector(Collector):
    """Metrics of the current state."""

    def __init__(self, state: Callable[[], NodeState]) -> None:
        self._state = state

    def collect(self) -> Iterator[Metric]:
        """Called by prometheus_client for each request."""
        state = self._state()
        events = CounterMetricFamily("jauspy_node_events", "Events counted by the node manager.", labels=["event"])
        dropped = CounterMetricFamily("jauspy_node_dropped", "Packets dropped, by reason.", labels=["reason"])
        for name, count in sorted(state.router.counters.items()):
            family, label = (dropped, name[8:]) if name.startswith("dropped.") else (events, name)
            family.add_metric([label], count)
        yield from (events, dropped)
        yield GaugeMetricFamily("jauspy_node_components", "Local components.", value=len(state.router.components))
        yield GaugeMetricFamily("jauspy_node_peers", "Known network addresses.", value=len(state.router.address_book))
        queue = GaugeMetricFamily("jauspy_node_queue", "Packets waiting for a component.", labels=["component"])
        for id, port in state.router.components:
            queue.add_metric([str(JausID.from_int(id))], state.queued.get(format_port(port), 0))
        yield queue
        yield GaugeMetricFamily("jauspy_node_ingress", "Packets read and not routed yet.", value=state.ingress)
        kernel = CounterMetricFamily("jauspy_node_kernel_dropped", "Packets dropped by the kernel.", labels=["network"])
        for name, network in state.networks.items():
            kernel.add_metric([name], network.receive_buffer.dropped)
        yield kernel
        left_out = CounterMetricFamily(
            "jauspy_node_left_out", "Messages that a link did not carry.", labels=["link", "limit", "message"]
        )
        for kind, count in state.router.limits.left_out.items():
            code = "" if kind.code is None else f"0x{kind.code:04X}"
            left_out.add_metric([kind.link, kind.limit, code], count)
        yield left_out


class MetricsServer:
    """Answers every GET with the metrics."""

    def __init__(self, host: str, port: int, state: Callable[[], NodeState]) -> None:
        self._where = (host, port)
        self._state = state
        self._registry = CollectorRegistry(auto_describe=False)
        self._collector = NodeCollector(state)
        self._readers = 0
        self._server: StreamServer | None = None

    async def __aenter__(self) -> None:
        self._registry.register(self._collector)
        try:
            sock = socket.create_server(self._where)
        except OSError as error:
            why = os.strerror(error.errno) if error.errno else str(error)  # `str(error)` would repeat the address
            problem = f"cannot serve metrics on {self._where[0]}:{self._where[1]}: {why}"
            raise TransportError(f"{problem}; choose another with --metrics") from error
        counters = self._state().router.counters
        self._server = StreamServer(sock, self._serve, counters, MAX_REQUEST)

    async def __aexit__(self, *error: object) -> None:
        if self._server is not None:
            await self._server.close()

    async def _serve(self, reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
        if self._readers >= MAX_READERS:
            writer.transport.abort()
            return
        self._readers += 1
        try:
            async with asyncio.timeout(REQUEST_TIMEOUT):
                request = await reader.readuntil(b"\r\n\r\n")
                writer.write(self._answer(request))
                await writer.drain()
        except (OSError, TimeoutError, asyncio.IncompleteReadError, asyncio.LimitOverrunError):
            writer.transport.abort()
        finally:
            self._readers -= 1
            writer.close()

    def _answer(self, request: bytes) -> bytes:
        if not request.startswith(b"GET "):
            return b"HTTP/1.1 405 Method Not Allowed\r\nContent-Length: 0\r\nConnection: close\r\n\r\n"
        body = generate_latest(self._registry)
        head = f"Content-Type: {CONTENT_TYPE_LATEST}\r\nContent-Length: {len(body)}\r\nConnection: close"
        return f"HTTP/1.1 200 OK\r\n{head}\r\n\r\n".encode() + body
