"""Source of the straight-line encoders."""

from __future__ import annotations

from jauspy.codec.plan import ClassPlan


def encode_method(plan: ClassPlan) -> list[str]:
    """The lines of `_pack`."""
    return []
