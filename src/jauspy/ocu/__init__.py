"""The client API: find robots, ask them, control them, listen to them."""

from jauspy.ocu.client import OCU
from jauspy.ocu.control import Control
from jauspy.ocu.elements import Elements
from jauspy.ocu.model import Component, Node, ServiceInfo, Subsystem
from jauspy.ocu.robot import ComponentClient, Robot
from jauspy.ocu.service import ServiceClient
from jauspy.ocu.stats import Stats
from jauspy.ocu.subscription import Subscription
from jauspy.ocu.watch import Appeared, Changed, Vanished

__all__ = [
    "OCU",
    "Appeared",
    "Changed",
    "Component",
    "ComponentClient",
    "Control",
    "Elements",
    "Node",
    "Robot",
    "ServiceClient",
    "ServiceInfo",
    "Stats",
    "Subscription",
    "Subsystem",
    "Vanished",
]
