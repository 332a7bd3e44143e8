"""The OCU without `await`, for scripts and notebooks; its event loop runs in a thread."""

from jauspy.sync.facade import OCU, ComponentClient, Control, Elements, Robot, ServiceClient, Subscription

__all__ = ["OCU", "ComponentClient", "Control", "Elements", "Robot", "ServiceClient", "Subscription"]
