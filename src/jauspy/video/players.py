"""How ffmpeg's programs and GStreamer receive a stream so that a picture is seen as soon as it is there."""

from __future__ import annotations

from pathlib import Path

from jauspy.video.rtp import CLOCK_RATE, PAYLOAD_TYPE


def ffmpeg_source(sdp: Path) -> list[str]:
    """Options of ffmpeg, ffplay and ffprobe. They decode a picture when the next one begins, later than GStreamer."""
    quick = ["-fflags", "nobuffer", "-flags", "low_delay"]
    return ["-protocol_whitelist", "file,udp,rtp", *quick, "-i", str(sdp)]


def gstreamer_source(port: int) -> list[str]:
    """The beginning of a pipeline of gst-launch-1.0, up to decoded pictures. It waits for late packets for 20 ms."""
    caps = f"application/x-rtp,media=video,clock-rate={CLOCK_RATE},encoding-name=H264,payload={PAYLOAD_TYPE}"
    stages = [["rtpjitterbuffer", "latency=20"], ["rtph264depay"], ["avdec_h264", "max-threads=1"]]
    return ["udpsrc", f"port={port}", f"caps={caps}", *(word for stage in stages for word in ("!", *stage))]
