"""Try robots of others in the simulation: load them, move each joint and the chassis, make a picture.

MUJOCO_GL=egl python tools/try_robots.py FILE|DIRECTORY... [-o DIRECTORY] [--package-path DIRECTORY] [--arg NAME:=VALUE]
    [--skip-missing-packages] [--placeholder-meshes]

Of a directory, all files that end in .urdf or .urdf.xacro. Each robot gets a first file as of `jauspy new robot`. The
table tells how many joints of each moved where they were commanded to, and what was wrong; pictures are in the output
directory. Robots and worlds of others are not part of jauspy: download them elsewhere.
"""

from __future__ import annotations

import argparse
import math
import sys
import time
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Final

import mujoco
import numpy as np
from PIL import Image

from jauspy.cli.new.robot import first_file
from jauspy.errors import ConfigError
from jauspy.platform.description import RobotModel
from jauspy.platform.joints import ControlMode, JointGroup, Target
from jauspy.robot import robot_files
from jauspy.robot.missing_parts import MissingPolicy
from jauspy.robot.urdf_files import read_urdf
from jauspy.robot.urdf_paths import PackagePaths
from jauspy_sim.assembly import build
from jauspy_sim.robot import SimulatedRobot

STEP: Final = 0.3
"""Radians, or a third of metres, that each joint is moved, if its limits permit that."""
TOLERANCE: Final = 0.1
"""Of that way."""
TIMEOUT: Final = 4.0
"""Simulated seconds that a joint may take longer than its way takes at its greatest velocity."""
SIZE: Final = (960, 720)


@dataclass(frozen=True, slots=True)
class Result:
    """What was seen of one robot."""

    moved: int
    joints: int
    driven: float
    """Metres, of a robot on wheels."""
    seconds: float
    """To load it."""
    speed: float
    """Simulated seconds in one."""


def main() -> None:
    """Try all robots that are given."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("robots", nargs="+", type=Path)
    parser.add_argument("-o", "--output", type=Path, default=Path("robots-tried"))
    parser.add_argument("--package-path", action="append", type=Path, default=[])
    parser.add_argument("--arg", action="append", default=[])
    parser.add_argument("--skip-missing-packages", action="store_true")
    parser.add_argument("--placeholder-meshes", action="store_true")
    options = parser.parse_args()
    extra: dict[str, object] = {}
    if options.package_path:
        extra["package_path"] = [str(each.resolve()) for each in options.package_path]
    if options.arg:
        extra["xacro_arguments"] = dict(each.split(":=", 1) for each in options.arg)
    extra |= {key: True for key in ("skip_missing_packages", "placeholder_meshes") if getattr(options, key)}
    options.output.mkdir(parents=True, exist_ok=True)
    failed = 0
    for number, path in enumerate(_files(options.robots)):
        try:
            result = _try(path, options.output / f"{number:02}_{path.name.split('.')[0]}", extra)
        except ConfigError as error:
            failed += 1
            print(f"{path.name:36} FAILED  {error}", flush=True)
            continue
        wheels = f", drove {result.driven:.2f} m" if result.driven else ""
        print(
            f"{path.name:36} loaded in {result.seconds:.1f} s, {result.moved} of {result.joints} joints moved{wheels}, "
            f"{result.speed:.0f} x real time",
            flush=True,
        )
    sys.exit(failed > 0)


def _files(paths: list[Path]) -> list[Path]:
    found: list[Path] = []
    for path in paths:
        inner = sorted(each for each in path.rglob("*") if each.name.endswith((".urdf", ".urdf.xacro")))
        found += inner if path.is_dir() else [path]
    return found


def _try(path: Path, output: Path, extra: dict[str, Any]) -> Result:
    packages = PackagePaths(tuple(map(Path, extra.get("package_path", ()))))
    policy = MissingPolicy(extra.get("skip_missing_packages", False), extra.get("placeholder_meshes", False))
    description = read_urdf(str(path), packages, extra.get("xacro_arguments"), policy, tell=lambda _: None)
    toml = output.with_suffix(".toml")
    toml.write_text(first_file(description, str(path.resolve()), 101, extra))
    began = time.monotonic()
    model = robot_files.robot_model(robot_files.load(toml.absolute()))
    robot = SimulatedRobot.open(model, "empty")
    loaded = time.monotonic() - began
    try:
        driven = _drive(robot) if model.wheels else 0.0
        moved = sum(_moves(robot, group, at) for group in robot.groups.values() for at in range(len(group.joints)))
        began = time.monotonic()
        robot.advance(1.0)
        speed = 1.0 / (time.monotonic() - began)
        _picture(robot, model, output.with_suffix(".png"))
        joints = sum(len(group.joints) for group in robot.groups.values())
        return Result(moved, joints, driven, loaded, speed)
    finally:
        robot.close()


def _drive(robot: SimulatedRobot) -> float:
    before = robot.data.qpos[:2].copy()
    robot.drive.set_effort(0.5, 0.0)
    robot.advance(3.0)
    robot.drive.stop()
    robot.advance(1.0)
    return float(np.linalg.norm(robot.data.qpos[:2] - before))


def _moves(robot: SimulatedRobot, group: JointGroup, at: int) -> bool:
    """Whether a joint goes where it is commanded to."""
    joint = group.joints[at]
    position = group.state().positions[at]
    way = STEP if joint.turns else STEP / 3.0
    if math.isfinite(joint.upper - joint.lower):
        way = min(way, 0.3 * (joint.upper - joint.lower))
    reached = goal = position
    for goal in (position + way, position - way):  # one of them may lead into the ground
        if not joint.lower <= goal <= joint.upper:
            continue
        _command(group, at, goal)
        deadline = robot.time + TIMEOUT + way / joint.velocity
        while robot.time < deadline:
            robot.advance(0.1)
            if abs(group.state().positions[at] - goal) < TOLERANCE * way:
                return True
        reached = group.state().positions[at]
        _command(group, at, position)
        robot.advance(1.0)
    print(f"  {joint.name}: is at {reached:.3f}, and not at {goal:.3f}", flush=True)
    return False


def _command(group: JointGroup, at: int, goal: float) -> None:
    targets: list[Target | None] = [None] * len(group.joints)
    targets[at] = Target(ControlMode.POSITION, goal)
    group.command(targets)


def _picture(robot: SimulatedRobot, model: RobotModel, path: Path) -> None:
    drawn = build(model, "empty")
    data = mujoco.MjData(drawn)
    data.qpos[:] = robot.data.qpos
    mujoco.mj_forward(drawn, data)
    seen = [number for number in range(drawn.ngeom) if drawn.geom_group[number] == 1] or [0]
    boxes = [(data.geom_xpos[number], drawn.geom_rbound[number]) for number in seen]
    low = np.min([place - 0.6 * reach for place, reach in boxes], axis=0)
    high = np.max([place + 0.6 * reach for place, reach in boxes], axis=0)
    camera = mujoco.MjvCamera()
    camera.azimuth, camera.elevation = 130.0, -20.0
    camera.lookat[:], camera.distance = (low + high) / 2.0, 1.3 * float(np.linalg.norm(high - low)) + 0.2
    drawn.vis.global_.offwidth, drawn.vis.global_.offheight = SIZE
    drawn.vis.map.znear = 0.01 / drawn.stat.extent
    with mujoco.Renderer(drawn, SIZE[1], SIZE[0]) as renderer:
        renderer.update_scene(data, camera)
        Image.fromarray(renderer.render()).save(path)


if __name__ == "__main__":
    main()
