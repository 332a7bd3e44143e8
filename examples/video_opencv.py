"""Receive the video of the arm camera of the robot 101 and find edges in it with OpenCV. Needs `jauspy[video]`."""

import asyncio
import sys

import cv2

import jauspy

FRAMES = 30


async def main(connect: str | None) -> None:
    async with jauspy.OCU("42.1.1", connect) as ocu:
        robot = await ocu.robot(101)
        count = 0
        async for frame in robot.camera("arm").frames():  # NumPy arrays in BGR; frame.time is when it was taken
            edges = cv2.Canny(cv2.cvtColor(frame, cv2.COLOR_BGR2GRAY), 50, 150)
            print(f"frame {count}: {frame.shape[1]}x{frame.shape[0]}, {(edges > 0).mean():.1%} edges")
            count += 1
            if count == FRAMES:
                break


if __name__ == "__main__":
    asyncio.run(main(sys.argv[1] if len(sys.argv) > 1 else None))
