"""Which process has a UDP port."""

from __future__ import annotations

import psutil


def udp_port_owner(port: int) -> str:
    """The owner of a UDP port, as in `process 1234 (jauspy node-manager)`; `another process` if it is not known."""
    try:
        pids = {c.pid for c in psutil.net_connections("udp") if c.laddr and c.laddr.port == port and c.pid}
    except psutil.Error:
        pids = set()
    return " and ".join(_describe_process(pid) for pid in sorted(pids)) or "another process"


def _describe_process(pid: int) -> str:
    try:
        command = " ".join(psutil.Process(pid).cmdline())
    except psutil.Error:
        command = ""
    return f"process {pid} ({command[:100]})" if command else f"process {pid}"
