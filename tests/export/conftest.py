"""A teleoperated run with video: commands and reports of an arm and its tool, and the RTP packets of a camera."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path

import numpy as np
import pytest

from jauspy.capture.reader import Datagram
from jauspy.codec.message import Message
from jauspy.ids import JausID
from jauspy.messages import registry
from jauspy.messages.core import ReportIdentification
from jauspy.messages.manipulator import ReportJointPositions, SetEndEffectorEffort, SetJointPositions
from jauspy.platform.video_settings import VideoSettings
from jauspy.protocol import judp
from jauspy.protocol.header import Packet
from jauspy.recording.run_files import PcapngFile, create
from jauspy.video.h264 import H264Encoder
from jauspy.video.h264_payload import packetise
from jauspy.video.rtp import RtpPacket

START = 1_700_000_000.0
CLIENT, ARM, TOOL = JausID(42, 1, 1), JausID(101, 1, 103), JausID(101, 1, 104)
HOSTS = {42: ("10.0.0.2", 3794), 101: ("10.0.0.1", 3794)}
RATE, SECONDS, WIDTH, HEIGHT = 20, 3.0, 320, 240


def joints(kind: type[Message], *angles: float) -> Message:
    rows = [{"joint_position": {"choice": "RADIAN", "value": angle}} for angle in angles]
    return kind.from_dict({"joint_position_list": rows})


def messages(offset: float) -> list[tuple[float, JausID, JausID, Message]]:
    name = ReportIdentification.from_dict({"query_type": 2, "type": 0, "identification": "=HYPERLINK(1)"})
    found: list[tuple[float, JausID, JausID, Message]] = [(0.0, ARM, CLIENT, name)]
    for number in range(int(SECONDS * 10)):
        time = number / 10
        found.append((time, ARM, CLIENT, joints(ReportJointPositions, 0.1 * time + offset, -1.0)))
        found.append((time + 0.02, CLIENT, ARM, joints(SetJointPositions, 0.1 * time + offset + 0.05, -1.0)))
        found.append((time + 0.03, CLIENT, TOOL, SetEndEffectorEffort(end_effector_effort=float(number))))
    return found


def picture(number: int) -> np.ndarray:
    """A grey that tells the number of the picture."""
    return np.full((HEIGHT, WIDTH, 3), 20 + 3 * number, np.uint8)


def video_packets() -> list[tuple[float, bytes]]:
    encoder = H264Encoder(VideoSettings(width=WIDTH, height=HEIGHT, rate=RATE))
    packets, sequence = [], 65_530
    for number in range(int(SECONDS * RATE)):
        payloads = packetise(encoder.encode(picture(number)))
        for place, payload in enumerate(payloads):
            marker = place == len(payloads) - 1
            stamp = 0xFFFFFF00 + number * 90_000 // RATE & 0xFFFFFFFF  # wraps
            packet = RtpPacket(sequence & 0xFFFF, stamp, 7, payload, marker=marker)
            packets.append((0.05 + number / RATE, packet.encode()))
            sequence += 1
    return packets


def write_run(path: Path, offset: float = 0.0, *, video: Sequence[tuple[float, bytes]] = ()) -> Path:
    rows = [
        (time, HOSTS[source.subsystem], HOSTS[to.subsystem], judp.pack(Packet(source, to, message.encode(), number)))
        for number, (time, source, to, message) in enumerate(messages(offset))
    ]
    rows += [(time, ("10.0.0.1", 40_000), ("10.0.0.2", 5004), packet) for time, packet in video]
    file = create(path, registry)
    assert isinstance(file, PcapngFile)
    for number, (time, source, to, payload) in enumerate(sorted(rows)):
        file.add(Datagram(number, START + time, source, to, payload), ())
    file.close()
    return path


@pytest.fixture(scope="session")
def packets() -> list[tuple[float, bytes]]:
    return video_packets()


@pytest.fixture
def run_file(tmp_path: Path, packets: list[tuple[float, bytes]]) -> Callable[..., Path]:
    """Writes a run as pcapng."""

    def write(name: str = "run", offset: float = 0.0, *, video: bool = True) -> Path:
        return write_run(tmp_path / f"{name}.pcapng", offset, video=packets if video else ())

    return write
