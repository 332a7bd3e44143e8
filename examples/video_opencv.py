"""Receive the video of the arm camera of the robot 101 and find edges in it with OpenCV. Needs `jauspy[video]`."""

import asyncio
import sys

import cv2

import jauspy
from jauspy.messages.environment_sensing import (
    ConfirmDigitalResourceEndpoint as Confirm,
    RegisterDigitalResourceEndpoint as Register,
    RemoveDigitalResourceEndpoint as Remove,
)
from jauspy.video.h264 import H264Decoder
from jauspy.video.receiver import RtpReceiver

CAMERA = "101.1.106"
RTP = 201  # ServerType of RTP streams in jauspy; AS6060 reserves no value for it
FRAMES = 30


async def main(connect: str | None) -> None:
    decoder, frames = H264Decoder(), 0
    with RtpReceiver() as receiver:  # listens on a free port of 127.0.0.1
        async with jauspy.OCU("42.1.1", connect) as ocu:
            url = f"rtp://127.0.0.1:{receiver.port}"
            stream = Register.DigitalResourceEndpointRec(server_type=RTP, server_url=url, resource_id=1)
            endpoint = await ocu.query(CAMERA, Register(Register.RequestIDRec(1), stream), expects=Confirm)
            while frames < FRAMES:
                await asyncio.sleep(0.02)
                for picture in receiver.take():
                    if (image := decoder.decode(picture)) is None:
                        continue
                    edges = cv2.Canny(cv2.cvtColor(image, cv2.COLOR_RGB2GRAY), 50, 150)
                    print(f"frame {frames}: {image.shape[1]}x{image.shape[0]}, {(edges > 0).mean():.1%} edges")
                    frames += 1
            await ocu.query(CAMERA, Remove(endpoint.id, request_id=2), expects=Confirm)


if __name__ == "__main__":
    asyncio.run(main(sys.argv[1] if len(sys.argv) > 1 else None))
