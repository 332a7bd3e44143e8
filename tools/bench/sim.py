"""How fast the simulated robots are, beside MuJoCo's bare step loop on the same model in the same run.

python tools/bench/sim.py [--seconds 10]

A robot's time has everything in it: controllers of the joints, tracks, the lidar with 360 rays at 10 Hz, force and
torque at 100 Hz. The bare loop has MuJoCo's steps alone, without a ray. The ratio is the median of tenths of seconds
that both simulate by turns, so that other programs disturb it little; `no lidar` is the same without rays.
"""

from __future__ import annotations

import argparse
import dataclasses
import statistics
import time

import mujoco

from jauspy.platform.joints import ControlMode, Target
from jauspy.robot.robot_files import load, robot_model
from jauspy_sim.assembly import TIMESTEP
from jauspy_sim.robot import SimulatedRobot

PIECE = 0.1
"""Seconds that robot and bare loop simulate by turns: from the same state, so that both have the same contacts."""


def targets(robot: SimulatedRobot, share: float) -> list[Target]:
    """Somewhere within the limits of the arm."""
    joints = robot.groups["arm"].joints
    return [Target(ControlMode.POSITION, j.lower + share * (j.upper - j.lower), speed=0.3) for j in joints]


def measure(robot: SimulatedRobot, seconds: float) -> tuple[float, float, float]:
    """How much faster than time a robot is that turns and waves its arm, and MuJoCo's steps alone; the ratio."""
    spare = mujoco.MjData(robot.model)
    pairs = []
    robot.drive.set_effort(0.0, 0.3)
    for piece in range(round(seconds / PIECE)):
        robot.groups["arm"].command(targets(robot, 0.6 if piece // 10 % 2 else 0.4))
        mujoco.mj_copyData(spare, robot.model, robot.data)
        start = time.process_time()
        for _ in range(round(PIECE / TIMESTEP)):
            mujoco.mj_step(robot.model, spare)
        middle = time.process_time()
        robot.advance(PIECE)
        pairs.append((time.process_time() - middle, middle - start))
    own, bare = (PIECE / statistics.median(times) for times in zip(*pairs, strict=True))
    return own, bare, statistics.median(bare / own for own, bare in pairs)


def main() -> None:
    """Print a line for each robot and world."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--seconds", type=float, default=10.0, help="simulated time of each line (%(default)s s)")
    seconds = parser.parse_args().seconds
    head = f"{'robot and world':24}{'real-time factor':>18}{'bare steps':>12}{'ratio':>8}{'no lidar':>10}"
    print(f"{head}  goal: at least 10, and 0.6")
    for name in ("inc1", "inc1_pprm"):
        for world in ("empty", "yard", "rough", "street", "house", "rubble"):
            model = robot_model(load(name))
            own, bare, ratio = measure(SimulatedRobot.open(model, world), seconds)
            blind = measure(SimulatedRobot.open(dataclasses.replace(model, lidars=()), world), seconds)
            print(f"{name + ' in ' + world:24}{own:18.1f}{bare:12.1f}{ratio:8.2f}{blind[2]:10.2f}")


if __name__ == "__main__":
    main()
