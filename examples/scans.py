"""Print how far the nearest obstacle is that a robot's lidar sees, and in which direction, ten times."""

import asyncio
import math
import sys

import jauspy


async def main(connect: str | None) -> None:
    async with jauspy.OCU("42.1.1", connect) as ocu:
        robot = await ocu.robot(101)
        count = 0
        async for scan in robot.lidar().scans(rate=5.0):  # Hz; without a rate, every scan
            distance, angle = min(zip(scan.ranges, scan.angles, strict=True))  # metres and radians, to the left
            seen = f"{distance:.2f} m at {math.degrees(angle):+.0f} degrees" if math.isfinite(distance) else "nothing"
            print(f"{scan.time:%H:%M:%S}  {seen}, {len(scan.points())} of {len(scan.ranges)} rays with an echo")
            count += 1
            if count == 10:
                break


if __name__ == "__main__":
    asyncio.run(main(sys.argv[1] if len(sys.argv) > 1 else None))
