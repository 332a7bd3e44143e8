"""Components and network peers as bytes, as in the tests of the node manager."""

from tests.node.conftest import introduce, stack, udp

__all__ = ["introduce", "stack", "udp"]
