"""Render pictures of the included worlds with inc1 in them, for docs/robots.md.

    python tools/draw_worlds.py [-o FOLDER] [--all] [NAME ...]

writes world_NAME.jpg, with `--all` also world_NAME_2.jpg and so on from the other views. Needs GL.
"""

from __future__ import annotations

import argparse
import os
from pathlib import Path
from typing import Final, NamedTuple

os.environ.setdefault("MUJOCO_GL", "egl")

import mujoco
import numpy as np
from PIL import Image

from jauspy.robot.robot_files import load, robot_model
from jauspy_sim.assembly import build

TARGET: Final = Path(__file__).parents[1] / "docs" / "assets"
WIDTH: Final = 1280
HEIGHT: Final = 720
SHADOWS: Final = 8192
"""Pixels of a side of the shadow map."""
SHADOW_RADIUS: Final = 14.0
"""Metres around the middle in which things cast shadows."""


class View(NamedTuple):
    """Where a camera looks, from how far (m), and from where (degrees)."""

    at: tuple[float, float, float]
    distance: float
    azimuth: float
    elevation: float


VIEWS: Final = {
    "street": (
        View((1.5, 0.4, 0.5), 6.4, 25.0, -16.0),
        View((3.2, 0.1, 0.3), 2.8, -20.0, -20.0),
        View((0.0, 2.0, 1.0), 12.0, -55.0, -22.0),
    ),
    "house": (
        View((4.0, 0.0, 0.6), 10.5, -38.0, -42.0),
        View((1.4, 0.0, 0.8), 4.2, 20.0, -14.0),
        View((5.6, 2.4, 0.6), 5.5, -140.0, -32.0),
    ),
    "rubble": (View((1.4, 0.0, 0.2), 5.4, 35.0, -17.0), View((2.6, -0.4, 0.3), 4.0, -40.0, -18.0)),
    "yard": (
        View((2.8, 0.5, 0.7), 6.9, 13.0, -15.0),
        View((0.9, 0.2, 0.4), 7.0, 118.0, -18.0),
        View((5.0, -2.5, 0.5), 8.5, -30.0, -14.0),
    ),
}


def draw(world: str, folder: Path, count: int) -> None:
    """Write the pictures of a world."""
    robot = robot_model(load("inc1"))
    model = build(robot, world)
    model.vis.global_.offwidth, model.vis.global_.offheight = WIDTH, HEIGHT
    model.vis.quality.offsamples = 8
    model.vis.quality.shadowsize = SHADOWS
    model.vis.map.shadowclip = SHADOW_RADIUS / model.stat.extent
    data = mujoco.MjData(model)
    for group in robot.groups.values():
        for joint, start in zip(group.joints, group.start, strict=True):
            data.joint(f"inc1/{joint}").qpos[0] = start
    mujoco.mj_forward(model, data)
    with mujoco.Renderer(model, HEIGHT, WIDTH) as renderer:
        for number, view in enumerate(VIEWS[world][:count], 1):
            camera = mujoco.MjvCamera()
            camera.lookat[:], camera.distance, camera.azimuth, camera.elevation = view
            renderer.update_scene(data, camera)
            for light in renderer.scene.lights[: renderer.scene.nlight]:
                if light.castshadow:  # the shadow map is around the point below the light
                    light.pos = np.array(view.at) - 20.0 * np.array(light.dir)
            name = f"world_{world}.jpg" if number == 1 else f"world_{world}_{number}.jpg"
            Image.fromarray(renderer.render()).save(folder / name, quality=84, optimize=True)


def main() -> None:
    """Draw what was asked for."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("names", nargs="*", metavar="NAME", help=f"worlds: {', '.join(VIEWS)} (default: all)")
    parser.add_argument("-o", "--output", type=Path, default=TARGET, metavar="FOLDER")
    parser.add_argument("--all", action="store_true", help="all views, not only the first")
    options = parser.parse_args()
    for name in options.names or VIEWS:
        draw(name, options.output, len(VIEWS[name]) if options.all else 1)


if __name__ == "__main__":
    main()
