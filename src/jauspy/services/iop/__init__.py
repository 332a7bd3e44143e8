"""Services of the Interoperability Profile (IOP) v3 and of AEODRS, over the contracts of `jauspy.platform`."""

from jauspy.services.iop.aeodrs_audio import AnnunciatorStreams, DigitalAudioSensor
from jauspy.services.iop.broadcasts import UnsolicitedBroadcastControlAvailable, UnsolicitedHeartbeat
from jauspy.services.iop.comms_lost import CommsLostPolicyManager
from jauspy.services.iop.communicator import Communicator
from jauspy.services.iop.convoy import Convoy
from jauspy.services.iop.data_logging import DataLogging, LogLevel, LogSettings, LogState, LogStatus, TrafficLogger
from jauspy.services.iop.digital_audio import DigitalAudio, DigitalAudioAnnunciator
from jauspy.services.iop.enhanced_waypoints import EnhancedGlobalWaypointListDriver, EnhancedLocalWaypointListDriver
from jauspy.services.iop.force_torque import EndEffectorForceTorqueSensor, ForceTorqueSensor
from jauspy.services.iop.guard_policies import (
    GuardedTeleopPolicyManager,
    MotionGuards,
    SelfCollisionAvoidancePolicyManager,
)
from jauspy.services.iop.handoff import EnhancedAccessControl, HandoffController, HandoffRequest
from jauspy.services.iop.health import (
    Code,
    HealthCheck,
    HealthEntry,
    HealthReporter,
    HourMeter,
    HoursInMemory,
    Reminder,
    Severity,
)
from jauspy.services.iop.id_allocators import NodeIDAllocator, SubsystemIDAllocator
from jauspy.services.iop.leader_follower_driver import LeaderFollowerDriver
from jauspy.services.iop.leader_management import LeaderManagement
from jauspy.services.iop.operational_parameters import ExtendedPrimitiveManipulator, ExtendedPrimitivePanTilt, Mount
from jauspy.services.iop.physical_properties import (
    ComponentPhysicalProperties,
    MountSite,
    MountSiteProperties,
    PhysicalSpecification,
)
from jauspy.services.iop.platform import PlatformMode, PlatformState
from jauspy.services.iop.preset_pose import PresetPose
from jauspy.services.iop.retrotraverse import Retrotraverse
from jauspy.services.iop.software_version import SoftwareRelease, SoftwareVersionReporting
from jauspy.services.iop.stability import StabilityControl
from jauspy.services.iop.video import AEODRSDigitalVideo, H264VideoEncoding
from jauspy.services.iop.video_illuminator import VideoIlluminator

__all__ = [
    "AEODRSDigitalVideo",
    "AnnunciatorStreams",
    "Code",
    "CommsLostPolicyManager",
    "Communicator",
    "ComponentPhysicalProperties",
    "Convoy",
    "DataLogging",
    "DigitalAudio",
    "DigitalAudioAnnunciator",
    "DigitalAudioSensor",
    "EndEffectorForceTorqueSensor",
    "EnhancedAccessControl",
    "EnhancedGlobalWaypointListDriver",
    "EnhancedLocalWaypointListDriver",
    "ExtendedPrimitiveManipulator",
    "ExtendedPrimitivePanTilt",
    "ForceTorqueSensor",
    "GuardedTeleopPolicyManager",
    "H264VideoEncoding",
    "HandoffController",
    "HandoffRequest",
    "HealthCheck",
    "HealthEntry",
    "HealthReporter",
    "HourMeter",
    "HoursInMemory",
    "LeaderFollowerDriver",
    "LeaderManagement",
    "LogLevel",
    "LogSettings",
    "LogState",
    "LogStatus",
    "MotionGuards",
    "Mount",
    "MountSite",
    "MountSiteProperties",
    "NodeIDAllocator",
    "PhysicalSpecification",
    "PlatformMode",
    "PlatformState",
    "PresetPose",
    "Reminder",
    "Retrotraverse",
    "SelfCollisionAvoidancePolicyManager",
    "Severity",
    "SoftwareRelease",
    "SoftwareVersionReporting",
    "StabilityControl",
    "SubsystemIDAllocator",
    "TrafficLogger",
    "UnsolicitedBroadcastControlAvailable",
    "UnsolicitedHeartbeat",
    "VideoIlluminator",
]
