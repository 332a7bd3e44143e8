"""`jauspy navigate`: its arguments, and a robot that it drives."""

import json
import threading
import time
from pathlib import Path

import numpy as np
import pytest
from tests.helpers.command_line import jauspy, robot_in_thread
from tests.helpers.robot import described

from jauspy.cloud.stream import CloudPublisher
from jauspy.geometry.frames import FrameTree
from jauspy.mapping.grid import OccupancyGrid
from jauspy.mapping.map_files import save_map

pytest.importorskip("scipy", reason="planning needs scipy")


@pytest.mark.parametrize("goal", ["6", "6,-2,1", "six,two", "nan,2", "1,inf", ""])
def test_a_goal_is_two_numbers(goal):
    result = jauspy("navigate", "101", "--to", goal, status=2)
    assert "write x,y in metres, as in 6,-2" in " ".join(result.stderr.replace("│", " ").split())


@pytest.mark.parametrize("start", ["1,2", "1,2,north", "1,2,inf"])
def test_a_start_is_two_numbers_and_an_angle(tmp_path, start):
    save_map(OccupancyGrid(), tmp_path / "house")
    result = jauspy("navigate", "101", "--to", "6,0", "--map", str(tmp_path / "house.yaml"), "--start", start, status=2)
    assert "write x,y in metres and the heading in degrees, as in 2,0,90" in " ".join(
        result.stderr.replace("│", " ").split()
    )


def test_a_start_needs_a_map():
    result = jauspy("navigate", "101", "--to", "6,0", "--start", "1,2,90", status=2)
    assert "give --map, too" in result.stderr


def test_maps_are_read_and_their_folder_is_looked_for_before_the_robot(tmp_path):
    result = jauspy("navigate", "101", "--to", "6,0", "--map", str(tmp_path / "house.yaml"), status=1)
    assert "house.yaml: cannot be read: No such file" in result.stderr
    result = jauspy("navigate", "101", "--to", "6,0", "--save-map", str(tmp_path / "nowhere" / "house"), status=1)
    assert "does not exist" in " ".join(result.stderr.split())


@pytest.mark.slow
def test_the_map_of_a_drive_is_written_and_a_robot_that_sees_nothing_is_not_found_in_it(tmp_path):
    with robot_in_thread() as running:
        asked = ("navigate", "101", "--to", "1,0", "--connect", running.local)
        jauspy(*asked, "--save-map", str(tmp_path / "plain"), status=0)
        notes, picture = tmp_path / "plain.yaml", tmp_path / "plain.pgm"
        assert notes.exists()
        assert picture.exists()
        result = jauspy(*asked, "--map", str(notes), status=1)
    assert "the lidar sees too little to find the robot in the map near (" in " ".join(result.stderr.split())


@pytest.mark.slow
def test_a_way_is_shown_and_driven():
    with robot_in_thread() as running:
        shown = jauspy("navigate", "101", "--to", "2,0.5", "--dry-run", "--json", "--connect", running.local, status=0)
        way = json.loads(shown.stdout)
        assert way["length"] == pytest.approx(2.06, abs=0.25)
        driven = jauspy("navigate", "101", "--to", "2,0.5", "--json", "--connect", running.local, status=0)
        rows = [json.loads(line) for line in driven.stdout.splitlines()]
        assert rows[0]["left"] > 1.0
        assert rows[-1]["arrived"]
        assert (rows[-1]["x"], rows[-1]["y"]) == (pytest.approx(2.0, abs=0.35), pytest.approx(0.5, abs=0.35))


@pytest.mark.slow
def test_the_way_leads_around_what_only_the_clouds_show(tmp_path: Path) -> None:
    """A wall 1.5 m ahead and 2 m wide, in clouds of the camera; the lidar of a kinematic robot sees nothing."""
    pytest.importorskip("pynng", reason="clouds need pynng")
    address, ended = f"ipc://{tmp_path}/cloud", threading.Event()
    camera = FrameTree(described("inc1")[1].description).pose("chassis_camera_link")
    y, z = np.meshgrid(np.arange(-1.0, 1.0, 0.02), np.arange(0.0, 0.5, 0.02))
    wall = np.column_stack([np.full(y.size, 1.5), y.ravel(), z.ravel()])
    points = ((wall - camera.position) @ np.array(camera.rotation)).astype("<f4").tobytes()

    def publish() -> None:
        with CloudPublisher(address) as publisher:
            while not ended.wait(0.1):
                publisher.publish(points, "chassis_camera_link", time.time())

    publishing = threading.Thread(target=publish)
    publishing.start()
    try:
        with robot_in_thread() as running:
            asked = ("navigate", "101", "--to", "3,0", "--dry-run", "--json", "--cloud", address)
            shown = jauspy(*asked, "--connect", running.local, status=0)
    finally:
        ended.set()
        publishing.join()
    assert json.loads(shown.stdout)["length"] > 3.4
