"""Components: services on a transport, with asyncio."""

from jauspy.component.component import Component, ComponentOptions, run

__all__ = ["Component", "ComponentOptions", "run"]
