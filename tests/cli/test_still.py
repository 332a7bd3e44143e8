"""`jauspy still` beside a robot whose cameras see sky and floor."""

from __future__ import annotations

import json

import pytest
from tests.helpers.command_line import jauspy, robot_in_thread

pytest.importorskip("av", reason="the extra 'video' is not installed")
cv2 = pytest.importorskip("cv2", reason="the extra 'video' is not installed")


@pytest.fixture(scope="module")
def robot():
    """Where a robot listens."""
    with robot_in_thread() as running:
        yield ["--connect", running.local]


@pytest.mark.slow
def test_picture_format_follows_the_file_suffix(robot, tmp_path):
    jpeg, png = tmp_path / "arm.jpg", tmp_path / "front.PNG"
    run = jauspy("still", "101.1.106", "--save", str(jpeg), "--timeout", "100", *robot)
    assert f"{jpeg}: JPEG by sensor 1 of 101.1.106, " in run.stdout
    assert jpeg.read_bytes().startswith(b"\xff\xd8\xff")
    assert cv2.imread(str(jpeg)).shape == (480, 640, 3)
    run = jauspy("still", "101.1.107", "--save", str(png), "--size", "1280x720", "--timeout", "100", *robot)
    assert png.read_bytes().startswith(b"\x89PNG")
    assert cv2.imread(str(png)).shape == (720, 1280, 3)
    asked = "query_still_image_sensor_configuration_list=[{sensor_id: 1, query_presence_vector: 255}]"
    run = jauspy("query", "101.1.107", "QueryStillImageSensorConfiguration", asked, *robot)
    (found,) = json.loads(run.stdout)["fields"]["still_image_sensor_configuration_list"]
    assert (found["frame_size"], found["still_image_format"]) == ("VGA_640_X480", "JPEG")


@pytest.mark.slow
def test_missing_camera_or_sensor_is_an_error(robot, tmp_path):
    run = jauspy("still", "101.1.102", "--save", str(tmp_path / "x.jpg"), *robot, status=1)
    assert "101.1.102 does not offer StillImage; it offers" in " ".join(run.stderr.split())
    run = jauspy("still", "101.1.106", "--save", str(tmp_path / "x.jpg"), "--sensor", "4", *robot, status=1)
    assert "101.1.106 has no sensor 4" in run.stderr


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (["101.1.255", "--save", "x.jpg"], "has wildcards"),
        (["101.1.106", "--save", "x.gif"], "the format of x.gif is unknown; use a suffix of .jpg, .jpeg, .png"),
        (["101.1.106", "--save", "/no/such/folder/x.jpg"], "the directory /no/such/folder does not exist"),
        (["101.1.106", "--save", "x.jpg", "--size", "large"], "'large' is not a size, as in --size 640x480"),
    ],
)
def test_wrong_usage_ends_with_status_2(arguments, said):
    run = jauspy("still", *arguments, status=1)
    assert said in " ".join(run.stderr.split())
