"""Who has a UDP port, for people who find it taken."""

from __future__ import annotations

import psutil


def udp_port_owner(port: int) -> str:
    """A phrase such as `process 1234 (jauspy node-manager)`; `another process` when the system does not tell."""
    try:
        pids = {c.pid for c in psutil.net_connections("udp") if c.laddr and c.laddr.port == port and c.pid}
    except psutil.Error:
        pids = set()
    return " and ".join(_describe(pid) for pid in sorted(pids)) or "another process"


def _describe(pid: int) -> str:
    try:
        command = " ".join(psutil.Process(pid).cmdline())
    except psutil.Error:
        command = ""
    return f"process {pid} ({command[:100]})" if command else f"process {pid}"
