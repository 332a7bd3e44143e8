"""Makes the host of each module of a robot: core services, those of the catalogue, and a watchdog on what it moves."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from datetime import datetime
from functools import reduce
from operator import matmul
from typing import Final

from jauspy.errors import ConfigError
from jauspy.geometry.denavit_hartenberg import manipulator_geometry, pan_tilt_frame
from jauspy.geometry.fingers import finger_width
from jauspy.geometry.frames import FrameTree
from jauspy.geometry.poses import JAUS_FROM_REP_103, Transform
from jauspy.geometry.urdf import JointKind
from jauspy.ids import JausID
from jauspy.messages.core import QueryIdentification, ReportIdentification
from jauspy.platform.chassis import Chassis, chassis_of
from jauspy.platform.contract import DriveBase, PartId, RobotParts, Snapshot
from jauspy.platform.description import GroupSetup, RobotModel
from jauspy.platform.joints import JointGroup, joint_positions
from jauspy.platform.localization import Localization, LocalizedDrive
from jauspy.platform.modular import arm, servo
from jauspy.platform.modular.cell import Car, CarState, Conveyor
from jauspy.platform.modular.connector import ConnectorState, VacuumConnector
from jauspy.platform.modular.parts import CellSetup, PartKind, Shape
from jauspy.platform.modular.servo import ServoModule, ServoState
from jauspy.protocol.header import Broadcast, Packet
from jauspy.robot import catalogue
from jauspy.robot.catalogue import Context, Stoppable
from jauspy.robot.config import (
    CAR,
    CONNECTOR,
    CONVEYOR,
    GRIPPER,
    IN_CELLS,
    MODULAR_ARM,
    SERVO,
    ModuleConfig,
    RobotConfig,
)
from jauspy.services.cell import ArmMotionControl, ServoControl
from jauspy.services.command_timeout import ContinuousCommands
from jauspy.services.core import AccessControl, Discovery, Events, Identity, Liveness, Management, Time, Transport
from jauspy.services.environment_sensing import (
    DigitalVideo,
    DigitalVideoCapabilities,
    JointMount,
    MountedForceTorqueSensor,
    MountedLidar,
    StillImage,
    StillImageData,
    VideoCamera,
    VideoSource,
    VideoStreams,
)
from jauspy.services.host import Host
from jauspy.services.manipulator import (
    Arm,
    ManipulatorListDriver,
    ManipulatorSpecification,
    PanTilt,
    PrimitiveEndEffector,
)
from jauspy.services.mobility import GlobalPose, Vehicle
from jauspy.services.service import Service


def mounted_lidars(config: RobotConfig, model: RobotModel, robot: RobotParts) -> tuple[MountedLidar, ...]:
    """The lidars, in the order of the robot's description."""
    tree, groups = FrameTree(model.description), robot.groups
    links = ((lidar, lidar.setup.link) for lidar in robot.lidars.values())
    return tuple(
        MountedLidar(frame_of(tree, link, groups), tree.is_fixed(link), joint_of(config, model, link), lidar=lidar)
        for lidar, link in links
    )


def mounted_force_torque_sensors(model: RobotModel, robot: RobotParts) -> tuple[MountedForceTorqueSensor, ...]:
    """The sensors of force and torque, in the order of the robot's description."""
    tree = FrameTree(model.description)
    return tuple(
        MountedForceTorqueSensor(sensor, frame_of(tree, sensor.setup.link, robot.groups))
        for sensor in robot.force_torque.values()
    )


def mounted_camera(config: RobotConfig, model: RobotModel, source: VideoSource, robot: RobotParts) -> VideoCamera:
    """A camera; one outside of the robot is mounted nowhere on it."""
    if source.setup.outside is not None:
        return VideoCamera(Transform, is_fixed=False, source=source)
    tree, link = FrameTree(model.description), source.setup.link
    return VideoCamera(
        frame_of(tree, link, robot.groups), tree.is_fixed(link), joint_of(config, model, link), source=source
    )


def frame_of(tree: FrameTree, link: str, groups: Mapping[str, JointGroup]) -> Callable[[], Transform]:
    """Returns a link's present frame in the root link's frame (REP-103)."""
    if tree.is_fixed(link):
        fixed = tree.pose(link)
        return lambda: fixed
    return lambda: tree.pose(link, joint_positions(groups.values()))


def joint_of(config: RobotConfig, model: RobotModel, link: str) -> JointMount | None:
    """The last joint before a link, if a CM-MAN or a CM-VIS moves it; None for one that is fixed, or on a finger."""
    description = model.description
    moving = [each for each in description.chain(description.root(), link) if each.kind is not JointKind.FIXED]
    for module in config.modules if moving else ():
        group = model.groups.get(module.moves or "")
        if module.type in {"CM-MAN", "CM-VIS"} and group is not None and moving[-1].name in group.joints:
            number = 1 + group.joints.index(moving[-1].name)
            frame = _joint_frame(module, model, group, number).inverse() @ _at_zero(model, group.base, link)
            return JointMount(config.id_of(module), number, frame @ JAUS_FROM_REP_103)
    return None


def _joint_frame(module: ModuleConfig, model: RobotModel, group: GroupSetup, number: int) -> Transform:
    """Frame of a joint in the group's base link with all joints at zero, as in the specification of the arm or unit."""
    chain = model.description.chain(group.base, group.tip)
    if module.type == "CM-VIS":
        return pan_tilt_frame(chain)
    found = manipulator_geometry(chain)
    return reduce(matmul, (link.frame(link.zero_position) for link in found.links[:number]), found.base)


def _at_zero(model: RobotModel, base: str, link: str) -> Transform:
    """The frame of `link` in that of `base`, with all joints at zero."""
    tree = FrameTree(model.description)
    return tree.pose(base).inverse() @ tree.pose(link)


NO_VIDEOS: Final[Mapping[str, VideoSource]] = {}

WATCHDOG_PERIOD: Final = 0.1
"""Seconds between two checks."""

MAY_MOVE: Final = ("Controlled", "Available", "Ready")
"""The nested states in which a client in control may cause motion (AS5710)."""

ANNOUNCEMENT_PERIOD: Final = 5.0
"""Seconds between two queries."""
CONSOLE_SILENCE: Final = 10.0
"""Seconds without a packet from a console that has answered, after which it may have left."""

LIST_DRIVERS: Final = ("ManipulatorJointPositionListDriver", "ManipulatorEndEffectorPoseListDriver")
"""Services that carry out the component's list, with a ManipulatorListDriver."""


def host_of(
    config: RobotConfig,
    module: ModuleConfig,
    model: RobotModel,
    robot: RobotParts,
    identities: Mapping[int, Identity],
    *,
    videos: Mapping[str, VideoSource] = NO_VIDEOS,
    utc_now: Callable[[], datetime],
    now: float,
    more: Sequence[Service] = (),
) -> Host:
    """The host of a module. `videos`: the cameras by name. `now`: seconds of the clock that runs it.

    `more`: services besides those that `module` names.
    """
    context = _context(config, module, model, robot, videos)
    id = config.id_of(module)
    return module_host(id, module, context, identities=identities, utc_now=utc_now, now=now, more=more)


def check_parts(config: RobotConfig, module: ModuleConfig, model: RobotModel, robot: RobotParts) -> None:
    """Check that the backend has what a module needs that is not present yet; raises `ConfigError`."""
    _context(config, module, model, robot, NO_VIDEOS)


def module_host(
    id: JausID,
    config: ModuleConfig,
    context: Context,
    *,
    identities: Mapping[int, Identity],
    utc_now: Callable[[], datetime],
    now: float,
    more: Sequence[Service] = (),
) -> Host:
    """The host of a module whose services are made from `context`, with a watchdog on what it moves."""
    access = config.access_control
    core: list[Service] = [
        Transport(),
        Events(),
        AccessControl(default_authority=access.default_authority, timeout=access.timeout),
        Management(),
        *more,
    ]
    optional: dict[str, Callable[[], Service]] = {
        "Discovery": lambda: Discovery(identities, registrants=config.registrants),
        "Time": Time,
        "Liveness": Liveness,
    }
    core += [make() for name, make in optional.items() if config.offers(name)]
    try:
        services = catalogue.make(config.type, config.services, context)
    except ConfigError as error:
        raise ConfigError(f"{id}: {error}") from error
    if isinstance(context, catalogue.ManipulatorContext) and any(config.offers(name) for name in LIST_DRIVERS):
        services.append(ManipulatorListDriver(context.arm))
    if config.older_versions:
        services += _older(context, services)
    for service in services:
        if isinstance(service, ContinuousCommands):
            service.command_timeout = config.command_timeout_of(service.urn.rpartition(":")[2])
    host = Host(id, [*core, *services], utc_now=utc_now, now=now, older_versions=config.older_versions)
    if context.moving is not None:
        Watchdog(host, context.moving)
    return host


def _older(context: Context, services: Sequence[Service]) -> Iterator[Service]:
    """Services for the messages of version 1.0 that the newer versions of these services lack."""
    for service in services:
        if isinstance(service, DigitalVideo) and isinstance(context, catalogue.VisionContext):
            yield DigitalVideoCapabilities(context.streams.cameras)
        elif isinstance(service, StillImage):
            yield StillImageData(service)
        elif isinstance(service, PrimitiveEndEffector) and isinstance(context, catalogue.EndEffectorContext):
            yield ManipulatorSpecification(context.arm)


def _context(
    config: RobotConfig, module: ModuleConfig, model: RobotModel, robot: RobotParts, videos: Mapping[str, VideoSource]
) -> Context:
    if module.moves is not None and module.moves not in robot.groups:
        id = config.id_of(module)
        raise ConfigError(f"{id} moves the group {module.moves!r}, and the backend has no such joints")
    if module.type in IN_CELLS and model.cell is not None:
        return cell_context(module, model.cell, robot)
    if module.part == CAR and model.cell is not None:
        vehicle = Vehicle(car_of(robot), name=model.cell.car, chassis=car_chassis(model.cell))
        return catalogue.MobilityContext(robot, vehicle)
    if module.type == "CM-SEN":
        return catalogue.SensorContext(
            robot, mounted_lidars(config, model, robot), mounted_force_torque_sensors(model, robot)
        )
    if module.camera is not None:
        camera = mounted_camera(config, model, videos[module.camera], robot)
        return catalogue.VisionContext(
            robot, VideoStreams({1: camera}, config.video_targets), _pan_tilt(module, model, robot)
        )
    if module.moves is None:
        return catalogue.MobilityContext(robot, vehicle_of(config, model, robot))
    joints = robot.groups[module.moves]
    if module.type == "CM-MAN":
        return catalogue.ManipulatorContext(robot, Arm(joints))
    driver = PrimitiveEndEffector(joints, _carrier(config, module, model))
    width = finger_width(model.description, [joint.name for joint in joints.joints])
    return catalogue.EndEffectorContext(robot, Arm(joints), driver, width)


def vehicle_of(config: RobotConfig, model: RobotModel, robot: RobotParts) -> Vehicle:
    """The chassis and reference frames that the services of a CM-MOB share.

    They use the pose that the robot estimates, unless it is exact.
    """
    origin = None
    if (given := config.origin) is not None:
        origin = GlobalPose(given.latitude, given.longitude, given.altitude, math.radians(given.heading))
    localization = Localization.of(robot)
    drive: DriveBase = robot.drive if localization is None else LocalizedDrive(robot.drive, localization)
    return Vehicle(drive, name=config.name, chassis=chassis_of(model), origin=origin, localization=localization)


def _pan_tilt(module: ModuleConfig, model: RobotModel, robot: RobotParts) -> PanTilt | None:
    """The unit that carries the module's camera; None if the camera has none of its own."""
    if module.group is None:
        return None
    base = model.groups[module.group].base
    return PanTilt(robot.groups[module.group], frame_of(FrameTree(model.description), base, robot.groups))


def _carrier(config: RobotConfig, module: ModuleConfig, model: RobotModel) -> JausID:
    """The CM-MAN whose joints carry the end effector of a module; the module itself when none does."""
    description = model.description
    base = model.groups[module.moves or ""].base
    carrying = {joint.name for joint in description.chain(description.root(), base)}
    arms = (other for other in config.modules if other.type == "CM-MAN" and other.moves in model.groups)
    found = (arm for arm in arms if carrying.intersection(model.groups[arm.moves or ""].joints))
    return config.id_of(next(found, module))


def may_move(host: Host) -> bool:
    """True while a client is in control and has resumed the component."""
    path = host.path
    return any(path[start : start + len(MAY_MOVE)] == MAY_MOVE for start in range(len(path)))


class Watchdog:
    """Stops all motion of a component whenever its state does not allow motion.

    This is redundant: the services stop motion themselves, unless they have a bug.
    """

    def __init__(self, host: Host, moving: Stoppable) -> None:
        self._host = host
        self._moving = moving
        self._check()

    def _check(self) -> None:
        self._host.set_timer("watchdog", self._host.now + WATCHDOG_PERIOD, self._check)
        if not may_move(self._host):
            self._moving.stop()


class Announcement:
    """Makes a component known to a console that waits for a query, as those of the IGVC judges did until 2013.

    Queries the identification of `console` every `ANNOUNCEMENT_PERIOD`, until it answers; and again once it has been
    silent for `CONSOLE_SILENCE`, for the next console of this id. The queries are multicast, too, because the next one
    may be on another machine.
    """

    def __init__(self, host: Host, console: JausID) -> None:
        self._host = host
        self._console = console
        self._last_heard: float | None = None
        """Time of the last packet from the console, once it has answered."""
        self._query()

    def intercept(self, packet: Packet) -> bool:
        """Handle the answer of the console; all other packets are passed to the services."""
        if packet.source != self._console:
            return False
        is_answer = int.from_bytes(packet.payload[:2], "little") == ReportIdentification.CODE
        if is_answer or self._last_heard is not None:
            self._last_heard = self._host.now
        return is_answer

    def _query(self) -> None:
        now = self._host.now
        if self._last_heard is not None and now < self._last_heard + CONSOLE_SILENCE:
            self._host.set_timer("announcement", self._last_heard + CONSOLE_SILENCE, self._query)
            return
        self._last_heard = None
        self._host.set_timer("announcement", now + ANNOUNCEMENT_PERIOD, self._query)
        query = QueryIdentification(QueryIdentification.QueryType.SUBSYSTEM)
        self._host.send(self._console, query, broadcast=Broadcast.GLOBAL)


def cell_context(module: ModuleConfig, cell: CellSetup, robot: RobotParts) -> Context:
    """The parts of a module of a cell. Raises `ConfigError` if the backend does not have them."""
    part = module.part or ""
    match module.type:
        case _ if module.type == SERVO:
            if (found := servo.find(robot, part)) is None:
                raise _missing(f"servo module {part!r}")
            type = cell.type_of(part)
            return catalogue.ServoContext(robot, ServoControl(found, type), connectors_of(part, cell, robot), cell)
        case _ if module.type == CONNECTOR:
            name = "" if part == GRIPPER else cell.type_of(part).name
            return catalogue.ConnectorContext(robot, part, name, connectors_of(part, cell, robot), cell)
        case _ if module.type == CONVEYOR:
            belt = Conveyor.of(robot)
            if belt is None or cell.conveyor is None:
                raise _missing("conveyor")
            return catalogue.ConveyorContext(robot, belt, cell.conveyor.max_speed)
        case _ if module.type == MODULAR_ARM:
            if (chain := arm.find(robot, part)) is None:
                raise _missing(f"modular arm {part!r}")
            return catalogue.ModularArmContext(robot, ArmMotionControl(chain), cell)
        case _:
            return catalogue.PartSensorContext(robot)


def connectors_of(part: str, cell: CellSetup, robot: RobotParts) -> tuple[VacuumConnector, ...]:
    """The connectors of a part, in the order of its type; the gripper is one. Raises `ConfigError` without one."""
    names = connector_names(part, cell)
    there = {each.name: each for each in robot.optional_parts if isinstance(each, VacuumConnector)}
    for name in names:
        if name not in there:
            raise _missing(f"vacuum connector {name!r}")
    return tuple(there[name] for name in names)


def is_present(module: ModuleConfig, cell: CellSetup | None, snapshot: Snapshot) -> bool:
    """True if a module has a component now: those of parts while they have power, the car while it is assembled."""
    if cell is None or module.part is None:
        return True
    parts = snapshot.parts
    if module.type == SERVO:
        servo_state = parts.get(PartId(ServoModule, module.part))
        return isinstance(servo_state, ServoState) and servo_state.powered
    if module.type == CONNECTOR and module.part != GRIPPER:
        states = (parts.get(PartId(VacuumConnector, name)) for name in connector_names(module.part, cell))
        return any(isinstance(state, ConnectorState) and state.powered for state in states)
    if module.type == "CM-MOB":
        car = parts.get(PartId(Car))
        return isinstance(car, CarState) and car.assembled
    return True


def connector_names(part: str, cell: CellSetup) -> list[str]:
    """The full names of the connectors of a part, in the order of its type; the gripper is one."""
    return [GRIPPER] if part == GRIPPER else [f"{part}/{name}" for name in cell.type_of(part).connectors]


def car_of(robot: RobotParts) -> Car:
    """The car. Raises `ConfigError` if the backend has none."""
    if (car := Car.of(robot)) is None:
        raise _missing("car")
    return car


def car_chassis(cell: CellSetup) -> Chassis:
    """The car's chassis for guidance: its size, and the limits of its wheels and fastest servo modules."""
    base = cell.type_of(cell.car)
    wheels = [each.solids[0] for each in cell.types.values() if each.kind is PartKind.WHEEL]
    radius = max((each.size[0] for each in wheels if each.shape is Shape.CYLINDER), default=0.0)
    fastest = max((each.servo.max_speed for each in cell.types.values() if each.servo), default=0.0)
    sides = [frame.position for frame in base.connectors.values()]
    length, width = (max((abs(at[axis]) for at in sides), default=0.0) for axis in (0, 1))
    speed, track = radius * fastest, 2.0 * width
    return Chassis(
        max_speed=speed,
        max_turn_rate=speed / track if track else 0.0,
        acceleration=speed / 2.0,
        deceleration=speed,
        track_separation=track,
        front=length + radius,
        back=length + radius,
        left=width,
        right=width,
        mass=sum(each.mass for each in base.solids),
    )


def _missing(what: str) -> ConfigError:
    return ConfigError(f"the backend has no {what}, which the file of the robot names")
