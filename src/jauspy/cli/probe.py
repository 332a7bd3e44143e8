"""Whether a node manager is there."""

from __future__ import annotations

import socket
from pathlib import Path
from typing import Final

NODE_MANAGER_SOCKET: Final = "JuniorRTE"


def node_manager_at(root: Path) -> bool:
    """True when a live process holds the node manager's socket in this local root."""
    with socket.socket(socket.AF_UNIX, socket.SOCK_DGRAM) as probe:
        try:
            probe.connect(str(root / NODE_MANAGER_SOCKET))
        except OSError:
            return False
    return True
