"""The table of services in docs/iop.md: what the definitions have, and what inc1 offers."""

from __future__ import annotations

from collections.abc import Mapping
from datetime import UTC, datetime
from pathlib import Path
from typing import Final

from jauspy import backends
from jauspy.audio.device_processes import LoudspeakerProcess, MicrophoneProcess
from jauspy.platform.guarded_robot import GuardedRobot
from jauspy.platform.sound_scene import MachineState, SoundScene
from jauspy.platform.stability import stability_of
from jauspy.robot import robot_files
from jauspy.robot.hosts import host_of
from jauspy.robot.kinds import Shared
from jauspy.robot.robot_files import robot_model
from jauspy.schema import load_builtin
from jauspy.schema.model import ServiceDefinition
from jauspy.video.camera_process import CameraProcess

from .table import read_all

PAGE: Final = Path(__file__).parents[2] / "docs" / "iop.md"
BEGIN: Final = "| service | version | messages in and out | inc1 |"
RULE: Final = "|---|---|---|---|"
EARLIER: Final = frozenset(
    f"urn:jaus:jss:{name}"
    for name in (
        "iop:CostMap2D", "iop:DigitalResourceDiscovery", "iop:EnhancedAccessControl", "iop:HandoffController",
        "exp:aeodrs:HealthMonitor", "iop:PathReporter", "iop:PlatformMode", "iop:PlatformState",
        "iop:UnsolicitedHeartbeat",
    )
)  # fmt: skip
"""Services of the profile that have no table, as other public sources define them."""

INC1: Final[Mapping[str, str]] = {
    "EnhancedAccessControl": "queues requests for control and hands it over when the client in control grants one",
    "PlatformState": "emergency, reset and shutdown of all modules together",
    "PlatformMode": "the mode STANDARD_OPERATING, the only one it has",
    "UnsolicitedHeartbeat": "a heartbeat a second to everyone",
    "UnsolicitedBroadcastControlAvailable": "its client in control to everyone, every five seconds",
    "SoftwareVersionReporting": "the versions of jauspy and Python",
    "CommsLostPolicyManager": "what the robot does when the link to its client is lost",
    "Retrotraverse": "drives back the way it came",
    "PresetPose": "named poses of arm and flippers, reached without contact",
    "Communicator": "delay, loss and rate of the link to each client that asks; queues by HealthReporter",
    "DataLogging": "CM-MAS of `jauspy up`: a log of the robot's traffic, on, off and paused",
    "DigitalAudio": "bit rate, sensitivity and volume; the sound, Opus, by DigitalResourceDiscovery",
    "DigitalAudioAnnunciator": "loudspeakers play RTP of the client in control; no RTSP",
    "DigitalAudioSensor": "microphones to the receiver that is set, G.711 mu-law over RTP",
    "DigitalAudioAnnuciator": "loudspeakers tell where to send, and play mu-law or Opus",
    "EnhancedGlobalWaypointListDriver": "directions and waits at waypoints on the globe, status",
    "EnhancedLocalWaypointListDriver": "directions and waits at waypoints, status",
    "ForceTorqueSensor": "the sensors of force and torque",
    "H264VideoEncoding": "profile, preset and refresh of the cameras' streams",
    "ManipulatorEndEffectorForceTorqueSensor": "the wrist's sensor, at the tool",
    "NodeIDAllocator": "nodes for components that start without one",
    "PhysicalSpecificationService": "bodies and masses in the present posture",
    "AEODRSDigitalVideo": "end point for the client in control, aiming mark",
    "AEODRSVideoIlluminator": "brightness of the lamps of its camera",
    "ComponentPhysicalProperties": "masses, inertia and shapes of all rigid parts",
    "MountSiteProperties": "where the modules are mounted",
    "SubsystemIDAllocator": "CM-MAS, if listed: subsystems for those that start without one",
    "ExtendedPrimitiveManipulator": "voltage and currents of each joint of the arm; temperature from CAN drives",
    "ExtendedPrimitivePanTilt": "the same of the pan-tilt unit",
    "HealthReporter": "health of drives, cameras, lidars, battery and computer; hours, reminders of maintenance",
    "StabilityControlService": "keeps arm and tracks from tipping the robot over",
    "Convoy": "the order in which robots follow it",
    "LeaderFollowerDriver": "follows another robot along its path, at a gap",
    "LeaderManagement": "registers who follows it, and waits for those of its convoy",
    "GuardedTeleopPolicyManager": "slows and stops the chassis before what lidar and depth camera see; off at first",
    "SelfCollisionAvoidancePolicyManager": "slows and stops joints before links touch; off at first",
    "PathReporter": "of `jauspy navigate`: the way that it drives",
    "CostMap2D": "of `jauspy navigate`: costs of the ground, zones to keep out of",
    "HandoffController": "of every OCU of jauspy: `OCU(decide_handoff=...)`, `ocu.request_handoff`",
}
"""What each service does on inc1, or, for those that it does not offer, who has it beside the robot."""


def services() -> list[ServiceDefinition]:
    """The 56 services of the profile, by set and name."""
    keys = {(table.id, table.version) for table in read_all()}
    found = [one for one in load_builtin().services if one.key in keys or one.id in EARLIER]
    return sorted(found, key=lambda one: (":iop:" not in one.id, one.name))


def offered() -> dict[str, list[str]]:
    """The kinds of modules of inc1 that offer each service, by its URN."""
    config = robot_files.load("inc1")
    model = robot_model(config)
    body = GuardedRobot(backends.find("kinematic").open(model, config.world), model)
    videos = {one.name: CameraProcess(body.cameras[one.name], one.settings()) for one in config.cameras}
    shared = Shared(
        stability=stability_of(model, body),
        microphones=[MicrophoneProcess(SoundScene.of(model, setup), MachineState) for setup in model.microphones],
        loudspeakers=[LoudspeakerProcess(setup, lambda _: None) for setup in model.loudspeakers],
    )
    found: dict[str, list[str]] = {}
    for module in config.modules:
        host = host_of(
            config,
            module,
            model,
            body,
            {},
            videos=videos,
            shared=shared,
            utc_now=lambda: datetime.now(UTC),
            now=0.0,
        )
        for urn in host.definitions:
            kinds = found.setdefault(urn, [])
            if module.type not in kinds:
                kinds.append(module.type)
    return found


def rows() -> list[str]:
    """The lines of the table, without its head."""
    kinds = offered()
    return [_row(service, kinds.get(service.id, [])) for service in services()]


def _row(service: ServiceDefinition, kinds: list[str]) -> str:
    name = service.id.rpartition(":")[2]
    what = INC1.get(name, "")
    offers = f"{', '.join(kinds)}: {what}" if kinds and what else ", ".join(kinds) or what or "by template"
    counts = f"{len(service.inputs)}, {len(service.outputs)}"
    return f"| `{service.id.removeprefix('urn:jaus:jss:')}` | {service.version} | {counts} | {offers} |"


def text() -> str:
    """The page with its present table."""
    before, _, after = PAGE.read_text("utf-8").partition(BEGIN)
    rest = after.partition("\n\n")[2]
    table = "\n".join((BEGIN, RULE, *rows()))
    return f"{before}{table}\n\n{rest}"


def write() -> list[Path]:
    """Write the page; the files that changed."""
    wanted = text()
    if PAGE.read_text("utf-8") == wanted:
        return []
    PAGE.write_text(wanted, "utf-8")
    return [PAGE]
