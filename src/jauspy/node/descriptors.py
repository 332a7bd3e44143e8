"""File descriptors: how many the process may have, and how many of them are for sockets of components."""

from __future__ import annotations

import resource
from typing import Final

from jauspy.protocol.component_ports import MAX_COMPONENTS

MAX_OPEN_FILES: Final = 4096
"""Limit of open files: a socket for each of up to 1024 components, TCP connections, logs and captures."""
RESERVED: Final = 192
"""Descriptors for networks, probes, connections, readers of status and metrics, serial lines and logs."""


def raise_limit() -> None:
    """Raise the soft limit of open files, which is 1024 on many systems."""
    soft, hard = resource.getrlimit(resource.RLIMIT_NOFILE)
    enough = MAX_OPEN_FILES if hard == resource.RLIM_INFINITY else min(MAX_OPEN_FILES, hard)
    if soft != resource.RLIM_INFINITY and soft < enough:
        resource.setrlimit(resource.RLIMIT_NOFILE, (enough, hard))


def max_component_sockets() -> int:
    """The number of components on local sockets: each needs one descriptor. The reserve is at most half of all."""
    limit, _ = resource.getrlimit(resource.RLIMIT_NOFILE)
    if limit == resource.RLIM_INFINITY:
        return MAX_COMPONENTS
    return min(MAX_COMPONENTS, max(limit - RESERVED, limit // 2))
