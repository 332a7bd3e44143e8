"""CM-VIS: still images on query and as events, and what they are set to."""

from __future__ import annotations

import asyncio
from datetime import UTC, datetime

import pytest
from tests.helpers.sampling import sampled
from tests.robot.cameras import CLIENT, OTHER, FakeVideo, Module

from jauspy.geometry.poses import Transform
from jauspy.messages import environment_sensing as m, registry
from jauspy.messages.core import CreateEvent, TimeStamp
from jauspy.messages.environment_sensing.v1_0.types import SensorIdRec, StillImageSensorErrorRec
from jauspy.platform.camera import CameraSetup
from jauspy.platform.video_settings import Still, StillFormat, StillSettings, VideoSettings
from jauspy.services.deferred import REPLY_TIMEOUT
from jauspy.services.environment_sensing import StillImage, VideoCamera, VisualSensor
from jauspy.services.host import Host

Query, Wanted = m.QueryStillImageDataExt, m.SetStillImageSensorConfiguration
Record = m.ReportStillImageDataExt.StillImageDataRec
Size, Format = Wanted.FrameSize, Wanted.StillImageFormat
Code = StillImageSensorErrorRec.StillImageErrorCode
STAMP, IMAGE, EVERYTHING = 1, 2, 0xFF
NATIVE = Query.ReportCoordinateSystem.NATIVE
PICTURE = Still(b"\xff\xd8 a picture", 0.25)
VGA = StillSettings(640, 480, StillFormat.JPEG)


@pytest.fixture
def module():
    made = Module()
    yield made
    made.robot.close()


def asking(*sensors, asked=EVERYTHING, system=NATIVE):
    return Query([Query.QueryStillImageDataRec(sensor, system, asked) for sensor in sensors])


def setting(sensor=1, **values):
    return Wanted(Wanted.RequestIdRec(5), [Wanted.StillImageSensorConfigurationRec(sensor, **values)])


def confirmed(answer):
    assert answer.request_id_rec.request_id == 5
    (record,) = answer.confirm_sensor_list
    return record


def records(sent):
    """The pictures of the one report."""
    ((_, report),) = sent
    return report.still_image_data_list


def test_query_takes_an_image_and_is_answered_later(module):
    module.now = 10.0
    assert module.tell(asking(1)) == []
    assert [settings for settings, _ in module.video.under_way] == [VGA]
    module.now = 10.5
    module.video.develop(PICTURE)
    ((to, report),) = module.run()
    assert to == CLIENT
    (record,) = report.still_image_data_list
    assert (record.sensor_id, record.report_coordinate_system) == (1, NATIVE)
    assert record.time_stamp == TimeStamp(250, 10, 0, 0, 1)
    assert (record.image_frame.format.name, record.image_frame.data) == ("JPEG", PICTURE.content)
    assert record.still_image_uri is None


@pytest.mark.parametrize(("asked", "fields"), [(STAMP, (True, False)), (IMAGE, (False, True)), (0, (False, False))])
def test_report_has_requested_fields_only(module, asked, fields):
    module.tell(asking(1, asked=asked))
    module.video.develop(PICTURE)
    (record,) = records(module.run())
    assert (record.time_stamp is not None, record.image_frame is not None) == fields


def test_images_are_not_transformed(module):
    module.tell(asking(1, system=Query.ReportCoordinateSystem.VEHICLE))
    module.video.develop(PICTURE)
    (record,) = records(module.run())
    assert record.report_coordinate_system == NATIVE


def test_unknown_sensors_have_no_image(module):
    module.tell(asking(7))
    assert records(module.run()) == []
    module.tell(asking(7, 0))
    module.video.develop(PICTURE)
    assert [record.sensor_id for record in records(module.run())] == [1]


def test_equal_requests_share_a_pending_image(module):
    module.tell(asking(1))
    module.tell(asking(1, asked=IMAGE), client=OTHER)
    module.tell(asking(1), client=CLIENT)
    assert len(module.video.under_way) == 1
    module.video.develop(PICTURE)
    assert [to for to, _ in module.run()] == [CLIENT, OTHER]
    module.tell(asking(1))
    assert len(module.video.under_way) == 1


@pytest.mark.parametrize("reason", ["refused", "lost", "silent"])
def test_failed_camera_is_reported_without_image(module, reason):
    module.video.refuses = reason == "refused"
    module.tell(asking(1))
    if reason == "lost":
        module.video.develop(None)
    ((_, report),) = module.run(REPLY_TIMEOUT)
    assert report.still_image_data_list == [Record(1, NATIVE)]
    counted = {"refused": "still_refused", "lost": "still_lost", "silent": "deferred_overdue"}[reason]
    assert module.host.counters[counted] == 1


# --- settings


def test_settings_apply_to_the_next_image(module):
    module.control()
    assert confirmed(module.ask(setting(frame_size=Size.HD720_1280_X720))) == SensorIdRec(1)
    assert confirmed(module.ask(setting(still_image_format=Format.PNG))) == SensorIdRec(1)
    module.tell(asking(1))
    assert [settings for settings, _ in module.video.under_way] == [StillSettings(1280, 720, StillFormat.PNG)]
    module.video.develop(Still(b"\x89PNG", 0.0))
    (record,) = records(module.run())
    assert record.image_frame.format.name == "PNG"
    query = m.QueryStillImageSensorConfiguration
    asked = [query.QueryStillImageSensorConfigurationRec(0, EVERYTHING)]
    (found,) = module.ask(query(asked)).still_image_sensor_configuration_list
    assert (found.frame_size, found.still_image_format) == (Size.HD720_1280_X720, Format.PNG)
    (found,) = module.ask(
        query([query.QueryStillImageSensorConfigurationRec(1, 1)])
    ).still_image_sensor_configuration_list
    assert (found.frame_size, found.still_image_format) == (Size.HD720_1280_X720, None)


def test_pending_image_keeps_its_format(module):
    module.control()
    module.tell(asking(1))
    module.tell(setting(still_image_format=Format.PNG))
    module.tell(asking(1), client=OTHER)
    module.video.develop(PICTURE)
    formats = {to: report.still_image_data_list[0].image_frame.format.name for to, report in module.run()}
    assert formats == {CLIENT: "JPEG", OTHER: "PNG"}


@pytest.mark.parametrize(
    ("record", "code"),
    [
        ({"sensor": 2}, Code.UNKNOWN_SENSOR_ID),
        ({"frame_size": Size.WHUXGA_7680_X4800}, Code.INVALID_FRAME_SIZE),
        ({"still_image_format": Format.GIF}, Code.INVALID_FORMAT),
        ({"frame_size": Size.QXGA_2048_X1536, "still_image_format": Format.DNG}, Code.MULTIPLE_INVALID_PARAMETERS),
    ],
)
def test_invalid_settings_are_refused_with_the_reason(module, record, code):
    module.control()
    refused = confirmed(module.ask(setting(**record)))
    assert refused.still_image_error_code == code
    assert refused.error_message
    module.tell(asking(1))
    assert module.video.under_way[0][0] == VGA


def test_settings_require_control(module):
    module.control()
    assert module.tell(setting(still_image_format=Format.PNG), client=OTHER) == []
    module.tell(asking(1))
    assert module.video.under_way[0][0] == VGA


def test_capabilities(module):
    query = m.QueryStillImageSensorCapabilities
    asked = [query.QueryStillImageSensorCapabilitiesRec(0, EVERYTHING)]
    (found,) = module.ask(query(asked)).still_image_sensor_list
    formats = found.supported_image_formats
    assert (formats.jpeg, formats.png, formats.gif) == (1, 1, 0)
    assert (found.supported_frame_sizes.vga_640_x480, found.supported_frame_sizes.whuxga_7680_x4800) == (1, 0)


def test_all_supported_sizes_can_be_set(module):
    module.control()
    query = m.QueryStillImageSensorCapabilities
    asked = [query.QueryStillImageSensorCapabilitiesRec(1, EVERYTHING)]
    offered = module.ask(query(asked)).still_image_sensor_list[0].supported_frame_sizes
    for size in Size:
        name = size.name.lower()
        assert isinstance(confirmed(module.ask(setting(frame_size=size))), SensorIdRec) == bool(getattr(offered, name))


# --- events


def test_periodic_events_report_images(module):
    module.tell(CreateEvent(1, CreateEvent.EventType.PERIODIC, 5.0, asking(1, asked=IMAGE)))
    seen = []
    for content in (b"one", b"two", b"three"):
        module.run(0.25)
        module.video.develop(Still(content, 0.0))
        seen += [event.report_message.still_image_data_list[0].image_frame.data for _, event in module.run()]
    assert seen == [b"one", b"two", b"three"]


def test_events_on_change_report_changed_images(module):
    module.tell(CreateEvent(1, CreateEvent.EventType.EVERY_CHANGE, 0.0, asking(1, asked=IMAGE)))
    seen = []
    for content in (b"one", b"one", b"two", b"two"):
        module.run(0.25)
        module.video.develop(Still(content, 0.0))
        seen += [event.report_message.still_image_data_list[0].image_frame.data for _, event in module.run()]
    assert seen == [b"one", b"two"]


# --- several cameras


@pytest.mark.slow
def test_several_cameras_of_one_component():
    videos = [FakeVideo(CameraSetup(name, "link", 1.0)) for name in ("left", "right")]
    videos[1].settings = VideoSettings(320, 240)
    cameras = {number: VideoCamera(Transform, source=video) for number, video in enumerate(videos, start=1)}
    services = [VisualSensor(cameras), StillImage(cameras)]
    host = Host(CLIENT, services, utc_now=lambda: datetime(2026, 1, 1, tzinfo=UTC))
    host.receive(asking(0).encode(), OTHER, 0.0)
    assert [video.under_way[0][0].width for video in videos] == [640, 320]
    videos[1].develop(Still(b"right", 0.0))
    assert host.next_timeout() == REPLY_TIMEOUT
    videos[0].develop(Still(b"left", 0.0))
    host.handle_timeout(0.0)
    (sent,) = host.poll_output(0.0)
    pictures = registry.decode(sent.payload).still_image_data_list
    assert [(each.sensor_id, each.image_frame.data) for each in pictures] == [(1, b"left"), (2, b"right")]
    host.receive(asking(1, 2).encode(), OTHER, 1.0)
    videos[0].develop(Still(b"left", 0.0))
    host.handle_timeout(1.0 + REPLY_TIMEOUT)
    host.handle_timeout(1.0 + REPLY_TIMEOUT)
    (sent,) = host.poll_output(2.0 + REPLY_TIMEOUT)
    left, right = registry.decode(sent.payload).still_image_data_list
    assert (left.image_frame.data, right.image_frame) == (b"left", None)


# --- for real


@pytest.mark.slow
@pytest.mark.parametrize("format", sampled(list(StillFormat), 1))
async def test_real_camera_takes_an_image(format):
    pytest.importorskip("av", reason="the extra 'video' is not installed")
    cv2 = pytest.importorskip("cv2", reason="the extra 'video' is not installed")
    import numpy as np

    from jauspy.video.camera_process import CameraProcess

    module = Module(video=lambda camera: CameraProcess(camera, VideoSettings(320, 240)))
    ready = asyncio.Event()
    module.host.on_timer_change = ready.set
    async with module.video:
        module.control()
        module.tell(setting(still_image_format=Format[format.name], frame_size=Size.CIF_352_X288))
        module.tell(asking(1))
        await asyncio.wait_for(ready.wait(), 100.0)
        (record,) = records(module.run())
    module.robot.close()
    assert record.image_frame.format.name == format.name
    image = cv2.imdecode(np.frombuffer(record.image_frame.data, np.uint8), cv2.IMREAD_COLOR)
    assert image.shape == (288, 352, 3)
    assert image.std() > 10.0
