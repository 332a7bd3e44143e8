"""Has the video of both cameras of `inc1` sent to itself, and counts pictures; decodes none.

python tools/bench/_viewer.py PORT

Says `ready` when each camera has sent a picture, and how many came when its standard input closes.
"""

from __future__ import annotations

import asyncio
import json
import sys
from contextlib import AsyncExitStack

from jauspy.cli.video import registered, url_of
from jauspy.ids import JausID
from jauspy.ocu import OCU
from jauspy.video.receiver import RtpReceiver

CAMERAS = (JausID(101, 1, 106), JausID(101, 1, 107))
HOST = "127.0.0.1"


async def view(port: int) -> None:
    """Receive until standard input closes."""
    counts = dict.fromkeys(map(str, CAMERAS), 0)
    seen = asyncio.Event()
    loop = asyncio.get_running_loop()

    def take(receiver: RtpReceiver, camera: str) -> None:
        counts[camera] += len(receiver.take())
        if all(counts.values()):
            seen.set()

    async with AsyncExitStack() as stack:
        ocu = await stack.enter_async_context(OCU(connect=f"udp://{HOST}:{port}"))
        for camera in CAMERAS:
            receiver = stack.enter_context(RtpReceiver(HOST))
            loop.add_reader(receiver.fileno(), take, receiver, str(camera))
            await stack.enter_async_context(registered(ocu, camera, 1, url_of((HOST, receiver.port))))
        async with asyncio.timeout(60.0):
            await seen.wait()
        before = dict(counts)
        print("ready", flush=True)
        await asyncio.to_thread(sys.stdin.read)
        print(json.dumps({camera: count - before[camera] for camera, count in counts.items()}), flush=True)


if __name__ == "__main__":
    asyncio.run(view(int(sys.argv[1])))
