"""Attackers use the same sockets as the tests of the node manager."""

from tests.node.conftest import daemon, introduce, stack, udp

__all__ = ["daemon", "introduce", "stack", "udp"]
