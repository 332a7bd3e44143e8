"""`older_versions`: what clients of version 1.0 see of a module, and what it answers them."""

from __future__ import annotations

from collections.abc import Iterator

import pytest
from tests.robot.cameras import Module

from jauspy.messages import older
from jauspy.platform.video_settings import Still
from jauspy.services.core.discovery import OfferedService, offered_services

SENSING = "urn:jaus:jss:environmentSensing:"
NATIVE = older.QueryStillImageData.ReportCoordinateSystem.NATIVE


@pytest.fixture
def module() -> Iterator[Module]:
    made = Module(older_versions=True)
    yield made
    made.robot.close()


def test_both_versions_are_listed(module: Module) -> None:
    offers = offered_services(module.host)
    for name in ("VisualSensor", "DigitalVideo", "StillImage"):
        assert OfferedService(SENSING + name, 1, 0) in offers
        assert OfferedService(SENSING + name, 2, 0) in offers
    assert OfferedService("urn:jaus:jss:core:Events", 1, 0) in offers


def test_without_the_setting_only_the_newest_are_listed() -> None:
    newest = Module()
    assert OfferedService(SENSING + "DigitalVideo", 1, 0) not in offered_services(newest.host)
    newest.robot.close()


def test_capabilities_of_digital_video_1_0_are_reported(module: Module) -> None:
    query = older.QueryDigitalVideoSensorCapabilities
    report = module.ask(query([query.QueryDigitalVideoSensorCapabilitiesRec(0, 0xFF)]))
    assert report.CODE == 0x4808
    (record,) = report.digital_video_sensor_list
    assert (record.sensor_id, record.minimum_frame_rate) == (1, 1)
    assert record.supported_digital_formats.mpeg4_avc_h264 == 1


def test_image_of_still_image_1_0_is_taken(module: Module) -> None:
    query = older.QueryStillImageData
    assert module.tell(query([query.QueryStillImageDataRec(1, NATIVE, 0xFF)])) == []
    module.video.develop(Still(b"\xff\xd8 a picture", 0.25))
    ((_, report),) = module.run()
    assert report.CODE == 0x4814
    (record,) = report.still_image_data_list
    assert (record.sensor_id, record.image_frame.data) == (1, b"\xff\xd8 a picture")
    assert record.time_stamp is not None


def test_camera_that_fails_is_left_out(module: Module) -> None:
    query = older.QueryStillImageData
    module.tell(query([query.QueryStillImageDataRec(1, NATIVE, 0xFF)]))
    module.video.develop(None)
    ((_, report),) = module.run()
    assert report.still_image_data_list == []
