"""Translation of JAUS messages to Foxglove's schemas: SI units, axes of REP-103 (x forward, y left, z up).

All times are those of the recorder: clocks of robots may differ, and reports of joints have no time.
"""

from __future__ import annotations

import math
import struct
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from itertools import pairwise
from typing import Any, Final, NamedTuple

from foxglove import messages as fox

from jauspy.codec.message import Message
from jauspy.geometry.poses import Pose, Transform, Twist, jaus_frame, jaus_pose, jaus_twist
from jauspy.geometry.vectors import rotation_from_quaternion
from jauspy.ids import JausID
from jauspy.messages.core.v1_0 import access_control, management
from jauspy.messages.environment_sensing.v1_0 import range_sensor as range_sensor_1
from jauspy.messages.environment_sensing.v1_0.types import StaticGeometricPropertiesRec
from jauspy.messages.environment_sensing.v2_0 import range_sensor as range_sensor_2
from jauspy.messages.iop.v1_1.cost_map2d import ReportCostMap2D
from jauspy.messages.manipulator.v1_0 import (
    manipulator_joint_position_sensor,
    manipulator_joint_velocity_sensor,
    pan_tilt_joint_position_sensor,
    pan_tilt_joint_velocity_sensor,
    primitive_manipulator,
)
from jauspy.messages.manipulator.v2_0 import (
    manipulator_joint_velocity_sensor as joint_velocity_2,
    pan_tilt_joint_velocity_sensor as pan_tilt_velocity_2,
    primitive_manipulator as primitive_manipulator_2,
)
from jauspy.messages.manipulator.v2_0.manipulator_specification_service import ReportManipulatorSpecifications
from jauspy.messages.mobility.v1_0.global_pose_sensor import ReportGlobalPose
from jauspy.messages.mobility.v1_0.local_pose_sensor import ReportLocalPose
from jauspy.messages.mobility.v1_0.velocity_state_sensor import ReportVelocityState
from jauspy.printable import printable
from jauspy.protocol.header import Packet
from jauspy.recording.described_robot import DescribedRobot
from jauspy.recording.robot_scene import (
    BASE,
    LOCAL,
    RobotScene,
    frame_id,
    frame_transform,
    sdk_pose,
    vector3,
)
from jauspy.recording.samples import Sample, sample

TRANSFORMS: Final = "/tf"
LOG: Final = "/log"
"""Topics of all robots; the others begin with the id of the component that reports."""
FULL_INTERVAL: Final = 1_000_000_000
"""Nanoseconds after which all frames of a described robot are told again, so that a viewer can begin anywhere."""
MAX_STATES: Final = 4096
"""Sentences of the log, and components with state, that are remembered; with one more, all are forgotten."""
EVEN: Final = 0.01
"""Share of the step between two rays of a planar scan by which a step may differ."""
MAX_CELLS: Final = 4_000_000
"""Cells of a map of runs of equal cost."""
LEVEL: Final = 1e-3
"""Radians that a ray of a planar scan may be inclined; more than inclinations are rounded to."""


class Seen(NamedTuple):
    """A message as it was seen."""

    packet: Packet
    message: Any
    time: int
    """Nanoseconds since 1970, UTC."""

    @property
    def source(self) -> JausID:
        """The sender."""
        return self.packet.source

    @property
    def base(self) -> str:
        """The frame of the sender's vehicle."""
        return frame_id(self.source.subsystem, BASE)

    @property
    def stamp(self) -> fox.Timestamp:
        """The time, of the SDK."""
        return fox.Timestamp(self.time // 1_000_000_000, self.time % 1_000_000_000)

    def topic(self, name: str) -> str:
        """A topic of the sender."""
        return f"/{self.source}/{name}"


@dataclass(slots=True)
class _Component:
    """What a component has told that others of its messages need."""

    pose: Transform | None = None
    names: tuple[str, ...] = ()
    """Joints of a manipulator, from its specification."""
    sensors: dict[int, Transform] = field(default_factory=dict)
    """Poses of sensors on the vehicle."""


class Translator:
    """Translates messages of many robots; `robots` are those whose descriptions are known, by subsystem."""

    def __init__(self, robots: Mapping[int, DescribedRobot]) -> None:
        self._scenes = {subsystem: RobotScene(robot) for subsystem, robot in robots.items()}
        self._components: dict[JausID, _Component] = {}
        self._poses: dict[int, Transform] = {}
        self._told_at: dict[int, int] = {}
        """When all frames of a robot were told."""
        self._sentences: dict[str, str] = {}

    def translate(self, packet: Packet, message: Message, time: int) -> Iterator[Sample]:
        """The samples of a message; none for most kinds."""
        handler = _handler(type(message))
        seen = Seen(packet, message, time)
        if seen.source.subsystem in self._scenes:
            yield from self._scene(seen)
        if handler is not None:
            yield from handler(self, seen)

    # --- frames ---------------------------------------------------------------------------------------------------

    def _scene(self, seen: Seen) -> Iterator[Sample]:
        """Meshes once, and all frames now and then."""
        subsystem = seen.source.subsystem
        before, scene = self._told_at.get(subsystem), self._scenes[subsystem]
        if before is None:
            name = f"/{subsystem}/meshes"
            yield sample(name, seen.time, scene.meshes(seen.stamp), state="")
        if before is None or not 0 <= seen.time - before < FULL_INTERVAL:
            self._told_at[subsystem] = seen.time
            transforms = scene.transforms(seen.stamp)
            pose = self._poses.get(subsystem)
            if pose is not None:
                transforms.append(_base_transform(seen, pose))
            yield sample(TRANSFORMS, seen.time, fox.FrameTransforms(transforms=transforms), state=str(subsystem))

    def _component(self, source: JausID) -> _Component:
        found = self._components.get(source)
        if found is None:
            if len(self._components) >= MAX_STATES:
                self._components.clear()
                self._poses.clear()
            found = self._components[source] = _Component()
        return found

    # --- vehicle --------------------------------------------------------------------------------------------------

    def local_pose(self, seen: Seen) -> Iterator[Sample]:
        """PoseInFrame, and the frame of the vehicle."""
        report: ReportLocalPose = seen.message
        if report.x is None or report.y is None:
            return
        values = (report.x, report.y, report.z, report.roll, report.pitch, report.yaw)
        pose = Transform.from_pose(jaus_pose(Pose(*(value or 0.0 for value in values))))
        self._component(seen.source).pose = self._poses[seen.source.subsystem] = pose
        local = frame_id(seen.source.subsystem, LOCAL)
        told = fox.PoseInFrame(timestamp=seen.stamp, frame_id=local, pose=sdk_pose(pose))
        yield sample(seen.topic("pose"), seen.time, told)
        transforms = fox.FrameTransforms(transforms=[_base_transform(seen, pose)])
        yield sample(TRANSFORMS, seen.time, transforms)

    def velocity(self, seen: Seen) -> Iterator[Sample]:
        """Odometry with the latest pose; none before the first pose."""
        report: ReportVelocityState = seen.message
        pose = self._component(seen.source).pose or self._poses.get(seen.source.subsystem)
        if pose is None:
            return
        values = (
            report.velocity_x,
            report.velocity_y,
            report.velocity_z,
            report.roll_rate,
            report.pitch_rate,
            report.yaw_rate,
        )
        twist = jaus_twist(Twist(*(value or 0.0 for value in values)))
        told = fox.Odometry(
            timestamp=seen.stamp,
            frame_id=frame_id(seen.source.subsystem, LOCAL),
            body_frame_id=seen.base,
            pose=sdk_pose(pose),
            linear_velocity=vector3((twist.vx, twist.vy, twist.vz)),
            angular_velocity=vector3((twist.wx, twist.wy, twist.wz)),
        )
        yield sample(seen.topic("odometry"), seen.time, told)

    def global_pose(self, seen: Seen) -> Iterator[Sample]:
        """LocationFix; headings are clockwise from north in both."""
        report: ReportGlobalPose = seen.message
        if report.latitude is None or report.longitude is None:
            return
        known = fox.LocationFixPositionCovarianceType
        variance = None if report.position_rms is None else report.position_rms**2 / 3.0
        told = fox.LocationFix(
            timestamp=seen.stamp,
            frame_id=seen.base,
            latitude=report.latitude,
            longitude=report.longitude,
            altitude=report.altitude or 0.0,
            position_covariance=None if variance is None else [variance, 0, 0, 0, variance, 0, 0, 0, variance],
            position_covariance_type=known.Unknown if variance is None else known.Approximated,
            heading=report.yaw,
        )
        yield sample(seen.topic("location"), seen.time, told, state="")

    # --- joints ---------------------------------------------------------------------------------------------------

    def specification(self, seen: Seen) -> Iterator[Sample]:
        """Learn the names of a manipulator's joints."""
        records = seen.message.joint_names_list or ()
        self._component(seen.source).names = tuple(printable(record.description) for record in records)
        yield from ()

    def joint_positions(self, seen: Seen) -> Iterator[Sample]:
        """JointStates and frames; without a description, positions as AS6057 counts them."""
        values = [record.joint_position.value for record in seen.message.joint_position_list]
        scene = self._scenes.get(seen.source.subsystem)
        known = None if scene is None else scene.take_manipulator(seen.source.component, values)
        yield from self._positions(seen, known, values)

    def pan_tilt_positions(self, seen: Seen) -> Iterator[Sample]:
        """The same for a pan-tilt unit."""
        values = [seen.message.joint1_position, seen.message.joint2_position]
        scene = self._scenes.get(seen.source.subsystem)
        known = None if scene is None else scene.take_pan_tilt(seen.source.component, values)
        yield from self._positions(seen, known, values)

    def _positions(self, seen: Seen, known: Mapping[str, float] | None, values: Sequence[float]) -> Iterator[Sample]:
        if known is None:
            named = zip(self._joint_names(seen, len(values)), values, strict=True)
            yield _joints(seen, [fox.JointState(name=name, position=value) for name, value in named])
            return
        yield _joints(seen, [fox.JointState(name=name, position=value) for name, value in known.items()])
        transforms = self._scenes[seen.source.subsystem].transforms(seen.stamp, known)
        yield sample(TRANSFORMS, seen.time, fox.FrameTransforms(transforms=transforms))

    def joint_velocities(self, seen: Seen) -> Iterator[Sample]:
        """JointStates with velocities."""
        values = [record.joint_velocity.value for record in seen.message.joint_velocity_list]
        named = zip(self._joint_names(seen, len(values)), values, strict=True)
        yield _joints(seen, [fox.JointState(name=name, velocity=value) for name, value in named], "joint_velocities")

    def pan_tilt_velocities(self, seen: Seen) -> Iterator[Sample]:
        """The same for a pan-tilt unit."""
        values = [seen.message.joint1_velocity, seen.message.joint2_velocity]
        named = zip(self._joint_names(seen, len(values)), values, strict=True)
        yield _joints(seen, [fox.JointState(name=name, velocity=value) for name, value in named], "joint_velocities")

    def joint_efforts(self, seen: Seen) -> Iterator[Sample]:
        """JointStates with efforts, in percent of the maximum, as AS6057 has them."""
        values = [record.joint_effort for record in seen.message.joint_effort_list]
        named = zip(self._joint_names(seen, len(values)), values, strict=True)
        yield _joints(seen, [fox.JointState(name=name, effort=value) for name, value in named], "joint_efforts")

    def _joint_names(self, seen: Seen, count: int) -> Sequence[str]:
        scene = self._scenes.get(seen.source.subsystem)
        described = () if scene is None else scene.joints(seen.source.component)
        for names in (described, self._component(seen.source).names):
            if len(names) == count:
                return names
        return [f"{seen.source} joint {number}" for number in range(1, count + 1)]

    # --- ranges and maps ------------------------------------------------------------------------------------------

    def sensor_places(self, seen: Seen) -> Iterator[Sample]:
        """Learn where sensors are mounted."""
        for record in seen.message.geometric_properties_list:
            place = record.geometric_properties_variant
            if isinstance(place, StaticGeometricPropertiesRec):
                x, y, z = place.sensor_position
                reported = Transform(rotation_from_quaternion(*place.unit_quaternion), (x, y, z))
                sensors = self._component(seen.source).sensors
                if len(sensors) < MAX_STATES:
                    sensors[record.sensor_id_rec.sensor_id] = jaus_frame(reported)
        yield from ()

    def ranges(self, seen: Seen) -> Iterator[Sample]:
        """LaserScan of a level ring of even steps, else PointCloud."""
        for record in seen.message.range_sensor_data_list:
            described = getattr(record, "range_sensor_data_rec", None)
            if described is None:  # why there is no measurement
                continue
            number = int(described.sensor_id)
            frame, pose = self._place(seen, number, is_native=described.report_coordinate_system == 0)
            points = record.range_sensor_data_point_list
            if is_planar([(point.bearing, point.inclination) for point in points]):
                yield _laser_scan(seen, number, frame, pose, points)
            else:
                yield _point_cloud(seen, number, frame, pose, points)

    def _place(self, seen: Seen, number: int, *, is_native: bool) -> tuple[str, Transform]:
        """The frame of a sensor's measurements, and its pose in it."""
        if not is_native:
            return seen.base, Transform()
        scene = self._scenes.get(seen.source.subsystem)
        frame = None if scene is None else scene.lidar_frame(number)
        if frame is not None:
            return frame, Transform()
        return seen.base, self._component(seen.source).sensors.get(number, Transform())

    def cost_map(self, seen: Seen) -> Iterator[Sample]:
        """Grid of a map in the local frame. Rows run along x of the map, columns to the right of it."""
        report: ReportCostMap2D = seen.message
        size, place = report.cost_map2d_rec, report.cost_map2d_pose_var
        rows, columns = size.number_of_rows, size.number_of_columns
        if not isinstance(place, report.CostMap2DLocalPoseRec) or not rows or not columns:
            return
        cells = _costs(report.cost_map2d_data_var)
        if cells is None or len(cells) != rows * columns:
            return
        middle = jaus_pose(Pose(place.map_center_x, place.map_center_y, 0.0, 0.0, 0.0, place.map_rotation))
        # the first cell of a Grid is at its origin, x runs along its columns, and y along its rows
        corner = Transform(position=(-size.map_width / 2.0, -size.map_height / 2.0, 0.0))
        told = fox.Grid(
            timestamp=seen.stamp,
            frame_id=frame_id(seen.source.subsystem, LOCAL),
            pose=sdk_pose(Transform.from_pose(middle) @ corner),
            column_count=columns,
            cell_size=fox.Vector2(x=size.map_width / columns, y=size.map_height / rows),
            row_stride=columns,
            cell_stride=1,
            fields=[fox.PackedElementField(name="cost", offset=0, type=fox.PackedElementFieldNumericType.Uint8)],
            data=cells,
        )
        yield sample(seen.topic("map"), seen.time, told, state="", is_bulk=True)

    # --- log ------------------------------------------------------------------------------------------------------

    def status(self, seen: Seen) -> Iterator[Sample]:
        """A sentence when the state of a component changes."""
        status = seen.message.status
        name = getattr(status, "name", str(status))
        is_bad = name in ("FAILURE", "EMERGENCY")
        yield from self._say(seen, f"state {seen.source}", f"{seen.source} is in {name}", is_error=is_bad)

    def control(self, seen: Seen) -> Iterator[Sample]:
        """A sentence when a component reports another client in control."""
        report: access_control.ReportControl = seen.message
        client = JausID(report.subsystem_id, report.node_id, report.component_id)
        text = f"is controlled by {client}" if int(client) else "is not controlled"
        yield from self._say(seen, f"control {seen.source}", f"{seen.source} {text}")

    def confirmed(self, seen: Seen) -> Iterator[Sample]:
        """A sentence when a client gets or is refused control."""
        client, code = seen.packet.destination, seen.message.response_code
        if code == access_control.ConfirmControl.ResponseCode.CONTROL_ACCEPTED:
            yield from self._say(seen, f"control {seen.source}", f"{seen.source} is controlled by {client}")
            return
        why = getattr(code, "name", str(code)).lower().replace("_", " ")
        text = f"{seen.source} refuses control to {client}: {why}"
        yield from self._say(seen, f"refused {seen.source} {client}", text, is_error=True)

    def rejected(self, seen: Seen) -> Iterator[Sample]:
        """A sentence when a client has lost or released control."""
        if seen.message.response_code == access_control.RejectControl.ResponseCode.CONTROL_RELEASED:
            yield from self._say(seen, f"control {seen.source}", f"{seen.source} is not controlled")

    def emergency(self, seen: Seen) -> Iterator[Sample]:
        """A sentence when a client sets or clears an emergency."""
        is_set = isinstance(seen.message, management.SetEmergency)
        code = seen.message.emergency_code
        verb = "sets" if is_set else "clears"
        target = seen.packet.destination
        text = f"{seen.source} {verb} emergency {getattr(code, 'name', code)} of {target}"
        yield from self._say(seen, f"emergency {seen.source} {target}", text, is_error=is_set)

    def ordered(self, seen: Seen) -> Iterator[Sample]:
        """A sentence when a client orders another state."""
        target, name = seen.packet.destination, type(seen.message).NAME
        yield from self._say(seen, f"order {seen.source} {target}", f"{seen.source} sends {name} to {target}")

    def _say(self, seen: Seen, topic: str, text: str, *, is_error: bool = False) -> Iterator[Sample]:
        """A line of the log, unless it was the last one of its topic."""
        if self._sentences.get(topic) == text:
            return
        if len(self._sentences) >= MAX_STATES:
            self._sentences.clear()
        self._sentences[topic] = text
        level = fox.LogLevel.Error if is_error else fox.LogLevel.Info
        told = fox.Log(timestamp=seen.stamp, level=level, message=text, name=str(seen.source))
        yield sample(LOG, seen.time, told, state=topic)


def picture(camera: str, time: int, access_unit: bytes, *, is_idr: bool) -> Sample:
    """CompressedVideo of one picture of H.264 (a byte stream of annex B), as its camera encoded it."""
    stamp = fox.Timestamp(time // 1_000_000_000, time % 1_000_000_000)
    told = fox.CompressedVideo(timestamp=stamp, frame_id=camera, data=access_unit, format="h264")
    return sample(f"/{camera}/video", time, told, is_bulk=True, is_key=is_idr)


def is_planar(rays: Sequence[tuple[float, float]]) -> bool:
    """True if rays (bearing and inclination, rad) are level, and their bearings are evenly spaced."""
    if len(rays) < 2 or any(abs(inclination) > LEVEL for _, inclination in rays):
        return False
    step = (rays[-1][0] - rays[0][0]) / (len(rays) - 1)
    slack = max(abs(step) * EVEN, LEVEL)
    return step != 0.0 and all(abs(b - a - step) <= slack for (a, _), (b, _) in pairwise(rays))


def _base_transform(seen: Seen, pose: Transform) -> fox.FrameTransform:
    return frame_transform(seen.stamp, frame_id(seen.source.subsystem, LOCAL), seen.base, pose)


def _joints(seen: Seen, joints: list[fox.JointState], topic: str = "joints") -> Sample:
    return sample(seen.topic(topic), seen.time, fox.JointStates(timestamp=seen.stamp, joints=joints))


def _has_echo(point: Any) -> bool:
    return point.range_validity is None or bool(point.range_validity)


def _laser_scan(seen: Seen, number: int, frame: str, pose: Transform, points: Sequence[Any]) -> Sample:
    counterclockwise = sorted(points, key=lambda point: -point.bearing)
    told = fox.LaserScan(
        timestamp=seen.stamp,
        frame_id=frame,
        pose=sdk_pose(pose),
        start_angle=-counterclockwise[0].bearing,
        end_angle=-counterclockwise[-1].bearing,
        ranges=[point.range if _has_echo(point) else float("inf") for point in counterclockwise],
    )
    return sample(seen.topic(f"scan_{number}"), seen.time, told, is_bulk=True)


def _point_cloud(seen: Seen, number: int, frame: str, pose: Transform, points: Sequence[Any]) -> Sample:
    found = bytearray()
    for point in points:
        if _has_echo(point):
            flat, height = point.range * math.cos(point.inclination), point.range * math.sin(point.inclination)
            found += struct.pack("<3f", flat * math.cos(point.bearing), -flat * math.sin(point.bearing), height)
    numeric = fox.PackedElementFieldNumericType.Float32
    told = fox.PointCloud(
        timestamp=seen.stamp,
        frame_id=frame,
        pose=sdk_pose(pose),
        point_stride=12,
        fields=[fox.PackedElementField(name=axis, offset=4 * place, type=numeric) for place, axis in enumerate("xyz")],
        data=bytes(found),
    )
    return sample(seen.topic(f"points_{number}"), seen.time, told, is_bulk=True)


def _costs(data: Any) -> bytes | None:
    """The costs of cells, row by row; None if they are too many."""
    match data:
        case ReportCostMap2D.CostDataList():
            return bytes(record.cost for record in data.cost_data_list)
        case ReportCostMap2D.CostAndConfidenceDataList():
            return bytes(record.cost for record in data.cost_and_confidence_data_list)
    runs = [record.cost_and_run_length for record in data.run_length_encoded_data_list]
    if sum(run.number_cells_sub_field for run in runs) > MAX_CELLS:
        return None
    return b"".join(bytes([run.cost_sub_field]) * run.number_cells_sub_field for run in runs)


Handler = Callable[[Translator, Seen], Iterator[Sample]]

_HANDLERS: Final[Mapping[type[Message], Handler]] = {
    ReportLocalPose: Translator.local_pose,
    ReportVelocityState: Translator.velocity,
    ReportGlobalPose: Translator.global_pose,
    ReportManipulatorSpecifications: Translator.specification,
    manipulator_joint_position_sensor.ReportJointPositions: Translator.joint_positions,
    pan_tilt_joint_position_sensor.ReportPanTiltJointPositions: Translator.pan_tilt_positions,
    manipulator_joint_velocity_sensor.ReportJointVelocities: Translator.joint_velocities,
    joint_velocity_2.ReportJointVelocity: Translator.joint_velocities,
    pan_tilt_joint_velocity_sensor.ReportPanTiltJointVelocities: Translator.pan_tilt_velocities,
    pan_tilt_velocity_2.ReportPanTiltJointVelocity: Translator.pan_tilt_velocities,
    primitive_manipulator.ReportJointEfforts: Translator.joint_efforts,
    primitive_manipulator_2.ReportJointEffort: Translator.joint_efforts,
    range_sensor_1.ReportRangeSensorData: Translator.ranges,
    range_sensor_2.ReportRangeSensorData: Translator.ranges,
    range_sensor_1.ReportSensorGeometricProperties: Translator.sensor_places,
    range_sensor_2.ReportSensorGeometricProperties: Translator.sensor_places,
    ReportCostMap2D: Translator.cost_map,
    management.ReportStatus: Translator.status,
    management.SetEmergency: Translator.emergency,
    management.ClearEmergency: Translator.emergency,
    management.Standby: Translator.ordered,
    management.Resume: Translator.ordered,
    management.Reset: Translator.ordered,
    management.Shutdown: Translator.ordered,
    access_control.ReportControl: Translator.control,
    access_control.ConfirmControl: Translator.confirmed,
    access_control.RejectControl: Translator.rejected,
}
"""Public definitions, by the oldest version from which later ones are derived."""


def _handler(kind: type[Message]) -> Handler | None:
    return next((_HANDLERS[each] for each in kind.__mro__ if each in _HANDLERS), None)
