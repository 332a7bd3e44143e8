"""CM-VIS: a client in control sets and runs the stream of a camera, others watch."""

from __future__ import annotations

import asyncio
import math

import pytest
from tests.robot.cameras import OTHER, Module

from jauspy.ids import JausID
from jauspy.messages import environment_sensing as m
from jauspy.messages.environment_sensing.v1_0.types import (
    DigitalVideoSensorErrorRec,
    ManipulatorGeometricPropertiesRec,
    SensorIDQueryRec,
    SensorIdRec,
    StaticGeometricPropertiesRec,
    VisualSensorErrorRec,
)
from jauspy.platform.video_settings import RTP_SERVER_TYPE, VideoSettings
from jauspy.services.environment_sensing.digital_resource_discovery import (
    END_POINT_TIMEOUT,
    MAX_END_POINTS,
    MAX_END_POINTS_PER_CLIENT,
    parse_rtp_url,
)

Stream, Wanted = m.ControlDigitalVideoSensorStream, m.SetDigitalVideoSensorConfiguration
Size = Wanted.FrameSize


@pytest.fixture
def module():
    made = Module()
    yield made
    made.robot.close()


def setting(**values):
    return Wanted(Wanted.RequestIdRec(5), [Wanted.DigitalVideoSensorConfigurationRec(1, **values)])


def confirmed(answer):
    assert answer.request_id_rec.request_id == 5
    (record,) = answer.confirm_sensor_list
    return record


def flow(module):
    report = module.ask(m.QueryDigitalVideoSensorStatus([SensorIDQueryRec(0)]))
    return report.digital_video_sensor_status_list[0].streaming_state.name


# --- end points


def test_registered_end_point_receives_until_it_is_removed(module):
    assert flow(module) == "STOP"
    number = module.enter("rtp://127.0.0.1:5004")
    assert module.video.receivers == {("127.0.0.1", 5004): True}
    assert flow(module) == "PLAY"
    (entry,) = module.ask(m.QueryDigitalResourceEndpoint()).digital_resource_endpoint_list
    assert (entry.server_type, entry.server_url, entry.resource_id) == (RTP_SERVER_TYPE, "rtp://127.0.0.1:5004", 1)
    assert (entry.jaus_id.subsystem_id, entry.jaus_id.node_id, entry.jaus_id.component_id) == (101, 1, 107)
    removed = module.ask(m.RemoveDigitalResourceEndpoint(number, 3))
    assert (removed.id, removed.request_id) == (number, 3)
    assert module.video.receivers == {}
    assert module.ask(m.QueryDigitalResourceEndpoint()).digital_resource_endpoint_list == []


def test_end_point_expires_after_five_minutes_without_renewal(module):
    number = module.enter("rtp://10.0.0.7:5004")
    module.now = END_POINT_TIMEOUT - 1.0
    assert module.enter("rtp://10.0.0.7:5004") == number
    module.now += END_POINT_TIMEOUT - 1.0
    module.host.handle_timeout(module.now)
    assert module.video.receivers
    module.now += 2.0
    module.host.handle_timeout(module.now)
    assert module.video.receivers == {}


@pytest.mark.parametrize(
    "url",
    [
        "rtp://robot:5004",
        "rtp://10.0.0.7",
        "rtp://10.0.0.7:0",
        "http://10.0.0.7:80",
        "",
        "rtp://[",
        "rtp://10.0.0.7:666",
    ],
)
def test_invalid_url_is_refused_with_number_0(module, url):
    assert module.enter(url) == 0
    assert module.video.receivers == {}
    assert module.host.counters["endpoint_refused"] == 1


def test_other_server_types_and_sensors_are_refused(module):
    assert module.enter("rtp://10.0.0.7:5004", server=0) == 0
    assert module.enter("rtp://10.0.0.7:5004", sensor=2) == 0
    assert module.host.counters["endpoint_refused"] == 2


def test_end_points_of_other_clients_cannot_be_changed(module):
    number = module.enter("rtp://10.0.0.7:5004")
    assert module.enter("rtp://10.0.0.7:5004", client=OTHER) == 0
    assert module.ask(m.RemoveDigitalResourceEndpoint(number, 3), OTHER).id == 0
    assert module.video.receivers == {("10.0.0.7", 5004): True}


def test_end_point_above_a_clients_share_replaces_its_oldest(module):
    share = MAX_END_POINTS_PER_CLIENT
    numbers = [module.enter(f"rtp://10.0.0.7:{5000 + 2 * port}") for port in range(share + 1)]
    assert numbers == [*range(1, share + 2)]
    assert list(module.video.receivers) == [("10.0.0.7", 5002 + 2 * port) for port in range(share)]


def test_number_of_end_points_is_bounded(module):
    clients = [JausID(50, 1, 1 + number) for number in range(MAX_END_POINTS + 1)]
    numbers = [module.enter(f"rtp://10.0.0.7:{5000 + 2 * n}", client) for n, client in enumerate(clients)]
    assert numbers == [*range(1, MAX_END_POINTS + 1), 0]


def test_end_points_of_a_lost_client_are_removed(module):
    module.enter("rtp://10.0.0.7:5004")
    module.enter("rtp://10.0.0.8:5004", client=OTHER)
    module.host.unreachable(OTHER, module.now)
    assert module.video.receivers == {("10.0.0.7", 5004): True}


def test_ipv6_addresses_are_accepted():
    assert parse_rtp_url("rtp://[fe80::1]:5004") == ("fe80::1", 5004)


# --- streams


def test_play_pause_and_stop_apply_to_own_end_points(module):
    module.enter("rtp://10.0.0.7:5004")
    module.enter("rtp://10.0.0.8:5004", client=OTHER)
    module.control()
    module.tell(Stream(1, Stream.StreamState.PAUSE))
    assert module.video.receivers == {("10.0.0.7", 5004): False, ("10.0.0.8", 5004): True}
    module.tell(Stream(1, Stream.StreamState.STOP))
    assert module.video.receivers == {("10.0.0.8", 5004): True}
    assert flow(module) == "PLAY"
    module.tell(Stream(1, Stream.StreamState.PLAY))
    assert module.video.receivers == {("10.0.0.7", 5004): True, ("10.0.0.8", 5004): True}


def test_commands_without_control_are_ignored(module):
    module.enter("rtp://10.0.0.7:5004")
    module.tell(Stream(1, Stream.StreamState.STOP), setting(frame_rate=5))
    assert module.video.receivers == {("10.0.0.7", 5004): True}
    assert module.video.settings == VideoSettings()


def test_command_without_own_stream_is_counted(module):
    module.control()
    module.tell(Stream(7, Stream.StreamState.PLAY))
    assert module.host.counters["stream_unknown"] == 1


# --- configuration


def test_size_rate_and_bit_rate_are_set_and_reported(module):
    module.control()
    answer = module.ask(setting(frame_size=Size.HD720_1280_X720, frame_rate=25, maximum_bit_rate=4000))
    assert confirmed(answer) == SensorIdRec(1)
    assert module.video.settings == VideoSettings(1280, 720, 25, 4_000_000)
    query = m.QueryDigitalVideoSensorConfiguration
    record = query.QueryDigitalVideoConfigurationRec(1, 0x1F)
    (found,) = module.ask(query([record])).digital_video_sensor_configuration_list
    assert (found.frame_size, found.frame_rate, found.minimum_bit_rate, found.maximum_bit_rate) == (
        Size.HD720_1280_X720,
        25,
        4000,
        4000,
    )
    assert found.digital_format.name == "MPEG_4_AVC"


Code = DigitalVideoSensorErrorRec.DigitalVideoErrorCode


@pytest.mark.parametrize(
    ("values", "code"),
    [
        ({"frame_rate": 0}, Code.FRAME_RATE_TOO_LOW),
        ({"frame_rate": 61}, Code.FRAME_RATE_TOO_HIGH),
        ({"frame_size": Size.WHUXGA_7680_X4800}, Code.INVALID_FRAME_SIZE),
        ({"maximum_bit_rate": 63}, Code.INVALID_MAXIMUM_BIT_RATE),
        ({"minimum_bit_rate": 3000, "maximum_bit_rate": 2000}, Code.INVALID_MINIMUM_BIT_RATE),
        ({"digital_format": Wanted.DigitalFormat.MJPEG}, Code.INVALID_FORMAT),
        ({"frame_rate": 0, "maximum_bit_rate": 1}, Code.MULTIPLE_INVALID_PARAMETERS),
    ],
)
def test_invalid_settings_are_refused_with_the_reason(module, values, code):
    module.control()
    refused = confirmed(module.ask(setting(**values)))
    assert refused.digital_video_error_code == code
    assert refused.error_message
    assert module.video.settings == VideoSettings()


@pytest.mark.parametrize("size", [size for size in Size if size.name.endswith(("640_X480", "176_X144", "1366_X768"))])
def test_all_supported_sizes_can_be_set(module, size):
    module.control()
    assert confirmed(module.ask(setting(frame_size=size))) == SensorIdRec(1)
    settings = module.video.settings
    assert size.name.endswith(f"_{settings.width}_X{settings.height}")


def test_capabilities(module):
    query = m.QueryDigitalVideoSensorCapabilitiesExt
    record = query.QueryDigitalVideoSensorCapabilitiesRec(0, 0xFF)
    (found,) = module.ask(query([record])).digital_video_sensor_list
    assert (found.minimum_frame_rate, found.maximum_frame_rate) == (1, 60)
    assert (found.supported_frame_sizes.vga_640_x480, found.supported_frame_sizes.whuxga_7680_x4800) == (1, 0)
    assert found.recording_supported.name == "UNSUPPORTED"


# --- lens and sensor

Lens = m.SetVisualSensorConfiguration
LensCode = VisualSensorErrorRec.VisualSensorErrorCode


def lens(module, **values):
    return confirmed(module.ask(Lens(Lens.RequestIdRec(5), [Lens.VisualSensorConfigurationRec(1, **values)])))


def lens_report(module):
    query = m.QueryVisualSensorConfiguration
    (found,) = module.ask(query([query.QueryVisualSensorConfigurationRec(1, 0xFFFF)])).visual_sensor_configuration_list
    return found


def test_field_of_view_and_automatic_exposure_are_reported(module):
    found = lens_report(module)
    assert found.horizontal_field_of_view == pytest.approx(math.radians(80.0), abs=1e-6)
    assert math.tan(found.vertical_field_of_view / 2) == pytest.approx(0.75 * math.tan(math.radians(40.0)), abs=1e-5)
    assert (found.zoom_level, found.exposure_mode.name, found.light_sensitivity.name) == (0.0, "AUTO", "AUTO")


def test_settings_of_the_lens_reach_the_camera_and_are_reported(module):
    module.control()
    wanted = {
        "exposure_mode": Lens.ExposureMode.MANUAL,
        "shutter_speed": 0.02,
        "light_sensitivity": Lens.LightSensitivity.ISO_400,
        "white_balance": Lens.WhiteBalance.SHADE,
        "focus_mode": Lens.FocusMode.MANUAL_FOCUS,
        "focus_value": 60.0,
        "imaging_mode": Lens.ImagingMode.GREYSCALE,
        "metering_mode": Lens.MeteringMode.SPOT,
    }
    assert lens(module, **wanted) == SensorIdRec(1)
    imaging = module.video.imaging
    assert (imaging.exposure_mode.name, imaging.iso, imaging.white_balance.name) == ("MANUAL", 400, "SHADE")
    assert (imaging.focus, imaging.shutter) == (pytest.approx(0.6, abs=1e-4), pytest.approx(0.02, abs=1e-3))
    found = lens_report(module)
    assert {name: getattr(found, name) for name in wanted} == pytest.approx(wanted, abs=2e-3)


def test_zoom_is_one_thing_in_percent_and_as_field_of_view(module):
    module.control()
    half = 2 * math.atan(math.tan(math.radians(40.0)) / 2)
    assert lens(module, horizontal_field_of_view=half) == SensorIdRec(1)
    assert module.video.imaging.zoom == pytest.approx(2.0, abs=1e-6)
    level = lens_report(module).zoom_level
    assert lens(module, zoom_level=0.0) == SensorIdRec(1)
    assert lens(module, zoom_level=level) == SensorIdRec(1)
    assert lens_report(module).horizontal_field_of_view == pytest.approx(half, abs=1e-4)
    assert lens(module, zoom_mode=Lens.ZoomMode.OFF) == SensorIdRec(1)
    assert lens_report(module).horizontal_field_of_view == pytest.approx(math.radians(80.0), abs=1e-6)


@pytest.mark.parametrize(
    ("values", "code"),
    [
        ({"horizontal_field_of_view": 1.5}, LensCode.INVALID_HORIZONTAL_FOV),
        ({"horizontal_field_of_view": 0.01}, LensCode.INVALID_HORIZONTAL_FOV),
        ({"horizontal_field_of_view": -0.5}, LensCode.INVALID_HORIZONTAL_FOV),
        ({"vertical_field_of_view": 1.5}, LensCode.INVALID_VERTICAL_FOV),
        ({"horizontal_field_of_view": 0.6, "vertical_field_of_view": 0.6}, LensCode.INVALID_VERTICAL_FOV),
        ({"zoom_mode": Lens.ZoomMode.OFF, "zoom_level": 50.0}, LensCode.INVALID_ZOOM_VALUE),
        ({"focal_length": 1.0}, LensCode.INVALID_ZOOM_VALUE),
        ({"shutter_speed": 2.0}, LensCode.INVALID_SHUTTER_SPEED),
        ({"aperture": 5.6}, LensCode.INVALID_APERTURE_VALUE),
        ({"exposure_mode": Lens.ExposureMode.APERTURE_PRIORITY}, LensCode.INVALID_EXPOSURE_MODE),
        ({"imaging_mode": Lens.ImagingMode.INFRARED}, LensCode.INVALID_IMAGING_MODE),
        ({"sensor_state": Lens.SensorState.OFF}, LensCode.INVALID_SENSOR_STATE),
        ({"image_stabilization": Lens.ImageStabilization.ON}, LensCode.INVALID_IMAGE_STABILIZATION),
        ({"shutter_speed": 2.0, "aperture": 5.6}, LensCode.MULTIPLE_INVALID_PARAMETERS),
    ],
)
def test_what_the_lens_cannot_do_is_refused_with_the_reason_and_changes_nothing(module, values, code):
    module.control()
    before = module.video.imaging
    refused = lens(module, white_balance=Lens.WhiteBalance.FLASH, **values)
    assert isinstance(refused, VisualSensorErrorRec)
    assert refused.visual_sensor_error_code == code
    assert refused.error_message
    assert module.video.imaging == before


def test_capabilities_of_the_lens_say_what_is_offered(module):
    query = m.QueryVisualSensorCapabilitiesExt
    record = query.QueryVisualSensorCapabilitiesRec(0, 0xFFFFFFFF)
    (found,) = module.ask(query([record])).visual_sensor_capabilities_list
    setup = module.video.setup.imaging
    plain = m.QueryVisualSensorCapabilities
    (short,) = module.ask(plain([plain.QueryVisualSensorCapabilitiesRec(0, 0xFFFF)])).visual_sensor_capabilities_list
    assert (short.imaging_modes.greyscale, short.maximum_focal_length) == (1, found.maximum_focal_length)
    assert (found.exposure_modes.manual, found.exposure_modes.aperture_priority) == (1, 0)
    assert (found.zoom_modes.none, found.zoom_modes.digital_only) == (1, int(setup.digital_zoom > 1))
    assert found.maximum_shutter_speed == pytest.approx(setup.exposure_time[1], abs=1e-3)
    assert found.maximum_horizontal_field_of_view == pytest.approx(math.radians(80.0), abs=1e-6)
    module.control()
    assert lens(module, horizontal_field_of_view=found.minimum_horizontal_field_of_view) == SensorIdRec(1)
    assert lens(module, zoom_level=100.0) == SensorIdRec(1)
    assert lens_report(module).vertical_field_of_view == pytest.approx(found.minimum_vertical_field_of_view, abs=1e-4)


def test_mounting_of_a_fixed_camera_is_reported():
    module = Module(fixed=True)
    answer = module.ask(m.QuerySensorGeometricProperties([SensorIDQueryRec(1)]))
    (found,) = answer.geometric_properties_list
    properties = found.geometric_properties_variant
    assert isinstance(properties, StaticGeometricPropertiesRec)
    assert properties.sensor_position == pytest.approx([-0.33, 0.0, -0.44], abs=1e-3)


@pytest.mark.parametrize(("component", "manipulator", "joint"), [(106, 104, 4), (107, 107, 2)])
def test_joint_of_a_moving_camera_is_reported(component, manipulator, joint):
    answer = Module(component).ask(m.QuerySensorGeometricProperties([SensorIDQueryRec(1)]))
    (found,) = answer.geometric_properties_list
    mounting = found.geometric_properties_variant
    assert isinstance(mounting, ManipulatorGeometricPropertiesRec)
    assert (mounting.subsystem_id, mounting.node_id, mounting.component_id) == (101, 1, manipulator)
    assert mounting.joint_number == joint
    if component == 107:
        assert mounting.sensor_position == pytest.approx([0.026, 0.0, 0.0], abs=1e-6)
        assert mounting.unit_quaternion == pytest.approx([1.0, 0.0, 0.0, 0.0], abs=1e-6)


# --- for real


@pytest.mark.slow
async def test_a_client_watches_and_changes_a_real_camera():
    pytest.importorskip("av", reason="the extra 'video' is not installed")
    pytest.importorskip("cv2", reason="the extra 'video' is not installed")
    from jauspy.video.camera_process import CameraProcess
    from jauspy.video.h264 import H264Decoder
    from jauspy.video.receiver import RtpReceiver

    module = Module(video=lambda camera: CameraProcess(camera, VideoSettings(320, 240)))
    decoder, shapes = H264Decoder(), []
    async with module.video:
        with RtpReceiver() as receiver:
            assert module.enter(f"rtp://127.0.0.1:{receiver.port}")
            module.control()
            async with asyncio.timeout(100.0):
                while (480, 640, 3) not in shapes:
                    shapes += [decoder.decode(picture).shape for picture in receiver.take()]
                    if shapes:
                        module.tell(setting(frame_size=Size.VGA_640_X480))
                    await asyncio.sleep(0.01)
    module.robot.close()
    assert shapes[0] == (240, 320, 3)
    assert not receiver.counters.get("lost")
