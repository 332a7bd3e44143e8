"""The client API: discover, query and control robots, and subscribe to their events."""

from jauspy.ocu.arm import Arm
from jauspy.ocu.camera import Camera
from jauspy.ocu.cell import Connector, Conveyor, ModularArm, PartStation, ServoModule
from jauspy.ocu.client import OCU
from jauspy.ocu.commands import CommandStream
from jauspy.ocu.comms_lost import CommsLost, CommsLostSettings, WayBack
from jauspy.ocu.connection import Stats
from jauspy.ocu.control import Control
from jauspy.ocu.courses import CoursePoint
from jauspy.ocu.discovery import Appeared, Changed, Vanished
from jauspy.ocu.driving import Progress
from jauspy.ocu.following import Following
from jauspy.ocu.gripper import Gripper
from jauspy.ocu.guards import Guard, Guards
from jauspy.ocu.joints import joint_efforts, joint_positions, joint_velocities, metres
from jauspy.ocu.lidar import Lidar, Scan
from jauspy.ocu.lists import Elements
from jauspy.ocu.motion_limits import MotionLimits
from jauspy.ocu.planner import HeldObject, MotionPlan, Planner, PlannerState
from jauspy.ocu.robot import ComponentClient, Robot, RobotControl
from jauspy.ocu.service import ServiceClient
from jauspy.ocu.sound import Announcer, Microphone
from jauspy.ocu.state import BatteryReport, ForceTorque, HealthReport, Joints, LinkHealth, RobotPose
from jauspy.ocu.subscription import Subscription
from jauspy.ocu.subsystems import ComponentInfo, NodeInfo, ServiceInfo, SubsystemInfo

__all__ = [
    "OCU",
    "Announcer",
    "Appeared",
    "Arm",
    "BatteryReport",
    "Camera",
    "Changed",
    "CommandStream",
    "CommsLost",
    "CommsLostSettings",
    "ComponentClient",
    "ComponentInfo",
    "Connector",
    "Control",
    "Conveyor",
    "CoursePoint",
    "Elements",
    "Following",
    "ForceTorque",
    "Gripper",
    "Guard",
    "Guards",
    "HealthReport",
    "HeldObject",
    "Joints",
    "Lidar",
    "LinkHealth",
    "Microphone",
    "ModularArm",
    "MotionLimits",
    "MotionPlan",
    "NodeInfo",
    "PartStation",
    "Planner",
    "PlannerState",
    "Progress",
    "Robot",
    "RobotControl",
    "RobotPose",
    "Scan",
    "ServiceClient",
    "ServiceInfo",
    "ServoModule",
    "Stats",
    "Subscription",
    "SubsystemInfo",
    "Vanished",
    "WayBack",
    "joint_efforts",
    "joint_positions",
    "joint_velocities",
    "metres",
]
