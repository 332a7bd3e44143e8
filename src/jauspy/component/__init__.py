"""The component runtime: asyncio around services."""

from jauspy.component.component import Component
from jauspy.component.program import run
from jauspy.component.shell import Component

__all__ = ["Component", "Shell", "run"]
