"""The tables of a robot's TOML file."""

from __future__ import annotations

import math
import re
from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Annotated, Any, Final, Literal, Self, TypeAlias

from pydantic import (
    AfterValidator,
    BaseModel,
    BeforeValidator,
    ConfigDict,
    Field,
    GetCoreSchemaHandler,
    InstanceOf,
    ModelWrapValidatorHandler,
    PrivateAttr,
    field_validator,
    model_validator,
)

from jauspy.cloud.depth import DepthSettings
from jauspy.errors import ConfigError
from jauspy.ids import JausID
from jauspy.platform.battery import BatterySetup
from jauspy.platform.camera import CameraSetup, Quality
from jauspy.platform.description import GroupSetup, GuardedTeleopSetup, SelfCollisionSetup, TiltSetup, TrackSetup
from jauspy.platform.force_torque import ForceTorqueSetup
from jauspy.platform.imaging_settings import ImagingSetup
from jauspy.platform.joints import ContactReaction, Gains, JointGains, JointSensors
from jauspy.platform.lights import LampSetup, TimeOfDay
from jauspy.platform.localization import GnssSetup, LocalizationSetup
from jauspy.platform.modular.parts import CellSetup
from jauspy.platform.named_poses import MAX_POSES
from jauspy.platform.ranging import LidarSetup
from jauspy.platform.servo_drives import CanTable
from jauspy.platform.sound import LoudspeakerSetup, MicrophoneSetup, ToneSetup
from jauspy.platform.stability_setup import StabilitySetup
from jauspy.platform.tables import FormOf, Name, UrdfName, check_unique, reject_conversions, values_of
from jauspy.platform.video_settings import VideoSettings
from jauspy.platform.wheels import WheelJoints
from jauspy.robot import catalogue
from jauspy.robot.kinds import KINDS, Kind
from jauspy.robot.kinds.audio import LOUDSPEAKERS, MICROPHONES
from jauspy.robot.kinds.cell import Connector, Servo
from jauspy.robot.kinds.manipulator import ManipulatorKind
from jauspy.robot.kinds.mobility import ORIGIN, Mobility
from jauspy.robot.kinds.sensing import FORCE_TORQUE, LIDARS
from jauspy.services.command_timeout import DEFAULT_TIMEOUT
from jauspy.services.core.discovery import Registrants
from jauspy.services.environment_sensing.digital_resource_discovery import Network
from jauspy.services.iop import Reminder
from jauspy.services.iop.comms_lost import (
    SHORTEST_TIMEOUT,
    TOO_SHORT,
    CommsLostPolicy,
    ContinueMission,
    Reaction,
    StopMotion,
)
from jauspy.services.iop.retrotraverse import RetraceRequest
from jauspy.services.mobility import GlobalPose
from jauspy.transport.age import MAX_AGE


class StrictConfig(BaseModel):
    """A table of the file; unknown keys are errors."""

    model_config = ConfigDict(extra="forbid", frozen=True)

    @classmethod
    def __get_pydantic_core_schema__(cls, source: Any, handler: GetCoreSchemaHandler) -> Any:
        schema = handler(source)
        reject_conversions(handler.resolve_ref_schema(schema))
        return schema


class JointConfig(StrictConfig):
    """One joint of a group, and its controllers."""

    name: UrdfName
    start: float = 0.0
    """Initial position, in radians or metres."""
    position: Gains
    velocity: Gains


class JointLimitsConfig(StrictConfig):
    """Limits of a joint in place of those of the URDF, which often are zero or missing."""

    effort: Annotated[float, Field(gt=0.0, le=1e6)] | None = None
    """N m, or N."""
    velocity: Annotated[float, Field(gt=0.0, le=1e4)] | None = None
    """Rad/s, or m/s."""
    lower: Annotated[float, Field(ge=-1e4, le=1e4)] | None = None
    upper: Annotated[float, Field(ge=-1e4, le=1e4)] | None = None
    """Radians, or metres."""
    damping: Annotated[float, Field(ge=0.0, le=1e6)] | None = None


class GroupConfig(StrictConfig):
    """Joints that are commanded together: an arm, a gripper, flippers."""

    base: UrdfName
    """The link that carries the group."""
    tip: UrdfName
    """The link at its end."""
    rate: Annotated[float, Field(ge=10.0, le=500.0)] = 250.0
    """Rate of the controllers, in hertz."""
    feed_forward: bool = False
    """True to have their controllers apply the efforts that a motion needs by the robot's own model."""
    contact: ContactReaction = ContactReaction.IGNORE
    """What they do when something is in their way: "stop", "yield" or "ignore". Needs `feed_forward`."""
    sensors: JointSensors | None = None
    """Errors of encoders and motor currents; exact without this table."""
    joints: Annotated[tuple[JointConfig, ...], Field(min_length=1, max_length=32)]
    """Base to tip."""

    @model_validator(mode="after")
    def _check_unique_names(self) -> Self:
        check_unique("joints", [joint.name for joint in self.joints])
        return self

    @model_validator(mode="after")
    def _check_contact(self) -> Self:
        if self.contact is not ContactReaction.IGNORE and not self.feed_forward:
            raise ValueError(f'contact = "{self.contact.value}": needs feed_forward = true, whose model tells contact')
        return self

    def setup(self) -> GroupSetup:
        """Return the setup for the backend."""
        gains = {joint.name: JointGains(joint.position, joint.velocity) for joint in self.joints}
        names, start = zip(*((joint.name, joint.start) for joint in self.joints), strict=True)
        return GroupSetup(
            joints=names,
            gains=gains,
            base=self.base,
            tip=self.tip,
            rate=self.rate,
            start=start,
            feed_forward=self.feed_forward,
            contact=self.contact,
            sensors=self.sensors,
        )


Groups: TypeAlias = Mapping[UrdfName, GroupConfig]

PosePosition: TypeAlias = Annotated[float, Field(allow_inf_nan=False)]


@dataclass(frozen=True, slots=True)
class CameraTable(CameraSetup):
    """A camera and its stream at first: a table `[[cameras]]`."""

    imaging: ImagingSetup = ImagingSetup()
    """Limits and faults of its lens and sensor; by default with noise."""
    size: tuple[int, int] = (640, 480)
    """Width and height of the stream's pictures."""
    rate: int = 15
    """Pictures per second."""
    bit_rate: int = 2000
    """Kilobits per second."""
    depth: DepthSettings | None = None
    """Settings of a depth camera; None for other cameras."""
    stamped: bool = False
    """True if the upper edge of each picture shows its number and the time it was taken, as black and white squares."""

    def __post_init__(self) -> None:
        super(CameraTable, self).__post_init__()  # with slots, super() would mean the class before it had them
        if self.outside is not None and self.depth is not None:
            raise ValueError("depth: a camera outside of the robot measures no depths; leave it out")
        try:
            self.settings()
        except ConfigError as error:
            raise ValueError(str(error)) from None

    def setup(self) -> CameraSetup:
        """Return the camera without its stream, for the backend."""
        return CameraSetup(**values_of(self, CameraSetup))

    def settings(self) -> VideoSettings:
        """Return the settings for the encoder; raises `ConfigError` for what cannot be encoded."""
        width, height = self.size
        return VideoSettings(width=width, height=height, rate=self.rate, bit_rate=1000 * self.bit_rate)


def _check_cloud_address(address: str) -> str:
    if not re.fullmatch(r"tcp://(\[[0-9A-Fa-f:.]+\]|[\w.*-]+):\d{1,5}", address, re.ASCII):
        raise ValueError(f"address: {address!r} is not tcp://HOST:PORT; give other addresses by --cloud NAME=ADDRESS")
    return address


class CloudConfig(StrictConfig):
    """A stream of point clouds."""

    source: UrdfName
    """The name of a lidar, or of a camera with `depth`."""
    address: Annotated[str, Field(max_length=200), AfterValidator(_check_cloud_address)]
    """The address of the publisher, as in tcp://127.0.0.1:5565; others, such as ipc://, replace files, and are given by
    `--cloud`."""


class AccessControlConfig(StrictConfig):
    """Access control of a module."""

    timeout: Annotated[int, Field(ge=0, le=255)] = 5
    """Seconds, 1..255, after which a silent client loses control; 0: never."""
    default_authority: Annotated[int, Field(ge=0, le=255)] = 1
    """Lowest authority that may request control."""


class CommsLostConfig(StrictConfig):
    """The reaction of the robot to a lost link to its client, until a client says otherwise."""

    policy: Literal["stop", "continue", "retrotraverse"] = "stop"
    timeout: Annotated[int, Field(ge=0, le=65535)] = 0
    """Seconds of silence after which it begins, 4 or more; 0: as soon as control has ended."""
    distance: Annotated[float, Field(gt=0.0, le=1e6)] = 30.0
    """Metres that it drives back at most."""
    speed: Annotated[float, Field(ge=0.0, le=327.0)] = 0.0
    """m/s on the way back; 0: as on the way out."""
    regained: Literal["stop", "continue"] = "stop"
    """Reaction to a link that is back; the robot stops in any case when a client takes control."""
    regained_timeout: Annotated[int, Field(ge=0, le=65535)] = 0
    """Seconds of contact after which the link is back."""

    @field_validator("timeout")
    @classmethod
    def _check_timeout(cls, seconds: int) -> int:
        if 0 < seconds < SHORTEST_TIMEOUT:
            raise ValueError(TOO_SHORT)
        return seconds

    def setup(self) -> CommsLostPolicy:
        """Return the policy for the service."""
        reactions: dict[str, Reaction] = {
            "stop": StopMotion(),
            "continue": ContinueMission(),
            "retrotraverse": RetraceRequest(self.distance, self.speed),
        }
        return CommsLostPolicy(
            self.timeout, reactions[self.policy], self.regained_timeout, stops_when_regained=self.regained == "stop"
        )


def _policy(value: object) -> object:
    return value if isinstance(value, CommsLostPolicy) else CommsLostConfig.model_validate(value).setup()


def _check_single_component(text: str) -> str:
    try:
        wildcard = JausID.parse(text).is_wildcard
    except ConfigError as error:
        raise ValueError(f"announce_to: {error}") from None
    if wildcard:
        raise ValueError(f"announce_to: {text} has wildcards; give the id of one console, as in 42.1.1")
    return text


CommandTimeout: TypeAlias = Annotated[float, Field(gt=0.0, le=3600.0)] | Literal["off"]


def _check_command_timeout(value: object) -> object:
    """Raise one error instead of one for each permitted type."""
    for entry in value.values() if isinstance(value, Mapping) else (value,):
        is_number = isinstance(entry, int | float) and not isinstance(entry, bool) and 0.0 < entry <= 3600.0
        if entry != "off" and not is_number:
            raise ValueError(f'{entry!r} is neither seconds (above 0, up to 3600) nor "off"; or write a table of these')
    return value


def _check_kind(type: str) -> str:
    if type not in KINDS:
        raise ValueError(f"there is no such kind of module; the kinds are: {', '.join(map(repr, KINDS))}")
    return type


class ModuleConfig(StrictConfig):
    """One capability module: a JAUS component."""

    type: Annotated[str, AfterValidator(_check_kind)]
    """Kind of the module, as in CM-MOB: one of `KINDS`."""
    component: Annotated[int, Field(ge=1, le=254)]
    node: Annotated[int, Field(ge=1, le=254)] | None = None
    """The JAUS node; that of the robot when left out."""
    part: Annotated[str, Field(min_length=1, max_length=60)] | None = None
    """The part of the factory cell: of a CM-SRV or CM-CON, the name of a CM-ARM's arm; `car` for a CM-MOB that drives
    the cell's car."""
    services: tuple[str, ...] | None = None
    """Services in addition to Transport, Events, AccessControl and Management; by default all that the type offers."""
    group: UrdfName | None = None
    """The joints that a CM-MAN or CM-EEF moves, `arm` or `gripper` when left out; those that turn a CM-VIS's camera."""
    camera: UrdfName | None = None
    """Name of the camera that a CM-VIS streams."""
    older_versions: bool = False
    """True to offer version 1.0 of the services beside 1.1 and 2.0, for clients of that age."""
    access_control: AccessControlConfig = AccessControlConfig()
    registrants: Registrants = "machine"
    """Components that the module's Discovery accepts as registered: those on its machine, or those of its subsystem."""
    command_timeout: Annotated[
        CommandTimeout | Mapping[str, CommandTimeout], BeforeValidator(_check_command_timeout)
    ] = DEFAULT_TIMEOUT
    """Seconds after which an effort, velocity or vector ends unless the client sends a further command, or "off": one
    value for all services of the module, or a table by service."""
    comms_lost: Annotated[InstanceOf[CommsLostPolicy], BeforeValidator(_policy), FormOf(CommsLostConfig)] | None = None
    """Reaction to a lost link to the client, of a CM-MOB; without it, it stays where it stops."""
    announce_to: Annotated[str, AfterValidator(_check_single_component)] | None = None
    """The id of a console that the module queries for its identification until it answers, to be discovered by it."""

    @model_validator(mode="after")
    def _check_type(self) -> Self:
        try:
            needs = self.needs()
        except ConfigError as error:
            raise ValueError(f"services: {error}") from None
        if isinstance(self.command_timeout, Mapping):
            known = catalogue.defaults(self.type) if self.services is None else self.services
            if unknown := sorted(set(self.command_timeout) - set(known)):
                raise ValueError(f"command_timeout: this module does not offer {', '.join(unknown)}")
        self.kind.check(self, needs)
        return self

    def needs(self) -> dict[str, list[str]]:
        """The parts that the listed services need, each with those services; `ConfigError` for an unknown service."""
        found: dict[str, list[str]] = {}
        for name in self.services or ():
            if name not in catalogue.CORE:
                found.setdefault(catalogue.find(self.type, name).needs, []).append(name)
        return found

    @property
    def kind(self) -> Kind[Any]:
        """The kind of module, with its services and its parts."""
        return KINDS[self.type]

    @property
    def moves(self) -> str | None:
        """The group of joints that the module moves."""
        return self.group or self.kind.group

    def command_timeout_of(self, service: str) -> float | None:
        """Seconds after which the service stops unless a further command arrives; None is never."""
        given = self.command_timeout
        value = given.get(service, DEFAULT_TIMEOUT) if isinstance(given, Mapping) else given
        return None if value == "off" else value

    def offers(self, service: str) -> bool:
        """True if the module has the service, provided that the robot has the parts for it."""
        return service in (catalogue.defaults(self.type) if self.services is None else self.services)


class OriginConfig(StrictConfig):
    """Position of the origin of the robot's world on the globe (WGS 84)."""

    latitude: Annotated[float, Field(ge=-90.0, le=90.0)]
    longitude: Annotated[float, Field(ge=-180.0, le=180.0)]
    """Degrees, north and east positive."""
    altitude: Annotated[float, Field(ge=-10000.0, le=35000.0)] = 0.0
    """Metres above the ellipsoid."""
    heading: Annotated[float, Field(ge=-360.0, le=360.0)] = 0.0
    """Heading of the world's x axis, in degrees clockwise from true north: the robot's heading at the start."""

    def pose(self) -> GlobalPose:
        """Return it with the heading in radians."""
        return GlobalPose(self.latitude, self.longitude, self.altitude, math.radians(self.heading))


MAX_POSE_NAME: Final = 64
"""Characters."""


def _check_latin1(name: str) -> str:
    try:
        name.encode("latin-1")
    except UnicodeEncodeError as error:
        raise ValueError(f"name: {name!r}: JAUS sends names in Latin-1, which has no {name[error.start]!r}") from None
    return name


def _check_target(network: Network) -> Network:
    if network.is_multicast or network.is_unspecified:
        raise ValueError(f"video_targets: {network}: video is sent to one machine, so give networks of machines")
    return network


class HealthConfig(StrictConfig):
    """Hours of operation and maintenance of a robot."""

    hour_meter: Annotated[str, Field(min_length=1, max_length=4096)] | None = None
    """The file that keeps the hours, below the folder of the TOML file; without it they begin at zero each time."""
    reminders: Annotated[tuple[Reminder, ...], Field(max_length=16)] = ()

    @model_validator(mode="after")
    def _check_ids(self) -> Self:
        check_unique("reminders", [str(reminder.id) for reminder in self.reminders])
        return self


class RobotConfig(StrictConfig):
    """One robot: a JAUS node with its capability modules, on a backend."""

    name: Annotated[Name, AfterValidator(_check_latin1)]
    description: Annotated[str, Field(max_length=200)] = ""
    urdf: Annotated[str, Field(min_length=1)]
    """The file that describes its links and joints, as URDF or xacro; a relative path starts at the TOML file."""
    package_path: Annotated[tuple[Annotated[str, Field(min_length=1)], ...], Field(max_length=64)] = ()
    """Directories in which the packages of `package://` and `$(find ...)` are searched before those of ROS; relative
    ones start at the TOML file."""
    xacro_arguments: Mapping[Name, str] = Field(default_factory=dict)
    """The arguments of a xacro file, which `$(arg NAME)` is replaced by."""
    skip_missing_packages: bool = False
    """True to leave out what the URDF includes of packages and files that are missing, with all that needs it."""
    placeholder_meshes: bool = False
    """True to put a box in the place of each missing mesh."""
    subsystem: Annotated[int, Field(ge=1, le=65534)]
    node: Annotated[int, Field(ge=1, le=254)]
    backend: Name = "kinematic"
    world: Annotated[str, Field(min_length=1, max_length=4096)] = "empty"
    """A world of the backend, or the path of a file: MJCF (.xml), SDF (.sdf, .world) or a list of objects (.toml)."""
    model_path: Annotated[tuple[Annotated[str, Field(min_length=1)], ...], Field(max_length=64)] = ()
    """Directories with models, in which an SDF world's `model://` is searched before those of the environment."""
    time_of_day: TimeOfDay = TimeOfDay.DAY
    """Light of the world, as cameras see it: "day", "dusk" or "night"."""
    quality: Quality = Quality.MEDIUM
    """Quality of simulated pictures: "low" (no shadows), "medium", "high" (also smooth edges)."""
    max_message_age: Annotated[float, Field(ge=0.0, allow_inf_nan=False)] = MAX_AGE
    """Seconds for which a command may wait while the robot's process does not run; 0 is no limit."""
    origin: OriginConfig | None = None
    """Without an origin there are no services with global poses."""
    operators: Annotated[str, Field(min_length=1)] | None = None
    """The operators file: who may command, with keys; a relative path starts at the TOML file."""
    require_operator: bool = True
    """True to require seals: with `operators`, whether commands without the seal of one are refused."""
    audit_log: Annotated[str, Field(min_length=1)] | None = None
    """The file in which commands are recorded, below the folder of the TOML file, where a relative path starts."""
    record_to: Annotated[str, Field(min_length=1)] | None = None
    """The folder of the recordings that DataLogging switches, below that of the TOML file, where a relative path
    starts."""
    modules: tuple[ModuleConfig, ...]
    localization: LocalizationSetup = LocalizationSetup()
    tilt_guard: TiltSetup | None = None
    """The tilt at which the robot is stopped; without it, it may tilt as it likes."""
    self_collision: SelfCollisionSetup = SelfCollisionSetup()
    """The guard that stops joints before links touch each other."""
    guarded_teleop: GuardedTeleopSetup = GuardedTeleopSetup()
    """The guard that stops the chassis before obstacles."""
    tracks: TrackSetup | None = None
    wheels: WheelJoints | None = None
    """Without tracks and wheels the base is fixed to the world."""
    cell: CellSetup | None = None
    """The factory cell around the robot. Parts with a servo or connectors that no module names get one for each."""
    can: CanTable | None = None
    """The servo drives of the robot, for the backend `can`."""
    joint_limits: Mapping[UrdfName, JointLimitsConfig] = Field(default_factory=dict)
    """Limits in place of those of the URDF, by the names of joints."""
    groups: Groups = Field(default_factory=dict)
    """The groups of joints, by name."""
    poses: Mapping[str, Mapping[UrdfName, PosePosition]] = Field(default_factory=dict)
    """Named poses: positions of all joints of a group, or of several; degrees, or metres of joints that slide."""
    lidars: Annotated[tuple[LidarSetup, ...], Field(max_length=16)] = ()
    force_torque: Annotated[tuple[ForceTorqueSetup, ...], Field(max_length=16)] = ()
    cameras: Annotated[tuple[CameraTable, ...], Field(max_length=16)] = ()
    lights: Annotated[tuple[LampSetup, ...], Field(max_length=8)] = ()
    """Lamps of the robot."""
    microphones: Annotated[tuple[MicrophoneSetup, ...], Field(max_length=8)] = ()
    loudspeakers: Annotated[tuple[LoudspeakerSetup, ...], Field(max_length=8)] = ()
    tones: Annotated[tuple[ToneSetup, ...], Field(max_length=8)] = ()
    """Sounds of the simulated world."""
    battery: BatterySetup | None = None
    """The battery of a simulated robot; without it the supply never ends."""
    stability: StabilitySetup | None = None
    """Limits that keep the robot from tipping over; without it there are none but those of `tilt_guard`."""
    health: HealthConfig = HealthConfig()
    clouds: Annotated[tuple[CloudConfig, ...], Field(max_length=32)] = ()
    """Point clouds that are published whenever the robot runs."""
    video_targets: Annotated[tuple[Annotated[Network, AfterValidator(_check_target)], ...], Field(max_length=64)] = ()
    """Networks and addresses into which any client may have video and sound sent, beside its own machine."""

    _file: str = PrivateAttr(default="")

    @property
    def file(self) -> str:
        """The file that it was read from, for error messages; empty if there is none."""
        return self._file

    def set_file(self, file: str) -> None:
        """Set the file that it was read from."""
        self._file = file

    @model_validator(mode="wrap")
    @classmethod
    def _add_modules(cls, given: object, handler: ModelWrapValidatorHandler[Self]) -> Self:
        config = handler(given)
        more = config.modules_of_parts()
        return config.model_copy(update={"modules": (*config.modules, *more)}) if more else config

    def modules_of_parts(self) -> tuple[ModuleConfig, ...]:
        """The modules of the cell's parts that have a servo or connectors, and that no other module names.

        Raises `ValueError` if the node has no numbers left.
        """
        if self.cell is None:
            return ()
        node, types = self.cell.node, self.cell.types
        named = {module.part for module in self.modules if module.type in (Servo.type, Connector.type)}
        taken = {module.component for module in self.modules if (module.node or self.node) == node}
        free = [number for number in range(1, 255) if number not in taken]
        parts = [part for part in self.cell.parts if types[part.type].is_module and part.name not in named]
        if len(parts) > len(free):
            raise ValueError(f"cell.parts: {len(parts)} need a component of node {node}, which has {len(free)} left")
        return tuple(
            ModuleConfig(
                type=Servo.type if types[part.type].servo else Connector.type,
                component=number,
                node=node,
                part=part.name,
            )
            for number, part in zip(free, parts, strict=False)
        )

    @model_validator(mode="after")
    def _check_modules(self) -> Self:
        if not self.modules:
            raise ValueError("modules: there is none; a robot needs one or more [[modules]]")
        if self.operators is None and "require_operator" in self.model_fields_set and self.require_operator:
            raise ValueError("require_operator: needs operators, the file that names who may command")
        if self.operators is None and self.audit_log is not None:
            raise ValueError("audit_log: needs operators, the file that names who may command")
        for (node, component), count in Counter((m.node or self.node, m.component) for m in self.modules).items():
            if count > 1:
                raise ValueError(
                    f"modules: {count} have the component id {component} of node {node}; give each its own, 1..254"
                )
        if self.tracks is not None and self.wheels is not None:
            raise ValueError("wheels: the robot has tracks, too; give one of them")
        self._check_cell()
        self._check_movers()
        self._check_sensors("lidars", self.lidars, LIDARS)
        self._check_sensors("force_torque", self.force_torque, FORCE_TORQUE)
        self._check_cameras()
        self._check_sound()
        if self.origin is None and isinstance(self.localization.gnss, GnssSetup):
            raise ValueError(f"localization.gnss: needs {ORIGIN}, from which its positions are counted")
        self._check_lights()
        self._check_poses()
        if not any(module.offers("Discovery") for module in self.modules):
            raise ValueError(
                "modules: none has the service Discovery; without it the robot cannot be discovered; add it to services"
            )
        for module in self.modules:
            if self.origin is None and (globe := module.needs().get(ORIGIN)):
                raise ValueError(f"origin: is missing; {', '.join(sorted(globe))} cannot be offered without {ORIGIN}")
        return self

    def _check_movers(self) -> None:
        """Check that no part is moved by two modules: each has its own access control, and so its own client."""
        moved: dict[str, int] = {}
        for module in self.modules:
            what = module.kind.moved(module)
            if what is None:
                continue
            stands = self.tracks is None and self.wheels is None
            if module.type == Mobility.type and module.part is None and stands:
                raise ValueError(f"tracks: is missing, and so is wheels; the CM-MOB {module.component} drives on one")
            if what in moved:
                raise ValueError(
                    f"modules: {moved[what]} and {module.component} both move the {what}; one module may, "
                    "for each has a client in control"
                )
            moved[what] = module.component
            if module.moves and module.moves not in self.groups:
                known = ", ".join(self.groups) or "none"
                raise ValueError(
                    f"modules: {module.component} moves the {what}, which is not there; there are: {known}"
                )

    def _check_cell(self) -> None:
        """Check that the modules of a factory cell name what is there."""
        if (cell := self.cell) is None:
            for module in self.modules:
                if module.kind.in_cell or module.part is not None:
                    raise ValueError(f"cell: is missing; {module.component} is a {module.type} of a factory cell")
            return
        for module in self.modules:
            module.kind.check_cell(module, cell)

    def _check_sensors(self, key: str, sensors: Sequence[LidarSetup | ForceTorqueSetup], need: str) -> None:
        check_unique(key, [sensor.name for sensor in sensors])
        for module in self.modules:
            if not sensors and (offered := module.needs().get(need)):
                raise ValueError(f"{key}: there is none, and {module.component} offers {offered[0]}; add [[{key}]]")

    def _check_cameras(self) -> None:
        names = [camera.name for camera in self.cameras]
        check_unique("cameras", names)
        taken = [module.camera for module in self.modules if module.camera is not None]
        for name in taken:
            if name not in names:
                known = ", ".join(names) or "none"
                raise ValueError(f"modules: a CM-VIS names the camera {name!r}, which is not there; there are: {known}")
            if taken.count(name) > 1:
                raise ValueError(f"modules: the camera {name!r} has two CM-VIS; one controls its stream")

    def _check_sound(self) -> None:
        names = [microphone.name for microphone in self.microphones]
        names += [loudspeaker.name for loudspeaker in self.loudspeakers]
        check_unique("microphones and loudspeakers", names)
        for need, devices in ((MICROPHONES, self.microphones), (LOUDSPEAKERS, self.loudspeakers)):
            for module in self.modules:
                if not devices and (offered := module.needs().get(need)):
                    raise ValueError(
                        f"{need}: there is none, and {module.component} offers {offered[0]}; add [[{need}]]"
                    )

    def _check_lights(self) -> None:
        check_unique("lights", [light.name for light in self.lights])

    def _check_poses(self) -> None:
        """Check the names of poses, and that each has all joints of the groups that it moves."""
        if len(self.poses) > MAX_POSES:
            raise ValueError(f"poses: {len(self.poses)} are too many; a robot has up to {MAX_POSES}")
        groups = {joint.name: name for name, group in self.groups.items() for joint in group.joints}
        for name, positions in self.poses.items():
            if not (1 <= len(name) <= MAX_POSE_NAME and name.isprintable() and name.strip() == name):
                raise ValueError(
                    f"poses: the name {name!r} must have 1 to {MAX_POSE_NAME} printable characters, and begin and "
                    "end with none that is blank"
                )
            _check_latin1(name)
            if not positions:
                raise ValueError(f"poses.{name}: it names no joint")
            for joint in positions:
                if joint not in groups:
                    known = ", ".join(groups) or "none"
                    raise ValueError(f"poses.{name}: no group has the joint {joint!r}; there are: {known}")
            self._check_pose(name, {groups[joint] for joint in positions})

    def _check_pose(self, pose: str, groups: set[str]) -> None:
        movers = {module.moves: module.type for module in self.modules}
        for group in sorted(groups):
            missing = [j.name for j in self.groups[group].joints if j.name not in self.poses[pose]]
            if missing:
                raise ValueError(
                    f"poses.{pose}: {missing[0]} of the group {group} is missing; give all joints of a group or none"
                )
            if movers.get(group, ManipulatorKind.type) != ManipulatorKind.type:
                raise ValueError(
                    f"poses.{pose}: a {movers[group]} moves the group {group}, and only CM-MAN have poses; leave its "
                    "joints out"
                )

    @property
    def movers(self) -> Mapping[int, str]:
        """The groups of joints, by the numbers of the components that move them."""
        return {module.component: module.moves for module in self.modules if module.moves is not None}

    def id_of(self, module: ModuleConfig) -> JausID:
        """The JAUS id of a module."""
        return JausID(self.subsystem, module.node or self.node, module.component)

    @property
    def nodes(self) -> tuple[int, ...]:
        """The JAUS nodes of its modules, sorted."""
        return tuple(sorted({self.node, *(module.node or self.node for module in self.modules)}))
