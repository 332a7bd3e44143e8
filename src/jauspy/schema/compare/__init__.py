"""What differs between two definitions: on the wire, in names, in behaviour."""

from __future__ import annotations

from jauspy.schema.compare.change import Change
from jauspy.schema.compare.services import MessageDiff, ServiceDiff, compare, compare_services, pairs

__all__ = ["Change", "MessageDiff", "ServiceDiff", "compare", "compare_services", "pairs"]
