"""Components and network peers as bytes, as in the tests of the node manager."""

from tests.node.conftest import daemon, introduce, stack, udp

__all__ = ["daemon", "introduce", "stack", "udp"]
