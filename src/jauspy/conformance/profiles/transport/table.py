"""AS5669A as seen from outside: packing, wildcards, broadcast, ACK, pieces, duplicates, garbage, ports.

Every step sends packets made by hand to one component, with a query that changes nothing. A target is its component and
its node manager together; what the two do with a packet cannot be told apart from outside.
"""

from __future__ import annotations

from typing import Final

from jauspy.conformance.profile import Profile
from jauspy.conformance.profiles.raw_packets import alive, step
from jauspy.conformance.profiles.transport.acknowledging import ACKNOWLEDGING
from jauspy.conformance.profiles.transport.addresses import ADDRESSING
from jauspy.conformance.profiles.transport.garbage import MALFORMED_DATAGRAMS
from jauspy.conformance.profiles.transport.packing import PACKING
from jauspy.conformance.profiles.transport.pieces import FRAGMENTATION
from jauspy.conformance.profiles.transport.ports import UDP_PORTS

PROFILE: Final = Profile(
    "transport",
    "AS5669A: packing, wildcards, broadcast, ACK, pieces, duplicates, garbage, source ports",
    (
        *ADDRESSING,
        *PACKING,
        *ACKNOWLEDGING,
        *FRAGMENTATION,
        *MALFORMED_DATAGRAMS,
        *UDP_PORTS,
        step("alive", "after all this a query is answered", alive),
    ),
)
