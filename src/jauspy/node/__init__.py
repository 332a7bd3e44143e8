"""The node manager: an asyncio shell around `protocol.routing.Router`."""

from __future__ import annotations

from jauspy.node.config import NodeConfig
from jauspy.node.manager import NodeManager

__all__ = ["NodeConfig", "NodeManager"]
