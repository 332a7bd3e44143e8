"""Frames of a camera for OpenCV: a real robot, its camera process, RTP on 127.0.0.1."""

from __future__ import annotations

from datetime import UTC, datetime, timedelta

import pytest

from jauspy.errors import ConfigError, RequestError, ResponseTimeout
from jauspy.ocu import camera as module
from jauspy.protocol.addressing import Location
from jauspy.transport.multicast import address_towards
from jauspy.video.receiver import RtpReceiver

np = pytest.importorskip("numpy")
pytest.importorskip("av")


@pytest.mark.slow
async def test_frames_are_images_in_bgr_with_a_time(node_manager, robot, ocu):
    inc1 = await ocu.robot(101)
    frames = inc1.camera("arm").frames()
    times = []
    async for frame in frames:
        assert frame.dtype == np.uint8
        assert frame.shape == (480, 640, 3)
        assert frame[10:20].time == frame.time
        if frame.time is not None:
            times.append(frame.time)
        if len(times) == 3:
            break
    await frames.aclose()
    assert sorted(times) == times
    assert abs(datetime.now(UTC) - times[-1]) < timedelta(seconds=10)
    assert sum(robot.videos["arm"].receivers.values()) == 0


@pytest.mark.slow
async def test_video_is_sent_as_it_was_set_and_counted(node_manager, robot, ocu):
    camera = (await ocu.robot(101)).camera("arm")
    assert not camera.counters
    with pytest.raises(ConfigError, match=r"JAUS has no video of 321x240; the sizes are .*320x240"):
        await camera.set_video(size=(321, 240))
    with pytest.raises(RequestError, match=r"101.1.106 refused the settings of its video: .+"):
        await camera.set_video(rate=250)
    await camera.set_video(size=(320, 240), rate=5)
    frames = camera.frames(silence=20.0)
    assert (await anext(frames)).shape == (240, 320, 3)
    await frames.aclose()
    assert camera.counters["pictures"] >= 1


@pytest.mark.slow
async def test_still_of_a_camera_by_name(node_manager, robot, ocu):
    camera = (await ocu.robot(101)).camera("chassis")
    with pytest.raises(ResponseTimeout, match="sent no picture of sensor 1 in 0 s"):
        await camera.still(timeout=0.0)
    photo = await camera.still(timeout=100.0)  # its process may take long to start
    assert photo.content[:2] == b"\xff\xd8"


async def test_cameras_are_named_when_one_is_to_be_chosen(robot, ocu):
    inc1 = await ocu.robot(101)
    with pytest.raises(ConfigError, match=r"This robot has 'arm', 'chassis', 'outside', as in robot.camera\('arm'\)"):
        await anext(inc1.camera().frames())
    with pytest.raises(ConfigError, match="there is no camera 'rear'"):
        await anext(inc1.camera("rear").frames())


async def test_robot_without_a_camera_says_so(ocu, virtual_network):
    async with virtual_network.component("7.1.1", []):
        with pytest.raises(ConfigError, match="has no camera: it does not offer DigitalVideo"):
            await anext((await ocu.robot(7)).camera().frames())


@pytest.mark.slow
async def test_no_picture_says_why(node_manager, robot, ocu, monkeypatch):
    monkeypatch.setattr(module.Camera, "_register", _ignored)
    with pytest.raises(RequestError, match=r"101.1.106 sends no picture to rtp://127.0.0.1:\d+: no packet arrived"):
        await anext((await ocu.robot(101)).camera("arm").frames(timeout=0.2))


async def _ignored(self, component, sensor, url) -> int:
    """A robot that confirms and then sends nothing."""
    return 7


def test_own_address_is_the_one_that_routes_to_the_robot():
    assert address_towards("127.0.0.1") == "127.0.0.1"
    assert address_towards("not an address") is None


@pytest.mark.slow
@pytest.mark.parametrize(
    ("location", "expected"),
    [(Location(is_here=True), "127.0.0.1"), (Location(hosts=frozenset({"127.0.0.1"})), "127.0.0.1")],
)
async def test_address_follows_the_machine_of_the_robot(robot, ocu, monkeypatch, location, expected):
    async def locate(self, id):
        return location

    monkeypatch.setattr(module.Connection, "locate", locate)
    inc1 = await ocu.robot(101)
    assert await inc1.camera("arm")._own_address(inc1.component(106).info) == expected


async def test_unknown_machine_asks_for_an_address(robot, ocu, monkeypatch):
    async def locate(self, id):
        return Location()

    monkeypatch.setattr(module.Connection, "locate", locate)
    with pytest.raises(ConfigError, match=r"unknown on which machine 101.1.106 is; .*frames\(address=...\)"):
        await anext((await ocu.robot(101)).camera("arm").frames())


@pytest.mark.slow
async def test_loop_that_is_left_by_break_ends_the_video_when_the_ocu_is_closed(node_manager, robot):
    async with node_manager.ocu() as ocu:
        async for _ in (await ocu.robot(101)).camera("arm").frames():
            assert sum(robot.videos["arm"].receivers.values()) == 1
            break
    assert sum(robot.videos["arm"].receivers.values()) == 0


@pytest.mark.slow
async def test_no_picture_says_what_the_camera_says(node_manager, robot, ocu, monkeypatch):
    """Not that a firewall may be in between: what it says has arrived."""
    monkeypatch.setattr(module.Camera, "_register", _ignored)
    monkeypatch.setattr(RtpReceiver, "note", "camera arm is still starting")
    camera = (await ocu.robot(101)).camera("arm")
    assert camera.note == ""
    with pytest.raises(ResponseTimeout, match=r"no picture to rtp://127.0.0.1:\d+: the camera says: camera arm is"):
        await anext(camera.frames(timeout=0.1))
