"""How long it takes to find positions of an arm's joints for a pose, and velocities for a line.

python tools/bench/inverse_kinematics.py [--poses 200]
"""

from __future__ import annotations

import argparse
import random
import time
from statistics import mean

from jauspy.backends.kinematic import KinematicJoints
from jauspy.geometry.kinematics import InverseKinematics, Solution, forward_kinematics
from jauspy.robot.robot_files import load, robot_model
from jauspy.services.manipulator.arm import Arm
from jauspy.services.manipulator.end_effector import CONTROL_PERIOD, STEPS_PER_TURN
from jauspy.services.manipulator.tool_motion import ToolMotion


def timed(search: InverseKinematics) -> tuple[Solution, list[float]]:
    """What a search found, and processor seconds of each of its turns."""
    turns: list[float] = []
    while True:
        start = time.process_time()
        found = search.advance(STEPS_PER_TURN)
        turns.append(time.process_time() - start)
        if found is not None:
            return found, turns


def measure(robot: str, poses: int) -> None:
    """Search random poses that can be reached, and move on a line; print what that took."""
    model, rng = robot_model(load(robot)), random.Random(1)  # noqa: S311 - the same poses every time
    arm = Arm(KinematicJoints(model.description, model.groups["arm"]))
    links, limits = arm.geometry.links, arm.limits
    searches, exact = [], 0
    for _ in range(poses):
        goal = forward_kinematics(links, [rng.uniform(*limit) for limit in limits], arm.tool).tool
        search = InverseKinematics(links, arm.tool, goal, arm.state().positions, limits)
        found, turns = timed(search)
        exact += found.reaches_pose
        searches.append(turns)
    motion, looks = ToolMotion(arm), 200
    motion.follow((0.0, 0.0, 0.0), (0.03, 0.0, 0.0))
    start = time.process_time()
    for _ in range(looks):
        motion.rates(CONTROL_PERIOD)
    look = (time.process_time() - start) / looks
    whole = [sum(each) for each in searches]
    longest = max(max(each) for each in searches)
    print(
        f"{robot}: {exact} of {poses} poses, {1e3 * mean(whole):.1f} ms each, at most {1e3 * max(whole):.1f}; "
        f"a turn at most {1e3 * longest:.1f} ms; a look at a line {1e3 * look:.2f} ms"
    )


def main() -> None:
    """Measure both arms."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--poses", type=int, default=200)
    poses = parser.parse_args().poses
    for robot in ("inc1", "inc1_pprm"):
        measure(robot, poses)


if __name__ == "__main__":
    main()
