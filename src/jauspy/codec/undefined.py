"""The bits on the wire that a schema gives no meaning; they are kept and sent again."""

from __future__ import annotations

from jauspy.codec.plan import ClassPlan
from jauspy.codec.wire import limits


def undefined_presence(plan: ClassPlan) -> int:
    """Presence bits beyond the last optional attribute."""
    if not plan.presence:
        return 0
    return limits(plan.presence)[1] & ~((1 << sum(slot.optional for slot in plan.slots)) - 1)


def undefined_bits(plan: ClassPlan) -> int:
    """Bits of a bit field that no sub-field names."""
    named = 0
    for bit in plan.bits:
        named |= bit.mask << bit.shift
    return limits(plan.code)[1] & ~named
