"""A recorded run as MCAP: a robot drives a circle, its state changes, and a camera shows the number of each picture."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np

from jauspy.capture.dissector import Dissector
from jauspy.capture.reader import Datagram
from jauspy.codec.message import Message
from jauspy.ids import JausID
from jauspy.messages import registry
from jauspy.messages.core import ReportStatus
from jauspy.messages.mobility import ReportLocalPose, ReportVelocityState
from jauspy.platform.video_settings import VideoSettings
from jauspy.protocol import judp
from jauspy.protocol.header import Packet
from jauspy.recording.run_files import create
from jauspy.video.h264 import H264Encoder
from jauspy.video.imaging import draw_numbers

START = 1_700_000_000.0
ROBOT, CLIENT = JausID(101, 1, 102), JausID(42, 1, 1)
RADIUS, RATE, GOP = 2.0, 10, 10


def write_run(path: Path, seconds: float = 8.0, cameras: tuple[str, ...] = ("101.1.106",)) -> Path:
    """Write the run: a turn to the left in 8 s, from the origin along x."""
    dissector, file = Dissector(registry), create(path, registry)
    encoders = {name: H264Encoder(VideoSettings(width=320, height=240, rate=RATE, gop=GOP)) for name in cameras}

    def add(time: float, number: int, message: Message) -> None:
        payload = judp.pack(Packet(ROBOT, CLIENT, message.encode(), number))
        datagram = Datagram(number, START + time, ("10.0.0.1", 3794), ("10.0.0.2", 3794), payload)
        file.add(datagram, dissector.dissect(payload, START + time).parts)

    for step in range(int(seconds * RATE)):
        time = step / RATE
        yaw = math.tau * time / 8.0
        x, y = RADIUS * math.sin(yaw), RADIUS * (1.0 - math.cos(yaw))
        add(time, 3 * step, ReportLocalPose(x=x, y=-y, yaw=math.remainder(-yaw, math.tau)))
        add(time, 3 * step + 1, ReportVelocityState(velocity_x=1.57 + 0.3 * math.sin(3.0 * yaw)))
        if step % 20 == 0:
            states = ReportStatus.Status
            add(time, 3 * step + 2, ReportStatus(status=states.READY if step // 20 % 2 else states.STANDBY, reserved=0))
        for name, encoder in encoders.items():
            grey = np.full((240, 320, 3), 40 + 2 * (step % 80), np.uint8)
            draw_numbers(grey, step)
            nals = encoder.encode(grey, idr=step % GOP == 0)
            unit = b"".join(b"\0\0\0\1" + nal for nal in nals)
            file.add_picture(name, START + time, unit, is_idr=step % GOP == 0)
    file.close()
    return path
