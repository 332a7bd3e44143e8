"""Drive the robot 101 to a point, bend its arm and grip, in metres, radians and newtons."""

import asyncio
import sys

import jauspy


async def main(connect: str | None) -> None:
    async with jauspy.OCU("42.1.1", connect) as ocu:
        robot = await ocu.robot(101)
        async with robot.control(authority=200):  # takes and resumes all that moves; at the end: Standby, released
            ahead = {"x": 1.0, "y": 0.5}  # metres from where the robot stands, to the front and to the left
            await robot.go_to(
                **ahead, frame="robot", timeout=60.0, progress=lambda now: print(f"{now.distance:.2f} m left")
            )
            await robot.drive(angular=0.5, seconds=1.0)  # rad/s, to the left
            joints = await robot.arm.move({"arm_link_2_to_arm_link_3": -1.2}, speed=0.8)  # radians, as in the URDF
            fingers = await robot.gripper.close(force=20)  # newtons
        pose = await robot.pose()
    print(f"at x {pose.x:.2f} m, y {pose.y:.2f} m; elbow {joints['arm_link_2_to_arm_link_3']:.2f} rad")
    print(f"fingers {dict(fingers.positions)}")


if __name__ == "__main__":
    asyncio.run(main(sys.argv[1] if len(sys.argv) > 1 else None))
