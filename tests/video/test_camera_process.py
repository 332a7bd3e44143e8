from __future__ import annotations

import asyncio
import dataclasses
import math
import os
import signal
import subprocess
import sys
from contextlib import suppress
from pathlib import Path

import pytest
from tests.helpers.sampling import sampled

from jauspy.testing import until

pytest.importorskip("av", reason="the extra 'video' is not installed")
pytest.importorskip("cv2", reason="the extra 'video' is not installed")

import cv2
import numpy as np
import psutil

from jauspy import worker_process
from jauspy.backends.kinematic import KinematicRobot
from jauspy.backends.kinematic_camera import SKY_INDEX
from jauspy.errors import ConfigError
from jauspy.platform.camera import CameraSetup
from jauspy.platform.video_settings import StillFormat, StillSettings, VideoSettings
from jauspy.robot.robot_files import load, robot_model
from jauspy.video import camera_process
from jauspy.video.camera_process import CameraProcess
from jauspy.video.h264 import H264Decoder
from jauspy.video.imaging import read_numbers
from jauspy.video.receiver import RtpReceiver
from jauspy.video.sender import MAX_RECEIVERS

SMALL = VideoSettings(320, 240, 20)
TINY = StillSettings(128, 96, StillFormat.PNG)
TIMEOUT = 100.0
"""Seconds; cameras' processes have what other work leaves of the processors, which may be little."""


@pytest.fixture
def robot():
    setup = CameraSetup("front", "chassis_camera_link", math.radians(80.0))
    opened = KinematicRobot(dataclasses.replace(robot_model(load("inc1")), cameras=(setup,)))
    yield opened
    opened.close()


@pytest.fixture
async def camera(robot):
    async with CameraProcess(robot.cameras["front"], SMALL, stamped=True) as opened:
        yield opened


@pytest.fixture
def receiver():
    with RtpReceiver() as opened:
        yield opened


def at(receiver):
    return ("127.0.0.1", receiver.port)


async def images(receiver, count, decoder=None):
    decoder = decoder or H264Decoder()
    found = []
    async with asyncio.timeout(TIMEOUT):
        while len(found) < count:
            found += [decoder.decode(picture) for picture in receiver.take()]
            await asyncio.sleep(0.005)
    return found


@pytest.mark.slow
async def test_fallback_to_ray_casting_is_logged_once(monkeypatch, caplog):
    sim = pytest.importorskip("jauspy_sim.robot", reason="MuJoCo is not installed")
    monkeypatch.setenv("MUJOCO_GL", "disable")
    monkeypatch.setattr(worker_process, "RESTART_DELAYS", (0.01, 0.02))
    setup = CameraSetup("front", "chassis_camera_link", math.radians(80.0))
    robot = sim.SimulatedRobot.open(dataclasses.replace(robot_model(load("inc1")), cameras=(setup,)), "empty")
    async with CameraProcess(robot.cameras["front"], SMALL) as camera:
        camera.watch(("127.0.0.1", 2000), playing=False)
        await until(lambda: camera.description, TIMEOUT)
        os.kill(camera.pid, signal.SIGKILL)
        camera.take(TINY, (again := asyncio.get_running_loop().create_future()).set_result)
        await asyncio.wait_for(again, TIMEOUT)
        await until(lambda: camera.counters["started"] == 2, TIMEOUT)
    robot.close()
    said = [record for record in caplog.records if "casts rays" in record.message]
    assert [record.levelname for record in said] == ["WARNING"]


def nicenesses(pid):
    """Those of its threads; one may end meanwhile."""
    found = []
    for thread in Path(f"/proc/{pid}/task").iterdir():
        with suppress(ProcessLookupError):
            found.append(os.getpriority(os.PRIO_PROCESS, int(thread.name)))
    return found


@pytest.mark.slow
async def test_camera_process_has_lower_priority(monkeypatch, robot, receiver):
    monkeypatch.setattr(camera_process, "NICENESS", 5)
    async with CameraProcess(robot.cameras["front"], SMALL) as camera:
        camera.watch(("127.0.0.1", 2000), playing=False)
        await until(lambda: camera.description, TIMEOUT)
        ours = os.getpriority(os.PRIO_PROCESS, 0)
        assert os.getpriority(os.PRIO_PROCESS, camera.pid) == ours, "a thread of it can begin anew"
        camera.watch(at(receiver))
        async with asyncio.timeout(TIMEOUT):
            while min(5, 19 - ours) not in {nice - ours for nice in nicenesses(camera.pid)}:
                await images(receiver, 1)
        assert os.getsid(camera.pid) == os.getsid(0), "sessions get shares of their own"
        assert os.getpgid(camera.pid) != os.getpgid(0), "Ctrl-C is the robot's"


@pytest.mark.slow
async def test_the_process_starts_at_first_use_and_two_receivers_see_the_same_pictures(camera, receiver):
    decoder = H264Decoder()
    assert camera.pid is None
    with RtpReceiver() as other:
        camera.watch(at(receiver))
        first = await images(receiver, 3, decoder)
        camera.watch(at(other))
        second = await images(other, 3)
        numbers = [read_numbers(image)[0] for image in [*first, *await images(receiver, len(second), decoder)]]
    assert numbers == list(range(numbers[0], numbers[0] + len(numbers)))
    assert read_numbers(second[0])[0] > numbers[2]
    assert camera.counters["started"] == 1
    await until(lambda: camera.description.startswith("draws sky and floor"), TIMEOUT)


@pytest.mark.slow
async def test_the_size_changes_while_it_runs(camera, receiver):
    decoder = H264Decoder()
    camera.watch(at(receiver))
    assert (await images(receiver, 2, decoder))[0].shape == (240, 320, 3)
    camera.settings = VideoSettings(640, 480, 20)
    async with asyncio.timeout(TIMEOUT):
        while (await images(receiver, 1, decoder))[-1].shape != (480, 640, 3):
            pass
    assert not receiver.counters.get("lost")


@pytest.mark.slow
async def test_streams_can_be_paused_played_and_left(camera, receiver):
    with RtpReceiver() as other:
        camera.watch(at(receiver))
        camera.watch(at(other))
        paused = H264Decoder()
        before = read_numbers((await images(receiver, 2, paused))[-1])[0]
        camera.watch(at(receiver), playing=False)
        seen = read_numbers((await images(other, 20))[-1])[0]
        leftover = [read_numbers(paused.decode(picture))[0] for picture in receiver.take()]
        assert len(leftover) < 20
        camera.watch(at(receiver))
        after = read_numbers((await images(receiver, 1, paused))[0])[0]
        assert after > seen > before
        camera.leave(at(receiver))
        camera.leave(at(other))
        assert camera.receivers == {}


async def still_of(camera, settings):
    """A still image and its pixels."""
    taken = asyncio.get_running_loop().create_future()
    camera.take(settings, taken.set_result)
    still = await asyncio.wait_for(taken, TIMEOUT)
    return still, cv2.imdecode(np.frombuffer(still.content, np.uint8), cv2.IMREAD_COLOR)


@pytest.mark.slow
@pytest.mark.parametrize("size", sampled([(128, 96), (1280, 720)], 1), ids=str)
async def test_still_images_of_any_size_of_which_small_ones_are_anti_aliased(camera, size):
    """All from one process, because its start takes longer than an image."""
    for format in StillFormat:
        still, image = await still_of(camera, StillSettings(*size, format))
        assert still.content.startswith({StillFormat.JPEG: b"\xff\xd8\xff", StillFormat.PNG: b"\x89PNG"}[format])
        assert 0.0 < still.age < TIMEOUT
        assert image.shape == (size[1], size[0], 3)
        assert image.std() > 10.0
    for other, smooth in (((640, 480), True), ((1408, 1152), False)):
        _, image = await still_of(camera, StillSettings(*other, StillFormat.PNG))
        assert (len(np.unique(image.reshape(-1, 3), axis=0)) > SKY_INDEX + 1) is smooth
    assert camera.counters["started"] == 1


async def test_too_many_stills_and_receivers_are_refused(camera):
    for _ in range(camera_process.MAX_PENDING_STILLS):
        camera.take(TINY, lambda _: None)
    with pytest.raises(ConfigError, match="8 still images of this camera are pending"):
        camera.take(TINY, lambda _: None)
    for port in range(2000, 2000 + 2 * MAX_RECEIVERS, 2):
        camera.watch(("127.0.0.1", port), playing=False)
    with pytest.raises(ConfigError, match="8 receivers watch this camera already"):
        camera.watch(("127.0.0.1", 4000))


@pytest.mark.slow
async def test_dead_process_is_restarted(camera, receiver, caplog):
    camera.settings = dataclasses.replace(SMALL, width=160, height=120)
    camera.watch(at(receiver))
    await images(receiver, 2)
    lost = asyncio.get_running_loop().create_future()
    killed = camera.pid
    assert killed is not None
    os.kill(killed, signal.SIGSTOP)
    camera.take(TINY, lost.set_result)
    os.kill(killed, signal.SIGKILL)
    assert await asyncio.wait_for(lost, TIMEOUT) is None
    await until(lambda: receiver.take() == [] and camera.pid not in {killed, None}, TIMEOUT)
    assert (await images(receiver, 2))[0].shape == (120, 160, 3)
    assert camera.counters["started"] == 2
    assert camera.counters["stills_lost"] == 1
    assert "its process ended (-9); it starts again in 0.5 s" in caplog.text


@pytest.mark.slow
async def test_hanging_process_is_ended(camera, monkeypatch):
    monkeypatch.setattr(worker_process, "MAX_UNREAD", 1000)
    camera.watch(("127.0.0.1", 2000))
    await until(lambda: camera.description, TIMEOUT)
    os.kill(camera.pid, signal.SIGSTOP)
    hanging = camera.pid
    for number in range(20_000):
        camera.settings = dataclasses.replace(SMALL, gop=1 + number % 200)
        if camera.counters["hung"]:
            break
    await until(lambda: camera.pid not in {hanging, None}, TIMEOUT)


@pytest.mark.slow
async def test_process_without_still_is_ended(camera, monkeypatch):
    camera.watch(("127.0.0.1", 2000))
    await until(lambda: camera.description, TIMEOUT)
    hanging = camera.pid
    os.kill(hanging, signal.SIGSTOP)
    monkeypatch.setattr(camera_process, "STILL_TIMEOUT", 0.1)
    lost = asyncio.get_running_loop().create_future()
    camera.take(TINY, lost.set_result)
    assert await asyncio.wait_for(lost, TIMEOUT) is None
    assert camera.counters["hung"] == 1
    await until(lambda: camera.pid not in {hanging, None}, TIMEOUT)
    monkeypatch.undo()
    taken = asyncio.get_running_loop().create_future()
    camera.take(TINY, taken.set_result)
    assert (await asyncio.wait_for(taken, TIMEOUT)).content


@pytest.mark.slow
async def test_starting_process_is_not_ended(camera, monkeypatch):
    monkeypatch.setattr(camera_process, "STILL_TIMEOUT", 0.01)
    taken = asyncio.get_running_loop().create_future()
    camera.take(TINY, taken.set_result)
    await until(lambda: camera.description, TIMEOUT)
    monkeypatch.undo()
    assert (await asyncio.wait_for(taken, TIMEOUT)).content
    assert camera.counters["hung"] == 0


@pytest.mark.slow
async def test_process_ends_with_the_robot_process(tmp_path):
    program = tmp_path / "robot.py"
    program.write_text(
        """
import asyncio, dataclasses, math
from jauspy.robot.robot_files import robot_model
from jauspy.robot.robot_files import load
from jauspy.platform.camera import CameraSetup
from jauspy.backends.kinematic import KinematicRobot
from jauspy.platform.video_settings import VideoSettings
from jauspy.video.camera_process import CameraProcess

async def main():
    setup = CameraSetup("front", "chassis_camera_link", 1.0)
    robot = KinematicRobot(dataclasses.replace(robot_model(load("inc1")), cameras=(setup,)))
    async with CameraProcess(robot.cameras["front"], VideoSettings()) as camera:
        camera.watch(("127.0.0.1", 9))
        while camera.pid is None:
            await asyncio.sleep(0.01)
        print(camera.pid, flush=True)
        await asyncio.sleep(60.0)

asyncio.run(main())
"""
    )
    parent = await asyncio.create_subprocess_exec(sys.executable, str(program), stdout=subprocess.PIPE)
    child = int(await parent.stdout.readline())
    assert Path(f"/proc/{child}").exists()
    parent.kill()
    await parent.communicate()
    await until(lambda: is_over(child), TIMEOUT)


def is_over(pid):
    try:
        return psutil.Process(pid).status() == psutil.STATUS_ZOMBIE
    except psutil.NoSuchProcess:
        return True
