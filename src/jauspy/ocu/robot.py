"""Clients of a discovered subsystem and its components. The verbs are in driving, arm, gripper and camera."""

# ruff: noqa: ASYNC109 - a timeout ends in an error that says where the robot is

from __future__ import annotations

import asyncio
from collections.abc import Awaitable, Callable, Coroutine, Iterable, Sequence
from datetime import UTC, datetime
from types import TracebackType
from typing import TYPE_CHECKING, Any, Final, Self

from jauspy.arguments import async_only, check_number, check_text
from jauspy.errors import ConfigError, RequestError
from jauspy.ids import JausID
from jauspy.messages.environment_sensing.v2_0.force_torque_sensor import QueryForceTorque, ReportForceTorque
from jauspy.messages.exp import QueryHealthDetails, ReportHealthDetails
from jauspy.messages.iop import QueryCommunicatorHealth, ReportCommunicatorHealth
from jauspy.messages.ugv import QueryPowerPlantStatus, ReportPowerPlantStatus
from jauspy.ocu.arm import POSE_DRIVER, POSITION_DRIVER, Arm
from jauspy.ocu.camera import VIDEO, Camera
from jauspy.ocu.cell import Connector, Conveyor, ModularArm, PartStation, ServoModule
from jauspy.ocu.comms_lost import POLICY_MANAGER, RETROTRAVERSE, CommsLost, WayBack, drive_back
from jauspy.ocu.connection import Connection
from jauspy.ocu.control import DEFAULT_AUTHORITY, Control
from jauspy.ocu.courses import CoursePoint, course_points, drive_course
from jauspy.ocu.driving import TOLERANCE, VELOCITY, WRENCH, Driving, Progress
from jauspy.ocu.following import Follower, Following
from jauspy.ocu.gripper import DRIVER as GRIPPER_DRIVER, Gripper
from jauspy.ocu.guards import Guards
from jauspy.ocu.joints import PAN_TILT_SENSOR, POSITION_SENSOR, joint_table, reported
from jauspy.ocu.lidar import RANGE_SENSOR, Lidar
from jauspy.ocu.planner import PLANNER, Planner
from jauspy.ocu.preset_poses import PRESET_POSE, NoRouteError, listed
from jauspy.ocu.service import ServiceClient
from jauspy.ocu.sound import ANNOUNCER, MICROPHONE, Announcer, Microphone
from jauspy.ocu.state import BatteryReport, ForceTorque, HealthReport, Joints, LinkHealth, RobotPose, health_of
from jauspy.ocu.subsystems import ComponentInfo, NodeInfo, ServiceInfo, SubsystemInfo
from jauspy.printable import printable

MOVING: Final = (VELOCITY, WRENCH, "mobility:LocalWaypointDriver", POSITION_DRIVER, POSE_DRIVER, GRIPPER_DRIVER)
"""Services that move a robot; a component that offers one of them is controlled by `Robot.control`."""
FORCE_TORQUE: Final = "environmentSensing:ForceTorqueSensor"
COMMUNICATOR: Final = "iop:Communicator"
ALL_LINK_FIELDS: Final = 0xFFFF
HEALTH: Final = "HealthReporter"
POWER_PLANT: Final = "PowerPlantManager"
ALL_FIELDS: Final = 0xFF
DEFAULT_SPEED: Final = 0.5
"""m/s on the way to a point."""


class ComponentClient:
    """The client of one discovered component; `info` is its description at the time of discovery."""

    def __init__(self, connection: Connection, info: ComponentInfo) -> None:
        self.info = info
        self._connection = connection

    def __repr__(self) -> str:
        return f"<{printable(self.info.name) or 'component'} {self.id}>"

    @property
    def id(self) -> JausID:
        """JAUS id."""
        return self.info.id

    @property
    def is_controlled(self) -> bool:
        """True while this OCU controls it, or asks for control."""
        return self.id in self._connection.controls

    def service(self, name: str) -> ServiceClient:
        """The client of a service by its URN, or the end of it; `ConfigError` lists what the component offers."""
        check_text(name, "a service's name")
        found = self.info.find(name)
        if found is None:
            raise ConfigError(f"{self.id} does not offer {name}; it offers {_listed(self.info)}")
        return ServiceClient(self._connection, self.id, found)

    @property
    def camera(self) -> Camera:
        """Camera of the component, if it has one only."""
        return Camera(self._connection, (self.info,), None)

    def microphone(self, number: int = 1) -> Microphone:
        """One of its microphones, by number from 1."""
        check_number(number, "number", whole=True)
        return Microphone(self._connection, self.info, number)

    def announcer(self, number: int | None = None) -> Announcer:
        """One of its loudspeakers by number; without a number the first one. Microphones are counted before them."""
        if number is not None:
            check_number(number, "number", whole=True)
        return Announcer(self._connection, self.info, number)

    # --- modules of a factory cell ------------------------------------------------------------------------------------

    @property
    def modular_arm(self) -> ModularArm:
        """The arm of servo modules that it moves."""
        return ModularArm(self.service("ModularArm"))

    def connector(self, number: int = 1) -> Connector:
        """One of its vacuum connectors, by number from 1."""
        check_number(number, "number", whole=True)
        return Connector(self.service("VacuumConnector"), number)

    @property
    def servo(self) -> ServoModule:
        """Servo of the module."""
        return ServoModule(self.service("ServoModule"))

    @property
    def conveyor(self) -> Conveyor:
        """Belt of the conveyor."""
        return Conveyor(self.service("Conveyor"))

    @property
    def part_station(self) -> PartStation:
        """Sensor of parts, and the power of modules."""
        return PartStation(self.service("PartSensor"), self.service("ModulePower"))


class Robot:
    """The client of a discovered subsystem; `info` is its description at the time of discovery.

    Its verbs use metres, radians and seconds with the axes of REP-103 (x forward, y left, z up), and need `control()`
    where they move something. They raise `ConfigError` when the robot offers no service for them.
    """

    def __init__(self, connection: Connection, info: SubsystemInfo) -> None:
        self.info = info
        self._connection = connection
        self._driving = Driving(connection, self._offering)
        self._follower = Follower(connection, self._offering)
        self._arms: dict[JausID, Arm] = {}

    def __repr__(self) -> str:
        return f"<{self.info.kind} {self.id} {self.name!r} with {len(self.components)} components>"

    @property
    def id(self) -> int:
        """The subsystem's number."""
        return self.info.id

    @property
    def name(self) -> str:
        """The name that it reports."""
        return self.info.name

    @property
    def nodes(self) -> tuple[NodeInfo, ...]:
        """Nodes of the robot."""
        return self.info.nodes

    @property
    def components(self) -> tuple[ComponentInfo, ...]:
        """The components of all of its nodes."""
        return self.info.components

    def component(self, which: int | str | JausID) -> ComponentClient:
        """The client of a component by number (102) or by id ("101.1.102"); `ConfigError` lists the components."""
        if isinstance(which, str):
            which = JausID.parse(which)
        found = [component for component in self.components if which in (component.id, component.id.component)]
        if len(found) == 1:
            return ComponentClient(self._connection, found[0])
        if found:
            raise ConfigError(f"subsystem {self.id} has several components {which}; choose by whole id: {_ids(found)}")
        raise ConfigError(f"subsystem {self.id} has no component {which}; it has {_ids(self.components)}")

    def service(self, name: str) -> ServiceClient:
        """The client of a service by its URN, or the end of it, such as `mobility:PrimitiveDriver`.

        Raises `ConfigError`, which lists what is offered, unless exactly one component offers it.
        """
        check_text(name, "a service's name")
        offering = list(self.info.offering(name))
        if len(offering) == 1:
            return ComponentClient(self._connection, offering[0]).service(name)
        if offering:
            first = offering[0].id.component
            raise ConfigError(
                f"several components of subsystem {self.id} offer {name}: {_ids(offering)}; choose one, as in "
                f"robot.component({first}).service({name!r})"
            )
        offers = "; ".join(f"{component.id}: {_listed(component)}" for component in self.components) or "nothing"
        raise ConfigError(f"subsystem {self.id} does not offer {name}; it offers {offers}")

    # --- what it does ---------------------------------------------------------------------------------------------

    def control(self, *parts: str | int, authority: int = DEFAULT_AUTHORITY) -> RobotControl:
        """Control for an `async with` block of all components that move the robot, or of some; it resumes them.

        `parts` are "drive", "arm", "gripper", "planner", or components by number (102) or id ("101.1.102"). At the end
        of the block they are put in Standby and released.
        """
        ids: list[JausID] = [id for part in parts for id in self._part(part)] if parts else self._moving()
        return RobotControl(self._connection, list(dict.fromkeys(ids)), authority, self._driving.close)

    async def drive(self, linear: float = 0.0, angular: float = 0.0, *, seconds: float | None = None) -> None:
        """Drive at `linear` m/s forward and `angular` rad/s counterclockwise; until the next command, or for `seconds`.

        The command is repeated while the program's event loop runs (dead-man's switch): when the program hangs for a
        second, or ends, the robot stops. Raises `ConfigError` for velocities that the robot does not reach,
        `ControlRejected` without control, and `RequestError` with the reason when the robot is not Ready.
        """
        await self._driving.drive(linear, angular, seconds)

    async def drive_effort(self, linear: float = 0.0, angular: float = 0.0, *, seconds: float | None = None) -> None:
        """Drive with efforts in percent, forward and counterclockwise, and without steering; otherwise as `drive`."""
        await self._driving.drive_effort(linear, angular, seconds)

    async def speed_limits(self) -> tuple[float, float]:
        """The greatest velocities for `drive` that the robot reports, in m/s and rad/s; infinite if it reports none."""
        return await self._driving.speed_limits()

    async def stop(self) -> None:
        """Stop the robot; resent until acknowledged. Needs control; `jauspy estop` stops any robot."""
        await self._driving.stop()

    async def go_to(
        self,
        x: float,
        y: float,
        yaw: float | None = None,
        *,
        frame: str = "local",
        speed: float = DEFAULT_SPEED,
        tolerance: float = TOLERANCE,
        accept: float | None = None,
        timeout: float = 120.0,
        progress: Callable[[Progress], None] | None = None,
    ) -> RobotPose:
        """Drive to a point (metres) and wait until the robot has arrived; returns its pose.

        With `yaw` (radians, counterclockwise) it then turns on the spot to this heading; without, it stays as it
        arrived. Obstacles are not avoided. `frame`: "local", the frame of `pose()`, or "robot", forward and left of the
        present pose. The robot is told to come within `tolerance` metres; where it stands then may be `accept` metres
        off, by default the same. `progress` is called five times a second with the remaining distance. Raises
        `RequestError` when the robot does not arrive within `timeout` seconds. If the call is cancelled, it stops.
        """
        return await self._driving.go_to(
            x, y, yaw, frame, speed=speed, tolerance=tolerance, accept=accept, timeout=timeout, progress=progress
        )

    async def drive_course(
        self,
        points: Iterable[CoursePoint | tuple[float, float]],
        *,
        speed: float = DEFAULT_SPEED,
        timeout: float = 300.0,
    ) -> RobotPose:
        """Drive along points (metres of the local frame) and wait until the robot is at the last; returns its pose.

        A point is a pair (x, y), or `CoursePoint(x, y, reverse=True, wait=5.0)` to drive there backward and stand there
        for some seconds; these need EnhancedLocalWaypointListDriver (IOP). At other points the robot drives on at
        `speed` m/s, negative backward. The list of the component is replaced. Raises `RequestError` when the robot is
        not there within `timeout` seconds; then, and if the call is cancelled, it stops.
        """
        return await drive_course(
            self._connection, self._offering, self._driving, course_points(points), speed=speed, timeout=timeout
        )

    async def follow(
        self,
        leader: int | str | JausID,
        *,
        gap: float = 3.0,
        lag: float = 0.0,
        max_gap: float = 30.0,
        offset: float = 0.0,
        may_slow: bool = False,
        may_stop: bool = False,
    ) -> None:
        """Begin to follow another robot along its path, `gap` metres and, if given, `lag` seconds behind it.

        `leader` is the component with its GlobalPoseSensor, as in "101.1.102", or a subsystem: then the one with the
        numbers of this robot's driver. `offset` is in metres to the left of the leader's path. The robot stops for good
        when its leader is more than `max_gap` metres ahead along the path or silent for 3 s, when another command is
        sent to it, and when its control is lost. With `may_slow` and `may_stop` it asks the leader to wait for it,
        which the leader does if its `set_convoy` names this robot. Raises `RequestError` if it does not begin.
        """
        await self._follower.follow(
            leader, gap=gap, lag=lag, max_gap=max_gap, offset=offset, may_slow=may_slow, may_stop=may_stop
        )

    async def stop_following(self) -> None:
        """Stop the robot, which then follows nobody."""
        await self._follower.stop()

    async def following(self) -> Following:
        """Whether the robot follows another one now, and how."""
        return await self._follower.state()

    async def set_convoy(self, *followers: int) -> None:
        """Set the convoy that this robot leads: subsystems, each behind the one before it; none ends the convoy.

        The robot waits for the first of them only, if that asks for it; it needs `control()`.
        """
        await self._follower.set_convoy(self.id, followers)

    async def retrotraverse(
        self,
        distance: float | None = None,
        *,
        speed: float | None = None,
        point: tuple[float, float] | None = None,
        nose_first: bool = False,
        standoff: float = 0.0,
        timeout: float = 300.0,
        progress: Callable[[float], None] | None = None,
    ) -> WayBack:
        """Drive back along the path by which the robot came, and wait until it has arrived.

        The result tells how far that was, and why it ended there: a path that is shorter than `distance` is no error.

        `distance` metres, or to where the path comes nearest to a `point`, latitude and longitude in degrees, and then
        at most `distance`; it stops `standoff` metres before. It drives with the headings of the way out, or turns
        about (`nose_first`), at most at `speed` m/s, by default as fast as it came. `progress` is called twice a second
        with the share that is driven, 0..1. Raises `RequestError` when the robot gives up, or does not arrive within
        `timeout` seconds. If the call is cancelled, it stops.
        """
        service = self._offering(RETROTRAVERSE)
        if service is None:
            raise ConfigError(f"this robot keeps no path to drive back: it does not offer {RETROTRAVERSE}")
        await self._driving.close()
        return await drive_back(
            self._connection,
            service,
            distance=distance,
            speed=speed,
            point=point,
            nose_first=nose_first,
            standoff=standoff,
            timeout=timeout,
            progress=progress,
        )

    @property
    def comms_lost(self) -> CommsLost:
        """The reaction of the robot to a lost link to this OCU."""
        service = self._offering(POLICY_MANAGER)
        if service is None:
            raise ConfigError(f"this robot has no policy for lost links: it does not offer {POLICY_MANAGER}")
        return CommsLost(self._connection, service)

    async def pose(self) -> RobotPose:
        """The present pose in the robot's local frame, metres and radians."""
        return await self._driving.pose()

    async def joints(self) -> Joints:
        """Positions of all joints that are reported, in radians or metres by their names in the description (URDF)."""
        offering = [
            component
            for component in self.components
            if component.find(POSITION_SENSOR) or component.find(PAN_TILT_SENSOR)
        ]
        if not offering:
            raise ConfigError(f"subsystem {self.id} does not report its joints: it offers no {POSITION_SENSOR}")
        groups = await asyncio.gather(*map(self._joints_of, offering))
        found: dict[str, float] = {}
        for component, group in zip(offering, groups, strict=True):
            for name, value in group.items():  # names of components that do not report theirs are not unique
                found[f"{component.id} {name}" if name in found else name] = value
        return Joints(found, datetime.now(UTC))

    async def poses(self) -> dict[str, tuple[JausID, ...]]:
        """Names of the poses that the robot knows, each with the components whose joints it names."""
        arms = self._posed()
        found: dict[str, tuple[JausID, ...]] = {}
        for arm, names in zip(arms, await asyncio.gather(*(arm.poses() for arm in arms)), strict=True):
            for name in dict.fromkeys(names):
                found[name] = (*found.get(name, ()), arm.info.id)
        return found

    async def move_to(self, name: str, *, timeout: float = 60.0) -> Joints:
        """Move all joints of a pose there, as in `robot.move_to("stow")`: arm and flippers. Returns all positions.

        One component moves after the other. One that finds no way without contact waits until others have moved.
        Raises as `Arm.move_to`, with `timeout` seconds for each component, which must be controlled.
        """
        known = await self.poses()
        if name not in known:
            raise ConfigError(f"subsystem {self.id} has no pose {name!r}; it has: {listed(known)}")
        waiting = [arm for arm in self._posed() if arm.info.id in known[name]]
        while waiting:
            obstructed = list[tuple[Arm, NoRouteError]]()
            for arm in waiting:
                try:
                    await arm.move_to(name, timeout=timeout)
                except NoRouteError as error:
                    obstructed.append((arm, error))
            if len(obstructed) == len(waiting):
                raise obstructed[0][1]
            waiting = [arm for arm, _ in obstructed]
        return await self.joints()

    async def force_torque(self, sensor: int = 1) -> ForceTorque:
        """Measurement of a force-torque sensor, as between arm and gripper; `sensor` is its number from 1."""
        check_number(sensor, "sensor", whole=True)
        client = self.service(FORCE_TORQUE)
        record = QueryForceTorque.QueryForceTorqueRec(sensor, QueryForceTorque.CoordinateSystem.VEHICLE, ALL_FIELDS)
        report = await client.query(QueryForceTorque([record]), expects=ReportForceTorque)
        for measured in report.report_force_torque_list:
            # JAUS's axes: y to the right, z down
            force = measured.force_x or 0.0, -(measured.force_y or 0.0), -(measured.force_z or 0.0)
            torque = measured.torque_x or 0.0, -(measured.torque_y or 0.0), -(measured.torque_z or 0.0)
            return ForceTorque(force, torque, datetime.now(UTC))
        raise RequestError(f"{client.id} has no force-torque sensor {sensor}")

    async def link(self) -> LinkHealth:
        """Health of the link to this program, which the robot measures while it is asked (Communicator of IOP)."""
        report = await self.service(COMMUNICATOR).query(QueryCommunicatorHealth(ALL_LINK_FIELDS))
        record, error = report.report_communicator_health_rec, report.error_variant
        rate = error.packet_error_rate if isinstance(error, ReportCommunicatorHealth.PacketErrorRateRec) else 0.0
        return LinkHealth(
            is_up=record.bit_results != ReportCommunicatorHealth.BIT_Results.FAILED,
            round_trip=None if record.latency is None else 2.0 * record.latency,
            loss=rate / 100.0,
            rate=None if record.data_rate is None else 1e6 * record.data_rate,
        )

    async def battery(self) -> BatteryReport:
        """Charge, voltage and current of the robot's battery, of the first one if it has several."""
        client = self.service(POWER_PLANT)
        report = await client.query(QueryPowerPlantStatus([]), expects=ReportPowerPlantStatus)
        for plant in report.power_plant_status_list:
            status = plant.power_plant_status_var
            if isinstance(status, ReportPowerPlantStatus.BatteryStatus) and status.battery_status:
                row = status.battery_status[0]
                percent = row.percent_charge_remaining
                return BatteryReport(
                    charge=None if percent is None else percent / 100.0,
                    voltage=row.voltage,
                    current=row.current_draw,
                    temperature=row.battery_temp,
                    time=datetime.now(UTC),
                )
        raise RequestError(f"{client.id} reports no battery")

    async def health(self) -> list[HealthReport]:
        """Health of the robot's drives, cameras, computers and battery, the worst first."""
        report = await self.service(HEALTH).query(QueryHealthDetails(), expects=ReportHealthDetails)
        return health_of(report, datetime.now(UTC))

    @property
    def arm(self) -> Arm:
        """Arm of the robot: the component that moves a tool, or else the only one that moves joints to positions."""
        with_tool, joints = list(self.info.offering(POSE_DRIVER)), list(self.info.offering(POSITION_DRIVER))
        return self._arm_of(with_tool if len(with_tool) == 1 else joints)

    def manipulator(self, which: int | str | JausID) -> Arm:
        """The joints that a component moves, by number (103) or id: another arm, flippers, or a pan-tilt unit."""
        return self._arm_of([self.component(which).info])

    @property
    def gripper(self) -> Gripper:
        """Gripper of the robot."""
        return Gripper(
            self._connection, self._only(list(self.info.offering(GRIPPER_DRIVER)), "gripper", GRIPPER_DRIVER)
        )

    @property
    def planner(self) -> Planner:
        """Planner of the motions of its arm: a component that runs beside it, as by `jauspy planner`."""
        found = list(self.info.offering(PLANNER))
        return Planner(self._connection, self._only(found, "planner of motions", PLANNER, "robot.planner_of({})"))

    def planner_of(self, which: int | str | JausID) -> Planner:
        """A planner of motions by number (130) or id of its component, for a robot that has several."""
        return Planner(self._connection, self.component(which).info)

    @property
    def guards(self) -> Guards:
        """Its guards against self collision and obstacles."""
        return Guards(self._connection, self.components)

    def camera(self, name: str | None = None) -> Camera:
        """A camera by its name; the only one without a name."""
        return Camera(self._connection, tuple(self.info.offering(VIDEO)), name)

    def lidar(self, name: str | None = None) -> Lidar:
        """A lidar by its name; the only one without a name."""
        return Lidar(self._connection, tuple(self.info.offering(RANGE_SENSOR)), name)

    @property
    def microphone(self) -> Microphone:
        """First microphone of the robot, if one component has them."""
        return Microphone(self._connection, self._only(list(self.info.offering(MICROPHONE)), "microphone", MICROPHONE))

    @property
    def announcer(self) -> Announcer:
        """First loudspeaker of the robot, if one component has them."""
        return Announcer(self._connection, self._only(list(self.info.offering(ANNOUNCER)), "loudspeaker", ANNOUNCER))

    # --- inside ---------------------------------------------------------------------------------------------------

    def _offering(self, *names: str) -> ServiceClient | None:
        """The client of the first of these services that the robot offers."""
        for name in names:
            offering = list(self.info.offering(name))
            if offering:
                return self.service(name) if len(offering) == 1 else self._of_the_driver(name, offering)
        return None

    def _of_the_driver(self, name: str, offering: list[ComponentInfo]) -> ServiceClient:
        """The one of several components that this program controls, if that is one."""
        controlled = [component for component in offering if component.id in self._connection.controls]
        return (
            self.service(name)
            if len(controlled) != 1
            else ComponentClient(self._connection, controlled[0]).service(name)
        )

    def _moving(self) -> list[JausID]:
        return [component.id for component in self.components if any(component.find(name) for name in MOVING)]

    def _part(self, part: str | int) -> list[JausID]:
        if part == "drive":
            return [self._driving.driver().id]
        if part == "arm":
            return [self.arm.info.id]
        if part == "gripper":
            return [self.gripper.info.id]
        if part == "planner":
            return [self.planner.info.id]
        if isinstance(part, str) and "." not in part:
            raise ConfigError(
                f"there is no part {part!r}; parts are drive, arm, gripper, planner, and components, as in 102"
            )
        return [self.component(part).id]

    def _posed(self) -> list[Arm]:
        """The components with named poses."""
        return [self._arm_of([component]) for component in self.info.offering(PRESET_POSE)]

    def _arm_of(self, found: list[ComponentInfo]) -> Arm:
        info = self._only(found, "arm", POSITION_DRIVER, "robot.manipulator({})")
        return self._arms.setdefault(info.id, Arm(self._connection, info))

    def _only(
        self, found: list[ComponentInfo], what: str, service: str, choose: str = "robot.component({})"
    ) -> ComponentInfo:
        if not found:
            raise ConfigError(f"subsystem {self.id} has no {what}: it does not offer {service}")
        if len(found) > 1:
            which = choose.format(found[0].id.component)
            raise ConfigError(f"subsystem {self.id} has several: {_ids(found)}; choose one, as in {which}")
        return found[0]

    async def _joints_of(self, component: ComponentInfo) -> dict[str, float]:
        table = await joint_table(self._connection, component)
        return table.from_reported(await reported(self._connection, component))


def _ids(components: list[ComponentInfo] | tuple[ComponentInfo, ...]) -> str:
    return ", ".join(str(component.id) for component in components) or "none"


def _listed(component: ComponentInfo) -> str:
    return ", ".join(map(str, component.services)) or "nothing"


class RobotControl:
    """Controls components of a robot in the block: takes control and resumes them; Standby and release at the end.

    Entering raises `ControlRejected`, which names the client in control, and then controls nothing. When control of a
    component is lost later, commands to it raise `ControlRejected`, and `lost` gives the reason.
    """

    def __init__(
        self, connection: Connection, ids: Sequence[JausID], authority: int, leave: Callable[[], Awaitable[None]]
    ) -> None:
        if not ids:
            raise ConfigError("there is nothing to control: the robot offers no service that moves it")
        self.ids: tuple[JausID, ...] = tuple(ids)
        """The components, as their robot lists them."""
        self._connection = connection
        self._authority = authority
        self._leave = leave
        self._controls: list[Control] = []

    def __repr__(self) -> str:
        return (
            f"<control of {', '.join(map(str, self.ids))}: {self.lost or ('held' if self._controls else 'not held')}>"
        )

    @property
    def held(self) -> bool:
        """True while all components are controlled."""
        return bool(self._controls) and all(control.held for control in self._controls)

    @property
    def lost(self) -> str:
        """Why control of a component was lost; empty while all are held."""
        return next((control.lost for control in self._controls if control.lost), "")

    def check(self) -> None:
        """Raise `ControlRejected` when control of a component was lost."""
        for control in self._controls:
            control.check()

    async def resume(self) -> None:
        """Resume the components again, as after a lost link, an emergency, or a Standby of another client.

        They accept new commands; interrupted motions are not continued.
        """
        self.check()
        await _together(self._resume(control) for control in self._controls)

    async def include(self, ids: Iterable[JausID]) -> None:
        """Control further components, too, and resume them.

        Raises `ControlRejected` when one of them is not granted, and then controls none of these.
        """
        connection = self._connection
        new = [Control(connection, id, self._authority, connection.retry) for id in ids if id not in self.ids]
        try:
            await _together(self._enter(component) for component in new)
        except BaseException as error:
            await self._drop({component.id for component in new}, error)
            raise
        self.ids += tuple(component.id for component in new)

    async def exclude(self, ids: Iterable[JausID]) -> None:
        """End control of these components: they are put in Standby and released, if they still answer."""
        gone = set(ids)
        self.ids = tuple(component_id for component_id in self.ids if component_id not in gone)
        await self._drop(gone, None)

    async def _drop(self, ids: set[JausID], error: BaseException | None) -> None:
        dropped = [control for control in self._controls if control.id in ids]
        self._controls = [control for control in self._controls if control.id not in ids]
        kind = None if error is None else type(error)
        await _together(control.__aexit__(kind, error, None) for control in dropped)

    async def until_lost(self) -> None:
        """Wait until control of a component is lost, or until the block is left."""
        waiting = [asyncio.ensure_future(control.until_lost()) for control in self._controls]
        try:
            await asyncio.wait(waiting, return_when=asyncio.FIRST_COMPLETED)
        finally:
            for task in waiting:
                task.cancel()

    async def __aenter__(self) -> Self:
        connection = self._connection
        controls = [Control(connection, id, self._authority, connection.retry) for id in self.ids]
        try:
            await _together(self._enter(control) for control in controls)
        except BaseException as error:
            await self._exit(error)
            raise
        return self

    async def _enter(self, control: Control) -> None:
        await control.__aenter__()
        self._controls.append(control)
        await self._resume(control)

    async def _resume(self, control: Control) -> None:
        await ServiceClient(self._connection, control.id, _MANAGEMENT).resume()

    async def __aexit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        try:
            await self._leave()
        finally:
            await self._exit(error)

    async def _exit(self, error: BaseException | None) -> None:
        await self._drop({control.id for control in self._controls}, error)

    if not TYPE_CHECKING:
        __enter__ = __exit__ = async_only("`async with`")


_MANAGEMENT: Final = ServiceInfo("urn:jaus:jss:core:Management", "1.1")


async def _together(work: Iterable[Coroutine[Any, Any, None]]) -> None:
    """Run all to their ends, then raise the first error: a component that fails must not leave others half way."""
    results = await asyncio.gather(*work, return_exceptions=True)
    for result in results:
        if isinstance(result, BaseException):
            raise result
