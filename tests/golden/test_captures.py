"""Messages of real captures, garbage in strings included, decode and encode to the same bytes."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from pathlib import Path

import dpkt
import pytest

from jauspy.messages import registry

CAPTURES = Path(__file__).parents[2].parent / "shared" / "captures"


def payloads(file: Path) -> Iterator[bytes]:
    """The message in each packet of each JUDP datagram: 12 bytes of header before, 2 bytes of sequence number after."""
    with file.open("rb") as stream:
        for _, frame in dpkt.pcap.Reader(stream):
            data = bytes(dpkt.ethernet.Ethernet(frame).data.data.data)
            at = 1
            while data[:1] == b"\x02" and len(data) - at >= 14:
                size = int.from_bytes(data[at + 1 : at + 3], "little")
                yield data[at + 12 : at + size - 2]
                at += max(size, 14)


CUT = {"sae_management": {}, "cop_waypoint_run_2013": {"QueryServices": 1, "ReportLocalWaypoint": 96}}
"""How often which message of a capture was sent shorter than its presence vector and counts say."""


@pytest.mark.parametrize("name", CUT)
def test_captures_round_trip(name: str) -> None:
    file = CAPTURES / f"{name}.pcap"
    if not file.is_file():
        pytest.skip(f"{file} is not there")
    known = [data for data in payloads(file) if registry.by_code(int.from_bytes(data[:2], "little"))]
    assert len(known) > 20
    cut: Counter[str] = Counter()
    for data in known:
        message, deviations = registry.decode(data, strict=False)
        if any(deviation.lost for deviation in deviations):
            cut[message.NAME] += 1
        else:
            assert message.encode(strict=False) == data
        if not deviations:
            assert registry.decode(data).encode() == data
    assert cut == CUT[name]
