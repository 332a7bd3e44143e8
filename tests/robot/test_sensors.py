"""CM-SEN on a robot of each backend, on virtual time, and clients that ask it."""

from __future__ import annotations

import bz2
import lzma
import math
import zlib
from collections.abc import Callable
from dataclasses import replace
from datetime import UTC, datetime, timedelta
from importlib.util import find_spec
from typing import Any, TypeVar

import pytest
from tests.helpers.robot import described

from jauspy.backends import find
from jauspy.codec.message import Message
from jauspy.ids import JausID
from jauspy.messages.core import CreateEvent, Event, RequestControl
from jauspy.messages.environment_sensing.v1_0.types import ManipulatorGeometricPropertiesRec
from jauspy.messages.environment_sensing.v2_0 import range_sensor as m
from jauspy.platform.ranging import LidarSetup
from jauspy.robot.hosts import host_of

CLIENT, OTHER = JausID(42, 1, 1), JausID(42, 2, 1)
STEP = 0.01
START = datetime(2026, 1, 1, tzinfo=UTC)
NATIVE, VEHICLE = 0, 1
POINT_ID, VALIDITY = 1 << 0, 1 << 1
DATA = m.QueryRangeSensorData.QueryRangeSensorDataRec
PACKED = m.QueryRangeSensorCompressedData.QueryRangeSensorCompressedDataRec
HEAD = 12
"""Bytes before the list of points in a report of one sensor."""

M = TypeVar("M", bound=Message)


class Mast:
    """A robot, and its sensor module."""

    def __init__(self, backend: str, world: str = "yard", *more: LidarSetup) -> None:
        config, model = described("inc1")
        model = replace(model, lidars=(*model.lidars, *more))
        self.robot = find(backend).open(model, world)
        self.now = 0.0
        (module,) = (each for each in config.modules if each.type == "CM-SEN")
        self.host = host_of(
            config, module, model, self.robot, {}, utc_now=lambda: START + timedelta(seconds=self.now), now=0.0
        )

    def tell(self, message: Message, client: JausID = CLIENT) -> list[bytes]:
        self.host.receive(message.encode(), client, self.now)
        return [each.payload for each in self.host.poll_output(self.now)]

    def ask(self, query: Message, answer: type[M]) -> M:
        (payload,) = self.tell(query)
        return answer.decode(payload)

    def scan(self, asked: int = 0, frame: int = NATIVE, sensor: int = 1) -> Any:
        answer = self.ask(m.QueryRangeSensorData([DATA(sensor, frame, asked)]), m.ReportRangeSensorData)
        (found,) = answer.range_sensor_data_list
        return found

    def set(self, **wanted: float) -> Any:
        record = m.SetRangeSensorConfiguration.RangeSensorConfigurationRec(**({"sensor_id": 1} | wanted))
        request = m.SetRangeSensorConfiguration.RequestIdRec(9)
        message = m.SetRangeSensorConfiguration(request, [record])
        answer = self.ask(message, m.ConfirmSensorConfiguration)
        assert answer.request_id_rec.request_id == 9
        (found,) = answer.confirm_sensor_list
        return found

    def run(self, seconds: float, each: Callable[[], None] = lambda: None) -> None:
        for _ in range(round(seconds / STEP)):
            self.robot.advance(STEP)
            self.now += STEP
            while (due := self.host.next_timeout()) is not None and due <= self.now:
                self.host.handle_timeout(self.now)
            each()


needs_mujoco = pytest.mark.skipif(find_spec("mujoco") is None, reason="MuJoCo is not installed")


@pytest.fixture(params=["kinematic", pytest.param("sim", marks=needs_mujoco)])
def mast(request: pytest.FixtureRequest) -> Mast:
    return Mast(request.param)


@pytest.fixture
def yard() -> Mast:
    pytest.importorskip("mujoco", reason="MuJoCo is not installed")
    return Mast("sim")


def nearest(sequence: Any, bearing: float) -> Any:
    return min(sequence.range_sensor_data_point_list, key=lambda point: abs(point.bearing - bearing))


# --- data


def test_rays_without_echo_are_reported_only_with_validity() -> None:
    plain = Mast("kinematic")
    assert plain.scan().range_sensor_data_point_list == []
    all_rays = plain.scan(VALIDITY).range_sensor_data_point_list
    assert len(all_rays) == 360
    assert {(point.range_validity, round(point.range, 3)) for point in all_rays} == {(0, 30.0)}


def test_bearings_are_clockwise(yard: Mast) -> None:
    scan = yard.scan()
    assert nearest(scan, -math.pi / 2).range == pytest.approx(4.0, abs=0.05), "the wall to the left"
    assert not [p for p in scan.range_sensor_data_point_list if abs(p.bearing - math.pi / 2) < 0.1], "none to the right"


def test_only_requested_optional_fields_are_reported(yard: Mast) -> None:
    bare, numbered = (nearest(yard.scan(asked), math.pi) for asked in (0, POINT_ID | 1 << 2))
    assert (bare.point_id, bare.range_validity, bare.range_error_rms) == (None, None, None)
    assert numbered.range_error_rms == pytest.approx(0.01, abs=1e-4)
    assert numbered.point_id in range(360)
    assert numbered.range_validity is None


def test_points_can_be_reported_in_the_vehicle_frame(yard: Mast) -> None:
    scan = yard.scan(frame=VEHICLE)
    assert scan.range_sensor_data_rec.report_coordinate_system == VEHICLE
    for point in scan.range_sensor_data_point_list:  # the lidar is 0.44 m above the ground: up is positive
        assert point.range * math.sin(point.inclination) == pytest.approx(0.44, abs=1e-3)
    back = nearest(scan, math.pi)
    assert back.range * math.cos(back.inclination) == pytest.approx(3.0, abs=0.05), "0.33 m more than from the lidar"


def test_time_stamp_is_that_of_the_scan(mast: Mast) -> None:
    mast.run(0.25)
    stamp = mast.scan().range_sensor_data_rec.time_stamp
    assert (stamp.seconds, stamp.milliseconds) == (0, pytest.approx(200, abs=1))
    mast.run(0.04)
    assert mast.scan().range_sensor_data_rec.time_stamp == stamp


def test_a_lidar_on_the_arm_moves_with_it() -> None:
    mast = Mast("kinematic", "empty", LidarSetup("wrist", "arm_camera_link"))
    query = m.QuerySensorGeometricProperties([m.QuerySensorGeometricProperties.SensorIDQueryRec(0)])
    first, second = mast.ask(query, m.ReportSensorGeometricProperties).geometric_properties_list
    assert first.geometric_properties_variant.sensor_position == pytest.approx([-0.33, 0.0, -0.44], abs=1e-6)
    assert first.geometric_properties_variant.unit_quaternion == pytest.approx([1.0, 0.0, 0.0, 0.0], abs=1e-6)
    assert isinstance(second.geometric_properties_variant, ManipulatorGeometricPropertiesRec)
    assert (second.geometric_properties_variant.component_id, second.geometric_properties_variant.joint_number) == (
        104,
        4,
    )
    before = nearest(mast.scan(VALIDITY, VEHICLE, sensor=2), 0.0)
    mast.robot.groups["arm"].command(
        [replace_target(1.0), *[None] * 4],
    )
    mast.run(3.0)
    after = mast.scan(VALIDITY, VEHICLE, sensor=2).range_sensor_data_point_list[before.point_id or 180]
    assert after.bearing != pytest.approx(before.bearing, abs=0.5)


def replace_target(position: float) -> Any:
    from jauspy.platform.joints import ControlMode, Target

    return Target(ControlMode.POSITION, position)


@pytest.mark.parametrize(("method", "expand"), [(0, bytes), (1, zlib.decompress), (2, bz2.decompress), (3, None)])
def test_compressed_points_are_those_of_the_plain_report(
    yard: Mast, method: int, expand: Callable[[bytes], bytes] | None
) -> None:
    expand = expand or (lambda data: lzma.decompress(data, lzma.FORMAT_ALONE))
    (plain,) = yard.tell(m.QueryRangeSensorData([DATA(1, VEHICLE, POINT_ID)]))
    query = m.QueryRangeSensorCompressedData([PACKED(1, VEHICLE, method, POINT_ID)])
    (packed,) = yard.ask(query, m.ReportRangeSensorCompressedData).range_sensor_compressed_data_list
    assert isinstance(packed, m.ReportRangeSensorCompressedData.RangeSensorCompressedDataRec)
    assert packed.data_compression == method
    assert expand(packed.compressed_data) == plain[HEAD:]


def test_each_scan_causes_one_event_on_change(mast: Mast) -> None:
    events = []
    query = m.QueryRangeSensorData([DATA(1, NATIVE, 0)])
    mast.tell(CreateEvent(1, CreateEvent.EventType.EVERY_CHANGE, 25.0, query))
    mast.run(1.005, lambda: events.extend(each.payload for each in mast.host.poll_output(mast.now)))
    reports = [Event.decode(each) for each in events if each[:2] == Event.CODE.to_bytes(2, "little")]
    assert len(reports) in (10, 11)


# --- which sensors


def test_each_sensor_is_reported_once(mast: Mast) -> None:
    query = m.QueryRangeSensorData([DATA(0, NATIVE, 0)] * 1000 + [DATA(1, VEHICLE, 0)])
    answer = mast.ask(query, m.ReportRangeSensorData)
    (only,) = answer.range_sensor_data_list
    assert isinstance(only, m.ReportRangeSensorData.RangeSensorDataSeq)
    assert only.range_sensor_data_rec.report_coordinate_system == NATIVE


@pytest.mark.slow
def test_unknown_sensors_are_reported_up_to_a_bound(mast: Mast) -> None:
    query = m.QueryRangeSensorData([DATA(number, NATIVE, 0) for number in range(2, 30002)])
    found = mast.ask(query, m.ReportRangeSensorData).range_sensor_data_list
    assert len(found) == 64
    assert {type(each) for each in found} == {m.ReportRangeSensorData.RangeSensorDataErrorRec}
    assert found[0].data_error_code == m.ReportRangeSensorData.DataErrorCode.UNKNOWN_ERROR


def test_capabilities_are_those_of_the_description(mast: Mast) -> None:
    record = m.QueryRangeSensorCapabilities.QueryRangeSensorCapabilitiesRec
    (found,) = mast.ask(
        m.QueryRangeSensorCapabilities([record(0, 0xFFFF)]), m.ReportRangeSensorCapabilities
    ).range_sensor_capabilities_list
    assert found.sensor_name == "lidar"
    assert found.maximum_update_rate == pytest.approx(10.0, abs=0.01)
    assert (found.minimum_range, found.maximum_range) == pytest.approx((0.1, 30.0), abs=1e-3)
    (bare,) = mast.ask(
        m.QueryRangeSensorCapabilities([record(0, 0)]), m.ReportRangeSensorCapabilities
    ).range_sensor_capabilities_list
    assert (bare.sensor_id, bare.maximum_range, bare.supported_states) == (1, None, None)


# --- settings


def configuration(mast: Mast) -> Any:
    record = m.QueryRangeSensorConfiguration.QueryRangeSensorConfigurationRec
    (found,) = mast.ask(
        m.QueryRangeSensorConfiguration([record(1, 0xFFFF)]), m.ReportRangeSensorConfiguration
    ).range_sensor_configuration_list
    return found


def test_settings_require_control(mast: Mast) -> None:
    record = m.SetRangeSensorConfiguration.RangeSensorConfigurationRec(1, sensor_state=2)
    message = m.SetRangeSensorConfiguration(m.SetRangeSensorConfiguration.RequestIdRec(1), [record])
    assert mast.tell(message) == []
    mast.tell(RequestControl(200), client=OTHER)
    assert mast.tell(message) == []
    mast.run(0.1)
    assert configuration(mast).sensor_state == 0
    assert len(mast.tell(message, client=OTHER)) == 1
    assert configuration(mast).sensor_state == 2


def test_a_sensor_in_standby_has_no_data(mast: Mast) -> None:
    mast.tell(RequestControl(200))
    assert isinstance(mast.set(sensor_state=1), m.ConfirmSensorConfiguration.SensorIdRec)
    mast.run(0.1)
    assert mast.scan().data_error_code == m.ReportRangeSensorData.DataErrorCode.SENSOR_NOT_ACTIVE
    mast.set(sensor_state=0)
    mast.run(0.1)
    assert mast.scan().range_sensor_data_rec.sensor_id == 1


def test_angle_limits_restrict_the_scan(mast: Mast) -> None:
    mast.tell(RequestControl(200))
    mast.set(horizontal_field_of_view_start_angle=-math.pi / 2, horizontal_field_of_view_stop_angle=0.0)
    mast.run(0.1)
    bearings = [p.bearing for p in mast.scan(VALIDITY).range_sensor_data_point_list]
    assert len(bearings) == 91
    assert (min(bearings), max(bearings)) == pytest.approx((-math.pi / 2, 0.0), abs=1e-6)


def test_range_limits_restrict_the_scan(yard: Mast) -> None:
    yard.tell(RequestControl(200))
    yard.set(maximum_range=3.0)
    yard.run(0.1)
    assert max(p.range for p in yard.scan().range_sensor_data_point_list) < 3.0


def test_reported_settings_are_valid_settings(mast: Mast) -> None:
    mast.tell(RequestControl(200))
    now = configuration(mast)
    names = [name for name in type(now).__dataclass_fields__ if not name.startswith("reserved")]
    assert isinstance(
        mast.set(**{name: getattr(now, name) for name in names}), m.ConfirmSensorConfiguration.SensorIdRec
    )
    assert configuration(mast) == now


Code = m.ConfirmSensorConfiguration.RangeSensorErrorRec.RangeSensorErrorCode


@pytest.mark.slow
@pytest.mark.parametrize(
    ("wanted", "code", "said"),
    [
        ({"sensor_id": 7}, Code.UNKNOWN_SENSOR_ID, "no sensor 7; there are: 1"),
        ({"horizontal_field_of_view_start_angle": 1.0, "horizontal_field_of_view_stop_angle": -1.0},
         Code.INVALID_HORIZONTAL_FOV, "less than the last"),
        ({"vertical_field_of_view_stop_angle": 0.5}, Code.INVALID_VERTICAL_FOV, "one plane"),
        ({"update_rate": 20.0}, Code.INVALID_UPDATE_RATE, "at most 10 Hz"),
        ({"update_rate": 0.0}, Code.INVALID_UPDATE_RATE, "more than 0"),
        ({"maximum_range": 31.0}, Code.INVALID_SENSOR_RANGE, "0.1..30 m"),
        ({"minimum_range": 5.0, "maximum_range": 4.0}, Code.INVALID_SENSOR_RANGE, "0.1..30 m"),
        ({"update_rate": 20.0, "maximum_range": 31.0}, Code.MULTIPLE_INVALID_PARAMETERS, "Hz; distances"),
    ],
)  # fmt: skip
def test_invalid_settings_are_refused_with_a_reason(mast: Mast, wanted: dict[str, float], code: int, said: str) -> None:
    mast.tell(RequestControl(200))
    before = configuration(mast)
    refused = mast.set(**wanted)
    assert refused.range_sensor_error_code == code
    assert said in refused.error_message
    assert configuration(mast) == before
