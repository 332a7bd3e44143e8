"""urn:jaus:jss:iop:NodeIDAllocator 1.1. Generated from schemas/; do not edit."""

from __future__ import annotations

from jauspy.codec import declare as jd

_SERVICE = jd.Service("urn:jaus:jss:iop:NodeIDAllocator", "1.1")


@jd.message(_SERVICE, 0xDB03, query=True)
class RequestNodeID(jd.Message):
    """RequestNodeID (0xDB03): Asks for a node number of one's own.

    requester_id: 7. Key of the asker, unique in the subsystem; for instance MAC address and a counter byte, or IPv4 address, a counter byte and two zero bytes
    """
    requester_id: list[int] = jd.field("RequesterID", jd.Grid(jd.Number("B"), (7,)))


@jd.message(_SERVICE, 0xFB03)
class GrantNodeID(jd.Message):
    """GrantNodeID (0xFB03): Answers a request with the number given out; sent as broadcast as the asker has no address yet.

    node_id: Number given out; 0 if that failed
    requester_id: 7. Key of the asker, sent back so that it knows the answer is its own; formed as in RequestNodeID
    """
    node_id: int = jd.field("NodeID", jd.Number("B"))
    requester_id: list[int] = jd.field("RequesterID", jd.Grid(jd.Number("B"), (7,)))
