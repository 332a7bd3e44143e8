"""The OCU without `await`, for scripts and notebooks: an event loop in a thread does the waiting."""

from jauspy.sync.facade import OCU, ComponentClient, Control, Elements, Robot, ServiceClient, Subscription

__all__ = ["OCU", "ComponentClient", "Control", "Elements", "Robot", "ServiceClient", "Subscription"]
