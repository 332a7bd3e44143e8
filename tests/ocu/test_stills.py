"""Pictures for an OCU: large ones, through a node manager."""

from __future__ import annotations

import asyncio
import os
import zlib
from datetime import UTC, datetime, timedelta

import pytest
from tests.robot.cameras import FakeVideo

from jauspy.component import Component, ComponentOptions
from jauspy.errors import ConfigError, ControlRejected, RequestError, ResponseTimeout
from jauspy.geometry.poses import Transform
from jauspy.ids import JausID
from jauspy.messages import environment_sensing as m
from jauspy.ocu import OCU
from jauspy.ocu.stills import LARGE_IMAGE_DELIVERY
from jauspy.platform.camera import CameraSetup
from jauspy.platform.video_settings import Still, StillFormat, StillSettings
from jauspy.services.core import Discovery
from jauspy.services.environment_sensing import StillImage, VideoCamera, VisualSensor
from jauspy.services.host import Host

CAMERA = JausID(101, 1, 106)


class LargeVideo(FakeVideo):
    """Develops at once: pictures as large as they could be at worst."""

    def take(self, settings, then):
        super().take(settings, then)
        self.last = settings
        if not self.sleeps:
            self.develop(Still(self.picture, 0.0))


@pytest.fixture
def video():
    made = LargeVideo(CameraSetup("arm", "link", 1.0))
    made.picture, made.last, made.sleeps = os.urandom(500_000), None, False
    return made


@pytest.fixture
async def service(node_manager, video):
    """StillImage of that camera, as an OCU that comes in by UDP sees it."""
    cameras = {1: VideoCamera(Transform, source=video)}
    services = [Discovery(), VisualSensor(cameras), StillImage(cameras)]
    host = Host(CAMERA, services, utc_now=lambda: datetime.now(UTC), now=node_manager.now())
    async with (
        Component.of_host(
            host, node_manager.transport(CAMERA), options=ComponentOptions(delivery=LARGE_IMAGE_DELIVERY)
        ),
        OCU("42.1.1", node_manager.udp, delivery=LARGE_IMAGE_DELIVERY) as ocu,
    ):
        robot = await ocu.discover(CAMERA.subsystem)
        yield robot.component(str(CAMERA)).service("StillImage")


async def test_large_image_arrives_complete(service, video):
    photo = await service.still(timeout=20.0)
    assert zlib.crc32(photo.content) == zlib.crc32(video.picture)
    assert (photo.format, photo.sensor) == ("JPEG", 1)
    assert photo.taken is not None
    assert photo.taken.utcoffset() == timedelta(0)
    video.picture = os.urandom(1_500_000)
    photo = await service.still(timeout=40.0)
    assert zlib.crc32(photo.content) == zlib.crc32(video.picture)


async def test_size_and_format_apply_to_one_image(service, video):
    photo = await service.still(size=(1280, 720), format="png", timeout=20.0)
    assert photo.format == "PNG"
    assert video.last == StillSettings(1280, 720, StillFormat.PNG)
    await service.still(format="JPEG", timeout=20.0)
    assert video.last == StillSettings(640, 480, StillFormat.JPEG)


async def test_existing_control_is_used(service, video):
    async with service.control():
        await service.still(size=(320, 240), timeout=20.0)
    assert video.last.width == 320


async def test_unchanged_settings_need_no_control(service, node_manager):
    async with OCU("42.2.1", node_manager.udp) as other:
        robot = await other.discover(CAMERA.subsystem)
        async with robot.component(str(CAMERA)).service("StillImage").control(200):
            await service.still(size=(640, 480), format="jpeg", timeout=20.0)
            with pytest.raises(ControlRejected, match=r"42\.2\.1"):
                await service.still(size=(320, 240), timeout=20.0)


async def test_unsupported_settings_are_rejected(service, video):
    with pytest.raises(ConfigError, match="no images of 641x480; the sizes are 128x96, "):
        await service.still(size=(641, 480))
    with pytest.raises(ConfigError, match="no image format 'webp'; there are JPEG, GIF, PNG"):
        await service.still(format="webp")
    with pytest.raises(RequestError, match="refuses that for sensor 1: the camera writes JPEG and PNG only"):
        await service.still(format="tiff")
    with pytest.raises(RequestError, match=r"101\.1\.106 has no sensor 3"):
        await service.still(sensor=3)
    video.refuses = True
    with pytest.raises(RequestError, match="has no picture of sensor 1"):
        await service.still()


async def test_report_without_image_is_queried_again(service, video):
    video.sleeps = True
    with pytest.raises(ResponseTimeout, match=r"no picture of sensor 1 in 0\.4 s: its camera may still be starting"):
        await service.still(timeout=0.4)


@pytest.mark.parametrize("start", [15.0, 35.0, 60.0])
async def test_slowly_starting_camera_is_awaited(virtual_network, video, start):
    """Its component gives up after ten seconds, and says that there is no picture."""
    video.sleeps = True
    cameras = {1: VideoCamera(Transform, source=video)}
    async with (
        virtual_network.component(CAMERA, [VisualSensor(cameras), StillImage(cameras)]),
        virtual_network.ocu() as ocu,
    ):
        service = (await ocu.discover(CAMERA.subsystem)).component(str(CAMERA)).service("StillImage")
        asked = asyncio.create_task(service.still(timeout=40.0))
        await asyncio.sleep(start)
        video.develop(Still(b"a picture", 0.0))
        if start < 40.0:
            assert (await asked).content == b"a picture"
        else:
            with pytest.raises(ResponseTimeout, match="in 40 s: its camera may still be starting"):
                await asked


async def test_images_arrive_as_events(service, video):
    query = m.QueryStillImageDataExt
    record = query.QueryStillImageDataRec(1, query.ReportCoordinateSystem.NATIVE, 2)
    video.picture = os.urandom(100_000)
    seen = []
    async with service.subscribe(query([record]), rate=10.0) as reports:
        async for report in reports:
            seen.append(report.still_image_data_list[0].image_frame.data)
            if len(seen) == 3:
                break
    assert seen == [video.picture] * 3
