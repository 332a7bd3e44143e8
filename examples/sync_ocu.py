"""Turn the robot 101 by 90 degrees, without `await`."""

import math
import sys
import time

from jauspy.messages.mobility import QueryLocalPose, SetWrenchEffort
from jauspy.sync import OCU

TIMEOUT = 20.0  # seconds, after which the robot is stopped wherever it is


def main(connect: str | None) -> None:
    with OCU("42.1.1", connect) as ocu:
        robot = ocu.discover(subsystem=101)
        driver = robot.service("mobility:PrimitiveDriver")
        sensor = robot.service("mobility:LocalPoseSensor")
        start = sensor.query(QueryLocalPose()).yaw
        end = time.monotonic() + TIMEOUT
        with driver.control(authority=200):
            driver.resume()
            for pose in sensor.subscribe(QueryLocalPose(), rate=10.0):
                driver.send(SetWrenchEffort(propulsive_rotational_effort_z=40.0))  # percent, to the right, for 2 s
                turned = math.remainder(pose.yaw - start, math.tau)
                print(f"turned {math.degrees(turned):.0f} degrees")
                if turned > math.radians(90.0):
                    break
                if time.monotonic() > end:
                    sys.exit(f"not turned after {TIMEOUT:g} s")


if __name__ == "__main__":
    main(sys.argv[1] if len(sys.argv) > 1 else None)
