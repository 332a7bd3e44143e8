"""The client API: discover, query and control robots, and subscribe to their events."""

from jauspy.ocu.arm import Arm
from jauspy.ocu.camera import Camera
from jauspy.ocu.cell import Connector, Conveyor, ModularArm, PartStation, ServoModule
from jauspy.ocu.client import OCU
from jauspy.ocu.commands import CommandStream
from jauspy.ocu.connection import Stats
from jauspy.ocu.control import Control
from jauspy.ocu.discovery import Appeared, Changed, Vanished
from jauspy.ocu.driving import Progress
from jauspy.ocu.gripper import Gripper
from jauspy.ocu.joints import joint_efforts, joint_positions, joint_velocities, metres
from jauspy.ocu.lidar import Lidar, Scan
from jauspy.ocu.lists import Elements
from jauspy.ocu.motion_limits import MotionLimits
from jauspy.ocu.robot import ComponentClient, Robot, RobotControl
from jauspy.ocu.service import ServiceClient
from jauspy.ocu.state import ForceTorque, Joints, RobotPose
from jauspy.ocu.subscription import Subscription
from jauspy.ocu.subsystems import ComponentInfo, NodeInfo, ServiceInfo, SubsystemInfo

__all__ = [
    "OCU",
    "Appeared",
    "Arm",
    "Camera",
    "Changed",
    "CommandStream",
    "ComponentClient",
    "ComponentInfo",
    "Connector",
    "Control",
    "Conveyor",
    "Elements",
    "ForceTorque",
    "Gripper",
    "Joints",
    "Lidar",
    "ModularArm",
    "MotionLimits",
    "NodeInfo",
    "PartStation",
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
    "joint_efforts",
    "joint_positions",
    "joint_velocities",
    "metres",
]
