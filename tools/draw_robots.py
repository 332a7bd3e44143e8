"""Draw the robots for docs/robots.md, with MuJoCo and the renderer of the cameras (needs GL).

    python tools/draw_robots.py [-o FOLDER] [NAME ...]

writes JPEG files to docs/assets, or to FOLDER; with names, only these.
"""

from __future__ import annotations

import argparse
import os
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Final

os.environ.setdefault("MUJOCO_GL", "egl")

import mujoco
import numpy as np
from numpy.typing import NDArray
from PIL import Image

from jauspy.robot.robot_files import load, robot_model
from jauspy_sim.assembly import build, prefix

TARGET: Final = Path(__file__).parents[1] / "docs" / "assets"
SIZE: Final = (1200, 750)
FINER: Final = 2
"""Pictures are rendered so many times as large, and reduced."""
SHADOWS: Final = 8192
"""Pixels of a side of the shadow map."""

REACHING: Final = {
    "arm_link_1_to_arm_link_2": 1.25,
    "arm_link_2_to_arm_link_3": -1.05,
    "arm_link_3_to_arm_link_4": -0.45,
    "base_link_to_flippers": 0.35,
    "base_link_to_pan_link": 0.35,
}
"""The arm stretched out, flippers before the tracks."""


@dataclass(frozen=True)
class View:
    """A picture: what is seen, and from where."""

    look_at: tuple[float, float, float]
    distance: float
    azimuth: float
    """Degrees, of the direction of sight."""
    elevation: float
    robot: str = "inc1"
    pose: Mapping[str, float] = field(default_factory=dict)
    """Positions of joints; others are at their start."""
    shadow_radius: float = 2.4
    """Metres around the middle in which things cast shadows."""


VIEWS: Final[Mapping[str, View]] = {
    "inc1_front": View((0.02, 0.0, 0.28), 1.65, 152.0, -17.0),
    "inc1_side": View((0.09, 0.0, 0.31), 1.75, 84.0, -9.0, pose=REACHING),
    "inc1_rear": View((-0.05, 0.0, 0.26), 1.6, 38.0, -24.0),
    "inc1_gripper": View((0.74, 0.0, 0.56), 0.60, 128.0, -30.0, pose=REACHING),
    "inc1_camera": View((0.37, 0.0, 0.235), 0.36, 165.0, -10.0),
    "inc1_track": View((-0.02, -0.3, 0.13), 0.95, 112.0, -10.0, pose={"base_link_to_flippers": 0.9}),
    "inc1_pprm": View(
        (0.10, 0.0, 0.42),
        2.2,
        140.0,
        -14.0,
        "inc1_pprm",
        pose={"mast_to_arm_link_1": 0.32, "arm_link_1_to_arm_link_2": 0.22},
    ),
}


def posed(view: View) -> tuple[mujoco.MjModel, mujoco.MjData]:
    """The robot in its pose, in the empty world."""
    robot = robot_model(load(view.robot))
    model = build(robot, "empty")
    data = mujoco.MjData(model)
    name = prefix(view.robot)
    for group in robot.groups.values():
        for joint, start in zip(group.joints, group.start, strict=True):
            data.joint(f"{name}{joint}").qpos[:] = view.pose.get(joint, start)
    for joint_ in robot.description.joints.values():
        if joint_.mimics is not None:
            data.joint(f"{name}{joint_.name}").qpos[:] = data.joint(f"{name}{joint_.mimics}").qpos
    mujoco.mj_forward(model, data)
    return model, data


def rendered(view: View) -> NDArray[np.uint8]:
    """The picture, larger than it will be."""
    model, data = posed(view)
    width, height = (FINER * side for side in SIZE)
    model.vis.global_.offwidth, model.vis.global_.offheight = width, height
    model.vis.quality.shadowsize = SHADOWS
    model.vis.map.shadowclip = view.shadow_radius / model.stat.extent
    model.vis.map.znear = 0.02 / model.stat.extent
    camera = mujoco.MjvCamera()
    camera.lookat, camera.distance = view.look_at, view.distance
    camera.azimuth, camera.elevation = view.azimuth, view.elevation
    with mujoco.Renderer(model, height, width) as renderer:
        renderer.update_scene(data, camera)
        for light in renderer.scene.lights[: renderer.scene.nlight]:
            if light.castshadow:  # the shadow map is around the point below the light
                light.pos = np.array(view.look_at) - 10.0 * np.array(light.dir)
        return np.array(renderer.render())


def main() -> None:
    """Write the pictures."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("names", nargs="*", metavar="NAME", help=f"of {', '.join(VIEWS)}")
    parser.add_argument("-o", "--output", type=Path, default=TARGET, metavar="FOLDER")
    options = parser.parse_args()
    if unknown := set(options.names) - set(VIEWS):
        parser.error(f"there is no picture {', '.join(sorted(unknown))}; known are: {', '.join(VIEWS)}")
    for name in options.names or VIEWS:
        file = options.output / f"{name}.jpg"
        picture = Image.fromarray(rendered(VIEWS[name])).resize(SIZE, Image.Resampling.LANCZOS)
        picture.save(file, quality=88, optimize=True, progressive=True)
        print(f"{file.name}: {file.stat().st_size // 1000} kB")


if __name__ == "__main__":
    main()
