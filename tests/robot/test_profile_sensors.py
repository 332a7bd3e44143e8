"""Cameras, lamps and sensors of force and torque in the forms of IOP and AEODRS."""

from __future__ import annotations

import ipaddress

import pytest
from tests.helpers.robot import described
from tests.robot.cameras import Module
from tests.robot.test_force_torque import Wrist

from jauspy.geometry.frames import FrameTree, joint_frame
from jauspy.geometry.poses import Transform
from jauspy.geometry.vectors import cross, difference, rotated
from jauspy.ids import JausID
from jauspy.messages.core import ReleaseControl
from jauspy.messages.environment_sensing.v2_0 import force_torque_sensor as sensing
from jauspy.messages.exp import (
    QueryAimpointParameters,
    QueryDigitalVideoEndpoint,
    QueryDigitalVideoIlluminator,
    QueryDigitalVideoIlluminatorCapabilities,
    QueryDigitalVideoIlluminatorConfiguration,
    SetDigitalVideoEndpoint,
    SetDigitalVideoIlluminator,
    SetDigitalVideoIlluminatorConfiguration,
)
from jauspy.messages.iop import QueryManipulatorEndEffectorForceTorque
from jauspy.messages.iop.v1_0 import h264_video_encoding as h264
from jauspy.messages.iop.v1_1 import force_torque_sensor as iop
from jauspy.ocu.subsystems import ComponentInfo, ServiceInfo
from jauspy.platform.lights import lamps_of
from jauspy.platform.video_settings import H264Profile
from jauspy.robot.kinds.joints import end_effector_load
from jauspy.services.environment_sensing import h264_video_encoding
from jauspy.services.manipulator import Arm

STRANGER = JausID(43, 1, 1)


def endpoint(host: str, port: int, sensor: int = 1) -> SetDigitalVideoEndpoint:
    return SetDigitalVideoEndpoint(
        SetDigitalVideoEndpoint.SensorIdRec(sensor),
        SetDigitalVideoEndpoint.EndpointRecord(int(ipaddress.IPv4Address(host)), port),
    )


# --- the stream of a camera ---------------------------------------------------------------------------------------


def test_the_client_in_control_has_the_stream_sent_to_its_own_machine():
    module = Module()
    module.tell(endpoint("127.0.0.1", 5004))
    assert module.video.receivers == {}, "without control nothing happens"
    module.control()
    module.tell(endpoint("127.0.0.1", 5004))
    assert module.video.receivers == {("127.0.0.1", 5004): True}
    report = module.ask(QueryDigitalVideoEndpoint(1))
    assert (report.endpoint_record.ip_addr, report.endpoint_record.port) == (0x7F000001, 5004)
    assert module.ask(QueryDigitalVideoEndpoint(1), client=STRANGER).endpoint_record.ip_addr == 0, "it is private"
    module.tell(endpoint("127.0.0.1", 5006))
    assert module.video.receivers == {("127.0.0.1", 5006): True}
    module.tell(endpoint("0.0.0.0", 0))
    assert module.video.receivers == {}


def test_the_stream_ends_with_control():
    module = Module()
    module.control()
    module.tell(endpoint("127.0.0.1", 5004), ReleaseControl())
    assert module.video.receivers == {}
    assert module.ask(QueryDigitalVideoEndpoint(1)).endpoint_record.port == 0


@pytest.mark.parametrize(
    "message",
    [
        endpoint("203.0.113.7", 5004),
        endpoint("224.0.0.1", 5004),
        endpoint("255.255.255.255", 5004),
        endpoint("127.0.0.1", 3794),
        endpoint("127.0.0.1", 22),
        endpoint("127.0.0.1", 5004, sensor=9),
    ],
    ids=["stranger", "group", "broadcast", "JAUS", "system", "sensor"],
)
def test_streams_to_others_are_refused_and_counted(message):
    module = Module()
    module.control()
    module.tell(message)
    assert module.video.receivers == {}
    assert module.host.counters["endpoint_refused"] == 1


def test_the_aiming_mark_is_the_middle_of_the_picture():
    module = Module()
    report = module.ask(QueryAimpointParameters(1))
    size, mark = report.resolution_rec, report.reticle_position_rec
    assert (size.x_resolution, size.y_resolution) == (640, 480)
    assert (mark.x_reticle_position, mark.y_reticle_position) == (320, 240)
    assert module.tell(QueryAimpointParameters(7)) == []
    assert module.host.counters["unknown_sensor"] == 1


# --- coding -------------------------------------------------------------------------------------------------------


def test_coding_is_set_and_reported_as_by_the_standard():
    module = Module()
    module.control()
    record = h264.SetH264VideoEncodingConfiguration.H264ConfigurationRec(
        sensor_id=1, profile=4, group_of_pictures=30, roi_parameters=[0.0] * 6
    )
    module.tell(h264.SetH264VideoEncodingConfiguration([record]))
    assert (module.video.settings.coding.profile, module.video.settings.gop) == (H264Profile.HIGH, 30)
    query = h264.QueryH264VideoEncodingConfiguration
    (report,) = module.ask(query([query.QueryH264VideoEncodingConfigurationRec(0)])).h264_configuration_list
    assert (report.profile, report.group_of_pictures, report.region_of_interest_on_off) == (4, 30, 0)
    query = h264.QueryH264VideoEncodingCapabilities
    (report,) = module.ask(query([query.QueryH264VideoEncodingCapabilityRec(1)])).h264_capabilities_list
    assert (report.supported_profiles.high, report.supported_profiles.extended) == (1, 0)
    assert (report.supported_presets.low_latency, report.supported_presets.manipulation) == (1, 0)


def test_both_forms_have_the_same_numbers():
    theirs, ours = h264.ReportH264VideoEncodingConfiguration, h264_video_encoding._Report
    assert [entry.value for entry in theirs.Profile] == [entry.value for entry in ours.Profile]
    assert {entry.name: entry.value for entry in ours.Preset}.items() >= {
        entry.name: entry.value for entry in theirs.Preset if entry.value <= 5
    }.items()


@pytest.mark.parametrize("change", [{"profile": 7}, {"preset": 4}, {"group_of_pictures": 0}, {"sensor_id": 9}])
def test_impossible_coding_changes_nothing(change):
    module = Module()
    module.control()
    before = module.video.settings
    fields = {"sensor_id": 1, "roi_parameters": [0.0] * 6} | change
    good = h264.SetH264VideoEncodingConfiguration.H264ConfigurationRec(sensor_id=1, profile=4, roi_parameters=[0.0] * 6)
    bad = h264.SetH264VideoEncodingConfiguration.H264ConfigurationRec(**fields)
    module.tell(h264.SetH264VideoEncodingConfiguration([good, bad]))
    assert module.video.settings == before


# --- lamps --------------------------------------------------------------------------------------------------------


def lamp(module: Module, name: str):
    return next(lamp for lamp in lamps_of(module.robot) if lamp.setup.name == name)


@pytest.mark.parametrize(("component", "name", "cone"), [(106, "arm", 60.0), (107, "front", 70.0)])
def test_each_camera_has_its_lamp(component, name, cone):
    module = Module(component)
    query = QueryDigitalVideoIlluminatorCapabilities
    report = module.ask(query([query.QueryDigitalVideoIlluminatorCapabilityRec(0)]))
    (entry,) = report.digital_video_illuminator_capabilities_list
    assert (entry.illuminator_id, entry.illuminator_name) == (1, name)
    assert entry.max_beamwidth == pytest.approx(cone, abs=0.01)
    assert (entry.illumination_modes.color, entry.illumination_modes.infrared) == (1, 0)
    module.tell(SetDigitalVideoIlluminator(1, 40.0, cone))
    assert lamp(module, name).level == 0.0, "without control it stays dark"
    module.control()
    module.tell(SetDigitalVideoIlluminator(1, 40.0, cone))
    assert lamp(module, name).level == pytest.approx(0.4, abs=1e-4)
    query = QueryDigitalVideoIlluminator
    (entry,) = module.ask(query([query.SensorIdRec(1), query.SensorIdRec(1)])).illumination_record_list
    assert (entry.level, entry.beamwidth) == (pytest.approx(40.0, abs=0.01), pytest.approx(cone, abs=0.01))


def test_what_a_lamp_cannot_do_is_counted_and_changes_nothing_else():
    module = Module()
    module.control()
    configuration = SetDigitalVideoIlluminatorConfiguration
    module.tell(
        SetDigitalVideoIlluminator(9, 50.0, 70.0),
        SetDigitalVideoIlluminator(1, 50.0, 10.0),
        configuration(configuration.IlluminatorConfigRecord(1, 2), []),
        configuration(configuration.IlluminatorConfigRecord(1, 0), [configuration.SensorRec(77)]),
    )
    assert lamp(module, "front").level == pytest.approx(0.5, abs=1e-4)
    counters = module.host.counters
    assert (counters["unknown_illuminator"], counters["unsupported_beamwidth"]) == (1, 1)
    assert counters["unsupported_illumination"] == 2
    report = module.ask(QueryDigitalVideoIlluminatorConfiguration(1))
    assert (report.illuminator_config_record.illumination_mode, len(report.sensors_list)) == (0, 1)
    module.tell(configuration(configuration.IlluminatorConfigRecord(1, 0), []))
    assert module.ask(QueryDigitalVideoIlluminatorConfiguration(1)).sensors_list == []
    assert module.tell(QueryDigitalVideoIlluminatorConfiguration(5)) == []


def test_a_camera_outside_of_the_robot_has_no_lamp():
    assert "urn:jaus:jss:exp:aeodrs:AEODRSVideoIlluminator" not in Module(109).host.definitions


# --- force and torque ----------------------------------------------------------------------------------------------


def test_both_forms_of_the_sensor_report_the_same():
    wrist = Wrist()
    ask = iop.QueryForceTorque.QueryForceTorqueRec
    for frame in (0, 1):
        (theirs,) = wrist.ask(sensing.QueryForceTorque.QueryForceTorqueRec(1, frame, 0b111111))
        (ours,) = wrist._tell(
            iop.QueryForceTorque([ask(1, frame, 0b111111)]), iop.ReportForceTorque
        ).report_force_torque_list
        for axis in "xyz":
            assert getattr(ours, f"force_{axis}") == pytest.approx(getattr(theirs, f"force_{axis}"), abs=0.2)
            assert getattr(ours, f"torque_{axis}") == pytest.approx(getattr(theirs, f"torque_{axis}"), abs=0.2)
    (masked,) = wrist._tell(iop.QueryForceTorque([ask(1, 0, 0b100)]), iop.ReportForceTorque).report_force_torque_list
    assert (masked.force_x, masked.torque_x) == (None, None)
    assert masked.force_z is not None
    assert wrist._tell(iop.QueryForceTorque([ask(5, 0, 1)]), iop.ReportForceTorque).report_force_torque_list == []
    limits = iop.QueryForceTorqueCapabilities
    (entry,) = wrist._tell(
        limits([limits.QueryForceTorqueCapabilityRec(0, 0xFFFF)]), iop.ReportForceTorqueCapabilities
    ).report_force_torque_capabilities_list
    assert (entry.sensor_id, entry.sensor_name) == (1, "wrist1")
    assert entry.max_force_x == pytest.approx(300.0, abs=0.2)
    assert entry.min_torque_z == pytest.approx(-30.0, abs=0.2)


def test_the_end_effector_has_the_load_of_its_sensor_about_its_own_origin():
    """By the frames of the URDF: the wrench is carried from the sensor's link to the tip link and to the last joint."""
    wrist = Wrist()
    robot, group = wrist.robot, wrist.robot.groups["arm"]
    arm = Arm(group)
    service = end_effector_load(robot, arm)
    assert service is not None
    found = service.send_report_manipulator_end_effector_force_torque()
    (sensor,) = robot.force_torque.values()
    wrench = sensor.wrench
    assert (found.force_x**2 + found.force_y**2 + found.force_z**2) ** 0.5 == pytest.approx(
        sum(value**2 for value in wrench.force) ** 0.5
    )
    tree = FrameTree(described("inc1")[1].description)
    tip = tree.pose(sensor.setup.link).inverse() @ tree.pose(group.chain[-1].child)
    torque = difference(wrench.torque, cross(tip.position, wrench.force))
    positions = {joint.name: 0.0 for joint in group.chain}
    last = Transform()
    for joint in group.chain:
        last = last @ joint_frame(joint, joint.position(positions))
    zero = arm.geometry.from_urdf([0.0] * len(arm.geometry.links))
    axes = (arm.geometry.forward(zero).inverse() @ last).rotation
    turn = Transform(axes) @ Transform(tip.rotation).inverse()
    assert [found.force_x, found.force_y, found.force_z] == pytest.approx(rotated(turn.rotation, wrench.force))
    assert [found.torque_x, found.torque_y, found.torque_z] == pytest.approx(rotated(turn.rotation, torque))
    assert QueryManipulatorEndEffectorForceTorque.REPORT is type(found)


def test_a_bare_name_is_that_of_the_standard():
    services = (
        ServiceInfo("urn:jaus:jss:environmentSensing:ForceTorqueSensor", "2.0"),
        ServiceInfo("urn:jaus:jss:iop:ForceTorqueSensor", "1.1"),
    )
    info = ComponentInfo(JausID(101, 1, 108), services=services)
    assert info.find("ForceTorqueSensor") == services[0]
    assert info.find("iop:ForceTorqueSensor") == services[1]
