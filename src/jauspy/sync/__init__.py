"""The OCU without `await`, for scripts and notebooks; its event loop runs in a thread."""

from jauspy.sync.facade import (
    OCU,
    Arm,
    Camera,
    CommandStream,
    ComponentClient,
    Control,
    Elements,
    Gripper,
    Robot,
    RobotControl,
    ServiceClient,
    Subscription,
)

__all__ = [
    "OCU",
    "Arm",
    "Camera",
    "CommandStream",
    "ComponentClient",
    "Control",
    "Elements",
    "Gripper",
    "Robot",
    "RobotControl",
    "ServiceClient",
    "Subscription",
]
