"""How long the guards of inc1 take for a check, in milliseconds of processor time, beside their goal of 1 ms.

python tools/bench/guards.py [--seconds 10]

The arm and the flippers move at random velocities, and the chassis turns in the world `yard`; only checks that compute
are counted, not the steps between them.
"""

from __future__ import annotations

import argparse
import dataclasses
import statistics
import time
from typing import Protocol

import numpy as np

from jauspy.platform.description import GuardedTeleopSetup, SelfCollisionSetup
from jauspy.platform.drive_guard import PERIOD as DRIVE_PERIOD, DriveGuard, drive_guard
from jauspy.platform.joint_guard import PERIOD as JOINT_PERIOD, JointGuard
from jauspy.platform.joints import ControlMode, Target
from jauspy.robot.robot_files import load, robot_model
from jauspy_sim.robot import SimulatedRobot

STEP = 0.002
COMPUTES = 0.05
"""Milliseconds below which a step has computed nothing."""


class Stepped(Protocol):
    """A guard."""

    def step(self, now: float) -> None:
        """Check if it is due."""
        ...


def timed(guard: Stepped, now: float) -> float:
    """Milliseconds of processor time of a step."""
    start = time.thread_time()
    guard.step(now)
    return 1000.0 * (time.thread_time() - start)


def main() -> None:
    """Print a line for each guard."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--seconds", type=float, default=10.0, help="simulated time (%(default)s s)")
    seconds = parser.parse_args().seconds
    model = dataclasses.replace(
        robot_model(load("inc1")),
        cameras=(),
        self_collision=SelfCollisionSetup(enabled=True),
        guarded_teleop=GuardedTeleopSetup(enabled=True),
    )
    robot = SimulatedRobot.open(model, "yard")
    joints, drive = JointGuard(model, model.self_collision, robot.groups), drive_guard(model, robot)
    assert isinstance(drive, DriveGuard)
    rng = np.random.default_rng(0)
    times: dict[str, list[float]] = {"self collision": [], "obstacles": []}
    for number in range(round(seconds / STEP)):
        if number % 500 == 0:
            drive.drive.set_effort(0.3, 0.3)
            for group in joints.groups.values():
                speeds = rng.uniform(-1.0, 1.0, len(group.joints)).tolist()
                rows = zip(group.joints, speeds, strict=True)
                group.command([Target(ControlMode.VELOCITY, share * joint.velocity) for joint, share in rows])
        times["self collision"].append(timed(joints, robot.time))
        times["obstacles"].append(timed(drive, robot.time))
        robot.advance(STEP)
    print(f"{'guard':16}{'every':>8}{'median':>10}{'99 %':>10}{'a step of 2 ms':>17}  goal: at most 1 ms")
    for (name, found), period in zip(times.items(), (JOINT_PERIOD, DRIVE_PERIOD), strict=True):
        checks = sorted(value for value in found if value > COMPUTES)
        last = checks[int(0.99 * len(checks))]
        mean = statistics.mean(found)
        print(f"{name:16}{1000.0 * period:5.0f} ms{statistics.median(checks):7.2f} ms{last:7.2f} ms{mean:14.2f} ms")
    robot.close()


if __name__ == "__main__":
    main()
