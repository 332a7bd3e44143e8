"""The component runtime: an asyncio shell around services."""

from jauspy.component.shell import Component

__all__ = ["Component"]
