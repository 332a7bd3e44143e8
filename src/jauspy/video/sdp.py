"""Session descriptions (RFC 8866, RFC 6184 8.2.1) of a stream, for players."""

from __future__ import annotations

from jauspy.video.rtp import CLOCK_RATE, PAYLOAD_TYPE


def session_description(name: str, address: str, port: int) -> str:
    """The SDP with which a player receives the stream at that address and port."""
    family = "IP6" if ":" in address else "IP4"
    title = " ".join(name.split()) or "-"
    lines = [
        "v=0",
        f"o=- 0 0 IN {family} {address}",
        f"s={title}",
        f"c=IN {family} {address}",
        "t=0 0",
        f"m=video {port} RTP/AVP {PAYLOAD_TYPE}",
        f"a=rtpmap:{PAYLOAD_TYPE} H264/{CLOCK_RATE}",
        f"a=fmtp:{PAYLOAD_TYPE} packetization-mode=1",
        "a=recvonly",
    ]
    return "".join(f"{line}\r\n" for line in lines)
