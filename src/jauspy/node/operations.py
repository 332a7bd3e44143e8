"""What is opened beside the routing, when the configuration says so: status, metrics, mirror."""

# ruff: noqa: PLC0415 - what is not configured is not imported

from __future__ import annotations

from collections.abc import Callable
from contextlib import AsyncExitStack
from typing import TYPE_CHECKING

from jauspy.node.config import NodeConfig
from jauspy.node.status import NodeState

if TYPE_CHECKING:
    from jauspy.node.mirror import Mirror


async def open_all(stack: AsyncExitStack, config: NodeConfig, state: Callable[[], NodeState]) -> Mirror | None:
    """Open on `stack`; raises `TransportError`. The sockets are open when `state` is asked."""
    if config.status:
        from jauspy.node.status import SOCKET_NAME, StatusServer

        path = config.local_root / SOCKET_NAME
        await stack.enter_async_context(StatusServer(path, config.local_mode, config.local_group, state))
    if config.metrics is not None:
        from jauspy.node.metrics import MetricsServer

        host, _, port = config.metrics.rpartition(":")
        await stack.enter_async_context(MetricsServer(host, int(port), state))
    if config.mirror is None:
        return None
    from jauspy.node.mirror import Mirror

    def group(network: str) -> tuple[str, int]:
        told = state().networks[network]
        return told.config.multicast_group, told.port

    return stack.enter_context(Mirror(config.mirror, config.mirror_limit, state().core.counters, group))
