"""Film a robot that loses its link in the house `house` and drives back out of it: docs/robots.md shows the pictures.

    python tools/film_retrotraverse.py FILM.mp4 [--period SECONDS]

The door stands open. The physics are those of the backend `sim`, on virtual time; where the robot is, the film says.
"""

from __future__ import annotations

import argparse
import math
import sys
import tempfile
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any, Final

import av

sys.path.insert(0, str(Path(__file__).parents[1]))

from tests.helpers.robot import described
from tests.robot.test_lost_links import CONTROL, back, policy, status_of
from tests.robot.world import World
from tests.system.test_lost_link_in_house import with_open_door

from jauspy.backends import find
from jauspy.messages.core import RequestControl
from jauspy.messages.mobility import SetLocalWaypoint, SetTravelSpeed
from jauspy.platform.camera import CameraSetup, OutsideSetup, Viewpoint
from jauspy.platform.localization import Localization

SIZE: Final = (640, 360)
RATE: Final = 10
"""Pictures per second of the film."""
LONGEST_PERIOD: Final = 2.0
"""Seconds between two pictures, at most: control ends when the client is silent longer."""
WAY: Final = ((3.2, 0.0), (7.55, 0.0), (7.55, 2.6))
"""Metres: through the door, along the corridor, and around the corner into the room behind it."""


def driven(world: World, period: float) -> Iterator[None]:
    """The whole story: a moment each `period` seconds."""
    world.take_control()
    world.tell(policy(back(50.0), timeout=7))
    for x, y in WAY:
        world.tell(SetLocalWaypoint(x=x, y=-y), SetTravelSpeed(0.45))
        while world.now < 60.0 and math.dist((world.vehicle.pose.x, world.vehicle.pose.y), (x, -y)) > 0.4:
            if world.robot.drive.pose().y < 1.2:
                world.tell(RequestControl(200))  # the link is good
            world.run(period)
            yield
            if world.host.controller is None:
                break
    while world.now < 120.0:
        world.run(period)
        yield
        if world.host.controller is None and world.own_motion.parts == frozenset() and world.robot.drive.pose().x < 0.3:
            return


def main() -> None:
    """Drive and film."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("film", type=Path)
    parser.add_argument("--period", type=float, default=0.5, help="seconds between two pictures")
    arguments = parser.parse_args()
    if not 0.0 < arguments.period <= LONGEST_PERIOD:
        parser.error(f"--period is above 0 and up to {LONGEST_PERIOD:g} s: the robot hears its client once in each")
    above = OutsideSetup(Viewpoint.FIXED, position=(5.0, 0.4, 8.5))
    camera = CameraSetup("above", "", math.radians(40.0), outside=above)
    model = replace(described("inc1")[1], lidars=(), cameras=(camera,))
    with tempfile.TemporaryDirectory() as folder, av.open(str(arguments.film), "w") as container:
        robot = find("sim").open(model, str(with_open_door(Path(folder))))
        world = World("sim", robot=robot, localization=Localization.of(robot), timeout=CONTROL)
        session: Any = robot.cameras["above"].open()
        stream = container.add_stream("libx264", rate=RATE)
        stream.width, stream.height, stream.pix_fmt = *SIZE, "yuv420p"
        for _ in driven(world, arguments.period):
            frame = av.VideoFrame.from_ndarray(session.look(*SIZE).image, format="rgb24")
            container.mux(stream.encode(frame))
            pose = robot.drive.pose()
            print(f"{world.now:6.1f} s  x {pose.x:5.2f}  y {pose.y:5.2f}  back: {status_of(world)}", flush=True)
        container.mux(stream.encode())
        session.close()
        robot.close()


if __name__ == "__main__":
    main()
