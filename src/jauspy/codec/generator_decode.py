"""Source of the straight-line decoders."""

from __future__ import annotations

from jauspy.codec.plan import ClassPlan


def decode_method(plan: ClassPlan) -> list[str]:
    """The lines of `_unpack` of a message, or `_read` of what is inside one."""
    return []
