"""The client API: discover, query and control robots, and subscribe to their events."""

from jauspy.ocu.client import OCU
from jauspy.ocu.connection import Stats
from jauspy.ocu.control import Control
from jauspy.ocu.discovery import Appeared, Changed, Vanished
from jauspy.ocu.lists import Elements
from jauspy.ocu.robot import ComponentClient, Robot
from jauspy.ocu.service import ServiceClient
from jauspy.ocu.subscription import Subscription
from jauspy.ocu.subsystems import ComponentInfo, NodeInfo, ServiceInfo, SubsystemInfo

__all__ = [
    "OCU",
    "Appeared",
    "Changed",
    "ComponentClient",
    "ComponentInfo",
    "Control",
    "Elements",
    "NodeInfo",
    "Robot",
    "ServiceClient",
    "ServiceInfo",
    "Stats",
    "Subscription",
    "SubsystemInfo",
    "Vanished",
]
