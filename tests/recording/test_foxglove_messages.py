"""What Foxglove's schemas tell of JAUS messages, read back by others' libraries."""

from __future__ import annotations

import asyncio
import json
import math
import struct
from collections import defaultdict
from contextlib import suppress
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest
from tests.recording.protobuf import decoded

from jauspy.capture.dissector import Dissector
from jauspy.capture.reader import Datagram
from jauspy.ids import JausID
from jauspy.messages import registry
from jauspy.messages.core import (
    ClearEmergency,
    ConfirmControl,
    Event,
    QueryControl,
    QueryStatus,
    RejectControl,
    ReportControl,
    ReportStatus,
    SetEmergency,
)
from jauspy.messages.environment_sensing import ReportRangeSensorData
from jauspy.messages.iop import ReportCostMap2D
from jauspy.messages.manipulator import QueryJointPositions, QueryPanTiltJointPositions, ReportJointPositions
from jauspy.messages.mobility import (
    QueryLocalPose,
    QueryVelocityState,
    ReportGlobalPose,
    ReportLocalPose,
    ReportVelocityState,
)
from jauspy.protocol import judp
from jauspy.protocol.delivery import fragment_at, fragment_count
from jauspy.protocol.header import Packet
from jauspy.recording.described_robot import DescribedRobot
from jauspy.recording.recorder import Picture, Recorder
from jauspy.robot import robot_files
from jauspy.testing import VirtualNetwork

pytest.importorskip("foxglove", reason="foxglove-sdk is of the extra `recording`")

from jauspy.recording.feed import Feed
from jauspy.recording.foxglove_messages import is_planar, picture
from jauspy.recording.robot_scene import RobotScene

OCU, ROBOT = JausID(42, 1, 1), JausID(101, 1, 102)
HERE, THERE = ("10.0.0.1", 3794), ("10.0.0.2", 3794)
START = 1_700_000_000.0


def datagram(packet: Packet, time: float = START) -> Datagram:
    return Datagram(1, time, HERE, THERE, judp.pack(packet))


class Reader:
    """Feeds messages, and decodes the samples that they make."""

    def __init__(self, robots: dict[int, DescribedRobot] | None = None) -> None:
        self._feed = Feed(registry, robots or {})
        self._dissector = Dissector(registry)
        self._number = 0

    def take(self, message: Any, source: JausID = ROBOT, destination: JausID = OCU) -> dict[str, Any]:
        """The samples by topic, without those that are no Protocol Buffers."""
        self._number += 1
        payload = message if isinstance(message, bytes) else message.encode()
        found: dict[str, Any] = {}
        for index in range(fragment_count(len(payload))):
            part, flag = fragment_at(payload, index)
            packet = replace(Packet(source, destination, part, self._number), data_flag=flag)
            row = datagram(packet, START + self._number * 0.1)
            for sample in self._feed.samples(row, self._dissector.dissect(row.payload, row.time).parts):
                form = sample.form
                if form.encoding == "protobuf":
                    found[sample.topic] = decoded(form.schema.name, form.schema.data, sample.data)
                else:
                    found[sample.topic] = sample.data
            self._number += 1
        return found


@pytest.fixture(scope="module")
def inc1() -> DescribedRobot:
    config = robot_files.load("inc1")
    return DescribedRobot(config.subsystem, robot_files.robot_model(config), config.movers)


def test_a_pose_has_the_axes_of_rep_103() -> None:
    found = Reader().take(ReportLocalPose(x=1.0, y=2.0, z=3.0, roll=0.0, pitch=0.0, yaw=math.pi / 2))
    pose = found["/101.1.102/pose"]
    assert (pose.frame_id, pose.timestamp.seconds) == ("101/local", int(START))
    place, turn = pose.pose.position, pose.pose.orientation
    assert (place.x, place.y, place.z) == pytest.approx((1.0, -2.0, -3.0), abs=1e-4)
    assert (turn.z, turn.w) == pytest.approx((-math.sqrt(0.5), math.sqrt(0.5)), abs=1e-4)
    (transform,) = found["/tf"].transforms
    assert (transform.parent_frame_id, transform.child_frame_id) == ("101/local", "101/base")
    assert transform.translation.y == pytest.approx(-2.0, abs=1e-4)


def test_odometry_has_the_latest_pose_and_a_velocity_of_the_body() -> None:
    reader = Reader()
    velocity = ReportVelocityState(velocity_x=1.0, velocity_y=0.5, yaw_rate=0.25)
    assert "/101.1.102/odometry" not in reader.take(velocity)
    reader.take(ReportLocalPose(x=4.0, y=0.0))
    odometry = reader.take(velocity)["/101.1.102/odometry"]
    assert odometry.pose.position.x == pytest.approx(4.0, abs=1e-4)
    assert (odometry.linear_velocity.x, odometry.linear_velocity.y) == pytest.approx((1.0, -0.5), abs=0.01)
    assert odometry.angular_velocity.z == pytest.approx(-0.25, abs=0.001)
    assert (odometry.frame_id, odometry.body_frame_id) == ("101/local", "101/base")


def test_a_location() -> None:
    fix = Reader().take(ReportGlobalPose(latitude=50.5, longitude=8.25, altitude=100.0, position_rms=3.0))
    told = fix["/101.1.102/location"]
    assert (told.latitude, told.longitude, told.altitude) == pytest.approx((50.5, 8.25, 100.0), abs=1e-4)
    assert list(told.position_covariance) == pytest.approx([3, 0, 0, 0, 3, 0, 0, 0, 3], abs=1e-4)
    assert "/101.1.102/location" not in Reader().take(ReportGlobalPose(latitude=50.5))


def positions(*values: float) -> ReportJointPositions:
    rows = [{"joint_position": {"choice": 1, "value": value}} for value in values]
    return ReportJointPositions.from_dict({"joint_position_list": rows})


def test_joints_without_a_description_are_numbered() -> None:
    (told,) = [each for topic, each in Reader().take(positions(0.5, -0.5)).items() if topic.endswith("/joints")]
    assert [joint.name for joint in told.joints] == ["101.1.102 joint 1", "101.1.102 joint 2"]
    assert [joint.position for joint in told.joints] == pytest.approx([0.5, -0.5])


def test_joints_of_a_described_robot_move_its_frames(inc1: DescribedRobot) -> None:
    reader, arm = Reader({101: inc1}), JausID(101, 1, 104)
    first = reader.take(positions(0.0, 0.0, 0.0, 0.0, 0.0), arm)
    names = [joint.name for joint in first["/101.1.104/joints"].joints]
    assert names == list(inc1.model.groups["arm"].joints)
    before = {each.child_frame_id: each for each in first["/tf"].transforms}
    second = reader.take(positions(0.5, 0.0, 0.0, 0.0, 0.0), arm)
    after = {each.child_frame_id: each for each in second["/tf"].transforms}
    assert set(after) == {"101/" + inc1.model.description.joint(name).child for name in names}
    moved = [name for name, each in after.items() if str(each.rotation) != str(before[name].rotation)]
    assert moved == ["101/arm_link_1"]


def test_all_frames_are_told_at_first_and_again_after_a_second(inc1: DescribedRobot) -> None:
    reader, links = Reader({101: inc1}), inc1.model.description.links()
    counts = [len(each["/tf"].transforms) if "/tf" in each else 0 for each in (
        reader.take(ReportStatus.from_dict({"status": "READY", "reserved": 0})) for _ in range(7)
    )]  # fmt: skip
    assert counts[0] == len(links)  # each but the root in its parent, and the root in the base
    assert counts.count(len(links)) == 2
    assert set(counts) == {0, len(links)}


def test_meshes_are_in_the_scene_once(inc1: DescribedRobot) -> None:
    reader = Reader({101: inc1})
    scene = reader.take(ReportLocalPose(x=0.0, y=0.0))["/101/meshes"]
    assert "/101/meshes" not in reader.take(ReportLocalPose(x=0.0, y=0.0))
    models = [model for entity in scene.entities for model in entity.models]
    assert {entity.frame_id for entity in scene.entities} <= {f"101/{link}" for link in inc1.model.description.links()}
    assert len(models) == inc1.model.description.urdf.count("<mesh ")
    for model in models:
        assert (model.media_type, model.data[:1]) == ("model/obj", b"#") or b"\nv " in model.data


def scan(*rays: tuple[float, float, float]) -> ReportRangeSensorData:
    points = [
        {"range": distance, "bearing": bearing, "inclination": inclination, "range_validity": int(distance < 50.0)}
        for bearing, inclination, distance in rays
    ]
    stamp = {"milliseconds": 0, "seconds": 1, "minutes": 2, "hour": 3, "day": 4}
    described = {"sensor_id": 1, "report_coordinate_system": 0, "time_stamp": stamp}
    row = {"range_sensor_data_seq": {"range_sensor_data_rec": described, "range_sensor_data_point_list": points}}
    return ReportRangeSensorData.from_dict({"range_sensor_data_list": [row]})


def test_a_level_ring_is_a_laser_scan() -> None:
    told = Reader().take(scan((-0.1, 0.0, 5.0), (0.0, 0.0, 99.0), (0.1, 0.0, 7.0)))["/101.1.102/scan_1"]
    assert (told.start_angle, told.end_angle) == pytest.approx((-0.1, 0.1), abs=1e-6)
    assert list(told.ranges) == pytest.approx([7.0, math.inf, 5.0], abs=1e-3)
    assert told.frame_id == "101/base"


def test_other_scans_are_clouds() -> None:
    told = Reader().take(scan((0.0, 0.5, 2.0), (1.0, 0.0, 99.0), (math.pi / 2, 0.0, 3.0)))["/101.1.102/points_1"]
    points = list(struct.iter_unpack("<3f", told.data))
    assert [field.name for field in told.fields] == ["x", "y", "z"]
    assert points[0] == pytest.approx((2.0 * math.cos(0.5), 0.0, 2.0 * math.sin(0.5)), abs=1e-3)
    assert points[1] == pytest.approx((0.0, -3.0, 0.0), abs=1e-3)
    assert len(points) == 2


def test_what_is_planar() -> None:
    assert is_planar([(0.0, 0.0), (0.1, 0.0), (0.2, 0.0)])
    assert not is_planar([(0.0, 0.0), (0.1, 0.1), (0.2, 0.0)])
    assert not is_planar([(0.0, 0.0), (0.1, 0.0), (0.4, 0.0)])
    assert not is_planar([(0.0, 0.0), (0.0, 0.0)])
    assert not is_planar([(0.0, 0.0)])


def test_a_scan_of_many_fragments_and_a_report_in_an_event() -> None:
    wide = scan(*((number * 0.001, 0.0, 5.0) for number in range(2000)))
    assert fragment_count(len(wide.encode())) > 1
    event = Event(event_id=1, sequence_number=0, report_message=wide)
    for message in (wide, event):
        found = Reader().take(message)
        assert len(found["/101.1.102/scan_1"].ranges) == 2000
        assert json.loads(found[f"/101.1.102/{type(message).NAME}"])


def test_a_scan_of_a_described_robot_is_in_its_link(inc1: DescribedRobot) -> None:
    told = Reader({101: inc1}).take(scan((0.0, 0.0, 5.0), (0.1, 0.0, 5.0)))
    assert told["/101.1.102/scan_1"].frame_id == f"101/{inc1.model.lidars[0].link}"


def cost_map(cells: dict[str, Any]) -> ReportCostMap2D:
    size = {"number_of_rows": 2, "number_of_columns": 3, "map_width": 3.0, "map_height": 2.0}
    place = {"cost_map2d_local_pose_rec": {"map_center_x": 10.0, "map_center_y": 4.0, "map_rotation": 0.0}}
    return ReportCostMap2D.from_dict(
        {"cost_map2d_rec": size, "cost_map2d_pose_var": place, "cost_map2d_data_var": cells}
    )


def test_a_map() -> None:
    plain = {"cost_data_list": {"cost_data_list": [{"cost": cost} for cost in range(6)]}}
    told = Reader().take(cost_map(plain))["/101.1.102/map"]
    assert (told.data, told.column_count, told.row_stride) == (bytes(range(6)), 3, 3)
    assert (told.cell_size.x, told.cell_size.y) == pytest.approx((1.0, 1.0), abs=0.2)
    assert told.pose.position.x == pytest.approx(10.0 - 1.5, abs=0.2)
    few = {"cost_data_list": {"cost_data_list": [{"cost": 1}]}}
    assert "/101.1.102/map" not in Reader().take(cost_map(few))


def test_a_picture_is_as_it_came() -> None:
    access_unit = b"\x00\x00\x00\x01\x67sps\x00\x00\x00\x01\x65slice"
    made = picture("101.1.106", 1_500_000_000, access_unit, is_idr=True)
    told = decoded(made.form.schema.name, made.form.schema.data, made.data)
    assert (made.topic, told.format, told.data) == ("/101.1.106/video", "h264", access_unit)
    assert (told.timestamp.seconds, told.timestamp.nanos) == (1, 500_000_000)


def status(name: str) -> ReportStatus:
    return ReportStatus.from_dict({"status": name, "reserved": 0})


def test_the_log_tells_changes_and_each_once() -> None:
    reader, accepted = Reader(), ConfirmControl(ConfirmControl.ResponseCode.CONTROL_ACCEPTED)
    steps: list[tuple[Any, JausID, JausID]] = [
        (status("STANDBY"), ROBOT, OCU),
        (status("STANDBY"), ROBOT, OCU),
        (accepted, ROBOT, OCU),
        (ReportControl(42, 1, 1, 200), ROBOT, OCU),
        (ConfirmControl(ConfirmControl.ResponseCode.INSUFFICIENT_AUTHORITY), ROBOT, JausID(43, 1, 1)),
        (SetEmergency(SetEmergency.EmergencyCode.STOP), OCU, ROBOT),
        (status("EMERGENCY"), ROBOT, OCU),
        (ClearEmergency(ClearEmergency.EmergencyCode.STOP), OCU, ROBOT),
        (RejectControl(RejectControl.ResponseCode.CONTROL_RELEASED), ROBOT, OCU),
    ]
    lines = [found["/log"] for step in steps if "/log" in (found := reader.take(*step))]
    assert [line.message for line in lines] == [
        "101.1.102 is in STANDBY",
        "101.1.102 is controlled by 42.1.1",
        "101.1.102 refuses control to 43.1.1: insufficient authority",
        "42.1.1 sets emergency STOP of 101.1.102",
        "101.1.102 is in EMERGENCY",
        "42.1.1 clears emergency STOP of 101.1.102",
        "101.1.102 is not controlled",
    ]
    assert [line.level for line in lines] == [2, 2, 4, 4, 4, 2, 2]


async def recorded_run(path: Path, robot: DescribedRobot) -> None:
    """Record a virtual robot that is watched, from what is sent on its network."""
    async with VirtualNetwork() as network:
        recorder = Recorder(path, registry, robots={robot.subsystem: robot})

        def keeps(packet: Packet) -> bool:
            recorder.add(datagram(packet, network.utc_now().timestamp()))
            return True

        network.keeps = keeps
        async with network.robot("inc1"), network.ocu("42.1.2") as ocu:
            found = await ocu.discover(101)
            watching = [
                asyncio.create_task(watch(found, "mobility:LocalPoseSensor", QueryLocalPose())),
                asyncio.create_task(watch(found, "mobility:VelocityStateSensor", QueryVelocityState())),
                asyncio.create_task(scans(found)),
            ]
            for query in (QueryStatus(), QueryControl()):
                await ocu.query(ROBOT, query)
            await ocu.query(JausID(101, 1, 104), QueryJointPositions())
            await ocu.query(JausID(101, 1, 107), QueryPanTiltJointPositions())
            await asyncio.sleep(3.0)
            for task in watching:
                task.cancel()
                with suppress(asyncio.CancelledError):
                    await task
        recorder.add_picture(Picture("101.1.106", network.utc_now().timestamp(), b"\x00\x00\x00\x01\x65", is_idr=True))
        recorder.close()


async def watch(robot: Any, service: str, query: Any) -> None:
    async with robot.service(service).subscribe(query, rate=10) as reports:
        async for _ in reports:
            pass


async def scans(robot: Any) -> None:
    async for _ in robot.lidar().scans(rate=5):
        pass


@pytest.mark.slow
async def test_every_message_of_a_run_fits_its_schema(tmp_path: Path, inc1: DescribedRobot) -> None:
    jsonschema, reader = pytest.importorskip("jsonschema"), pytest.importorskip("mcap.reader")
    path = tmp_path / "run.mcap"
    await recorded_run(path, inc1)
    counts: defaultdict[str, int] = defaultdict(int)
    with path.open("rb") as file:
        for schema, _, message in reader.make_reader(file).iter_messages():
            counts[schema.name] += 1
            if schema.encoding == "protobuf":
                assert decoded(schema.name, schema.data, message.data)
            elif schema.encoding == "jsonschema":
                jsonschema.validate(json.loads(message.data), json.loads(schema.data))
    seen = {name.removeprefix("foxglove."): count for name, count in counts.items() if name.startswith("foxglove.")}
    assert set(seen) == {
        "CompressedVideo",
        "FrameTransforms",
        "JointStates",
        "LaserScan",
        "Log",
        "Odometry",
        "PoseInFrame",
        "SceneUpdate",
    }
    assert min(seen["PoseInFrame"], seen["Odometry"]) > 20
    assert seen["LaserScan"] > 10


def test_primitive_shapes_and_missing_meshes(inc1: DescribedRobot, tmp_path: Path) -> None:
    from foxglove.messages import Timestamp

    from jauspy.geometry.urdf import parse_urdf

    text = f"""<robot name="r"><link name="a">
      <visual><geometry><box size="1 2 3"/></geometry></visual>
      <visual><geometry><cylinder radius="1" length="2"/></geometry></visual>
      <visual><geometry><sphere radius="1"/></geometry></visual>
      <visual><geometry><mesh filename="{tmp_path}/none.obj"/></geometry></visual>
    </link></robot>"""
    model = replace(inc1.model, description=parse_urdf(text), groups={})
    made = RobotScene(DescribedRobot(7, model)).meshes(Timestamp(0, 0))
    (entity,) = decoded("foxglove.SceneUpdate", made.get_schema().data, made.encode()).entities
    assert (entity.cubes[0].size.y, entity.cylinders[0].size.x, entity.spheres[0].size.z) == (2.0, 2.0, 2.0)
    assert not entity.models
