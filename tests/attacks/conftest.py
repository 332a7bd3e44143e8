"""Components and network peers as bytes, as in the tests of the node manager."""

from tests.node.conftest import daemon_process, introduce, stack, udp

__all__ = ["daemon_process", "introduce", "stack", "udp"]
