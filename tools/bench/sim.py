"""How fast the simulated robots are, beside MuJoCo's bare step loop on the same model in the same run.

python tools/bench/sim.py [--seconds 10]
"""

from __future__ import annotations

import argparse
import time

import mujoco

from jauspy.modules.description import robot_model
from jauspy.modules.robots import load
from jauspy.platform.joints import ControlMode, Target
from jauspy_sim.assembly import TIMESTEP
from jauspy_sim.robot import SimulatedRobot

PIECE = 0.1
"""Seconds that robot and bare loop simulate by turns: from the same state, so that both have the same contacts."""


def targets(robot: SimulatedRobot, share: float) -> list[Target]:
    """Somewhere within the limits of the arm."""
    joints = robot.groups["arm"].joints
    return [Target(ControlMode.POSITION, j.lower + share * (j.upper - j.lower), speed=0.3) for j in joints]


def measure(robot: SimulatedRobot, seconds: float) -> tuple[float, float]:
    """Processor seconds of a robot that turns and waves its arm, and of MuJoCo's steps alone."""
    spare = mujoco.MjData(robot.model)
    own = bare = 0.0
    robot.drive.set_effort(0.0, 0.3)
    for piece in range(round(seconds / PIECE)):
        robot.groups["arm"].command(targets(robot, 0.6 if piece // 10 % 2 else 0.4))
        mujoco.mj_copyData(spare, robot.model, robot.data)
        start = time.process_time()
        for _ in range(round(PIECE / TIMESTEP)):
            mujoco.mj_step(robot.model, spare)
        middle = time.process_time()
        robot.advance(PIECE)
        own += time.process_time() - middle
        bare += middle - start
    return own, bare


def main() -> None:
    """Print a line for each robot and world."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--seconds", type=float, default=10.0, help="simulated time of each line (%(default)s s)")
    seconds = parser.parse_args().seconds
    print(f"{'robot and world':24}{'real-time factor':>18}{'bare steps':>12}{'ratio':>8}  goal: at least 10, and 0.6")
    for name in ("inc1", "inc1_pprm"):
        for world in ("empty", "demo", "rough"):
            own, bare = measure(SimulatedRobot.open(robot_model(load(name)), world), seconds)
            print(f"{name + ' in ' + world:24}{seconds / own:18.1f}{seconds / bare:12.1f}{bare / own:8.2f}")


if __name__ == "__main__":
    main()
